//! How far a flank stands out between two rolls, at once.

use crate::gear::{Part, PartCurve, RollCurve};

/// Stretches of roll that a flank is divided into (tuned: about as many as a dense trace has points).
const STRETCHES: usize = 256;

/// Of a curve of a few knots a flank is looked at in so many parts at least (tuned).
const FEWEST: f64 = 24.0;

/// A flank's deviation from its involute, and bounds of it over any rolls.
#[derive(Debug, Clone)]
pub(super) struct FlankHeights {
    low: f64,
    per_stretch: f64,
    /// A binary tree of greatest deviations, mm: entry `k` over what `2k` and `2k + 1` are over, the stretches from [`STRETCHES`] on.
    most: Vec<f64>,
    least: f64,
    fine: f64,
}

impl FlankHeights {
    /// Those of an involute, with or without deviations; `None` of other curves, and of flanks with edges.
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
                // A roll may be rounded into the next stretch.
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

    /// Over how much of the roll it bends to one side on average, or less, rad.
    pub fn fine(&self) -> f64 {
        self.fine
    }

    /// A bound of the deviation between two rolls of the flank, mm: its greatest there and in a few stretches beside.
    #[inline]
    pub fn most(&self, from: f64, to: f64) -> f64 {
        if self.most.is_empty() {
            return 0.0;
        }
        let stretch = |xi: f64| {
            let k = (xi - self.low) * self.per_stretch;
            // The cast takes what lies below for 0.
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

/// The deviation of a flank; `None` of an involute without.
pub(super) fn deviation(flank: &Part) -> Option<&RollCurve> {
    match &flank.curve {
        PartCurve::Modified(flank) => Some(flank.deviation()),
        _ => None,
    }
}
