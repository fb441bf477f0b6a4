//! Small workbooks that would take gigabytes or minutes: the built binary refuses each within 5 s and 500 MB. `tests/sessions/bombs.txt` has texts.
//!
//! Both bounds are the system's: the shell that starts the process limits its address space and its time on the processor, so that a
//! busy machine changes nothing.

use super::pair_with_table::pair;
use std::fs;
use std::io::{Cursor, Write};
use std::process::Command;
use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

const MIB: usize = 1 << 20;
const RELATIONS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";

/// The parts of a bomb.
struct Parts {
    /// The start of the list of shared texts, and its content.
    texts: (String, String),
    /// The data of each sheet, and the number of such sheets.
    sheet: (String, usize),
    /// The number and size of other parts, bytes.
    others: (usize, usize),
}

fn workbook(parts: &Parts) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let mut part = |name: &str, content: &[u8]| {
        let options = SimpleFileOptions::default();
        archive.start_file(name, options).unwrap();
        archive.write_all(content).unwrap();
    };
    let (sheet, count) = &parts.sheet;
    let named = |of: &dyn Fn(usize) -> String| (0..*count).map(of).collect::<String>();
    part("[Content_Types].xml", b"<Types/>");
    let office = format!(
        "<Relationships xmlns=\"{PACKAGE}\"><Relationship Id=\"r\" Type=\"{RELATIONS}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
    );
    part("_rels/.rels", office.as_bytes());
    let sheets = named(&|i| format!("<sheet name=\"S{i}\" sheetId=\"{}\" r:id=\"r{i}\"/>", i + 1));
    let book = format!(
        "<workbook xmlns=\"{MAIN}\" xmlns:r=\"{RELATIONS}\"><sheets>{sheets}</sheets></workbook>"
    );
    part("xl/workbook.xml", book.as_bytes());
    let targets = named(&|i| {
        format!(
            "<Relationship Id=\"r{i}\" Type=\"{RELATIONS}/worksheet\" Target=\"worksheets/s{i}.xml\"/>"
        )
    });
    let targets = format!(
        "<Relationships xmlns=\"{PACKAGE}\">{targets}<Relationship Id=\"t\" Type=\"{RELATIONS}/sharedStrings\" Target=\"sharedStrings.xml\"/></Relationships>"
    );
    part("xl/_rels/workbook.xml.rels", targets.as_bytes());
    let (start, texts) = &parts.texts;
    let texts = format!("{start}{texts}</sst>");
    part("xl/sharedStrings.xml", texts.as_bytes());
    let sheet = format!("<worksheet xmlns=\"{MAIN}\"><sheetData>{sheet}</sheetData></worksheet>");
    for i in 0..*count {
        part(&format!("xl/worksheets/s{i}.xml"), sheet.as_bytes());
    }
    let (others, size) = parts.others;
    for i in 0..others {
        part(&format!("xl/media/{i}.png"), &vec![0; size]);
    }
    archive.finish().unwrap().into_inner()
}

fn rows(count: usize, columns: usize, cell: &str) -> String {
    format!("<row>{}</row>", cell.repeat(columns)).repeat(count)
}

/// A workbook of shared texts and rows that show the first of them.
fn of_texts(text: &str, rows_of: (usize, usize)) -> Vec<u8> {
    workbook(&Parts {
        texts: ("<sst>".to_owned(), format!("<si><t>{text}</t></si>")),
        sheet: (rows(rows_of.0, rows_of.1, "<c t=\"s\"><v>0</v></c>"), 1),
        others: (0, 0),
    })
}

fn of_start(start: &str) -> Vec<u8> {
    workbook(&Parts {
        texts: (start.to_owned(), "<si><t>x</t></si>".to_owned()),
        sheet: (rows(2, 2, "<c t=\"s\"><v>0</v></c>"), 1),
        others: (0, 0),
    })
}

fn of_sheets(sheet: String, count: usize) -> Vec<u8> {
    workbook(&Parts {
        texts: ("<sst>".to_owned(), String::new()),
        sheet: (sheet, count),
        others: (0, 0),
    })
}

fn attributes(count: usize) -> String {
    (0..count).map(|i| format!(" a{i}=\"1\"")).collect()
}

/// Runs the binary on a pair whose wheel has the pitch of a workbook.
fn refused(table: &[u8], says: &str) {
    let folder = TempDir::new().unwrap();
    let pair = pair(44, "pitch = { kind = \"single\", file = \"p.xlsx\" }");
    fs::write(folder.path().join("p.xlsx"), table).unwrap();
    fs::write(folder.path().join("pair.toml"), pair).unwrap();
    let script = "ulimit -t 5; ulimit -v 500000; exec \"$0\" simulate pair.toml --format json";
    let output = Command::new("sh")
        .args(["-c", script])
        .arg(assert_cmd::cargo::cargo_bin("gearlash"))
        .env("RAYON_NUM_THREADS", "1")
        .current_dir(folder.path())
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{says}: {message}");
    assert!(output.stdout.is_empty() && message.len() < 5000);
    // A line for each problem, and below it the piece of the pair file.
    let of_piece = |line: &str| {
        let rest = line.trim_start_matches(|c: char| c == ' ' || c.is_ascii_digit());
        rest.starts_with('|') || rest.starts_with("--> ")
    };
    let mut lines = message.lines();
    let is_plain = lines.all(|line| line.starts_with("error: ") || of_piece(line));
    assert!(is_plain && message.contains(says), "{says:?} in {message}");
}

#[test]
fn workbooks() {
    let repeated = of_texts(&"x".repeat(10 * MIB), (100, 10));
    let size = repeated.len();
    assert!(size < 20_000, "a small file: {size} bytes");
    let most = "more than 32767 characters, the most a cell may have";
    refused(&repeated, most);
    refused(&of_texts(&"x".repeat(100_000), (9500, 100)), most);
    let text = "the text of the cells up to here has more than 16 MiB";
    refused(&of_texts(&"x".repeat(30_000), (1900, 100)), text);
    for count in ["9999999999999", "99999999999999999999999", "-1"] {
        let start = format!("<sst uniqueCount=\"{count}\">");
        // No memory is taken for texts that are not there.
        refused(&of_start(&start), "no line names the columns");
    }
    let tag = format!("<sst{}>", attributes(1_000_000));
    refused(&of_start(&tag), "no line names the columns");
    let part = "more than 32 MiB unpacked, the most a part may have";
    refused(&of_sheets(" ".repeat(300 * MIB), 1), part);
    let row = format!("<row{}></row>", attributes(1_000_000));
    refused(&of_sheets(row, 1), "is empty");
    let cell = "<c><v>1</v></c>";
    let beyond = "is outside the table limits: up to 100 columns and 200000 cells are read";
    refused(&of_sheets(rows(1, 1_000_000, cell), 1), beyond);
    refused(&of_sheets(rows(1900, 100, cell), 5), beyond);
    refused(&of_sheets(rows(300_000, 1, cell), 1), beyond);
    let parts = "its parts have more than 64 MiB unpacked";
    refused(&of_sheets(rows(19_000, 100, cell), 3), parts);
    let long = "y".repeat(20 * MIB);
    let long = format!("<row><c t=\"inlineStr\"><is><t>{long}</t></is></c></row>");
    refused(&of_sheets(long, 1), most);
    let reference = format!("<row><c r=\"{}1\"/></row>", "A".repeat(50_000));
    refused(&of_sheets(reference, 1), "no spreadsheet has a cell \"AAAA");
    let open = "<a>".repeat(5_000_000);
    refused(&of_sheets(open, 1), "ill-formed document");
    let pictures = workbook(&Parts {
        texts: ("<sst>".to_owned(), String::new()),
        sheet: (String::new(), 1),
        others: (20, 31 * MIB),
    });
    refused(&pictures, parts);
    let empty = workbook(&Parts {
        texts: ("<sst>".to_owned(), "<si/>".repeat(6_000_000)),
        sheet: (rows(2, 2, "<c t=\"s\"><v>0</v></c>"), 1),
        others: (0, 0),
    });
    refused(&empty, "is empty");
}
