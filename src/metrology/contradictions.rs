//! Measurements of one gear that contradict each other: reversed left flanks, thickness stated twice, an eccentricity counted twice.

use super::finding::{Eccentricity, Finding, RunoutSource, ThicknessBesidePitch};
use super::flank_correlation::{
    anticorrelation_p_value, datum_anticorrelation_p_value, first_harmonic_difference,
    first_harmonic_energy,
};
use super::pitch_statement::{EccentricitySource, PitchStatement};
use super::settle::Flanks;
use super::thickness_statement::ThicknessStatement;
use crate::gear::{Deviations, Flank, Pitch, Spans, separate_eccentricity};
use crate::numeric::{mean, range};

/// Below this probability, opposed flanks count as reversed. Tuned: of unrelated curves, white or random walks, at most 2 in
/// 4000 were suspected. Curves with common waves up to 5 µm, noise of ±1 µm and one reversed flank: 84 % were found at
/// z = 20, 91 % at z = 44. About the datum axis, with 0, 2 and 20 µm of eccentricity, at most 2 in 4000 were suspected. Reversed
/// flanks were found in all of 4000 cases from 20 µm on, and in 57 … 96 % at 5 µm. `cargo test -p gearlash-input-tests --test readers
/// reversed_flanks -- --nocapture` prints the counts.
const UNRELATED: f64 = 1e-3;
/// Ratio of the energies left in the spans by the two signs of the left flank, above which the sign is clear. Tuned: noise alone
/// reaches it in 1 of 400 cases with 7 readings and in none with 20.
const CLEARER: f64 = 4.0;
/// Fewest spans that decide the sign. All round, fewer may confirm the stated sign.
const FEWEST_SPANS: usize = 7;
/// Two curves are equal if their difference has at most this share of the energy. Tuned: thickness of 4 µm r.m.s., measured twice
/// with 1 µm per flank, leaves 0.19; unrelated curves leave 2.
const SAME: f64 = 0.2;
/// Greatest shift of a list in tooth numbers that is tried. Tuned: counting from 0 gives 1, the first tooth of a span some ten.
const MOST_SHIFT: usize = 12;
/// Less variation of the spans, mm r.m.s., is lost in the digits of a sheet.
const LEAST: f64 = 1e-4;
/// Standard deviations by which the spans must contradict the stated thickness.
const CERTAIN: f64 = 3.0;
/// Most variation of spans beside the pitch of both flanks, mm r.m.s. Tuned: a length rounded to 10 µm leaves 2.9 µm, its noise of
/// 2 µm and two flanks of 1 µm another 2.5, together 3.8; one tooth of 20 read 25 µm off leaves 5.6.
const MOST_LEFT: f64 = 5e-3;

/// All contradictions, except those of the first harmonic. `pitch` has its curves as measured.
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
        if looks_reversed(measured, own, witness, stated.is_datum(), flanks) {
            findings.push(Finding::LeftFlankReversed {
                eccentricity_um: eccentricities(measured, flanks),
            });
        } else if let Some(shown) = witness
            .and_then(|spans| share_shown(spans, pitch_alone(flanks), per_tooth_alone(flanks)))
            && (shown.is_refused() || shown.left > MOST_LEFT)
        {
            findings.push(Finding::SpansRefusePitch {
                shown: shown.slope,
                left_um: 1000.0 * shown.left,
                spans_count: spans.is_some() && spans_count(flanks),
            });
        }
        let twice = compare_with_pitch(own, &flanks.stated.per_tooth);
        findings.extend(twice.map(Finding::ThicknessBesidePitch));
    }
    let shown =
        spans.and_then(|spans| share_shown(&spans, per_tooth_alone(flanks), pitch_alone(flanks)));
    let refused = shown.filter(Shown::is_refused);
    findings.extend(refused.map(|shown| Finding::SpansRefuseThickness {
        shown: shown.slope,
        spans_count: spans_count(flanks),
    }));
    findings
}

fn spans_count(flanks: &Flanks) -> bool {
    let amplification = flanks.all_round.and_then(|note| note.amplification);
    amplification.is_some()
}

/// The stated pitch alone.
fn pitch_alone(flanks: &Flanks) -> Deviations {
    Deviations {
        pitch: flanks.stated.pitch.clone(),
        ..Deviations::default()
    }
}

/// The stated per-tooth thickness alone.
fn per_tooth_alone(flanks: &Flanks) -> Deviations {
    Deviations {
        per_tooth: flanks.stated.per_tooth.clone(),
        ..Deviations::default()
    }
}

/// Whether the left flank's sign looks reversed: by the spans if they decide, otherwise by the flanks alone.
fn looks_reversed(
    measured: &Pitch,
    own: &Pitch,
    spans: Option<&Spans>,
    is_datum: bool,
    flanks: &Flanks,
) -> bool {
    let other = measured.clone().read_as_material();
    let other_own = if is_datum {
        separate_eccentricity(&other, flanks.gears.most())
            .ok()
            .map(|parts| parts.pitch)
    } else {
        Some(other)
    };
    let left_over = |pitch: &Pitch| -> Option<f64> {
        let known = Deviations {
            pitch: Some(pitch.clone()),
            ..flanks.stated.clone()
        };
        let beside = spans?.compare(&known).ok()?;
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
            let exchanged = left_over(&own.clone().exchanged());
            return exchanged.is_none_or(|exchanged| turned <= CLEARER * exchanged);
        }
        if (enough || spans.all_round()) && turned > CLEARER * as_stated {
            return false;
        }
    }
    let p_value = if is_datum {
        datum_anticorrelation_p_value(measured, flanks.gears.most())
    } else {
        anticorrelation_p_value(measured)
    };
    p_value < UNRELATED
}

/// Eccentricity in datum-axis pitch with the left flanks reversed and as stated, µm.
fn eccentricities(measured: &Pitch, flanks: &Flanks) -> Option<[f64; 2]> {
    let note = flanks.eccentricity.as_ref()?;
    let turned = measured.clone().read_as_material();
    let turned = separate_eccentricity(&turned, flanks.gears.most()).ok()?;
    Some([1000.0 * turned.eccentricity, note.in_pitch.um])
}

/// Compares stated per-tooth thickness with the thickness in the pitch of both flanks.
fn compare_with_pitch(pitch: &Pitch, per_tooth: &[f64]) -> Option<ThicknessBesidePitch> {
    let mean = mean(per_tooth);
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
    } else if let Some((by, down)) = shift_of_equal_list(&by_flanks, &same) {
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

/// The shift in tooth numbers at which `list` is the `same` as another list, and whether the shift is down.
fn shift_of_equal_list(list: &[f64], same: &impl Fn(&[f64], f64) -> bool) -> Option<(usize, bool)> {
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

/// A stated thickness variation as spans show it.
struct Shown {
    /// The share of it: 1 if they agree.
    slope: f64,
    /// Standard deviation of the share; infinite where there is no variation.
    deviation: f64,
    /// Variation of the spans beside all that is stated, mm r.m.s.
    left: f64,
}

impl Shown {
    /// Whether the spans are more even without the stated thickness: with certainty its share is below 1/2.
    fn is_refused(&self) -> bool {
        self.slope + CERTAIN * self.deviation < 0.5
    }
}

/// The `stated` thickness variation as enough spans show it, beside the `other` deviations.
///
/// The spans without the effect of the `other` deviations are regressed on the spans expected from the stated ones.
fn share_shown(spans: &Spans, stated: Deviations, other: Deviations) -> Option<Shown> {
    let other = spans.compare(&other).ok()?;
    let stated = spans.compare(&stated).ok()?;
    let pairs = stated.iter().zip(other);
    let pairs = pairs.map(|((read, said), (_, by_other))| (read - by_other, *said));
    let pairs: Vec<(f64, f64)> = pairs.collect();
    if pairs.len() < FEWEST_SPANS {
        return None;
    }
    let left = |slope: f64| -> f64 {
        let beside = pairs.iter().map(|(read, said)| read - slope * said);
        beside.map(|left| left * left).sum()
    };
    let said: f64 = pairs.iter().map(|(_, said)| said * said).sum();
    let (slope, deviation) = if said <= pairs.len() as f64 * LEAST.powi(2) {
        (0.0, f64::INFINITY)
    } else {
        let slope = pairs.iter().map(|(read, said)| read * said).sum::<f64>() / said;
        (
            slope,
            (left(slope) / (pairs.len() - 2) as f64 / said).sqrt(),
        )
    };
    Some(Shown {
        slope,
        deviation,
        left: (left(1.0) / pairs.len() as f64).sqrt(),
    })
}

/// Greatest share of the first harmonics' energy that an eccentricity leaves. A wave common to both flanks of a tooth leaves
/// `sin² (α − π/(2z))`, 0.1 at 20°. Noise of a tenth of an eccentricity, at 20 teeth, leaves some 0.001.
const NOT_JOINT: f64 = 0.05;
/// Standard deviations by which the harmonic must exceed the rest of the pitch: white deviations do so once in e^(4²/2) = 3000 times.
const STANDS_OUT: f64 = 4.0;

/// A contradiction in the first harmonic of `pitch`, with its curves as `measured`. `by_readings`: the runout is stated by readings.
pub(super) fn first_harmonic(
    pitch: &PitchStatement,
    measured: &Pitch,
    by_readings: bool,
    flanks: &Flanks,
) -> Option<Finding> {
    if pitch.is_datum() {
        harmonic_beyond_eccentricity(pitch, measured, flanks)
    } else {
        eccentricity_in_own_pitch(measured, by_readings, flanks)
    }
}

/// Own-axis pitch that contains the eccentricity of the runout, both flanks jointly.
fn eccentricity_in_own_pitch(
    measured: &Pitch,
    by_readings: bool,
    flanks: &Flanks,
) -> Option<Finding> {
    let gear = flanks.gears.most();
    let in_runout = flanks.in_runout.filter(|stated| stated.um > 0.0)?;
    let found = separate_eccentricity(measured, gear).ok()?;
    let in_pitch = Eccentricity::new(found.eccentricity, found.high_tooth);
    // Least squares of `datum`: deviations of s leave s cos α/√z in either component of the eccentricity.
    let basic_data = gear.basic_data();
    let rest = Flank::BOTH.map(|side| found.pitch.flank(side).iter().map(|f| f * f).sum::<f64>());
    let z = f64::from(basic_data.teeth());
    let free = (2.0 * z - 4.0).max(1.0);
    let deviation =
        (rest.iter().sum::<f64>() / free / z).sqrt() * basic_data.transverse_pressure_angle().cos();
    let left = first_harmonic_energy(&found.pitch);
    let jointly = left <= NOT_JOINT * first_harmonic_energy(measured);
    if !(jointly && found.eccentricity > STANDS_OUT * deviation) {
        return None;
    }
    if !in_runout.is_same(&in_pitch, basic_data) {
        // The same amount in another direction: one of the two directions may be wrong. A harmonic of the gear's own pitch is as
        // large by chance: beside readings, only a known slip counts.
        let reversal = in_runout.reversal(&in_pitch, basic_data);
        let is_doubted = reversal.is_some() || !by_readings && in_runout.is_as_large(&in_pitch);
        return is_doubted.then_some(Finding::StatedEccentricityElsewhere {
            in_pitch,
            stated: in_runout,
            reversal,
        });
    }
    Some(Finding::OwnPitchHoldsEccentricity {
        in_pitch,
        in_runout,
        runout: if by_readings {
            RunoutSource::Readings {
                left: flanks.runout.stated(),
            }
        } else {
            RunoutSource::Total
        },
    })
}

/// Datum-axis pitch whose first harmonic is not that of an eccentricity alone.
///
/// For white deviations `s` the energy left by the joint fit is exponential with the mean `z s²`. It exceeds the rest by
/// [`STANDS_OUT`] if it is above `STANDS_OUT²/2` times this mean.
fn harmonic_beyond_eccentricity(
    pitch: &PitchStatement,
    measured: &Pitch,
    flanks: &Flanks,
) -> Option<Finding> {
    if pitch.eccentricity == Some(EccentricitySource::Runout) {
        // The rest counts as the gear's own pitch.
        return None;
    }
    let (own, note) = (flanks.stated.pitch.as_ref()?, flanks.eccentricity?);
    let (left, all) = (first_harmonic_energy(own), first_harmonic_energy(measured));
    let z = f64::from(flanks.gears.most().basic_data().teeth());
    let squares = |side| own.flank(side).iter().map(|f| f * f).sum::<f64>();
    // Without the harmonic: its energy is z/2 times its squares. Means and harmonics are fitted.
    let rest = (Flank::BOTH.map(squares).iter().sum::<f64>() - 2.0 * left / z).max(0.0);
    let white = z * rest / (2.0 * z - 6.0).max(1.0);
    let stands_out = left > STANDS_OUT.powi(2) / 2.0 * white;
    let exchanged = measured.clone().exchanged();
    let exchanged = separate_eccentricity(&exchanged, flanks.gears.most()).ok();
    (stands_out && left > NOT_JOINT * all).then(|| Finding::FirstHarmonicNotEccentricity {
        // The amplitude is 2/z times the coefficient, as the root mean square of both flanks.
        left_um: 1000.0 * 2.0 / z * (left / 2.0).sqrt(),
        left_percent: 100.0 * left / all,
        alike: first_harmonic_difference(measured) <= NOT_JOINT * all,
        exchanged: exchanged
            .is_some_and(|parts| first_harmonic_energy(&parts.pitch) <= NOT_JOINT * all),
        eccentricity_um: note.in_pitch.um,
    })
}
