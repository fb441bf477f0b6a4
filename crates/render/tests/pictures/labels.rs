//! Labels of a chart cross no line: their boxes beside the lines that are drawn.

use super::{METHOD, all_kinds, heading, study};
use gearlash::analysis::Analysis;
use gearlash::analysis::Plan;
use gearlash::analysis::curves::{courses, with_sweep};
use gearlash::analysis::outcome::by_distance;
use gearlash_render::chart::{self, Chart, Plot};
use roxmltree::{Document, Node};

const UNDERCUT: &str = "../crates/render/tests/charts/pairs/undercut_8x24.toml";

type Spot = [f64; 2];

/// Left, top, right, bottom of a text: 0.58 em a character, 0.33 em a thin one, about what DejaVu Sans takes; a capital's height.
fn room(node: &Node) -> [f64; 4] {
    let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let texts = node.descendants().filter(Node::is_text);
    let content: String = texts.filter_map(|text| text.text()).collect();
    let thin = |c: &char| " ijlt.,:()·".contains(*c);
    let em: f64 = content
        .trim()
        .chars()
        .map(|c| if thin(&c) { 0.33 } else { 0.58 })
        .sum();
    let (x, y, size) = (number("x"), number("y"), number("font-size"));
    [x, y - 0.73 * size, x + size * em, y]
}

/// The lines of a path, each through its points.
fn lines(node: &Node) -> Vec<Vec<Spot>> {
    let data = node.attribute("d").unwrap_or_default();
    let parts = data.split('M').filter(|part| !part.is_empty());
    let line = |part: &str| {
        let points = part.trim_end_matches('Z').split('L');
        points
            .map(|point| {
                let (x, y) = point.split_once(' ').unwrap();
                [x, y].map(|number| number.parse().unwrap())
            })
            .collect()
    };
    parts.map(line).collect()
}

/// Whether a segment goes through a box: clipped to it by Liang and Barsky's way.
fn meets([from, to]: [Spot; 2], room: [f64; 4]) -> bool {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let along = to[axis] - from[axis];
        let [low, high] = [room[axis], room[axis + 2]].map(|edge| edge - from[axis]);
        if along == 0.0 {
            if low > 0.0 || high < 0.0 {
                return false;
            }
            continue;
        }
        let [first, last] = [
            f64::min(low / along, high / along),
            f64::max(low / along, high / along),
        ];
        (enter, leave) = (enter.max(first), leave.min(last));
    }
    enter <= leave
}

/// No label of the chart meets a line of the data, at either width.
fn check(name: &str, chart: &Chart) {
    for chart in [chart, &chart.narrow()] {
        let document = Document::parse(&chart.svg).unwrap();
        let nodes = || document.descendants();
        let label = |node: &Node| {
            let class = node.parent().and_then(|parent| parent.attribute("class"));
            class == Some("gearlash-labels") && node.has_tag_name("text")
        };
        // Axes and grid are no data.
        let is_data = |node: &Node| {
            let stroke = node.attribute("stroke");
            let is_grid = stroke == Some("#d5d9de") || stroke == Some("#d99a8c");
            node.has_tag_name("path") && node.attribute("fill") == Some("none") && !is_grid
        };
        let inside = |plot: &Plot, [x, y]: Spot| {
            x > plot.left + 0.1 && x < plot.right - 0.1 && y > plot.top && y < plot.bottom - 0.1
        };
        let segments: Vec<[Spot; 2]> = nodes()
            .filter(is_data)
            .flat_map(|node| lines(&node))
            .flat_map(|line| {
                line.windows(2)
                    .map(|pair| [pair[0], pair[1]])
                    .collect::<Vec<_>>()
            })
            .filter(|pair| {
                let middle = [0, 1].map(|i| 0.5 * (pair[0][i] + pair[1][i]));
                chart.panels.iter().any(|plot| inside(plot, middle))
            })
            .collect();
        for node in nodes().filter(label) {
            let room = room(&node);
            let crossed = segments.iter().find(|segment| meets(**segment, room));
            assert!(
                crossed.is_none(),
                "{name}: {:?} at {room:?} is crossed by {crossed:?}",
                node.text()
            );
            let plot = chart
                .panels
                .iter()
                .find(|plot| inside(plot, [room[0], room[3]]));
            let plot =
                plot.unwrap_or_else(|| panic!("{name}: {:?} outside the plots", node.text()));
            assert!(room[2] <= plot.right, "{name}: {:?} is cut", node.text());
        }
    }
}

#[test]
fn no_label_of_any_kind_crosses_a_line() {
    for (number, chart) in all_kinds("t").iter().enumerate() {
        check(&format!("chart {number}"), chart);
    }
}

/// The charts of a report for pairs of many kinds: the label of the least was on the dashed line of the mesh cycle.
#[test]
fn no_label_of_a_report_crosses_a_line() {
    for fixture in [
        UNDERCUT,
        "../crates/render/tests/charts/pairs/helical_25x61.toml",
        "../crates/render/tests/charts/pairs/printed_12x36.toml",
        "karba_44x44_pitch.toml",
    ] {
        let study = with_sweep(study(fixture));
        let analysis = Analysis::silently(&Plan::whole(&study, METHOD)).unwrap();
        for course in courses(&analysis.curves) {
            let course = course.with_cycle(&analysis.extremes.each);
            check(
                fixture,
                &chart::revolution(&heading("r", "t"), &course).unwrap(),
            );
            check(
                fixture,
                &chart::difference(&heading("d", "t"), &course, 0.1).unwrap(),
            );
        }
        let all: Vec<_> = analysis.all().collect();
        for curve in &analysis.over_distance {
            let ranges = by_distance(&all, &[]);
            check(
                fixture,
                &chart::distance(&heading("a", "t"), curve, &ranges).unwrap(),
            );
        }
        if let Some(field) = &analysis.field {
            check(fixture, &chart::field(&heading("f", "t"), field).unwrap());
        }
    }
}

/// The undercut pinion 8/24: between poses at 16 steps a pitch the curve reached 155.2 µm; its peaks are the proven
/// greatest of the cycle, 156.38 µm (issue 41).
#[test]
fn the_peaks_of_an_undercut_pair_are_drawn() {
    let study = with_sweep(study(UNDERCUT));
    let plan = Plan::new(&study, METHOD).with_revolution().with_extremes();
    let analysis = Analysis::silently(&plan).unwrap();
    let course = courses(&analysis.curves).remove(0);
    for line in &course.lines {
        let peaks = line.points.windows(3).filter(|three| {
            let [before, here, after] = [0, 1, 2].map(|i| three[i].simulated_um.unwrap());
            here > before && here > after && (here - 156.38).abs() < 0.005
        });
        assert_eq!(peaks.count(), 24, "{:?}", line.flank);
    }
    let even = courses(&analysis.revolution).remove(0);
    assert!(even.greatest.unwrap().backlash_um < 155.3);
}

/// Refined curves keep every pose of the even sweep, in order.
#[test]
fn a_refined_curve_goes_through_the_even_poses() {
    let study = with_sweep(study("karba_44x44_pitch.toml"));
    let plan = Plan::new(&study, METHOD).with_revolution().with_extremes();
    let analysis = Analysis::silently(&plan).unwrap();
    let [even, drawn] = [&analysis.revolution, &analysis.curves].map(|runs| courses(runs));
    for (even, fine) in even.iter().zip(&drawn) {
        for (even, fine) in even.lines.iter().zip(&fine.lines) {
            assert!(fine.points.len() > even.points.len());
            assert!(fine.points.is_sorted_by(|a, b| a.x < b.x));
            let kept = fine
                .points
                .iter()
                .filter(|point| even.points.contains(point));
            assert_eq!(kept.count(), even.points.len());
        }
    }
    // Without refinement the lowest pose lies above the proven least.
    let least = analysis
        .extremes
        .each
        .iter()
        .filter_map(|run| run.least.as_ref());
    let proven = least
        .map(|least| least.found() * 1e3)
        .fold(f64::MAX, f64::min);
    let lowest = drawn
        .iter()
        .filter_map(|course| course.least.map(|least| least.backlash_um));
    assert!((lowest.fold(f64::MAX, f64::min) - proven).abs() < 1e-6);
}
