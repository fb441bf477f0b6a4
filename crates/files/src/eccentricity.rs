//! Which eccentricity a gear has: that of `[runout]`, or that of pitch about the datum axis.

use super::pitch::PitchSheet;
use super::problems::Problems;
use super::runout::Runout;
use super::table::Table;
use gearlash::error::GearError;
use gearlash::gear::{BasicGearData, Gear, Pitch};
use gearlash::metrology::{Eccentricity, EccentricityNote};

/// Of `[pitch] eccentricity`: which one counts where pitch and runout both state it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Counts {
    Pitch,
    Runout,
}

pub const COUNTS: [(&str, Counts); 2] = [("pitch", Counts::Pitch), ("runout", Counts::Runout)];

/// Checks that the eccentricity of `sheet` and of `runout` count once.
pub fn check(
    gear: &Table,
    sheet: &PitchSheet,
    runout: &Runout,
    problems: &mut Problems,
) -> Option<()> {
    let (key, reason, help) = match (sheet.is_datum(), sheet.counts()) {
        (true, None) if runout.total_um > 0.0 => (
            "pitch.axis",
            "pitch measured about the datum axis already contains the eccentricity, and [runout] would count it twice",
            "drop the runout, or say in [pitch] which counts: eccentricity = \"pitch\" or \"runout\"; \
             write axis = \"own\" if the values are free of eccentricity",
        ),
        (true, Some(Counts::Runout)) if runout.stated().is_none() => (
            "pitch.eccentricity",
            "no runout is stated, or no high tooth of it",
            "add [runout] with total_um and high_tooth, or write eccentricity = \"pitch\"",
        ),
        (false, Some(_)) => (
            "pitch.eccentricity",
            "goes with axis = \"datum\" only: values about the gear's own axis contain no eccentricity",
            "remove it, or write axis = \"datum\"",
        ),
        _ => return Some(()),
    };
    problems.add(gear.problem(key, reason, help));
    None
}

/// Own pitch of `gear`, from datum-axis `readings`, and the eccentricity that they hold.
///
/// # Errors
/// [`GearError::DatumPitch`] where an eccentricity moves the measuring circle off the involute.
pub fn separate(
    readings: &Pitch,
    gear: &Gear,
    counts: Option<Counts>,
    runout: &Runout,
) -> Result<(Pitch, Eccentricity), GearError> {
    let separated = readings.separate_eccentricity(gear)?;
    let in_pitch = Eccentricity {
        um: 1000.0 * separated.eccentricity,
        high_tooth: separated.high_tooth,
    };
    let pitch = match runout.stated() {
        Some(stated) if counts == Some(Counts::Runout) => {
            readings.without_eccentricity(gear, runout.eccentricity(), stated.high_tooth)?
        }
        _ => separated.pitch,
    };
    Ok((pitch, in_pitch))
}

/// The eccentricity `in_pitch` beside that of `runout`.
pub fn beside(
    in_pitch: Eccentricity,
    counts: Option<Counts>,
    runout: &Runout,
    basic_data: &BasicGearData,
) -> EccentricityNote {
    let stated = counts.and(runout.stated());
    EccentricityNote {
        in_pitch,
        stated,
        stated_counts: counts == Some(Counts::Runout),
        difference_um: stated.map(|stated| apart_um(in_pitch, stated, basic_data)),
    }
}

/// The distance of two displacements, µm.
pub fn apart_um(one: Eccentricity, other: Eccentricity, basic_data: &BasicGearData) -> f64 {
    let angle = (other.high_tooth - one.high_tooth) * basic_data.angular_pitch();
    let (sin, cos) = angle.sin_cos();
    (other.um * cos - one.um).hypot(other.um * sin)
}

/// An eccentricity in words.
pub fn shown(e: Eccentricity) -> String {
    format!("{:.3} µm towards tooth {:.2}", e.um, e.high_tooth)
}

/// What the user should know of it.
pub fn told(gear: &Table, note: &EccentricityNote) -> String {
    let found = shown(note.in_pitch);
    let pitch = gear.path_of("pitch");
    match (note.stated, note.difference_um) {
        (Some(stated), Some(apart)) if note.stated_counts => format!(
            "{pitch}: the datum-axis values contain an eccentricity of {found}; that of [runout], {}, {apart:.3} µm from it, counts and is \
             taken out of them, and what is left of a first harmonic counts as the gear's own pitch",
            shown(stated),
        ),
        (stated, apart) => {
            let beside = match (stated, apart) {
                (Some(stated), Some(apart)) => format!(
                    "; [runout] says {}, {apart:.3} µm from it, which is not used",
                    shown(stated)
                ),
                _ => String::new(),
            };
            format!(
                "{pitch}: the datum-axis values contain an eccentricity of {found}, which is taken as the gear's \
                 (a first harmonic of its own pitch cannot be told from it){beside}"
            )
        }
    }
}
