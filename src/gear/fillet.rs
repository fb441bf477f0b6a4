//! The fillet: envelope of the rack tool's tip round, rolled without slip.
//!
//! Derivation. While the rack rolls on the reference circle, the pitch point
//! sits at `E r` with `E = e^{iβ}` and is the instantaneous centre; the centre
//! of the tool's tip round lies at the offset `−h_0 + iu` from it (radial,
//! tangential), `u = c_0 − r(β − β_space)`. The normal of the envelope passes
//! through the pitch point, so with `γ` the angle between normal and radius
//!
//! ```text
//! u = h_0 tan γ,   P = E (r − L e^{−iγ}),   L = h_0/cos γ + ρ,   n = E e^{−iγ}.
//! ```
//!
//! `γ` runs from 0 at the root land to `π/2 − α`, where the flank of the tool
//! takes over. Written in `γ`, nothing changes sign at `h_0 = 0`: a shift that
//! lifts the centre of the tip round to the pitch line or beyond it is no
//! special case. Differentiating, with `dβ/dγ = −h_0/(r cos² γ)`,
//!
//! ```text
//! dP/dγ = i n S,   S = ρ + h_0 L/(r cos² γ),   d(arg n)/dγ = −q,   q = 1 + h_0/(r cos² γ).
//! ```
//!
//! In the transverse section of a helical gear the tool's tip round `ρ` is an ellipse, `ρ/cos β` along the pitch line and `ρ` deep. Its point
//! whose normal has the angle `γ` lies, with `k = √(1 + tan²β sin²γ)`, at `ρ (sin γ/cos²β, −cos γ)/k` from its centre. Rolled alike, now
//!
//! ```text
//! L = h_0/cos γ + ρ/k,   u = h_0 tan γ − ρ tan²β sin γ/k,   −r dβ/dγ = M/cos γ,   M = h_0/cos γ − ρ tan²β cos²γ/k³ = L − ρ_t,
//! S = ρ_t + L M/(r cos γ),   q = 1 + M/(r cos γ),   ρ_t = ρ/(cos²β k³),
//! ```
//!
//! `ρ_t` the ellipse's radius of curvature: the circle's formulas with `ρ/k` in `L` and `M` for `h_0/cos γ`, which they become at `β = 0`.
//! (A circle in place of the ellipse moves form diameters by tens of micrometres.)
//!
//! All for the right-hand half tooth, its centre line on +x.

mod elliptic;

use super::{BasicGearData, BasicRack, involute};
use crate::error::GearError;
use crate::numeric::bisect;
use nalgebra::{Complex, Point2, UnitComplex, Vector2};
use std::f64::consts::{FRAC_PI_2, PI};

/// The generated fillet of a right-hand half tooth, from root land to involute.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fillet {
    /// Reference radius `r`, mm.
    radius: f64,
    /// `h_0 = h_fP − ρ − x_E m`, mm: depth of the tip round's centre below the pitch line.
    depth: f64,
    /// `ρ`, mm.
    tip_round: f64,
    /// `tan²β`.
    lean: f64,
    /// Polar angle of the root land's end, `−π/z + c_0/r`.
    root_angle: f64,
    /// `γ` at the form point.
    end: f64,
    /// Roll of the involute at the form point.
    form_roll: f64,
}

impl Fillet {
    /// The fillet of `basic_data` cut by `rack` at the generating shift `x_E` (modules).
    ///
    /// Its end is the tangency with the involute, or with undercut the
    /// outermost crossing of trochoid and involute.
    ///
    /// # Errors
    /// [`GearError::TipRoundTooLarge`], [`GearError::FilletCusp`].
    pub fn new(
        basic_data: &BasicGearData,
        rack: &BasicRack,
        x_e: f64,
    ) -> Result<Fillet, GearError> {
        rack.check_tip_round(basic_data)?;
        let (module, alpha) = (basic_data.module(), basic_data.transverse_pressure_angle());
        let radius = basic_data.reference_radius();
        let tip_round = rack.root_radius() * module;
        let depth = (rack.dedendum() - rack.root_radius() - x_e) * module;
        let tangency = FRAC_PI_2 - alpha;
        let base = basic_data.base_radius();
        let mut fillet = Fillet {
            radius,
            depth,
            tip_round,
            lean: basic_data.helix_angle().tan().powi(2),
            root_angle: rack.half_root_land(basic_data) / basic_data.helix_cos() / radius
                - PI / f64::from(basic_data.teeth()),
            end: tangency,
            form_roll: 0.0,
        };
        // The contact normal at the tangency is the line of action: r sin α_t
        // long to the base circle, L = h_0/sin α_t + ρ/k of it below the pitch point.
        fillet.form_roll =
            (radius * alpha.sin() - depth / alpha.sin() - fillet.round(alpha.cos())) / base;
        if fillet.least_speed() < 0.0 {
            return Err(GearError::FilletCusp {
                generating_shift: x_e,
            });
        }
        if fillet.form_roll < 0.0 {
            let half_base = basic_data.half_base_angle(x_e);
            fillet.undercut(base, half_base);
        }
        Ok(fillet)
    }

    /// Least `S` over the fillet. In `c = 1/cos γ`: `S = ρ + h_0 ρ c²/r + h_0² c³/r`, which for
    /// `h_0 < 0` has its minimum at `c = 2ρ/(3|h_0|)`.
    fn least_speed(&self) -> f64 {
        if self.lean > 0.0 {
            return self.least_elliptic_speed();
        }
        let greatest = 1.0 / self.end.cos();
        let c = if self.depth < 0.0 {
            (2.0 * self.tip_round / (-3.0 * self.depth)).clamp(1.0, greatest)
        } else {
            1.0
        };
        self.tip_round + self.depth * c * c * (self.tip_round + self.depth * c) / self.radius
    }

    /// Moves the end back to the crossing of trochoid and involute.
    ///
    /// The trochoid meets the base circle inside the flank's metal and ends on
    /// the mirrored branch of the involute, outside it: between the two the
    /// angle between trochoid and involute changes sign once. `|P|` rises with
    /// `γ` (`d|P|²/dγ = 2 r S sin γ`), so both bisections hold their bracket.
    fn undercut(&mut self, base: f64, half_base: f64) {
        let tangency = self.end;
        let inside = |gamma: f64| self.point(gamma).coords.norm() < base;
        let [_, at_base] = bisect(0.0, tangency, 0.0, inside);
        let excess = |gamma: f64| {
            let point = self.point(gamma);
            let roll = involute::roll_at(point.coords.norm(), base);
            point.y.atan2(point.x) + half_base - involute::inv_of_roll(roll)
        };
        // Within rounding of the base circle no crossing can be told from the tangency.
        if excess(at_base) > 0.0 && excess(tangency) < 0.0 {
            [_, self.end] = bisect(at_base, tangency, 0.0, |gamma| excess(gamma) > 0.0);
        }
        self.form_roll = involute::roll_at(self.point(self.end).coords.norm(), base);
    }

    /// The same fillet turned by `angle`, rad, about the gear's centre.
    pub(super) fn turned(self, angle: f64) -> Fillet {
        Fillet {
            root_angle: self.root_angle + angle,
            ..self
        }
    }

    /// Greatest `γ`, rad: the fillet's parameter runs over `0 ..= end`.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Roll of the involute where the fillet meets it.
    pub fn form_roll(&self) -> f64 {
        self.form_roll
    }

    /// Polar angle at which root land and fillet meet, rad.
    pub fn root_angle(&self) -> f64 {
        self.root_angle
    }

    /// The greatest polar angle of the fillet, rad: minus half the angle that the tooth spans at its neck, about the gear's centre. 0
    /// or more means that both fillets of a tooth cross: it is cut off.
    ///
    /// `P' = i n S` turns by `S n·P/|P|²`, and `n·P = r cos γ − L`. With `c = cos γ` it is 0 where `r c² − ρ c − h_0 = 0`;
    /// at the lesser `γ` of both the angle is greatest, if not at an end; at the other it is least.
    pub fn neck(&self) -> f64 {
        if self.lean > 0.0 {
            return self.elliptic_neck();
        }
        let (r, round, depth) = (self.radius, self.tip_round, self.depth);
        // Without a real root NaN, which is in no range.
        let root = (round * round + 4.0 * r * depth).sqrt();
        let still = ((round + root) / (2.0 * r)).acos();
        let angle = |gamma: f64| {
            let point = self.point(gamma);
            point.y.atan2(point.x)
        };
        let ends = self.root_angle.max(angle(self.end));
        match (0.0..=self.end).contains(&still) {
            true => ends.max(angle(still)),
            false => ends,
        }
    }

    /// Polar angle `arg E` of the generating pitch point at `gamma`, rad.
    pub(crate) fn pitch_angle(&self, gamma: f64) -> f64 {
        self.pitch_point(gamma).angle()
    }

    /// `L`, mm: how far the fillet stands from its generating pitch point, along its normal.
    pub(crate) fn reach(&self, gamma: f64) -> f64 {
        let (sin, cos) = gamma.sin_cos();
        self.depth / cos + self.round(sin)
    }

    /// Rotation `E` of the pitch point at `gamma`.
    fn pitch_point(&self, gamma: f64) -> UnitComplex<f64> {
        let turn = self.depth * gamma.tan() / self.radius - self.held_back(gamma.sin());
        UnitComplex::new(self.root_angle - turn)
    }

    /// The point at `gamma`, mm.
    pub fn point(&self, gamma: f64) -> Point2<f64> {
        let (sin, cos) = gamma.sin_cos();
        let reach = self.depth / cos + self.round(sin);
        let offset = Vector2::new(self.radius - reach * cos, reach * sin);
        (self.pitch_point(gamma) * offset).into()
    }

    /// The outward unit normal at `gamma`.
    pub fn normal(&self, gamma: f64) -> Vector2<f64> {
        self.pitch_point(gamma) * Vector2::new(gamma.cos(), -gamma.sin())
    }

    /// Point, mm, and outward unit normal at `gamma`, from one sine and cosine of `γ` and of the pitch point.
    #[inline]
    pub(super) fn at(&self, gamma: f64) -> (Point2<f64>, Vector2<f64>) {
        let (sin, cos) = gamma.sin_cos();
        let (pitch_sin, pitch_cos) = (self.root_angle
            - (self.depth * sin / (cos * self.radius) - self.held_back(sin)))
        .sin_cos();
        let e = Complex::new(pitch_cos, pitch_sin);
        let normal = e * Complex::new(cos, -sin);
        let point = e * self.radius - normal * (self.depth / cos + self.round(sin));
        (
            Point2::new(point.re, point.im),
            Vector2::new(normal.re, normal.im),
        )
    }

    /// Radius about the gear's centre, mm.
    pub(super) fn radius(&self, gamma: f64) -> f64 {
        let point = self.at(gamma).0;
        (point.x * point.x + point.y * point.y).sqrt()
    }

    /// `S`, mm.
    #[inline]
    pub(super) fn speed(&self, gamma: f64) -> f64 {
        if self.lean > 0.0 {
            return self.over(gamma, gamma).speed()[0];
        }
        let c = 1.0 / gamma.cos();
        let lift = self.depth * c * c / self.radius;
        self.tip_round + lift * (self.tip_round + self.depth * c)
    }

    /// `S` times the half length, `q` times the half length: both rise with `γ` once `h_0` is taken by its amount.
    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        if self.lean > 0.0 {
            let over = self.over(low, high);
            return (greatest(over.speed()) * half, greatest(over.turn()) * half);
        }
        let c = 1.0 / high.cos();
        let depth = self.depth.abs();
        let lift = depth * c * c / self.radius;
        let speed = self.tip_round + lift * (self.tip_round + depth * c);
        (speed * half, (1.0 + lift) * half)
    }

    /// `−q/S`; with `h_0 ≥ 0` both grow with `γ`.
    pub(super) fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        if self.lean > 0.0 {
            let over = self.over(low, high);
            let ([slow, fast], [little, much]) = (over.speed(), over.turn());
            return (slow > 0.0 && little > 0.0).then(|| (-much / slow, -little / fast));
        }
        let (least, most) = (self.speed(low), self.speed(high));
        let turn = |gamma: f64| {
            let cos = gamma.cos();
            1.0 + self.depth / (self.radius * cos * cos)
        };
        let known = self.depth >= 0.0 && least > 0.0;
        known.then(|| (-turn(high) / least, -turn(low) / most))
    }

    /// None is known: a fillet is hollow, or not by much.
    pub(super) fn curvature(&self, _: f64, _: f64) -> Option<f64> {
        None
    }

    /// `h_0`, mm.
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// `ρ`, mm.
    pub fn tip_round(&self) -> f64 {
        self.tip_round
    }

    /// Whether the tool's tip round is an ellipse in the transverse section, as that of a helical gear is.
    pub fn is_elliptic(&self) -> bool {
        self.lean > 0.0
    }

    /// `(A, B)` such that over any `[γ − Δ, γ]` the part of `P''` across the chord is at most `A + B Δ`.
    ///
    /// `P'' = (i n S)'`: across the tangent `S |q|`, along it `|S'|`. The chord is
    /// parallel to the tangent at some point between, from which the tangent
    /// turns by at most `q Δ`. With `c = 1/cos γ` every term below rises with
    /// `γ` once `h_0` is taken by its amount, so its value at the upper end bounds the interval.
    pub fn bend(&self, gamma: f64) -> (f64, f64) {
        if self.lean > 0.0 {
            return self.elliptic_bend(gamma);
        }
        let c = 1.0 / gamma.cos();
        let (depth, round, r) = (self.depth.abs(), self.tip_round, self.radius);
        let speed = round + (depth * round * c * c + depth * depth * c * c * c) / r;
        let turn = 1.0 + depth * c * c / r;
        let speed_slope =
            gamma.tan() * (2.0 * depth * round * c * c + 3.0 * depth * depth * c * c * c) / r;
        (speed * turn, speed_slope * turn)
    }
}

/// The greater amount of an interval's ends.
fn greatest([low, high]: [f64; 2]) -> f64 {
    low.abs().max(high.abs())
}

#[cfg(test)]
mod tests;
