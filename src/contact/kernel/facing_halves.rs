//! Two convex pieces that face each other at a rotation of the free gear, and directions that separate them.
//!
//! The frame is that of [`crate::contact::exact`]: free axis at the origin, locked axis at `(a, 0)`, left side mirrored. A piece is at `C +
//! e^{iθ} P`; the free gear turns by `μ` about the origin. In a direction `n = e^{iν}` out of the locked metal the room between the
//! supporting lines is
//!
//! ```text
//! s   = (C_F − C_L)·n − h_L(ν − θ_L) − h_F(ν + π − θ_F − μ)
//! s_ν = (C_F − C_L)·in − h_L' − h_F';   s_νν = −(ρ_L + ρ_F) − s
//! s_μ = h_F' − C_F·in;   the arm of a force along n about the free axis.
//! ```
//!
//! `s > 0` in one direction proves the pieces apart, however the direction was found. If the arm is also above 0, `s` rises with `μ` until
//! the normal passes the axis on its far side: the pieces stay apart as the free gear turns further. If the arm is below 0, they stay apart
//! over a play of `w` if `s > |s_μ| w + r w²`. Here `r` is the free gear's greatest radius about its axis: `|s_μμ| = |H − ρ_F| ≤ 2r`, with
//! the support `H` about the axis. A piece is *out of reach* at every rotation if a direction keeps it off the disc in which the free piece
//! turns.

use super::convex::{Convex, Support, along, wrapped};
use super::proof::Reason;
use crate::contact::gap::{C, dot, turn};
use std::cell::Cell;
use std::f64::consts::PI;

/// Limit of directions on one side; ordinary sides need 15 to 60.
const MOST_DIRECTIONS_OF_SIDE: u32 = 4000;

/// Limit of directions for one pair of pieces.
const MOST_DIRECTIONS: u32 = 48;

/// Range of directions on either side of the first, rad.
const HALF_RANGE: f64 = 1.7;

/// Greatest step between two directions, rad.
const GREATEST_STEP: f64 = 0.3;

/// Two half teeth at their positions in a pose, the locked one first.
#[derive(Debug, Clone, Copy)]
pub(super) struct FacingHalves<'a> {
    /// Centres of the outlines, mm.
    pub centres: [C; 2],
    /// `θ` of each, rad, that of the free one including its rotation; within ±π.
    pub angles: [f64; 2],
    /// `e^{iθ}`.
    pub directions: [C; 2],
    /// Part of the free gear's rotation over which the pieces must stay apart, rad; infinite if no other contact ends it.
    pub play: f64,
    /// Greatest radius of the free gear about its axis, mm.
    pub radius: f64,
    /// Room, mm, that pieces must exceed to be apart.
    pub margin: f64,
    /// Counts the directions examined on the side of the pose.
    pub tried: &'a Cell<u32>,
}

/// The room between two pieces in one direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room {
    /// `s`, mm.
    pub room: f64,
    /// `s_ν`, mm.
    pub slope: f64,
    /// `ρ_L + ρ_F`, mm.
    pub radius: f64,
    /// `s_μ`, mm.
    pub arm: f64,
    /// Its slope over `ν`, mm: `c·n` of the centre `c` of curvature of the free piece.
    pub arm_slope: f64,
}

/// The proof that two pieces are apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Apart {
    pub by: Reason,
    /// The direction out of the locked metal, or the normal of the middle tangent.
    pub normal: C,
}

impl Apart {
    /// By a direction out of the locked metal, which holds at this and every greater rotation.
    pub fn along(normal: C) -> Apart {
        let by = Reason::Direction;
        Apart { by, normal }
    }
}

impl FacingHalves<'_> {
    /// Counts a direction.
    #[inline]
    pub fn count(&self) {
        self.tried.set(self.tried.get() + 1);
    }

    /// Whether the limit of directions is exceeded.
    pub fn is_spent(&self) -> bool {
        self.tried.get() > MOST_DIRECTIONS_OF_SIDE
    }

    /// These halves with a margin that is `more` mm wider.
    pub fn wider(&self, more: f64) -> Self {
        let margin = self.margin + more;
        FacingHalves { margin, ..*self }
    }

    /// Whether a room, mm, with this arm keeps two pieces apart as the free gear turns further.
    #[inline]
    pub fn stays_apart(&self, room: f64, arm: f64) -> bool {
        let lost = if arm > 0.0 {
            0.0
        } else {
            self.play * (self.radius * self.play - arm)
        };
        room > self.margin + lost
    }

    /// The supports of `locked` along the direction `n = e^{iν}` and of `free` against it, `ν` within ±π.
    #[inline]
    pub fn supports(&self, locked: &Convex, free: &Convex, nu: f64, n: C) -> [Support; 2] {
        let own = n * self.directions[0].conj();
        let locked = locked.support(wrapped(nu - self.angles[0]), own);
        let own = -n * self.directions[1].conj();
        let free = free.support(wrapped(wrapped(nu + PI) - self.angles[1]), own);
        [locked, free]
    }

    /// The room between `locked` and `free` in the direction `n = e^{iν}`, `ν` within ±π.
    #[inline]
    pub fn room(&self, locked: &Convex, free: &Convex, nu: f64, n: C) -> Room {
        self.room_of(&self.supports(locked, free, nu, n), n)
    }

    /// The room between two pieces with these supports along `n`.
    #[inline]
    pub fn room_of(&self, &[l, f]: &[Support; 2], n: C) -> Room {
        let d = self.centres[1] - self.centres[0];
        Room {
            room: dot(d, n) - l.reach - f.reach,
            slope: along(d, n) - l.along - f.along,
            radius: l.radius + f.radius,
            arm: self.least_arm(f, n),
            arm_slope: dot(self.centres[1], n) - f.reach + f.radius,
        }
    }

    /// The middle between the supporting points of both pieces in the direction near `start` in which these face each other, if they overlap
    /// by at most `depth` mm there.
    pub fn middle(&self, [locked, free]: &[Convex; 2], start: C, depth: f64) -> Option<C> {
        let mut n = start;
        for _ in 0..4 {
            let here = self.room(locked, free, n.arg(), n);
            if here.radius > 0.0 {
                n *= turn((here.slope / here.radius).clamp(-GREATEST_STEP, GREATEST_STEP));
            }
        }
        let point = |piece: &Convex, k: usize, n: C| {
            let own = n * self.directions[k].conj();
            let support = piece.support(own.arg(), own);
            self.centres[k] + n * C::new(support.reach, support.along)
        };
        let room = self.room(locked, free, n.arg(), n).room;
        let touches = room < 0.0 && room >= -depth;
        touches.then(|| 0.5 * (point(locked, 0, n) + point(free, 1, -n)))
    }

    /// The least arm of the free piece against `n` about its axis, while the direction passes its next corner and its land.
    ///
    /// On a land the room changes by `c·n`, with its centre `c`. An arm above 0 may change sign there: the room then rises and falls. At the
    /// near corner `p` it has an arm of `-e`, and falls by at most `|p| - |p·n| ≤ e²/(2 |p·n|)` from there. If the land's way gained as much
    /// as that, the room never falls below its value here, and the arm here is the answer.
    #[inline]
    pub fn least_arm(&self, free: Support, n: C) -> f64 {
        let centre = self.centres[1];
        let arm = free.lever - along(centre, n);
        if !(free.ahead > 0.0) {
            return arm;
        }
        let end = centre * turn(free.ahead.min(self.play));
        let at_end = -along(end, n);
        let corner = dot(end, n) - free.radius;
        let gained = dot(end - centre, n);
        let is_on_land = free.radius > 0.0;
        if is_on_land && arm > 0.0 && corner < 0.0 && -2.0 * corner * gained > at_end * at_end {
            return arm;
        }
        arm.min(at_end)
    }

    /// The proof that both pieces are apart. Newton's method on `s_ν` in a bracket finds a direction, first from `start`, then from the free
    /// tooth's own side.
    pub fn find_separation(&self, locked: &Convex, free: &Convex, start: f64) -> Option<Apart> {
        let own_side = wrapped(self.angles[1] + 0.5 * PI);
        self.find_separation_from(locked, free, start)
            .or_else(|| self.find_out_of_reach(locked, free))
            .or_else(|| {
                let far = wrapped(own_side - start).abs() > 0.5;
                far.then(|| self.find_separation_from(locked, free, own_side))?
            })
    }

    fn find_separation_from(&self, locked: &Convex, free: &Convex, start: f64) -> Option<Apart> {
        // Directions, relative to the start, that enclose the greatest room, and the room there.
        let (mut low, mut high) = (-HALF_RANGE, HALF_RANGE);
        let mut ends: [Option<Room>; 2] = [None; 2];
        let mut off = 0.0;
        for tried in 0..MOST_DIRECTIONS {
            self.count();
            let nu = wrapped(start + off);
            let n = turn(nu);
            let here = self.room(locked, free, nu, n);
            if self.stays_apart(here.room, here.arm) {
                return Some(Apart::along(n));
            }
            if here.room > self.margin && !(here.arm > 0.0) {
                return self.find_with_arm(locked, free, (nu, here));
            }
            if here.slope > 0.0 {
                low = off;
                ends[0] = Some(here);
            } else {
                high = off;
                ends[1] = Some(here);
            }
            if let [Some(one), Some(other)] = ends
                && greatest_between(one, other, high - low) < self.margin
            {
                return None;
            }
            let bend = here.radius + here.room;
            let newton = if bend > 1e-9 {
                (here.slope / bend).clamp(-GREATEST_STEP, GREATEST_STEP)
            } else {
                0.1f64.copysign(here.slope)
            };
            // Because of `s + s'' ≤ 0` no direction within a right angle has more than this.
            if tried > 2
                && newton.abs() < 1e-5
                && here.room + here.slope * newton < 0.0
                && bend > 1e-3
            {
                return None;
            }
            let next = off + newton;
            let next = if next > low && next < high && (tried < 8 || tried % 2 == 1) {
                next
            } else {
                0.5 * (low + high)
            };
            if (next - off).abs() < 1e-15 {
                return None;
            }
            off = next;
        }
        None
    }

    /// A direction with a positive arm near `nu`, where there is room without one. Newton's method on the arm.
    fn find_with_arm(
        &self,
        locked: &Convex,
        free: &Convex,
        (mut nu, mut here): (f64, Room),
    ) -> Option<Apart> {
        for _ in 0..6 {
            let step = (1e-6 * self.radius - 1.1 * here.arm) / here.arm_slope;
            nu = wrapped(nu + step);
            self.count();
            let n = turn(nu);
            here = self.room(locked, free, nu, n);
            if self.stays_apart(here.room, here.arm) {
                return Some(Apart::along(n));
            }
            if !(here.room > self.margin) || here.arm > 0.0 {
                return None;
            }
        }
        None
    }

    /// The proof that the locked piece is off the disc about the free axis in which the free piece turns.
    fn find_out_of_reach(&self, locked: &Convex, free: &Convex) -> Option<Apart> {
        let radius = free.farthest(self.centres[1] * self.directions[1].conj());
        self.beyond(locked, radius)
    }

    /// The proof that the locked piece is off the disc of this radius, mm, about the free axis.
    pub fn beyond(&self, locked: &Convex, radius: f64) -> Option<Apart> {
        let mut nu = (-self.centres[0]).arg();
        for _ in 0..24 {
            self.count();
            let n = turn(nu);
            let l = locked.support(wrapped(nu - self.angles[0]), n * self.directions[0].conj());
            let room = -dot(self.centres[0], n) - l.reach - radius;
            if room > self.margin {
                return Some(Apart {
                    by: Reason::OutOfReach,
                    normal: n,
                });
            }
            let slope = -along(self.centres[0], n) - l.along;
            let bend = l.radius + room + radius;
            let is_hopeless = slope.abs() < 0.3 * bend && room + slope * slope / bend < 0.0;
            if !(bend > 0.0) || is_hopeless {
                return None;
            }
            nu = wrapped(nu + (slope / bend).clamp(-0.5, 0.5));
        }
        None
    }
}

/// Upper bound of the room between two directions that are `width` rad apart and enclose the greatest: because of `s + s'' ≤ 0` both tangents
/// bound it.
fn greatest_between(one: Room, other: Room, width: f64) -> f64 {
    if width > 0.5 {
        return f64::INFINITY;
    }
    let (rise, fall) = (one.slope, -other.slope);
    let across = (other.room - one.room + fall * width) / (rise + fall);
    let bend = 0.5 * width * width * one.room.abs().max(other.room.abs());
    one.room + rise * across.clamp(0.0, width) + bend
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::exact::HalfToothShape;
    use crate::gear::{Gear, GearDesign, Profile};

    fn shape(teeth: u32) -> HalfToothShape {
        let gear = Gear::nominal(GearDesign::plain(teeth, 2.0)).unwrap();
        HalfToothShape::new(&Profile::new(&gear))
    }

    /// The right-hand halves of 20 and 30 teeth at 50.4 mm, eccentric, the free one turned by `rotation`.
    fn at(rotation: f64) -> FacingHalves<'static> {
        let angles = [PI + 0.03, wrapped(0.02 + rotation)];
        FacingHalves {
            centres: [C::new(50.4, 0.01), turn(rotation) * C::new(0.02, -0.03)],
            angles,
            directions: angles.map(turn),
            play: f64::INFINITY,
            radius: 33.0,
            margin: 1e-12,
            tried: Box::leak(Box::new(Cell::new(0))),
        }
    }

    /// The tops of both.
    fn tops(shapes: &[HalfToothShape; 2]) -> [Convex<'_>; 2] {
        shapes
            .each_ref()
            .map(|shape| Convex::top(shape, shape.tip_corner().conj()))
    }

    /// Source: differences of the room by the direction and by the rotation.
    #[test]
    fn slopes_are_those_of_the_room() {
        let shapes = [shape(20), shape(30)];
        let [locked, free] = tops(&shapes);
        let room = |rotation: f64, nu: f64| at(rotation).room(&locked, &free, nu, turn(nu));
        const STEP: f64 = 1e-6;
        for k in 0..60 {
            let (rotation, nu) = (0.02 * f64::from(k % 10) - 0.1, 1.2 + 0.02 * f64::from(k));
            let here = room(rotation, nu);
            let beside = [-STEP, STEP].map(|by| [room(rotation, nu + by), room(rotation + by, nu)]);
            let slope = |i: usize| (beside[1][i].room - beside[0][i].room) / (2.0 * STEP);
            assert!((slope(0) - here.slope).abs() < 1e-4, "{k}: {here:?}");
            assert!((slope(1) - here.arm).abs() < 1e-4, "{k}: {here:?}");
            let bend = (beside[1][0].slope - beside[0][0].slope) / (2.0 * STEP);
            let smooth = beside
                .iter()
                .all(|b| (b[0].radius - here.radius).abs() < 1e-3);
            assert!(
                !smooth || (bend + here.radius + here.room).abs() < 1e-3,
                "{k}: {bend}"
            );
        }
    }

    /// Source: the room of the turned piece. Eccentric lands whose arms change sign under way, from past the far corner to before the near one.
    #[test]
    fn a_room_with_an_arm_does_not_fall() {
        const PLAY: f64 = 0.4;
        let shapes = [shape(20), shape(30)];
        let [locked, free] = tops(&shapes);
        let mut held = 0;
        for centre in (0..126).map(|k| C::from_polar(3.0, 0.05 * f64::from(k))) {
            let turned = |by: f64| FacingHalves {
                centres: [C::new(50.4, 0.01), turn(0.02 + by) * centre],
                play: PLAY,
                ..at(0.02 + by)
            };
            for nu in (0..720).map(|k| wrapped(0.003 + PI * f64::from(k) / 360.0)) {
                let n = turn(nu);
                let here = turned(0.0).room(&locked, &free, nu, n);
                // Towards the mate: behind the axis the room falls again.
                if !(here.arm > 0.0 && n.re < -0.5) {
                    continue;
                }
                held += 1;
                for by in [0.02, 0.1, 0.2, PLAY] {
                    let there = turned(by).room(&locked, &free, nu, n);
                    assert!(there.room >= here.room - 1e-12, "{nu} {by} {here:?}");
                }
            }
        }
        assert!(held > 200, "{held}");
    }

    /// The room loses no more than its arm and the turn allow as the free gear turns further. Source: the room of the turned piece.
    #[test]
    fn a_room_falls_no_faster_than_its_arm() {
        let shapes = [shape(20), shape(30)];
        let [locked, free] = tops(&shapes);
        let land = Convex::arc(26.0, 0.02, 0.09);
        let chord = Convex::Chord([C::new(27.0, 0.4), C::new(27.4, -0.3)]);
        for free in [&free, &land, &chord] {
            for k in 0..720 {
                let nu = wrapped(0.003 + PI * f64::from(k) / 360.0);
                let n = turn(nu);
                let here = at(0.02).room(&locked, free, nu, n);
                for by in [0.001, 0.004, 0.016] {
                    let there = at(0.02 + by).room(&locked, free, nu, n);
                    let least = here.room + by * here.arm - 33.0 * by * by;
                    assert!(there.room >= least - 1e-12, "{k} {by}: {there:?}, {here:?}");
                }
            }
        }
        let endless = at(0.0).wider(1.0);
        assert!(endless.stays_apart(2.0, 1e-9) && !endless.stays_apart(1.0, 1e-9));
        assert!(!endless.stays_apart(2.0, 0.0));
    }

    /// Newton's method needs few directions, for pieces that hardly leave room and for pieces that hardly overlap. Source: ordinary pairs
    /// need 15 to 60 a side.
    #[test]
    fn few_directions_decide() {
        let shapes = [shape(20), shape(30)];
        let [locked, free] = tops(&shapes);
        let apart = |rotation: f64, start: f64| {
            let at = at(rotation);
            let apart = at.find_separation_from(&locked, &free, start);
            (apart.is_some(), at.tried.get())
        };
        let (mut low, mut high) = (-0.1, 0.3);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if apart(middle, 1.9).0 {
                high = middle
            } else {
                low = middle
            }
        }
        for start in [1.5, 1.7, 1.9, 2.1] {
            for off in [1e-10, 1e-8, 1e-6, 1e-4] {
                let (is_apart, directions_tried) = apart(high + off, start);
                assert!(
                    is_apart && (1..=8).contains(&directions_tried),
                    "{start} {off}: {directions_tried}"
                );
                let (is_apart, directions_tried) = apart(low - off, start);
                assert!(
                    !is_apart && (1..=10).contains(&directions_tried),
                    "{start} {off}: {directions_tried}"
                );
            }
        }
        let at = at(0.0);
        let disc = free.farthest(at.centres[1] * at.directions[1].conj());
        assert!(at.beyond(&locked, 0.3 * disc).is_some());
        assert!(at.beyond(&locked, disc).is_none());
        assert!((2..=8).contains(&at.tried.get()), "{:?}", at.tried);
    }

    /// Pieces that one direction with a positive arm separates stay apart as the free gear turns further, up to a right angle. Source: new
    /// directions.
    #[test]
    fn separated_pieces_stay_apart() {
        let shapes = [shape(20), shape(30)];
        let [locked, free] = tops(&shapes);
        let mut kept = 0;
        for start in 0..40 {
            let rotation = -0.1 + 0.01 * f64::from(start);
            let apart = at(rotation).find_separation(&locked, &free, 1.9);
            let Some(apart) = apart.filter(|apart| apart.by == Reason::Direction) else {
                continue;
            };
            let n = apart.normal;
            kept += 1;
            let first = at(rotation).room(&locked, &free, n.arg(), n).room;
            for on in 1..30 {
                let there = at(rotation + 0.04 * f64::from(on));
                let here = there.room(&locked, &free, n.arg(), n);
                assert!(here.arm <= 0.0 || here.room > first, "{start} {on}");
                let apart = there.find_separation(&locked, &free, 1.9);
                assert!(apart.is_some(), "{start} {on}");
            }
        }
        assert!(kept > 10 && kept < 40, "{kept}");
    }
}
