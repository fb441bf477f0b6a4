//! What each wheel comes to with each pinion.

use crate::analysis::extremes::WIDTH;
use crate::error::{Error, GearError};
use crate::gear::AsBuilt;
use crate::pair::{GearPair, Member, SweepPlan};
use crate::parallel;
use crate::population::{Assembly, Outcome, OutcomeKind, Requirement, Standing};
use std::ops::ControlFlow;

/// Distances from what is wanted beyond this are not told apart, mm: more than teeth differ.
const FARTHEST: f64 = 100.0;

/// Steps of [`Fit::steps`] at most.
pub(super) const MOST_STEPS: i64 = (FARTHEST / WIDTH) as i64;

/// How gears are put together, and what is asked of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    /// Least and greatest centre distance, mm: the least backlash is looked for at the one, the greatest at the other.
    pub center_distances: [f64; 2],
    /// Radial play of both bearings together, mm.
    pub clearance: f64,
    /// The gear that stands still.
    pub locked: Member,
    /// The common face of helical gears, mm ([`GearPair::with_face`]); of spur gears `[0, 0]`.
    pub face: [f64; 2],
    /// What each pair must keep over its whole mesh cycle.
    pub requirement: Requirement,
    /// The backlash from which that of a pair is to stray least over its mesh cycle, mm; `None`: the middle of what is required, or its one
    /// limit.
    pub target: Option<f64>,
}

impl Terms {
    /// The backlash that is wanted, mm: as stated; else the middle of what is required, of a lower limit alone that limit, of an upper one
    /// alone half of it, and 0 without any.
    pub fn wanted(&self) -> f64 {
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
    /// What comes of it.
    pub outcome: Outcome,
    /// Whether it is within what is required, and proven.
    pub meets: bool,
    /// How far its backlash strays from what is wanted over the mesh cycle, mm; infinite without backlash.
    pub off: f64,
}

/// A wheel and a pinion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairFit {
    /// The phase that is best: one within what is required, if any, the nearest to what is wanted.
    pub best: Fit,
    /// How many assembly phases are within what is required.
    pub meeting: u32,
}

/// Every wheel with every pinion.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    pub(super) wheels: usize,
    pub(super) pinions: usize,
    /// Wheel by wheel.
    pub(super) cells: Vec<PairFit>,
    pub(super) phases: u32,
    /// Mean base tooth thickness of each gear, mm.
    pub(super) thicknesses: [Vec<f64>; 2],
}

impl Matrix {
    /// Every one of `wheels` with every one of `pinions`, all of the same numbers of teeth, in every assembly phase: gcd(z_1, z_2) of them.
    /// `tick` is called for each wheel with each pinion, from any thread; a break ends the work.
    ///
    /// # Errors
    /// [`Error::Interrupted`]; gears that make no pair at one of the distances, or of other numbers of teeth than the first.
    pub fn new(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        terms: &Terms,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Matrix, Error> {
        let cells = Matrix::cells(wheels, pinions, terms, tick)?;
        Ok(Matrix::of_cells(wheels, pinions, cells)?)
    }

    /// The cells of their matrix, wheel by wheel. A cell depends on its own two gears alone.
    ///
    /// # Errors
    /// As [`Matrix::new`].
    pub fn cells(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        terms: &Terms,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Vec<PairFit>, Error> {
        let phases = phase_count(wheels, pinions)?;
        let pairs = |wheel| pinions.iter().map(move |pinion| (wheel, pinion));
        let gears = wheels.iter().flat_map(pairs);
        let cells = parallel::map(gears, |(wheel, pinion)| {
            Error::if_stopped(tick())?;
            PairFit::new(wheel, pinion, phases, terms)
        });
        cells.into_iter().collect()
    }

    /// The matrix of these gears whose `cells`, wheel by wheel, are known.
    ///
    /// # Errors
    /// Another number of cells than wheels times pinions; as [`Matrix::new`].
    pub fn of_cells(
        wheels: &[AsBuilt],
        pinions: &[AsBuilt],
        cells: Vec<PairFit>,
    ) -> Result<Matrix, GearError> {
        if wheels.len() * pinions.len() != cells.len() {
            return Err(GearError::OutOfRange {
                what: "number of cells of a matrix",
                value: cells.len() as f64,
                allowed: "wheels times pinions",
            });
        }
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

    /// Wheels and pinions.
    pub fn size(&self) -> [usize; 2] {
        [self.wheels, self.pinions]
    }

    /// Assembly phases of each pair.
    pub fn phases(&self) -> u32 {
        self.phases
    }

    /// What wheel `wheel` comes to with pinion `pinion`, both from 0; `None` where there is no such gear.
    pub fn pair_fit(&self, wheel: usize, pinion: usize) -> Option<&PairFit> {
        let place = (wheel < self.wheels && pinion < self.pinions)
            .then_some(wheel * self.pinions + pinion)?;
        self.cells.get(place)
    }

    /// Pairs that can be made at most.
    pub fn most(&self) -> usize {
        self.wheels.min(self.pinions)
    }
}

/// Assembly phases of gears that all have the numbers of teeth of the first.
///
/// # Errors
/// A gear of another number of teeth.
fn phase_count(wheels: &[AsBuilt], pinions: &[AsBuilt]) -> Result<u32, GearError> {
    let teeth = |gear: &AsBuilt| gear.gear().basic_data().teeth();
    let counts = [wheels, pinions].map(|gears| gears.first().map_or(1, teeth));
    for (gears, count) in [wheels, pinions].into_iter().zip(counts) {
        if let Some(other) = gears.iter().map(teeth).find(|other| *other != count) {
            return Err(GearError::OutOfRange {
                what: "number of teeth of a gear to be matched",
                value: other.into(),
                allowed: "that of the first of its kind",
            });
        }
    }
    Ok(SweepPlan::phase_count(counts[0], counts[1]))
}

impl PairFit {
    fn new(
        wheel: &AsBuilt,
        pinion: &AsBuilt,
        phases: u32,
        terms: &Terms,
    ) -> Result<PairFit, Error> {
        let pairs = ends(terms).map(|distance| {
            GearPair::with_locked(wheel.clone(), pinion.clone(), distance, terms.locked)?
                .with_face(terms.face)
        });
        let pairs = pairs.collect::<Result<Vec<GearPair>, GearError>>()?;
        let mut best: Option<Fit> = None;
        let mut meeting = 0;
        for pinion_tooth in 1..=phases {
            let fit = Fit::new(&pairs, pinion_tooth, terms)?;
            meeting += u32::from(fit.meets);
            let is_better =
                best.is_none_or(|best| (fit.meets, best.steps()) > (best.meets, fit.steps()));
            if is_better {
                best = Some(fit);
            }
        }
        // Any two numbers of teeth have one phase at least.
        let best = best.unwrap_or(Fit::NONE);
        Ok(PairFit { best, meeting })
    }
}

impl Fit {
    /// How far its backlash strays from what is wanted, in widths of the brackets: what is nearer is alike. Those above [`FARTHEST`] are, too.
    pub(super) fn steps(&self) -> i64 {
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

    /// Of the pair at the least and, where it is another, at the greatest distance.
    fn new(pairs: &[GearPair], pinion_tooth: u32, terms: &Terms) -> Result<Fit, Error> {
        let mut found: Option<Outcome> = None;
        let assembly = |pair: &GearPair| Assembly::new(pair.clone(), terms.clearance, pinion_tooth);
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
        let standing = terms.requirement.standing_of(&outcome, ends);
        let meets = outcome.is_proven && keeps(&outcome, &standing);
        Ok(Fit::of(pinion_tooth, outcome, meets, terms.wanted()))
    }

    /// What `outcome` comes to in the phase of `pinion_tooth` where the backlash `wanted`, mm, is wanted.
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

/// The least distance and, where it is another, the greatest.
fn ends(terms: &Terms) -> impl Iterator<Item = f64> {
    let [near, far] = terms.center_distances;
    std::iter::once(near).chain((far != near).then_some(far))
}

/// Whether an assembly that has both extremes, as `outcome` says, and stands so keeps the requirement.
fn keeps(outcome: &Outcome, standing: &Standing) -> bool {
    let is_found = outcome.least.is_some() && outcome.greatest.is_some();
    is_found && !standing.below && !standing.above
}
