//! Workbooks.

use super::*;
use rust_xlsxwriter::{ExcelDateTime, Format, Workbook, Worksheet};

fn saved(mut workbook: Workbook) -> Vec<u8> {
    workbook.save_to_buffer().unwrap()
}

fn texts(sheet: &mut Worksheet, row: u32, words: &[&str]) {
    for (column, word) in words
        .iter()
        .enumerate()
        .filter(|(_, word)| !word.is_empty())
    {
        sheet.write(row, column as u16, *word).unwrap();
    }
}

/// A row a tooth from line `row` + 1 on: its number, and one value of each list.
fn rows(sheet: &mut Worksheet, row: u32, lists: &[Vec<f64>]) {
    for tooth in 0..TEETH {
        sheet.write(row + tooth, 0, tooth + 1).unwrap();
        for (column, list) in lists.iter().enumerate() {
            sheet
                .write(row + tooth, column as u16 + 1, list[tooth as usize])
                .unwrap();
        }
    }
}

fn jumps() -> Vec<f64> {
    vec![0.3; TEETH as usize]
}

/// A title, merged group headings over fp, Fp and fu, a row of units, statistics and a signature below.
fn german(workbook: &mut Workbook, name: &str) {
    let sheet = workbook.add_worksheet().set_name(name).unwrap();
    texts(
        sheet,
        0,
        &["Prüfprotokoll Teilung", "", "", "", "Auftrag", "4711"],
    );
    let format = Format::new();
    texts(sheet, 3, &["Zahn"]);
    sheet
        .merge_range(3, 1, 3, 3, "Linke Flanke", &format)
        .unwrap();
    sheet
        .merge_range(3, 4, 3, 6, "Rechte Flanke", &format)
        .unwrap();
    texts(sheet, 4, &["Nr.", "fp", "Fp", "fu", "fp", "Fp", "fu"]);
    texts(
        sheet,
        5,
        &["", "[µm]", "[µm]", "[µm]", "[µm]", "[µm]", "[µm]"],
    );
    let lists = [
        single(LEFT),
        cumulative(LEFT),
        jumps(),
        single(RIGHT),
        cumulative(RIGHT),
        jumps(),
    ];
    rows(sheet, 6, &lists);
    for (row, label) in (24..).zip(["Max", "Min", "Mittelwert", "Spannweite"]) {
        texts(sheet, row, &[label]);
        for column in 1..7 {
            sheet.write(row, column, 1.5).unwrap();
        }
    }
    texts(sheet, 30, &["Prüfer: Kunz"]);
}

#[test]
fn merged_groups_units_and_statistics() {
    let mut workbook = Workbook::new();
    german(&mut workbook, "Teilung");
    let shop = Shop::new("p.xlsx", saved(workbook));
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";
    let told = shop.is(keys, &listed("cumulative"), &[], "");
    for words in [
        "read from line 5 on",
        "\"Linke Flanke Fp\" (C)",
        "\"Rechte Flanke Fp\" (F)",
        "\"Mittelwert\"",
        "\"Linke Flanke fp\" (B)",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}

/// The same book, its other kind: the key `kind` chooses the columns.
#[test]
fn single_pitch_beside_cumulative() {
    let mut workbook = Workbook::new();
    german(&mut workbook, "Teilung");
    let shop = Shop::new("p.xlsx", saved(workbook));
    let keys = "pitch = { kind = \"single\", file = \"p.xlsx\" }";
    let (found, _) = shop.check(keys, "").unwrap();
    assert_eq!(found, shop.check(&listed("single"), "").unwrap().0);
    assert_ne!(found, shop.check(&listed("cumulative"), "").unwrap().0);
}

#[test]
fn english_headings_dates_and_a_remark() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(sheet, 0, &["Pitch inspection report"]);
    texts(
        sheet,
        1,
        &["Part", "pinion 17", "", "", "Inspector", "J. Doe"],
    );
    let heads = [
        "Tooth No.",
        "Left flank Fp [µm]",
        "Right flank Fp [µm]",
        "Date",
        "Remark",
    ];
    texts(sheet, 3, &heads);
    rows(sheet, 4, &[cumulative(LEFT), cumulative(RIGHT)]);
    let format = Format::new().set_num_format("yyyy-mm-dd");
    for row in 4..4 + TEETH {
        let date = ExcelDateTime::from_ymd(2026, 3, 12).unwrap();
        sheet.write_with_format(row, 3, &date, &format).unwrap();
    }
    texts(sheet, 9, &["", "", "", "", "burr removed"]);
    for (row, label) in (22..).zip(["max", "min", "mean", "range"]) {
        texts(sheet, row, &[label]);
        sheet.write(row, 1, 1.5).unwrap();
        sheet.write(row, 2, 1.5).unwrap();
    }
    let shop = Shop::new("report.xlsx", saved(workbook));
    let keys = "pitch = { kind = \"cumulative\", file = \"report.xlsx\" }";
    let told = shop.is(keys, &listed("cumulative"), &[], "");
    assert!(told.contains("\"Date\" (D), \"Remark\" (E)"), "{told}");
}

#[test]
fn texts_with_decimal_commas() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(sheet, 0, &["Zahn-Nr.", "Fp links", "Fp rechts"]);
    texts(sheet, 1, &["-", "µm", "µm"]);
    let (left, right) = (cumulative(LEFT), cumulative(RIGHT));
    for tooth in 0..TEETH {
        let comma = |list: &[f64]| format!("{:.1}", list[tooth as usize]).replace('.', ",");
        let cells = [(tooth + 1).to_string(), comma(&left), comma(&right)];
        texts(sheet, 2 + tooth, &cells.each_ref().map(String::as_str));
    }
    let shop = Shop::new("p.xlsx", saved(workbook));
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";
    shop.is(keys, &listed("cumulative"), &[], "");
}

#[test]
fn one_table_among_three_sheets() {
    let mut workbook = Workbook::new();
    let cover = workbook.add_worksheet().set_name("Deckblatt").unwrap();
    texts(cover, 0, &["Zahnrad", "17 Zähne", "Modul 3"]);
    german(&mut workbook, "Teilung");
    let limits = workbook.add_worksheet().set_name("Grenzwerte").unwrap();
    texts(limits, 0, &["Merkmal", "Grenze"]);
    texts(limits, 1, &["Fp"]);
    limits.write(1, 1, 20).unwrap();
    let shop = Shop::new("p.xlsx", saved(workbook));
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";
    let told = shop.is(keys, &listed("cumulative"), &[], "");
    assert!(told.contains("sheet \"Teilung\""), "{told}");
}

#[test]
fn two_tables_on_three_sheets() {
    let mut workbook = Workbook::new();
    workbook.add_worksheet().set_name("Übersicht").unwrap();
    german(&mut workbook, "Rad 1");
    german(&mut workbook, "Rad 2");
    workbook
        .worksheet_from_name("Rad 1")
        .unwrap()
        .write(8, 2, 9.0)
        .unwrap();
    let shop = Shop::new("p.xlsx", saved(workbook));
    let told = shop.refused("pitch = { kind = \"cumulative\", file = \"p.xlsx\" }");
    assert!(
        told.contains("\"Rad 1\", \"Rad 2\"") && told.contains("sheet = \"Rad 1\""),
        "{told}"
    );
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\", sheet = \"Rad 2\" }";
    shop.is(keys, &listed("cumulative"), &["--sheet", "Rad 2"], "");
}

/// Columns that have other names: the message lists them, and letters choose.
#[test]
fn columns_by_letter() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(sheet, 0, &["Messung 12"]);
    texts(sheet, 2, &["Zahn", "A-Seite", "B-Seite"]);
    rows(sheet, 3, &[cumulative(LEFT), cumulative(RIGHT)]);
    let shop = Shop::new("p.xlsx", saved(workbook));
    let told = shop.refused("pitch = { kind = \"cumulative\", file = \"p.xlsx\" }");
    assert!(
        told.contains("\"B-Seite\" (C); name them there")
            && told.contains("right = \"…\", left = \"…\""),
        "{told}"
    );
    let chosen = "left = \"B\", right = \"B-Seite\"";
    let keys = format!("pitch = {{ kind = \"cumulative\", file = \"p.xlsx\", {chosen} }}");
    let options = ["--left", "B", "--right", "B-Seite"];
    shop.is(
        &keys,
        &listed("cumulative"),
        &options,
        "kind = \"cumulative\"",
    );
}

#[test]
fn several_columns_that_may_be_it() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(
        sheet,
        0,
        &["Zahn", "Fp links", "Fp rechts", "Fp links gemessen"],
    );
    rows(sheet, 1, &[cumulative(LEFT), cumulative(RIGHT), jumps()]);
    let shop = Shop::new("p.xlsx", saved(workbook));
    let told = shop.refused("pitch = { kind = \"cumulative\", file = \"p.xlsx\" }");
    let words = "2 columns may be left: \"Fp links\" (B) and \"Fp links gemessen\" (D)";
    assert!(
        told.contains(words) && told.contains("left = \"B\""),
        "{told}"
    );
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\", left = \"Fp links\" }";
    shop.is(keys, &listed("cumulative"), &["--left", "Fp links"], "");
}

/// fp is never taken for Fp: not by default, and not by a key.
#[test]
fn single_pitch_is_not_taken_for_cumulative() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(sheet, 0, &["Zahn", "fp links", "fp rechts"]);
    rows(sheet, 1, &[single(LEFT), single(RIGHT)]);
    let shop = Shop::new("p.xlsx", saved(workbook));
    for keys in ["", ", left = \"fp links\", right = \"C\""] {
        let keys = format!("pitch = {{ kind = \"cumulative\", file = \"p.xlsx\"{keys} }}");
        let told = shop.check(&keys, "").unwrap_err();
        assert!(
            told.contains("is of single pitch deviations, fp")
                && told.contains("kind = \"single\""),
            "{told}"
        );
    }
    let keys = "pitch = { kind = \"single\", file = \"p.xlsx\" }";
    shop.is(keys, &listed("single"), &[], "");
}

#[test]
fn runout_of_a_wider_book() {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    texts(sheet, 0, &["Rundlaufprüfung"]);
    texts(sheet, 1, &["Zahn", "Uhrzeit", "Rundlauf Fr", "Prüfer"]);
    texts(sheet, 2, &["Nr.", "", "(µm)"]);
    let runout = cumulative(LEFT);
    for (row, um) in (3..).zip(&runout) {
        sheet.write(row, 0, row - 2).unwrap();
        texts(sheet, row, &["", "10:15", "", "Kunz"]);
        sheet.write(row, 2, *um).unwrap();
    }
    texts(sheet, 21, &["Max-Min"]);
    sheet.write(21, 2, 3.0).unwrap();
    let shop = Shop::new("r.xlsx", saved(workbook));
    let rows = (1..)
        .zip(&runout)
        .map(|(tooth, um): (u32, &f64)| format!("{tooth},{um}\n"));
    let plain = Shop::new(
        "plain.csv",
        format!("tooth,runout\n{}", rows.collect::<String>()),
    );
    let (expected, _) = plain
        .check("runout = { at = \"tooth\", file = \"plain.csv\" }", "")
        .unwrap();
    let (found, _) = shop
        .check("runout = { at = \"tooth\", file = \"r.xlsx\" }", "")
        .unwrap();
    assert_eq!(found, expected);
    let toml = super::completed(shop.import(&[])["toml"].as_str().unwrap(), "at = \"tooth\"");
    assert_eq!(shop.check("", &toml).unwrap().0, expected, "{toml}");
}
