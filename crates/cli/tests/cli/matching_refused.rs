//! What `gearlash match` refuses, and what it warns of.

use super::matching::{MATCH, gear, matched, pair};
use super::*;
use std::fs;

/// All that is wrong is reported at once, and nothing is written.
#[test]
fn what_cannot_be_matched_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "good.toml", 40.0, 0.0);
    fs::write(here.join("w/bad.toml"), "[gear]\nteeth = 44\n").unwrap();
    fs::write(
        here.join("w/other.toml"),
        "[gear]\nteeth = 43\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n",
    )
    .unwrap();
    fs::create_dir_all(here.join("p")).unwrap();
    pair(here, "");
    matched(here)
        .code(2)
        .stderr(predicates::str::contains("bad.toml: gear.module_mm"))
        .stderr(predicates::str::contains(
            "other.toml: gear.teeth = 43: wheel.teeth of the pair file is 44; match gears of one pair",
        ))
        .stderr(predicates::str::contains("p: holds no gear file"));
    assert!(!here.join("out").exists());
}

/// Measured gears are those of 20 °C: a warm pair, or the gears of one, would stand at a distance that is not theirs.
#[test]
fn gears_are_not_matched_at_another_temperature() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "1.toml", 40.0, 0.0);
    gear(&here.join("p"), "1.toml", 40.0, 0.0);
    let warm = |celsius: f64| {
        let gear =
            "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nexpansion_per_k = 11.5e-6\n";
        format!(
            "[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\nhousing_expansion_per_k = 23e-6\ntemperature_c = {celsius}\n"
        )
    };
    fs::write(here.join("pair.toml"), warm(80.0)).unwrap();
    matched(here).code(2).stderr(predicates::str::contains(
        "pair.toml: assembly.temperature_c = 80: gears are matched at the 20 °C at which they were measured; remove the temperature",
    ));
    fs::write(here.join("pair.toml"), warm(20.0)).unwrap();
    matched(here).success();
    fs::write(here.join("p/pair.toml"), warm(80.0)).unwrap();
    matched(here).code(2).stderr(predicates::str::contains(
        "pair.toml: assembly.temperature_c = 80",
    ));
}

/// A gear that is not one of the pair's is reported with its file and key, and so are the others.
#[test]
fn gears_of_another_pair_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "1.toml", 40.0, 0.0);
    gear(&here.join("p"), "1.toml", 40.0, 0.0);
    let other = "[gear]\nteeth = 44\nmodule_mm = 3.5\npressure_angle_deg = 14.5\n";
    fs::write(here.join("p/other.toml"), other).unwrap();
    pair(here, "");
    matched(here).code(2).stderr(
        predicates::str::contains(
            "other.toml: gear.module_mm = 3.5: pinion.module_mm of the pair file is 3; match gears of one pair",
        )
        .and(predicates::str::contains(
            "other.toml: gear.pressure_angle_deg = 14.5: pinion.pressure_angle_deg of the pair file is 20",
        )),
    );
}

/// Every file of a folder that is named as a gear file is a gear, or is reported.
#[test]
fn no_gear_file_of_a_folder_is_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    pair(here, "");
    gear(&here.join("p"), "1.toml", 40.0, 0.0);
    gear(&here.join("p"), "2.toml", 40.0, 0.0);
    gear(&here.join("w"), "1.TOML", 40.0, 0.0);
    gear(&here.join("w"), "2.Toml", 40.0, 0.0);
    fs::write(here.join("w/readme.txt"), "gears").unwrap();
    matched(here)
        .success()
        .stdout(predicates::str::starts_with("2 of 2 pairs assemble"));
    fs::create_dir(here.join("w/folder.toml")).unwrap();
    fs::write(
        here.join("p/2.json"),
        "{\"gear\": {\"teeth\": 44, \"module_mm\": 3.0, \"pressure_angle_deg\": 20.0}}",
    )
    .unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("nowhere", here.join("p/gone.json")).unwrap();
    let told = matched(here)
        .code(2)
        .stderr(predicates::str::contains("folder.toml: is no file"))
        .stderr(predicates::str::contains(
            "2.toml: 2.json is a gear of the same name; rename one of them",
        ));
    if cfg!(unix) {
        told.stderr(predicates::str::contains("gone.json: cannot be read: "));
    }
}

/// Of a band of thickness its middle is matched; a band of the pair file, and how its numbers scatter, say nothing of measured gears.
#[test]
fn bands_that_are_not_used_are_reported_once() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let band = "thickness.allowance_um = { min = -90, max = -50 }\n";
    let text = format!("[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n{band}");
    for kind in ["w", "p"] {
        gear(&here.join(kind), "1.toml", 70.0, 0.0);
        fs::write(here.join(kind).join("2.toml"), &text).unwrap();
    }
    let gear = "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n";
    let text = format!(
        "[wheel]\n{gear}{band}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\n[tolerance]\ncenter_distance = {{ scatter = \"normal\", sigma_um = 5 }}\n"
    );
    fs::write(here.join("pair.toml"), text).unwrap();
    let output = gearlash(here)
        .args(MATCH.split(' '))
        .args(["--format", "json", "-o", "out"])
        .output()
        .unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    let told: Vec<&str> = told.lines().collect();
    assert_eq!(
        told,
        [
            "warning: pair.toml: wheel.thickness.allowance_um, tolerance: not used: gears are matched as the files of the two folders have them",
            "warning: pair.toml: w/2.toml: gear.thickness.allowance_um: a band, whose middle is matched, as in one file more: state what was measured",
        ]
    );
    // All four are 70 µm thinner than nominal.
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for pair in json["pairs"].as_array().unwrap() {
        assert!(
            (pair["least_um"].as_f64().unwrap() - 140.0).abs() < 1e-3,
            "{pair}"
        );
    }
}

/// What the gears' own files warn of, as `gauge` tells it, once for all that say the same: single pitches that do not close.
#[test]
fn warnings_of_the_gear_files_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let values = format!("[9{}]", ", 0".repeat(43));
    let text = format!(
        "[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n\
         pitch = {{ kind = \"single\", right_um = {values}, left_um = {values} }}\n"
    );
    for (kind, names) in [("w", ["1.toml", "2.toml"]), ("p", ["1.toml", "2.toml"])] {
        fs::create_dir_all(here.join(kind)).unwrap();
        for name in names {
            fs::write(here.join(kind).join(name), &text).unwrap();
        }
    }
    pair(here, "");
    let alone = gearlash(here)
        .args(["gauge", "w/1.toml", "--format", "json", "-o", "g"])
        .output()
        .unwrap();
    let alone = String::from_utf8(alone.stderr).unwrap();
    let warned: Vec<&str> = alone
        .lines()
        .filter_map(|line| line.strip_prefix("warning: w/1.toml: "))
        .collect();
    assert!(!warned.is_empty(), "{alone}");
    let output = matched(here);
    let told = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    for text in warned {
        let line = format!("warning: w/1.toml and 3 more: {text}");
        assert!(told.lines().any(|told| told == line), "{line}: {told}");
    }
    // Of gears that are drawn whole, too.
    let pair = fs::read_to_string(here.join("pair.toml")).unwrap();
    let drawn = "[tolerance]\nassemblies = 20\n[tolerance.wheel]\ngears = \"w/*.toml\"\n";
    fs::write(here.join("drawn.toml"), pair + drawn).unwrap();
    let output = gearlash(here)
        .args(["tolerance", "drawn.toml", "-o", "t"])
        .output()
        .unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    let wanted = "warning: drawn.toml: tolerance.wheel.gears: w/1.toml and 1 more: gear.pitch";
    assert!(told.contains(wanted), "{told}");
}

/// A gear file name becomes a cell: it acts on no terminal, log or spreadsheet.
#[cfg(unix)]
#[test]
fn names_of_gears_act_on_no_terminal_log_or_spreadsheet() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for name in ["=1+1.toml", "::error::x.toml", "\u{1b}[31mred.toml"] {
        gear(&here.join("w"), name, 40.0, 0.0);
    }
    gear(&here.join("p"), "@p.toml", 40.0, 0.0);
    pair(here, "");
    // Two wheels are left over, which have no mate: exit 0.
    matched(here).success();
    let matrix = fs::read_to_string(here.join("out/matrix.csv")).unwrap();
    let words = MATCH.split(' ').chain(["--format", "csv"]);
    let printed = gearlash(here).args(words).output().unwrap();
    assert_eq!(printed.stdout, matrix.as_bytes());
    let cells: Vec<&str> = matrix.lines().skip(1).collect();
    assert!(cells[0].starts_with(" [31mred,'@p,"), "{matrix}");
    assert!(cells[1].starts_with(": :error::x,'@p,"), "{matrix}");
    assert!(cells[2].starts_with("'=1+1,'@p,"), "{matrix}");
}

/// Results among the gears would be gears of the next run, and a gear of both folders would be its own mate.
#[test]
fn folders_of_gears_take_no_results_and_are_two() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "1.toml", 40.0, 0.0);
    }
    pair(here, "");
    let refused = |words: &str, wanted: &str| {
        let mut command = gearlash(here);
        let ended = command.args(words.split(' ')).assert().code(2);
        ended.stdout("").stderr(predicates::str::contains(wanted));
    };
    refused(
        &format!("{MATCH} -o w"),
        "-o w: this is the folder of --wheels",
    );
    refused(
        &format!("{MATCH} -o w/../p --format json"),
        "this is the folder of --pinions",
    );
    refused(
        "match pair.toml --wheels w --pinions ./w",
        "--wheels and --pinions are one folder, w",
    );
    for kind in ["w", "p"] {
        assert_eq!(files(&here.join(kind)), ["1.toml"]);
    }
}
