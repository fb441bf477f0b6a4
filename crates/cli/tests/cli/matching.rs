//! `gearlash match`.

use super::*;
use std::fs;
use std::path::Path;

/// A gear file of 44 teeth, its thickness less by `less_um`, with a runout `F_r`, its high tooth 7.
fn gear(folder: &Path, name: &str, less_um: f64, runout_um: f64) {
    fs::create_dir_all(folder).unwrap();
    let text = format!(
        "[gear]\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = {}\nrunout.total_um = {runout_um}\nrunout.high_tooth = 7\n",
        -less_um
    );
    fs::write(folder.join(name), text).unwrap();
}

fn pair(folder: &Path, require: &str) {
    let gear =
        "teeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\n";
    let text = format!(
        "title = \"rig\"\n[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.0\n{require}"
    );
    fs::write(folder.join("pair.toml"), text).unwrap();
}

fn matched(folder: &Path) -> assert_cmd::assert::Assert {
    let words = [
        "match",
        "pair.toml",
        "--wheels",
        "w",
        "--pinions",
        "p",
        "-o",
        "out",
    ];
    gearlash(folder).args(words).assert()
}

/// At the reference centre distance perfect gears have the backlash that their teeth are thinner: 40 + 80 µm of a thick and a thin one.
#[test]
fn thick_teeth_go_with_thin_ones() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "thick.toml", 40.0, 0.0);
        gear(&here.join(kind), "thin.toml", 80.0, 0.0);
    }
    pair(here, "[require]\nj_wt_um = { min = 115, max = 125 }\n");
    matched(here).success().stdout(predicates::str::starts_with(
        "2 of 2 pairs keep 115 … 125 µm; to be expected 1.0 at random, 2.0 with 2 thickness classes.",
    ));
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(here.join("out/match.json")).unwrap()).unwrap();
    let names: Vec<[&str; 2]> = json["pairs"]
        .as_array()
        .unwrap()
        .iter()
        .map(|pair| ["wheel", "pinion"].map(|kind| pair[kind].as_str().unwrap()))
        .collect();
    assert_eq!(names, [["thick", "thin"], ["thin", "thick"]]);
    for pair in json["pairs"].as_array().unwrap() {
        for end in ["least_um", "greatest_um"] {
            assert!((pair[end].as_f64().unwrap() - 120.0).abs() < 1e-3, "{pair}");
        }
    }
}

/// Two eccentric gears of one number of teeth have, with their high places together, twice the spread; marked, none but that of rounding:
/// the backlash of their phase is what `simulate` finds where the teeth that are marked meet.
#[test]
fn marked_teeth_have_the_backlash_that_simulate_finds() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "one.toml", 60.0, 30.0);
    }
    pair(here, "[require]\nj_wt_um = { min = 110 }\n");
    matched(here).success();
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(here.join("out/match.json")).unwrap()).unwrap();
    let found = &json["pairs"][0];
    let gear = |start: &str| {
        format!(
            "{start}\nteeth = 44\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -60\nrunout.total_um = 30\nrunout.high_tooth = 7\n"
        )
    };
    let text = format!(
        "{}{}[assembly]\ncenter_distance_mm = 132.0\n[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 8\nstart = [1, {}]\n",
        gear("[wheel]"),
        gear("[pinion]"),
        found["pinion_tooth"]
    );
    fs::write(here.join("phase.toml"), text).unwrap();
    let output = gearlash(here)
        .args(["simulate", "phase.toml", "--no-files", "--format", "json"])
        .output()
        .unwrap();
    let simulated: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let extremes = &simulated["extremes"][0];
    for (end, at) in [("least", 0), ("greatest", 1)] {
        let bracket = extremes[end]["j_wt_um"][at].as_f64().unwrap();
        let here = found[format!("{end}_um")].as_f64().unwrap();
        assert!((bracket - here).abs() < 2e-3, "{end}: {bracket} {here}");
    }
    // All phases together spread by twice both runouts' share; the marked one by less than a tenth.
    let spread = found["greatest_um"].as_f64().unwrap() - found["least_um"].as_f64().unwrap();
    assert!(spread < 3.0, "{spread}");
}

/// All that is wrong is told at once, and nothing is written.
#[test]
fn what_cannot_be_matched_is_told() {
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

/// A gear without a mate is left over: exit code 1.
#[test]
fn a_gear_without_a_mate_is_left_over() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    gear(&here.join("w"), "thick.toml", 40.0, 0.0);
    gear(&here.join("w"), "fat.toml", -300.0, 0.0);
    gear(&here.join("p"), "a.toml", 40.0, 0.0);
    gear(&here.join("p"), "b.toml", 40.0, 0.0);
    pair(here, "");
    matched(here)
        .code(1)
        .stdout(predicates::str::starts_with("1 of 2 pairs assemble"))
        .stdout(predicates::str::contains("Wheels left over: fat."));
}

/// A gear whose reference face is at the back has its teeth numbered the other way, what was right on it is left: matched so it is the gear
/// with its sheet turned over by hand, tooth `t` being tooth `22 - t` of 20, and a place along ascending numbers one against them.
#[test]
fn a_gear_seen_from_behind_is_its_sheet_turned_over() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let basic = "teeth = 20\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n";
    let sheet = |tooth: f64, right: &[f64], left: &[f64]| {
        format!(
            "[gear]\n{basic}thickness.allowance_um = -60\nrunout = {{ total_um = 30, high_tooth = {tooth} }}\n\
             pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {left:?} }}\n"
        )
    };
    let wave = |lag: f64| -> Vec<f64> {
        (0..20)
            .map(|k| (8.0 * (0.3 * f64::from(k * k) + lag).sin()).round())
            .collect()
    };
    let (right, left) = (wave(0.0), wave(1.0));
    let turned = |list: &[f64]| -> Vec<f64> { (0..20).map(|k| -list[(20 - k) % 20]).collect() };
    for kind in ["w", "asis", "turned"] {
        fs::create_dir_all(here.join(kind)).unwrap();
    }
    fs::write(here.join("w/1.toml"), sheet(4.0, &left, &right)).unwrap();
    fs::write(here.join("asis/1.toml"), sheet(7.0, &right, &left)).unwrap();
    let over = sheet(15.0, &turned(&left), &turned(&right));
    fs::write(here.join("turned/1.toml"), over).unwrap();
    let matched = |pinions: &str, face: &str| -> serde_json::Value {
        let text = format!(
            "[wheel]\n{basic}[pinion]\n{basic}reference_face = \"{face}\"\n[assembly]\ncenter_distance_mm = 60.0\n[require]\nj_wt_um.min = 0\n"
        );
        fs::write(here.join("pair.toml"), text).unwrap();
        let words = ["match", "pair.toml", "--wheels", "w", "--pinions", pinions];
        let output = gearlash(here)
            .args(words)
            .args(["--format", "json", "-o", "out"])
            .output()
            .unwrap();
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["pairs"][0].clone()
    };
    let (behind, by_hand) = (matched("asis", "back"), matched("turned", "front"));
    for end in ["least_um", "greatest_um"] {
        let ends = [&behind, &by_hand].map(|pair| pair[end].as_f64().unwrap());
        assert!((ends[0] - ends[1]).abs() < 1e-3, "{end}: {ends:?}");
    }
    let tooth = |pair: &serde_json::Value| pair["pinion_tooth"].as_u64().unwrap();
    assert_eq!(tooth(&behind), (21 - tooth(&by_hand)) % 20 + 1);
    assert_ne!(matched("asis", "front")["least_um"], behind["least_um"]);
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

/// A gear that is not one of the pair's is told with its file and key, and so are the others.
#[test]
fn gears_of_another_pair_are_told() {
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

/// Every file of a folder that is named as a gear file is a gear, or is told.
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
fn bands_that_are_not_used_are_told_once() {
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
        .args([
            "match",
            "pair.toml",
            "--wheels",
            "w",
            "--pinions",
            "p",
            "--format",
            "json",
            "-o",
            "out",
        ])
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
fn warnings_of_the_gear_files_are_told() {
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

/// At `a = d_1/2 + d_2/2` perfect gears have `j_wt = j_t`, `j_bn = j_wt cos 20°`: what is required of `j_bn` decides as of `j_wt`, and the middle of it is
/// wanted. It was a warning, and any pair met it.
#[test]
fn every_requirement_decides_which_gears_go_together() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for kind in ["w", "p"] {
        gear(&here.join(kind), "thick.toml", 40.0, 0.0);
        gear(&here.join(kind), "thin.toml", 80.0, 0.0);
    }
    let cos = 20f64.to_radians().cos();
    let [min, max] = [115.0, 125.0].map(|um| um * cos);
    for require in [
        format!("j_bn_um = {{ min = {min}, max = {max} }}"),
        "j_t_um = { min = 115, max = 125 }".to_owned(),
    ] {
        pair(here, &format!("[require]\n{require}\n"));
        let printed = output(gearlash(here).args([
            "match",
            "pair.toml",
            "--wheels",
            "w",
            "--pinions",
            "p",
            "--format",
            "json",
            "-o",
            "out",
        ]));
        let json: serde_json::Value = serde_json::from_str(&printed).unwrap();
        assert_eq!(json["pairs"][0]["pinion"], "thin");
        let wanted = json["wanted_um"].as_f64().unwrap();
        assert!((wanted - 120.0).abs() < 1e-9, "{wanted}");
        let expected = json["expected_pairs"]["random"]["any_phase"]
            .as_f64()
            .unwrap();
        assert!((expected - 1.0).abs() < 1e-12, "{expected}");
        let text = json["text"].as_str().unwrap();
        assert!(text.starts_with("2 of 2 pairs keep j_"), "{text}");
    }
    pair(here, "[require]\nradial_clearance_mm = { min = 0.9 }\n");
    matched(here).code(1).stdout(predicates::str::starts_with(
        "0 of 2 pairs keep radial clearance 0.9 mm or more",
    ));
}

/// Wheels and pinions of which each has a thickness and a runout of its own, and their pair.
fn many(here: &Path) {
    for (kind, count) in [("w", 5u32), ("p", 4)] {
        for k in 0..count {
            let (less, runout) = (40.0 + 9.0 * f64::from(k), 7.0 * f64::from(k % 3));
            gear(&here.join(kind), &format!("g{k}.toml"), less, runout);
        }
    }
    pair(here, "[require]\nj_wt_um = { min = 100, max = 130 }\n");
}

fn run(here: &Path, words: &str) -> (Option<i32>, String, String) {
    let output = gearlash(here)
        .args(words.split_whitespace())
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn written(folder: &Path) -> Vec<(std::ffi::OsString, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<_> = entries
        .map(|one| (one.file_name(), fs::read(one.path()).unwrap()))
        .collect();
    files.sort();
    files
}

const MATCH: &str = "match pair.toml --wheels w --pinions p";

/// However the matrix is cut, in more parts than it has places too, and on any number of threads.
#[test]
fn parts_of_a_matching_come_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    let whole = run(here, &format!("{MATCH} -o whole"));
    assert_eq!(whole.0, Some(0), "{}", whole.2);
    let wanted = written(&here.join("whole"));
    assert_eq!(wanted.len(), 3);
    for parts in [1, 3, 7, 64] {
        let mut names = String::new();
        for k in (1..=parts).rev() {
            let mut part = gearlash(here);
            part.env("RAYON_NUM_THREADS", ["1", "2", "7"][k % 3]);
            part.args(MATCH.split(' '));
            let shard = format!("{k}/{parts}");
            part.args(["--shard", &shard, "-o", "parts"]);
            part.assert().success();
            names += &format!("parts/part_{k}_of_{parts}.json ");
        }
        let merged = run(here, &format!("merge {names} -o merged"));
        assert_eq!(merged.0, Some(0), "{}", merged.2);
        assert!(written(&here.join("merged")) == wanted, "{parts}");
        assert_eq!(merged.1.replace("merged", "whole"), whole.1);
        for format in ["json", "csv"] {
            let told = run(here, &format!("merge {names} --format {format}"));
            assert_eq!(told.1, run(here, &format!("{MATCH} --format {format}")).1);
        }
    }
    for threads in ["1", "2", "7"] {
        let mut command = gearlash(here);
        command.env("RAYON_NUM_THREADS", threads);
        command.args(MATCH.split(' ')).args(["-o", "threads"]);
        command.assert().success();
        assert!(written(&here.join("threads")) == wanted, "{threads}");
    }
}

/// What is missing, given twice, unfinished, edited or of another matching, or of a population, is named; nothing is written.
#[test]
fn parts_that_make_no_matching_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    let part = |words: &str| {
        let done = run(here, &format!("match pair.toml --pinions p {words}"));
        assert_eq!(done.0, Some(0), "{}", done.2);
    };
    for k in 1..=3 {
        part(&format!("--wheels w --shard {k}/3 -o parts"));
    }
    part("--wheels w --shard 2/3 -o target --target-um 110");
    part("--wheels w --shard 2/4 -o four");
    fs::create_dir(here.join("fewer")).unwrap();
    for k in 0..4 {
        fs::copy(
            here.join(format!("w/g{k}.toml")),
            here.join(format!("fewer/g{k}.toml")),
        )
        .unwrap();
    }
    part("--wheels fewer --shard 2/3 -o others");
    let text = fs::read_to_string(here.join("parts/part_2_of_3.json")).unwrap();
    let edited = |name: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        fs::write(here.join(name), text.replacen(from, to, 1)).unwrap();
    };
    let version = format!("\"gearlash\":\"{}\"", env!("CARGO_PKG_VERSION"));
    edited("old.json", &version, "\"gearlash\":\"0.0.1\"");
    edited("tooth.json", "\"cells\":[[", "\"cells\":[[99");
    let first = text.find("\"cells\":[").unwrap() + "\"cells\":[".len();
    let end = text[first..].find(']').unwrap() + first + 2;
    fs::write(
        here.join("less.json"),
        format!("{}{}", &text[..first], &text[end..]),
    )
    .unwrap();
    fs::write(
        here.join("more.json"),
        format!("{}{}{}", &text[..end], &text[first..end], &text[end..]),
    )
    .unwrap();
    for (second, wanted) in [
        ("", "1 part of 3 missing: 2"),
        (
            "parts/part_3_of_3.json",
            "parts/part_3_of_3.json: is named twice",
        ),
        (
            "target/part_2_of_3.json",
            "of another run than parts/part_1_of_3.json: input",
        ),
        ("four/part_2_of_4.json", "number of parts 4, not 3"),
        (
            "others/part_2_of_3.json",
            "of another run than parts/part_1_of_3.json: input",
        ),
        ("old.json", "version of gearlash 0.0.1"),
        ("tooth.json", "it has a pair that no gears make"),
        ("less.json", "less.json: part 2 was interrupted"),
        ("more.json", "it says that more is done than it is to do"),
        ("pair.toml", "pair.toml: this is no part of a run"),
        ("nothing.json", "nothing.json: this is no part of a run"),
    ] {
        let words = format!("merge parts/part_1_of_3.json parts/part_3_of_3.json {second} -o m");
        let (code, printed, told) = run(here, &words);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{second}: {told}");
        assert!(told.contains(wanted), "{second}: {told}");
        assert!(
            !here.join("m").exists() || written(&here.join("m")).is_empty(),
            "{second}"
        );
    }
}

/// What is done is kept, and the same command goes on from it: a part file of which the first pairs are done.
#[test]
fn an_interrupted_matching_goes_on_and_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    assert_eq!(run(here, &format!("{MATCH} -o whole")).0, Some(0));
    assert_eq!(
        run(here, &format!("{MATCH} --shard 1/1 -o parts")).0,
        Some(0)
    );
    let text = fs::read_to_string(here.join("parts/part_1_of_1.json")).unwrap();
    let first = text.find("\"cells\":[").unwrap() + "\"cells\":[".len();
    let third = text[first..].match_indices("],[").nth(2).unwrap().0 + first + 1;
    fs::create_dir(here.join("out")).unwrap();
    fs::write(
        here.join("out/part.json"),
        format!("{}]}}\n", &text[..third]),
    )
    .unwrap();
    let gone_on = run(here, &format!("{MATCH} -o out"));
    assert_eq!(gone_on.0, Some(0), "{}", gone_on.2);
    assert!(
        gone_on.2.contains("out/part.json: goes on after 3 pairs"),
        "{}",
        gone_on.2
    );
    assert!(written(&here.join("out")) == written(&here.join("whole")));
    fs::write(here.join("out/part.json"), "{}").unwrap();
    let anew = run(here, &format!("{MATCH} -o out"));
    assert!(
        anew.2.contains("cannot be gone on from, and is done again"),
        "{}",
        anew.2
    );
    assert!(written(&here.join("out")) == written(&here.join("whole")));
}
