//! The readings as JSON.

use super::GaugedGear;
use super::readings::{Reading, roll};
use crate::table::{Column, Table};
use gearlash::gauge::{
    FlankProfiles, Gauged, GradedReading, PitchReadings, ProfileReading, Unmeasured,
};
use gearlash::gear::{Flank, GRADE_SOURCE, Grade, Hand};
use gearlash_files::characters;
use serde_json::{Value, json};

/// All gears: lengths in mm where the name says so, deviations in µm. What was not measured is
/// `{ "not_measured": reason }`.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
pub fn json(title: &str, gears: &[GaugedGear]) -> Result<String, serde_json::Error> {
    json_of(title, gears.iter().map(gear).collect())
}

/// All `gears`, each as it is.
pub(crate) fn json_of(title: &str, gears: Vec<Value>) -> Result<String, serde_json::Error> {
    let all = json!({ "gearlash": env!("CARGO_PKG_VERSION"), "title": title, "gears": gears });
    characters::json_of(&all)
}

fn gear(gauged: &GaugedGear) -> Value {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let mut shown = json!({
        "gear": gauged.name,
        "material": gauged.material.name(),
        "teeth": gauged.gear.gear().basic_data().teeth(),
        "spans": of(&read.spans, |spans| json!({
            "teeth": spans.teeth,
            "formula_mm": formula.span,
            "readings": rows(read, Reading::Spans, &["tooth", "span", "error_bound", "touched"], &LENGTH),
        })),
        "pins": of(&read.pins, |pins| json!({
            "pin_mm": pins.diameter,
            "formula_two_mm": formula.over_two,
            "two": over(read, Reading::Pins, "pins"),
            "formula_three_mm": formula.over_three,
            "three": over(read, Reading::ThreePins, "three_pins"),
        })),
        "runout": of(&read.runout, |runout| json!({
            "ball_mm": runout.diameter,
            "total_um": runout.total() * 1e3,
            "error_bound_um": runout.error() * 1e3,
            "readings": rows(read, Reading::Runout, &["tooth", "radius", "error_bound", "touched"], &RADIUS),
        })),
        "eccentricity": {
            "um": read.eccentricity.amount * 1e3,
            "high_tooth": read.eccentricity.high_tooth,
            "error_bound_um": read.eccentricity.error * 1e3,
        },
        "pitch_own": of(&read.pitch_own, |found| pitch(found, read, [Reading::SinglePitchOwn, Reading::PitchOwn])),
        "pitch_datum": of(&read.pitch_datum, |found| pitch(found, read, [Reading::SinglePitchDatum, Reading::PitchDatum])),
        "thickness": of(&read.thickness, |thickness| json!({
            "circle_mm": 2.0 * thickness.radius,
            "formula_mm": formula.thickness,
            "error_bound_um": thickness.error * 1e3,
            "arc_mm": thickness.arcs,
        })),
        "root": of(&read.root, |root| json!({
            "diameter_mm": 2.0 * root.radius,
            "formula_mm": 2.0 * formula.root,
            "error_bound_um": 2.0 * root.error * 1e3,
        })),
        "profile": of(&read.profile, |found| json!({
            "error_bound_um": found.error * 1e3,
            "right": profiles(found.flank(Flank::Right)),
            "left": profiles(found.flank(Flank::Left)),
        })),
        "grades": of(&read.grades, |graded| json!({
            "source": GRADE_SOURCE,
            "values": graded.iter().map(grade).collect::<Vec<_>>(),
        })),
        "roll": of(&read.roll, |found| json!({
            "master_teeth": found.master.basic_data().teeth(),
            "master_tip_diameter_mm": 2.0 * found.master.tip_radius(),
            "formula_mm": formula.distance,
            "total_um": found.total().found * 1e3,
            "total_missed_um": found.total().missed * 1e3,
            "tooth_to_tooth_um": found.tooth_to_tooth().found * 1e3,
            "tooth_to_tooth_missed_um": found.tooth_to_tooth().missed * 1e3,
            "error_bound_um": 2.0 * found.reading_error() * 1e3,
            "poses": poses(roll(&found.poses)),
            "between": poses(roll(&found.between)),
        })),
    });
    if let Some(hand) = gauged.gear.gear().basic_data().hand() {
        of_helix(gauged, hand, &mut shown);
    }
    shown
}

/// What is said of helical gears beside: in which section or direction lengths are, dimensions over pins that lie along the spaces, thickness in the
/// normal section.
fn of_helix(gauged: &GaugedGear, hand: Hand, shown: &mut Value) {
    let (read, spec) = (&gauged.gauged, gauged.spec);
    shown["helix_angle_deg"] = json!(spec.helix_angle_deg);
    shown["hand"] = json!(hand.name());
    shown["face_mm"] = json!(spec.face_mm);
    if read.spans.is_ok() {
        shown["spans"]["direction"] = json!("normal");
    }
    if read.pins.is_ok() {
        shown["pins"]["two_and_three_are"] = json!("balls");
        shown["pins"]["formula_lying_mm"] = json!(read.formula.over_lying);
        shown["pins"]["lying"] = over(read, Reading::LyingPins, "lying_pins");
    }
    if let Ok(thickness) = &read.thickness {
        let normal = |arc: &f64| arc * thickness.normal;
        shown["thickness"]["section"] = json!("transverse");
        shown["thickness"]["normal_formula_mm"] = json!(normal(&read.formula.thickness));
        shown["thickness"]["normal_mm"] =
            json!(thickness.arcs.iter().map(normal).collect::<Vec<f64>>());
    }
}

/// What is shown of a reading, or why there is none.
pub(crate) fn of<T>(read: &Result<T, Unmeasured>, shown: impl Fn(&T) -> Value) -> Value {
    match read {
        Ok(read) => shown(read),
        Err(reason) => json!({ "not_measured": reason.to_string() }),
    }
}

/// Keys of a row of lengths, and of radii.
const LENGTH: [&str; 4] = ["tooth", "mm", "error_bound_um", "touched"];
const RADIUS: [&str; 4] = ["tooth", "radius_mm", "error_bound_um", "touched"];
/// Keys of a dimension over pins.
const OVER: [&str; 4] = ["tooth", "opposite", "mm", "error_bound_um"];
/// Keys of a pose of the roll test.
const POSE: [&str; 6] = [
    "tooth",
    "fraction",
    "rotation_rad",
    "mm",
    "error_bound_um",
    "class",
];

/// The columns `names` of a reading, a row a tooth, under `keys`.
fn rows(read: &Gauged, reading: Reading, names: &[&str], keys: &[&str]) -> Value {
    let table = reading.table(read);
    table.map_or_else(|| json!([]), |table| table.of(names).to_json(keys))
}

fn over(read: &Gauged, reading: Reading, length: &str) -> Value {
    let names = ["tooth", "opposite", length, "error_bound"];
    rows(read, reading, &names, &OVER)
}

fn poses(columns: Vec<Column>) -> Value {
    let name = Reading::Roll.name();
    Table { name, columns }.to_json(&POSE)
}

fn pitch(found: &PitchReadings, read: &Gauged, readings: [Reading; 2]) -> Value {
    let [single, cumulative] = readings.map(|reading| reading.table(read));
    let list = |table: &Option<Table>, side: Flank| {
        let column = table.as_ref()?.column(side.name())?;
        Some(column.numbers())
    };
    let flank = |side| {
        json!({
            "single_greatest_um": found.greatest_single(side) * 1e3,
            "total_um": found.total(side) * 1e3,
            "single_um": list(&single, side),
            "cumulative_um": list(&cumulative, side),
        })
    };
    json!({
        "error_bound_um": found.error * 1e3,
        "right": flank(Flank::Right),
        "left": flank(Flank::Left),
    })
}

/// Values by tooth, and the curves of the teeth that are not alike, each with its first tooth.
fn profiles(flank: &FlankProfiles) -> Value {
    let um = |of: fn(&ProfileReading) -> f64| {
        let values = flank.by_tooth(of).into_iter();
        values.map(|mm| mm * 1e3).collect::<Vec<f64>>()
    };
    let curve = |(shape, profile): (usize, &ProfileReading)| {
        let tooth = flank.of_tooth.iter().position(|&of| of == shape);
        let points = || profile.points.iter();
        json!({
            "tooth": tooth.map(|index| index + 1),
            "roll_length_mm": points().map(|point| point.0).collect::<Vec<f64>>(),
            "deviation_um": points().map(|point| point.1 * 1e3).collect::<Vec<f64>>(),
        })
    };
    json!({
        "evaluated_roll_length_mm": flank.evaluated,
        "evaluated_mm": flank.evaluated_diameters,
        "slope_um": um(|profile| profile.slope),
        "form_um": um(|profile| profile.form),
        "total_um": um(|profile| profile.total),
        "curve_of_tooth": flank.of_tooth,
        "curves": flank.shapes.iter().enumerate().map(curve).collect::<Vec<_>>(),
    })
}

/// `grade` is null beyond the last one; the tolerance is then the last one's.
fn grade(one: &GradedReading) -> Value {
    let (grade, tolerance) = match one.grade {
        Grade::Within { grade, tolerance } => (Some(grade), tolerance),
        Grade::Beyond { tolerance, .. } => (None, tolerance),
    };
    json!({
        "symbol": one.quantity.symbol(),
        "axis": one.pitch.map(|(axis, _)| axis.name()),
        "flank": one.pitch.map(|(_, side)| side.name()),
        "measured_um": one.measured * 1e3,
        "error_bound_um": one.error * 1e3,
        "grade": grade,
        "tolerance_um": tolerance * 1e3,
    })
}
