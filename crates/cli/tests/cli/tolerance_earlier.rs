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
        let run = |arguments: &[&OsStr], wanted: i32| {
            let output = gearlash(working).args(arguments).output().unwrap();
            let message = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(wanted), "{message}");
            String::from_utf8(output.stdout).unwrap()
        };
        let at = |name: &str| start.join(name).into_os_string();
        let word = |text: &'static str| OsStr::new(text);
        let rows = start.join(OsStr::from_bytes(b"r\xe4.csv"));
        run(
            &[
                word("tolerance"),
                &at("pair.toml"),
                word("--assemblies"),
                word("30"),
                word("-o"),
                &at("o"),
                word("--rows"),
                rows.as_os_str(),
            ],
            0,
        );
        assert_eq!(
            std::fs::read_to_string(here.join(OsStr::from_bytes(b"r\xe4.csv")))
                .unwrap()
                .lines()
                .count(),
            32
        );
        run(
            &[
                word("tolerance"),
                &at("pair.toml"),
                word("--assemblies"),
                word("30"),
                word("-o"),
                &at("o"),
                word("--from-rows"),
                rows.as_os_str(),
            ],
            0,
        );
        std::fs::remove_file(here.join(OsStr::from_bytes(b"r\xe4.csv"))).unwrap();
        // All three wheels are drawn.
        let result = std::fs::read_to_string(here.join("o/result.json")).unwrap();
        assert!(result.contains("which wheel"), "{result}");
        let printed = run(
            &[
                word("match"),
                &at("wide.toml"),
                word("--wheels"),
                &at("w"),
                word("--pinions"),
                &at("p"),
                word("-o"),
                &at("matched"),
            ],
            0,
        );
        assert!(printed.starts_with("2 of 2 pairs"), "{printed}");
        let matrix = std::fs::read_to_string(here.join("matched/matrix.csv")).unwrap();
        for name in ["\n\\xe4,\\xfc,", "\n\\xf6,2,", "\n1,2,"] {
            assert!(matrix.contains(name), "{name}: {matrix}");
        }
    }
}
