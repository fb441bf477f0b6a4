//! Bounds of one side's contact over a cell of locked rotations.
//!
//! The frame is the side's: free axis at the origin, locked axis at `a` on +x. In a cell the locked gear turns by `τ`, `|τ| ≤ w`. Each
//! bound is a line: the free gear has the rotation `level + g τ`. The rate `g` is that of a contact, or of the chord between the contacts at the
//! ends. In the frame of a free gear that follows the line, a locked point that is at `P` in the middle, `p = P − a` from the locked axis, is at
//! `P(τ) = a e^{−igτ} + p e^{i(1−g)τ}`.
//!
//! A line that divides the gears turns with the locked gear, at the rate `κ = 1 − g`, or stands still with the free one, `κ = 0`. Where a
//! corner slides along a straight edge, the line that turns with the edge touches it all through the cell. Let `n` be its unit normal in the
//! middle, and `u = −i n`. Along the normal the locked point is at `n·(a e^{−i(g+κ)τ} + p e^{i(1−g−κ)τ})`, and a free point `Q` at
//! `n·(Q e^{−iκτ})`. A function `f` of `τ` is at most `f(0) ± w f'(0) + w²/2 · max(0, f''(0) + w/3 · max |f'''|)`.
//! `f(0)` and `f'(0)` are linear in `P` and `Q`: `n·P` with `u·((1−g−κ) P − a)`, and `n·Q` with `−κ u·Q`. For either sign they are
//! greatest together at a corner of a rectangle ([`Reach`]). At a contact `P = Q` and `u·((1−g) P − a)` is 0, so the bound differs from the
//! contact only by the second order of `w`.
//!
//! **Above** ([`SideCell::above`]). A line separates the gears if no locked point passes it in the cell,
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
use crate::contact::gap::{C, Rectangle, RunContent, dot, turn};
use crate::numeric::root_beyond;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Add;

/// Angle, rad, within which a narrow rectangle is seen on either side of its centre: sin 15° > 1/4.
const NARROW: f64 = 0.262;

/// Greatest level above the nominal rotation, rad, for a bound from below.
const MOST_LEVEL: f64 = 1.0;

/// Rounding of lengths, of the greatest in them.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Pairs of rectangles looked at before a bound is given up (tuned).
const MOST_PAIRS: u32 = 20_000;

/// Rectangles of a half tooth for which there is room at first (tuned).
const ROOM: usize = 64;

/// Greatest rate of a bound over the ratio of the teeth. The ratio itself replaces greater rates.
const FASTEST: f64 = 4.0;

/// Steps towards the level at which a line divides.
const STEPS: u32 = 6;

/// Fineness of the end of a stretch, as a part of the squares of radii of its piece (tuned).
const END: f64 = 1.0 / 4096.0;

/// A bound of a side's gap: on the line of the cell's rate, rad from the nominal rotation in the middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    pub level: f64,
    /// Greatest effect of the outlines' error bounds, rad.
    pub drawn: f64,
}

/// A contact, in the middle of a cell on the line through it.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactInCell {
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
#[derive(Debug, Clone, Copy)]
pub(super) struct SideCell<'a> {
    /// Locked and free.
    pub teeth: [&'a SideTeeth<'a>; 2],
    /// The free half teeth at rotation 0.
    pub free_halves: &'a [FreeHalf<'a>],
    pub frames: [Frame; 2],
    /// Greatest radius of each gear about its axis, mm.
    pub reach: [f64; 2],
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
    /// Bounds of the squares of its points' radii in the cell, mm².
    squares: (f64, f64),
    within: NodeContent,
    /// Where its parts begin among the nodes, and their number; 0 before it is divided.
    parts: (usize, usize),
}

#[derive(Debug, Clone, Copy)]
enum NodeContent {
    Run(usize),
    /// A piece between two parameters.
    Part(usize, f64, f64),
}

/// A search from above.
struct SearchFromAbove {
    level: f64,
    drawn: f64,
    turned: C,
    compared: u32,
}

/// How far points reach along a direction in a cell: a bound at either end from value and slope in the middle, the second derivative there,
/// and the greatest third one.
#[derive(Debug, Clone, Copy)]
struct Reach {
    to_either: [f64; 2],
    bent: f64,
    third: f64,
}

impl Add for Reach {
    type Output = Reach;

    fn add(self, other: Reach) -> Reach {
        Reach {
            to_either: [0, 1].map(|k: usize| self.to_either[k] + other.to_either[k]),
            bent: self.bent + other.bent,
            third: self.third + other.third,
        }
    }
}

/// Result of a comparison of two rectangles.
enum Comparison {
    /// A line divides them, or their radii do.
    Apart,
    /// Rise of the level, rad, that separates them; `None` if no line does.
    Overlap(Option<f64>),
}

impl SideCell<'_> {
    /// The greatest length, mm.
    fn size(&self) -> f64 {
        self.distance + self.reach[0] + self.reach[1]
    }

    /// This rate, or that of the nominal rotation in place of a much greater one.
    pub fn limited(&self, rate: f64) -> f64 {
        if (rate / self.ratio).abs() <= FASTEST {
            rate
        } else {
            self.ratio
        }
    }

    fn turned(&self, level: f64) -> C {
        self.nominal * turn(level)
    }

    /// How far the line of a bound leaves the nominal rotation within the cell, rad.
    fn drift(&self) -> f64 {
        (self.rate - self.ratio).abs() * self.half
    }

    /// Rate at which a direction turns that is fixed to a gear, seen from the line's free gear.
    fn turns_with(&self, gear: usize) -> f64 {
        [1.0 - self.rate, 0.0][gear]
    }

    /// How far `locked` reaches along a direction that is `n` in the middle and turns at the rate `turning`.
    fn locked_reach(&self, locked: &Rectangle, n: C, turning: f64) -> Reach {
        let (a, w) = (self.distance, self.half);
        let (own, axis) = (1.0 - self.rate - turning, self.rate + turning);
        let u = n * -C::i();
        // `n·P''` is greatest where `n·P` is least.
        let bent = (own * own - axis * axis) * a * n.re + own * own * locked.farthest(-n);
        let third = axis.abs().powi(3) * a + own.abs().powi(3) * self.reach[0];
        Reach {
            to_either: [w, -w].map(|w| locked.farthest(n + u * (w * own)) - w * a * u.re),
            bent,
            third,
        }
    }

    /// Like [`SideCell::locked_reach`], of a free rectangle that `back` turns back from the level to rotation 0.
    fn free_reach(&self, free: &Rectangle, n: C, turning: f64, back: C) -> Reach {
        let n = back * n;
        if turning == 0.0 {
            return Reach {
                to_either: [free.farthest(n); 2],
                bent: 0.0,
                third: 0.0,
            };
        }
        let (u, w) = (n * -C::i(), self.half);
        Reach {
            to_either: [w, -w].map(|w| free.farthest(n - u * (w * turning))),
            bent: turning * turning * free.farthest(-n),
            third: turning.abs().powi(3) * self.reach[1],
        }
    }

    /// The greatest value of a reach in the cell, mm.
    fn greatest(&self, reach: Reach) -> f64 {
        let w = self.half;
        let bent = f64::max(0.0, reach.bent + w * reach.third / 3.0);
        f64::max(reach.to_either[0], reach.to_either[1]) + 0.5 * w * w * bent
    }

    /// The greatest value of all reaches in the cell, mm.
    fn most(&self, reaches: impl Iterator<Item = Reach>) -> f64 {
        let values = reaches.map(|reach| self.greatest(reach));
        values.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Bounds of the squares of the radii of `locked` in the cell: `|P|² = a² + |p|² + 2 a Re(e^{iτ} p)`.
    fn squares(&self, locked: &Rectangle) -> (f64, f64) {
        let (a, w) = (self.distance, self.half);
        let (least, most) = locked.squares();
        let aside = locked.farthest(C::i()).max(locked.farthest(-C::i()));
        let change = 2.0 * a * w * (aside.abs() + 0.5 * w * self.reach[0]);
        (least - change, most + change)
    }

    /// A level above the gaps of `pairs` of half teeth in the whole cell, from `floor` on, and how many rectangles were compared; `None` where
    /// the search ends without one.
    pub fn above(&self, pairs: impl Iterator<Item = [u32; 2]>, floor: f64) -> (Option<Bound>, u32) {
        let level = floor + self.fine;
        let mut search = SearchFromAbove {
            level,
            drawn: 0.0,
            turned: self.turned(level),
            compared: 0,
        };
        let mut open = Vec::with_capacity(ROOM);
        let mut nodes = [0, 1].map(|_| Vec::with_capacity(ROOM));
        for teeth in pairs {
            open.clear();
            nodes.iter_mut().for_each(Vec::clear);
            if !self.part(teeth, &mut search, &mut nodes, &mut open) {
                return (None, search.compared);
            }
        }
        let SearchFromAbove { level, drawn, .. } = search;
        (Some(Bound { level, drawn }), search.compared)
    }

    /// Raises the level until a pair of half teeth is apart below it. `nodes` and `open` are empty.
    fn part(
        &self,
        teeth: [u32; 2],
        search: &mut SearchFromAbove,
        nodes: &mut [Vec<Node>; 2],
        open: &mut Vec<[usize; 2]>,
    ) -> bool {
        for gear in [0, 1] {
            let Some(run) = self.teeth[gear].boxes(teeth[gear]).whole() else {
                return true;
            };
            nodes[gear].push(self.run(gear, teeth, run));
        }
        let reach = self.reach[1];
        // A rectangle no wider than that, and one no longer than that, are not cut.
        let flat = 0.25 * self.fine * reach;
        let short = 0.25 * self.half * self.reach[0] + self.fine * reach;
        open.push([0, 0]);
        'pairs: while let Some(pair) = open.pop() {
            let both = [0, 1].map(|gear: usize| &nodes[gear][pair[gear]]);
            let rectangles = both.map(|node| &node.rectangle);
            let is_flat = rectangles.iter().all(|it| it.width() <= flat);
            let is_small = is_flat && rectangles.iter().all(|it| it.length() <= short);
            for _ in 0..STEPS {
                search.compared += 1;
                if search.compared > MOST_PAIRS {
                    return false;
                }
                match self.apart(both, search, is_flat) {
                    Comparison::Apart => continue 'pairs,
                    Comparison::Overlap(Some(need)) if is_small || is_flat && need <= self.fine => {
                        search.level += need + 1e-3 * self.fine;
                        search.turned = self.turned(search.level);
                    }
                    Comparison::Overlap(_) => break,
                }
            }
            let longer = usize::from(rectangles[1].length() > rectangles[0].length());
            let Some((from, count)) = self.divided(longer, teeth, &mut nodes[longer], pair[longer])
            else {
                return false;
            };
            for part in from..from + count {
                let mut pair = pair;
                pair[longer] = part;
                open.push(pair);
            }
        }
        true
    }

    /// Whether a line divides two rectangles at the level, or their radii do. The rise is found only where it is needed.
    fn apart(
        &self,
        nodes: [&Node; 2],
        search: &mut SearchFromAbove,
        needs_rise: bool,
    ) -> Comparison {
        let [locked, free] = nodes.map(|node| &node.rectangle);
        let size = self.size();
        let [squares, mates] = nodes.map(|node| node.squares);
        let room = ROUNDING * size * size + 2.0 * self.bound * size;
        if squares.0 > mates.1 + room || mates.0 > squares.1 + room {
            return Comparison::Apart;
        }
        let turned = search.turned;
        let centre = locked.centre();
        let seen = turned * free.centre();
        let sway =
            self.half * ((1.0 - self.rate).abs() + self.distance / squares.0.max(0.0).sqrt());
        if !(locked.is_narrow() && free.is_narrow()) {
            return Comparison::Overlap(None);
        }
        // Gaps differ from that of the centres by no more than both are wide, and count within half a turn of the nominal rotation.
        let play = 2.0 * NARROW + sway;
        let least = search.level - self.drift() - play;
        if !(least >= -FRAC_PI_2 && dot(centre, seen) >= 0.0) {
            let ahead = (centre * seen.conj()).arg();
            if !(least + ahead >= -PI && ahead <= FRAC_PI_2) {
                return Comparison::Overlap(None);
            }
            if ahead < -play {
                return Comparison::Apart;
            }
        }
        let mut need: Option<f64> = None;
        let between = centre + seen;
        let radial = || between / between.norm_sqr().sqrt();
        let back = turned.conj();
        for way in 0..3 {
            let (along, turning) = match way {
                0 => (turned * free.along(), self.turns_with(1)),
                1 => (locked.along(), self.turns_with(0)),
                _ => (radial(), self.turns_with(1)),
            };
            let u = along * 1f64.copysign(dot(along, centre));
            let n = C::i() * u;
            // An overlap in the middle of the cell is one of the cell.
            if !needs_rise && locked.farthest(n) + free.farthest(back * -n) > 0.0 {
                continue;
            }
            let arm = -self.greatest(self.free_reach(free, -u, turning, back));
            let before = self.greatest(self.locked_reach(locked, -u, turning));
            if !(arm > 0.0 && before < 0.0) {
                continue;
            }
            let reach =
                self.locked_reach(locked, n, turning) + self.free_reach(free, -n, turning, back);
            let over = self.greatest(reach) + ROUNDING * size;
            if over <= 0.0 {
                search.drawn = search.drawn.max((over + self.bound) / arm);
                return Comparison::Apart;
            }
            need = Some(need.map_or(over / arm, |need| need.min(over / arm)));
        }
        Comparison::Overlap(need)
    }

    fn run(&self, gear: usize, teeth: [u32; 2], run: usize) -> Node {
        let rectangle = match gear {
            0 => {
                let Frame { centre, direction } = self.frames[0];
                let boxes = self.teeth[0].boxes(teeth[0]);
                boxes.shape(run).placed(centre, direction)
            }
            _ => *self.free_halves[teeth[1] as usize - 1].rectangle(run),
        };
        self.node(gear, rectangle, NodeContent::Run(run))
    }

    /// A part of a piece.
    fn piece(&self, gear: usize, tooth: u32, piece: usize, [low, high]: [f64; 2]) -> Node {
        let it = &self.teeth[gear].half(tooth).pieces[piece];
        let Frame { centre, direction } = self.frames[gear];
        let rectangle = Rectangle::new(&it.curve, (low, high), |t| it.point(t));
        let rectangle = rectangle.placed(centre, direction);
        self.node(gear, rectangle, NodeContent::Part(piece, low, high))
    }

    fn node(&self, gear: usize, rectangle: Rectangle, within: NodeContent) -> Node {
        let squares = match gear {
            0 => self.squares(&rectangle),
            _ => rectangle.squares(),
        };
        Node {
            rectangle,
            squares,
            within,
            parts: (0, 0),
        }
    }

    /// Divides a node once. Returns where its parts begin and their number; `None` where it cannot be divided.
    fn divided(
        &self,
        gear: usize,
        teeth: [u32; 2],
        nodes: &mut Vec<Node>,
        node: usize,
    ) -> Option<(usize, usize)> {
        if nodes[node].parts.1 > 0 {
            return Some(nodes[node].parts);
        }
        let (tooth, from) = (teeth[gear], nodes.len());
        match nodes[node].within {
            NodeContent::Run(run) => match self.teeth[gear].boxes(tooth).inside(run) {
                RunContent::Runs(runs) => nodes.extend(runs.map(|run| self.run(gear, teeth, run))),
                RunContent::Pieces([piece, _]) => {
                    let it = &self.teeth[gear].half(tooth).pieces[piece];
                    let (low, high) = it.range();
                    // About the axis an arc has one radius, on which only its clockwise end can touch.
                    let has_one_radius = gear == 1
                        && self.frames[1].centre == C::ZERO
                        && it.curve.is_about_the_origin();
                    let ends = if has_one_radius {
                        [it.ends[1]; 2]
                    } else {
                        [low, high]
                    };
                    nodes.push(self.piece(gear, tooth, piece, ends));
                }
            },
            NodeContent::Part(piece, low, high) => {
                let middle = 0.5 * (low + high);
                if !(low < middle && middle < high) {
                    return None;
                }
                let halves = [[low, middle], [middle, high]];
                nodes.extend(halves.map(|ends| self.piece(gear, tooth, piece, ends)));
            }
        }
        nodes[node].parts = (from, nodes.len() - from);
        Some(nodes[node].parts)
    }

    /// A level that the gap of the contact's own half teeth does not fall below in the whole cell; `None` where none is shown.
    pub fn below(&self, touching: &ContactInCell) -> Option<Bound> {
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
        let stretch = |gear: usize| match gear {
            0 => {
                let tip = |at: &Rectangle| square.0 - room - self.squares(at).1;
                let root = |at: &Rectangle| self.squares(at).0 - square.1 - room;
                self.stretch(0, touching, &tip, &root)
            }
            _ => {
                let tip = |at: &Rectangle| at.squares().0 - most - room;
                let root = |at: &Rectangle| least - room - at.squares().1;
                self.stretch(1, touching, &tip, &root)
            }
        };
        let is_corner = |gear: usize| {
            let (piece, at) = touching.at[gear];
            self.teeth[gear].half(touching.teeth[gear]).pieces[piece].is_corner(at)
        };
        // A corner slides along the other gear's curve.
        let curves = if is_corner(1) { [0, 1] } else { [1, 0] };
        curves.into_iter().find_map(|gear| {
            let curve = stretch(gear)?;
            let (locked, free): (&[Rectangle], &[Rectangle]) = match gear {
                0 => (&curve, &[q]),
                _ => (&[p], &curve),
            };
            let [common, normal] = [0, 1 + gear].map(|k: usize| touching.normals[k]);
            let mut lines = [(normal, gear), (common, 1)].into_iter();
            lines.find_map(|(n, fixed_to)| {
                self.level_of_line(n, self.turns_with(fixed_to), touching.level, locked, free)
            })
        })
    }

    /// Rectangles round a stretch of a half tooth round its contact, towards the tip to where `tip` is at least 0 and towards the root to where
    /// `root` is.
    fn stretch(
        &self,
        gear: usize,
        touching: &ContactInCell,
        tip: &dyn Fn(&Rectangle) -> f64,
        root: &dyn Fn(&Rectangle) -> f64,
    ) -> Option<Vec<Rectangle>> {
        let tooth = touching.teeth[gear];
        let pieces = &self.teeth[gear].half(tooth).pieces;
        let Frame { centre, direction } = self.frames[gear];
        let at =
            |piece: usize, t: f64| Rectangle::point(centre + direction * pieces[piece].point(t));
        let (own, from) = touching.at[gear];
        let mut round = Vec::with_capacity(8);
        round.push(at(own, from));
        for (end, beyond) in [(0, tip), (1, root)] {
            let (mut piece, mut from) = (own, from);
            let mut short = beyond(&at(piece, from));
            while short < 0.0 {
                let mut to = pieces[piece].ends[end];
                let last = beyond(&at(piece, to));
                if last >= 0.0 {
                    let fine = END * (last - short);
                    to = root_beyond([(from, short), (to, last)], fine, |t| beyond(&at(piece, t)));
                }
                if from != to {
                    let part = [from.min(to), from.max(to)];
                    round.push(self.piece(gear, tooth, piece, part).rectangle);
                }
                short = last;
                if last < 0.0 {
                    piece = match end {
                        0 => piece.checked_sub(1)?,
                        _ => piece + 1,
                    };
                    from = pieces.get(piece)?.ends[1 - end];
                }
            }
        }
        Some(round)
    }

    /// The level, from `level` down, at which a line has `free` wholly on its locked side and `locked` on its free side throughout the cell. Its
    /// normal is `n` in the middle and turns at the rate `turning`.
    fn level_of_line(
        &self,
        n: C,
        turning: f64,
        mut level: f64,
        locked: &[Rectangle],
        free: &[Rectangle],
    ) -> Option<Bound> {
        let u = n * -C::i();
        let is_narrow = |all: &[Rectangle]| all.iter().all(Rectangle::is_narrow);
        let to = |n: C| {
            let each = locked.iter();
            each.map(move |it| self.locked_reach(it, n, turning))
        };
        if !(self.most(to(-u)) < 0.0 && is_narrow(locked) && is_narrow(free)) {
            return None;
        }
        for _ in 0..STEPS {
            let back = self.turned(level).conj();
            let from = |n: C| {
                let each = free.iter();
                each.map(move |it| self.free_reach(it, n, turning, back))
            };
            let arm = -self.most(from(-u));
            if !(arm > 0.0 && level + self.drift() <= MOST_LEVEL) {
                return None;
            }
            let both = to(-n).flat_map(|locked| from(n).map(move |free| locked + free));
            let over = self.most(both) + ROUNDING * self.size();
            if over <= 0.0 {
                let drawn = self.bound / arm;
                return Some(Bound { level, drawn });
            }
            level -= over / arm + 1e-3 * self.fine;
        }
        None
    }
}
