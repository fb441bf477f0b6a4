//! Profile deviations as stated: whether a gear can have them, and what else they mean.
//!
//! A stated span, a dimension over pins and a pitch are those of the flanks where they touch. What these stand out there, as an involute
//! would, is taken out of the reading ([`crate::gear::Excess`]); it depends, weakly, on the thickness that is sought, so the two take turns.
//! Allowance and base thickness are of the involute without its deviations, and so is the nominal thickness.

use super::error::{MeasurementError, ProfileKey};
use super::finding::Finding;
use super::statement::ThicknessStatement;
use super::toleranced::Toleranced;
use crate::error::GearError;
use crate::gear::{
    AsBuilt, BasicGearData, Deviations, Excess, Face, Flank, FlankShifts, Gear, GearDesign,
    Modification, PerTooth, Pitch, Spans,
};

/// How far an evaluation range may reach beyond the flank, mm: diameters come rounded to 1 µm.
const ROUNDED: f64 = 1e-3;
/// Part of a radius below which thickness has settled: some ulps.
const ROUNDING: f64 = 1e-14;
/// Each round of thickness and excess leaves about a hundredth of the error.
const MOST_ROUNDS: usize = 30;

/// What is wrong with `profiles` on `gear`, each key by itself.
pub(super) fn check(
    gear: &Gear,
    face: Face,
    profiles: &[Modification; 2],
) -> Vec<MeasurementError> {
    let mut errors = Vec::new();
    for (index, (flank, profile)) in Flank::BOTH.into_iter().zip(profiles).enumerate() {
        let fault = |key, error| MeasurementError::Profile { flank, key, error };
        if let Err(error) = check_range(gear, profile) {
            errors.push(fault(ProfileKey::Range, error));
            continue;
        }
        let none = Modification {
            range: profile.range,
            ..Modification::default()
        };
        let parts = [
            (
                ProfileKey::Slope,
                Modification {
                    slope: profile.slope,
                    ..none.clone()
                },
            ),
            (
                ProfileKey::Crowning,
                Modification {
                    crowning: profile.crowning,
                    ..none.clone()
                },
            ),
            (
                ProfileKey::TipRelief,
                Modification {
                    tip_relief: profile.tip_relief,
                    ..none.clone()
                },
            ),
            (
                ProfileKey::RootRelief,
                Modification {
                    root_relief: profile.root_relief,
                    ..none.clone()
                },
            ),
            (
                ProfileKey::Trace,
                Modification {
                    traces: profile.traces.clone(),
                    ..none
                },
            ),
        ];
        let before = errors.len();
        let all = (ProfileKey::All, profile.clone());
        for (key, part) in parts.into_iter().chain([all]) {
            if key == ProfileKey::All && errors.len() > before {
                break;
            }
            let mut alone = Deviations::default();
            alone.profiles[index] = part;
            let built = alone.profiles[index]
                .curves(gear)
                .and_then(|_| AsBuilt::new(gear.clone(), face, &alone));
            errors.extend(built.err().map(|error| fault(key, error)));
        }
    }
    errors
}

fn check_range(gear: &Gear, profile: &Modification) -> Result<(), GearError> {
    let Some([start, end]) = profile.range else {
        return Ok(());
    };
    let fault = |what, radius: f64, allowed| {
        Err(GearError::OutOfRange {
            what,
            value: 2.0 * radius,
            allowed,
        })
    };
    if !(start >= gear.form_radius() - 0.5 * ROUNDED) {
        let allowed = "the root form diameter or more";
        return fault("start of the evaluation range (mm)", start, allowed);
    }
    if !(end <= gear.tip_radius() + 0.5 * ROUNDED && end > start) {
        let allowed = "above its start, up to the tip diameter";
        return fault("end of the evaluation range (mm)", end, allowed);
    }
    Ok(())
}

/// Teeth without a trace, which take the mean.
pub(super) fn findings(teeth: u32, profiles: &[Modification; 2]) -> Vec<Finding> {
    let of_flank = |(flank, profile): (Flank, &Modification)| {
        let traces = profile.traces.iter();
        let measured = traces.filter(|trace| trace.tooth.is_some()).count() as u32;
        (measured > 0 && measured < teeth).then_some(Finding::ProfileOfSomeTeeth {
            flank,
            measured,
            teeth,
        })
    };
    Flank::BOTH
        .into_iter()
        .zip(profiles)
        .filter_map(of_flank)
        .collect()
}

/// The pitch of the involutes of flanks whose `pitch` was measured on the reference circle.
///
/// # Errors
/// As [`Modification::curves`].
pub(super) fn of_involutes(
    pitch: &Pitch,
    gear: &Gear,
    profiles: &[Modification; 2],
) -> Result<Pitch, GearError> {
    // Alike on all teeth it is no pitch.
    let by_tooth = |profile: &Modification| profile.traces.iter().any(|t| t.tooth.is_some());
    if !profiles.iter().any(by_tooth) {
        return Ok(pitch.clone());
    }
    let Some(excess) = Excess::new(gear, profiles)? else {
        return Ok(pitch.clone());
    };
    let touched = excess.by_reference_circle();
    let [right, left] = Flank::BOTH.map(|flank| -> Vec<f64> {
        let pairs = pitch.flank(flank).iter().zip(touched.flank(flank));
        pairs.map(|(pitch, touched)| pitch - touched).collect()
    });
    Ok(Pitch::from_cumulative(&right, &left))
}

impl ThicknessStatement {
    /// `s_b`, mm, beside what profile deviations stand out where the measurement touches, the flanks standing as `known`; single
    /// readings are the mean of all places of a gear without other deviations.
    ///
    /// # Errors
    /// As [`ThicknessStatement::base_thickness`]; profiles that no gear has.
    pub(super) fn base_of_modified(
        &self,
        design: &GearDesign,
        known: &Deviations,
    ) -> Result<Toleranced<f64>, GearError> {
        let teeth = design.basic_data.teeth();
        let profiles = Deviations {
            profiles: known.profiles.clone(),
            ..Deviations::default()
        };
        let all = |mm: f64| (1..=teeth).map(|place| (place, mm)).collect();
        match self {
            ThicknessStatement::Span { teeth, mm } => mm.try_map(|&mm| {
                let alike = ThicknessStatement::SpanReadings {
                    teeth: *teeth,
                    readings: all(mm),
                    per_tooth: false,
                };
                alike.base_of_readings(design, &profiles)
            }),
            ThicknessStatement::OverPins { body, pin_mm, mm } => mm.try_map(|&mm| {
                let alike = ThicknessStatement::PinReadings {
                    body: *body,
                    pin_mm: *pin_mm,
                    readings: all(mm),
                };
                alike.base_of_readings(design, &profiles)
            }),
            _ => self.base_of_readings(design, known).map(Toleranced::Single),
        }
    }

    fn base_of_readings(&self, design: &GearDesign, known: &Deviations) -> Result<f64, GearError> {
        let basic_data = &design.basic_data;
        let rounding = 4.0 * f64::EPSILON * basic_data.reference_radius();
        let mut touched = FlankShifts::default();
        let mut base = self.base_touching(basic_data, known, &touched)?;
        let mut last = f64::INFINITY;
        for _ in 0..MOST_ROUNDS {
            // That there is no such gear is reported of the thickness itself.
            let Ok(gear) = Gear::new(*design, base) else {
                return Ok(base);
            };
            touched = self.touched(&gear, known, &touched)?;
            let next = self.base_touching(basic_data, known, &touched)?;
            let change = (next - base).abs();
            base = next;
            // At the rounding, or as near as it gets.
            if change <= rounding || (change >= last && last <= 1e3 * rounding) {
                return Ok(base);
            }
            last = change;
        }
        Err(GearError::Readings(
            "no mean thickness gives these readings with this profile",
        ))
    }

    /// What the flanks of `gear` stand out where this measurement touches them.
    pub(super) fn touched(
        &self,
        gear: &Gear,
        known: &Deviations,
        before: &FlankShifts,
    ) -> Result<FlankShifts, GearError> {
        let Some(excess) = Excess::new(gear, &known.profiles)? else {
            return Ok(FlankShifts::default());
        };
        match self {
            ThicknessStatement::Span { teeth, .. }
            | ThicknessStatement::SpanReadings { teeth, .. } => excess.by_span(*teeth, known),
            ThicknessStatement::OverPins { pin_mm, .. }
            | ThicknessStatement::PinReadings { pin_mm, .. } => {
                excess.by_pins(*pin_mm, known, before)
            }
            _ => Ok(FlankShifts::default()),
        }
    }

    /// The thickness of each tooth by `spans` of this statement. A flank that it turns is touched elsewhere, by which its profile may stand
    /// out more or less: the two take turns. (What that does to the mean thickness, the square of a turn, is left out: below 0.1 nm.)
    pub(super) fn thickness_beside_profiles(
        &self,
        spans: Spans,
        gear: &Gear,
        known: &Deviations,
    ) -> Result<Option<PerTooth>, GearError> {
        let mut touched = self.touched(gear, known, &FlankShifts::default())?;
        for _ in 0..MOST_ROUNDS {
            let Some(found) = spans.clone().touching(touched.clone()).per_tooth(known)? else {
                return Ok(None);
            };
            let mut standing = known.clone();
            standing.per_tooth.resize(found.thickness.len(), 0.0);
            for (thickness, more) in standing.per_tooth.iter_mut().zip(&found.thickness) {
                *thickness += more;
            }
            let next = self.touched(gear, &standing, &touched)?;
            if next.is_near(&touched, ROUNDING * gear.tip_radius()) {
                return Ok(Some(found));
            }
            touched = next;
        }
        Err(GearError::Readings(
            "no thickness of the teeth gives these readings with this profile",
        ))
    }

    fn base_touching(
        &self,
        basic_data: &BasicGearData,
        known: &Deviations,
        touched: &FlankShifts,
    ) -> Result<f64, GearError> {
        let spans = self.spans(basic_data)?;
        match (spans, self.pins(basic_data)?) {
            (Some(spans), _) => spans.touching(touched.clone()).base_thickness(known),
            (None, Some(pins)) => pins.touching(touched.clone()).base_thickness(known),
            (None, None) => Err(GearError::Readings("there is no reading")),
        }
    }
}
