//! Readings along the face: leads about both axes, and spans and runout at several heights.
//!
//! A stylus follows each flank on the reference circle, section by section, while the machine turns with the helix. The further turn of the
//! flank, times the base radius, is its lead deviation along the transverse base tangent, plus = more material, 0 in the measuring plane.
//! About the axis of the teeth a trace shows the lead alone. About the rotation axis it contains wobble, and on helical teeth eccentricity. A
//! leaning tooth shows in a section its own height `b + t·q`, where `q` leads from the axis of the teeth to the point
//! ([`crate::pair::section_at`]).
//!
//! The evaluation follows ISO 1328-1 with a straight line as design lead. `C_β` is the least-squares parabola, over the whole face.

use super::Unmeasured;
use super::eccentricity::{Eccentricity, eccentricity};
use super::flanks::crossing;
use super::profile::{FlankTraces, TraceReading, evaluate, off_flank};
use super::runout::{RunoutReadings, runout};
use super::span::{Spans, spans};
use super::workpiece::Workpiece;
use crate::gear::{AsBuilt, Flank, Hand, Lead, PitchAxis};
use crate::parallel;
use nalgebra::{UnitComplex, Vector2};

/// Points over the face, and over the evaluation range.
const POINTS: usize = 41;
/// Multiple of its bound below which two traces are one.
const ALIKE: f64 = 100.0;
/// Share of the face that the evaluation range leaves out at each end, unless one module is less (ISO 1328-1).
const LEFT_OUT: f64 = 0.05;

/// Readings along the face of a gear that deviates there.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FaceReadings {
    /// Leads about the axis of the teeth.
    pub own: Result<LeadReadings, Unmeasured>,
    /// Leads about the rotation axis.
    pub datum: Result<LeadReadings, Unmeasured>,
    /// Readings at both ends of the evaluation range and in its middle.
    pub sections: Vec<SectionReadings>,
    /// Runout of a shoulder that was machined with the teeth.
    pub face_runout: FaceRunout,
}

impl FaceReadings {
    /// The leads about the axis of the teeth, and those about the rotation axis where they differ.
    pub fn leads(&self) -> impl Iterator<Item = &LeadReadings> {
        let own = self.own.as_ref().ok();
        let datum = self.datum.as_ref().ok();
        let datum = datum.filter(|datum| own.is_none_or(|own| own.flanks != datum.flanks));
        own.into_iter().chain(datum)
    }
}

/// Readings at one height.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SectionReadings {
    /// Height from the reference face's end of the teeth, mm.
    pub height: f64,
    /// `W_k`.
    pub spans: Result<Spans, Unmeasured>,
    /// `F_r`.
    pub runout: Result<RunoutReadings, Unmeasured>,
    /// The centre of the tip circle.
    pub eccentricity: Eccentricity,
}

/// Axial runout of the reference face, from the eccentricities at two heights.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FaceRunout {
    /// Total reading, mm; 0 if it is not above its error.
    pub amount: f64,
    /// Diameter on which it is read, mm: the reference circle.
    pub diameter: f64,
    /// Tooth, fractional, at which the face stands out most, in the section at the face's end of the teeth.
    pub high_tooth: f64,
    /// Bound on the error of `amount`, mm.
    pub error: f64,
}

/// Leads of all flanks about one axis.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LeadReadings {
    /// The axis of the measurement.
    pub axis: PitchAxis,
    /// Leads of the gear's own right flanks, then of its left ones, over the height from the reference face's end of the teeth.
    pub flanks: [FlankTraces; 2],
    /// Whether the teeth are helical.
    pub is_helical: bool,
    /// The hand of the teeth; right for spur gears.
    hand: Hand,
    /// Width of the face, mm.
    width: f64,
    /// Bound on the error of each deviation, mm.
    pub error: f64,
}

impl LeadReadings {
    /// The leads of a gear's own flank.
    pub fn flank(&self, own: Flank) -> &FlankTraces {
        &self.flanks[own.index()]
    }

    /// `f_Hβ` of a lead, mm: plus = greater helix angle, of spur gears as if they were right hand.
    pub fn helix_slope(&self, own: Flank, lead: &TraceReading) -> f64 {
        Lead::slope_of_helix(lead.slope, self.hand, own)
    }

    /// `C_β` of a lead, mm: a parabola, 0 in the middle, this much less material at both ends of the face.
    pub fn crowning(&self, lead: &TraceReading) -> f64 {
        let [(from, _), (to, _)] = lead.mean_line;
        lead.crowning * (self.width / (to - from)).powi(2)
    }
}

/// The face of a gear: its ends, and heights on it.
#[derive(Clone, Copy)]
struct OwnFace {
    /// Ends along the axis, mm from the measuring plane.
    ends: [f64; 2],
    /// Whether the reference face is in front.
    is_front: bool,
    /// Evaluation range, heights, mm.
    range: [f64; 2],
}

impl OwnFace {
    fn new(gear: &AsBuilt, ends: [f64; 2], range: Option<[f64; 2]>) -> OwnFace {
        let width = ends[1] - ends[0];
        let margin = gear.gear().basic_data().module().min(LEFT_OUT * width);
        OwnFace {
            ends,
            is_front: gear.face().ascending() < 0.0,
            range: range.unwrap_or([margin, width - margin]),
        }
    }

    fn width(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// Place along the axis of a height.
    fn place(&self, height: f64) -> f64 {
        if self.is_front {
            self.ends[0] + height
        } else {
            self.ends[1] - height
        }
    }
}

/// Reads leads, spans over `k` teeth, and runout with a `ball`, along the face; `None` for a gear that does not deviate there. The heights of
/// `range` count from the reference face's end of the teeth.
pub(super) fn along_face(
    gear: &AsBuilt,
    ends: [f64; 2],
    range: Option<[f64; 2]>,
    (k, ball): (u32, f64),
) -> Option<FaceReadings> {
    if !gear.deviates_along_face() || ends[0] >= ends[1] {
        return None;
    }
    let face = OwnFace::new(gear, ends, range);
    let [from, to] = face.range;
    let heights = [from, 0.5 * (from + to), to];
    let at = heights.map(|height| gear.section_at(face.place(height)));
    let sections: Vec<SectionReadings> = (at.iter().zip(heights))
        .map(|(section, height)| {
            let work = Workpiece::new(section);
            SectionReadings {
                height,
                spans: spans(&work, k),
                runout: runout(&work, ball),
                eccentricity: eccentricity(&work),
            }
        })
        .collect();
    Some(FaceReadings {
        own: measure_leads(gear, &face, PitchAxis::Own),
        datum: measure_leads(gear, &face, PitchAxis::Datum),
        face_runout: face_runout(gear, &face, &sections[0], &sections[2]),
        sections,
    })
}

/// The axial runout from the readings of two sections.
fn face_runout(
    gear: &AsBuilt,
    face: &OwnFace,
    near: &SectionReadings,
    far: &SectionReadings,
) -> FaceRunout {
    let basic_data = gear.gear().basic_data();
    // Teeth wind along the axis; the frame of the measuring plane does not.
    let wound = |height: f64| basic_data.twist() * face.place(height);
    let centre = |read: &SectionReadings| {
        let found = &read.eccentricity;
        let direction = gear.tooth_angle(found.high_tooth) + wound(read.height);
        found.amount * Vector2::new(direction.cos(), direction.sin())
    };
    let diameter = 2.0 * basic_data.reference_radius();
    let per_height = diameter / (far.height - near.height);
    let off = (centre(far) - centre(near)) * per_height;
    let error = (near.eccentricity.error + far.eccentricity.error) * per_height;
    let angle = gear.face().ascending() * (off.y.atan2(off.x) - wound(0.0));
    let (amount, high_tooth) = if off.norm() > error {
        (off.norm(), basic_data.tooth_towards(angle))
    } else {
        (0.0, 1.0)
    };
    FaceRunout {
        amount,
        diameter,
        high_tooth,
        error,
    }
}

/// The leads of every flank of a gear about the axis of its teeth, which are between `ends`, mm from the measuring plane. The heights of the
/// evaluation range count from the reference face's end of the teeth (default: that of ISO 1328-1).
///
/// # Errors
/// A flank that the stylus leaves.
pub fn leads(
    gear: &AsBuilt,
    ends: [f64; 2],
    range: Option<[f64; 2]>,
) -> Result<LeadReadings, Unmeasured> {
    measure_leads(gear, &OwnFace::new(gear, ends, range), PitchAxis::Own)
}

/// Measures the lead of every flank about `axis`.
fn measure_leads(
    gear: &AsBuilt,
    face: &OwnFace,
    axis: PitchAxis,
) -> Result<LeadReadings, Unmeasured> {
    let heights = |[from, to]: [f64; 2]| {
        let step = move |k: usize| from + (to - from) * k as f64 / (POINTS - 1) as f64;
        (0..POINTS).map(step)
    };
    let all = heights([0.0, face.width()]).chain(heights(face.range));
    let all: Vec<f64> = all.collect();
    let sections = all.iter().map(|at| gear.section_at(face.place(*at)));
    let sections: Vec<AsBuilt> = sections.collect();
    let work = Workpiece::new(gear);
    let teeth = gear.gear().basic_data().teeth();
    let mut error = 0.0;
    let mut flank = |own: Flank| {
        let sense = gear.face().seen_from_front(own).sense();
        let read = parallel::map(1..=teeth, |tooth| {
            let (start, _) = turn(&work, gear, (own, tooth), axis)?;
            let mut worst = 0.0;
            let deviations = sections.iter().map(|section| {
                let (turn, error) = turn(&work, section, (own, tooth), axis)?;
                worst = f64::max(worst, 2.0 * error);
                // Material of the further turn, along the base tangent.
                Some(sense * (turn - start) * gear.gear().base_radius())
            });
            let deviations: Vec<f64> = deviations.collect::<Option<_>>()?;
            let points: Vec<(f64, f64)> = all.iter().copied().zip(deviations).collect();
            let (whole, within) = points.split_at(POINTS);
            Some((evaluate(whole.to_vec(), within), worst))
        });
        let mut shapes: Vec<TraceReading> = Vec::new();
        let mut of_tooth = Vec::new();
        for (tooth, found) in (1..).zip(read) {
            let Some((found, bound)) = found else {
                return Err(off_flank(own, tooth));
            };
            error = f64::max(error, bound);
            let is_alike = |one: &TraceReading| {
                let mut points = one.points.iter().zip(&found.points);
                points.all(|(one, other)| (one.1 - other.1).abs() <= ALIKE * bound)
            };
            let known = shapes.iter().position(is_alike);
            of_tooth.push(known.unwrap_or(shapes.len()));
            if known.is_none() {
                shapes.push(found);
            }
        }
        Ok(FlankTraces {
            evaluated: face.range,
            shapes,
            of_tooth,
        })
    };
    let flanks = [flank(Flank::Right)?, flank(Flank::Left)?];
    let hand = gear.gear().basic_data().hand();
    Ok(LeadReadings {
        axis,
        flanks,
        is_helical: hand.is_some(),
        hand: hand.unwrap_or(Hand::Right),
        width: face.width(),
        error,
    })
}

/// Angle of the own flank of `tooth` on the reference circle in a section, rad, from the tooth's undisturbed centre line, and its error as an
/// arc, mm; `None` off the flank.
fn turn(
    work: &Workpiece,
    section: &AsBuilt,
    (own, tooth): (Flank, u32),
    axis: PitchAxis,
) -> Option<(f64, f64)> {
    let side = section.face().seen_from_front(own);
    let (angle, error, point) = crossing(work, section, (side, tooth), axis)?;
    let rise = match axis {
        PitchAxis::Own => 0.0,
        PitchAxis::Datum => {
            let along = UnitComplex::new(-section.tooth_angle(f64::from(tooth)));
            (along * section.lean(0.0)).dot(&point.coords)
        }
    };
    let lead = section.lead_change(side, tooth, [0.0, rise]);
    let gear = section.gear();
    let tilted = angle + gear.basic_data().twist() * rise;
    Some((tilted + side.sense() * lead / gear.base_radius(), error))
}
