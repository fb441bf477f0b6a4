//! The made sheets describe one gear: it is built from their pitch and gauged, by contact, and each file has the readings.

use super::*;
use gearlash::gauge::{Settings, gauge};
use oracle::{column, delimited, protocol};

/// Checks that the column of `words` in a file is what was read, but for half of the last digit, and rounding.
fn agree(name: &str, words: [&str; 2], read: &[f64], half: f64) {
    let bytes = fs::read(format!("../../fixtures/sheets/{name}")).unwrap();
    let file = column(&delimited(&bytes, 44, &[words]).unwrap(), 0);
    check_near(name, &file, read, half);
}

fn check_near(name: &str, file: &[f64], read: &[f64], half: f64) {
    assert_eq!(file.len(), read.len());
    for (tooth, (file, read)) in (1..).zip(file.iter().zip(read)) {
        let off = (file - read).abs();
        assert!(off <= half + 1e-7, "{name}, {tooth}: {file}, {read}");
    }
}

#[test]
fn sheets_are_what_the_gauge_reads_on_their_gear() {
    let table = fs::read("../../fixtures/sheets/pitch.csv").unwrap();
    let keys = "thickness.span = { teeth = 6, mm = 50.555 }\nrunout = { total_um = 6.6, high_tooth = 33 }\n\
                pitch = { kind = \"cumulative\", file = \"pitch.csv\" }";
    let study = read_with("pitch.csv", &table, &pair(44, keys)).unwrap();
    let settings = Settings {
        span_teeth: Some(6),
        ball: Some(5.25),
        steps_per_pitch: 1,
        ..Settings::default()
    };
    let read = gauge(
        &study.study.materials[0].1,
        &settings,
        &|_| (),
        &gearlash::error::go_on,
    )
    .unwrap();
    let um = |mm: f64| 1000.0 * mm;
    let balls = read.runout.unwrap().deviations();
    let balls: Vec<f64> = balls.into_iter().map(um).collect();
    agree("runout.csv", ["runout", "rundlauf"], &balls, 0.05);
    let text = fs::read("../../fixtures/sheets/protocol.txt").unwrap();
    for block in protocol(&text, 44, 3).unwrap() {
        check_near("protocol.txt", &column(&block, 0), &balls, 0.05);
    }
    let spans = read.spans.unwrap().readings;
    let spans: Vec<f64> = spans.iter().map(|span| span.length).collect();
    agree("spans.csv", ["span", "zahnweite"], &spans, 0.0005);
    let thickness = read.thickness.unwrap();
    let thicker = thickness
        .arcs
        .iter()
        .map(|arc| um(arc - thickness.summary().mean));
    let thicker: Vec<f64> = thicker.collect();
    agree("thickness.csv", ["thickness", "dicke"], &thicker, 0.05);
}

/// The pair of the sheets contradicts nothing and gives the gear back: e and high tooth within the rounding of 44 readings.
#[test]
fn the_pair_of_the_sheets_is_their_gear() {
    let study = read_pair(Path::new("../../fixtures/sheets/inspected_44x44.toml")).unwrap();
    let warnings = study.warnings.concat();
    assert!(!warnings.contains("contradict"), "{warnings}");
    let wheel = &study.study.materials[0].1;
    // 0.05 µm a reading at most, doubled by 2/z Σ |cos|.
    assert!((1000.0 * wheel.eccentricity() - 3.3).abs() < 0.1);
    assert!((wheel.high_tooth() - 33.0).abs() * std::f64::consts::TAU / 44.0 < 0.1 / 3.3);
}
