//! The number of missing values. `tests/sessions/curve_imports.txt` and `curve_faults.txt` hold what else is read and what is refused.

use super::made::Made;
use super::{pair, read_with};

const TRACE: &str = "profile = { trace = { file = \"gear.mka\" } }";

/// The deviations of the left trace as read with another `UNDEFINED`.
fn left_trace(text: &str) -> Vec<f64> {
    let study = read_with(text.as_bytes(), &pair(17, TRACE))
        .unwrap_or_else(|message| panic!("{message:#?}"));
    let profile = study.spec.wheel.data().unwrap().profile.clone().unwrap();
    let left = profile.left.unwrap_or(profile.both);
    left.traces()[0].deviation_um.clone().unwrap()
}

/// `UNDEFINED` is one number, not a limit: values below it and just above it stay.
#[test]
fn the_undefined_number_is_no_threshold() {
    let text = Made::new(17).text();
    // Tables of pitch have zeros of their own.
    let (head, rest) = text.split_once("    linke Zahnflanke").unwrap();
    let text = format!("{head}Teilung:{}", rest.split_once("Teilung:").unwrap().1);
    let with =
        |number: &str| text.replace("UNDEFINED -2147483.648", &format!("UNDEFINED {number}"));
    let all = left_trace(&text);
    assert_eq!((all.len(), all[0]), (19, 0.01));
    for number in ["999.9", "0", "0.004", "-10.0"] {
        assert_eq!(left_trace(&with(number)), all, "{number}");
    }
    // As it stands there.
    assert_eq!(left_trace(&with("0.01")), all[1..]);
    assert_eq!(left_trace(&with("3.61")), all[..18]);
    // With fewer digits than in the preamble.
    let short = text.replace("\r\n-2147483.648 ", "\r\n-2147484 ");
    assert_eq!(left_trace(&short), all);
}
