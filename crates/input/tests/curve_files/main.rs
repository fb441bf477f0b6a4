//! Curve files `.mka` and value files `.mew` of a P40. No real one is public: these are MADE, by the small writer of [`made`].

mod made;
mod mutants;

use crate::mutant;
use made::Made;
use std::fs;

/// The example beside the other sheets is what the writer makes.
#[test]
fn the_fixture() {
    let path = "../../fixtures/sheets/curves.mka";
    assert_eq!(fs::read_to_string(path).unwrap(), Made::new(9).text());
}
