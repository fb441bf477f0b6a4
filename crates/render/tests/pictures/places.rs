//! Charts, parsed and compared with the data.

use super::drawn::{HALF, INK, LEFT, Picture, RIGHT, Spot, ends, is_at, place};
use super::{
    ALL_KINDS, TITLE, UM, course, heading, of_course, of_difference, over, simulated, study,
};
use gearlash::gear::Side;
use gearlash_render::chart;
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
        let plot = &chart.plot;
        for (name, value) in [
            ("data-left", plot.left),
            ("data-right", plot.right),
            ("data-top", plot.top),
            ("data-bottom", plot.bottom),
            ("data-x0", plot.x[0]),
            ("data-x1", plot.x[1]),
            ("data-y0", plot.y[0]),
            ("data-y1", plot.y[1]),
        ] {
            assert_eq!(root.attribute(name).unwrap().parse(), Ok(value), "{name}");
        }
        assert_eq!(chart.panels[0], chart.plot);
    }
}

/// Right-flank lines are solid: each of their points is one pose, where no column holds more than four.
#[test]
fn a_revolution_stands_where_its_poses_are() {
    for (fixture, a) in [
        ("karba_44x44.toml", 132.21),
        ("karba_44x44_pitch.toml", 132.0),
    ] {
        let course = course(fixture, a);
        let (chart, picture) = of_course(&course);
        let mut drawn = picture.lines_of(RIGHT);
        drawn.retain(|line| line.len() > 100);
        let data = simulated(&course, Side::Right);
        assert_eq!((drawn.len(), data.len()), (2, 2));
        for (drawn, data) in drawn.iter().zip(&data) {
            assert_eq!((drawn.len(), data.len()), (704, 704));
            let mut pairs = drawn.iter().zip(data);
            assert!(pairs.all(|(spot, pose)| is_at(*spot, place(&chart.plot, *pose))));
        }
        // A dash begins or bends on the line of the left-flank poses.
        let data = simulated(&course, Side::Left);
        for &[x, y] in picture.lines_of(LEFT).concat().iter() {
            // The legend, with its sample, stands above the plot.
            if x < chart.plot.left || y < chart.plot.top {
                continue;
            }
            let mut segments = data.iter().flat_map(|line| line.windows(2));
            let near = segments.any(|pair| {
                let [from, to] = [pair[0], pair[1]].map(|pose| place(&chart.plot, pose));
                let [low, high] = ends([from[1], to[1]].into_iter());
                let inside = from[0] - HALF <= x && x <= to[0] + HALF;
                inside && (low - HALF..=high + HALF).contains(&y)
            });
            assert!(near, "{x} {y}");
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
    drawn.retain(|line| line[0][1] > chart.plot.top);
    assert_eq!(drawn.len(), runs);
    assert!(chart.svg.contains("gaps: jammed"));
}

/// Labels stand above all lines, with a halo; a cross is on each extreme.
#[test]
fn extremes_are_labelled_with_the_teeth_that_bind() {
    let course = course("karba_44x44_pitch.toml", 132.0);
    let (chart, picture) = of_course(&course);
    let least = course.least.unwrap();
    let all = Side::BOTH.map(|side| simulated(&course, side).concat());
    let [lowest, _] = ends(all.concat().iter().map(|pose| pose[1]));
    assert_eq!(least.backlash_um, lowest);
    let label = format!(
        "least −{:.1} µm: right flanks {}·{}, left flanks {}·{} touch",
        -lowest, least.right.0, least.right.1, least.left.0, least.left.1
    );
    assert!(chart.svg.contains(&label), "{label}");
    assert!(chart.svg.contains("interference"));
    let spot = place(&chart.plot, [least.x, least.backlash_um]);
    let cross = picture.lines_of(INK).into_iter().any(|line| {
        let middle = [0, 1].map(|axis| 0.5 * (line[0][axis] + line[1][axis]));
        line.len() == 2 && is_at(middle, spot)
    });
    assert!(cross);

    let document = Document::parse(&chart.svg).unwrap();
    let mut children = document.root_element().children();
    let last = children.rfind(|node| node.is_element()).unwrap();
    assert_eq!(last.attribute("class"), Some("gearlash-labels"));
    // The halo is an element of its own below each text: readers that know no paint-order draw an outline over it.
    assert!(!chart.svg.contains("paint-order"));
    let texts: Vec<_> = last.children().filter(|node| node.is_element()).collect();
    let is_least = |text: Option<&str>| text.unwrap().contains("least −");
    assert!(texts.iter().any(|node| is_least(node.text())));
    for pair in texts.chunks(2) {
        assert_eq!(pair[0].text(), pair[1].text());
        assert_eq!(pair[0].attribute("stroke"), Some("#ffffff"));
        assert_eq!(pair[1].attribute("stroke"), None);
        for at in ["x", "y"] {
            assert_eq!(pair[0].attribute(at), pair[1].attribute(at));
        }
    }
}

/// Right-flank measurements of Tables 5 and 6 are filled circles.
#[test]
fn measured_values_stand_where_they_were_measured() {
    let curve = over(&study("karba_44x44.toml"), 11, 11);
    let chart = chart::distance(UM, &heading("c", "t"), &curve, &[]).unwrap();
    let picture = Picture::of(&chart.svg);
    let dots = picture.dots.iter().filter(|dot| dot.fill == RIGHT);
    let mut drawn: Vec<Spot> = dots.map(|dot| dot.centre).collect();
    drawn.retain(|spot| spot[1] > chart.plot.top);
    // Table 6, mating 11 & 11.
    let printed = [
        [132.21, 159.0],
        [132.15, 116.0],
        [132.09, 72.0],
        [132.04, 38.0],
    ];
    assert_eq!(drawn.len(), printed.len());
    for (spot, value) in drawn.iter().zip(printed) {
        assert!(is_at(*spot, place(&chart.plot, value)));
    }
    assert!(!chart.svg.contains(">interference"));
}

/// Model 3 agrees to 1e-9 µm: its panel has an axis of its own unit and says where the tolerance is. Simulation and model 1 differ
/// by another amount at each material: two lines that nothing told apart.
#[test]
fn the_difference_to_model_3_has_its_own_axis() {
    let course = course("karba_44x44.toml", 132.21);
    let (chart, picture) = of_difference(&course);
    assert_eq!(chart.panels.len(), 2);
    assert!(picture.has("10⁻⁹ µm"));
    assert!(picture.has("tolerance ±0.1 µm: far outside this axis"));
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
