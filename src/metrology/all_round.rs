//! What readings all round determine.

use super::finding::{Finding, MeanOnly};
use super::settle::Flanks;
use super::statement::ThicknessStatement;
use crate::gear::{Gear, Spans, thickness};

/// Where readings all round determine more or less than one might think.
pub(super) fn finding(statement: &ThicknessStatement, flanks: &Flanks) -> Option<Finding> {
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
            // All round the pitch of each flank is 0 in the mean.
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

/// A number of teeth whose spans all round determine every tooth of `gear`.
fn other_span(gear: &Gear) -> Option<u32> {
    let z = gear.basic_data().teeth();
    (2..=z).find(|&k| Spans::determine(z, k) && thickness::check_span(gear, k).is_ok())
}
