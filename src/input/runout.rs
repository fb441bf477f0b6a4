//! `[runout]`: how far the teeth stand from the rotation axis.

use super::entry::Limits;
use super::problems::Problems;
use super::sheet::{Column, Coverage, Header, Sheet, Wanted};
use super::stated::Stated;
use super::table::Table;
use crate::gear::{Gear, RunoutFit};
use crate::notes::Eccentricity;
use serde_json::{Map, Value, json};

pub const KEYS: &[&str] = &["total_um", "high_tooth", "file", "sheet", "at"];

/// Where a reading was taken, in pitches beyond the centre of the tooth of its number.
const PLACES: [(&str, f64); 2] = [("tooth", 0.0), ("space", 0.5)];

const TOTAL: Limits = Limits {
    allowed: "a number of µm, 0 or more, less than the tooth depth",
    holds: |um| um >= 0.0,
    way_out: "give the radial runout F_r, twice the eccentricity",
};

/// Runout `F_r`, µm, and the tooth towards which the teeth are displaced.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Runout {
    pub total_um: f64,
    /// `None` only when there is no runout.
    pub high_tooth: Option<f64>,
    /// Whether the pair file has it.
    given: bool,
    /// What the file it comes from says of the gear.
    pub header: Header,
    /// What was made of readings.
    pub warning: Option<String>,
}

impl Runout {
    /// Reads `[runout]` of a gear's table, none when it is not there.
    pub fn read(gear: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Runout> {
        let table = gear.table("runout", KEYS, problems)?;
        if !gear.has("runout") {
            return Some(Runout::default());
        }
        if table.has("file") {
            return Runout::read_file(&table, teeth, problems);
        }
        if table.has("at") {
            problems.add(table.problem(
                "at",
                "stands without file, allowed is at only with file",
                "add `file`, or remove at",
            ));
            return None;
        }
        let total_um = table.number("total_um", &TOTAL, problems);
        let high_tooth = Runout::read_high_tooth(&table, teeth, problems);
        let (total_um, high_tooth) = (total_um?, high_tooth?);
        if total_um > 0.0 && high_tooth.is_none() {
            table.need(
                "high_tooth",
                &format!(
                    "the tooth number at the highest reading, {}",
                    allowed(teeth)
                ),
                problems,
            );
            return None;
        }
        Some(Runout {
            total_um,
            high_tooth,
            given: true,
            ..Runout::default()
        })
    }

    /// The first harmonic of the readings in the file that `table` names.
    fn read_file(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Runout> {
        let stated = ["total_um", "high_tooth"]
            .into_iter()
            .find(|name| table.has(name));
        if let Some(stated) = stated {
            problems.add(table.problem(
                "file",
                format!("stands beside {stated}, allowed is one of file and the values"),
                "remove one or the other",
            ));
            return None;
        }
        let needed = "\"tooth\" (at its centre line) or \"space\" (between it and the next number)";
        let at = table
            .need("at", needed, problems)
            .and_then(|entry| problems.keep(entry.choice(&PLACES)));
        let wanted = Wanted {
            columns: [Column::Runout],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        let fit = RunoutFit::new(&sheet.values(0), at?);
        let total_um = 2.0 * fit.eccentricity;
        Some(Runout {
            total_um,
            given: true,
            high_tooth: (total_um > 0.0).then_some(fit.high_tooth),
            header: sheet.header,
            warning: Some(format!(
                "{}: the readings' first harmonic is an eccentricity of {:.3} µm towards tooth {:.2}, which is taken as the gear's; \
                 F_r, their range, is {:.3} µm; up to {:.3} µm of a reading is neither mean nor first harmonic and is not used \
                 (pitch data say it)",
                table.path_of("file"),
                fit.eccentricity,
                fit.high_tooth,
                fit.range,
                fit.rest,
            )),
        })
    }

    fn read_high_tooth(
        table: &Table,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<f64>> {
        const ANY: Limits = Limits {
            allowed: "a tooth number, 1 or more, fractions allowed",
            holds: |tooth| tooth >= 1.0,
            way_out: "give the number of the tooth at the highest reading",
        };
        let Some(entry) = table.optional("high_tooth")? else {
            return Some(None);
        };
        let tooth = problems.keep(entry.number(&ANY))?;
        if teeth.is_some_and(|teeth| tooth >= f64::from(teeth) + 1.0) {
            problems.add(entry.problem(
                format!("out of range, allowed is {}", allowed(teeth)),
                ANY.way_out,
            ));
            return None;
        }
        Some(Some(tooth))
    }

    /// Checks that the runout stays below the tooth depth of each of `gears`.
    pub fn check(&self, gear: &Table, gears: &Stated<Gear>, problems: &mut Problems) -> Option<()> {
        let depth_of = |gear: &Gear| gear.tip_radius() - gear.root_radius();
        // Both thicknesses have one tip circle; the thicker tooth has the higher root.
        let depth_mm = depth_of(gears.most()).min(depth_of(gears.least()));
        if self.total_um / 1000.0 < depth_mm {
            return Some(());
        }
        problems.add(gear.problem(
            "runout.total_um",
            format!(
                "out of range, allowed is below the tooth depth, {:.1} µm",
                1000.0 * depth_mm
            ),
            "check the unit: µm",
        ));
        None
    }

    /// Eccentricity `e = F_r/2`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.total_um / 2000.0
    }

    /// The eccentricity, where a runout is stated; its tooth is 1 where there is none of it.
    pub fn stated(&self) -> Option<Eccentricity> {
        self.given.then(|| Eccentricity {
            um: self.total_um / 2.0,
            high_tooth: self.high_tooth.unwrap_or(1.0),
        })
    }

    /// As in the pair file.
    pub fn echo(&self) -> Value {
        let mut echo = Map::from_iter([("total_um".to_owned(), json!(self.total_um))]);
        if let Some(tooth) = self.high_tooth {
            echo.insert("high_tooth".to_owned(), json!(tooth));
        }
        Value::Object(echo)
    }
}

fn allowed(teeth: Option<u32>) -> String {
    match teeth {
        Some(teeth) => format!("1 up to, but not including, {}", teeth + 1),
        None => "1 up to, but not including, the number of teeth + 1".to_owned(),
    }
}
