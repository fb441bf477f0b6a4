//! Mean thickness and flanks of a gear, solved together from its measurements.

use super::error::{DeviationCause, Fits, MeasurementError, StatementRole};
use super::finding::{
    AllRoundNote, Eccentricity, EccentricityNote, Finding, FlankKnowledge, Outlier,
};
use super::outliers;
use super::pitch_statement::{EccentricitySource, PitchStatement};
use super::runout::{ProbeReadings, ReadingsFit, Runout};
use super::thickness_statement::{ThicknessStatement, Toleranced};
use crate::error::GearError;
use crate::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Pitch, separate_eccentricity,
    thickness, without_eccentricity,
};

/// A design and one statement of its tooth thickness.
#[derive(Debug, Clone, Copy)]
pub(super) struct StatedTooth<'a> {
    pub design: &'a GearDesign,
    pub statement: &'a ThicknessStatement,
    pub role: StatementRole,
}

impl StatedTooth<'_> {
    /// The gear at one or both limits of the thickness, checked for contact on the involute.
    ///
    /// `known` are the deviations in its readings.
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
                let fails = |alone| AsBuilt::new(gear.clone(), face, &alone).is_err();
                let none = Deviations::default;
                let Deviations {
                    profiles, leads, ..
                } = deviations.clone();
                let cause = if !fails(Deviations {
                    pitch: None,
                    ..deviations.clone()
                }) {
                    DeviationCause::Pitch
                } else if fails(Deviations { profiles, ..none() }) {
                    DeviationCause::Profile
                } else if fails(Deviations { leads, ..none() }) {
                    DeviationCause::Lead
                } else if matches!(self.statement, ThicknessStatement::SpanReadings { .. }) {
                    DeviationCause::Spans
                } else {
                    DeviationCause::PerTooth
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
        let outlier = outliers::of_readings(self.statement, &self.design.basic_data, known);
        outlier.map(Outlier::Reading).into_iter().collect()
    }

    fn off_involute(&self, error: GearError, gear: &Gear, known: &Deviations) -> MeasurementError {
        let (fits, suspects) = match self.statement {
            ThicknessStatement::Span { .. } | ThicknessStatement::SpanReadings { .. } => {
                (Fits::Spans(fitting_spans(gear)), self.suspects(known))
            }
            ThicknessStatement::Chord { .. } => (Fits::Chord, Vec::new()),
            _ => (Fits::Pin(fitting_pin(gear)), Vec::new()),
        };
        MeasurementError::OffInvolute {
            role: self.role,
            error,
            fits,
            suspects,
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

/// Statements about the flanks.
pub(super) struct FlankStatements<'a> {
    pub tooth: StatedTooth<'a>,
    /// Stated per-tooth thickness, and pitch free of eccentricity.
    pub stated: Deviations,
    /// Datum-axis pitch with its curves.
    pub datum: Option<(&'a PitchStatement, &'a Pitch)>,
    /// The runout as stated; for readings their range, before the fit.
    pub runout: Runout,
    pub readings: Option<&'a ProbeReadings>,
}

/// The gear at one or both limits of the thickness, with its flanks.
pub(super) struct Flanks {
    pub gears: Toleranced<Gear>,
    /// The stated deviations, with the eccentricity removed from the pitch, without the thickness from spans.
    pub stated: Deviations,
    /// All deviations.
    pub deviations: Deviations,
    pub eccentricity: Option<EccentricityNote>,
    pub all_round: Option<AllRoundNote>,
    /// The runout as stated, or fitted to its readings.
    pub runout: Runout,
    /// The eccentricity in the runout alone.
    pub in_runout: Option<Eccentricity>,
    /// Findings about the runout readings.
    pub of_readings: Vec<Finding>,
}

/// Most rounds; each leaves about `e/r` of the error.
const MOST_ROUNDS: usize = 50;

impl FlankStatements<'_> {
    /// Solves mean thickness and eccentricity in turns.
    ///
    /// Removing the eccentricity from datum-axis pitch needs the mean thickness, and readings all round need the pitch. The iteration
    /// starts with `gears` without that pitch.
    pub(super) fn settle(self, mut gears: Toleranced<Gear>) -> Result<Flanks, MeasurementError> {
        let basic_data = &self.tooth.design.basic_data;
        let counts = self.datum.and_then(|(pitch, _)| pitch.eccentricity);
        let mut runout = self.runout;
        let mut stated = self.stated;
        // The fit without the datum-axis pitch.
        let mut fit = fit_readings(self.readings, &mut runout, &gears, &stated)?;
        let mut in_pitch = None;
        if let Some((_, readings)) = self.datum {
            // Rounding of the thickness is some ulps of the radius.
            let rounding = 1e-13 * basic_data.reference_radius();
            let mut settled = false;
            for _ in 0..MOST_ROUNDS {
                let parts = separate_pitch(readings, gears.most(), counts, &runout);
                let (pitch, found) = parts.map_err(MeasurementError::DatumPitch)?;
                stated.pitch = Some(pitch);
                in_pitch = Some(found);
                let next = self.tooth.gears(&stated)?;
                let change = next.most().base_thickness() - gears.most().base_thickness();
                gears = next;
                if change.abs() <= rounding {
                    settled = true;
                    break;
                }
            }
            if !settled {
                return Err(MeasurementError::NotSettled);
            }
        }
        let found = self.tooth.statement.per_tooth(gears.most(), &stated);
        let found = found.map_err(MeasurementError::PerTooth)?;
        let mut deviations = stated.clone();
        if let Some(found) = &found {
            deviations.thicken(&found.thickness);
        }
        let by_runout = counts == Some(EccentricitySource::Runout);
        if !by_runout {
            fit = fit_readings(self.readings, &mut runout, &gears, &deviations)?;
        }
        let note = in_pitch.map(|found| eccentricity_note(found, counts, &runout, basic_data));
        let of_readings = match (&fit, self.readings) {
            (Some(fit), Some(readings)) => {
                let knowledge = match (&deviations.pitch, by_runout) {
                    (None, _) => FlankKnowledge::NoPitch,
                    (Some(_), false) => FlankKnowledge::Pitch,
                    (Some(_), true) => FlankKnowledge::DatumPitch,
                };
                let all = if by_runout {
                    ReadingsFit::new(readings, gears.most(), &deviations)?.fit
                } else {
                    fit.fit.clone()
                };
                fit.findings(knowledge, &all, note.as_ref())
            }
            _ => Vec::new(),
        };
        let (eccentricity, high_tooth) = match note.filter(|note| !note.stated_counts) {
            Some(note) => (note.in_pitch.um / 1000.0, Some(note.in_pitch.high_tooth)),
            None => (runout.eccentricity(), runout.high_tooth),
        };
        for all in [&mut stated, &mut deviations] {
            all.eccentricity = eccentricity;
            all.high_tooth = high_tooth.unwrap_or(1.0);
            all.any_direction = eccentricity > 0.0 && high_tooth.is_none();
        }
        let readings = self.tooth.statement.readings();
        Ok(Flanks {
            gears,
            stated,
            deviations,
            eccentricity: note,
            all_round: readings.map(|readings| AllRoundNote {
                readings: readings.len(),
                amplification: found.map(|found| found.amplification),
            }),
            in_runout: match &fit {
                Some(fit) => fit.first_harmonic(),
                None => runout.stated(),
            },
            runout,
            of_readings,
        })
    }
}

/// Fits the eccentricity of the readings, if any, beside the `known` deviations, and stores it in `runout`.
fn fit_readings(
    readings: Option<&ProbeReadings>,
    runout: &mut Runout,
    gears: &Toleranced<Gear>,
    known: &Deviations,
) -> Result<Option<ReadingsFit>, MeasurementError> {
    let Some(readings) = readings else {
        return Ok(None);
    };
    let fit = ReadingsFit::new(readings, gears.most(), known)?;
    *runout = Runout::new(2000.0 * fit.fit.eccentricity, fit.fit.high_tooth);
    runout.check(gears)?;
    Ok(Some(fit))
}

/// Own pitch of `gear` and eccentricity, separated from datum-axis `readings`.
fn separate_pitch(
    readings: &Pitch,
    gear: &Gear,
    counts: Option<EccentricitySource>,
    runout: &Runout,
) -> Result<(Pitch, Eccentricity), GearError> {
    let separated = separate_eccentricity(readings, gear)?;
    let in_pitch = Eccentricity::new(separated.eccentricity, separated.high_tooth);
    let pitch = match runout.stated() {
        Some(stated) if counts == Some(EccentricitySource::Runout) => {
            without_eccentricity(readings, gear, runout.eccentricity(), stated.high_tooth)?
        }
        _ => separated.pitch,
    };
    Ok((pitch, in_pitch))
}

/// Comparison of the eccentricity `in_pitch` with that of `runout`.
fn eccentricity_note(
    in_pitch: Eccentricity,
    counts: Option<EccentricitySource>,
    runout: &Runout,
    basic_data: &BasicGearData,
) -> EccentricityNote {
    let stated = counts.and(runout.stated());
    EccentricityNote {
        in_pitch,
        is_alone: runout.total_um == 0.0,
        stated,
        stated_counts: counts == Some(EccentricitySource::Runout),
        difference_um: stated.map(|stated| in_pitch.distance_um(&stated, basic_data)),
        reversal: stated.and_then(|stated| stated.reversal(&in_pitch, basic_data)),
    }
}
