//! The result of each wheel with each pinion, the best assignment, and simpler ways of pairing for comparison.

use crate::analysis::extremes::WIDTH;
use crate::contact::first_least;
use crate::error::{Error, GearError, Tick};
use crate::gear::AsBuilt;
use crate::pair::{GearPair, Member, SweepPlan};
use crate::parallel;
use crate::population::{Assembly, AssemblyLimits, Outcome, OutcomeKind, Standing};
use pathfinding::kuhn_munkres::kuhn_munkres;
use pathfinding::matrix::Matrix as Weights;

/// Greatest distinguished distance from the target, mm: more than teeth differ.
const FARTHEST: f64 = 100.0;

/// Greatest value of [`Fit::off_in_widths`].
pub(super) const MOST_WIDTHS: i64 = (FARTHEST / WIDTH) as i64;

/// How the gears are assembled, and what is required.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairConditions {
    /// Least and greatest centre distance, mm: the least backlash is found at the first, the greatest at the second.
    pub center_distances: [f64; 2],
    /// Radial play of both bearings together, mm.
    pub clearance: f64,
    /// The locked gear.
    pub locked: Member,
    /// The common face of helical gears, mm ([`GearPair::with_face`]); `[0, 0]` for spur gears.
    pub face: [f64; 2],
    /// Lean of the pinion's axis, mm per mm ([`GearPair::with_lean`]).
    pub lean: [f64; 2],
    /// The requirement for each pair over its whole mesh cycle.
    pub requirement: AssemblyLimits,
    /// The target backlash, mm; `None`: see [`PairConditions::target_backlash`].
    pub target: Option<f64>,
}

impl PairConditions {
    /// The target backlash, mm.
    ///
    /// Without a stated target it is the middle of the required range, a lower limit alone, half of an upper limit alone, or 0.
    pub fn target_backlash(&self) -> f64 {
        let limits = (self.requirement.min(), self.requirement.max());
        self.target.unwrap_or(match limits {
            (Some(min), Some(max)) => 0.5 * (min + max),
            (Some(min), None) => min,
            (None, Some(max)) => 0.5 * max,
            (None, None) => 0.0,
        })
    }
}

/// A wheel and a pinion in one assembly phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// The pinion tooth whose right flank meets that of wheel tooth 1.
    pub pinion_tooth: u32,
    /// The outcome.
    pub outcome: Outcome,
    /// Whether the outcome is proven and meets the requirement.
    pub meets: bool,
    /// Greatest distance of the backlash from the target over the mesh cycle, mm; infinite without backlash.
    pub off: f64,
}

/// A wheel and a pinion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairFit {
    /// The best phase: one that meets the requirement, if any, and nearest to the target.
    pub best: Fit,
    /// Number of assembly phases that meet the requirement.
    pub phases_that_meet: u32,
}

/// Every wheel with every pinion.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    pub(super) wheels: usize,
    pub(super) pinions: usize,
    /// The cells, wheel by wheel.
    pub(super) cells: Vec<PairFit>,
    pub(super) phases: u32,
    /// Mean base tooth thickness of each gear, mm.
    pub(super) thicknesses: [Vec<f64>; 2],
}

impl Matrix {
    /// Every wheel with every pinion in every assembly phase, gcd(z_1, z_2) of them.
    ///
    /// All wheels have the same number of teeth, and so have all pinions. `tick` runs for each cell, on any thread; a break ends the work.
    ///
    /// # Errors
    /// [`Error::Interrupted`]; gears that make no pair at one of the distances, or with different numbers of teeth.
    pub fn new(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        conditions: &PairConditions,
        tick: &Tick,
    ) -> Result<Matrix, Error> {
        let cells = Matrix::cells(wheels, pinions, conditions, tick)?;
        Ok(Matrix::of_cells(wheels, pinions, cells)?)
    }

    /// The cells of the matrix, wheel by wheel. A cell depends only on its two gears.
    ///
    /// # Errors
    /// As [`Matrix::new`].
    pub fn cells(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        conditions: &PairConditions,
        tick: &Tick,
    ) -> Result<Vec<PairFit>, Error> {
        let phases = phase_count(wheels, pinions)?;
        let pairs = |wheel| pinions.iter().map(move |pinion| (wheel, pinion));
        let gears = wheels.iter().flat_map(pairs);
        let cells = parallel::map(gears, |(wheel, pinion)| {
            Error::if_stopped(tick(1))?;
            PairFit::new(wheel, pinion, phases, conditions)
        });
        cells.into_iter().collect()
    }

    /// The matrix of these gears from known `cells`, wheel by wheel.
    ///
    /// # Errors
    /// A number of cells other than wheels times pinions; as [`Matrix::new`].
    pub fn of_cells(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        cells: Vec<PairFit>,
    ) -> Result<Matrix, GearError> {
        GearError::require(
            wheels.len() * pinions.len() == cells.len(),
            "number of cells of a matrix",
            cells.len() as f64,
            "wheels times pinions",
        )?;
        Ok(Matrix {
            wheels: wheels.len(),
            pinions: pinions.len(),
            cells,
            phases: phase_count(wheels, pinions)?,
            thicknesses: [wheels, pinions].map(|gears| {
                let thickness = gears.iter().map(|gear| gear.gear().base_thickness());
                thickness.collect()
            }),
        })
    }

    /// Number of wheels and of pinions.
    pub fn size(&self) -> [usize; 2] {
        [self.wheels, self.pinions]
    }

    /// Number of assembly phases of each pair.
    pub fn phases(&self) -> u32 {
        self.phases
    }

    /// The result of wheel `wheel` with pinion `pinion`, both from 0; `None` without such a gear.
    pub fn pair_fit(&self, wheel: usize, pinion: usize) -> Option<&PairFit> {
        let place = (wheel < self.wheels && pinion < self.pinions)
            .then_some(wheel * self.pinions + pinion)?;
        self.cells.get(place)
    }

    /// Greatest possible number of pairs.
    pub fn most(&self) -> usize {
        self.wheels.min(self.pinions)
    }
}

/// Number of assembly phases of gears with equal numbers of teeth.
///
/// # Errors
/// A gear with another number of teeth than the first of its kind.
fn phase_count(wheels: &[AsBuilt], pinions: &[AsBuilt]) -> Result<u32, GearError> {
    let teeth = |gear: &AsBuilt| gear.gear().basic_data().teeth();
    let counts = [wheels, pinions].map(|gears| gears.first().map_or(1, teeth));
    for (gears, count) in [wheels, pinions].into_iter().zip(counts) {
        for other in gears.iter().map(teeth) {
            let what = "number of teeth of a gear to be matched";
            GearError::require(
                other == count,
                what,
                other.into(),
                "that of the first of its kind",
            )?;
        }
    }
    Ok(SweepPlan::phase_count(counts[0], counts[1]))
}

impl PairFit {
    fn new(
        wheel: &AsBuilt,
        pinion: &AsBuilt,
        phases: u32,
        conditions: &PairConditions,
    ) -> Result<PairFit, Error> {
        let pairs = ends(conditions).map(|distance| {
            GearPair::with_locked(wheel.clone(), pinion.clone(), distance, conditions.locked)?
                .with_face(conditions.face)?
                .with_lean(conditions.lean)
        });
        let pairs = pairs.collect::<Result<Vec<GearPair>, GearError>>()?;
        let mut best: Option<Fit> = None;
        let mut phases_that_meet = 0;
        for pinion_tooth in 1..=phases {
            let fit = Fit::new(&pairs, pinion_tooth, conditions)?;
            phases_that_meet += u32::from(fit.meets);
            let is_better = best.is_none_or(|best| {
                (fit.meets, best.off_in_widths()) > (best.meets, fit.off_in_widths())
            });
            if is_better {
                best = Some(fit);
            }
        }
        // Any two numbers of teeth have at least one phase.
        let best = best.unwrap_or(Fit::NONE);
        Ok(PairFit {
            best,
            phases_that_meet,
        })
    }
}

impl Fit {
    /// Distance from the target in widths of the brackets: nearer values are equal, and so are values above [`FARTHEST`].
    pub(super) fn off_in_widths(&self) -> i64 {
        (self.off.min(FARTHEST) / WIDTH).round() as i64
    }

    const NONE: Fit = Fit {
        pinion_tooth: 1,
        outcome: Outcome {
            kind: OutcomeKind::Unproven,
            least: None,
            greatest: None,
            is_proven: false,
        },
        meets: false,
        off: f64::INFINITY,
    };

    /// The fit of the pair at the least and, if different, at the greatest distance.
    fn new(
        pairs: &[GearPair],
        pinion_tooth: u32,
        conditions: &PairConditions,
    ) -> Result<Fit, Error> {
        let mut found: Option<Outcome> = None;
        let assembly = |pair: &GearPair| Assembly {
            pair: pair.clone().into(),
            clearance: conditions.clearance,
            phase: pinion_tooth,
        };
        for pair in pairs {
            let here = assembly(pair).outcome()?;
            found = Some(match found {
                None => here,
                Some(near) => near.with_far(&here),
            });
        }
        let Some(outcome) = found else {
            return Ok(Fit::NONE);
        };
        let ends = || {
            let [near, _] = assembly(pairs.first()?).ends()?;
            let [_, far] = assembly(pairs.last()?).ends()?;
            Some([near, far])
        };
        let standing = conditions.requirement.standing_of(&outcome, ends);
        let meets = outcome.is_proven && keeps(&outcome, &standing);
        let target = conditions.target_backlash();
        Ok(Fit::of(pinion_tooth, outcome, meets, target))
    }

    /// The fit of an `outcome` in the phase of `pinion_tooth` with the target backlash `wanted`, mm.
    pub fn of(pinion_tooth: u32, outcome: Outcome, meets: bool, wanted: f64) -> Fit {
        let both = outcome.least.zip(outcome.greatest);
        let off = both.map_or(f64::INFINITY, |(least, greatest)| {
            (least - wanted).abs().max((greatest - wanted).abs())
        });
        Fit {
            pinion_tooth,
            outcome,
            meets,
            off,
        }
    }
}

/// The least distance and, if different, the greatest.
fn ends(conditions: &PairConditions) -> impl Iterator<Item = f64> {
    let [near, far] = conditions.center_distances;
    std::iter::once(near).chain((far != near).then_some(far))
}

/// Whether an assembly with this outcome and standing meets the requirement: both extremes exist and lie within it.
fn keeps(outcome: &Outcome, standing: &Standing) -> bool {
    let is_found = outcome.least.is_some() && outcome.greatest.is_some();
    is_found && !standing.below && !standing.above
}

/// Most gears of a kind for an optimal assignment, whose time grows with their cube. With more gears the nearest pairs are taken first.
pub const MOST_EXACT: usize = 1000;

/// An assignment of wheels to pinions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assignment {
    /// Wheel and pinion of each pair that meets the requirement, both from 0, in the order of the wheels.
    pub pairs: Vec<(usize, usize)>,
    /// Whether the assignment is optimal: no other has more pairs, or as many pairs nearer to the target.
    pub is_best: bool,
}

impl Matrix {
    /// The most pairs that meet the requirement and, among those assignments, the least sum of distances from the target.
    pub fn assign(&self) -> Assignment {
        let [wheels, pinions] = self.size();
        let mut pairs = if wheels.max(pinions) <= MOST_EXACT {
            self.best()
        } else {
            self.nearest_first()
        };
        pairs.retain(|(wheel, pinion)| self.meets(*wheel, *pinion));
        pairs.sort_unstable();
        Assignment {
            pairs,
            is_best: wheels.max(pinions) <= MOST_EXACT,
        }
    }

    fn meets(&self, wheel: usize, pinion: usize) -> bool {
        self.pair_fit(wheel, pinion)
            .is_some_and(|fit| fit.best.meets)
    }

    fn off_in_widths(&self, wheel: usize, pinion: usize) -> i64 {
        let fit = self.pair_fit(wheel, pinion);
        fit.map_or(MOST_WIDTHS, |fit| fit.best.off_in_widths())
    }

    /// The optimal assignment: one more pair weighs more than all distances together.
    fn best(&self) -> Vec<(usize, usize)> {
        let [wheels, pinions] = self.size();
        if self.most() == 0 {
            return Vec::new();
        }
        let one = MOST_WIDTHS * (self.most() as i64 + 1);
        let weight = |wheel: usize, pinion: usize| {
            if self.meets(wheel, pinion) {
                one - self.off_in_widths(wheel, pinion)
            } else {
                0
            }
        };
        // Rows are no more than columns.
        if wheels <= pinions {
            let weights = Weights::from_fn(wheels, pinions, |(w, p)| weight(w, p));
            kuhn_munkres(&weights).1.into_iter().enumerate().collect()
        } else {
            let weights = Weights::from_fn(pinions, wheels, |(p, w)| weight(w, p));
            let found = kuhn_munkres(&weights).1.into_iter().enumerate();
            found.map(|(pinion, wheel)| (wheel, pinion)).collect()
        }
    }

    fn nearest_first(&self) -> Vec<(usize, usize)> {
        let [wheels, pinions] = self.size();
        let places = (0..wheels).flat_map(|wheel| (0..pinions).map(move |pinion| (wheel, pinion)));
        let mut places: Vec<(usize, usize)> = places
            .filter(|(wheel, pinion)| self.meets(*wheel, *pinion))
            .collect();
        places
            .sort_by_key(|(wheel, pinion)| (self.off_in_widths(*wheel, *pinion), *wheel, *pinion));
        let mut free = [vec![true; wheels], vec![true; pinions]];
        places.retain(|(wheel, pinion)| {
            let both = free[0][*wheel] && free[1][*pinion];
            if both {
                free[0][*wheel] = false;
                free[1][*pinion] = false;
            }
            both
        });
        places
    }
}

/// Most thickness classes: a shop does not keep more.
pub const MOST_CLASSES: usize = 10;

/// Expected number of pairs that meet the requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Assembled in any phase.
    pub any_phase: f64,
    /// Assembled in the best phase of each pair, with marked teeth.
    pub best_phase: f64,
}

impl Matrix {
    /// Expectation for random pairing.
    pub fn at_random(&self) -> Expected {
        let [wheels, pinions] = self.size();
        let (wheels, pinions) = ((0..wheels).collect(), (0..pinions).collect());
        self.expected(&[(wheels, pinions)])
    }

    /// Expectation for the best number of thickness classes, up to [`MOST_CLASSES`], and that number; `None` without gears.
    ///
    /// The thickest wheels go with the thinnest pinions, at random within a class.
    pub fn by_classes(&self) -> Option<(usize, Expected)> {
        let most = self.most().min(MOST_CLASSES);
        let each = (1..=most).map(|count| (count, self.expected(&self.classes(count))));
        first_least(each.map(|(count, found)| ((count, found), -found.any_phase, 0.0)))
    }

    /// Wheels and pinions of each class.
    fn classes(&self, count: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
        let sorted = |member: usize, sign: f64| {
            let thickness = &self.thicknesses[member];
            let mut order: Vec<usize> = (0..thickness.len()).collect();
            order.sort_by(|a, b| (sign * thickness[*a]).total_cmp(&(sign * thickness[*b])));
            order
        };
        let (wheels, pinions) = (sorted(0, 1.0), sorted(1, -1.0));
        let part = |order: &[usize], class: usize| {
            let border = |class: usize| class * order.len() / count;
            order[border(class)..border(class + 1)].to_vec()
        };
        let each = (0..count).map(|class| (part(&wheels, class), part(&pinions, class)));
        each.collect()
    }

    fn expected(&self, classes: &[(Vec<usize>, Vec<usize>)]) -> Expected {
        let (mut any_phase, mut best_phase) = (0.0, 0.0);
        for (wheels, pinions) in classes {
            let (mut meeting, mut meets) = (0u64, 0u64);
            for &wheel in wheels {
                for found in pinions
                    .iter()
                    .filter_map(|pinion| self.pair_fit(wheel, *pinion))
                {
                    meeting += u64::from(found.phases_that_meet);
                    meets += u64::from(found.best.meets);
                }
            }
            let places = wheels.len() * pinions.len();
            if places == 0 {
                continue;
            }
            // Each pair of a class is equally likely any of its cells.
            let pairs = wheels.len().min(pinions.len()) as f64 / places as f64;
            any_phase += pairs * meeting as f64 / f64::from(self.phases);
            best_phase += pairs * meets as f64;
        }
        Expected {
            any_phase,
            best_phase,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::population::{Outcome, OutcomeKind};
    use proptest::prelude::*;

    /// A matrix of distances from the target, µm; `None`: outside the requirement.
    fn matrix(wheels: usize, pinions: usize, off_um: &[Option<u32>]) -> Matrix {
        let cell = |off: &Option<u32>| PairFit {
            best: Fit {
                pinion_tooth: 1,
                outcome: Outcome {
                    kind: OutcomeKind::Clear,
                    least: Some(0.0),
                    greatest: Some(0.0),
                    is_proven: true,
                },
                meets: off.is_some(),
                off: off.map_or(1.0, |um| 1e-3 * f64::from(um)),
            },
            phases_that_meet: u32::from(off.is_some()),
        };
        Matrix {
            wheels,
            pinions,
            cells: off_um.iter().map(cell).collect(),
            phases: 1,
            thicknesses: [vec![1.0; wheels], vec![1.0; pinions]],
        }
    }

    /// Number of pairs, and less the sum of their distances, of the best assignment of the wheels from `wheel` on to free pinions.
    fn brute(matrix: &Matrix, wheel: usize, free: u32) -> (usize, i64) {
        if wheel == matrix.wheels {
            return (0, 0);
        }
        let meeting = (0..matrix.pinions)
            .filter(|pinion| free & 1 << pinion != 0 && matrix.meets(wheel, *pinion))
            .map(|pinion| {
                let (pairs, off) = brute(matrix, wheel + 1, free & !(1 << pinion));
                (pairs + 1, off - matrix.off_in_widths(wheel, pinion))
            });
        let without = brute(matrix, wheel + 1, free);
        meeting.fold(without, |one, other| one.max(other))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Source: every possible assignment.
        #[test]
        fn no_other_assignment_is_better(
            wheels in 1..7usize,
            pinions in 1..7usize,
            off in prop::collection::vec(prop::option::weighted(0.5, 0..50u32), 36),
        ) {
            let matrix = matrix(wheels, pinions, &off[..wheels * pinions]);
            let found = matrix.assign();
            let sum: i64 = found.pairs.iter().map(|(w, p)| matrix.off_in_widths(*w, *p)).sum();
            prop_assert_eq!((found.pairs.len(), -sum), brute(&matrix, 0, u32::MAX));
            prop_assert!(found.is_best);
        }

        /// The assignment for many gears: each gear once, only pairs that meet the requirement, and no further pair possible.
        #[test]
        fn nearest_first_leaves_no_pair_over(
            off in prop::collection::vec(prop::option::weighted(0.5, 0..50u32), 64),
        ) {
            let matrix = matrix(8, 8, &off);
            let pairs = matrix.nearest_first();
            let own = |member: fn(&(usize, usize)) -> usize| {
                pairs.iter().map(member).collect::<std::collections::BTreeSet<usize>>()
            };
            let (wheels, pinions) = (own(|pair| pair.0), own(|pair| pair.1));
            prop_assert_eq!([wheels.len(), pinions.len()], [pairs.len(); 2]);
            for (wheel, pinion) in (0..8).flat_map(|wheel| (0..8).map(move |pinion| (wheel, pinion))) {
                let is_over = !wheels.contains(&wheel) && !pinions.contains(&pinion);
                let is_pair = pairs.contains(&(wheel, pinion));
                prop_assert!(matrix.meets(wheel, pinion) || !is_pair);
                prop_assert!(!(matrix.meets(wheel, pinion) && is_over));
            }
        }
    }
}
