//! Whether a block's single and cumulative pitch tell the same story.

use super::block::{Block, Name};
use crate::data_file::DataFile;
use crate::problems::Problems;

/// `f_i = F_i − F_{i−1}`, within half a unit of the last printed digit of each of the three, of a block that has
/// every tooth once.
pub fn check(file: &DataFile, block: &Block, problems: &mut Problems) {
    let (Some(mut single), Some(mut cumulative)) =
        (block.column(Name::Single), block.column(Name::Cumulative))
    else {
        return;
    };
    single.sort_by_key(|value| value.1);
    cumulative.sort_by_key(|value| value.1);
    let Some(mut before) = cumulative.last().copied() else {
        return;
    };
    for ((line, tooth, f), now) in single.into_iter().zip(cumulative) {
        let difference = now.2.value - before.2.value;
        let rounding = f.rounding + now.2.rounding + before.2.rounding;
        // Rounding of the subtraction itself: some ulps of the values.
        let slack = 1e-12 * (now.2.value.abs() + before.2.value.abs());
        if (f.value - difference).abs() > rounding + slack {
            problems.add(file.problem_at(
                line,
                format!(
                    "fp of tooth {tooth} is {}, but its Fp minus that of tooth {} is {}: the two columns differ by more than their rounding",
                    file.bare(f.text),
                    before.1,
                    file.bare(&format!("{difference:.4}")),
                ),
                "find the wrong one, or remove the other column from a copy of the protocol",
            ));
        }
        before = now;
    }
}
