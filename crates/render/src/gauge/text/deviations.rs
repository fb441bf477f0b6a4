//! Runout, pitch and roll in µm.

use gearlash::gauge::{Eccentricity, Gauged, PitchReadings};
use gearlash::gear::Side;
use gearlash_files::numbers::{ascii, order_um, um_ascii};
use std::fmt::Write;

pub(super) fn lines(read: &Gauged) -> String {
    let mut text = String::from("\n");
    if let Ok(runout) = &read.runout {
        let _ = writeln!(
            text,
            "F_r {} µm ({})",
            um_ascii(runout.total(), 3),
            eccentricity(&read.eccentricity),
        );
    }
    if let Ok(roll) = &read.roll {
        let [total, single] = [roll.total(), roll.tooth_to_tooth()].map(|range| {
            format!(
                "{} µm (+ {} at most)",
                um_ascii(range.found, 3),
                order_um(range.missed)
            )
        });
        let _ = writeln!(
            text,
            "F_i'' {total}, f_i'' {single}: {} poses a pitch and {} more round the extremes, each ± {} µm",
            roll.steps_per_pitch,
            roll.between.len(),
            order_um(roll.reading_error()),
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
            "2 e = {} µm towards tooth {}",
            um_ascii(2.0 * found.amount, 3),
            ascii(found.high_tooth, 2)
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
            um_ascii(pitch.greatest_single(side), 3),
            um_ascii(pitch.total(side), 3),
        )
    };
    format!("{}; {}", side(Side::Right), side(Side::Left))
}
