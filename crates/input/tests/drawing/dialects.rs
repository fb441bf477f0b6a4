//! Blocks, as programs write them into drawings. `tests/sessions/dialects.txt` has whole drawings of one gear.

use super::*;
use made::{in_units, line};

/// `blocks` and `entities` as sections of a DXF in mm.
fn with_blocks(blocks: &[(&str, Vec<String>)], entities: &[String]) -> String {
    let mut section = vec!["SECTION 2 BLOCKS".to_owned()];
    for (name, inside) in blocks {
        section.push(format!("BLOCK 8 0 2 {name} 10 0 20 0"));
        section.extend(inside.clone());
        section.push("ENDBLK 8 0".to_owned());
    }
    section.push("ENDSEC".to_owned());
    let lines = section
        .iter()
        .map(|one| format!("0\n{}\n", one.replace(' ', "\n")));
    let lines = lines.collect::<String>() + "0\nSECTION\n2\nENTITIES\n";
    in_units(Some(4), entities).replacen("  0\nSECTION\n  2\nENTITIES\n", &lines, 1)
}

/// An arc and its chord, moved, turned, scaled, mirrored and nested: the image of each point is known.
#[test]
fn blocks_are_placed() {
    let half = vec![
        "ARC 8 0 10 1 20 0 40 2 50 0 51 180".to_owned(),
        line([3.0, 0.0], [-1.0, 0.0]).replace("TEETH", "0"),
    ];
    let nested = vec!["INSERT 8 0 2 HALF 10 10 20 0 41 2 42 2 50 90".to_owned()];
    let blocks = [("HALF", half), ("OUTER", nested)];
    let loop_of = |insert: &str| {
        let drawing = drawn("dxf", &with_blocks(&blocks, &[insert.to_owned()]), &in_mm());
        let drawing = drawing.unwrap_or_else(|error| panic!("{insert}: {error}"));
        drawing.loops[0].clone()
    };
    // The top of the arc, (1, 2), and the middle of the chord, (1, 0).
    for (insert, images) in [
        ("HALF 10 5 20 7", "6 9, 6 7"),
        ("HALF 10 5 20 7 50 90", "3 8, 5 8"),
        ("HALF 10 5 20 7 41 3 42 3", "8 13, 8 7"),
        ("HALF 10 5 20 7 41 -1", "4 9, 4 7"),
        ("HALF 10 5 20 7 210 0 220 0 230 -1", "-6 9, -6 7"),
        // Half an ellipse.
        ("HALF 10 0 20 0 41 1 42 3", "1 6, 1 0"),
        // Inner: (1, 2) to 2·(−2, 1) + (10, 0) = (6, 2), (1, 0) to (10, 2); outer: reversed in y, moved.
        ("OUTER 10 1 20 1 42 -1", "7 -1, 11 -1"),
    ] {
        let one = loop_of(&format!("INSERT 8 TEETH 2 {insert}"));
        assert_eq!(one.name, "TEETH");
        check_through(&one, &points(images));
    }
    let row = with_blocks(
        &blocks,
        &["INSERT 8 A 2 HALF 10 0 20 0 70 3 71 2 44 20 45 30".to_owned()],
    );
    assert_eq!(drawn("dxf", &row, &in_mm()).unwrap().loops.len(), 6);
}
