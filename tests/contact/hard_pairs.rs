//! The pairs of fixtures/reference/hard by every method: exact and certified, polygon, both. The right results have other sources
//! (`fixtures/reference/hard/README.md`; brute force is `tests/common/clearance`).

use crate::kit::{rows, study};
use gearlash::analysis::extremes::extremes;
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::Study;
use gearlash::contact::{Certifier, CutPair, Doubt, Method, MethodAgreement, PoseResult, Status};
use gearlash::error::go_on;
use gearlash::pair::{Member, Pose};
use serde::Deserialize;

const METHODS: [Method; 3] = [
    Method::Exact { certify: true },
    Method::Polygon,
    Method::Both,
];

fn hard(name: &str) -> Study {
    study(format!("fixtures/reference/hard/{name}.toml"))
}

/// All poses of a pair by one method. That they come to an end at all was once the question.
fn poses(name: &str, method: Method) -> Vec<PoseResult> {
    let runs = simulate(&hard(name), method, &go_on).unwrap();
    let poses = runs.into_iter().flat_map(|run| run.poses);
    poses.map(|pose| pose.simulated).collect()
}

/// A right result of a pair.
#[derive(Debug, Deserialize)]
struct Want {
    pair: String,
    pose: String,
    want: String,
    within: Option<f64>,
}

impl Want {
    fn holds(&self, poses: &[PoseResult]) -> bool {
        let is_right = |pose: &PoseResult| match self.want.parse::<f64>() {
            Ok(um) => {
                (pose.backlash).is_some_and(|mm| (1e3 * mm - um).abs() <= self.within.unwrap())
            }
            Err(_) => pose.status().name() == self.want,
        };
        match &*self.pose {
            "" => true,
            "some" => poses.iter().any(is_right),
            "every" => poses.iter().all(is_right),
            place => is_right(&poses[place.parse::<usize>().unwrap()]),
        }
    }
}

/// Every method proves every pose, with one status and values within both bounds, and polygons certify it.
#[test]
fn hard_pairs_are_right_by_every_method() {
    let wants: Vec<Want> = rows(include_str!("data/hard_pairs.csv"));
    let pairs: Vec<&[Want]> = wants.chunk_by(|one, next| one.pair == next.pair).collect();
    assert_eq!(pairs.len(), 20);
    for wants in pairs {
        let name = &wants[0].pair;
        let [exact, polygon, both] = METHODS.map(|method| poses(name, method));
        for (place, pose) in exact.iter().enumerate() {
            let of_all = [pose, &polygon[place], &both[place]];
            let status = pose.status();
            assert_ne!(status, Status::Unproven, "{name}, pose {place}: {of_all:?}");
            assert_eq!(
                of_all.map(PoseResult::status),
                [status; 3],
                "{name} {place}"
            );
            if let Some((one, other)) = pose.backlash.zip(polygon[place].backlash) {
                let bounds = pose.error_bound.unwrap() + polygon[place].error_bound.unwrap();
                assert!((one - other).abs() <= bounds, "{name}, pose {place}");
            }
        }
        // One rule: what is within both bounds is no disagreement, however large.
        let agreement = MethodAgreement::of(&both);
        assert!(agreement.agrees() && agreement.compared == both.len());
        for want in wants {
            for poses in [&exact, &polygon, &both] {
                assert!(want.holds(poses), "{want:?}: {poses:?}");
            }
        }
    }
}

/// The certificate confirms the results of the polygon method like those of the exact one.
#[test]
fn polygon_results_are_certified() {
    let names = "tip_corner_missed_9_7 far_land_5_14 root_gap_20_20 jammed_hangs_15_16";
    for name in names.split(' ') {
        let study = hard(name);
        let (_, wheel, pinion) = &study.materials[0];
        let coarse = CutPair::for_certificates(wheel, pinion);
        let cut = CutPair::new(wheel, pinion, study.chordal_error);
        for plan in study.runs().unwrap() {
            let pair = plan.run.assembly.data().unwrap();
            let certifier = Certifier::new(coarse.kernel(pair));
            for mating in &plan.matings {
                let pose = Pose::new(pair, *mating);
                let found = cut.refined_kernel(pair).lost_motion(&pose).unwrap();
                certifier.check(&pose, &found).unwrap();
            }
        }
    }
}

/// Found by fuzzing: tip circles that meet to the last bit of their radii (`a` is 1e-13 mm from `r_a1 + r_a2`). Whether a tip is in
/// reach of the mate's is rounding; the exact method says yes, polygons say no, and neither may pass for proven beside the other.
#[test]
fn tips_that_just_meet_5_18() {
    let study = study("fixtures/grazing/tips_just_meet_5_18.toml");
    let runs = simulate(&study, Method::Both, &go_on).unwrap();
    let pair = runs[0].run.assembly.data().unwrap();
    let tips = Member::BOTH.map(|member| pair.gear(member).gear().tip_radius());
    assert!((pair.center_distance() - tips[0] - tips[1]).abs() < 2e-13);
    let right = &runs[0].poses[0].simulated;
    assert!(right.is_unproven(), "{right:?}");
    let agreement = MethodAgreement::of(runs[0].poses.iter().map(|pose| &pose.simulated));
    assert_eq!((agreement.one_alone, agreement.compared), (1, 1));
    assert!(!agreement.agrees() && agreement.largest == 0.0);
    let left = &runs[0].poses[1].simulated;
    assert_eq!(left.status(), Status::NoContact, "{left:?}");
}

/// Their extremes took 4 to 25 s. They end by their effort, of which nothing depends on the machine: what is not proven by then says so, and its
/// bracket holds what was found.
#[test]
fn extremes_of_hard_pairs_end_by_their_effort() {
    for (name, status) in [
        ("reference/hard/grazing_bound_a", Status::NoContact),
        ("reference/hard/grazing_bound_b", Status::NoContact),
        (
            "reference/hard/tip_corner_missed_84_16",
            Status::Interference,
        ),
        ("reference/hard/far_land_5_14", Status::Jammed),
        ("grazing/lands_pass_clear", Status::NoContact),
    ] {
        let study = study(format!("fixtures/{name}.toml"));
        for run in extremes(&study, METHODS[0], &go_on).unwrap().each {
            assert_eq!(run.status, status, "{name}");
            // Outlines prove the one that neither jams nor leaves mesh.
            assert_eq!(run.is_proven(), status == Status::Interference, "{name}");
            for extreme in run.least.iter().chain(&run.greatest) {
                let cut_short = [Doubt::Effort, Doubt::Unbounded, Doubt::OffInvolute];
                let mut doubts = extreme.doubt.iter();
                assert!(doubts.all(|doubt| cut_short.contains(doubt)), "{name}");
                let bracket = extreme.low..=extreme.high;
                assert!(bracket.contains(&extreme.found()), "{name}");
            }
            let ends = [
                run.meshes_to.map(|to| [to.low, to.high]),
                run.assembles_from.map(|from| [from.low, from.high]),
            ];
            for [low, high] in ends.into_iter().flatten() {
                assert!(low < high && high - low < 0.01, "{name}: {low} … {high}");
            }
        }
    }
}
