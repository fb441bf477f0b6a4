//! Error bounds as they are shown.

/// An error bound, given in mm, in µm: one digit, rounded up.
pub(super) fn bound(mm: f64) -> String {
    let um = mm * 1e3;
    if !(um > 0.0 && um.is_finite()) {
        return "0".to_owned();
    }
    let power = um.log10().floor();
    // What rounding of a product adds to a whole digit is none.
    let digit = (um / 10f64.powf(power) * (1.0 - 1e-12)).ceil();
    match digit {
        10.0 => scientific(1.0, power + 1.0),
        _ => scientific(digit, power),
    }
}

/// A number as `digits · 10^power` with raised digits, or as it is where that is short.
pub(super) fn decades(number: f64) -> String {
    let text = format!("{number:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    match (digits.parse(), power.parse::<f64>()) {
        (Ok(digits), Ok(power)) if power.abs() > 3.0 => scientific(digits, power),
        _ => format!("{number}"),
    }
}

/// `digit · 10^power` with raised digits, or as it is where that is short.
pub(super) fn scientific(digit: f64, power: f64) -> String {
    if (-3.0..=3.0).contains(&power) {
        return format!("{}", digit * 10f64.powf(power));
    }
    let power = format!("{power}");
    let raised = power.chars().map(|c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4'..='9' => char::from_u32('⁴' as u32 + c as u32 - '4' as u32).unwrap_or(c),
        _ => '⁰',
    });
    format!("{digit}·10{}", raised.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_is_rounded_up() {
        assert_eq!(bound(3.14e-12), "4·10⁻⁹");
        assert_eq!(bound(1e-12), "1·10⁻⁹");
        assert_eq!(bound(9.5e-12), "1·10⁻⁸");
        assert_eq!(decades(3.2e-9), "3.2·10⁻⁹");
        assert_eq!(decades(1e-12), "1·10⁻¹²");
        assert_eq!(decades(0.0032), "0.0032");
        assert_eq!(decades(0.0), "0");
        assert_eq!(bound(3.2e-5), "0.04");
        assert_eq!(bound(0.0), "0");
    }
}
