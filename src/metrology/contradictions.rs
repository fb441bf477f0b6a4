//! Where measurements of one gear contradict each other: left flanks reversed, thickness stated twice, spans that refuse it.

use super::finding::{Finding, ThicknessBesidePitch};
use super::pitch_statement::PitchStatement;
use super::settle::Flanks;
use super::statement::ThicknessStatement;
use crate::gear::{Deviations, Pitch, Spans, range};

/// The probability below which flanks that go against each other count as reversed. Tuned: of unrelated curves, white
/// or random walks, at most 2 in 4000 were suspected; of curves with common waves of up to 5 µm and noise of
/// ±1 µm, one of them reversed, 84 % were found at z = 20 and 91 % at z = 44. About the
/// datum axis, with 0, 2 and 20 µm of eccentricity, at most 2 in 4000 were suspected; reversed, all of 4000 were found from
/// 20 µm on, of 5 µm 57 … 96 %. `cargo test -p gearlash-files --test all_round reversed_flanks -- --nocapture` prints the counts.
const UNRELATED: f64 = 1e-3;
/// How many times less energy must be left in the spans by one sign of the left flank than by the other. Tuned:
/// noise `ε` alone comes there only within 30° of one direction of as many dimensions as there are readings, the
/// change of sign being as large as `ε` besides; 1 in 400 with 7 readings, none with 20.
const CLEARER: f64 = 4.0;
/// Fewest spans that are asked which sign they bear out; all round, fewer bear out the one that is stated.
const FEWEST_SPANS: usize = 7;
/// Two curves are the same when this part of the energy at most is in their difference. Tuned: thickness of 4 µm r.m.s.,
/// measured twice with 1 µm a flank, leaves 0.19; unrelated curves leave 2.
const SAME: f64 = 0.2;
/// Most tooth numbers by which a list is sought moved. Tuned: counting from 0 makes 1, the first tooth of a span some ten;
/// farther on a smooth curve is the same as any other.
const MOST_SHIFT: usize = 12;
/// Standard deviations by which the spans must refuse the stated thickness.
const CERTAIN: f64 = 3.0;

/// Everything that contradicts; of the pitch its curves as `measured`.
pub(super) fn findings(
    statement: &ThicknessStatement,
    cross_check: Option<&ThicknessStatement>,
    pitch: Option<(&PitchStatement, &Pitch)>,
    flanks: &Flanks,
) -> Vec<Finding> {
    let basic_data = flanks.gears.most().basic_data();
    let spans = |of: &ThicknessStatement| of.spans(basic_data).ok().flatten();
    let cross_check = cross_check.and_then(spans);
    let spans = spans(statement);
    let mut findings = Vec::new();
    if let (Some((stated, measured)), Some(own)) = (pitch, &flanks.stated.pitch) {
        let witness = spans.as_ref().or(cross_check.as_ref());
        if reversed(measured, own, witness, stated.is_datum(), flanks) {
            findings.push(Finding::LeftFlankReversed {
                eccentricity_um: eccentricities(measured, flanks),
            });
        }
        let twice = beside_pitch(own, &flanks.stated.per_tooth);
        findings.extend(twice.map(Finding::ThicknessBesidePitch));
    }
    findings.extend(spans.and_then(|spans| refused(&spans, flanks)));
    findings
}

/// Whether the left flank's sign looks reversed: by the spans where they can tell, by the flanks alone otherwise.
fn reversed(
    measured: &Pitch,
    own: &Pitch,
    spans: Option<&Spans>,
    is_datum: bool,
    flanks: &Flanks,
) -> bool {
    let other = measured.clone().read_as_material();
    let other_own = match is_datum {
        true => other
            .separate_eccentricity(flanks.gears.most())
            .ok()
            .map(|parts| parts.pitch),
        false => Some(other),
    };
    let left_over = |pitch: &Pitch| -> Option<f64> {
        let known = Deviations {
            pitch: Some(pitch.clone()),
            ..flanks.stated.clone()
        };
        let beside = spans?.beside(&known).ok()?;
        let left = beside.iter().map(|(read, said)| (read - said).powi(2));
        Some(left.sum())
    };
    if let (Some(spans), Some(as_stated), Some(turned)) = (
        spans.map(Spans::readings),
        left_over(own),
        other_own.as_ref().and_then(left_over),
    ) {
        let enough = spans.list().len() >= FEWEST_SPANS;
        if enough && as_stated > CLEARER * turned {
            return true;
        }
        if (enough || spans.all_round()) && turned > CLEARER * as_stated {
            return false;
        }
    }
    let p_value = match is_datum {
        true => measured.datum_anticorrelation_p_value(flanks.gears.most()),
        false => measured.anticorrelation_p_value(),
    };
    p_value < UNRELATED
}

/// What eccentricity datum-axis flanks hold with the left one reversed and as stated, µm.
fn eccentricities(measured: &Pitch, flanks: &Flanks) -> Option<[f64; 2]> {
    let note = flanks.eccentricity.as_ref()?;
    let turned = measured.clone().read_as_material();
    let turned = turned.separate_eccentricity(flanks.gears.most()).ok()?;
    Some([1000.0 * turned.eccentricity, note.in_pitch.um])
}

/// Per-tooth thickness that stands beside what the pitch of both flanks says of it.
fn beside_pitch(pitch: &Pitch, per_tooth: &[f64]) -> Option<ThicknessBesidePitch> {
    let mean = per_tooth.iter().sum::<f64>() / per_tooth.len().max(1) as f64;
    let energy: f64 = per_tooth.iter().map(|t| (t - mean).powi(2)).sum();
    let variation = range(per_tooth);
    if !(variation > 0.0) {
        // One value for all teeth is an offset.
        return None;
    }
    let same = |other: &[f64], sign: f64| {
        let pairs = per_tooth.iter().zip(other);
        let apart: f64 = pairs.map(|(t, o)| (t - mean - sign * o).powi(2)).sum();
        apart <= SAME * energy
    };
    let by_flanks = pitch.thickness();
    let turned = pitch.clone().read_as_material().thickness();
    if same(&by_flanks, 1.0) {
        Some(ThicknessBesidePitch::Same)
    } else if same(&by_flanks, -1.0) {
        Some(ThicknessBesidePitch::TakenBack)
    } else if same(&turned, 1.0) {
        Some(ThicknessBesidePitch::SameIfReversed)
    } else if let Some((by, down)) = moved(&by_flanks, &same) {
        Some(ThicknessBesidePitch::SameIfMoved { by, down })
    } else {
        let apart = |(t, by_flanks): (&f64, &f64)| (t - mean - by_flanks).abs();
        let differences: Vec<f64> = per_tooth.iter().zip(&by_flanks).map(apart).collect();
        let numbered = (1..).zip(&differences);
        let (tooth, most) = numbered.max_by(|a, b| a.1.total_cmp(b.1))?;
        Some(ThicknessBesidePitch::Different {
            list_um: 1000.0 * variation,
            pitch_um: 1000.0 * range(&by_flanks),
            tooth,
            apart_um: 1000.0 * most,
        })
    }
}

/// By how many tooth numbers `list` is moved where it is the `same` as another, and whether the other's value stands farther on.
fn moved(list: &[f64], same: &impl Fn(&[f64], f64) -> bool) -> Option<(usize, bool)> {
    let most = MOST_SHIFT.min(list.len() / 2);
    (1..=most).find_map(|by| {
        let mut turned = list.to_vec();
        turned.rotate_left(by);
        if same(&turned, 1.0) {
            return Some((by, true));
        }
        turned.rotate_right(2 * by);
        same(&turned, 1.0).then_some((by, false))
    })
}

/// Per-tooth thickness that spans on the same gear do not show.
///
/// Regression of what the spans show beside the pitch on what the stated thickness makes of them: the
/// slope is 1 where they agree. Below 1/2 the spans are more even with nothing stated.
fn refused(spans: &Spans, flanks: &Flanks) -> Option<Finding> {
    let stated = &flanks.stated;
    if stated.per_tooth.is_empty() {
        return None;
    }
    let alone = Deviations {
        per_tooth: stated.per_tooth.clone(),
        ..Deviations::default()
    };
    let pitch = Deviations {
        pitch: stated.pitch.clone(),
        ..Deviations::default()
    };
    let pitch = spans.beside(&pitch).ok()?;
    let pairs: Vec<(f64, f64)> = spans
        .beside(&alone)
        .ok()?
        .iter()
        .zip(pitch)
        .map(|((read, said), (_, by_pitch))| (read - by_pitch, *said))
        .collect();
    let said: f64 = pairs.iter().map(|(_, said)| said * said).sum();
    if pairs.len() < FEWEST_SPANS || !(said > 0.0) {
        return None;
    }
    let slope = pairs.iter().map(|(read, said)| read * said).sum::<f64>() / said;
    let left: f64 = pairs
        .iter()
        .map(|(read, said)| (read - slope * said).powi(2))
        .sum();
    let deviation = (left / (pairs.len() - 2) as f64 / said).sqrt();
    (slope + CERTAIN * deviation < 0.5).then_some(Finding::SpansRefuseThickness {
        shown: slope,
        spans_count: flanks
            .all_round
            .and_then(|note| note.amplification)
            .is_some(),
    })
}
