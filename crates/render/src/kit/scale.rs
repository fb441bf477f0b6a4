//! Round scales and the bars that show them.

use super::frame::Spot;
use super::paint::INK;
use super::sheet::{UNITS_PER_MM, line};
use super::text::TextStyle;
use gearlash_text::numbers::rounded;
use svg::node::element::Group;

/// Mantissas of scales: 1, 2 and 5 by ISO 5455.
pub const ISO_5455: &[f64] = &[1.0, 2.0, 5.0];
/// A finer series for a view that should fill its frame.
pub const FINE: &[f64] = &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0];

/// The greatest scale `n : 1` or `1 : n` with `n` of the `series` that is at most `limit` (> 0).
pub fn at_most(limit: f64, series: &[f64]) -> f64 {
    if limit >= 1.0 {
        return round_down(limit, series);
    }
    1.0 / round_up(1.0 / limit, series)
}

/// The least number of the `series`, times a power of ten, that is at least `limit` (> 0).
pub fn round_up(limit: f64, series: &[f64]) -> f64 {
    let power = power(decade(limit));
    let mut numbers = series.iter().map(|mantissa| mantissa * power);
    numbers.find(|n| *n >= limit).unwrap_or(10.0 * power)
}

/// The greatest number of the `series`, times a power of ten, that is at most `limit` (> 0).
pub fn round_down(limit: f64, series: &[f64]) -> f64 {
    let power = power(decade(limit));
    let fits = |mantissa: &&f64| **mantissa * power <= limit;
    series.iter().rfind(fits).unwrap_or(&1.0) * power
}

/// The greatest `n` with `10^n ≤ x` (> 0), by comparison: the last digit of a logarithm can differ between machines.
pub fn decade(x: f64) -> i32 {
    let mut decade = 0;
    while x < power(decade) {
        decade -= 1;
    }
    while x >= power(decade + 1) {
        decade += 1;
    }
    decade
}

/// `10^decade`, exactly rounded.
pub fn power(decade: i32) -> f64 {
    match decade {
        0.. => 10f64.powi(decade),
        _ => 1.0 / 10f64.powi(-decade),
    }
}

/// `20 : 1` or `1 : 5`, for `scale` units of the sheet per millimetre.
pub fn ratio(scale: f64) -> String {
    let ratio = scale / UNITS_PER_MM;
    let tidy = |x: f64| rounded(x, 3).to_string();
    if ratio >= 1.0 {
        format!("{} : 1", tidy(ratio))
    } else {
        format!("1 : {}", tidy(1.0 / ratio))
    }
}

/// A bar of a round length between 60 and 150 units at `scale` units per millimetre, with its length and the scale as text on its
/// right; `at` is its left end.
pub fn bar(at: Spot, scale: f64) -> Group {
    let length = round_down(150.0 / scale, ISO_5455);
    let width = length * scale;
    let [x, y] = at;
    let caption = format!("{} · {}", length_text(length), ratio(scale));
    let tick = |x: f64| line(&[[x, y - 4.0], [x, y + 4.0]], INK, 1.2);
    let caption = TextStyle::new(13.0)
        .grey()
        .text(&caption, [x + width + 10.0, y + 4.5]);
    Group::new()
        .add(line(&[at, [x + width, y]], INK, 3.0))
        .add(tick(x))
        .add(tick(x + width))
        .add(caption)
}

/// A round length in the unit that needs few digits.
fn length_text(mm: f64) -> String {
    let (value, unit) = match mm {
        _ if mm >= 1000.0 => (mm / 1000.0, "m"),
        _ if mm >= 0.1 => (mm, "mm"),
        _ if mm >= 1e-4 => (mm * 1e3, "µm"),
        _ => (mm * 1e6, "nm"),
    };
    format!("{} {unit}", rounded(value, 3))
}
