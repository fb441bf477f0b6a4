//! Which eccentricity a gear has: that of its runout, or that of pitch about the datum axis.

use super::error::MeasurementError;
use super::notes::{Eccentricity, EccentricityNote};
use super::pitch_statement::{EccentricitySource, PitchStatement};
use super::runout::{Runout, RunoutStatement};
use crate::error::GearError;
use crate::gear::{BasicGearData, Gear, Pitch};

impl PitchStatement {
    /// Checks that the eccentricity of this pitch and that of `runout` count once.
    ///
    /// # Errors
    /// [`MeasurementError::EccentricityTwice`], [`MeasurementError::NoRunout`], [`MeasurementError::NoEccentricityInOwnPitch`].
    pub fn check_eccentricity(&self, runout: &RunoutStatement) -> Result<(), MeasurementError> {
        let runout = runout.runout();
        match (self.is_datum(), self.eccentricity) {
            (true, None) if runout.total_um > 0.0 => Err(MeasurementError::EccentricityTwice),
            (true, Some(EccentricitySource::Runout)) if runout.stated().is_none() => {
                Err(MeasurementError::NoRunout)
            }
            (false, Some(_)) => Err(MeasurementError::NoEccentricityInOwnPitch),
            _ => Ok(()),
        }
    }
}

/// Own pitch of `gear`, from datum-axis `readings`, and the eccentricity that they hold.
///
/// # Errors
/// [`GearError::DatumPitch`] where an eccentricity moves the measuring circle off the involute.
pub(super) fn separate(
    readings: &Pitch,
    gear: &Gear,
    counts: Option<EccentricitySource>,
    runout: &Runout,
) -> Result<(Pitch, Eccentricity), GearError> {
    let separated = readings.separate_eccentricity(gear)?;
    let in_pitch = Eccentricity {
        um: 1000.0 * separated.eccentricity,
        high_tooth: separated.high_tooth,
    };
    let pitch = match runout.stated() {
        Some(stated) if counts == Some(EccentricitySource::Runout) => {
            readings.without_eccentricity(gear, runout.eccentricity(), stated.high_tooth)?
        }
        _ => separated.pitch,
    };
    Ok((pitch, in_pitch))
}

/// The eccentricity `in_pitch` beside that of `runout`.
pub(super) fn beside(
    in_pitch: Eccentricity,
    counts: Option<EccentricitySource>,
    runout: &Runout,
    basic_data: &BasicGearData,
) -> EccentricityNote {
    let stated = counts.and(runout.stated());
    EccentricityNote {
        in_pitch,
        stated,
        stated_counts: counts == Some(EccentricitySource::Runout),
        difference_um: stated.map(|stated| apart_um(in_pitch, stated, basic_data)),
    }
}

/// The distance of two displacements, µm.
pub(super) fn apart_um(one: Eccentricity, other: Eccentricity, basic_data: &BasicGearData) -> f64 {
    let angle = (other.high_tooth - one.high_tooth) * basic_data.angular_pitch();
    let (sin, cos) = angle.sin_cos();
    (other.um * cos - one.um).hypot(other.um * sin)
}
