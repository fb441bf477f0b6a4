//! Good tables: the study of the same numbers written inline.

use super::*;
use oracle::{column, delimited, protocol};

fn fixture(name: &str) -> Vec<u8> {
    fs::read(format!("../../fixtures/sheets/{name}")).unwrap()
}

const FLANKS: [[&str; 2]; 2] = [["right", "rechts"], ["left", "links"]];

/// The pair of the made sheets with their wheel's pitch as the tests' own reading has it.
fn inline(kind: &str, right: &[f64], left: &[f64]) -> PairFile {
    let keys = format!("pitch = {{ kind = \"{kind}\", right_um = {right:?}, left_um = {left:?} }}");
    super::good("unused", b"", &pair(44, &keys))
}

fn from_file(name: &str, table: &[u8], kind: &str) -> PairFile {
    let keys = format!("pitch = {{ kind = \"{kind}\", file = \"{name}\" }}");
    super::good(name, table, &pair(44, &keys))
}

#[test]
fn pitch_of_every_layout_is_that_of_the_lists() {
    let rows = delimited(&fixture("pitch.csv"), 44, &FLANKS).unwrap();
    let expected = inline("cumulative", &column(&rows, 0), &column(&rows, 1));
    for name in [
        "pitch.csv",
        "pitch_german.csv",
        "pitch.xlsx",
        "protocol.txt",
    ] {
        assert!(
            is_same(&from_file(name, &fixture(name), "cumulative"), &expected),
            "{name}"
        );
    }
    let [left, right] = protocol(&fixture("protocol.txt"), 44, 1).unwrap();
    let expected = inline("single", &column(&right, 0), &column(&left, 0));
    let found = from_file("protocol.txt", &fixture("protocol.txt"), "single");
    assert!(is_same(&found, &expected));
}

/// Spans in mm have three decimals, of either sign and separator; the pair file may state the sign.
#[test]
fn lengths_with_three_decimals() {
    let mm: Vec<f64> = (0..44)
        .map(|i| f64::from(50_541 + i % 5) / 1000.0)
        .collect();
    let list = pair(
        44,
        &format!("thickness.span = {{ teeth = 6, mm = {mm:?} }}"),
    );
    let expected = read_with("unused", b"", &list).unwrap();
    for (separator, sign) in [('\t', ","), ('\t', "."), (';', "."), (';', ",")] {
        let row =
            |(i, mm): (usize, &f64)| format!("{}{separator}{mm:.3}\n", i + 1).replace('.', sign);
        let rows: String = mm.iter().enumerate().map(row).collect();
        let table = format!("Zahn{separator}Zahnweite (mm)\n{rows}");
        let read = |decimal: &str| {
            let keys = format!("thickness.span = {{ teeth = 6, file = \"s.txt\"{decimal} }}");
            read_with("s.txt", table.as_bytes(), &pair(44, &keys))
        };
        let found = read(&format!(", decimal = {sign:?}")).unwrap();
        assert!(is_same(&found, &expected), "{separator:?} {sign}");
        // Nothing else is possible: no span has 50 m.
        assert!(
            is_same(&read("").unwrap(), &expected),
            "{separator:?} {sign}"
        );
        // The other sign is an error, line by line, never a thousandfold length.
        let other = if sign == "," { "." } else { "," };
        let problems = read(&format!(", decimal = {other:?}")).unwrap_err();
        assert!(
            problems[0].reason.contains("by the key `decimal`"),
            "{problems:#?}"
        );
    }
}

/// The cosine of an eccentric gear: e and the high tooth come back but for e³/r², which a first-order cosine leaves out (a reading is
/// e cos θ + e² sin² θ/(2 r) + …: the second order has no first harmonic), and the echo says the same.
#[test]
fn runout_is_the_first_harmonic_of_the_readings() {
    let (e, high) = (3.3f64, 33.25);
    let left_out = e.powi(3) / 66e3f64.powi(2);
    for (at, ahead) in [("tooth", 0.0), ("space", 0.5)] {
        let reading = |tooth: u32| {
            e * ((f64::from(tooth) + ahead - high) * std::f64::consts::TAU / 44.0).cos()
        };
        let rows: Vec<String> = (1..=44)
            .map(|tooth| format!("{tooth};{:?}", 100.0 + reading(tooth)))
            .collect();
        let table = format!("Zahn;Rundlauf (µm)\n{}", rows.join("\n"));
        let keys = format!("runout = {{ file = \"r.csv\", at = \"{at}\" }}");
        let study = read_with("r.csv", table.as_bytes(), &pair(44, &keys)).unwrap();
        let wheel = &study.study.materials[0].1;
        let (found, found_high) = (wheel.eccentricity(), wheel.high_tooth());
        assert!((1000.0 * found - e).abs() < left_out, "{found}");
        assert!((found_high - high).abs() < 1e-9, "{found_high}");
        let stated = &study.spec.wheel.data().unwrap().runout;
        assert_eq!(stated.total(), 2000.0 * wheel.eccentricity());
        assert_eq!(stated.high_tooth, Some(wheel.high_tooth()));
        assert_eq!(study.warnings.len(), 1);
        for words in [
            "wheel.runout.file: ",
            "3.300 µm towards tooth 33.25",
            "6.596 µm",
        ] {
            assert!(study.warnings[0].contains(words), "{}", study.warnings[0]);
        }
    }
}

/// Readings that are all the same have no high tooth.
#[test]
fn no_runout_needs_no_high_tooth() {
    let rows: String = (1..=44).map(|tooth| format!("{tooth},0\n")).collect();
    let table = format!("tooth,runout\n{rows}");
    let keys = "runout = { file = \"r.csv\", at = \"tooth\" }";
    let study = super::good("r.csv", table.as_bytes(), &pair(44, keys));
    let expected = serde_json::json!({ "total_um": 0.0 });
    assert_eq!(echo(&study)["wheel"]["runout"], expected);
}

/// The pair of the fixtures: its echo, without any file, gives the same study.
#[test]
fn the_echo_of_tables_read_back_gives_the_same_study() {
    let study = read_pair(Path::new("../../fixtures/sheets/inspected_44x44.toml")).unwrap();
    assert_eq!(study.warnings.len(), 2, "{:#?}", study.warnings);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("inspected_44x44.json");
    fs::write(&path, echo(&study).to_string()).unwrap();
    let mut again = read_pair(&path).unwrap();
    again.warnings.clone_from(&study.warnings);
    assert!(is_same(&again, &study));
}
