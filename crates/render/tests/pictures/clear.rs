//! Texts of a chart keep clear of each other, and its labels of the lines that are drawn.

use super::drawn::{Picture, Room, Spot, meets, overlap};
use super::{ALL_KINDS, METHOD, UM, course, heading, study};
use gearlash::analysis::curves::{courses, with_sweep};
use gearlash::analysis::outcome::by_distance;
use gearlash::analysis::{Analysis, Plan};
use gearlash_render::chart::{self, Chart, Plot};
use roxmltree::Document;

const UNDERCUT: &str = "../crates/render/tests/pictures/pairs/undercut_8x24.toml";

fn contains(plot: &Plot, [x, y]: Spot) -> bool {
    x > plot.frame.left + 0.1
        && x < plot.frame.right - 0.1
        && y > plot.frame.top
        && y < plot.frame.bottom - 0.1
}

/// No text of the chart lies on another, and no label meets a line of the data, at either width.
fn check(name: &str, chart: &Chart) {
    for chart in [chart, &chart.narrow()] {
        let picture = Picture::of(&chart.svg);
        let texts = picture.texts.iter().filter(|text| text.is_plain);
        let texts: Vec<(&str, &Room)> = texts.map(|text| (&*text.content, &text.room)).collect();
        assert!(texts.len() > 3, "{name}");
        let document = Document::parse(&chart.svg).unwrap();
        let mut view = document
            .root_element()
            .attribute("viewBox")
            .unwrap()
            .split(' ');
        let width: f64 = view.nth(2).unwrap().parse().unwrap();
        for (number, (content, room)) in texts.iter().enumerate() {
            let on = texts[..number]
                .iter()
                .find(|(_, other)| overlap(room, other));
            assert!(on.is_none(), "{name}: {content:?} on {on:?}");
            assert!(room[2] < width, "{name}: {content:?} is cut at {room:?}");
        }
        // Axes and grid are no data.
        let is_grid = |stroke: &str| stroke == "#d5d9de" || stroke == "#d99a8c";
        let lines = picture.lines.iter();
        let data = lines.filter(|line| !line.is_filled && !is_grid(&line.stroke));
        let segments = data.flat_map(|line| line.points.windows(2));
        let inside = segments.filter(|ends| {
            let middle = [0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
            chart.panels.iter().any(|plot| contains(plot, middle))
        });
        let segments: Vec<[Spot; 2]> = inside.map(|ends| [ends[0], ends[1]]).collect();
        for text in picture.texts.iter().filter(|text| text.is_label) {
            let (words, room) = (&text.content, &text.room);
            let crossed = segments.iter().find(|segment| meets(**segment, room));
            let is_free = crossed.is_none();
            assert!(is_free, "{name}: {words:?} is crossed by {crossed:?}");
            let mut panels = chart.panels.iter();
            let plot = panels.find(|plot| contains(plot, [room[0], room[3]]));
            let plot = plot.unwrap_or_else(|| panic!("{name}: {words:?} outside the plots"));
            assert!(room[2] <= plot.frame.right, "{name}: {words:?} is cut");
        }
    }
}

#[test]
fn texts_of_any_kind_keep_clear() {
    for (number, chart) in ALL_KINDS.iter().enumerate() {
        check(&format!("chart {number}"), chart);
    }
}

/// The charts of a report for pairs of many kinds: the label of the least was on the dashed line of the mesh cycle.
#[test]
fn texts_of_a_report_keep_clear() {
    for fixture in [
        UNDERCUT,
        "../crates/render/tests/pictures/pairs/helical_25x61.toml",
        "../crates/render/tests/pictures/pairs/printed_12x36.toml",
        "karba_44x44_pitch.toml",
    ] {
        let study = with_sweep(study(fixture));
        let analysis = Analysis::silently(&Plan::whole(&study, METHOD)).unwrap();
        let mut charts = Vec::new();
        for course in courses(&analysis.curves) {
            let course = course.with_cycle(&analysis.extremes.each, &study.requirements);
            charts.push(Ok(chart::revolution(UM, &heading("r", "t"), &course)));
            charts.push(chart::difference(&heading("d", "t"), &course, 0.1));
        }
        let all: Vec<_> = analysis.all().collect();
        let ranges = by_distance(&all, &[]);
        let curves = analysis.over_distance.iter();
        charts.extend(curves.map(|curve| chart::distance(UM, &heading("a", "t"), curve, &ranges)));
        let field = analysis.field.iter();
        charts.extend(field.map(|field| Ok(chart::field(&heading("f", "t"), field))));
        for chart in charts {
            check(fixture, &chart.unwrap());
        }
    }
}

/// A helical pair 27/51 and a pair 200/31: the words at the limits of the mesh cycle stood on those at what the course attains.
#[test]
fn words_at_the_mesh_cycle_keep_clear_of_those_at_the_course() {
    for fixture in ["karba_44x44.toml", "karba_44x44_pitch.toml"] {
        let plain = course(fixture, 132.21);
        let [low, high] = [plain.least, plain.greatest].map(|end| end.unwrap().backlash_um);
        for part in [
            0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.13, 0.16, 0.2, 0.3, 0.5, 1.0,
        ] {
            for middle in [0.1, 0.5, 0.9] {
                let beyond = part * (high - low);
                let mut course = plain.clone();
                course.cycle_um = [Some(low - beyond), Some(high + beyond)];
                // Where the extremes stand along the axis decides on which side of them their words are.
                let [from, to] = course.span;
                let extremes = [&mut course.least, &mut course.greatest];
                for extreme in extremes.into_iter().flatten() {
                    extreme.x = from + middle * (to - from);
                }
                let chart = chart::revolution(UM, &heading("c", "t"), &course);
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
        let points = (0..20_000).map(swing).collect();
        let titles = [title, "x", "y"];
        let chart = chart::curve(&heading("c", "t"), titles, 200, 1.0, points).unwrap();
        assert!(chart.svg.contains("shaded: min–max"));
        check(title, &chart);
    }
}
