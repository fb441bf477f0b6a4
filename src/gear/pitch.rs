//! Pitch deviation of both flanks as cumulative curves.
//!
//! A pitch curve is cumulative (index deviation `F`), in mm at the reference circle, positive along ascending tooth numbers, about
//! its own mean. `right` and `left` are the gear's *own* flanks.

use super::Flank;
use crate::numeric::{mean, range};

/// The axis about which pitch is measured.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum PitchAxis {
    // The values hold no eccentricity.
    /// The gear's own.
    #[default]
    Own,
    // The values hold the eccentricity.
    /// The rotation axis.
    Datum,
}

impl PitchAxis {
    /// `own` or `datum`, as in a pair file.
    pub fn name(self) -> &'static str {
        match self {
            PitchAxis::Own => "own",
            PitchAxis::Datum => "datum",
        }
    }
}

/// Cumulative pitch deviation `F` of a gear's own right and left flanks, mm, each about its mean.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pitch {
    right: Vec<f64>,
    left: Vec<f64>,
}

impl Pitch {
    /// The curves of cumulative values `F_i`, mm, along ascending numbers.
    pub fn from_cumulative(right: &[f64], left: &[f64]) -> Pitch {
        Pitch {
            right: about_mean(right.to_vec()),
            left: about_mean(left.to_vec()),
        }
    }

    /// The curves of single values `f_i = F_i − F_{i−1}`, mm, along ascending numbers.
    ///
    /// Single pitch deviations count from the mean pitch, so the values of a flank sum to zero. A remainder from rounding is
    /// distributed evenly.
    pub fn from_single(right: &[f64], left: &[f64]) -> Pitch {
        let cumulate = |single: &[f64]| {
            let mean = mean(single);
            let sums = single.iter().scan(0.0, |sum, f| {
                *sum += f - mean;
                Some(*sum)
            });
            about_mean(sums.collect())
        };
        Pitch {
            right: cumulate(right),
            left: cumulate(left),
        }
    }

    /// These data read as `+ = plus material` on both flanks.
    ///
    /// On the reference face, numbers ascend clockwise, and the right flank is on the clockwise side. Plus material is positive along
    /// ascending numbers on right flanks and negative on left flanks.
    pub fn read_as_material(mut self) -> Pitch {
        for value in &mut self.left {
            *value = -*value;
        }
        self
    }

    /// These data with right and left flanks exchanged.
    #[must_use]
    pub fn exchanged(self) -> Pitch {
        Pitch {
            right: self.left,
            left: self.right,
        }
    }

    /// `F` of every tooth's own `side` flank, mm.
    pub fn flank(&self, side: Flank) -> &[f64] {
        match side {
            Flank::Right => &self.right,
            Flank::Left => &self.left,
        }
    }

    /// `f_i = F_i − F_{i−1}` of every tooth's own `side` flank, mm; tooth 1 counts from the last tooth.
    pub fn single(&self, side: Flank) -> Vec<f64> {
        let cumulative = self.flank(side);
        let before = cumulative.last().into_iter().chain(cumulative);
        cumulative.iter().zip(before).map(|(f, b)| f - b).collect()
    }

    /// Greatest single deviation `f_p` of a flank, mm, by amount.
    pub fn greatest_single(&self, side: Flank) -> f64 {
        let amounts = self.single(side).into_iter().map(f64::abs);
        amounts.fold(0.0, f64::max)
    }

    /// Greatest difference `f_u` of two single deviations of a flank one after the other, mm.
    pub fn adjacent_difference(&self, side: Flank) -> f64 {
        greatest_change(&self.single(side), 1)
    }

    /// Greatest cumulative deviation of a flank over an eighth of the teeth, `F_p(z/8)`, mm, over the nearest whole number of pitches.
    pub fn eighth(&self, side: Flank) -> f64 {
        let curve = self.flank(side);
        greatest_change(curve, usize::max(1, (curve.len() + 4) / 8))
    }

    /// Range `R_p` of the single deviations of a flank, mm.
    pub fn single_range(&self, side: Flank) -> f64 {
        range(self.single(side))
    }

    /// Total cumulative deviation `F_p` of a flank, mm: the range of `F`.
    pub fn total(&self, side: Flank) -> f64 {
        range(self.flank(side))
    }

    /// Thickness of each tooth from its two flanks, mm at the reference circle, about the mean: `Δs_i = F_R,i − F_L,i` (design
    /// section 6).
    pub fn thickness(&self) -> Vec<f64> {
        let flanks = self.right.iter().zip(&self.left);
        flanks.map(|(right, left)| right - left).collect()
    }
}

/// Greatest difference of a value and that `steps` teeth later.
fn greatest_change(values: &[f64], steps: usize) -> f64 {
    let later = values.iter().cycle().skip(steps);
    let changes = values.iter().zip(later).map(|(f, later)| (later - f).abs());
    changes.fold(0.0, f64::max)
}

fn about_mean(mut values: Vec<f64>) -> Vec<f64> {
    let mean = mean(&values);
    for value in &mut values {
        *value -= mean;
    }
    values
}
