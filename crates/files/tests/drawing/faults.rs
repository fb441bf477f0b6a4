//! Faults of drawings: place, reason and remedy.

use super::*;
use made::{dxf, in_units, line, polyline, spline, svg};

/// A fault and its remedy, one line each.
fn fault(ending: &str, text: &str, options: &Options) -> String {
    let error = drawn(ending, text, options).unwrap_err();
    format!("{error}\n  {}\n", error.help)
}

/// The faults of drawings in mm, each below the text that makes it one.
fn faults<'a>(ending: &str, made: impl IntoIterator<Item = (&'a str, String)>) -> String {
    let made = made.into_iter();
    let each = made.map(|(shown, text)| format!("> {shown}\n{}", fault(ending, &text, &in_mm())));
    each.collect()
}

#[test]
fn units_are_never_guessed() {
    let circle = ["CIRCLE 10 0 20 0 40 2".to_owned()];
    let none = Options::default();
    let inch = stated_in(Unit::Inch);
    insta::assert_snapshot!(
        [
            fault("dxf", &in_units(None, &circle), &none),
            fault("dxf", &in_units(Some(4), &circle), &inch),
            fault("dxf", &in_units(Some(2), &circle), &inch),
            fault("svg", &svg("<circle r=\"2\"/>"), &inch),
            fault("csv", "0,0\n1,0\n0,1\n", &none),
            fault("csv", "# unit: mm\n0,0\n1,0\n0,1\n", &inch),
        ]
        .concat()
    );
}

#[test]
fn what_is_not_read_is_refused_by_name() {
    let entities = [
        "INSERT 8 A 2 GEAR 10 0 20 0",
        "HATCH 8 A",
        "3DFACE 8 A",
        "CIRCLE 10 0 20 0 40 2 210 1 220 0 230 0",
        "LINE 10 0 20 0 30 1 11 5 21 0 31 2",
        "SPLINE 71 3 72 0 73 0 74 2 11 0 21 0 11 1 21 1",
    ];
    let entities = faults("dxf", entities.map(|one| (one, dxf(&[one.to_owned()]))));
    let elements = [
        "<use href=\"#a\"/>",
        "<rect width=\"3\" height=\"3\" rx=\"1\"/>",
        "<g clip-path=\"url(#a)\"><circle r=\"1\"/></g>",
        "<path id=\"p\" d=\"M 0 0 L 1 x\"/>",
    ];
    let elements = faults("svg", elements.map(|one| (one, svg(one))));
    let pages = [
        "<svg transform=\"scale(2)\"",
        "<svg style=\"transform: scale(2)\"",
        "<svg mask=\"url(#a)\"",
        "<!DOCTYPE svg><svg",
    ];
    let page = svg("<circle r=\"1\"/>");
    let pages = faults("svg", pages.map(|one| (one, page.replace("<svg", one))));
    insta::assert_snapshot!(entities + &elements + &pages);
    let binary = b"AutoCAD Binary DXF\r\n\x1a\0";
    let binary = read(Path::new("a.DXF"), binary, &in_mm()).unwrap_err();
    assert_eq!(binary.to_string(), "byte 1: not supported: a binary DXF");
    let error = read(Path::new("a.dwg"), b"", &in_mm()).unwrap_err();
    assert!(error.reason.starts_with("a.dwg: unknown kind"), "{error}");
}

/// Values that the crate would read as zero, or skip.
#[test]
fn entities_must_be_whole() {
    let square = polyline(
        true,
        &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
        "",
    );
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5];
    let entities = [
        "LINE 10 0 20 0 11 5",
        "LINE 10 0 20 0",
        "ARC 10 0 20 0 40 1 50 0",
        "CIRCLE 10 0 20 0 40 1 40 2",
        "CIRCLE 10 0 20 0 40 nan",
        "CIRCLE 10 0 20 0 40 1,5",
        "CIRCLE 10 0 20 0 40 -1",
        "CIRCLE 10 0 20 0 40 1e99",
        &square.replace("90 3", "90 4"),
        "VERTEX 10 0 20 0",
        "POLYLINE 66 1",
        &spline(3, &[0.0; 5], &[[0.0; 2]; 4], &[]),
        &spline(3, &knots, &[[0.0; 2]; 4], &[]),
    ];
    let found = faults("dxf", entities.map(|one| (one, dxf(&[one.to_owned()]))));
    insta::assert_snapshot!(found);
}

#[test]
fn layers_and_ids_that_are_not_there_are_reported_with_those_that_are() {
    let options = Options {
        select: Some("Gear".to_owned()),
        ..in_mm()
    };
    let found = [
        fault("dxf", &made::mixed_dxf(), &options),
        fault("svg", &made::mixed_svg(), &options),
        fault("csv", &made::list(), &options),
    ];
    insta::assert_snapshot!(found.concat());
}

#[test]
fn lists_are_read_strictly() {
    let lists = [
        "0,0\n1,0\n0;1\n",
        "0,0\n1,0,0\n0,1\n",
        "0,0\n1,nan\n0,1\n",
        "0,0\nx,y\n0,1\n",
        "a,b\n0,0\n",
        "0;1.5\n1,5;0\n0;1\n",
        "0;1,500\n1;0\n0;1\n",
        "0,0\n1,0\n0,0\n",
        "# unit: ell\n0,0\n",
        "# unit: mm\nx (cm),y (cm)\n",
        "",
    ];
    insta::assert_snapshot!(faults("csv", lists.map(|one| (one, one.to_owned()))));
}

#[test]
fn what_is_cut_off_or_too_large_is_reported() {
    let whole = dxf(&[line([0.0, 0.0], [1.0, 0.0])]);
    let many = "0 1 1 0 ".repeat(300_000);
    let deep = ["<g>".repeat(100_000), "</g>".repeat(100_000)].join("<circle r=\"1\"/>");
    for (ending, text, words) in [
        (
            "dxf",
            whole[..whole.len() - 8].to_owned(),
            "the file ends without EOF: it is truncated",
        ),
        (
            "csv",
            "\n".repeat((64 << 20) + 1),
            "has more than 67108864 bytes",
        ),
        ("svg", svg(&format!("<path d=\"M {many}\"/>")), " is open: "),
        (
            "svg",
            svg(&format!("<path d=\"M {many} L {many}\"/>")),
            "has more than 1000000 segments",
        ),
        ("svg", svg(&deep), "groups nested deeper than 200"),
    ] {
        let error = drawn(ending, &text, &in_mm()).unwrap_err();
        assert!(error.reason.contains(words), "{error}");
    }
}
