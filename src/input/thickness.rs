//! `[thickness]`: one statement of the mean tooth thickness, and what is added per tooth.

use super::entry::{Limits, quoted};
use super::node::Node;
use super::problems::Problems;
use super::stated::{Keys, Stated};
use super::table::Table;
use crate::error::GearError;
use crate::gear::{Blank, Gear, thickness};
use serde_json::{Map, Value, json};

pub const KEYS: &[&str] = &[
    "span",
    "over_pins",
    "allowance_um",
    "base_thickness_mm",
    "per_tooth_um",
];
const STATEMENTS: &[&str] = KEYS.split_at(4).0;

const LENGTH: Limits = Limits {
    allowed: "a number of mm above 0 and up to 1e9",
    holds: |mm| mm > 0.0 && mm <= 1e9,
    way_out: "give the measured length in mm",
};
const ALLOWANCE: Limits = Limits {
    allowed: "a number of µm, −1e7 … 1e7",
    holds: |um| um.abs() <= 1e7,
    way_out: "give the deviation from the nominal thickness, negative when thinner",
};
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Statement {
    /// Not at all: nominal.
    Nominal,
    /// `W_k` in mm over `k` teeth.
    Span { teeth: u32, mm: Stated<f64> },
    /// `M_dK` in mm over pins of diameter `D_M`, mm.
    OverPins { pin_mm: f64, mm: Stated<f64> },
    /// `A_s` in µm, transverse at the reference circle.
    Allowance(Stated<f64>),
    /// `s_b` in mm.
    Base(Stated<f64>),
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
                    "stands beside {}: {} thickness statements, allowed is one of {}",
                    given[1..].join(", "),
                    given.len(),
                    quoted(STATEMENTS, "`")
                ),
                "keep the one you trust most; the others can be compared with it",
            ));
            return None;
        }
        match given.first().copied() {
            Some("span") => {
                let span = table.table("span", &["teeth", "mm", "min_mm", "max_mm"], problems)?;
                let most = teeth.unwrap_or(10_000);
                let teeth = span.whole("teeth", 1..=most, "count the teeth spanned", problems);
                let mm = Stated::read(&span, &MEASURED, &LENGTH, problems);
                Some(Statement::Span {
                    teeth: teeth?,
                    mm: mm?,
                })
            }
            Some("over_pins") => {
                let pins =
                    table.table("over_pins", &["pin_mm", "mm", "min_mm", "max_mm"], problems)?;
                let pin_mm = pins.number("pin_mm", &LENGTH, problems);
                let mm = Stated::read(&pins, &MEASURED, &LENGTH, problems);
                Some(Statement::OverPins {
                    pin_mm: pin_mm?,
                    mm: mm?,
                })
            }
            Some("allowance_um") => {
                bare(table, "allowance_um", &ALLOWANCE, problems).map(Statement::Allowance)
            }
            Some(_) => bare(table, "base_thickness_mm", &LENGTH, problems).map(Statement::Base),
            None if STATEMENTS.iter().any(|name| table.is_mistyped(name)) => None,
            None => Some(Statement::Nominal),
        }
    }

    /// The key it stands under, below the gear's; `None` when nothing is stated.
    pub fn key(&self) -> Option<&'static str> {
        match self {
            Statement::Nominal => None,
            Statement::Span { .. } => Some("thickness.span"),
            Statement::OverPins { .. } => Some("thickness.over_pins"),
            Statement::Allowance(_) => Some("thickness.allowance_um"),
            Statement::Base(_) => Some("thickness.base_thickness_mm"),
        }
    }

    /// Mean base tooth thickness `s_b`, mm.
    ///
    /// # Errors
    /// A dimension over pins whose pins would sit inside the base circle.
    pub fn base_thickness(&self, blank: &Blank) -> Result<Stated<f64>, GearError> {
        let toothing = &blank.toothing;
        let nominal = blank.nominal_base_thickness();
        match self {
            Statement::Nominal => Ok(Stated::Single(nominal)),
            Statement::Span { teeth, mm } => {
                mm.try_map(|&mm| Ok(thickness::base_from_span(toothing, *teeth, mm)))
            }
            Statement::OverPins { pin_mm, mm } => {
                mm.try_map(|&mm| thickness::base_from_pins(toothing, *pin_mm, mm))
            }
            Statement::Allowance(um) => um.try_map(|&um| {
                Ok(thickness::base_from_allowance(
                    toothing,
                    nominal,
                    um / 1000.0,
                ))
            }),
            Statement::Base(mm) => Ok(*mm),
        }
    }

    /// Whether the measurement touches `gear` where it measures its thickness.
    ///
    /// # Errors
    /// A span or a pin that does not touch the involute, a pin below the tip or in the root.
    pub fn check(&self, gear: &Gear) -> Result<(), GearError> {
        match *self {
            Statement::Span { teeth, .. } => thickness::check_span(gear, teeth),
            Statement::OverPins { pin_mm, .. } => thickness::check_pins(gear, pin_mm),
            _ => Ok(()),
        }
    }

    /// What the nominal tooth would measure: "nominal is 50.6 mm".
    pub fn nominal(&self, blank: &Blank) -> String {
        let toothing = &blank.toothing;
        let base = blank.nominal_base_thickness();
        match *self {
            Statement::Nominal | Statement::Base(_) => format!("nominal is {base:.4} mm"),
            Statement::Span { teeth, .. } => {
                let span = thickness::span_from_base(toothing, teeth, base);
                format!("nominal over {teeth} teeth is {span:.4} mm")
            }
            Statement::OverPins { pin_mm, .. } => {
                let over = thickness::pins_from_base(toothing, pin_mm, base);
                format!("nominal over pins of {pin_mm} mm is {over:.4} mm")
            }
            Statement::Allowance(_) => "nominal is 0 µm".to_owned(),
        }
    }

    /// As in the pair file; nominal is an allowance of 0.
    pub fn echo(&self) -> Map<String, Value> {
        let mut echo = Map::new();
        let (key, value) = match self {
            Statement::Nominal => ("allowance_um", json!(0.0)),
            Statement::Span { teeth, mm } => {
                let mut span = Map::from_iter([("teeth".to_owned(), json!(teeth))]);
                mm.echo(&MEASURED, &mut span);
                ("span", Value::Object(span))
            }
            Statement::OverPins { pin_mm, mm } => {
                let mut pins = Map::from_iter([("pin_mm".to_owned(), json!(pin_mm))]);
                mm.echo(&MEASURED, &mut pins);
                ("over_pins", Value::Object(pins))
            }
            Statement::Allowance(um) => ("allowance_um", bare_echo(um)),
            Statement::Base(mm) => ("base_thickness_mm", bare_echo(mm)),
        };
        echo.insert(key.to_owned(), value);
        echo
    }
}

/// A number, or a table of `min` and `max`.
fn bare(
    table: &Table,
    name: &str,
    limits: &Limits,
    problems: &mut Problems,
) -> Option<Stated<f64>> {
    let entry = table.get(name)?;
    match entry.node() {
        Node::Table(_) => {
            let band = table.table(name, &["min", "max"], problems)?;
            Stated::read(&band, &BARE, limits, problems)
        }
        Node::Whole(_) | Node::Number(_) => problems.keep(entry.number(limits)).map(Stated::Single),
        _ => {
            let allowed = format!("{}, or {{ min = …, max = … }}", limits.allowed);
            problems.add(entry.wrong_type(&allowed, limits.way_out));
            None
        }
    }
}

fn bare_echo(stated: &Stated<f64>) -> Value {
    match stated {
        Stated::Single(value) => json!(value),
        Stated::Band { least, most } => json!({ "min": least, "max": most }),
    }
}
