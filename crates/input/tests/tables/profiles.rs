//! Profile traces in tables: the gear of the same lists written inline. `tests/sessions/profile_faults.txt` holds the faults.

use super::*;
use gearlash::gear::{AsBuilt, Side};
use written_book::{columns, written};

/// Points of one trace: roll length, mm, and deviation, µm.
const POINTS: [[f64; 2]; 4] = [[12.0, -1.5], [18.25, 2.0], [24.5, 3.5], [30.0, -4.25]];

fn inline(keys: &str) -> PairFile {
    good("unused", b"", &pair(44, keys))
}

fn from_table(name: &str, table: &[u8]) -> PairFile {
    let keys = format!("profile = {{ trace = {{ file = \"{name}\" }} }}");
    good(name, table, &pair(44, &keys))
}

fn csv(separator: &str) -> String {
    let rows = POINTS.map(|[at, um]| format!("{at}{separator}{um}\n"));
    format!("roll_length_mm{separator}deviation_um\n{}", rows.concat())
}

/// The wheel of a study.
fn wheel(study: &PairFile) -> &AsBuilt {
    &study.study.materials[0].1
}

/// Checks that a flank deviates by the points' µm `times` a factor. Source of the roll: L = r_b ξ, ISO 21771.
fn check_points(wheel: &AsBuilt, side: Side, tooth: u32, times: f64, bound: f64) {
    let base = wheel.gear().base_radius();
    for [at, um] in POINTS {
        let found = wheel.modification(side, tooth).unwrap().at(at / base);
        let off = found - times * um / 1000.0;
        assert!(off.abs() < bound, "{side:?} {tooth}: {off}");
    }
}

/// Each format says the same, and so do diameters: `L = √(d² − d_b²)/2`.
#[test]
fn every_format_says_the_same() {
    let [at, um] = [0, 1].map(|column| POINTS.map(|point| point[column]));
    let lists = format!("roll_length_mm = {at:?}, deviation_um = {um:?}");
    let expected = inline(&format!("profile = {{ trace = {{ {lists} }} }}"));
    let german = csv(";").replace('.', ",");
    let book = written(&columns(["Wälzlänge (mm)", "Abweichung (µm)"], &POINTS));
    for (name, table) in [
        ("t.csv", csv(",").as_bytes()),
        ("t.tsv", csv("\t").as_bytes()),
        ("t.csv", german.as_bytes()),
        ("t.xlsx", &book),
    ] {
        assert!(is_same(&from_table(name, table), &expected), "{name}");
    }
    for side in Side::BOTH {
        check_points(wheel(&expected), side, 7, 1.0, 1e-12);
    }
    let base = wheel(&expected).gear().base_radius();
    let rows = POINTS.map(|[at, um]| format!("{:.17},{um}\n", 2.0 * base.hypot(at)));
    let table = format!("diameter_mm,deviation_um\n{}", rows.concat());
    let found = from_table("t.csv", table.as_bytes());
    check_points(wheel(&found), Side::Right, 1, 1.0, 1e-10);
}

/// A table with tooth and flank: each tooth has its own, the others the mean of those measured, and a note says so.
#[test]
fn teeth_and_flanks_have_their_own() {
    let mut table = "tooth,flank,roll_length_mm,deviation_um\n".to_owned();
    for (tooth, flank, times) in [(3, "right", 1.0), (9, "right", 3.0), (3, "left", -2.0)] {
        for [at, um] in POINTS {
            table += &format!("{tooth},{flank},{at},{}\n", times * um);
        }
    }
    let study = from_table("t.csv", table.as_bytes());
    let wheel = wheel(&study);
    for (side, tooth, times) in [
        (Side::Right, 3, 1.0),
        (Side::Right, 9, 3.0),
        (Side::Right, 20, 2.0),
        (Side::Left, 3, -2.0),
        (Side::Left, 20, -2.0),
    ] {
        check_points(wheel, side, tooth, times, 1e-12);
    }
    let message = study.remarks.concat() + &study.warnings.concat();
    for words in [
        "wheel.profile.trace: traces of 2 of 44 right flanks; the other teeth take their mean",
        "traces of 1 of 44 left flanks",
    ] {
        assert!(message.contains(words), "{message}");
    }
    // As understood it is a pair file of the same gear.
    let again = good("unused", b"", &toml::to_string(&echo(&study)).unwrap());
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
                    let rows = table.lines().skip(1).map(|line| line.replace('"', ""));
                    let rows = rows.filter(|line| !line.trim_matches([',', ' ']).is_empty());
                    let cell = |cell: &str| cell.parse().unwrap();
                    let rows: Vec<Vec<f64>> =
                        rows.map(|row| row.split(',').map(cell).collect()).collect();
                    let points = trace.roll_length_mm.unwrap().into_iter();
                    let points = points.zip(trace.deviation_um.unwrap());
                    let points: Vec<_> = points.map(|(length, um)| vec![length, um]).collect();
                    assert_eq!(points, rows, "{table}");
                    read += 1;
                }
            }
        }
    }
    assert!(message > 200 && read > 20, "{message} {read}");
}
