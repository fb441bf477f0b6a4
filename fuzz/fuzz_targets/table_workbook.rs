//! An `.xlsx` workbook. The first byte selects the readings. The XML of sheet, shared texts, styles, list of sheets and their
//! relations follows, separated by lines `---`. The target stores it in a zip archive, because checksums would stop every mutation.
//! Missing parts are minimal. An input that begins with `!` holds the bytes of the archive itself.
#![no_main]

use gearlash_fuzz::table;
use libfuzzer_sys::{Corpus, fuzz_target};
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

const BETWEEN: &[u8] = b"\n---\n";

/// The parts of an input, with the defaults of missing parts.
const PARTS: [(&str, &str); 5] = [
    (
        "xl/worksheets/sheet1.xml",
        "<worksheet><sheetData/></worksheet>",
    ),
    ("xl/sharedStrings.xml", "<sst/>"),
    ("xl/styles.xml", "<styleSheet/>"),
    (
        "xl/workbook.xml",
        r#"<workbook xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="S" sheetId="1" r:id="r1"/></sheets></workbook>"#,
    ),
    (
        "xl/_rels/workbook.xml.rels",
        r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/><Relationship Id="r2" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/sharedStrings" Target="sharedStrings.xml"/><Relationship Id="r3" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/styles" Target="styles.xml"/></Relationships>"#,
    ),
];

/// Parts that are the same for every input.
const FIXED: [(&str, &str); 2] = [
    ("[Content_Types].xml", "<Types/>"),
    (
        "_rels/.rels",
        r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#,
    ),
];

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let file = match bytes.split_first() {
        Some((b'!', rest)) => rest
            .split_first()
            .map(|(&choice, archive)| (choice, archive.to_vec())),
        Some((&choice, rest)) => Some((choice, workbook(rest))),
        None => None,
    };
    let read = file.and_then(|(choice, file)| table::read(choice, &file));
    read.map_or(Corpus::Reject, |()| Corpus::Keep)
});

fn workbook(input: &[u8]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    let mut part = |name: &str, content: &[u8]| {
        archive.start_file(name, options).unwrap();
        archive.write_all(content).unwrap();
    };
    for (name, content) in FIXED {
        part(name, content.as_bytes());
    }
    let mut rest = Some(input);
    for (name, otherwise) in PARTS {
        let (own, behind) = match rest {
            Some(rest) => {
                let end = rest
                    .windows(BETWEEN.len())
                    .position(|window| window == BETWEEN);
                end.map_or((rest, None), |end| {
                    (&rest[..end], Some(&rest[end + BETWEEN.len()..]))
                })
            }
            None => (&b""[..], None),
        };
        part(
            name,
            if own.is_empty() {
                otherwise.as_bytes()
            } else {
                own
            },
        );
        rest = behind;
    }
    archive.finish().unwrap().into_inner()
}
