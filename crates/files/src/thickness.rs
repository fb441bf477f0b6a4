//! `[thickness]`: one statement of the mean tooth thickness.

use super::entry::{Limits, quoted};
use super::limits::{ALLOWANCE, LENGTH};
use super::node::Node;
use super::problems::Problems;
use super::readings::LengthReadings;
use super::sheet::Column;
use super::spec::{Either, LengthSpec, OverPinsSpec, SpanSpec, StatementSpec};
use super::stated::{self, Keys};
use super::table::Table;
use gearlash::metrology::{ThicknessStatement, Toleranced};

pub const KEYS: &[&str] = &[
    "span",
    "over_pins",
    "allowance_um",
    "base_thickness_mm",
    "per_tooth_um",
    "cross_check",
];
const STATEMENTS: &[&str] = KEYS.split_at(4).0;
const SPAN_KEYS: &[&str] = &[
    "teeth",
    "mm",
    "min_mm",
    "max_mm",
    "first_tooth",
    "per_tooth",
    "file",
    "sheet",
    "header_row",
    "tooth_column",
    "column",
    "decimal",
];
const PIN_KEYS: &[&str] = &[
    "pin_mm",
    "mm",
    "min_mm",
    "max_mm",
    "space",
    "file",
    "sheet",
    "header_row",
    "tooth_column",
    "column",
    "decimal",
];

const MEASURED: Keys = Keys {
    single: Some("mm"),
    min: "min_mm",
    max: "max_mm",
};
const BARE: Keys = Keys {
    single: None,
    min: "min",
    max: "max",
};

/// How the pair file states the mean thickness.
#[derive(Debug, Clone, PartialEq)]
pub enum Statement {
    /// Not at all: nominal.
    Nominal,
    /// `W_k` in mm over `k` teeth.
    Span { teeth: u32, mm: Toleranced<f64> },
    /// `M_dK` in mm over pins of diameter `D_M`, mm.
    OverPins { pin_mm: f64, mm: Toleranced<f64> },
    /// `W_k` all round, at first teeth; `per_tooth`: they give each tooth's thickness, too.
    Spans {
        teeth: u32,
        readings: LengthReadings,
        per_tooth: bool,
    },
    /// `M_dK` all round, at spaces.
    Pins {
        pin_mm: f64,
        readings: LengthReadings,
    },
    /// `A_s` in µm, transverse at the reference circle.
    Allowance(Toleranced<f64>),
    /// `s_b` in mm.
    Base(Toleranced<f64>),
}

impl Statement {
    /// Reads the one statement of `table`.
    pub fn read(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Statement> {
        let given: Vec<&str> = STATEMENTS
            .iter()
            .copied()
            .filter(|name| table.has(name))
            .collect();
        if given.len() > 1 {
            problems.add(table.problem(
                given[0],
                format!(
                    "given together with {}: {} thickness statements, allowed is one of {}",
                    given[1..].join(", "),
                    given.len(),
                    quoted(STATEMENTS, "`")
                ),
                "keep the one you trust most; the others can be compared with it",
            ));
            return None;
        }
        match given.first().copied() {
            Some("span") => Statement::read_span(table, teeth, problems),
            Some("over_pins") => Statement::read_pins(table, teeth, problems),
            Some("allowance_um") => {
                bare(table, "allowance_um", &ALLOWANCE, problems).map(Statement::Allowance)
            }
            Some(_) => bare(table, "base_thickness_mm", &LENGTH, problems).map(Statement::Base),
            None if STATEMENTS.iter().any(|name| table.is_mistyped(name)) => None,
            None => Some(Statement::Nominal),
        }
    }

    fn read_span(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Statement> {
        let span = table.table("span", SPAN_KEYS, problems)?;
        let most = teeth.unwrap_or(10_000);
        let k = span.whole("teeth", 1..=most, "count the teeth spanned", problems);
        let per_tooth = match span.optional("per_tooth")? {
            Some(entry) => problems.keep(entry.flag()),
            None => Some(true),
        };
        Some(
            match LengthReadings::read(&span, "first_tooth", Column::Span, teeth, problems)? {
                Some(readings) => Statement::Spans {
                    teeth: k?,
                    readings,
                    per_tooth: per_tooth?,
                },
                None => {
                    let mm = stated::read(&span, &MEASURED, &LENGTH, problems);
                    Statement::Span { teeth: k?, mm: mm? }
                }
            },
        )
    }

    fn read_pins(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Statement> {
        let pins = table.table("over_pins", PIN_KEYS, problems)?;
        let pin_mm = pins.number("pin_mm", &LENGTH, problems);
        Some(
            match LengthReadings::read(&pins, "space", Column::OverPins, teeth, problems)? {
                Some(readings) => Statement::Pins {
                    pin_mm: pin_mm?,
                    readings,
                },
                None => {
                    let mm = stated::read(&pins, &MEASURED, &LENGTH, problems);
                    Statement::OverPins {
                        pin_mm: pin_mm?,
                        mm: mm?,
                    }
                }
            },
        )
    }

    /// What was measured.
    pub fn measured(&self) -> ThicknessStatement {
        match self {
            Statement::Nominal => ThicknessStatement::Nominal,
            Statement::Span { teeth, mm } => ThicknessStatement::Span {
                teeth: *teeth,
                mm: *mm,
            },
            Statement::OverPins { pin_mm, mm } => ThicknessStatement::OverPins {
                pin_mm: *pin_mm,
                mm: *mm,
            },
            Statement::Spans {
                teeth,
                readings,
                per_tooth,
            } => ThicknessStatement::SpanReadings {
                teeth: *teeth,
                readings: readings.measured(),
                per_tooth: *per_tooth,
            },
            Statement::Pins { pin_mm, readings } => ThicknessStatement::PinReadings {
                pin_mm: *pin_mm,
                readings: readings.measured(),
            },
            Statement::Allowance(um) => ThicknessStatement::AllowanceUm(*um),
            Statement::Base(mm) => ThicknessStatement::BaseThickness(*mm),
        }
    }

    /// The key it stands under, below that of the thickness; `None` when nothing is stated.
    pub fn key(&self) -> Option<&'static str> {
        match self {
            Statement::Nominal => None,
            Statement::Span { .. } | Statement::Spans { .. } => Some("span"),
            Statement::OverPins { .. } | Statement::Pins { .. } => Some("over_pins"),
            Statement::Allowance(_) => Some("allowance_um"),
            Statement::Base(_) => Some("base_thickness_mm"),
        }
    }

    /// As in the pair file; nominal is an allowance of 0.
    pub fn spec(&self) -> StatementSpec {
        let mut spec = StatementSpec::default();
        match self {
            Statement::Nominal => spec.allowance_um = Some(Either::One(0.0)),
            Statement::Span { teeth, mm } => {
                spec.span = Some(SpanSpec {
                    teeth: *teeth,
                    length: measured(mm),
                    ..SpanSpec::default()
                });
            }
            Statement::OverPins { pin_mm, mm } => {
                spec.over_pins = Some(OverPinsSpec {
                    pin_mm: *pin_mm,
                    length: measured(mm),
                    ..OverPinsSpec::default()
                });
            }
            Statement::Spans {
                teeth,
                readings,
                per_tooth,
            } => {
                spec.span = Some(SpanSpec {
                    teeth: *teeth,
                    length: all_round(readings),
                    first_tooth: Some(readings.places().to_vec()),
                    per_tooth: Some(*per_tooth),
                    ..SpanSpec::default()
                });
            }
            Statement::Pins { pin_mm, readings } => {
                spec.over_pins = Some(OverPinsSpec {
                    pin_mm: *pin_mm,
                    length: all_round(readings),
                    space: Some(readings.places().to_vec()),
                    ..OverPinsSpec::default()
                });
            }
            Statement::Allowance(um) => spec.allowance_um = Some(stated::spec(um)),
            Statement::Base(mm) => spec.base_thickness_mm = Some(stated::spec(mm)),
        }
        spec
    }
}

/// A measured length as a pair file writes it: `mm`, or `min_mm` and `max_mm`.
fn measured(mm: &Toleranced<f64>) -> LengthSpec {
    let mut length = LengthSpec::default();
    match *mm {
        Toleranced::Single(mm) => length.mm = Some(Either::One(mm)),
        Toleranced::Band { least, most } => {
            (length.min_mm, length.max_mm) = (Some(least), Some(most))
        }
    }
    length
}

fn all_round(readings: &LengthReadings) -> LengthSpec {
    LengthSpec {
        mm: Some(Either::Other(readings.mm().to_vec())),
        ..LengthSpec::default()
    }
}

/// A number, or a table of `min` and `max`.
fn bare(
    table: &Table,
    name: &str,
    limits: &Limits,
    problems: &mut Problems,
) -> Option<Toleranced<f64>> {
    let entry = table.get(name)?;
    match entry.node() {
        Node::Table(_) => {
            let band = table.table(name, &["min", "max"], problems)?;
            stated::read(&band, &BARE, limits, problems)
        }
        Node::Whole(_) | Node::Number(_) => {
            problems.keep(entry.number(limits)).map(Toleranced::Single)
        }
        _ => {
            let allowed = format!("{}, or {{ min = …, max = … }}", limits.allowed);
            problems.add(entry.wrong_type(&allowed, limits.help));
            None
        }
    }
}
