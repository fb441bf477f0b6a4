//! What runout readings say, in words.

use super::eccentricity::shown;
use gearlash::gear::Probe;
use gearlash::metrology::{FittedReadings, FlankKnowledge, RunoutContradiction};

/// What was made of them.
pub fn readings(readings: &FittedReadings) -> String {
    let (range, left) = (readings.range_um, readings.left_um);
    let fitted = shown(readings.eccentricity);
    match readings.knowledge {
        FlankKnowledge::NoPitch => format!(
            "the readings' first harmonic{} is an eccentricity of {fitted}, which is used as the gear's: without [pitch] a first harmonic of its own tooth \
             thickness cannot be distinguished from it. F_r, their range, is {range:.3} µm; up to {left:.3} µm of a reading is residual and ignored",
            match readings.flanks_taken_out {
                false => "",
                true => ", after removing the effect of the stated tooth thickness,",
            },
        ),
        FlankKnowledge::Pitch => format!(
            "the readings contain an eccentricity of {fitted}, after removing the effect of the stated flanks{} (their first harmonic itself is {}). \
             F_r, their range, is {range:.3} µm; up to {left:.3} µm of a reading is residual and ignored",
            probe(readings),
            shown(readings.first_harmonic)
        ),
        FlankKnowledge::DatumPitch => format!(
            "the readings' first harmonic is an eccentricity of {fitted}; datum-axis pitch cannot separate it from a first harmonic of the gear's own tooth \
             thickness, which looks the same in both. F_r, their range, is {range:.3} µm; up to {left:.3} µm of a reading is in neither that harmonic nor the pitch",
        ),
    }
}

fn probe(readings: &FittedReadings) -> String {
    match (readings.probe, readings.by_ball_um) {
        (Probe::Fork, _) => " as a fork at the pressure angle reads them".to_owned(),
        (Probe::Ball(mm), None) => format!(" under a ball of {mm} mm"),
        (Probe::Ball(mm), Some(um)) => format!(
            " under a ball of {mm:.3} mm, which touches at the reference circle (another that fits changes it by up to {um:.3} µm; state it as ball_mm)"
        ),
    }
}

/// Readings beside the flanks that they refuse.
pub fn contradiction(found: &RunoutContradiction) -> String {
    let place = match found.probe {
        Probe::Ball(_) => "after tooth",
        Probe::Fork => "at tooth",
    };
    format!(
        "the readings contradict the flanks, whose data take precedence. Beyond the first harmonic the readings vary by up to {:.3} µm, the stated flanks by \
         {:.3} µm; {place} {} they differ by {:.3} µm. F_r of the readings is {:.3} µm, of the gear as stated {:.3} µm. Check gear, tooth numbers, sense and at",
        found.read_um,
        found.said_um,
        found.tooth,
        found.apart_um,
        found.range_um,
        found.known_range_um,
    )
}
