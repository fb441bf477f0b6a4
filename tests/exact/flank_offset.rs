//! Drawn gears moved along their normals: what closed forms give for the moved outlines and for their play.

use super::*;
use crate::drawn::{gear, pin};
use crate::outlines::drawn;
use crate::paths::repeated;

/// Round heads with straight sides, moved out by `d`, are those drawn `d` farther out, roots included. Inwards as well.
#[test]
fn a_moved_pin_is_a_greater_pin() {
    let pins = |head, root| gear(&repeated(24, &pin(48.0, head, root)), 0.0);
    let drawn = pins(2.4, 43.0);
    for by in [0.35, 0.1, 0.001, -0.001, -0.2, -0.35] {
        let moved = drawn.with_flank_offset(by).unwrap();
        let expected = pins(2.4 + by, 43.0 + by);
        assert_eq!(moved.flank_offset(), Some(by));
        near(by, moved.tip_radius(), expected.tip_radius(), 1e-9);
        near(by, moved.root_radius(), expected.root_radius(), 1e-9);
        let play = |wheel: &OutlineGear, step: u32| {
            let mate = gear(&repeated(18, &pin(36.0, 2.0, 31.0)), 0.0);
            let pair = OutlinePair::new(wheel.clone(), mate, 84.3, Member::Wheel).unwrap();
            let found = OutlineKernel::new(&pair).lost_motion(&at(1, 1, 0.13 * f64::from(step)));
            found.unwrap().angle().unwrap()
        };
        for step in 0..9 {
            near((by, step), play(&moved, step), play(&expected, step), 1e-9);
        }
        // An offset replaces an earlier one.
        assert_eq!(moved.with_flank_offset(0.0).unwrap(), drawn);
    }
}

/// An involute moved along its normal is an involute of the same base circle, turned. So the play of a drawn pair grows by the sum of its four
/// offsets over `cos α_wt` on the pitch circle, within the error of both drawings; tooth 1 stays tooth 1 on either face.
#[test]
fn involutes_stay_conjugate() {
    const CHORD: f64 = 1e-4;
    let wheel = drawn(&spur(24, 2.0).front(), CHORD).unwrap();
    let pinion = drawn(&spur(31, 2.0).back(), CHORD).unwrap();
    for [one, other] in [[-0.1, -0.1], [-0.15, 0.05], [-0.3, 0.1]] {
        let (wheel, pinion) = (
            wheel.with_flank_offset(one),
            pinion.with_flank_offset(other),
        );
        let pair = OutlinePair::new(wheel.unwrap(), pinion.unwrap(), 55.0, Member::Wheel).unwrap();
        let kernel = OutlineKernel::new(&pair);
        let radius = pair.operating_pitch_radius(Member::Pinion);
        let expected = -2.0 * (one + other) / 20f64.to_radians().cos();
        for step in 0..12 {
            let found = kernel.lost_motion(&at(3, 5, 0.23 * f64::from(step)));
            let found = found.unwrap();
            let error = found.error().unwrap() * radius;
            let play = found.angle().unwrap() * radius;
            near((one, step), play, expected, error);
            assert!(error < 6.0 * CHORD, "{error}");
        }
    }
}

/// Heads of radius 2.4 mm vanish at 2.4 mm inwards. Outwards by `d`, the heads of two neighbours meet on the middle of the space. The radius there
/// is `48 cos(π/24) + √((2.4 + d)² − (48 sin(π/24))²)`. Half the depth of 7.4 mm is left below their tops at `50.4 + d`.
#[test]
fn an_impossible_offset_is_refused_with_the_greatest() {
    let drawn = gear(&repeated(24, &pin(48.0, 2.4, 43.0)), 0.0);
    let greatest = |by: f64| match drawn.with_flank_offset(by) {
        Err(OutlineError::Offset { greatest_mm, .. }) => greatest_mm,
        other => panic!("{by}: {other:?}"),
    };
    let (sin, cos) = (PI / 24.0).sin_cos();
    let (beside, above) = (48.0 * sin, 50.4 - 48.0 * cos - 3.7);
    // (d + above)² = (2.4 + d)² − beside².
    let most = (2.4 * 2.4 - beside * beside - above * above) / (2.0 * above - 4.8);
    for (by, most) in [(6.0, most), (-3.0, 2.4)] {
        let found = greatest(by);
        assert!(found <= most && most - found < 2e-3, "{found} {most}");
        let is_possible = |mm: f64| drawn.with_flank_offset(mm.copysign(by)).is_ok();
        assert!(is_possible(found) && !is_possible(found + 0.002));
    }
    let by_data = OutlineGear::from(&spur(24, 2.0).front());
    assert_eq!(by_data.flank_offset(), None);
}
