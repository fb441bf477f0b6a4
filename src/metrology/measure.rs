//! The measurements of one gear, and the gear built from them.

use super::error::{MeasurementError, StatementRole};
use super::finding::{Finding, GearNotes, Outlier, Quantity, ThicknessStatements};
use super::pitch_statement::PitchStatement;
use super::runout::{Runout, RunoutStatement};
use super::settle::{FlankStatements, Flanks, StatedTooth};
use super::thickness_statement::{ThicknessStatement, Toleranced};
use super::wobble::Wobble;
use super::{contradictions, datum_leads, lead, outliers, plausibility, profile};
use crate::error::GearError;
use crate::gear::{AsBuilt, Deviations, Face, Flank, Gear, GearDesign, Lead, Modification, Pitch};

/// The measurements of one gear.
///
/// Lengths are mm; deviations, allowance and runout are µm, as inspection sheets print them, and their names say so.
/// `right` and `left` are the gear's own flanks; lists of one value a tooth begin with tooth 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurements {
    /// The design.
    pub design: GearDesign,
    /// Orientation of the reference face.
    pub face: Face,
    /// The mean tooth thickness.
    pub thickness: ThicknessStatement,
    /// Thickness of each tooth beyond the mean, µm at the reference circle; may be empty.
    pub per_tooth_um: Vec<f64>,
    /// A second thickness statement, for comparison only.
    pub cross_check: Option<CrossCheck>,
    /// Pitch deviation of both flanks.
    pub pitch: Option<PitchStatement>,
    /// Runout.
    pub runout: RunoutStatement,
    /// Lean of the teeth's axis.
    pub wobble: Wobble,
    /// Profile deviations of the gear's own right flanks and of its left ones.
    ///
    /// A span, a dimension over pins and a pitch belong to the flanks at the contacts; other thickness statements to the involutes.
    pub profiles: [Modification; 2],
    /// Lead deviations of the gear's own right flanks and of its left ones.
    pub leads: [Lead; 2],
    /// Whether the traces of the leads were measured about the datum axis: they contain the wobble.
    pub leads_about_datum: bool,
}

/// A second statement of the tooth thickness.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossCheck {
    /// The statement.
    pub statement: ThicknessStatement,
    /// Greatest difference of both base thicknesses, µm.
    pub tolerance_um: f64,
}

impl CrossCheck {
    /// Default tolerance. Tuned: two readings of 1 µm each, and the error of a pin's diameter. A slip of a micrometer's thimble line
    /// is 10 µm; the rounding of printed lengths is 0.5 µm each.
    pub const TOLERANCE_UM: f64 = 3.0;
}

/// A gear built from its measurements.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGear {
    /// The gear, in one or both materials.
    pub as_built: Toleranced<AsBuilt>,
    /// Deviations of the flanks beside the mean thickness, and the eccentricity.
    pub deviations: Deviations,
    /// The runout: as stated, or fitted to its readings.
    pub runout: Runout,
    /// Findings about the measurements.
    pub findings: Vec<Finding>,
    /// Comparisons of the measurements, for tables and reports.
    pub notes: GearNotes,
}

impl Measurements {
    /// A nominal gear of `design` without measurements.
    pub fn nominal(design: GearDesign, face: Face) -> Measurements {
        Measurements {
            design,
            face,
            thickness: ThicknessStatement::Nominal,
            per_tooth_um: Vec::new(),
            cross_check: None,
            pitch: None,
            runout: RunoutStatement::None,
            wobble: Wobble::default(),
            profiles: Default::default(),
            leads: Default::default(),
            leads_about_datum: false,
        }
    }

    /// Builds the gear and collects the findings.
    ///
    /// # Errors
    /// All errors in the measurements.
    pub fn measure(&self) -> Result<MeasuredGear, Vec<MeasurementError>> {
        let pitch = match self.curves() {
            Ok(pitch) => pitch,
            Err(mut errors) => {
                errors.extend(self.check_thickness_and_runout());
                return Err(errors);
            }
        };
        self.check_leads()?;
        if self.leads_about_datum {
            return self.measure_about_datum();
        }
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
            wobble: self.wobble.lean,
            wobble_tooth: self.wobble.tooth,
            profiles: self.profiles.clone(),
            leads: self.leads.clone(),
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
            // Report it and check the rest without runout.
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

    /// As [`Measurements::measure`], with leads about the datum axis. A stated wobble counts, else that of the leads.
    fn measure_about_datum(&self) -> Result<MeasuredGear, Vec<MeasurementError>> {
        let found = datum_leads::separate(&self.design, &self.leads, &self.runout);
        let (found, leads) = found.map_err(|error| vec![error])?;
        let is_stated = self.wobble.lean > 0.0;
        let own = Measurements {
            leads,
            leads_about_datum: false,
            wobble: if is_stated { self.wobble } else { found },
            ..self.clone()
        };
        let mut gear = own.measure()?;
        let [near, far] = self.leads.each_ref().map(|lead| lead.face)[0];
        let over_um = 1000.0 * (far - near);
        let apart = self.wobble.apart(&found, &self.design.basic_data);
        gear.findings.push(Finding::WobbleInLeads {
            um: over_um * found.lean,
            tooth: found.tooth,
            apart_um: is_stated.then_some(over_um * apart),
        });
        Ok(gear)
    }

    /// Errors of the thickness and the runout alone, for invalid pitch or per-tooth thickness.
    pub fn check_thickness_and_runout(&self) -> Vec<MeasurementError> {
        let gears = self.tooth().gears(&Deviations::default());
        let checked = gears.and_then(|gears| {
            self.runout.check(&self.design.basic_data)?;
            self.runout.runout().check(&gears)
        });
        checked.err().into_iter().collect()
    }

    /// Checks the profiles and returns the pitch of the involutes of the `measured` flanks.
    fn check_profiles(
        &self,
        measured: Option<&Pitch>,
    ) -> Result<Option<Pitch>, Vec<MeasurementError>> {
        let without = Deviations::default();
        // An impossible gear is an error of the thickness.
        let gears = if self.profiles.iter().all(Modification::is_none) {
            None
        } else {
            self.tooth().gears(&without).ok()
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

    /// Checks the leads.
    fn check_leads(&self) -> Result<(), Vec<MeasurementError>> {
        if self.leads.iter().all(Lead::is_none) {
            return Ok(());
        }
        // An impossible gear is an error of the thickness.
        let gears = self.tooth().gears(&Deviations::default());
        let errors = gears.map_or_else(
            |_| Vec::new(),
            |gears| lead::check(gears.most(), self.face, &self.leads),
        );
        if errors.is_empty() {
            Ok(())
        } else {
            Err(errors)
        }
    }

    fn tooth(&self) -> StatedTooth<'_> {
        StatedTooth {
            design: &self.design,
            statement: &self.thickness,
            role: StatementRole::Counts,
        }
    }

    /// The pitch curves as measured. Checks that the eccentricity counts once.
    fn curves(&self) -> Result<Option<Pitch>, Vec<MeasurementError>> {
        let Some(pitch) = &self.pitch else {
            return Ok(None);
        };
        let curves = pitch.curves(&self.design.basic_data);
        match (curves, pitch.check_eccentricity(&self.runout)) {
            (Ok(curves), Ok(())) => Ok(Some(curves)),
            (curves, once) => {
                let errors = curves.err().unwrap_or_default();
                Err(errors.into_iter().chain(once.err()).collect())
            }
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
        let check = |&um: &f64| {
            GearError::require(um.is_finite(), "per-tooth thickness (µm)", um, "a number")
        };
        let checked = self.per_tooth_um.iter().try_for_each(check);
        checked.map_err(MeasurementError::PerTooth)
    }

    /// The gear with `flanks`. `measured` is its pitch as measured.
    fn gear(
        &self,
        flanks: Flanks,
        measured: Option<&Pitch>,
    ) -> Result<MeasuredGear, MeasurementError> {
        let basic_data = &self.design.basic_data;
        let reading = outliers::of_readings(&self.thickness, basic_data, &flanks.stated);
        let of_pitch = |pitch| outliers::of_pitch(pitch, basic_data);
        let pitch = self.pitch.as_ref().and_then(of_pitch);
        let outliers = reading.map(Outlier::Reading).into_iter();
        let outliers: Vec<Outlier> = outliers.chain(pitch.map(Outlier::Pitch)).collect();
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
        let teeth = basic_data.teeth();
        let profiles = self.profiles.each_ref().map(|profile| &profile.traces[..]);
        let of_some = profile::of_some_teeth(teeth, profiles);
        findings.extend(of_some.map(Finding::ProfileOfSomeTeeth));
        let leads = self.leads.each_ref().map(|lead| &lead.traces[..]);
        let of_some = profile::of_some_teeth(teeth, leads);
        findings.extend(of_some.map(Finding::LeadOfSomeTeeth));
        findings.extend(plausibility::readings_all_round(&self.thickness, flanks));
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
        let whole = plausibility::looks_like_whole(Quantity::PerTooth, per_tooth_um, half_pitch);
        let off_mean = || plausibility::off_mean(&self.thickness, basic_data, per_tooth_um);
        findings.extend(whole.or_else(off_mean));
        findings.extend(plausibility::of_allowance(
            &self.thickness,
            1000.0 * basic_data.module(),
        ));
        let pitch_um = self.pitch.iter().flat_map(|pitch| {
            let both = Flank::BOTH.map(|flank| pitch.values(flank).iter().copied());
            both.into_iter().flatten()
        });
        let pitch_um: Vec<f64> = pitch_um.collect();
        findings.extend(plausibility::looks_like_whole(
            Quantity::Pitch,
            &pitch_um,
            2.0 * half_pitch,
        ));
        findings
            .extend(cross_check.and_then(|check| plausibility::same_kind(&self.thickness, check)));
        findings.extend(pitch.and_then(|(pitch, measured)| {
            let by_readings = self.runout.readings().is_some();
            contradictions::first_harmonic(pitch, measured, by_readings, flanks)
        }));
        findings
    }

    /// Comparison of thickness statement and cross-check for a gear with these `flanks`.
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
