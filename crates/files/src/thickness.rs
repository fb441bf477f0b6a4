//! `[thickness]`: one statement of the mean tooth thickness.

use super::entry::{Limits, quoted};
use super::limits::{ALLOWANCE, FLANK_OFFSET, LENGTH};
use super::node::Node;
use super::problems::Problems;
use super::readings::LengthReadings;
use super::sheet::{self, Column};
use super::spec::{BodyName, Either, LengthSpec, OverPinsSpec, SpanSpec, StatementSpec};
use super::stated::{self, Keys};
use super::table::Table;
use gearlash::error::GearError;
use gearlash::gear::{MeasuringBody, ThicknessField};
use gearlash::metrology::{ThicknessStatement, Toleranced};

pub const KEYS: &[&str] = &[
    "span",
    "over_pins",
    "designation",
    "allowance_um",
    "flank_offset_mm",
    "base_thickness_mm",
    "per_tooth_um",
    "cross_check",
];
const STATEMENTS: &[&str] = KEYS.split_at(6).0;
/// The ways to write a tolerance field.
const FIELD: &str = "21 … 30 and a, ab, b, bc, c, cd, d, e, f, g or h, such as \"25cd\"";
const SPAN_KEYS: &[&str] = &sheet::keys_beside::<6, 12>([
    "teeth",
    "mm",
    "min_mm",
    "max_mm",
    "first_tooth",
    "per_tooth",
]);
const PIN_KEYS: &[&str] =
    &sheet::keys_beside::<6, 12>(["pin_mm", "kind", "mm", "min_mm", "max_mm", "space"]);
const BODIES: [(&str, MeasuringBody); 2] =
    [("ball", MeasuringBody::Ball), ("pin", MeasuringBody::Pin)];

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
/// As a drawing writes them.
const LIMITS: Keys = Keys {
    single: None,
    min: "lower",
    max: "upper",
};

/// How the pair file states the mean thickness.
#[derive(Debug, Clone, PartialEq)]
pub enum Statement {
    /// Not at all: nominal.
    Nominal,
    /// `W_k` in mm over `k` teeth.
    Span { teeth: u32, mm: Toleranced<f64> },
    /// `M_dK` in mm over pins of diameter `D_M`, mm; over which, where that is stated.
    OverPins {
        body: Option<MeasuringBody>,
        pin_mm: f64,
        mm: Toleranced<f64>,
    },
    /// `W_k` all round, at first teeth; `per_tooth`: they give each tooth's thickness, too.
    Spans {
        teeth: u32,
        readings: LengthReadings,
        per_tooth: bool,
    },
    /// `M_dK` all round, at spaces.
    Pins {
        body: Option<MeasuringBody>,
        pin_mm: f64,
        readings: LengthReadings,
    },
    /// `A_s` in µm, transverse at the reference circle.
    Allowance(Toleranced<f64>),
    /// A tolerance field such as 25cd.
    Field(ThicknessField),
    /// What both flanks stand out along their normals, mm.
    FlankOffset(Toleranced<f64>),
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
            Some("flank_offset_mm") => {
                bare(table, "flank_offset_mm", &FLANK_OFFSET, problems).map(Statement::FlankOffset)
            }
            Some("designation") => field(table, problems).map(Statement::Field),
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
        let body = pins.optional_as("kind", problems, |entry| entry.choice(&BODIES));
        Some(
            match LengthReadings::read(&pins, "space", Column::OverPins, teeth, problems)? {
                Some(readings) => Statement::Pins {
                    body: body?,
                    pin_mm: pin_mm?,
                    readings,
                },
                None => {
                    let mm = stated::read(&pins, &MEASURED, &LENGTH, problems);
                    Statement::OverPins {
                        body: body?,
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
            Statement::OverPins { body, pin_mm, mm } => ThicknessStatement::OverPins {
                body: body.unwrap_or_default(),
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
            Statement::Pins {
                body,
                pin_mm,
                readings,
            } => ThicknessStatement::PinReadings {
                body: body.unwrap_or_default(),
                pin_mm: *pin_mm,
                readings: readings.measured(),
            },
            Statement::Allowance(um) => ThicknessStatement::AllowanceUm(*um),
            Statement::Field(field) => ThicknessStatement::Field(*field),
            Statement::FlankOffset(mm) => ThicknessStatement::FlankOffset(*mm),
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
            Statement::Field(_) => Some("designation"),
            Statement::FlankOffset(_) => Some("flank_offset_mm"),
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
            Statement::OverPins { body, pin_mm, mm } => {
                spec.over_pins = Some(OverPinsSpec {
                    kind: body.map(BodyName::from),
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
            Statement::Pins {
                body,
                pin_mm,
                readings,
            } => {
                spec.over_pins = Some(OverPinsSpec {
                    kind: body.map(BodyName::from),
                    pin_mm: *pin_mm,
                    length: all_round(readings),
                    space: Some(readings.places().to_vec()),
                    ..OverPinsSpec::default()
                });
            }
            Statement::Allowance(um) => spec.allowance_um = Some(stated::spec(um)),
            Statement::Field(field) => spec.designation = Some(field.to_string()),
            Statement::FlankOffset(mm) => spec.flank_offset_mm = Some(stated::spec(mm)),
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

fn field(table: &Table, problems: &mut Problems) -> Option<ThicknessField> {
    let entry = table.get("designation")?;
    let text = problems.keep(entry.text("write it in quotes"))?;
    let refused = |error: GearError| {
        entry.problem(
            format!("{error}, allowed is {FIELD}"),
            "copy it from the drawing; or give allowance_um = { upper = …, lower = … }",
        )
    };
    problems.keep(text.parse().map_err(refused))
}

/// A number, or a table of `min` and `max`, of an allowance also of `upper` and `lower`.
fn bare(
    table: &Table,
    name: &str,
    limits: &Limits,
    problems: &mut Problems,
) -> Option<Toleranced<f64>> {
    let entry = table.get(name)?;
    match entry.node() {
        Node::Table(_) => {
            if name != "allowance_um" {
                let band = table.table(name, &["min", "max"], problems)?;
                return stated::read(&band, &BARE, limits, problems);
            }
            let band = table.table(name, &["min", "max", "lower", "upper"], problems)?;
            let first = |names: [&'static str; 2]| names.into_iter().find(|name| band.has(name));
            match (first(["min", "max"]), first(["lower", "upper"])) {
                (Some(one), Some(other)) => {
                    problems.add(band.problem(
                        other,
                        format!(
                            "given together with {one}, allowed is min and max, or lower and upper"
                        ),
                        "remove two of them",
                    ));
                    None
                }
                (None, Some(_)) => stated::read(&band, &LIMITS, limits, problems),
                _ => stated::read(&band, &BARE, limits, problems),
            }
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
