//! Outliers: single values far from all others. They are reported and used unchanged.

use super::finding::{PitchOutlier, ReadingOutlier, TooFar};
use super::pitch_statement::{PitchKind, PitchStatement};
use super::thickness_statement::ThicknessStatement;
use crate::gear::{BasicGearData, Deviations, Flank, GradedQuantity};

/// Median absolute deviations from which a value is an outlier. Tuned: for normal values 5.4 standard deviations, one in ten
/// million. The crest of a wave has 1.4, the end of a uniform distribution 2.
const STANDS_OUT: f64 = 8.0;
/// Least distance of an outlier among nearly equal readings, mm. Tuned: a slip of a micrometer's thimble line is 10 µm, less the
/// noise of 1 µm or two.
const THIMBLE_LINE: f64 = 0.008;
/// Fewest values for a median criterion.
const FEWEST: usize = 7;

/// Variation of a coarse gear, mm: the tolerance of grade 11, the coarsest of ISO 1328-1 (source: [`GradedQuantity`]).
///
/// Outside the range of the grades it is a tenth of the module.
fn coarse_variation(quantity: GradedQuantity, basic_data: &BasicGearData) -> f64 {
    let last = *crate::gear::GRADES.end();
    let tolerance = quantity.tolerance(basic_data, last);
    tolerance.unwrap_or(0.1 * basic_data.module())
}

/// The median; 0 for no values.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut list: Vec<f64> = values.collect();
    list.sort_unstable_by(f64::total_cmp);
    let (half, odd) = (list.len() / 2, !list.len().is_multiple_of(2));
    match (
        list.get(half),
        half.checked_sub(1).and_then(|before| list.get(before)),
    ) {
        (Some(middle), _) if odd => *middle,
        (Some(above), Some(below)) => (above + below) / 2.0,
        _ => 0.0,
    }
}

/// The reading farthest from the others, if it is an outlier.
///
/// A span depends on two flanks, so pitch of the range `F_p` changes it by at most `F_p`. Each of two pins moves by `F_r`. The effect
/// of the `known` flanks is removed first.
pub(super) fn of_readings(
    statement: &ThicknessStatement,
    basic_data: &BasicGearData,
    known: &Deviations,
) -> Option<ReadingOutlier> {
    let readings = statement.readings()?;
    let over_pins = matches!(statement, ThicknessStatement::PinReadings { .. });
    let plausible = if over_pins {
        2.0 * coarse_variation(GradedQuantity::Runout, basic_data)
    } else {
        coarse_variation(GradedQuantity::TotalPitch, basic_data)
    };
    let count = readings.len();
    let is_known = known.pitch.is_some() || !known.per_tooth.is_empty();
    // Readings without known flanks are judged unchanged.
    let beside = is_known.then(|| statement.compare(basic_data, known).ok());
    let said: Option<Vec<f64>> = beside
        .flatten()
        .map(|beside| beside.iter().map(|(_, said)| *said).collect());
    let said_of = said.clone().unwrap_or_else(|| vec![0.0; count]);
    let read_and_said = || readings.iter().zip(&said_of);
    let left = || read_and_said().map(|((_, mm), said)| mm - said);
    let middle = median(left());
    let apart = |mm: f64| (mm - middle).abs();
    let spread = median(left().map(apart));
    let each = readings.iter().zip(left());
    let (&(place, mm), left) = each.max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
    let why = if apart(left) > plausible {
        TooFar::CoarseGear(1000.0 * plausible)
    } else if count >= FEWEST && apart(left) > (STANDS_OUT * spread).max(THIMBLE_LINE) {
        TooFar::HalfWithin(1000.0 * spread)
    } else {
        return None;
    };
    Some(ReadingOutlier {
        over_pins,
        place,
        mm,
        off_um: 1000.0 * apart(left),
        median_mm: middle,
        readings: count,
        flanks_taken_out: said.is_some(),
        why,
    })
}

/// The value farthest from its neighbours (cumulative) or from the others (single), if it is an outlier.
///
/// An outlier exceeds the other values' distances and the difference of two neighbours on a coarse gear. A step in cumulative values,
/// as at the last tooth cut, is half its height off the mean of its neighbours.
pub(super) fn of_pitch(
    statement: &PitchStatement,
    basic_data: &BasicGearData,
) -> Option<PitchOutlier> {
    let coarse_um = 1000.0 * coarse_variation(GradedQuantity::SinglePitch, basic_data);
    let farthest = |flank: Flank| {
        let um = statement.values(flank);
        let off = distances_um(statement.kind, um);
        let half_within_um = median(off.iter().map(|off| off.abs()));
        let numbered = (1..).zip(um).zip(&off);
        let ((tooth, um), far) =
            numbered.max_by(|a: &((u32, &f64), &f64), b| a.1.abs().total_cmp(&b.1.abs()))?;
        let out = far.abs() > (STANDS_OUT * half_within_um).max(coarse_um) && off.len() >= FEWEST;
        out.then(|| PitchOutlier {
            flank,
            tooth,
            um: *um,
            off_um: far.abs(),
            from_neighbours: statement.kind == PitchKind::Cumulative,
            coarse_um,
            half_within_um,
        })
    };
    let both = Flank::BOTH.into_iter().filter_map(farthest);
    both.max_by(|a, b| a.off_um.total_cmp(&b.off_um))
}

/// Distance of each value from the others or from its neighbours, µm.
fn distances_um(kind: PitchKind, um: &[f64]) -> Vec<f64> {
    match kind {
        PitchKind::Single => {
            let middle = median(um.iter().copied());
            um.iter().map(|f| f - middle).collect()
        }
        PitchKind::Cumulative => {
            let (mut before, mut after) = (um.to_vec(), um.to_vec());
            // Rotating an empty list by 1 would panic.
            before.rotate_right(1.min(um.len()));
            after.rotate_left(1.min(um.len()));
            let beside = um.iter().zip(before.iter().zip(&after));
            beside.map(|(f, (b, a))| f - (b + a) / 2.0).collect()
        }
    }
}
