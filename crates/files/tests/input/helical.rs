//! Helical gears as they are read. `tests/sessions/helical.txt` holds what is refused.

use super::*;
use gearlash::contact::ExactKernel;
use gearlash::gear::{Gear, Hand};
use gearlash::pair::{Mating, Pose};

const HELICAL: &str = include_str!("helical.toml");

/// A gear as it runs.
fn built(file: &PairFile, member: Member) -> Gear {
    let run = file.study.runs().unwrap().remove(0);
    run.run.assembly.data().unwrap().gear(member).gear().clone()
}

/// The common face is what both have; radii are of the transverse module `m_n/cos β`.
#[test]
fn hand_and_face_are_read() {
    let file = study(HELICAL);
    assert_eq!(file.study.face, [-5.0, 15.0]);
    let run = &file.study.runs().unwrap()[0];
    assert_eq!(run.run.assembly.data().unwrap().face(), [-5.0, 15.0]);
    let wheel = built(&file, Member::Wheel);
    let data = wheel.basic_data();
    assert_eq!(data.hand(), Some(Hand::Left));
    let radius = 30.0 / f64::to_radians(15.0).cos();
    assert!((data.reference_radius() - radius).abs() < 1e-13);
    assert_eq!(file.spec.wheel.data().unwrap().face_mm, Some([-15.0, 15.0]));
    let off = HELICAL.replace("= 78\n", "= 78\nface_offset_mm = -20\n");
    assert_eq!(study(&off).study.face, [-15.0, 15.0]);
}

/// Hand, face and a helix angle of 0 change nothing for a spur pair.
#[test]
fn a_helix_angle_of_0_is_a_spur_gear() {
    let spur = HELICAL.replace("helix_angle_deg = 15", "helix_angle_deg = 0");
    let is_plain = |line: &&str| {
        !["hand", "face", "helix"]
            .iter()
            .any(|key| line.starts_with(key))
    };
    let plain = spur.lines().filter(is_plain).collect::<Vec<_>>().join("\n");
    let [one, other] = [spur, plain].map(|text| study(&text).study);
    assert_eq!(one, other);
}

/// A pinion whose measuring plane lies off stands there as its own plane has it: its runout turned against its teeth by `b tan β/r`.
#[test]
fn an_offset_turns_the_runout_against_the_teeth() {
    let text = HELICAL.replace(
        "face_mm = [-5, 40]",
        "face_mm = [-5, 40]\nrunout = { total_um = 20, high_tooth = 3 }",
    );
    let high = |text: &str| study(text).study.materials[0].2.high_tooth();
    assert_eq!(high(&text), 3.0);
    let moved = high(&text.replace("= 78\n", "= 78\nface_offset_mm = 10\n"));
    let radius = 45.0 / f64::to_radians(15.0).cos();
    let turned = 10.0 * f64::to_radians(15.0).tan() / radius / (std::f64::consts::TAU / 30.0);
    assert!(
        (moved - 3.0).abs() > 0.2 && ((moved - 3.0).abs() - turned).abs() < 1e-12,
        "{moved} {turned}"
    );
}

/// A pair with runouts at 60 °C; coefficients of the wheel, the pinion and the housing.
fn warm([wheel, pinion, housing]: [f64; 3]) -> String {
    let wheel = format!("_mm = 30\nexpansion_per_k = {wheel:e}");
    let pinion = format!(
        "[-5, 40]\nrunout = {{ total_um = 20, high_tooth = 3 }}\nexpansion_per_k = {pinion:e}"
    );
    let assembly = format!(
        "= 78\nface_offset_mm = 4\ntemperature_c = 60\nhousing_expansion_per_k = {housing:e}\n"
    );
    let text = HELICAL.replace("_mm = 30", &wheel);
    text.replace("[-5, 40]", &pinion)
        .replace("= 78\n", &assembly)
}

/// Where all parts expand equally, all lengths of the result do, including those along the axis.
#[test]
fn a_pair_that_expands_evenly_has_all_its_lengths_times_the_same() {
    let backlash = |text: &str| {
        let run = study(text).study.runs().unwrap().remove(0);
        let radius = run
            .run
            .assembly
            .operating_pitch_radius(run.run.assembly.free());
        let pair = run.run.assembly.data().unwrap();
        let kernel = ExactKernel::new(pair);
        let lost = |mating: &Mating| kernel.lost_motion(&Pose::new(pair, *mating)).unwrap();
        let found = run
            .matings
            .iter()
            .map(|mating| lost(mating).angle().unwrap() * radius);
        (pair.face(), found.collect::<Vec<f64>>())
    };
    let [(cold_face, cold), (warm_face, warm)] = [0.0, 25e-6].map(|k| backlash(&warm([k; 3])));
    assert_eq!(cold_face, [-1.0, 15.0]);
    for k in [0, 1] {
        assert!((warm_face[k] - 1.001 * cold_face[k]).abs() < 1e-12);
    }
    for (warm, cold) in warm.iter().zip(&cold) {
        assert!((warm - 1.001 * cold).abs() < 1e-10, "{warm} {cold}");
    }
}

/// Gears of steel and of a plastic at 60 °C: each with all its lengths times its own factor and its angles as they were, the face what both then have in common.
#[test]
fn gears_that_expand_unlike_keep_their_helix_angle() {
    let text = warm([11.5e-6, 110e-6, 23e-6]);
    let file = study(&text);
    let run = &file.study.runs().unwrap()[0];
    let factors = [1.0 + 40.0 * 11.5e-6, 1.0 + 40.0 * 110e-6];
    let gears = [Member::Wheel, Member::Pinion]
        .map(|member| run.run.assembly.data().unwrap().gear(member).gear());
    for ((gear, factor), z) in gears.into_iter().zip(factors).zip([20.0, 30.0]) {
        let data = gear.basic_data();
        assert_eq!(data.helix_angle(), f64::to_radians(15.0));
        let radius = 1.5 * z * factor / f64::to_radians(15.0).cos();
        assert!((data.reference_radius() - radius).abs() < 1e-12);
        // `r_b τ = tan β_b` of both.
        let lead = data.base_radius() * data.twist().abs();
        assert!(
            (lead - data.base_helix_angle().tan()).abs() < 1e-15,
            "{lead}"
        );
    }
    // From −5 mm of the pinion, 4 mm off, to 15 mm of the wheel.
    let face = run.run.assembly.data().unwrap().face();
    let expected = [4.0 * factors[0] - 5.0 * factors[1], 15.0 * factors[0]];
    for (end, expected) in face.iter().zip(expected) {
        assert!((end - expected).abs() < 1e-12, "{end} {expected}");
    }
}

/// A drawing's runout, of which no high tooth is stated, and uncertainties: read as those of a spur pair.
#[test]
fn runout_of_any_direction_and_uncertainties_are_read() {
    let wheel = "_mm = 30\nrunout.total_um = 20\nthickness.allowance_um = -50";
    let uncertain = "[uncertainty]\nallowance_um = 2\ncenter_distance_um = 3\n";
    let study = study(&(HELICAL.replace("_mm = 30", wheel) + uncertain)).study;
    assert!(study.materials[0].1.any_direction());
    // `A_st = A_sn/cos β`, `cos α_t` of which is left at the base circle.
    let transverse = (f64::to_radians(20.0).tan() / f64::to_radians(15.0).cos()).atan();
    let expected = 2e-3 * transverse.cos() / f64::to_radians(15.0).cos();
    let found = study.uncertainty.unwrap().base_thickness;
    assert!((found[0] - expected).abs() < 1e-15, "{found:?}");
}

/// `b ≥ W_k sin β_b + b_M cos β_b`, with the contact width `b_M = 1.2 + 0.018 W_k` that shops leave: here with `sin β_b = sin 15° cos 20°`.
#[test]
fn a_face_too_short_for_the_span_is_a_warning() {
    let with = |face: f64| {
        let keys = format!("_mm = {face}\nthickness.span = {{ teeth = 3, mm = 23.0 }}");
        study(&HELICAL.replace("_mm = 30", &keys)).warnings
    };
    let sin = f64::to_radians(15.0).sin() * f64::to_radians(20.0).cos();
    let needed = 23.0 * sin + (1.2 + 0.018 * 23.0) * (1.0 - sin * sin).sqrt();
    assert_eq!(with(needed + 1e-6), [""; 0]);
    let warned = with(needed - 1e-6);
    let words = "wheel.face_mm: a span over 3 teeth needs a face of 7.1";
    assert!(warned[0].contains(words), "{warned:?}");
}

/// FVA Workbench's 27 teeth, example 1-3: 147.077 mm over balls and 147.311 mm over pins are the nominal thickness. Both are equal for a spur
/// gear, and the echo has the stated one.
#[test]
fn a_dimension_is_over_balls_or_over_pins() {
    let gear = |teeth: u32, hand: &str, more: &str| {
        format!(
            "teeth = {teeth}\nmodule_mm = 4.5\npressure_angle_deg = 20\nhelix_angle_deg = 21\nhand = \"{hand}\"\nface_width_mm = 50\n{more}\n"
        )
    };
    let helical = |over: &str| {
        let more =
            format!("profile_shift = 0.3\nrack.root_radius = 0.25\nthickness.over_pins = {over}");
        let (wheel, pinion) = (gear(27, "right", &more), gear(51, "left", ""));
        study(&format!(
            "[wheel]\n{wheel}[pinion]\n{pinion}[assembly]\ncenter_distance_mm = 190\n"
        ))
    };
    let (ball, pin) = ("147.07716569057362", "147.3111662932581");
    let each = |mm: &str| format!("[{mm}, {mm}], space = [1, 9]");
    for (kind, mm) in [
        ("ball", ball),
        ("pin", pin),
        ("pin", &each(pin)),
        ("ball", &each(ball)),
    ] {
        let over = format!("{{ pin_mm = 9, kind = \"{kind}\", mm = {mm} }}");
        let file = helical(&over);
        let wheel = built(&file, Member::Wheel);
        let nominal = wheel.design().nominal_base_thickness();
        assert!((wheel.base_thickness() - nominal).abs() < 1e-9, "{over}");
        assert_eq!(echo(&file)["wheel"]["thickness"]["over_pins"]["kind"], kind);
    }
    let spur = |kind: &str| {
        let over = format!("thickness.over_pins = {{ pin_mm = 5.5, {kind} mm = 68.3 }}");
        let file = study(
            &HELICAL
                .replace("= 15", "= 0")
                .replace("face_width_mm = 30", &over),
        );
        let kind = echo(&file)["wheel"]["thickness"]["over_pins"]["kind"].clone();
        (built(&file, Member::Wheel).base_thickness(), kind)
    };
    let (none, echo) = spur("");
    assert!(echo.is_null());
    for kind in ["ball", "pin"] {
        let found = spur(&format!("kind = \"{kind}\","));
        assert_eq!(found, (none, kind.into()));
    }
}
