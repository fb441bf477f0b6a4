//! The result of a matching, and its sentence.

use super::read::MatchFile;
use crate::tolerance::{Limit, limits};
use gearlash::error::GearError;
use gearlash::matching::{Expected, Fit, Matrix, PairFit};
use gearlash_text::numbers::{fixed, rounded, shortest};

/// A pair of a matching.
#[derive(Debug, Clone, PartialEq)]
pub struct MatchedPair {
    /// Name of the wheel.
    pub wheel: String,
    /// Name of the pinion.
    pub pinion: String,
    /// Its best phase: wheel tooth 1 meets this pinion tooth, right flanks.
    pub fit: Fit,
}

/// The result of a matching.
#[derive(Debug, Clone)]
pub struct MatchResult {
    /// Title of the pair file.
    pub title: String,
    /// Names of the wheels and of the pinions, in the matrix' order.
    pub names: [Vec<String>; 2],
    /// Every wheel with every pinion.
    pub matrix: Matrix,
    /// The pairs, in the order of the wheels.
    pub pairs: Vec<MatchedPair>,
    /// The pairs by their places in the matrix.
    pub places: Vec<(usize, usize)>,
    /// Whether no other assignment is better.
    pub is_best: bool,
    /// Names of the unpaired wheels and pinions.
    pub left_over: [Vec<String>; 2],
    /// The expectation for random pairing.
    pub at_random: Expected,
    /// The best number of thickness classes, and the expectation for them.
    pub by_classes: Option<(usize, Expected)>,
    /// Least and greatest backlash allowed, and the wanted one, mm.
    pub limits: [Option<f64>; 2],
    /// Limits of other quantities.
    pub others: Vec<Limit>,
    /// Target backlash, mm.
    pub wanted: f64,
    /// Radial play of both bearings together, mm, which least and greatest include.
    pub clearance: f64,
}

impl MatchResult {
    /// The assignment of the gears of `file`; `cells` is their matrix, wheel by wheel.
    ///
    /// # Errors
    /// Another number of cells than wheels times pinions.
    pub fn new(file: &MatchFile, cells: Vec<PairFit>) -> Result<MatchResult, GearError> {
        let (wheels, pinions) = file.gears();
        let matrix = Matrix::of_cells(&wheels, &pinions, cells)?;
        let names = [&file.wheels, &file.pinions].map(|gears| {
            gears
                .iter()
                .map(|gear| gear.name.clone())
                .collect::<Vec<_>>()
        });
        let requirement = file.requirement();
        let assignment = matrix.assign();
        let pairs = assignment.pairs.iter().filter_map(|&(wheel, pinion)| {
            Some(MatchedPair {
                wheel: names[0].get(wheel)?.clone(),
                pinion: names[1].get(pinion)?.clone(),
                fit: matrix.pair_fit(wheel, pinion)?.best,
            })
        });
        let pairs = pairs.collect();
        let (wheels, pinions): (Vec<usize>, Vec<usize>) = assignment.pairs.iter().copied().unzip();
        let taken = [wheels, pinions];
        let left_over = [0, 1].map(|kind| {
            let each = names[kind].iter().enumerate();
            let left = each.filter(|(place, _)| !taken[kind].contains(place));
            left.map(|(_, name)| name.clone()).collect()
        });
        Ok(MatchResult {
            title: file.pair.study.title.clone(),
            at_random: matrix.at_random(),
            by_classes: matrix.by_classes(),
            limits: [requirement.min(), requirement.max()],
            others: limits(requirement),
            wanted: file.conditions.target_backlash(),
            clearance: file.conditions.clearance,
            is_best: assignment.is_best,
            places: assignment.pairs,
            names,
            pairs,
            left_over,
            matrix,
        })
    }

    /// Whether every gear that could have a mate is paired.
    pub fn is_complete(&self) -> bool {
        self.pairs.len() == self.matrix.most()
    }

    /// "198 of 200 pairs keep 40 µm or more; to be expected 171.3 at random, 183.0 with 6 thickness classes, thickest wheels to thinnest pinions"
    pub fn sentence(&self) -> String {
        let um = |mm: f64| shortest(rounded(1e3 * mm, 6));
        let limits = match self.limits {
            [Some(min), Some(max)] => format!("keep {} … {} µm", um(min), um(max)),
            [Some(min), None] => format!("keep {} µm or more", um(min)),
            [None, Some(max)] => format!("assemble with {} µm or less", um(max)),
            [None, None] if self.others.is_empty() => "assemble".to_owned(),
            [None, None] => String::new(),
        };
        let others = self.others.iter().map(|limit| {
            let (quantity, unit) = (&limit.quantity, &limit.unit);
            match [limit.min, limit.max].map(|end| end.map(shortest)) {
                [Some(min), Some(max)] => format!("keep {quantity} {min} … {max} {unit}"),
                [Some(min), None] => format!("keep {quantity} {min} {unit} or more"),
                [_, max] => format!("keep {quantity} {} {unit} or less", max.unwrap_or_default()),
            }
        });
        let own = Some(limits).filter(|own| !own.is_empty());
        let limits: Vec<String> = own.into_iter().chain(others).collect();
        let limits = limits.join(", ");
        let mut text = format!(
            "{} of {} pairs {limits}; to be expected {} at random",
            self.pairs.len(),
            self.matrix.most(),
            fixed(self.at_random.any_phase, 1)
        );
        if let Some((count, classes)) = self.by_classes.filter(|(count, _)| *count > 1) {
            text += &format!(
                ", {} with {count} thickness classes, thickest wheels to thinnest pinions",
                fixed(classes.any_phase, 1)
            );
        }
        if !self.is_best {
            text += "; nearest pairs first, so that another assignment may be better";
        }
        text
    }
}
