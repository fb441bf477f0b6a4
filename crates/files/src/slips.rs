//! Slips: single values that lie far from all the others. They are told, and count as they stand.

use super::faults::Drawing;
use super::thickness::Statement;
use gearlash::gear::{BasicGearData, Deviations, GradedQuantity};

/// A value that stands out.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlier {
    /// Where the values stand.
    pub key: String,
    /// Which one it is.
    pub what: String,
    /// From what it lies how far.
    pub off: String,
    /// Why that is too far.
    pub why: String,
}

impl Outlier {
    /// As a warning.
    pub fn told(&self) -> String {
        let Outlier {
            key,
            what,
            off,
            why,
        } = self;
        format!("{key}: {what} lies {off}, {why}: check it; it counts as it stands")
    }

    /// As the end of a way out of something that cannot be.
    pub fn suspected(&self) -> String {
        format!(", above all {}: it lies {}", self.what, self.off)
    }
}

/// Median absolute deviations by which a value stands out: for normal values 5.4 standard deviations, one in ten million; the
/// crest of a wave lies 1.4 of them out, the end of an even spread 2. Tuned.
pub const STANDS_OUT: f64 = 8.0;
/// Least distance of a reading that counts as a slip among readings that hardly differ, mm. Tuned: a slip of a micrometer's
/// thimble line is 10 µm, less the noise of 1 µm or two.
const THIMBLE_LINE: f64 = 0.008;
/// Fewest values of which the median tells what the others do.
pub const FEWEST: usize = 7;

/// By how much the values of even a coarse gear vary, mm: the tolerance of grade 11, the coarsest of ISO 1328-1, with its
/// source in [`GradedQuantity`]; a tenth of the module where there is none.
pub fn coarse(quantity: GradedQuantity, basic_data: &BasicGearData) -> f64 {
    let last = *gearlash::gear::GRADES.end();
    let tolerance = quantity.tolerance(basic_data, last);
    tolerance.unwrap_or(0.1 * basic_data.module())
}

/// The middle value, or the mean of both; 0 of none.
pub fn median(values: impl Iterator<Item = f64>) -> f64 {
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

/// The reading all round that lies farthest from the others, where that is too far.
///
/// A span holds two flanks, so teeth of the range `F_p` move it by no more than that; either of two pins stands out by `F_r`. What
/// the `known` flanks make of a reading is taken out of it first: a tooth that stands off is no slip of the reading.
pub fn in_readings(drawing: &Drawing, known: &Deviations) -> Option<Outlier> {
    let basic_data = &drawing.design.basic_data;
    let (name, place, plausible) = match &drawing.statement {
        Statement::Spans { .. } => (
            "span",
            "tooth",
            coarse(GradedQuantity::TotalPitch, basic_data),
        ),
        Statement::Pins { .. } => (
            "over_pins",
            "space",
            2.0 * coarse(GradedQuantity::Runout, basic_data),
        ),
        _ => return None,
    };
    let readings = drawing.statement.readings()?;
    let count = readings.count();
    let is_known = known.pitch.is_some() || !known.per_tooth.is_empty();
    // Readings that no flanks explain are judged as they stand.
    let beside = is_known.then(|| drawing.statement.beside(basic_data, known).ok());
    let said: Option<Vec<f64>> = beside
        .flatten()
        .map(|beside| beside.iter().map(|(_, said)| *said).collect());
    let said_of = said.clone().unwrap_or_else(|| vec![0.0; count]);
    let left = || {
        readings
            .list()
            .zip(&said_of)
            .map(|((_, mm), said)| mm - said)
    };
    let middle = median(left());
    let apart = |mm: f64| (mm - middle).abs();
    let spread = median(left().map(apart));
    let ((number, mm), left) = readings
        .list()
        .zip(left())
        .max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
    let why = if apart(left) > plausible {
        format!(
            "more than the {:.0} µm by which even a coarse gear varies",
            1000.0 * plausible
        )
    } else if count >= FEWEST && apart(left) > (STANDS_OUT * spread).max(THIMBLE_LINE) {
        format!("half of them within {:.1} µm", 1000.0 * spread)
    } else {
        return None;
    };
    Some(Outlier {
        key: drawing.table.path_of(&format!("{}.{name}", drawing.under)),
        what: format!("the reading at {place} {number}, {mm} mm,"),
        off: format!(
            "{:.1} µm from the median of all {count}, {}",
            1000.0 * apart(left),
            match said {
                None => format!("{middle} mm"),
                Some(_) => format!("{middle:.4} mm, once what the stated flanks do is taken out"),
            }
        ),
        why,
    })
}
