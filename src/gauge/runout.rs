//! Runout `F_r`: a ball in every space, measured from the rotation axis.

use super::seat::{Seat, seats};
use super::workpiece::Workpiece;
use super::{Summary, Unmeasured};
use crate::numeric::range;

/// The ball in one space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BallReading {
    /// The ball at rest: the space after this seat's tooth, and its contacts.
    pub seat: Seat,
    /// Distance of its centre from the rotation axis, mm.
    pub radius: f64,
}

/// Readings all round.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RunoutReadings {
    /// Ball diameter, mm.
    pub diameter: f64,
    /// Readings by the tooth before the space.
    pub readings: Vec<BallReading>,
}

impl RunoutReadings {
    /// `F_r`, mm: greatest less least radius.
    pub fn total(&self) -> f64 {
        range(self.readings.iter().map(|reading| reading.radius))
    }

    /// Bound on the error of `F_r`, mm, for a difference of two readings.
    pub fn error(&self) -> f64 {
        2.0 * self.radii().error
    }

    /// The radii in short.
    pub fn radii(&self) -> Summary {
        let readings = self.readings.iter();
        Summary::of(readings.map(|reading| (reading.radius, reading.seat.error)))
    }

    /// Readings of a dial that is set to zero at the mean: each radius less the mean, mm.
    pub fn deviations(&self) -> Vec<f64> {
        let mean = self.radii().mean;
        let readings = self.readings.iter();
        readings.map(|reading| reading.radius - mean).collect()
    }
}

/// Measures balls of `diameter` in every space.
pub(super) fn runout(work: &Workpiece, diameter: f64) -> Result<RunoutReadings, Unmeasured> {
    let seats = seats(work, diameter)?;
    let displacement = work.as_built.displacement(0.0);
    let read = |seat: Seat| BallReading {
        radius: (seat.centre + displacement).coords.norm(),
        seat,
    };
    Ok(RunoutReadings {
        diameter,
        readings: seats.into_iter().map(read).collect(),
    })
}
