//! The thickness as the settings of manufacturing state it.

use super::*;

const SERIES: &str = "<attribute id=\"tooth_thickness_deviation_tolerance_series_din_3967_1978\" unit=\"none\">c25</attribute>";
const SHIFT: &str =
    "<attribute id=\"generated_addendum_modification_coefficient\" unit=\"none\">-0.03</attribute>";

/// The fixture without series in stage 10, its generated shift replaced.
fn without_series(shift: &str) -> RexsFile {
    let text = fixture("gearbox.rexs").replace(SERIES, "");
    assert!(text.contains(SHIFT));
    read(&text.replace(SHIFT, shift)).unwrap()
}

fn allowance(file: &RexsFile, gear: &str) -> [f64; 2] {
    let thickness = pair(file, 10)[gear]["thickness"].clone();
    ["upper", "lower"].map(|end| thickness["allowance_um"][end].as_float().unwrap())
}

#[test]
fn the_generated_shift_alone_states_the_thickness() {
    // s = m (π/2 + 2 x tan α) of ISO 21771, m 4, 20°: 0.03 modules less make it 8 mm · 0.03 tan 20° = 87.353 µm thinner.
    let by_hand = |x: f64| 8e3 * x * 0.363_970_234_266_202_4;
    let file = without_series(SHIFT);
    for gear in ["wheel", "pinion"] {
        for found in allowance(&file, gear) {
            assert!((found - by_hand(-0.03)).abs() < 1e-5, "{found}");
        }
    }
    let stage = file.stage(10).unwrap().pair.as_ref().unwrap();
    assert!(
        stage.summary.contains("−87.4…−87.4 µm"),
        "{}",
        stage.summary
    );
    let message = "cylindrical_gear 11 has no other thickness: generated_addendum_modification_coefficient −0.03 of \
                cylindrical_gear_manufacturing_settings 18 makes −87.4 / −87.4 µm";
    assert!(
        stage.remarks.iter().any(|one| one == message),
        "{:?}",
        stage.remarks
    );
    assert!(
        !stage
            .remarks
            .iter()
            .any(|message| message.contains("nominal"))
    );

    let end = |end: &str, value: &str| {
        let name = format!("generated_addendum_modification_coefficient_{end}_deviation");
        format!("<attribute id=\"{name}\" unit=\"none\">{value}</attribute>")
    };
    let both = format!("{SHIFT}{}{}", end("upper", "0.005"), end("lower", "-0.01"));
    let [upper, lower] = allowance(&without_series(&both), "wheel");
    assert!((upper - by_hand(-0.025)).abs() < 1e-5, "{upper}");
    assert!((lower - by_hand(-0.04)).abs() < 1e-5, "{lower}");
    let one = format!("{SHIFT}{}", end("upper", "0.005"));
    assert!(why(&without_series(&one), 10).contains("one deviation of generated_"));
    // The profile shift itself: no allowance.
    let none = without_series(&SHIFT.replace("-0.03", "0.0"));
    assert!(pair(&none, 10)["wheel"].get("thickness").is_none());
}

#[test]
fn the_generated_shift_lies_within_the_series() {
    // DIN 3967, m 4 and d = 68 mm: 25c is −85/−125 µm; −0.03 makes −87 µm, −0.04 −116 µm, −0.05 −146 µm.
    let good = fixture("gearbox.rexs");
    for shift in ["-0.03", "-0.04", "0.0"] {
        let file = read(&good.replace(SHIFT, &SHIFT.replace("-0.03", shift))).unwrap();
        let found = pair(&file, 10)["wheel"]["thickness"].clone();
        assert_eq!(found.to_string(), "{ designation = \"25c\" }");
        let remarks = &file.stage(10).unwrap().pair.as_ref().unwrap().remarks;
        let message = remarks
            .iter()
            .any(|message| message.contains("makes 0.0 / 0.0 µm, 25c counts"));
        assert_eq!(message, shift == "0.0", "{remarks:?}");
    }
    for (shift, message) in [("-0.05", "−145.6 / −145.6"), ("-0.02", "−58.2 / −58.2")] {
        let file = read(&good.replace(SHIFT, &SHIFT.replace("-0.03", shift))).unwrap();
        let found = why(&file, 10);
        assert!(
            found.contains("contradicts itself: 25c is −85.0 / −125.0 µm, generated_")
                && found.contains(message),
            "{found}"
        );
    }
}

#[test]
fn settings_that_differ_state_no_thickness() {
    let other = "<component id=\"51\" type=\"cylindrical_gear_manufacturing_settings\">";
    let text = fixture("gearbox.rexs").replacen(
        "</components>",
        &format!(
            "{other}{}</component></components>",
            SHIFT.replace("-0.03", "-0.1")
        ),
        1,
    );
    let text = text.replacen(
        "<ref id=\"18\" role=\"manufacturing_settings\"/>",
        "<ref id=\"51\" role=\"manufacturing_settings\"/>",
        1,
    );
    let file = read(&text).unwrap();
    let remarks = &file.stage(10).unwrap().pair.as_ref().unwrap().remarks;
    assert!(
        remarks
            .iter()
            .any(|message| message.ends_with("differ and are not used")),
        "{remarks:?}"
    );
    let file = read(&text.replace(SERIES, "")).unwrap();
    assert!(
        why(&file, 10).contains("alone, which differ"),
        "{}",
        why(&file, 10)
    );
}
