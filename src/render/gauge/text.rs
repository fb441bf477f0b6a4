//! A short table of each gear.

use super::GaugedGear;
use crate::gauge::{Eccentricity, Gauged, GradedReading, PitchReadings, Unmeasured};
use crate::gear::{Curve, GRADE_SOURCE, Grade, Side};
use crate::mesh::{ContactKind, PoseClass, Touch};
use crate::render::table::{finish, table, um};
use std::fmt::Write;

/// The text `gauge` prints.
pub fn text(title: &str, gears: &[GaugedGear]) -> String {
    let mut text = format!("{title}\n");
    for gauged in gears {
        let _ = write!(text, "\n{}\n\n", gauged.words());
        text += &lengths(&gauged.gauged);
        text += &deviations(&gauged.gauged);
        text += &grades(&gauged.gauged);
        text += &remarks(&gauged.gauged);
    }
    text += LEGEND;
    let _ = writeln!(text, "Grades: {GRADE_SOURCE}.");
    text
}

const LEGEND: &str = "
Lengths in mm; range, off and bound in µm. Formula: of the mean thickness, no deviations. Off: mean less formula.
Ball: its centre from the rotation axis, so its range is F_r. a'': tight mesh with the master, its range is F_i''.
F_r of an eccentricity e alone is 2 e, down to 2 e cos(π/z) where no space is in line with the high tooth;
pitch and thickness of the teeth add to it.
Thickness is an arc of the reference circle. Pitch: own, about the gear's own centre; datum, about its rotation axis,
which is what a standard grades. Grade: the finest that admits the value, with its tolerance; measured and tolerance in µm.
";

/// Lengths with their least, mean and greatest reading.
fn lengths(read: &Gauged) -> String {
    let mut table = table(&[
        "", "least", "mean", "greatest", "range", "formula", "off", "bound",
    ]);
    let mut row = |name: String, values: Vec<f64>, error: f64, formula: Option<f64>| {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
        let mm = |length: f64| format!("{length:.6}");
        table.add_row(vec![
            name,
            mm(least),
            mm(mean),
            mm(most),
            um(Some(most - least), 3),
            formula.map_or("–".to_owned(), mm),
            um(formula.map(|formula| mean - formula), 3),
            format!("{:.0e}", 1e3 * error),
        ]);
    };
    let greatest = |errors: &mut dyn Iterator<Item = f64>| errors.fold(0.0, f64::max);
    let formula = &read.formula;
    if let Ok(spans) = &read.spans {
        let values = spans.readings.iter().map(|span| span.length).collect();
        let error = greatest(&mut spans.readings.iter().map(|span| span.error));
        row(
            format!("span W_{}", spans.teeth),
            values,
            error,
            formula.span,
        );
    }
    if let Ok(pins) = &read.pins {
        for (name, list, formula) in [
            ("two", &pins.two, formula.over_two),
            ("three", &pins.three, formula.over_three),
        ] {
            if !list.is_empty() {
                let values = list.iter().map(|over| over.length).collect();
                let error = greatest(&mut list.iter().map(|over| over.error));
                row(
                    format!("M_dK, {name} pins {} mm", pins.diameter),
                    values,
                    error,
                    formula,
                );
            }
        }
    }
    if let Ok(thickness) = &read.thickness {
        row(
            "thickness s".to_owned(),
            thickness.arcs.clone(),
            thickness.error,
            Some(formula.thickness),
        );
    }
    if let Ok(runout) = &read.runout {
        let values = runout
            .readings
            .iter()
            .map(|reading| reading.radius)
            .collect();
        let error = greatest(&mut runout.readings.iter().map(|reading| reading.seat.error));
        row(
            format!("ball {} mm", runout.diameter),
            values,
            error,
            formula.ball_centre,
        );
    }
    if let Ok(roll) = &read.roll {
        let values = roll.poses.iter().map(|pose| pose.distance).collect();
        let error = greatest(&mut roll.poses.iter().map(|pose| pose.error));
        let master = roll.master.toothing().teeth();
        row(
            format!("a'', master z {master}"),
            values,
            error,
            formula.distance,
        );
    }
    finish(&table)
}

/// Runout, pitch and roll in µm.
fn deviations(read: &Gauged) -> String {
    let mut text = String::from("\n");
    if let Ok(runout) = &read.runout {
        let _ = writeln!(
            text,
            "F_r {} µm ({})",
            um(Some(runout.total()), 3),
            eccentricity(&read.eccentricity),
        );
    }
    if let Ok(roll) = &read.roll {
        let _ = writeln!(
            text,
            "F_i'' {} µm, f_i'' {} µm (± {:.0e} µm, at {} poses a pitch)",
            um(Some(roll.total()), 3),
            um(Some(roll.tooth_to_tooth()), 3),
            1e3 * roll.error(),
            roll.steps_per_pitch,
        );
    }
    for pitch in [&read.pitch_own, &read.pitch_datum].into_iter().flatten() {
        let _ = writeln!(text, "pitch, {}: {}", pitch.axis.name(), both(pitch));
    }
    text
}

fn eccentricity(found: &Eccentricity) -> String {
    if found.amount > 0.0 {
        format!(
            "2 e = {} µm towards tooth {:.2}",
            um(Some(2.0 * found.amount), 3),
            found.high_tooth
        )
    } else {
        "no eccentricity".to_owned()
    }
}

fn both(pitch: &PitchReadings) -> String {
    let side = |side: Side| {
        format!(
            "{} flanks f_p {} µm, F_p {} µm",
            side.name(),
            um(Some(pitch.greatest_single(side)), 3),
            um(Some(pitch.total(side)), 3),
        )
    };
    format!("{}; {}", side(Side::Right), side(Side::Left))
}

/// Accuracy grades, or why there are none.
fn grades(read: &Gauged) -> String {
    let graded = match &read.grades {
        Ok(graded) if graded.is_empty() => return String::new(),
        Ok(graded) => graded,
        Err(reason) => return format!("\nno accuracy grades: {reason}\n"),
    };
    let mut table = table(&["", "measured", "grade", "tolerance"]);
    for one in graded {
        let (grade, tolerance) = match one.grade {
            Grade::Within { grade, tolerance } => (grade.to_string(), tolerance),
            Grade::Beyond { last, tolerance } => (format!("beyond {last}"), tolerance),
        };
        table.add_row(vec![
            graded_words(one),
            um(Some(one.measured), 3),
            grade,
            um(Some(tolerance), 1),
        ]);
    }
    format!("\n{}", finish(&table))
}

fn graded_words(one: &GradedReading) -> String {
    let symbol = one.graded.symbol();
    match one.pitch {
        Some((axis, side)) => format!("{symbol} {}, {} flanks", axis.name(), side.name()),
        None => symbol.to_owned(),
    }
}

/// What was not measured, and what was touched off the involute.
fn remarks(read: &Gauged) -> String {
    let mut text = String::new();
    let mut missing = |what: &str, reason: Option<&Unmeasured>| {
        if let Some(reason) = reason {
            let _ = writeln!(text, "not measured, {what}: {reason}");
        }
    };
    missing("span", read.spans.as_ref().err());
    missing("over pins", read.pins.as_ref().err());
    missing("runout", read.runout.as_ref().err());
    missing("pitch", read.pitch_own.as_ref().err());
    missing("pitch about the axis", read.pitch_datum.as_ref().err());
    missing("thickness", read.thickness.as_ref().err());
    missing("roll test", read.roll.as_ref().err());
    let mut touched = |what: &str, touches: Vec<[Touch; 2]>| {
        for curve in [Curve::Tip, Curve::Fillet, Curve::Root] {
            let count = touches
                .iter()
                .filter(|both| both.iter().any(|t| t.curve == curve))
                .count();
            if count > 0 {
                let _ = writeln!(
                    text,
                    "{count} of {} {what} touch the {}, not the involute alone",
                    touches.len(),
                    curve.name()
                );
            }
        }
    };
    if let Ok(spans) = &read.spans {
        touched(
            "spans",
            spans.readings.iter().map(|span| span.touched).collect(),
        );
    }
    if let Ok(pins) = &read.pins {
        touched("pins", pins.seats.iter().map(|seat| seat.touched).collect());
    }
    if let Ok(runout) = &read.runout {
        touched(
            "balls",
            runout
                .readings
                .iter()
                .map(|reading| reading.seat.touched)
                .collect(),
        );
    }
    if let Ok(roll) = &read.roll {
        let off = roll
            .poses
            .iter()
            .filter(|pose| pose.class != PoseClass::Contact(ContactKind::Involute));
        let count = off.count();
        if count > 0 {
            let _ = writeln!(
                text,
                "at {count} of {} poses the roll test touches off the line of action",
                roll.poses.len()
            );
        }
    }
    text
}
