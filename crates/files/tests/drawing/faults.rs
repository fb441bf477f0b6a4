//! Drawings that are cut off, too large or of another kind. `tests/sessions/drawing_faults.txt` holds the other faults.

use super::*;
use made::{dxf, line, svg};

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
        ("dwg", String::new(), "gear.dwg: unknown kind"),
        (
            "DXF",
            "AutoCAD Binary DXF\r\n\x1a\0".to_owned(),
            "byte 1: not supported: a binary DXF",
        ),
    ] {
        let error = drawn(ending, &text, &in_mm()).unwrap_err();
        assert!(error.reason.contains(words), "{error}");
    }
}
