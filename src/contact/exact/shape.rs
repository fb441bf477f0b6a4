//! The half tooth all teeth of a gear share: its parts in complex numbers, and what the direct solver knows of involute and fillet.
//!
//! The left-hand half is the mirror image, and the exact method solves the left side as the mirrored right side.

use super::flank_heights::FlankHeights;
use super::flank_pieces::FlankPieces;
use crate::gear::{Fillet, Part, PartCurve, Profile, ProfilePart, involute};
use std::f64::consts::PI;
use std::sync::OnceLock;

pub(super) use crate::contact::gap::{C, CurvePoint, turn};

/// The right-hand half tooth, its centre line on +x.
#[derive(Debug, Clone)]
pub(in crate::contact) struct HalfToothShape {
    /// From the tip to the root.
    parts: [Part; 4],
    // What follows, down to the corners, is about involute and fillet of a half tooth that a rack generates.
    pub base: f64,
    pub half_base: f64,
    pub tip_radius: f64,
    pub root_radius: f64,
    pub tip_roll: f64,
    pub form_roll: f64,
    /// `r`.
    pub pitch_radius: f64,
    pub fillet: Fillet,
    /// `h_0`.
    pub depth: f64,
    /// `ρ`.
    pub round: f64,
    pub fillet_end: f64,
    /// The joint of involute and fillet.
    pub joint: C,
    /// The involute's normal at the tip corner.
    pub tip_normal: C,
    corners: [(f64, C); 2],
    /// Whether its flank lies on one side of each of its tangents.
    pub is_convex: bool,
    /// Greatest tilt of its flank's normal by a deviation, rad.
    pub tilt: f64,
    /// Its flank in pieces, once a pair asks for them.
    pieces: OnceLock<Box<FlankPieces>>,
    /// How far it stands out, likewise; `None` of what has edges or is no involute.
    heights: OnceLock<Option<Box<FlankHeights>>>,
}

impl HalfToothShape {
    pub fn new(profile: &Profile) -> HalfToothShape {
        let gear = profile.gear();
        let (basic_data, fillet) = (gear.basic_data(), gear.fillet());
        let mut shape = HalfToothShape {
            parts: ProfilePart::ALL.map(|part| profile.part(part).clone()),
            base: gear.base_radius(),
            half_base: gear.half_base_angle(),
            tip_radius: gear.tip_radius(),
            root_radius: gear.root_radius(),
            tip_roll: gear.tip_roll(),
            form_roll: gear.form_roll(),
            pitch_radius: basic_data.reference_radius(),
            fillet: *fillet,
            depth: fillet.depth(),
            round: fillet.tip_round(),
            fillet_end: fillet.end(),
            joint: C::ZERO,
            tip_normal: C::ZERO,
            corners: [(0.0, C::ZERO); 2],
            is_convex: true,
            tilt: 0.0,
            pieces: OnceLock::new(),
            heights: OnceLock::new(),
        };
        if let PartCurve::Modified(flank) = &profile.part(ProfilePart::Involute).curve {
            let (low, high) = shape.range(ProfilePart::Involute);
            shape.is_convex = flank.is_convex(low, high);
            shape.tilt = flank.tilt(low, high);
        }
        shape.corners = [shape.tip_roll, shape.form_roll]
            .map(|roll| (roll, shape.at(ProfilePart::Involute, roll).point));
        shape.joint = shape.corners[1].1;
        shape.tip_normal = shape.at(ProfilePart::Involute, shape.tip_roll).normal;
        shape
    }

    /// Its flank in pieces.
    pub(super) fn flank_pieces(&self) -> &FlankPieces {
        let part = self.part(ProfilePart::Involute);
        self.pieces.get_or_init(|| Box::new(FlankPieces::new(part)))
    }

    /// How far its flank stands out; `None` of one that has edges or is no involute.
    pub(super) fn flank_heights(&self) -> Option<&FlankHeights> {
        let part = self.part(ProfilePart::Involute);
        let heights = || FlankHeights::new(part).map(Box::new);
        self.heights.get_or_init(heights).as_deref()
    }

    /// One of its parts.
    pub fn part(&self, part: ProfilePart) -> &Part {
        &self.parts[part as usize]
    }

    /// The curve of a part.
    #[inline]
    pub fn curve(&self, part: ProfilePart) -> &PartCurve {
        &self.part(part).curve
    }

    /// Rolls and points of the corners: the tip's, and the joint where it is an edge.
    pub fn corners(&self) -> &[(f64, C)] {
        let undercut = self.part(ProfilePart::Fillet).corners[0];
        &self.corners[..1 + usize::from(undercut)]
    }

    /// Whether its flank has no deviation at a roll.
    pub fn is_undeviating(&self, roll: f64) -> bool {
        match &self.part(ProfilePart::Involute).curve {
            PartCurve::Modified(flank) => flank.deviation().at(roll) == 0.0,
            PartCurve::Involute(_) => true,
            _ => false,
        }
    }

    /// Least radius of curvature of its flank from a roll outwards, mm: 0 where it has an edge there, or bulges no more.
    pub fn least_bend_radius(&self, roll: f64) -> f64 {
        let part = self.part(ProfilePart::Involute);
        let (_, high) = part.range();
        match &part.curve {
            PartCurve::Modified(_) if roll >= high => self.base * high,
            PartCurve::Modified(flank) => flank.least_bend_radius(roll, high),
            _ => self.base * roll,
        }
    }

    /// The corner of an undeviating flank and the tip land.
    #[inline]
    pub fn tip_corner(&self) -> C {
        self.corners[0].1
    }

    /// Parameters of a part's two ends, the lesser first. Equal ends: the part has no length.
    pub fn range(&self, part: ProfilePart) -> (f64, f64) {
        self.part(part).range()
    }

    /// Point and normal of `part` at parameter `t`.
    #[inline]
    pub fn at(&self, part: ProfilePart, t: f64) -> CurvePoint {
        let (point, normal) = self.part(part).curve.at(t);
        CurvePoint {
            point: C::new(point.x, point.y),
            normal: C::new(normal.x, normal.y),
        }
    }

    /// Greatest amount of the angle `ψ` between fillet and radius from `gamma` up, rad.
    ///
    /// `tan ψ = (r cos γ − L)/(r sin γ)`, whose derivative has the sign of `g = −r + ρ cos γ + h_0 (1 − tan² γ)`. For
    /// `h_0 ≥ 0` that is at most `−r + ρ + h_0 = −r_f`: `ψ` falls, below 0 where an undercut flank hangs over. For `h_0 < 0`
    /// `g` has a slope of the sign of `2|h_0|/cos³ γ − ρ`, so that it falls and then rises, from below 0 on: `ψ` is greatest
    /// at an end, and not negative where `r cos γ ≥ ρ`.
    pub fn steepest_fillet(&self, gamma: f64) -> f64 {
        if self.fillet.is_elliptic() {
            return self.fillet.steepest(gamma);
        }
        if self.depth < 0.0 && self.pitch_radius * self.fillet_end.cos() < self.round {
            return PI / 2.0;
        }
        let psi = |gamma: f64| {
            let sample = self.at(ProfilePart::Fillet, gamma);
            let z = sample.normal.conj() * sample.point;
            z.re.atan2(z.im.abs())
        };
        psi(gamma).max(psi(self.fillet_end).abs())
    }

    /// Root form radius.
    pub fn form_radius(&self) -> f64 {
        involute::radius_at(self.form_roll, self.base)
    }

    /// Radius about the gear's own centre, mm.
    pub fn radius(&self, part: ProfilePart, t: f64) -> f64 {
        self.part(part).curve.radius(t)
    }

    /// Whether it is a point without one normal: the tip corner or an undercut joint. Where a land ends is the
    /// placed tooth's to know.
    pub fn is_corner(&self, (part, t): (ProfilePart, f64)) -> bool {
        self.part(part).is_corner(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{BasicGearData, BasicRack, Gear, GearDesign, Hand};

    /// The amount of the angle between fillet and radius at every thousandth: few teeth whose tool's round stands outside its
    /// pitch line, and ordinary and undercut ones; spur, and of helical gears, where 64 stretches bound it.
    #[test]
    fn no_fillet_is_steeper_than_the_steepest() {
        for (teeth, alpha_deg, helix_deg, shift, round) in [
            (3, 14.5f64, 0.0f64, 0.85, 0.55),
            (4, 14.5, 0.0, 0.95, 0.5),
            (3, 20.0, 0.0, 1.0, 0.4),
            (17, 20.0, 0.0, 0.0, 0.38),
            (9, 20.0, 0.0, 0.0, 0.38),
            (17, 20.0, 25.0, 0.0, 0.38),
            (9, 20.0, 8.0, 0.0, 0.38),
            (4, 20.0, 20.0, 1.0, 0.4),
        ] {
            let basic = BasicGearData::new(teeth, 1.0, alpha_deg.to_radians()).unwrap();
            let basic = basic
                .with_helix(helix_deg.to_radians(), Hand::Left)
                .unwrap();
            let design = GearDesign {
                profile_shift: shift,
                rack: BasicRack::new(1.0, 1.25, round).unwrap(),
                tip_diameter: (shift > 0.0).then_some(f64::from(teeth) + 2.0 * shift + 0.7),
                ..GearDesign::standard(basic)
            };
            let gear = Gear::nominal(design).unwrap();
            let shape = HalfToothShape::new(&Profile::new(&gear));
            let amount = |gamma: f64| {
                let sample = shape.at(ProfilePart::Fillet, gamma);
                let along = sample.normal * C::new(0.0, 1.0);
                let cos = (along.conj() * sample.point).re.abs() / sample.point.norm();
                cos.min(1.0).acos()
            };
            for from in [0.3, 0.6, 0.9] {
                let start = from * shape.fillet_end;
                let at = |k: u32| start + (shape.fillet_end - start) * f64::from(k) / 1000.0;
                let most = (0..=1000).map(|k| amount(at(k))).fold(0.0, f64::max);
                let steepest = shape.steepest_fillet(start);
                assert!(
                    steepest >= most - 1e-9,
                    "{teeth} {from}: {steepest}, {most}"
                );
                assert!(
                    helix_deg == 0.0 || steepest <= most + 0.06,
                    "{teeth} {from}"
                );
                if shape.depth >= 0.0 && helix_deg == 0.0 {
                    assert!(
                        steepest <= most + 1e-9,
                        "{teeth} {from}: {steepest}, {most}"
                    );
                }
            }
        }
    }
}
