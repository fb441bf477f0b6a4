//! Thickness by tooth whose mean repeats the stated thickness.

use super::*;

/// The reviewers' list from the nominal thickness, −52 … −47 µm, beside the stated −50 µm repeats it. No warning comes for a list
/// about the mean, or for one value for all teeth. Nor does one come for a list without a statement, or beside spans all round,
/// whose mean it does not move.
#[test]
fn a_mean_of_the_list_that_adds_to_the_stated_one_is_reported() {
    let list = [-52, -48, -49, -53, -50, -47, -51, -50, -49, -51];
    let about = list.map(|um| um + 50);
    let spans: Vec<f64> = list
        .iter()
        .map(|um| 14.69 + 1e-3 * f64::from(*um))
        .collect();
    let warning = |stated: &str, list: &[i32]| {
        let keys = format!(
            "teeth = 10\nmodule_mm = 3\nprofile_shift = 0.5\nthickness = {{ per_tooth_um = {list:?}{stated} }}"
        );
        let warning = pair(&keys).warnings;
        let about = |warning: &&String| warning.contains("its mean, ");
        warning.iter().find(about).cloned()
    };
    for (stated, key) in [
        (", allowance_um = -50", "allowance_um"),
        (", allowance_um = { min = -60, max = -50 }", "allowance_um"),
        (", span = { teeth = 2, mm = 14.4 }", "span"),
    ] {
        let warning = warning(stated, &list).unwrap();
        let words =
            format!("wheel.thickness.per_tooth_um: its mean, -50.0 µm, adds to the stated {key} ");
        assert!(warning.starts_with(&words), "{warning}");
        // Σ (um + 50)² = 30, over 9.
        assert!(warning.contains("by 1.8 µm"), "{warning}");
    }
    assert_eq!(warning(", allowance_um = -50", &about), None);
    assert_eq!(warning(", allowance_um = -50", &[-50; 10]), None);
    assert_eq!(warning("", &list), None);
    let readings = format!(", span = {{ teeth = 2, mm = {spans:?}, per_tooth = false }}");
    assert_eq!(warning(&readings, &list), None);
}
