//! Spans and dimensions over pins all round, from files: the study of the same lists written inline.

use super::*;
use rust_xlsxwriter::Workbook;

/// As a German Excel writes it, in Windows-1252: these letters have their Unicode numbers there.
fn german(heading: &str, readings: &[(u32, f64)]) -> Vec<u8> {
    let row = |(place, mm): &(u32, f64)| format!("{place};{mm:.3}\r\n").replace('.', ",");
    let rows: String = readings.iter().map(row).collect();
    let text = format!("Zahn-Nr.;{heading}\r\n{rows}");
    text.chars().map(|letter| letter as u8).collect()
}

fn workbook(heading: &str, readings: &[(u32, f64)]) -> Vec<u8> {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.write(0, 0, heading).unwrap();
    sheet.write(0, 1, "tooth").unwrap();
    for (row, (place, mm)) in (1..).zip(readings) {
        sheet.write(row, 0, *mm).unwrap();
        sheet.write(row, 1, *place).unwrap();
    }
    workbook.save_to_buffer().unwrap()
}

/// Readings of about `mm` at all places of 44 but the last two, rising by 1 µm up to the fifth, in descending order.
fn readings(mm: f64) -> Vec<(u32, f64)> {
    let reading = |place: u32| (place, mm + f64::from(place % 5) / 1000.0);
    (1..=42).rev().map(reading).collect()
}

fn same(statement: &str, place_key: &str, headings: [&str; 2], mm: f64) {
    let readings = readings(mm);
    let (mut places, mut values) = (Vec::new(), Vec::new());
    for (place, mm) in readings.iter().rev() {
        places.push(*place);
        // The value in three decimals.
        values.push(format!("{mm:.3}").parse::<f64>().unwrap());
    }
    let rounded: Vec<(u32, f64)> = places
        .iter()
        .copied()
        .zip(values.iter().copied())
        .rev()
        .collect();
    let keys = |rest: &str| pair(44, &format!("thickness.{statement}, {rest} }}"));
    let list = keys(&format!("mm = {values:?}, {place_key} = {places:?}"));
    let expected = read_with("unused", b"", &list).unwrap_or_else(|message| panic!("{message:#?}"));
    for (name, table) in [
        ("w.csv", german(headings[0], &rounded)),
        ("w.xlsx", workbook(headings[1], &rounded)),
    ] {
        let found = read_with(name, &table, &keys(&format!("file = \"{name}\"")));
        let found = found.unwrap_or_else(|message| panic!("{message:#?}"));
        assert!(is_same(&found, &expected), "{name}");
    }
}

/// W_6 = m cos α ((k − 1/2) π + z inv α) = 50.559 mm without allowance.
#[test]
fn spans() {
    let headings = ["Zahnweite (mm)", "span (mm)"];
    same("span = { teeth = 6", "first_tooth", headings, 50.5);
}

/// M_dK = d_b/cos α_K + D_M = 139.5 mm without allowance, inv α_K = inv α + D_M/d_b − π/(2 z).
#[test]
fn pins() {
    let headings = ["Zweirollenmaß [mm]", "over pins (mm)"];
    same("over_pins = { pin_mm = 5.25", "space", headings, 139.4);
}
