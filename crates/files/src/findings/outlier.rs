//! Outliers, in words.

use crate::numbers::ascii;
use crate::statements::Statements;
use gearlash::metrology::{Outlier, TooFar};

/// The key of an outlier and a warning.
pub fn describe(of: &Statements, outlier: &Outlier) -> (&'static str, String) {
    let (key, why) = match outlier {
        Outlier::Reading(reading) => (
            if reading.over_pins {
                "thickness.over_pins"
            } else {
                "thickness.span"
            },
            match reading.why {
                TooFar::CoarseGear(um) => format!(
                    "more than the {} µm by which even a coarse gear varies",
                    ascii(um, 0)
                ),
                TooFar::HalfWithin(um) => format!("half of them within {} µm", ascii(um, 1)),
            },
        ),
        Outlier::Pitch(pitch) => (
            of.pitch_key(pitch.flank),
            format!(
                "more than the {} µm of even a coarse gear, half of the others within {} µm",
                ascii(pitch.coarse_um, 0),
                ascii(pitch.half_within_um, 1)
            ),
        ),
    };
    let (name, deviation) = (outlier_name(outlier), deviation(outlier));
    let words = format!("{name} is {deviation}, {why}: check it; it is used as given");
    (key, words)
}

/// The outlier as the end of a help text for impossible measurements.
pub fn suspected(outlier: &Outlier) -> String {
    format!(
        ", above all {}: it is {}",
        outlier_name(outlier),
        deviation(outlier)
    )
}

fn outlier_name(outlier: &Outlier) -> String {
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

/// Its deviation and the reference it deviates from.
fn deviation(outlier: &Outlier) -> String {
    match outlier {
        Outlier::Reading(reading) => format!(
            "{} µm from the median of all {}, {}",
            ascii(reading.off_um, 1),
            reading.readings,
            if reading.flanks_taken_out {
                format!(
                    "{} mm, after removing the effect of the stated flanks",
                    ascii(reading.median_mm, 4)
                )
            } else {
                format!("{} mm", reading.median_mm)
            }
        ),
        Outlier::Pitch(pitch) => format!(
            "{} µm from {}",
            ascii(pitch.off_um, 1),
            if pitch.from_neighbours {
                "its neighbours' mean"
            } else {
                "the median"
            }
        ),
    }
}
