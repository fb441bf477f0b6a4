//! The difference of two drawings of one gear: in words, as a table, as JSON and as CSV.

use crate::column::{Row, Value, csv_text, json_text, row_type, shown};
use crate::layout::{Screen, Tone};
use gearlash::outline::{Deviation, OutlineGear};
use gearlash_input::outlines::ComparedOutlines;
use gearlash_text::characters::plain;
use gearlash_text::numbers::{ascii, bound_um, fixed, signed_um, um, um_ascii};
use serde_json::json;
use std::iter;

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

/// The deviation of B at a place along A.
struct PlaceRow {
    name: &'static str,
    at: Deviation,
    /// In A's drawing, mm.
    point: [f64; 2],
}

row_type!(row: PlaceRow {
    "" Plain [heading(shown("").left())] => row.name;
    "" Plain [heading(shown("µm"))] => signed_um(row.at.beyond, 2);
    "deviation_um" Plain [rank(2)] => 1e3 * row.at.beyond;
    "a_tooth" Plain [heading(shown("tooth of A"))] => row.at.tooth;
    "point_mm.0" Fixed(4) [csv("x_mm"), heading(shown("x mm"))] => row.point[0];
    "point_mm.1" Fixed(4) [csv("y_mm"), heading(shown("y mm"))] => row.point[1];
    "radius_mm" Fixed(4) [heading(shown("radius mm"))] => row.at.point.coords.norm();
    "" Plain [csv("normal_x")] => row.at.normal.x;
    "" Plain [csv("normal_y")] => row.at.normal.y;
});

impl PlaceRow {
    fn new(compared: &ComparedOutlines, name: &'static str, at: &Deviation) -> PlaceRow {
        PlaceRow {
            name,
            at: *at,
            point: compared.in_drawing(at).into(),
        }
    }

    /// The greatest and the least deviation.
    fn ends(compared: &ComparedOutlines) -> [PlaceRow; 2] {
        let found = &compared.difference;
        [("greatest", &found.greatest), ("least", &found.least)]
            .map(|(name, at)| PlaceRow::new(compared, name, at))
    }
}

/// One of the drawings.
struct DrawingRow {
    name: &'static str,
    file: String,
    gear: OutlineGear,
    center: [f64; 2],
}

row_type!(row: DrawingRow {
    "" Plain [heading(shown("").left())] => row.name;
    "file" Plain => row.file.clone();
    "teeth" Plain [heading(shown("teeth"))] => row.gear.teeth();
    "center_mm.0" Plain => row.center[0];
    "center_mm.1" Plain => row.center[1];
    "" Fixed(4) [heading(shown("root diameter mm"))] => 2.0 * row.gear.root_radius();
    "tip_diameter_mm" Fixed(4) [heading(shown("tip diameter mm"))] => 2.0 * row.gear.tip_radius();
    "root_diameter_mm" Plain => 2.0 * row.gear.root_radius();
    "" Plain [heading(shown("centre mm").left())] => row.center.map(|mm| ascii(mm, 4)).join(", ");
    "error_bound_um" Plain => 1e3 * row.gear.bound();
    "" Plain [heading(shown("within µm"))] => um_ascii(row.gear.bound(), 4);
});

fn drawings(compared: &ComparedOutlines) -> [DrawingRow; 2] {
    [0, 1].map(|k| DrawingRow {
        name: ["A", "B"][k],
        file: compared.files[k].clone(),
        gear: compared.gears[k].clone(),
        center: compared.centres[k].into(),
    })
}

/// The deviation of B at each place along A, in A's drawing, as CSV.
pub fn difference_csv(compared: &ComparedOutlines) -> String {
    let columns = PlaceRow::columns();
    let names = columns.csv_names(false).map(|name| name.into()).collect();
    let rows = compared.difference.along.iter().map(|at| {
        let row = PlaceRow::new(compared, "", at);
        columns.csv_values(&row, false)
    });
    csv_text::<Vec<Value>>(iter::once(names).chain(rows))
}

/// The outcome as JSON.
pub fn comparison_json(compared: &ComparedOutlines, tolerance_um: Option<f64>) -> String {
    let found = &compared.difference;
    let [a, b] = drawings(compared).map(|row| row.json());
    let [greatest, least] = PlaceRow::ends(compared).map(|row| row.json());
    json_text(&json!({
        "gearlash": env!("CARGO_PKG_VERSION"),
        "passed": compared.passes(tolerance_um),
        "tolerance_um": tolerance_um,
        "a": a,
        "b": b,
        "rotation_deg": found.rotation.to_degrees(),
        "b_tooth_on_a_tooth_1": found.tooth,
        "turns_alike": found.alike,
        "mean_um": 1e3 * found.mean,
        "root_mean_square_um": 1e3 * found.root_mean_square,
        "greatest": greatest,
        "least": least,
        "error_bound_um": 1e3 * found.bound,
    }))
}

/// The difference as text on `screen`, judged by `tolerance_um` if there is one.
pub fn difference_text(
    compared: &ComparedOutlines,
    tolerance_um: Option<f64>,
    screen: &Screen,
) -> String {
    let [a, b] = &compared.files;
    let verdict = tolerance_um.map_or(String::new(), |tolerance| {
        let (tone, words) = if compared.passes(tolerance_um) {
            (Tone::Good, "Agree within")
        } else {
            (Tone::Bad, "DIFFER by more than")
        };
        let words = format!("{words} {tolerance} µm + error bound");
        format!("{}: ", screen.toned(tone, &words))
    });
    screen.fold(&format!(
        "{}\n\n{verdict}{}\n\n{}\n{}\n{}\nPlus: B has more material. Places are in A's drawing; each deviation is within {} µm.\n",
        plain(&format!("A {a} and B {b}")),
        difference_sentence(compared),
        PlaceRow::columns().text(&PlaceRow::ends(compared), screen),
        DrawingRow::columns().text(&drawings(compared), screen),
        turn_words(compared),
        bound_um(compared.difference.bound)
    ))
}
