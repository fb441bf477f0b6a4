//! The gear on the bench: its outline, cut coarsely, and finer where something touches.
//!
//! Equal teeth share two half teeth. A query uses the frame of the half tooth (see [`HalfTooth`]); the caller turns it there. A coarse
//! polygon selects the stretch that can touch. That stretch is cut again until chords are as near their curve as f64 allows.

use crate::contact::PolylineShape;
use crate::gear::{AsBuilt, HalfTooth, ProfilePart, Side, involute};
use nalgebra::{Point2, UnitComplex, Vector2};
use std::ops::Range;

/// Chordal error of the first polygons, modules (tuned: about thirty chords per half tooth).
const COARSE: f64 = 1e-3;
/// Factor of each finer cut: about thirty chords over the stretch (tuned, as in the polygon method).
const FINER: f64 = 1e-3;
/// Distance from the tip circle, mm, within which a place is the tip corner, and from the form circle, within which it
/// is the end of the involute. Other results use the same width.
const CORNER: f64 = 1e-7;

/// A contact on the outline, in the frame of its half tooth.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub at: Point2<f64>,
    pub curve: ProfilePart,
}

/// A gear as built, on the bench.
pub(super) struct Workpiece<'a> {
    pub as_built: &'a AsBuilt,
    /// Right and left half teeth, by shape ([`AsBuilt::shape_of`]).
    halves: [Vec<CutHalfTooth>; 2],
}

struct CutHalfTooth {
    whole: Polygon,
    /// Only its tip land and involute.
    flank: HalfTooth,
}

struct Polygon {
    half: HalfTooth,
    shape: PolylineShape,
}

impl Polygon {
    fn new(half: HalfTooth) -> Polygon {
        Polygon {
            shape: PolylineShape::new(half.points()),
            half,
        }
    }
}

impl<'a> Workpiece<'a> {
    pub fn new(as_built: &'a AsBuilt) -> Workpiece<'a> {
        let chordal_error = COARSE * as_built.gear().basic_data().module();
        let cut = |side, shape| {
            let profile = as_built.shape(side, shape);
            let half = HalfTooth::new(&profile, side, chordal_error);
            let above = |curve| matches!(curve, ProfilePart::Tip | ProfilePart::Involute);
            let segments = half.segments().iter();
            let count = segments.take_while(|s| above(s.curve)).count();
            CutHalfTooth {
                flank: half.recut(&profile, 0..count, chordal_error),
                whole: Polygon::new(half),
            }
        };
        Workpiece {
            as_built,
            halves: Side::BOTH.map(|side| {
                let shapes = 0..as_built.shapes(side);
                shapes.map(|shape| cut(side, shape)).collect()
            }),
        }
    }

    fn cut(&self, side: Side, tooth: u32) -> &CutHalfTooth {
        &self.halves[side.index()][self.as_built.shape_of(side, tooth)]
    }

    /// Chordal error of the finest polygons, mm: 64 ulps of the greatest radius, below which points are uncertain.
    fn finest(&self) -> f64 {
        64.0 * f64::EPSILON * self.as_built.reach()
    }

    /// Bound on the error of a place, mm: the finest chords plus the same for the rounding of coordinates and turns.
    pub fn bound(&self) -> f64 {
        2.0 * self.finest()
    }

    /// Rotation of the half tooth on `side` of `tooth` in a frame whose +x is `pitches` counter-clockwise of the
    /// undisturbed centre of `tooth`.
    pub fn turn(&self, side: Side, tooth: u32, pitches: f64) -> UnitComplex<f64> {
        let pitch = self.as_built.gear().basic_data().angular_pitch();
        UnitComplex::new(self.as_built.flank_offset(side, tooth) - pitches * pitch)
    }

    /// The middle of the tip land, in the frame of the half tooth on `side`.
    pub fn tip_land(&self, side: Side, tooth: u32) -> Point2<f64> {
        self.cut(side, tooth).whole.half.points()[0]
    }

    /// Start of the root land of the half tooth on `side`, in its frame; the end of the fillet without a land.
    pub fn root_end(&self, side: Side, tooth: u32) -> Point2<f64> {
        let polygon = &self.cut(side, tooth).whole.half;
        let mut segments = polygon.segments().iter();
        let land = segments.position(|segment| segment.curve == ProfilePart::Root);
        polygon.points()[land.unwrap_or(polygon.segments().len())]
    }

    /// The tooth `steps` ascending numbers after `tooth`.
    pub fn tooth_after(&self, tooth: u32, steps: u32) -> u32 {
        super::tooth_after(self.as_built.gear().basic_data().teeth(), tooth, steps)
    }

    /// Contact of a plane face of outward normal `along` that closes on the flank of `side` of `tooth`: tip land or involute.
    ///
    /// The face ends at the form circle. Vertices are on their curve, and chords within `δ` of it. A chord with both
    /// ends more than `δ` behind the foremost vertex is not in contact.
    pub fn foremost(&self, side: Side, tooth: u32, along: Vector2<f64>) -> Place {
        let profile = self.as_built.profile(side, tooth);
        let mut cut: Option<HalfTooth> = None;
        loop {
            let polygon = cut.as_ref().unwrap_or(&self.cut(side, tooth).flank);
            let points = polygon.points().iter();
            let ahead: Vec<f64> = points.map(|p| along.dot(&p.coords)).collect();
            let (mut best, mut most) = (0, f64::NEG_INFINITY);
            for (i, &value) in ahead.iter().enumerate() {
                if value > most {
                    (best, most) = (i, value);
                }
            }
            let chordal_error = polygon.chordal_error();
            if chordal_error <= self.finest() {
                let at = polygon.points()[best];
                let last = polygon.segments().len() - 1;
                let curve = polygon.segments()[best.min(last)].curve;
                return self.place(at, curve);
            }
            let near = |i: &usize| ahead[*i].max(ahead[*i + 1]) >= most - chordal_error;
            let window = stretch((0..polygon.segments().len()).filter(near));
            cut = Some(polygon.recut(&profile, window, (chordal_error * FINER).max(self.finest())));
        }
    }

    /// The nearest place to `point` on the half tooth of `side` of `tooth`, and its distance, mm.
    pub fn nearest(&self, side: Side, tooth: u32, point: Point2<f64>) -> (Place, f64) {
        let profile = self.as_built.profile(side, tooth);
        let mut cut: Option<Polygon> = None;
        loop {
            let on = cut.as_ref().unwrap_or(&self.cut(side, tooth).whole);
            let found = on.shape.nearest(&point);
            let chordal_error = on.half.chordal_error();
            if chordal_error <= self.finest() {
                let (curve, _) = on.half.locate(found.segment, &found.at);
                return (self.place(found.at, curve), found.distance);
            }
            // The curve is at most δ further away than its nearest chord, and any chord at most δ further than its curve.
            let window = on
                .shape
                .near_point(&point, found.distance + 2.0 * chordal_error);
            let finer = (chordal_error * FINER).max(self.finest());
            cut = Some(Polygon::new(on.half.recut(&profile, window, finer)));
        }
    }

    /// Intersection of the involute of `side` of `tooth` with the circle of `radius` about `centre`, and the error
    /// bound along that circle, mm; `None` if they do not intersect.
    ///
    /// If the chord moves by `δ` across, the intersection moves by `δ/cos` along the circle, where `cos` is between the chord's normal and
    /// the circle. On a chord of length `h` the squared distance is taken as linear: off by `h²/(8 radius)`, far below `δ`.
    pub fn crossing(
        &self,
        side: Side,
        tooth: u32,
        centre: Point2<f64>,
        radius: f64,
    ) -> Option<(Point2<f64>, f64)> {
        let excess = |p: &Point2<f64>| {
            let distance = (p - centre).norm();
            (distance - radius) * (distance + radius)
        };
        let (at, along) = self.crossing_on_flank(side, tooth, excess)?;
        let cos = along.dot(&(at - centre).normalize()).abs();
        Some((at, self.bound() / cos))
    }

    /// The place on the flank of `side` of `tooth`, from tip to root, at which `excess` falls below 0, and the
    /// direction of the finest chord there. `excess` must be almost linear along a chord. `None` if there is none.
    fn crossing_on_flank(
        &self,
        side: Side,
        tooth: u32,
        excess: impl Fn(&Point2<f64>) -> f64,
    ) -> Option<(Point2<f64>, Vector2<f64>)> {
        let profile = self.as_built.profile(side, tooth);
        let mut cut: Option<HalfTooth> = None;
        loop {
            let polygon = cut.as_ref().unwrap_or(&self.cut(side, tooth).flank);
            let points = polygon.points();
            let crosses = |i: &usize| {
                polygon.segments()[*i].curve == ProfilePart::Involute
                    && excess(&points[*i]) >= 0.0
                    && excess(&points[*i + 1]) < 0.0
            };
            let i = (0..polygon.segments().len()).find(crosses)?;
            if polygon.chordal_error() <= self.finest() {
                let ends = [excess(&points[i]), excess(&points[i + 1])];
                let chord = points[i + 1] - points[i];
                let at = points[i] + ends[0] / (ends[0] - ends[1]) * chord;
                return Some((at, chord.normalize()));
            }
            let finer = (polygon.chordal_error() * FINER).max(self.finest());
            cut = Some(polygon.recut(&profile, i..i + 1, finer));
        }
    }

    /// Position of the flank of `side` of `tooth` on the tangent to the base circle at the roll `xi`, mm from the point
    /// of tangency, with its error bound. `None` if the tangent does not meet the flank.
    ///
    /// An involute of the mean thickness in its undisturbed place is at `r_b ξ`. The tangent is nearly normal to the flank.
    pub fn along_tangent(&self, side: Side, tooth: u32, xi: f64) -> Option<(f64, f64)> {
        let gear = self.as_built.gear();
        let angle = xi - gear.half_base_angle();
        // The left half tooth is the mirror image.
        let mirror = -side.sense();
        let outward = Vector2::new(angle.cos(), mirror * angle.sin());
        let along = Vector2::new(angle.sin(), -mirror * angle.cos());
        let excess = |p: &Point2<f64>| outward.dot(&p.coords) - gear.base_radius();
        let (at, chord) = self.crossing_on_flank(side, tooth, excess)?;
        Some((
            along.dot(&at.coords),
            self.bound() / chord.dot(&outward).abs(),
        ))
    }

    /// Rolls of the ends of the flank of `side` of `tooth`, the lower first: those of the tangents through the ends.
    pub fn flank_rolls(&self, side: Side, tooth: u32) -> [f64; 2] {
        let polygon = &self.cut(side, tooth).flank;
        let gear = self.as_built.gear();
        let mut segments = polygon.segments().iter();
        let first = segments.position(|segment| segment.curve == ProfilePart::Involute);
        let points = polygon.points();
        [points[points.len() - 1], points[first.unwrap_or(0)]].map(|end| {
            let roll = involute::roll_at(end.coords.norm(), gear.base_radius());
            let angle = -side.sense() * end.y.atan2(end.x);
            angle + roll.atan() + gear.half_base_angle()
        })
    }

    /// Whether a place of the involute at `radius`, mm, is its lower end at the form circle.
    pub fn ends_involute(&self, radius: f64) -> bool {
        radius <= self.as_built.gear().form_radius() + CORNER
    }

    fn place(&self, at: Point2<f64>, curve: ProfilePart) -> Place {
        let on_tip_circle = at.coords.norm() >= self.as_built.gear().tip_radius() - CORNER;
        Place {
            at,
            curve: if on_tip_circle {
                ProfilePart::Tip
            } else {
                curve
            },
        }
    }
}

/// From the first to the last of `indices`, which ascend.
fn stretch(mut indices: impl DoubleEndedIterator<Item = usize>) -> Range<usize> {
    let first = indices.next().unwrap_or(0);
    first..indices.next_back().unwrap_or(first) + 1
}
