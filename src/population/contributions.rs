//! What each scatter contributes to the variance of the least and of the greatest backlash.
//!
//! Sobol's indices of independent quantities `x_1 … x_k`: of the variance `V` of `f`, the share that the mean of `f` at a given `x_i`
//! has (first order: by `x_i` alone), and the share that is left on average where all but `x_i` are given (total: with all that it does
//! together with others). Two independent samples `A` and `B` of all quantities and, for each `i`, the sample `AB_i` which is `A`
//! but for `x_i`, taken from `B`, give both (Saltelli et al. 2010):
//!
//! ```text
//! V_i  = E[f(B) (f(AB_i) − f(A))]       B and AB_i share x_i alone: E[f(B) f(AB_i)] = E²[f] + V_i; B and A nothing: E[f(B) f(A)] = E²[f]
//! V_Ti = E[(f(A) − f(AB_i))²]/2         they share all but x_i: half the mean square difference of two with the same rest is its variance
//! ```
//!
//! `f(B)` is taken about the mean of all, which changes no expectation of the first and makes it scatter less. The standard errors are
//! those of the jackknife over [`GROUPS`] groups of rows. All sums are of integers, and add up whichever way the rows are cut.

use super::factor::Factor;
use super::members::Population;
use super::sample::{SampleError, in_chunks};
use super::spread::{Overflow, TENTHS_NM_PER_MM, tenths};
use super::stream::{Draw, Run};
use crate::error::Error;
use crate::parallel;
use std::ops::{ControlFlow, Range};

/// Groups of rows that the standard errors come from: row `j` is of group `j` modulo so many.
pub const GROUPS: usize = 32;

/// Rows that one core takes at a time.
const CHUNK: u64 = 8;

/// Sums over the rows of a group, of one extreme in tenths of a nanometre.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct GroupSums {
    /// Rows of which every assembly has the extreme.
    pub rows: u64,
    /// Rows without.
    pub left_out: u64,
    /// `Σ f(A)`, `Σ f(B)`, `Σ f(A)²`, `Σ f(B)²`, `Σ f(A) f(B)`.
    pub samples: [i128; 5],
    /// `Σ f(AB_i)`, `Σ f(AB_i)²`, `Σ f(B) f(AB_i)`, `Σ f(A) f(AB_i)` of each quantity.
    pub factors: Vec<[i128; 4]>,
}

/// Sums over rows of the samples, which add up to those over all.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ContributionSums {
    /// Of the least `j_wt`, group by group.
    pub least: Vec<GroupSums>,
    /// Of the greatest.
    pub greatest: Vec<GroupSums>,
}

/// A number with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// What one quantity contributes to the variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contribution {
    /// Which.
    pub factor: Factor,
    /// By itself.
    pub first: Estimate,
    /// With all that it does together with others.
    pub total: Estimate,
}

/// The contributions to one extreme.
#[derive(Debug, Clone, PartialEq)]
pub struct Contributions {
    /// Rows they come from.
    pub rows: u64,
    /// Rows left out, an assembly of which has no such extreme.
    pub left_out: u64,
    /// In the order of [`Population::factors`]; empty where nothing varies or too few rows are left.
    pub each: Vec<Contribution>,
}

impl ContributionSums {
    /// Over no rows, of so many quantities.
    pub fn new(factors: usize) -> ContributionSums {
        let group = GroupSums {
            factors: vec![[0; 4]; factors],
            ..GroupSums::default()
        };
        ContributionSums {
            least: vec![group.clone(); GROUPS],
            greatest: vec![group; GROUPS],
        }
    }

    /// Adds the sums over other rows.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, other: &ContributionSums) -> Result<(), Overflow> {
        let groups = self.least.iter_mut().chain(&mut self.greatest);
        for (group, other) in groups.zip(other.least.iter().chain(&other.greatest)) {
            group.add(other)?;
        }
        Ok(())
    }

    /// What they say of the least and of the greatest `j_wt`.
    pub fn contributions(&self, factors: &[Factor]) -> [Contributions; 2] {
        [&self.least, &self.greatest].map(|groups| Contributions::of(groups, factors))
    }
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
        self.left_out += other.left_out;
        for (sum, other) in self.beside(other) {
            *sum = sum.checked_add(*other).ok_or(Overflow)?;
        }
        Ok(())
    }

    /// Adds a row: `f` of A, of B and of each `AB_i`.
    fn count(&mut self, row: Option<(i64, i64, Vec<i64>)>) -> Result<(), Overflow> {
        let Some((a, b, mixed)) = row else {
            self.left_out += 1;
            return Ok(());
        };
        // No product of two i64 is beyond i128.
        let times = |one: i64, other: i64| i128::from(one) * i128::from(other);
        let each = mixed
            .iter()
            .map(|&ab| [i128::from(ab), times(ab, ab), times(b, ab), times(a, ab)]);
        self.add(&GroupSums {
            rows: 1,
            left_out: 0,
            samples: [a.into(), b.into(), times(a, a), times(b, b), times(a, b)],
            factors: each.collect(),
        })
    }

    /// `None` where the rest does not fit.
    fn without(&self, other: &GroupSums) -> Option<GroupSums> {
        let mut rest = self.clone();
        rest.rows -= other.rows;
        for (sum, other) in rest.beside(other) {
            *sum = sum.checked_sub(*other)?;
        }
        Some(rest)
    }

    /// First-order and total share of each quantity; `None` where nothing varies, or sums do not fit.
    fn indices(&self) -> Option<Vec<[f64; 2]>> {
        let n = self.rows as f64;
        let [a, b, aa, bb, ab] = self.samples;
        let mean = a.checked_add(b)? as f64 / (2.0 * n);
        let variance = aa.checked_add(bb)? as f64 / (2.0 * n) - mean * mean;
        // Of lengths in tenths of a nanometre rounding alone leaves 1/12.
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
        // Each group fitted, and all of them did when they were added; else nothing is said.
        let fits = groups.iter().all(|group| all.add(group).is_ok());
        let none = Contributions {
            rows: all.rows,
            left_out: all.left_out,
            each: Vec::new(),
        };
        let filled = groups.iter().all(|group| group.rows > 0);
        let rest = groups.iter().map(|group| all.without(group)?.indices());
        let rest: Option<Vec<Vec<[f64; 2]>>> = match fits && filled {
            true => rest.collect(),
            false => None,
        };
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

/// Least and greatest of an assembly.
type Both = [Option<f64>; 2];

/// `f` of A, of B, and of each AB_i.
fn row<T>(
    factors: &[Factor],
    of: impl Fn(&dyn Fn(Factor) -> Run) -> Result<T, Error>,
) -> Result<(T, T, Vec<T>), Error> {
    let mixed = factors.iter().map(|&one| {
        of(&|factor| match factor == one {
            true => Run::Second,
            false => Run::First,
        })
    });
    Ok((
        of(&|_| Run::First)?,
        of(&|_| Run::Second)?,
        mixed.collect::<Result<_, Error>>()?,
    ))
}

/// Adds one row to both extremes' groups.
fn count(
    sums: &mut ContributionSums,
    number: u64,
    (a, b, mixed): &(Both, Both, Vec<Both>),
) -> Result<(), Overflow> {
    let group = (number % GROUPS as u64) as usize;
    for (end, groups) in [&mut sums.least, &mut sums.greatest]
        .into_iter()
        .enumerate()
    {
        let length = |both: &Both| both[end].map(tenths);
        let mixed: Option<Vec<i64>> = mixed.iter().map(length).collect();
        let row = length(a).zip(length(b)).zip(mixed);
        groups[group].count(row.map(|((a, b), mixed)| (a, b, mixed)))?;
    }
    Ok(())
}

/// The sums over the rows `numbers`, from 1, of both samples with `seed`: two assemblies a row and one for each quantity. `tick` as in
/// [`super::sample()`].
///
/// # Errors
/// As [`super::sample()`].
pub fn contribution_sums(
    population: &Population,
    seed: u64,
    numbers: Range<u64>,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<ContributionSums, SampleError> {
    let factors = population.factors();
    let both = |number: u64, run: &dyn Fn(Factor) -> Run| {
        let draw = |factor| Draw {
            seed,
            run: run(factor),
            number,
        };
        match population.assembled(&draw) {
            Ok(assembly) => assembly
                .outcome()
                .map(|found| [found.least, found.greatest]),
            Err(_) => Ok([None; 2]),
        }
    };
    let chunks = parallel::map(
        in_chunks(&numbers, CHUNK),
        |chunk| -> Result<_, SampleError> {
            Error::if_stopped(tick())?;
            let mut sums = ContributionSums::new(factors.len());
            for number in chunk {
                let row = row(factors, |run| both(number, run))?;
                count(&mut sums, number, &row)?;
            }
            Ok(sums)
        },
    );
    let mut sums = ContributionSums::new(factors.len());
    for chunk in chunks {
        sums.add(&chunk?)?;
    }
    Ok(sums)
}

impl Estimate {
    /// Whether `value` lies within so many standard errors, and the rounding of lengths, of it.
    pub fn admits(&self, value: f64, errors: f64) -> bool {
        (self.value - value).abs() <= errors * self.error + 1.0 / TENTHS_NM_PER_MM
    }
}
