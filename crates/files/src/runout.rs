//! `[runout]`: how far the teeth stand from the rotation axis.

mod readings;

use super::limits::{HIGH_TOOTH, RUNOUT};
use super::problems::Problems;
use super::sheet::{self, Header};
use super::spec::RunoutSpec;
use super::table::Table;
use gearlash::metrology::{self, RunoutStatement};

pub use readings::RunoutSheet;

pub const KEYS: &[&str] = &sheet::keys_beside::<4, 10>(["total_um", "high_tooth", "at", "ball_mm"]);

/// Runout `F_r`, µm, and the tooth towards which the teeth are displaced.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Runout {
    /// Of readings 0 until they are fitted.
    pub total_um: f64,
    /// `None`: it may be any.
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
            return Some(Runout {
                sheet: Some(sheet),
                ..Runout::default()
            });
        }
        sheet::without_file(&table, problems)?;
        if let Some(name) = ["at", "ball_mm"].into_iter().find(|name| table.has(name)) {
            problems.add(table.problem(
                name,
                format!("given without file, {name} is allowed only with file"),
                format!("add `file`, or remove {name}"),
            ));
            return None;
        }
        let total_um = table.number("total_um", &RUNOUT, problems);
        let high_tooth = Runout::read_high_tooth(&table, teeth, problems);
        let (total_um, high_tooth) = (total_um?, high_tooth?);
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

    /// What was measured.
    pub fn measured(&self) -> RunoutStatement {
        match (&self.sheet, self.high_tooth) {
            (Some(sheet), _) => RunoutStatement::Readings(sheet.measured()),
            (None, None) if self.total_um == 0.0 => RunoutStatement::None,
            (None, high_tooth) => RunoutStatement::Total {
                total_um: self.total_um,
                high_tooth,
            },
        }
    }

    /// The runout of the gear as measured.
    pub fn settled(&self, runout: metrology::Runout) -> Runout {
        Runout {
            total_um: runout.total_um,
            high_tooth: runout.high_tooth,
            sheet: self.sheet.clone(),
        }
    }

    /// The key, below the gear's table, that gives it.
    pub fn key(&self) -> &'static str {
        match &self.sheet {
            Some(_) => "runout.file",
            None => "runout.total_um",
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
