//! Single values that lie far from all the others. They are reported, and count as they stand.

use super::finding::{PitchOutlier, ReadingOutlier, TooFar};
use super::pitch_statement::{PitchKind, PitchStatement};
use super::statement::ThicknessStatement;
use crate::gear::{BasicGearData, Deviations, Flank, GradedQuantity};

/// Median absolute deviations by which a value stands out: for normal values 5.4 standard deviations, one in ten million; the
/// crest of a wave lies 1.4 of them out, the end of an even spread 2. Tuned.
const STANDS_OUT: f64 = 8.0;
/// Least distance of a reading that counts as an outlier among readings that hardly differ, mm. Tuned: a slip of a micrometer's
/// thimble line is 10 µm, less the noise of 1 µm or two.
const THIMBLE_LINE: f64 = 0.008;
/// Fewest values of which the median tells what the others do.
const FEWEST: usize = 7;

/// By how much the values of even a coarse gear vary, mm: the tolerance of grade 11, the coarsest of ISO 1328-1, with its
/// source in [`GradedQuantity`]; a tenth of the module where there is none.
fn coarse(quantity: GradedQuantity, basic_data: &BasicGearData) -> f64 {
    let last = *crate::gear::GRADES.end();
    let tolerance = quantity.tolerance(basic_data, last);
    tolerance.unwrap_or(0.1 * basic_data.module())
}

/// The middle value, or the mean of both; 0 of none.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut list: Vec<f64> = values.collect();
    list.sort_by(f64::total_cmp);
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

impl ThicknessStatement {
    /// The reading that lies farthest from the others, where that is too far.
    ///
    /// A span holds two flanks, so teeth of the range `F_p` move it by no more than that; either of two pins stands out by `F_r`. What
    /// the `known` flanks make of a reading is taken out of it first: a tooth that stands off is no slip of the reading.
    pub fn outlier(
        &self,
        basic_data: &BasicGearData,
        known: &Deviations,
    ) -> Option<ReadingOutlier> {
        let readings = self.readings()?;
        let over_pins = matches!(self, ThicknessStatement::PinReadings { .. });
        let plausible = match over_pins {
            false => coarse(GradedQuantity::TotalPitch, basic_data),
            true => 2.0 * coarse(GradedQuantity::Runout, basic_data),
        };
        let count = readings.len();
        let is_known = known.pitch.is_some() || !known.per_tooth.is_empty();
        // Readings that no flanks explain are judged as they stand.
        let beside = is_known.then(|| self.beside(basic_data, known).ok());
        let said: Option<Vec<f64>> = beside
            .flatten()
            .map(|beside| beside.iter().map(|(_, said)| *said).collect());
        let said_of = said.clone().unwrap_or_else(|| vec![0.0; count]);
        let left = || {
            readings
                .iter()
                .zip(&said_of)
                .map(|((_, mm), said)| mm - said)
        };
        let middle = median(left());
        let apart = |mm: f64| (mm - middle).abs();
        let spread = median(left().map(apart));
        let (&(place, mm), left) = readings
            .iter()
            .zip(left())
            .max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
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
}

impl PitchStatement {
    /// The value that lies farthest from its neighbours (cumulative) or from the others (single), where that is more than all the
    /// others do and than two neighbours of even a coarse gear differ.
    ///
    /// A step in cumulative values, such as the last tooth cut leaves, lies half its height off either neighbours' mean.
    pub fn outlier(&self, basic_data: &BasicGearData) -> Option<PitchOutlier> {
        let coarse_um = 1000.0 * coarse(GradedQuantity::SinglePitch, basic_data);
        let farthest = |flank: Flank| {
            let um = self.values(flank);
            let off = self.off(um);
            let half_within_um = median(off.iter().map(|off| off.abs()));
            let numbered = (1..).zip(um).zip(&off);
            let ((tooth, um), far) =
                numbered.max_by(|a: &((u32, &f64), &f64), b| a.1.abs().total_cmp(&b.1.abs()))?;
            let out =
                far.abs() > (STANDS_OUT * half_within_um).max(coarse_um) && off.len() >= FEWEST;
            out.then(|| PitchOutlier {
                flank,
                tooth,
                um: *um,
                off_um: far.abs(),
                from_neighbours: self.kind == PitchKind::Cumulative,
                coarse_um,
                half_within_um,
            })
        };
        Flank::BOTH
            .into_iter()
            .filter_map(farthest)
            .max_by(|a, b| a.off_um.total_cmp(&b.off_um))
    }

    /// How far each value lies off, µm.
    fn off(&self, um: &[f64]) -> Vec<f64> {
        match self.kind {
            PitchKind::Single => {
                let middle = median(um.iter().copied());
                um.iter().map(|f| f - middle).collect()
            }
            PitchKind::Cumulative => {
                let (mut before, mut after) = (um.to_vec(), um.to_vec());
                // Of no teeth nothing can be turned.
                before.rotate_right(1.min(um.len()));
                after.rotate_left(1.min(um.len()));
                let beside = before.iter().zip(&after);
                um.iter()
                    .zip(beside)
                    .map(|(f, (b, a))| f - (b + a) / 2.0)
                    .collect()
            }
        }
    }
}
