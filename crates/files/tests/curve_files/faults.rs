//! Files that are wrong, and what is said of them.

use super::made::{MEW, Made};
use super::{pair, read_with, told};

const PER_TOOTH: &str = "thickness.per_tooth_um = { file = \"gear.mka\" }";
const PITCH: &str = "pitch = { kind = \"single\", file = \"gear.mka\" }";
const TRACE: &str = "profile = { trace = { file = \"gear.mka\" } }";

#[test]
fn faults_have_their_words() {
    let made = Made::new(17);
    let text = made.text();
    for (from, to, keys, expected) in [
        (
            "Zähnezahl z..............: 17",
            "Zähnezahl z..............: 18",
            TRACE,
            "the pair file has teeth = 17",
        ),
        (
            "Start Messbereich",
            "Start",
            TRACE,
            "no header line is labelled start messbereich",
        ),
        (
            "\r\nTeilung:",
            "\r\nwhat is this\r\nTeilung:",
            PITCH,
            "3 values, the block has 4 columns",
        ),
        (
            "Profil:",
            "Profile:",
            PITCH,
            "\"Profile:\" is not understood here",
        ),
        (
            "links / 20  Werte  z",
            "links / 21  Werte  z",
            PITCH,
            "20 of 21 values into the trace of line",
        ),
        (
            "PROFILE diameter",
            "PROFILE angle",
            TRACE,
            "PROFILE is \"angle\"",
        ),
        ("UNITS mm", "UNITS inch", PITCH, "allowed is mm and µm"),
    ] {
        assert!(text.contains(from), "{from}");
        let told = told(&text.replacen(from, to, 1), 17, keys);
        assert!(told.contains(expected), "{to}: {told}");
    }
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

/// One mistake, one problem.
#[test]
fn one_bad_number_is_one_problem() {
    let text = Made::new(17).text();
    for (from, to, expected) in [
        (
            "1.21",
            "1,21",
            "\"1,21\", allowed is a number of µm: value 12 of 20",
        ),
        ("1.21", "1.21 1.22", "21 values of the trace of line"),
        ("1.21", "", "19 of 20 values into the trace of line"),
        (
            "Zahn-Nr.: 2 links / 20  Werte  z",
            "Zahn-Nr.: 2 links / 1.5  Werte  z",
            "allowed is such as",
        ),
        (
            "Zahn-Nr.: 2 links / 20  Werte  z",
            "Zahn-Nr.: 0 links / 20  Werte  z",
            "allowed is such as",
        ),
        ("Profil:", "Profile:", "\"Profile:\" is not understood here"),
        ("fp  Fp  Fr", "fp  Fq  Fr", "unknown column"),
        (
            "Z-Nr. Seite PHI",
            "Z-Nr. Seite",
            "allowed is Z-Nr. Seite PHI X Y Z",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        let told = told(&text.replacen(from, to, 1), 17, TRACE);
        assert!(told.contains(expected), "{to}: {told}");
        assert_eq!(told.lines().count(), 1, "{to}: {told}");
    }
}

/// What no pair file can state is refused for what it is.
#[test]
fn gears_of_other_kinds_are_refused() {
    let text = Made::new(17).text();
    let teeth = " 22 :Zähnezahl z..............: 17  Außenverzahnung";
    assert!(text.contains(teeth));
    for (line, expected) in [
        (
            " 22 :Zähnezahl z..............: 17  Innenverzahnung",
            "the gear is internal",
        ),
        (
            " 22 :Zähnezahl z..............: -17",
            "the gear is internal",
        ),
        (
            " 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: 15.0",
            "Schrägungswinkel is 15, the pair file has helix_angle_deg = 0",
        ),
        (
            " 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: R -15.0",
            "Schrägungswinkel is 15, the pair file has helix_angle_deg = 0",
        ),
        (
            " 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: rechts",
            "Schrägungswinkel is \"rechts\", allowed is a number of degrees",
        ),
        (
            " 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: 15.0 20.0",
            "allowed is a number of degrees",
        ),
        (" 22 :Zähnezahl z....: 17.5", "allowed is a whole number"),
    ] {
        let told = told(&text.replace(teeth, line), 17, PITCH);
        assert!(told.contains(expected), "{line}: {told}");
    }
    let spur = " 22 :Zähnezahl z....: 17\r\n 26 :Schrägungswinkel.......: 0.0000  0.0000";
    assert!(read_with(text.replace(teeth, spur).as_bytes(), &pair(17, PITCH)).is_ok());
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
