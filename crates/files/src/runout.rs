//! `[runout]`: how far the teeth stand from the rotation axis.

mod readings;

use super::limits::{HIGH_TOOTH, RUNOUT};
use super::problems::Problems;
use super::sheet::{self, Header};
use super::spec::RunoutSpec;
use super::stated::Stated;
use super::table::Table;
use gearlash::gear::Gear;
use gearlash::notes::Eccentricity;

pub use readings::{Knowledge, ReadingsFit, RunoutSheet};

pub const KEYS: &[&str] = &[
    "total_um",
    "high_tooth",
    "file",
    "sheet",
    "decimal",
    "at",
    "ball_mm",
];

/// Runout `F_r`, µm, and the tooth towards which the teeth are displaced.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Runout {
    /// Of readings that are not yet fitted, their range.
    pub total_um: f64,
    /// `None` only when there is no runout.
    pub high_tooth: Option<f64>,
    /// The readings it comes from.
    pub sheet: Option<RunoutSheet>,
}

impl Runout {
    /// Reads `[runout]` of a gear's table, none when it is not there.
    pub fn read(gear: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Runout> {
        let table = gear.table("runout", KEYS, problems)?;
        if !gear.has("runout") {
            return Some(Runout::default());
        }
        if table.has("file") {
            let sheet = RunoutSheet::read(&table, teeth, problems)?;
            let range = sheet.range_um();
            return Some(Runout {
                total_um: range,
                high_tooth: (range > 0.0).then_some(1.0),
                sheet: Some(sheet),
            });
        }
        sheet::without_file(&table, problems)?;
        if let Some(name) = ["at", "ball_mm"].into_iter().find(|name| table.has(name)) {
            problems.add(table.problem(
                name,
                format!("stands without file, allowed is {name} only with file"),
                format!("add `file`, or remove {name}"),
            ));
            return None;
        }
        let total_um = table.number("total_um", &RUNOUT, problems);
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
            ..Runout::default()
        })
    }

    /// What the file it comes from says of the gear.
    pub fn header(&self) -> Option<&Header> {
        self.sheet.as_ref().map(RunoutSheet::header)
    }

    /// The runout of readings once their eccentricity, mm, is known.
    pub fn fitted(&self, eccentricity: f64, high_tooth: f64) -> Runout {
        let total_um = 2000.0 * eccentricity;
        Runout {
            total_um,
            high_tooth: (total_um > 0.0).then_some(high_tooth),
            sheet: self.sheet.clone(),
        }
    }

    fn read_high_tooth(
        table: &Table,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<f64>> {
        let Some(entry) = table.optional("high_tooth")? else {
            return Some(None);
        };
        let tooth = problems.keep(entry.number(&HIGH_TOOTH))?;
        if teeth.is_some_and(|teeth| tooth >= f64::from(teeth) + 1.0) {
            problems.add(entry.problem(
                format!("out of range, allowed is {}", allowed(teeth)),
                HIGH_TOOTH.help,
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
        let key = match &self.sheet {
            Some(_) => "runout.file",
            None => "runout.total_um",
        };
        problems.add(gear.problem(
            key,
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

    /// The eccentricity, where a runout is stated with its high tooth.
    pub fn stated(&self) -> Option<Eccentricity> {
        self.high_tooth.map(|high_tooth| Eccentricity {
            um: self.total_um / 2.0,
            high_tooth,
        })
    }

    /// As in the pair file.
    pub fn spec(&self) -> RunoutSpec {
        RunoutSpec {
            total_um: self.total_um,
            high_tooth: self.high_tooth,
            ..RunoutSpec::default()
        }
    }
}

fn allowed(teeth: Option<u32>) -> String {
    match teeth {
        Some(teeth) => format!("1 up to, but not including, {}", teeth + 1),
        None => "1 up to, but not including, the number of teeth + 1".to_owned(),
    }
}
