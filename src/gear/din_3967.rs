//! Tooth thickness from a drawing's designation, after DIN 3967.

use super::BasicGearData;
use crate::error::GearError;
use std::str::FromStr;

/// Source of the allowances, shown beside every one of them.
pub const DIN_3967_SOURCE: &str =
    "after DIN 3967:1978, as two public programs tabulate it alike; standard not consulted";

/// The series of upper allowances, the greatest first.
const SERIES: [&str; 11] = ["a", "ab", "b", "bc", "c", "cd", "d", "e", "f", "g", "h"];
/// The series of tolerances.
const TOLERANCES: std::ops::RangeInclusive<usize> = 21..=30;

/// Rows: greatest reference diameter, mm; upper allowance by series, tolerance by series, µm.
#[rustfmt::skip]
const TABLE: [(f64, [i16; 11], [i16; 10]); 11] = [
    (10.0, [-100, -85, -70, -58, -48, -40, -33, -22, -10, -5, 0], [3, 5, 8, 12, 20, 30, 50, 80, 130, 200]),
    (50.0, [-135, -110, -95, -75, -65, -54, -44, -30, -14, -7, 0], [5, 8, 12, 20, 30, 50, 80, 130, 200, 300]),
    (125.0, [-180, -150, -125, -105, -85, -70, -60, -40, -19, -9, 0], [6, 10, 16, 25, 40, 60, 100, 160, 250, 400]),
    (280.0, [-250, -200, -170, -140, -115, -95, -80, -56, -26, -12, 0], [8, 12, 20, 30, 50, 80, 130, 200, 300, 500]),
    (560.0, [-330, -280, -230, -190, -155, -130, -110, -75, -35, -17, 0], [10, 16, 25, 40, 60, 100, 160, 250, 400, 600]),
    (1000.0, [-450, -370, -310, -260, -210, -175, -145, -100, -48, -22, 0], [12, 20, 30, 50, 80, 130, 200, 300, 500, 800]),
    (1600.0, [-600, -500, -420, -340, -290, -240, -200, -135, -64, -30, 0], [16, 25, 40, 60, 100, 160, 250, 400, 600, 1000]),
    (2500.0, [-820, -680, -560, -460, -390, -320, -270, -180, -85, -41, 0], [20, 30, 50, 80, 130, 200, 300, 500, 800, 1300]),
    (4000.0, [-1100, -920, -760, -620, -520, -430, -360, -250, -115, -56, 0], [25, 40, 60, 100, 160, 250, 400, 600, 1000, 1600]),
    (6300.0, [-1500, -1250, -1020, -840, -700, -580, -480, -330, -155, -75, 0], [30, 50, 80, 130, 200, 300, 500, 800, 1300, 2000]),
    (10_000.0, [-2000, -1650, -1350, -1150, -940, -780, -640, -450, -210, -100, 0], [40, 60, 100, 160, 250, 400, 600, 1000, 1600, 2400]),
];

/// A tolerance field of the tooth thickness such as `25cd`: series of the tolerance, series of the upper allowance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ThicknessField {
    allowance: usize,
    tolerance: usize,
}

impl ThicknessField {
    /// Upper and lower allowance `A_sne` and `A_sni` of the normal tooth thickness at the reference cylinder, µm.
    ///
    /// # Errors
    /// A reference diameter above 10 000 mm, the end of the table.
    pub fn allowances_um(&self, basic_data: &BasicGearData) -> Result<[f64; 2], GearError> {
        let diameter = 2.0 * basic_data.reference_radius();
        let row = TABLE.iter().find(|(up_to, ..)| diameter <= *up_to);
        let (_, allowances, tolerances) = row.ok_or(GearError::OutOfRange {
            what: "reference diameter (mm)",
            value: diameter,
            allowed: "up to 10 000 mm: DIN 3967 ends there",
        })?;
        let upper = f64::from(allowances[self.allowance]);
        Ok([upper, upper - f64::from(tolerances[self.tolerance])])
    }
}

impl FromStr for ThicknessField {
    type Err = GearError;

    /// `25cd` or `cd25`, with or without a space, perhaps behind `DIN 3967`.
    fn from_str(text: &str) -> Result<ThicknessField, GearError> {
        let text = text.trim();
        let behind = text.strip_prefix("DIN 3967");
        let text = behind.map_or(text, |text| text.trim_start_matches([' ', '-']));
        let letters: String = text.chars().filter(|c| c.is_alphabetic()).collect();
        let digits: String = text.chars().filter(char::is_ascii_digit).collect();
        let written = |first: &str, second: &str| text.split_whitespace().eq([first, second]);
        let joined = [format!("{digits}{letters}"), format!("{letters}{digits}")];
        let whole = joined.iter().any(|joined| joined == text)
            || written(&digits, &letters)
            || written(&letters, &digits);
        let allowance = SERIES.iter().position(|series| *series == letters);
        let tolerance = digits
            .parse()
            .ok()
            .filter(|number| TOLERANCES.contains(number));
        match (whole, allowance, tolerance) {
            (true, Some(allowance), Some(number)) => Ok(ThicknessField {
                allowance,
                tolerance: number - TOLERANCES.start(),
            }),
            _ => Err(GearError::ThicknessField),
        }
    }
}

impl std::fmt::Display for ThicknessField {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let number = self.tolerance + TOLERANCES.start();
        write!(f, "{number}{}", SERIES[self.allowance])
    }
}
