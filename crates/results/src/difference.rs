//! The difference of two drawings of one gear: in words, as JSON and as CSV.

use gearlash::outline::Deviation;
use gearlash_files::characters::{csv_text, json_of};
use gearlash_files::numbers::{fixed, signed_um, um};
use gearlash_files::outlines::ComparedOutlines;
use serde::Serialize;
use serde_json::json;

/// The deviations of B from A.
pub fn difference_sentence(compared: &ComparedOutlines) -> String {
    let found = &compared.difference;
    let signed = |mm: f64| signed_um(mm, 2).replace('-', "−");
    format!(
        "B lies {} … {} µm beyond A, mean {} µm, root mean square {} µm.",
        signed(found.least.beyond),
        signed(found.greatest.beyond),
        signed(found.mean),
        um(found.root_mean_square, 2)
    )
}

/// The rotation of B that fits A best.
pub fn turn_words(compared: &ComparedOutlines) -> String {
    let found = &compared.difference;
    let other_teeth = match found.alike {
        1 => "every other whole tooth fits worse".to_owned(),
        turns => format!(
            "the fit is the same for {turns} tooth positions, and the smallest rotation is used"
        ),
    };
    format!(
        "Both have {} teeth. B is turned by {}° about its centre, its tooth {} on A's tooth 1: {other_teeth}.",
        compared.gears[0].teeth(),
        fixed(found.rotation.to_degrees(), 5),
        found.tooth
    )
}

#[derive(Serialize)]
struct Row {
    a_tooth: u32,
    x_mm: f64,
    y_mm: f64,
    radius_mm: f64,
    normal_x: f64,
    normal_y: f64,
    deviation_um: f64,
}

/// The deviation of B at each place along A, in A's drawing, as CSV.
///
/// # Errors
/// An error of the csv crate.
pub fn difference_csv(compared: &ComparedOutlines) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for at in &compared.difference.along {
        let point = compared.in_drawing(at);
        writer.serialize(Row {
            a_tooth: at.tooth,
            x_mm: point.x,
            y_mm: point.y,
            radius_mm: at.point.coords.norm(),
            normal_x: at.normal.x,
            normal_y: at.normal.y,
            deviation_um: 1e3 * at.beyond,
        })?;
    }
    csv_text(writer)
}

/// The outcome as JSON.
///
/// # Errors
/// An error of serde_json.
pub fn comparison_json(
    compared: &ComparedOutlines,
    tolerance_um: Option<f64>,
) -> serde_json::Result<String> {
    let drawing = |k: usize| {
        let gear = &compared.gears[k];
        json!({
            "file": compared.files[k],
            "teeth": gear.teeth(),
            "center_mm": <[f64; 2]>::from(compared.centres[k]),
            "tip_diameter_mm": 2.0 * gear.tip_radius(),
            "root_diameter_mm": 2.0 * gear.root_radius(),
            "error_bound_um": 1e3 * gear.bound(),
        })
    };
    let place = |at: &Deviation| {
        json!({
            "deviation_um": 1e3 * at.beyond,
            "a_tooth": at.tooth,
            "point_mm": <[f64; 2]>::from(compared.in_drawing(at)),
            "radius_mm": at.point.coords.norm(),
        })
    };
    let found = &compared.difference;
    json_of(&json!({
        "gearlash": env!("CARGO_PKG_VERSION"),
        "passed": compared.passes(tolerance_um),
        "tolerance_um": tolerance_um,
        "a": drawing(0),
        "b": drawing(1),
        "rotation_deg": found.rotation.to_degrees(),
        "b_tooth_on_a_tooth_1": found.tooth,
        "turns_alike": found.alike,
        "mean_um": 1e3 * found.mean,
        "root_mean_square_um": 1e3 * found.root_mean_square,
        "greatest": place(&found.greatest),
        "least": place(&found.least),
        "error_bound_um": 1e3 * found.bound,
    }))
}
