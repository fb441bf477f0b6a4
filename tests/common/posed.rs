//! One pose of a pair file.

use crate::kit::{pair_of, study};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating};
use std::path::Path;

/// The first pose at `flank` of a pair file that has one centre distance and one thickness.
pub fn pose(path: impl AsRef<Path>, flank: Side) -> (GearPair, Mating) {
    let study = study(path);
    let pair = pair_of(&study);
    let matings = study.sweep.unwrap().matings(&pair);
    let mating = matings.into_iter().find(|mating| mating.flank == flank);
    (pair, mating.unwrap())
}
