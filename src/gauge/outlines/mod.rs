//! Spans and pins on a gear given by its outline: anvils and pins touch the curves as drawn.
//!
//! A contact at tip or root is reported. Readings mean the same as those of a gear by its data ([`Spans`], [`super::Pins`]).
//!
//! **Spans.** Both anvils are plane and reach from outside the tips down to a third of the depth above the root. An outline has no form
//! circle, and a fillet is no flank. Closed in the direction `u` they are `W(u)` apart, the sum of the extents of both
//! flanks. Rocking changes that by the component across `u` of the line between the two contacts. The reading is the
//! stationary `W` nearest to the direction perpendicular to the middle of the spanned teeth. On involutes that is
//! anywhere on the plateau, on round flanks the greatest, on flat parallel ones the least.
//!
//! **Pins.** As on a gear by its data (`src/gauge/seat.rs`) the centre of a pin at rest is half its diameter from both flanks. Newton's
//! method on the two distances finds it. The pin comes from outside, above the middle of the space. No step is longer than the
//! distance to the nearest metal, so it passes through none. The half teeth reach to the middle of the root: a pin that
//! touches no flank first, or the root alone, has no seat.

mod place;

use super::pins::pins;
use super::span::check_spanned;
use super::{Formula, Gauged, Seat, Span, Spans, Unmeasured, tooth_after};
use crate::gear::{Flank, Side};
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};
use crate::parallel;
use nalgebra::{Complex, Matrix2, Point2, Vector2};
use place::{Goal, Place, rounding};

type C = Complex<f64>;

/// Measures spans over `span_teeth` teeth and over pins of the diameter `pin`, mm (> 0), on `gear`. Other gauges need an involute.
///
/// ```
/// # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
/// use gearlash::gauge::gauge_outline;
/// use gearlash::outline::OutlineGear;
///
/// # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
/// let outline = OutlineGear::from(&AsBuilt::perfect(gear, Face::Front));
/// let spans = gauge_outline(&outline, Some(3), None).spans?;
/// // As of the gear by its data, ISO 21771.
/// let alpha = 20f64.to_radians();
/// let span = 2.0 * alpha.cos() * (2.5 * std::f64::consts::PI + 20.0 * (alpha.tan() - alpha));
/// assert!((spans.summary().mean - span).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gauge_outline(gear: &OutlineGear, span_teeth: Option<u32>, pin: Option<f64>) -> Gauged {
    let no_involute = || Unmeasured("an outline has no involute".to_owned());
    let not_asked = |what: &str| Unmeasured(format!("no {what} is given"));
    let over_pins = |diameter| {
        let seats = seats(gear, diameter)?;
        pins(seats, diameter, gear.tip_radius(), rounding(gear), false)
    };
    Gauged {
        spans: span_teeth.map_or(Err(not_asked("number of teeth")), |k| spans(gear, k)),
        pins: pin.map_or(Err(not_asked("diameter")), over_pins),
        runout: Err(no_involute()),
        pitch_own: Err(no_involute()),
        pitch_datum: Err(no_involute()),
        thickness: Err(no_involute()),
        profile: Err(no_involute()),
        along_face: None,
        eccentricity: Err(no_involute()),
        roll: Err(no_involute()),
        root: Err(no_involute()),
        stated: Err(no_involute()),
        grades: Err(no_involute()),
        formula: Formula::default(),
    }
}

/// Height of the anvils' end above the root, as a part of the depth: the height at which teeth are found.
const REACH: f64 = 1.0 / 3.0;

/// Part of the depth that counts as the anvils' end.
const END: f64 = 0.01;

/// Retreat without its end, mm, up to which an anvil counts as flat on the flank: far below the resolution of a gauge, far above rounding.
const LEVEL: f64 = 1e-6;

/// Directions on either side within half a pitch (tuned: neighbouring ones differ little).
const ROCKS: u32 = 32;

/// Measures the span over `k` teeth all round.
fn spans(gear: &OutlineGear, k: u32) -> Result<Spans, Unmeasured> {
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

/// Limit of Newton steps; a dozen is already much.
const MOST_STEPS: usize = 60;

/// Longest step, as a part of the distance to the nearest metal.
const SHARE: f64 = 0.9;

/// Least sine of the angle between two flanks that hold a pin better than one.
const HOLD: f64 = 1e-3;

/// Lays a pin of `diameter` into every space.
fn seats(gear: &OutlineGear, diameter: f64) -> Result<Vec<Seat>, Unmeasured> {
    let seats = parallel::map(1..=gear.teeth(), |tooth| seat(gear, tooth, diameter));
    seats.into_iter().collect()
}

/// Lays a pin of `diameter` into the space after `tooth`.
fn seat(gear: &OutlineGear, tooth: u32, diameter: f64) -> Result<Seat, Unmeasured> {
    let (face, radius, fine) = (gear.face(), 0.5 * diameter, rounding(gear));
    let ends = [(Flank::Right, 0), (Flank::Left, 1)].map(|(flank, steps)| {
        let side = face.seen_from_front(flank);
        let tooth = tooth_after(gear.teeth(), tooth, steps);
        (side, tooth, gear.half(side, tooth))
    });
    let middle = gear.tooth_angle(f64::from(tooth) + 0.5);
    let mut centre = Complex::from_polar(gear.tip_radius() + radius, middle);
    for _ in 0..MOST_STEPS {
        let found: [Place; 2] =
            ends.map(|(side, _, half)| Goal::Nearest(centre).on(&half.pieces, side, fine));
        let [one, other] = found.map(|place| {
            let away = (centre - place.at) / place.value;
            Vector2::new(away.re, away.im)
        });
        let gradients = Matrix2::from_rows(&[one.transpose(), other.transpose()]);
        let hold = gradients.determinant().abs();
        let lack = Vector2::new(radius - found[0].value, radius - found[1].value);
        let Some(inverse) = gradients.try_inverse().filter(|_| hold >= HOLD) else {
            break;
        };
        if lack.amax() <= 4.0 * fine {
            // Each distance is within its bound. A centre between two gradients of the determinant D moves by at most √2 · √2/|D| as much.
            let missed = found[0].missed.max(found[1].missed);
            let distance = lack.amax() + missed + fine + gear.bound();
            return Ok(Seat {
                tooth,
                centre: Point2::new(centre.re, centre.im),
                error: 2.0 * distance / hold,
                touched: [0, 1].map(|i: usize| found[i].touch(ends[i].2, ends[i].1)),
                sections: [0.0; 2],
            });
        }
        let step = inverse * lack;
        let longest = SHARE * found[0].value.min(found[1].value);
        centre += Complex::new(step.x, step.y) * (longest / step.norm()).min(1.0);
    }
    Err(Unmeasured(format!(
        "a pin of {diameter} mm finds no rest on both flanks of the space after tooth {tooth}: take one of another diameter"
    )))
}
