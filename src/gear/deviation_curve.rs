//! A deviation `δ` of a flank, plus = more material: a piecewise cubic.
//!
//! A profile deviation counts along the involute's normal, over the roll `ξ`. A lead deviation counts along the transverse base tangent,
//! over the height along the axis. Both are constant before the first knot and after the last. The value is continuous. A profile's slope
//! is continuous except at the *edges* where a straight relief begins; a lead's may jump at any knot.

/// `δ(ξ)`, mm, of the roll, rad, or of the height, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct DeviationCurve {
    /// Rolls, ascending; at least two.
    knots: Vec<f64>,
    /// Cubic after each knot but the last: coefficients of the powers of `ξ − knot`.
    cubics: Vec<[f64; 4]>,
    /// Knots at which the slope jumps.
    edges: Vec<f64>,
    /// `None` for a curve that is only a part of a sum.
    index: Option<Index>,
}

/// Bounds and places of the stretches of a curve.
#[derive(Debug, Clone, PartialEq)]
struct Index {
    /// Bounds over all stretches.
    whole: [Interval; 3],
    /// Bounds over blocks of [`BLOCK`] stretches; empty for short curves.
    blocks: Vec<[Interval; 3]>,
    /// Number of knots before each of as many equal parts as there are knots; empty for short curves.
    before: Vec<u32>,
}

/// Stretches per block of bounds. Tuned: a measured trace has some thirty blocks.
const BLOCK: usize = 16;

/// Least and greatest value over an interval.
pub(super) type Interval = [f64; 2];

impl DeviationCurve {
    /// The polynomial in powers of `ξ − from` between two rolls, constant beyond.
    pub(super) fn polynomial([from, to]: [f64; 2], cubic: [f64; 4]) -> DeviationCurve {
        DeviationCurve {
            knots: vec![from, to],
            cubics: vec![cubic],
            edges: Vec::new(),
            index: None,
        }
    }

    /// This curve, extended by exactly 0 from its end to `to`.
    pub(super) fn zero_until(mut self, to: f64) -> DeviationCurve {
        self.knots.push(to);
        self.cubics.push([0.0; 4]);
        self
    }

    /// This curve with an edge at `edge`, one of its ends.
    pub(super) fn with_edge(mut self, edge: f64) -> DeviationCurve {
        self.edges.push(edge);
        self
    }

    /// The curve through points (roll, rad; deviation, mm) of strictly ascending roll, at least two.
    ///
    /// It interpolates by monotone cubics (Fritsch and Carlson). The slope at a point is the harmonic mean of the neighbouring chords'
    /// slopes, or 0 if their signs differ. The curve never leaves the range of the two points beside it: `2 s t/(s + t) ≤ 2 min(s, t)`
    /// keeps each end slope within three times the chord's, which makes the cubic monotone.
    pub(super) fn through(points: &[(f64, f64)]) -> DeviationCurve {
        let chords: Vec<f64> = points
            .windows(2)
            .map(|pair| (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0))
            .collect();
        let slope = |k: usize| match (k.checked_sub(1).map(|k| chords[k]), chords.get(k)) {
            (Some(s), Some(&t)) if s * t > 0.0 => 2.0 * s * t / (s + t),
            // Flat at the ends and at an extreme.
            _ => 0.0,
        };
        let cubic = |k: usize| {
            let (width, chord) = (points[k + 1].0 - points[k].0, chords[k]);
            let [from, to] = [slope(k), slope(k + 1)];
            let second = (3.0 * chord - 2.0 * from - to) / width;
            let third = (from + to - 2.0 * chord) / (width * width);
            [points[k].1, from, second, third]
        };
        DeviationCurve {
            knots: points.iter().map(|point| point.0).collect(),
            cubics: (0..chords.len()).map(cubic).collect(),
            edges: Vec::new(),
            index: None,
        }
    }

    /// The straight lines between points of strictly ascending place, at least two.
    pub(super) fn linear(points: &[(f64, f64)]) -> DeviationCurve {
        let lines = points.windows(2).map(|pair| {
            let [(from, start), (to, end)] = [pair[0], pair[1]];
            [start, (end - start) / (to - from), 0.0, 0.0]
        });
        DeviationCurve {
            knots: points.iter().map(|point| point.0).collect(),
            cubics: lines.collect(),
            edges: Vec::new(),
            index: None,
        }
        .with_index()
    }

    /// This curve with all values `more` greater.
    pub(super) fn raised(mut self, more: f64) -> DeviationCurve {
        for cubic in &mut self.cubics {
            cubic[0] += more;
        }
        if let Some(index) = &mut self.index {
            for bounds in index.blocks.iter_mut().chain([&mut index.whole]) {
                bounds[0] = bounds[0].map(|value| value + more);
            }
        }
        self
    }

    /// This curve with places and values multiplied by `factor`.
    pub(super) fn enlarged(&self, factor: f64) -> DeviationCurve {
        let times = [factor, 1.0, 1.0 / factor, 1.0 / (factor * factor)];
        DeviationCurve {
            knots: self.knots.iter().map(|knot| knot * factor).collect(),
            cubics: (self.cubics.iter())
                .map(|cubic| std::array::from_fn(|k| cubic[k] * times[k]))
                .collect(),
            edges: self.edges.iter().map(|edge| edge * factor).collect(),
            index: None,
        }
        .with_index()
    }

    /// Difference of its greatest and its least value.
    pub(crate) fn range(&self) -> f64 {
        let [from, to] = self.ends();
        let [least, most] = self.bounds(from, to)[0];
        most - least
    }

    /// The places between its cubics, ascending, with both ends.
    pub(crate) fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The sum of curves multiplied by their factors; 0 without curves.
    pub(super) fn sum(curves: &[(f64, &DeviationCurve)]) -> DeviationCurve {
        let of = |list: fn(&DeviationCurve) -> &Vec<f64>| {
            let all = curves.iter().flat_map(|(_, curve)| list(curve).iter());
            let mut all: Vec<f64> = all.copied().collect();
            all.sort_unstable_by(f64::total_cmp);
            all.dedup();
            all
        };
        let (knots, edges) = (of(|curve| &curve.knots), of(|curve| &curve.edges));
        let cubic = |pair: &[f64]| {
            // Each curve is one cubic between neighbouring knots of the sum.
            let middle = 0.5 * (pair[0] + pair[1]);
            curves.iter().fold([0.0; 4], |sum, (times, curve)| {
                let there = curve.cubic_at(middle, pair[0]);
                std::array::from_fn(|k| sum[k] + times * there[k])
            })
        };
        match knots.len() {
            0 => DeviationCurve::polynomial([0.0, 1.0], [0.0; 4]),
            _ => DeviationCurve {
                cubics: knots.windows(2).map(cubic).collect(),
                knots,
                edges,
                index: None,
            }
            .with_index(),
        }
    }

    /// This curve with its index.
    fn with_index(mut self) -> DeviationCurve {
        let (count, [first, last]) = (self.cubics.len() / BLOCK, self.ends());
        let (mut blocks, mut before) = (Vec::new(), Vec::new());
        if count > 1 {
            let block = |k: usize| {
                let (from, to) = (k * BLOCK, (k + 1) * BLOCK);
                self.bounds_of(from..to, self.knots[from], self.knots[to])
            };
            blocks.extend((0..count).map(block));
            let part = (last - first) / self.knots.len() as f64;
            before.extend((0..self.knots.len()).map(|k| {
                let from = first + part * k as f64;
                self.knots.partition_point(|&knot| knot <= from) as u32
            }));
        }
        self.index = Some(Index {
            whole: self.bounds_of(0..self.cubics.len(), first, last),
            blocks,
            before,
        });
        self
    }

    /// The first and the last knot.
    fn ends(&self) -> [f64; 2] {
        [self.knots[0], self.knots[self.knots.len() - 1]]
    }

    /// The cubic at `xi` in powers of `ξ − about`.
    fn cubic_at(&self, xi: f64, about: f64) -> [f64; 4] {
        match self.stretch(xi) {
            Err(held) => [held, 0.0, 0.0, 0.0],
            Ok(k) => {
                let h = about - self.knots[k];
                let [a, b, c, d] = self.cubics[k];
                [
                    a + h * (b + h * (c + h * d)),
                    b + h * (2.0 * c + 3.0 * h * d),
                    c + 3.0 * h * d,
                    d,
                ]
            }
        }
    }

    /// The stretch that contains `xi`, or the constant value there. A knot belongs to the stretch after it.
    #[inline]
    fn stretch(&self, xi: f64) -> Result<usize, f64> {
        match self.knots_before(xi) {
            0 => Err(self.cubics[0][0]),
            k if k < self.knots.len() => Ok(k - 1),
            _ => {
                let last = self.cubics.len() - 1;
                Err(at(&self.cubics[last], self.knots[last + 1] - self.knots[last])[0])
            }
        }
    }

    /// Number of knots up to `xi`.
    #[inline]
    fn knots_before(&self, xi: f64) -> usize {
        match &self.index {
            None => self.knots.partition_point(|&knot| knot <= xi),
            // Few knots are counted sooner than halved.
            Some(index) if index.before.is_empty() => {
                self.knots.iter().map(|&knot| usize::from(knot <= xi)).sum()
            }
            Some(index) => self.knots_before_by(&index.before, xi),
        }
    }

    /// [`DeviationCurve::knots_before`] by the parts of the index.
    fn knots_before_by(&self, parts: &[u32], xi: f64) -> usize {
        let (knots, [first, last]) = (&self.knots, self.ends());
        let per_part = knots.len() as f64 / (last - first);
        // The cast maps negative values to 0.
        let part = ((xi - first) * per_part) as usize;
        let mut before = parts[part.min(knots.len() - 1)] as usize;
        while before < knots.len() && knots[before] <= xi {
            before += 1;
        }
        // A roll may be rounded into the next part.
        while before > 0 && knots[before - 1] > xi {
            before -= 1;
        }
        before
    }

    /// `δ`, mm, its slope `δ'`, mm/rad, and `δ''` at the roll `xi`; at an edge, those of the greater rolls.
    #[inline]
    pub(crate) fn jet(&self, xi: f64) -> [f64; 3] {
        match self.stretch(xi) {
            Err(held) => [held, 0.0, 0.0],
            Ok(k) => at(&self.cubics[k], xi - self.knots[k]),
        }
    }

    /// `δ`, mm, at the roll `xi`, rad.
    pub fn at(&self, xi: f64) -> f64 {
        self.jet(xi)[0]
    }

    /// `δ'`, mm/rad, at the roll `xi`, rad; at an edge, that of the greater rolls.
    pub fn slope(&self, xi: f64) -> f64 {
        self.jet(xi)[1]
    }

    /// Number of knots between two rolls.
    pub(crate) fn knots_between(&self, low: f64, high: f64) -> usize {
        self.knots_before(high) - self.knots_before(low)
    }

    /// Rolls, ascending, between which the curve is one cubic that bends to one side; they include the edges.
    pub(crate) fn bends(&self) -> Vec<f64> {
        let ends = self.knots.windows(2).zip(&self.cubics);
        let turns = ends.filter_map(|(ends, [.., second, third])| {
            let turn = ends[0] - second / (3.0 * third);
            (turn > ends[0] && turn < ends[1]).then_some(turn)
        });
        let mut bends: Vec<f64> = self.knots.iter().copied().chain(turns).collect();
        bends.sort_unstable_by(f64::total_cmp);
        bends
    }

    /// Rolls at which the slope jumps, ascending.
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// This curve multiplied by `factor`.
    pub(super) fn scaled(&self, factor: f64) -> DeviationCurve {
        DeviationCurve::sum(&[(factor, self)])
    }

    /// Intervals in which `δ`, `δ'` and `δ''` lie over the rolls from `low` to `high`.
    pub(crate) fn bounds(&self, low: f64, high: f64) -> [Interval; 3] {
        let [start, end] = self.ends();
        let mut bounds = match &self.index {
            Some(index) if low <= start && high >= end => index.whole,
            index => {
                let blocks = index.as_ref().map_or(&[][..], |index| &index.blocks);
                self.bounds_of_blocks(blocks, low, high)
            }
        };
        for place in [low, high] {
            // Constant beyond the ends.
            if place < start || place >= end {
                let held = self.jet(place).map(|value| [value; 2]);
                bounds = both(bounds, held);
            }
        }
        bounds
    }

    /// [`DeviationCurve::bounds`] between its ends by those of its `blocks`.
    fn bounds_of_blocks(&self, blocks: &[[Interval; 3]], low: f64, high: f64) -> [Interval; 3] {
        let first = self.knots_before(low).max(1) - 1;
        let last = self.knots_before(high).min(self.cubics.len());
        // Whole blocks inside, and the stretches before and after them.
        let from = first.div_ceil(BLOCK).min(blocks.len());
        let to = (last / BLOCK).min(blocks.len());
        if from < to {
            let before = self.bounds_of(first..from * BLOCK, low, high);
            let behind = self.bounds_of(to * BLOCK..last, low, high);
            let inside = blocks[from..to].iter().copied();
            inside.fold(both(before, behind), both)
        } else {
            self.bounds_of(first..last, low, high)
        }
    }

    /// [`DeviationCurve::bounds`] over those of `stretches` that lie between the rolls.
    fn bounds_of(&self, stretches: std::ops::Range<usize>, low: f64, high: f64) -> [Interval; 3] {
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut take = |which: usize, value: f64| {
            let [least, most]: &mut Interval = &mut bounds[which];
            (*least, *most) = (least.min(value), most.max(value));
        };
        for k in stretches {
            let (from, to) = (self.knots[k].max(low), self.knots[k + 1].min(high));
            if from > to {
                continue;
            }
            let cubic = &self.cubics[k];
            let [from, to] = [from, to].map(|xi| xi - self.knots[k]);
            let inside = |xi: &f64| *xi > from && *xi < to;
            for end in [from, to] {
                for (which, value) in at(cubic, end).into_iter().enumerate() {
                    take(which, value);
                }
            }
            let [_, b, c, d] = *cubic;
            if c == 0.0 && d == 0.0 {
                continue;
            }
            // The slope is extreme at δ'' = 0, the deviation at δ' = 0.
            let flat = -c / (3.0 * d);
            let root = (c * c - 3.0 * b * d).sqrt();
            let still = [
                (-c + root) / (3.0 * d),
                (-c - root) / (3.0 * d),
                -b / (2.0 * c),
            ];
            if inside(&flat) {
                take(1, at(cubic, flat)[1]);
            }
            for place in still.into_iter().filter(inside) {
                take(0, at(cubic, place)[0]);
            }
        }
        bounds
    }
}

/// Intervals that contain both.
fn both(one: [Interval; 3], other: [Interval; 3]) -> [Interval; 3] {
    std::array::from_fn(|k| [one[k][0].min(other[k][0]), one[k][1].max(other[k][1])])
}

/// Value, slope and second derivative of a cubic.
#[inline]
fn at([a, b, c, d]: &[f64; 4], h: f64) -> [f64; 3] {
    [
        a + h * (b + h * (c + h * d)),
        b + h * (2.0 * c + 3.0 * h * d),
        2.0 * c + 6.0 * h * d,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points() -> impl Strategy<Value = Vec<(f64, f64)>> {
        let step = (0.01f64..0.2, -0.03f64..0.03);
        prop::collection::vec(step, 2..90).prop_map(|steps| {
            let mut roll = 0.1;
            let point = |(width, deviation)| {
                roll += width;
                (roll, deviation)
            };
            steps.into_iter().map(point).collect()
        })
    }

    proptest! {
        /// Source: the points, and Fritsch and Carlson's condition: a value between two points is within their range.
        #[test]
        fn goes_through_its_points_and_never_beyond(points in points()) {
            let curve = DeviationCurve::through(&points);
            for pair in points.windows(2) {
                let [(from, a), (to, b)] = [pair[0], pair[1]];
                for k in 0..=40 {
                    let value = curve.at(from + (to - from) * f64::from(k) / 40.0);
                    prop_assert!(value >= a.min(b) - 1e-15 && value <= a.max(b) + 1e-15);
                }
                prop_assert!((curve.at(from) - a).abs() < 1e-15 && (curve.at(to) - b).abs() < 1e-15);
            }
            prop_assert_eq!(curve.at(0.0), points[0].1);
            prop_assert!((curve.at(99.0) - points[points.len() - 1].1).abs() < 1e-15);
        }

        /// Values, slopes (by differences) and second derivatives of a sum within the bounds of any interval.
        #[test]
        fn lies_within_its_bounds(points in points(), more in points(), low in 0.0f64..4.0, width in 0.0f64..6.0) {
            let ramp = DeviationCurve::polynomial([0.3, 0.7], [0.0, -0.02, 0.01, 0.3]).with_edge(0.3);
            let [one, two] = [points, more].map(|points| DeviationCurve::through(&points));
            let curve = DeviationCurve::sum(&[(1.0, &one), (-0.5, &two), (2.0, &ramp)]);
            prop_assert_eq!(curve.edges(), &[0.3]);
            let found = |xi: f64| curve.knots_before(xi) == curve.knots.partition_point(|&knot| knot <= xi);
            prop_assert!(curve.knots.iter().all(|&knot| found(knot) && found(knot.next_up()) && found(knot.next_down())));
            let bounds = curve.bounds(low, low + width);
            for k in 0..=50 {
                let xi = low + width * f64::from(k) / 50.0;
                let jet = curve.jet(xi);
                let expected = one.at(xi) - 0.5 * two.at(xi) + 2.0 * ramp.at(xi);
                prop_assert!((jet[0] - expected).abs() < 1e-14);
                for (value, [least, most]) in jet.into_iter().zip(bounds) {
                    let rounding = 1e-12 * (1.0 + value.abs());
                    prop_assert!(value >= least - rounding && value <= most + rounding, "{xi} {jet:?} {bounds:?}");
                }
            }
        }
    }
}
