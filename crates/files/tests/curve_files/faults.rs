//! Units, angles and missing values. `tests/sessions/curve_faults.txt` holds the messages of wrong files.

use super::made::Made;
use super::{message, pair, read_with};

const PITCH: &str = "pitch = { kind = \"single\", file = \"gear.mka\" }";
const TRACE: &str = "profile = { trace = { file = \"gear.mka\" } }";

/// A helix angle of 0, stated for both flanks, is that of a spur gear.
#[test]
fn a_spur_gear_may_state_its_helix_angle() {
    let text = Made::new(17).text().replace(
        "17  Außenverzahnung",
        "17\r\n 26 :Schrägungswinkel.......: 0.0000  0.0000",
    );
    assert!(read_with(text.as_bytes(), &pair(17, PITCH)).is_ok());
}

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

/// The tables of pitch know the number of the preamble, too.
#[test]
fn the_undefined_number_in_a_table_of_pitch() {
    let text = Made::new(17).text();
    let text = text.replace("UNDEFINED -2147483.648", "UNDEFINED -8888.0");
    let row = text.lines().find(|line| line.starts_with("  4  ")).unwrap();
    let fp = row.split_whitespace().nth(1).unwrap();
    let text = text.replacen(row, &row.replacen(fp, "-8888.0", 1), 1);
    let message = message(&text, 17, PITCH);
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(
        message.contains("-8888.0 stands for a value that was not measured, as UNDEFINED"),
        "{message}"
    );
}

#[test]
fn angles_are_in_degrees() {
    let text = Made::new(17).text();
    for (unit, good) in [
        ("deg", true),
        ("Grad", true),
        ("rad", false),
        ("gon", false),
        ("", false),
    ] {
        let text = text.replace("ANGLE degrees", &format!("ANGLE {unit}"));
        match read_with(text.as_bytes(), &pair(17, PITCH)) {
            Ok(_) => assert!(good, "{unit}"),
            Err(_) => {
                let message = message(&text, 17, PITCH);
                assert!(
                    !good && message.contains("allowed is degrees"),
                    "{unit}: {message}"
                );
            }
        }
    }
}
