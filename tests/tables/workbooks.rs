//! Workbooks, written by another library than the one that reads them.

use super::*;
use rust_xlsxwriter::{ExcelDateTime, Format, Workbook};

/// Pitch of four teeth in the sheet `name`, the cell of the third row and column left to `third`.
fn sheet(workbook: &mut Workbook, name: &str, third: impl Fn(&mut rust_xlsxwriter::Worksheet)) {
    let sheet = workbook.add_worksheet().set_name(name).unwrap();
    for (column, heading) in ["tooth", "left (µm)", "right (µm)"].iter().enumerate() {
        sheet.write(0, column as u16, *heading).unwrap();
    }
    for row in 1..=44 {
        sheet.write(row, 0, row).unwrap();
        sheet.write(row, 1, 0.5).unwrap();
        sheet.write(row, 2, 0).unwrap();
    }
    third(sheet);
}

fn told(workbook: &mut Workbook, keys: &str) -> String {
    let table = workbook.save_to_buffer().unwrap();
    let keys = format!("pitch = {{ kind = \"cumulative\", file = \"p.xlsx\"{keys} }}");
    match read_with("p.xlsx", &table, &pair(44, &keys)) {
        Ok(study) => format!(
            "left of tooth 3 is {}",
            echoed(&study, "pitch", "left_um")[2]
        ),
        Err(told) => {
            let message = |problem: &Problem| {
                problem
                    .to_string()
                    .split("/p.xlsx: ")
                    .last()
                    .unwrap()
                    .to_owned()
            };
            told.iter().map(message).collect::<Vec<_>>().join("\n")
        }
    }
}

#[test]
fn cells() {
    let cases: [&dyn Fn(&mut rust_xlsxwriter::Worksheet); 8] = [
        &|_| {},
        &|sheet| {
            sheet.write(3, 1, "0,5").unwrap();
        },
        &|sheet| {
            sheet.write(3, 1, true).unwrap();
        },
        &|sheet| {
            let format = Format::new().set_num_format("dd.mm.yyyy");
            let date = ExcelDateTime::from_ymd(2026, 2, 1).unwrap();
            sheet.write_with_format(3, 1, &date, &format).unwrap();
        },
        &|sheet| {
            sheet.write(3, 0, 3.5).unwrap();
        },
        &|sheet| {
            sheet.write(3, 0, 2).unwrap();
        },
        &|sheet| {
            sheet.write(3, 4, "a remark").unwrap();
        },
        &|sheet| {
            sheet.write(50, 1, 7).unwrap();
        },
    ];
    let told = cases.map(|third| {
        let mut workbook = Workbook::new();
        sheet(&mut workbook, "Pitch", third);
        told(&mut workbook, "")
    });
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn sheets() {
    let mut workbook = Workbook::new();
    sheet(&mut workbook, "Rad 1", |_| {});
    workbook.add_worksheet().set_name("leer").unwrap();
    let one = told(&mut workbook, "");
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
    let several = cases.map(|keys| told(&mut workbook, keys));
    insta::assert_snapshot!(format!("{one}\n{}", several.join("\n")));
}

#[test]
fn broken_containers() {
    let good = fs::read("fixtures/sheets/pitch.xlsx").unwrap();
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";
    for broken in [
        &good[..0],
        &good[..1],
        &good[..good.len() / 2],
        &good[..good.len() - 1],
        b"tooth,left,right\n1,2,3",
    ] {
        let told = read_with("p.xlsx", broken, &pair(44, keys)).unwrap_err();
        assert_eq!(told.len(), 1, "{told:#?}");
        assert!(
            told[0]
                .reason
                .contains("cannot be read as an .xlsx workbook"),
            "{}",
            told[0]
        );
    }
}
