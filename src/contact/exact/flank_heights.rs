//! Bounds of a flank's deviation between two rolls, from a table.

use crate::gear::{DeviationCurve, Part, PartCurve};

/// Stretches of roll in the table of a flank (tuned: about as many as a dense trace has points).
const STRETCHES: usize = 256;

/// Least number of parts of a flank with few knots (tuned).
const FEWEST: f64 = 24.0;

/// A flank's deviation from its involute, with bounds over any rolls.
#[derive(Debug, Clone)]
pub(super) struct FlankHeights {
    low: f64,
    per_stretch: f64,
    /// A binary tree of greatest deviations, mm. Entry `k` covers the range of `2k` and `2k + 1`; the stretches start at [`STRETCHES`].
    most: Vec<f64>,
    least: f64,
    fine: f64,
}

impl FlankHeights {
    /// The table of an involute with or without deviations; `None` for flanks with edges.
    pub fn new(flank: &Part) -> Option<FlankHeights> {
        let (low, high) = flank.range();
        let mut heights = FlankHeights {
            low,
            per_stretch: STRETCHES as f64 / (high - low),
            most: Vec::new(),
            least: 0.0,
            fine: (high - low) / FEWEST,
        };
        match &flank.curve {
            PartCurve::Involute(_) => (),
            PartCurve::Modified(curve) if curve.deviation().edges().is_empty() => {
                let deviation = curve.deviation();
                let width = (high - low) / STRETCHES as f64;
                // A roll can be rounded into the next stretch.
                let play = 1e-6 * width;
                let mut most = vec![0.0; 2 * STRETCHES];
                for k in 0..STRETCHES {
                    let from = low + width * k as f64 - play;
                    let [[least, greatest], ..] = deviation.bounds(from, from + width + 2.0 * play);
                    heights.least = match k {
                        0 => least,
                        _ => heights.least.min(least),
                    };
                    most[STRETCHES + k] = greatest;
                }
                for k in (1..STRETCHES).rev() {
                    most[k] = most[2 * k].max(most[2 * k + 1]);
                }
                heights.most = most;
                let knots = deviation.knots_between(low, high) as f64;
                heights.fine = (high - low) / knots.clamp(FEWEST, STRETCHES as f64);
            }
            _ => return None,
        }
        Some(heights)
    }

    /// Roll, rad, over which the deviation keeps the sign of its curvature on average, or less.
    pub fn fine(&self) -> f64 {
        self.fine
    }

    /// A bound of the deviation between two rolls, mm: the greatest value there and in the stretches beside them.
    #[inline]
    pub fn most(&self, from: f64, to: f64) -> f64 {
        if self.most.is_empty() {
            return 0.0;
        }
        let stretch = |xi: f64| {
            let k = (xi - self.low) * self.per_stretch;
            // The cast turns negative values into 0.
            STRETCHES + (k as usize).min(STRETCHES - 1)
        };
        let (mut first, mut last) = (stretch(from), stretch(to));
        while last - first > 2 {
            (first, last) = (first / 2, last / 2);
        }
        let all = self.most[first..=last].iter().copied();
        all.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Greatest and least deviation, mm.
    pub fn whole(&self) -> [f64; 2] {
        [self.most.get(1).copied().unwrap_or(0.0), self.least]
    }
}

/// The deviation of a flank; `None` for an involute without any.
pub(super) fn deviation(flank: &Part) -> Option<&DeviationCurve> {
    match &flank.curve {
        PartCurve::Modified(flank) => Some(flank.deviation()),
        _ => None,
    }
}

/// Greatest amount of a value in an interval.
pub(super) fn amount([least, most]: [f64; 2]) -> f64 {
    least.abs().max(most.abs())
}
