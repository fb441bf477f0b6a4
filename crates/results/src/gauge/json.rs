//! The readings as JSON, and the grades as a table.

use super::GaugedGear;
use crate::column::{Row, json_text, list, row_type, shown};
use crate::layout::Screen;
use gearlash::contact::Touch;
use gearlash::gauge::{
    BallReading, FaceReadings, FlankTraces, Gauged, GradedReading, LeadReadings, OverPins,
    PitchReadings, ProfileReadings, RollPose, SectionReadings, Span, TraceReading, Unmeasured,
};
use gearlash::gear::{Flank, GRADE_SOURCE, Hand};
use gearlash_input::spec::GearSpec;
use gearlash_text::numbers::um_ascii;
use serde_json::{Value, json};

/// All gears as JSON: lengths in mm where the name says so, deviations in µm. A reading that was not taken is
/// `{ "not_measured": reason }`.
pub fn json(title: &str, gears: &[GaugedGear]) -> String {
    let gears: Vec<Value> = gears.iter().map(gear).collect();
    json_text(&json!({ "gearlash": env!("CARGO_PKG_VERSION"), "title": title, "gears": gears }))
}

fn gear(gauged: &GaugedGear) -> Value {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let mut shown = json!({
        "gear": gauged.name,
        "material": gauged.material.name(),
        "teeth": gauged.teeth,
        "spans": reading_or_reason(&read.spans, |spans| json!({
            "teeth": spans.teeth,
            "formula_mm": formula.span,
            "readings": list(&spans.readings),
        })),
        "pins": reading_or_reason(&read.pins, |pins| json!({
            "pin_mm": pins.diameter,
            "formula_two_mm": formula.over_two,
            "two": list(&pins.two),
            "formula_three_mm": formula.over_three,
            "three": list(&pins.three),
        })),
        "runout": reading_or_reason(&read.runout, |runout| json!({
            "ball_mm": runout.diameter,
            "total_um": runout.total() * 1e3,
            "error_bound_um": runout.error() * 1e3,
            "readings": list(&runout.readings),
        })),
        "eccentricity": reading_or_reason(&read.eccentricity, |found| json!({
            "um": found.amount * 1e3,
            "high_tooth": found.high_tooth,
            "error_bound_um": found.error * 1e3,
        })),
        "pitch_own": reading_or_reason(&read.pitch_own, pitch),
        "pitch_datum": reading_or_reason(&read.pitch_datum, pitch),
        "thickness": reading_or_reason(&read.thickness, |thickness| json!({
            "circle_mm": 2.0 * thickness.radius,
            "formula_mm": formula.thickness,
            "error_bound_um": thickness.error * 1e3,
            "arc_mm": thickness.arcs,
        })),
        "root": reading_or_reason(&read.root, |root| json!({
            "diameter_mm": 2.0 * root.radius,
            "formula_mm": formula.root.map(|root| 2.0 * root),
            "error_bound_um": 2.0 * root.error * 1e3,
        })),
        "profile": reading_or_reason(&read.profile, profile),
        "grades": reading_or_reason(&read.grades, |graded| json!({
            "source": GRADE_SOURCE,
            "values": list(graded),
        })),
        "roll": reading_or_reason(&read.roll, |found| json!({
            "master_teeth": found.master.basic_data().teeth(),
            "master_tip_diameter_mm": 2.0 * found.master.tip_radius(),
            "formula_mm": formula.distance,
            "total_um": found.total.found * 1e3,
            "total_missed_um": found.total.missed * 1e3,
            "tooth_to_tooth_um": found.tooth_to_tooth.found * 1e3,
            "tooth_to_tooth_missed_um": found.tooth_to_tooth.missed * 1e3,
            "error_bound_um": 2.0 * found.distances().error * 1e3,
            "poses": list(&found.poses),
            "between": list(&found.between),
        })),
    });
    if let Some(found) = &read.along_face {
        shown["along_face"] = along_face(found);
    }
    if let Some((gear, spec)) = gauged.data
        && let Some(hand) = gear.gear().basic_data().hand()
    {
        of_helix(&gauged.gauged, spec, hand, &mut shown);
    }
    if let Some(mm) = gauged.outline_bound {
        shown["outline_bound_um"] = json!(mm * 1e3);
    }
    shown
}

/// Adds the keys of helical gears: the section or direction of lengths, dimensions over pins that lie along the spaces, thickness
/// in the normal section.
fn of_helix(read: &Gauged, spec: &GearSpec, hand: Hand, shown: &mut Value) {
    shown["helix_angle_deg"] = json!(spec.helix_angle_deg);
    shown["hand"] = json!(hand.name());
    shown["face_mm"] = json!(spec.face_mm);
    if read.spans.is_ok() {
        shown["spans"]["direction"] = json!("normal");
    }
    if let Ok(pins) = &read.pins {
        shown["pins"]["two_and_three_are"] = json!("balls");
        shown["pins"]["formula_lying_mm"] = json!(read.formula.over_lying);
        shown["pins"]["lying"] = list(&pins.lying);
    }
    if let Ok(thickness) = &read.thickness {
        let normal = |arc: &f64| arc * thickness.normal;
        shown["thickness"]["section"] = json!("transverse");
        shown["thickness"]["normal_formula_mm"] =
            json!(read.formula.thickness.as_ref().map(normal));
        shown["thickness"]["normal_mm"] =
            json!(thickness.arcs.iter().map(normal).collect::<Vec<f64>>());
    }
}

/// A reading as `shown`, or the reason why it was not taken.
fn reading_or_reason<T>(read: &Result<T, Unmeasured>, shown: impl Fn(&T) -> Value) -> Value {
    match read {
        Ok(read) => shown(read),
        Err(reason) => json!({ "not_measured": reason.to_string() }),
    }
}

row_type!(row: Span {
    "tooth" Plain => row.first_tooth;
    "mm" Plain => row.length;
    "error_bound_um" Plain => row.error * 1e3;
    "touched" Plain => list(&row.touched);
});

row_type!(row: BallReading {
    "tooth" Plain => row.seat.tooth;
    "radius_mm" Plain => row.radius;
    "error_bound_um" Plain => row.seat.error * 1e3;
    "touched" Plain => list(&row.seat.touched);
});

row_type!(row: OverPins {
    "tooth" Plain => row.tooth;
    "opposite" Plain => row.opposite;
    "mm" Plain => row.length;
    "error_bound_um" Plain => row.error * 1e3;
});

row_type!(row: Touch {
    "tooth" Plain => row.tooth;
    "curve" Plain => row.curve.name();
    "radius_mm" Plain => row.radius;
});

row_type!(row: RollPose {
    "tooth" Plain => row.mating.wheel_tooth;
    "fraction" Plain => row.mating.fraction;
    "rotation_rad" Plain => row.rotation;
    "mm" Plain => row.distance;
    "error_bound_um" Plain => row.error * 1e3;
    "class" Plain => row.class.name();
});

/// Readings of both flanks and their error bound, mm.
fn both(error: f64, flank: impl Fn(Flank) -> Value) -> Value {
    json!({
        "error_bound_um": error * 1e3,
        "right": flank(Flank::Right),
        "left": flank(Flank::Left),
    })
}

fn pitch(found: &PitchReadings) -> Value {
    let um = |lengths: &[f64]| lengths.iter().map(|mm| mm * 1e3).collect::<Vec<f64>>();
    let pitch = &found.cumulative;
    both(found.error, |side| {
        json!({
            "single_greatest_um": pitch.greatest_single(side) * 1e3,
            "total_um": pitch.total(side) * 1e3,
            "single_um": um(&pitch.single(side)),
            "cumulative_um": um(pitch.flank(side)),
        })
    })
}

fn profile(found: &ProfileReadings) -> Value {
    both(found.error, |own| {
        let flank = found.flank(own);
        let head = json!({
            "evaluated_roll_length_mm": flank.evaluated,
            "evaluated_mm": found.evaluated_diameters[own.index()],
        });
        traces(flank, "roll_length_mm", head)
    })
}

/// Leads about one axis.
fn leads(found: &LeadReadings) -> Value {
    both(found.error, |own| {
        let flank = found.flank(own);
        let head = json!({
            "evaluated_from_reference_face_mm": flank.evaluated,
            "helix_slope_um": um(flank, |lead| found.helix_slope(own, lead)),
            "crowning_um": um(flank, |lead| found.crowning(lead)),
        });
        traces(flank, "from_reference_face_mm", head)
    })
}

/// The readings of the gauges along the face.
fn along_face(found: &FaceReadings) -> Value {
    json!({
        "lead_own": reading_or_reason(&found.own, leads),
        "lead_datum": reading_or_reason(&found.datum, leads),
        "sections": list(&found.sections),
        "face_runout": {
            "um": found.face_runout.amount * 1e3,
            "diameter_mm": found.face_runout.diameter,
            "high_tooth": found.face_runout.high_tooth,
        },
    })
}

/// Values of `of` by tooth, µm.
fn um(flank: &FlankTraces, of: impl Fn(&TraceReading) -> f64) -> Vec<f64> {
    let values = flank.by_tooth(of).into_iter();
    values.map(|mm| mm * 1e3).collect()
}

/// `shown` with the values by tooth, and each distinct curve over `place` with its first tooth.
fn traces(flank: &FlankTraces, place: &str, mut shown: Value) -> Value {
    let curve = |(shape, trace): (usize, &TraceReading)| {
        let tooth = flank.of_tooth.iter().position(|&of| of == shape);
        let points = || trace.points.iter();
        json!({
            "tooth": tooth.map(|index| index + 1),
            place: points().map(|point| point.0).collect::<Vec<f64>>(),
            "deviation_um": points().map(|point| point.1 * 1e3).collect::<Vec<f64>>(),
        })
    };
    shown["slope_um"] = json!(um(flank, |trace| trace.slope));
    shown["form_um"] = json!(um(flank, |trace| trace.form));
    shown["total_um"] = json!(um(flank, |trace| trace.total));
    shown["curve_of_tooth"] = json!(flank.of_tooth);
    shown["curves"] = flank.shapes.iter().enumerate().map(curve).collect();
    shown
}

row_type!(row: SectionReadings {
    "from_reference_face_mm" Plain => row.height;
    "spans_mm" Plain => row.spans.as_ref().map_or(Value::Null, |spans| json!(spans.summary().ends));
    "mean_span_mm" Plain => row.spans.as_ref().ok().map(|spans| spans.summary().mean);
    "runout_um" Plain => row.runout.as_ref().ok().map(|runout| runout.total() * 1e3);
    "eccentricity_um" Plain => row.eccentricity.amount * 1e3;
    "high_tooth" Plain => row.eccentricity.high_tooth;
});

row_type!(row: GradedReading {
    "" Plain [heading(shown(""))] => graded_name(row);
    "symbol" Plain => row.quantity.symbol();
    "axis" Plain => row.pitch.map(|(axis, _)| axis.name());
    "flank" Plain => row.pitch.map(|(_, side)| side.name());
    "" Plain [heading(shown("measured"))] => um_ascii(row.measured, 3);
    "measured_um" Plain => row.measured * 1e3;
    "error_bound_um" Plain => row.error * 1e3;
    "" Plain [heading(shown("grade"))] => row.grade.words();
    "grade" Plain => row.grade.admits.then_some(row.grade.grade);
    "" Plain [heading(shown("tolerance"))] => um_ascii(row.grade.tolerance, 1);
    "tolerance_um" Plain => row.grade.tolerance * 1e3;
});

fn graded_name(one: &GradedReading) -> String {
    let symbol = one.quantity.symbol();
    match one.pitch {
        Some((axis, side)) => format!("{symbol} {}, {} flanks", axis.name(), side.name()),
        None => symbol.to_owned(),
    }
}

/// The `graded` readings as a table for a terminal.
pub fn grade_table(graded: &[GradedReading], screen: &Screen) -> String {
    GradedReading::columns().text(graded, screen)
}
