//! `outline`: a gear as measured as DXF, SVG and CSV, compared with closed forms of its curves. `tests/sessions/outline.txt` holds small ones.

mod deviated;

use super::*;
use deviated::*;

/// The outline of a gear file, with options separated by blanks.
fn outline(file: &Path, options: &str) -> String {
    let mut command = gearlash(file.parent().unwrap());
    command.arg("outline").arg(file).args(["-o", "-"]);
    output(command.args(options.split(' ')))
}

/// Twice the area left of a closed polygon, halved.
fn area(points: &[Point]) -> f64 {
    let next = points.iter().cycle().skip(1);
    0.5 * points
        .iter()
        .zip(next)
        .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
        .sum::<f64>()
}

/// The vertices of the CSV, with further options.
fn csv_points(file: &Path, options: &str) -> Vec<Point> {
    let text = outline(file, &format!("--format csv{options}"));
    points_of(&text)
}

fn points_of(text: &str) -> Vec<Point> {
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|row| {
        let (x, y) = row.split_once(',').unwrap();
        [x.parse().unwrap(), y.parse().unwrap()]
    })
    .collect()
}

/// Vertices and bulges of the one LWPOLYLINE.
fn dxf_vertices(text: &str) -> Vec<(Point, f64)> {
    let lines: Vec<&str> = text.lines().collect();
    let (mut vertices, mut in_polyline) = (Vec::new(), false);
    for pair in lines.chunks(2) {
        let (code, value) = (pair[0], pair[1]);
        let number = || value.parse::<f64>().unwrap();
        match (code, in_polyline) {
            ("0", _) => in_polyline = value == "LWPOLYLINE",
            ("70", true) => assert_eq!(value, "1", "closed"),
            ("10", true) => vertices.push(([number(), 0.0], 0.0)),
            ("20", true) => vertices.last_mut().unwrap().0[1] = number(),
            ("42", true) => vertices.last_mut().unwrap().1 = number(),
            _ => {}
        }
    }
    assert!(text.contains(&format!("\n90\n{}\n", vertices.len())));
    vertices
}

#[test]
fn every_vertex_of_a_deviated_eccentric_gear_lies_on_its_curves() {
    let folder = empty_folder();
    for face in ["front", "back"] {
        let file = gear_file(folder.path(), face);
        let text = outline(&file, "--format csv");
        let points = points_of(&text);
        check_vertices(&points);
        assert!(area(&points) > 0.0, "counter-clockwise");
        assert!(text.contains("\n# unit: mm\n") && text.contains("\n# tolerance: 1 um ("));
    }
}

#[test]
fn chords_keep_the_tolerance_and_use_it() {
    let folder = empty_folder();
    let file = gear_file(folder.path(), "front");
    for tolerance_um in ["100", "1", "0.01"] {
        let points = csv_points(&file, &format!(" --tolerance-um {tolerance_um}"));
        let mut most: f64 = 0.0;
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let ends = [a, b].map(|end| radius(on_flank(*end).2));
            let on = |circle: f64| ends.iter().all(|end| (end - circle).abs() < 1e-9);
            for part in [0.25, 0.5, 0.75] {
                let at = [0, 1].map(|k| a[k] + part * (b[k] - a[k]));
                let (_, _, seen) = on_flank(at);
                most = most.max(match (on(tip()), on(root())) {
                    (true, _) => tip() - radius(seen),
                    (_, true) => root() - radius(seen),
                    _ if ends.iter().all(|end| *end > form() + 1e-9) => beside_involute(seen).abs(),
                    _ if ends.iter().all(|end| *end < form() - 1e-9) => beside_fillet(seen),
                    // The chord that ends where involute and fillet meet.
                    _ => beside_involute(seen).abs().min(beside_fillet(seen)),
                });
            }
        }
        let share = most * 1e3 / tolerance_um.parse::<f64>().unwrap();
        let is_used = share <= 1.0 + 1e-6 && share > 0.5;
        assert!(is_used, "{share} of {tolerance_um} um");
    }
}

#[test]
fn dxf_and_svg_hold_the_same_outline_with_lands_as_arcs() {
    let folder = empty_folder();
    let file = gear_file(folder.path(), "back");
    let text = outline(&file, "--format dxf");
    let vertices = dxf_vertices(&text);
    assert!(text.is_ascii());
    for words in [
        "999\ntitle: deviated <back> & eccentric \\U+00E9\n",
        "\n9\n$ACADVER\n1\nAC1015\n",
        "\n9\n$INSUNITS\n70\n4\n",
    ] {
        assert!(text.contains(words), "{words}");
    }
    let points: Vec<Point> = vertices.iter().map(|(point, _)| *point).collect();
    check_vertices(&points);

    // A bulge is the tangent of a quarter of the arc's angle: its middle stands half the chord times the bulge off the chord.
    let mut lands = [0, 0];
    let mut whole = area(&points);
    for (i, (a, bulge)) in vertices
        .iter()
        .enumerate()
        .filter(|(_, (_, bulge))| *bulge != 0.0)
    {
        let (b, _) = vertices[(i + 1) % vertices.len()];
        let chord = [b[0] - a[0], b[1] - a[1]];
        let middle = [
            0.5 * (a[0] + b[0] + bulge * chord[1]),
            0.5 * (a[1] + b[1] - bulge * chord[0]),
        ];
        let at = radius(on_flank(middle).2);
        let land = [tip(), root()]
            .iter()
            .position(|circle| (at - circle).abs() < 1e-9);
        lands[land.unwrap()] += 1;
        let angle = 4.0 * bulge.atan();
        let round = radius(chord) / (2.0 * (0.5 * angle).sin());
        whole += 0.5 * round * round * (angle - angle.sin());
    }
    assert_eq!(lands, [TEETH; 2]);

    // The area against that of a polygon a thousand times as fine: chords off by up to 1 µm along the whole outline.
    let fine = csv_points(&file, " --tolerance-um 0.001");
    let next = fine.iter().cycle().skip(1);
    let chords = fine
        .iter()
        .zip(next)
        .map(|(a, b)| radius([b[0] - a[0], b[1] - a[1]]));
    let length: f64 = chords.sum();
    let off = (whole - area(&fine)).abs();
    assert!(off > 0.0 && off < 1e-3 * length, "{off}");

    let text = outline(&file, "--format svg");
    let document = roxmltree::Document::parse(&text).unwrap();
    let svg = document.root_element();
    let view = svg.attribute("viewBox").unwrap().split(' ');
    let view: Vec<f64> = view.map(|word| word.parse().unwrap()).collect();
    let width = svg.attribute("width").unwrap().strip_suffix("mm").unwrap();
    assert_eq!(view[2], width.parse::<f64>().unwrap());
    assert!(view[0] < -tip() - ECCENTRICITY && view[0] + view[2] > tip() + ECCENTRICITY);
    assert!(text.contains("tolerance: 1 um"));
    assert!(text.contains("<title>deviated &lt;back&gt; &amp; eccentric é</title>"));
    let mut nodes = document.descendants();
    let path = nodes.find(|node| node.has_tag_name("path")).unwrap();
    let data = path.attribute("d").unwrap();
    let data = data.strip_suffix(" Z").unwrap().replace(['L', 'M'], "");
    // `x y`, then ` x y` of a chord or ` Ar r 0 0 0 x y` of an arc that is counter-clockwise on the sheet.
    let (mut words, mut radii) = (data.split_whitespace(), 0);
    let mut drawn = Vec::new();
    while let Some(word) = words.next() {
        let mut x = word;
        if let Some(round) = word.strip_prefix('A') {
            let round: f64 = round.parse().unwrap();
            let is_land = (round - tip()).abs() < 1e-9 || (round - root()).abs() < 1e-9;
            assert!(is_land, "{round}");
            radii += 1;
            let flags: Vec<&str> = words.by_ref().take(4).collect();
            assert_eq!(flags[1..], ["0", "0", "0"]);
            x = words.next().unwrap();
        }
        let y: f64 = words.next().unwrap().parse().unwrap();
        drawn.push([x.parse().unwrap(), 0.0 - y]);
    }
    assert_eq!(radii, 2 * TEETH);
    assert_eq!(drawn.pop().unwrap(), drawn[0]);
    assert_eq!(drawn, points);
}

/// A full tip round leaves no root land; two teeth that are thicker close the root between them. The outline does not cross itself.
#[test]
fn a_space_that_is_closed_at_its_root_ends_where_its_fillets_cross() {
    let folder = empty_folder();
    let file = folder.path().join("closed.toml");
    let text = "[gear]\nteeth = 12\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nprofile_shift = 0.4\n\
                rack = { root_radius = 0.4719 }\n\
                thickness = { per_tooth_um = [0, 150, 150, 0, -100, -100, -100, 0, 0, 0, 0, 0] }\n";
    std::fs::write(&file, text).unwrap();
    let points = csv_points(&file, " --tolerance-um 10");
    let across = |a: Point, b: Point, c: Point| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let count = points.len();
    let chord = |i: usize| (points[i], points[(i + 1) % count]);
    for i in 0..count {
        for j in i + 2..count {
            let ((a, b), (c, d)) = (chord(i), chord(j));
            let crossed =
                across(a, b, c) * across(a, b, d) < 0.0 && across(c, d, a) * across(c, d, b) < 0.0;
            let is_apart = !crossed || (i == 0 && j == count - 1);
            assert!(is_apart, "{a:?} {b:?} and {c:?} {d:?}");
        }
    }
    // Least radius: the deepest spaces reach the root circle, the closed ones do not.
    let root = 12.0 - 2.0 * (1.25 - 0.4);
    let valleys = (0..count).filter(|i| {
        let [before, at, after] = [i + count - 1, *i, i + 1].map(|k| radius(points[k % count]));
        at < before && at <= after && at > root + 1e-4
    });
    assert_eq!(valleys.count(), 3);
}

/// A section of a right-hand gear at `b` is that of the measuring plane, turned by `b tan β/r`: clockwise seen from the front,
/// counter-clockwise from the back. It turns about the centre of its outline, whose offset from the axis is constant.
#[test]
fn a_section_of_a_helical_gear_is_turned_with_its_helix() {
    let folder = empty_folder();
    for (face, sense) in [("front", -1.0), ("back", 1.0)] {
        let text = format!(
            "title = \"wound\"\n[gear]\nteeth = 21\nmodule_mm = 2\npressure_angle_deg = 20\nhelix_angle_deg = 15\nhand = \"right\"\n\
             face_mm = [-5, 12]\nreference_face = \"{face}\"\nrunout = {{ total_um = 400, high_tooth = 1 }}\n"
        );
        let file = folder.path().join("wound.toml");
        std::fs::write(&file, text).unwrap();
        let [plane, section] = [0, 10].map(|z| csv_points(&file, &format!(" --section {z}")));
        let beta = f64::to_radians(15.0);
        let radius = 21.0 / beta.cos();
        let (sin, cos) = (sense * 10.0 * beta.tan() / radius).sin_cos();
        assert_eq!(plane.len(), section.len());
        // Half the runout up: tooth 1 points up in the measuring plane.
        for (p, q) in plane.iter().zip(&section) {
            let [x, y] = [p[0], p[1] - 0.2];
            let turned = [x * cos - y * sin, x * sin + y * cos + 0.2];
            let off = (turned[0] - q[0]).hypot(turned[1] - q[1]);
            assert!(off < 1e-9, "{face}: {turned:?} {q:?}");
        }
    }
}
