//! Errors show no more of a file than they must.

use super::*;
use std::fs;

const SECRET: &str = "root:x:0:0:hunter2:/root:/bin/sh";

fn pair_with(folder: &Path, wheel: &str, below: &str) {
    let gear = "module_mm = 2.0\npressure_angle_deg = 20.0\n";
    let text = format!(
        "[wheel]\nteeth = 20\n{gear}{wheel}\n[pinion]\nteeth = 17\n{gear}[assembly]\ncenter_distance_mm = 37.1\n{below}\n"
    );
    fs::write(folder.join("pair.toml"), text).unwrap();
}

fn message(folder: &Path) -> String {
    let (code, printed, message) = run(folder, &["simulate", "pair.toml", "--format", "json"]);
    assert_eq!((code, &printed[..]), (Some(2), ""));
    message
}

/// The keys that name files, each with those that belong to them.
const NAMES: [(&str, &str); 6] = [
    ("", "[measured]\nfile = \"FILE\""),
    ("pitch = { kind = \"single\", file = \"FILE\" }", ""),
    ("pitch = { kind = \"cumulative\", file = \"FILE\" }", ""),
    ("runout = { at = \"tooth\", file = \"FILE\" }", ""),
    ("thickness = { span = { teeth = 3, file = \"FILE\" } }", ""),
    ("thickness = { per_tooth_um = { file = \"FILE\" } }", ""),
];

/// A file outside the folder, by a path or by a link, in every shape that a message quoted.
#[cfg(unix)]
#[test]
fn nothing_of_a_file_outside_the_folder_is_quoted() {
    let above = empty_folder();
    let folder = above.path().join("pairs");
    fs::create_dir(&folder).unwrap();
    let secrets = [
        format!("{SECRET}\n{SECRET}\n"),
        format!("a,{SECRET},b\n1,2,3\n"),
        format!("tooth,left,right\n1,{SECRET},0\n"),
        format!("tooth;left;right\nhunter2;{SECRET};0\n"),
        format!("tooth,left (hunter2),right\n1,{SECRET},0\n"),
        format!("tooth (hunter2),left,right\n{SECRET},0,0\n"),
        "tooth,runout\n1,1.234\n2,5,678\n".to_owned(),
        "tooth\tleft\tright\n1\t7,654\t0\n".to_owned(),
        "tooth,left,right\n7654,1,1\n".to_owned(),
        format!("linke Zahnflanke\n{SECRET}\n"),
        format!("linke Zahnflanke\nZahn-Nr. hunter2 {SECRET}\n"),
        "linke Zahnflanke\nZahn-Nr. fp\nhunter2 1\n1 hunter2\n".to_owned(),
        format!("22 :Zähnezahl: {SECRET}\nlinke Zahnflanke\nZahn-Nr. fp\n1 1\n"),
        "21 :Normalmodul: 7654\nlinke Zahnflanke\nZahn-Nr. fp\n1 1\n".to_owned(),
        "linke Zahnflanke\nZahn-Nr. fp Fp\n1 7654 1\n2 1 1\n".to_owned(),
        format!(
            "center_distance_mm,wheel_tooth,pinion_tooth,measured_right_um,measured_left_um,predicted_min_um,predicted_max_um,source\n{SECRET},hunter2,7654,x,y,3,2,s\n"
        ),
        format!("PK\u{3}\u{4}{SECRET}"),
    ];
    let mut quoted_inside = 0;
    for secret in &secrets {
        fs::write(above.path().join("secret"), secret).unwrap();
        let link = folder.join("link");
        let _ = fs::remove_file(&link);
        std::os::unix::fs::symlink("../secret", &link).unwrap();
        fs::write(folder.join("inside"), secret).unwrap();
        let absolute = above.path().join("secret").display().to_string();
        for (wheel, below) in NAMES {
            for (file, is_outside) in [
                ("../secret", true),
                (&absolute, true),
                ("link", true),
                ("inside", false),
            ] {
                let put = |text: &str| text.replace("FILE", file);
                pair_with(&folder, &put(wheel), &put(below));
                let message = message(&folder);
                let shows = ["hunter2", "root:", "7654", "7,654", "1.234", "5,678"]
                    .iter()
                    .any(|part| message.contains(part));
                assert!(!(shows && is_outside), "{file}: {secret}: {message}");
                quoted_inside += usize::from(shows && !is_outside);
            }
        }
    }
    // The same files beside the pair file are quoted: the messages are those that leaked.
    assert!(quoted_inside > 25, "{quoted_inside}");
}

/// A header, a cell, a key, a value and a name of a million characters each: cut at 60, visibly.
#[test]
fn messages_are_short_whatever_stands_in_a_file() {
    let folder = empty_folder();
    let folder = folder.path();
    let long = "ä".repeat(1 << 20);
    let shown = format!("{} …", "ä".repeat(59));
    let write = |name: &str, text: String| fs::write(folder.join(name), text).unwrap();
    write("head.csv", format!("{long},left\n1,2\n"));
    write("cell.csv", format!("tooth,left,right\n1,{long},3\n"));
    write("unit.csv", format!("tooth,left ({long}),right\n1,2,3\n"));
    let pitch = |file: &str| format!("pitch = {{ kind = \"single\", file = \"{file}\" }}");
    for (wheel, below) in [
        (pitch("head.csv"), ""),
        (pitch("cell.csv"), ""),
        (pitch("unit.csv"), ""),
        (String::new(), "[measured]\nfile = \"head.csv\""),
        (pitch(&long), ""),
        (format!("\"{long}\" = 1"), ""),
        (format!("reference_face = \"{long}\""), ""),
        (
            format!("rack = {{ \"{long}\" = {{ \"{long}\" = \"{long}\" }} }}"),
            "",
        ),
    ] {
        pair_with(folder, &wheel, below);
        let message = message(folder);
        let lengths = message.lines().map(|line| line.chars().count());
        let longest = lengths.max().unwrap();
        let is_short = longest < 6100 && message.chars().count() < 15_000;
        assert!(is_short, "{longest}");
        // A line that names no column is no header, and is not shown; headings are listed.
        let is_no_header = message.contains("no line names the columns");
        let is_listed = message.contains("\"left (ä") && message.contains("ä … (B)");
        let is_cut = message.contains(&shown) || is_no_header || is_listed;
        assert!(is_cut, "{message}");
    }
    // A parser's own words.
    write("pair.toml", format!("\"{long}\" = 1\n\"{long}\" = 2\n"));
    let message = message(folder);
    let is_short = message.chars().count() < 500;
    assert!(
        is_short && message.contains("duplicate key `\"ää"),
        "{message}"
    );
}
