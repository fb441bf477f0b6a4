//! Formats of `gearlash tolerance` without a folder, and names of files that are not UTF-8.

use super::tolerance::PAIR;
use super::*;

/// Folders and files whose names are no UTF-8: everything is found, written and told apart.
#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_are_taken_as_they_are() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let top = empty_folder();
    let here = top.path().join(OsStr::from_bytes(b"Zahnr\xe4der"));
    std::fs::create_dir_all(here.join("w")).unwrap();
    std::fs::create_dir_all(here.join("p")).unwrap();
    let gear = |teeth: u32| {
        format!(
            "[gear]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -40\n"
        )
    };
    for (name, teeth) in [
        (&b"w/1.toml"[..], 20),
        (b"w/\xe4.toml", 20),
        (b"w/\xf6.toml", 20),
        (b"p/\xfc.toml", 30),
        (b"p/2.toml", 30),
    ] {
        std::fs::write(here.join(OsStr::from_bytes(name)), gear(teeth)).unwrap();
    }
    let own = PAIR.split("[tolerance.wheel]").next().unwrap();
    std::fs::write(
        here.join("pair.toml"),
        format!("{own}[tolerance.wheel]\ngears = \"w/*.toml\"\n"),
    )
    .unwrap();
    let wide = own.replace("max = 150", "max = 400");
    std::fs::write(here.join("wide.toml"), wide).unwrap();
    // From within, from above, by its absolute name.
    for (working, start) in [
        (here.as_path(), Path::new("")),
        (top.path(), Path::new(here.file_name().unwrap())),
        (top.path(), &here),
    ] {
        // Words with an @ are files and folders there.
        let run = |words: &str, last: &Path| {
            let mut command = gearlash(working);
            for word in words.split(' ') {
                match word.strip_prefix('@') {
                    Some(name) => command.arg(start.join(name)),
                    None => command.arg(word),
                };
            }
            let output = command.arg(last).output().unwrap();
            let message = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(0), "{message}");
            String::from_utf8(output.stdout).unwrap()
        };
        let name = OsStr::from_bytes(b"r\xe4.csv");
        let rows = start.join(name);
        let tolerance = "tolerance @pair.toml --assemblies 30 -o @o";
        run(&format!("{tolerance} --rows"), &rows);
        let text = std::fs::read_to_string(here.join(name)).unwrap();
        assert_eq!(text.lines().count(), 32);
        run(&format!("{tolerance} --from-rows"), &rows);
        std::fs::remove_file(here.join(name)).unwrap();
        // All three wheels are drawn.
        let result = std::fs::read_to_string(here.join("o/result.json")).unwrap();
        assert!(result.contains("which wheel"), "{result}");
        let printed = run(
            "match @wide.toml --wheels @w --pinions @p -o",
            &start.join("matched"),
        );
        assert!(printed.starts_with("2 of 2 pairs"), "{printed}");
        let matrix = std::fs::read_to_string(here.join("matched/matrix.csv")).unwrap();
        for name in ["\n\\xe4,\\xfc,", "\n\\xf6,2,", "\n1,2,"] {
            assert!(matrix.contains(name), "{name}: {matrix}");
        }
    }
}
