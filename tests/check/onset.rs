//! Contact off the involutes: what it costs and where it begins.

use super::*;

/// The case that issue 4 states, digits and all.
#[test]
fn the_fillet_of_86_21_costs_what_no_formula_sees() {
    let (_folder, file) = written(&pair_86_21(160.2));
    let found = diagnosed(&input::read(&file).unwrap().study);
    let worst = &found.contact.loss.as_ref().unwrap().worst;
    let close = |found: f64, stated: f64| {
        assert!((found - stated).abs() <= 5e-4, "{found} {stated}");
    };
    close((worst.backlash + worst.loss) * 1e3, -216.426);
    close(worst.backlash * 1e3, -238.948);
    close(worst.loss * 1e3, 22.522);
    assert_eq!(worst.class, PoseClass::Contact(ContactKind::TipFillet));
    let class = ContactClass::of(&worst.assembly, worst.side, &worst.contact);
    assert_eq!(class.tip, Some(Member::Wheel));
    close(worst.contact.pinion.radius, 28.948);
    close(
        check(&found, "non_involute_form", Some(Member::Pinion))
            .limit
            .unwrap(),
        29.668,
    );

    // Clearance is exactly the lower limit, K (8) is content, and yet.
    for member in [Member::Wheel, Member::Pinion] {
        let clearance = check(&found, "radial_clearance", Some(member));
        assert_eq!(clearance.verdict, Verdict::Warn);
        assert!(clearance.margin.unwrap().abs() <= 1e-9);
        let k_8 = check(&found, "non_involute_k8", Some(member));
        assert_eq!(k_8.verdict, Verdict::Pass);
    }
    let form = |member| check(&found, "non_involute_form", Some(member)).verdict;
    assert_eq!(form(Member::Wheel), Verdict::Pass);
    assert_eq!(form(Member::Pinion), Verdict::Fail);
    assert_eq!(
        check(&found, "off_line_contact", None).verdict,
        Verdict::Fail
    );
    let onset = found.groups[0].onset.clone().unwrap().unwrap();
    assert!(
        onset.distance > 160.2 && onset.distance < 160.3,
        "{onset:?}"
    );

    let (_folder, file) = written(&pair_86_21(160.3));
    let farther = diagnosed(&input::read(&file).unwrap().study);
    let loss = farther.contact.loss.as_ref().unwrap();
    assert!(loss.worst.loss.abs() <= 1e-9, "{}", loss.worst.loss);
    assert_eq!(
        check(&farther, "non_involute_onset", None).verdict,
        Verdict::Pass
    );
    // The onset does not depend on where the search began.
    let again = farther.groups[0].onset.clone().unwrap().unwrap().distance;
    assert!((again - onset.distance).abs() <= 2e-5, "{again} {onset:?}");
}

/// The onset against poses it never saw: 960 phases of a pitch.
#[test]
fn below_the_onset_something_is_touched_above_it_nothing() {
    let (_folder, file) = written(&pair_86_21(160.2));
    let study = input::read(&file).unwrap().study;
    let run = &study.runs().unwrap()[0];
    let onset = non_involute_onset(run.assembly.data().unwrap(), &run.matings)
        .unwrap()
        .unwrap();
    assert!(onset.bracket[1] - onset.bracket[0] <= 1e-6);
    let touched = |distance: f64| {
        let assembly = run.assembly.at(distance).unwrap();
        let kernel = ExactKernel::new(assembly.data().unwrap());
        (0..960)
            .filter(|phase| {
                let mating = mating(1, 1).onward(&assembly, f64::from(*phase) / 960.0);
                let found = kernel
                    .lost_motion(&Pose::new(assembly.data().unwrap(), mating))
                    .unwrap();
                PoseClass::of(assembly.data().unwrap(), &found).is_non_involute()
            })
            .count()
    };
    // 960 phases miss the first one by up to half a step, which turns a tip's path by micrometres at most.
    assert!(touched(onset.distance - 1e-3) > 0);
    assert_eq!(touched(onset.bracket[1] + 1e-6), 0);
}
