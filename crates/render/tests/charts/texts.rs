//! Texts of a chart: none lies on another.

use super::{all_kinds, course, heading};
use gearlash_render::chart::{self, Chart, LineAxes, LineSeries, Look};
use roxmltree::{Document, Node};

/// Left, top, right, bottom.
type Room = [f64; 4];

/// A text and its room where it lies: 0.58 em a character, 0.33 em a thin one, about what DejaVu Sans takes; a capital's height.
fn text(node: &Node) -> (String, Room) {
    let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let content: String = node
        .descendants()
        .filter(Node::is_text)
        .filter_map(|text| text.text())
        .collect();
    let content = content.trim().to_owned();
    let thin = content
        .chars()
        .filter(|c| " ijlt.,:()·".contains(*c))
        .count() as f64;
    let wide = content.chars().count() as f64 - thin;
    let (x, y, size) = (number("x"), number("y"), number("font-size"));
    let width = size * (0.58 * wide + 0.33 * thin);
    let left = match node.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    (content, [left, y - 0.73 * size, left + width, y])
}

/// Every text that lies and is no halo is clear of the others.
fn check(name: &str, chart: &Chart) {
    let document = Document::parse(&chart.svg).unwrap();
    let texts = document.descendants().filter(|node| {
        let is_halo = node.has_attribute("aria-hidden");
        node.has_tag_name("text") && !is_halo && !node.has_attribute("transform")
    });
    let texts: Vec<_> = texts.map(|node| text(&node)).collect();
    assert!(texts.len() > 3, "{name}");
    for (number, (content, a)) in texts.iter().enumerate() {
        for (other, b) in &texts[..number] {
            let distance = a[0] >= b[2] || b[0] >= a[2] || a[1] >= b[3] || b[1] >= a[3];
            assert!(distance, "{name}: {content:?} on {other:?}");
        }
    }
}

#[test]
fn no_text_of_any_kind_lies_on_another() {
    for (number, chart) in all_kinds("t").iter().enumerate() {
        check(&format!("chart {number}"), chart);
    }
}

/// A helical pair 27/51 and a pair 200/31: the words at the limits of the mesh cycle stood on those at what the course attains.
#[test]
fn words_at_the_mesh_cycle_keep_clear_of_those_at_the_course() {
    for fixture in ["karba_44x44.toml", "karba_44x44_pitch.toml"] {
        let plain = course(fixture, 132.21);
        let [least, greatest] = [&plain.least, &plain.greatest].map(|end| end.as_ref().unwrap());
        let ends = [least.backlash_um, greatest.backlash_um];
        for part in [
            0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.13, 0.16, 0.2, 0.3, 0.5, 1.0,
        ] {
            for middle in [0.1, 0.5, 0.9] {
                let beyond = part * (ends[1] - ends[0]);
                let mut course = plain.clone();
                course.cycle_um = [Some(ends[0] - beyond), Some(ends[1] + beyond)];
                // Where the extremes stand along the axis decides on which side of them their words are.
                let [from, to] = course.span;
                for extreme in [&mut course.least, &mut course.greatest]
                    .into_iter()
                    .flatten()
                {
                    extreme.x = from + middle * (to - from);
                }
                let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
                check(&format!("{fixture}, {part} beyond, at {middle}"), &chart);
            }
        }
    }
}

/// The roll test of a gear with 200 teeth: the note on its envelope stood on the end of a long title.
#[test]
fn the_note_on_an_envelope_keeps_clear_of_the_title() {
    for title in [
        "",
        "short",
        "roll test with a master of z 30 · F_i'' 88.303, f_i'' 53.509 µm · mean 172.385350 mm",
    ] {
        let swing = |number: u32| (f64::from(number), Some(f64::from(number % 2)));
        let series = LineSeries {
            name: "a",
            points: (0..20_000).map(swing).collect(),
            look: Look::Plain,
            dots: false,
        };
        let axes = LineAxes {
            title,
            x: "x",
            teeth: None,
            y: "y",
            least: 1.0,
        };
        let chart = chart::lines(&heading("c", "t"), axes, &[series]).unwrap();
        assert!(chart.svg.contains("shaded: min–max"));
        check(title, &chart);
    }
}
