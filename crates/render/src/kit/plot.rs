//! A plot: data in a frame, with axes, ticks and a grid.

use super::frame::{Frame, Spot};
use super::marks::turned;
use super::paint::{GRID, INK};
use super::scale::{decade, power};
use super::sheet::line;
use super::text::TextStyle;
use gearlash_text::numbers::fixed;
use svg::node::Node;
use svg::node::element::Group;

/// The frame of a plot and the data at its edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plot {
    /// Its edges, units of the `viewBox`.
    pub frame: Frame,
    /// Data at the left and at the right edge.
    pub x: [f64; 2],
    /// Data at the lower and at the upper edge.
    pub y: [f64; 2],
}

impl Plot {
    /// The place of data on the sheet.
    pub(crate) fn spot(&self, (x, y): (f64, f64)) -> Spot {
        let part = |[from, to]: [f64; 2], value: f64| (value - from) / (to - from);
        [
            self.frame.left + part(self.x, x) * self.frame.width(),
            self.frame.bottom - part(self.y, y) * self.frame.height(),
        ]
    }

    /// The place of the data between two values of x and of y.
    pub(crate) fn between(&self, x: [f64; 2], y: [f64; 2]) -> Frame {
        let ([left, bottom], [right, top]) = (self.spot((x[0], y[0])), self.spot((x[1], y[1])));
        Frame::new([left, top], [right, bottom])
    }

    /// Units of the sheet per unit of data, across and up.
    pub(crate) fn scale(&self) -> [f64; 2] {
        [
            self.frame.width() / (self.x[1] - self.x[0]),
            self.frame.height() / (self.y[1] - self.y[0]),
        ]
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub name: String,
    /// Data at both ends.
    pub range: [f64; 2],
    /// The number of teeth where the axis is a tooth number. Numbers beyond it start again.
    pub teeth: Option<u32>,
    /// No numbers and no grid, because there are no values.
    pub bare: bool,
}

impl Axis {
    pub fn new(name: &str, range: [f64; 2]) -> Axis {
        Axis {
            name: name.to_owned(),
            range,
            teeth: None,
            bare: false,
        }
    }

    /// An axis of tooth numbers where `teeth` is stated.
    pub fn of_teeth(name: &str, range: [f64; 2], teeth: Option<u32>) -> Axis {
        let axis = Axis::new(name, range);
        Axis { teeth, ..axis }
    }

    /// An axis without a name and numbers.
    pub fn bare(range: [f64; 2]) -> Axis {
        let axis = Axis::new("", range);
        Axis { bare: true, ..axis }
    }

    /// Its ticks: at most `most`, and none between two teeth.
    pub fn ticks(&self, most: usize) -> Ticks {
        let [from, to] = self.range;
        match (self.bare, self.teeth) {
            (true, _) => Ticks::new(self.range, 0),
            (false, Some(_)) => Ticks::new(self.range, usize::clamp((to - from) as usize, 1, most)),
            (false, None) => Ticks::new(self.range, most),
        }
    }

    pub fn number(&self, ticks: &Ticks, value: f64) -> String {
        match self.teeth {
            None => ticks.number(value),
            Some(teeth) => {
                let tooth = (value.round() as i64 - 1).rem_euclid(i64::from(teeth.max(1))) + 1;
                tooth.to_string()
            }
        }
    }
}

/// Ticks at round values of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Ticks {
    /// Their values, ascending.
    pub at: Vec<f64>,
    decimals: usize,
}

impl Ticks {
    /// At most `most` ticks within `range`, on multiples of 1, 2 or 5 times a power of ten, with as many decimals as that step
    /// needs.
    pub fn new([low, high]: [f64; 2], most: usize) -> Ticks {
        // A tick at an end is kept despite rounding: a millionth of a step is invisible.
        let ends = |step: f64| [(low / step - 1e-6).ceil(), (high / step + 1e-6).floor()];
        let count = |step: f64| {
            let [first, last] = ends(step);
            last - first + 1.0
        };
        // Every third of `place` is a decade.
        let step =
            |place: i32| [1.0, 2.0, 5.0][place.rem_euclid(3) as usize] * power(place.div_euclid(3));
        // Start at ten times the width, which has one tick at most.
        let mut place = 3 * (decade((high - low).max(f64::MIN_POSITIVE)) + 2);
        // The resolution of f64 is the limit.
        let finest = f64::EPSILON * 8.0 * low.abs().max(high.abs());
        while count(step(place - 1)) <= most as f64 && step(place - 1) > finest {
            place -= 1;
        }
        let [first, last] = ends(step(place));
        let ticks = if most == 0 {
            0
        } else {
            (last - first + 1.0).max(0.0) as u32
        };
        // Divide by a whole number where the step is a fraction, so that the tick is nearest to its printed number.
        let (mantissa, decade) = (step(place.rem_euclid(3)), place.div_euclid(3));
        let value = |number: u32| {
            let units = (first + f64::from(number)) * mantissa;
            match decade {
                0.. => units * power(decade),
                _ => units / power(-decade),
            }
        };
        Ticks {
            at: (0..ticks).map(value).collect(),
            decimals: usize::try_from(-decade).unwrap_or(0),
        }
    }

    pub fn number(&self, value: f64) -> String {
        fixed(value, self.decimals)
    }
}

pub const NUMBERS: TextStyle = TextStyle::new(12.0);
const NAMES: TextStyle = TextStyle::new(13.0);
const TICK: f64 = 4.0;

/// Lines across a plot at the ticks of both axes, at most `most` of each.
pub fn grid(plot: &Plot, [x, y]: [&Axis; 2], most: [usize; 2]) -> Group {
    let mut group = Group::new();
    for value in x.ticks(most[0]).at {
        let x = plot.spot((value, plot.y[0]))[0];
        group.append(line(
            &[[x, plot.frame.top], [x, plot.frame.bottom]],
            GRID,
            0.8,
        ));
    }
    for value in y.ticks(most[1]).at {
        let y = plot.spot((plot.x[0], value))[1];
        group.append(line(
            &[[plot.frame.left, y], [plot.frame.right, y]],
            GRID,
            0.8,
        ));
    }
    group
}

/// Axes at the left and below with at most `most` ticks each, numbers and names.
pub fn axes(plot: &Plot, [x, y]: [&Axis; 2], most: [usize; 2]) -> Group {
    let Frame {
        left,
        right,
        top,
        bottom,
    } = plot.frame;
    let mut group = Group::new().add(line(&[[left, bottom], [right, bottom]], INK, 1.0));
    if !y.bare {
        group.append(line(&[[left, top], [left, bottom]], INK, 1.0));
    }
    let ticks = x.ticks(most[0]);
    for &value in &ticks.at {
        let at = plot.spot((value, plot.y[0]))[0];
        group.append(line(&[[at, bottom], [at, bottom + TICK]], INK, 1.0));
        let number = x.number(&ticks, value);
        group.append(NUMBERS.middle().text(&number, [at, bottom + 17.0]));
    }
    let ticks = y.ticks(most[1]);
    for &value in &ticks.at {
        let at = plot.spot((plot.x[0], value))[1];
        group.append(line(&[[left - TICK, at], [left, at]], INK, 1.0));
        let foot = at + NUMBERS.below_middle();
        let number = y.number(&ticks, value);
        group.append(NUMBERS.end().text(&number, [left - 8.0, foot]));
    }
    let [middle_x, middle_y] = plot.frame.middle();
    if !x.name.is_empty() {
        let style = NAMES.middle().fitted(&x.name, right - left, 9.0);
        group.append(style.text(&x.name, [middle_x, bottom + 37.0]));
    }
    if !y.name.is_empty() {
        let values = ticks.at.iter();
        let numbers = values.map(|value| NUMBERS.width(&y.number(&ticks, *value)));
        // Left of the widest number, with the distance of a sheet's edge from its plots.
        let foot = left - numbers.fold(44.0, f64::max).min(56.0) - 12.0;
        let style = NAMES.middle().fitted(&y.name, bottom - top + 40.0, 9.0);
        let at = [foot, middle_y];
        group.append(turned(style.text(&y.name, at), at));
    }
    group
}

#[cfg(test)]
mod tests {
    use super::Ticks;
    use proptest::prelude::*;
    use std::collections::HashSet;

    /// Every tick prints its own value, and no two print the same.
    fn assert_labels_distinct(range: [f64; 2], most: usize) {
        let ticks = Ticks::new(range, most);
        assert!(ticks.at.len() <= most, "{ticks:?}");
        let step = ticks.at.windows(2).map(|pair| pair[1] - pair[0]);
        let step = step.fold(f64::INFINITY, f64::min);
        let mut seen = HashSet::new();
        for value in &ticks.at {
            let text = ticks.number(*value);
            let read: f64 = text.replace('−', "-").parse().unwrap();
            let decimals = text.split_once('.').map_or(0, |(_, digits)| digits.len());
            let last = 10f64.powi(-(decimals as i32));
            assert!((read - value).abs() <= 0.5 * last, "{text} at {value}");
            assert!((read - value).abs() <= 1e-3 * step, "{text}, step {step}");
            assert!(seen.insert(text.clone()), "{text} twice: {:?}", ticks.at);
            let slack = 1e-5 * (range[1] - range[0]);
            let within = range[0] - slack..=range[1] + slack;
            assert!(within.contains(value), "{value} in {range:?}");
        }
    }

    /// Review of issue 6: half micrometres without a decimal read 0, 0, −1, −1, −2, −2, −3.
    #[test]
    fn half_micrometres_have_a_decimal() {
        assert_labels_distinct([-3.36, 0.3], 8);
        let ticks = Ticks::new([-3.36, 0.3], 8);
        assert!(ticks.at.iter().any(|value| ticks.number(*value) == "−0.5"));
    }

    /// By hand: steps of 0.05 would be five.
    #[test]
    fn ticks_are_as_many_as_there_is_room_for() {
        assert_eq!(Ticks::new([0.0, 0.2], 4).at, [0.0, 0.1, 0.2]);
        assert_eq!(Ticks::new([0.0, 0.2], 5).at, [0.0, 0.05, 0.1, 0.15, 0.2]);
        assert!(Ticks::new([0.0, 0.2], 0).at.is_empty());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn numbers_are_distinct_and_those_of_their_ticks(
            middle in -1000.0..1000.0f64, digits in 1.0..9.99f64, power in -4..4i32, most in 2..15usize,
        ) {
            let half = 0.5 * digits * 10f64.powi(power);
            assert_labels_distinct([middle - half, middle + half], most);
            // Zero is included, as in a chart of differences.
            assert_labels_distinct([-1.8 * half, 0.2 * half], most);
        }
    }
}
