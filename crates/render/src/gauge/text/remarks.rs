//! What was not measured, and what was touched off the involute.

use gearlash::gauge::{Gauged, Unmeasured};
use gearlash::gear::ProfilePart;
use gearlash::mesh::{ContactKind, PoseClass, Touch};
use gearlash_files::results::gauge::GaugedGear;
use std::fmt::Write;

/// What the gauges did not read on `gauged`, and why: a line each.
pub fn missing(gauged: &GaugedGear) -> Vec<String> {
    let lines = unmeasured(&gauged.gauged).into_iter();
    let named = |line| format!("{}: {line}", gauged.words());
    lines.map(named).collect()
}

/// What was not measured, and why.
fn unmeasured(read: &Gauged) -> Vec<String> {
    let mut lines = Vec::new();
    let mut missing = |what: &str, reason: Option<&Unmeasured>| {
        lines.extend(reason.map(|reason| format!("not measured, {what}: {reason}")));
    };
    missing("span", read.spans.as_ref().err());
    missing("over pins", read.pins.as_ref().err());
    missing("runout", read.runout.as_ref().err());
    missing("pitch", read.pitch_own.as_ref().err());
    missing("pitch about the axis", read.pitch_datum.as_ref().err());
    missing("thickness", read.thickness.as_ref().err());
    missing("root diameter", read.root.as_ref().err());
    missing("roll test", read.roll.as_ref().err());
    lines
}

pub(super) fn lines(read: &Gauged) -> String {
    let mut text = String::new();
    for line in unmeasured(read) {
        let _ = writeln!(text, "{line}");
    }
    if let Err(reason) = &read.stated {
        let _ = writeln!(text, "no gear file: {reason}");
    }
    if let Ok(pins) = &read.pins {
        let touches = pins.seats.iter().map(|seat| seat.touched);
        text += &touched("pins", &touches.collect::<Vec<_>>());
    }
    if let Ok(runout) = &read.runout {
        let touches = runout.readings.iter().map(|reading| reading.seat.touched);
        text += &touched("balls", &touches.collect::<Vec<_>>());
    }
    if let Ok(roll) = &read.roll {
        let off = |class: PoseClass| class != PoseClass::Contact(ContactKind::Involute);
        let count = roll.poses.iter().filter(|pose| off(pose.class)).count();
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

fn touched(what: &str, touches: &[[Touch; 2]]) -> String {
    let mut text = String::new();
    for curve in [ProfilePart::Tip, ProfilePart::Fillet, ProfilePart::Root] {
        let on = |both: &&[Touch; 2]| both.iter().any(|touch| touch.curve == curve);
        let count = touches.iter().filter(on).count();
        if count > 0 {
            let _ = writeln!(
                text,
                "{count} of {} {what} touch the {}, not the involute alone",
                touches.len(),
                curve.name()
            );
        }
    }
    text
}
