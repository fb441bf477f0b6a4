//! The accuracy grades of one gear's own deviations.

use super::{AsBuilt, Grade, Graded, Inspection, Side};
use crate::error::GearError;

/// A deviation of a gear and the accuracy grade that admits it, after [`super::GRADE_SOURCE`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradedValue {
    /// Which deviation.
    pub what: Graded,
    /// The gear's own flank; `None` for runout.
    pub side: Option<Side>,
    /// Its amount, mm.
    pub value: f64,
    /// Its grade.
    pub grade: Grade,
}

impl GradedValue {
    /// Single pitch `f_p` and total cumulative pitch `F_p` of both flanks of `gear`, about its own centre.
    ///
    /// # Errors
    /// As [`Graded::grade`].
    pub fn of_pitch(gear: &AsBuilt) -> Result<Vec<GradedValue>, GearError> {
        let inspection = Inspection::of(gear);
        let single = Side::BOTH.map(|side| {
            let value = inspection.largest_single(side);
            GradedValue::new(gear, Graded::SinglePitch, Some(side), value)
        });
        let total = Side::BOTH.map(|side| {
            let value = inspection.total_cumulative(side);
            GradedValue::new(gear, Graded::TotalPitch, Some(side), value)
        });
        single.into_iter().chain(total).collect()
    }

    /// Runout `F_r = 2 e` of `gear`.
    ///
    /// # Errors
    /// As [`Graded::grade`].
    pub fn of_runout(gear: &AsBuilt) -> Result<GradedValue, GearError> {
        GradedValue::new(gear, Graded::Runout, None, 2.0 * gear.eccentricity())
    }

    fn new(
        gear: &AsBuilt,
        what: Graded,
        side: Option<Side>,
        value: f64,
    ) -> Result<GradedValue, GearError> {
        Ok(GradedValue {
            what,
            side,
            value,
            grade: what.grade(gear.gear().toothing(), value)?,
        })
    }
}
