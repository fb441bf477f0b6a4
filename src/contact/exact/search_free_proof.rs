//! The pairs of curves that need no search.
//!
//! The polar gap of two half teeth is continuous over their common radii. Its slope over `ln ρ` is `σ_locked − σ_free`.
//! Where that vanishes, the second derivative has the sign of `−(κ_1 + κ_2)` (κ + for convex): the curves touch there
//! with opposite normals. So the greatest value is
//!
//! - on the line of action, where both are involutes (κ_1 + κ_2 > 0, one stationary point at most), or
//! - at a corner: the near tip corner of either gear, the joint of an undercut fillet (also an edge), or the far corner
//!   of a locked tip land if a free land that is not exactly round about its axis ends on it,
//!
//! for all pairs of curves that meet these conditions within reach of each other:
//!
//! 1. Both are monotone in `ρ` (the normal never meets the axis). A locked involute may turn back towards its tip. Behind
//!    the turn it has the same radii at lesser angles, and the gap rises from the turn on.
//! 2. A fillet is more hollow than the opposite involute is convex, and no fillet is convex. Then the gap has only minima
//!    there. (At a smooth joint the slopes agree, so a gap that rises towards it continues to rise.)
//! 3. A tip land is much rounder about the axis than the opposite curve. So the gap rises along it towards
//!    its near corner on either side of the line of centres.
//! 4. A root land is out of reach.
//!
//! The check holds for all poses, with the centre of the locked outline anywhere within its eccentricity `e_L` of its
//! axis. Pairs of curves that fail are *open*: branch and bound searches them.

use super::curves::CurvePairs;
use super::shape::HalfToothShape;
use super::teeth::Teeth;
use crate::gear::ProfilePart::{self, Fillet, Involute, Root, Tip};
use crate::gear::involute;
use crate::numeric::bisect_smooth;
use crate::pair::overlap_half_angle;
use std::f64::consts::{FRAC_PI_2, PI};

/// The properties of a pair of gears that hold at every pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct SearchFreeProof {
    /// Pairs of curves that must be searched.
    pub open: CurvePairs,
    /// Least `γ` of the locked and of the free fillet that can be reached; `None` if unreachable or searched.
    pub locked_fillet: Option<f64>,
    pub free_fillet: Option<f64>,
    /// Whether a locked involute can turn back.
    pub turns_back: bool,
    /// Whether a locked tip land can touch a free involute between its corners, or at the far one.
    pub tangents: bool,
    /// Limit of the tip's `X`: teeth up to it can touch a free tip land between its corners with their locked involute.
    pub steep_arm: Option<f64>,
}

impl SearchFreeProof {
    /// Whether no pose needs a search.
    pub fn is_direct(&self) -> bool {
        self.open.is_empty() && self.steep_arm.is_none()
    }
}

/// The half teeth of both gears, their eccentricities, and the centre distance.
pub(super) struct ProofInput<'a> {
    /// Without deviations.
    pub locked: &'a HalfToothShape,
    pub free: &'a HalfToothShape,
    /// With deviations.
    pub locked_teeth: &'a Teeth,
    pub free_teeth: &'a Teeth,
    pub locked_off: f64,
    pub free_off: f64,
    pub distance: f64,
}

impl ProofInput<'_> {
    /// The nearest position of the locked outline's centre: the widest lens and the least slopes.
    fn near(&self) -> f64 {
        self.distance - self.locked_off
    }

    /// Greatest radius of the free gear and least radius of the locked one about the free axis.
    fn outmost(&self) -> f64 {
        self.free.tip_radius + self.free_off
    }

    fn inmost(&self) -> f64 {
        self.near() - self.locked.tip_radius
    }

    /// The proof; `None` if even involutes need a search.
    pub fn prove(&self) -> Option<SearchFreeProof> {
        let (locked, free, near) = (self.locked, self.free, self.near());
        if !(self.inmost() > self.free_off && free.base > self.free_off) {
            return None;
        }
        let half = overlap_half_angle(locked.tip_radius, self.outmost(), near)?;
        // The free involute's arm X = Q × n is r_b + C·E with |C| = e_F. For the locked one E is at (polar angle) +
        // atan ξ from the line of centres, and X = D cos − r_b.
        if !(locked.base < near && half < (locked.base / near).acos()) {
            return None;
        }
        // The tilt of a normal shortens the arm by at most the tilt times the distance from the axis.
        let tilted = near * self.tilt();
        let arm = near * (half + locked.tip_roll.atan()).cos() - locked.base - tilted;
        if !(free.base - self.outmost() * self.tilt() > self.free_off) {
            return None;
        }

        let mut open = CurvePairs::default();
        let free_reach = reached(free, self.inmost() - self.free_off);
        let locked_reach = reached(locked, near - self.outmost());
        for curve in ProfilePart::ALL {
            open.add_unless(free_reach != ReachedDepth::Root, curve, Root);
            open.add_unless(locked_reach != ReachedDepth::Root, Root, curve);
        }
        let free_fillet = match free_reach {
            ReachedDepth::Fillet(gamma) if free.pitch_radius * gamma.sin() > self.free_off => {
                Some(gamma)
            }
            _ => None,
        };
        let fillet_arm = match locked_reach {
            ReachedDepth::Fillet(gamma) => self.fillet_arm(gamma).map(|arm| (gamma, arm)),
            _ => None,
        };
        // Conditions 1 and 2.
        let form_near = near - self.free_off;
        let free_good = free_reach == ReachedDepth::Involute
            || free_fillet.is_some_and(|gamma| {
                let mate = self.locked_teeth;
                hollow((free, gamma), mate, form_near - free.form_radius())
            });
        let locked_good = locked_reach == ReachedDepth::Involute
            || fillet_arm.is_some_and(|(gamma, _)| {
                let mate = self.free_teeth;
                hollow((locked, gamma), mate, form_near - locked.form_radius())
            });
        open.add_unless(free_good, Involute, Fillet);
        open.add_unless(locked_good, Fillet, Involute);
        open.add_unless(free_good && locked_good, Fillet, Fillet);
        // Condition 3.
        self.open_lands(&mut open, fillet_arm.map(|(_, arm)| arm), free_fillet);
        let level_arm = near * half.cos() - locked.base - tilted;
        open.add_unless(self.is_rounder_than(level_arm), Involute, Tip);
        if locked_reach != ReachedDepth::Involute && fillet_arm.is_none() && self.free_off > 0.0 {
            open.add(Fillet, Tip);
        }
        if free_reach != ReachedDepth::Involute && free_fillet.is_none() {
            open.add(Tip, Fillet);
        }
        Some(SearchFreeProof {
            open,
            locked_fillet: fillet_arm.map(|(gamma, _)| gamma),
            free_fillet,
            turns_back: !(arm > 1e-9 * near),
            tangents: !self.rises_on_involutes(half),
            steep_arm: (!self.is_rounder_than(arm)).then(|| self.least_round_arm()),
        })
    }

    /// Opens the pairs of curves whose tip land is not round enough about the axis.
    fn open_lands(&self, open: &mut CurvePairs, fillet_arm: Option<f64>, free_fillet: Option<f64>) {
        let (locked, free, near) = (self.locked, self.free, self.near());
        if let Some(gamma) = free_fillet {
            let steepest = slope_at(free.steepest_fillet(gamma) + self.shift());
            let within =
                overlap_half_angle(locked.tip_radius, free.form_radius() + self.free_off, near);
            open.add_unless(within.is_none_or(|b| steepest < self.land(b)), Tip, Fillet);
        }
        // The free land: X is D sin b on the locked land, where b is the angle at which it crosses the nearest free tip circle.
        if self.free_off == 0.0 {
            return;
        }
        let (tip, far) = (
            free.tip_radius - self.free_off,
            self.distance + self.locked_off,
        );
        let cos = (locked.tip_radius * locked.tip_radius + far * far - tip * tip)
            / (2.0 * far * locked.tip_radius);
        let crossing = if cos < 1.0 {
            near * cos.max(0.0).acos().sin()
        } else {
            0.0
        };
        open.add_unless(self.is_rounder_than(crossing), Tip, Tip);
        if let Some(arm) = fillet_arm {
            open.add_unless(self.is_rounder_than(arm), Fillet, Tip);
        }
    }

    /// Whether the gap rises along a locked land towards its near corner against every free involute.
    fn rises_on_involutes(&self, half: f64) -> bool {
        slope_at(self.free.tip_roll.atan() + self.shift()) < self.land(half)
    }

    /// `σ` of the locked land at the angle `b` from the line of centres: `(D cos b − r_a)/(D sin b)`, which falls with `b`.
    fn land(&self, b: f64) -> f64 {
        let near = self.near();
        (near * b.cos() - self.locked.tip_radius) / (near * b.sin())
    }

    /// Greatest change of `ψ`: `asin(e/ρ)` from an axis `e` away, plus the tilt of a deviating flank.
    fn shift(&self) -> f64 {
        (self.free_off / self.inmost()).asin() + self.tilt()
    }

    /// Greatest tilt of a flank's normal by its deviation, rad.
    fn tilt(&self) -> f64 {
        self.locked_teeth.tilt().max(self.free_teeth.tilt())
    }

    /// Whether the free land is rounder about its axis than a locked curve of the arm `X`: `|σ| ≥ (r_a − e)/e` on the
    /// land against `|σ| ≤ ρ/X`.
    fn is_rounder_than(&self, arm: f64) -> bool {
        self.free_off == 0.0 || arm > self.least_round_arm()
    }

    fn least_round_arm(&self) -> f64 {
        self.outmost() * self.free_off / (self.free.tip_radius - self.free_off)
    }

    /// Least `X = D sin(γ − η) − r sin γ` of the locked fillet from `gamma` up; `None` unless positive. `η` is the
    /// angle of its pitch point `E` from the line of centres.
    ///
    /// `E` is within `asin(L/r)` of the point. X is a sine of `γ` at fixed `η`, and a sine of `η` at fixed `γ`. Where X
    /// is positive it is concave, so its least value is at a corner of the box.
    fn fillet_arm(&self, gamma: f64) -> Option<f64> {
        let (shape, near) = (self.locked, self.near());
        let half = overlap_half_angle(shape.form_radius(), self.outmost(), near)?;
        let reach = shape.depth / shape.fillet_end.cos() + shape.round;
        let behind = (reach.abs() / shape.pitch_radius).min(1.0).asin();
        // On a fillet with h_0 ≥ 0 the point is ahead of E, towards the tooth.
        let ahead = if shape.depth >= 0.0 { 0.0 } else { behind };
        let mut least = f64::INFINITY;
        for gamma in [gamma, shape.fillet_end] {
            for eta in [-half - behind, half + ahead] {
                if !(gamma - eta > 0.0 && gamma - eta < PI) {
                    return None;
                }
                least = least.min(near * (gamma - eta).sin() - shape.pitch_radius * gamma.sin());
            }
        }
        (least > 1e-9 * near).then_some(least)
    }
}

/// `σ = tan ψ`; infinite where the angle is past a right one.
fn slope_at(psi: f64) -> f64 {
    if psi < FRAC_PI_2 {
        psi.tan()
    } else {
        f64::INFINITY
    }
}

/// Part of a fillet to which the depth that its mate reaches is bisected.
const BISECTED: f64 = 1e-12;

/// The depth to which the mate can reach into a half tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ReachedDepth {
    Involute,
    /// Down to this `γ` of the fillet.
    Fillet(f64),
    Root,
}

fn reached(shape: &HalfToothShape, radius: f64) -> ReachedDepth {
    if radius >= shape.form_radius() {
        return ReachedDepth::Involute;
    }
    if !(radius > shape.root_radius) {
        return ReachedDepth::Root;
    }
    // |P| rises with γ; the lower end of the bracket is on the safe side.
    let end = shape.fillet_end;
    let width = end * BISECTED;
    let beyond = |gamma: f64| shape.at(Fillet, gamma).point.norm() - radius;
    let [low, _] = bisect_smooth(0.0, end, width, beyond);
    ReachedDepth::Fillet(low)
}

/// Whether `fillet` is more hollow everywhere than the mate's involute is convex from `radius` outwards.
///
/// The fillet's radius of curvature is `S/q = ρ + h_0² c³/(r + h_0 c²)` with `c = 1/cos γ` ([`crate::gear::Fillet`]).
/// It rises with `c` while `r + h_0 c² > 0`, which is also the condition for a hollow fillet. For a helical gear a
/// bound per stretch applies, from `gamma` up.
fn hollow((fillet, gamma): (&HalfToothShape, f64), mate: &Teeth, radius: f64) -> bool {
    let least = mate.least_bend_radius(involute::roll_at(radius, mate.shape.base));
    if fillet.fillet.is_elliptic() {
        return least > (1.0 + 1e-9) * fillet.fillet.greatest_hollow(gamma);
    }
    let c = 1.0 / fillet.fillet_end.cos();
    let q = fillet.pitch_radius + fillet.depth * c * c;
    q > 1e-9 * fillet.pitch_radius
        && least > (1.0 + 1e-9) * (fillet.round + fillet.depth * fillet.depth * c * c * c / q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{BasicRack, Deviations, Face, GearDesign, Hand, Side};

    fn teeth(count: u32, helix_deg: f64, shift: f64, round: f64) -> Teeth {
        let design = GearDesign::plain(count, 2.0).helical(helix_deg, Hand::Left);
        let radius = design.basic_data.reference_radius();
        let design = GearDesign {
            rack: BasicRack::new(1.0, 1.25, round).unwrap(),
            // Low enough that no tooth is pointed.
            tip_diameter: Some(2.0 * radius + 4.0 * shift + 0.4),
            ..design.shifted(shift)
        };
        let gear = design.built(Face::Front, &Deviations::default());
        Teeth::new(&gear, Side::Right)
    }

    /// A fillet is more hollow than the opposite involute is convex from the radius at which that is as curved as the
    /// fillet where it is flattest. That radius is `√(r_b² + R²)`; for a helical gear it is within a 16th. A fillet
    /// that bulges somewhere is hollow nowhere. Source: the fillet's curvature by differences of its normal.
    #[test]
    fn a_fillet_is_hollower_than_a_flank_that_bends_less() {
        let mate = teeth(60, 0.0, 0.0, 0.38);
        let mut bulging = 0;
        for (count, helix, shift, round) in [
            (17, 0.0, 0.0, 0.38),
            (25, 0.0, 0.4, 0.38),
            (40, 0.0, -0.3, 0.2),
            (30, 0.0, 1.2, 0.38),
            (3, 0.0, 1.0, 0.4),
            (4, 0.0, 1.0, 0.4),
            (3, 0.0, 1.2, 0.3),
            (25, 25.0, 0.4, 0.38),
            (60, 40.0, 1.0, 0.38),
            (3, 10.0, 1.2, 0.3),
        ] {
            let teeth = teeth(count, helix, shift, round);
            let shape = &teeth.shape;
            const STEP: f64 = 1e-6;
            // Radius of curvature, + where the fillet is hollow.
            let hollowness = |k: u32| {
                let t = STEP + (shape.fillet_end - 2.0 * STEP) * f64::from(k) / 1000.0;
                let [one, other] = [t - STEP, t + STEP].map(|t| shape.at(Fillet, t));
                let (way, turn) = (other.point - one.point, other.normal - one.normal);
                -way.norm_sqr() / (way.re * turn.re + way.im * turn.im)
            };
            let radii: Vec<f64> = (0..=1000).map(hollowness).collect();
            if radii.iter().any(|radius| *radius < 0.0) {
                assert!(!hollow((shape, 0.0), &mate, 1e3), "{count} {shift}");
                bulging += 1;
                continue;
            }
            let flattest = radii.into_iter().fold(0.0, f64::max);
            let radius = |share: f64| mate.shape.base.hypot(flattest * (1.0 + share));
            let [below, above] = if helix > 0.0 {
                [radius(-1e-3), radius(1.0 / 16.0)]
            } else {
                [
                    radius(-1e-3).max(radius(0.0) * (1.0 - 1e-5)),
                    radius(1e-3).min(radius(0.0) * (1.0 + 1e-5)),
                ]
            };
            assert!(hollow((shape, 0.0), &mate, above), "{count} {shift}");
            assert!(!hollow((shape, 0.0), &mate, below), "{count} {shift}");
        }
        assert!(bulging > 0);
    }
}
