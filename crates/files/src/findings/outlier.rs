//! Values that stand out, in words.

use crate::statements::Statements;
use gearlash::metrology::{Outlier, TooFar};

/// As a warning.
pub fn describe(of: &Statements, outlier: &Outlier) -> String {
    let (key, why) = match outlier {
        Outlier::Reading(reading) => (
            match reading.over_pins {
                true => "thickness.over_pins",
                false => "thickness.span",
            },
            match reading.why {
                TooFar::CoarseGear(um) => {
                    format!("more than the {um:.0} µm by which even a coarse gear varies")
                }
                TooFar::HalfWithin(um) => format!("half of them within {um:.1} µm"),
            },
        ),
        Outlier::Pitch(pitch) => (
            of.pitch_key(pitch.flank),
            format!(
                "more than the {:.0} µm of even a coarse gear, half of the others within {:.1} µm",
                pitch.coarse_um, pitch.half_within_um
            ),
        ),
    };
    format!(
        "{}: {} is {}, {why}: check it; it is used as given",
        of.table.path_of(key),
        what(outlier),
        off(outlier)
    )
}

/// As the end of a way out of something that cannot be.
pub fn suspected(outlier: &Outlier) -> String {
    format!(", above all {}: it is {}", what(outlier), off(outlier))
}

/// Which one it is.
fn what(outlier: &Outlier) -> String {
    match outlier {
        Outlier::Reading(reading) => {
            let place = if reading.over_pins { "space" } else { "tooth" };
            format!(
                "the reading at {place} {}, {} mm,",
                reading.place, reading.mm
            )
        }
        Outlier::Pitch(pitch) => format!(
            "tooth {} of the {} flanks, {} µm,",
            pitch.tooth,
            pitch.flank.name(),
            pitch.um
        ),
    }
}

/// From what it lies how far.
fn off(outlier: &Outlier) -> String {
    match outlier {
        Outlier::Reading(reading) => format!(
            "{:.1} µm from the median of all {}, {}",
            reading.off_um,
            reading.readings,
            match reading.flanks_taken_out {
                false => format!("{} mm", reading.median_mm),
                true => format!(
                    "{:.4} mm, after removing the effect of the stated flanks",
                    reading.median_mm
                ),
            }
        ),
        Outlier::Pitch(pitch) => format!(
            "{:.1} µm from {}",
            pitch.off_um,
            match pitch.from_neighbours {
                true => "its neighbours' mean",
                false => "the median",
            }
        ),
    }
}
