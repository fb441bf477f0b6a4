//! The certificate of outlines: polygons confirm a rotation that the search found.
//!
//! At a slightly more open rotation every pair of half teeth in reach must be clear. Chords prove that; they are halved only where they are
//! within both chordal errors of each other. At a slightly more closed rotation one pair must touch. The certificate uses nothing of the
//! search but its answer: no gap, no rectangles, no slopes.

use super::discs::Disc;
use super::teeth::{Frame, SideTeeth};
use crate::contact::gap::{C, PlacedCurve, RunContent, Tree};
use crate::contact::parry::closest;
use crate::gear::PartCurve;
use crate::outline::HalfPiece;
use nalgebra::Point2;
use std::f64::consts::FRAC_PI_4;
use std::ops::Range;

/// Limit of pairs of runs of chords examined on one side: about 0.05 µs each.
const EFFORT: u32 = 240_000;

/// Limit if nothing touches, when every chord of both gears is examined (tuned: a quarter gave up gears of ordinary, wide pairs).
const EFFORT_ON_NOTHING: u32 = 8 * EFFORT;

/// Pairs of runs that take the time of examining one pair of chords, or of halving a chord.
const LOOK: u32 = 4;

/// The reason why a side is given up.
const SPENT: &str = "too many stretches of the outlines are too near each other to be told apart";

/// Error of the finest chords, as a part of the centre distance: far above rounding, far below the accuracy of a drawing.
const FINEST: f64 = 1e-11;

/// Distance, in finest chords, by which a pair is turned. A corner beside an edge is only a part of that away from it.
const APART: f64 = 256.0;

/// A stretch of a curve: a straight line, and greatest distance of the stretch from it, mm.
#[derive(Debug, Clone, Copy)]
struct Chord {
    ends: [C; 2],
    error: f64,
}

impl Chord {
    fn new(curve: &PartCurve, (low, high): (f64, f64), point: impl Fn(f64) -> C) -> Chord {
        let (reach, turn) = curve.spread(low, high);
        // Its chord is parallel to a tangent: below a right angle between them the stretch ends where its chord does.
        if !(turn < FRAC_PI_4) {
            return Chord {
                ends: [point(0.5 * (low + high)); 2],
                error: reach,
            };
        }
        let (a, b) = curve.bend(high);
        let span = high - low;
        Chord {
            ends: [low, high].map(point),
            error: (a + b * span) * span * span / 8.0,
        }
    }
}

/// A half tooth in chords, one per piece of the outline.
#[derive(Debug)]
struct CutHalf {
    chords: Vec<Chord>,
    discs: Tree<Disc>,
}

/// One side of both gears in chords: every half tooth, locked and free.
#[derive(Debug)]
pub(super) struct CutSide([Vec<CutHalf>; 2]);

impl CutSide {
    pub fn new(teeth: [&SideTeeth; 2]) -> CutSide {
        CutSide(teeth.map(|teeth| {
            let half = |tooth| {
                let pieces = teeth.half(tooth).pieces.iter();
                let cut =
                    |piece: &HalfPiece| Chord::new(&piece.curve, piece.range(), |t| piece.point(t));
                let chords: Vec<Chord> = pieces.map(cut).collect();
                let round = |chord: &Chord| Disc {
                    middle: (chord.ends[0] + chord.ends[1]) * 0.5,
                    radius: 0.5 * (chord.ends[1] - chord.ends[0]).norm() + chord.error,
                };
                CutHalf {
                    discs: Tree::new(&chords.iter().map(round).collect::<Vec<Disc>>()),
                    chords,
                }
            };
            (1..=teeth.gear.teeth()).map(half).collect()
        }))
    }
}

/// A stretch at its position in a pose.
#[derive(Debug, Clone, Copy)]
struct PlacedStretch<'a> {
    ends: [Point2<f64>; 2],
    half_length: f64,
    error: f64,
    curve: PlacedCurve<'a>,
    low: f64,
    high: f64,
}

impl<'a> PlacedStretch<'a> {
    fn new(chord: &Chord, curve: PlacedCurve<'a>, (low, high): (f64, f64)) -> PlacedStretch<'a> {
        let [from, to] = chord.ends;
        PlacedStretch {
            ends: chord.ends.map(|end| Point2::new(end.re, end.im)),
            half_length: 0.5 * (to - from).norm_sqr().sqrt(),
            error: chord.error,
            curve,
            low,
            high,
        }
    }

    fn middle(&self) -> Point2<f64> {
        nalgebra::center(&self.ends[0], &self.ends[1])
    }

    /// Radius about its middle that contains it, mm.
    fn reach(&self) -> f64 {
        self.half_length + self.error
    }

    /// Whether it is worth halving.
    fn is_coarse(&self, finest: f64) -> bool {
        let middle = 0.5 * (self.low + self.high);
        self.error > finest && self.low < middle && middle < self.high
    }

    fn halves(&self) -> [PlacedStretch<'a>; 2] {
        let middle = 0.5 * (self.low + self.high);
        [(self.low, middle), (middle, self.high)].map(|range| {
            let chord = Chord::new(self.curve.curve, range, |t| self.curve.at(t).point);
            PlacedStretch::new(&chord, self.curve, range)
        })
    }

    /// Distances of its ends from the origin, mm: points of the curve, but only its middle where the curve turns far.
    fn end_radii(&self) -> [f64; 2] {
        self.ends.map(|end| end.coords.norm())
    }

    /// Raises `greatest` to its greatest distance from the origin, mm, if that is more. Halving stops when nothing is `left`.
    fn farthest(&self, greatest: &mut f64, finest: f64, left: &mut u32) {
        let [one, other] = self.end_radii();
        let far = one.max(other);
        if !self.is_coarse(finest) {
            *greatest = greatest.max(far);
        // The curve goes through the ends of its chords, not through the middle of a disc.
        } else if far + self.error > *greatest && charge(left, LOOK) {
            for half in self.halves() {
                half.farthest(greatest, finest, left);
            }
        }
    }

    /// Lowers `least` to its least distance from the origin, mm, if that is less. Halving stops when nothing is `left`.
    fn nearest(&self, least: &mut f64, finest: f64, left: &mut u32) {
        let near = closest(&self.ends, &[Point2::origin(); 2]).distance;
        if !self.is_coarse(finest) {
            *least = least.min(near);
        } else if near - self.error < *least && charge(left, LOOK) {
            for half in self.halves() {
                half.nearest(least, finest, left);
            }
        }
    }
}

/// Subtracts `units` from the effort `left`. Returns whether there were enough.
fn charge(left: &mut u32, units: u32) -> bool {
    let enough = *left >= units;
    *left = left.saturating_sub(units);
    enough
}

/// The half teeth of one side at a pose, in the frame of the search with the free gear's axis at the origin.
pub(super) struct PosedHalves<'a> {
    pub teeth: [&'a SideTeeth<'a>; 2],
    pub cut: &'a CutSide,
    pub center_distance: f64,
    /// Frame of the locked gear.
    pub locked: Frame,
    /// Numbers of the half teeth that face each other, locked and free.
    pub pairs: Vec<[u32; 2]>,
}

impl<'a> PosedHalves<'a> {
    fn finest(&self) -> f64 {
        FINEST * self.center_distance
    }

    /// Turn of the free gear to either side, rad, for a point with this lever, mm.
    pub fn turn_of_finest(&self, lever: f64) -> f64 {
        APART * self.finest() / lever
    }

    /// Whether all is clear at the free rotation `open`, and something touches at `closed`, rad.
    ///
    /// # Errors
    /// The finding that contradicts it.
    pub fn touches(&self, open: f64, closed: f64) -> Result<(), &'static str> {
        let mut left = EFFORT;
        let free = [open, closed].map(|rotation| self.free(rotation));
        let mut seen = |free, pair: &[u32; 2]| self.are_clear(free, *pair, &mut left);
        if !self.pairs.iter().all(|pair| seen(free[0], pair)) {
            return Err(match left {
                0 => SPENT,
                _ => "a pair touches before",
            });
        }
        if self.pairs.iter().all(|pair| seen(free[1], pair)) {
            Err("nothing touches there")
        } else if left == 0 {
            // Without effort, an unproven clearance need not be a touch.
            Err(SPENT)
        } else {
            Ok(())
        }
    }

    /// Whether facing half teeth have no radius in common, so that none ever touches.
    ///
    /// # Errors
    /// If two have one.
    pub fn check_no_touch(&self) -> Result<(), &'static str> {
        let finest = self.finest();
        let free = self.free(0.0);
        let mut left = EFFORT_ON_NOTHING;
        let mut meets = |&[locked, free_tooth]: &[u32; 2]| {
            let whole = |which: usize, tooth| 0..self.half(which, tooth).chords.len();
            let own: Vec<PlacedStretch> = self
                .stretches(0, locked, self.locked, whole(0, locked))
                .collect();
            let mates = self.stretches(1, free_tooth, free, whole(1, free_tooth));
            let mates: Vec<PlacedStretch> = mates.collect();
            // After the ends of all, few are left to halve.
            let ends = own.iter().flat_map(PlacedStretch::end_radii);
            let mut least = ends.fold(f64::INFINITY, f64::min);
            let ends = mates.iter().flat_map(PlacedStretch::end_radii);
            let mut greatest = ends.fold(0.0, f64::max);
            for seen in &own {
                seen.nearest(&mut least, finest, &mut left);
            }
            for seen in &mates {
                seen.farthest(&mut greatest, finest, &mut left);
            }
            least < greatest - APART * finest
        };
        if self.pairs.iter().any(&mut meets) {
            return Err("a pair does touch");
        }
        match left {
            0 => Err(SPENT),
            _ => Ok(()),
        }
    }

    fn free(&self, rotation: f64) -> Frame {
        let turned = C::from_polar(1.0, rotation);
        Frame {
            centre: turned * self.teeth[1].displacement,
            direction: turned,
        }
    }

    /// A half tooth in chords, locked (0) or free (1).
    fn half(&self, which: usize, tooth: u32) -> &'a CutHalf {
        &self.cut.0[which][tooth as usize - 1]
    }

    /// Pieces of a half tooth, locked (0) or free (1).
    fn stretches(
        &self,
        which: usize,
        tooth: u32,
        frame: Frame,
        range: Range<usize>,
    ) -> impl Iterator<Item = PlacedStretch<'a>> {
        let pieces = &self.teeth[which].half(tooth).pieces[range.clone()];
        let chords = &self.half(which, tooth).chords[range];
        chords.iter().zip(pieces).map(move |(chord, piece)| {
            let there = Chord {
                ends: chord.ends.map(|end| frame.centre + frame.direction * end),
                ..*chord
            };
            PlacedStretch::new(&there, frame.placed(piece), piece.range())
        })
    }

    /// Whether two half teeth are proven clear.
    fn are_clear(&self, free: Frame, [locked, free_tooth]: [u32; 2], left: &mut u32) -> bool {
        let teeth = [locked, free_tooth];
        let frames = [self.locked, free];
        let discs = [0, 1].map(|which: usize| &self.half(which, teeth[which]).discs);
        // Pieces outside the mate's greatest circle touch nothing.
        let mates = [
            (C::ZERO, self.teeth[1].gear.reach()),
            (C::from(self.center_distance), self.teeth[0].gear.reach()),
        ];
        let circles = mates.map(|(middle, radius)| Disc { middle, radius });
        let placed = |which: usize, run: usize| {
            let Disc { middle, radius } = *discs[which].shape(run);
            let Frame { centre, direction } = frames[which];
            Disc {
                middle: centre + direction * middle,
                radius,
            }
        };
        let mut open: Vec<[usize; 2]> = match (discs[0].whole(), discs[1].whole()) {
            (Some(one), Some(other)) => vec![[one, other]],
            _ => vec![],
        };
        while let Some(runs) = open.pop() {
            if !charge(left, 1) {
                return false;
            }
            let [own, mate] = [0, 1].map(|which: usize| placed(which, runs[which]));
            let reach = |disc: &Disc, circle: &Disc| !disc.is_apart(circle);
            let meets = reach(&own, &circles[0]) && reach(&mate, &circles[1]);
            if !meets || own.is_apart(&mate) {
                continue;
            }
            match [0, 1].map(|which: usize| discs[which].inside(runs[which])) {
                [
                    RunContent::Pieces([from, to]),
                    RunContent::Pieces([mate_from, mate_to]),
                ] => {
                    let own: Vec<PlacedStretch> =
                        self.stretches(0, locked, frames[0], from..to).collect();
                    let mut mates = self.stretches(1, free_tooth, frames[1], mate_from..mate_to);
                    if !mates.all(|mate| {
                        own.iter()
                            .all(|own| self.are_stretches_clear(own, &mate, left))
                    }) {
                        return false;
                    }
                }
                // The greater one is divided, if possible.
                [RunContent::Runs(parts), other]
                    if own.radius >= mate.radius || matches!(other, RunContent::Pieces(_)) =>
                {
                    open.extend(parts.map(|part| [part, runs[1]]));
                }
                [_, RunContent::Runs(parts)] => open.extend(parts.map(|part| [runs[0], part])),
                [RunContent::Runs(parts), _] => open.extend(parts.map(|part| [part, runs[1]])),
            }
        }
        true
    }

    /// Whether two stretches are proven clear.
    fn are_stretches_clear(
        &self,
        own: &PlacedStretch,
        mate: &PlacedStretch,
        left: &mut u32,
    ) -> bool {
        let within = own.reach() + mate.reach();
        if (own.middle() - mate.middle()).norm_squared() > within * within {
            return true;
        }
        if !charge(left, LOOK) {
            return false;
        }
        let finest = self.finest();
        let distance = closest(&own.ends, &mate.ends).distance;
        // The finest may be straight: only their rounding is left.
        if distance > (own.error + mate.error).max(2.0 * finest) {
            return true;
        }
        match (own.is_coarse(finest), mate.is_coarse(finest)) {
            (false, false) => false,
            (true, other) if !other || own.error >= mate.error => {
                let mut halves = own.halves().into_iter();
                halves.all(|half| self.are_stretches_clear(&half, mate, left))
            }
            _ => {
                let mut halves = mate.halves().into_iter();
                halves.all(|half| self.are_stretches_clear(own, &half, left))
            }
        }
    }
}
