//! A run of `gearlash tolerance --rows` that is interrupted: it leaves whole rows, and prints the commands that go on.

use super::*;
use std::time::{Duration, Instant};

const RUN: &str = "tolerance p.toml --assemblies 100000 --rows rows.csv -o o";

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

/// Stops `RUN` by Ctrl-C after some rows, and returns what it tells.
fn interrupted(folder: &Path) -> String {
    let mut command = gearlash(folder);
    command.env("RAYON_NUM_THREADS", "1").stderr(Stdio::piped());
    command.args(RUN.split(' ')).stdout(Stdio::null());
    let mut child = command.spawn().unwrap();
    let until = Instant::now() + Duration::from_secs(120);
    // More than the header.
    while std::fs::metadata(folder.join("rows.csv")).map_or(0, |found| found.len()) < 1000 {
        assert!(child.try_wait().unwrap().is_none(), "it has ended already");
        assert!(Instant::now() < until, "no row was written");
        std::thread::sleep(Duration::from_millis(5));
    }
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(130));
    stderr_of(&ended)
}

#[test]
fn an_interrupted_run_prints_the_commands_that_go_on() {
    let folder = population();
    let path = folder.path();
    let message = interrupted(path);
    let commands: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    assert_eq!(commands.len(), 2, "{message}");
    assert!(message.contains("are in rows.csv: go on with"), "{message}");
    let left = std::fs::read_to_string(path.join("rows.csv")).unwrap();
    assert!(left.ends_with('\n'));
    // A header of two lines, and whole blocks.
    let rows = left.lines().count() - 2;
    assert!(rows > 0 && rows.is_multiple_of(2048), "{rows}");
    let go_on = |command: &str, further: &str| {
        let words = command.strip_prefix("gearlash ").unwrap();
        let done = run(path, &format!("{words} {further}"));
        assert!(done.status.success(), "{}", stderr_of(&done));
    };
    go_on(commands[0], "");
    go_on(commands[1], "--format json -o o");
    std::fs::remove_file(path.join("rows.csv")).unwrap();
    let whole = run(path, &RUN.replace("-o o", "--format json -o whole"));
    assert!(whole.status.success(), "{}", stderr_of(&whole));
    let result = |folder: &str| std::fs::read(path.join(folder).join("result.json")).unwrap();
    assert!(result("o") == result("whole"));
}
