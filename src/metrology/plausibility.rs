//! Values that look like another sign or quantity, and readings all round that determine less than expected.

use super::finding::{Finding, MeanOnly, Quantity, SameKind};
use super::settle::Flanks;
use super::thickness_statement::{ThicknessStatement, Toleranced};
use crate::gear::{BasicGearData, Gear, Spans, thickness};
use crate::numeric::mean;

/// Greatest mean of a list, in standard deviations. Tuned: a mean three standard deviations from 0 means that all values lie on one
/// side of 0, as for values counted from the nominal thickness.
const OFF: f64 = 3.0;
/// Mean of a list, in modules, that no allowance explains. Tuned: the greatest allowance of DIN 3967, a, is smaller from module 2 mm on.
const MOST_MEAN: f64 = 0.1;

/// Per-tooth thickness whose mean is large compared with its scatter and adds to the stated thickness.
///
/// Exceptions: one value for all teeth is a deliberate offset; a list may count from the nominal thickness; readings all round
/// contain the mean of the list.
pub(super) fn off_mean(
    statement: &ThicknessStatement,
    basic_data: &BasicGearData,
    per_tooth_um: &[f64],
) -> Option<Finding> {
    let first = *per_tooth_um.first()?;
    let count = per_tooth_um.len() as f64;
    let mean_um = per_tooth_um.iter().sum::<f64>() / count;
    let module_um = 1000.0 * basic_data.module();
    if mean_um.abs() > MOST_MEAN * module_um {
        return Some(Finding::PerToothMeanTooLarge { mean_um });
    }
    match statement {
        ThicknessStatement::Nominal
        | ThicknessStatement::AllowanceUm(Toleranced::Single(0.0))
        | ThicknessStatement::SpanReadings { .. }
        | ThicknessStatement::PinReadings { .. } => return None,
        _ => {}
    }
    if per_tooth_um.iter().all(|um| *um == first) {
        return None;
    }
    let squares: f64 = per_tooth_um.iter().map(|um| (um - mean_um).powi(2)).sum();
    let scatter_um = (squares / (count - 1.0)).sqrt();
    (mean_um.abs() > OFF * scatter_um).then_some(Finding::PerToothOffMean {
        mean_um,
        scatter_um,
    })
}

/// Allowance, in modules, above which another unit is suspected: a sixth of the tooth thickness.
const MOST_ALLOWANCE: f64 = 0.25;

/// An allowance that looks like the other sign, or like another unit.
pub(super) fn of_allowance(statement: &ThicknessStatement, module_um: f64) -> Option<Finding> {
    match statement {
        ThicknessStatement::AllowanceUm(um) if *um.most() > 0.0 => {
            Some(Finding::AllowanceThickens { um: *um.most() })
        }
        ThicknessStatement::AllowanceUm(um) if -um.most() > MOST_ALLOWANCE * module_um => {
            Some(Finding::AllowanceTooLarge { um: *um.most() })
        }
        _ => None,
    }
}

/// Greatest relative difference of the thickness of a shifted tooth from half the pitch: a shift of 0.65 at 20°.
const SHIFTED: f64 = 0.3;
/// Greatest relative variation of whole lengths on one gear. Tuned: deviations in µm vary by as much as their size.
const VARIES: f64 = 0.1;

/// Values in µm near the whole length in mm: thicknesses or pitches instead of deviations. A list of one value may be an offset.
pub(super) fn looks_like_whole(quantity: Quantity, um: &[f64], whole_mm: f64) -> Option<Finding> {
    let mean_um = mean(um);
    let is_alike = |value: &f64| (value - mean_um).abs() < VARIES * mean_um;
    let differ = um.iter().any(|value| *value != um[0]);
    let is_whole = (mean_um - whole_mm).abs() < SHIFTED * whole_mm;
    (differ && is_whole && um.iter().all(is_alike))
        .then_some(Finding::LooksLikeWhole { quantity, mean_um })
}

/// A `cross_check` of the same kind as the thickness statement, which repeats its errors: those of the pin or of the tooth count.
pub(super) fn same_kind(
    counts: &ThicknessStatement,
    cross_check: &ThicknessStatement,
) -> Option<Finding> {
    let of = |statement: &ThicknessStatement| match statement {
        // A base thickness may come from any measurement.
        ThicknessStatement::Nominal
        | ThicknessStatement::FlankOffset(_)
        | ThicknessStatement::ArcThickness(_)
        | ThicknessStatement::BaseThickness(_) => None,
        ThicknessStatement::Span { teeth, .. } | ThicknessStatement::SpanReadings { teeth, .. } => {
            Some((SameKind::Span, f64::from(*teeth)))
        }
        ThicknessStatement::OverPins { pin_mm, .. }
        | ThicknessStatement::PinReadings { pin_mm, .. } => Some((SameKind::OverPins, *pin_mm)),
        ThicknessStatement::Chord { height_mm, .. } => {
            Some((SameKind::Chord, height_mm.unwrap_or(0.0)))
        }
        ThicknessStatement::AllowanceUm(_) | ThicknessStatement::Field(_) => {
            Some((SameKind::Allowance, 0.0))
        }
    };
    let (kind, _) = of(cross_check).filter(|kind| of(counts) == Some(*kind))?;
    Some(Finding::CrossCheckOfSameKind(kind))
}

/// Readings all round that determine more or less than expected.
pub(super) fn readings_all_round(
    statement: &ThicknessStatement,
    flanks: &Flanks,
) -> Option<Finding> {
    let note = flanks.all_round?;
    let gear = flanks.gears.most();
    let (readings, teeth) = (note.readings, gear.basic_data().teeth());
    let with_pitch = flanks.stated.pitch.is_some();
    match statement {
        ThicknessStatement::PinReadings { .. } => Some(Finding::PinsGiveMeanOnly {
            readings,
            with_pitch,
        }),
        ThicknessStatement::SpanReadings {
            teeth: spanned,
            per_tooth,
            ..
        } => {
            if let Some(amplification) = note.amplification {
                return Some(Finding::SpansGiveEachTooth {
                    spanned: *spanned,
                    teeth,
                    amplification,
                    with_pitch,
                });
            }
            let too_few = readings < teeth as usize;
            // All round, the mean pitch of each flank is 0.
            let pitch_in_mean = too_few && !with_pitch;
            let why = match (per_tooth, too_few) {
                (false, _) if !pitch_in_mean => return None,
                (false, _) => MeanOnly::AsAsked,
                (true, true) => MeanOnly::TooFew,
                (true, false) => MeanOnly::Undetermined {
                    other: other_span(gear),
                },
            };
            Some(Finding::SpansGiveMeanOnly {
                spanned: *spanned,
                teeth,
                readings,
                why,
                pitch_in_mean,
            })
        }
        _ => None,
    }
}

/// The least number of teeth whose spans all round determine every tooth of `gear`.
fn other_span(gear: &Gear) -> Option<u32> {
    let z = gear.basic_data().teeth();
    (2..=z).find(|&k| Spans::determine(z, k) && thickness::check_span(gear, k).is_ok())
}
