//! One closed LWPOLYLINE as DXF R2000, ASCII.
//!
//! AutoCAD needs all sections of a file of this version (DXF Reference, R2000: tables, blocks and objects with their handles).
//! Other programs need its header and the entity.

use super::number;
use gearlash::outline::PathSegment;

/// Everything before the entity: a group code and its value in turn. `$INSUNITS` 4 and `$MEASUREMENT` 1 are millimetres.
const BEFORE: &str = "
0 SECTION 2 HEADER
  9 $ACADVER 1 AC1015  9 $HANDSEED 5 FF  9 $INSUNITS 70 4  9 $MEASUREMENT 70 1
0 ENDSEC
0 SECTION 2 TABLES
  0 TABLE 2 VPORT 5 1 330 0 100 AcDbSymbolTable 70 0 0 ENDTAB
  0 TABLE 2 LTYPE 5 2 330 0 100 AcDbSymbolTable 70 3
    0 LTYPE 5 3 330 2 100 AcDbSymbolTableRecord 100 AcDbLinetypeTableRecord 2 ByBlock 70 0 3 Solid 72 65 73 0 40 0.0
    0 LTYPE 5 4 330 2 100 AcDbSymbolTableRecord 100 AcDbLinetypeTableRecord 2 ByLayer 70 0 3 Solid 72 65 73 0 40 0.0
    0 LTYPE 5 5 330 2 100 AcDbSymbolTableRecord 100 AcDbLinetypeTableRecord 2 Continuous 70 0 3 Solid 72 65 73 0 40 0.0
  0 ENDTAB
  0 TABLE 2 LAYER 5 6 330 0 100 AcDbSymbolTable 70 1
    0 LAYER 5 7 330 6 100 AcDbSymbolTableRecord 100 AcDbLayerTableRecord 2 0 70 0 62 7 6 Continuous
  0 ENDTAB
  0 TABLE 2 STYLE 5 8 330 0 100 AcDbSymbolTable 70 1
    0 STYLE 5 9 330 8 100 AcDbSymbolTableRecord 100 AcDbTextStyleTableRecord 2 Standard 70 0 40 0.0 41 1.0 50 0.0 71 0 42 2.5 3 txt
  0 ENDTAB
  0 TABLE 2 VIEW 5 A 330 0 100 AcDbSymbolTable 70 0 0 ENDTAB
  0 TABLE 2 UCS 5 B 330 0 100 AcDbSymbolTable 70 0 0 ENDTAB
  0 TABLE 2 APPID 5 C 330 0 100 AcDbSymbolTable 70 1
    0 APPID 5 D 330 C 100 AcDbSymbolTableRecord 100 AcDbRegAppTableRecord 2 ACAD 70 0
  0 ENDTAB
  0 TABLE 2 DIMSTYLE 5 E 330 0 100 AcDbSymbolTable 70 1 100 AcDbDimStyleTable
    0 DIMSTYLE 105 F 330 E 100 AcDbSymbolTableRecord 100 AcDbDimStyleTableRecord 2 Standard 70 0
  0 ENDTAB
  0 TABLE 2 BLOCK_RECORD 5 10 330 0 100 AcDbSymbolTable 70 2
    0 BLOCK_RECORD 5 11 330 10 100 AcDbSymbolTableRecord 100 AcDbBlockTableRecord 2 *Model_Space
    0 BLOCK_RECORD 5 12 330 10 100 AcDbSymbolTableRecord 100 AcDbBlockTableRecord 2 *Paper_Space
  0 ENDTAB
0 ENDSEC
0 SECTION 2 BLOCKS
  0 BLOCK 5 13 330 11 100 AcDbEntity 8 0 100 AcDbBlockBegin 2 *Model_Space 70 0 10 0.0 20 0.0 30 0.0 3 *Model_Space
  0 ENDBLK 5 14 330 11 100 AcDbEntity 8 0 100 AcDbBlockEnd
  0 BLOCK 5 15 330 12 100 AcDbEntity 8 0 100 AcDbBlockBegin 2 *Paper_Space 70 0 10 0.0 20 0.0 30 0.0 3 *Paper_Space
  0 ENDBLK 5 16 330 12 100 AcDbEntity 8 0 100 AcDbBlockEnd
0 ENDSEC
0 SECTION 2 ENTITIES
  0 LWPOLYLINE 5 17 330 11 100 AcDbEntity 8 0 100 AcDbPolyline
";

const AFTER: &str = "
0 ENDSEC
0 SECTION 2 OBJECTS
  0 DICTIONARY 5 18 330 0 100 AcDbDictionary 281 1 3 ACAD_GROUP 350 19
  0 DICTIONARY 5 19 330 18 100 AcDbDictionary 281 1
0 ENDSEC
0 EOF
";

/// The file of a closed `outline`, `header` as comments. Arcs stay arcs; other curves are chords within `tolerance`, mm.
pub(super) fn text(outline: &[PathSegment], tolerance: f64, header: &[String]) -> String {
    let mut vertices = Vec::new();
    for part in outline {
        match *part {
            PathSegment::Arc { sweep, .. } => vertices.push((part.start(), (sweep / 4.0).tan())),
            PathSegment::Line(_) | PathSegment::Cubic(_) => {
                vertices.extend(part.chords(tolerance).map(|point| (point, 0.0)));
            }
        }
    }
    let mut text = String::new();
    for line in header {
        text += &format!("999\n{}\n", ascii(line));
    }
    frame(&mut text, BEFORE);
    // Group code 70, value 1: closed.
    text += &format!("90\n{}\n70\n1\n", vertices.len());
    for (point, bulge) in vertices {
        text += &format!("10\n{}\n20\n{}\n", number(point.x), number(point.y));
        if bulge != 0.0 {
            text += &format!("42\n{}\n", number(bulge));
        }
    }
    frame(&mut text, AFTER);
    text
}

/// Adds group codes and values, one per line.
fn frame(text: &mut String, words: &str) {
    for word in words.split_whitespace() {
        text.push_str(word);
        text.push('\n');
    }
}

/// `text` in ASCII as DXF writes it: other characters as `\U+XXXX`, by their UTF-16.
fn ascii(text: &str) -> String {
    let units = text.encode_utf16();
    let units = units.map(|unit| match u8::try_from(unit) {
        Ok(byte) if byte.is_ascii() => char::from(byte).to_string(),
        _ => format!("\\U+{unit:04X}"),
    });
    units.collect()
}
