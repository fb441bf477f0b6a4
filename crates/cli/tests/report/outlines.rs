//! The page of a pair with an outline.

use crate::command::gearlash;
use crate::page::checked;
use crate::words::{row, select, text};
use std::path::Path;
use tempfile::TempDir;

/// A folder with the drawings of `fixtures/outlines`, and `pair` as the pair file.
fn drawn(pair: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    let drawings = Path::new(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fixtures/outlines"
    ));
    for name in ["wheel_20.dxf", "pinion_20.svg", "drawn_20x20.toml"] {
        std::fs::copy(drawings.join(name), folder.path().join(name)).unwrap();
    }
    if !pair.is_empty() {
        std::fs::write(folder.path().join("drawn_20x20.toml"), pair).unwrap();
    }
    folder
}

fn page(folder: &TempDir) -> String {
    let output = gearlash(folder)
        .args(["report", "drawn_20x20.toml", "-o", "-"])
        .assert()
        .success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}

/// The drawn pair, `gears`, at `a`.
fn at(a: &str) -> String {
    format!(
        "[wheel.outline]\nfile = \"wheel_20.dxf\"\n[pinion.outline]\nfile = \"pinion_20.svg\"\n[assembly]\ncenter_distance_mm = {a}\n"
    )
}

/// Source: `fixtures/outlines/wheel_20.toml` and `pinion_20.toml`, from which both were drawn: 20 teeth, d_a = 44, x = s/(2 m tan α) of
/// −60 µm and of −60 + 9 µm on the mean; the seventh tooth is 180 µm thicker than the others. Values of the mesh as `check` has them (its snapshot).
#[test]
fn the_page_of_two_drawings() {
    let folder = drawn("");
    let page = page(&folder);
    let document = checked(&page);
    let answer = text(&select(&document, ".answer")[0]);
    assert!(
        answer.starts_with("Does not assemble at a = 40.050 mm."),
        "{answer}"
    );
    let values = select(&document, ".extremes .value");
    assert!(text(&values[0]).starts_with("−15.61 "));
    assert_eq!(select(&document, ".verdict.fail").len(), 1);
    let cells = row(&document, "#result", "40.050");
    let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
    assert_eq!(
        cells,
        [
            "40.050",
            "no: interference",
            "−15.61",
            "7·15 / 7·16",
            "152.43",
            "174.18",
            "6·16 / 6·17"
        ]
    );
    for (name, wheel, pinion) in [
        ("drawing", "wheel_20.dxf", "pinion_20.svg"),
        (
            "unit",
            "1 mm, stated by the drawing",
            "1 mm, stated by the drawing",
        ),
        (
            "centre in the drawing, mm",
            "(0, 0), as stated",
            "(0, 0), as stated",
        ),
        // 20 tips and 20 roots are arcs, the rest chords.
        (
            "parts of the outline",
            "760 lines, 40 arcs",
            "760 lines, 40 arcs",
        ),
        ("teeth", "20", "20"),
        ("tip diameter, mm", "44", "44"),
    ] {
        let cells = row(&document, "#input", name);
        assert_eq!([&cells[1], &cells[2]], [wheel, pinion], "{name}");
    }
    let input = text(&select(&document, "#input")[0]);
    assert!(input.contains("Found, not used: the wheel looks like module 2.0 mm, 20°, 20 teeth, x = −0.035 (residual"), "{input}");
    assert!(page.contains("40.0714 assembles from here on"));
    assert_eq!(select(&document, "#poses figure").len(), 2);
    assert!(input.contains("formulas and checks are left out"));
    for absent in ["<script", "contact ratio</", "Formulas"] {
        assert!(!page.contains(absent), "{absent}");
    }
}

/// The same input gives the same bytes; without -o the page goes beside the other results.
#[test]
fn the_page_of_drawings_is_the_same_twice() {
    let folder = drawn("");
    let first = page(&folder);
    gearlash(&folder)
        .args(["report", "drawn_20x20.toml"])
        .assert()
        .code(0)
        .stdout("out/drawn_20x20.html\n");
    let second = std::fs::read_to_string(folder.path().join("out/drawn_20x20.html")).unwrap();
    assert!(first == second);
}

/// Tips reach 22 mm, roots 17.42: below a = 39.42 a tip sits in a root, above 44 tips pass each other.
#[test]
fn drawings_that_jam_are_out_of_mesh_or_turn() {
    let jammed = page(&drawn(&at("39.3")));
    let document = checked(&jammed);
    assert_eq!(
        text(&select(&document, ".answer")[0]),
        "Jammed at a = 39.300 mm."
    );
    assert!(jammed.contains("Assembles from a = 40.0714 mm"));
    assert_eq!(select(&document, "#poses figure").len(), 1);
    assert!(jammed.contains("jammed: a tip sits in a root"));
    let out_of_mesh = page(&drawn(&at("44.3")));
    checked(&out_of_mesh);
    assert!(out_of_mesh.contains("Out of mesh at a = 44.300 mm"));
    assert!(out_of_mesh.contains("No pose is in mesh: there is nothing to draw."));
    // The first curve is that of the tightest.
    let several = page(&drawn(&at("[40.2, 40.0, 40.1]")));
    let document = checked(&several);
    let answer = text(&select(&document, ".answer")[0]);
    assert!(
        answer.starts_with("Does not assemble at 1 of 3 distances (a = 40.000 mm)."),
        "{answer}"
    );
    for (a, assembles) in [
        ("40.000", "no: interference"),
        ("40.100", "yes"),
        ("40.200", "yes"),
    ] {
        assert_eq!(row(&document, "#result", a)[1], assembles);
    }
    assert_eq!(select(&document, "#backlash details figure").len(), 2);
}

/// A gear by its data as the mate: two materials, each with its row, curve and map; the data stand where its drawing would.
#[test]
fn a_drawing_and_a_gear_by_its_data() {
    let pair = at("40.2").replace(
        "[pinion.outline]\nfile = \"pinion_20.svg\"",
        "[pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[pinion.thickness]\nallowance_um = { min = -60, max = -20 }",
    );
    let page = page(&drawn(&pair.replace(
        "[wheel.outline]",
        "title = \"<i>drawn</i> & \\u0007\"\n[wheel.outline]\nteeth = 20",
    )));
    let document = checked(&page);
    assert!(!page.contains("<i>drawn"));
    let rows = select(&document, "#backlash table tbody tr");
    let rows: Vec<String> = rows.iter().map(text).collect();
    assert!(
        rows[0].contains("most material") && rows[1].contains("least material"),
        "{rows:?}"
    );
    let drawing = row(&document, "#input", "drawing");
    assert_eq!(
        drawing[2],
        "none: by its data, module 2 mm, 20°, x = 0, allowance −60 … −20 µm"
    );
    assert_eq!(row(&document, "#input", "unit")[2], "–");
    assert_eq!(select(&document, "#backlash figure").len(), 3);
}

/// Square teeth, a list of points in inches: no involute, and the unit is the pair file's.
#[test]
fn an_outline_that_is_no_involute_is_called_none() {
    let points = (0..48).map(|k| {
        let (radius, angle) = (
            if k % 4 < 2 { 12.0 } else { 9.0 },
            f64::from(k) * std::f64::consts::TAU / 48.0,
        );
        format!(
            "{:.6},{:.6}\n",
            radius * angle.cos() / 25.4,
            radius * angle.sin() / 25.4
        )
    });
    let list = format!("x,y\n{}", points.collect::<String>());
    let gear = |name: &str| format!("[{name}.outline]\nfile = \"square.csv\"\nunits = \"inch\"\n");
    let folder = drawn(&format!(
        "{}{}[assembly]\ncenter_distance_mm = 22.5\n",
        gear("wheel"),
        gear("pinion")
    ));
    std::fs::write(folder.path().join("square.csv"), list).unwrap();
    let page = page(&folder);
    let document = checked(&page);
    assert!(page.contains("No outline looks like an involute."));
    assert_eq!(
        row(&document, "#input", "unit")[1],
        "25.4 mm, stated by the pair file"
    );
    assert_eq!(
        row(&document, "#input", "parts of the outline")[1],
        "48 lines"
    );
    assert_eq!(row(&document, "#input", "teeth")[2], "12");
}
