//! Standard output and standard error that accept nothing, or are a file that was read.

use super::*;
use std::fs::File;
use std::io::Read;

/// Every command that prints, with what it needs.
const PRINTING: [&str; 15] = [
    "simulate p.toml",
    "simulate p.toml --format json",
    "simulate p.toml --format csv",
    "compare p.toml",
    "compare p.toml --format json",
    "compare p.toml --format junit",
    "check p.toml",
    "report p.toml -o -",
    "chart p.toml --kind inspection -o -",
    "snapshot p.toml --worst -o -",
    "gauge p.toml --format csv --steps-per-pitch 1",
    "schema",
    "init -",
    "--help",
    "--version",
];

fn full() -> File {
    File::options().write(true).open("/dev/full").unwrap()
}

/// They ended with 0 beside a file that was cut or empty.
#[test]
fn a_full_standard_output_is_reported_and_ends_with_2() {
    let folder = folder();
    for words in PRINTING {
        let mut command = gearlash(folder.path());
        let output = command.args(words.split(' ')).stdout(full()).output();
        let output = output.unwrap();
        assert_eq!(output.status.code(), Some(2), "{words}");
        let stderr_of = stderr_of(&output);
        assert!(
            stderr_of
                .contains("error: standard output: cannot be written: No space left on device"),
            "{words}: {stderr_of}"
        );
        assert_eq!(temporary(folder.path()), [] as [PathBuf; 0], "{words}");
    }
}

/// As under `| head -c 1`: the reader has enough. The result of the command still counts.
#[test]
fn a_closed_pipe_is_quiet() {
    let folder = folder();
    for words in PRINTING {
        let usual = run(folder.path(), words).status.code();
        let mut command = gearlash(folder.path());
        command.args(words.split(' '));
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let mut stderr_of = String::new();
        let stderr = child.stderr.take();
        stderr.unwrap().read_to_string(&mut stderr_of).unwrap();
        assert_eq!(child.wait().unwrap().code(), usual, "{words}: {stderr_of}");
        assert!(
            !stderr_of.contains("error") && !stderr_of.contains("panicked"),
            "{words}: {stderr_of}"
        );
    }
}

/// It panicked, exit 101.
#[test]
fn a_full_or_closed_standard_error_changes_nothing() {
    let folder = folder();
    std::fs::write(folder.path().join("bad.toml"), "title = 1\n").unwrap();
    // Warnings, notes, errors, and what clap says.
    for words in PRINTING.into_iter().chain([
        "simulate bad.toml",
        "compare bad.toml none.toml",
        "nothing",
        "simulate p.toml --method both",
    ]) {
        let usual = run(folder.path(), words);
        let mut into_full = gearlash(folder.path());
        into_full.args(words.split(' ')).stderr(full());
        let output = into_full.output().unwrap();
        assert_eq!(output.status.code(), usual.status.code(), "{words}");
        assert_eq!(output.stdout, usual.stdout, "{words}");
        let mut closed = Command::new("sh");
        closed.current_dir(folder.path()).stdin(Stdio::null());
        let script = format!("{} {words} 2>&-", env!("CARGO_BIN_EXE_gearlash"));
        let output = closed.args(["-c", &script]).output().unwrap();
        assert_eq!(output.status.code(), usual.status.code(), "{words}");
    }
}

/// `>> pair.toml` would append to it; `cat` refuses that, too.
#[test]
fn streams_do_not_go_into_a_file_that_was_read() {
    let folder = folder();
    let before = contents(folder.path());
    for redirected in ["p.toml >>", "- < p.toml >>", "p.toml 2>>"] {
        let script = format!(
            "{} simulate --format json {redirected} p.toml",
            env!("CARGO_BIN_EXE_gearlash")
        );
        let mut command = Command::new("sh");
        command.current_dir(folder.path()).args(["-c", &script]);
        assert_eq!(command.status().unwrap().code(), Some(2), "{redirected}");
        let after = contents(folder.path());
        // Standard error is still appended there; the old content stays.
        let kept = after[Path::new("p.toml")].starts_with(&before[Path::new("p.toml")]);
        assert!(kept, "{redirected}");
        assert!(redirected.contains("2>>") || after == before);
    }
}
