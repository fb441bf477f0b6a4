//! Proven extremes of a pair with a runout without a stated direction, over all directions.
//!
//! The contact of two outlines depends on the positions of their centres (the axis, for a gear with a known direction). Let the centres be
//! `d` apart, and the line through them be turned by `ψ`. Turned back, this is a pose of the same outlines slightly later in the cycle. (In
//! helical gears all sections have the same centres.) So over a whole cycle and all directions only `d` counts. The room on either side
//! grows with `d`, as the mate moves away from its contact. The least backlash is that of gears whose high teeth face the mate at every
//! pose, and the greatest that of gears whose high teeth point away. These are gears without this eccentricity at the centre distance `a' =
//! a ∓ Σ e` ([`cycle_extremes`](crate::contact::cycle_extremes)), with one difference: the free one turns about its axis, `e` behind (or before) its centre. A turn
//! by `φ` about the axis moves the centre across by `e φ`, which turns the line of centres by `ψ = e φ/a'`. Turned back, the locked gear is
//! further by `ψ` and the free one by `φ + ψ`. With the free gear's operating pitch radius `r'` at `a'`, the lost motion of the other pair
//! is
//!
//! ```text
//! φ' = φ (1 ± e/r')
//! ```
//!
//! and its left flanks touch `ψ` later than its right ones. That equals a pair with turned left flanks: the locked gear's by `ψ`, the free
//! one's by the amount that it goes back meanwhile. The lost motion `φ_0` without this effect gives the effect, and so the extreme `φ_1`.
//! The room on one side changes by less than half of the free gear's turn (a corner on an involute, `1 − (cos δ − ξ sin δ)`, with `δ` at
//! most a third). So no pose exceeds `φ_1` by more than half of `|φ_1 − φ_0| e/r'`.
//!
//! The lean of a shaft stays in the picture: turned back by `ψ`, the pinion leans by another vector, which differs by at most `|ψ|` times the
//! lean. This moves its sections by that over the face, and their height by that times the tip radius.

use crate::contact::{Doubt, End, ExactKernel, Extreme, Extremes, PROVEN_WIDTH, Status, is_proven};
use crate::error::Error;
use crate::gear::{AsBuilt, Side};
use crate::outline::AssembledPair;
use crate::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::{PI, TAU};

/// Greatest change of the room on a side, rad per rad of the free gear. (It also holds on a fillet: an arm of half the base radius is left,
/// or nothing bounds the pair.)
const STEEPEST: f64 = 0.5;

/// Greatest eccentricity for the derivation above, as a part of the free gear's operating pitch radius. Then `e` is also below a quarter of
/// `a'`.
const LARGEST_SHARE: f64 = 0.25;

/// Least distance of the axes above touching base circles, as a part of the sum of the base radii.
const NEAREST: f64 = 1e-6;

/// A search for one extreme of a pair.
pub(super) type Search<'a> = dyn Fn(&GearPair, &ExactKernel, End) -> Result<Extremes, Error> + 'a;

/// A pose, and its pair with its high teeth at the worst place.
#[derive(Debug, Clone)]
pub(super) struct PosedPair {
    pub assembly: AssembledPair,
    pub mating: Mating,
}

/// The least, the greatest and the lost pose of a cycle, and the binding one at the distance from which the pair assembles.
pub(super) type Poses = [Option<PosedPair>; 4];

/// Extremes over all directions.
pub(super) struct AnyDirection {
    pub found: Extremes,
    pub poses: Poses,
    /// The pair without its open eccentricities: at the centre distance less their sum, with its least; at the distance plus their sum,
    /// with its greatest. `None` where an end is not searched.
    pub ends: [Option<(GearPair, Extremes)>; 2],
    /// Difference of these distances from the centre distance, mm.
    pub off: f64,
}

/// Whether a gear has a runout without a direction.
pub(super) fn has_open_runout(assembly: &GearPair) -> bool {
    let gears = Member::BOTH.map(|member| assembly.gear(member));
    gears.iter().any(|gear| open_eccentricity(gear) > 0.0)
}

/// The eccentricity, mm, of a gear without a direction.
fn open_eccentricity(gear: &AsBuilt) -> f64 {
    if gear.any_direction() {
        gear.eccentricity()
    } else {
        0.0
    }
}

/// The extremes `ends` of `assembly`; `search` finds one of a pair without a runout of unknown direction.
pub(super) fn extremes(
    assembly: &GearPair,
    ends: &[End],
    search: &Search<'_>,
) -> Result<AnyDirection, Error> {
    // Neither a distance nor a direction changes a tooth.
    let kernel = ExactKernel::new(assembly);
    let facing = |end: End| {
        let wanted = ends.contains(&end);
        let facing = wanted.then(|| Facing::new(assembly, &kernel, end, search));
        facing.transpose()
    };
    let (near, far) = (facing(End::Least)?, facing(End::Greatest)?);
    let status_of = |end: &Option<Facing>| end.as_ref().map(|end| end.found.status);
    let status = match (status_of(&near), status_of(&far)) {
        (Some(Status::Jammed), _) => Status::Jammed,
        (_, Some(Status::NoContact)) => Status::NoContact,
        (one, other) => one.or(other).unwrap_or(Status::Unproven),
    };
    let bounded = |end: &Option<Facing>| end.as_ref().map_or(Ok(None), Facing::bounded);
    let (least, least_pose) = bounded(&near)?.unzip();
    let (greatest, greatest_pose) = bounded(&far)?.unzip();
    let losing = match status {
        Status::Jammed => &near,
        _ => &far,
    };
    let lost = losing
        .as_ref()
        .and_then(|end| Some(end.directed(end.found.lost?, None)));
    let lost = lost.transpose()?.map(|(assembly, mating)| PosedPair {
        assembly: assembly.into(),
        mating,
    });
    let matings = near.iter().chain(&far).map(|end| end.found.matings).next();
    let open = Member::BOTH.map(|member| open_eccentricity(assembly.gear(member)));
    Ok(AnyDirection {
        found: Extremes {
            matings: matings.unwrap_or(0),
            status,
            least,
            greatest,
            lost: lost.as_ref().map(|pose| pose.mating),
        },
        poses: [least_pose, greatest_pose, lost, None],
        off: open.iter().sum(),
        ends: [near, far].map(|end| end.map(|end| (end.centred, end.found))),
    })
}

/// All high teeth towards the mate for the least, or away from it for the greatest.
struct Facing<'a> {
    assembly: &'a GearPair,
    /// Its kernel.
    kernel: &'a ExactKernel,
    end: End,
    /// `e` of the free gear, mm: behind its axis, or before it.
    off: f64,
    centred: GearPair,
    found: Extremes,
    /// Finds the extreme of a pair without a runout of unknown direction.
    search: &'a Search<'a>,
}

impl<'a> Facing<'a> {
    fn new(
        assembly: &'a GearPair,
        kernel: &'a ExactKernel,
        end: End,
        search: &'a Search<'a>,
    ) -> Result<Facing<'a>, Error> {
        let off = |member| end.sign() * open_eccentricity(assembly.gear(member));
        let gear = |member| assembly.gear(member).centred();
        let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
        let wanted = assembly.center_distance() - off(Member::Wheel) - off(Member::Pinion);
        let base = wheel.gear().base_radius() + pinion.gear().base_radius();
        // Involutes have no contact at a lesser distance: a result there bounds nothing unless it jams.
        let distance = wanted.max(base * (1.0 + NEAREST));
        let centred = assembly.with_gears(wheel, pinion, distance)?;
        let mut found = search(&centred, &kernel.at(&centred), end)?;
        if let Some(least) = found.least.as_mut().filter(|_| wanted < distance) {
            (least.low, least.doubt) = (f64::NEG_INFINITY, Some(Doubt::Unbounded));
        }
        Ok(Facing {
            assembly,
            kernel,
            end,
            off: off(assembly.free()),
            found,
            centred,
            search,
        })
    }

    /// The bracket of the extreme of the centred pair, converted to the assembly; and the pose that attains it.
    fn bounded(&self) -> Result<Option<(Extreme, PosedPair)>, Error> {
        let Some(mut extreme) = self.found.at(self.end) else {
            return Ok(None);
        };
        let free = self.assembly.free();
        let radius = self.centred.operating_pitch_radius(free);
        let share = self.off / radius;
        let angle = |j_wt: f64| j_wt / radius / (1.0 + share);
        let mut supposed = None;
        if self.off != 0.0
            && let Some([right, left]) = self.contacts(extreme.mating)?
        {
            let turn = left - right;
            let turned = self.with_left_flanks_on(turn)?;
            let found = (self.search)(&turned, &ExactKernel::new(&turned), self.end)?;
            if let Some(other) = found.at(self.end) {
                (extreme, supposed) = (other, Some(turn.abs()));
            }
        }
        let ends = [angle(extreme.low), angle(extreme.high)];
        let turn = ends[0].abs().max(ends[1].abs());
        // The difference from the supposed turn, and the third order of `2 atan(e sin(φ/2)/(A − e cos(φ/2)))` with `A` from the axis to the
        // mate's centre: less than `φ²/24 + e φ²/(8 a')` of it, and for `e` below a quarter of `a'` less than `φ²/12`.
        let off = supposed.map_or(turn, |supposed| {
            let each = ends.map(|end| (end.abs() - supposed).abs());
            each[0].max(each[1])
        });
        // Above the largest share nothing is claimed.
        let most = share.abs().min(LARGEST_SHARE);
        // Without a bound it is unknown. The attained value alone has no slack.
        let slack = if off.is_finite() {
            (STEEPEST * off + turn.powi(3) / 12.0) * most / (1.0 - 2.0 * most) + self.by_lean()
        } else {
            0.0
        };
        let contacts = self.contacts(extreme.mating)?;
        let (assembly, mating) = self.directed(extreme.mating, contacts)?;
        let per_radian = assembly.operating_pitch_radius(free);
        let is_beyond = share.abs() > LARGEST_SHARE;
        let [mut low, mut high] = if is_beyond {
            [f64::NEG_INFINITY, f64::INFINITY]
        } else {
            [ends[0] - slack, ends[1] + slack].map(|end| end * per_radian)
        };
        let mut found = angle(extreme.found) * per_radian;
        let kernel = self.kernel.at(&assembly);
        let seen = kernel.lost_motion_at(&assembly, mating)?;
        // The attained value bounds the other end.
        if let Some((angle, error)) = seen.and_then(|seen| seen.angle().zip(seen.error())) {
            let attained = [angle - error, angle + error].map(|end| end * per_radian);
            found = angle * per_radian;
            [low, high] = match self.end {
                End::Least => [low.min(attained[0]), attained[1]],
                End::Greatest => [attained[0], high.max(attained[1])],
            };
        }
        let is_wide = !is_proven(low, high, PROVEN_WIDTH);
        let bounded = Extreme {
            low,
            high,
            found,
            mating,
            doubt: if is_beyond {
                Some(Doubt::Unbounded)
            } else {
                extreme.doubt.or(is_wide.then_some(Doubt::SecondOrder))
            },
        };
        let assembly = assembly.into();
        Ok(Some((bounded, PosedPair { assembly, mating })))
    }

    /// Bound on the change of a lost motion, rad, by the turn of the line of centres where the pinion's shaft leans.
    fn by_lean(&self) -> f64 {
        let (assembly, pinion) = (self.assembly, self.centred.gear(Member::Pinion));
        let open = Member::BOTH.map(|member| open_eccentricity(assembly.gear(member)));
        // The sine of this turn is at most the sum by the distance.
        let turn = 0.5 * PI * (open[0] + open[1]) / self.centred.center_distance();
        let [in_plane, out_of_plane] = assembly.lean();
        let [from, to] = assembly.face();
        let reach = pinion.gear().tip_radius() + pinion.eccentricity();
        let slope = pinion.gear().basic_data().base_helix_angle().tan();
        let moved = from.abs().max(to.abs()) + slope * reach;
        let free = self.centred.gear(assembly.free()).gear();
        2.0 * turn * in_plane.hypot(out_of_plane) * moved / free.base_radius()
    }

    /// Rotations of the free gear at contact of its right and its left flanks, at a mating of the centred pair.
    fn contacts(&self, mating: Mating) -> Result<Option<[f64; 2]>, Error> {
        let (assembly, mating) = self.directed(mating, None)?;
        let kernel = self.kernel.at(&assembly);
        let found = kernel.lost_motion_at(&assembly, mating)?;
        Ok(found.and_then(|found| Some([found.right?.rotation, found.left?.rotation])))
    }

    /// Turn of the line of centres, rad, while the free gear turns by `turn` about its axis.
    fn line_turn(&self, turn: f64) -> f64 {
        self.off * turn / self.centred.center_distance()
    }

    /// The centred pair with the left flanks as after a turn of the free gear by `turn` about its axis.
    fn with_left_flanks_on(&self, turn: f64) -> Result<GearPair, Error> {
        let (locked, free) = (self.centred.locked(), self.centred.free());
        let teeth = |member| {
            let gear: &AsBuilt = self.centred.gear(member);
            f64::from(gear.gear().basic_data().teeth())
        };
        let line_turn = self.line_turn(turn);
        let gear = |member| {
            let by = if member == locked {
                line_turn
            } else {
                -line_turn * teeth(locked) / teeth(free)
            };
            self.centred.gear(member).with_side_turned(Side::Left, by)
        };
        let (wheel, pinion) = (gear(Member::Wheel)?, gear(Member::Pinion)?);
        Ok(self
            .centred
            .with_gears(wheel, pinion, self.centred.center_distance())?)
    }

    /// The assembly with its high teeth as for this end, and its mating with the position of `mating` of the centred pair. The free gear is
    /// between the rotations of both `contacts`, or at its nominal one.
    fn directed(
        &self,
        mating: Mating,
        contacts: Option<[f64; 2]>,
    ) -> Result<(GearPair, Mating), Error> {
        let assembly = self.assembly;
        let locked = assembly.gear(assembly.locked());
        // At another distance a tooth is slightly displaced: the mating moves on by that.
        let there = Pose::new(&self.centred, mating).locked_rotation();
        let here = Pose::new(assembly, mating).locked_rotation();
        let beside = (there - here + PI).rem_euclid(TAU) - PI;
        // Half of the turn of the line of centres between the contacts: at the right one it is back by that.
        let turn = contacts.map_or(0.0, |[right, left]| left - right);
        let beside = beside + 0.5 * self.line_turn(turn);
        let pitch = locked.gear().basic_data().angular_pitch();
        let mating = mating.onward(assembly, -locked.face().ascending() * beside / pitch);
        let pose = Pose::new(assembly, mating);
        let facing = self.centred.center_distance() < assembly.center_distance();
        let gear = |member| {
            let gear: &AsBuilt = assembly.gear(member);
            if !gear.any_direction() {
                return Ok(gear.clone());
            }
            let between = contacts.filter(|_| member == assembly.free());
            let rotation = match between {
                Some([right, left]) => 0.5 * (right + left),
                None => pose.rotation(assembly, member),
            };
            let angle = if facing { -rotation } else { PI - rotation };
            let along = gear.face().ascending() * angle;
            let tooth = gear.gear().basic_data().tooth_towards(along);
            gear.with_runout(gear.eccentricity(), tooth)
        };
        let (wheel, pinion) = (gear(Member::Wheel)?, gear(Member::Pinion)?);
        let pair = assembly.with_gears(wheel, pinion, assembly.center_distance())?;
        Ok((pair, mating))
    }
}
