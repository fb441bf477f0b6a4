//! Links, pipes and devices as places to read and write.

use super::*;
use std::io::BufRead;
use std::os::unix::fs::symlink;
use std::time::{Duration, Instant};

/// As `cp` has it: the file the link points to is replaced, the link stays.
#[test]
fn an_output_through_a_link_follows_it() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("there")).unwrap();
    std::fs::write(folder.path().join("there/page.html"), "old").unwrap();
    symlink("there/page.html", folder.path().join("page.html")).unwrap();
    assert!(
        run(folder.path(), "report p.toml -o page.html")
            .status
            .success()
    );
    assert!(folder.path().join("page.html").is_symlink());
    let page = std::fs::read_to_string(folder.path().join("there/page.html")).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>"));
    // A folder of results, too.
    symlink("there", folder.path().join("results")).unwrap();
    assert!(
        run(folder.path(), "simulate p.toml -o results")
            .status
            .success()
    );
    assert!(folder.path().join("results").is_symlink());
    assert!(folder.path().join("there/result.json").is_file());
}

/// As `cp`, which does not write through a link that leads nowhere.
#[test]
fn an_output_through_a_link_that_leads_nowhere_is_refused() {
    let folder = folder();
    symlink("nowhere/page.html", folder.path().join("page.html")).unwrap();
    let output = run(folder.path(), "report p.toml -o page.html");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr_of(&output).contains("page.html: this is a link to a file that is not there"));
}

/// A link of a result's name is replaced, what it points to stays: it belongs to somebody else.
#[test]
fn a_link_in_the_folder_of_results_is_replaced() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("results")).unwrap();
    std::fs::write(folder.path().join("other.json"), "mine").unwrap();
    symlink("../other.json", folder.path().join("results/result.json")).unwrap();
    assert!(
        run(folder.path(), "simulate p.toml -o results")
            .status
            .success()
    );
    assert!(!folder.path().join("results/result.json").is_symlink());
    let other = std::fs::read_to_string(folder.path().join("other.json")).unwrap();
    assert_eq!(other, "mine");
}

/// As root, `-o /dev/null` once put a file in the place of the device.
#[test]
fn a_device_is_written_to_and_stays() {
    let folder = folder();
    assert!(
        run(folder.path(), "report p.toml -o /dev/null")
            .status
            .success()
    );
    use std::os::unix::fs::FileTypeExt;
    let null = std::fs::metadata("/dev/null").unwrap().file_type();
    assert!(null.is_char_device());
    let output = run(folder.path(), "report p.toml -o /dev/full");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr_of(&output).contains("/dev/full: cannot be written: No space left on device"));
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// It waited for ever.
#[test]
fn a_pipe_that_nobody_writes_or_reads_is_reported() {
    let folder = folder();
    pipe(&folder.path().join("pipe.toml"));
    let begun = Instant::now();
    let output = run(folder.path(), "simulate pipe.toml");
    assert_eq!(output.status.code(), Some(2));
    assert!(begun.elapsed() < Duration::from_secs(10));
    let stderr_of = stderr_of(&output);
    assert!(
        stderr_of.contains(
            "pipe.toml: cannot be read: no data has come for 5 s; start the program that writes to it"
        ),
        "{stderr_of}"
    );
    let output = run(folder.path(), "report p.toml -o pipe.toml");
    assert_eq!(output.status.code(), Some(2));
    pipe(&folder.path().join("pipe.html"));
    let output = run(folder.path(), "report p.toml -o pipe.html");
    assert_eq!(output.status.code(), Some(2));
}

/// The writer may come late and take its time.
#[test]
fn a_pipe_that_is_written_slowly_is_read_whole() {
    let folder = folder();
    pipe(&folder.path().join("pipe.toml"));
    let script = "(sleep 0.3; head -c 100 p.toml; sleep 0.3; tail -c +101 p.toml) > pipe.toml";
    let mut writer = Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", script])
        .spawn()
        .unwrap();
    let output = run(folder.path(), "simulate pipe.toml --format json");
    assert!(writer.wait().unwrap().success());
    assert!(output.status.success(), "{}", stderr_of(&output));
    assert_eq!(
        output.stdout,
        run(folder.path(), "simulate p.toml --format json").stdout
    );
}

/// A pipe and standard input that begin and then bring nothing: each waited for ever.
#[test]
fn an_input_that_stops_is_reported() {
    let folder = folder();
    pipe(&folder.path().join("pipe.toml"));
    for (script, name) in [
        (
            "(echo; sleep 30) > pipe.toml & GEARLASH check pipe.toml",
            "pipe.toml",
        ),
        ("(echo; sleep 30) | GEARLASH check -", "stdin"),
        ("GEARLASH check /dev/zero", "/dev/zero"),
    ] {
        let begun = Instant::now();
        let script = script.replace("GEARLASH", env!("CARGO_BIN_EXE_gearlash"));
        let mut child = Command::new("bash")
            .current_dir(folder.path())
            .args([
                "-c",
                &format!("{script}; code=$?; kill $(jobs -p) 2> /dev/null; exit $code"),
            ])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut stderr_of = String::new();
        let mut stderr = std::io::BufReader::new(child.stderr.take().unwrap());
        stderr.read_line(&mut stderr_of).unwrap();
        assert!(begun.elapsed() < Duration::from_secs(15), "{name}");
        let words = match name {
            "/dev/zero" => "has more than 64 MiB",
            _ => "no data has come for 5 s",
        };
        assert!(
            stderr_of.contains(name) && stderr_of.contains(words),
            "{name}: {stderr_of}"
        );
        drop(stderr);
        child.kill().unwrap();
        child.wait().unwrap();
    }
}
