//! Thickness by span, over pins, by allowance, by base thickness: one tooth, four statements.

use super::*;

/// `s_b` of the wheel's materials, mm.
fn wheel_base(study: &PairFile) -> Vec<f64> {
    let gears = study.study.materials.iter();
    gears
        .map(|(_, wheel, _)| wheel.gear().base_thickness())
        .collect()
}

/// The same tooth, 20 µm thinner than nominal, computed apart from the program (inv by bisection):
/// z 20, x 0 (even) and z 21, x 0.1 (odd), m 3, 20°.
#[test]
fn every_statement_of_the_same_tooth_gives_the_same_base_thickness() {
    // Teeth, profile shift, base thickness, span and dimension over pins.
    for stated in [
        "20 0.0 5.249735670974402 22.9625242755357 67.34917010670293",
        "21 0.1 5.496964375582293 23.20975298014359 70.65919178333365",
    ] {
        let stated: Vec<&str> = stated.split(' ').collect();
        let [teeth, shift, base, span, over_pins] = stated[..] else {
            panic!("{stated:?}");
        };
        let expected: f64 = base.parse().unwrap();
        for statement in [
            format!("base_thickness_mm = {base}"),
            "allowance_um = -20".to_owned(),
            format!("span = {{ teeth = 3, mm = {span} }}"),
            format!("over_pins = {{ pin_mm = 5.25, mm = {over_pins} }}"),
        ] {
            let study = study(&PAIR.replace(
                "teeth = 20",
                &format!("teeth = {teeth}\nprofile_shift = {shift}\nthickness.{statement}"),
            ));
            let [found] = wheel_base(&study)[..] else {
                panic!("{statement}: one material");
            };
            assert!((found - expected).abs() < 1e-12, "{statement}: {found}");
        }
    }
}

/// The larger value is the thicker tooth in every statement; a single value serves both materials.
#[test]
fn min_and_max_make_least_and_most_material() {
    for statement in [
        "span = { teeth = 3, min_mm = 22.95, max_mm = 22.97 }",
        "over_pins = { pin_mm = 5.25, min_mm = 67.33, max_mm = 67.36 }",
        "allowance_um = { min = -30, max = -22 }",
        "base_thickness_mm = { min = 5.24, max = 5.26 }",
    ] {
        let study = wheel(&format!("thickness.{statement}"));
        let [most, least] = &study.study.materials[..] else {
            panic!("{statement}");
        };
        assert_eq!((most.0, least.0), (Material::Most, Material::Least));
        let base = wheel_base(&study);
        assert!(base[0] > base[1], "{statement}: {base:?}");
        assert_eq!(most.2, least.2, "the pinion has one thickness");
        let runs = study.study.runs().unwrap();
        let names: Vec<&str> = runs.iter().map(|run| run.run.material.name()).collect();
        assert_eq!(names, ["most", "least"]);
    }
}

#[test]
fn nothing_stated_is_nominal() {
    for keys in [
        "",
        "thickness = {}",
        "thickness.per_tooth_um = []",
        "thickness.allowance_um = 0",
    ] {
        let study = wheel(keys);
        let gear = study.study.materials[0].1.gear();
        assert_eq!(
            gear.base_thickness(),
            gear.design().nominal_base_thickness()
        );
    }
}
