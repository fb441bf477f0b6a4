//! The 126 reference poses.

use crate::reference;
use gearlash::contact::{Contact, ExactKernel};
use gearlash::gear::Side;
use gearlash::pair::{Member, Pose};
use serde_json::Value;

/// Source: fixtures/reference/lost_motion, an independent slow program, right to 1e-9 µm.
#[test]
fn all_126_poses_to_a_picometre() {
    let (mut poses, mut worst) = (0, 0.0f64);
    for (assembly, cases) in reference::pairs() {
        let kernel = ExactKernel::new(&assembly);
        let pitch_radius_um = 1000.0 * assembly.operating_pitch_radius(Member::Pinion);
        for case in cases {
            let pose = Pose::new(&assembly, case.mating);
            let found = kernel.lost_motion(&pose).expect("a result");
            let j_wt = found.angle().expect("an angle") * pitch_radius_um;
            let off = (j_wt - case.j_wt_um).abs();
            assert!(off <= 1e-6, "{}: off by {off:e} µm", case.name);
            let bound = found.error().expect("a bound") * pitch_radius_um;
            assert!(bound <= 1e-6, "{}: bound {bound:e} µm", case.name);
            // The reference itself is right to 1e-9 µm.
            assert!(
                off <= bound + 1e-9,
                "{}: {off:e} above {bound:e}",
                case.name
            );
            check_contact(&found.right.unwrap(), &case.result, Side::Right, &case.name);
            check_contact(&found.left.unwrap(), &case.result, Side::Left, &case.name);
            worst = worst.max(off);
            poses += 1;
        }
    }
    println!("worst of {poses} poses: {worst:e} µm");
    assert_eq!(poses, 126);
}

/// Teeth, curves and radii, unless the pair is one of several that tie (perfect gears: the
/// reference names whichever its rounding prefers).
fn check_contact(contact: &Contact, result: &Value, side: Side, name: &str) {
    let expected = &result[side.name()];
    let tied = name.starts_with("clear") || name.starts_with("interfering");
    if tied {
        return;
    }
    for (touch, gear) in [(contact.wheel, "wheel"), (contact.pinion, "pinion")] {
        let tooth = expected[format!("{gear}_tooth")].as_u64().unwrap();
        assert_eq!(u64::from(touch.tooth), tooth, "{name} {side:?} {gear}");
        let curve = expected[format!("{gear}_curve")].as_str().unwrap();
        assert_eq!(touch.curve.name(), curve, "{name} {side:?} {gear}");
        let radius = expected[format!("{gear}_radius_mm")].as_f64().unwrap();
        let off = (touch.radius - radius).abs();
        assert!(
            off <= 1e-5,
            "{name} {side:?} {gear}: radius off by {off:e} mm"
        );
    }
}
