//! The general charts: lines and bars.

use super::drawn::{HALF, LEFT, RIGHT, distance, place, polylines};
use gearlash_render::chart::{
    BarPanel, BarSeries, Chart, Heading, LineAxes, LineSeries, Look, PictureError, bar_panels,
    lines,
};
use roxmltree::Document;

fn heading<'a>() -> Heading<'a> {
    Heading {
        prefix: "small",
        title: "Five teeth",
        subtitle: "made values",
    }
}

fn bars([x_axis, y_axis]: [&str; 2], series: &[BarSeries]) -> Result<Chart, PictureError> {
    let panel = BarPanel {
        title: "",
        y_axis,
        series,
        limits: Vec::new(),
        level: 0.0,
    };
    bar_panels(&heading(), "", x_axis, &[panel])
}

fn series() -> [BarSeries<'static>; 2] {
    let values = |values: [f64; 5]| values.map(Some).to_vec();
    let mut left = values([-1.0, 0.5, 2.0, 1.5, -0.5]);
    left[3] = None;
    [
        BarSeries {
            name: "right",
            values: values([1.0, 2.0, -1.5, 0.0, 0.5]),
            look: Look::Right,
        },
        BarSeries {
            name: "left",
            values: left,
            look: Look::Left,
        },
    ]
}

#[test]
fn small_bar_chart() {
    let chart = bars(["tooth", "deviation, µm"], &series()).unwrap();
    insta::assert_snapshot!(chart.svg);
}

/// Bars of a tooth stand side by side about its number, from zero to the value; a missing one is left out.
#[test]
fn bars_stand_at_their_teeth() {
    let chart = bars(["tooth", "deviation, µm"], &series()).unwrap();
    let document = Document::parse(&chart.svg).unwrap();
    for (colour, series, from) in [(RIGHT, &series()[0], -0.4), (LEFT, &series()[1], 0.0)] {
        let outlines = polylines(&document, colour).into_iter();
        let mut drawn = outlines.filter(|line| line[0].1 > chart.plot.top);
        for (tooth, value) in (1..).zip(&series.values) {
            let Some(value) = *value else {
                continue;
            };
            let corners = drawn.next().unwrap();
            let left = f64::from(tooth) + from;
            let low = place(&chart.plot, (left, value.min(0.0)));
            let high = place(&chart.plot, (left + 0.4, value.max(0.0)));
            assert!(distance(corners[0], low) < HALF && distance(corners[2], high) < HALF);
        }
        assert!(drawn.next().is_none());
    }
}

#[test]
fn lines_of_several_looks_stand_where_their_points_are() {
    let points = vec![
        (1.0, Some(3.0)),
        (2.0, Some(5.0)),
        (3.0, None),
        (4.0, Some(4.0)),
        (5.0, Some(1.0)),
    ];
    let line = |look, dots| LineSeries {
        name: "a & b",
        points: points.clone(),
        look,
        dots,
    };
    let all = [
        line(Look::Right, false),
        line(Look::Third, false),
        line(Look::Left, true),
    ];
    let chart = lines(&heading(), axes(1e-3), &all).unwrap();
    let document = Document::parse(&chart.svg).unwrap();
    let drawn: Vec<_> = polylines(&document, RIGHT)
        .into_iter()
        .filter(|line| line[0].1 > chart.plot.top)
        .collect();
    let expected = [vec![(1.0, 3.0), (2.0, 5.0)], vec![(4.0, 4.0), (5.0, 1.0)]];
    assert_eq!(drawn.len(), 2);
    for (drawn, expected) in drawn.iter().zip(&expected) {
        assert_eq!(drawn.len(), 2);
        for (spot, point) in drawn.iter().zip(expected) {
            assert!(distance(*spot, place(&chart.plot, *point)) < HALF);
        }
    }
    assert!(chart.svg.contains("a &amp; b"));
}

fn axes(least: f64) -> LineAxes<'static> {
    LineAxes {
        title: "",
        x: "tooth",
        teeth: Some(4),
        y: "M_dK, mm",
        least,
    }
}

/// Rounding noise does not fill a chart: its axis is as high as said at least.
#[test]
fn noise_is_drawn_flat() {
    let line = LineSeries {
        name: "a''",
        points: vec![(1.0, Some(-1e-9)), (2.0, Some(1e-9)), (3.0, Some(0.0))],
        look: Look::Plain,
        dots: false,
    };
    let chart = lines(&heading(), axes(0.1), &[line]).unwrap();
    let [low, high] = chart.plot.y;
    assert!(high - low >= 0.1);
    assert!((low + high).abs() < 1e-6);
}

/// A bar for each of 10 000 teeth would be a few megabytes and narrower than a pixel.
#[test]
fn ten_thousand_teeth_are_a_thinned_line() {
    let values = (0..10_000)
        .map(|i| Some(f64::from(i % 97) - 40.0))
        .collect();
    let series = [BarSeries {
        name: "right",
        values,
        look: Look::Right,
    }];
    let chart = bars(["tooth", "µm"], &series).unwrap();
    assert!(chart.svg.len() < 300_000);
    let document = Document::parse(&chart.svg).unwrap();
    let drawn = polylines(&document, RIGHT).concat();
    let heights = drawn
        .iter()
        .map(|spot| spot.1)
        .filter(|y| *y > chart.plot.top);
    let top = heights.fold(f64::MAX, f64::min);
    assert!((top - place(&chart.plot, (1.0, 56.0)).1).abs() < HALF);
}

#[test]
fn nothing_to_draw_is_an_error() {
    let none = BarSeries {
        name: "none",
        values: vec![],
        look: Look::Plain,
    };
    assert!(bars(["tooth", "µm"], &[]).is_err());
    assert!(bars(["tooth", "µm"], &[none]).is_err());
    assert!(lines(&heading(), axes(1.0), &[]).is_err());
}
