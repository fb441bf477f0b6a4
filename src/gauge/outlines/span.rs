//! Two parallel anvils closed on the outer flanks of `k` teeth.
//!
//! Both are plane and reach from outside the tips down to a third of the depth above the root. An outline has no form
//! circle, and a fillet is no flank. Closed in the direction `u` they are `W(u)` apart, the sum of the extents of both
//! flanks. Rocking changes that by the component across `u` of the line between the two contacts. The reading is the
//! stationary `W` nearest to the direction perpendicular to the middle of the spanned teeth. On involutes that is
//! anywhere on the plateau, on round flanks the greatest, on flat parallel ones the least.

use super::place::{Goal, Place, rounding};
use crate::gauge::span::check_spanned;
use crate::gauge::{Span, Spans, Unmeasured, tooth_after};
use crate::gear::{Flank, Side};
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};
use crate::parallel;
use nalgebra::Complex;

type C = Complex<f64>;

/// Height of the anvils' end above the root, as a part of the depth: the height at which teeth are found.
const REACH: f64 = 1.0 / 3.0;

/// Part of the depth that counts as the anvils' end.
const END: f64 = 0.01;

/// Retreat without its end, mm, up to which an anvil counts as flat on the flank: far below the resolution of a gauge, far above rounding.
const LEVEL: f64 = 1e-6;

/// Directions on either side within half a pitch (tuned: neighbouring ones differ little).
const ROCKS: u32 = 32;

/// Measures the span over `k` teeth all round.
pub(super) fn spans(gear: &OutlineGear, k: u32) -> Result<Spans, Unmeasured> {
    check_spanned(k, gear.teeth())?;
    let readings = parallel::map(1..=gear.teeth(), |first| {
        Anvils::new(gear, k, first).close()
    });
    let readings = readings.into_iter().collect::<Result<Vec<_>, _>>()?;
    let low = readings.iter().filter(|(_, low)| *low).count();
    if low > 0 {
        return Err(Unmeasured(format!(
            "over {k} of {} teeth, {low} of {} readings touch with the anvils' ends, a third of the depth above the root: span more teeth",
            gear.teeth(),
            readings.len()
        )));
    }
    Ok(Spans {
        teeth: k,
        readings: readings.into_iter().map(|(span, _)| span).collect(),
    })
}

/// The flank on which one anvil closes.
struct OuterFlank<'a> {
    side: Side,
    tooth: u32,
    half: &'a HalfOutline,
    /// The pieces down to the anvil's end, and to slightly above it.
    pieces: [Vec<HalfPiece>; 2],
}

struct Anvils<'a> {
    gear: &'a OutlineGear,
    /// One for the first tooth and one for the last.
    outer: [OuterFlank<'a>; 2],
    /// Perpendicular to the middle of the spanned teeth, outwards from the first one.
    square: C,
}

/// The anvils closed in one direction.
struct ClosedAnvils {
    places: [Place; 2],
    length: f64,
    /// Change of the length with the direction, mm/rad.
    slope: f64,
}

impl<'a> Anvils<'a> {
    fn new(gear: &'a OutlineGear, k: u32, first_tooth: u32) -> Anvils<'a> {
        let face = gear.face();
        let depth = gear.tip_radius() - gear.root_radius();
        let reach = gear.root_radius() + REACH * depth;
        let outer = [(Flank::Left, 0), (Flank::Right, k - 1)].map(|(flank, steps)| {
            let side = face.seen_from_front(flank);
            let tooth = tooth_after(gear.teeth(), first_tooth, steps);
            let half = gear.half(side, tooth);
            OuterFlank {
                side,
                tooth,
                half,
                pieces: [reach, reach + END * depth].map(|radius| half.down_to(radius)),
            }
        });
        let middle = gear.tooth_angle(f64::from(first_tooth) + 0.5 * f64::from(k - 1));
        Anvils {
            gear,
            outer,
            square: Complex::from_polar(1.0, middle) * C::new(0.0, -face.ascending()),
        }
    }

    /// The foremost places when rocked by `angle`, rad, with the anvils' ends cut off if `cut`.
    fn places(&self, angle: f64, cut: bool) -> [Place; 2] {
        let along = self.square * Complex::from_polar(1.0, angle);
        [(0, along), (1, -along)].map(|(end, out): (usize, C)| {
            let OuterFlank { side, pieces, .. } = &self.outer[end];
            Goal::Foremost(out).on(&pieces[usize::from(cut)], *side, rounding(self.gear))
        })
    }

    fn closed(&self, angle: f64) -> ClosedAnvils {
        let places = self.places(angle, false);
        let along = self.square * Complex::from_polar(1.0, angle);
        let join = along.conj() * (places[0].at - places[1].at);
        ClosedAnvils {
            places,
            length: -places[0].value - places[1].value,
            slope: join.im,
        }
    }

    /// The reading, and whether only an anvil's end touches.
    fn close(&self) -> Result<(Span, bool), Unmeasured> {
        let step = 0.5 * self.gear.pitch() / f64::from(ROCKS);
        // The last direction on either side.
        let mut last = [(0.0, self.closed(0.0).slope); 2];
        for rock in 1..=ROCKS {
            for (which, sign) in [1.0, -1.0].into_iter().enumerate() {
                let angle = sign * step * f64::from(rock);
                let slope = self.closed(angle).slope;
                if slope * last[which].1 <= 0.0 {
                    return Ok(self.between([last[which], (angle, slope)]));
                }
                last[which] = (angle, slope);
            }
        }
        let [first, last] = self.outer.each_ref().map(|outer| outer.tooth);
        Err(Unmeasured(format!(
            "the anvils found no hold on the teeth from {first} to {last}: rocked by half a pitch either way, they keep closing or opening"
        )))
    }

    /// The reading between two directions whose slopes have opposite signs.
    fn between(&self, [mut one, mut other]: [(f64, f64); 2]) -> (Span, bool) {
        let fine = rounding(self.gear);
        let rest = |one: (f64, f64), other: (f64, f64)| {
            one.1.abs().max(other.1.abs()) * (one.0 - other.0).abs()
        };
        loop {
            let angle = 0.5 * (one.0 + other.0);
            let closed = self.closed(angle);
            let halves = angle != one.0 && angle != other.0;
            if halves && rest(one, other) > fine {
                if closed.slope * one.1 > 0.0 {
                    one = (angle, closed.slope)
                } else {
                    other = (angle, closed.slope)
                }
                continue;
            }
            let above = self.places(angle, true);
            let level = LEVEL + self.gear.bound();
            let low = (0..2).any(|end| above[end].value > closed.places[end].value + level);
            let missed = closed.places[0].missed + closed.places[1].missed;
            let touch =
                |end: usize| closed.places[end].touch(self.outer[end].half, self.outer[end].tooth);
            let span = Span {
                first_tooth: self.outer[0].tooth,
                length: closed.length,
                error: missed + rest(one, other) + 2.0 * (fine + self.gear.bound()),
                touched: [touch(0), touch(1)],
                sections: [0.0; 2],
            };
            return (span, low);
        }
    }
}
