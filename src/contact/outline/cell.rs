//! Bounds of one side's contact over a cell of locked rotations.
//!
//! The frame is the side's: free axis at the origin, locked axis at `a` on +x. In a cell the locked gear turns by `τ`, `|τ| ≤ w`. Each
//! bound is a line: the free gear has the rotation `level + g τ`. The rate `g` is the rate of the contact in the middle. In the frame of a
//! free gear that follows the line, a locked point `P` moves as follows. Its position in the middle is `P`, and `p = P − a` from the locked
//! axis.
//!
//! `P(τ) = a e^{−igτ} + p e^{i(1−g)τ}`, `P'(0) = i ((1−g) P − a)`, `P''(0) = −g² a − (1−g)² p`,
//! `|P'''| ≤ |g|³ a + |1−g|³ |p|`.
//!
//! Let `n` be a unit vector and `u = −i n`. The point reaches at most
//! `n·P + w |u·((1−g) P − a)| + w²/2 · max(0, n·P''(0) + w |P'''|/3)` along `n`. For either sign of `τ` the first two terms
//! are linear in `P`. Over a rectangle they are greatest at one of its corners. At a contact `u·((1−g) P − a)` is 0, so the
//! bound differs from the contact only by terms of second order in `w`.
//!
//! **Above** ([`SideCell::above`]). A line with the normal `n` separates the gears if no locked point passes it in the cell,
//! all free points lie beyond it, and `u·P > 0` for all of them. Then the angle grows from the locked to the free points
//! along every circle about the axis, and the pair's gap stays below the line of `level`. Rectangles enclose runs of pieces
//! and parts of pieces. A pair that no line separates is divided. If both are flat and short, the level rises by the missing
//! distance divided by its arm, the least `u·Q`.
//!
//! **Below** ([`SideCell::below`]). Take a locked point, and a stretch of the free outline that covers all radii of this
//! point in the cell. If a line has the stretch on its locked side and the point on its free side, the gap at the point's
//! radius is never below the line of `level`. The roles of the two gears may be exchanged.
//!
//! Both bounds are valid wherever the contact in the middle was found: it only says where to look. True outlines may lie
//! `bound` away from the drawn ones. Their effect on the level is kept apart (`drawn`), to first order.

use super::halves::FreeHalf;
use super::teeth::{Frame, SideTeeth};
use crate::contact::gap::{C, Inside, Rectangle, dot, turn};
use std::f64::consts::{FRAC_PI_2, PI};

/// Angle, rad, within which a narrow rectangle is seen on either side of its centre: sin 15° > 1/4.
const NARROW: f64 = 0.262;

/// Greatest level above the nominal rotation, rad, for a bound from below.
const MOST_LEVEL: f64 = 1.0;

/// Rounding of lengths, of the greatest in them.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Pairs of rectangles looked at before a bound is given up (tuned).
const MOST_PAIRS: u32 = 20_000;

/// Steps towards the level at which a line divides.
const STEPS: u32 = 6;

/// Halvings for the end of a stretch: a 4000th of a piece.
const HALVINGS: u32 = 12;

/// A bound of a side's gap: on the line of the cell's rate, rad from the nominal rotation in the middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    pub level: f64,
    /// Greatest effect of the outlines' error bounds, rad.
    pub drawn: f64,
}

/// The contact in the middle of a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    /// Gap, rad from the nominal rotation.
    pub level: f64,
    /// Locked and free tooth.
    pub teeth: [u32; 2],
    /// Piece and parameter of both.
    pub at: [(usize, f64); 2],
    /// Unit normals out of the locked metal: the common one, the locked curve's, the free curve's.
    pub normals: [C; 3],
}

/// A cell of rotations of one side.
#[derive(Debug)]
pub(super) struct SideCell<'a> {
    /// Locked and free.
    pub teeth: [&'a SideTeeth<'a>; 2],
    /// The free half teeth at rotation 0.
    pub still: &'a [FreeHalf<'a>],
    pub frames: [Frame; 2],
    /// Turn of the free gear to its nominal rotation in the middle.
    pub nominal: C,
    /// Centre distance, mm.
    pub distance: f64,
    /// Half the cell's width, rad of the locked gear.
    pub half: f64,
    /// The rate of the nominal rotation: the ratio of the teeth, negative.
    pub ratio: f64,
    /// The rate of the bounds.
    pub rate: f64,
    /// Resolution, rad of the free gear.
    pub fine: f64,
    /// Error bounds of both outlines together, mm.
    pub bound: f64,
}

/// A rectangle round a run of pieces or a part of a piece, where its frame puts it.
#[derive(Debug, Clone, Copy)]
struct Node {
    rectangle: Rectangle,
    within: Within,
}

#[derive(Debug, Clone, Copy)]
enum Within {
    Run(usize),
    /// A piece between two parameters.
    Part(usize, f64, f64),
}

/// A search from above.
struct Ascent {
    level: f64,
    drawn: f64,
    turned: C,
    looked: u32,
}

/// Result of a comparison of two rectangles.
enum Apart {
    Yes,
    /// Rise of the level, rad, that separates them; `None` if no line does.
    Above(Option<f64>),
}

impl SideCell<'_> {
    /// The greatest length, mm.
    fn size(&self) -> f64 {
        let reach = self.teeth.map(|teeth| teeth.gear.reach());
        self.distance + reach[0] + reach[1]
    }

    fn turned(&self, level: f64) -> C {
        self.nominal * turn(level)
    }

    /// How far the line of a bound leaves the nominal rotation within the cell, rad.
    fn drift(&self) -> f64 {
        (self.rate - self.ratio).abs() * self.half
    }

    /// The farthest that a point of `locked` reaches along the unit vector `n` in the cell, seen from the line's free gear, mm.
    fn farthest(&self, locked: &Rectangle, n: C) -> f64 {
        let (a, g, w) = (self.distance, self.rate, self.half);
        let u = n * -C::i();
        let slower = 1.0 - g;
        let to_either = [w, -w].map(|w| locked.farthest(n + u * (w * slower)) - w * a * u.re);
        // `n·P''` is greatest where `n·P` is least.
        let least = -locked.farthest(-n);
        let bent = (slower * slower - g * g) * a * n.re - slower * slower * least;
        let third =
            (g * g * g).abs() * a + (slower * slower * slower).abs() * self.teeth[0].gear.reach();
        let bent = f64::max(0.0, bent + w * third / 3.0);
        f64::max(to_either[0], to_either[1]) + 0.5 * w * w * bent
    }

    /// Bounds of the squares of the radii of `locked` in the cell: `|P|² = a² + |p|² + 2 a Re(e^{iτ} p)`.
    fn squares(&self, locked: &Rectangle) -> (f64, f64) {
        let (a, w) = (self.distance, self.half);
        let (least, most) = locked.squares();
        let aside = locked.farthest(C::i()).max(locked.farthest(-C::i()));
        let change = 2.0 * a * w * (aside.abs() + 0.5 * w * self.teeth[0].gear.reach());
        (least - change, most + change)
    }

    /// A level above the gaps of `pairs` of half teeth in the whole cell, from `floor` on, and how many rectangles were compared; `None` where
    /// the search ends without one.
    pub fn above(&self, pairs: impl Iterator<Item = [u32; 2]>, floor: f64) -> (Option<Bound>, u32) {
        let level = floor + self.fine;
        let mut ascent = Ascent {
            level,
            drawn: 0.0,
            turned: self.turned(level),
            looked: 0,
        };
        for teeth in pairs {
            if !self.part(teeth, &mut ascent) {
                return (None, ascent.looked);
            }
        }
        let Ascent { level, drawn, .. } = ascent;
        (Some(Bound { level, drawn }), ascent.looked)
    }

    /// Raises the level until a pair of half teeth is apart below it.
    fn part(&self, teeth: [u32; 2], ascent: &mut Ascent) -> bool {
        let whole = [0, 1].map(|gear: usize| {
            let run = self.teeth[gear].boxes(teeth[gear]).whole()?;
            Some(self.run(gear, teeth, run))
        });
        let [Some(locked), Some(free)] = whole else {
            return true;
        };
        let reach = self.teeth[1].gear.reach();
        // A rectangle no wider than that, and one no longer than that, are not cut.
        let flat = 0.25 * self.fine * reach;
        let short = 0.25 * self.half * self.teeth[0].gear.reach() + self.fine * reach;
        let mut open = vec![[locked, free]];
        'pairs: while let Some(pair) = open.pop() {
            let rectangles = pair.each_ref().map(|node| &node.rectangle);
            let is_flat = rectangles.iter().all(|it| it.width() <= flat);
            let is_small = is_flat && rectangles.iter().all(|it| it.length() <= short);
            for _ in 0..STEPS {
                ascent.looked += 1;
                if ascent.looked > MOST_PAIRS {
                    return false;
                }
                match self.apart(&pair, ascent, is_flat) {
                    Apart::Yes => continue 'pairs,
                    Apart::Above(Some(need)) if is_small || is_flat && need <= self.fine => {
                        ascent.level += need + 1e-3 * self.fine;
                        ascent.turned = self.turned(ascent.level);
                    }
                    Apart::Above(_) => break,
                }
            }
            let longer = usize::from(rectangles[1].length() > rectangles[0].length());
            let Some(parts) = self.divided(longer, teeth, &pair[longer]) else {
                return false;
            };
            for part in parts.into_iter().flatten() {
                let mut pair = pair;
                pair[longer] = part;
                open.push(pair);
            }
        }
        true
    }

    /// Whether a line divides two rectangles at the level, or their radii do. The rise is found only where it is needed.
    fn apart(&self, [locked, free]: &[Node; 2], ascent: &mut Ascent, needs_rise: bool) -> Apart {
        let (locked, free) = (&locked.rectangle, &free.rectangle);
        let size = self.size();
        let (squares, mates) = (self.squares(locked), free.squares());
        let room = ROUNDING * size * size + 2.0 * self.bound * size;
        if squares.0 > mates.1 + room || mates.0 > squares.1 + room {
            return Apart::Yes;
        }
        let turned = ascent.turned;
        let centre = locked.centre();
        let seen = turned * free.centre();
        let sway =
            self.half * ((1.0 - self.rate).abs() + self.distance / squares.0.max(0.0).sqrt());
        if !(locked.is_narrow() && free.is_narrow()) {
            return Apart::Above(None);
        }
        // Gaps differ from that of the centres by no more than both are wide, and count within half a turn of the nominal rotation.
        let play = 2.0 * NARROW + sway;
        let least = ascent.level - self.drift() - play;
        if !(least >= -FRAC_PI_2 && dot(centre, seen) >= 0.0) {
            let ahead = (centre * seen.conj()).arg();
            if !(least + ahead >= -PI && ahead <= FRAC_PI_2) {
                return Apart::Above(None);
            }
            if ahead < -play {
                return Apart::Yes;
            }
        }
        let mut need: Option<f64> = None;
        let between = centre + seen;
        let radial = || between / between.norm_sqr().sqrt();
        for way in 0..3 {
            let along = match way {
                0 => turned * free.along(),
                1 => locked.along(),
                _ => radial(),
            };
            let u = along * 1f64.copysign(dot(along, centre));
            let n = C::i() * u;
            let under = -free.farthest(turned.conj() * -n);
            // An overlap in the middle of the cell is one of the cell.
            if !needs_rise && locked.farthest(n) > under {
                continue;
            }
            let arm = -free.farthest(turned.conj() * -u);
            if !(arm > 0.0 && self.farthest(locked, -u) < 0.0) {
                continue;
            }
            let over = self.farthest(locked, n) - under + ROUNDING * size;
            if over <= 0.0 {
                ascent.drawn = ascent.drawn.max((over + self.bound) / arm);
                return Apart::Yes;
            }
            need = Some(need.map_or(over / arm, |need| need.min(over / arm)));
        }
        Apart::Above(need)
    }

    fn run(&self, gear: usize, teeth: [u32; 2], run: usize) -> Node {
        let rectangle = match gear {
            0 => {
                let Frame { centre, direction } = self.frames[0];
                let boxes = self.teeth[0].boxes(teeth[0]);
                boxes.shape(run).placed(centre, direction)
            }
            _ => *self.still[teeth[1] as usize - 1].rectangle(run),
        };
        Node {
            rectangle,
            within: Within::Run(run),
        }
    }

    /// A part of a piece.
    fn piece(&self, gear: usize, tooth: u32, piece: usize, [low, high]: [f64; 2]) -> Node {
        let it = &self.teeth[gear].half(tooth).pieces[piece];
        let Frame { centre, direction } = self.frames[gear];
        let rectangle = Rectangle::new(&it.curve, (low, high), |t| it.point(t));
        Node {
            rectangle: rectangle.placed(centre, direction),
            within: Within::Part(piece, low, high),
        }
    }

    /// The two parts of a node; `None` where it cannot be divided.
    fn divided(&self, gear: usize, teeth: [u32; 2], node: &Node) -> Option<[Option<Node>; 2]> {
        let tooth = teeth[gear];
        match node.within {
            Within::Run(run) => Some(match self.teeth[gear].boxes(tooth).inside(run) {
                Inside::Runs(runs) => runs.map(|run| Some(self.run(gear, teeth, run))),
                Inside::Pieces([piece, _]) => {
                    let it = &self.teeth[gear].half(tooth).pieces[piece];
                    let (low, high) = it.range();
                    // About the axis an arc has one radius, on which only its clockwise end can touch.
                    if gear == 1
                        && self.frames[1].centre == C::ZERO
                        && it.curve.is_about_the_origin()
                    {
                        return Some([Some(self.piece(gear, tooth, piece, [it.ends[1]; 2])), None]);
                    }
                    [Some(self.piece(gear, tooth, piece, [low, high])), None]
                }
            }),
            Within::Part(piece, low, high) => {
                let middle = 0.5 * (low + high);
                if !(low < middle && middle < high) {
                    return None;
                }
                let part = |ends| Some(self.piece(gear, tooth, piece, ends));
                Some([part([low, middle]), part([middle, high])])
            }
        }
    }

    /// A level that the gap of the contact's own half teeth does not fall below in the whole cell; `None` where none is shown.
    pub fn below(&self, touching: &Touching) -> Option<Bound> {
        let [(locked, t), (free, u)] = touching.at;
        let point = |gear: usize, piece: usize, at: f64| {
            let half = self.teeth[gear].half(touching.teeth[gear]);
            let Frame { centre, direction } = self.frames[gear];
            Rectangle::point(centre + direction * half.pieces[piece].point(at))
        };
        let size = self.size();
        let room = ROUNDING * size * size + 2.0 * self.bound * size;
        let (p, q) = (point(0, locked, t), point(1, free, u));
        let (least, most) = self.squares(&p);
        let square = q.squares();
        // Tips of the free gear are far from its axis, those of the locked one near it.
        let frees = self.stretch(1, touching, &|at| at.squares().0 >= most + room, &|at| {
            at.squares().1 <= least - room
        });
        let lockeds = self.stretch(
            0,
            touching,
            &|at| self.squares(at).1 <= square.0 - room,
            &|at| self.squares(at).0 >= square.1 + room,
        );
        let mut best: Option<Bound> = None;
        for n in touching.normals {
            let one = frees
                .as_ref()
                .and_then(|frees| self.held(n, touching.level, &[p], frees));
            let other = lockeds
                .as_ref()
                .and_then(|all| self.held(n, touching.level, all, &[q]));
            for found in [one, other].into_iter().flatten() {
                if best.is_none_or(|best| found.level > best.level) {
                    best = Some(found);
                }
            }
        }
        best
    }

    /// Rectangles round a stretch of a half tooth round its contact, towards the tip to where `tip` holds and towards the root to where `root` does.
    fn stretch(
        &self,
        gear: usize,
        touching: &Touching,
        tip: &dyn Fn(&Rectangle) -> bool,
        root: &dyn Fn(&Rectangle) -> bool,
    ) -> Option<Vec<Rectangle>> {
        let tooth = touching.teeth[gear];
        let pieces = &self.teeth[gear].half(tooth).pieces;
        let Frame { centre, direction } = self.frames[gear];
        let at =
            |piece: usize, t: f64| Rectangle::point(centre + direction * pieces[piece].point(t));
        let (own, from) = touching.at[gear];
        let mut round = vec![at(own, from)];
        for (end, ends) in [(0, tip), (1, root)] {
            let (mut piece, mut from) = (own, from);
            while !ends(&at(piece, from)) {
                let mut to = pieces[piece].ends[end];
                let is_last = ends(&at(piece, to));
                if is_last {
                    let mut short = from;
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (short + to);
                        if ends(&at(piece, middle)) {
                            to = middle;
                        } else {
                            short = middle;
                        }
                    }
                }
                if from != to {
                    let part = [from.min(to), from.max(to)];
                    round.push(self.piece(gear, tooth, piece, part).rectangle);
                }
                if is_last {
                    break;
                }
                piece = match end {
                    0 => piece.checked_sub(1)?,
                    _ => piece + 1,
                };
                from = pieces.get(piece)?.ends[1 - end];
            }
        }
        Some(round)
    }

    /// The level, from `level` down, at which a line with the normal `n` has `free` wholly on its locked side and `locked` on its free side
    /// throughout the cell.
    fn held(
        &self,
        n: C,
        mut level: f64,
        locked: &[Rectangle],
        free: &[Rectangle],
    ) -> Option<Bound> {
        let u = n * -C::i();
        let is_narrow = |all: &[Rectangle]| all.iter().all(Rectangle::is_narrow);
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
        let before = most(&mut locked.iter().map(|it| self.farthest(it, -u))) < 0.0;
        if !(before && is_narrow(locked) && is_narrow(free)) {
            return None;
        }
        let least = -most(&mut locked.iter().map(|it| self.farthest(it, -n)));
        for _ in 0..STEPS {
            let back = self.turned(level).conj();
            let arm = -most(&mut free.iter().map(|it| it.farthest(back * -u)));
            if !(arm > 0.0 && level + self.drift() <= MOST_LEVEL) {
                return None;
            }
            let reached = most(&mut free.iter().map(|it| it.farthest(back * n)));
            let over = reached - least + ROUNDING * self.size();
            if over <= 0.0 {
                let drawn = self.bound / arm;
                return Some(Bound { level, drawn });
            }
            level -= over / arm + 1e-3 * self.fine;
        }
        None
    }
}
