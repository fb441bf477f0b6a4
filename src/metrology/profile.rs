//! Stated profile deviations: their checks, their findings, and the pitch of the involutes.

use super::error::{MeasurementError, ProfileKey};
use super::finding::SomeTeeth;
use crate::error::GearError;
use crate::gear::{AsBuilt, Deviations, Excess, Face, Flank, Gear, Modification, Pitch, Trace};

/// Greatest excess of an evaluation range over the flank, mm: diameters are rounded to 1 µm.
const ROUNDED: f64 = 1e-3;

/// The keys of a profile that are checked alone, and all together last.
const KEYS: [ProfileKey; 6] = [
    ProfileKey::Slope,
    ProfileKey::Crowning,
    ProfileKey::TipRelief,
    ProfileKey::RootRelief,
    ProfileKey::Trace,
    ProfileKey::All,
];

/// The deviation of one key of `profile`, with its evaluation range.
fn with_key_alone(profile: &Modification, key: ProfileKey) -> Modification {
    let mut alone = Modification {
        range: profile.range,
        ..Modification::default()
    };
    match key {
        ProfileKey::Slope => alone.slope = profile.slope,
        ProfileKey::Crowning => alone.crowning = profile.crowning,
        ProfileKey::TipRelief => alone.tip_relief = profile.tip_relief,
        ProfileKey::RootRelief => alone.root_relief = profile.root_relief,
        ProfileKey::Trace => alone.traces = profile.traces.clone(),
        ProfileKey::All => alone = profile.clone(),
        ProfileKey::Range => {}
    }
    alone
}

/// Errors of `profiles` on `gear`, each key alone.
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
        let before = errors.len();
        for key in KEYS {
            if key == ProfileKey::All && errors.len() > before {
                break;
            }
            let mut alone = Deviations::default();
            alone.profiles[index] = with_key_alone(profile, key);
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
    GearError::require(
        start >= gear.form_radius() - 0.5 * ROUNDED,
        "start of the evaluation range (mm)",
        2.0 * start,
        "the root form diameter or more",
    )?;
    GearError::require(
        end <= gear.tip_radius() + 0.5 * ROUNDED && end > start,
        "end of the evaluation range (mm)",
        2.0 * end,
        "above its start, up to the tip diameter",
    )
}

/// The flanks with `traces` of some of the `teeth` only.
pub(super) fn of_some_teeth(teeth: u32, traces: [&[Trace]; 2]) -> impl Iterator<Item = SomeTeeth> {
    let each = Flank::BOTH.into_iter().zip(traces);
    each.filter_map(move |(flank, traces)| {
        let measured = traces.iter().filter(|trace| trace.tooth.is_some());
        let measured = measured.count() as u32;
        (1..teeth).contains(&measured).then_some(SomeTeeth {
            flank,
            measured,
            teeth,
        })
    })
}

/// The pitch of the involutes, from the `pitch` of the flanks measured on the reference circle.
pub(super) fn of_involutes(
    pitch: &Pitch,
    gear: &Gear,
    profiles: &[Modification; 2],
) -> Result<Pitch, GearError> {
    // A deviation equal on all teeth is no pitch.
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
