//! The polygon method against the slow program's 126 poses (`fixtures/reference/lost_motion`, right to 1e-9 µm).

use crate::common;

use common::{ReferenceContact, ReferencePose, reference_names, reference_pair};
use gearlash::contact::{Certifier, Contact, CutPair, LostMotion, Status};
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose};

/// µm of `j_wt` a radian of the free gear.
fn um(assembly: &GearPair) -> f64 {
    assembly.operating_pitch_radius(assembly.free()) * 1e3
}

fn cut(assembly: &GearPair, chord_um: f64) -> CutPair {
    CutPair::new(
        assembly.gear(Member::Wheel),
        assembly.gear(Member::Pinion),
        chord_um * 1e-3,
    )
}

/// Every reference pose at this chord: (name, pose, reference, found, j_wt in µm, bound in µm).
fn all(
    chord_um: f64,
    mut check: impl FnMut(&str, &GearPair, &ReferencePose, &LostMotion, f64, f64),
) {
    for name in reference_names() {
        let pair = reference_pair(&name);
        let cut = cut(&pair.assembly, chord_um);
        let kernel = cut.kernel(&pair.assembly);
        let scale = um(&pair.assembly);
        for reference in &pair.poses {
            let found = kernel
                .lost_motion(&Pose::new(&pair.assembly, reference.mating()))
                .unwrap();
            let (j_wt, bound) = (
                found.angle().unwrap() * scale,
                found.error().unwrap() * scale,
            );
            check(&name, &pair.assembly, reference, &found, j_wt, bound);
        }
    }
}

#[test]
fn all_126_poses_within_the_error_bound() {
    let mut poses = 0;
    all(0.01, |name, assembly, reference, found, j_wt, bound| {
        poses += 1;
        let pose = Pose::new(assembly, reference.mating());
        assert!((pose.locked_rotation() - reference.wheel_rotation_rad).abs() < 1e-12);
        let error = (j_wt - reference.j_wt_um).abs();
        assert!(error <= bound, "{name}: {error} µm, bound {bound} µm");
        assert!(
            bound <= 0.1,
            "{name}: bound {bound} µm at the default chord"
        );
        for (side, contact) in [(Side::Right, &found.right), (Side::Left, &found.left)] {
            same_contact(name, reference.contact(side), contact.as_ref().unwrap());
        }
    });
    assert_eq!(poses, 126);
}

/// The named teeth are the reference's. Perfect gears tie, and ties may be named either way: their
/// kinds (clear, interfering) are exempt unless the contact is the pose's own.
fn same_contact(name: &str, expected: &ReferenceContact, contact: &Contact) {
    let teeth = (contact.wheel.tooth, contact.pinion.tooth);
    let expected_teeth = (expected.wheel_tooth, expected.pinion_tooth);
    let perfect = name.starts_with("clear") || name.starts_with("interfering");
    if perfect && teeth != expected_teeth {
        return;
    }
    assert_eq!(teeth, expected_teeth, "{name}");
    // A contact radius is known to the length of a chord or two; involute chords of 0.01 µm here
    // span up to 0.12 mm.
    let near = |found: f64, expected: f64| (found - expected).abs() < 0.12;
    assert!(
        near(contact.wheel.radius, expected.wheel_radius_mm),
        "{name}"
    );
    assert!(
        near(contact.pinion.radius, expected.pinion_radius_mm),
        "{name}"
    );
    assert!((contact.normal.norm() - 1.0).abs() < 1e-12);
}

/// Issue 3: exact and polygon method within 1e-6 µm of all 126 poses.
#[test]
fn refined_polygons_are_right_to_a_picometre() {
    let (mut worst, mut widest) = (0.0f64, 0.0f64);
    for name in reference_names() {
        let pair = reference_pair(&name);
        let cut = cut(&pair.assembly, 0.1);
        let kernel = cut.refined_kernel(&pair.assembly);
        for reference in &pair.poses {
            let found = kernel
                .lost_motion(&Pose::new(&pair.assembly, reference.mating()))
                .unwrap();
            let scale = um(&pair.assembly);
            let error = (found.angle().unwrap() * scale - reference.j_wt_um).abs();
            let bound = found.error().unwrap() * scale;
            assert!(
                error <= 1e-6 && bound <= 1e-6,
                "{name}: {error} µm, bound {bound} µm"
            );
            // The reference is right to 1e-9 µm itself.
            assert!(
                error <= bound + 1e-9,
                "{name}: {error} µm, bound {bound} µm"
            );
            worst = worst.max(error);
            widest = widest.max(bound);
            for side in Side::BOTH {
                let contact = if side == Side::Right {
                    found.right
                } else {
                    found.left
                };
                same_contact(&name, reference.contact(side), &contact.unwrap());
            }
        }
    }
    println!("greatest error {worst:.2e} µm, greatest bound {widest:.2e} µm");
}

/// The error falls as the chordal error does: `chord_um` 1 → 0.01, mean over the 126 poses.
/// Run with `--nocapture` for the table.
#[test]
fn the_error_falls_in_proportion_to_the_chord() {
    let mut means = Vec::new();
    println!("chord_um   mean error µm   greatest error µm   greatest bound µm");
    for chord_um in [1.0, 0.3, 0.1, 0.03, 0.01] {
        let (mut sum, mut count, mut worst, mut widest) = (0.0, 0.0, 0.0f64, 0.0f64);
        all(chord_um, |name, _, reference, _, j_wt, bound| {
            let error = (j_wt - reference.j_wt_um).abs();
            assert!(error <= bound, "{name} at {chord_um}: {error} > {bound}");
            sum += error;
            count += 1.0;
            worst = worst.max(error);
            widest = widest.max(bound);
        });
        println!(
            "{chord_um:8}   {:13.5}   {worst:17.5}   {widest:17.5}",
            sum / count
        );
        means.push((chord_um, sum / count));
    }
    for pair in means.windows(2) {
        let ((coarse, coarse_error), (fine, fine_error)) = (pair[0], pair[1]);
        let order = (coarse_error / fine_error).ln() / f64::ln(coarse / fine);
        assert!(
            (0.8..1.2).contains(&order),
            "from {coarse} to {fine}: order {order}"
        );
    }
}

/// The certificate holds for right answers and fails for wrong ones: 1e-5 µm too open, too closed.
#[test]
fn the_certificate_tells_right_from_wrong() {
    let mut spent = std::time::Duration::ZERO;
    let mut poses = 0;
    for name in reference_names() {
        let pair = reference_pair(&name);
        let cut = cut(&pair.assembly, 1.0);
        let kernel = cut.refined_kernel(&pair.assembly);
        let certifier = Certifier::new(cut.kernel(&pair.assembly));
        for reference in &pair.poses {
            let pose = Pose::new(&pair.assembly, reference.mating());
            let found = kernel.lost_motion(&pose).unwrap();
            let start = std::time::Instant::now();
            certifier
                .check(&pose, &found)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
            spent += start.elapsed();
            poses += 1;
            for sense in [-1.0, 1.0] {
                let mut wrong = found;
                if let Some(right) = &mut wrong.right {
                    right.rotation += sense * 1e-5 / um(&pair.assembly);
                }
                assert!(certifier.check(&pose, &wrong).is_err(), "{name}");
            }
        }
    }
    println!("{:?} a certificate", spent / poses);
}

/// A tip land on the end of a root land, z 9/78 (pose 41 of the first campaign's seed 1). The root land's
/// end was taken for a smooth place whose normal passes through the axis: its bracket reached half a turn, and
/// cutting all that is within half a turn again never ended.
#[test]
fn a_tip_land_on_the_end_of_a_root_land_ends() {
    let gear = |teeth, shift, face| {
        let design = GearDesign {
            basic_data: BasicGearData::new(teeth, 3.0, 15.4f64.to_radians()).unwrap(),
            profile_shift: shift,
            rack: BasicRack::new(0.89, 1.17, 0.045).unwrap(),
            tip_diameter: None,
        };
        AsBuilt::perfect(Gear::nominal(design).unwrap(), face)
    };
    let (wheel, pinion) = (gear(9, 0.12, Face::Front), gear(78, 0.56, Face::Back));
    let deep = wheel.gear().root_radius() + pinion.gear().tip_radius() - 0.5;
    let assembly = GearPair::with_locked(wheel, pinion, deep, Member::Pinion).unwrap();
    let cut = cut(&assembly, 0.3);
    for k in 0..32 {
        let mating = Mating {
            wheel_tooth: 1,
            pinion_tooth: 1,
            flank: Side::Left,
            fraction: f64::from(k) / 32.0,
        };
        let pose = Pose::new(&assembly, mating);
        let found = cut.refined_kernel(&assembly).lost_motion(&pose).unwrap();
        assert_eq!(found.status(), Status::Jammed);
    }
}
