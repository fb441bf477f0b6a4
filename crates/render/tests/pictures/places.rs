//! Charts, parsed and compared with the data.

use super::drawn::{LEFT, Picture, RIGHT, is_at, place};
use super::{ALL_KINDS, TITLE, course, of_course, of_difference};
use gearlash::gear::Side;
use roxmltree::Document;

/// One element with an escaped title, ids of its own and nothing from elsewhere, which tells scripts its frame.
#[test]
fn every_kind_is_one_svg_element_with_an_escaped_title() {
    for chart in ALL_KINDS.iter() {
        let document = Document::parse(&chart.svg).unwrap();
        let root = document.root_element();
        assert!(chart.svg.starts_with("<svg "));
        assert!(root.attribute("viewBox").unwrap().starts_with("0 0 800 "));
        let picture = Picture::of(&chart.svg);
        let title = TITLE.replace(['\u{1}', '\u{ffff}'], " ");
        assert_eq!(picture.texts[0].content, title.trim());
        // resvg, whose sans-serif is Arial, showed no text where there is none.
        let fonts = root.attribute("font-family").unwrap();
        assert!(fonts.starts_with("sans-serif, DejaVu Sans"), "{fonts}");
        assert_eq!(chart.svg.matches("font-family").count(), 1);
        for absent in ["<script", "NaN", "inf\"", "href", "url("] {
            assert!(!chart.svg.contains(absent), "{absent}");
        }
        assert!(chart.svg.len() < 300_000, "{} bytes", chart.svg.len());
        let prefix = root.attribute("id").unwrap();
        let nodes = document.descendants();
        let ids: Vec<&str> = nodes.filter_map(|node| node.attribute("id")).collect();
        assert!(ids.len() == 2 && ids.iter().all(|id| id.starts_with(prefix)));
        let plot = &chart.panels[0];
        for (name, value) in [
            ("data-left", plot.frame.left),
            ("data-right", plot.frame.right),
            ("data-top", plot.frame.top),
            ("data-bottom", plot.frame.bottom),
            ("data-x0", plot.x[0]),
            ("data-x1", plot.x[1]),
            ("data-y0", plot.y[0]),
            ("data-y1", plot.y[1]),
        ] {
            assert_eq!(root.attribute(name).unwrap().parse(), Ok(value), "{name}");
        }
    }
}

#[test]
fn gaps_of_jammed_poses_stay_gaps() {
    let course = course("tip_on_fillet_86x21.toml", 159.72);
    let line = &course.lines[0].points;
    let runs = line.split(|point| point.simulated_um.is_none());
    let runs = runs.filter(|run| run.len() > 1).count();
    assert!(runs > 80);
    let (chart, picture) = of_course(&course);
    let mut drawn = picture.lines_of(RIGHT);
    drawn.retain(|line| line[0][1] > chart.panels[0].frame.top);
    assert_eq!(drawn.len(), runs);
    assert!(chart.svg.contains("gaps: jammed"));
}

/// Model 3 agrees to 1e-9 µm: its panel has an axis of its own unit and says where the tolerance is. Simulation and model 1 differ
/// by another amount at each material: two lines that nothing told apart.
#[test]
fn the_difference_to_model_3_has_its_own_axis() {
    let course = course("karba_44x44.toml", 132.21);
    let (chart, picture) = of_difference(&course);
    assert_eq!(chart.panels.len(), 2);
    assert!(picture.has("10⁻⁹ µm"));
    assert!(picture.has("tolerance ±0.1 µm: outside this axis"));
    let lower = chart.panels[1];
    let mut drawn = picture.lines_of(RIGHT);
    drawn.retain(|line| line.len() > 100);
    assert_eq!(drawn.len(), 2);
    let lines = course.lines.iter().filter(|line| line.flank == Side::Right);
    for (drawn, line) in drawn.iter().zip(lines) {
        assert_eq!(drawn.len(), line.points.len());
        for (spot, point) in drawn.iter().zip(&line.points) {
            let value = point.off_line_of_action_um.unwrap() / 1e-9;
            assert!(is_at(*spot, place(&lower, [point.x, value])));
        }
    }
    // The legend's sample has a width of its own.
    let lines = picture.lines.iter().filter(|line| line.stroke == LEFT);
    let mut widths: Vec<&str> = lines.map(|line| line.width.as_str()).collect();
    widths.sort_unstable();
    widths.dedup();
    assert_eq!(widths.len(), 3, "{widths:?}");
    assert!(chart.svg.contains("(thin: least material)"));
}
