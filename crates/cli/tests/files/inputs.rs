//! No result replaces a file that was read, under any name.

use super::*;
use std::os::unix::fs::symlink;

/// A folder with pairs that read tables, protocols, workbooks and measured rows.
fn workshop() -> tempfile::TempDir {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    let gear = |pitch: &str| {
        format!(
            "title = \"g\"\n[gear]\nteeth = 12\nmodule_mm = 2\npressure_angle_deg = 20\nprofile_shift = 0.3\n{pitch}"
        )
    };
    let curve = "tooth,right_um,left_um\n".to_owned()
        + &(1..=12)
            .map(|i| format!("{i},{0},{0}\n", i % 3))
            .collect::<String>();
    // Names of results, and a name that is none.
    for name in ["result.csv", "gauge_gear.csv", "curve.txt"] {
        std::fs::write(at(name), &curve).unwrap();
        let named = format!("pitch = {{ kind = \"cumulative\", file = \"{name}\" }}\n");
        std::fs::write(at(&format!("of_{name}.toml")), gear(&named)).unwrap();
        let wheel = gear(&named).replace("[gear]", "[wheel]");
        let pinion = gear("")
            .replace("[gear]", "[pinion]")
            .replace("title = \"g\"\n", "");
        let pair = format!(
            "{wheel}{pinion}reference_face = \"back\"\n[assembly]\ncenter_distance_mm = 25.4\n[sweep]\nmating = [[1, 1]]\n"
        );
        std::fs::write(at(&format!("with_{name}.toml")), pair).unwrap();
    }
    std::fs::write(at("gauge_gear.toml"), gear("")).unwrap();
    std::fs::copy(at("p.toml"), at("result.json.toml")).unwrap();
    std::fs::copy(at("p.toml"), at("plain")).unwrap();
    std::fs::create_dir(at("inner")).unwrap();
    std::fs::create_dir(at("linked")).unwrap();
    symlink(at("plain"), at("to_plain.svg")).unwrap();
    std::fs::hard_link(at("plain"), at("hard.html")).unwrap();
    symlink("../curve.txt", at("linked/result.csv")).unwrap();
    std::fs::hard_link(at("curve.txt"), at("inner/result.csv")).unwrap();
    std::fs::hard_link(at("p.toml"), at("inner/result.json")).unwrap();
    std::fs::hard_link(at("p.toml"), at("inner/a37.1_as-measured_min.svg")).unwrap();
    std::fs::hard_link(at("p.toml"), at("linked/map_as-measured.csv")).unwrap();
    symlink(at("linked"), at("by_link")).unwrap();
    symlink(at("inner"), at("another")).unwrap();
    folder
}

/// Command, link and folder: each ended with 0 and the input gone, or may have.
const TO_FILES: [&str; 19] = [
    "report plain -o plain",
    "report plain -o ./inner/../plain",
    "report plain -o hard.html",
    "snapshot plain --worst -o to_plain.svg",
    "chart plain --kind inspection -o hard.html",
    "report to_plain.svg -o plain",
    "report with_curve.txt.toml -o curve.txt",
    "chart with_curve.txt.toml --kind inspection -o curve.txt",
    "snapshot with_curve.txt.toml --worst -o inner/../curve.txt",
    "simulate with_result.csv.toml -o .",
    "simulate with_result.csv.toml --format json -o .",
    "simulate with_curve.txt.toml -o inner",
    "simulate with_curve.txt.toml -o by_link",
    "simulate p.toml -o inner",
    "simulate p.toml -o another",
    "gauge gauge_gear.toml -o .",
    "gauge of_gauge_gear.csv.toml -o . --steps-per-pitch 1",
    "gauge gauge_gear.toml -o linked/..",
    "check p.toml --map -o by_link",
];

/// `report inspected_44x44.toml -o protocol.txt` replaced the protocol the pair names; exit 0.
#[test]
fn no_output_takes_the_place_of_a_file_that_was_read() {
    let folder = workshop();
    let before = contents(folder.path());
    for words in TO_FILES {
        let output = run(folder.path(), words);
        let stderr_of = stderr_of(&output);
        assert_eq!(output.status.code(), Some(2), "{words}: {stderr_of}");
        assert!(
            stderr_of.contains("this is the file ") && stderr_of.contains("which was read"),
            "{words}: {stderr_of}"
        );
        assert_eq!(output.stdout, b"", "{words}");
        assert!(contents(folder.path()) == before, "{words}");
    }
}

/// A result read as a pair file, and its own folder: `simulate result.json -o .`
#[test]
fn a_result_is_not_replaced_by_what_is_made_of_it() {
    let folder = folder();
    let echo = run(folder.path(), "simulate p.toml --format json").stdout;
    let echo: serde_json::Value = serde_json::from_slice(&echo).unwrap();
    let name = folder.path().join("result.json");
    std::fs::write(&name, echo["pair"].to_string()).unwrap();
    let before = contents(folder.path());
    let output = run(folder.path(), "simulate result.json -o .");
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr_of(&output).contains("result.json: this is the file result.json"));
    assert!(contents(folder.path()) == before);
}

/// Both names are in the message, and the refusal comes before the work.
#[test]
fn the_message_names_both_files() {
    let folder = workshop();
    let output = run(folder.path(), "simulate with_curve.txt.toml -o inner");
    let stderr_of = stderr_of(&output);
    assert!(
        stderr_of.contains("inner/result.csv: this is the file curve.txt"),
        "{stderr_of}"
    );
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

/// The step summary is appended to, and may be a file that was read.
#[test]
fn the_step_summary_is_no_input() {
    let folder = folder();
    let before = contents(folder.path());
    let mut command = gearlash(folder.path());
    command.args(["compare", "p.toml", "--format", "github"]);
    command.env("GITHUB_STEP_SUMMARY", folder.path().join("p.toml"));
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr_of(&output).contains("p.toml: this is the file p.toml"));
    assert!(contents(folder.path()) == before);
}
