//! Sheets as shops write them; each was once refused.

use super::*;
use gearlash_files::import::{Imported, Kind, Options, Value, tables};

/// Reads a table of the file `name` in `cases/`.
fn import(name: &str, only: Kind, sheet: &str) -> Imported {
    let path = Path::new("../files/tests/tables/cases").join(name);
    let keys = [("sheet", sheet.to_owned())];
    let options = Options {
        only: Some(only),
        keys: &keys,
        gear: "wheel",
    };
    let bytes = fs::read(&path).unwrap();
    tables(&path, bytes, &options).unwrap_or_else(|error| panic!("{:#?}", error.problems))
}

fn columns(imported: &Imported) -> Vec<Vec<Value>> {
    let columns = imported.tables.iter().flat_map(|table| &table.columns);
    columns.map(|column| column.values.clone()).collect()
}

/// The lines after the last tooth are statistics, "Fp ges." with numbers, and a span of all teeth. `pruef2.xlsx` is the same book
/// without the last two.
#[test]
fn words_below_the_last_tooth_are_left_out() {
    for (sheet, teeth) in [("Rad z25", 25), ("Ritzel z18", 18)] {
        for only in [Kind::Pitch, Kind::Runout] {
            let found = import("pruef.xlsx", only, sheet);
            assert_eq!(found.tables[0].rows(), teeth, "{sheet}");
            let left_out = found.tables[0].left_out.as_deref().unwrap();
            for words in ["\"Fp ges.\"", "\"Zahnweite W3 [mm]\"", "\"Mittelwert\""] {
                assert!(left_out.contains(words), "{left_out}");
            }
            let expected = import("pruef2.xlsx", only, sheet);
            assert_eq!(columns(&found), columns(&expected), "{sheet}");
        }
    }
}

/// A ball reads in the spaces ("Lücke"). The readings are 10 µm · cos, highest in space 1, which is half a pitch beyond tooth 1.
#[test]
fn runout_by_spaces() {
    let study = read_pair(Path::new("../files/tests/tables/cases/h3.toml")).unwrap();
    let wheel = &study.study.materials[0].1;
    // Readings are rounded to 0.1 µm.
    assert!((1000.0 * wheel.eccentricity() - 10.0).abs() < 0.05);
    assert!((wheel.high_tooth() - 1.5).abs() < 0.05);

    let table = fs::read("../files/tests/tables/cases/rl.csv").unwrap();
    let keys = "runout = { file = \"rl.csv\", at = \"tooth\" }";
    let problems = read_with("rl.csv", &table, &pair(51, keys)).unwrap_err();
    assert_eq!(problems.len(), 1, "{problems:#?}");
    assert_eq!(problems[0].key, "wheel.runout.at");
    assert!(problems[0].reason.contains("numbered by spaces"));
}

#[test]
fn formats_that_are_not_read_say_how_to_save_them() {
    let open_document = b"PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x08\0\0\0\
        mimetypeapplication/vnd.oasis.opendocument.spreadsheet";
    // The signature of the compound file format, then anything.
    let old = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0\0\0\0";
    let cases: [(&str, &[u8], &str); 3] = [
        ("p.xls", old, "is an old Excel workbook, .xls"),
        (
            "p.ods",
            open_document,
            "is an OpenDocument file, such as .ods",
        ),
        ("p.pdf", b"%PDF-1.7\n", "is a PDF"),
    ];
    for (name, bytes, expected) in cases {
        let keys = format!("pitch = {{ kind = \"single\", file = \"{name}\" }}");
        let message = read_with(name, bytes, &pair(44, &keys)).unwrap_err();
        assert_eq!(message.len(), 1, "{message:#?}");
        assert!(message[0].reason.ends_with(expected), "{}", message[0]);
        assert_eq!(message[0].help, "save it as .xlsx or CSV");
    }
}
