//! Verifies a [`Proof`] from the outlines alone. Nothing is searched for, and nothing of prover or kernel is used.
//!
//! Teeth are placed by number, in the picture. How far a piece reaches in a direction is the greatest `P·n` of its curves, by bisection of their
//! own points and normals. Three things are verified: the directions named do keep their pieces apart; the pieces named are all there are, of every
//! locked tooth and the free tooth that faces it, unless these are out of reach of each other; and the point named lies in the metal of both teeth.

use super::proof::{Piece, Proof, Reason, Separation, SideProof};
use crate::gear::{AsBuilt, Profile, ProfilePart, Side};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{Point2, UnitComplex, Vector2};
use std::f64::consts::FRAC_PI_2;

/// A half tooth in the picture.
struct Half<'a> {
    gear: &'a AsBuilt,
    profile: Profile<'a>,
    side: Side,
    tooth: u32,
    centre: Point2<f64>,
    turned: UnitComplex<f64>,
}

/// How far a piece reaches in a direction: greatest `P·n`, and where.
type Reach = (f64, Point2<f64>);

impl Proof {
    /// Verifies from the outlines alone that it proves `pose` of `assembly`: a program of its own, which shares nothing with what made it.
    ///
    /// # Errors
    /// The first thing that is not as the proof says.
    pub fn verify(&self, assembly: &GearPair, pose: &Pose) -> Result<(), String> {
        for side in Side::BOTH {
            if !self.sides.iter().any(|proven| proven.side == side) {
                return Err(format!("nothing is said of the {} side", side.name()));
            }
        }
        for side in &self.sides {
            if !assembly.is_helical() {
                verify_side(assembly, pose, side)?;
                continue;
            }
            let here = pose.in_section(assembly, side.section);
            verify_side(&assembly.section(side.section), &here, side)?;
        }
        Ok(())
    }
}

fn verify_side(assembly: &GearPair, pose: &Pose, proof: &SideProof) -> Result<(), String> {
    let side = proof.side;
    let free = |tooth, rotation| Half::new(assembly, assembly.free(), rotation, side, tooth);
    let locked = |tooth| {
        Half::new(
            assembly,
            assembly.locked(),
            pose.locked_rotation(),
            side,
            tooth,
        )
    };
    if let Some(touch) = &proof.touch {
        let teeth = [
            locked(touch.locked_tooth),
            free(touch.free_tooth, touch.closed),
        ];
        if let Some(tooth) = teeth.iter().find(|tooth| !tooth.has(touch.point)) {
            return Err(format!(
                "tooth {} does not hold the common point",
                tooth.tooth
            ));
        }
    }
    let gear = assembly.gear(assembly.locked());
    let mating = pose.mating().tooth(assembly.locked());
    let (pitch, teeth) = (
        gear.gear().basic_data().angular_pitch(),
        gear.gear().basic_data().teeth(),
    );
    // All locked teeth, half of them to either side of the one nearest to the line of centres.
    let from_line = pose.locked_rotation() + gear.tooth_angle(f64::from(mating));
    let nearest = -(from_line / pitch).round() as i64;
    let (before, behind) = (i64::from(teeth - 1) / 2, i64::from(teeth) / 2);
    for steps in nearest - before..=nearest + behind {
        let locked_tooth = gear.counter_clockwise(mating, steps);
        let free_tooth = pose.facing_tooth(assembly, side, steps);
        // Out of reach at every rotation, where no rotation is named.
        let pair = [
            locked(locked_tooth),
            free(free_tooth, proof.open.unwrap_or(0.0)),
        ];
        let named =
            |one: &&Separation| (one.locked_tooth, one.free_tooth) == (locked_tooth, free_tooth);
        let named: Vec<&Separation> = proof.apart.iter().filter(named).collect();
        let axis = assembly.axis(assembly.free());
        if named.is_empty() && pair[0].distance(axis) > pair[1].reach_about(axis) {
            continue;
        }
        let failed = |what: &str| {
            let name = side.name();
            Err(format!(
                "{name} side, locked tooth {locked_tooth}, free tooth {free_tooth}: {what}"
            ))
        };
        for one in &named {
            if !holds(&pair, one, axis, proof.open.is_some()) {
                return failed(&format!(
                    "{:?} of {:?} and {:?}",
                    one.by, one.locked, one.free
                ));
            }
        }
        for part in PARTS {
            for other in PARTS {
                let radii = pair[0].radius(part) + pair[1].radius(other);
                let apart = (pair[0].centre - axis).norm() - pair[1].gear.eccentricity();
                if radii > apart && !covers(&pair, &named, part, other) {
                    return failed(&format!(
                        "of {} and {} a part is left out",
                        part.name(),
                        other.name()
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Parts of a half tooth, each with what it is named by; the top includes tip and involute.
const PARTS: [ProfilePart; 3] = [ProfilePart::Tip, ProfilePart::Fillet, ProfilePart::Root];

/// Whether `named` has all of two parts: of fillets every stretch.
fn covers(pair: &[Half; 2], named: &[&Separation], part: ProfilePart, other: ProfilePart) -> bool {
    let parts = [part, other];
    let ranges = [0, 1].map(|k| pair[k].range(parts[k]));
    if ranges.iter().any(|(low, high)| low >= high) {
        return true;
    }
    let within = |piece: Piece, k: usize| match (piece, parts[k]) {
        (Piece::Top, ProfilePart::Tip) | (Piece::Root, ProfilePart::Root) => Some(ranges[k]),
        (Piece::Fillet([low, high]), ProfilePart::Fillet) => Some((low, high)),
        _ => None,
    };
    let whole_free = |one: &&Separation| one.by == Reason::OutOfReach && one.free == Piece::Top;
    let boxes: Vec<[(f64, f64); 2]> = named
        .iter()
        .filter_map(|one| {
            let free = if whole_free(one) {
                Some(ranges[1])
            } else {
                within(one.free, 1)
            };
            Some([within(one.locked, 0)?, free?])
        })
        .collect();
    // Every cell of the grid of all their ends lies in one of them.
    let grid = [0, 1].map(|k| {
        let mut ends: Vec<f64> = boxes.iter().flat_map(|one| [one[k].0, one[k].1]).collect();
        ends.extend([ranges[k].0, ranges[k].1]);
        ends.retain(|end| *end >= ranges[k].0 && *end <= ranges[k].1);
        ends.sort_by(f64::total_cmp);
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

/// Whether what is said to keep two pieces apart does; `open`: at a rotation, else at every one.
fn holds(pair: &[Half; 2], one: &Separation, axis: Point2<f64>, open: bool) -> bool {
    let [locked, free] = pair;
    let n = one.normal;
    let opening = -locked.side.sense();
    let (reach, _) = locked.reach(one.locked, n);
    match one.by {
        Reason::Direction => {
            let (back, at) = free.reach(one.free, -n);
            open && -back > reach && opening * turns(axis, at, n) > 0.0
        }
        Reason::OutOfReach => axis.coords.dot(&n) - free.piece_about(one.free, axis) > reach,
        Reason::LockedTangents => {
            open && off_tangents(locked, one.locked, (free, one.free), |at, n| {
                opening * turns(axis, at, n)
            })
        }
        // A force out of the free metal turns the free gear the other way.
        Reason::FreeTangents => {
            open && off_tangents(free, one.free, (locked, one.locked), |at, n| {
                opening * turns(axis, at, -n)
            })
        }
    }
}

/// Moment about `axis` of a unit force along `n` at a point.
fn turns(axis: Point2<f64>, at: Point2<f64>, n: Vector2<f64>) -> f64 {
    (at - axis).perp(&n)
}

/// Whether the tangents of all points of a fillet's stretch keep a piece of the mate off.
///
/// The distance `σ(ν)` of the piece from the tangent with the normal `e^{iν}` has `σ'' + σ = R − ρ`, the difference of both radii of curvature. Where
/// that is not negative, `σ` lies above `σ_0 cos x + σ_0' sin x` of either end of a cell. Cells are halved until that is enough.
fn off_tangents(
    half: &Half,
    fillet: Piece,
    (mate, piece): (&Half, Piece),
    arm: impl Fn(Point2<f64>, Vector2<f64>) -> f64,
) -> bool {
    let Piece::Fillet([low, high]) = fillet else {
        return false;
    };
    let at = |t: f64| {
        let (point, n) = half.at(ProfilePart::Fillet, t);
        let (back, met) = mate.reach(piece, -n);
        (point, n, -back - point.coords.dot(&n), met)
    };
    let mut cells = vec![(low, high, 0)];
    while let Some((low, high, depth)) = cells.pop() {
        let [(p0, n0, s0, q0), (p1, n1, s1, q1)] = [low, high].map(at);
        if !(s0 > 0.0 && s1 > 0.0 && arm(q0, n0) > 0.0 && arm(q1, n1) > 0.0) {
            return false;
        }
        // σ' is how far the mate's point lies along the tangent; towards each other it falls.
        let turn = n0.perp(&n1);
        let slope =
            |p: Point2<f64>, q: Point2<f64>, n: Vector2<f64>| (q - p).dot(&Vector2::new(-n.y, n.x));
        let falls = [
            slope(p0, q0, n0) * turn.signum(),
            -slope(p1, q1, n1) * turn.signum(),
        ];
        let width = turn.abs().asin();
        let hollow = (p1 - p0).norm() >= (q1 - q0).norm();
        // Each bound is concave where it is above 0: the greater of both is least where they cross, or at an end.
        if hollow && crossing([s0, s1], falls, width) > 0.0 {
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
    let (mut low, mut high) = (0.0, width);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match bound(0, middle) > bound(1, width - middle) {
            true => low = middle,
            false => high = middle,
        }
    }
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

    /// Parameters of a part's ends: of the tip land from its far corner, of the root land to the middle of the space.
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

    /// How far a piece reaches in the direction `n`.
    fn reach(&self, piece: Piece, n: Vector2<f64>) -> Reach {
        match piece {
            Piece::Top => {
                let of = |part| self.reach_of(part, self.range(part), n);
                farther(of(ProfilePart::Tip), of(ProfilePart::Involute))
            }
            Piece::Fillet([low, high]) => self.reach_of(ProfilePart::Fillet, (low, high), n),
            Piece::Root => self.reach_of(ProfilePart::Root, self.range(ProfilePart::Root), n),
        }
    }

    /// The same of one curve, which turns one way, by less than half a turn: at an end, or where it turns from rising to falling.
    fn reach_of(
        &self,
        part: ProfilePart,
        (mut low, mut high): (f64, f64),
        n: Vector2<f64>,
    ) -> Reach {
        let reach = |t: f64| {
            let (point, _) = self.at(part, t);
            (point.coords.dot(&n), point)
        };
        let (start, end) = (self.at(part, low), self.at(part, high));
        let sense = (end.0 - start.0).perp(&start.1).signum();
        let rises = |t: f64| sense * n.perp(&self.at(part, t).1) > 0.0;
        let ends = farther(reach(low), reach(high));
        if !rises(low) || rises(high) {
            return ends;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match rises(middle) {
                true => low = middle,
                false => high = middle,
            }
        }
        farther(ends, farther(reach(low), reach(high)))
    }
}

/// Geometry of the metal, in the frame of the tooth as a right-hand half.
impl Half<'_> {
    fn own(&self, point: Point2<f64>) -> Vector2<f64> {
        let own = self.turned.inverse() * (point - self.centre);
        Vector2::new(own.x, -self.side.sense() * own.y)
    }

    /// Whether a point lies in its metal, between the outline and the far corner of the tip land.
    fn has(&self, point: Point2<f64>) -> bool {
        let own = self.own(point);
        let radius = own.norm();
        let gear = self.gear.gear();
        let here = own.y.atan2(own.x);
        let ends = [
            -self.range(ProfilePart::Root).1,
            -self.range(ProfilePart::Tip).0,
        ];
        if radius >= gear.tip_radius() || here >= ends[1] {
            return false;
        }
        if radius <= gear.root_radius() {
            return here > ends[0];
        }
        let part = match radius >= gear.form_radius() {
            true => ProfilePart::Involute,
            false => ProfilePart::Fillet,
        };
        let (mut low, mut high) = self.range(part);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            match self.profile.radius(part, middle) < radius {
                true => low = middle,
                false => high = middle,
            }
        }
        let angle = |t: f64| {
            let point = self.profile.point(part, t, Side::Right);
            point.y.atan2(point.x)
        };
        angle(low).max(angle(high)) < here
    }

    /// Least distance of a point from the sector between far corner and root end, within the tip circle.
    fn distance(&self, point: Point2<f64>) -> f64 {
        let own = self.own(point);
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

    /// Greatest distance of a piece from its axis, mm. Along a fillet it may fall and then rises; along an involute it rises towards the tip.
    fn piece_about(&self, piece: Piece, axis: Point2<f64>) -> f64 {
        match piece {
            Piece::Fillet(ends) => {
                let distances = ends.map(|t| (self.at(ProfilePart::Fillet, t).0 - axis).norm());
                distances[0].max(distances[1])
            }
            Piece::Root => self.land_about(ProfilePart::Root, axis),
            Piece::Top => self.reach_about(axis),
        }
    }

    /// Greatest distance of the whole half tooth from its axis, mm.
    fn reach_about(&self, axis: Point2<f64>) -> f64 {
        let deeper = self.gear.eccentricity() + self.gear.gear().form_radius();
        self.land_about(ProfilePart::Tip, axis).max(deeper)
    }

    /// That of a land: where it lies straight beyond the gear's centre, or an end.
    fn land_about(&self, part: ProfilePart, axis: Point2<f64>) -> f64 {
        let (low, high) = self.range(part);
        let beyond = self.own(self.centre + (self.centre - axis));
        let at = (-beyond.y.atan2(beyond.x)).clamp(low.min(high), high);
        let distance = |t: f64| (self.at(part, t).0 - axis).norm();
        [at, low, high]
            .map(distance)
            .into_iter()
            .fold(0.0, f64::max)
    }
}

fn farther(one: Reach, other: Reach) -> Reach {
    if other.0 > one.0 { other } else { one }
}
