//! A closed polygon by its corners: its area, its centroid, how often it winds round a point.

use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Each corner and the next, about the first one.
fn sides(corners: &[Point2<f64>]) -> impl Iterator<Item = [Vector2<f64>; 2]> {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next);
    sides.map(|(a, b)| [a - corners[0], b - corners[0]])
}

/// The area it encloses, mm²; negative when it runs clockwise.
pub fn area(corners: &[Point2<f64>]) -> f64 {
    sides(corners).map(|[a, b]| 0.5 * a.perp(&b)).sum()
}

/// The centroid of its area; `None` of one without area.
pub fn centroid(corners: &[Point2<f64>]) -> Option<Point2<f64>> {
    let (mut twice, mut moment) = (0.0, Vector2::zeros());
    for [a, b] in sides(corners) {
        twice += a.perp(&b);
        moment += (a + b) * (a.perp(&b) / 3.0);
    }
    (twice != 0.0).then(|| corners[0] + moment / twice)
}

/// How often it winds counter-clockwise round `point`, which is on none of its sides.
pub fn winding(corners: &[Point2<f64>], point: Point2<f64>) -> i32 {
    let turns = sides(corners).map(|side| {
        let [a, b] = side.map(|corner| corners[0] + corner - point);
        a.perp(&b).atan2(a.dot(&b))
    });
    (turns.sum::<f64>() / TAU).round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: half of base times height, and a third of the sum of the corners.
    #[test]
    fn a_triangle() {
        let corners = [[10.0, 20.0], [16.0, 20.0], [10.0, 29.0]].map(Point2::from);
        let back = [corners[2], corners[1], corners[0]];
        assert_eq!((area(&corners), area(&back)), (27.0, -27.0));
        assert_eq!(centroid(&corners), Some(Point2::new(12.0, 23.0)));
        assert_eq!(centroid(&back), centroid(&corners));
        assert_eq!(centroid(&corners[..2]), None);
        let inside = Point2::new(11.0, 21.0);
        let windings = [
            (&corners, inside),
            (&back, inside),
            (&corners, Point2::origin()),
        ];
        assert_eq!(windings.map(|(of, point)| winding(of, point)), [1, -1, 0]);
    }
}
