//! Charts, parsed and compared with the data.

use super::drawn::{HALF, INK, LEFT, RIGHT, circles, distance, place, polylines};
use super::{all_kinds, course, heading, over, simulated};
use gearlash::gear::Side;
use gearlash_render::chart::{self, Chart, Plot};
use roxmltree::Document;

const TITLE: &str = "A < B & \"C\" <script>alert('1')</script> ]]> \u{1}\u{ffff}";

#[test]
fn every_kind_is_one_svg_element_with_an_escaped_title() {
    for chart in all_kinds(TITLE) {
        let document = Document::parse(&chart.svg).unwrap();
        let root = document.root_element();
        assert!(chart.svg.starts_with("<svg "));
        assert!(root.attribute("viewBox").unwrap().starts_with("0 0 800 "));
        let named = |name| {
            document
                .descendants()
                .filter(move |node| node.has_tag_name(name))
        };
        assert_eq!(named("script").count(), 0);
        let title = named("text")
            .next()
            .unwrap()
            .text()
            .unwrap()
            .trim()
            .to_owned();
        assert_eq!(title, TITLE.replace(['\u{1}', '\u{ffff}'], " ").trim());
        // resvg, whose sans-serif is Arial, showed no text where there is none.
        let fonts = root.attribute("font-family").unwrap();
        assert!(fonts.starts_with("sans-serif, DejaVu Sans"), "{fonts}");
        assert!(named("text").all(|text| !text.has_attribute("font-family")));
        assert!(!chart.svg.contains("NaN") && !chart.svg.contains("inf\""));
        // Nothing from elsewhere.
        assert!(!chart.svg.contains("href") && !chart.svg.contains("url("));
        assert!(chart.svg.len() < 300_000, "{} bytes", chart.svg.len());
    }
}

#[test]
fn ids_start_with_the_prefix_and_the_frame_is_told_to_scripts() {
    for chart in all_kinds("t") {
        let document = Document::parse(&chart.svg).unwrap();
        let root = document.root_element();
        let prefix = root.attribute("id").unwrap();
        let ids = document
            .descendants()
            .filter_map(|node| node.attribute("id"));
        assert!(ids.clone().all(|id| id.starts_with(prefix)) && ids.count() == 2);
        let Plot {
            left,
            right,
            top,
            bottom,
            x,
            y,
        } = chart.plot;
        for (name, value) in [
            ("data-left", left),
            ("data-right", right),
            ("data-top", top),
            ("data-bottom", bottom),
            ("data-x0", x[0]),
            ("data-x1", x[1]),
            ("data-y0", y[0]),
            ("data-y1", y[1]),
        ] {
            assert_eq!(root.attribute(name).unwrap().parse(), Ok(value), "{name}");
        }
        assert_eq!(chart.panels[0], chart.plot);
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    assert_eq!(all_kinds("t"), all_kinds("t"));
}

/// Right-flank lines are solid: each of their points is one pose, where no column holds more than four.
#[test]
fn a_revolution_stands_where_its_poses_are() {
    for (fixture, a) in [
        ("karba_44x44.toml", 132.21),
        ("karba_44x44_pitch.toml", 132.0),
    ] {
        let course = course(fixture, a);
        let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
        let document = Document::parse(&chart.svg).unwrap();
        let long = |colour| {
            let lines = polylines(&document, colour).into_iter();
            lines.filter(|line| line.len() > 100).collect::<Vec<_>>()
        };
        let drawn = long(RIGHT);
        let data = simulated(&course, Side::Right);
        assert_eq!((drawn.len(), data.len()), (2, 2));
        for (drawn, data) in drawn.iter().zip(&data) {
            assert_eq!((drawn.len(), data.len()), (704, 704));
            for (spot, pose) in drawn.iter().zip(data) {
                assert!(distance(*spot, place(&chart.plot, *pose)) < HALF);
            }
        }
        // A dash begins or bends on the line of the left-flank poses.
        let data = simulated(&course, Side::Left);
        for &(x, y) in polylines(&document, LEFT).iter().flatten() {
            if x < chart.plot.left {
                continue; // the legend's sample
            }
            let near = data.iter().any(|line| {
                line.windows(2).any(|pair| {
                    let [from, to] = [0, 1].map(|i| place(&chart.plot, pair[i]));
                    let inside = from.0 - HALF <= x && x <= to.0 + HALF;
                    let between = f64::min(from.1, to.1) - HALF..=f64::max(from.1, to.1) + HALF;
                    inside && between.contains(&y)
                })
            });
            // The legend stands above the plot.
            assert!(near || y < chart.plot.top, "{x} {y}");
        }
    }
}

/// 28 896 poses of a hunting cycle: the path is thinned, the extremes stay.
#[test]
fn a_hunting_cycle_is_thinned_without_losing_its_extremes() {
    let mut study = super::study("tip_on_fillet_86x21.toml")
        .at(vec![160.3])
        .unwrap();
    study.sweep = Some(gearlash::pair::SweepPlan::Revolution {
        pitches: 1806,
        steps_per_pitch: 16,
        start: (1, 1),
    });
    let tick = || std::ops::ControlFlow::Continue(());
    let runs = gearlash::analysis::curves::revolution(&study, super::METHOD, &tick).unwrap();
    let course = gearlash::analysis::curves::courses(&runs).remove(0);
    assert_eq!(course.lines.len(), 2);
    let data = simulated(&course, Side::Right).remove(0);
    assert_eq!(data.len(), 28_896);
    let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
    assert!(chart.svg.len() < 300_000, "{}", chart.svg.len());
    let document = Document::parse(&chart.svg).unwrap();
    let drawn = polylines(&document, RIGHT).concat();
    let heights = || {
        drawn
            .iter()
            .map(|spot| spot.1)
            .filter(|y| *y > chart.plot.top)
    };
    let values = || data.iter().map(|pose| place(&chart.plot, *pose).1);
    for pick in [f64::min, f64::max] {
        let ends = (heights().reduce(pick), values().reduce(pick));
        assert!((ends.0.unwrap() - ends.1.unwrap()).abs() < HALF, "{ends:?}");
    }
}

#[test]
fn gaps_of_jammed_poses_stay_gaps() {
    let course = course("tip_on_fillet_86x21.toml", 159.72);
    let line = &course.lines[0].points;
    let runs = line.split(|point| point.simulated_um.is_none());
    let runs = runs.filter(|run| run.len() > 1).count();
    assert!(runs > 80);
    let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
    let document = Document::parse(&chart.svg).unwrap();
    let in_plot = |line: &&Vec<(f64, f64)>| line[0].1 > chart.plot.top;
    assert_eq!(
        polylines(&document, RIGHT).iter().filter(in_plot).count(),
        runs
    );
    assert!(chart.svg.contains("gaps: jammed"));
}

#[test]
fn extremes_are_labelled_with_the_teeth_that_bind() {
    let course = course("karba_44x44_pitch.toml", 132.0);
    let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
    let least = course.least.unwrap();
    let all = simulated(&course, Side::Right).concat();
    let all = [all, simulated(&course, Side::Left).concat()].concat();
    let lowest = all.iter().map(|pose| pose.1).fold(f64::MAX, f64::min);
    assert_eq!(least.backlash_um, lowest);
    let label = format!(
        "least −{:.1} µm: right flanks {}·{}, left flanks {}·{} touch",
        -lowest, least.right.0, least.right.1, least.left.0, least.left.1
    );
    assert!(chart.svg.contains(&label), "{label}");
    assert!(chart.svg.contains("interference"));
    // The cross is on it.
    let document = Document::parse(&chart.svg).unwrap();
    let spot = place(&chart.plot, (least.x, least.backlash_um));
    let cross = polylines(&document, INK).into_iter().any(|line| {
        let middle = (0.5 * (line[0].0 + line[1].0), 0.5 * (line[0].1 + line[1].1));
        line.len() == 2 && distance(middle, spot) < HALF
    });
    assert!(cross);
}

/// Right-flank measurements of Tables 5 and 6 are filled circles.
#[test]
fn measured_values_stand_where_they_were_measured() {
    let curve = over("karba_44x44.toml", (11, 11));
    let Chart { svg, plot, .. } = chart::distance(&heading("c", "t"), &curve, &[]).unwrap();
    let document = Document::parse(&svg).unwrap();
    let drawn: Vec<_> = circles(&document, RIGHT)
        .into_iter()
        .filter(|spot| spot.1 > plot.top)
        .collect();
    // Table 6, mating 11 & 11.
    let printed = [
        (132.21, 159.0),
        (132.15, 116.0),
        (132.09, 72.0),
        (132.04, 38.0),
    ];
    assert_eq!(drawn.len(), printed.len());
    for (spot, value) in drawn.iter().zip(printed) {
        assert!(distance(*spot, place(&plot, value)) < HALF);
    }
    assert!(!svg.contains(">interference"));
}

/// Model 3 agrees to 1e-9 µm: its panel has an axis of its own unit and says where the tolerance is.
#[test]
fn the_difference_to_model_3_has_its_own_axis() {
    let course = course("karba_44x44.toml", 132.21);
    let chart = chart::difference(&heading("c", "t"), &course, 0.1).unwrap();
    assert_eq!(chart.panels.len(), 2);
    let document = Document::parse(&chart.svg).unwrap();
    let texts: Vec<&str> = document
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text().map(str::trim))
        .collect();
    assert!(texts.contains(&"10⁻⁹ µm"));
    assert!(texts.contains(&"tolerance ±0.1 µm: far outside this axis"));
    let lower = chart.panels[1];
    let drawn: Vec<_> = polylines(&document, RIGHT)
        .into_iter()
        .filter(|line| line.len() > 100)
        .collect();
    let lines = course.lines.iter().filter(|line| line.flank == Side::Right);
    for (drawn, line) in drawn.iter().zip(lines) {
        assert_eq!(drawn.len(), line.points.len());
        for (spot, point) in drawn.iter().zip(&line.points) {
            let value = point.off_line_of_action_um.unwrap() / 1e-9;
            assert!(distance(*spot, place(&lower, (point.x, value))) < HALF);
        }
    }
    assert_eq!(drawn.len(), 2);
}

/// Simulation and model 1 differ by another amount at each material: two lines that nothing told apart.
#[test]
fn the_materials_of_a_difference_are_told_apart() {
    let course = course("karba_44x44.toml", 132.21);
    let chart = chart::difference(&heading("c", "t"), &course, 0.1).unwrap();
    let document = Document::parse(&chart.svg).unwrap();
    // Lines of curves: the legend's sample has a different width.
    let lines = document
        .descendants()
        .filter(|node| node.attribute("stroke") == Some(LEFT));
    let mut widths: Vec<_> = lines
        .filter_map(|node| node.attribute("stroke-width"))
        .collect();
    widths.sort_unstable();
    widths.dedup();
    assert_eq!(widths.len(), 3, "{widths:?}");
    assert!(chart.svg.contains("(thin: least material)"));
}

/// Labels stand above all lines, with a halo.
#[test]
fn labels_are_drawn_last_and_haloed() {
    let course = course("karba_44x44_pitch.toml", 132.0);
    let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
    let document = Document::parse(&chart.svg).unwrap();
    let root = document.root_element();
    let mut children = root.children();
    let last = children.rfind(|node| node.is_element()).unwrap();
    assert_eq!(last.attribute("class"), Some("gearlash-labels"));
    // The halo is an element of its own below each text: readers that know no paint-order draw an outline over it.
    assert!(!chart.svg.contains("paint-order"));
    let texts: Vec<_> = last.children().filter(|node| node.is_element()).collect();
    assert!(
        texts
            .iter()
            .any(|node| node.text().unwrap().contains("least −"))
    );
    for pair in texts.chunks(2) {
        assert_eq!(pair[0].text(), pair[1].text());
        assert_eq!(pair[0].attribute("stroke"), Some("#ffffff"));
        assert_eq!(pair[1].attribute("stroke"), None);
        for at in ["x", "y"] {
            assert_eq!(pair[0].attribute(at), pair[1].attribute(at));
        }
    }
}
