//! Accuracy grades of the pitch and runout readings.

use super::Unmeasured;
use super::flanks::PitchReadings;
use super::runout::RunoutReadings;
use crate::error::GearError;
use crate::gear::{BasicGearData, Flank, Grade, GradedQuantity, PitchAxis};

/// One measured value and its grade.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GradedReading {
    /// The graded quantity.
    pub quantity: GradedQuantity,
    /// Axis and flanks; `None` for the runout, which is read from the rotation axis.
    pub pitch: Option<(PitchAxis, Flank)>,
    /// mm.
    pub measured: f64,
    /// Bound on the error of `measured`, mm.
    pub error: f64,
    /// The finest grade that the value meets.
    pub grade: Grade,
}

/// The grades of the readings: about the datum axis, as in the standard, about the gear's own axis, and of the runout.
pub(super) fn grades<'a>(
    basic_data: &BasicGearData,
    pitches: impl Iterator<Item = &'a PitchReadings>,
    runout: Option<&RunoutReadings>,
) -> Result<Vec<GradedReading>, Unmeasured> {
    let mut list = Vec::new();
    for read in pitches {
        for side in Flank::BOTH {
            for (quantity, measured) in [
                (
                    GradedQuantity::SinglePitch,
                    read.cumulative.greatest_single(side),
                ),
                (GradedQuantity::TotalPitch, read.cumulative.total(side)),
            ] {
                // A difference of two values.
                let error = 2.0 * read.error;
                list.push((quantity, Some((read.axis, side)), measured, error));
            }
        }
    }
    list.extend(runout.map(|read| (GradedQuantity::Runout, None, read.total(), read.error())));
    // A reading within its error of zero is of a quantity without deviations, which nobody measured.
    list.retain(|(_, _, measured, error)| measured > error);
    let one = |(quantity, pitch, measured, error)| -> Result<GradedReading, GearError> {
        Ok(GradedReading {
            quantity,
            pitch,
            measured,
            error,
            // A value that exceeds a tolerance by less than its error is within it.
            grade: quantity.grade(basic_data, measured - error)?,
        })
    };
    let read: Result<Vec<GradedReading>, GearError> = list.into_iter().map(one).collect();
    read.map_err(|error| Unmeasured(error.to_string()))
}
