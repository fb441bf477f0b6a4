//! Runout as it is stated: an amount and a high tooth, or readings of a ball or a fork.

use super::error::MeasurementError;
use super::notes::Eccentricity;
use super::toleranced::Toleranced;
use crate::error::GearError;
use crate::gear::{BasicGearData, Gear};

/// What is stated of how far the teeth stand from the rotation axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum RunoutStatement {
    /// Nothing: none.
    #[default]
    None,
    /// Radial runout `F_r`, twice the eccentricity.
    Total {
        /// `F_r`, µm.
        total_um: f64,
        /// The tooth (fractional, `1 ≤ … < z + 1`) at the highest reading; `None`: it may be any.
        high_tooth: Option<f64>,
    },
    /// Readings all round.
    Readings(ProbeReadings),
}

/// Runout readings, from any one zero.
#[derive(Debug, Clone, PartialEq)]
pub struct ProbeReadings {
    /// One a tooth, tooth 1 first, µm, + = outwards.
    pub um: Vec<f64>,
    /// What was read with.
    pub with: ReadWith,
}

/// What touched the flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ReadWith {
    /// A fork astride each tooth.
    Fork,
    /// A ball of this diameter, mm, in the space after each tooth, towards the next number.
    Ball(f64),
    /// A ball there whose diameter is not known: taken as one that touches at the reference circle.
    AnyBall,
}

impl ProbeReadings {
    /// The readings in mm.
    pub(super) fn mm(&self) -> Vec<f64> {
        self.um.iter().map(|um| um / 1000.0).collect()
    }

    /// Greatest reading less least, µm.
    pub fn range_um(&self) -> f64 {
        let mm = self.mm();
        let greatest = mm.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = mm.iter().copied().fold(f64::INFINITY, f64::min);
        1000.0 * (greatest - least).max(0.0)
    }
}

impl RunoutStatement {
    /// The readings, where there are any.
    pub fn readings(&self) -> Option<&ProbeReadings> {
        match self {
            RunoutStatement::Readings(readings) => Some(readings),
            _ => None,
        }
    }

    /// The runout as it is stated; of readings that are not yet fitted, their range.
    pub(super) fn runout(&self) -> Runout {
        match self {
            RunoutStatement::None => Runout::default(),
            RunoutStatement::Total {
                total_um,
                high_tooth,
            } => Runout {
                total_um: *total_um,
                high_tooth: *high_tooth,
            },
            RunoutStatement::Readings(readings) => {
                let total_um = readings.range_um();
                Runout {
                    total_um,
                    high_tooth: (total_um > 0.0).then_some(1.0),
                }
            }
        }
    }

    /// Checks that it states numbers of a gear of `basic_data`.
    pub(super) fn check(&self, basic_data: &BasicGearData) -> Result<(), MeasurementError> {
        let wrong = |what, value, allowed| {
            Err(MeasurementError::Runout(GearError::OutOfRange {
                what,
                value,
                allowed,
            }))
        };
        match self {
            RunoutStatement::Total { total_um, .. } if !(*total_um >= 0.0) => {
                wrong("runout (µm)", *total_um, "0 or more")
            }
            RunoutStatement::Total {
                high_tooth: Some(high_tooth),
                ..
            } if !(*high_tooth >= 1.0 && *high_tooth < f64::from(basic_data.teeth()) + 1.0) => {
                wrong(
                    "high tooth",
                    *high_tooth,
                    "1 up to, but not including, the number of teeth + 1",
                )
            }
            RunoutStatement::Readings(readings) => {
                match readings.um.iter().find(|um| !um.is_finite()) {
                    Some(um) => wrong("a runout reading (µm)", *um, "a number"),
                    None => Ok(()),
                }
            }
            _ => Ok(()),
        }
    }
}

/// Runout `F_r`, µm, and the tooth towards which the teeth are displaced.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Runout {
    /// `F_r = 2 e`, µm.
    pub total_um: f64,
    /// `None` where none is stated: of a runout above 0 it may then be any.
    pub high_tooth: Option<f64>,
}

impl Runout {
    /// That of an eccentricity, mm, which readings hold.
    pub(super) fn fitted(eccentricity: f64, high_tooth: f64) -> Runout {
        let total_um = 2000.0 * eccentricity;
        Runout {
            total_um,
            high_tooth: (total_um > 0.0).then_some(high_tooth),
        }
    }

    /// Eccentricity `e = F_r/2`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.total_um / 2000.0
    }

    /// The eccentricity, where a runout is stated with its high tooth.
    pub fn stated(&self) -> Option<Eccentricity> {
        self.high_tooth.map(|high_tooth| Eccentricity {
            um: self.total_um / 2.0,
            high_tooth,
        })
    }

    /// Checks that it stays below the tooth depth of each of `gears`.
    pub(super) fn check(&self, gears: &Toleranced<Gear>) -> Result<(), MeasurementError> {
        let depth_of = |gear: &Gear| gear.tip_radius() - gear.root_radius();
        // Both thicknesses have one tip circle; the thicker tooth has the higher root.
        let depth_mm = depth_of(gears.most()).min(depth_of(gears.least()));
        if self.total_um / 1000.0 < depth_mm {
            return Ok(());
        }
        Err(MeasurementError::RunoutBeyondDepth {
            depth_um: 1000.0 * depth_mm,
        })
    }
}
