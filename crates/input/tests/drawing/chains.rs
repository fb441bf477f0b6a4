//! Loose ends: joined, closed, or an error with its points.

use super::*;
use made::{corners, dxf, line, lines};

/// The loop has the same corners for any order and direction of the lines.
#[test]
fn lines_in_any_order_make_the_loop() {
    let corners = corners(9);
    let mut drawn_lines = lines(&corners);
    let mut choice = mutant::Choice(9);
    for round in 0..20 {
        let one = loop_of("dxf", &dxf(&drawn_lines));
        assert_eq!((one.segments.len(), one.bound_mm), (36, 0.0));
        let start = |segment: &PathSegment| [segment.start().x, segment.start().y];
        let mut found: Vec<[f64; 2]> = one.segments.iter().map(start).collect();
        let mut expected = corners.clone();
        let order = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
        found.sort_by(order);
        expected.sort_by(order);
        assert_eq!(found, expected);
        let (a, b) = (choice.below(36), choice.below(36));
        drawn_lines.swap(a, b);
        let (from, to) = (corners[round], corners[round + 1]);
        let place = drawn_lines.iter().position(|one| *one == line(from, to));
        if let Some(place) = place {
            drawn_lines[place] = line(to, from);
        }
    }
}

/// A gap of 0.4 µm is closed by a line of that length, half of which is the bound; one of 4 µm is reported, and join_mm closes it.
#[test]
fn small_gaps_are_closed_and_told() {
    let gapped = |gap: f64| {
        dxf(&[
            line([0.0, 0.0], [5.0, 0.0]),
            line([5.0 + gap, 0.0], [0.0, 5.0]),
            line([0.0, 5.0], [0.0, 0.0]),
        ])
    };
    let one = loop_of("dxf", &gapped(0.0004));
    assert_eq!(one.segments.len(), 4);
    assert!((one.bound_mm - 0.0002).abs() < 1e-15);
    assert!((one.segments[1].length() - 0.0004).abs() < 1e-15);
    let error = drawn("dxf", &gapped(0.004), &in_mm()).unwrap_err();
    for words in [
        "from (5.004000, ",
        " to (5.000000, ",
        " of 3 drawn elements, is open",
        " 0.004000 mm away",
    ] {
        assert!(error.reason.contains(words), "{error}");
    }
    let join_mm: f64 = error.help.split(" = ").nth(1).unwrap().parse().unwrap();
    assert!((0.004..0.0042).contains(&join_mm), "{join_mm}");
    let drawing = drawn("dxf", &gapped(0.004), &Options { join_mm, ..in_mm() }).unwrap();
    assert!((drawing.loops[0].bound_mm - 0.002).abs() < 1e-15);
    // A gap of join_mm itself is closed: 5.5 and 5 have no rounding.
    let join_mm = 0.5;
    let drawing = drawn("dxf", &gapped(0.5), &Options { join_mm, ..in_mm() }).unwrap();
    assert_eq!(drawing.loops[0].bound_mm, 0.25);
}

/// A line shorter than join_mm between two others stays: its ends meet theirs exactly.
#[test]
fn a_short_line_is_kept() {
    let points = [[0.0, 0.0], [5.0, 0.0], [5.0005, 0.0], [0.0, 5.0]];
    let one = loop_of("dxf", &dxf(&lines(&points)));
    assert_eq!((one.segments.len(), one.bound_mm), (4, 0.0));
}

/// Centre lines are left out, on a layer of their own and among the teeth. A broken outline is an error.
#[test]
fn construction_lines_are_left_out() {
    let mut entities = lines(&corners(9));
    entities.push(line([-30.0, 0.0], [30.0, 0.0]).replace("TEETH", "CENTRE"));
    let drawing = drawn("dxf", &dxf(&entities), &in_mm()).unwrap();
    assert_eq!(drawing.loops.len(), 1);
    let left_out = "left out: layer \"CENTRE\", on which all 1 paths are open, \
                    the first from (-30.000000, 0.000000) mm to (30.000000, 0.000000) mm";
    assert_eq!(drawing.remarks, [left_out]);
    entities.push(line([-30.0, 1.0], [30.0, 1.0]));
    entities.push(line([1.0, -30.0], [1.0, 30.0]));
    let drawing = drawn("dxf", &dxf(&entities), &in_mm()).unwrap();
    assert_eq!(drawing.loops.len(), 1);
    let words = "left out: open line beside the outline (2, the first in line ";
    assert!(drawing.remarks[0].starts_with(words), "{drawing:?}");
    // Two gaps of the outline, and a bore that is closed.
    entities.remove(3);
    entities.remove(20);
    entities.push("CIRCLE 8 TEETH 10 0 20 0 40 3".to_owned());
    let error = drawn("dxf", &dxf(&entities), &in_mm()).unwrap_err();
    assert!(error.reason.contains(" is open: "), "{error}");
    assert!(error.to_string().starts_with("line "), "{error}");
}

/// Pieces drawn twice, in either direction, count once.
#[test]
fn what_is_drawn_twice_counts_once() {
    let mut entities = lines(&corners(9));
    entities.push(entities[5].clone());
    let [from, to] = [corners(9)[7], corners(9)[8]];
    entities.push(line(to, from));
    let drawing = drawn("dxf", &dxf(&entities), &in_mm()).unwrap();
    assert_eq!(drawing.loops[0].segments.len(), 36);
    assert!(drawing.remarks[0].starts_with("left out: drawn twice (2, the first in line "));
}
