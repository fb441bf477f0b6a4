//! Conversion of a gear given by data to a drawn outline and to an outline gear.

use super::gear::OutlineGear;
use super::half::{HalfOutline, HalfPiece};
use super::path::PathSegment;
use crate::gear::{AsBuilt, Face, Placed, ProfilePart, Side, smooth};
use nalgebra::{Complex, Point2};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A shorter half root land counts as none, mm: some hundred times the rounding of the largest gears.
const NO_LAND: f64 = 1e-9;

/// Chordal error of the drawn path over the tip radius: a tenth of a line's width in the largest picture.
const CHORD: f64 = 1e-6;

/// The closed outline of `gear` seen on its reference face, mm, counter-clockwise.
///
/// The rotation axis is the origin, and the outline is displaced by the eccentricity. The undisturbed centre line of tooth 1 points
/// up (+y), and teeth count clockwise. Flanks and fillets are chords within `chordal_error` mm (> 0) of their curves; tip and root
/// lands are arcs. Fillets that cross in a narrow space end at the crossing of their chords.
pub fn of_gear(gear: &AsBuilt, chordal_error: f64) -> Vec<PathSegment> {
    placed_outline(gear, FRAC_PI_2, chordal_error)
}

/// [`of_gear`] of the transverse section at `b`, mm along the axis from the measuring plane away from the viewer.
///
/// The outline turns with the helix; the direction of the eccentricity is constant.
pub fn of_section(gear: &AsBuilt, b: f64, chordal_error: f64) -> Vec<PathSegment> {
    let turned = b * gear.gear().basic_data().twist();
    placed_outline(&gear.section_at(b), FRAC_PI_2 + turned, chordal_error)
}

/// The outline with tooth 1 at `tooth_1`, rad, seen from the front, mirrored to show the reference face.
fn placed_outline(gear: &AsBuilt, tooth_1: f64, chordal_error: f64) -> Vec<PathSegment> {
    let placed = Placed::new(gear, Point2::origin(), tooth_1);
    let centre = placed.centre();
    let teeth = 0..i64::from(gear.gear().basic_data().teeth());
    let flanks = |side| -> Vec<Vec<Point2<f64>>> {
        let teeth = teeth.clone().map(|step| gear.counter_clockwise(1, step));
        let flanks = teeth.map(|tooth| placed.flank(side, tooth, chordal_error));
        flanks.collect()
    };
    let (mut rights, mut lefts) = (flanks(Side::Right), flanks(Side::Left));
    // The right flanks in the order of the spaces: each faces the left one of the tooth before.
    rights.rotate_left(1);
    for (left, right) in lefts.iter_mut().zip(&mut rights) {
        end_in_space(left, right, centre);
    }
    let chord = |ends: &[Point2<f64>]| PathSegment::Line([ends[0], ends[1]]);
    let mut outline = Vec::new();
    for (space, (left, right)) in lefts.iter().zip(&rights).enumerate() {
        outline.extend(left.windows(2).map(chord));
        let root = [left[left.len() - 1], right[right.len() - 1]];
        if root[0] != root[1] {
            outline.push(land(centre, root));
        }
        outline.extend(right.windows(2).rev().map(|ends| chord(ends).reversed()));
        let next = &lefts[(space + 1) % lefts.len()];
        outline.push(land(centre, [right[0], next[0]]));
    }
    match gear.face() {
        Face::Front => outline,
        Face::Back => {
            let turned = outline.iter().rev();
            turned.map(|part| part.reversed().mirrored()).collect()
        }
    }
}

/// The outline gear of a gear given by data: its exact curves, every tooth at its measured place.
impl From<&AsBuilt> for OutlineGear {
    fn from(built: &AsBuilt) -> OutlineGear {
        let gear = built.gear();
        let halves = Side::BOTH.map(|side| {
            let half = |tooth: u32| {
                let mirror = -side.sense();
                let turned = built.tooth_angle(f64::from(tooth)) + built.flank_offset(side, tooth);
                let turn = Complex::from_polar(1.0, mirror * turned);
                let profile = built.profile(side, tooth);
                let pieces = |part: ProfilePart| {
                    let (mut from, mut to) = profile.range(part);
                    match part {
                        ProfilePart::Tip => from = built.land_start(side, tooth),
                        ProfilePart::Root => to = built.root_end(side, tooth),
                        _ => (),
                    }
                    let gear_part = profile.part(part);
                    let corners = match part {
                        ProfilePart::Tip => [true; 2],
                        _ => gear_part.corners,
                    };
                    let edges = gear_part.curve.edges();
                    let stretches = smooth(edges, from.min(to), from.max(to));
                    let piece = move |(low, high): (f64, f64)| HalfPiece {
                        curve: gear_part.curve.clone(),
                        ends: if from > to { [high, low] } else { [low, high] },
                        turn,
                        mirrored: false,
                        corners: match edges {
                            [] => corners,
                            _ => [true; 2],
                        },
                    };
                    stretches.map(piece)
                };
                let pieces = ProfilePart::ALL.into_iter().flat_map(pieces);
                HalfOutline {
                    pieces: pieces
                        .filter(|piece| piece.ends[0] != piece.ends[1])
                        .collect(),
                    tip_limit: gear.tip_radius() * (1.0 - f64::EPSILON),
                    root_limit: gear.root_radius() * (1.0 + f64::EPSILON),
                }
            };
            (1..=gear.basic_data().teeth()).map(half).collect()
        });
        let displacement = built.displacement(0.0);
        // Drawn about the axis as the reference face shows it, tooth 1 up.
        let path = of_gear(built, CHORD * gear.tip_radius()).into_iter();
        let path = path.map(|segment| match built.face() {
            Face::Front => segment,
            Face::Back => segment.mirrored(),
        });
        let off = built.displacement(FRAC_PI_2);
        let gear = OutlineGear {
            face: built.face(),
            path: path.map(|segment| segment.moved(-off)).collect(),
            drawn_direction: FRAC_PI_2,
            halves,
            tip_radius: gear.tip_radius(),
            root_radius: gear.root_radius(),
            displacement: Complex::new(displacement.x, displacement.y),
            bound: 0.0,
            classes: Arc::default(),
            drawing: None,
        };
        gear.classified()
    }
}

/// The arc about `centre` from one point to another.
fn land(centre: Point2<f64>, ends: [Point2<f64>; 2]) -> PathSegment {
    let [from, to] = ends.map(|end| end - centre);
    PathSegment::Arc {
        centre,
        radius: from.norm(),
        start: from.y.atan2(from.x),
        sweep: from.perp(&to).atan2(from.dot(&to)),
    }
}

/// Ends both flanks of a space, tip first, in one point of its middle if they leave no root land.
fn end_in_space(left: &mut Vec<Point2<f64>>, right: &mut Vec<Point2<f64>>, centre: Point2<f64>) {
    let middle = ((left[0] - centre) + (right[0] - centre)).normalize();
    let beyond = |point: &Point2<f64>| middle.perp(&(point - centre));
    let before = left.iter().take_while(|point| beyond(point) < -NO_LAND);
    let before = before.count();
    if before == 0 || before == left.len() {
        return;
    }
    let [from, to] = [left[before - 1], left[before]];
    let share = beyond(&from) / (beyond(&from) - beyond(&to));
    let end = from + (to - from) * share.min(1.0);
    for flank in [left, right] {
        flank.truncate(before);
        flank.push(end);
    }
}
