//! Contacts off the involutes: their classes, what they cost, and where undercut brings them about.

use super::*;
use CheckVerdict::{Fail, Pass, Warn};

fn kind_of(curves: [&str; 2]) -> ContactKind {
    let has = |curve| curves.contains(&curve);
    match (has("root"), has("fillet"), has("tip")) {
        (true, _, _) => ContactKind::Root,
        (_, true, true) => ContactKind::TipFillet,
        (_, true, false) => ContactKind::Fillet,
        (_, false, true) if curves == ["tip"; 2] => ContactKind::TipTip,
        (_, false, true) => ContactKind::TipInvolute,
        (_, false, false) => ContactKind::Involute,
    }
}

/// Both contacts of the 18 poses fillet_* and the 36 handover_*: the reference's curves. A premature corner's teeth touch on the line of action a
/// little later, a late one's did a little before: model 3 knows, which shares nothing with the classes.
#[test]
fn classes_of_the_reference_poses() {
    let (mut poses, mut fillets, mut premature, mut late) = (0, 0, 0, 0);
    let names = "fillet_1 fillet_2 fillet_3 handover_1 handover_2 handover_3";
    for name in names.split(' ') {
        let pair = reference_pair(name);
        let assembly = &pair.assembly;
        let kernel = ExactKernel::new(assembly);
        for reference in &pair.poses {
            let mating = reference.mating();
            let found = kernel.lost_motion(&Pose::new(assembly, mating)).unwrap();
            let mut gravest = ContactKind::Involute;
            for side in Side::BOTH {
                let contact = found.on(side).unwrap();
                let curves = reference.contact(side).curves();
                let class = ContactClass::of(assembly, side, &contact);
                assert_eq!(class.kind, kind_of(curves), "{name} {mating:?}");
                let tip = match curves {
                    ["tip", "tip"] => None,
                    ["tip", _] => Some(Member::Wheel),
                    [_, "tip"] => Some(Member::Pinion),
                    _ => None,
                };
                assert_eq!(class.tip, tip, "{name}");
                gravest = gravest.max(class.kind);
                fillets += usize::from(class.kind == ContactKind::TipFillet);
                if class.kind != ContactKind::TipInvolute || name.starts_with("fillet") {
                    continue;
                }
                let on_line = |pitches: f64| {
                    let pose = Pose::new(assembly, mating.onward(assembly, pitches));
                    let teeth = (contact.wheel.tooth, contact.pinion.tooth);
                    SideContact::all(assembly, &pose, side)
                        .any(|c| (c.locked_tooth, c.free_tooth) == teeth)
                };
                let (count, expected) = match class.moment.unwrap() {
                    Moment::Premature => (&mut premature, [false, true]),
                    Moment::Late => (&mut late, [true, false]),
                };
                *count += 1;
                let before_and_after = [-0.2, 0.2].map(on_line);
                assert_eq!(before_and_after, expected, "{name} {mating:?} {side:?}");
            }
            let class = PoseClass::of(assembly, &found);
            assert_eq!(class, PoseClass::Contact(gravest));
            poses += 1;
        }
    }
    assert_eq!(poses, 18 + 36);
    assert!(fillets > 0 && premature > 0 && late > 0);
}

/// At 117.4 mm the tip corner of this pair reaches the line of action half a pitch beyond mating 4, 41, and touches on it:
/// model 3 has the same backlash. That costs nothing and is no contact off the line of action.
#[test]
fn a_corner_that_costs_nothing_is_not_off_the_line_of_action() {
    let wheel = spur(17, 2.0).shift(0.5).allowance(-0.03).runout(0.010, 5.5);
    let pinion = spur(100, 2.0)
        .shift(-0.3)
        .allowance(-0.05)
        .runout(0.015, 60.0);
    let pair = GearPair::new(wheel.front(), pinion.front(), 117.4).unwrap();
    let found = diagnosed(&at_mating(&pair, (4, 41), vec![0.5]));
    let classes = &found.contact.classes;
    let corner = PoseClass::Contact(ContactKind::TipInvolute);
    assert_eq!(classes.get(&corner), Some(&1), "{classes:?}");
    let check = check(&found, "off_line_contact", None);
    let said = (check.verdict, check.outlines, &*check.note);
    assert_eq!(said, (Pass, Some(0.0), ""));
}

/// The cost of contact off the line of action is model 3's backlash less the simulation's, for every pose of both materials.
#[test]
fn losses_are_those_of_all_poses() {
    let study = study("fixtures/karba_44x44.toml");
    let runs = compared(&study);
    assert!(runs.len() > 1);
    let poses = runs.iter().flat_map(|run| &run.poses);
    let losses = poses.map(|pose| pose.line_of_action.unwrap() - pose.simulated.backlash.unwrap());
    let losses: Vec<f64> = losses.collect();
    let found = diagnosed(&study);
    let loss = found.contact.loss.as_ref().unwrap();
    let mean = losses.iter().sum::<f64>() / losses.len() as f64;
    assert_eq!(loss.poses, losses.len());
    near("mean", loss.mean, mean, 1e-15);
    let [least, worst] = ends(losses);
    assert_eq!(loss.least, least);
    near("worst", loss.worst.loss, worst, limits::MET_WITHIN);
    let group = found.groups[0].material;
    assert_eq!(group.name(), "most");
    let most = runs.iter().filter(|run| run.run.material == group);
    let poses = most.flat_map(|run| &run.poses);
    let [least, _] = ends(poses.map(|pose| pose.simulated.backlash.unwrap()));
    let condition = check(&found, "backlash_condition", None);
    let [("least_j_wt_um", value)] = condition.details[..] else {
        panic!("{condition:?}")
    };
    near("least j_wt", value, 1e3 * least, 1e-9);
}

/// The case that issue 4 states, digits and all: clearance is exactly the lower limit, K (8) is content, and yet the wheel's tip meets the pinion's
/// fillet, which no formula sees.
#[test]
fn the_fillet_of_86_21_costs_what_no_formula_sees() {
    let phases = Vec::from_iter((0..24).map(|phase| f64::from(phase) / 24.0));
    let pair = |distance| pair(&spur(86, 3.0), &spur(21, 3.0), distance);
    let found = diagnosed(&at_mating(&pair(160.2), (1, 1), phases.clone()));
    let worst = &found.contact.loss.as_ref().unwrap().worst;
    assert_eq!(worst.class, PoseClass::Contact(ContactKind::TipFillet));
    let class = ContactClass::of(&worst.assembly, worst.side, &worst.contact);
    assert_eq!(class.tip, Some(Member::Wheel));
    let (wheel, pinion) = (Some(Member::Wheel), Some(Member::Pinion));
    let form = check(&found, "non_involute_form", pinion);
    for (what, value, stated) in [
        ("formula", (worst.backlash + worst.loss) * 1e3, -216.426),
        ("backlash", worst.backlash * 1e3, -238.948),
        ("loss", worst.loss * 1e3, 22.522),
        ("contact radius", worst.contact.pinion.radius, 28.948),
        ("form radius", form.limit.unwrap(), 29.668),
    ] {
        near(what, value, stated, 5e-4);
    }
    // Where the wheel's tip would end on the line of action.
    assert!(form.formula.unwrap() < 29.668);
    for (id, gear, verdict) in [
        ("radial_clearance", wheel, Warn),
        ("radial_clearance", pinion, Warn),
        ("non_involute_k8", wheel, Pass),
        ("non_involute_k8", pinion, Pass),
        ("non_involute_form", wheel, Pass),
        ("non_involute_form", pinion, Fail),
        ("off_line_contact", None, Fail),
    ] {
        let check = check(&found, id, gear);
        assert_eq!(check.verdict, verdict, "{id} {gear:?}");
        if id == "radial_clearance" {
            near(id, check.margin.unwrap(), 0.0, 1e-9);
        }
    }
    let onset = |found: &Diagnosis| found.groups[0].onset.clone().unwrap().unwrap().distance;
    let near_by = onset(&found);
    assert!(near_by > 160.2 && near_by < 160.3, "{near_by}");

    let farther = diagnosed(&at_mating(&pair(160.3), (1, 1), phases));
    let loss = farther.contact.loss.as_ref().unwrap();
    near("loss at 160.3", loss.worst.loss, 0.0, 1e-9);
    for (id, gear) in [("non_involute_onset", None), ("non_involute_form", pinion)] {
        assert_eq!(check(&farther, id, gear).verdict, Pass, "{id}");
    }
    // The onset does not depend on where the search began.
    near("onset", onset(&farther), near_by, 2e-5);
}

/// Without undercut the margin is `r sin α − (h_f − ρ (1 − sin α) − x) m/sin α`; with it the margin is negative, and the trochoid cuts higher.
/// Source: the rack's round leaves its flank at `h_f − ρ (1 − sin α)` below the pitch line (ISO 53).
#[test]
fn the_margin_to_undercut_is_the_racks() {
    let sin = 20f64.to_radians().sin();
    for (teeth, x) in [(10, 0.0), (12, -0.2), (21, 0.0), (24, 0.3), (60, 0.5)] {
        let distance = 1.5 * f64::from(teeth + 40) + 3.0 * x + 0.5;
        let pair = pair(&spur(teeth, 3.0).shift(x), &spur(40, 3.0), distance);
        let found = diagnosed(&at_one_pose(&pair));
        let undercut = check(&found, "undercut", Some(Member::Wheel));
        let round = 1.25 - 0.38 * (1.0 - sin);
        let expected = 1.5 * f64::from(teeth) * sin - (round - x) * 3.0 / sin;
        near(teeth, undercut.margin.unwrap(), expected, 1e-9);
        let passes = expected > 0.0;
        let verdict = if passes { Pass } else { Warn };
        assert_eq!(undercut.verdict, verdict, "{teeth}");
        if passes {
            near(teeth, undercut.outlines.unwrap(), expected, 1e-9);
        }
    }
}

/// If the edge of an undercut touches at the form circle, in front of the line of action, a pair has less backlash than
/// model 3. Both the check `off_line_contact` and the comparison report it.
#[test]
fn an_undercut_edge_below_the_formula_is_off_the_line() {
    // Every other tooth of the wheel stands 20 µm on: it touches where its neighbour's involutes would.
    let steps = [0.0, 0.02].repeat(5);
    let gear = spur(10, 2.0).allowance(-0.04);
    let pair = pair(&gear.clone().pitch(&steps, &steps), &gear, 20.15);
    let form = gear.gear().form_radius();
    let mut at_edge = 0;
    let runs = compared(&Study::of_pair("undercut", &pair, 12));
    for pose in runs.iter().flat_map(|run| &run.poses) {
        let lower = pose.simulated.backlash.zip(pose.line_of_action);
        let Some((backlash, formula)) = lower.filter(|(found, formula)| formula - found > 1e-3)
        else {
            continue;
        };
        // By hand, from the radii: one of the contacts is at a form circle.
        let found = pose.simulated.proven().unwrap();
        let touched = [found.right.unwrap(), found.left.unwrap()];
        let touched = touched.iter();
        let mut radii = touched.flat_map(|at| [at.wheel.radius, at.pinion.radius]);
        if radii.any(|radius| (radius - form).abs() < 1e-7) {
            at_edge += 1;
            assert_eq!(pose.verdict, PoseVerdict::OffLine, "{backlash} {formula}");
        }
    }
    assert!(at_edge > 5, "{at_edge}");
}
