//! The general charts: bars and curves.

use super::drawn::{HALF, LEFT, Picture, RIGHT, Spot, ends, is_at, place};
use super::heading;
use gearlash_render::chart::{
    BarPanel, BarSeries, Chart, Heading, Look, PictureError, bar_panels, curve,
};

fn bars(series: &[BarSeries]) -> Result<Chart, PictureError> {
    let heading = Heading {
        subtitle: "made values",
        ..heading("small", "Five teeth")
    };
    let panel = BarPanel {
        y_axis: "deviation, µm",
        series,
        ..BarPanel::default()
    };
    bar_panels(&heading, "", "tooth", &[panel])
}

fn five_teeth() -> [BarSeries<'static>; 2] {
    let right = [1.0, 2.0, -1.5, 0.0, 0.5].map(Some);
    let left = [Some(-1.0), Some(0.5), Some(2.0), None, Some(-0.5)];
    [
        BarSeries {
            name: "right",
            values: right.to_vec(),
            look: Look::Right,
        },
        BarSeries {
            name: "left",
            values: left.to_vec(),
            look: Look::Left,
        },
    ]
}

/// Bars of a tooth stand side by side about its number, from zero to the value; a missing one is left out.
#[test]
fn small_bar_chart() {
    let series = five_teeth();
    let chart = bars(&series).unwrap();
    let picture = Picture::of(&chart.svg);
    for (colour, series, from) in [(RIGHT, &series[0], -0.4), (LEFT, &series[1], 0.0)] {
        let own = picture.areas.iter().filter(|area| area.stroke == colour);
        let mut drawn = own.filter(|area| area.room[3] > chart.panels[0].frame.top);
        for (tooth, value) in (1..).zip(&series.values) {
            let Some(value) = *value else {
                continue;
            };
            let [left, top, right, bottom] = drawn.next().unwrap().room;
            let x = f64::from(tooth) + from;
            let [low, high] = [(x, value.min(0.0)), (x + 0.4, value.max(0.0))]
                .map(|(x, y)| place(&chart.panels[0], [x, y]));
            assert!(is_at([left, bottom], low) && is_at([right, top], high));
        }
        assert!(drawn.next().is_none());
    }
    insta::assert_snapshot!(chart.svg);
}

fn curve_over(points: &[(f64, Option<f64>)]) -> Result<Chart, PictureError> {
    let titles = ["", "tooth", "M_dK, mm"];
    curve(&heading("small", "t"), titles, 4, 0.1, points.to_vec())
}

/// Where its points are, with a gap.
#[test]
fn a_curve_goes_through_its_points() {
    let points = [3.0, 5.0, f64::NAN, 4.0, 1.0].map(|y| Some(y).filter(|y| y.is_finite()));
    let points: Vec<_> = [1.0, 2.0, 3.0, 4.0, 5.0].into_iter().zip(points).collect();
    let chart = curve_over(&points).unwrap();
    let picture = Picture::of(&chart.svg);
    let mut drawn = picture.lines.iter().filter(|line| line.width == "1.60");
    let expected: [[Spot; 2]; 2] = [[[1.0, 3.0], [2.0, 5.0]], [[4.0, 4.0], [5.0, 1.0]]];
    for expected in expected {
        let line = drawn.next().unwrap();
        assert_eq!(line.points.len(), 2);
        for (spot, point) in line.points.iter().zip(expected) {
            assert!(is_at(*spot, place(&chart.panels[0], point)));
        }
    }
    assert!(drawn.next().is_none());
}

/// Rounding noise does not fill a chart: its axis is as high as said at least.
#[test]
fn noise_is_drawn_flat() {
    let points = [(1.0, Some(-1e-9)), (2.0, Some(1e-9)), (3.0, Some(0.0))];
    let [low, high] = curve_over(&points).unwrap().panels[0].y;
    assert!(high - low >= 0.1);
    assert!((low + high).abs() < 1e-6);
}

/// A bar for each of 10 000 teeth would be a few megabytes and narrower than a pixel.
#[test]
fn ten_thousand_teeth_are_a_thinned_line() {
    let values = (0..10_000).map(|i| Some(f64::from(i % 97) - 40.0));
    let [mut series, _] = five_teeth();
    series.values = values.collect();
    let chart = bars(&[series]).unwrap();
    assert!(chart.svg.len() < 300_000);
    let drawn = Picture::of(&chart.svg).lines_of(RIGHT).concat();
    let heights = drawn.iter().map(|spot| spot[1]);
    let [top, _] = ends(heights.filter(|y| *y > chart.panels[0].frame.top));
    assert!((top - place(&chart.panels[0], [1.0, 56.0])[1]).abs() < HALF);
}

#[test]
fn nothing_to_draw_is_an_error() {
    let [mut none, _] = five_teeth();
    none.values.clear();
    assert!(bars(&[]).is_err());
    assert!(bars(&[none]).is_err());
    assert!(curve_over(&[]).is_err());
}
