//! Hard cases with a definite answer, each by both methods, and by brute force at several phases. Closed forms are computed in the tests.

use super::*;
use crate::kit;
use crate::methods::{by_brute_force, cut};
use crate::perfect::closed_form;
use crate::posed;
use rayon::prelude::*;

/// The exact result, borne out by its certificate and by the polygon method within both error bounds.
fn by_both(assembly: &GearPair, mating: Mating) -> LostMotion {
    by_both_within(assembly, &cut(assembly), mating, f64::INFINITY)
}

/// [`by_both`], the lost motion of either within `most_um`.
fn by_both_within(assembly: &GearPair, cut: &CutPair, mating: Mating, most_um: f64) -> LostMotion {
    let pose = Pose::new(assembly, mating);
    let exact = ExactKernel::new(assembly).lost_motion(&pose).unwrap();
    let polygon = cut.refined_kernel(assembly).lost_motion(&pose).unwrap();
    let certifier = Certifier::new(cut.kernel(assembly));
    certifier.check(&pose, &exact).unwrap();
    assert_eq!(exact.status(), polygon.status(), "{exact:?} {polygon:?}");
    if exact.status() != Status::Jammed {
        assert_eq!(differ(&exact, &polygon, 0.0), None, "{mating:?}");
    }
    if let Some((one, other)) = exact.angle().zip(polygon.angle()) {
        near(mating, one * um(assembly), other * um(assembly), most_um);
    }
    exact
}

fn holds_by_brute_force(assembly: &GearPair, mating: Mating, found: &LostMotion) {
    let against = by_brute_force(assembly, &Pose::new(assembly, mating), found);
    assert!(against.is_empty(), "{mating:?}: {against:#?}");
}

/// Sixteen poses over a pitch with either gear locked, each third of those with a locked wheel by brute force. Both methods agree within 1e-6 µm
/// (issue 3). None has another status than those `allowed`, and each of them occurs.
fn over_a_pitch(wheel: &Make, pinion: &Make, distance: f64, allowed: &[Status]) -> Vec<LostMotion> {
    let mut results = Vec::new();
    for locked in Member::BOTH {
        let assembly = kit::locked(wheel, pinion, distance, locked);
        let cut = cut(&assembly);
        for k in 0..16 {
            let mating = at_flank(1, 1, Side::BOTH[k % 2], k as f64 / 16.0);
            let found = by_both_within(&assembly, &cut, mating, 1e-6);
            if k % 3 == 0 && locked == Member::Wheel {
                holds_by_brute_force(&assembly, mating, &found);
            }
            results.push(found);
        }
    }
    let met: Vec<Status> = results.iter().map(LostMotion::status).collect();
    assert!(met.iter().all(|one| allowed.contains(one)), "{met:?}");
    assert!(allowed.iter().all(|one| met.contains(one)), "{met:?}");
    results
}

fn contacts(results: &[LostMotion]) -> impl Iterator<Item = Contact> {
    results.iter().flat_map(|r| [r.right, r.left]).flatten()
}

fn touches(contact: &Contact, curve: ProfilePart) -> bool {
    contact.wheel.curve == curve || contact.pinion.curve == curve
}

/// Pairs whose every pose is on the involutes: one tooth difference, two thousand teeth, the least and the greatest modules. Source: the closed form.
#[test]
fn extreme_perfect_gears_have_the_closed_form() {
    for (teeth, module, distance) in [
        ([31, 30], 2.0, 61.05),
        ([2000, 2000], 1.0, 2000.02),
        ([2000, 20], 1.0, 1010.02),
        ([40, 25], 0.05, 32.55 * 0.05),
        ([40, 25], 50.0, 32.55 * 50.0),
    ] {
        let [wheel, pinion] = teeth.map(|teeth| spur(teeth, module));
        let assembly = pair(&wheel, &pinion, distance);
        let results = over_a_pitch(&wheel, &pinion, distance, &[Status::Clear]);
        for result in &results[..16] {
            let j_wt = 1e-3 * result.angle().unwrap() * um(&assembly);
            near((teeth, module), j_wt, closed_form(&assembly), 1e-9);
        }
    }
}

/// Addendum 0.4: the path of contact is shorter than a base pitch, so between two pairs on
/// it a tip corner carries, with more backlash than the closed form.
#[test]
fn contact_ratio_below_one() {
    let [wheel, pinion] = [20, 31].map(|teeth| spur(teeth, 2.0).rack(0.4, 1.25, 0.38));
    let assembly = pair(&wheel, &pinion, 51.2);
    let [one, two] = [wheel.gear(), pinion.gear()];
    let path = one.base_radius() * one.tip_roll() + two.base_radius() * two.tip_roll()
        - 51.2 * assembly.operating_pressure_angle().sin();
    assert!(path < one.basic_data().base_pitch(), "{path}");
    let results = over_a_pitch(&wheel, &pinion, 51.2, &[Status::Clear]);
    assert!(contacts(&results).any(|contact| touches(&contact, ProfilePart::Tip)));
    for result in &results[..16] {
        let j_wt = 1e-3 * result.angle().unwrap() * um(&assembly);
        assert!(j_wt >= closed_form(&assembly) - 1e-9);
    }
}

/// At 96 mm tip circles of 48 mm touch: just below, nothing but tips can touch, and most poses touch nothing. Clearance at the root is 0.75 mm: 1 mm
/// below the nominal distance of 90 mm every tip at the line of centres dives in.
#[test]
fn only_tips_touch_at_either_end() {
    use Status::{Clear, Jammed, NoContact};
    let gear = spur(30, 3.0);
    for (distance, statuses) in [
        (95.97, &[Clear, NoContact][..]),
        (96.001, &[NoContact]),
        (500.0, &[NoContact]),
        (89.0, &[Jammed]),
    ] {
        let results = over_a_pitch(&gear, &gear, distance, statuses);
        if distance > 90.0 {
            let on_tips = |one: Contact| one.wheel.radius > 47.96 && one.pinion.radius > 47.96;
            assert!(contacts(&results).all(on_tips));
        }
    }
}

/// Eccentric by 2.25 mm, a third of the tooth depth, at 134 mm (2 mm beyond the nominal distance). High teeth towards each other dive 4.5 − 2 mm too
/// deep, past the 0.75 mm of tip clearance; away from each other they stand 6.5 mm apart, beyond the 6 mm that tips overlap.
#[test]
fn eccentricity_of_a_third_of_the_tooth_depth() {
    let gear = |high: f64| match high {
        0.0 => spur(44, 3.0),
        _ => spur(44, 3.0).runout(2.25, high),
    };
    for (wheel, pinion, status) in [
        (1.0, 1.0, Status::Jammed),
        (23.0, 23.0, Status::NoContact),
        (12.0, 0.0, Status::Clear),
        (0.0, 12.0, Status::Clear),
        (12.0, 34.0, Status::Clear),
    ] {
        over_a_pitch(&gear(wheel), &gear(pinion), 134.0, &[status]);
    }
}

/// The test rig's pair (Karba et al., Tables 3 and 4) by its spans `W_6` and runouts, mm: `W_k = (k − 1) p_b + s_b`.
fn rig(distance: f64, runouts: [f64; 2]) -> GearPair {
    let gear = |span: f64, runout: f64| {
        let gear = spur(44, 3.0);
        let nominal = gear.gear();
        let base = span - 5.0 * nominal.basic_data().base_pitch();
        let thinner = nominal.base_thickness() - base;
        gear.thinner(thinner).runout(runout / 2.0, 33.0)
    };
    let (wheel, pinion) = (gear(50.561, runouts[0]), gear(50.567, runouts[1]));
    pair(&wheel, &pinion, distance)
}

const RUNOUTS: [f64; 2] = [0.0066, 0.010];

/// At 137.91 mm 8 of 32 poses were reported as out of mesh although the far half of a tip land blocks them; at 23, 23 and 0.625 the fast path saw
/// nothing, and the polygons' steps along the land had no end. Source of the counts: a Python study of solid teeth.
#[test]
fn the_rig_pair_just_before_it_is_out_of_mesh() {
    for (distance, expected_clear) in [(137.89, 26), (137.9, 26), (137.91, 24)] {
        let assembly = rig(distance, RUNOUTS);
        let clear = (0..32u32).into_par_iter().filter(|k| {
            let mating = at(22 + k / 16, 22 + k / 16, f64::from(k % 16) / 16.0);
            let found = by_both(&assembly, mating);
            let kernel = ExactKernel::new(&assembly);
            let search = kernel.lost_motion_by_search(&Pose::new(&assembly, mating));
            assert_eq!(differ(&found, &search.unwrap(), 0.0), None);
            holds_by_brute_force(&assembly, mating, &found);
            found.status() == Status::Clear
        });
        assert_eq!(clear.count(), expected_clear, "{distance}");
    }
}

/// Where the middle of tooth 1's mean land points at the mate.
fn tooth_1_at_mate(assembly: &GearPair) -> f64 {
    let wheel = assembly.gear(Member::Wheel).gear();
    -assembly.operating_half_angle(Member::Wheel) / wheel.basic_data().angular_pitch()
}

/// Just below 138 mm a corner of the free gear meets the locked land where the tip circles cross, `β = acos(a/(2 r_a))` on either side of the line of
/// centres: `τ − 2 ψ_a − 2 β` of the free gear's space remain. The tips do not overlap at 138 mm, so nothing touches.
#[test]
fn tip_circles_that_just_touch() {
    let tip = 69.0;
    let expected = |a: f64, gear: &Gear| {
        let land = gear.half_angle_at_roll(gear.tip_roll());
        // 1 − cos β = 2 sin²(β/2).
        let beta = 2.0 * ((2.0 * tip - a) / (4.0 * tip)).sqrt().asin();
        gear.basic_data().angular_pitch() - 2.0 * land - 2.0 * beta
    };
    let found_at = |assembly: &GearPair| by_both(assembly, at(1, 1, tooth_1_at_mate(assembly)));
    for below in [1e-9, 1e-7, 1e-5, 1e-3] {
        let assembly = rig(138.0 - below, [0.0; 2]);
        let gear = assembly.gear(Member::Pinion).gear();
        near("tip", gear.tip_radius(), tip, 1e-13);
        let found = found_at(&assembly);
        let error = found.error().unwrap();
        let known = expected(138.0 - below, gear);
        near(below, found.angle().unwrap(), known, error);
        // The lever is 69 mm · sin 2β at least: 1e-3 mm at 1e-9, of coordinates good to 1e-12 mm.
        assert!(error < 1e-7, "{error:e}");
    }
    for beyond in [0.0, 1e-9, 1e-7, 1e-3] {
        let found = found_at(&rig(138.0 + beyond, [0.0; 2]));
        assert!(found.right.is_none() && found.left.is_none(), "{beyond}");
    }
}

/// A nanometre either way of a tip on a root decides, wherever the line of centres meets the land: in its middle, or on the half
/// that one side's half tooth does not have; a micrometre for the high tooth of an eccentric gear. Thin teeth keep the flanks out of it.
#[test]
fn a_tip_within_a_nanometre_of_a_root() {
    let thin = spur(30, 3.0).rack(1.0, 1.25, 0.2).thinner(1.5);
    // Shorter teeth: they do not reach the other's root land first.
    let mate = thin.clone().tip_diameter(95.0);
    for (eccentricity, off, beside) in [(0.0, 1e-6, &[-0.01, 0.0, 0.01][..]), (0.3, 1e-3, &[0.0])] {
        let wheel = thin.clone().runout(eccentricity, 1.0);
        // The root follows the generating shift, so it is deeper than nominal.
        let touching = wheel.front().reach() + mate.gear().root_radius();
        for (distance, expected) in [
            (touching - off, Status::Jammed),
            (touching + off, Status::Clear),
        ] {
            let assembly = pair(&wheel, &mate, distance);
            for beside in beside {
                let fraction = tooth_1_at_mate(&assembly) + beside;
                let found = by_both(&assembly, at(1, 1, fraction));
                assert_eq!(found.status(), expected, "{beside}: {found:?}");
            }
        }
    }
}

/// Poses of fixtures/grazing, from earlier campaigns.
#[test]
fn grazing_poses_by_both_methods() {
    for (name, flank, status) in [
        // Coarse polygons passed the left contact by.
        ("passed_by", Side::Left, Status::NoContact),
        // The free land is nearly round about its axis: the search by pieces came to no end.
        ("lands_pass_clear", Side::Left, Status::NoContact),
        // A tip is deeper in a root on the half of its land that the polygons did not have.
        ("far_half_on_root", Side::Right, Status::Jammed),
        // A free tip land touches a root land between its corners.
        ("land_on_land", Side::Left, Status::Interference),
    ] {
        let (assembly, mating) = posed::pose(format!("fixtures/grazing/{name}.toml"), flank);
        let found = by_both(&assembly, mating);
        assert_eq!(found.status(), status, "{name}");
        let touches = [found.right, found.left].map(|contact| contact.is_some());
        match name {
            "passed_by" => assert_eq!(touches, [false, true]),
            "lands_pass_clear" => assert_eq!(touches, [false, false]),
            _ => {}
        }
        holds_by_brute_force(&assembly, mating, &found);
    }
}
