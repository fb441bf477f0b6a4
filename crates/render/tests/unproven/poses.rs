//! Which poses are not proven, why, and what is kept of them.

use super::{CERTIFIED, Case, LOW_TIPS, REVOLUTION, unproven};
use gearlash::contact::{
    Method, MethodAgreement, PolygonDifference, PoseResult, Status, sweep, worst_pose,
};
use gearlash::error::Error;
use std::ops::ControlFlow;

/// Whether the two pairs differ at a pose, which the exact method decides.
fn differ(own: &PoseResult, other: &PoseResult) -> bool {
    let [own, other] = [own, other].map(|pose| pose.proven().unwrap());
    let sides = [(own.right, other.right), (own.left, other.left)];
    sides.into_iter().any(|(own, other)| {
        let turn = own.unwrap().rotation - other.unwrap().rotation;
        turn.abs() > 1e-9
    })
}

/// Nor is it the worst, which it would be.
#[test]
fn a_refused_certificate_leaves_its_pose_alone_unproven() {
    let (mut certified, mut exact) = (Vec::new(), Vec::new());
    let mut refused = 0;
    for [pose, own, other] in LOW_TIPS.beside_exact(CERTIFIED) {
        if differ(&own, &other) {
            refused += 1;
            let doubt = unproven(&pose).unwrap();
            assert!(doubt.reason.starts_with("the certificate failed: on the "));
            assert!(doubt.reason.contains("nothing touches at the rotation"));
            assert_eq!((doubt.exact, doubt.polygon), (own.backlash, None));
            assert_eq!(pose.status(), Status::Unproven);
            assert_eq!((pose.backlash, pose.error_bound), (None, None));
            assert_eq!(pose.range(), [None; 2]);
            assert!(!pose.interferes() && !pose.just_touches());
        } else {
            assert_eq!(pose.found, own.found);
        }
        certified.push(pose);
        exact.push(own);
    }
    // Where tooth 5 comes into contact and leaves it, on either side.
    assert_eq!((certified.len(), refused), (160, 4));
    let worst = |poses: &[PoseResult]| worst_pose(poses.iter().enumerate()).unwrap();
    assert!(certified[worst(&exact)].found.is_err());
    assert!(certified[worst(&certified)].found.is_ok());
}

#[test]
fn two_methods_that_differ_beyond_both_bounds_leave_both_values_in_doubt() {
    let mut poses = Vec::new();
    for [pose, own, other] in LOW_TIPS.beside_exact(Method::Both) {
        let [exact, polygon] = [&own, &other].map(|pose| pose.backlash.unwrap());
        let Some(PolygonDifference::Value(difference)) = pose.polygon_difference else {
            panic!("{pose:?}");
        };
        assert!((difference - (polygon - exact)).abs() < 1e-9);
        if differ(&own, &other) {
            let doubt = unproven(&pose).unwrap();
            assert_eq!(doubt.exact, Some(exact));
            assert!((doubt.polygon.unwrap() - polygon).abs() < 1e-9);
            let reason = &doubt.reason;
            assert!(reason.contains("more than both error bounds"), "{reason}");
            assert_eq!(pose.backlash, None);
        } else {
            assert_eq!((pose.proven(), pose.backlash), (own.proven(), own.backlash));
        }
        poses.push(pose);
    }
    // The sum of what each pose is judged by: those beyond are the unproven ones.
    let agreement = MethodAgreement::of(&poses);
    let doubtful = poses.iter().filter(|pose| pose.found.is_err()).count();
    assert_eq!((agreement.beyond, agreement.one_alone), (doubtful, 0));
    assert_eq!(agreement.compared, poses.len());
    assert!(agreement.largest.is_finite() && !agreement.agrees());
}

#[test]
fn a_value_of_one_method_alone_is_in_doubt() {
    let case = Case::far("[sweep]\nmating = [[1, 1]]\n");
    for [pose, own, other] in case.beside_exact(Method::Both) {
        let statuses = [own.status(), other.status()];
        assert_eq!(statuses, [Status::Clear, Status::NoContact]);
        let doubt = unproven(&pose).unwrap();
        assert_eq!((doubt.exact, doubt.polygon), (own.backlash, None));
        let reason =
            "the exact method finds clear, the polygon method no contact. Rely on neither value;";
        assert!(doubt.reason.starts_with(reason), "{}", doubt.reason);
        assert_eq!(pose.polygon_difference, Some(PolygonDifference::OneAlone));
    }
}

#[test]
fn an_end_of_the_bearing_clearance_is_in_doubt_by_itself() {
    let case = Case::low_tips(&format!("bearing_clearance_mm = 0.01\n{REVOLUTION}"));
    let mut refused = [0; 2];
    for [pose, own, other] in case.beside_exact(CERTIFIED) {
        let mut doubts = usize::from(pose.found.is_err());
        for end in [0, 1] {
            let differs = (own.range()[end].unwrap() - other.range()[end].unwrap()).abs() > 1e-8;
            assert_eq!(pose.is_end_unproven(end), differs);
            assert_eq!(pose.range()[end], own.range()[end].filter(|_| !differs));
            refused[end] += usize::from(differs);
            doubts += usize::from(differs);
        }
        assert_eq!(pose.unproven().count(), doubts);
    }
    assert!(refused[0] > 0 && refused[1] > 0);
}

#[test]
fn ctrl_c_still_ends_a_sweep() {
    let pair = LOW_TIPS.plan.run.assembly.data().unwrap();
    let matings = &LOW_TIPS.plan.matings;
    let off = |_| ControlFlow::Break(());
    let ended = sweep(pair, &LOW_TIPS.cut, CERTIFIED, matings, 0.0, &off);
    assert!(matches!(ended, Err(Error::Interrupted)));
}
