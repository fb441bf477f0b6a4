//! The class of each contact.

use super::*;
use gearlash::analysis::diagnosis::ContactCount;

fn kind_of(contact: &ReferenceContact) -> ContactKind {
    let curves = [contact.wheel_curve.as_str(), contact.pinion_curve.as_str()];
    let has = |curve| curves.contains(&curve);
    match (has("root"), has("fillet"), has("tip")) {
        (true, _, _) => ContactKind::Root,
        (_, true, true) => ContactKind::TipFillet,
        (_, true, false) => ContactKind::Fillet,
        (_, false, true) if curves == ["tip", "tip"] => ContactKind::TipTip,
        (_, false, true) => ContactKind::TipInvolute,
        (_, false, false) => ContactKind::Involute,
    }
}

/// Both contacts of the 18 poses fillet_* and the 36 handover_*: the reference's curves.
#[test]
fn classes_of_the_reference_poses() {
    let (mut poses, mut corners, mut fillets) = (0, 0, 0);
    for name in ["fillet", "handover"]
        .iter()
        .flat_map(|kind| (1..=3).map(move |n| format!("{kind}_{n}")))
    {
        let pair = reference_pair(&name);
        let assembly = &pair.assembly;
        let kernel = ExactKernel::new(assembly);
        for reference in &pair.poses {
            let pose = Pose::new(assembly, reference.mating());
            let found = kernel.lost_motion(&pose).unwrap();
            let mut gravest = ContactKind::Involute;
            for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
                let expected = reference.contact(side);
                let class = ContactClass::of(assembly, side, &contact.unwrap());
                assert_eq!(class.kind, kind_of(expected), "{name} {pose:?}");
                let tip = match (&*expected.wheel_curve, &*expected.pinion_curve) {
                    ("tip", "tip") => None,
                    ("tip", _) => Some(Member::Wheel),
                    (_, "tip") => Some(Member::Pinion),
                    _ => None,
                };
                assert_eq!(class.tip, tip, "{name}");
                gravest = gravest.max(class.kind);
                corners += usize::from(class.kind == ContactKind::TipInvolute);
                fillets += usize::from(class.kind == ContactKind::TipFillet);
            }
            let class = PoseClass::of(assembly, &found);
            assert_eq!(class, PoseClass::Contact(gravest));
            poses += 1;
        }
    }
    assert_eq!(poses, 18 + 36);
    println!("{corners} corner and {fillets} fillet contacts");
    assert!(corners > 0 && fillets > 0);
}

/// A premature corner's teeth touch on the line of action a little later, a late one's did a little before:
/// model 3 knows, which shares nothing with the classes.
#[test]
fn a_corner_is_premature_before_its_teeth_reach_the_line_of_action() {
    let (mut premature, mut late) = (0, 0);
    for name in ["handover_1", "handover_2", "handover_3"] {
        let pair = reference_pair(name);
        let assembly = &pair.assembly;
        let kernel = ExactKernel::new(assembly);
        for reference in &pair.poses {
            let mating = reference.mating();
            let found = kernel.lost_motion(&Pose::new(assembly, mating)).unwrap();
            for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
                let contact = contact.unwrap();
                let class = ContactClass::of(assembly, side, &contact);
                if class.kind != ContactKind::TipInvolute {
                    continue;
                }
                let on_line = |pitches: f64| {
                    let pose = Pose::new(assembly, mating.onward(assembly, pitches));
                    SideContact::all(assembly, &pose, side).any(|c| {
                        c.locked_tooth == contact.wheel.tooth
                            && c.free_tooth == contact.pinion.tooth
                    })
                };
                let (before, after) = (on_line(-0.2), on_line(0.2));
                match class.moment.unwrap() {
                    Moment::Premature => {
                        assert!(after && !before, "{name} {mating:?} {side:?}");
                        premature += 1;
                    }
                    Moment::Late => {
                        assert!(before && !after, "{name} {mating:?} {side:?}");
                        late += 1;
                    }
                }
            }
        }
    }
    println!("{premature} premature, {late} late");
    assert!(premature > 0 && late > 0);
}

/// At 117.4 mm the tip corner of this pair reaches the line of action half a pitch beyond mating 4, 41, and touches on it:
/// model 3 has the same backlash. That costs nothing and is no contact off the line of action.
#[test]
fn a_corner_that_costs_nothing_is_not_off_the_line_of_action() {
    let (_folder, file) = written(&eccentric_17_100(
        "[assembly]\ncenter_distance_mm = 117.4\n[sweep]\nmating = [[4, 41]]\nfraction = [0.5]\n",
    ));
    let study = input::read(&file).unwrap().study;
    let found = diagnosed(&study);
    let corner = PoseClass::Contact(ContactKind::TipInvolute);
    assert_eq!(
        found.contact.classes.get(&corner),
        Some(&1),
        "{:?}",
        found.contact.classes
    );
    let check = check(&found, "off_line_contact", None);
    assert_eq!(
        (check.verdict, check.outlines),
        (Verdict::Pass, Some(0.0)),
        "{check:?}"
    );
    assert_eq!(check.note, "");
}

/// The cost of contact off the line of action is model 3's backlash less the simulation's, for every pose of both materials.
#[test]
fn losses_are_those_of_all_poses() {
    let study = input::read(&fixture("karba_44x44.toml")).unwrap().study;
    let exact = Method::Exact { certify: true };
    let runs = simulate(&study, exact, &|| ControlFlow::Continue(())).unwrap();
    let runs = compare(runs, study.tolerance_um);
    assert!(runs.len() > 1);
    let poses = || runs.iter().flat_map(|run| &run.poses);
    let losses: Vec<f64> = poses()
        .map(|pose| pose.line_of_action.unwrap() - pose.simulated.backlash.unwrap())
        .collect();
    let found = diagnosed(&study);
    let loss = found.contact.loss.as_ref().unwrap();
    let mean = losses.iter().sum::<f64>() / losses.len() as f64;
    assert_eq!(loss.poses, losses.len());
    assert!((loss.mean - mean).abs() < 1e-15, "{} {mean}", loss.mean);
    let least = losses.iter().copied().fold(f64::INFINITY, f64::min);
    assert_eq!(loss.least, least);
    let worst = losses.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!((loss.worst.loss - worst).abs() <= limits::MET_WITHIN);
    let condition = check(&found, "backlash_condition", None);
    let group = found.groups[0].material;
    let backlash = runs.iter().filter(|run| run.run.material == group);
    let backlash = backlash
        .flat_map(|run| &run.poses)
        .map(|pose| pose.simulated.backlash.unwrap());
    let least = backlash.fold(f64::INFINITY, f64::min);
    let [(name, value)] = condition.details[..] else {
        panic!("{condition:?}")
    };
    assert_eq!(name, "least_j_wt_um");
    assert!((value - 1e3 * least).abs() < 1e-9, "{value}, {least} mm");
}

/// Poses of a class, of several, and of all, counted by hand.
#[test]
fn poses_of_classes_are_added_up() {
    let involute = PoseClass::Contact(ContactKind::Involute);
    let classes = [
        (involute, 5),
        (PoseClass::Jammed, 3),
        (PoseClass::NoContact, 2),
    ];
    let count = ContactCount {
        classes: classes.into(),
        ..ContactCount::default()
    };
    assert_eq!(count.of_class(|class| class == PoseClass::Jammed), 3);
    assert_eq!(count.of_class(|class| class != involute), 5);
    assert_eq!(count.of_class(|class| class == PoseClass::Unproven), 0);
    assert_eq!(count.poses(), 10);
}
