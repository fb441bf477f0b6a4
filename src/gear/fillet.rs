//! The fillet: envelope of the rack tool's tip round, rolled without slip.
//!
//! Derivation. The rack rolls on the reference circle. The pitch point `E r`, `E = e^{iβ}`, is the instantaneous centre. The
//! centre of the tool's tip round lies at the offset `−h_0 + iu` from it (radial, tangential), `u = c_0 − r(β − β_space)`. The
//! normal of the envelope passes through the pitch point. With `γ`, the angle between normal and radius,
//!
//! ```text
//! u = h_0 tan γ,   P = E (r − L e^{−iγ}),   L = h_0/cos γ + ρ,   n = E e^{−iγ}.
//! ```
//!
//! `γ` runs from 0 at the root land to `π/2 − α`, where the flank of the tool begins. Nothing changes sign at `h_0 = 0`: a shift
//! that lifts the centre of the tip round beyond the pitch line is no special case. With `dβ/dγ = −h_0/(r cos² γ)`,
//!
//! ```text
//! dP/dγ = i n S,   S = ρ + h_0 L/(r cos² γ),   d(arg n)/dγ = −q,   q = 1 + h_0/(r cos² γ).
//! ```
//!
//! In the transverse section of a helical gear the tool's tip round `ρ` is an ellipse, `ρ/cos β` along the pitch line and `ρ`
//! deep. With `k = √(1 + tan²β sin²γ)`, the point with the normal angle `γ` lies at `ρ (sin γ/cos²β, −cos γ)/k` from its centre.
//! Rolling it gives
//!
//! ```text
//! L = h_0/cos γ + ρ/k,   u = h_0 tan γ − ρ tan²β sin γ/k,
//!
//! −r dβ/dγ = M/cos γ,   M = h_0/cos γ − ρ tan²β cos²γ/k³ = L − ρ_t,
//!
//! S = ρ_t + L M/(r cos γ),   q = 1 + M/(r cos γ),   ρ_t = ρ/(cos²β k³),
//! ```
//!
//! where `ρ_t` is the ellipse's radius of curvature. They become the circle's formulas at `β = 0`. A circle in place of the ellipse
//! would move form diameters by tens of micrometres.
//!
//! Each term of `L` and `M` is monotone in `γ` from 0 to a right angle, and so is `ρ_t`. Their values at the ends of a stretch
//! bound it. `S` and `q` follow by sums and products of intervals.
//!
//! The formulas hold for the right-hand half tooth, its centre line on +x.

use super::{BasicGearData, BasicRack, involute};
use crate::error::GearError;
use crate::numeric::bisect;
use nalgebra::{Complex, Point2, UnitComplex, Vector2};
use std::f64::consts::{FRAC_PI_2, PI};

/// Number of stretches for bounds over a whole fillet.
const STRETCHES: u32 = 64;

/// Most bisections of a stretch: `S` is then known within 1e-9 of its size.
const MOST_HALVINGS: u32 = 30;

/// An end of a stretch: sine and cosine of its `γ`, and `k`.
#[derive(Debug, Clone, Copy)]
struct StretchEnd {
    sin: f64,
    cos: f64,
    stretch: f64,
}

/// Bounds over a stretch, least first.
#[derive(Debug, Clone, Copy)]
struct StretchBounds {
    /// `L`, mm.
    reach: [f64; 2],
    /// `M/(r cos γ)`.
    lift: [f64; 2],
    /// `ρ_t`, mm.
    round: [f64; 2],
}

impl StretchBounds {
    /// `S`, mm.
    pub fn speed(&self) -> [f64; 2] {
        sum(self.round, product(self.reach, self.lift))
    }

    /// `q`.
    pub fn turn(&self) -> [f64; 2] {
        sum([1.0; 2], self.lift)
    }
}

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
    /// It ends at the tangency with the involute, or, with undercut, at the outermost crossing of trochoid and involute.
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

    /// Least `S` over the fillet. With `c = 1/cos γ`, `S = ρ + h_0 ρ c²/r + h_0² c³/r` has its minimum at `c = 2ρ/(3|h_0|)` for
    /// `h_0 < 0`.
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
    /// The trochoid crosses the base circle inside the metal. It ends outside it, on the mirrored branch of the involute. In
    /// between, the angle between trochoid and involute changes sign once. `|P|` rises with `γ` (`d|P|²/dγ = 2 r S sin γ`), so
    /// both bisections keep their bracket.
    fn undercut(&mut self, base: f64, half_base: f64) {
        let tangency = self.end;
        let inside = |gamma: f64| self.point(gamma).coords.norm() < base;
        let [_, at_base] = bisect(0.0, tangency, 0.0, inside);
        let excess = |gamma: f64| {
            let point = self.point(gamma);
            let roll = involute::roll_at(point.coords.norm(), base);
            point.y.atan2(point.x) + half_base - involute::inv_of_roll(roll)
        };
        // Within rounding of the base circle a crossing equals the tangency.
        if excess(at_base) > 0.0 && excess(tangency) < 0.0 {
            [_, self.end] = bisect(at_base, tangency, 0.0, |gamma| excess(gamma) > 0.0);
        }
        self.form_roll = involute::roll_at(self.point(self.end).coords.norm(), base);
    }

    /// This fillet turned by `angle`, rad, about the gear's centre.
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

    /// The greatest polar angle of the fillet, rad: minus half the angle of the tooth at its neck, about the gear's centre.
    ///
    /// At 0 or more both fillets of a tooth cross, and the tooth is cut off.
    ///
    /// `P' = i n S` turns by `S n·P/|P|²`, and `n·P = r cos γ − L`. With `c = cos γ` it is 0 where `r c² − ρ c − h_0 = 0`. The angle
    /// is greatest at the lesser root `γ` or at an end, and least at the other root.
    pub fn neck(&self) -> f64 {
        if self.lean > 0.0 {
            return self.elliptic_neck();
        }
        let (r, round, depth) = (self.radius, self.tip_round, self.depth);
        // NaN without a real root, which no range contains.
        let root = (round * round + 4.0 * r * depth).sqrt();
        let still = ((round + root) / (2.0 * r)).acos();
        let angle = |gamma: f64| {
            let point = self.point(gamma);
            point.y.atan2(point.x)
        };
        let ends = self.root_angle.max(angle(self.end));
        if (0.0..=self.end).contains(&still) {
            ends.max(angle(still))
        } else {
            ends
        }
    }

    /// Polar angle `arg E` of the generating pitch point at `gamma`, rad.
    pub(crate) fn pitch_angle(&self, gamma: f64) -> f64 {
        self.pitch_point(gamma).angle()
    }

    /// `L`, mm: distance of the fillet from its generating pitch point, along its normal.
    pub(crate) fn reach(&self, gamma: f64) -> f64 {
        let (sin, cos) = gamma.sin_cos();
        self.depth / cos + self.round(sin)
    }

    /// Rotation `E` of the pitch point at `gamma`.
    fn pitch_point(&self, gamma: f64) -> UnitComplex<f64> {
        let turn = self.depth * gamma.tan() / self.radius - self.ellipse_lag(gamma.sin());
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
            - (self.depth * sin / (cos * self.radius) - self.ellipse_lag(sin)))
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
            return self.over([self.stretch_end(gamma); 2]).speed()[0];
        }
        let c = 1.0 / gamma.cos();
        let lift = self.depth * c * c / self.radius;
        self.tip_round + lift * (self.tip_round + self.depth * c)
    }

    /// Bounds of `S` and of `q`, times the half length. Both bounds rise with `γ`, because they use `|h_0|`.
    pub(super) fn spread(&self, low: f64, high: f64) -> (f64, f64) {
        let half = 0.5 * (high - low);
        if self.lean > 0.0 {
            let over = self.between(low, high);
            return (greatest(over.speed()) * half, greatest(over.turn()) * half);
        }
        let c = 1.0 / high.cos();
        let depth = self.depth.abs();
        let lift = depth * c * c / self.radius;
        let speed = self.tip_round + lift * (self.tip_round + depth * c);
        (speed * half, (1.0 + lift) * half)
    }

    /// Bounds of `−q/S`. For `h_0 ≥ 0` both `q` and `S` rise with `γ`.
    pub(super) fn convexity(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        if self.lean > 0.0 {
            let over = self.between(low, high);
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

    /// `None`: a fillet is hollow or nearly hollow.
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

    /// Whether the tool's tip round is an ellipse in the transverse section, as for a helical gear.
    pub fn is_elliptic(&self) -> bool {
        self.lean > 0.0
    }

    /// `(A, B)` such that over any `[γ − Δ, γ]` the part of `P''` across the chord is at most `A + B Δ`.
    ///
    /// `P'' = (i n S)'` has the parts `S |q|` across the tangent and `|S'|` along it. The chord is parallel to the tangent at some
    /// point between, from which the tangent turns by at most `q Δ`. Every term below rises with `γ`, because it uses `|h_0|`: its
    /// value at the upper end bounds the interval.
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

    /// `ρ/k` at `sin γ`, mm: extent of the tool's tip round from its centre along the normal.
    #[inline]
    fn round(&self, sin: f64) -> f64 {
        if self.lean > 0.0 {
            self.tip_round / self.stretch(sin)
        } else {
            self.tip_round
        }
    }

    /// Lag of the pitch point's turn by the elliptic tip round, rad: `ρ tan²β sin γ/(k r)`.
    #[inline]
    fn ellipse_lag(&self, sin: f64) -> f64 {
        if self.lean > 0.0 {
            self.tip_round * self.lean * sin / (self.stretch(sin) * self.radius)
        } else {
            0.0
        }
    }

    /// `k`.
    fn stretch(&self, sin: f64) -> f64 {
        (1.0 + self.lean * sin * sin).sqrt()
    }

    /// The values at `γ` from which bounds over a stretch follow.
    fn stretch_end(&self, gamma: f64) -> StretchEnd {
        let (sin, cos) = gamma.sin_cos();
        StretchEnd {
            sin,
            cos,
            stretch: self.stretch(sin),
        }
    }

    /// Bounds over the stretch from `low` to `high`.
    fn between(&self, low: f64, high: f64) -> StretchBounds {
        self.over([low, high].map(|gamma| self.stretch_end(gamma)))
    }

    /// Bounds over the stretch between two ends, the lower first.
    fn over(&self, ends: [StretchEnd; 2]) -> StretchBounds {
        let secant = ends.map(|end| 1.0 / end.cos);
        let rising = secant.map(|c| self.depth * c);
        let deep = [rising[0].min(rising[1]), rising[0].max(rising[1])];
        let [low, high] = ends;
        let falling = |of: &dyn Fn(StretchEnd) -> f64| [of(high), of(low)];
        let cubed = |end: StretchEnd| end.stretch * end.stretch * end.stretch;
        let round = falling(&|end| self.tip_round * (1.0 + self.lean) / cubed(end));
        let along = falling(&|end| self.tip_round / end.stretch);
        let against = falling(&|end| self.tip_round * self.lean * end.cos * end.cos / cubed(end));
        let moment = [deep[0] - against[1], deep[1] - against[0]];
        StretchBounds {
            reach: sum(deep, along),
            lift: product(moment, secant.map(|c| c / self.radius)),
            round,
        }
    }

    /// A lower bound of `S` over the fillet, with the sign of the least `S`.
    fn least_elliptic_speed(&self) -> f64 {
        self.least_speed_between(0.0, self.end, MOST_HALVINGS)
    }

    fn least_speed_between(&self, low: f64, high: f64, halvings: u32) -> f64 {
        let bound = self.between(low, high).speed()[0];
        let middle = 0.5 * (low + high);
        if bound >= 0.0 || halvings == 0 {
            return bound;
        }
        let here = self.speed(middle);
        if here < 0.0 {
            return here;
        }
        let first = self.least_speed_between(low, middle, halvings - 1);
        if first < 0.0 {
            first
        } else {
            first.min(self.least_speed_between(middle, high, halvings - 1))
        }
    }

    /// [`Fillet::neck`] of an elliptic tip round: the angle is greatest where `n·P = r cos γ − L` is 0, or at an end.
    fn elliptic_neck(&self) -> f64 {
        let at = |k: u32| self.end * f64::from(k) / f64::from(STRETCHES);
        let ahead = |gamma: f64| {
            let (sin, cos) = gamma.sin_cos();
            self.radius * cos - self.depth / cos - self.round(sin)
        };
        // The angle is least where it rises through 0.
        let still = (0..STRETCHES).filter_map(|k| {
            let (low, high) = (at(k), at(k + 1));
            let falls = ahead(low) > 0.0 && ahead(high) <= 0.0;
            falls.then(|| bisect(low, high, 0.0, |gamma| ahead(gamma) > 0.0)[1])
        });
        still
            .chain([self.end])
            .map(|gamma| {
                let point = self.point(gamma);
                point.y.atan2(point.x)
            })
            .fold(self.root_angle, f64::max)
    }

    /// [`Fillet::bend`] of an elliptic tip round. With `c = 1/cos γ`, `k ≥ 1` and `|k'| ≤ tan²β/2`: `|L| ≤ |h_0| c + ρ`, `|M| ≤ |h_0| c + ρ
    /// tan²β`, `|L'| ≤ |h_0| c tan γ + ρ tan²β/2`, `|M'| ≤ |h_0| c tan γ + ρ tan²β (1 + 3/2 tan²β)`, `|ρ_t'| ≤ 3/2 tan²β ρ/cos²β`.
    fn elliptic_bend(&self, gamma: f64) -> (f64, f64) {
        let (c, tan) = (1.0 / gamma.cos(), gamma.tan());
        let (depth, round, lean, r) =
            (self.depth.abs() * c, self.tip_round, self.lean, self.radius);
        let (reach, moment) = (depth + round, depth + round * lean);
        let reach_slope = depth * tan + 0.5 * round * lean;
        let moment_slope = depth * tan + round * lean * (1.0 + 1.5 * lean);
        let speed = round * (1.0 + lean) + reach * moment * c / r;
        let turn = 1.0 + moment * c / r;
        let speed_slope = 1.5 * lean * round * (1.0 + lean)
            + (reach_slope * moment + reach * moment_slope + reach * moment * tan) * c / r;
        (speed * turn, speed_slope * turn)
    }

    /// The greatest radius of curvature `S/q` from `γ` up, mm; ∞ if the fillet is not hollow throughout.
    pub(crate) fn greatest_hollow(&self, gamma: f64) -> f64 {
        self.stretches(gamma).fold(0.0, |most: f64, ends| {
            let over = self.over(ends);
            let (speed, turn) = (over.speed()[1], over.turn()[0]);
            most.max(if turn > 0.0 {
                speed / turn
            } else {
                f64::INFINITY
            })
        })
    }

    /// Greatest amount of the angle `ψ` between fillet and radius from `γ` up, rad: `tan ψ = (r cos γ − L)/(r sin γ)`.
    pub(crate) fn steepest(&self, gamma: f64) -> f64 {
        self.stretches(gamma).fold(0.0, |most: f64, ends| {
            let reach = self.over(ends).reach;
            let [out, within] = ends.map(|end| self.radius * end.cos);
            let radial = (out - reach[0]).abs().max((within - reach[1]).abs());
            most.max(radial.atan2(self.radius * ends[0].sin))
        })
    }

    /// The ends of equal stretches from `γ` up.
    fn stretches(&self, from: f64) -> impl Iterator<Item = [StretchEnd; 2]> {
        let width = self.end - from;
        let at = move |k: u32| from + width * f64::from(k) / f64::from(STRETCHES);
        let mut low = self.stretch_end(from);
        (1..=STRETCHES).map(move |k| {
            let high = self.stretch_end(at(k));
            [std::mem::replace(&mut low, high), high]
        })
    }
}

fn sum(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let all = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
    [
        all.into_iter().fold(f64::INFINITY, f64::min),
        all.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// The greatest absolute value in an interval.
fn greatest([low, high]: [f64; 2]) -> f64 {
    low.abs().max(high.abs())
}

#[cfg(test)]
pub(super) mod tests;
