//! Charts of a population: histogram with limits, convergence of its share, contributions to its spread.

use super::captions::entry;
use super::panel::{Look, Mark, Panel, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};
use gearlash::population::{BIN_TENTHS_NM, Contributions, Spread, TENTHS_NM_PER_MM};
use gearlash_input::tolerance::{Convergence, ToleranceResult, shares};
use gearlash_text::numbers::{fixed, shortest};

const BARS: i64 = 120;
/// Height of the picture relative to the tallest bar: the names of three lines fit above.
const HEADROOM: f64 = 1.28;
/// How much lower each further line of a side ends, relative to the height of the picture.
const LOWER: f64 = 0.07;
/// Bin width of the sums, µm.
const BIN_UM: f64 = BIN_TENTHS_NM as f64 / TENTHS_NM_PER_MM * 1e3;

/// Least and greatest backlash over the population, with the limits required and the worst case; `None` where no assembly has a
/// backlash.
fn histogram(heading: &Heading, result: &ToleranceResult) -> Option<Chart> {
    let about = &result.about;
    let tally = &result.tally;
    let spreads = [
        ("least of each assembly", &tally.least, Look::Right),
        ("greatest", &tally.greatest, Look::Left),
    ];
    let ends = spreads.iter().flat_map(|(_, spread, _)| {
        let bins = spread.histogram.keys();
        [bins.clone().min().copied(), bins.max().copied()]
    });
    let ends: Vec<i64> = ends.flatten().collect();
    let (low, high) = (*ends.iter().min()?, *ends.iter().max()?);
    // A bar has a round whole number of bins.
    let least = (high - low) / BARS + 1;
    let rounds = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];
    let width = rounds.into_iter().find(|width| *width >= least);
    let width = width.unwrap_or(least);
    let bars = |spread: &Spread| {
        let mut bars = std::collections::BTreeMap::<i64, u64>::new();
        for (bin, count) in &spread.histogram {
            *bars.entry(bin.div_euclid(width)).or_default() += count;
        }
        bars
    };
    let um = |bar: i64| (bar * width) as f64 * BIN_UM;
    let mut marks = Vec::new();
    let mut most = 0;
    for (_, spread, look) in spreads {
        for (bar, count) in bars(spread) {
            most = most.max(count);
            let x = [um(bar), um(bar + 1)];
            marks.push(Mark::Bar(x, [0.0, count as f64], look));
        }
    }
    let top = HEADROOM * most as f64;
    let mut lines: Vec<(f64, String)> = Vec::new();
    for (limit, name) in [(about.min_mm, "min"), (about.max_mm, "max")] {
        lines.extend(limit.map(|mm| (1e3 * mm, format!("{name} {}", shortest(1e3 * mm)))));
    }
    if let Some([_, worst, roots]) = about.limit_cases {
        for (case, name) in [(worst, "worst case"), (roots, "root sum of squares")] {
            let case = case.into_iter().flatten();
            lines.extend(case.map(|mm| (1e3 * mm, name.to_owned())));
        }
    }
    let values = lines.iter().map(|line| line.0);
    let values = values.chain([um(low.div_euclid(width)), um(high.div_euclid(width) + 1)]);
    let x = range(values, [0.06; 2], BIN_UM).unwrap_or([0.0, 1.0]);
    let middle = 0.5 * (x[0] + x[1]);
    lines.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (left, right): (Vec<_>, Vec<_>) = lines.into_iter().partition(|line| line.0 < middle);
    // Names are placed inwards of their lines. Inner lines end lower, below the names of the outer ones.
    let left = left.into_iter().map(|line| (line, Anchor::Start, 5.0));
    let right = right.into_iter().rev();
    let right = right.map(|line| (line, Anchor::End, -5.0));
    for (rank, ((at, name), anchor, shift)) in left.enumerate().chain(right.enumerate()) {
        let height = top * (1.0 - LOWER * rank as f64);
        marks.push(Mark::upright(at, [0.0, height], Look::Limit, 1.4));
        marks.push(Mark::text([at, height], [shift, 8.0], name, anchor));
    }
    let entries = spreads.map(|(name, _, look)| entry(name, look, Swatch::Bar));
    let x = Axis::new("backlash j_wt over the whole mesh cycle, µm", x);
    let name = format!("assemblies in {} µm", shortest(width as f64 * BIN_UM));
    let panel = Panel::new(x, Axis::new(&name, [0.0, top]), 380.0, marks);
    Some(sheet::draw(heading, "", &entries, &[panel]))
}

/// The share that does not meet the requirement over the number of assemblies, with its interval.
///
/// # Errors
/// [`PictureError`] without a point.
fn convergence(heading: &Heading, course: &[Convergence]) -> Result<Chart, PictureError> {
    let points = |of: fn(&Convergence) -> f64| -> Vec<(f64, Option<f64>)> {
        let each = course.iter();
        each.map(|point| (point.assemblies as f64, Some(1e6 * of(point))))
            .collect()
    };
    let shares = points(|point| point.share.share);
    // For the first assemblies, the interval would fill the picture.
    let later = course.iter().skip(course.len() / 8);
    let highs = later.map(|point| 1e6 * point.share.high);
    let values = highs
        .chain(shares.iter().filter_map(|point| point.1))
        .chain([0.0]);
    let y = range(values, [0.0, 0.08], 1.0);
    let (Some(last), Some(y)) = (course.last(), y) else {
        return Err(PictureError("there are no assemblies".to_owned()));
    };
    let clipped = |of: fn(&Convergence) -> f64| {
        let each = points(of).into_iter();
        each.map(|(x, value)| (x, value.map(|value| value.min(y[1]))))
            .collect()
    };
    let edges = [
        clipped(|point| point.share.low),
        clipped(|point| point.share.high),
    ];
    let band = Mark::Band(edges, Look::Right, 0.2);
    let marks = vec![band, Mark::Line(shares, Look::Right, 1.8)];
    let name = "share so far, and its interval of 95 % (Clopper and Pearson)";
    let entries = [entry(name, Look::Right, Swatch::LineInBand(0.2))];
    let x = Axis::new("assemblies drawn", [0.0, last.assemblies as f64]);
    let y = Axis::new("outside the requirement, ppm", y);
    let panel = Panel::new(x, y, 320.0, marks);
    Ok(sheet::draw(heading, "", &entries, &[panel]))
}

/// Share of each quantity in the variance of an extreme: first-order and total effect, with whiskers of 2 standard errors; `None`
/// without a contribution.
fn contributions(heading: &Heading, found: &Contributions) -> Option<Chart> {
    if found.each.is_empty() {
        return None;
    }
    let mut each: Vec<_> = found.each.iter().collect();
    each.sort_by(|a, b| b.total.value.total_cmp(&a.total.value));
    let count = each.len() as f64;
    let ends = |sign: f64| {
        let both = each.iter().flat_map(|one| [one.first, one.total]);
        both.map(move |index| 100.0 * (index.value + sign * 2.0 * index.error))
    };
    let right = ends(1.0).fold(1.0, f64::max);
    let x = [ends(-1.0).fold(0.0, f64::min), 1.05 * right];
    let mut marks = Vec::new();
    for (place, one) in each.iter().enumerate() {
        let middle = count - place as f64 - 0.5;
        for (index, look, at) in [
            (one.total, Look::Right, middle + 0.04),
            (one.first, Look::Left, middle - 0.24),
        ] {
            let percent = 100.0 * index.value;
            let x = [percent.min(0.0), percent.max(0.0)];
            marks.push(Mark::Bar(x, [at - 0.12, at + 0.12], look));
            let error = 200.0 * index.error;
            let ends = [percent - error, percent + error];
            marks.push(Mark::level(ends, at, Look::Plain, 1.2));
        }
        let percent = fixed(100.0 * one.total.value, 1);
        let name = format!("{} {percent} %", one.factor.name());
        let name = Mark::text([0.0, middle + 0.32], [4.0, 0.0], name, Anchor::Start);
        marks.push(name);
    }
    marks.push(Mark::upright(0.0, [0.0, count], Look::Plain, 1.0));
    let entries = [
        ("with joint effects (total effect)", Look::Right),
        ("by itself (first-order effect)", Look::Left),
    ];
    let entries = entries.map(|(name, look)| entry(name, look, Swatch::Bar));
    let x = Axis::new("share of the variance, %; lines: ± 2 standard errors", x);
    let panel = Panel::new(x, Axis::bare([0.0, count]), 70.0 + 56.0 * count, marks);
    Some(sheet::draw(heading, "", &entries, &[panel]))
}

/// Pictures of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Pictures {
    /// Histogram with limits; `None` where no assembly has a backlash.
    pub histogram: Option<Chart>,
    /// The share outside the requirement over the number of assemblies.
    pub convergence: Chart,
    /// Contributions to the extreme that the requirement limits first; `None` where none were computed.
    pub contributions: Option<Chart>,
}

/// The pictures of `result`.
///
/// # Errors
/// None for a run of at least one assembly.
pub fn pictures(result: &ToleranceResult) -> Result<Pictures, PictureError> {
    let about = &result.about;
    // The contributions are a picture of their own.
    let first = shares(result);
    let heading = |prefix| Heading {
        prefix,
        title: &about.title,
        subtitle: &first,
    };
    let least = about.min_mm.is_some() || about.others.iter().any(|one| one.min.is_some());
    let most = about.max_mm.is_some() || about.others.iter().any(|one| one.max.is_some());
    let greatest = !least && most;
    let found = &result.contributions[usize::from(greatest)];
    let of = ["least", "greatest"][usize::from(greatest)];
    let subtitle = format!("What the spread of the {of} backlash comes from");
    let contributions = Heading {
        subtitle: &subtitle,
        ..heading("contributions")
    };
    Ok(Pictures {
        histogram: self::histogram(&heading("histogram"), result),
        convergence: self::convergence(&heading("convergence"), &result.convergence())?,
        contributions: self::contributions(&contributions, found),
    })
}
