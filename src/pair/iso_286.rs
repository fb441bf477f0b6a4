//! A centre distance with its tolerance as a drawing writes it: `30 js7` (after ISO 286), `30 ±0.02`, `30 +0.03/0`.

use crate::error::GearError;
use std::str::FromStr;

/// Source of the tolerances, shown beside every one of them.
pub const ISO_286_SOURCE: &str =
    "after ISO 286-1, tolerance grades as widely printed, standard not consulted";

/// The grades of the table.
const GRADES: std::ops::RangeInclusive<usize> = 5..=10;

/// Rows: greatest size, mm; tolerance by grade, µm; least deviation of `F`, µm. The table begins above 3 mm.
const TABLE: [(f64, [u16; 6], f64); 12] = [
    (6.0, [5, 8, 12, 18, 30, 48], 10.0),
    (10.0, [6, 9, 15, 22, 36, 58], 13.0),
    (18.0, [8, 11, 18, 27, 43, 70], 16.0),
    (30.0, [9, 13, 21, 33, 52, 84], 20.0),
    (50.0, [11, 16, 25, 39, 62, 100], 25.0),
    (80.0, [13, 19, 30, 46, 74, 120], 30.0),
    (120.0, [15, 22, 35, 54, 87, 140], 36.0),
    (180.0, [18, 25, 40, 63, 100, 160], 43.0),
    (250.0, [20, 29, 46, 72, 115, 185], 50.0),
    (315.0, [23, 32, 52, 81, 130, 210], 56.0),
    (400.0, [25, 36, 57, 89, 140, 230], 62.0),
    (500.0, [27, 40, 63, 97, 155, 250], 68.0),
];

/// A centre distance with the tolerance of a drawing: a field `js`, `H`, `h`, `F` or `f` of grade 5 … 10, `±` a length, or two deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignatedDistance {
    nominal: f64,
    tolerance: Tolerance,
}

/// Where a distance may lie.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Tolerance {
    /// One of [`FIELDS`], and its grade.
    Field(Field, usize),
    /// Lower and upper deviation, mm.
    Deviations([f64; 2]),
}

/// Its letter; its lower and upper end in shares of the grade; its distance from the nominal size in those of `F`.
type Field = (&'static str, [f64; 2], f64);

/// Tolerance fields. `JS` is the same field on a hole.
const FIELDS: [Field; 6] = [
    ("js", [-0.5, 0.5], 0.0),
    ("JS", [-0.5, 0.5], 0.0),
    ("H", [0.0, 1.0], 0.0),
    ("h", [-1.0, 0.0], 0.0),
    ("F", [0.0, 1.0], 1.0),
    ("f", [-1.0, 0.0], -1.0),
];

impl DesignatedDistance {
    /// Nominal centre distance `a`, mm.
    pub fn nominal(&self) -> f64 {
        self.nominal
    }

    /// Whether the tolerance is that of a field of ISO 286.
    pub fn is_field(&self) -> bool {
        matches!(self.tolerance, Tolerance::Field(..))
    }

    /// Lower and upper deviation, µm.
    ///
    /// # Errors
    /// A field at a nominal distance outside the table: 3 mm or less, or above 500 mm.
    pub fn deviations_um(&self) -> Result<[f64; 2], GearError> {
        let ((_, ends, away), grade) = match self.tolerance {
            Tolerance::Field(field, grade) => (field, grade),
            Tolerance::Deviations(mm) => return Ok(mm.map(|mm| 1000.0 * mm)),
        };
        let row = TABLE.iter().find(|(up_to, ..)| self.nominal <= *up_to);
        match row {
            Some((_, tolerances, least)) if self.nominal > 3.0 => {
                let tolerance = f64::from(tolerances[grade - GRADES.start()]);
                Ok(ends.map(|share| share * tolerance + away * least))
            }
            _ => Err(GearError::OutOfRange {
                what: "designated centre distance (mm)",
                value: self.nominal,
                allowed: "above 3 and up to 500 mm: the table ends there",
            }),
        }
    }
}

/// A number in digits alone, with a decimal point or a decimal comma.
fn plain_number(text: &str) -> Option<f64> {
    let text = text.trim();
    let text = text.strip_suffix("mm").map_or(text, str::trim_end);
    let text = text.replace(',', ".");
    let is_plain = |c: char| c.is_ascii_digit() || c == '.';
    text.chars().all(is_plain).then(|| text.parse().ok())?
}

const SIGNS: [char; 3] = ['+', '-', '−'];

/// A deviation with its sign; 0 needs none.
fn deviation(text: &str) -> Option<f64> {
    let text = text.trim();
    match text.strip_prefix(SIGNS) {
        Some(amount) if text.starts_with('+') => plain_number(amount),
        Some(amount) => plain_number(amount).map(|mm| 0.0 - mm),
        None => plain_number(text).filter(|mm| *mm == 0.0),
    }
}

/// `30 +0.03/0`, `30 +0.03 -0.01`, `30 +0.03 0`, `30 +0.03`: the nominal distance, and both deviations in either order. The second is 0
/// where it is missing.
fn deviations(text: &str) -> Option<(f64, Tolerance)> {
    let (head, second) = match text.split_once('/') {
        Some(parts) => parts,
        None if text.matches(SIGNS).count() == 1 => (text.strip_suffix(" 0").unwrap_or(text), "0"),
        None => text.split_at(text.rfind(SIGNS)?),
    };
    let head = head.trim();
    // A sign or a blank ends the nominal distance.
    let begins = |c: char| SIGNS.contains(&c) || c.is_whitespace();
    let (nominal, first) = head.split_at(head.find(begins)?);
    let (one, other) = (deviation(first)?, deviation(second)?);
    let mm = [one.min(other), one.max(other)];
    Some((plain_number(nominal)?, Tolerance::Deviations(mm)))
}

impl FromStr for DesignatedDistance {
    type Err = GearError;

    /// `30 js7`, `30,0 H7`, `30 ±0.02`, `30 +0.03/0`, with or without spaces and `mm`.
    fn from_str(text: &str) -> Result<DesignatedDistance, GearError> {
        let text = text.trim();
        let text = text.strip_suffix("mm").unwrap_or(text);
        let read = || {
            let sign = ["±", "+-", "+/-"]
                .into_iter()
                .find(|sign| text.contains(sign));
            if let Some((nominal, mm)) = sign.and_then(|sign| text.split_once(sign)) {
                let mm = plain_number(mm)?;
                return Some((plain_number(nominal)?, Tolerance::Deviations([-mm, mm])));
            }
            if text.contains('/') || text.contains(SIGNS) {
                return deviations(text);
            }
            let mut field = *FIELDS.iter().find(|(letter, ..)| text.contains(letter))?;
            let (nominal, grade) = text.split_once(field.0)?;
            let grade = grade.trim();
            let digits = grade.chars().all(|c| c.is_ascii_digit());
            let grade = grade
                .parse()
                .ok()
                .filter(|grade| digits && GRADES.contains(grade))?;
            if field.0 == "JS" {
                field.0 = "js";
            }
            Some((plain_number(nominal)?, Tolerance::Field(field, grade)))
        };
        let (nominal, tolerance) = read().ok_or(GearError::DistanceField)?;
        Ok(DesignatedDistance { nominal, tolerance })
    }
}

impl std::fmt::Display for DesignatedDistance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let signed = |mm: f64| match mm {
            0.0 => "0".to_owned(),
            mm => format!("{mm:+}"),
        };
        match self.tolerance {
            Tolerance::Field((letter, ..), grade) => write!(f, "{} {letter}{grade}", self.nominal),
            Tolerance::Deviations([lower, upper]) if lower == -upper => {
                write!(f, "{} ±{upper}", self.nominal)
            }
            Tolerance::Deviations([lower, upper]) => {
                write!(f, "{} {}/{}", self.nominal, signed(upper), signed(lower))
            }
        }
    }
}
