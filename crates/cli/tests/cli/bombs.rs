//! Small or ordinary files that would take gigabytes or minutes: each is refused within 5 s and 500 MB, by the built binary.
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
    part(
        "xl/sharedStrings.xml",
        format!("{start}{texts}</sst>").as_bytes(),
    );
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

/// Runs the binary on `pair` beside `table`, within `most_mb` MB; returns its message.
fn refused(what: &str, table: (&str, &[u8]), pair: (&str, &[u8]), most_mb: usize) -> String {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(table.0), table.1).unwrap();
    fs::write(folder.path().join(pair.0), pair.1).unwrap();
    let binary = assert_cmd::cargo::cargo_bin("gearlash");
    let script = format!(
        "ulimit -t 5; ulimit -v {}; exec \"$0\" simulate \"$1\" --format json",
        most_mb * 1000
    );
    let output = Command::new("sh")
        .args(["-c", &script])
        .arg(binary)
        .arg(pair.0)
        .env("RAYON_NUM_THREADS", "1")
        .current_dir(folder.path())
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{what}: {message}");
    assert!(output.stdout.is_empty());
    assert!(
        message.len() < 5000,
        "{what}: {} bytes of message",
        message.len()
    );
    // A line for each problem, and below it the piece of the pair file.
    let of_piece = |line: &str| {
        let rest = line.trim_start_matches(|c: char| c == ' ' || c.is_ascii_digit());
        rest.starts_with('|') || rest.starts_with("--> ")
    };
    let mut lines = message.lines();
    assert!(
        lines.all(|line| line.starts_with("error: ") || of_piece(line)),
        "{what}: {message}"
    );
    message
}

fn of_pitch(name: &str, table: &[u8], says: &str) {
    let keys = format!("pitch = {{ kind = \"single\", file = \"{name}\" }}");
    let pair = pair(44, &keys);
    let message = refused(says, (name, table), ("pair.toml", pair.as_bytes()), 500);
    assert!(message.contains(says), "{says:?} in {message}");
}

#[test]
fn workbooks() {
    let repeated = of_texts(&"x".repeat(10 * MIB), (100, 10));
    assert!(
        repeated.len() < 20_000,
        "a small file: {} bytes",
        repeated.len()
    );
    let most = "more than 32767 characters, the most a cell may have";
    of_pitch("p.xlsx", &repeated, most);
    of_pitch("p.xlsx", &of_texts(&"x".repeat(100_000), (9500, 100)), most);
    let text = "the text of the cells up to here has more than 16 MiB";
    of_pitch("p.xlsx", &of_texts(&"x".repeat(30_000), (1900, 100)), text);
    for count in ["9999999999999", "99999999999999999999999", "-1"] {
        let start = format!("<sst uniqueCount=\"{count}\">");
        // No memory is taken for texts that are not there.
        of_pitch("p.xlsx", &of_start(&start), "no line names the columns");
    }
    let tag = format!("<sst{}>", attributes(1_000_000));
    of_pitch("p.xlsx", &of_start(&tag), "no line names the columns");
    let part = "more than 32 MiB unpacked, the most a part may have";
    of_pitch("p.xlsx", &of_sheets(" ".repeat(300 * MIB), 1), part);
    of_pitch(
        "p.xlsx",
        &of_sheets(format!("<row{}></row>", attributes(1_000_000)), 1),
        "is empty",
    );
    let cell = "<c><v>1</v></c>";
    let beyond = "is outside the table limits: up to 100 columns and 200000 cells are read";
    of_pitch("p.xlsx", &of_sheets(rows(1, 1_000_000, cell), 1), beyond);
    of_pitch("p.xlsx", &of_sheets(rows(1900, 100, cell), 5), beyond);
    of_pitch("p.xlsx", &of_sheets(rows(300_000, 1, cell), 1), beyond);
    let parts = "its parts have more than 64 MiB unpacked";
    of_pitch("p.xlsx", &of_sheets(rows(19_000, 100, cell), 3), parts);
    let long = format!(
        "<row><c t=\"inlineStr\"><is><t>{}</t></is></c></row>",
        "y".repeat(20 * MIB)
    );
    of_pitch("p.xlsx", &of_sheets(long, 1), most);
    let reference = format!("<row><c r=\"{}1\"/></row>", "A".repeat(50_000));
    of_pitch(
        "p.xlsx",
        &of_sheets(reference, 1),
        "no spreadsheet has a cell \"AAAA",
    );
    of_pitch(
        "p.xlsx",
        &of_sheets("<a>".repeat(5_000_000), 1),
        "ill-formed document",
    );
    let pictures = workbook(&Parts {
        texts: ("<sst>".to_owned(), String::new()),
        sheet: (String::new(), 1),
        others: (20, 31 * MIB),
    });
    of_pitch("p.xlsx", &pictures, parts);
    let empty = workbook(&Parts {
        texts: ("<sst>".to_owned(), "<si/>".repeat(6_000_000)),
        sheet: (rows(2, 2, "<c t=\"s\"><v>0</v></c>"), 1),
        others: (0, 0),
    });
    of_pitch("p.xlsx", &empty, "is empty");
}

#[test]
fn text_tables() {
    let cells = "cells, allowed are up to 200000";
    of_pitch("p.csv", &vec![b','; 16 * MIB], cells);
    let lines = format!("tooth,left,right\n{}", "\n".repeat(15 * MIB));
    of_pitch("p.csv", lines.as_bytes(), cells);
    let rows = format!("tooth,left,right\n{}", "1,2,3\n".repeat(1_000_000));
    of_pitch("p.csv", rows.as_bytes(), cells);
    let wide: Vec<u8> = [0xFF, 0xFE]
        .into_iter()
        .chain([b',', 0].repeat(7 * MIB))
        .collect();
    of_pitch("p.csv", &wide, cells);
    let name = format!("{},b\n1,2\n", "x".repeat(MIB));
    of_pitch("p.csv", name.as_bytes(), "no line names the columns");
    let digits = format!("tooth,left,right\n1,{},3\n", "9".repeat(15 * MIB));
    of_pitch("p.csv", digits.as_bytes(), "left is \"9999");
    of_pitch("p.csv", &vec![b'"'; 16 * MIB], "no comma, semicolon or tab");
    let head = "linke Zahnflanke\nZahn-Nr. fp\n";
    let many = format!("{head}{}", "1 1\n".repeat(3_900_000));
    of_pitch("p.txt", many.as_bytes(), "more rows than the 20000");
    let long = format!("{head}{}", "1 ".repeat(8_000_000));
    of_pitch(
        "p.txt",
        long.as_bytes(),
        "8000000 values, the block has 2 columns",
    );
}

/// 16 million commas take no more than 200 MB, whatever names the file.
#[test]
fn sixteen_million_commas_within_200_megabytes() {
    let commas = vec![b','; 16 * MIB];
    let keys = "pitch = { kind = \"single\", file = \"p.csv\" }";
    let gear = pair(44, keys);
    let rig = pair(44, "").replace("[sweep]\nmating = [[1, 1]]", "[measured]\nfile = \"p.csv\"");
    // One record over many lines: line ends in quotes count as cells.
    let quoted = "\"a\n\",".repeat(3_000_000).into_bytes();
    for (pair, table, most_mb, cells) in [
        (&gear, &commas, 200, "has some 16777216 cells"),
        (&rig, &commas, 200, "has some 16777216 cells"),
        (&rig, &quoted, 300, "has some 6000000 cells"),
    ] {
        let message = refused(
            cells,
            ("p.csv", table),
            ("pair.toml", pair.as_bytes()),
            most_mb,
        );
        assert!(message.contains(cells), "{message}");
    }
}

#[test]
fn pair_files() {
    let numbered =
        |count: usize, word: &dyn Fn(usize) -> String| (0..count).map(word).collect::<String>();
    let json_keys = format!(
        "{{{}\"z\":1}}",
        numbered(1_200_000, &|i| format!("\"k{i}\":1,"))
    );
    let (many, list) = ("keys and values", |of: &str, n: usize| of.repeat(n));
    let toml = [
        (
            format!("a={}", "[".repeat(15 * MIB)),
            "keys and values, allowed are up to 500000",
        ),
        (format!("a={}", "[".repeat(400_000)), "recurse"),
        (format!("a=[{}]", list("[],", 5_000_000)), many),
        (format!("a=[{}]", list("0,", 7_000_000)), many),
        (
            format!("{}=1", "a.".repeat(100_000) + "a"),
            "recursion limit",
        ),
        ("[[a]]\n".repeat(2_700_000), many),
        (format!("a = \"{}\"", "x".repeat(15 * MIB)), "unknown key"),
        (numbered(1_200_000, &|i| format!("k{i}=1\n")), many),
    ];
    let json = [
        ("[".repeat(16 * MIB), "recursion limit"),
        (
            format!("{{\"a\":[{}0]}}", list("[],", 5_000_000)),
            "unknown key",
        ),
        (
            format!("{{\"a\":[{}0]}}", list("0,", 8_000_000)),
            "unknown key",
        ),
        (json_keys, "more than 1000 keys in one table"),
    ];
    let toml = toml.map(|(text, says)| ("p.toml", text, says));
    let json = json.map(|(text, says)| ("p.json", text, says));
    for (name, text, says) in toml.into_iter().chain(json) {
        let message = refused(says, ("x", b""), (name, text.as_bytes()), 500);
        assert!(message.contains(says), "{says:?} in {message}");
    }
}
