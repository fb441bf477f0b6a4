//! A gear placed in the picture: its centre, its teeth, its outline near a point.

use super::{AsBuilt, HalfTooth, ProfilePart, Segment, Side};
use nalgebra::{Point2, UnitComplex, Vector2};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// A gear on its axis at a rotation.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a> {
    as_built: &'a AsBuilt,
    axis: Point2<f64>,
    tooth_1: f64,
}

impl<'a> Placed<'a> {
    /// The gear `as_built` on `axis` (mm), with the undisturbed centre of tooth 1 in the direction `tooth_1`, rad.
    pub fn new(as_built: &'a AsBuilt, axis: Point2<f64>, tooth_1: f64) -> Placed<'a> {
        Placed {
            as_built,
            axis,
            tooth_1,
        }
    }

    /// The gear.
    pub fn as_built(&self) -> &'a AsBuilt {
        self.as_built
    }

    /// This gear turned by another `angle`, rad.
    pub fn turned(&self, angle: f64) -> Placed<'a> {
        Placed::new(self.as_built, self.axis, self.tooth_1 + angle)
    }

    /// Rotation axis, mm.
    pub fn axis(&self) -> Point2<f64> {
        self.axis
    }

    /// Centre of the outline, mm, at the distance of the eccentricity from the axis.
    pub fn centre(&self) -> Point2<f64> {
        self.axis + self.as_built.displacement(self.tooth_1)
    }

    /// Direction of a tooth's undisturbed centre as seen from [`Placed::centre`], rad.
    pub fn direction(&self, tooth: u32) -> f64 {
        self.tooth_1 + self.as_built.tooth_angle(f64::from(tooth))
    }

    /// The teeth that reach into the disc of radius `reach` (mm) about `place`, and a few more, counter-clockwise.
    ///
    /// All `z` teeth if the disc contains the centre or surrounds it.
    pub fn teeth_near(&self, place: Point2<f64>, reach: f64) -> Vec<u32> {
        let basic_data = self.as_built.gear().basic_data();
        let seen = (place - self.centre(), self.tooth_1);
        let steps = steps_near(seen, reach, basic_data.angular_pitch(), basic_data.teeth());
        let tooth = |step| self.as_built.counter_clockwise(1, step);
        steps.map(tooth).collect()
    }

    /// A closed counter-clockwise polygon, mm, equal to the gear's metal within the disc of radius `reach` about `place`.
    ///
    /// Every chord is within `chordal_error` mm of its curve. With fewer than all teeth, the polygon closes through the gear's
    /// centre, outside the disc.
    pub fn outline_near(
        &self,
        place: Point2<f64>,
        reach: f64,
        chordal_error: f64,
    ) -> Vec<Point2<f64>> {
        let teeth = self.teeth_near(place, reach);
        let mut outline = Vec::new();
        for &tooth in &teeth {
            // Each half ends in the middle of the space as built, where the next begins.
            let half = |side| {
                let land = self.root_land(side, tooth, chordal_error);
                let above = self.above_root(side, tooth, chordal_error);
                [&above, land.get(1..).unwrap_or_default()].concat()
            };
            let points = half(Side::Right);
            outline.extend(points.iter().rev().map(self.place(Side::Right, tooth)));
            let points = half(Side::Left);
            outline.extend(points.iter().map(self.place(Side::Left, tooth)));
        }
        if teeth.len() < self.as_built.gear().basic_data().teeth() as usize {
            outline.push(self.centre());
        }
        outline
    }

    /// A flank from the tip corner to the root land: involute and fillet, mm, chords within `chordal_error` mm.
    pub fn flank(&self, side: Side, tooth: u32, chordal_error: f64) -> Vec<Point2<f64>> {
        let half = HalfTooth::new(&self.as_built.profile(side, tooth), side, chordal_error);
        let is_land = |segment: &Segment| segment.curve.is_land();
        let segments = half.segments();
        let first = segments.iter().take_while(|s| is_land(s)).count();
        let last = segments.len() - segments.iter().rev().take_while(|s| is_land(s)).count();
        let points = half.points()[first..=last].iter();
        points.map(self.place(side, tooth)).collect()
    }

    /// One curve of a flank, tip end first, mm, chords within `chordal_error` mm; empty without length.
    pub fn curve(
        &self,
        side: Side,
        tooth: u32,
        curve: ProfilePart,
        chordal_error: f64,
    ) -> Vec<Point2<f64>> {
        if curve == ProfilePart::Root {
            let land = self.root_land(side, tooth, chordal_error);
            return land.iter().map(self.place(side, tooth)).collect();
        }
        let half = HalfTooth::new(&self.as_built.profile(side, tooth), side, chordal_error);
        let segments = half.segments();
        let Some(first) = segments.iter().position(|s| s.curve == curve) else {
            return Vec::new();
        };
        let own = segments[first..].iter().take_while(|s| s.curve == curve);
        let count = own.count();
        let points = half.points()[first..=first + count].iter();
        points.map(self.place(side, tooth)).collect()
    }

    /// A half tooth down to its root land, in its own frame. The right half has the whole tip land.
    ///
    /// Pitch deviations may leave the middle of the land to neither half. One owner keeps the outline from running back there.
    fn above_root(&self, side: Side, tooth: u32, chordal_error: f64) -> Vec<Point2<f64>> {
        let profile = self.as_built.profile(side, tooth);
        let start = match side {
            Side::Right => self.as_built.land_start(side, tooth),
            Side::Left => profile.range(ProfilePart::Tip).1,
        };
        HalfTooth::from_land(&profile, side, chordal_error, start)
    }

    /// The root land up to the middle of the space as built, in the half tooth's frame; empty in a space closed at its root.
    fn root_land(&self, side: Side, tooth: u32, chordal_error: f64) -> Vec<Point2<f64>> {
        let profile = self.as_built.profile(side, tooth);
        HalfTooth::root_land(
            &profile,
            side,
            chordal_error,
            self.as_built.root_end(side, tooth),
        )
    }

    /// Transformation from the frame of the half tooth on `side` to the picture.
    fn place(&self, side: Side, tooth: u32) -> impl Fn(&Point2<f64>) -> Point2<f64> + use<> {
        let offset = self.as_built.flank_offset(side, tooth);
        let turn = UnitComplex::new(self.direction(tooth) + offset);
        let centre = self.centre();
        move |point| centre + turn * point.coords
    }
}

/// Counter-clockwise steps from tooth 1 to the teeth that reach into the disc of radius `reach` (mm) about a place, and a few more.
///
/// `place` counts from the gear's centre, and tooth 1 points in the direction `tooth_1` (rad). All `teeth` if the disc contains the
/// centre or surrounds it.
pub(crate) fn steps_near(
    (place, tooth_1): (Vector2<f64>, f64),
    reach: f64,
    pitch: f64,
    teeth: u32,
) -> RangeInclusive<i64> {
    let distance = place.norm();
    // Two more pitches: half a tooth, half a pitch of flank deviation, and one in reserve.
    let half_angle = if distance > reach {
        (reach / distance).asin() + 2.0 * pitch
    } else {
        PI
    };
    let teeth = i64::from(teeth);
    if half_angle >= PI {
        return 0..=teeth - 1;
    }
    let from_1 = place.y.atan2(place.x) - tooth_1;
    let first = ((from_1 - half_angle) / pitch).ceil() as i64;
    let last = ((from_1 + half_angle) / pitch).floor() as i64;
    first..=last.min(first + teeth - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign, Profile};

    /// The outline of a tooth thinner by more than half its land stays between its two tip corners. Source: the mean land's half
    /// angle turned with each flank.
    #[test]
    fn a_thin_tooth_has_no_land_beyond_its_corners() {
        let design = GearDesign::plain(20, 2.0);
        let gear = design.gear();
        let (_, half) = Profile::new(&gear).range(ProfilePart::Tip);
        let mut per_tooth = vec![0.0; 20];
        // Three quarters of the land, at the reference circle.
        per_tooth[2] = -1.5 * half * gear.basic_data().reference_radius();
        let deviations = Deviations {
            per_tooth,
            ..Deviations::default()
        };
        let built = design.built(Face::Back, &deviations);
        let placed = Placed::new(&built, Point2::origin(), 0.0);
        assert!(built.land_start(Side::Right, 3) > 0.0);
        let corner = |side: Side| built.flank_offset(side, 3) + side.sense() * half;
        let (right, left) = (corner(Side::Right), corner(Side::Left));
        let tip = built.gear().tip_radius();
        let mut met = 0;
        for point in placed.outline_near(Point2::origin(), 2.0 * tip, 1e-4) {
            let off = point.y.atan2(point.x) - placed.direction(3);
            let off = off - 2.0 * PI * (off / (2.0 * PI)).round();
            if point.coords.norm() > tip - 1e-9 && off.abs() < PI / 20.0 {
                let is_between = off > right - 1e-12 && off < left + 1e-12;
                assert!(is_between, "{right} {off} {left}");
                met += 1;
            }
        }
        assert!(met >= 2);
    }
}
