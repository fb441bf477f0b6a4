//! Accuracy grades of measured pitch and runout, after ISO 1328-1:2013.
//!
//! The formulas come from several open implementations; the standard itself was not consulted. They hold for `5 ≤ z ≤ 1000`,
//! `5 mm ≤ d ≤ 15 000 mm`, normal modules `0.5 mm ≤ m_n ≤ 70 mm` and grades 1 … 11.

use super::BasicGearData;
use crate::error::GearError;
use std::ops::RangeInclusive;

/// Source of the grades, shown beside every one of them.
pub const GRADE_SOURCE: &str = "after ISO 1328-1:2013, formulas as published in several open implementations, standard not consulted";

/// All grades, the finest first.
pub const GRADES: RangeInclusive<u32> = 1..=11;

/// A deviation that a grade limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum GradedQuantity {
    /// Single pitch deviation `f_p`, the largest amount.
    SinglePitch,
    /// Total cumulative pitch deviation `F_p`, the range.
    TotalPitch,
    /// Runout `F_r`.
    Runout,
}

/// A grade with its tolerance, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Grade {
    /// The finest grade that admits the value; the last of all where none does.
    pub grade: u32,
    /// Its tolerance.
    pub tolerance: f64,
    /// Whether it admits the value.
    pub admits: bool,
}

impl Grade {
    /// `5`, or `beyond 11` where no grade admits the value.
    pub fn words(self) -> String {
        let beyond = if self.admits { "" } else { "beyond " };
        format!("{beyond}{}", self.grade)
    }
}

impl GradedQuantity {
    /// All three.
    pub const ALL: [GradedQuantity; 3] = [
        GradedQuantity::SinglePitch,
        GradedQuantity::TotalPitch,
        GradedQuantity::Runout,
    ];

    /// Symbol of the deviation.
    pub fn symbol(self) -> &'static str {
        match self {
            GradedQuantity::SinglePitch => "f_p",
            GradedQuantity::TotalPitch => "F_p",
            GradedQuantity::Runout => "F_r",
        }
    }

    /// Tolerance of `basic_data` at grade `A`, mm, rounded as on a drawing.
    ///
    /// # Errors
    /// [`GearError::OutOfRange`] outside the ranges of the formulas.
    pub fn tolerance(self, basic_data: &BasicGearData, grade: u32) -> Result<f64, GearError> {
        Ok(rounded(self.unrounded(basic_data, grade)?) / 1e3)
    }

    /// The grade of `measured`, mm. A value equal to a tolerance is within it, whatever the rounding from µm to mm.
    ///
    /// # Errors
    /// As [`GradedQuantity::tolerance`].
    pub fn grade(self, basic_data: &BasicGearData, measured: f64) -> Result<Grade, GearError> {
        // The conversion rounds once, by half a unit in the last place at most.
        let least = measured * (1.0 - f64::EPSILON);
        let mut grade = *GRADES.start();
        let mut tolerance = self.tolerance(basic_data, grade)?;
        while !(least <= tolerance) && grade < *GRADES.end() {
            grade += 1;
            tolerance = self.tolerance(basic_data, grade)?;
        }
        Ok(Grade {
            grade,
            tolerance,
            admits: least <= tolerance,
        })
    }

    /// Tolerance before rounding, µm: `f_pT = (0.001 d + 0.4 m_n + 5) √2^(A−5)`, `F_pT = (0.002 d + 0.55 √d + 0.7 m_n + 12) √2^(A−5)`,
    /// `F_rT = 0.9 F_pT`, with `d` and the normal module `m_n` in mm.
    fn unrounded(self, basic_data: &BasicGearData, grade: u32) -> Result<f64, GearError> {
        let d = 2.0 * basic_data.reference_radius();
        let module = basic_data.module();
        let within = |what, value: f64, range: RangeInclusive<f64>, allowed| {
            GearError::require(range.contains(&value), what, value, allowed)
        };
        let teeth = f64::from(basic_data.teeth());
        within("teeth, to be graded,", teeth, 5.0..=1000.0, "5 … 1000")?;
        within(
            "reference diameter, to be graded,",
            d,
            5.0..=15_000.0,
            "5 … 15 000 mm",
        )?;
        within("module, to be graded,", module, 0.5..=70.0, "0.5 … 70 mm")?;
        within("accuracy grade", f64::from(grade), 1.0..=11.0, "1 … 11")?;
        let step = 2f64.sqrt().powf(f64::from(grade) - 5.0);
        let total = (0.002 * d + 0.55 * d.sqrt() + 0.7 * module + 12.0) * step;
        Ok(match self {
            GradedQuantity::SinglePitch => (0.001 * d + 0.4 * module + 5.0) * step,
            GradedQuantity::TotalPitch => total,
            GradedQuantity::Runout => 0.9 * total,
        })
    }
}

/// Rounds to 1 µm above 10 µm, to 0.5 µm above 5 µm, else to 0.1 µm.
fn rounded(um: f64) -> f64 {
    if um > 10.0 {
        um.round()
    } else if um > 5.0 {
        (2.0 * um).round() / 2.0
    } else {
        (10.0 * um).round() / 10.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule of rounding at its borders.
    #[test]
    fn rounds_by_size() {
        for (um, shown) in [
            (4.94, 4.9),
            (5.0, 5.0),
            (5.2, 5.0),
            (5.26, 5.5),
            (9.74, 9.5),
            (10.2, 10.0),
            (10.5, 11.0),
        ] {
            assert_eq!(rounded(um), shown, "{um}");
        }
    }

    #[test]
    fn refuses_what_the_formulas_do_not_cover() {
        let data = |teeth, module| BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap();
        for (teeth, module) in [(4, 3.0), (1001, 1.0), (5, 0.9), (300, 60.0), (40, 0.4)] {
            for graded in GradedQuantity::ALL {
                let tolerance = graded.tolerance(&data(teeth, module), 6);
                assert!(tolerance.is_err(), "{teeth} {module}");
            }
        }
        for grade in [0, 12] {
            assert!(
                GradedQuantity::Runout
                    .tolerance(&data(40, 3.0), grade)
                    .is_err()
            );
        }
    }
}
