//! Gears with multiplied deviations, large enough to see, beside the perfect ones.
//!
//! For pictures only. The gears are at a pose's nominal rotations, and their outlines are not in contact.

use crate::error::GearError;
use crate::gear::{AsBuilt, HalfTooth, Placed, Side};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::Point2;

/// The measured deviations of one gear. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredOnGear {
    /// Eccentricity `e`, and the tooth in its direction.
    pub eccentricity: (f64, f64),
    /// Least and greatest offset of any flank from the perfect gear, along the reference circle, plus = more metal.
    pub flanks: [f64; 2],
    /// Least and greatest profile deviation of any flank, plus = more metal; `None` for involutes.
    pub profile: Option<[f64; 2]>,
}

/// Both gears, exaggerated and perfect.
#[derive(Debug, Clone)]
pub struct Exaggeration<'a> {
    assembly: &'a GearPair,
    factor: f64,
    drawn: [AsBuilt; 2],
    perfect: [AsBuilt; 2],
}

impl<'a> Exaggeration<'a> {
    /// The gears of `assembly` with their deviations `factor` times as large.
    ///
    /// # Errors
    /// As [`AsBuilt::exaggerated`].
    pub fn new(assembly: &'a GearPair, factor: f64) -> Result<Exaggeration<'a>, GearError> {
        let both = |factor: f64| -> Result<[AsBuilt; 2], GearError> {
            let [wheel, pinion] = Member::BOTH.map(|m| assembly.gear(m).exaggerated(factor));
            Ok([wheel?, pinion?])
        };
        Ok(Exaggeration {
            assembly,
            factor,
            drawn: both(factor)?,
            perfect: both(0.0)?,
        })
    }

    /// The factor of the deviations.
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// One gear at the nominal rotation of `pose`: exaggerated, and perfect.
    pub fn placed(&self, pose: &Pose, member: Member) -> [Placed<'_>; 2] {
        let rotation = pose.rotation(self.assembly, member);
        let tooth_1 = self.assembly.mate_direction(member) + rotation;
        let which = usize::from(member == Member::Pinion);
        [&self.drawn[which], &self.perfect[which]]
            .map(|gear| Placed::new(gear, self.assembly.axis(member), tooth_1))
    }

    /// The outline of a gear of [`Exaggeration::placed`], as [`Placed::outline_near`], without the loops where
    /// exaggerated neighbouring fillets cross.
    pub fn outline_near(
        placed: &Placed,
        place: Point2<f64>,
        reach: f64,
        chordal_error: f64,
    ) -> Vec<Point2<f64>> {
        let half = HalfTooth::new(
            &placed.as_built().profile(Side::Right, 1),
            Side::Right,
            chordal_error,
        );
        let outline = placed.outline_near(place, reach, chordal_error);
        without_loops(outline, half.points().len())
    }

    /// The measured deviations of one gear.
    pub fn found(&self, member: Member) -> MeasuredOnGear {
        let teeth = 1..=self.assembly.teeth(member);
        let places = teeth.flat_map(|tooth| self.flanks_of(member, tooth));
        let (least, most) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |range, place| {
            (range.0.min(place), range.1.max(place))
        });
        let gear = self.assembly.gear(member);
        MeasuredOnGear {
            eccentricity: (gear.eccentricity(), gear.high_tooth()),
            flanks: [least, most],
            profile: profile(gear),
        }
    }

    /// Offsets of a tooth's right and left flank from their perfect places, mm along the reference circle, plus = more metal.
    pub fn flanks_of(&self, member: Member, tooth: u32) -> [f64; 2] {
        let drawn = &self.drawn[usize::from(member == Member::Pinion)];
        let radius = drawn.gear().basic_data().reference_radius();
        Side::BOTH.map(|side| side.sense() * drawn.flank_offset(side, tooth) * radius / self.factor)
    }
}

/// Least and greatest profile deviation of `gear`, mm; `None` for involutes.
fn profile(gear: &AsBuilt) -> Option<[f64; 2]> {
    let all = Side::BOTH.iter().flat_map(|side| gear.deviations(*side));
    let both = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
    gear.is_modified().then(|| all.reduce(both))?
}

/// `points` without the loops of up to `longest` chords in the open line through them.
fn without_loops(points: Vec<Point2<f64>>, longest: usize) -> Vec<Point2<f64>> {
    let mut kept = Vec::with_capacity(points.len());
    let mut from = 0;
    while from + 1 < points.len() {
        kept.push(points[from]);
        let here = [points[from], points[from + 1]];
        let last = (from + longest).min(points.len() - 2);
        // The far end first: it removes the inner loops too.
        let crossing = (from + 2..=last)
            .rev()
            .find_map(|to| Some((to, crossing(here, [points[to], points[to + 1]])?)));
        from = match crossing {
            Some((to, at)) => {
                kept.push(at);
                to + 1
            }
            None => from + 1,
        };
    }
    kept.extend(points.get(from));
    kept
}

/// The intersection of two segments, excluding their ends.
fn crossing(a: [Point2<f64>; 2], b: [Point2<f64>; 2]) -> Option<Point2<f64>> {
    let beside =
        |line: &[Point2<f64>; 2], point: Point2<f64>| (line[1] - line[0]).perp(&(point - line[0]));
    let of_a = a.map(|end| beside(&b, end));
    let of_b = b.map(|end| beside(&a, end));
    let cross = of_a[0] * of_a[1] < 0.0 && of_b[0] * of_b[1] < 0.0;
    cross.then(|| a[0] + (a[1] - a[0]) * (of_a[0] / (of_a[0] - of_a[1])))
}
