//! Drawn outlines against other readers and closed forms; each fault with its place and remedy; mutants.

mod chains;
mod curves;
mod dialects;
mod lists;
mod made;
#[path = "../tables/mutant.rs"]
mod mutant;
mod mutations;
mod pages;
mod round_trip;
mod splines;

use gearlash::outline::PathSegment;
use gearlash_drawing::{Drawing, DrawingError, DrawnPath, Options, Unit, read};
use nalgebra::Point2;
use std::path::Path;

/// Reads `text` as a file that ends in `ending`.
fn drawn(ending: &str, text: &str, options: &Options) -> Result<Drawing, DrawingError> {
    let name = format!("gear.{ending}");
    let read = read(Path::new(&name), text.as_bytes(), options);
    if let Ok(drawing) = &read {
        check_sound(drawing);
    }
    read
}

/// In mm.
fn in_mm() -> Options {
    stated_in(Unit::Mm)
}

fn stated_in(unit: Unit) -> Options {
    Options {
        unit: Some(unit),
        ..Options::default()
    }
}

/// The smooth curve through a list in mm.
fn smooth(text: &str) -> Vec<PathSegment> {
    let options = Options {
        smooth: true,
        ..in_mm()
    };
    let drawing = drawn("csv", text, &options).unwrap();
    drawing.loops[0].segments.clone()
}

/// The one loop of `text` in mm.
fn loop_of(ending: &str, text: &str) -> DrawnPath {
    let drawing = drawn(ending, text, &in_mm()).unwrap_or_else(|error| panic!("{error}"));
    let [one] = &drawing.loops[..] else {
        panic!("{drawing:?}");
    };
    one.clone()
}

/// Checks an invariant of every drawing: its loops are closed and have finite numbers.
fn check_sound(drawing: &Drawing) {
    assert!(!drawing.loops.is_empty());
    for one in &drawing.loops {
        assert!(!one.segments.is_empty() && !one.place.is_empty());
        assert!(one.bound_mm.is_finite() && one.bound_mm >= 0.0);
        let next = one.segments.iter().skip(1).chain(&one.segments[..1]);
        for (segment, next) in one.segments.iter().zip(next) {
            assert!(segment.is_finite() && segment.length() > 0.0, "{segment:?}");
            let gap = (next.start() - segment.end()).norm();
            assert!(gap <= 1.0001e-9, "{gap:e} mm: {segment:?} {next:?}");
        }
    }
}

/// Distance of a point from a loop, mm.
fn distance(one: &DrawnPath, point: [f64; 2]) -> f64 {
    let point = Point2::from(point);
    let of = |segment: &PathSegment| {
        let at = |u: f64| (segment.at(u) - point).norm();
        let nearest = (0..=200).map(|step| f64::from(step) / 200.0);
        let nearest = nearest.min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap();
        let (mut low, mut high) = ((nearest - 0.005).max(0.0), (nearest + 0.005).min(1.0));
        for _ in 0..100 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if at(a) < at(b) {
                high = b;
            } else {
                low = a;
            }
        }
        at(0.5 * (low + high))
    };
    one.segments.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Points written as `x y, x y`.
fn points(text: &str) -> Vec<[f64; 2]> {
    let number = |word: &str| word.parse().unwrap();
    let point = |pair: &str| {
        let (x, y) = pair.trim().split_once(' ').unwrap();
        [number(x), number(y)]
    };
    text.split(',').map(point).collect()
}

/// Checks that each of `points` lies on the loop within its bound and rounding.
fn check_through(one: &DrawnPath, points: &[[f64; 2]]) {
    for &point in points {
        let distance = distance(one, point);
        assert!(distance <= one.bound_mm + 1e-11, "{point:?}: {distance:e}");
    }
}

/// `through.txt` holds drawings, and points of their loops as other programs find them.
#[test]
fn loops_go_through_the_points_of_other_programs() {
    let lines = include_str!("through.txt").lines();
    for line in lines.filter(|line| line.contains(" | ")) {
        let [ending, drawn, on] = line.split(" | ").collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let text = match ending {
            "dxf" => made::dxf(&drawn.split("; ").map(str::to_owned).collect::<Vec<_>>()),
            _ => made::svg(drawn),
        };
        check_through(&loop_of(ending, &text), &points(on));
    }
}
