//! Spans and dimensions over pins all round, from files: the study of the same lists written inline.

use super::*;
use written_book::{columns, written};

/// As a German Excel writes it, in Windows-1252: these letters have their Unicode numbers there.
fn german(heading: &str, readings: &[[f64; 2]]) -> Vec<u8> {
    let row = |[mm, place]: &[f64; 2]| format!("{place};{mm:.3}\r\n").replace('.', ",");
    let rows: String = readings.iter().map(row).collect();
    let text = format!("Zahn-Nr.;{heading}\r\n{rows}");
    text.chars().map(|letter| letter as u8).collect()
}

/// Readings of three decimals at all places of 44 but the last two, in descending order.
///
/// W_6 = m cos α ((k − 1/2) π + z inv α) = 50.559 mm without allowance. M_dK = d_b/cos α_K + D_M = 139.5 mm, inv α_K = inv α + D_M/d_b − π/(2 z).
#[test]
fn readings_in_files_are_those_of_lists() {
    for (statement, place, headings, least_um) in [
        (
            "span = { teeth = 6",
            "first_tooth",
            ["Zahnweite (mm)", "span (mm)"],
            50_500,
        ),
        (
            "over_pins = { pin_mm = 5.25",
            "space",
            ["Zweirollenmaß [mm]", "over pins (mm)"],
            139_400,
        ),
    ] {
        let places: Vec<u32> = (1..=42).collect();
        let mm: Vec<f64> = places
            .iter()
            .map(|place| f64::from(least_um + place % 5) / 1000.0)
            .collect();
        let mut readings: Vec<[f64; 2]> = Vec::new();
        for (mm, place) in mm.iter().zip(&places).rev() {
            readings.push([*mm, f64::from(*place)]);
        }
        let keys = |rest: &str| pair(44, &format!("thickness.{statement}, {rest} }}"));
        let list = keys(&format!("mm = {mm:?}, {place} = {places:?}"));
        let expected = good("unused", b"", &list);
        for (name, table) in [
            ("w.csv", german(headings[0], &readings)),
            (
                "w.xlsx",
                written(&columns([headings[1], "tooth"], &readings)),
            ),
        ] {
            let found = good(name, &table, &keys(&format!("file = \"{name}\"")));
            assert!(is_same(&found, &expected), "{name}");
        }
    }
}
