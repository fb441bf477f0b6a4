//! The half tooth all teeth of a gear share, in a form that is quick to evaluate.
//!
//! The same four curves and parameters as [`crate::gear::Profile`], written for
//! the right-hand half in complex numbers, point and normal from one sine and
//! cosine; a unit test holds the two together. The left-hand half is the mirror
//! image, and the exact method solves the left side as the mirrored right side.

use crate::gear::{Gear, ProfilePart, involute};
use nalgebra::Complex;
use std::f64::consts::PI;

/// Point or vector of the plane.
pub(super) type C = Complex<f64>;

/// `e^{i angle}`.
pub(super) fn turn(angle: f64) -> C {
    let (sin, cos) = angle.sin_cos();
    C::new(cos, sin)
}

/// A point of a curve, mm, and the unit normal there, out of the metal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub point: C,
    pub normal: C,
}

/// The right-hand half tooth, its centre line on +x.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    pub base: f64,
    pub half_base: f64,
    pub tip_radius: f64,
    pub root_radius: f64,
    pub tip_roll: f64,
    pub form_roll: f64,
    tip_half_angle: f64,
    /// `r`.
    pub pitch_radius: f64,
    /// `h_0`.
    pub depth: f64,
    /// `ρ`.
    pub round: f64,
    root_angle: f64,
    pub fillet_end: f64,
    half_pitch: f64,
    /// Whether the fillet meets the involute in an edge.
    undercut: bool,
    /// The joint of involute and fillet.
    pub joint: C,
    /// The involute's normal at the tip corner.
    pub tip_normal: C,
    corners: [(f64, C); 2],
}

impl Shape {
    pub fn new(gear: &Gear) -> Shape {
        let (basic_data, rack, fillet) = (gear.basic_data(), &gear.design().rack, gear.fillet());
        let module = basic_data.module();
        let mut shape = Shape {
            base: gear.base_radius(),
            half_base: gear.half_base_angle(),
            tip_radius: gear.tip_radius(),
            root_radius: gear.root_radius(),
            tip_roll: gear.tip_roll(),
            form_roll: gear.form_roll(),
            tip_half_angle: gear.half_angle_at_roll(gear.tip_roll()),
            pitch_radius: basic_data.reference_radius(),
            depth: (rack.dedendum() - rack.root_radius() - gear.generating_shift()) * module,
            round: rack.root_radius() * module,
            root_angle: fillet.root_angle(),
            fillet_end: fillet.end(),
            half_pitch: PI / f64::from(basic_data.teeth()),
            undercut: fillet.end() < PI / 2.0 - basic_data.pressure_angle(),
            joint: C::ZERO,
            tip_normal: C::ZERO,
            corners: [(0.0, C::ZERO); 2],
        };
        shape.corners = [shape.tip_roll, shape.form_roll]
            .map(|roll| (roll, shape.at(ProfilePart::Involute, roll).point));
        shape.joint = shape.corners[1].1;
        shape.tip_normal = shape.at(ProfilePart::Involute, shape.tip_roll).normal;
        shape
    }

    /// Rolls and points of the corners: the tip's, and the joint where it is an edge.
    pub fn corners(&self) -> &[(f64, C)] {
        &self.corners[..1 + usize::from(self.undercut)]
    }

    /// Parameters of a curve's two ends, the lesser first. Equal ends: the curve has no length.
    pub fn range(&self, curve: ProfilePart) -> (f64, f64) {
        match curve {
            ProfilePart::Tip => (0.0, self.tip_half_angle),
            ProfilePart::Involute => (self.form_roll, self.tip_roll),
            ProfilePart::Fillet => (0.0, self.fillet_end),
            ProfilePart::Root => (-self.root_angle, self.half_pitch),
        }
    }

    /// Point and normal of `curve` at parameter `t`.
    pub fn at(&self, curve: ProfilePart, t: f64) -> Sample {
        match curve {
            ProfilePart::Tip | ProfilePart::Root => {
                let normal = turn(-t);
                let radius = if curve == ProfilePart::Tip {
                    self.tip_radius
                } else {
                    self.root_radius
                };
                Sample {
                    point: normal * radius,
                    normal,
                }
            }
            // P = r_b E (1 − iξ), n = −iE.
            ProfilePart::Involute => {
                let e = turn(t - self.half_base);
                let normal = C::new(e.im, -e.re);
                Sample {
                    point: (e + normal * t) * self.base,
                    normal,
                }
            }
            // P = E (r − L e^{−iγ}), n = E e^{−iγ}, E = e^{i(root − h_0 tan γ/r)}, L = h_0/cos γ + ρ.
            ProfilePart::Fillet => {
                let (sin, cos) = t.sin_cos();
                let e = turn(self.root_angle - self.depth * sin / (cos * self.pitch_radius));
                let normal = e * C::new(cos, -sin);
                Sample {
                    point: e * self.pitch_radius - normal * (self.depth / cos + self.round),
                    normal,
                }
            }
        }
    }

    /// `(d, w)`: every point of `curve` with parameter in `[low, high]` lies within `d` of the middle
    /// one, and its normal within the angle `w` of the middle one's.
    ///
    /// `d` is the length of the longer half, `w` the turn of the normal over it.
    /// Involute: length `r_b ξ²/2`, turn `ξ`. Fillet: `dP/dγ = S`, turn `q`
    /// ([`crate::gear::Fillet`]); both rise with `γ` once `h_0` is taken by its amount.
    pub fn spread(&self, curve: ProfilePart, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        match curve {
            ProfilePart::Tip => (self.tip_radius * half, half),
            ProfilePart::Root => (self.root_radius * half, half),
            ProfilePart::Involute => (0.5 * self.base * half * (high + 0.5 * (low + high)), half),
            ProfilePart::Fillet => {
                let c = 1.0 / high.cos();
                let depth = self.depth.abs();
                let lift = depth * c * c / self.pitch_radius;
                let speed = self.round + lift * (self.round + depth * c);
                (speed * half, (1.0 + lift) * half)
            }
        }
    }

    /// `dP/dt = i n · speed`, with its sign.
    pub fn speed(&self, curve: ProfilePart, t: f64) -> f64 {
        match curve {
            ProfilePart::Tip => -self.tip_radius,
            ProfilePart::Root => -self.root_radius,
            // dP/dξ = r_b ξ E = r_b ξ · i n.
            ProfilePart::Involute => self.base * t,
            ProfilePart::Fillet => {
                let c = 1.0 / t.cos();
                let lift = self.depth * c * c / self.pitch_radius;
                self.round + lift * (self.round + self.depth * c)
            }
        }
    }

    /// Greatest amount of the angle `ψ` between fillet and radius from `gamma` up, rad.
    ///
    /// `tan ψ = (r cos γ − L)/(r sin γ)`, whose derivative has the sign of `g = −r + ρ cos γ + h_0 (1 − tan² γ)`. For
    /// `h_0 ≥ 0` that is at most `−r + ρ + h_0 = −r_f`: `ψ` falls, below 0 where an undercut flank hangs over. For `h_0 < 0`
    /// `g` has a slope of the sign of `2|h_0|/cos³ γ − ρ`, so that it falls and then rises, from below 0 on: `ψ` is greatest
    /// at an end, and not negative where `r cos γ ≥ ρ`.
    pub fn steepest_fillet(&self, gamma: f64) -> f64 {
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
    pub fn radius(&self, curve: ProfilePart, t: f64) -> f64 {
        match curve {
            ProfilePart::Tip => self.tip_radius,
            ProfilePart::Root => self.root_radius,
            ProfilePart::Involute => self.base * (1.0 + t * t).sqrt(),
            ProfilePart::Fillet => self.at(curve, t).point.norm_sqr().sqrt(),
        }
    }

    /// Whether it is a point without one normal: the tip corner or an undercut joint. Where a land ends is the
    /// placed tooth's to know.
    pub fn is_corner(&self, (curve, t): (ProfilePart, f64)) -> bool {
        match curve {
            ProfilePart::Tip | ProfilePart::Root => false,
            ProfilePart::Involute => t >= self.tip_roll || self.undercut && t <= self.form_roll,
            ProfilePart::Fillet => self.undercut && t >= self.fillet_end,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{BasicGearData, BasicRack, GearDesign, Profile, Side};

    /// The two ways of writing the curves agree, undercut and `h_0 < 0` included.
    #[test]
    fn the_curves_are_those_of_the_profile() {
        for (teeth, shift) in [(9, -0.1), (44, 0.0), (200, 1.2)] {
            let gear = Gear::nominal(GearDesign {
                basic_data: BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap(),
                profile_shift: shift,
                rack: BasicRack::ISO_53_A,
                tip_diameter: None,
            })
            .unwrap();
            let (shape, profile) = (Shape::new(&gear), Profile::new(&gear));
            assert_eq!(shape.undercut, teeth == 9);
            for curve in ProfilePart::ALL {
                let (low, high) = shape.range(curve);
                for k in 0..=10 {
                    let t = low + (high - low) * f64::from(k) / 10.0;
                    let sample = shape.at(curve, t);
                    let point = profile.point(curve, t, Side::Right);
                    let normal = profile.normal(curve, t, Side::Right);
                    let near = 1e-13 * gear.tip_radius();
                    assert!((sample.point - C::new(point.x, point.y)).norm() < near);
                    assert!((sample.normal - C::new(normal.x, normal.y)).norm() < 1e-13);
                    assert!((shape.radius(curve, t) - sample.point.norm()).abs() < near);
                    // dP/dt = i n · speed, by a central difference.
                    let step = 1e-5;
                    let rise = shape.at(curve, t + step).point - shape.at(curve, t - step).point;
                    let slope = C::i() * sample.normal * shape.speed(curve, t);
                    assert!((rise / (2.0 * step) - slope).norm() < 1e-6 * gear.tip_radius());
                    let (reach, bend) = shape.spread(curve, low, high);
                    let middle = shape.at(curve, 0.5 * (low + high));
                    assert!((sample.point - middle.point).norm() <= reach * (1.0 + 1e-12));
                    let turned = (sample.normal * middle.normal.conj()).arg().abs();
                    assert!(turned <= bend * (1.0 + 1e-12) + 1e-15);
                }
            }
        }
    }
}
