//! A centre distance with a tolerance field such as `30 js7`, after ISO 286.

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

/// A centre distance with a symmetric tolerance field `js5` … `js10`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignatedDistance {
    nominal: f64,
    grade: usize,
}

impl DesignatedDistance {
    /// Nominal centre distance `a`, mm.
    pub fn nominal(&self) -> f64 {
        self.nominal
    }

    /// Half the tolerance grade, µm: the greatest deviation on either side.
    ///
    /// # Errors
    /// A nominal distance outside the table: 3 mm or less, or above 500 mm.
    pub fn tolerance_um(&self) -> Result<f64, GearError> {
        let row = TABLE.iter().find(|(up_to, _)| self.nominal <= *up_to);
        match row {
            Some((_, tolerances)) if self.nominal > 3.0 => {
                Ok(0.5 * f64::from(tolerances[self.grade - GRADES.start()]))
            }
            _ => Err(GearError::OutOfRange {
                what: "designated centre distance (mm)",
                value: self.nominal,
                allowed: "above 3 and up to 500 mm: the table ends there",
            }),
        }
    }
}

impl FromStr for DesignatedDistance {
    type Err = GearError;

    /// `30 js7`, with or without spaces; `JS` is the same field on a hole.
    fn from_str(text: &str) -> Result<DesignatedDistance, GearError> {
        let refused = || GearError::DistanceField;
        let (nominal, field) = text
            .split_once("js")
            .or_else(|| text.split_once("JS"))
            .ok_or_else(refused)?;
        let plain = |c: char| c.is_ascii_digit() || c == '.';
        let nominal = Some(nominal.trim()).filter(|nominal| nominal.chars().all(plain));
        let nominal: f64 = nominal.and_then(|n| n.parse().ok()).ok_or_else(refused)?;
        let field = field.trim();
        let digits = field.chars().all(|c| c.is_ascii_digit());
        let grade = field.parse().ok().filter(|_| digits);
        match grade.filter(|grade| GRADES.contains(grade)) {
            Some(grade) => Ok(DesignatedDistance { nominal, grade }),
            None => Err(refused()),
        }
    }
}

impl std::fmt::Display for DesignatedDistance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} js{}", self.nominal, self.grade)
    }
}
