//! One pose of a pair file.

use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating};
use gearlash_files as input;
use std::path::Path;

/// The first pose at `flank` of a pair file that has one centre distance and one thickness.
pub fn pose(path: &Path, flank: Side) -> (GearPair, Mating) {
    let study = input::read(path).unwrap().study;
    let (_, wheel, pinion) = &study.materials[0];
    let assembly = study
        .pair(wheel, pinion, study.center_distances[0])
        .unwrap();
    let matings = study.sweep.unwrap().matings(&assembly);
    let mating = matings.into_iter().find(|mating| mating.flank == flank);
    (assembly, mating.unwrap())
}

/// The pair and mating of a file of fixtures/grazing.
pub fn grazing(name: &str, flank: Side) -> (GearPair, Mating) {
    pose(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("fixtures/grazing/{name}.toml")),
        flank,
    )
}
