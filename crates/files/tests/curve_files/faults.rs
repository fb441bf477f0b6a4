//! Files that are wrong, and what is said of them.

use super::made::{MEW, Made};
use super::{pair, read_with, told};

const PER_TOOTH: &str = "thickness.per_tooth_um = { file = \"gear.mka\" }";
const PITCH: &str = "pitch = { kind = \"single\", file = \"gear.mka\" }";
const TRACE: &str = "profile = { trace = { file = \"gear.mka\" } }";

/// What is said of the file with `from` replaced by `to`, below the replacement.
fn faults(replaced: &[(&str, &str, &str)]) -> String {
    let text = Made::new(17).text();
    let each = replaced.iter().map(|(from, to, keys)| {
        assert!(text.contains(from), "{from}");
        let told = told(&text.replacen(from, to, 1), 17, keys);
        format!("{from} ⇒ {to}\n{told}\n\n")
    });
    each.collect()
}

/// One mistake, one problem.
#[test]
fn a_fault_is_one_problem_in_words() {
    const HEAD: &str = "Zahn-Nr.: 2 links / 20  Werte  z";
    insta::assert_snapshot!(faults(&[
        (
            "Zähnezahl z..............: 17",
            "Zähnezahl z..............: 18",
            TRACE
        ),
        ("Start Messbereich", "Start", TRACE),
        ("\r\nTeilung:", "\r\nwhat is this\r\nTeilung:", PITCH),
        ("Profil:", "Profile:", PITCH),
        ("links / 20  Werte  z", "links / 21  Werte  z", PITCH),
        ("PROFILE diameter", "PROFILE angle", TRACE),
        ("UNITS mm", "UNITS inch", PITCH),
        ("1.21", "1,21", TRACE),
        ("1.21", "1.21 1.22", TRACE),
        ("1.21", "", TRACE),
        (HEAD, "Zahn-Nr.: 2 links / 1.5  Werte  z", TRACE),
        (HEAD, "Zahn-Nr.: 0 links / 20  Werte  z", TRACE),
        ("fp  Fp  Fr", "fp  Fq  Fr", TRACE),
        ("Z-Nr. Seite PHI", "Z-Nr. Seite", TRACE),
    ]));
}

/// What no pair file can state is refused for what it is.
#[test]
fn gears_of_other_kinds_are_refused() {
    const TEETH: &str = " 22 :Zähnezahl z..............: 17  Außenverzahnung";
    let helical =
        |angle: &str| format!(" 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: {angle}");
    let lines = [
        " 22 :Zähnezahl z..............: 17  Innenverzahnung".to_owned(),
        " 22 :Zähnezahl z..............: -17".to_owned(),
        helical("15.0"),
        helical("R -15.0"),
        helical("rechts"),
        helical("15.0 20.0"),
        " 22 :Zähnezahl z....: 17.5".to_owned(),
    ];
    insta::assert_snapshot!(faults(&lines.each_ref().map(|line| (
        TEETH,
        &line[..],
        PITCH
    ))));
    let spur = Made::new(17)
        .text()
        .replace(TEETH, &helical("0.0000  0.0000"));
    assert!(read_with(spur.as_bytes(), &pair(17, PITCH)).is_ok());
}

/// The deviations of the left trace as read with another `UNDEFINED`.
fn left_trace(text: &str) -> Vec<f64> {
    let study =
        read_with(text.as_bytes(), &pair(17, TRACE)).unwrap_or_else(|told| panic!("{told:#?}"));
    let profile = study.spec.wheel.profile.unwrap();
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
    let told = told(&text, 17, PITCH);
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(
        told.contains("-8888.0 stands for a value that was not measured, as UNDEFINED"),
        "{told}"
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
                let told = told(&text, 17, PITCH);
                assert!(
                    !good && told.contains("allowed is degrees"),
                    "{unit}: {told}"
                );
            }
        }
    }
}

/// By its first line, whatever its values are.
#[test]
fn a_value_file_is_one_without_values() {
    let empty = MEW.split("10111").next().unwrap().to_owned() + "26450 : V Fuß : 8999.0\r\n";
    let undefined = MEW.replace("-2.9", "-9999.0");
    for text in [MEW, &empty, &undefined] {
        for keys in [PITCH, TRACE, PER_TOOTH] {
            let told = told(text, 17, keys);
            assert!(told.contains("is a value file (.mew)"), "{keys}: {told}");
        }
    }
}

/// A file that cannot be read is reported once.
#[test]
fn no_file() {
    let keys = "thickness.per_tooth_um = { file = \"nothing.mka\" }";
    let problems = read_with(b"", &pair(17, keys)).unwrap_err();
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert!(problems[0].reason.contains("nothing.mka"), "{problems:#?}");
}

/// A key that is gone names what to state instead.
#[test]
fn thickness_from_positions_is_gone() {
    let keys = "thickness = { file = \"gear.mka\" }";
    let problems = read_with(b"", &pair(17, keys)).unwrap_err();
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert_eq!(problems[0].key, "wheel.thickness.file");
    assert!(problems[0].help.contains("`span`, `over_pins`"));
    let told = told(&Made::new(17).text(), 17, PER_TOOTH);
    assert!(
        told.contains("thickness is not taken from the probe's positions"),
        "{told}"
    );
}
