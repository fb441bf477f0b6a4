//! Numbers as text for people: one place for decimals, minus signs, raised digits and bounds.
//!
//! Pages and pictures have the true minus `−`, a terminal has ASCII's, because users paste its text elsewhere. Neither has a
//! negative zero. Lengths are given in mm; functions with µm in their name multiply by 1000. Results for programs are not written
//! here: JSON and CSV hold the shortest text that reads back to the same f64.

use gearlash::analysis::requirement::Quantity;
use gearlash::pair::{BacklashUnit, Member, arcmin};

/// Stands for a missing value.
pub const NONE: &str = "–";

/// `value` with `decimals` decimals and a true minus sign; a dash for none.
pub fn fixed(value: impl Into<Option<f64>>, decimals: usize) -> String {
    match value.into() {
        Some(value) => true_minus(format!("{value:.decimals$}")),
        None => NONE.to_owned(),
    }
}

/// [`fixed`] in ASCII.
pub fn ascii(value: impl Into<Option<f64>>, decimals: usize) -> String {
    fixed(value, decimals).replace('−', "-")
}

/// Both values as [`ascii`], with as many more decimals as tell them apart.
pub fn distinct_digits(values: [f64; 2], decimals: usize) -> [String; 2] {
    let texts = |decimals| values.map(|value| ascii(value, decimals));
    let mut each = (decimals..16).map(texts);
    let apart = each.find(|[one, other]| one != other);
    apart.unwrap_or_else(|| texts(decimals))
}

/// A length in µm with `decimals` decimals and a true minus sign; a dash for none.
pub fn um(length_mm: impl Into<Option<f64>>, decimals: usize) -> String {
    fixed(length_mm.into().map(|mm| mm * 1e3), decimals)
}

/// [`um`] in ASCII.
pub fn um_ascii(length_mm: impl Into<Option<f64>>, decimals: usize) -> String {
    ascii(length_mm.into().map(|mm| mm * 1e3), decimals)
}

/// A length in µm with `decimals` decimals and its sign, plus or minus, in ASCII; zero has none.
pub fn signed_um(length_mm: f64, decimals: usize) -> String {
    signed(length_mm * 1e3, decimals)
}

/// `value` with `decimals` decimals and its sign, plus or minus, in ASCII; zero has none.
pub fn signed(value: f64, decimals: usize) -> String {
    let text = ascii(value, decimals);
    if text.contains(|digit: char| ('1'..='9').contains(&digit)) && !text.starts_with('-') {
        format!("+{text}")
    } else {
        text
    }
}

/// A backlash `j_wt` at centre distance `a`, mm, in `unit`, with a true minus sign; a dash for none. Arcmin have one decimal more
/// than µm: one arcmin is about 10 to 20 µm at gears of usual size.
pub fn backlash(
    unit: BacklashUnit,
    j_wt_um: impl Into<Option<f64>>,
    a: f64,
    decimals: usize,
) -> String {
    let more = usize::from(unit != BacklashUnit::Um);
    let value = j_wt_um.into().map(|um| unit.of_um(um, a));
    fixed(value, decimals + more)
}

/// [`backlash`] in ASCII.
pub fn backlash_ascii(
    unit: BacklashUnit,
    j_wt_um: impl Into<Option<f64>>,
    a: f64,
    decimals: usize,
) -> String {
    backlash(unit, j_wt_um, a, decimals).replace('−', "-")
}

/// `value` in the fewest digits that read back to the same number, with a true minus sign, as a user writes it.
pub fn shortest(value: f64) -> String {
    true_minus(format!("{value}"))
}

/// `value` with at least `least` and at most `most` decimals, without trailing zeros beyond `least`.
pub fn trimmed(value: f64, least: usize, most: usize) -> String {
    let mut text = fixed(value, most);
    let whole = text.len() - most;
    while text.len() > whole + least && text.ends_with('0') {
        text.pop();
    }
    text.trim_end_matches('.').to_owned()
}

/// A centre distance as stated: three decimals, or as many as it has, up to six. More would show how it is computed, such as from
/// inches or at a temperature.
pub fn stated_distance(mm: f64) -> String {
    trimmed(mm, 3, 6)
}

/// Name and unit of a quantity, the number of units per mm (rad), and its decimals.
pub fn unit_of(quantity: Quantity) -> (&'static str, &'static str, f64, usize) {
    match quantity {
        Quantity::OperatingBacklash => ("j_wt", "µm", 1e3, 2),
        Quantity::ReferenceBacklash => ("j_t", "µm", 1e3, 2),
        Quantity::NormalBacklash => ("j_bn", "µm", 1e3, 2),
        Quantity::RadialBacklash => ("j_r", "µm", 1e3, 2),
        Quantity::LostMotion(Member::Wheel) => {
            ("lost motion of the wheel", "arcmin", arcmin(1.0), 3)
        }
        Quantity::LostMotion(Member::Pinion) => {
            ("lost motion of the pinion", "arcmin", arcmin(1.0), 3)
        }
        Quantity::RadialClearance => ("radial clearance", "mm", 1.0, 4),
    }
}

/// `value` rounded to `decimals` decimals; never −0.
pub fn rounded(value: f64, decimals: usize) -> f64 {
    let scale = 10f64.powi(decimals as i32);
    (value * scale).round() / scale + 0.0
}

/// A positive value in three significant digits; below 1e-4 as a power of ten.
pub fn significant(value: f64) -> String {
    if value >= 1e-4 {
        let decimals = (0..9)
            .find(|d| value * 10f64.powi(*d) >= 100.0)
            .unwrap_or(9);
        return format!("{value:.*}", decimals as usize);
    }
    let exponent = (1..30)
        .find(|e| value * 10f64.powi(*e) >= 1.0)
        .unwrap_or(30);
    let digits = value * 10f64.powi(exponent);
    format!("{digits:.2} · 10{}", raised(-exponent))
}

/// The magnitude of a length in µm, such as `3e-9`; for tables in ASCII.
pub fn order_um(length_mm: f64) -> String {
    power(length_mm * 1e3, 0)
}

/// `value` in scientific notation with `decimals` decimals, in ASCII.
pub fn power(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$e}")
}

/// An error bound, given in mm, in µm: one digit, rounded up.
pub fn bound_um(length_mm: f64) -> String {
    let um = length_mm * 1e3;
    if !(um > 0.0 && um.is_finite()) {
        return "0".to_owned();
    }
    let power = um.log10().floor();
    // A rounding error of the product does not add to a whole digit.
    let digit = (um / 10f64.powf(power) * (1.0 - 1e-12)).ceil();
    match digit {
        10.0 => scientific(1.0, power + 1.0),
        _ => scientific(digit, power),
    }
}

/// `12.34 ± 0.56`: a value and its bound, to the second significant digit of the bound, which is rounded up. A bound of 0 is not
/// shown.
pub fn within(value: f64, bound: f64) -> String {
    let bound = two_digits_up(bound);
    if !(bound > 0.0 && bound.is_finite()) {
        return fixed(value, 2);
    }
    let decimals = (1.0 - bound.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{} ± {}", fixed(value, decimals), fixed(bound, decimals))
}

/// A length and its bound, given in mm, in µm as [`within`].
pub fn um_within(length_mm: f64, bound_mm: f64) -> String {
    within(length_mm * 1e3, bound_mm * 1e3)
}

/// Bounds from this length on make the second decimal of a µm uncertain, mm.
const VISIBLE_BOUND: f64 = 5e-6;

/// A length in µm: as [`um_within`] where two decimals would hide the bound, else with two decimals. Both are given in mm.
pub fn um_known(length_mm: f64, bound_mm: f64) -> String {
    let bound = if bound_mm < VISIBLE_BOUND {
        0.0
    } else {
        bound_mm
    };
    um_within(length_mm, bound)
}

/// `12.35 ± 0.57 µm`, or `12.35 µm (error ≤ 2·10⁻⁹ µm)` where the bound is smaller than what is shown. Both are given in mm.
pub fn um_bounded(length_mm: f64, bound_mm: f64) -> String {
    let value = um_known(length_mm, bound_mm);
    if bound_mm < VISIBLE_BOUND {
        format!("{value} µm (error ≤ {} µm)", bound_um(bound_mm))
    } else {
        format!("{value} µm")
    }
}

/// A bound to two digits, rounded up; zero stays.
pub fn two_digits_up(value: f64) -> f64 {
    if !(value > 0.0 && value.is_finite()) {
        return value;
    }
    let text = format!("{value:.15e}");
    let parts = text.split_once('e');
    let parts = parts.and_then(|(digits, power)| {
        Some((digits.parse::<f64>().ok()?, power.parse::<i32>().ok()?))
    });
    let up = parts.and_then(|(digits, power)| {
        // A value of two digits is unchanged: 1e-14 is above the rounding of a product.
        let tenths = (digits * 10.0 * (1.0 - 1e-14)).ceil();
        format!("{tenths}e{}", power - 1).parse().ok()
    });
    up.unwrap_or(value)
}

/// A difference, given in mm, in µm: four decimals, or its magnitude where they would all be 0.
pub fn difference_um(length_mm: impl Into<Option<f64>>) -> String {
    match length_mm.into() {
        Some(mm) if mm != 0.0 && mm.abs() < 5e-7 => {
            let um = mm.abs() * 1e3;
            let power = um.log10().floor();
            let sign = if mm < 0.0 { "−" } else { "" };
            let digit = (um / 10f64.powf(power)).round();
            format!("{sign}{}", scientific(digit, power))
        }
        other => um(other, 4),
    }
}

/// A number as `digits·10^power` with raised digits, or plainly where that is short.
pub fn decades(number: f64) -> String {
    let text = format!("{number:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    match (digits.parse(), power.parse::<f64>()) {
        (Ok(digits), Ok(power)) if power.abs() > 3.0 => scientific(digits, power),
        _ => format!("{number}"),
    }
}

/// A number of bytes in words, to about two digits.
pub fn bytes(count: u64) -> String {
    match count {
        0..1_000_000_000 => format!("{} MB", count.div_ceil(1_000_000)),
        1_000_000_000..10_000_000_000 => format!("{:.1} GB", count as f64 / 1e9),
        _ => format!("{} GB", count.div_ceil(1_000_000_000)),
    }
}

/// `digit·10^power` with raised digits, or plainly where that is short.
fn scientific(digit: f64, power: f64) -> String {
    if (-3.0..=3.0).contains(&power) {
        // Not `{}`: seven tenths would be 0.7000000000000001.
        return format!(
            "{:.*}",
            f64::max(0.0, -power) as usize,
            digit * 10f64.powf(power)
        );
    }
    format!("{digit}·10{}", raised(power as i32))
}

/// A power as raised digits.
fn raised(power: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4'..='9' => char::from_u32('⁴' as u32 + c as u32 - '4' as u32).unwrap_or(c),
        _ => '⁰',
    };
    power.to_string().chars().map(raised).collect()
}

fn true_minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}
