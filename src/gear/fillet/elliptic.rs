//! What is known of a helical gear's fillet over a stretch of `γ`: bounds of its speed and turn, where the circle's closed forms end.
//!
//! Of `L = h_0/cos γ + ρ/k` and `M = h_0/cos γ − ρ tan²β cos²γ/k³` each term is monotone in `γ` from 0 to a right angle, as is
//! `ρ_t = ρ/(cos²β k³)`: its values at a stretch's ends bound it, and `S` and `q` follow by sums and products of intervals.

use super::Fillet;
use crate::numeric::bisect;

/// Stretches into which questions about a whole fillet cut it.
const STRETCHES: u32 = 64;

/// Bisections before a stretch's bound is taken as it is: `S` within 1e-9 of its size.
const MOST_HALVINGS: u32 = 30;

/// Bounds over a stretch, least first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Over {
    /// `L`, mm.
    reach: [f64; 2],
    /// `M/(r cos γ)`.
    lift: [f64; 2],
    /// `ρ_t`, mm.
    round: [f64; 2],
}

impl Over {
    /// `S`, mm.
    pub fn speed(&self) -> [f64; 2] {
        sum(self.round, product(self.reach, self.lift))
    }

    /// `q`.
    pub fn turn(&self) -> [f64; 2] {
        sum([1.0; 2], self.lift)
    }
}

impl Fillet {
    /// `ρ/k` at `sin γ`, mm: how far the tool's tip round reaches from its centre along the normal.
    #[inline]
    pub(super) fn round(&self, sin: f64) -> f64 {
        match self.lean > 0.0 {
            true => self.tip_round / self.stretch(sin),
            false => self.tip_round,
        }
    }

    /// What the ellipse takes off the turn of the pitch point, rad: `ρ tan²β sin γ/(k r)`.
    #[inline]
    pub(super) fn held_back(&self, sin: f64) -> f64 {
        match self.lean > 0.0 {
            true => self.tip_round * self.lean * sin / (self.stretch(sin) * self.radius),
            false => 0.0,
        }
    }

    /// `k`.
    fn stretch(&self, sin: f64) -> f64 {
        (1.0 + self.lean * sin * sin).sqrt()
    }

    /// Bounds between `low` and `high`.
    pub(super) fn over(&self, low: f64, high: f64) -> Over {
        let ends = [low, high].map(|gamma| {
            let (sin, cos) = gamma.sin_cos();
            (1.0 / cos, cos, self.stretch(sin))
        });
        let rising = ends.map(|(c, _, _)| self.depth * c);
        let deep = [rising[0].min(rising[1]), rising[0].max(rising[1])];
        let [(low_c, low_cos, low_k), (high_c, high_cos, high_k)] = ends;
        let falling = |of: &dyn Fn(f64, f64) -> f64| [of(high_cos, high_k), of(low_cos, low_k)];
        let round = falling(&|_, k| self.tip_round * (1.0 + self.lean) / (k * k * k));
        let along = falling(&|_, k| self.tip_round / k);
        let against = falling(&|cos, k| self.tip_round * self.lean * cos * cos / (k * k * k));
        let moment = [deep[0] - against[1], deep[1] - against[0]];
        Over {
            reach: sum(deep, along),
            lift: product(moment, [low_c / self.radius, high_c / self.radius]),
            round,
        }
    }

    /// A lower bound of `S` over the fillet that has its sign.
    pub(super) fn least_elliptic_speed(&self) -> f64 {
        self.least_speed_between(0.0, self.end, MOST_HALVINGS)
    }

    fn least_speed_between(&self, low: f64, high: f64, halvings: u32) -> f64 {
        let bound = self.over(low, high).speed()[0];
        let middle = 0.5 * (low + high);
        if bound >= 0.0 || halvings == 0 {
            return bound;
        }
        let here = self.speed(middle);
        if here < 0.0 {
            return here;
        }
        let first = self.least_speed_between(low, middle, halvings - 1);
        match first < 0.0 {
            true => first,
            false => first.min(self.least_speed_between(middle, high, halvings - 1)),
        }
    }

    /// The greatest polar angle, rad, as [`Fillet::neck`]: where `n·P = r cos γ − L` is 0, or at an end.
    pub(super) fn elliptic_neck(&self) -> f64 {
        let at = |k: u32| self.end * f64::from(k) / f64::from(STRETCHES);
        let ahead = |gamma: f64| {
            let (sin, cos) = gamma.sin_cos();
            self.radius * cos - self.depth / cos - self.round(sin)
        };
        // Where it rises through 0 the angle is least.
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

    /// As [`Fillet::bend`]. With `c = 1/cos γ`, `k ≥ 1` and `|k'| ≤ tan²β/2`: `|L| ≤ |h_0| c + ρ`, `|M| ≤ |h_0| c + ρ tan²β`,
    /// `|L'| ≤ |h_0| c tan γ + ρ tan²β/2`, `|M'| ≤ |h_0| c tan γ + ρ tan²β (1 + 3/2 tan²β)`, `|ρ_t'| ≤ 3/2 tan²β ρ/cos²β`.
    pub(super) fn elliptic_bend(&self, gamma: f64) -> (f64, f64) {
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

    /// The greatest radius of curvature `S/q` from `γ` up, mm: ∞ where the fillet is not hollow all through.
    pub(crate) fn greatest_hollow(&self, gamma: f64) -> f64 {
        self.stretches(gamma).fold(0.0, |most: f64, (low, high)| {
            let over = self.over(low, high);
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
        self.stretches(gamma).fold(0.0, |most: f64, (low, high)| {
            let reach = self.over(low, high).reach;
            let (out, within) = (self.radius * low.cos(), self.radius * high.cos());
            let radial = (out - reach[0]).abs().max((within - reach[1]).abs());
            most.max(radial.atan2(self.radius * low.sin()))
        })
    }

    fn stretches(&self, from: f64) -> impl Iterator<Item = (f64, f64)> {
        let at = move |k: u32, end: f64| from + (end - from) * f64::from(k) / f64::from(STRETCHES);
        let end = self.end;
        (0..STRETCHES).map(move |k| (at(k, end), at(k + 1, end)))
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
