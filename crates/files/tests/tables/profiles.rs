//! Profile traces in tables: the gear of the same lists written inline. `tests/sessions/profile_faults.txt` holds the faults.

use super::*;
use gearlash::gear::{AsBuilt, Side};
use rust_xlsxwriter::Workbook;

/// Points of one trace: roll length, mm, and deviation, µm.
const POINTS: [(f64, f64); 4] = [(12.0, -1.5), (18.25, 2.0), (24.5, 3.5), (30.0, -4.25)];

fn inline(keys: &str) -> PairFile {
    read_with("unused", b"", &pair(44, keys)).unwrap_or_else(|problems| panic!("{problems:#?}"))
}

fn from_table(name: &str, table: &[u8], keys: &str) -> PairFile {
    let keys = format!("profile = {{ trace = {{ file = \"{name}\"{keys} }} }}");
    read_with(name, table, &pair(44, &keys)).unwrap_or_else(|problems| panic!("{problems:#?}"))
}

fn lists() -> String {
    let [at, um] = [POINTS.map(|point| point.0), POINTS.map(|point| point.1)];
    format!("roll_length_mm = {at:?}, deviation_um = {um:?}")
}

fn csv(separator: &str) -> String {
    let rows = POINTS.map(|(at, um)| format!("{at}{separator}{um}\n"));
    format!("roll_length_mm{separator}deviation_um\n{}", rows.concat())
}

/// The wheel of a study.
fn wheel(study: &PairFile) -> &AsBuilt {
    &study.study.materials[0].1
}

#[test]
fn every_format_says_the_same() {
    let expected = inline(&format!("profile = {{ trace = {{ {} }} }}", lists()));
    let german = csv(";").replace('.', ",");
    let mut book = Workbook::new();
    let sheet = book.add_worksheet();
    sheet.write(0, 0, "Wälzlänge (mm)").unwrap();
    sheet.write(0, 1, "Abweichung (µm)").unwrap();
    for (row, (at, um)) in (1..).zip(POINTS) {
        sheet.write(row, 0, at).unwrap();
        sheet.write(row, 1, um).unwrap();
    }
    let book = book.save_to_buffer().unwrap();
    for (name, table) in [
        ("t.csv", csv(",").as_bytes()),
        ("t.tsv", csv("\t").as_bytes()),
        ("t.csv", german.as_bytes()),
        ("t.xlsx", &book),
    ] {
        assert!(is_same(&from_table(name, table, ""), &expected), "{name}");
    }
    // Source of the roll: L = r_b ξ, ISO 21771.
    let base = wheel(&expected).gear().base_radius();
    for (at, um) in POINTS {
        for side in Side::BOTH {
            let curve = wheel(&expected).modification(side, 7).unwrap();
            assert!((curve.at(at / base) - um / 1000.0).abs() < 1e-12);
        }
    }
}

/// Diameters: `L = √(d² − d_b²)/2`.
#[test]
fn diameters_are_roll_lengths() {
    let base = wheel(&inline("")).gear().base_radius();
    let rows = POINTS.map(|(at, um)| format!("{:.17},{um}\n", 2.0 * base.hypot(at)));
    let table = format!("diameter_mm,deviation_um\n{}", rows.concat());
    let found = from_table("t.csv", table.as_bytes(), "");
    for (at, um) in POINTS {
        let curve = wheel(&found).modification(Side::Right, 1).unwrap();
        assert!((curve.at(at / base) - um / 1000.0).abs() < 1e-10, "{at}");
    }
}

/// A table with tooth and flank: each tooth has its own, the others the mean of those measured, and a note says so.
#[test]
fn teeth_and_flanks_have_their_own() {
    let mut table = "tooth,flank,roll_length_mm,deviation_um\n".to_owned();
    for (tooth, flank, times) in [(3, "right", 1.0), (9, "right", 3.0), (3, "left", -2.0)] {
        for (at, um) in POINTS {
            table += &format!("{tooth},{flank},{at},{}\n", times * um);
        }
    }
    let study = from_table("t.csv", table.as_bytes(), "");
    let wheel = wheel(&study);
    let base = wheel.gear().base_radius();
    for (side, tooth, times) in [
        (Side::Right, 3, 1.0),
        (Side::Right, 9, 3.0),
        (Side::Right, 20, 2.0),
        (Side::Left, 3, -2.0),
        (Side::Left, 20, -2.0),
    ] {
        for (at, um) in POINTS {
            let found = wheel.modification(side, tooth).unwrap().at(at / base);
            assert!(
                (found - times * um / 1000.0).abs() < 1e-12,
                "{side:?} {tooth}"
            );
        }
    }
    let message = study.remarks.concat() + &study.warnings.concat();
    assert!(
        message.contains(
            "wheel.profile.trace: traces of 2 of 44 right flanks; the other teeth take their mean"
        ),
        "{message}"
    );
    assert!(
        message.contains("traces of 1 of 44 left flanks"),
        "{message}"
    );
    // As understood it is a pair file of the same gear.
    let mut spec = echo(&study);
    spec["sweep"] = serde_json::json!({ "mating": [[1, 1]] });
    let again = read_with("unused", b"", &toml::to_string(&spec).unwrap()).unwrap();
    assert_eq!(again.study.materials[0].1, *wheel);
}

/// Every character of a table changed, one at a time: a problem of that file with its place, or the points that stand there.
#[test]
fn garbled_traces_are_reported_or_understood() {
    let good = csv(",");
    let keys = "profile = { trace = { file = \"t.csv\" } }";
    let (mut message, mut read) = (0, 0);
    for (at, old) in good.char_indices() {
        for new in ["", "x", "-", ",", "9", "\n", "\"", "\u{0}"] {
            let mut table = good.clone();
            table.replace_range(at..at + old.len_utf8(), new);
            match read_with("t.csv", table.as_bytes(), &pair(44, keys)) {
                Err(problems) => {
                    let own = |problem: &Problem| problem.key.starts_with("wheel.profile");
                    assert!(problems.iter().all(own), "{table}: {problems:#?}");
                    message += 1;
                }
                Ok(study) => {
                    let profile = study.spec.wheel.data().unwrap().profile.clone().unwrap();
                    let trace = profile.both.traces()[0].clone();
                    let rows: Vec<String> = table
                        .lines()
                        .skip(1)
                        .filter(|line| !line.trim_matches([',', ' ']).is_empty())
                        .map(|line| line.replace('"', ""))
                        .collect();
                    let points = trace.roll_length_mm.unwrap().into_iter();
                    let points: Vec<_> = points.zip(trace.deviation_um.unwrap()).collect();
                    assert_eq!(points.len(), rows.len(), "{table}");
                    for (row, (length, um)) in rows.iter().zip(points) {
                        let cells: Vec<f64> = row.split(',').map(|c| c.parse().unwrap()).collect();
                        assert_eq!(cells, [length, um], "{table}");
                    }
                    read += 1;
                }
            }
        }
    }
    assert!(message > 200 && read > 20, "{message} {read}");
}
