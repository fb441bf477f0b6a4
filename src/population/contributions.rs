//! The contribution of each scatter to the variance of the least and of the greatest backlash.
//!
//! Sobol's indices of independent quantities `x_1 … x_k` are shares of the variance `V` of `f`. The first-order index is the share of the
//! mean of `f` at a given `x_i`: the effect of `x_i` alone. The total index is the share that is left on average with all but `x_i` given:
//! the effect including interactions. Both come from two independent samples `A` and `B` of all quantities, and one sample `AB_i` for
//! each `i`. `AB_i` is `A` except for `x_i` from `B` (Saltelli et al. 2010):
//!
//! ```text
//! V_i  = E[f(B) (f(AB_i) − f(A))]       B and AB_i share x_i alone: E[f(B) f(AB_i)] = E²[f] + V_i; B and A nothing: E[f(B) f(A)] = E²[f]
//! V_Ti = E[(f(A) − f(AB_i))²]/2         they share all but x_i: half the mean square difference of two with the same rest is its variance
//! ```
//!
//! `f(B)` is taken about the mean of all, which keeps the expectation of `V_i` and reduces its scatter. The standard errors are those of
//! the jackknife over [`JACKKNIFE_GROUPS`] groups of rows. All sums are integers, so they do not depend on the order of the rows.

use super::factor::Factor;
use super::members::Population;
use super::sample::chunks;
use super::spread::{Overflow, tenths};
use super::stream::{Draw, SampleKind};
use crate::error::{Error, Tick};
use crate::parallel;

/// Number of groups of rows for the standard errors: row `j` belongs to group `j` modulo this.
pub const JACKKNIFE_GROUPS: usize = 32;

/// Rows per core and tick.
pub const ROWS_PER_TICK: u64 = 8;

/// Rows in memory at a time (tuned: enough for many threads, about 100 kB).
const BLOCK: u64 = 1024;

/// The reason why there are no contributions.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ContributionsError {
    /// A calculation failed, or was interrupted.
    #[error(transparent)]
    Error(#[from] Error),
    /// The sums are too large.
    #[error(transparent)]
    Overflow(#[from] Overflow),
}

/// Sums over the rows of a group, for one extreme, in tenths of a nanometre.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct GroupSums {
    /// Rows in which every assembly has the extreme.
    rows: u64,
    /// Other rows.
    unused_rows: u64,
    /// `Σ f(A)`, `Σ f(B)`, `Σ f(A)²`, `Σ f(B)²`, `Σ f(A) f(B)`.
    samples: [i128; 5],
    /// `Σ f(AB_i)`, `Σ f(AB_i)²`, `Σ f(B) f(AB_i)`, `Σ f(A) f(AB_i)` of each quantity.
    factors: Vec<[i128; 4]>,
}

/// A number with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// The contribution of one quantity to the variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contribution {
    /// The quantity.
    pub factor: Factor,
    /// First-order effect.
    pub first: Estimate,
    /// Total effect, with interactions.
    pub total: Estimate,
}

/// The contributions to one extreme.
#[derive(Debug, Clone, PartialEq)]
pub struct Contributions {
    /// Rows used.
    pub rows: u64,
    /// Rows not used, because an assembly has no such extreme.
    pub unused_rows: u64,
    /// In the order of [`Population::factors`]; empty if nothing varies or too few rows are left.
    pub each: Vec<Contribution>,
}

impl GroupSums {
    /// Each sum with that of `other`.
    fn beside<'a>(
        &'a mut self,
        other: &'a GroupSums,
    ) -> impl Iterator<Item = (&'a mut i128, &'a i128)> {
        let own = self.samples.iter_mut();
        let own = own.chain(self.factors.iter_mut().flatten());
        own.zip(other.samples.iter().chain(other.factors.iter().flatten()))
    }

    fn add(&mut self, other: &GroupSums) -> Result<(), Overflow> {
        self.rows += other.rows;
        self.unused_rows += other.unused_rows;
        for (sum, other) in self.beside(other) {
            *sum = sum.checked_add(*other).ok_or(Overflow)?;
        }
        Ok(())
    }

    /// Adds a row: `f` of A, of B and of each `AB_i`; `None` if an assembly lacks the extreme.
    fn add_row(&mut self, row: Option<Vec<i64>>) -> Result<(), Overflow> {
        let Some(&[a, b, ref mixed @ ..]) = row.as_deref() else {
            self.unused_rows += 1;
            return Ok(());
        };
        // No product of two i64 exceeds i128.
        let times = |one: i64, other: i64| i128::from(one) * i128::from(other);
        let each = mixed
            .iter()
            .map(|&ab| [i128::from(ab), times(ab, ab), times(b, ab), times(a, ab)]);
        self.add(&GroupSums {
            rows: 1,
            unused_rows: 0,
            samples: [a.into(), b.into(), times(a, a), times(b, b), times(a, b)],
            factors: each.collect(),
        })
    }

    /// `None` on overflow.
    fn without(&self, other: &GroupSums) -> Option<GroupSums> {
        let mut rest = self.clone();
        rest.rows -= other.rows;
        for (sum, other) in rest.beside(other) {
            *sum = sum.checked_sub(*other)?;
        }
        Some(rest)
    }

    /// First-order and total share of each quantity; `None` if nothing varies, or on overflow.
    fn indices(&self) -> Option<Vec<[f64; 2]>> {
        let n = self.rows as f64;
        let [a, b, aa, bb, ab] = self.samples;
        let mean = a.checked_add(b)? as f64 / (2.0 * n);
        let variance = aa.checked_add(bb)? as f64 / (2.0 * n) - mean * mean;
        // Rounding to tenths of a nanometre alone leaves 1/12.
        if !(variance > 1.0) {
            return None;
        }
        let each = self
            .factors
            .iter()
            .map(|&[mixed, mixed_2, b_mixed, a_mixed]| {
                let (products, moved) = (b_mixed.checked_sub(ab)?, mixed.checked_sub(a)?);
                let squares = aa.checked_sub(a_mixed.checked_mul(2)?)?;
                let first = products as f64 / n - mean * moved as f64 / n;
                let total = squares.checked_add(mixed_2)? as f64 / (2.0 * n);
                Some([first / variance, total / variance])
            });
        each.collect()
    }
}

impl Contributions {
    fn of(groups: &[GroupSums], factors: &[Factor]) -> Contributions {
        let mut all = GroupSums {
            factors: vec![[0; 4]; factors.len()],
            ..GroupSums::default()
        };
        // The groups were summed without overflow before; otherwise there is no result.
        let fits = groups.iter().all(|group| all.add(group).is_ok());
        let none = Contributions {
            rows: all.rows,
            unused_rows: all.unused_rows,
            each: Vec::new(),
        };
        let filled = groups.iter().all(|group| group.rows > 0);
        let rest = groups.iter().map(|group| all.without(group)?.indices());
        let rest: Option<Vec<Vec<[f64; 2]>>> = if fits && filled { rest.collect() } else { None };
        let Some((indices, rest)) = all.indices().zip(rest) else {
            return none;
        };
        let count = rest.len() as f64;
        // Jackknife: (m − 1)/m Σ (θ_(g) − mean)², θ_(g) without group g.
        let estimate = |factor: usize, order: usize| {
            let each = || rest.iter().map(|indices| indices[factor][order]);
            let mean = each().sum::<f64>() / count;
            let squares: f64 = each().map(|index| (index - mean).powi(2)).sum();
            Estimate {
                value: indices[factor][order],
                error: (squares * (count - 1.0) / count).sqrt(),
            }
        };
        let each = factors
            .iter()
            .enumerate()
            .map(|(index, &factor)| Contribution {
                factor,
                first: estimate(index, 0),
                total: estimate(index, 1),
            });
        Contributions {
            each: each.collect(),
            ..none
        }
    }
}

/// Least and greatest `j_wt` of an assembly, tenths of a nanometre.
type LeastAndGreatest = [Option<i64>; 2];

/// `f` of A, of B, and of each AB_i in row `number` of both samples.
fn evaluate(
    population: &Population,
    seed: u64,
    number: u64,
) -> Result<Vec<LeastAndGreatest>, Error> {
    let of = |sample: &dyn Fn(Factor) -> SampleKind| -> Result<LeastAndGreatest, Error> {
        let draw = |factor| Draw {
            seed,
            sample: sample(factor),
            number,
        };
        match population.assembled(&draw) {
            Ok(assembly) => {
                let found = assembly.outcome()?;
                Ok([found.least, found.greatest].map(|mm| mm.map(tenths)))
            }
            Err(_) => Ok([None; 2]),
        }
    };
    let mixed = population.factors().iter().map(|&one| {
        of(&|factor| {
            if factor == one {
                SampleKind::Second
            } else {
                SampleKind::First
            }
        })
    });
    let whole = [of(&|_| SampleKind::First), of(&|_| SampleKind::Second)];
    whole.into_iter().chain(mixed).collect()
}

/// The contributions to the least and to the greatest `j_wt`, from the first `rows` of both samples with `seed`. A row has two assemblies
/// and one for each quantity. `tick` is called once every [`ROWS_PER_TICK`] rows, from any thread; a break ends the work.
///
/// # Errors
/// [`ContributionsError`].
pub fn contributions(
    population: &Population,
    seed: u64,
    rows: u64,
    tick: &Tick,
) -> Result<[Contributions; 2], ContributionsError> {
    let factors = population.factors();
    let group = GroupSums {
        factors: vec![[0; 4]; factors.len()],
        ..GroupSums::default()
    };
    let mut sums = [(); 2].map(|()| vec![group.clone(); JACKKNIFE_GROUPS]);
    for block in chunks(&(1..rows + 1), BLOCK) {
        let evaluated = parallel::map(chunks(&block, ROWS_PER_TICK), |chunk| {
            Error::if_stopped(tick(1))?;
            let rows = chunk.map(|number| evaluate(population, seed, number));
            rows.collect::<Result<Vec<_>, Error>>()
        });
        let evaluated = evaluated.into_iter().collect::<Result<Vec<_>, Error>>()?;
        for (number, row) in block.zip(evaluated.iter().flatten()) {
            for (end, groups) in sums.iter_mut().enumerate() {
                let values = row.iter().map(|both| both[end]).collect();
                groups[(number % JACKKNIFE_GROUPS as u64) as usize].add_row(values)?;
            }
        }
    }
    Ok(sums.map(|groups| Contributions::of(&groups, factors)))
}
