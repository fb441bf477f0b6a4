//! The flanks on the measuring circle: pitch of both flanks and tooth thickness.
//!
//! The measuring circle is the reference circle. About the gear's own centre it shows the gear's own pitch deviation.
//! About the rotation axis, as on a machine that holds the gear by its datum, it also shows the eccentricity.

use super::workpiece::Workpiece;
use super::{Summary, Unmeasured};
use crate::gear::{AsBuilt, Flank, Pitch, PitchAxis, Side};
use crate::numeric::mean;
use nalgebra::{Point2, UnitComplex, Vector2};

/// Pitch deviation of both flanks of a gear, read on the measuring circle.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PitchReadings {
    /// Centre of the circle.
    pub axis: PitchAxis,
    /// Cumulative deviation `F`, mm, along ascending numbers, each flank about its mean.
    pub cumulative: Pitch,
    /// Bound on the error of each value, mm.
    pub error: f64,
}

/// Tooth thickness all round.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ThicknessReadings {
    /// Radius of the measuring circle, mm.
    pub radius: f64,
    /// Thickness of each tooth, mm: an arc of that circle about the gear's own centre, not a chord. In a helical gear
    /// it is in the transverse section.
    pub arcs: Vec<f64>,
    /// `cos β`: ratio of the thickness in the normal section to the arc.
    pub normal: f64,
    /// Bound on the error of each, mm.
    pub error: f64,
    /// Nominal thickness, `s_t = m_n (π/2 + 2 x tan α_n)/cos β`, mm.
    pub nominal: f64,
}

impl ThicknessReadings {
    /// The readings in short.
    pub fn summary(&self) -> Summary {
        Summary::of(self.arcs.iter().map(|arc| (*arc, self.error)))
    }

    /// Each tooth's thickness less the mean, mm.
    pub fn deviations(&self) -> Vec<f64> {
        let mean = mean(&self.arcs);
        self.arcs.iter().map(|arc| arc - mean).collect()
    }
}

/// Polar angles of every flank's intersection with the circle, from the undisturbed centre line of its tooth, and the
/// greatest error as an arc.
struct Crossings {
    angles: [Vec<f64>; 2],
    error: f64,
}

/// The intersection of the flank on `side` of `tooth` in a `section` of the gear with the measuring circle about `axis`: its polar angle about
/// the circle's centre from the undisturbed centre line of the tooth, rad, the error as an arc, mm, and the place from the gear's own centre.
/// `None` off the flank.
pub(super) fn crossing(
    work: &Workpiece,
    section: &AsBuilt,
    (side, tooth): (Side, u32),
    axis: PitchAxis,
) -> Option<(f64, f64, Point2<f64>)> {
    let displacement = match axis {
        PitchAxis::Own => Vector2::zeros(),
        PitchAxis::Datum => section.displacement(0.0),
    };
    let along = UnitComplex::new(-section.tooth_angle(f64::from(tooth)));
    let centre = Point2::from(along * -displacement);
    let turn = UnitComplex::new(section.flank_offset(side, tooth));
    let (at, error) = work.crossing(side, tooth, turn.inverse() * centre, radius(work))?;
    let point = turn * at;
    let arm = point - centre;
    Some((arm.y.atan2(arm.x), error, point))
}

/// Reads the pitch of both flanks about `axis`.
pub(super) fn pitch(work: &Workpiece, axis: PitchAxis) -> Result<PitchReadings, Unmeasured> {
    let crossings = crossings(work, axis)?;
    let face = work.as_built.face();
    let scale = face.ascending() * radius(work);
    let curve = |own: Flank| -> Vec<f64> {
        let angles = &crossings.angles[face.seen_from_front(own).index()];
        angles.iter().map(|angle| scale * angle).collect()
    };
    Ok(PitchReadings {
        axis,
        cumulative: Pitch::from_cumulative(&curve(Flank::Right), &curve(Flank::Left)),
        // The error of the value plus that of the mean.
        error: 2.0 * crossings.error,
    })
}

/// Reads the thickness of every tooth.
pub(super) fn thickness(work: &Workpiece) -> Result<ThicknessReadings, Unmeasured> {
    let Crossings { angles, error } = crossings(work, PitchAxis::Own)?;
    let [right, left] = &angles;
    let teeth = right.iter().zip(left);
    let design = work.as_built.gear().design();
    Ok(ThicknessReadings {
        nominal: design.nominal_thickness() / design.basic_data.helix_cos(),
        radius: radius(work),
        normal: design.basic_data.helix_cos(),
        arcs: teeth
            .map(|(right, left)| radius(work) * (left - right))
            .collect(),
        error: 2.0 * error,
    })
}

fn radius(work: &Workpiece) -> f64 {
    work.as_built.gear().basic_data().reference_radius()
}

fn crossings(work: &Workpiece, axis: PitchAxis) -> Result<Crossings, Unmeasured> {
    let gear = work.as_built;
    let mut found = Crossings {
        angles: [Vec::new(), Vec::new()],
        error: 0.0,
    };
    for tooth in 1..=gear.gear().basic_data().teeth() {
        for (side, angles) in Side::BOTH.into_iter().zip(&mut found.angles) {
            let Some((angle, error, _)) = crossing(work, gear, (side, tooth), axis) else {
                return Err(Unmeasured(format!(
                    "the reference circle of {} mm does not cross the involute of tooth {tooth}",
                    2.0 * radius(work)
                )));
            };
            angles.push(angle);
            found.error = found.error.max(error);
        }
    }
    Ok(found)
}
