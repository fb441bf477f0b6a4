//! Where the involute begins, beside the formulas of the basic rack.

use super::*;

/// The measured length from the base circle's tangent point to the form point is, without undercut, the one the rack
/// generates: `r sin α − (h_f − ρ (1 − sin α) − x) m/sin α` (with undercut the margin is negative and the trochoid cuts higher).
/// Source: the rack's round leaves its flank at `h_f − ρ (1 − sin α)` below the pitch line (ISO 53).
#[test]
fn the_margin_to_undercut_is_the_racks() {
    let alpha = 20f64.to_radians();
    let sin = alpha.sin();
    for (teeth, x) in [(10, 0.0), (12, -0.2), (21, 0.0), (24, 0.3), (60, 0.5)] {
        let text = format!(
            "[wheel]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nprofile_shift = {x}\n\
             [pinion]\nteeth = 40\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
             [assembly]\ncenter_distance_mm = {}\n[sweep]\nmating = [[1, 1]]\n",
            1.5 * f64::from(teeth + 40) + 3.0 * x + 0.5
        );
        let (_folder, file) = written(&text);
        let found = diagnosed(&input::read(&file).unwrap().study);
        let undercut = check(&found, "undercut", Some(Member::Wheel));
        let round = 1.25 - 0.38 * (1.0 - sin);
        let expected = 1.5 * f64::from(teeth) * sin - (round - x) * 3.0 / sin;
        let margin = undercut.margin.unwrap();
        assert!(
            (margin - expected).abs() <= 1e-9,
            "z {teeth}: {margin} {expected}"
        );
        if expected > 0.0 {
            let measured = undercut.measured.unwrap();
            assert!(
                (measured - expected).abs() <= 1e-9,
                "z {teeth}: {measured} {expected}"
            );
            assert_eq!(undercut.verdict, Verdict::Pass);
        } else {
            assert_eq!(undercut.verdict, Verdict::Warn);
        }
    }
}
