//! Workbooks, written by another library than the one that reads them.

use super::*;
use rust_xlsxwriter::{Chart, ChartType, ExcelDateTime, Format, Workbook};
use std::io::{Read, Write};
use written_book::{Cell, columns, fill, write};

const KEYS: &str = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";

/// Adds a sheet `name` of pitch; cells left to `change`.
fn sheet(workbook: &mut Workbook, name: &str, change: impl Fn(&mut rust_xlsxwriter::Worksheet)) {
    let rows = (1..=44).map(|tooth| [f64::from(tooth), 0.5, 0.0]);
    let cells = columns(
        ["tooth", "left (µm)", "right (µm)"],
        &rows.collect::<Vec<_>>(),
    );
    let sheet = workbook.add_worksheet().set_name(name).unwrap();
    fill(sheet, &cells);
    change(sheet);
}

/// The readings of tooth 3, or the problems below the file's name.
fn outcome(workbook: &mut Workbook, keys: &str) -> String {
    let table = workbook.save_to_buffer().unwrap();
    let keys = KEYS.replace(" }", &format!("{keys} }}"));
    let problems = match read_with("p.xlsx", &table, &pair(44, &keys)) {
        Ok(study) => {
            let left = echoed(&study, "pitch", "left_um");
            return format!("left of tooth 3 is {}", left[2]);
        }
        Err(problems) => problems,
    };
    let message = |problem: &Problem| {
        let text = problem.to_string();
        text.rsplit("/p.xlsx: ").next().unwrap().to_owned()
    };
    problems.iter().map(message).collect::<Vec<_>>().join("\n")
}

#[test]
fn cells() {
    let text = |text: &str| Cell::Text(text.to_owned());
    let cases = [
        None,
        Some((3, 1, text("0,5"))),
        Some((3, 1, Cell::Flag(true))),
        // A date.
        Some((3, 1, Cell::Nothing)),
        Some((3, 0, Cell::Number(3.5))),
        Some((3, 0, Cell::Number(2.0))),
        Some((3, 4, text("a remark"))),
        Some((50, 1, Cell::Number(7.0))),
    ];
    let outcomes = cases.map(|case| {
        let mut workbook = Workbook::new();
        sheet(&mut workbook, "Pitch", |sheet| match &case {
            Some((row, column, Cell::Nothing)) => {
                let format = Format::new().set_num_format("dd.mm.yyyy");
                let date = ExcelDateTime::from_ymd(2026, 2, 1).unwrap();
                sheet
                    .write_with_format(*row, *column, &date, &format)
                    .unwrap();
            }
            Some((row, column, cell)) => write(sheet, *row, *column, cell),
            None => {}
        });
        outcome(&mut workbook, "")
    });
    insta::assert_snapshot!(outcomes.join("\n"));
}

#[test]
fn sheets() {
    let mut workbook = Workbook::new();
    sheet(&mut workbook, "Rad 1", |_| {});
    workbook.add_worksheet().set_name("leer").unwrap();
    let one = outcome(&mut workbook, "");
    sheet(&mut workbook, "Rad 2", |sheet| {
        sheet.write(3, 1, 2).unwrap();
    });
    let cases = [
        "",
        ", sheet = \"Rad 2\"",
        ", sheet = \"Rad 3\"",
        ", sheet = \"leer\"",
        ", sheet = 2",
    ];
    let several = cases.map(|keys| outcome(&mut workbook, keys));
    insta::assert_snapshot!(format!("{one}\n{}", several.join("\n")));
}

/// Formats that show dates make a number a mistyped one. Source: ECMA-376, 18.8.31.
#[test]
fn formats_of_dates() {
    let dates = "dd.mm.yyyy|[$-407]d. mmm yy;@|[h]:mm|hh:mm AM/PM|yyyy\\-mm";
    let numbers = "General|0.00|#,##0.00\\ \\m\\m|0.0\" mm\"|[Red]-0.0|0;[h]|_d0*s";
    for (codes, is_date) in [(dates, true), (numbers, false)] {
        for code in codes.split('|') {
            let mut workbook = Workbook::new();
            sheet(&mut workbook, "Pitch", |sheet| {
                let format = Format::new().set_num_format(code);
                sheet.write_number_with_format(3, 1, 0.25, &format).unwrap();
            });
            let found = outcome(&mut workbook, "");
            let is_read = found == "left of tooth 3 is 0.25";
            let is_refused = found.contains("a date or time");
            assert_eq!(is_refused, is_date, "{code}: {found}");
            assert_eq!(is_read, !is_date, "{code}: {found}");
        }
    }
}

/// The workbook `good` with one text of its parts replaced by another.
fn changed(good: &[u8], from: &str, to: &str) -> Vec<u8> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(good)).unwrap();
    let mut changed = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let mut part = archive.by_index(index).unwrap();
        let name = part.name().unwrap().into_owned();
        let mut text = String::new();
        part.read_to_string(&mut text).unwrap();
        let options = zip::write::SimpleFileOptions::default();
        changed.start_file(name, options).unwrap();
        changed
            .write_all(text.replace(from, to).as_bytes())
            .unwrap();
    }
    changed.finish().unwrap().into_inner()
}

/// `_x0030_` in a text stands for its character, and so does `&#48;`. Source: ECMA-376, ST_Xstring; XML 1.0, 4.1.
#[test]
fn escapes_of_texts() {
    let mut workbook = Workbook::new();
    sheet(&mut workbook, "Pitch", |sheet| {
        sheet.write(3, 1, "0,75").unwrap();
    });
    let book = workbook.save_to_buffer().unwrap();
    for (text, value) in [("0,75", 0.75), ("_x0030_,5", 0.5), ("0,&#50;_x0035_", 0.25)] {
        let table = changed(&book, "0,75", text);
        let study = good("p.xlsx", &table, &pair(44, KEYS));
        assert_eq!(echoed(&study, "pitch", "left_um")[2], value, "{text}");
    }
}

/// Charts on sheets of their own hold no table.
#[test]
fn a_chart_sheet_beside_the_table() {
    let mut workbook = Workbook::new();
    sheet(&mut workbook, "Pitch", |_| {});
    let mut chart = Chart::new(ChartType::Line);
    chart.add_series().set_values("Pitch!$B$2:$B$45");
    let page = workbook.add_chartsheet();
    page.insert_chart(0, 0, &chart).unwrap();
    assert_eq!(outcome(&mut workbook, ""), "left of tooth 3 is 0.5");
}

/// A reference that comes round to another cell in 32 bits: row 2^32 + 3 is no row 3.
#[test]
fn a_reference_beyond_the_last_cell() {
    let mut workbook = Workbook::new();
    sheet(&mut workbook, "Pitch", |_| {});
    let good = workbook.save_to_buffer().unwrap();
    for beyond in ["B4294967300", "AAAAAAAAAA4"] {
        let table = changed(&good, "r=\"B4\"", &format!("r=\"{beyond}\""));
        let problems = read_with("p.xlsx", &table, &pair(44, KEYS)).unwrap_err();
        let expected = format!("no spreadsheet has a cell \"{beyond}\"");
        assert!(problems[0].reason.ends_with(&expected), "{problems:#?}");
    }
}
