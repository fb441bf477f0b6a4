//! How far two drawings of one gear differ: in words, as JSON and as CSV.

use gearlash::outline::Deviation;
use gearlash_files::characters::{csv_text, json_of};
use gearlash_files::numbers::{fixed, signed_um, um};
use gearlash_files::outlines::ComparedOutlines;
use serde::Serialize;

/// How far B lies from A.
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

/// How B was turned to lie on A.
pub fn turn_words(compared: &ComparedOutlines) -> String {
    let found = &compared.difference;
    let alike = match found.alike {
        1 => "every other whole tooth fits worse".to_owned(),
        turns => format!("{turns} turns by whole teeth fit alike, this is the least"),
    };
    format!(
        "Both have {} teeth. B is turned by {}° about its centre, its tooth {} on A's tooth 1: {alike}.",
        compared.gears[0].teeth(),
        fixed(found.rotation.to_degrees(), 5),
        found.tooth
    )
}

#[derive(Serialize)]
struct Result<'a> {
    gearlash: &'static str,
    passed: bool,
    tolerance_um: Option<f64>,
    a: DrawingRecord<'a>,
    b: DrawingRecord<'a>,
    rotation_deg: f64,
    b_tooth_on_a_tooth_1: u32,
    turns_alike: u32,
    mean_um: f64,
    root_mean_square_um: f64,
    greatest: PlaceRecord,
    least: PlaceRecord,
    error_bound_um: f64,
}

#[derive(Serialize)]
struct DrawingRecord<'a> {
    file: &'a str,
    teeth: u32,
    center_mm: [f64; 2],
    tip_diameter_mm: f64,
    root_diameter_mm: f64,
    error_bound_um: f64,
}

#[derive(Serialize)]
struct PlaceRecord {
    deviation_um: f64,
    a_tooth: u32,
    point_mm: [f64; 2],
    radius_mm: f64,
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

/// How far B lies from A at each place along A, in A's drawing, as CSV.
///
/// # Errors
/// Of the csv crate.
pub fn difference_csv(compared: &ComparedOutlines) -> std::result::Result<String, csv::Error> {
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
/// Of serde_json.
pub fn comparison_json(
    compared: &ComparedOutlines,
    tolerance_um: Option<f64>,
) -> serde_json::Result<String> {
    let drawing = |k: usize| DrawingRecord {
        file: &compared.files[k],
        teeth: compared.gears[k].teeth(),
        center_mm: compared.centres[k].into(),
        tip_diameter_mm: 2.0 * compared.gears[k].tip_radius(),
        root_diameter_mm: 2.0 * compared.gears[k].root_radius(),
        error_bound_um: 1e3 * compared.gears[k].bound(),
    };
    let place = |at: &Deviation| PlaceRecord {
        deviation_um: 1e3 * at.beyond,
        a_tooth: at.tooth,
        point_mm: compared.in_drawing(at).into(),
        radius_mm: at.point.coords.norm(),
    };
    let found = &compared.difference;
    let result = Result {
        gearlash: env!("CARGO_PKG_VERSION"),
        passed: compared.passes(tolerance_um),
        tolerance_um,
        a: drawing(0),
        b: drawing(1),
        rotation_deg: found.rotation.to_degrees(),
        b_tooth_on_a_tooth_1: found.tooth,
        turns_alike: found.alike,
        mean_um: 1e3 * found.mean,
        root_mean_square_um: 1e3 * found.root_mean_square,
        greatest: place(&found.greatest),
        least: place(&found.least),
        error_bound_um: 1e3 * found.bound,
    };
    json_of(&result)
}
