//! Drawings made by formulas.

use std::f64::consts::TAU;
use std::fmt::Write;

/// A DXF in mm of these entities, each its pairs separated by spaces: "LINE 10 0 20 0 11 5 21 5".
pub fn dxf(entities: &[String]) -> String {
    in_units(Some(4), entities)
}

/// A DXF of these entities with `$INSUNITS`, or without.
pub fn in_units(insunits: Option<i32>, entities: &[String]) -> String {
    let mut text =
        "999\nmade by a formula\n  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1015\n"
            .to_owned();
    if let Some(unit) = insunits {
        write!(text, "  9\n$INSUNITS\n 70\n     {unit}\n").unwrap();
    }
    text += "  9\n$EXTMIN\n 10\n-99.0\n 20\n-99.0\n 30\n0.0\n  0\nENDSEC\n";
    text += "  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nLAYER\n 70\n1\n  0\nLAYER\n  2\nTEETH\n 70\n0\n 62\n7\n  6\n\n  0\nENDTAB\n  0\nENDSEC\n";
    text += "  0\nSECTION\n  2\nENTITIES\n";
    for entity in entities {
        for (index, word) in format!("0 {entity}").split(' ').enumerate() {
            let width = [3, 0][index % 2];
            writeln!(text, "{word:>width$}").unwrap();
        }
    }
    text += "  0\nENDSEC\n  0\nSECTION\n  2\nOBJECTS\n  0\nDICTIONARY\n  5\nC\n100\nAcDbDictionary\n  3\nACAD_GROUP\n350\nD\n  0\nENDSEC\n  0\nEOF\n";
    text
}

/// A straight line.
pub fn line([x, y]: [f64; 2], [u, v]: [f64; 2]) -> String {
    format!("LINE 8 TEETH 10 {x} 20 {y} 11 {u} 21 {v}")
}

/// Straight lines around.
pub fn lines(points: &[[f64; 2]]) -> Vec<String> {
    let next = points.iter().skip(1).chain(&points[..1]);
    let pairs = points.iter().zip(next);
    pairs.map(|(from, to)| line(*from, *to)).collect()
}

/// A light polyline of x, y, bulge.
pub fn polyline(closed: bool, vertices: &[[f64; 3]], more: &str) -> String {
    let mut text = format!(
        "LWPOLYLINE 8 TEETH{more} 90 {} 70 {}",
        vertices.len(),
        i32::from(closed)
    );
    for [x, y, bulge] in vertices {
        write!(text, " 10 {x} 20 {y} 42 {bulge}").unwrap();
    }
    text
}

/// A spline.
pub fn spline(degree: usize, knots: &[f64], points: &[[f64; 2]], weights: &[f64]) -> String {
    let mut text = format!(
        "SPLINE 8 TEETH 210 0 220 0 230 1 70 8 71 {degree} 72 {} 73 {} 74 0",
        knots.len(),
        points.len()
    );
    text.extend(knots.iter().map(|knot| format!(" 40 {knot}")));
    text.extend(weights.iter().map(|weight| format!(" 41 {weight}")));
    text.extend(points.iter().map(|[x, y]| format!(" 10 {x} 20 {y} 30 0")));
    text
}

/// Corners of a wheel with `teeth` straight teeth.
pub fn corners(teeth: u32) -> Vec<[f64; 2]> {
    (0..4 * teeth)
        .map(|index| {
            let radius = if index % 4 < 2 { 20.0 } else { 23.5 };
            let angle = TAU * (f64::from(index) + 0.1) / f64::from(4 * teeth);
            [radius * angle.cos(), radius * angle.sin()]
        })
        .collect()
}

/// Everything that a DXF may draw an outline with: teeth of lines, arcs, bulges, a spline and half an ellipse, and a bore.
pub fn mixed_dxf() -> String {
    let mut entities = vec![
        line([10.0, 0.0], [12.0, 1.0]),
        "ARC 8 TEETH 10 12 20 3 40 2 50 270 51 90".to_owned(),
        polyline(
            false,
            &[[12.0, 5.0, 0.4], [9.0, 8.0, -0.2], [5.0, 9.0, 0.0]],
            "",
        ),
        spline(
            3,
            &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0],
            &[[5.0, 9.0], [4.0, 11.0], [2.0, 8.0], [0.0, 8.0]],
            &[],
        ),
        "POLYLINE 8 TEETH 66 1 10 0 20 0 30 0 70 0".to_owned(),
        "VERTEX 8 TEETH 10 0 20 8 42 0.5".to_owned(),
        "VERTEX 8 TEETH 10 -5 20 0".to_owned(),
        "SEQEND 8 TEETH".to_owned(),
        "ELLIPSE 8 TEETH 10 2.5 20 0 11 7.5 21 0 40 0.5 41 3.141592653589793 42 6.283185307179586"
            .to_owned(),
        "TEXT 8 NOTES 10 0 20 0 40 2 1 z=8".to_owned(),
    ];
    entities.push("CIRCLE 8 BORE 10 3 20 2 40 1.5".to_owned());
    dxf(&entities)
}

/// A page of `width` mm with a view box as wide, holding `content`.
pub fn svg(content: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"-50 -50 100 100\">\n{content}\n</svg>\n"
    )
}

/// Everything that an SVG may draw an outline with.
pub fn mixed_svg() -> String {
    svg(concat!(
        "<title>a wheel of eight teeth, drawn by a formula</title>\n",
        "<metadata>0 1 2 3 4 5 6 7 8 9 no geometry here</metadata>\n",
        "<defs><path id=\"unused\" d=\"M 0 0 H 3 V 3 Z\"/></defs>\n",
        "<g transform=\"rotate(10) scale(2)\" fill=\"none\" stroke=\"black\" stroke-width=\"0.1\">\n",
        "<path id=\"teeth\" d=\"M10,-6 q 5,-8 11,2 t -2,3 A 3 3 0 0 1 15 4 a 9 4 30 0 0 -12 5 S 0,4 1,3 Z\"/>\n",
        "<circle cx=\"2\" cy=\"1\" r=\"0.5\"/>\n",
        "</g>\n",
        "<polygon points=\"-20,-20 -15,-20 -15,-12.5\"/>\n",
        "<rect x=\"-30\" y=\"-30\" width=\"4\" height=\"5\"/>\n",
        "<!-- the last words, in which no geometry is either -->"
    ))
}

/// A wheel as a list of points.
pub fn list() -> String {
    let mut text =
        "# made by a formula, for the mutants of the list\n# unit: mm\n# teeth twelve\nx,y\n"
            .to_owned();
    for [x, y] in corners(12) {
        writeln!(text, "{x:.6},{y:.6}").unwrap();
    }
    text
}
