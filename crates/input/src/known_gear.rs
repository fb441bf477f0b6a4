//! A gear by its data, as far as it is known while its tables are read.

use super::helix::Helix;
use gearlash::gear::{BasicGearData, Face};
use gearlash_tables::ProtocolHeader;
use std::cell::RefCell;

/// The data of a gear, each `None` where it has a problem; and what its tables say beside their values.
#[derive(Debug)]
pub struct KnownGear {
    pub teeth: Option<u32>,
    pub module_mm: Option<f64>,
    pub helix: Option<Helix>,
    pub basic_data: Option<BasicGearData>,
    pub face: Option<Face>,
    /// Statements about the gear in the files of its tables, that of the pitch first.
    pub headers: RefCell<Vec<ProtocolHeader>>,
    pub warnings: RefCell<Vec<String>>,
}

impl KnownGear {
    /// Both ends of the teeth, mm over the measuring plane away from the reference face; `Some(None)` where none are stated.
    pub fn heights(&self) -> Option<Option<[f64; 2]>> {
        let (helix, face) = (self.helix?, self.face?);
        Some(helix.face_mm.map(|ends| face.heights(ends)))
    }
}
