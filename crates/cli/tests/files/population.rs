//! Runs of `gearlash tolerance` and `gearlash match` that were stopped in the middle, by Ctrl-C and by a kill.

use super::*;
use std::process::Child;
use std::time::{Duration, Instant};

const ARGS: &str = "tolerance p.toml --assemblies 100000 -o";

fn population() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = "title = \"series\"\n\
         [wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n\
         [pinion]\nteeth = 17\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n\
         [assembly]\ncenter_distance_mm = 37.1\n[require]\nj_wt_um = { min = 40 }\n\
         [tolerance]\ncontribution_rows = 0\ncenter_distance = { scatter = \"normal\", sigma_um = 10 }\n";
    std::fs::write(folder.path().join("p.toml"), text).unwrap();
    folder
}

const MATCH: &str = "match p.toml --wheels w --pinions p -o";

/// 27 wheels and as many pinions of 40 teeth, no two alike: three blocks of some seconds each.
fn gears() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let data = "teeth = 40\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n";
    let text = format!(
        "title = \"batch\"\n[wheel]\n{data}[pinion]\n{data}[assembly]\ncenter_distance_mm = 80.0\n[require]\nj_wt_um = {{ min = 80 }}\n"
    );
    std::fs::write(folder.path().join("p.toml"), text).unwrap();
    for kind in ["w", "p"] {
        std::fs::create_dir(folder.path().join(kind)).unwrap();
        for k in 0..27 {
            let text = format!(
                "[gear]\n{data}thickness.allowance_um = {}\nrunout = {{ total_um = {}, high_tooth = {} }}\n",
                -50 - k,
                10 + k % 7,
                1 + k
            );
            std::fs::write(folder.path().join(kind).join(format!("{k}.toml")), text).unwrap();
        }
    }
    folder
}

/// A run on one core, once it has kept something beyond `before` bytes of it.
fn begun(folder: &Path, args: &str, before: Option<Vec<u8>>) -> Child {
    let mut command = gearlash(folder);
    command.env("RAYON_NUM_THREADS", "1").stderr(Stdio::piped());
    let mut child = command
        .args(args.split_whitespace())
        .arg("o")
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let until = Instant::now() + Duration::from_secs(120);
    while std::fs::read(folder.join("o/part.json")).ok() == before {
        assert!(child.try_wait().unwrap().is_none(), "it has ended already");
        assert!(Instant::now() < until, "nothing was kept");
        std::thread::sleep(Duration::from_millis(20));
    }
    child
}

#[test]
fn a_population_that_was_interrupted_and_killed_comes_to_the_same_bytes() {
    comes_to_the_same(&population(), ARGS, "assemblies", 11);
}

#[test]
fn a_matching_that_was_interrupted_and_killed_comes_to_the_same_bytes() {
    comes_to_the_same(&gears(), MATCH, "pairs", 3);
}

/// A run of `args` in `folder`, stopped by Ctrl-C and then by a kill, ends with so many files as one that was not.
fn comes_to_the_same(folder: &tempfile::TempDir, args: &str, units: &str, files: usize) {
    let path = folder.path();
    let child = begun(path, args, None);
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(130));
    let said = told(&ended);
    let kept = format!("{units} are kept in o/part.json: the same command goes on");
    assert!(said.contains(&kept), "{said}");
    let kept = std::fs::read(path.join("o/part.json")).unwrap();
    let mut child = begun(path, args, Some(kept));
    child.kill().unwrap();
    child.wait().unwrap();
    let run = |folder: &str| {
        let mut command = gearlash(path);
        command.env("SOURCE_DATE_EPOCH", "1700000000");
        let done = command
            .args(args.split_whitespace())
            .arg(folder)
            .output()
            .unwrap();
        assert!(done.status.success(), "{}", told(&done));
        (told(&done), contents(&path.join(folder)))
    };
    let (said, resumed) = run("o");
    assert!(said.contains("o/part.json: goes on after"), "{said}");
    let (_, whole) = run("whole");
    assert!(resumed == whole && whole.len() >= files);
}
