//! Gearbox models (REXS). The models are made, from the public grammar of the format.

mod mutations;
mod oracle;
mod read;

use crate::mutant;
use gearlash_rexs::{self as rexs, RexsFile};
use gearlash_text::InputError;
use std::path::Path;

fn fixture(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/rexs");
    std::fs::read_to_string(Path::new(folder).join(name)).unwrap()
}

fn read_bytes(bytes: &[u8]) -> Result<RexsFile, InputError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("gearbox.rexs");
    std::fs::write(&path, bytes).unwrap();
    rexs::read(&path)
}

fn read(text: &str) -> Result<RexsFile, InputError> {
    read_bytes(text.as_bytes())
}

/// The pair file of a stage as a table, and as it stands.
fn pair(file: &RexsFile, stage: i32) -> toml::Table {
    let pair = file.stage(stage).unwrap().pair.as_ref();
    let pair = pair.unwrap_or_else(|why| panic!("{stage}: {why}"));
    pair.pair_file.parse().unwrap()
}
