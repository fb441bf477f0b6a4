//! Every method against the slow program's 126 poses (`fixtures/reference/lost_motion`, right to 1e-9 µm).

use crate::common::{
    ReferenceContact, ReferencePair, ReferencePose, reference_names, reference_pair,
};
use crate::kit::{at_flank, locked, near, spur_of_angle, um};
use gearlash::contact::{Contact, CutPair, ExactKernel, Status};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member, Pose};

fn cut(assembly: &GearPair, chord_um: f64) -> CutPair {
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear(member));
    CutPair::new(wheel, pinion, chord_um * 1e-3)
}

/// All poses, each with its pair and name.
fn for_all(mut check: impl FnMut(&str, &ReferencePair, &ReferencePose, &Pose)) {
    let mut poses = 0;
    for name in reference_names() {
        let pair = reference_pair(&name);
        for reference in &pair.poses {
            let pose = Pose::new(&pair.assembly, reference.mating());
            assert!((pose.locked_rotation() - reference.wheel_rotation_rad).abs() < 1e-12);
            check(&name, &pair, reference, &pose);
            poses += 1;
        }
    }
    assert_eq!(poses, 126);
}

/// The named teeth are the reference's, and the radii within `off` mm. Perfect gears tie, and ties may be named either way: their
/// kinds (clear, interfering) are exempt unless the contact is the pose's own.
fn same_contact(name: &str, expected: &ReferenceContact, contact: &Contact, off: f64) {
    let teeth = (contact.wheel.tooth, contact.pinion.tooth);
    let perfect = name.starts_with("clear") || name.starts_with("interfering");
    if perfect && teeth != expected.teeth() {
        return;
    }
    assert_eq!(teeth, expected.teeth(), "{name}");
    near(name, contact.wheel.radius, expected.wheel_radius_mm, off);
    near(name, contact.pinion.radius, expected.pinion_radius_mm, off);
    assert!((contact.normal.norm() - 1.0).abs() < 1e-12);
}

/// Exact method and refined polygons, which are within 1e-6 µm (issue 3), and within their own bounds; the exact method names curves, too.
#[test]
fn all_126_poses_to_a_picometre() {
    for_all(|name, pair, reference, pose| {
        let assembly = &pair.assembly;
        let exact = ExactKernel::new(assembly).lost_motion(pose).unwrap();
        let polygons = cut(assembly, 0.1);
        let polygon = polygons.refined_kernel(assembly).lost_motion(pose).unwrap();
        // A polygon's contact radius is known to the length of a chord or two; involute chords of 0.01 µm here
        // span up to 0.12 mm.
        for (found, radius_off) in [(exact, 1e-5), (polygon, 0.12)] {
            let bound = found.error().unwrap() * um(assembly);
            assert!(bound <= 1e-6, "{name}: {bound} µm");
            // The reference is right to 1e-9 µm itself.
            let within = f64::min(1e-6, bound + 1e-9);
            let angle = found.angle().unwrap();
            near(name, angle * um(assembly), reference.j_wt_um, within);
            for side in Side::BOTH {
                let contact = found.on(side).unwrap();
                same_contact(name, reference.contact(side), &contact, radius_off);
            }
        }
        for side in Side::BOTH {
            let (expected, contact) = (reference.contact(side), exact.on(side).unwrap());
            if contact.wheel.tooth == expected.wheel_tooth {
                let curves = [contact.wheel, contact.pinion].map(|touch| touch.curve.name());
                assert_eq!(curves, expected.curves(), "{name}");
            }
        }
    });
}

/// Polygons of one chord are right within their bound, which is 0.1 µm at the most at the default chord. The error falls as the chordal error does:
/// `chord_um` 1 → 0.01, mean over the 126 poses.
#[test]
fn the_error_falls_in_proportion_to_the_chord() {
    let mut means = Vec::new();
    for chord_um in [1.0, 0.3, 0.1, 0.03, 0.01] {
        let (mut sum, mut widest) = (0.0, 0.0f64);
        for name in reference_names() {
            let pair = reference_pair(&name);
            let (assembly, cut) = (&pair.assembly, cut(&pair.assembly, chord_um));
            let kernel = cut.kernel(assembly);
            for reference in &pair.poses {
                let found = kernel.lost_motion(&Pose::new(assembly, reference.mating()));
                let found = found.unwrap();
                let error = (found.angle().unwrap() * um(assembly) - reference.j_wt_um).abs();
                let bound = found.error().unwrap() * um(assembly);
                assert!(error <= bound, "{name} at {chord_um}: {error} > {bound}");
                sum += error;
                widest = widest.max(bound);
            }
        }
        assert!(chord_um > 0.01 || widest <= 0.1, "bound {widest} µm");
        means.push((chord_um, sum / 126.0));
    }
    for pair in means.windows(2) {
        let ((coarse, coarse_error), (fine, fine_error)) = (pair[0], pair[1]);
        let order = f64::ln(coarse_error / fine_error) / f64::ln(coarse / fine);
        assert!((0.8..1.2).contains(&order), "{coarse} to {fine}: {order}");
    }
}

/// A tip land on the end of a root land, z 9/78 (pose 41 of the first campaign's seed 1). The root land's
/// end was taken for a smooth place whose normal passes through the axis: its bracket reached half a turn, and
/// cutting all that is within half a turn again never ended.
#[test]
fn a_tip_land_on_the_end_of_a_root_land_ends() {
    let gear = |teeth, shift| {
        let gear = spur_of_angle(teeth, 3.0, 15.4).shift(shift);
        gear.rack(0.89, 1.17, 0.045)
    };
    let (wheel, pinion) = (gear(9, 0.12), gear(78, 0.56));
    let deep = wheel.gear().root_radius() + pinion.gear().tip_radius() - 0.5;
    let assembly = locked(&wheel, &pinion, deep, Member::Pinion);
    let cut = cut(&assembly, 0.3);
    for k in 0..32 {
        let mating = at_flank(1, 1, Side::Left, f64::from(k) / 32.0);
        let pose = Pose::new(&assembly, mating);
        let found = cut.refined_kernel(&assembly).lost_motion(&pose).unwrap();
        assert_eq!(found.status(), Status::Jammed);
    }
}
