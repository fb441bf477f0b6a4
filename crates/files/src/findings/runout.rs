//! Findings about runout readings, in words.

use super::shown;
use crate::numbers::ascii;
use gearlash::gear::Probe;
use gearlash::metrology::{FittedReadings, FlankKnowledge};

pub fn readings(readings: &FittedReadings) -> String {
    let [range, left] = [readings.range_um, readings.left_um].map(|um| ascii(um, 3));
    let fitted = shown(readings.eccentricity);
    match readings.knowledge {
        FlankKnowledge::NoPitch => format!(
            "the readings' first harmonic{} is an eccentricity of {fitted}, which is used as the gear's: without [pitch] a first harmonic of its own tooth \
             thickness cannot be distinguished from it. F_r, their range, is {range} µm; up to {left} µm of a reading is residual and ignored",
            if readings.flanks_taken_out {
                ", after removing the effect of the stated tooth thickness,"
            } else {
                ""
            },
        ),
        FlankKnowledge::Pitch => format!(
            "the readings contain an eccentricity of {fitted}, after removing the effect of the stated flanks{} (their first harmonic itself is {}). \
             F_r, their range, is {range} µm; up to {left} µm of a reading is residual and ignored",
            probe(readings),
            shown(readings.first_harmonic)
        ),
        FlankKnowledge::DatumPitch => format!(
            "the readings' first harmonic is an eccentricity of {fitted}; datum-axis pitch cannot separate it from a first harmonic of the gear's own tooth \
             thickness, which looks the same in both. F_r, their range, is {range} µm; up to {left} µm of a reading is in neither that harmonic nor the pitch",
        ),
    }
}

fn probe(readings: &FittedReadings) -> String {
    match (readings.probe, readings.by_ball_um) {
        (Probe::Fork, _) => " as a fork at the pressure angle reads them".to_owned(),
        (Probe::Ball(mm), None) => format!(" under a ball of {mm} mm"),
        (Probe::Ball(mm), Some(um)) => format!(
            " under a ball of {} mm, which touches at the reference circle (another that fits changes it by up to {} µm; state it as ball_mm)",
            ascii(mm, 3),
            ascii(um, 3)
        ),
    }
}
