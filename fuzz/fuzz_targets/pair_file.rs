//! The text of a pair file, TOML or JSON: problems, or a study with first poses on which both methods agree.
#![no_main]

use gearlash::pair::GearPair;
use gearlash_fuzz::folder::Folder;
use gearlash_fuzz::pose::agree;
use libfuzzer_sys::{Corpus, fuzz_target};

/// Greatest number of planned poses; a larger plan is skipped.
const MOST_PLANNED: u64 = 20_000;
/// Poses that are run.
const MOST_RUN: usize = 2;

/// Files named by the pair files of fixtures/.
const TABLES: [(&str, &[u8]); 7] = [
    (
        "karba_tables_5_6.csv",
        include_bytes!("../../fixtures/karba_tables_5_6.csv"),
    ),
    (
        "pitch.csv",
        include_bytes!("../../fixtures/sheets/pitch.csv"),
    ),
    (
        "pitch_german.csv",
        include_bytes!("../../fixtures/sheets/pitch_german.csv"),
    ),
    (
        "protocol.txt",
        include_bytes!("../../fixtures/sheets/protocol.txt"),
    ),
    (
        "runout.csv",
        include_bytes!("../../fixtures/sheets/runout.csv"),
    ),
    (
        "spans.csv",
        include_bytes!("../../fixtures/sheets/spans.csv"),
    ),
    (
        "thickness.csv",
        include_bytes!("../../fixtures/sheets/thickness.csv"),
    ),
];

fuzz_target!(|text: &str| -> Corpus {
    // No other file of this machine has a part in it.
    if text.contains("/dev") || text.contains("/proc") || text.contains("..") {
        return Corpus::Reject;
    }
    let named: Vec<_> = TABLES
        .into_iter()
        .filter(|(name, _)| text.contains(name))
        .collect();
    let folder = Folder::new(text, &named);
    let Some(study) = folder.read_twice() else {
        return Corpus::Keep;
    };
    let (_, wheel, pinion) = &study.materials[0];
    let assembly = GearPair::with_locked(
        wheel.clone(),
        pinion.clone(),
        study.center_distances[0],
        study.locked,
    );
    let assembly = assembly.expect("a good pair file, but no assembly");
    let matings = match &study.sweep {
        Some(plan) if plan.poses() > MOST_PLANNED => return Corpus::Keep,
        Some(plan) => {
            let parts = plan.parts();
            let (_, part) = &parts[0];
            part.matings(&assembly)
        }
        None => {
            study
                .runs()
                .expect("a good pair file, but no runs")
                .remove(0)
                .matings
        }
    };
    for mating in matings.into_iter().take(MOST_RUN) {
        if let Err(what) = agree(&assembly, mating) {
            panic!("{what}\n{mating:?}");
        }
    }
    Corpus::Keep
});
