//! The readings as JSON.

use super::GaugedGear;
use super::by_tooth::micrometres;
use gearlash::gauge::{GradedReading, OverPins, PitchReadings, RollPose, Unmeasured};
use gearlash::gear::{GRADE_SOURCE, Grade, Side};
use gearlash::mesh::Touch;
use gearlash_files::characters;
use serde_json::{Value, json};

/// All gears: lengths in mm where the name says so, deviations in µm. What was not measured is
/// `{ "not_measured": reason }`.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
pub fn json(title: &str, gears: &[GaugedGear]) -> Result<String, serde_json::Error> {
    let gears: Vec<Value> = gears.iter().map(gear).collect();
    let all = json!({ "gearlash": env!("CARGO_PKG_VERSION"), "title": title, "gears": gears });
    Ok(characters::json(serde_json::to_string_pretty(&all)?) + "\n")
}

fn gear(gauged: &GaugedGear) -> Value {
    let read = &gauged.gauged;
    let formula = &read.formula;
    json!({
        "gear": gauged.name,
        "material": gauged.material.name(),
        "teeth": gauged.gear.gear().basic_data().teeth(),
        "spans": of(&read.spans, |spans| json!({
            "teeth": spans.teeth,
            "formula_mm": formula.span,
            "readings": spans.readings.iter().map(|span| json!({
                "tooth": span.first_tooth,
                "mm": span.length,
                "error_bound_um": span.error * 1e3,
                "touched": touched(&span.touched),
            })).collect::<Vec<_>>(),
        })),
        "pins": of(&read.pins, |pins| json!({
            "pin_mm": pins.diameter,
            "formula_two_mm": formula.over_two,
            "two": over(&pins.two),
            "formula_three_mm": formula.over_three,
            "three": over(&pins.three),
        })),
        "runout": of(&read.runout, |runout| json!({
            "ball_mm": runout.diameter,
            "total_um": runout.total() * 1e3,
            "error_bound_um": runout.error() * 1e3,
            "readings": runout.readings.iter().map(|reading| json!({
                "tooth": reading.seat.tooth,
                "radius_mm": reading.radius,
                "error_bound_um": reading.seat.error * 1e3,
                "touched": touched(&reading.seat.touched),
            })).collect::<Vec<_>>(),
        })),
        "eccentricity": {
            "um": read.eccentricity.amount * 1e3,
            "high_tooth": read.eccentricity.high_tooth,
            "error_bound_um": read.eccentricity.error * 1e3,
        },
        "pitch_own": of(&read.pitch_own, pitch),
        "pitch_datum": of(&read.pitch_datum, pitch),
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
        "grades": of(&read.grades, |graded| json!({
            "source": GRADE_SOURCE,
            "values": graded.iter().map(grade).collect::<Vec<_>>(),
        })),
        "roll": of(&read.roll, |roll| json!({
            "master_teeth": roll.master.basic_data().teeth(),
            "master_tip_diameter_mm": 2.0 * roll.master.tip_radius(),
            "formula_mm": formula.distance,
            "total_um": roll.total().found * 1e3,
            "total_missed_um": roll.total().missed * 1e3,
            "tooth_to_tooth_um": roll.tooth_to_tooth().found * 1e3,
            "tooth_to_tooth_missed_um": roll.tooth_to_tooth().missed * 1e3,
            "error_bound_um": 2.0 * roll.reading_error() * 1e3,
            "poses": roll.poses.iter().map(pose).collect::<Vec<_>>(),
            "between": roll.between.iter().map(pose).collect::<Vec<_>>(),
        })),
    })
}

fn of<T>(read: &Result<T, Unmeasured>, shown: impl Fn(&T) -> Value) -> Value {
    match read {
        Ok(read) => shown(read),
        Err(reason) => json!({ "not_measured": reason.to_string() }),
    }
}

fn over(list: &[OverPins]) -> Vec<Value> {
    let one = |over: &OverPins| {
        json!({
            "tooth": over.tooth,
            "opposite": over.opposite,
            "mm": over.length,
            "error_bound_um": over.error * 1e3,
        })
    };
    list.iter().map(one).collect()
}

fn pose(pose: &RollPose) -> Value {
    json!({
        "tooth": pose.mating.wheel_tooth,
        "fraction": pose.mating.fraction,
        "rotation_rad": pose.rotation,
        "mm": pose.distance,
        "error_bound_um": pose.error * 1e3,
        "class": pose.class.name(),
    })
}

fn pitch(pitch: &PitchReadings) -> Value {
    let flank = |side| {
        json!({
            "single_greatest_um": pitch.greatest_single(side) * 1e3,
            "total_um": pitch.total(side) * 1e3,
            "single_um": micrometres(&pitch.single(side)),
            "cumulative_um": micrometres(pitch.cumulative.flank(side)),
        })
    };
    json!({
        "error_bound_um": pitch.error * 1e3,
        "right": flank(Side::Right),
        "left": flank(Side::Left),
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

fn touched(touches: &[Touch]) -> Vec<Value> {
    let one = |touch: &Touch| json!({ "tooth": touch.tooth, "curve": touch.curve.name(), "radius_mm": touch.radius });
    touches.iter().map(one).collect()
}
