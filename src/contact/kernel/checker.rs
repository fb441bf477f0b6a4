//! Verifies a [`Proof`] from the outlines alone, without any search and without the code of prover or kernel.
//!
//! Teeth are placed by number in the picture. The reach of a piece in a direction is the greatest `P·n` of its curves, by bisection of
//! their own points and normals. Three facts are verified. The named directions keep their pieces apart. The named pieces are complete: all
//! of every locked tooth and the free tooth that faces it, unless these are out of reach of each other. The named point is in the metal of
//! both teeth.

use super::proof::{Piece, Proof, Reason, Separation, SideProof};
use crate::gear::{AsBuilt, Profile, ProfilePart, Side};
use crate::numeric::bisect;
use crate::pair::{GearPair, Member, Pose, section_at};
use nalgebra::{Point2, UnitComplex, Vector2};
use std::f64::consts::FRAC_PI_2;

/// Part of a range to which a place is bisected.
const FINEST: f64 = 1e-18;

/// A half tooth in the picture.
struct Half<'a> {
    gear: &'a AsBuilt,
    profile: Profile<'a>,
    side: Side,
    tooth: u32,
    centre: Point2<f64>,
    turned: UnitComplex<f64>,
}

/// A locked tooth: the half that faces the mate, and the far half.
struct Tooth<'a> {
    near: Half<'a>,
    far: Half<'a>,
}

/// A locked tooth and the free half tooth that faces it.
struct Pair<'a> {
    locked: Tooth<'a>,
    free: Half<'a>,
    /// The axis of the free gear.
    axis: Point2<f64>,
    /// Range of its rotations over which they are apart, rad.
    play: f64,
}

/// Reach of a piece in a direction: greatest `P·n`, and its point.
type Reach = (f64, Point2<f64>);

impl Proof {
    /// Verifies from the outlines alone that it proves `pose` of `assembly`. The verifier shares no code with the prover.
    ///
    /// # Errors
    /// The first contradiction to the proof.
    pub fn verify(&self, assembly: &GearPair, pose: &Pose) -> Result<(), String> {
        for side in Side::BOTH {
            let of_side = || self.sides.iter().filter(|proven| proven.side == side);
            let is_free = of_side().all(|proven| proven.open.is_none());
            let touches = of_side().any(|proven| proven.touch.is_some());
            if of_side().count() == 0 || touches == is_free {
                return Err(format!("nothing is said of the {} side", side.name()));
            }
        }
        self.verify_play(assembly, pose)?;
        for side in &self.sides {
            if !assembly.varies_along_face() {
                verify_side(assembly, pose, side)?;
                continue;
            }
            let (section, here) = section_at(assembly, pose, side.section);
            verify_side(&section, &here, side)?;
        }
        Ok(())
    }

    /// Verifies that the range of each side extends past the start of the other side's range.
    fn verify_play(&self, assembly: &GearPair, pose: &Pose) -> Result<(), String> {
        // From the nominal rotation in each section.
        let until = |side: &SideProof| {
            let (_, here) = section_at(assembly, pose, side.section);
            Some(side.until? - here.free_rotation())
        };
        let of = |side: Side| self.sides.iter().filter(move |proof| proof.side == side);
        for right in of(Side::Right) {
            for left in of(Side::Left) {
                let meet = match (until(right), until(left)) {
                    (None, None) => true,
                    (Some(right), Some(left)) => right >= left,
                    _ => false,
                };
                if !meet {
                    return Err("between both sides some rotations are not covered".to_owned());
                }
            }
        }
        Ok(())
    }
}

fn verify_side(assembly: &GearPair, pose: &Pose, proof: &SideProof) -> Result<(), String> {
    let side = proof.side;
    if root_circles_may_overlap(assembly, pose) {
        return Err("root circles overlap".to_owned());
    }
    let free = |tooth, rotation| Half::new(assembly, assembly.free(), rotation, side, tooth);
    let locked = |tooth| {
        let (gear, rotation) = (assembly.locked(), pose.locked_rotation());
        let [near, far] =
            [side, side.other()].map(|side| Half::new(assembly, gear, rotation, side, tooth));
        Tooth { near, far }
    };
    if let Some(touch) = &proof.touch {
        let tooth = locked(touch.locked_tooth);
        let in_locked = tooth.near.contains(touch.point) || tooth.far.contains(touch.point);
        if !(in_locked && free(touch.free_tooth, touch.closed).contains(touch.point)) {
            return Err(format!(
                "teeth {} and {} do not both hold the common point",
                touch.locked_tooth, touch.free_tooth
            ));
        }
    }
    let gear = assembly.gear(assembly.locked());
    let mating = pose.mating().tooth(assembly.locked());
    let (pitch, teeth) = (
        gear.gear().basic_data().angular_pitch(),
        gear.gear().basic_data().teeth(),
    );
    // All locked teeth, half of them on either side of the one nearest to the line of centres.
    let from_line = pose.locked_rotation() + gear.tooth_angle(f64::from(mating));
    let nearest = -(from_line / pitch).round() as i64;
    let (before, behind) = (i64::from(teeth - 1) / 2, i64::from(teeth) / 2);
    for steps in nearest - before..=nearest + behind {
        let locked_tooth = gear.counter_clockwise(mating, steps);
        let free_tooth = pose.facing_tooth(assembly, side, steps);
        // Out of reach at every rotation, if no rotation is named.
        let pair = Pair {
            locked: locked(locked_tooth),
            free: free(free_tooth, proof.open.unwrap_or(0.0)),
            axis: assembly.axis(assembly.free()),
            play: match (proof.open, proof.until) {
                (Some(open), Some(until)) => (until - open).abs(),
                _ => f64::INFINITY,
            },
        };
        let named =
            |one: &&Separation| (one.locked_tooth, one.free_tooth) == (locked_tooth, free_tooth);
        let named: Vec<&Separation> = proof.apart.iter().filter(named).collect();
        if named.is_empty() && pair.is_out_of_reach(proof.open.is_some()) {
            continue;
        }
        let failed = |what: &str| {
            let name = side.name();
            Err(format!(
                "{name} side, locked tooth {locked_tooth}, free tooth {free_tooth}: {what}"
            ))
        };
        for one in &named {
            if !pair.holds(one, proof.open.is_some()) {
                return failed(&format!(
                    "{:?} of {:?} and {:?}",
                    one.by, one.locked, one.free
                ));
            }
        }
        // If nothing touches, facing half teeth do not.
        let parts = LOCKED
            .into_iter()
            .filter(|part| part.0 || proof.open.is_some());
        for locked in parts {
            for free in FREE {
                if pair.may_meet(locked.1, free) && !pair.covers(&named, locked, free) {
                    return failed(&format!(
                        "of {} and {} a part is left out",
                        locked.1.name(),
                        free.name()
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Whether root circles overlap at a rotation of the free gear: two spaces that face each other are no facing half teeth.
fn root_circles_may_overlap(assembly: &GearPair, pose: &Pose) -> bool {
    let [locked, free] = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
    let tooth_1 = assembly.mate_direction(assembly.locked()) + pose.locked_rotation();
    let centre = assembly.axis(assembly.locked()) + locked.displacement(tooth_1);
    let solid = locked.gear().root_radius() + free.gear().root_radius() + free.eccentricity();
    (assembly.axis(assembly.free()) - centre).norm() < solid
}

/// Parts of the free half tooth, each by its name; the top includes tip and involute.
const FREE: [ProfilePart; 3] = [ProfilePart::Tip, ProfilePart::Fillet, ProfilePart::Root];

/// Parts of the locked tooth: of the near half, and of the far half. (Its root land faces the other side of the free gear's teeth.)
const LOCKED: [(bool, ProfilePart); 5] = [
    (true, ProfilePart::Tip),
    (true, ProfilePart::Fillet),
    (true, ProfilePart::Root),
    (false, ProfilePart::Tip),
    (false, ProfilePart::Fillet),
];

impl Tooth<'_> {
    fn half(&self, is_near: bool) -> &Half<'_> {
        if is_near { &self.near } else { &self.far }
    }

    fn reach(&self, piece: Piece, n: Vector2<f64>) -> Reach {
        match piece {
            Piece::Tooth => further(
                self.near.reach(Piece::Top, n),
                self.far.reach(Piece::Top, n),
            ),
            Piece::FarFillet(range) => self.far.reach(Piece::Fillet(range), n),
            _ => self.near.reach(piece, n),
        }
    }
}

impl Pair<'_> {
    /// Whether the free half tooth reaches nothing of the locked tooth, or of its near half alone, at any rotation.
    fn is_out_of_reach(&self, with_far: bool) -> bool {
        let is_off = |half: &Half| half.distance(self.axis) > self.free.reach_about(self.axis);
        is_off(&self.locked.near) && (!with_far || is_off(&self.locked.far))
    }

    /// Whether two parts can meet by their greatest radii.
    fn may_meet(&self, locked: ProfilePart, free: ProfilePart) -> bool {
        let near = &self.locked.near;
        let apart = (near.centre - self.axis).norm() - self.free.gear.eccentricity();
        near.radius(locked) + self.free.radius(free) > apart
    }

    /// Whether `named` covers two parts completely, including every stretch of a fillet.
    fn covers(
        &self,
        named: &[&Separation],
        (is_near, part): (bool, ProfilePart),
        other: ProfilePart,
    ) -> bool {
        let ranges = [
            self.locked.half(is_near).range(part),
            self.free.range(other),
        ];
        if ranges.iter().any(|(low, high)| low >= high) {
            return true;
        }
        let locked = |piece: Piece| match (piece, is_near, part) {
            (Piece::Tooth, _, ProfilePart::Tip) => Some(ranges[0]),
            (Piece::Top, true, ProfilePart::Tip) | (Piece::Root, true, ProfilePart::Root) => {
                Some(ranges[0])
            }
            (Piece::Fillet([low, high]), true, ProfilePart::Fillet) => Some((low, high)),
            (Piece::FarFillet([low, high]), false, ProfilePart::Fillet) => Some((low, high)),
            _ => None,
        };
        let free = |one: &Separation| match (one.free, other) {
            // The disc of the whole half tooth.
            (Piece::Top, _) if one.by == Reason::OutOfReach => Some(ranges[1]),
            (Piece::Top, ProfilePart::Tip) | (Piece::Root, ProfilePart::Root) => Some(ranges[1]),
            (Piece::Fillet([low, high]), ProfilePart::Fillet) => Some((low, high)),
            _ => None,
        };
        let boxes: Vec<[(f64, f64); 2]> = named
            .iter()
            .filter_map(|one| Some([locked(one.locked)?, free(one)?]))
            .collect();
        // Every cell of the grid of all their ends is in one of them.
        let grid = [0, 1].map(|k| {
            let mut ends: Vec<f64> = boxes.iter().flat_map(|one| [one[k].0, one[k].1]).collect();
            ends.extend([ranges[k].0, ranges[k].1]);
            ends.retain(|end| *end >= ranges[k].0 && *end <= ranges[k].1);
            ends.sort_unstable_by(f64::total_cmp);
            ends.dedup();
            ends.windows(2)
                .map(|ends| 0.5 * (ends[0] + ends[1]))
                .collect::<Vec<f64>>()
        });
        grid[0].iter().all(|x| {
            grid[1].iter().all(|y| {
                let has = |range: (f64, f64), at: f64| range.0 <= at && at <= range.1;
                boxes.iter().any(|one| has(one[0], *x) && has(one[1], *y))
            })
        })
    }

    /// Whether a distance, mm, stays above 0 as the free gear turns further: it grows if its arm is above 0, and otherwise falls by at most
    /// this.
    fn stays(&self, distance: f64, arm: f64) -> bool {
        let gear = self.free.gear;
        let reach = gear.eccentricity() + gear.gear().tip_radius();
        let falls = if arm > 0.0 {
            0.0
        } else {
            self.play * (reach * self.play - arm)
        };
        distance > falls
    }

    /// Least arm of the free tooth in the direction `n` on the way to the near corner of its land.
    ///
    /// The normals of a land meet at the gear's centre, whose arm may fall until the land's end. If the distance has grown until there by
    /// more than the corner can still fall, it stays above its value now: a corner `p` with the arm `e` falls to `-|p|` at most.
    fn arm_past(
        &self,
        land: LandAhead,
        n: Vector2<f64>,
        arm: impl Fn(Point2<f64>, Vector2<f64>) -> f64,
    ) -> f64 {
        let free = &self.free;
        let turned = UnitComplex::new(-free.side.sense() * land.turn.min(self.play));
        let centre = self.axis + turned * (free.centre - self.axis);
        let past = arm(centre, n);
        let grown = (centre - free.centre).dot(&n);
        let corner = (centre - self.axis).dot(&n) - free.gear.gear().tip_radius();
        let falls = past * past / (2.0 * -corner);
        if land.is_here && corner < 0.0 && grown > falls {
            f64::INFINITY
        } else {
            past
        }
    }

    /// Whether a separation keeps its two pieces apart; `open`: at a rotation, otherwise at every one.
    fn holds(&self, one: &Separation, open: bool) -> bool {
        let Pair {
            locked, free, axis, ..
        } = self;
        let n = one.normal;
        // Arm of a force that opens the free gear.
        let arm = |at, n| -free.side.sense() * turns(*axis, at, n);
        let (reach, _) = locked.reach(one.locked, n);
        match one.by {
            Reason::Direction => {
                let (back, at) = free.reach(one.free, -n);
                // After a further turn the free piece has another corner towards the line.
                let next = free.next_corner(one.free, -n, at).unwrap_or(at);
                let past = free
                    .land_ahead(one.free, -n)
                    .map_or(f64::INFINITY, |land| self.arm_past(land, n, arm));
                open && self.stays(-back - reach, arm(at, n).min(arm(next, n)).min(past))
            }
            Reason::OutOfReach => axis.coords.dot(&n) - free.piece_about(one.free, *axis) > reach,
            Reason::LockedTangents => {
                let (half, fillet) = match one.locked {
                    Piece::FarFillet(range) => (&locked.far, Piece::Fillet(range)),
                    fillet => (&locked.near, fillet),
                };
                let stays = |s, [_, at]: [Point2<f64>; 2], n| self.stays(s, arm(at, n));
                open && off_tangents(half, fillet, |n| free.reach(one.free, n), stays)
            }
            // A force out of the free metal turns the free gear the other way.
            Reason::FreeTangents => {
                let stays =
                    |s, [at, _]: [Point2<f64>; 2], n: Vector2<f64>| self.stays(s, arm(at, -n));
                open && off_tangents(free, one.free, |n| locked.reach(one.locked, n), stays)
            }
        }
    }
}

/// The tip land of a top whose near corner reaches furthest after a further turn.
struct LandAhead {
    /// The turn, rad.
    turn: f64,
    /// Whether a point of the land reaches furthest now.
    is_here: bool,
}

/// Moment about `axis` of a unit force along `n` at a point.
fn turns(axis: Point2<f64>, at: Point2<f64>, n: Vector2<f64>) -> f64 {
    (at - axis).perp(&n)
}

/// Whether the tangents of all points of a fillet's stretch keep a piece of the mate off.
///
/// The distance `σ(ν)` of the piece from the tangent with the normal `e^{iν}` has `σ'' + σ = R − ρ`, the difference of both radii of
/// curvature. Where that is not negative, `σ` is above `σ_0 cos x + σ_0' sin x` of either end of a cell. Cells are halved until that
/// suffices.
fn off_tangents(
    half: &Half,
    fillet: Piece,
    mate: impl Fn(Vector2<f64>) -> Reach,
    stays: impl Fn(f64, [Point2<f64>; 2], Vector2<f64>) -> bool,
) -> bool {
    let Piece::Fillet([low, high]) = fillet else {
        return false;
    };
    let at = |t: f64| {
        let (point, n) = half.at(ProfilePart::Fillet, t);
        let (back, met) = mate(-n);
        (point, n, -back - point.coords.dot(&n), met)
    };
    let mut cells = vec![(low, high, 0)];
    while let Some((low, high, depth)) = cells.pop() {
        let [(p0, n0, s0, q0), (p1, n1, s1, q1)] = [low, high].map(at);
        let stay = |s0, s1| stays(s0, [p0, q0], n0) && stays(s1, [p1, q1], n1);
        if !stay(s0, s1) {
            return false;
        }
        // σ' is the position of the mate's point along the tangent; towards each other it falls.
        let turn = n0.perp(&n1);
        let slope =
            |p: Point2<f64>, q: Point2<f64>, n: Vector2<f64>| (q - p).dot(&Vector2::new(-n.y, n.x));
        let falls = [
            slope(p0, q0, n0) * turn.signum(),
            -slope(p1, q1, n1) * turn.signum(),
        ];
        let width = turn.abs().asin();
        let [run, run_of_mate] = [(p1 - p0).norm(), (q1 - q0).norm()];
        let least = if run >= run_of_mate {
            // Each bound is concave where it is above 0: the greater of both is least where they cross, or at an end.
            crossing([s0, s1], falls, width)
        } else {
            // σ' changes by at most the movement of both points.
            let steepest = falls[0].abs().max(falls[1].abs()) + run + run_of_mate;
            s0.min(s1) - width * steepest
        };
        if stay(least, least) {
            continue;
        }
        if depth > 40 {
            return false;
        }
        let middle = 0.5 * (low + high);
        cells.extend([(low, middle, depth + 1), (middle, high, depth + 1)]);
    }
    true
}

/// The value at which `s_0 cos x + f_0 sin x` and `s_1 cos (w − x) + f_1 sin (w − x)` cross between 0 and `w`.
fn crossing(s: [f64; 2], f: [f64; 2], width: f64) -> f64 {
    let bound = |k: usize, x: f64| s[k] * x.cos() + f[k] * x.sin();
    let is_before = |x: f64| bound(0, x) > bound(1, width - x);
    let [low, _] = bisect(0.0, width, FINEST * width, is_before);
    bound(0, low).max(bound(1, width - low))
}

impl<'a> Half<'a> {
    fn new(
        assembly: &'a GearPair,
        member: Member,
        rotation: f64,
        side: Side,
        tooth: u32,
    ) -> Half<'a> {
        let gear = assembly.gear(member);
        let tooth_1 = assembly.mate_direction(member) + rotation;
        let angle = tooth_1 + gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
        Half {
            gear,
            profile: gear.profile(side, tooth),
            side,
            tooth,
            centre: assembly.axis(member) + gear.displacement(tooth_1),
            turned: UnitComplex::new(angle),
        }
    }

    /// Point and normal of a part, in the picture.
    fn at(&self, part: ProfilePart, t: f64) -> (Point2<f64>, Vector2<f64>) {
        let point = self.turned * self.profile.point(part, t, self.side);
        (
            self.centre + point.coords,
            self.turned * self.profile.normal(part, t, self.side),
        )
    }

    /// Parameters of a part's ends: the tip land from its far corner, the root land to the middle of the space.
    fn range(&self, part: ProfilePart) -> (f64, f64) {
        let (low, high) = self.profile.range(part);
        match part {
            ProfilePart::Tip => (self.gear.land_start(self.side, self.tooth), low.max(high)),
            ProfilePart::Root => (low, self.gear.root_end(self.side, self.tooth)),
            _ => (low.min(high), low.max(high)),
        }
    }

    /// Greatest radius of a part about the gear's centre, mm.
    fn radius(&self, part: ProfilePart) -> f64 {
        match part {
            ProfilePart::Fillet => self.gear.gear().form_radius(),
            ProfilePart::Root => self.gear.gear().root_radius(),
            _ => self.gear.gear().tip_radius(),
        }
    }

    /// Reach of a piece in the direction `n`.
    fn reach(&self, piece: Piece, n: Vector2<f64>) -> Reach {
        match piece {
            Piece::Top | Piece::Tooth => {
                let of = |part| self.reach_of(part, self.range(part), n);
                further(of(ProfilePart::Tip), of(ProfilePart::Involute))
            }
            Piece::Fillet([low, high]) | Piece::FarFillet([low, high]) => {
                self.reach_of(ProfilePart::Fillet, (low, high), n)
            }
            Piece::Root => self.reach_of(ProfilePart::Root, self.range(ProfilePart::Root), n),
        }
    }

    /// The corner that reaches furthest in the direction `n` after the free gear has turned past an edge between two corners. `at` is the
    /// present one.
    fn next_corner(&self, piece: Piece, n: Vector2<f64>, at: Point2<f64>) -> Option<Point2<f64>> {
        let (part, (low, high)) = match piece {
            Piece::Top | Piece::Tooth => (ProfilePart::Tip, self.range(ProfilePart::Tip)),
            Piece::Fillet([low, high]) | Piece::FarFillet([low, high]) => {
                (ProfilePart::Fillet, (low, high))
            }
            Piece::Root => (ProfilePart::Root, self.range(ProfilePart::Root)),
        };
        let ends = [low, high].map(|t| self.at(part, t).0);
        let [n, far, other] = [
            self.to_own_frame(self.centre + n),
            self.to_own_frame(ends[0]),
            self.to_own_frame(ends[1]),
        ];
        match part {
            // Only from past the far corner, or within 30° of straight from behind: elsewhere curves follow.
            ProfilePart::Tip => {
                let (form, _) = self.range(ProfilePart::Involute);
                let joint = self.to_own_frame(self.at(ProfilePart::Involute, form).0);
                let is_behind = n.dot(&joint) < -0.75f64.sqrt() * joint.norm();
                (n.y > 0.0 && far.perp(&n) > 0.0 || is_behind).then_some(ends[0])
            }
            ProfilePart::Root if !ends.contains(&at) => None,
            // The clockwise end.
            _ if n.perp(&far) < n.perp(&other) => Some(ends[0]),
            _ => Some(ends[1]),
        }
    }

    /// The land of a top, if its near corner does not yet reach furthest in the direction `n`.
    fn land_ahead(&self, piece: Piece, n: Vector2<f64>) -> Option<LandAhead> {
        if !matches!(piece, Piece::Top | Piece::Tooth) {
            return None;
        }
        let (start, end) = self.range(ProfilePart::Tip);
        let n = self.to_own_frame(self.centre + n);
        let angle = n.y.atan2(n.x);
        (angle + end > 0.0).then_some(LandAhead {
            turn: angle + end,
            is_here: angle + start < 0.0,
        })
    }

    /// Reach of one curve, which turns one way by less than half a turn: at an end, or where it turns from rising to falling.
    fn reach_of(&self, part: ProfilePart, (low, high): (f64, f64), n: Vector2<f64>) -> Reach {
        let reach = |t: f64| {
            let (point, _) = self.at(part, t);
            (point.coords.dot(&n), point)
        };
        let (start, end) = (self.at(part, low), self.at(part, high));
        let sense = (end.0 - start.0).perp(&start.1).signum();
        let rises = |t: f64| sense * n.perp(&self.at(part, t).1) > 0.0;
        let ends = further(reach(low), reach(high));
        if !rises(low) || rises(high) {
            return ends;
        }
        let [low, high] = bisect(low, high, FINEST * (high - low), rises);
        further(ends, further(reach(low), reach(high)))
    }

    /// A point in the frame of the tooth as a right-hand half.
    fn to_own_frame(&self, point: Point2<f64>) -> Vector2<f64> {
        let own = self.turned.inverse() * (point - self.centre);
        Vector2::new(own.x, -self.side.sense() * own.y)
    }

    /// Whether a point is in its metal: within the root circle, or between the outline and the far corner of the tip land.
    fn contains(&self, point: Point2<f64>) -> bool {
        let own = self.to_own_frame(point);
        let radius = own.norm();
        let gear = self.gear.gear();
        let here = own.y.atan2(own.x);
        // Inside its root circle a gear is solid.
        if radius <= gear.root_radius() {
            return true;
        }
        if radius >= gear.tip_radius() || here >= -self.range(ProfilePart::Tip).0 {
            return false;
        }
        let part = if radius >= gear.form_radius() {
            ProfilePart::Involute
        } else {
            ProfilePart::Fillet
        };
        let (low, high) = self.range(part);
        let is_below = |t: f64| self.profile.radius(part, t) < radius;
        let [low, high] = bisect(low, high, FINEST * (high - low), is_below);
        let angle = |t: f64| {
            let point = self.profile.point(part, t, Side::Right);
            point.y.atan2(point.x)
        };
        angle(low).max(angle(high)) < here
    }

    /// Least distance of a point from the sector between far corner and root end, within the tip circle.
    fn distance(&self, point: Point2<f64>) -> f64 {
        let own = self.to_own_frame(point);
        let (radius, far) = (self.gear.gear().tip_radius(), own.norm());
        let ends = [
            -self.range(ProfilePart::Root).1,
            -self.range(ProfilePart::Tip).0,
        ];
        let beside = [ends[0] - own.y.atan2(own.x), own.y.atan2(own.x) - ends[1]];
        let beside = beside[0].max(beside[1]).max(0.0);
        match beside {
            _ if far * beside.cos() >= radius => {
                (far * far + radius * radius - 2.0 * far * radius * beside.cos()).sqrt()
            }
            _ if beside < FRAC_PI_2 => far * beside.sin(),
            _ => far,
        }
    }

    /// Greatest distance of a piece from its axis, mm. Along a fillet it may fall and then rises; along an involute it rises towards the
    /// tip.
    fn piece_about(&self, piece: Piece, axis: Point2<f64>) -> f64 {
        match piece {
            Piece::Fillet(ends) | Piece::FarFillet(ends) => {
                let distances = ends.map(|t| (self.at(ProfilePart::Fillet, t).0 - axis).norm());
                distances[0].max(distances[1])
            }
            Piece::Root => self.land_about(ProfilePart::Root, axis),
            Piece::Top | Piece::Tooth => self.reach_about(axis),
        }
    }

    /// Greatest distance of the whole half tooth from its axis, mm.
    fn reach_about(&self, axis: Point2<f64>) -> f64 {
        let low = self.range(ProfilePart::Tip).0;
        let high = self.range(ProfilePart::Root).1;
        let form = self.gear.gear().form_radius();
        self.land_about(ProfilePart::Tip, axis)
            .max(self.arc_about(form, (low, high), axis))
    }

    fn land_about(&self, part: ProfilePart, axis: Point2<f64>) -> f64 {
        self.arc_about(self.radius(part), self.range(part), axis)
    }

    /// Greatest distance of an arc about the gear's centre between two parameters of a land: straight past the centre, or at an end.
    fn arc_about(&self, radius: f64, (low, high): (f64, f64), axis: Point2<f64>) -> f64 {
        let axis = self.to_own_frame(axis);
        let at = (-(-axis.y).atan2(-axis.x)).clamp(low.min(high), high);
        let distance = |t: f64| (radius * Vector2::new(t.cos(), -t.sin()) - axis).norm();
        [at, low, high]
            .map(distance)
            .into_iter()
            .fold(0.0, f64::max)
    }
}

fn further(one: Reach, other: Reach) -> Reach {
    if other.0 > one.0 { other } else { one }
}

#[cfg(test)]
mod tests;
