//! Slips of unit and sign: each has one warning with the likely intention, near-misses and the fixtures have none.

use super::*;
use std::f64::consts::TAU;

const RIG: &str = "center_distance_mm,wheel_tooth,pinion_tooth,measured_right_um,measured_left_um,predicted_min_um,predicted_max_um,source\n37.1,1,1,50,51,40,60,rig\n37.1,2,2,50,51,40,60,rig\n";

/// The warnings of a pair file.
fn warnings(text: &str) -> Vec<String> {
    let folder = TempDir::new().unwrap();
    for (name, row) in [
        ("rig.csv", ""),
        ("twice.csv", "37.1,1,1,50,51,40,60,again\n"),
        ("repeated.csv", "37.1,1,1,50,52,40,60,again\n"),
    ] {
        fs::write(folder.path().join(name), format!("{RIG}{row}")).unwrap();
    }
    let path = folder.path().join("pair.toml");
    fs::write(&path, text).unwrap();
    let read = read(&path).unwrap_or_else(|error| panic!("{error}"));
    read.warnings
}

/// A pair of 20 and 17 teeth, module 2, with keys of the wheel, of the assembly, and tables below.
fn pair(wheel: &str, assembly: &str, below: &str) -> String {
    let gear = "module_mm = 2.0\npressure_angle_deg = 20.0\n";
    format!(
        "[wheel]\nteeth = 20\n{gear}{wheel}\n[pinion]\nteeth = 17\n{gear}[assembly]\n{assembly}\n{below}\n"
    )
}

/// The pair with keys of the wheel.
fn of(wheel: &str) -> String {
    pair(wheel, "center_distance_mm = 37.1", "")
}

/// The warnings of each pair, a line each, then an empty line.
fn slips(pairs: &[String]) -> String {
    let of_pair = |text: &String| {
        let found = warnings(text);
        assert!(!found.is_empty(), "{text}");
        format!("{}\n\n", found.join("\n"))
    };
    pairs.iter().map(of_pair).collect()
}

fn none(pairs: &[String]) {
    for text in pairs {
        assert_eq!(warnings(text), [""; 0], "{text}");
    }
}

fn list(of: impl Fn(f64) -> f64) -> String {
    let values = (0..20).map(|i| format!("{:.5}", of(f64::from(i))));
    format!("[{}]", values.collect::<Vec<_>>().join(", "))
}

/// Deviations of some µm without a wave round the gear, scaled.
fn noise(i: f64, scale: f64) -> f64 {
    scale * ((7.0 * i) % 5.0 - 2.0)
}

fn allowance(um: &str) -> String {
    of(&format!("thickness = {{ allowance_um = {um} }}"))
}

fn runout(um: f64) -> String {
    of(&format!("runout = {{ total_um = {um:?}, high_tooth = 3 }}"))
}

#[test]
fn micrometres_that_are_millimetres_and_other_units() {
    let pitch = |scale: f64| {
        let (right, left) = (list(|i| noise(i, scale)), list(|i| noise(i + 1.0, scale)));
        of(&format!(
            "pitch = {{ kind = \"cumulative\", right_um = {right}, left_um = {left} }}"
        ))
    };
    let below = |tables: &str| pair("", "center_distance_mm = 37.1", tables);
    let distance = |distance: &str| {
        let cold = "expansion_per_k = 0";
        let text = pair(cold, &format!("center_distance_mm = {distance}"), "");
        text.replace("teeth = 17\n", &format!("teeth = 17\n{cold}\n"))
    };
    let per_tooth = |scale: f64| {
        let each = list(|i| noise(i, scale));
        of(&format!("thickness = {{ per_tooth_um = {each} }}"))
    };
    insta::assert_snapshot!(slips(&[
        allowance("-0.022"),
        allowance("{ min = -0.030, max = -0.022 }"),
        runout(0.0066),
        pitch(0.002),
        per_tooth(0.002),
        of("profile = { slope_um = 0.004 }"),
        of("profile.trace = { roll_length_mm = [5, 7], deviation_um = [0, 0.003] }"),
        below(
            "[tolerance]\ncenter_distance = { scatter = \"normal\", sigma_um = 0.01, mean_um = 0.02 }"
        ),
        distance("{ nominal_mm = 37.1, tolerance_um = 0.03 }"),
        distance("37.1\ntemperature_c = 140\nhousing_expansion_per_k = 0"),
        distance("37.1\ntemperature_c = 293\nhousing_expansion_per_k = 0"),
        of("face_width_mm = 0.03"),
        allowance("-600"),
        of("helix_angle_deg = 0.35\nhand = \"left\"\nface_mm = [-10, 10]").replace(
            "teeth = 17\n",
            "teeth = 17\nhelix_angle_deg = 0.35\nhand = \"right\"\nface_mm = [-10, 10]\n"
        ),
        of("thickness = { flank_offset_mm = -0.00005 }"),
    ]));
    // 1e-9: rounding of what the gauge reads on a perfect gear.
    none(&[
        pitch(2.0),
        pitch(0.0),
        per_tooth(2.0),
        runout(0.5),
        runout(1e-9),
    ]);
    none(&["-0.5", "{ min = -22, max = -0.4 }", "0", "-22"].map(allowance));
}

/// The radial clearance is 0.25 m + 0.1 mm: 600 µm, of which half is 300.
#[test]
fn signs_plays_runouts_tolerances_and_rows() {
    let bearings = |clearance: &str| {
        let distance = "center_distance_mm = 37.3\nbearing_clearance_mm = ";
        pair("", &format!("{distance}{clearance}"), "")
    };
    let below = |tables: &str| pair("", "center_distance_mm = 37.1", tables);
    insta::assert_snapshot!(slips(&[
        allowance("22"),
        allowance("{ min = -5, max = 22 }"),
        bearings("{ wheel = 0.5, pinion = 0.02 }"),
        runout(310.0),
        below("[compare]\ntolerance_um = 150"),
        below("[measured]\nfile = \"twice.csv\""),
        pair("", "center_distance_mm = [38, 37.7]", ""),
    ]));
    none(&[
        pair("", "center_distance_mm = [38, 37.6]", ""),
        allowance("-490"),
        bearings("0.1"),
        runout(290.0),
        below("[compare]\ntolerance_um = 100"),
        below("[measured]\nfile = \"repeated.csv\""),
        below("[measured]\nfile = \"rig.csv\""),
    ]);
}

#[test]
fn thicknesses_in_place_of_deviations() {
    let mean = |keys: &str, mean: f64| {
        let each = list(|i| mean + noise(i, 2.0));
        of(&format!("thickness = {{ {keys}per_tooth_um = {each} }}"))
    };
    let beside = |um: f64| mean("allowance_um = -22, ", um);
    insta::assert_snapshot!(slips(&[mean("", -210.0), beside(-22.0)]));
    none(&[mean("", -190.0), beside(-1.0)]);
}

/// 25/36 teeth, m 1, 25°: without profile shift 30.5; with x 0/0.2 inv α_w = inv 25° + 2 · 0.2 tan 25° / 61 gives 30.6971 mm, with 0.6 31.0761 mm.
/// 30/40 teeth, m 1, 20°, x 0.4/0.5: 35.8310 mm; at 25° 35.8547 mm (both by bisection of the involute function, apart from the program).
#[test]
fn a_centre_distance_of_another_pair() {
    let pair = |teeth: [u32; 2], angle: f64, x: [f64; 2], a: &str| {
        let gear = |k: usize| {
            format!(
                "teeth = {}\nmodule_mm = 1.0\npressure_angle_deg = {angle:?}\nprofile_shift = {:?}\nrack = {{ root_radius = 0.3 }}\n",
                teeth[k], x[k]
            )
        };
        let (wheel, pinion) = (gear(0), gear(1));
        format!(
            "[wheel]\n{wheel}[pinion]\n{pinion}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n"
        )
    };
    let small = |x: [f64; 2], a: &str| pair([25, 36], 25.0, x, a);
    let large = |angle: f64, a: &str| pair([30, 40], angle, [0.4, 0.5], a);
    insta::assert_snapshot!(slips(&[
        small([0.0, 0.2], "30.5"),
        small([0.1, 0.2], "30.697"),
        small([0.0, 0.0], "31.076"),
        large(20.0, "35.855"),
    ]));
    none(&[
        small([0.0, 0.2], "30.697"),
        small([0.0, 0.2], "30.73"),
        small([0.0, 0.0], "30.5"),
        small([0.0, 0.0], "30.7"),
        // A scan that passes the right distance.
        small([0.0, 0.2], "[30.5, 30.7, 30.8]"),
        large(25.0, "35.855"),
        large(20.0, "35.831"),
    ]);
}

/// F = −e sin(ψ ∓ α)/cos α of an eccentricity e towards tooth 1 (first order, as in the documentation of the datum axis).
#[test]
fn pitch_with_the_harmonic_of_the_stated_runout() {
    let alpha = 20f64.to_radians();
    let pitch = |shift: f64, runout: f64| {
        let wave = |sign: f64| {
            list(|i| -10.0 * (TAU * i / 20.0 - sign * shift).sin() / alpha.cos() + noise(i, 0.1))
        };
        let (right, left) = (wave(1.0), wave(-1.0));
        of(&format!(
            "runout = {{ total_um = {runout}, high_tooth = 9 }}\npitch = {{ kind = \"cumulative\", right_um = {right}, left_um = {left} }}"
        ))
    };
    // Not where the runout says, but as large.
    insta::assert_snapshot!(slips(&[pitch(alpha, 20.0)]));
    // A wave that moves both flanks alike is no eccentricity's.
    none(&[pitch(0.0, 20.0), pitch(alpha, 60.0)]);
}

/// 20 teeth, m 2: W_3 = 15.3209 mm nominal, W_2 = 9.4168 mm (W_k = m cos α ((k − ½) π + z inv α)); 10 µm thinner in base thickness.
#[test]
fn a_cross_check_of_the_same_kind() {
    let checked = |statement: &str, check: &str| {
        of(&format!(
            "[wheel.thickness]\n{statement}\n[wheel.thickness.cross_check]\n{check}"
        ))
    };
    let span = "span = { teeth = 3, mm = 15.311 }";
    insta::assert_snapshot!(slips(&[
        checked(span, span),
        checked("allowance_um = -10", "allowance_um = -11"),
    ]));
    none(&[
        checked(span, "span = { teeth = 2, mm = 9.407 }"),
        checked(span, "allowance_um = -10.6"),
    ]);
}

/// The example of the documentation and the sheets beside the fixtures are not suspected.
#[test]
fn good_pairs_are_not_suspected() {
    let page = fs::read_to_string("../../docs/reference/pair-file.md").unwrap();
    let mut blocks = page
        .split("```")
        .filter_map(|block| block.strip_prefix("toml\n"));
    let example = blocks.find(|block| block.contains("[assembly]")).unwrap();
    let mut told = warnings(example);
    for entry in fs::read_dir("../../fixtures/sheets").unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            told.extend(read(&path).unwrap().warnings);
        }
    }
    let words = [
        "were meant",
        "check its sign",
        "radial",
        "would fit",
        "as large as",
        "same values",
    ];
    let suspected = |told: &&String| words.iter().any(|words| told.contains(words));
    assert_eq!(told.iter().find(suspected), None);
}
