//! A centre distance with its tolerance as a drawing writes it: `30 js7` (after ISO 286), `30 ±0.02`.

use crate::error::GearError;
use std::str::FromStr;

/// Source of the tolerances, shown beside every one of them.
pub const ISO_286_SOURCE: &str =
    "after ISO 286-1, tolerance grades as widely printed, standard not consulted";

/// The grades of the table.
const GRADES: std::ops::RangeInclusive<usize> = 5..=10;

/// Rows: greatest size, mm; tolerance by grade, µm. The table begins above 3 mm.
const TABLE: [(f64, [u16; 6]); 12] = [
    (6.0, [5, 8, 12, 18, 30, 48]),
    (10.0, [6, 9, 15, 22, 36, 58]),
    (18.0, [8, 11, 18, 27, 43, 70]),
    (30.0, [9, 13, 21, 33, 52, 84]),
    (50.0, [11, 16, 25, 39, 62, 100]),
    (80.0, [13, 19, 30, 46, 74, 120]),
    (120.0, [15, 22, 35, 54, 87, 140]),
    (180.0, [18, 25, 40, 63, 100, 160]),
    (250.0, [20, 29, 46, 72, 115, 185]),
    (315.0, [23, 32, 52, 81, 130, 210]),
    (400.0, [25, 36, 57, 89, 140, 230]),
    (500.0, [27, 40, 63, 97, 155, 250]),
];

/// A centre distance with the tolerance of a drawing: a field `js`, `H` or `h` of grade 5 … 10, or `±` a length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignatedDistance {
    nominal: f64,
    tolerance: Tolerance,
}

/// Where a distance may lie.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Tolerance {
    /// Lower and upper end in shares of the tolerance of a grade.
    Field {
        letter: &'static str,
        ends: [f64; 2],
        grade: usize,
    },
    /// The same length on either side, mm.
    PlusMinus(f64),
}

/// Tolerance fields, and their ends in shares of the grade. `JS` is the same field on a hole.
const FIELDS: [(&str, [f64; 2]); 4] = [
    ("js", [-0.5, 0.5]),
    ("JS", [-0.5, 0.5]),
    ("H", [0.0, 1.0]),
    ("h", [-1.0, 0.0]),
];

impl DesignatedDistance {
    /// Nominal centre distance `a`, mm.
    pub fn nominal(&self) -> f64 {
        self.nominal
    }

    /// Whether the tolerance is that of a field of ISO 286.
    pub fn is_field(&self) -> bool {
        matches!(self.tolerance, Tolerance::Field { .. })
    }

    /// Lower and upper deviation, µm.
    ///
    /// # Errors
    /// A field at a nominal distance outside the table: 3 mm or less, or above 500 mm.
    pub fn deviations_um(&self) -> Result<[f64; 2], GearError> {
        let (ends, grade) = match self.tolerance {
            Tolerance::Field { ends, grade, .. } => (ends, grade),
            Tolerance::PlusMinus(mm) => return Ok([-1000.0 * mm, 1000.0 * mm]),
        };
        let row = TABLE.iter().find(|(up_to, _)| self.nominal <= *up_to);
        match row {
            Some((_, tolerances)) if self.nominal > 3.0 => {
                let tolerance = f64::from(tolerances[grade - GRADES.start()]);
                Ok(ends.map(|share| share * tolerance))
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
    let text = text.trim().replace(',', ".");
    let is_plain = |c: char| c.is_ascii_digit() || c == '.';
    text.chars().all(is_plain).then(|| text.parse().ok())?
}

impl FromStr for DesignatedDistance {
    type Err = GearError;

    /// `30 js7`, `30,0 H7`, `30 ±0.02`, with or without spaces.
    fn from_str(text: &str) -> Result<DesignatedDistance, GearError> {
        let read = || {
            if let Some((nominal, mm)) = text.split_once('±').or_else(|| text.split_once("+-")) {
                let tolerance = Tolerance::PlusMinus(plain_number(mm)?);
                return Some((plain_number(nominal)?, tolerance));
            }
            let (letter, ends) = *FIELDS.iter().find(|(letter, _)| text.contains(letter))?;
            let (nominal, grade) = text.split_once(letter)?;
            let grade = grade.trim();
            let digits = grade.chars().all(|c| c.is_ascii_digit());
            let grade = grade
                .parse()
                .ok()
                .filter(|grade| digits && GRADES.contains(grade))?;
            let letter = if letter == "JS" { "js" } else { letter };
            let tolerance = Tolerance::Field {
                letter,
                ends,
                grade,
            };
            Some((plain_number(nominal)?, tolerance))
        };
        let (nominal, tolerance) = read().ok_or(GearError::DistanceField)?;
        Ok(DesignatedDistance { nominal, tolerance })
    }
}

impl std::fmt::Display for DesignatedDistance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.tolerance {
            Tolerance::Field { letter, grade, .. } => write!(f, "{} {letter}{grade}", self.nominal),
            Tolerance::PlusMinus(mm) => write!(f, "{} ±{mm}", self.nominal),
        }
    }
}
