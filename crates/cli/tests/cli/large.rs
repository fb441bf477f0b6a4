//! Results larger than what is kept of them in memory.

use super::*;
use crate::skip::skip;

/// 17 and 25 teeth: lcm = 425 pitches a hunting cycle.
fn hunting(distances: &str, steps_per_pitch: u32) -> String {
    format!(
        r###"
title = "##[error] in two pieces"
[wheel]
teeth = 17
module_mm = 2.0
pressure_angle_deg = 20.0
[wheel.thickness]
allowance_um = -60.0
[wheel.runout]
total_um = 12.0
high_tooth = 3.5
[pinion]
teeth = 25
module_mm = 2.0
pressure_angle_deg = 20.0
[assembly]
center_distance_mm = {distances}
[sweep]
revolutions = "hunting"
steps_per_pitch = {steps_per_pitch}
"###
    )
}

fn write(folder: &Path, text: &str) {
    std::fs::write(folder.join("large.toml"), text).unwrap();
}

/// Runs of 5100 poses are written in more than one piece.
#[test]
fn a_result_in_pieces_is_the_whole_result() {
    let folder = empty_folder();
    write(folder.path(), &hunting("[42.05, 42.1]", 12));
    let printed = |words: &[&str]| {
        let mut command = gearlash(folder.path());
        output(
            command
                .args(["simulate", "large.toml", "--no-certify"])
                .args(words),
        )
    };
    let json = printed(&["--format", "json"]);
    let csv = printed(&["--format", "csv"]);
    // Laid out as serde_json lays out the whole; the title's escape is ours.
    let value: Value = serde_json::from_str(&json).unwrap();
    let whole = serde_json::to_string_pretty(&value).unwrap() + "\n";
    assert!(whole.contains("\"##[error]") && !json.contains("##"));
    assert_eq!(json, whole.replace("##[error]", "#\\u0023[error]"));
    for run in value["runs"].as_array().unwrap() {
        let poses = run["poses"].as_array().unwrap();
        assert_eq!(poses.len(), 425 * 12);
        // The summary, of poses long gone, against all of them.
        let values = poses.iter().map(|pose| pose["j_wt_um"].as_f64().unwrap());
        let (least, most) = (
            values.clone().reduce(f64::min),
            values.clone().reduce(f64::max),
        );
        assert_eq!(run["summary"]["min_j_wt_um"].as_f64(), least);
        assert_eq!(run["summary"]["max_j_wt_um"].as_f64(), most);
        let mean = values.sum::<f64>() / poses.len() as f64;
        let written = run["summary"]["mean_j_wt_um"].as_f64().unwrap();
        assert!((written - mean).abs() < 1e-9, "{written} {mean}");
    }
    let rows: Vec<csv::StringRecord> = csv::Reader::from_reader(csv.as_bytes())
        .records()
        .map(Result::unwrap)
        .collect();
    let poses = value["runs"].as_array().unwrap().iter();
    let poses = poses.flat_map(|run| run["poses"].as_array().unwrap());
    assert_eq!(rows.len(), poses.clone().count());
    for (row, pose) in rows.iter().zip(poses) {
        assert_eq!(row[4], pose["mating"]["wheel_tooth"].to_string());
        assert_eq!(row[13], pose["j_wt_um"].to_string());
    }
    // The same in a folder, whatever is printed beside it and on how many cores.
    for (format, printed) in [("json", &json), ("csv", &csv)] {
        let mut command = gearlash(folder.path());
        command.env("RAYON_NUM_THREADS", "1");
        let words = ["simulate", "large.toml", "--no-certify", "-o", "results"];
        let again = output(command.args(words).args(["--format", format]));
        assert_eq!(&again, printed);
        let written = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
        assert_eq!(written("results/result.json"), json);
        assert_eq!(written("results/result.csv"), csv);
    }
}

/// 102 000 poses, whose results as a whole took 390 MB before they were written in pieces.
#[test]
#[cfg(target_os = "linux")]
fn memory_does_not_grow_with_the_poses() {
    let folder = empty_folder();
    write(folder.path(), &hunting("42.05", 240));
    let command = |limit_kib: u32| {
        let mut command = Command::new("sh");
        let program = assert_cmd::cargo::cargo_bin("gearlash");
        // Address space, of which an allocator sets some aside for each thread.
        command
            .current_dir(folder.path())
            .env("RAYON_NUM_THREADS", "2")
            .env("MALLOC_ARENA_MAX", "2")
            .arg("-c")
            .arg(format!("ulimit -v {limit_kib} && exec \"$0\" \"$@\""))
            .arg(program);
        command
    };
    if !command(256 << 10)
        .arg("--version")
        .ok()
        .is_ok_and(|run| run.status.success())
    {
        skip("this shell cannot limit the address space (ulimit -v)");
        return;
    }
    let mut run = command(256 << 10);
    let text =
        output(run.args("simulate large.toml --no-certify --format csv -o results".split(' ')));
    assert_eq!(text.lines().count(), 1 + 425 * 240);
}
