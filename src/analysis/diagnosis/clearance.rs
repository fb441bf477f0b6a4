//! Radial clearance as built: the least distance from a tip land to a root land over the rotation.
//!
//! Both gears roll together, the free one in the middle of the mean teeth's backlash. Lands are arcs about the
//! displaced centres, tooth by tooth. Their distance is that of two arcs that curve away from each other, or the depth
//! to which a tip reaches below the root circle, where everything is metal.

use super::lands::{Land, between_lands, near, root_land, tip_land};
use crate::analytic::InvolutePair;
use crate::contact::first_least;
use crate::error::{Error, Tick, go_on};
use crate::gear::Placed;
use crate::pair::{GearPair, Mating, Member, Pose};
use crate::parallel;
use std::collections::HashSet;
use std::f64::consts::PI;

/// Samples per pitch before the least distance is refined (tuned: a root land takes part in a twentieth of a pitch;
/// elsewhere the distance grows steadily).
const STEPS: u32 = 32;
/// Accuracy of the rotation, pitches. The distance changes by up to a module per pitch at a land's end, so this gives 1e-9 of that.
const PITCHES: f64 = 1e-9;

/// The place where a tip is nearest to a root.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RadialClearance {
    /// Least distance, mm; negative if the tip is inside the root.
    pub distance: f64,
    /// Tooth of the tip.
    pub tip_tooth: u32,
    /// The mate's tooth clockwise of the space of the root.
    pub root_tooth: u32,
    /// Positions of the gears.
    pub mating: Mating,
}

/// The least distance between `member`'s tips and its mate's roots, over one revolution of the locked gear from each of
/// `matings`, as far as it meets new teeth.
///
/// `None` without matings. Pitches that cannot contain the least distance are skipped.
pub fn radial_clearance(
    assembly: &GearPair,
    member: Member,
    matings: &[Mating],
) -> Option<RadialClearance> {
    let pitches = pitches(assembly, matings);
    // The search is never interrupted.
    least_over(assembly, member, &pitches, &go_on).ok()?
}

/// The least distance over one pitch from each of `pitches`; `tick` is called once for each.
pub(super) fn least_over(
    assembly: &GearPair,
    member: Member,
    pitches: &[Mating],
    tick: &Tick,
) -> Result<Option<RadialClearance>, Error> {
    let rolling = Rolling::new(assembly, member);
    let bounds = parallel::map(pitches, |mating| rolling.least_possible(*mating));
    let Some(first) = (0..pitches.len()).min_by(|i, j| bounds[*i].total_cmp(&bounds[*j])) else {
        return Ok(None);
    };
    let reached = rolling.within_pitch(pitches[first]).distance;
    let found = parallel::map(pitches.iter().zip(&bounds), |(mating, bound)| {
        let looked_at = || (*bound <= reached).then(|| rolling.within_pitch(*mating));
        Error::if_stopped(tick(1)).map(|()| looked_at())
    });
    let found: Vec<Option<RadialClearance>> = found.into_iter().collect::<Result<_, Error>>()?;
    // The first of equals, with any number of threads.
    let found = found.into_iter().flatten();
    Ok(first_least(found.map(|found| (found, found.distance, 0.0))))
}

/// The starts of the pitches over which the least distance is searched, no two with the same teeth.
pub(super) fn pitches(assembly: &GearPair, matings: &[Mating]) -> Vec<Mating> {
    let teeth = assembly.teeth(assembly.locked());
    let mut met = HashSet::new();
    let mut pitches = Vec::new();
    for start in matings {
        let start = Mating {
            fraction: 0.0,
            ..*start
        };
        for pitch in 0..teeth {
            let mating = start.onward(assembly, f64::from(pitch));
            if !met.insert((mating.wheel_tooth, mating.pinion_tooth)) {
                break;
            }
            pitches.push(mating);
        }
    }
    pitches
}

/// Both gears rolling together, with the data that are the same at every pose.
struct Rolling<'a> {
    assembly: &'a GearPair,
    /// The gear of the tips.
    member: Member,
    /// Half the backlash of the mean teeth, as a rotation of the free gear, rad.
    half_play: f64,
    /// Half the tip land of a mean tooth of `member`, rad.
    half_tip: f64,
}

impl<'a> Rolling<'a> {
    fn new(assembly: &'a GearPair, member: Member) -> Rolling<'a> {
        let play = InvolutePair::of(assembly)
            .base_backlash(assembly.center_distance())
            .unwrap_or(0.0);
        let free = assembly.gear(assembly.free()).gear().base_radius();
        let tips = assembly.gear(member).gear();
        Rolling {
            assembly,
            member,
            half_play: 0.5 * play / free,
            half_tip: tips.half_angle_at_roll(tips.tip_roll()),
        }
    }

    /// Lower bound of the distance that [`Rolling::within_pitch`] can find from `mating`, mm.
    ///
    /// Points of a tip circle and of a root circle are at least `d − r_a − r_f` apart, where `d` is the distance of the
    /// centres. From the middle of the pitch each centre moves by at most its eccentricity times the rotation.
    fn least_possible(&self, mating: Mating) -> f64 {
        let [tips, roots] = self.placed(mating.onward(self.assembly, 0.5));
        let distance = (roots.centre() - tips.centre()).norm();
        let reach = 0.5 + 2.0 / f64::from(STEPS);
        let moves = [&tips, &roots].map(|placed| {
            let gear = placed.as_built();
            reach * gear.gear().basic_data().angular_pitch() * gear.eccentricity()
        });
        let radii = tips.as_built().gear().tip_radius() + roots.as_built().gear().root_radius();
        distance - radii - moves[0] - moves[1] - rounding(distance + radii)
    }

    /// The least distance over one pitch from `mating`.
    fn within_pitch(&self, mating: Mating) -> RadialClearance {
        let at = |pitches: f64| self.nearest_lands(mating.onward(self.assembly, pitches));
        let step = 1.0 / f64::from(STEPS);
        let mut best = (at(0.0), 0.0);
        for i in 1..STEPS {
            let pitches = f64::from(i) * step;
            let found = at(pitches);
            if found.distance < best.0.distance {
                best = (found, pitches);
            }
        }
        // Thirds: the distance falls towards the least value and rises after it.
        let (mut low, mut high) = (best.1 - step, best.1 + step);
        while high - low > PITCHES {
            let third = (high - low) / 3.0;
            let (left, right) = (at(low + third), at(high - third));
            for found in [left, right] {
                if found.distance < best.0.distance {
                    best.0 = found;
                }
            }
            if left.distance <= right.distance {
                high -= third;
            } else {
                low += third;
            }
        }
        best.0
    }

    /// The gear of the tips and its mate, at `mating`.
    fn placed(&self, mating: Mating) -> [Placed<'a>; 2] {
        let assembly = self.assembly;
        let pose = Pose::new(assembly, mating);
        // Right-flank contact is the clockwise end of the backlash.
        let half = -mating.flank.sense() * self.half_play;
        [self.member, self.member.mate()].map(|member| {
            let rotation = if member == assembly.locked() {
                pose.locked_rotation()
            } else {
                pose.free_rotation() + half
            };
            Placed::new(
                assembly.gear(member),
                assembly.axis(member),
                assembly.mate_direction(member) + rotation,
            )
        })
    }

    /// The nearest tip and root at `mating`.
    fn nearest_lands(&self, mating: Mating) -> RadialClearance {
        let [tips, roots] = self.placed(mating);
        let between = roots.centre() - tips.centre();
        let distance = between.norm();
        let towards = between.y.atan2(between.x);
        let (tip_radius, root_radius) = (
            tips.as_built().gear().tip_radius(),
            roots.as_built().gear().root_radius(),
        );
        let mut least = RadialClearance {
            distance: f64::INFINITY,
            tip_tooth: 0,
            root_tooth: 0,
            mating,
        };
        let tips = near(&tips, towards, 0.0).map(|tooth| {
            let ends = tip_land(&tips, self.half_tip, tooth, towards);
            (tooth, Land::new(distance, tip_radius, ends))
        });
        let roots = near(&roots, towards + PI, 0.5).map(|tooth| {
            let ends = root_land(&roots, tooth, towards + PI);
            (tooth, Land::new(distance, root_radius, ends))
        });
        let nearest = |lands: &[(u32, Land); 3]| {
            let lands = lands.map(|(_, land)| land);
            lands
                .into_iter()
                .reduce(|one, other| if other.reach < one.reach { other } else { one })
        };
        let most = match (nearest(&tips), nearest(&roots)) {
            (Some(tip), Some(root)) => between_lands(distance, &tip, &root),
            _ => f64::INFINITY,
        } + rounding(distance);
        for (tip_tooth, tip) in &tips {
            for (root_tooth, root) in &roots {
                // No point of either land is nearer to the other circle than this, so larger values are skipped.
                // (Inside the root circle only the depth of a tip counts.)
                let outside = tip.reach > root_radius && root.reach - tip_radius > most;
                if tip.reach - root_radius > most || outside {
                    continue;
                }
                let apart = between_lands(distance, tip, root);
                if apart < least.distance {
                    least.distance = apart;
                    least.tip_tooth = *tip_tooth;
                    least.root_tooth = *root_tooth;
                }
            }
        }
        least
    }
}

/// Rounding of distances, which are sums and products of a few dozen lengths of `size`, mm.
fn rounding(size: f64) -> f64 {
    64.0 * f64::EPSILON * size
}
