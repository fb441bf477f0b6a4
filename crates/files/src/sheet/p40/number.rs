//! Numbers as these machines write them.

use super::super::number::{self, Decimal, Written};

/// `word` as a number: as elsewhere, and without the 0 before the point, as these machines leave it out.
pub fn written(word: &str) -> Option<Written<'_>> {
    let at = usize::from(word.starts_with(['-', '+']));
    if !word[at..].starts_with('.') {
        let found = number::written(word)?;
        return (found.decimal != Some(Decimal::Comma) && !number::zero_first(word))
            .then_some(found);
    }
    let full = format!("{}0{}", &word[..at], &word[at..]);
    let found = number::written(&full)?;
    Some(Written {
        text: word,
        value: found.value,
        decimal: found.decimal,
        may_be_thousands: found.may_be_thousands,
        rounding: found.rounding,
    })
}
