//! The gear that a design and a statement of its tooth thickness mean.

use super::error::{DeviationCause, Fits, MeasurementError, StatementRole};
use super::finding::Outlier;
use super::statement::ThicknessStatement;
use super::toleranced::Toleranced;
use crate::error::GearError;
use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, thickness};

/// A design and one statement of its tooth thickness.
#[derive(Debug, Clone, Copy)]
pub(super) struct StatedTooth<'a> {
    pub design: &'a GearDesign,
    pub statement: &'a ThicknessStatement,
    pub role: StatementRole,
}

impl StatedTooth<'_> {
    /// The gear in one or both materials, its thickness measurement checked against it.
    ///
    /// `known` is what its readings contain beside the mean thickness.
    pub(super) fn gears(&self, known: &Deviations) -> Result<Toleranced<Gear>, MeasurementError> {
        let design = self.design;
        let no_gear = |error| MeasurementError::NoGear {
            role: self.role,
            error,
            suspects: self.suspects(known),
        };
        let round = design.rack.check_tip_round(&design.basic_data);
        round.map_err(no_gear)?;
        let base = self.statement.base_thickness(design, known);
        let base = base.map_err(|error| MeasurementError::Thickness {
            role: self.role,
            error,
        })?;
        let gears = base.try_map(|&base| Gear::new(*design, base));
        let gears = gears.map_err(no_gear)?;
        gears.try_map(|gear| {
            let check = self.statement.check(gear);
            check.map_err(|error| self.off_involute(error, gear, known))
        })?;
        Ok(gears)
    }

    /// The gears with `deviations`.
    pub(super) fn as_built(
        &self,
        gears: &Toleranced<Gear>,
        face: Face,
        deviations: &Deviations,
        suspects: &[Outlier],
    ) -> Result<Toleranced<AsBuilt>, MeasurementError> {
        gears.try_map(|gear| {
            AsBuilt::new(gear.clone(), face, deviations).map_err(|error| {
                let thickness_alone = Deviations {
                    pitch: None,
                    ..deviations.clone()
                };
                let profiles_alone = Deviations {
                    profiles: deviations.profiles.clone(),
                    ..Deviations::default()
                };
                let by_spans = matches!(self.statement, ThicknessStatement::SpanReadings { .. });
                let profiles = AsBuilt::new(gear.clone(), face, &profiles_alone);
                let cause = match AsBuilt::new(gear.clone(), face, &thickness_alone) {
                    Err(_) if profiles.is_err() => DeviationCause::Profile,
                    Err(_) if by_spans => DeviationCause::Spans,
                    Err(_) => DeviationCause::PerTooth,
                    Ok(_) => DeviationCause::Pitch,
                };
                MeasurementError::Deviations {
                    error,
                    cause,
                    suspects: suspects.to_vec(),
                }
            })
        })
    }

    fn suspects(&self, known: &Deviations) -> Vec<Outlier> {
        let outlier = self.statement.outlier(&self.design.basic_data, known);
        outlier.map(Outlier::Reading).into_iter().collect()
    }

    fn off_involute(&self, error: GearError, gear: &Gear, known: &Deviations) -> MeasurementError {
        let by_span = matches!(
            self.statement,
            ThicknessStatement::Span { .. } | ThicknessStatement::SpanReadings { .. }
        );
        MeasurementError::OffInvolute {
            role: self.role,
            error,
            fits: match by_span {
                true => Fits::Spans(fitting_spans(gear)),
                false => Fits::Pin(fitting_pin(gear)),
            },
            suspects: match by_span {
                true => self.suspects(known),
                false => Vec::new(),
            },
        }
    }
}

/// The least and the greatest number of teeth whose span touches the involutes of `gear`.
fn fitting_spans(gear: &Gear) -> Option<(u32, u32)> {
    let fits = |teeth: &u32| thickness::check_span(gear, *teeth).is_ok();
    let teeth = gear.basic_data().teeth();
    Some(((2..=teeth).find(fits)?, (2..=teeth).rev().find(fits)?))
}

/// The diameter of a pin that touches the involutes of `gear`, mm.
fn fitting_pin(gear: &Gear) -> Option<f64> {
    let (form, tip) = (gear.form_roll(), gear.tip_roll());
    // Halfway up the involute first; a pin that touches higher is larger and stands out further.
    [0.5, 0.6, 0.7, 0.8, 0.9]
        .map(|part| {
            let roll = form + part * (tip - form);
            thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness())
        })
        .into_iter()
        .find(|&pin| pin > 0.0 && thickness::check_pins(gear, pin).is_ok())
}
