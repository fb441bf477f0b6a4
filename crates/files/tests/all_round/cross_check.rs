//! Two statements about one gear.

use super::*;

/// Table 4 of the study, z 44, m 3, 20°. `M_dK` is not at hand in print; 139.502 and 139.524 mm are the lengths of three
/// decimals whose base thickness (pin 5.25 mm) is the 6.272242 and 6.280663 mm that the issue names.
#[test]
fn table_4_tells_one_story() {
    for (span, base, over, cross) in [
        ([50.548, 50.561], [6.266028, 6.279028], 139.502, 6.272242),
        ([50.559, 50.567], [6.277028, 6.285028], 139.524, 6.280663),
    ] {
        let study = pair(&format!(
            "teeth = 44\nmodule_mm = 3\nthickness.span = {{ teeth = 6, min_mm = {}, max_mm = {} }}\n\
             thickness.cross_check.over_pins = {{ pin_mm = 5.25, mm = {over} }}",
            span[0], span[1]
        ));
        let found = study.study.notes[0].thickness.unwrap();
        for (found, expected) in [
            (found.counts[0], base[0]),
            (found.counts[1], base[1]),
            (found.cross[0], cross),
            (found.cross[1], cross),
        ] {
            assert!((found - expected).abs() < 6e-7, "{found} {expected}");
        }
        let difference = 1000.0 * (cross - (base[0] + base[1]) / 2.0);
        assert!((found.difference_um - difference).abs() < 2e-3);
        assert!(found.gap_um == 0.0 && found.agree());
        let remark = &study.remarks[0];
        assert!(remark.ends_with("they agree"), "{remark}");
        assert_eq!(study.warnings, [""; 0]);
        // It is never built.
        assert_eq!(wheel(&study).gear().base_thickness(), found.counts[1]);
    }
}

/// Its echo said `per_tooth`, which no cross-check may: the pair in a result could not be read again ([`pair`] does).
#[test]
fn a_cross_check_by_spans_all_round_is_echoed_as_one() {
    // W_6 = 3 cos 20° (5.5 π + 44 inv 20°).
    let alpha = 20f64.to_radians();
    let inv = alpha.tan() - alpha;
    let nominal = 3.0 * alpha.cos() * (5.5 * std::f64::consts::PI + 44.0 * inv);
    let study = pair(&format!(
        "teeth = 44\nmodule_mm = 3\nthickness = {{ allowance_um = 0, cross_check = {{ span = {{ teeth = 6, mm = {:?} }} }} }}",
        vec![nominal; 44]
    ));
    let agree =
        |warning: &String| warning.contains("cross_check: ") && warning.contains("they agree");
    assert!(study.remarks.iter().any(agree), "{:?}", study.remarks);
}
