//! A gear by its data, as far as it is known while its tables are read.

use super::helix::Helix;
use super::spec::System;
use gearlash::gear::{BasicGearData, Face};
use gearlash_tables::ProtocolHeader;
use gearlash_text::{MM_PER_INCH, Table};
use std::cell::RefCell;

/// The basic data of a gear in the normal section, each `None` where it has a problem; and what its tables say beside their values.
#[derive(Debug, Default)]
pub struct KnownGear {
    pub teeth: Option<u32>,
    pub module_mm: Option<f64>,
    /// Degrees as written.
    pub pressure_angle_deg: Option<f64>,
    pub helix: Option<Helix>,
    pub basic_data: Option<BasicGearData>,
    /// Factor from lengths as stated to those in the normal section: cos β for a transverse system, else 1.
    pub normal_per_stated: f64,
    pub face: Option<Face>,
    /// Statements about the gear in the files of its tables, that of the pitch first.
    pub headers: RefCell<Vec<ProtocolHeader>>,
    pub warnings: RefCell<Vec<String>>,
}

impl KnownGear {
    /// Reads the basic data in the gear's table.
    pub fn read(table: &Table) -> KnownGear {
        let number = |key: &str| table.read::<f64>(key).flatten();
        let helix = Helix::read(table);
        let system = table.read::<System>("system").flatten();
        let normal_per_stated = match (system, helix) {
            (Some(System::Transverse), Some(helix)) => helix.angle_deg.to_radians().cos(),
            _ => 1.0,
        };
        let stated = number("module_mm").or_else(|| Some(MM_PER_INCH / number("diametral_pitch")?));
        let module_mm = stated.map(|module| module * normal_per_stated);
        let stated = number("pressure_angle_deg");
        let pressure_angle_deg = match normal_per_stated {
            1.0 => stated,
            cos => stated.map(|angle| (angle.to_radians().tan() * cos).atan().to_degrees()),
        };
        let mut known = KnownGear {
            teeth: table.read("teeth").flatten(),
            module_mm,
            pressure_angle_deg,
            helix,
            normal_per_stated,
            face: table.read("reference_face").map(Option::unwrap_or_default),
            ..KnownGear::default()
        };
        known.basic_data = known.basic_data(table);
        known
    }

    fn basic_data(&self, table: &Table) -> Option<BasicGearData> {
        let angle = self.pressure_angle_deg?.to_radians();
        let spur = BasicGearData::new(self.teeth?, self.module_mm?, angle);
        let spur = table.keep("module_mm", spur, "correct the gear's basic data")?;
        self.helix?.apply_to(spur, table)
    }

    /// Both ends of the teeth, mm over the measuring plane away from the reference face; `Some(None)` where none are stated.
    pub fn heights(&self) -> Option<Option<[f64; 2]>> {
        let (helix, face) = (self.helix?, self.face?);
        Some(helix.face_mm.map(|ends| face.heights(ends)))
    }
}
