//! The flanks of a gear as its measurements state them, and the mean thickness that goes with them.

use super::eccentricity;
use super::error::MeasurementError;
use super::finding::{Finding, FlankKnowledge};
use super::notes::{AllRoundNote, Eccentricity, EccentricityNote};
use super::pitch_statement::{EccentricitySource, PitchStatement};
use super::runout::{ProbeReadings, Runout};
use super::runout_fit::ReadingsFit;
use super::toleranced::Toleranced;
use super::tooth::StatedTooth;
use crate::gear::{Deviations, Gear, Pitch};

/// What measurements say of the flanks.
pub(super) struct FlankStatements<'a> {
    pub tooth: StatedTooth<'a>,
    /// Stated thickness of each tooth beyond the mean and pitch free of eccentricity.
    pub stated: Deviations,
    /// Pitch about the datum axis, and its curves.
    pub datum: Option<(&'a PitchStatement, &'a Pitch)>,
    /// As stated; of readings that are not yet fitted, their range.
    pub runout: Runout,
    pub readings: Option<&'a ProbeReadings>,
}

/// The gear in one or both materials, and where its flanks stand.
pub(super) struct Flanks {
    pub gears: Toleranced<Gear>,
    /// What is stated, the eccentricity taken out of the pitch; without what spans add.
    pub stated: Deviations,
    /// All there is.
    pub deviations: Deviations,
    pub eccentricity: Option<EccentricityNote>,
    pub all_round: Option<AllRoundNote>,
    /// As stated, or as its readings say beside all that is known.
    pub runout: Runout,
    /// The eccentricity that the runout shows by itself.
    pub in_runout: Option<Eccentricity>,
    /// Findings about its readings.
    pub of_readings: Vec<Finding>,
}

/// Each round of mean thickness and eccentricity leaves about `e/r` of the error.
const MOST_ROUNDS: usize = 50;

impl FlankStatements<'_> {
    /// Of datum-axis pitch the eccentricity is taken out, which takes the mean thickness (where on a tooth its
    /// flanks stand); readings all round give the mean thickness once the pitch is known. So the two take turns, beginning
    /// with the `gears` of what is stated without that pitch.
    pub(super) fn settle(self, mut gears: Toleranced<Gear>) -> Result<Flanks, MeasurementError> {
        let basic_data = &self.tooth.design.basic_data;
        let counts = self.datum.and_then(|(pitch, _)| pitch.eccentricity);
        let mut runout = self.runout;
        let mut stated = self.stated;
        // Without the pitch, from which it is to be taken out.
        let mut fit = fitted(self.readings, &mut runout, &gears, &stated)?;
        let mut in_pitch = None;
        if let Some((_, readings)) = self.datum {
            // Rounding of the thickness is some ulps of the radius.
            let rounding = 1e-13 * basic_data.reference_radius();
            let mut settled = false;
            for _ in 0..MOST_ROUNDS {
                let parts = eccentricity::separate(readings, gears.most(), counts, &runout);
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
            deviations.per_tooth.resize(found.thickness.len(), 0.0);
            for (thickness, more) in deviations.per_tooth.iter_mut().zip(&found.thickness) {
                *thickness += more;
            }
        }
        let by_runout = counts == Some(EccentricitySource::Runout);
        if !by_runout {
            fit = fitted(self.readings, &mut runout, &gears, &deviations)?;
        }
        let of_readings = match (&fit, self.readings) {
            (Some(fit), Some(readings)) => {
                let knowledge = match (&deviations.pitch, by_runout) {
                    (None, _) => FlankKnowledge::NoPitch,
                    (Some(_), false) => FlankKnowledge::Pitch,
                    (Some(_), true) => FlankKnowledge::DatumPitch,
                };
                let all = match by_runout {
                    true => ReadingsFit::new(readings, gears.most(), &deviations)?.fit,
                    false => fit.fit.clone(),
                };
                fit.findings(knowledge, &all)
            }
            _ => Vec::new(),
        };
        let note = in_pitch.map(|found| eccentricity::beside(found, counts, &runout, basic_data));
        let (eccentricity, high_tooth) = match note.filter(|note| !note.stated_counts) {
            Some(note) => (note.in_pitch.um / 1000.0, Some(note.in_pitch.high_tooth)),
            None => (runout.eccentricity(), runout.high_tooth),
        };
        for all in [&mut stated, &mut deviations] {
            all.eccentricity = eccentricity;
            all.high_tooth = high_tooth.unwrap_or(1.0);
            all.any_direction = eccentricity > 0.0 && high_tooth.is_none();
        }
        Ok(Flanks {
            gears,
            stated,
            deviations,
            eccentricity: note,
            all_round: self
                .tooth
                .statement
                .readings()
                .map(|readings| AllRoundNote {
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

/// Gives `runout` the eccentricity that its readings hold beside what is `known`, if it has readings.
fn fitted(
    readings: Option<&ProbeReadings>,
    runout: &mut Runout,
    gears: &Toleranced<Gear>,
    known: &Deviations,
) -> Result<Option<ReadingsFit>, MeasurementError> {
    let Some(readings) = readings else {
        return Ok(None);
    };
    let fit = ReadingsFit::new(readings, gears.most(), known)?;
    *runout = Runout::fitted(fit.fit.eccentricity, fit.fit.high_tooth);
    runout.check(gears)?;
    Ok(Some(fit))
}
