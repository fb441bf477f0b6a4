//! `[thickness.cross_check]`: a second statement about the thickness, compared and never built.

use super::limits::CROSS_CHECK;
use super::problems::Problems;
use super::spec::{CROSS_CHECK_UM, CrossCheckSpec};
use super::table::Table;
use super::thickness::Statement;
use gearlash::metrology;

const KEYS: &[&str] = &[
    "span",
    "over_pins",
    "designation",
    "allowance_um",
    "flank_offset_mm",
    "base_thickness_mm",
    "tolerance_um",
];

/// The second statement.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossCheck {
    statement: Statement,
    tolerance_um: f64,
}

impl CrossCheck {
    /// Where it stands, below the gear's table.
    pub const UNDER: &str = "thickness.cross_check";

    /// Reads it from `[thickness]`; `Some(None)` when there is none.
    pub fn read(
        thickness: &Table,
        counts: Option<&Statement>,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<CrossCheck>> {
        if thickness.optional("cross_check")?.is_none() {
            return Some(None);
        }
        let table = thickness.table("cross_check", KEYS, problems)?;
        if table.has("span.per_tooth") {
            problems.add(table.problem(
                "span.per_tooth",
                "needless: a cross-check never changes a tooth",
                "remove it",
            ));
            return None;
        }
        let statement = Statement::read(&table, teeth, problems);
        let tolerance = table.number_or("tolerance_um", CROSS_CHECK_UM, &CROSS_CHECK, problems);
        let (statement, tolerance_um) = (statement?, tolerance?);
        if statement == Statement::Nominal {
            problems.add(thickness.problem(
                "cross_check",
                "states no thickness",
                "add span, over_pins or another statement of a thickness to it, or remove it",
            ));
            return None;
        }
        if counts? == &Statement::Nominal {
            problems.add(thickness.problem(
                "cross_check",
                "there is no other statement to compare it with",
                "state the thickness that counts beside it (allowance_um = 0 for the nominal one), or move it up to [thickness]",
            ));
            return None;
        }
        Some(Some(CrossCheck {
            statement,
            tolerance_um,
        }))
    }

    /// What it states.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// What was measured.
    pub fn measured(&self) -> metrology::CrossCheck {
        metrology::CrossCheck {
            statement: self.statement.measured(),
            tolerance_um: self.tolerance_um,
        }
    }

    /// As in the pair file.
    pub fn spec(&self) -> CrossCheckSpec {
        let mut statement = self.statement.spec();
        if let Some(span) = &mut statement.span {
            // A cross-check has no say in it.
            span.per_tooth = None;
        }
        CrossCheckSpec {
            statement,
            tolerance_um: Some(self.tolerance_um),
        }
    }
}
