//! The exact curves of one half tooth: tip land, involute, fillet, root land.
//!
//! For the right-hand half (clockwise side), the tooth's centre line on +x;
//! the left-hand half is its mirror image in the x axis. The pieces follow each
//! other from the middle of the tip land to the middle of the tooth space.

use super::{Gear, Side, involute};
use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;

/// One of the four curves of a half tooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ProfilePart {
    /// Tip land or its corner. Parameter: angle past the tooth's centre line, rad.
    Tip,
    /// Involute flank. Parameter: roll `ξ`, rad.
    Involute,
    /// Generated fillet. Parameter: `γ`, see [`super::Fillet`], rad.
    Fillet,
    /// Root land. Parameter: angle past the tooth's centre line, rad.
    Root,
}

impl ProfilePart {
    /// In order from the tip to the root.
    pub const ALL: [ProfilePart; 4] = [
        ProfilePart::Tip,
        ProfilePart::Involute,
        ProfilePart::Fillet,
        ProfilePart::Root,
    ];

    /// `tip`, `involute`, `fillet` or `root`, as results name it.
    pub fn name(self) -> &'static str {
        match self {
            ProfilePart::Tip => "tip",
            ProfilePart::Involute => "involute",
            ProfilePart::Fillet => "fillet",
            ProfilePart::Root => "root",
        }
    }
}

/// The half tooth of a gear as four exact curves.
#[derive(Debug, Clone, Copy)]
pub struct Profile<'a> {
    gear: &'a Gear,
    /// `r_b` and `ψ_b`, which every point of the involute takes.
    base: f64,
    half_base: f64,
}

impl<'a> Profile<'a> {
    /// The half tooth of `gear`.
    pub fn new(gear: &'a Gear) -> Profile<'a> {
        Profile {
            gear,
            base: gear.base_radius(),
            half_base: gear.half_base_angle(),
        }
    }

    /// The gear.
    pub fn gear(&self) -> &'a Gear {
        self.gear
    }

    /// Parameters at the two ends of `curve`, the end nearer the tip first.
    ///
    /// Involute and fillet descend, the lands ascend. A root land of a full tip round has no length.
    pub fn range(&self, curve: ProfilePart) -> (f64, f64) {
        let gear = self.gear;
        match curve {
            ProfilePart::Tip => (0.0, gear.half_angle_at_roll(gear.tip_roll())),
            ProfilePart::Involute => (gear.tip_roll(), gear.form_roll()),
            ProfilePart::Fillet => (gear.fillet().end(), 0.0),
            ProfilePart::Root => (
                -gear.fillet().root_angle(),
                PI / f64::from(gear.basic_data().teeth()),
            ),
        }
    }

    /// The point of `curve` at `parameter`, mm, on the half tooth of `side`.
    pub fn point(&self, curve: ProfilePart, parameter: f64, side: Side) -> Point2<f64> {
        let gear = self.gear;
        let right = match curve {
            ProfilePart::Tip => polar(gear.tip_radius(), -parameter),
            ProfilePart::Root => polar(gear.root_radius(), -parameter),
            ProfilePart::Fillet => gear.fillet().point(parameter),
            // r_b E (1 − iξ), E = e^{i(ξ − ψ_b)}.
            ProfilePart::Involute => {
                let (sin, cos) = (parameter - self.half_base).sin_cos();
                let base = self.base;
                Point2::new(
                    base * (cos + parameter * sin),
                    base * (sin - parameter * cos),
                )
            }
        };
        Point2::new(right.x, -side.sense() * right.y)
    }

    /// The unit normal of `curve` at `parameter`, out of the metal, on the half tooth of `side`.
    pub fn normal(&self, curve: ProfilePart, parameter: f64, side: Side) -> Vector2<f64> {
        let gear = self.gear;
        let right = match curve {
            ProfilePart::Tip | ProfilePart::Root => polar(1.0, -parameter).coords,
            ProfilePart::Fillet => gear.fillet().normal(parameter),
            // −iE.
            ProfilePart::Involute => {
                let (sin, cos) = (parameter - self.half_base).sin_cos();
                Vector2::new(sin, -cos)
            }
        };
        Vector2::new(right.x, -side.sense() * right.y)
    }

    /// `(A, B)` such that over a piece of length `Δ` on the near side of `parameter` the part of
    /// the second derivative across the chord is at most `A + B Δ`; `parameter` is the piece's greater end.
    ///
    /// Involute: `dP/dξ = r_b ξ E` and `P'' = r_b (E + iξE)`; `E` turns by `Δ` at most, so across
    /// the chord `r_b (ξ + Δ)`. Lands: `P''` has the length of the radius.
    pub(super) fn bend(&self, curve: ProfilePart, parameter: f64) -> (f64, f64) {
        let base = self.base;
        match curve {
            ProfilePart::Tip => (self.gear.tip_radius(), 0.0),
            ProfilePart::Root => (self.gear.root_radius(), 0.0),
            ProfilePart::Fillet => self.gear.fillet().bend(parameter),
            ProfilePart::Involute => (base * parameter, base),
        }
    }

    /// Bound, mm, on the distance of `curve` between two parameters from the chord through its points there:
    /// `(A + B Δ) Δ²/8`, see [`super::HalfTooth`].
    pub fn chordal_error(&self, curve: ProfilePart, from: f64, to: f64) -> f64 {
        let span = (to - from).abs();
        let (a, b) = self.bend(curve, from.max(to));
        (a + b * span) * span * span / 8.0
    }

    /// Greatest curvature of `curve` between two parameters, 1/mm: `1/(r_b ξ)` at the lesser `ξ` on the involute, that of a land;
    /// none is known of a fillet.
    pub(crate) fn curvature(&self, curve: ProfilePart, from: f64, to: f64) -> Option<f64> {
        match curve {
            ProfilePart::Tip => Some(1.0 / self.gear.tip_radius()),
            ProfilePart::Root => Some(1.0 / self.gear.root_radius()),
            ProfilePart::Involute => Some(1.0 / (self.base * from.min(to))),
            ProfilePart::Fillet => None,
        }
    }

    /// Radius about the gear's centre at `parameter` of `curve`, mm.
    pub fn radius(&self, curve: ProfilePart, parameter: f64) -> f64 {
        match curve {
            ProfilePart::Tip => self.gear.tip_radius(),
            ProfilePart::Root => self.gear.root_radius(),
            ProfilePart::Fillet => self.gear.fillet().point(parameter).coords.norm(),
            ProfilePart::Involute => involute::radius_at(parameter, self.base),
        }
    }
}

fn polar(radius: f64, angle: f64) -> Point2<f64> {
    Point2::new(radius * angle.cos(), radius * angle.sin())
}
