//! Drawings as programs write them. Each shows one gear: m = 2 mm, 20°, 16 teeth, whose span over three teeth an independent program measures as 15.1524 mm.

use super::*;
use gearlash::gauge::gauge_outline;
use gearlash::gear::Face;
use gearlash::outline::{OutlineGear, OutlineReading};
use gearlash_files::drawing::Repeat;
use gearlash_files::outlines::OutlineOptions;
use made::{in_units, line, lines};
use std::fs;

/// Span over three teeth of the gear in a drawing, mm.
fn span(name: &str, options: &Options) -> f64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/drawing/dialects")
        .join(name);
    let drawing = read(&path, &fs::read(&path).unwrap(), options);
    let drawing = drawing.unwrap_or_else(|error| panic!("{name}: {error}"));
    check_sound(&drawing);
    let [one] = &drawing.loops[..] else {
        panic!("{name}: {} loops", drawing.loops.len());
    };
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: Face::Front,
        teeth: Some(16),
        first_tooth: None,
        bound: one.bound_mm,
    };
    let gear = OutlineGear::new(&one.segments, &reading).unwrap();
    gauge_outline(&gear, Some(3), None).spans.unwrap().mean()
}

/// Inkscape and OpenJSCAD write a z at each vertex, FreeCAD noise of 1e-9 in z, CAD programs place blocks.
#[test]
fn drawings_of_many_programs_show_one_gear() {
    for (name, expected) in [
        // Half a unit of the last digit.
        ("z_noise.dxf", 15.1524),
        ("lwpolyline.dxf", 15.1524),
        ("lwpolyline_inkscape.dxf", 15.1524),
        ("insert.dxf", 15.1524),
        ("insert_scaled.dxf", 30.305),
    ] {
        let found = span(name, &Options::default());
        assert!(
            (found - expected).abs() < if expected > 20.0 { 5e-4 } else { 5e-5 },
            "{name}: {found}"
        );
    }
}

/// One tooth as a list of points, and all points with a z between blanks, are the gear that is drawn whole.
#[test]
fn one_tooth_and_blanks_show_the_gear_of_the_whole_drawing() {
    let whole = span("gear_16.dxf", &Options::default());
    let tooth = Options {
        repeat: Some(Repeat {
            teeth: 16,
            centre: Point2::origin(),
        }),
        ..in_mm()
    };
    // The lists have eight decimals.
    assert!((span("one_tooth.csv", &tooth) - whole).abs() < 1e-6);
    assert!((span("curve_xyz.txt", &in_mm()) - whole).abs() < 1e-6);
    let error = read(
        Path::new("tooth.csv"),
        &fs::read(
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawing/dialects/one_tooth.csv"),
        )
        .unwrap(),
        &Options {
            repeat: Some(Repeat {
                teeth: 40,
                centre: Point2::origin(),
            }),
            ..in_mm()
        },
    );
    let error = error.unwrap_err().to_string();
    assert!(error.contains("one of 40 teeth has 9.000°"), "{error}");
}

/// The named one of several outlines is read: 16 teeth round the origin, 24 about (40, 0). Source: the drawing of the first gear
/// alone.
#[test]
fn one_of_several_outlines_is_chosen() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawing/dialects/two_gears.dxf");
    let chosen = |options: OutlineOptions| {
        let read = gearlash_files::read_drawing(&path, &options);
        let gears = read.map_err(|error| error.lines().join("\n"))?;
        let (_, gear) = &gears.gears[0].drawn[0];
        let span = gauge_outline(gear, Some(3), None).spans.unwrap().mean();
        Ok::<_, String>((gear.teeth(), span))
    };
    let at = OutlineOptions::default();
    let fit = OutlineOptions {
        center: Some("fit"),
        ..at
    };
    let (teeth, span_3) = chosen(at).unwrap();
    assert_eq!(teeth, 16);
    assert!((span_3 - span("gear_16.dxf", &Options::default())).abs() < 1e-6);
    let number = |number| OutlineOptions {
        number: Some(number),
        ..fit
    };
    let at_mm = |at| OutlineOptions {
        at_mm: Some(at),
        ..fit
    };
    assert_eq!(chosen(number(1)).unwrap(), (teeth, span_3));
    assert_eq!(chosen(number(2)).unwrap().0, 24);
    assert_eq!(chosen(at_mm([41.0, -2.0])), chosen(number(2)));
    for options in [fit, number(3), at_mm([500.0, 0.0])] {
        let error = chosen(options).unwrap_err();
        assert!(error.contains("1 from (13.4166, -1.4982)"), "{error}");
        assert!(error.contains("2 from (18.5672, -1.6990)"), "{error}");
    }
}

/// `blocks` and `entities` as sections of a DXF in mm.
fn with_blocks(blocks: &[(&str, Vec<String>)], entities: &[String]) -> String {
    let mut section = vec!["SECTION 2 BLOCKS".to_owned()];
    for (name, inside) in blocks {
        section.push(format!("BLOCK 8 0 2 {name} 10 0 20 0"));
        section.extend(inside.clone());
        section.push("ENDBLK 8 0".to_owned());
    }
    section.push("ENDSEC".to_owned());
    let lines: String = section
        .iter()
        .flat_map(|one| {
            format!("0 {one}")
                .split(' ')
                .map(str::to_owned)
                .collect::<Vec<_>>()
        })
        .map(|word| word + "\n")
        .collect();
    in_units(Some(4), entities).replacen(
        "  0\nSECTION\n  2\nENTITIES\n",
        &(lines + "0\nSECTION\n2\nENTITIES\n"),
        1,
    )
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
        drawing
            .unwrap_or_else(|error| panic!("{insert}: {error}"))
            .loops
            .remove(0)
    };
    // The top of the arc, (1, 2), and the middle of the chord, (1, 0).
    for (insert, points) in [
        ("INSERT 8 TEETH 2 HALF 10 5 20 7", [[6.0, 9.0], [6.0, 7.0]]),
        (
            "INSERT 8 TEETH 2 HALF 10 5 20 7 50 90",
            [[3.0, 8.0], [5.0, 8.0]],
        ),
        (
            "INSERT 8 TEETH 2 HALF 10 5 20 7 41 3 42 3",
            [[8.0, 13.0], [8.0, 7.0]],
        ),
        (
            "INSERT 8 TEETH 2 HALF 10 5 20 7 41 -1",
            [[4.0, 9.0], [4.0, 7.0]],
        ),
        (
            "INSERT 8 TEETH 2 HALF 10 5 20 7 210 0 220 0 230 -1",
            [[-6.0, 9.0], [-6.0, 7.0]],
        ),
        // Half an ellipse.
        (
            "INSERT 8 TEETH 2 HALF 10 0 20 0 41 1 42 3",
            [[1.0, 6.0], [1.0, 0.0]],
        ),
        // Inner: (1, 2) to 2·(−2, 1) + (10, 0) = (6, 2), (1, 0) to (10, 2); outer: reversed in y, moved.
        (
            "INSERT 8 TEETH 2 OUTER 10 1 20 1 42 -1",
            [[7.0, -1.0], [11.0, -1.0]],
        ),
    ] {
        let one = loop_of(insert);
        assert_eq!(one.name, "TEETH");
        check_through(&one, &points);
    }
    let row = with_blocks(
        &blocks,
        &["INSERT 8 A 2 HALF 10 0 20 0 70 3 71 2 44 20 45 30".to_owned()],
    );
    assert_eq!(drawn("dxf", &row, &in_mm()).unwrap().loops.len(), 6);
}

/// Blocks that contain themselves, or multiply without end, are errors.
#[test]
fn endless_blocks_are_refused() {
    let inside = |name: &str| vec![format!("INSERT 8 0 2 {name} 10 0 20 0")];
    let itself = with_blocks(&[("A", inside("A"))], &inside("A"));
    let error = drawn("dxf", &itself, &in_mm()).unwrap_err().to_string();
    assert!(error.ends_with("blocks nested deeper than 16"), "{error}");
    let many = |name: &str| {
        vec![format!(
            "INSERT 8 0 2 {name} 10 0 20 0 70 30000 71 30000 44 1 45 1"
        )]
    };
    let empty = with_blocks(&[("A", Vec::new()), ("B", many("A"))], &many("B"));
    let error = drawn("dxf", &empty, &in_mm()).unwrap_err().to_string();
    assert_eq!(error, "has more than 1000000 entities");
}

/// Without $INSUNITS, $MEASUREMENT = 1 states mm; 0, which many programs write whatever they mean, states nothing.
#[test]
fn measurement_states_metric_units() {
    let with = |value: i32| {
        let text = in_units(Some(0), &lines(&made::corners(9)));
        let more = format!("  9\n$MEASUREMENT\n 70\n{value}\n  9\n$EXTMIN");
        drawn(
            "dxf",
            &text.replacen("  9\n$EXTMIN", &more, 1),
            &Options::default(),
        )
    };
    assert_eq!(with(1).unwrap().unit_mm, 1.0);
    let error = with(0).unwrap_err();
    assert!(
        error.reason.starts_with("the unit is not stated"),
        "{error}"
    );
}

/// A clone is drawn where it is moved to, by its own place and its transform.
#[test]
fn svg_clones_are_drawn() {
    let page = made::svg(
        "<defs><path id=\"a\" d=\"M 0 0 h 4 v 2 h -4 Z\"/></defs><use href=\"#a\" x=\"3\" y=\"1\" transform=\"scale(2)\"/>",
    );
    check_through(
        &loop_of("svg", &page),
        &[[6.0, -2.0], [14.0, -6.0], [10.0, -2.0]],
    );
    // Flags of arcs without separators, as Inkscape writes them.
    let arcs = made::svg("<path d=\"M0 0a5 5 0 0110 0z\"/>");
    check_through(&loop_of("svg", &arcs), &[[5.0, 5.0]]);
    let itself = made::svg("<g id=\"a\"><use href=\"#a\"/><use href=\"#a\"/></g>");
    assert!(drawn("svg", &itself, &in_mm()).is_err());
}
