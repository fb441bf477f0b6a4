//! Where the data of one gear contradict what the file says of them: warnings, each with the way out.

use super::cross_check::CrossCheck;
use super::faults::Drawing;
use super::flanks::Flanks;
use super::pitch::PitchSheet;
use super::thickness::Statement;
use gearlash::gear::{Deviations, Pitch, Side, Spans};

/// The probability below which flanks that go against each other count as turned round. Tuned: of unrelated curves, white
/// or random walks, at most 2 in 4000 were suspected; of curves with common waves of up to 5 µm and noise of
/// ±1 µm, one of them turned round, 84 % were found at z = 20 and 91 % at z = 44. About the
/// datum axis, with 0, 2 and 20 µm of eccentricity, at most 2 in 4000 were suspected; turned round, all of 4000 were found from
/// 20 µm on, of 5 µm 57 … 96 %. `cargo test --test all_round contradictions -- --nocapture` prints the counts.
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

/// Everything that contradicts; of the pitch `sheet`, its curves as measured.
pub fn told(
    drawing: &Drawing,
    cross_check: Option<&CrossCheck>,
    sheet: Option<(&PitchSheet, &Pitch)>,
    flanks: &Flanks,
) -> Vec<String> {
    let spans = |of: &Statement| of.spans(&drawing.design.basic_data).ok().flatten();
    let cross_check = cross_check.and_then(|check| spans(check.statement()));
    let spans = spans(&drawing.statement);
    let mut told = Vec::new();
    if let (Some((sheet, measured)), Some(own)) = (sheet, &flanks.stated.pitch) {
        let witness = spans.as_ref().or(cross_check.as_ref());
        if turned_round(measured, own, witness, sheet, flanks) {
            told.push(format!(
                "{}: the left flanks go against the right ones, as if their sign were turned round{}: if + means plus material on both flanks \
                 (or the gear was seen from the other face), write sense = {:?}",
                drawing.table.path_of(sheet.key(Side::Left)),
                eccentricities(measured, flanks),
                sheet.other_sense()
            ));
        }
        told.extend(twice(drawing, sheet, own, &flanks.stated.per_tooth));
    }
    told.extend(spans.and_then(|spans| refused(drawing, &spans, flanks)));
    told
}

/// Whether the left flank's sign looks turned round: by the spans where they can tell, by the flanks alone otherwise.
fn turned_round(
    measured: &Pitch,
    own: &Pitch,
    spans: Option<&Spans>,
    sheet: &PitchSheet,
    flanks: &Flanks,
) -> bool {
    let other = measured.clone().read_as_material();
    let other_own = match sheet.is_datum() {
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
    let opposition = match sheet.is_datum() {
        true => measured.datum_opposition(flanks.gears.most()),
        false => measured.opposition(),
    };
    opposition < UNRELATED
}

/// What eccentricity datum-axis flanks hold with either sign of the left one.
fn eccentricities(measured: &Pitch, flanks: &Flanks) -> String {
    let Some(note) = &flanks.eccentricity else {
        return String::new();
    };
    let turned = measured.clone().read_as_material();
    let turned = turned.separate_eccentricity(flanks.gears.most());
    turned.map_or(String::new(), |turned| {
        format!(
            " (they hold an eccentricity of {:.3} µm then, of {:.3} µm as stated)",
            1000.0 * turned.eccentricity,
            note.in_pitch.um
        )
    })
}

/// Per-tooth thickness that repeats or takes back what the pitch of both flanks says of it.
fn twice(
    drawing: &Drawing,
    sheet: &PitchSheet,
    pitch: &Pitch,
    per_tooth: &[f64],
) -> Option<String> {
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
    let key = drawing.table.path_of("thickness.per_tooth_um");
    if same(&by_flanks, 1.0) {
        Some(format!(
            "{key}: says the same as the pitch of both flanks (a tooth is thicker by right minus left pitch deviation), and the two add: \
             leave it out, unless the teeth are that much thicker once more"
        ))
    } else if same(&by_flanks, -1.0) {
        Some(format!(
            "{key}: takes back the thickness that the pitch of both flanks gives (right minus left pitch deviation): check which of the two is turned round; \
             where both were measured on the same teeth, leave it out"
        ))
    } else if same(&turned, 1.0) {
        Some(format!(
            "{key}: is the thickness that the pitch would give with the left flanks turned round: write pitch.sense = {:?} and leave it out, \
             since the two add",
            sheet.other_sense()
        ))
    } else if let Some((on, later)) = shifted(&by_flanks, &same) {
        Some(format!(
            "{key}: says what the pitch of both flanks says of the teeth, moved {} by {on} in tooth number, and the two add: check the tooth \
             numbers of both; where they are of the same teeth, leave it out",
            if later { "down" } else { "up" }
        ))
    } else {
        let apart = |(t, by_flanks): (&f64, &f64)| (t - mean - by_flanks).abs();
        let differences: Vec<f64> = per_tooth.iter().zip(&by_flanks).map(apart).collect();
        let numbered = (1..).zip(&differences);
        let (tooth, most) = numbered.max_by(|a, b| a.1.total_cmp(b.1))?;
        Some(format!(
            "{key}: the teeth vary by {:.3} µm by this list and by {:.3} µm by the pitch of both flanks (right minus left), \
             {:.3} µm apart at tooth {tooth}; the two are added: where both were measured on the same teeth, leave one of them out",
            1000.0 * variation,
            1000.0 * range(&by_flanks),
            1000.0 * most,
        ))
    }
}

/// Greatest less least.
fn range(list: &[f64]) -> f64 {
    let greatest = list.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = list.iter().copied().fold(f64::INFINITY, f64::min);
    greatest - least
}

/// By how many tooth numbers `list` is moved where it is the `same` as another, and whether the other's value stands farther on.
fn shifted(list: &[f64], same: &impl Fn(&[f64], f64) -> bool) -> Option<(usize, bool)> {
    let most = MOST_SHIFT.min(list.len() / 2);
    (1..=most).find_map(|on| {
        let mut turned = list.to_vec();
        turned.rotate_left(on);
        if same(&turned, 1.0) {
            return Some((on, true));
        }
        turned.rotate_right(2 * on);
        same(&turned, 1.0).then_some((on, false))
    })
}

/// Per-tooth thickness that spans on the same gear do not show.
///
/// Regression of what the spans show beside the pitch on what the stated thickness makes of them: the
/// slope is 1 where they agree. Below 1/2 the spans are more even with nothing stated.
fn refused(drawing: &Drawing, spans: &Spans, flanks: &Flanks) -> Option<String> {
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
    (slope + CERTAIN * deviation < 0.5).then(|| {
        format!(
            "{}: the spans do not show it (they show {:.0} % of it): check its sign and tooth numbers, or leave it out; {}",
            drawing.table.path_of("thickness.per_tooth_um"),
            100.0 * slope,
            match flanks.all_round.and_then(|note| note.amplification) {
                Some(_) => "the spans count",
                None => "it counts all the same",
            }
        )
    })
}
