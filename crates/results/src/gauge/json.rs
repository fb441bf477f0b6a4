//! The readings as JSON.

use super::{GaugedGear, GearSource};
use gearlash::contact::Touch;
use gearlash::gauge::{
    BallReading, FaceReadings, FlankTraces, Gauged, GradedReading, LeadReadings, OverPins,
    PitchReadings, ProfileReadings, RollPose, SectionReadings, Span, Spans, TraceReading,
    Unmeasured,
};
use gearlash::gear::{Flank, GRADE_SOURCE, Grade, Hand};
use gearlash_files::characters;
use gearlash_files::spec::GearSpec;
use serde_json::{Value, json};

/// All gears as JSON: lengths in mm where the name says so, deviations in µm. A reading that was not taken is
/// `{ "not_measured": reason }`.
///
/// # Errors
/// None caused by readings; an error of serde_json otherwise.
pub fn json(title: &str, gears: &[GaugedGear]) -> Result<String, serde_json::Error> {
    let gears: Vec<Value> = gears.iter().map(gear).collect();
    let all = json!({ "gearlash": env!("CARGO_PKG_VERSION"), "title": title, "gears": gears });
    characters::json_of(&all)
}

fn gear(gauged: &GaugedGear) -> Value {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let mut shown = json!({
        "gear": gauged.name,
        "material": gauged.material.name(),
        "teeth": gauged.teeth(),
        "spans": reading_or_reason(&read.spans, |spans| json!({
            "teeth": spans.teeth,
            "formula_mm": formula.span,
            "readings": spans.readings.iter().map(span).collect::<Value>(),
        })),
        "pins": reading_or_reason(&read.pins, |pins| json!({
            "pin_mm": pins.diameter,
            "formula_two_mm": formula.over_two,
            "two": over(&pins.two),
            "formula_three_mm": formula.over_three,
            "three": over(&pins.three),
        })),
        "runout": reading_or_reason(&read.runout, |runout| json!({
            "ball_mm": runout.diameter,
            "total_um": runout.total() * 1e3,
            "error_bound_um": runout.error() * 1e3,
            "readings": runout.readings.iter().map(ball).collect::<Value>(),
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
        "profile": reading_or_reason(&read.profile, |found| json!({
            "error_bound_um": found.error * 1e3,
            "right": profiles(found, Flank::Right),
            "left": profiles(found, Flank::Left),
        })),
        "grades": reading_or_reason(&read.grades, |graded| json!({
            "source": GRADE_SOURCE,
            "values": graded.iter().map(grade).collect::<Vec<_>>(),
        })),
        "roll": reading_or_reason(&read.roll, |found| json!({
            "master_teeth": found.master.basic_data().teeth(),
            "master_tip_diameter_mm": 2.0 * found.master.tip_radius(),
            "formula_mm": formula.distance,
            "total_um": found.total().found * 1e3,
            "total_missed_um": found.total().missed * 1e3,
            "tooth_to_tooth_um": found.tooth_to_tooth().found * 1e3,
            "tooth_to_tooth_missed_um": found.tooth_to_tooth().missed * 1e3,
            "error_bound_um": 2.0 * found.reading_error() * 1e3,
            "poses": poses(&found.poses),
            "between": poses(&found.between),
        })),
    });
    if let Some(found) = &read.along_face {
        shown["along_face"] = along_face(found);
    }
    match gauged.gear {
        GearSource::Data(gear, spec) => {
            if let Some(hand) = gear.gear().basic_data().hand() {
                of_helix(&gauged.gauged, spec, hand, &mut shown);
            }
        }
        GearSource::Drawn(gear) => shown["outline_bound_um"] = json!(gear.bound() * 1e3),
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
        shown["pins"]["lying"] = over(&pins.lying);
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

fn span(one: &Span) -> Value {
    json!({
        "tooth": one.first_tooth,
        "mm": one.length,
        "error_bound_um": one.error * 1e3,
        "touched": touched(&one.touched),
    })
}

fn ball(one: &BallReading) -> Value {
    json!({
        "tooth": one.seat.tooth,
        "radius_mm": one.radius,
        "error_bound_um": one.seat.error * 1e3,
        "touched": touched(&one.seat.touched),
    })
}

/// Dimensions over pins.
fn over(list: &[OverPins]) -> Value {
    let row = |one: &OverPins| {
        json!({
            "tooth": one.tooth,
            "opposite": one.opposite,
            "mm": one.length,
            "error_bound_um": one.error * 1e3,
        })
    };
    list.iter().map(row).collect()
}

/// The teeth and curves touched by a gauge.
fn touched(touches: &[Touch]) -> Value {
    let one = |touch: &Touch| json!({ "tooth": touch.tooth, "curve": touch.curve.name(), "radius_mm": touch.radius });
    touches.iter().map(one).collect()
}

/// Poses of a roll test.
fn poses(list: &[RollPose]) -> Value {
    let row = |pose: &RollPose| {
        json!({
            "tooth": pose.mating.wheel_tooth,
            "fraction": pose.mating.fraction,
            "rotation_rad": pose.rotation,
            "mm": pose.distance,
            "error_bound_um": pose.error * 1e3,
            "class": pose.class.name(),
        })
    };
    list.iter().map(row).collect()
}

fn pitch(found: &PitchReadings) -> Value {
    let um = |lengths: &[f64]| lengths.iter().map(|mm| mm * 1e3).collect::<Vec<f64>>();
    let flank = |side| {
        json!({
            "single_greatest_um": found.greatest_single(side) * 1e3,
            "total_um": found.total(side) * 1e3,
            "single_um": um(&found.single(side)),
            "cumulative_um": um(found.cumulative.flank(side)),
        })
    };
    json!({
        "error_bound_um": found.error * 1e3,
        "right": flank(Flank::Right),
        "left": flank(Flank::Left),
    })
}

fn profiles(found: &ProfileReadings, own: Flank) -> Value {
    let flank = found.flank(own);
    let head = json!({
        "evaluated_roll_length_mm": flank.evaluated,
        "evaluated_mm": found.evaluated_diameters[own.index()],
    });
    traces(flank, "roll_length_mm", head)
}

/// Leads of both flanks about one axis.
fn leads(found: &LeadReadings) -> Value {
    let flank = |own: Flank| {
        let flank = found.flank(own);
        let head = json!({
            "evaluated_from_reference_face_mm": flank.evaluated,
            "helix_slope_um": um(flank, |lead| found.helix_slope(own, lead)),
            "crowning_um": um(flank, |lead| found.crowning(lead)),
        });
        traces(flank, "from_reference_face_mm", head)
    };
    json!({
        "error_bound_um": found.error * 1e3,
        "right": flank(Flank::Right),
        "left": flank(Flank::Left),
    })
}

/// The readings of the gauges along the face.
fn along_face(found: &FaceReadings) -> Value {
    let section = |read: &SectionReadings| {
        json!({
            "from_reference_face_mm": read.height,
            "spans_mm": read.spans.as_ref().ok().map(Spans::ends),
            "mean_span_mm": read.spans.as_ref().ok().map(Spans::mean),
            "runout_um": read.runout.as_ref().ok().map(|runout| runout.total() * 1e3),
            "eccentricity_um": read.eccentricity.amount * 1e3,
            "high_tooth": read.eccentricity.high_tooth,
        })
    };
    json!({
        "lead_own": reading_or_reason(&found.own, leads),
        "lead_datum": reading_or_reason(&found.datum, leads),
        "sections": found.sections.iter().map(section).collect::<Vec<_>>(),
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

/// A grade; null beyond the last one, with the tolerance of the last one.
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
