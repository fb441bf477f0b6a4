//! Pitch deviation of both flanks as stated on an inspection sheet, and its cumulative curves.

use super::error::MeasurementError;
use super::finding::Finding;
use super::runout::RunoutStatement;
use crate::error::GearError;
use crate::gear::{BasicGearData, Flank, Pitch, PitchAxis};
use std::f64::consts::PI;

/// Kind of a pitch value.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum PitchKind {
    /// F_p, from the first tooth, or any one place.
    #[default]
    Cumulative,
    /// f_p, from the tooth before.
    Single,
}

impl PitchKind {
    /// `cumulative` or `single`.
    pub fn name(self) -> &'static str {
        match self {
            PitchKind::Cumulative => "cumulative",
            PitchKind::Single => "single",
        }
    }
}

/// Meaning of a positive pitch value.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum PitchSense {
    /// Along ascending numbers.
    #[default]
    Numbers,
    /// More material.
    Material,
}

/// The source of the gear's eccentricity if datum-axis pitch and runout both contain one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum EccentricitySource {
    /// The eccentricity in the datum-axis pitch.
    Pitch,
    /// The eccentricity of the runout.
    Runout,
}

/// Pitch deviation of the gear's own right and left flanks, µm at the reference circle, one value per tooth, tooth 1 first.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchStatement {
    /// Kind of the values.
    pub kind: PitchKind,
    /// The axis of the measurement.
    pub axis: PitchAxis,
    /// Meaning of a positive value.
    pub sense: PitchSense,
    /// The source of the eccentricity; required for datum-axis pitch with a stated runout.
    pub eccentricity: Option<EccentricitySource>,
    /// Right flanks, µm.
    pub right_um: Vec<f64>,
    /// Left flanks, µm.
    pub left_um: Vec<f64>,
}

/// Greatest sum of single pitch deviations per tooth, µm: half of the 0.1 µm to which sheets round. A greater sum is a mistake, or
/// the values are not single deviations.
const ROUNDING_UM: f64 = 0.05;

impl PitchStatement {
    /// Whether the values were measured about the datum axis.
    pub fn is_datum(&self) -> bool {
        self.axis == PitchAxis::Datum
    }

    /// The values of a flank as stated, µm.
    pub fn values(&self, flank: Flank) -> &[f64] {
        match flank {
            Flank::Right => &self.right_um,
            Flank::Left => &self.left_um,
        }
    }

    /// The cumulative curves as measured, each within half a pitch.
    ///
    /// # Errors
    /// [`MeasurementError::Pitch`] for lists without one value per tooth, [`MeasurementError::PitchOffHalf`] for each flank off by more.
    pub fn curves(&self, basic_data: &BasicGearData) -> Result<Pitch, Vec<MeasurementError>> {
        let teeth = basic_data.teeth();
        let lengths = Flank::BOTH.map(|flank| self.values(flank).len());
        if let Some(found) = lengths.into_iter().find(|found| *found != teeth as usize) {
            return Err(vec![MeasurementError::Pitch(GearError::WrongLength {
                what: "pitch",
                found,
                teeth,
            })]);
        }
        let mm = |um: &[f64]| -> Vec<f64> { um.iter().map(|um| um / 1000.0).collect() };
        let (right, left) = (mm(&self.right_um), mm(&self.left_um));
        let mut pitch = match self.kind {
            PitchKind::Cumulative => Pitch::from_cumulative(&right, &left),
            PitchKind::Single => Pitch::from_single(&right, &left),
        };
        if self.sense == PitchSense::Material {
            pitch = pitch.read_as_material();
        }
        let half = PI * basic_data.module() / 2.0;
        let off = |flank: Flank| {
            let numbered = (1..).zip(pitch.flank(flank));
            let worst = numbered.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let (tooth, f) = worst.filter(|(_, f)| !(f.abs() < half))?;
            Some(MeasurementError::PitchOffHalf {
                flank,
                tooth,
                off_um: 1000.0 * f,
                half_pitch_um: 1000.0 * half,
            })
        };
        let off: Vec<MeasurementError> = Flank::BOTH.into_iter().filter_map(off).collect();
        if off.is_empty() { Ok(pitch) } else { Err(off) }
    }

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

    /// Each flank whose single pitch deviations do not sum to 0.
    pub(super) fn open_circles(&self) -> Vec<Finding> {
        if self.kind != PitchKind::Single {
            return Vec::new();
        }
        let open = |flank: Flank| {
            let um = self.values(flank);
            let sum_um: f64 = um.iter().sum();
            let rounding_um = ROUNDING_UM * um.len() as f64;
            (sum_um.abs() > rounding_um).then_some(Finding::PitchDoesNotClose {
                flank,
                sum_um,
                rounding_um,
            })
        };
        Flank::BOTH.into_iter().filter_map(open).collect()
    }
}
