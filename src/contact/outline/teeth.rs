//! The teeth of one side of an outline, and their positions in a frame.

use crate::contact::gap::{C, CurveArc, PlacedCurve, Rectangle, Tree, turn};
use crate::gear::Side;
use crate::outline::{HalfOutline, HalfPiece, OutlineGear};

/// Pitches on either side of its even place that a tooth with long rectangles covers: its own width, and less than half a pitch off its place.
const WIDEST: f64 = 1.5;

/// One side of a gear's teeth, in the frame of the side.
#[derive(Debug)]
pub(super) struct SideTeeth<'a> {
    pub gear: &'a OutlineGear,
    side: Side,
    pub displacement: C,
    /// Sign with which tooth numbers increase in this frame.
    ascending: i64,
    /// Rectangles around the pieces of each half tooth.
    boxes: Vec<Tree<Rectangle>>,
    /// Least and greatest angle, rad, of points of a half tooth from its even place, about the axis.
    pub around: [f64; 2],
}

impl<'a> SideTeeth<'a> {
    pub fn new(gear: &'a OutlineGear, side: Side) -> SideTeeth<'a> {
        let mirror = -side.sense();
        let displacement = gear.displacement();
        let displacement = if mirror > 0.0 {
            displacement
        } else {
            displacement.conj()
        };
        let mut slopes = Some([0.0, 0.0]);
        let boxes = (1..=gear.teeth()).map(|tooth| {
            let pieces = gear.half(side, tooth).pieces.iter();
            let round =
                |piece: &HalfPiece| Rectangle::new(&piece.curve, piece.range(), |t| piece.point(t));
            let shapes: Vec<Rectangle> = pieces.map(round).collect();
            let back = turn(-mirror * gear.tooth_angle(f64::from(tooth)));
            for shape in &shapes {
                let those = shape.placed(back * displacement, back).slopes();
                slopes = slopes.zip(those).map(|([least, greatest], those)| {
                    [f64::min(least, those[0]), f64::max(greatest, those[1])]
                });
            }
            Tree::new(&shapes)
        });
        let boxes: Vec<Tree<Rectangle>> = boxes.collect();
        SideTeeth {
            gear,
            side,
            displacement,
            ascending: (mirror * gear.face().ascending()) as i64,
            boxes,
            around: slopes.map_or([-WIDEST, WIDEST].map(|it| it * gear.pitch()), |slopes| {
                slopes.map(f64::atan)
            }),
        }
    }

    pub fn half(&self, tooth: u32) -> &'a HalfOutline {
        self.gear.half(self.side, tooth)
    }

    /// The frame of the gear at rotation 0.
    pub fn still(&self) -> Frame {
        Frame {
            centre: self.displacement,
            direction: C::ONE,
        }
    }

    /// Rectangles around the pieces of a half tooth.
    pub fn boxes(&self, tooth: u32) -> &Tree<Rectangle> {
        &self.boxes[tooth as usize - 1]
    }

    /// The number of the tooth `steps` counter-clockwise of `tooth` in this frame.
    pub fn beside(&self, tooth: u32, steps: i64) -> u32 {
        let index = i64::from(tooth) - 1 + self.ascending * steps;
        index.rem_euclid(i64::from(self.gear.teeth())) as u32 + 1
    }
}

/// A frame of a gear: `centre + direction · P`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub centre: C,
    pub direction: C,
}

impl Frame {
    pub fn placed<'a>(&self, piece: &'a HalfPiece) -> PlacedCurve<'a> {
        PlacedCurve {
            curve: &piece.curve,
            mirrored: piece.mirrored,
            centre: self.centre,
            direction: self.direction * piece.turn,
        }
    }

    pub fn arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> CurveArc<'a> {
        let (low, high) = piece.range();
        CurveArc::new(self.placed(piece), name, low, high)
    }

    /// The arc of the free gear. About the axis an arc has one radius, so only its clockwise end, the one nearer the root, can touch.
    pub fn free_arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> CurveArc<'a> {
        if self.centre == C::ZERO && piece.curve.is_about_the_origin() {
            CurveArc::new(self.placed(piece), name, piece.ends[1], piece.ends[1])
        } else {
            self.arc(piece, name)
        }
    }
}

/// Depth below a radius, as a share of it, that [`nearest`] ignores: 0.0001 µm at 100 mm, a tenth of what results show.
const DEPTH: f64 = 1e-9;

/// Whether a curve comes within `radius`, mm, of the origin between two parameters. A curve deeper by less than twice [`DEPTH`] may
/// count as outside. Otherwise an arc about the origin at just this radius would be halved without end.
///
/// A piece is nowhere nearer than its chord by more than its height above it, which falls with the square of its length.
pub(super) fn nearest(placed: &PlacedCurve, low: f64, high: f64, radius: f64) -> bool {
    let [from, to] = [low, high].map(|t| placed.at(t).point);
    if from.norm().min(to.norm()) < radius * (1.0 - DEPTH) {
        return true;
    }
    let (constant, rising) = placed.curve.bend(high);
    let width = high - low;
    let height = (constant + rising * width) * width * width / 8.0;
    let along = to - from;
    let share = -(from * along.conj()).re / along.norm_sqr();
    let foot = from + along * share.clamp(0.0, 1.0);
    // A chord without length has a share that is no number.
    if !(foot.norm() - height < radius * (1.0 - 2.0 * DEPTH)) {
        return false;
    }
    let middle = 0.5 * (low + high);
    nearest(placed, low, middle, radius) || nearest(placed, middle, high, radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Circle, Cubic, Line, PartCurve};
    use nalgebra::Point2;

    /// Least distances of arcs, a line and a cubic curve in closed form. The search ends at that radius and finds nothing.
    /// It finds the curve at a radius greater by 1e-8 of itself.
    #[test]
    fn a_curve_that_is_equally_near_everywhere_is_not_within() {
        let points = [[-1.0, 2.0], [-0.5, 1.0], [0.5, 1.0], [1.0, 2.0]];
        let cubic = Cubic::new(points.map(Point2::from));
        let line = Line::new(Point2::new(3.0, -2.0), Point2::new(3.0, 5.0));
        let circle = |x: f64, radius| Circle::new(Point2::new(x, 0.0), radius, true);
        for (curve, [low, high], least) in [
            (PartCurve::Circle(circle(0.0, 17.4)), [0.3, 0.9], 17.4),
            (PartCurve::Circle(circle(39.4, 22.0)), [2.5, 3.7], 17.4),
            (PartCurve::Line(line), [0.0, 7.0], 3.0),
            (PartCurve::Cubic(cubic), [0.0, 1.0], 1.25),
        ] {
            let placed = PlacedCurve {
                curve: &curve,
                mirrored: false,
                centre: C::ZERO,
                direction: C::ONE,
            };
            for (off, expected) in [(-1e-8, false), (0.0, false), (1e-8, true)] {
                let found = nearest(&placed, low, high, least * (1.0 + off));
                assert_eq!(found, expected, "{curve:?} {off}");
            }
        }
    }
}
