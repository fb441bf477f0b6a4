//! Slips of unit and sign: each is noticed with the likely intention, its near-misses and the fixtures are not; nothing is changed.

use super::*;
use std::f64::consts::TAU;
use std::fs;

/// A pair of 20 and 17 teeth, module 2, with these keys.
struct Keys<'a> {
    wheel: &'a str,
    assembly: &'a str,
    below: &'a str,
}

const PLAIN: Keys = Keys {
    wheel: "",
    assembly: "center_distance_mm = 37.1",
    below: "",
};

fn text(keys: &Keys) -> String {
    let gear = "module_mm = 2.0\npressure_angle_deg = 20.0\n";
    format!(
        "[wheel]\nteeth = 20\n{gear}{}\n[pinion]\nteeth = 17\n{gear}[assembly]\n{}\n{}\n",
        keys.wheel, keys.assembly, keys.below
    )
}

/// What `check` warns of.
fn warned(pair: &str) -> Vec<String> {
    let folder = empty_folder();
    fs::write(folder.path().join("pair.toml"), pair).unwrap();
    fs::write(folder.path().join("rig.csv"), RIG).unwrap();
    fs::write(
        folder.path().join("twice.csv"),
        format!("{RIG}37.1,1,1,50,51,40,60,again\n"),
    )
    .unwrap();
    fs::write(
        folder.path().join("repeated.csv"),
        format!("{RIG}37.1,1,1,50,52,40,60,again\n"),
    )
    .unwrap();
    let output = gearlash(folder.path())
        .args([
            "snapshot",
            "pair.toml",
            "--mating",
            "1,1",
            "--flank",
            "right",
            "--center-distance",
            "37.1",
            "-o",
            "-",
        ])
        .output()
        .unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    let warning = |line: &str| line.strip_prefix("warning: pair.toml: ").map(str::to_owned);
    let warnings = told.lines().filter_map(warning).collect();
    assert!(!told.contains("error: pair.toml"), "{told}\n{pair}");
    warnings
}

const RIG: &str = "center_distance_mm,wheel_tooth,pinion_tooth,measured_right_um,measured_left_um,predicted_min_um,predicted_max_um,source\n37.1,1,1,50,51,40,60,rig\n37.1,2,2,50,51,40,60,rig\n";

fn wheel(keys: &str) -> Vec<String> {
    warned(&text(&Keys {
        wheel: keys,
        ..PLAIN
    }))
}

fn assembly(keys: &str) -> Vec<String> {
    warned(&text(&Keys {
        assembly: keys,
        ..PLAIN
    }))
}

fn below(tables: &str) -> Vec<String> {
    warned(&text(&Keys {
        below: tables,
        ..PLAIN
    }))
}

/// Exactly one warning, which says `words`.
fn one(warnings: &[String], words: &str) {
    assert_eq!(warnings.len(), 1, "{words}: {warnings:#?}");
    assert!(warnings[0].contains(words), "{words}: {warnings:#?}");
}

fn none(warnings: &[String]) {
    assert!(warnings.is_empty(), "{warnings:#?}");
}

fn list(of: impl Fn(f64) -> f64) -> String {
    let values = (0..20).map(|i| format!("{:.5}", of(f64::from(i))));
    format!("[{}]", values.collect::<Vec<_>>().join(", "))
}

/// Deviations of some µm without a wave round the gear, scaled.
fn noise(i: f64, scale: f64) -> f64 {
    scale * ((7.0 * i) % 5.0 - 2.0)
}

#[test]
fn micrometres_that_are_millimetres() {
    one(
        &wheel("thickness = { allowance_um = -0.022 }"),
        "wheel.thickness.allowance_um: the greatest value is -0.022 µm",
    );
    one(
        &wheel("thickness = { allowance_um = { min = -0.030, max = -0.022 } }"),
        "-0.03 mm are -30",
    );
    one(
        &wheel("runout = { total_um = 0.0066, high_tooth = 3 }"),
        "wheel.runout.total_um: the greatest value is 0.0066 µm",
    );
    let pitch = |scale: f64| {
        let (right, left) = (list(|i| noise(i, scale)), list(|i| noise(i + 1.0, scale)));
        wheel(&format!(
            "pitch = {{ kind = \"cumulative\", right_um = {right}, left_um = {left} }}"
        ))
    };
    one(&pitch(0.002), "wheel.pitch: ");
    none(&pitch(2.0));
    none(&pitch(0.0));
    let per_tooth = |scale: f64| {
        wheel(&format!(
            "thickness = {{ per_tooth_um = {} }}",
            list(|i| noise(i, scale))
        ))
    };
    one(&per_tooth(0.002), "wheel.thickness.per_tooth_um: ");
    none(&per_tooth(2.0));
    none(&wheel("thickness = { allowance_um = -0.5 }"));
    none(&wheel(
        "thickness = { allowance_um = { min = -22, max = -0.4 } }",
    ));
    none(&wheel("thickness = { allowance_um = 0 }"));
    none(&wheel("runout = { total_um = 0.5, high_tooth = 3 }"));
    // Rounding of what the gauge reads on a perfect gear.
    none(&wheel("runout = { total_um = 1e-9, high_tooth = 3 }"));
}

#[test]
fn an_allowance_above_0() {
    one(
        &wheel("thickness = { allowance_um = 22 }"),
        "if -22 µm was meant",
    );
    one(
        &wheel("thickness = { allowance_um = { min = -5, max = 22 } }"),
        "check its sign",
    );
    none(&wheel("thickness = { allowance_um = -22 }"));
}

#[test]
fn a_bearing_with_too_much_play() {
    one(
        &assembly(
            "center_distance_mm = 37.3\nbearing_clearance_mm = { wheel = 0.5, pinion = 0.02 }",
        ),
        "if µm were meant, write 0.0005",
    );
    none(&assembly(
        "center_distance_mm = 37.3\nbearing_clearance_mm = 0.1",
    ));
}

/// The radial clearance is 0.25 m + 0.1 mm here: 600 µm, of which half is 300.
#[test]
fn a_runout_of_more_than_half_the_radial_clearance() {
    one(
        &wheel("runout = { total_um = 310, high_tooth = 3 }"),
        "more than half of the radial clearance, 600.0 µm",
    );
    none(&wheel("runout = { total_um = 290, high_tooth = 3 }"));
}

#[test]
fn thicknesses_in_place_of_deviations() {
    let mean = |mean: f64| {
        wheel(&format!(
            "thickness = {{ per_tooth_um = {} }}",
            list(|i| mean + noise(i, 2.0))
        ))
    };
    one(
        &mean(-210.0),
        "its mean is -210.0 µm, more than a tenth of the module",
    );
    none(&mean(-190.0));
    let beside = |mean: f64| {
        wheel(&format!(
            "thickness = {{ allowance_um = -22, per_tooth_um = {} }}",
            list(|i| mean + noise(i, 2.0))
        ))
    };
    one(&beside(-22.0), "adds to the stated allowance_um");
    none(&beside(-1.0));
}

/// 25/36 teeth, m 1, 25°: without profile shift 30.5; with x 0/0.2 inv α_w = inv 25° + 2 · 0.2 tan 25° / 61 gives 30.6971 mm, with 0.6 31.0761 mm.
/// 30/40 teeth, m 1, 20°, x 0.4/0.5: 35.8310 mm; at 25° 35.8547 mm (both by bisection of the involute function, apart from the program).
#[test]
fn a_centre_distance_of_another_pair() {
    let pair = |teeth: (u32, u32), angle: f64, x: (f64, f64), a: &str| {
        let gear = |teeth: u32, x: f64| {
            format!(
                "teeth = {teeth}\nmodule_mm = 1.0\npressure_angle_deg = {angle:?}\nprofile_shift = {x:?}\nrack = {{ root_radius = 0.3 }}\n"
            )
        };
        warned_at(&format!(
            "[wheel]\n{}[pinion]\n{}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n",
            gear(teeth.0, x.0),
            gear(teeth.1, x.1)
        ))
    };
    let small = |x: (f64, f64), a: &str| pair((25, 36), 25.0, x, a);
    one(
        &small((0.0, 0.2), "30.5"),
        "it would fit no profile shift (30.5000 mm)",
    );
    one(
        &small((0.1, 0.2), "30.697"),
        "it would fit the pinion's profile shift alone",
    );
    one(&small((0.0, 0.0), "31.076"), "was profile_shift forgotten?");
    none(&small((0.0, 0.2), "30.697"));
    none(&small((0.0, 0.2), "30.73"));
    none(&small((0.0, 0.0), "30.5"));
    none(&small((0.0, 0.0), "30.7"));
    // A scan that passes the right distance.
    none(&small((0.0, 0.2), "[30.5, 30.7, 30.8]"));
    let large = |angle: f64, a: &str| pair((30, 40), angle, (0.4, 0.5), a);
    one(
        &large(20.0, "35.855"),
        "it would fit a pressure angle of 25° (35.85",
    );
    none(&large(25.0, "35.855"));
    none(&large(20.0, "35.831"));
}

/// As [`warned`], at the pair's own distances.
fn warned_at(pair: &str) -> Vec<String> {
    let folder = empty_folder();
    fs::write(folder.path().join("pair.toml"), pair).unwrap();
    let output = gearlash(folder.path())
        .args(["compare", "pair.toml"])
        .output()
        .unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(!told.contains("error"), "{told}");
    let warning = |line: &str| line.strip_prefix("warning: pair.toml: ").map(str::to_owned);
    told.lines().filter_map(warning).collect()
}

#[test]
fn a_tolerance_that_lets_everything_pass() {
    one(
        &below("[compare]\ntolerance_um = 150"),
        "compare.tolerance_um: 150 µm is as large as backlash itself",
    );
    none(&below("[compare]\ntolerance_um = 100"));
    let folder = empty_folder();
    small(folder.path());
    for (tolerance, warns) in [("150", true), ("100", false)] {
        let output = gearlash(folder.path())
            .args(["compare", "small.toml", "--tolerance-um", tolerance])
            .output()
            .unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            told.contains("warning: --tolerance-um: 150 µm"),
            warns,
            "{told}"
        );
    }
}

/// F = −e sin(ψ ∓ α)/cos α of an eccentricity e towards tooth 1 (first order, as in the documentation of the datum axis).
#[test]
fn pitch_with_the_harmonic_of_the_stated_runout() {
    let alpha = 20f64.to_radians();
    let pitch = |e: f64, shift: f64, runout: f64, high: u32| {
        let wave = |sign: f64| {
            list(|i| -e * (TAU * i / 20.0 - sign * shift).sin() / alpha.cos() + noise(i, 0.1))
        };
        wheel(&format!(
            "runout = {{ total_um = {runout}, high_tooth = {high} }}\npitch = {{ kind = \"cumulative\", right_um = {}, left_um = {} }}",
            wave(1.0),
            wave(-1.0)
        ))
    };
    // Not where the runout says, but as large.
    one(
        &pitch(10.0, alpha, 20.0, 9),
        "wheel.runout.high_tooth: the pitch of both flanks contains the first harmonic",
    );
    // A wave that moves both flanks alike is no eccentricity's.
    none(&pitch(10.0, 0.0, 20.0, 9));
    none(&pitch(10.0, alpha, 60.0, 9));
}

#[test]
fn equal_rows_of_measured_backlash() {
    one(
        &below("[measured]\nfile = \"twice.csv\""),
        "measured.file: lines 2 and 4 have the same values",
    );
    none(&below("[measured]\nfile = \"repeated.csv\""));
    none(&below("[measured]\nfile = \"rig.csv\""));
}

/// 20 teeth, m 2: W_3 = 15.3209 mm nominal, W_2 = 9.4168 mm (W_k = m cos α ((k − ½) π + z inv α)); 10 µm thinner in base thickness.
#[test]
fn a_cross_check_of_the_same_kind() {
    let checked = |statement: &str, check: &str| {
        wheel(&format!(
            "[wheel.thickness]\n{statement}\n[wheel.thickness.cross_check]\n{check}"
        ))
    };
    let span = "span = { teeth = 3, mm = 15.311 }";
    one(
        &checked(span, span),
        "is a span over as many teeth, like the statement that is used",
    );
    none(&checked(span, "span = { teeth = 2, mm = 9.407 }"));
    none(&checked(span, "allowance_um = -10.6"));
    one(
        &checked("allowance_um = -10", "allowance_um = -11"),
        "is an allowance, like",
    );
}

/// No fixture, no example and no file of `init` is suspected of anything new.
#[test]
fn good_pairs_are_not_suspected() {
    let page = fs::read_to_string(
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
            .join("docs/reference/pair-file.md"),
    )
    .unwrap();
    let example = page
        .split("```toml\n")
        .skip(1)
        .find(|block| block.contains("[assembly]"))
        .unwrap()
        .split("```")
        .next()
        .unwrap();
    let folder = empty_folder();
    fs::write(folder.path().join("readme.toml"), example).unwrap();
    output(gearlash(folder.path()).args(["init", "init.toml"]));
    let mut files = vec![
        folder.path().join("readme.toml"),
        folder.path().join("init.toml"),
    ];
    for name in ["", "sheets"] {
        let entries = fs::read_dir(fixture(name))
            .unwrap()
            .map(|entry| entry.unwrap().path());
        files
            .extend(entries.filter(|path| path.extension().is_some_and(|ending| ending == "toml")));
    }
    assert!(files.len() >= 7);
    let words = [
        "if mm were meant",
        "check its sign",
        "of radial play",
        "of the radial clearance",
        "of the module",
        "would fit",
        "hardly a difference would fail",
        "as large as the one stated here",
        "have the same values for one mating",
        "like the statement that is used",
        "adds to the stated",
    ];
    for file in files {
        let run = gearlash(folder.path())
            .arg("snapshot")
            .arg(&file)
            .args(["--mating", "1,1", "--flank", "right", "-o", "-"])
            .output()
            .unwrap();
        let told = String::from_utf8(run.stderr).unwrap();
        assert!(run.status.success(), "{told}");
        assert!(
            !words.iter().any(|words| told.contains(words)),
            "{}: {told}",
            file.display()
        );
    }
}
