//! One value that lies far from all the others.

use super::*;

const GEAR: &str = "teeth = 44\nmodule_mm = 3\n";

/// Warnings and the only problem, if any.
fn told(keys: &str) -> Vec<String> {
    match pair_beside(keys, "") {
        Ok(study) => study.warnings,
        Err(InputError { problems, .. }) => problems.iter().map(ToString::to_string).collect(),
    }
}

fn spans(mm: &[f64]) -> Vec<String> {
    let first: Vec<usize> = (0..mm.len()).map(|i| 1 + 4 * i).collect();
    told(&format!(
        "{GEAR}thickness.span = {{ teeth = 6, mm = {mm:?}, first_tooth = {first:?}, per_tooth = false }}"
    ))
}

/// The reviewers' readings: half a millimetre is in no gear. The median of 50.55, 50.56, 51.05 is 50.56.
#[test]
fn a_span_half_a_millimetre_off_is_named() {
    let told = spans(&[50.55, 50.56, 51.05]);
    let told: Vec<_> = told
        .iter()
        .filter(|told| told.contains("check it"))
        .collect();
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].starts_with("wheel.thickness.span: the reading at tooth 9, 51.05 mm, is 490.0 µm from the median of all 3, 50.56 mm"),
        "{}",
        told[0]
    );
}

/// A slip of one thimble line, 10 µm, among readings of 1 µm; an even spread of 60 µm is none.
#[test]
fn a_span_is_judged_by_the_others() {
    let one = [
        50.550, 50.551, 50.550, 50.549, 50.550, 50.551, 50.560, 50.550,
    ];
    assert!(
        spans(&one)
            .iter()
            .any(|told| told.contains("the reading at tooth 25, 50.56 mm,"))
    );
    let even: Vec<f64> = (0..8).map(|i| 50.5 + 0.008 * f64::from(i)).collect();
    assert!(!spans(&even).iter().any(|told| told.contains("check it")));
}

fn pitch(kind: &str, tooth: usize, um: f64) -> Vec<String> {
    let mut right = vec![0.0; 44];
    right[tooth - 1] = um;
    told(&format!(
        "{GEAR}pitch = {{ kind = {kind:?}, right_um = {right:?}, left_um = {:?} }}",
        vec![0.0; 44]
    ))
}

/// A spike in one value names its tooth, in cumulative and single values; a tooth that was cut 40 µm off is a gear's.
#[test]
fn a_pitch_value_that_stands_out_is_named() {
    for kind in ["cumulative", "single"] {
        let told = pitch(kind, 6, 1000.0);
        assert!(
            told.iter().any(|told| told
                .contains("right_um: tooth 6 of the right flanks, 1000 µm, is 1000.0 µm from")),
            "{told:?}"
        );
        assert!(
            !pitch(kind, 6, 40.0)
                .iter()
                .any(|told| told.contains("check it"))
        );
    }
}

/// 3 mm off a flank leave nothing of a tip land of some 2.3 mm (3/4 of the module): the error names the value.
#[test]
fn a_value_that_makes_the_gear_impossible_is_named() {
    let told = pitch("cumulative", 6, -3000.0);
    assert_eq!(told.len(), 1, "{told:?}");
    for words in [
        "leave this tooth without a tip",
        "above all tooth 6 of the right flanks, -3000 µm,",
    ] {
        assert!(told[0].contains(words), "{}", told[0]);
    }
    let mut mm = vec![50.55; 11];
    mm[2] = 90.0;
    let told = spans(&mm);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].contains("above all the reading at tooth 9, 90 mm,"),
        "{}",
        told[0]
    );
}

/// Right flank 17 stands 12 µm off, by the pitch: the span from tooth 12 over six is 12 cos 20° = 11.3 µm longer. It was called a slip
/// of the reading; without the pitch it looks like one, and another reading that is off is one.
#[test]
fn a_reading_that_the_stated_flanks_explain_is_no_slip() {
    let mut right = vec![0.0; 44];
    right[16] = 12.0;
    let pitch = format!(
        "pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {:?} }}\n",
        vec![0.0; 44]
    );
    let mut mm: Vec<f64> = (0..44).map(|i| 50.55 + 0.001 * f64::from(i % 3)).collect();
    mm[11] += 0.012 * 20f64.to_radians().cos();
    let told = |mm: &[f64], pitch: &str| {
        let mm: Vec<String> = mm.iter().map(|mm| format!("{mm:.3}")).collect();
        let told = told(&format!(
            "{GEAR}{pitch}thickness.span = {{ teeth = 6, mm = [{}], per_tooth = false }}",
            mm.join(", ")
        ));
        let slip = |told: &&String| told.contains("thickness.span") && told.contains("check it");
        told.iter().find(slip).cloned()
    };
    assert_eq!(told(&mm, &pitch), None);
    assert!(told(&mm, "").unwrap().contains("the reading at tooth 12, "));
    mm[29] += 0.0113;
    let slip = told(&mm, &pitch).unwrap();
    assert!(
        slip.contains("the reading at tooth 30, ")
            && slip.contains("after removing the effect of the stated flanks"),
        "{slip}"
    );
}

/// The same of pins: right flank 17 is one of space 17, and of the pair of pins read at space 39. A pin's centre moves by
/// Δ/(2 sin α_K), Δ = 12 cos 20° µm: sin α_K = 0.36 makes it 15.6 µm. By thickness, too: tooth 17 thicker by 12 µm.
#[test]
fn pins_beside_a_stated_flank_are_no_slip() {
    use gearlash::gear::{BasicGearData, thickness};
    let basic_data = BasicGearData::new(44, 3.0, 20f64.to_radians()).unwrap();
    let (pin, base) = (5.25, 6.2);
    let even = thickness::pins_from_base(&basic_data, pin, base);
    let delta = 0.012 * 20f64.to_radians().cos();
    let one = thickness::pin_centre_radius(&basic_data, pin, base + delta)
        - thickness::pin_centre_radius(&basic_data, pin, base);
    let mut mm = vec![even; 44];
    for space in [17, 39] {
        mm[space - 1] += one;
    }
    assert!(one > 0.014, "{one}");
    let mut right = vec![0.0; 44];
    right[16] = 12.0;
    let pitch = format!(
        "pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {:?} }}\n",
        vec![0.0; 44]
    );
    let told = |mm: &[f64], pitch: &str| {
        let keys = format!("{GEAR}{pitch}thickness.over_pins = {{ pin_mm = {pin}, mm = {mm:?} }}");
        let told = told(&keys);
        told.iter().any(|told| told.contains("check it"))
    };
    assert!(told(&mm, ""));
    assert!(!told(&mm, &pitch));
    mm[4] += 0.012;
    assert!(told(&mm, &pitch));
}
