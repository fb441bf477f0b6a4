//! A hollow curve and a convex mate that stays off it.
//!
//! A convex piece `B` does not cross a hollow curve if every point of the curve has a direction that keeps `B` off it. One direction can
//! serve a whole stretch of the curve. It must keep `B` off the chord by more than the curve's sag, or off both ends if the curve reaches
//! no further. Near a touch only the tangents of the curve suffice. Let `σ(ν)` be the distance of `B` from the tangent with the normal
//! `e^{iν}`. With the radius `R` of the curve and `ρ` of `B`
//!
//! ```text
//! σ'' + σ = R − ρ ≥ m,   so   σ(ν_0 + x) ≥ m + (σ_0 − m) cos x + σ_0' sin x   for |x| ≤ π:
//! ```
//!
//! the difference has the non-negative kernel `sin(x − y)`. One evaluation proves the whole neighbourhood of a touch.

use super::convex::{Convex, Support, along, wrapped};
use super::facing_halves::{Apart, FacingHalves};
use super::proof::Reason;
use crate::contact::gap::{C, dot, turn};
use crate::gear::{Fillet, Part, PartCurve};
use std::f64::consts::PI;

/// Stretches into which a curve is cut in advance (tuned: against 6, poses of equal gears take 8 % less, those with a small pinion 6 % more).
const STRETCHES: u32 = 4;

/// Limit of halvings of a stretch: smaller ones only occur at a touch.
const DEEPEST: u32 = 26;

/// A fillet, cut into stretches.
#[derive(Debug, Clone)]
pub(super) struct Hollow {
    curve: HollowCurve,
    /// The curve from one end to the other.
    pub whole: Stretch,
    stretches: Vec<Stretch>,
    /// Ends of the stretches, and greatest distance of the curve from any chord between them, mm.
    knots: Vec<C>,
    sag: f64,
}

#[derive(Debug, Clone)]
struct HollowCurve {
    curve: PartCurve,
    /// `r`, mm, of a fillet's generating circle.
    pitch_radius: f64,
    /// Whether it is mirrored in the tooth's centre line.
    mirrored: bool,
}

/// A stretch of a hollow curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// Parameters of its ends.
    pub ends: [f64; 2],
    /// Points of its ends and unit normals there, out of the metal.
    pub points: [C; 2],
    normals: [C; 2],
    /// Unit normal of its chord, out of the metal, and its direction, rad.
    pub normal: C,
    angle: f64,
    /// Greatest distance of the curve from the chord, mm.
    pub sag: f64,
    /// Least and greatest radius of curvature, mm, where the curve is known to be hollow.
    radii: Option<[f64; 2]>,
}

/// The distance of a mate from the tangent at one point of a curve.
#[derive(Debug, Clone, Copy)]
struct TangentDistance {
    /// `σ` and `σ'`, mm.
    room: f64,
    slope: f64,
    /// The mate's radius of curvature, mm, and the direction in which it is evaluated, rad, in its own frame.
    radius: f64,
    omega: f64,
    /// Arm about the free gear's axis.
    arm: f64,
}

impl Hollow {
    /// A fillet with a generating circle of this radius, mm, or its mirror image. It may bulge where no mate touches it.
    pub fn new(part: &Part, pitch_radius: f64, mirrored: bool) -> Hollow {
        let (low, high) = part.range();
        let curve = HollowCurve {
            curve: part.curve.clone(),
            pitch_radius,
            mirrored,
        };
        let stretch = |low: f64, high: f64| Stretch::new(&curve, [low, high]);
        let at = |k: u32| match k {
            // The end is exact to the last bit.
            STRETCHES => high,
            _ => low + (high - low) * f64::from(k) / f64::from(STRETCHES),
        };
        let stretches: Vec<Stretch> = (0..STRETCHES).map(|k| stretch(at(k), at(k + 1))).collect();
        let sags = stretches.iter().map(|stretch| stretch.sag);
        Hollow {
            knots: (0..=STRETCHES).map(|k| curve.at(at(k)).0).collect(),
            sag: sags.fold(0.0, f64::max),
            stretches,
            whole: stretch(low, high),
            curve,
        }
    }

    /// Upper bound of the support of all its points in the direction `n`, and of their least lever; other values are unknown.
    pub fn bound(&self, n: C) -> Support {
        let mut bound = Support {
            reach: f64::MIN,
            along: f64::NAN,
            radius: f64::NAN,
            lever: f64::MAX,
            ahead: 0.0,
        };
        for point in &self.knots {
            bound.reach = bound.reach.max(dot(*point, n));
            bound.lever = bound.lever.min(along(*point, n));
        }
        bound.reach += self.sag;
        bound.lever -= self.sag;
        bound
    }

    /// A stretch in parts: one of them about the parameter `at`, otherwise its halves.
    fn cut(&self, stretch: &Stretch, at: Option<f64>) -> impl Iterator<Item = Stretch> {
        let [low, high] = stretch.ends;
        let width = |at: f64| (0.2 * (high - low)).min(at - low).min(high - at);
        let about = at.filter(|at| width(*at) > 1e-3 * (high - low));
        let (first, second) = match about {
            Some(at) => (at - width(at), at + width(at)),
            None => (0.5 * (low + high), high),
        };
        let parts = [[low, first], [first, second], [second, high]];
        let parts = parts.into_iter().filter(|[from, to]| from < to);
        parts.map(|ends| Stretch::new(&self.curve, ends))
    }

    fn halves(&self, stretch: &Stretch) -> [Stretch; 2] {
        let [low, high] = stretch.ends;
        let middle = 0.5 * (low + high);
        [[low, middle], [middle, high]].map(|ends| Stretch::new(&self.curve, ends))
    }
}

impl Stretch {
    fn new(curve: &HollowCurve, ends: [f64; 2]) -> Stretch {
        let [(a, na), (b, nb)] = ends.map(|t| curve.at(t));
        let (_, middle) = curve.at(0.5 * (ends[0] + ends[1]));
        let chord = b - a;
        let length = chord.norm();
        let normal = C::new(chord.im, -chord.re) / length;
        let normal = if !(length > 0.0) {
            middle
        } else if dot(normal, middle) < 0.0 {
            -normal
        } else {
            normal
        };
        // On a hollow curve the normal turns one way: to the middle and from there by less than a right angle.
        let turns_little = dot(na, middle) > 0.0 && dot(middle, nb) > 0.0;
        let radii = curve.radii(ends).filter(|_| turns_little);
        // The tangents at both ends enclose it; for a curve that may turn either way, lines as steep as its steepest.
        let (_, half_turn) = curve.curve.spread(ends[0], ends[1]);
        let slope = match radii {
            Some(_) if dot(na, nb) > -0.5 => along(na, nb).abs() / (1.0 + dot(na, nb)),
            None if half_turn < 0.5 => (2.0 * half_turn).tan(),
            _ => f64::INFINITY,
        };
        Stretch {
            ends,
            points: [a, b],
            normals: [na, nb],
            normal,
            angle: normal.arg(),
            sag: 0.5 * length * slope,
            radii,
        }
    }

    /// Upper bound of the reach of its points in the direction `n`, and their least coordinate along `i n`.
    fn bound(&self, n: C) -> (f64, f64) {
        let [a, b] = self.points;
        let beyond = if self.reaches_no_further(n) {
            0.0
        } else {
            self.sag
        };
        let reach = dot(a, n).max(dot(b, n)) + beyond;
        (reach, along(a, n).min(along(b, n)) - self.sag)
    }

    /// Whether no point reaches further in the direction `n` than both ends. The only other greatest `P·n` of a hollow curve is where the
    /// normal is `−n`.
    fn reaches_no_further(&self, n: C) -> bool {
        self.radii.is_some() && self.normals.iter().all(|normal| dot(n, *normal) >= 0.0)
    }
}

impl HollowCurve {
    /// Point and normal at a parameter.
    fn at(&self, t: f64) -> (C, C) {
        let (point, normal) = self.curve.at(t);
        let both = (C::new(point.x, point.y), C::new(normal.x, normal.y));
        if self.mirrored {
            (both.0.conj(), both.1.conj())
        } else {
            both
        }
    }

    /// Least and greatest radius of curvature between two parameters; `None` if it is not known to be hollow.
    fn radii(&self, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
        match self.curve.convexity(low, high) {
            Some((least, most)) if most < 0.0 => Some([-1.0 / least, -1.0 / most]),
            Some(_) => None,
            None => match &self.curve {
                PartCurve::Trochoid(fillet) => {
                    shallow_radii(fillet, self.pitch_radius, [low, high])
                }
                _ => None,
            },
        }
    }
}

/// The radii of a fillet whose tool's tip radius has its centre outside the pitch line, `h_0 < 0`.
///
/// `R = S/q` with `c = 1/cos γ`: `q = 1 + h_0 c²/r` falls, `S = ρ + h_0 c² (ρ + h_0 c)/r` has one minimum, at `c = −2ρ/3h_0`.
fn shallow_radii(fillet: &Fillet, r: f64, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    let (depth, round) = (fillet.depth(), fillet.tip_round());
    if fillet.is_elliptic() || depth >= 0.0 {
        return None;
    }
    let q = |c: f64| 1.0 + depth * c * c / r;
    let s = |c: f64| round + depth * c * c * (round + depth * c) / r;
    let (from, to) = (1.0 / low.cos(), 1.0 / high.cos());
    let least = s((2.0 * round / (-3.0 * depth)).clamp(from, to));
    let most = s(from).max(s(to));
    (q(to) > 0.0 && least > 0.0).then(|| [least / q(from), most / q(to)])
}

/// The least of `m + (σ − m) cos x + σ' sin x` over `|x| ≤ w`, `w` below a right angle.
fn least_room(room: f64, slope: f64, m: f64, w: f64) -> f64 {
    let across = room - m;
    let (sin, cos) = w.sin_cos();
    if across < 0.0 && slope.abs() * cos < -across * sin {
        // m − √(across² + slope²), without cancellation.
        let amount = across.hypot(slope);
        return if m + amount > 0.0 {
            (room * (2.0 * m - room) - slope * slope) / (m + amount)
        } else {
            m - amount
        };
    }
    m + across * cos - slope.abs() * sin
}

/// Distance of `mate` from the line through a point of gear `owner` across a normal, both in its own frame; `angle` is the normal's
/// direction.
#[inline]
fn off_line(
    at: &FacingHalves,
    owner: usize,
    (point, normal): (C, C),
    angle: f64,
    mate: &Convex,
) -> TangentDistance {
    let other = 1 - owner;
    let p = at.centres[owner] + at.directions[owner] * point;
    let n = at.directions[owner] * normal;
    let own = -n * at.directions[other].conj();
    let omega = wrapped(wrapped(at.angles[owner] + angle + PI) - at.angles[other]);
    let support = mate.support(omega, own);
    let d = at.centres[other] - p;
    TangentDistance {
        room: dot(d, n) - support.reach,
        slope: along(d, n) - support.along,
        radius: support.radius,
        omega,
        arm: match owner {
            0 => at.least_arm(support, n),
            _ => along(p, n),
        },
    }
}

/// Distance of `mate` from the tangent at a point of a curve.
fn off_tangent(
    at: &FacingHalves,
    owner: usize,
    (point, normal): (C, C),
    mate: &Convex,
) -> TangentDistance {
    off_line(at, owner, (point, normal), normal.arg(), mate)
}

/// A normal of gear `owner` in its own frame, as the direction out of the locked metal.
pub(super) fn out_of_locked(at: &FacingHalves, owner: usize, normal: C) -> C {
    let n = at.directions[owner] * normal;
    if owner == 0 { n } else { -n }
}

/// Whether the normal of a stretch's chord keeps `mate` off the whole stretch.
#[inline]
pub(super) fn is_off_chord(
    at: &FacingHalves,
    owner: usize,
    stretch: &Stretch,
    mate: &Convex,
) -> bool {
    let off = off_chord(at, owner, stretch, mate);
    stays_off_chord(at, stretch, off)
}

/// Distance of `mate` from the chord of a stretch.
#[inline]
fn off_chord(at: &FacingHalves, owner: usize, stretch: &Stretch, mate: &Convex) -> TangentDistance {
    let line = (stretch.points[0], stretch.normal);
    off_line(at, owner, line, stretch.angle, mate)
}

#[inline]
fn stays_off_chord(at: &FacingHalves, stretch: &Stretch, off: TangentDistance) -> bool {
    let sag = if stretch.reaches_no_further(stretch.normal) {
        0.0
    } else {
        stretch.sag
    };
    at.stays_apart(off.room - sag, off.arm - sag)
}

/// Whether `mate` is off the whole hollow curve of gear `owner`. `record` receives each proven stretch. The first direction for a stretch is its
/// normal or `facing`, whichever leaves more room.
pub(super) fn is_off_hollow(
    at: &FacingHalves,
    (owner, hollow): (usize, &Hollow),
    (mate, facing): (&Convex, C),
    record: &mut impl FnMut([f64; 2], Apart),
) -> bool {
    let mut open: Vec<(Stretch, u32)> = Vec::new();
    // False where a stretch can be neither proven nor cut.
    let mut examine = |stretch: &Stretch, depth, open: &mut Vec<(Stretch, u32)>| {
        if let Some(proof) = off_stretch(at, (owner, hollow), stretch, (mate, facing)) {
            record(stretch.ends, proof);
            return true;
        }
        if depth >= DEEPEST || at.is_spent() {
            return false;
        }
        let nearest = nearest_tangent(at, (owner, hollow), stretch, mate);
        let parts = hollow.cut(stretch, nearest.map(|(at, _)| at));
        open.extend(parts.map(|part| (part, depth + 1)));
        true
    };
    for stretch in &hollow.stretches {
        if !examine(stretch, 0, &mut open) {
            return false;
        }
        while let Some((stretch, depth)) = open.pop() {
            if !examine(&stretch, depth, &mut open) {
                return false;
            }
        }
    }
    true
}

/// The parameter of the tangent nearest to `mate` within a stretch, and whether that keeps it off.
fn nearest_tangent(
    at: &FacingHalves,
    (owner, hollow): (usize, &Hollow),
    stretch: &Stretch,
    mate: &Convex,
) -> Option<(f64, bool)> {
    let [low, high] = stretch.ends;
    let radii = stretch.radii?;
    let turned = along(stretch.normals[1], stretch.normals[0]);
    if turned == 0.0 {
        return None;
    }
    let mut t = 0.5 * (low + high);
    for _ in 0..6 {
        let off = off_tangent(at, owner, hollow.curve.at(t), mate);
        let bend = 0.5 * (radii[0] + radii[1]) - off.radius - off.room;
        if !(bend > 0.0) {
            return None;
        }
        let step = off.slope / bend * (high - low) / turned;
        if step.abs() <= 1e-9 * (high - low) {
            return Some((t, at.stays_apart(off.room, off.arm)));
        }
        t -= step;
        if !(t >= low && t <= high) {
            return None;
        }
    }
    let off = off_tangent(at, owner, hollow.curve.at(t), mate);
    Some((t, at.stays_apart(off.room, off.arm)))
}

/// The proof that `mate` is off a stretch.
fn off_stretch(
    at: &FacingHalves,
    (owner, hollow): (usize, &Hollow),
    stretch: &Stretch,
    (mate, facing): (&Convex, C),
) -> Option<Apart> {
    at.count();
    let normal = out_of_locked(at, owner, stretch.normal);
    let off = off_chord(at, owner, stretch, mate);
    if stays_off_chord(at, stretch, off) {
        return Some(Apart::along(normal));
    }
    let chord = Convex::Chord(stretch.points);
    let (locked, free) = match owner {
        0 => (&chord, mate),
        _ => (mate, &chord),
    };
    let nu = facing.arg();
    let across = at.room(locked, free, nu, facing);
    let sag = sag_along(at, owner, stretch, Apart::along(facing));
    if at.stays_apart(across.room - sag, across.arm) {
        return Some(Apart::along(facing));
    }
    if is_off_tangents(at, (owner, hollow), stretch, mate) {
        let (_, normal) = hollow.curve.at(0.5 * (stretch.ends[0] + stretch.ends[1]));
        return Some(Apart {
            by: [Reason::LockedTangents, Reason::FreeTangents][owner],
            normal: out_of_locked(at, owner, normal),
        });
    }
    // A shorter stretch about the nearest tangent is proven by its tangents.
    let nearest = nearest_tangent(at, (owner, hollow), stretch, mate);
    if nearest.is_some_and(|(_, stays)| stays) {
        return None;
    }
    let start = if off.room >= across.room {
        normal.arg()
    } else {
        nu
    };
    let apart = at.find_separation(locked, free, start)?;
    let sag = sag_along(at, owner, stretch, apart);
    if sag == 0.0 {
        Some(apart)
    } else {
        at.wider(sag).find_separation(locked, free, start)
    }
}

/// The distance, mm, by which a stretch of gear `owner` can reach further than its chord where this keeps the chord off a mate.
fn sag_along(at: &FacingHalves, owner: usize, stretch: &Stretch, apart: Apart) -> f64 {
    let n = apart.normal * at.directions[owner].conj();
    let is_of_chord = match (apart.by, owner) {
        (_, 0) => stretch.reaches_no_further(n),
        // The disc in which a free chord turns is not that of its curve.
        (Reason::OutOfReach, _) => false,
        _ => stretch.reaches_no_further(-n),
    };
    if is_of_chord { 0.0 } else { stretch.sag }
}

/// Whether the tangents of all points of a stretch keep `mate` off.
fn is_off_tangents(
    at: &FacingHalves,
    (owner, hollow): (usize, &Hollow),
    stretch: &Stretch,
    mate: &Convex,
) -> bool {
    // For a chord each end has its own bound: across the chord's normal its support jumps.
    if let Convex::Chord([a, b]) = mate
        && a != b
    {
        let ends = [*a, *b].map(|end| Convex::Chord([end; 2]));
        return ends
            .iter()
            .all(|end| is_off_tangents(at, (owner, hollow), stretch, end));
    }
    let (point, normal) = hollow.curve.at(0.5 * (stretch.ends[0] + stretch.ends[1]));
    let off = off_tangent(at, owner, (point, normal), mate);
    let turns = stretch.normals.map(|end| along(end, normal).abs().asin());
    let play = turns[0].max(turns[1]);
    let Some(radii) = stretch.radii else {
        return false;
    };
    let round = mate.greatest_radius(off.omega, play);
    let least = least_room(off.room, off.slope, radii[0] - round, play);
    // The arm turns by at most its point's distance from the axis plus a radius.
    let (point, radius) = match owner {
        0 => (
            mate.farthest(at.centres[1] * at.directions[1].conj()),
            round,
        ),
        _ => (
            (at.centres[1] + at.directions[1] * point).norm() + radii[1] * play,
            radii[1],
        ),
    };
    let is_short = stretch.normals.iter().all(|end| dot(*end, normal) > 0.0);
    let arm = off.arm - play * (point + radius);
    is_short && play < 0.5 && at.stays_apart(least, arm)
}

/// Whether two hollow curves stay off each other. For any two stretches one must be off the other's chord, by more than its sag where
/// the other's curve may reach further than its chord.
pub(super) fn is_off_both(
    at: &FacingHalves,
    ([locked, free], nu): ([&Hollow; 2], f64),
    record: &mut impl FnMut([[f64; 2]; 2], Apart),
) -> bool {
    let mut open: Vec<[Stretch; 2]> = Vec::new();
    for l in &locked.stretches {
        open.extend(free.stretches.iter().map(|f| [*l, *f]));
    }
    let n = turn(nu);
    while let Some([l, f]) = open.pop() {
        if are_off_along(at, [&l, &f], n) {
            record([l.ends, f.ends], Apart::along(n));
            continue;
        }
        at.count();
        let chords = [&l, &f].map(|stretch| Convex::Chord(stretch.points));
        let proof = |owner: usize| {
            let ((hollow, stretch), mate) = match owner {
                0 => ((locked, &l), &f),
                _ => ((free, &f), &l),
            };
            let chord = &chords[1 - owner];
            let off = off_stretch(at, (owner, hollow), stretch, (chord, n))?;
            if holds_for_curve(at, 1 - owner, mate, stretch, off) {
                return Some(off);
            }
            off_stretch(&at.wider(mate.sag), (owner, hollow), stretch, (chord, n))
        };
        if let Some(proof) = proof(0).or_else(|| proof(1)) {
            record([l.ends, f.ends], proof);
            continue;
        }
        if at.is_spent() || open.len() > 400 {
            return false;
        }
        if l.sag > f.sag {
            open.extend(locked.halves(&l).map(|half| [half, f]));
        } else {
            open.extend(free.halves(&f).map(|half| [l, half]));
        }
    }
    true
}

/// Whether one direction keeps a stretch of the locked gear off one of the free gear.
fn are_off_along(at: &FacingHalves, [locked, free]: [&Stretch; 2], n: C) -> bool {
    let own = [0, 1].map(|k| n * at.directions[k].conj());
    let (reach, _) = locked.bound(own[0]);
    let (back, least) = free.bound(-own[1]);
    let room = dot(at.centres[1] - at.centres[0], n) - reach - back;
    at.stays_apart(room, least - along(at.centres[1], n))
}

/// Whether the direction that keeps a chord of gear `owner` off `mate` also keeps the curve off, at any distance from the chord.
fn holds_for_curve(
    at: &FacingHalves,
    owner: usize,
    stretch: &Stretch,
    mate: &Stretch,
    proof: Apart,
) -> bool {
    let back = at.directions[owner].conj();
    match proof.by {
        // It holds between the directions of both ends if it holds for both.
        Reason::LockedTangents | Reason::FreeTangents => mate.normals.iter().all(|n| {
            let own = -(at.directions[1 - owner] * n) * back;
            stretch.reaches_no_further(own)
        }),
        Reason::Direction if owner == 0 => stretch.reaches_no_further(proof.normal * back),
        Reason::Direction => stretch.reaches_no_further(-proof.normal * back),
        // The disc of a chord is not that of the curve.
        Reason::OutOfReach => false,
    }
}

/// Whether a fillet of the locked gear stays off the disc of this radius, mm, about the free axis.
pub(super) fn is_beyond(
    at: &FacingHalves,
    hollow: &Hollow,
    radius: f64,
    record: &mut impl FnMut([f64; 2], Apart),
) -> bool {
    let mut open = hollow.stretches.clone();
    while let Some(stretch) = open.pop() {
        let chord = Convex::Chord(stretch.points);
        match at.wider(stretch.sag).beyond(&chord, radius) {
            Some(apart) => record(stretch.ends, apart),
            None if at.is_spent() => return false,
            None => open.extend(hollow.halves(&stretch)),
        }
    }
    true
}

#[cfg(test)]
mod tests;
