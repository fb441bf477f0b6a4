//! `[thickness.cross_check]`: a second statement about the thickness, compared and never built.

use super::faults::Drawing;
use super::limits::CROSS_CHECK;
use super::problems::Problems;
use super::spec::{CROSS_CHECK_UM, CrossCheckSpec};
use super::stated::Stated;
use super::table::Table;
use super::thickness::Statement;
use gearlash::gear::{Deviations, Gear};
use gearlash::notes::ThicknessStatements;

const KEYS: &[&str] = &[
    "span",
    "over_pins",
    "allowance_um",
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
                "add span, over_pins, allowance_um or base_thickness_mm to it, or remove it",
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

    /// A warning where it is the same measurement as the one that counts: it repeats its faults, the pin's or the count of teeth.
    pub fn same_kind(&self, drawing: &Drawing) -> Option<String> {
        let of = |statement: &Statement| match statement {
            // A base thickness may come from any measurement.
            Statement::Nominal | Statement::Base(_) => None,
            Statement::Span { teeth, .. } | Statement::Spans { teeth, .. } => {
                Some(("a span over as many teeth", f64::from(*teeth)))
            }
            Statement::OverPins { pin_mm, .. } | Statement::Pins { pin_mm, .. } => {
                Some(("a dimension over the same pins", *pin_mm))
            }
            Statement::Allowance(_) => Some(("an allowance", 0.0)),
        };
        let (words, _) =
            of(&self.statement).filter(|kind| of(&drawing.statement) == Some(*kind))?;
        Some(format!(
            "{}: is {words}, like the statement that counts, and repeats its faults: a check by another kind of measurement (span, over pins, \
             another number of teeth or pin) would find them",
            drawing.table.path_of(CrossCheck::UNDER)
        ))
    }

    /// Compares it with `gears`, which have the deviations `known`.
    pub fn compare(
        &self,
        drawing: &Drawing,
        gears: &Stated<Gear>,
        known: &Deviations,
        problems: &mut Problems,
    ) -> Option<ThicknessStatements> {
        let second = Drawing {
            table: drawing.table,
            design: drawing.design,
            statement: self.statement.clone(),
            under: CrossCheck::UNDER,
        };
        let cross = second.gears(known, problems)?;
        let range =
            |gears: &Stated<Gear>| [gears.least(), gears.most()].map(|gear| gear.base_thickness());
        Some(ThicknessStatements::new(
            range(gears),
            range(&cross),
            self.tolerance_um,
        ))
    }

    /// What the user should know of the comparison.
    pub fn told(&self, drawing: &Drawing, compared: &ThicknessStatements) -> String {
        let range = |[least, most]: [f64; 2]| {
            if least == most {
                format!("{least:.6} mm")
            } else {
                format!("{least:.6} … {most:.6} mm")
            }
        };
        let bands = [compared.counts, compared.cross].map(|[least, most]| least < most);
        let (gap, tolerance) = (compared.gap_um, compared.tolerance_um);
        let outside = match bands {
            [false, false] => "".to_owned(),
            [true, true] => format!("the bands lie {gap:.1} µm apart, "),
            _ => format!("the single value lies {gap:.1} µm outside the band, "),
        };
        let verdict = match (compared.agree(), gap > 0.0) {
            (true, false) => "they agree".to_owned(),
            (true, true) => {
                format!("{outside}within the tolerance of {tolerance:.1} µm: they agree")
            }
            (false, _) => format!(
                "{outside}{tolerance:.1} µm is allowed: check both measurements, the pins and the number of teeth spanned"
            ),
        };
        format!(
            "{}: base thickness {} by {}, {} by {}, difference{} {:.2} µm: {verdict}",
            drawing.table.path_of(CrossCheck::UNDER),
            range(compared.counts),
            drawing.statement.key().unwrap_or_default(),
            range(compared.cross),
            self.statement.key().unwrap_or_default(),
            if bands == [false, false] {
                ""
            } else {
                " of the means"
            },
            compared.difference_um,
        )
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
