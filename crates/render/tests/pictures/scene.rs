//! The scene in mm: outlines, contacts, lines and overlaps where closed forms and counting say they are.

use super::design::design;
use super::drawn::ends;
use super::posed::{Posed, find, j_bn, pair};
use gearlash::contact::{FreePlacement, LostMotion};
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, Placed, Side};
use gearlash::pair::Member;
use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;

/// Distance of `point` from the closed polygon.
fn distance(polygon: &[Point2<f64>], point: Point2<f64>) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon
        .iter()
        .zip(next)
        .map(|(a, b)| {
            let (along, to) = (b - a, point - a);
            let t = (to.dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            (to - t * along).norm()
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn the_points_of_a_contact_lie_on_both_outlines() {
    let chord = 1e-5;
    for locked in [Member::Wheel, Member::Pinion] {
        for (flank, fraction) in [(Side::Right, 0.0), (Side::Left, 0.2), (Side::Right, -0.3)] {
            let pair = pair([25, 38], 2.0, 63.07, locked);
            let posed = Posed::new(pair, [7, 30], flank, fraction);
            let scene = posed.scene();
            assert_eq!(scene.free_placement(), FreePlacement::AtContact(flank));
            for meeting in scene.contacts() {
                let points = [meeting.on_locked, meeting.on_free];
                for (member, point) in [locked, locked.mate()].into_iter().zip(points) {
                    let placed = scene.placed(member);
                    let outline = placed.outline_near(meeting.on_locked, 5.0, chord);
                    // Only contacts on the real flanks say something.
                    let off = distance(&outline, point);
                    assert!(off <= 2.0 * chord, "{locked:?} {meeting:?} {off}");
                }
                let is_open = meeting.side != flank;
                let expected = if is_open { j_bn(&posed.pair) } else { 0.0 };
                assert!((meeting.gap - expected).abs() < 1e-12, "{meeting:?}");
            }
        }
    }
}

#[test]
fn contacts_lie_on_their_line_of_action_between_the_tip_circles() {
    let pair = pair([25, 38], 2.0, 63.07, Member::Wheel);
    let posed = Posed::new(pair, [7, 30], Side::Right, 0.2);
    let scene = posed.scene();
    let LostMotion { right, left, .. } = posed.found;
    for (side, contact) in [(Side::Right, right), (Side::Left, left)] {
        let action = scene.line_of_action(side).unwrap();
        let [from, to] = action.path.unwrap();
        let point = contact.unwrap().point;
        let along = (to - from).normalize();
        assert!((point - from).perp(&along).abs() < 1e-12);
        assert!((0.0..=(to - from).norm()).contains(&(point - from).dot(&along)));
        // Each end of the path is on a tip circle, each end of the line on a base circle.
        let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| posed.pair.gear(m).gear());
        let axis = posed.pair.axis(Member::Pinion);
        for (radius, expected) in [
            ((from - axis).norm(), pinion.tip_radius()),
            (to.coords.norm(), wheel.tip_radius()),
            (action.ends[0].coords.norm(), wheel.base_radius()),
        ] {
            assert!((radius - expected).abs() < 1e-12);
        }
    }
}

/// The rim of a gear between its tip and root circles: every vertex there, and no tooth twice.
#[test]
fn an_outline_keeps_its_deviations_and_its_eccentricity() {
    let gear = Gear::nominal(design(20, 3.0)).unwrap();
    let mut per_tooth = vec![0.0; 20];
    per_tooth[4] = 0.3;
    let deviations = Deviations {
        per_tooth,
        eccentricity: 0.2,
        high_tooth: 6.0,
        ..Deviations::default()
    };
    let as_built = AsBuilt::new(gear, Face::Back, &deviations).unwrap();
    let axis = Point2::new(10.0, -4.0);
    let placed = Placed::new(&as_built, axis, 0.4);
    // Numbers ascend counter-clockwise on a back face: tooth 6 stands a quarter turn from tooth 1.
    let high = 0.4 + PI / 2.0;
    let centre = axis + 0.2 * Vector2::new(high.cos(), high.sin());
    assert!((placed.centre() - centre).norm() < 1e-12);
    assert_eq!(placed.teeth_near(centre, 1.0).len(), 20);

    // Tooth 5 is 0.3 mm thicker on the reference circle than π m/2.
    let direction = placed.direction(5);
    let place = centre + 30.0 * Vector2::new(direction.cos(), direction.sin());
    let chord = 1e-6;
    let outline = placed.outline_near(place, 3.0, chord);
    let half = (PI * 3.0 / 2.0 + 0.3) / 60.0;
    for side in Side::BOTH {
        let angle = direction + side.sense() * half;
        let flank = centre + 30.0 * Vector2::new(angle.cos(), angle.sin());
        assert!(distance(&outline, flank) <= 2.0 * chord, "{side:?}");
    }
    let rim = outline.iter().map(|point| (point - centre).norm());
    let off_rim = rim.filter(|r| !(26.25 - 1e-9..=33.0 + 1e-9).contains(r));
    assert_eq!(off_rim.count(), 1, "the centre closes the polygon");
}

/// Whether the closed polygon holds the point: crossings of a ray, an odd number inside.
fn holds(polygon: &[Point2<f64>], at: Point2<f64>) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(p, q)| {
        (p.y > at.y) != (q.y > at.y) && at.x < p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x)
    });
    crossed.count() % 2 == 1
}

/// The area of the overlap against grid points counted in both outlines and near the contact.
#[test]
fn an_overlap_has_the_area_that_counting_finds() {
    for name in ["44/44 tight", "tip on fillet", "deviated tight"] {
        let posed = find(name);
        let scene = posed.scene();
        let mut meetings = scene.contacts().iter();
        let meeting = meetings.find(|meeting| meeting.gap < 0.0).unwrap();
        let overlap = scene.overlap(meeting).unwrap();
        let [[left, right], [bottom, top]] =
            [0, 1].map(|axis| ends(overlap.outline.iter().map(|p| p[axis])));
        let metal = [Member::Wheel, Member::Pinion].map(|member| {
            let placed = scene.placed(member);
            placed.outline_near(meeting.on_locked, 8.0, 1e-4)
        });
        let cells = 300;
        let (dx, dy) = ((right - left) / cells as f64, (top - bottom) / cells as f64);
        let mut both = 0;
        for i in 0..cells {
            for j in 0..cells {
                let at = Point2::new(left + (i as f64 + 0.5) * dx, bottom + (j as f64 + 0.5) * dy);
                both += usize::from(metal.iter().all(|polygon| holds(polygon, at)));
            }
        }
        let counted = both as f64 * dx * dy;
        // A strip some 30 cells wide or more: a cell's half at each edge, and it averages out.
        let off = (overlap.area / counted - 1.0).abs();
        assert!(off < 0.01, "{name}: {} {counted}", overlap.area);
    }
}

/// Two flanks with radii of curvature `ρ` that overlap by a much smaller depth `δ` share `4/3 δ √(2 δ/κ)`, `κ = 1/ρ_1 + 1/ρ_2`:
/// the length over which two parabolas overlap, times two thirds of the depth. Involutes have `ρ = √(r² − r_b²)`.
#[test]
fn overlaps_of_a_tenth_of_a_micrometre_and_of_a_tenth_of_a_millimetre_have_their_areas() {
    for (module, below) in [(3.0, 1e-4), (3.0, 1e-3), (20.0, 0.2)] {
        let pair = pair([44, 44], module, 44.0 * module - below, Member::Wheel);
        let posed = Posed::new(pair, [1, 1], Side::Right, 0.1);
        let scene = posed.scene();
        let mut seen = 0;
        for meeting in scene.contacts().iter().filter(|one| one.gap < 0.0) {
            let depth = -meeting.gap;
            let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| {
                let radius = meeting.contact.touch(member).radius;
                let base = posed.pair.gear(member).gear().base_radius();
                (radius * radius - base * base).sqrt()
            });
            let bend = 1.0 / wheel + 1.0 / pinion;
            let area = 4.0 / 3.0 * depth * (2.0 * depth / bend).sqrt();
            let found = scene.overlap(meeting).unwrap().area;
            assert!((found / area - 1.0).abs() < 0.005, "{found} {area}");
            seen += 1;
        }
        assert!(seen > 0);
    }
}
