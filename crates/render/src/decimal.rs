//! Numbers as text for people.

/// `value` with so many decimals, a true minus sign, and no negative zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    signed(format!("{value:.decimals$}"))
}

/// `value` in as few digits as read back to the same number, set likewise.
pub fn shortest(value: f64) -> String {
    signed(format!("{value}"))
}

/// `value` with so many decimals and no negative zero, in ASCII: what a terminal shows is pasted elsewhere.
pub fn ascii(value: f64, decimals: usize) -> String {
    fixed(value, decimals).replace('−', "-")
}

fn signed(text: String) -> String {
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_minus_is_true_and_zero_has_none() {
        for (value, decimals, text) in [
            (-16.2741, 2, "−16.27"),
            (-0.004, 2, "0.00"),
            (-0.0, 0, "0"),
            (-0.4, 0, "0"),
            (-0.005_1, 2, "−0.01"),
            (3.0, 1, "3.0"),
        ] {
            assert_eq!(fixed(value, decimals), text);
        }
        assert_eq!(ascii(-16.2741, 2), "-16.27");
        assert_eq!(shortest(-0.25), "−0.25");
        assert_eq!(shortest(-0.0), "0");
    }
}
