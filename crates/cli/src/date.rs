//! The day of a report: `SOURCE_DATE_EPOCH` where it is set, so that the same input gives the same bytes.

use crate::error::Error;
use jiff::Timestamp;
use jiff::tz::TimeZone;

const VARIABLE: &str = "SOURCE_DATE_EPOCH";

/// The day, in UTC, as `2026-11-21`.
///
/// # Errors
/// [`Error::Usage`] where the variable is set and not empty, and is no number of seconds within the calendar.
pub(super) fn today() -> Result<String, Error> {
    // Empty counts as unset: shells clear a variable so.
    match std::env::var_os(VARIABLE).filter(|text| !text.is_empty()) {
        None => Ok(day(Timestamp::now())),
        Some(text) => of_epoch(&text.to_string_lossy()),
    }
}

/// The day, given in seconds since 1970-01-01 UTC.
fn of_epoch(text: &str) -> Result<String, Error> {
    // The variable's definition allows no sign.
    let digits = text.bytes().all(|byte| byte.is_ascii_digit());
    let seconds = text.parse::<i64>().ok().filter(|_| digits);
    let timestamp = seconds.and_then(|seconds| Timestamp::from_second(seconds).ok());
    timestamp.map(day).ok_or_else(|| {
        Error::Usage(format!(
            "{VARIABLE}={text}: allowed are whole seconds since 1970-01-01 UTC, such as 1700000000; unset it to have today's date"
        ))
    })
}

fn day(timestamp: Timestamp) -> String {
    timestamp.to_zoned(TimeZone::UTC).date().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_become_a_day_in_utc() {
        // GNU date: date -u -d @1700000000 +%F; @951782399 is the last second of a leap day's eve.
        assert_eq!(of_epoch("1700000000").unwrap(), "2023-11-14");
        assert_eq!(of_epoch("951782399").unwrap(), "2000-02-28");
        assert_eq!(of_epoch("0").unwrap(), "1970-01-01");
        for bad in [
            "",
            " 1",
            "-1",
            "+1",
            "1.5",
            "x",
            "99999999999999",
            "999999999999999999999",
        ] {
            assert!(of_epoch(bad).is_err(), "{bad}");
        }
    }
}
