//! Each fault: what, where, and the way out.

use super::*;
use made::{dxf, in_units, line, polyline, spline, svg};

/// Checks the words of an error and of its way out.
fn check(ending: &str, text: &str, options: &Options, words: &str, help: &str) {
    let error = drawn(ending, text, options).expect_err(words);
    assert_eq!(error.to_string(), words);
    assert!(error.help.contains(help), "{}", error.help);
}

#[test]
fn units_are_never_guessed() {
    let circle = ["CIRCLE 10 0 20 0 40 2".to_owned()];
    let none = Options::default();
    let inch = Options {
        unit: Some(Unit::Inch),
        ..Options::default()
    };
    check(
        "dxf",
        &in_units(None, &circle),
        &none,
        "the unit is not stated: no $INSUNITS in the DXF",
        "units = \"mm\"",
    );
    check(
        "dxf",
        &in_units(Some(4), &circle),
        &inch,
        "the file states $INSUNITS = 4 (\"mm\"), the pair file \"inch\"",
        "leave it out",
    );
    check(
        "dxf",
        &in_units(Some(2), &circle),
        &inch,
        "line 14: $INSUNITS = 2, expected 1 (inch), 4 (mm), 5 (cm), 6 (m) or 13 (µm)",
        "in mm",
    );
    check(
        "svg",
        &svg("<circle r=\"2\"/>"),
        &inch,
        "the file states width 100 mm of 100 units, the pair file \"inch\"",
        "leave it out",
    );
    check(
        "csv",
        "0,0\n1,0\n0,1\n",
        &none,
        "the unit is not stated: no line `# unit: mm` in the list",
        "units = ",
    );
    check(
        "csv",
        "# unit: mm\n0,0\n1,0\n0,1\n",
        &inch,
        "the file states \"mm\" in line 1, the pair file \"inch\"",
        "leave it out",
    );
}

#[test]
fn what_is_not_read_is_refused_by_name() {
    for (entity, words) in [
        (
            "INSERT 8 A 2 GEAR 10 0 20 0",
            "line 53: entity 1 (INSERT on layer \"A\"): not supported: an INSERT of \"GEAR\", a block that the file does not have",
        ),
        (
            "HATCH 8 A",
            "line 53: entity 1 (HATCH on layer \"A\"): not supported: HATCH",
        ),
        (
            "3DFACE 8 A",
            "line 53: entity 1 (3DFACE on layer \"A\"): not supported: 3DFACE",
        ),
        (
            "CIRCLE 10 0 20 0 40 2 210 1 220 0 230 0",
            "line 53: entity 1 (CIRCLE on layer \"0\"): not supported: an extrusion direction other than 0, 0, ±1",
        ),
        (
            "LINE 10 0 20 0 30 1 11 5 21 0 31 2",
            "line 53: entity 1 (LINE on layer \"0\"): not supported: a point of another z than those before",
        ),
        (
            "SPLINE 71 3 72 0 73 0 74 2 11 0 21 0 11 1 21 1",
            "line 53: entity 1 (SPLINE on layer \"0\"): not supported: a SPLINE with fit points only",
        ),
    ] {
        check("dxf", &dxf(&[entity.to_owned()]), &in_mm(), words, "");
    }
    for (element, words) in [
        (
            "<use href=\"#a\"/>",
            "line 3: use: href = \"#a\": no element of this file",
        ),
        (
            "<rect width=\"3\" height=\"3\" rx=\"1\"/>",
            "line 3: rect: not supported: a rect with round corners",
        ),
        (
            "<g clip-path=\"url(#a)\"><circle r=\"1\"/></g>",
            "line 3: g: not supported: clip-path",
        ),
        (
            "<path id=\"p\" d=\"M 0 0 L 1 x\"/>",
            "line 3: path \"p\": invalid number at position 11",
        ),
    ] {
        let error = drawn("svg", &svg(element), &in_mm())
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with(words.split(" at position").next().unwrap()),
            "{error}"
        );
    }
    for words in [
        "transform=\"scale(2)\"",
        "style=\"transform: scale(2)\"",
        "mask=\"url(#a)\"",
    ] {
        let page = svg("<circle r=\"1\"/>").replace("<svg", &format!("<svg {words}"));
        let error = drawn("svg", &page, &in_mm()).unwrap_err();
        assert!(error.reason.contains("not supported: "), "{error}");
    }
    let doctype = format!("<!DOCTYPE svg>{}", "<svg/>");
    let error = drawn("svg", &doctype, &in_mm()).unwrap_err();
    assert!(error.help.contains("DOCTYPE"), "{error}");
    let binary = read(
        Path::new("a.DXF"),
        b"AutoCAD Binary DXF\r\n\x1a\0",
        &in_mm(),
    )
    .unwrap_err();
    assert_eq!(binary.to_string(), "byte 1: not supported: a binary DXF");
    let error = read(Path::new("a.dwg"), b"", &in_mm()).unwrap_err();
    assert!(error.reason.starts_with("a.dwg: unknown kind"), "{error}");
}

/// What the crate would take for zero, or pass over.
#[test]
fn entities_must_be_whole() {
    let square = polyline(
        true,
        &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
        "",
    );
    for (entity, words) in [
        (
            "LINE 10 0 20 0 11 5".to_owned(),
            "group 11 of LINE: a point without x or y",
        ),
        ("LINE 10 0 20 0".to_owned(), "group 11 of LINE is missing"),
        (
            "ARC 10 0 20 0 40 1 50 0".to_owned(),
            "group 51 of ARC is missing",
        ),
        (
            "CIRCLE 10 0 20 0 40 1 40 2".to_owned(),
            "group 40 of CIRCLE appears twice",
        ),
        (
            "CIRCLE 10 0 20 0 40 nan".to_owned(),
            "group 40 of CIRCLE is not a number: \"nan\"",
        ),
        (
            "CIRCLE 10 0 20 0 40 1,5".to_owned(),
            "group 40 of CIRCLE is not a number: \"1,5\"",
        ),
        (
            "CIRCLE 10 0 20 0 40 -1".to_owned(),
            "radius -1, allowed is above 0",
        ),
        (
            "CIRCLE 10 0 20 0 40 1e99".to_owned(),
            "a coordinate or radius is not a number, or greater than 1e6 mm",
        ),
        (
            square.replace("90 3", "90 4"),
            "group 90 is 4, but there are 3 values of group 10",
        ),
        ("VERTEX 10 0 20 0".to_owned(), "a VERTEX without a POLYLINE"),
        ("POLYLINE 66 1".to_owned(), "a POLYLINE without SEQEND"),
        (
            spline(3, &[0.0; 5], &[[0.0; 2]; 4], &[]),
            "a spline of degree 3 with 4 control points and 5 knots, expected more than 3 points and 8 knots",
        ),
        (
            spline(
                3,
                &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5],
                &[[0.0; 2]; 4],
                &[],
            ),
            "a spline whose knots do not ascend",
        ),
    ] {
        let error = drawn("dxf", &dxf(&[entity]), &in_mm()).unwrap_err();
        let text = error.to_string();
        assert!(text.ends_with(words) && text.starts_with("line "), "{text}");
        assert!(!error.help.is_empty());
    }
}

#[test]
fn layers_and_ids_that_are_not_there_are_reported_with_those_that_are() {
    let options = Options {
        select: Some("Gear".to_owned()),
        ..in_mm()
    };
    check(
        "dxf",
        &made::mixed_dxf(),
        &options,
        "has no layer \"Gear\", those there are: \"TEETH\", \"BORE\"",
        "one of these",
    );
    check(
        "svg",
        &made::mixed_svg(),
        &options,
        "has no id \"Gear\", those there are: \"teeth\"",
        "one of these",
    );
    check(
        "csv",
        &made::list(),
        &options,
        "has no layer or id \"Gear\", and no other",
        "leave it out",
    );
}

#[test]
fn lists_are_read_strictly() {
    for (text, words) in [
        ("0,0\n1,0\n0;1\n", "line 3: 1 columns, expected two"),
        ("0,0\n1,0,0\n0,1\n", "line 2: 3 columns, expected two"),
        ("0,0\n1,nan\n0,1\n", "line 2: \"nan\" is not a number"),
        ("0,0\nx,y\n0,1\n", "line 2: \"x\" is not a number"),
        ("a,b\n0,0\n", "line 1: \"a\" is not a number"),
        (
            "0;1.5\n1,5;0\n0;1\n",
            "line 2: \"1,5\" has a decimal comma, those before have a point",
        ),
        (
            "0;1,500\n1;0\n0;1\n",
            "line 1: \"1,500\" is ambiguous: decimal comma or thousands separator",
        ),
        (
            "0,0\n1,0\n0,0\n",
            "no closed loop: 2 different points, expected at least three",
        ),
        ("# unit: ell\n0,0\n", "line 1: unit \"ell\" is not known"),
        (
            "# unit: mm\nx (cm),y (cm)\n",
            "line 2: unit \"cm\", in line 1 it is \"mm\"",
        ),
        (
            "",
            "no closed loop: 0 different points, expected at least three",
        ),
    ] {
        check("csv", text, &in_mm(), words, "");
    }
}

#[test]
fn what_is_cut_off_or_too_large_is_reported() {
    let whole = dxf(&[line([0.0, 0.0], [1.0, 0.0])]);
    let cut = &whole[..whole.len() - 8];
    let error = drawn("dxf", cut, &in_mm()).unwrap_err().to_string();
    assert!(
        error.ends_with("the file ends without EOF: it is truncated"),
        "{error}"
    );
    let error = read(Path::new("a.csv"), &vec![b'\n'; (64 << 20) + 1], &in_mm()).unwrap_err();
    assert_eq!(error.to_string(), "has more than 67108864 bytes");
    let many = "0 1 1 0 ".repeat(300_000);
    let error = drawn("svg", &svg(&format!("<path d=\"M {many}\"/>")), &in_mm()).unwrap_err();
    assert!(error.reason.contains(" is open: "), "{error}");
    let error = drawn(
        "svg",
        &svg(&format!("<path d=\"M {many} L {many}\"/>")),
        &in_mm(),
    )
    .unwrap_err();
    assert_eq!(error.to_string(), "has more than 1000000 segments");
    let deep = svg(&format!(
        "{}<circle r=\"1\"/>{}",
        "<g>".repeat(100_000),
        "</g>".repeat(100_000)
    ));
    let error = drawn("svg", &deep, &in_mm()).unwrap_err().to_string();
    assert!(error.contains("groups nested deeper than 200"), "{error}");
}
