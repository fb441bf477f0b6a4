//! Everything that was measured of one gear, and the gear it means.

use super::error::{MeasurementError, StatementRole};
use super::finding::{Finding, Outlier, Quantity};
use super::notes::{GearNotes, ThicknessStatements};
use super::pitch_statement::PitchStatement;
use super::runout::{Runout, RunoutStatement};
use super::settle::{FlankStatements, Flanks};
use super::statement::ThicknessStatement;
use super::toleranced::Toleranced;
use super::tooth::StatedTooth;
use super::{all_round, contradictions, doubts, first_harmonic, profile};
use crate::error::GearError;
use crate::gear::{AsBuilt, Deviations, Face, Flank, Gear, GearDesign, Modification, Pitch};

/// What was measured of one gear.
///
/// Lengths are mm; deviations, allowance and runout are µm, as inspection sheets print them, and their names say so.
/// `right` and `left` are the gear's own flanks; lists of one value a tooth begin with tooth 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurements {
    /// What the drawing says.
    pub design: GearDesign,
    /// Which way the reference face looks.
    pub face: Face,
    /// The mean tooth thickness.
    pub thickness: ThicknessStatement,
    /// What each tooth is thicker than the mean, µm at the reference circle; may be empty.
    pub per_tooth_um: Vec<f64>,
    /// A second statement of the thickness: compared, and never built.
    pub cross_check: Option<CrossCheck>,
    /// Pitch deviation of both flanks.
    pub pitch: Option<PitchStatement>,
    /// Runout.
    pub runout: RunoutStatement,
    /// Profile deviation of the gear's own right flanks, and of its left ones. A span, a dimension over pins and a pitch are those of the
    /// flanks where they touch; every other thickness is that of their involutes.
    pub profiles: [Modification; 2],
}

/// A second statement of the tooth thickness.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossCheck {
    /// What it states.
    pub statement: ThicknessStatement,
    /// How far the two may lie apart as base thickness, µm.
    pub tolerance_um: f64,
}

impl CrossCheck {
    /// Tuned: two readings of 1 µm each, and what a pin's own diameter adds. Above it lies a slip of a
    /// micrometer's thimble line, 10 µm; below it the rounding of printed lengths, 0.5 µm each.
    pub const TOLERANCE_UM: f64 = 3.0;
}

/// A gear as its measurements say it is.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGear {
    /// The gear, in one or both materials.
    pub as_built: Toleranced<AsBuilt>,
    /// Where its flanks stand beside the mean thickness, and its eccentricity.
    pub deviations: Deviations,
    /// Its runout: as stated, or what its readings hold beside the flanks.
    pub runout: Runout,
    /// Findings about them.
    pub findings: Vec<Finding>,
    /// What the measurements say of each other; for tables and reports.
    pub notes: GearNotes,
}

impl Measurements {
    /// Of a gear of `design` of which nothing was measured: nominal.
    pub fn nominal(design: GearDesign, face: Face) -> Measurements {
        Measurements {
            design,
            face,
            thickness: ThicknessStatement::Nominal,
            per_tooth_um: Vec::new(),
            cross_check: None,
            pitch: None,
            runout: RunoutStatement::None,
            profiles: Default::default(),
        }
    }

    /// The gear that they mean, and what they say of each other.
    ///
    /// # Errors
    /// Everything that no gear has.
    pub fn measure(&self) -> Result<MeasuredGear, Vec<MeasurementError>> {
        let pitch = match self.curves() {
            Ok(pitch) => pitch,
            Err(mut errors) => {
                errors.extend(self.check_thickness_and_runout());
                return Err(errors);
            }
        };
        let of_involutes = self.check_profiles(pitch.as_ref())?;
        let (own, datum) = match (&self.pitch, of_involutes.as_ref()) {
            (Some(statement), Some(curves)) if statement.is_datum() => {
                (None, Some((statement, curves)))
            }
            _ => (of_involutes.clone(), None),
        };
        self.check_per_tooth().map_err(|error| vec![error])?;
        let stated = Deviations {
            per_tooth: self.per_tooth_um.iter().map(|um| um / 1000.0).collect(),
            pitch: own,
            high_tooth: 1.0,
            profiles: self.profiles.clone(),
            ..Deviations::default()
        };
        let gears = self.tooth().gears(&stated).map_err(|error| vec![error])?;
        let mut errors = Vec::new();
        let mut statements = FlankStatements {
            tooth: self.tooth(),
            stated,
            datum,
            runout: self.runout.runout(),
            readings: self.runout.readings(),
        };
        let runout = self.runout.check(&self.design.basic_data);
        if let Err(error) = runout.and_then(|()| statements.runout.check(&gears)) {
            // It is reported; the rest is checked without it.
            errors.push(error);
            (statements.runout, statements.readings) = (Runout::default(), None);
        }
        let gear = statements
            .settle(gears)
            .and_then(|flanks| self.gear(flanks, pitch.as_ref()));
        match gear {
            Ok(gear) if errors.is_empty() => Ok(gear),
            Ok(_) => Err(errors),
            Err(error) => {
                errors.push(error);
                Err(errors)
            }
        }
    }

    /// What is wrong with the thickness and the runout by themselves, where pitch and per-tooth thickness are not understood.
    pub fn check_thickness_and_runout(&self) -> Vec<MeasurementError> {
        let checked = self
            .tooth()
            .gears(&Deviations::default())
            .and_then(|gears| {
                self.runout.check(&self.design.basic_data)?;
                self.runout.runout().check(&gears)
            });
        checked.err().into_iter().collect()
    }

    /// Checks the profiles; gives the pitch of the involutes whose flanks were `measured`.
    fn check_profiles(
        &self,
        measured: Option<&Pitch>,
    ) -> Result<Option<Pitch>, Vec<MeasurementError>> {
        let without = Deviations::default();
        // That there is no such gear is reported of the thickness itself.
        let gears = match self.profiles.iter().all(Modification::is_none) {
            true => None,
            false => self.tooth().gears(&without).ok(),
        };
        let Some(gears) = gears else {
            return Ok(measured.cloned());
        };
        let errors = profile::check(gears.most(), self.face, &self.profiles);
        if !errors.is_empty() {
            return Err(errors);
        }
        let of_involutes = |pitch| profile::of_involutes(pitch, gears.most(), &self.profiles);
        let pitch = measured.map(of_involutes).transpose();
        pitch.map_err(|error| vec![MeasurementError::Pitch(error)])
    }

    fn tooth(&self) -> StatedTooth<'_> {
        StatedTooth {
            design: &self.design,
            statement: &self.thickness,
            role: StatementRole::Counts,
        }
    }

    /// The pitch curves as measured, whose eccentricity counts once.
    fn curves(&self) -> Result<Option<Pitch>, Vec<MeasurementError>> {
        let Some(pitch) = &self.pitch else {
            return Ok(None);
        };
        let curves = pitch.curves(&self.design.basic_data);
        match (curves, pitch.check_eccentricity(&self.runout)) {
            (Ok(curves), Ok(())) => Ok(Some(curves)),
            (curves, once) => Err(curves
                .err()
                .into_iter()
                .flatten()
                .chain(once.err())
                .collect()),
        }
    }

    fn check_per_tooth(&self) -> Result<(), MeasurementError> {
        let teeth = self.design.basic_data.teeth();
        let found = self.per_tooth_um.len();
        if found != 0 && found != teeth as usize {
            return Err(MeasurementError::PerTooth(GearError::WrongLength {
                what: "thickness of each tooth",
                found,
                teeth,
            }));
        }
        match self.per_tooth_um.iter().find(|um| !um.is_finite()) {
            Some(um) => Err(MeasurementError::PerTooth(GearError::OutOfRange {
                what: "per-tooth thickness (µm)",
                value: *um,
                allowed: "a number",
            })),
            None => Ok(()),
        }
    }

    /// The gear with `flanks`, its pitch as `measured`.
    fn gear(
        &self,
        flanks: Flanks,
        measured: Option<&Pitch>,
    ) -> Result<MeasuredGear, MeasurementError> {
        let basic_data = &self.design.basic_data;
        let outliers: Vec<Outlier> = [
            self.thickness
                .outlier(basic_data, &flanks.stated)
                .map(Outlier::Reading),
            self.pitch
                .as_ref()
                .and_then(|pitch| pitch.outlier(basic_data))
                .map(Outlier::Pitch),
        ]
        .into_iter()
        .flatten()
        .collect();
        let mut findings = self.findings(&flanks, measured);
        findings.extend(outliers.iter().copied().map(Finding::Outlier));
        let compared = self.compare(&flanks)?;
        findings.extend(compared.map(Finding::ThicknessStatedTwice));
        let as_built =
            self.tooth()
                .as_built(&flanks.gears, self.face, &flanks.deviations, &outliers)?;
        Ok(MeasuredGear {
            as_built,
            deviations: flanks.deviations,
            runout: flanks.runout,
            findings,
            notes: GearNotes {
                eccentricity: flanks.eccentricity,
                all_round: flanks.all_round,
                thickness: compared,
            },
        })
    }

    fn findings(&self, flanks: &Flanks, measured: Option<&Pitch>) -> Vec<Finding> {
        let basic_data = &self.design.basic_data;
        let per_tooth_um = &self.per_tooth_um;
        let pitch = self.pitch.as_ref().zip(measured);
        let cross_check = self.cross_check.as_ref().map(|check| &check.statement);
        let mut findings = Vec::new();
        findings.extend(self.pitch.iter().flat_map(PitchStatement::open_circles));
        findings.extend_from_slice(&flanks.of_readings);
        findings.extend(flanks.eccentricity.map(Finding::EccentricityInPitch));
        let runout = &flanks.runout;
        if flanks.deviations.any_direction {
            findings.push(Finding::RunoutWithoutDirection {
                total_um: runout.total_um,
            });
        }
        findings.extend(profile::findings(basic_data.teeth(), &self.profiles));
        findings.extend(all_round::finding(&self.thickness, flanks));
        findings.extend(contradictions::findings(
            &self.thickness,
            cross_check,
            pitch,
            flanks,
        ));
        if let ThicknessStatement::Field(field) = &self.thickness
            && let Ok([upper_um, lower_um]) = field.allowances_um(basic_data)
        {
            findings.push(Finding::ThicknessField {
                diameter_mm: 2.0 * basic_data.reference_radius(),
                upper_um,
                lower_um,
            });
        }
        let half_pitch = 0.5 * std::f64::consts::PI * basic_data.module();
        let whole = doubts::looks_like_whole(Quantity::PerTooth, per_tooth_um, half_pitch);
        let off_mean = || doubts::off_mean(&self.thickness, basic_data, per_tooth_um);
        findings.extend(whole.or_else(off_mean));
        findings.extend(doubts::of_allowance(&self.thickness));
        let pitch_um = self.pitch.iter().flat_map(|pitch| {
            let both = Flank::BOTH.map(|flank| pitch.values(flank).iter().copied());
            both.into_iter().flatten()
        });
        let pitch_um: Vec<f64> = pitch_um.collect();
        findings.extend(doubts::looks_like_whole(
            Quantity::Pitch,
            &pitch_um,
            2.0 * half_pitch,
        ));
        findings.extend(cross_check.and_then(|check| doubts::same_kind(&self.thickness, check)));
        findings.extend(pitch.and_then(|(pitch, measured)| {
            let by_readings = self.runout.readings().is_some();
            first_harmonic::finding(pitch, measured, by_readings, flanks)
        }));
        findings
    }

    /// The cross-check beside the statement that counts, of a gear with these `flanks`.
    fn compare(&self, flanks: &Flanks) -> Result<Option<ThicknessStatements>, MeasurementError> {
        let Some(check) = &self.cross_check else {
            return Ok(None);
        };
        let second = StatedTooth {
            design: &self.design,
            statement: &check.statement,
            role: StatementRole::CrossCheck,
        };
        let cross = second.gears(&flanks.deviations)?;
        let range = |gears: &Toleranced<Gear>| {
            [gears.least(), gears.most()].map(|gear| gear.base_thickness())
        };
        Ok(Some(ThicknessStatements::new(
            range(&flanks.gears),
            range(&cross),
            check.tolerance_um,
        )))
    }
}
