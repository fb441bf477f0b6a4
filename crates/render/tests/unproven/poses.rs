//! Which poses are not proven, why, and what is kept of them.

use super::{CERTIFIED, Case, REVOLUTION, unproven};
use gearlash::contact::{
    Method, MethodAgreement, PolygonDifference, PoseResult, Status, sweep, worst_pose,
};
use gearlash::error::Error;
use std::ops::ControlFlow;

/// Whether the two pairs differ at a pose, which the exact method decides.
fn differ(own: &PoseResult, other: &PoseResult) -> bool {
    let [own, other] = [own, other].map(|pose| pose.proven().unwrap());
    [(own.right, other.right), (own.left, other.left)]
        .into_iter()
        .any(|(own, other)| (own.unwrap().rotation - other.unwrap().rotation).abs() > 1e-9)
}

#[test]
fn a_refused_certificate_leaves_its_pose_alone_unproven() {
    let case = Case::low_tips();
    let [own, other] = case.exact();
    let certified = case.swept(CERTIFIED);
    assert_eq!(certified.len(), 160);
    let mut refused = 0;
    for ((pose, own), other) in certified.iter().zip(&own).zip(&other) {
        if differ(own, other) {
            refused += 1;
            let doubt = unproven(pose).unwrap();
            assert!(doubt.reason.starts_with("the certificate failed: on the "));
            assert!(doubt.reason.contains("nothing touches at the rotation"));
            assert_eq!((doubt.exact, doubt.polygon), (own.backlash, None));
            assert_eq!(pose.status(), Status::Unproven);
            assert_eq!((pose.backlash, pose.error_bound), (None, None));
            assert_eq!(pose.range(), [None; 2]);
            assert!(!pose.interferes() && !pose.just_touches());
        } else {
            assert_eq!(pose.found, own.found)
        }
    }
    // Where tooth 5 comes into contact and leaves it, on either side.
    assert_eq!(refused, 4);
}

#[test]
fn two_methods_that_differ_beyond_both_bounds_leave_both_values_in_doubt() {
    let case = Case::low_tips();
    let [own, other] = case.exact();
    for ((pose, own), other) in case.swept(Method::Both).iter().zip(&own).zip(&other) {
        let [exact, polygon] = [own, other].map(|pose| pose.backlash.unwrap());
        let Some(PolygonDifference::Value(difference)) = pose.polygon_difference else {
            panic!("{pose:?}");
        };
        assert!((difference - (polygon - exact)).abs() < 1e-9);
        if differ(own, other) {
            let doubt = unproven(pose).unwrap();
            assert_eq!(doubt.exact, Some(exact));
            assert!((doubt.polygon.unwrap() - polygon).abs() < 1e-9);
            assert!(
                doubt.reason.contains("more than both error bounds"),
                "{doubt:?}"
            );
            assert_eq!(pose.backlash, None);
        } else {
            assert_eq!((pose.proven(), pose.backlash), (own.proven(), own.backlash))
        }
    }
    // The sum of what each pose is judged by: those beyond are the unproven ones.
    let poses = case.swept(Method::Both);
    let agreement = MethodAgreement::of(&poses);
    let doubtful = poses.iter().filter(|pose| pose.found.is_err()).count();
    assert_eq!((agreement.beyond, agreement.one_alone), (doubtful, 0));
    assert_eq!(agreement.compared, poses.len());
    assert!(agreement.largest.is_finite() && !agreement.agrees());
}

/// Teeth that hardly reach each other: 43.5 mm of 44 mm at which the tips pass. With tips of 0.5 mm less on both polygons
/// they have nothing to touch.
#[test]
fn a_value_of_one_method_alone_is_in_doubt() {
    let pair = |tip: f64| {
        format!(
            "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\ntip_diameter_mm = {tip}\n\
             [pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\ntip_diameter_mm = {tip}\n\
             [assembly]\ncenter_distance_mm = 43.5\n[sweep]\nmating = [[1, 1]]\n"
        )
    };
    let case = Case::new(&pair(44.0), &pair(43.0));
    let [own, other] = case.exact();
    for ((pose, own), other) in case.swept(Method::Both).iter().zip(&own).zip(&other) {
        assert_eq!(
            (own.status(), other.status()),
            (Status::Clear, Status::NoContact)
        );
        let doubt = unproven(pose).unwrap();
        assert_eq!((doubt.exact, doubt.polygon), (own.backlash, None));
        let reason =
            "the exact method finds clear, the polygon method no contact. Rely on neither value;";
        assert!(doubt.reason.starts_with(reason), "{}", doubt.reason);
        assert_eq!(pose.polygon_difference, Some(PolygonDifference::OneAlone));
    }
}

#[test]
fn an_end_of_the_bearing_clearance_is_in_doubt_by_itself() {
    let case = Case::of(&format!("bearing_clearance_mm = 0.01\n{REVOLUTION}"));
    let [own, other] = case.exact();
    let certified = case.swept(CERTIFIED);
    let mut refused = [0; 2];
    for ((pose, own), other) in certified.iter().zip(&own).zip(&other) {
        for end in [0, 1] {
            let differs = (own.range()[end].unwrap() - other.range()[end].unwrap()).abs() > 1e-8;
            assert_eq!(pose.is_end_unproven(end), differs);
            assert_eq!(pose.range()[end], own.range()[end].filter(|_| !differs));
            refused[end] += usize::from(differs);
        }
        let doubts = pose.unproven().count();
        let ends = [0, 1]
            .iter()
            .filter(|end| pose.is_end_unproven(**end))
            .count();
        assert_eq!(doubts, ends + usize::from(pose.found.is_err()));
    }
    assert!(refused[0] > 0 && refused[1] > 0);
}

#[test]
fn an_unproven_pose_is_not_the_worst() {
    let case = Case::low_tips();
    let [own, _] = case.exact();
    let certified = case.swept(CERTIFIED);
    let worst = |poses: &[PoseResult]| worst_pose(poses.iter().enumerate()).unwrap();
    // It would be the worst.
    assert!(certified[worst(&own)].found.is_err());
    assert!(certified[worst(&certified)].found.is_ok());
}

#[test]
fn ctrl_c_still_ends_a_sweep() {
    let case = Case::low_tips();
    let (pair, cut, matings) = (
        case.plan.assembly.data().unwrap(),
        &case.cut,
        &case.plan.matings,
    );
    let ended = sweep(pair, cut, CERTIFIED, matings, 0.0, &|| {
        ControlFlow::Break(())
    });
    assert!(matches!(ended, Err(Error::Interrupted)));
}
