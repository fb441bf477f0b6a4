//! The pairs of fixtures/reference/hard by every method: exact and certified, polygon, both. The right results have other sources
//! (`fixtures/reference/hard/README.md`; brute force is `tests/common/clearance`).

use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::simulate::simulate;
use gearlash::analysis::study::Study;
use gearlash::contact::{Certifier, CutPair, Doubt, Method, MethodAgreement, PoseResult, Status};
use gearlash::pair::{Member, Pose};
use gearlash_files as input;
use std::ops::ControlFlow;
use std::path::Path;

const METHODS: [Method; 3] = [
    Method::Exact { certify: true },
    Method::Polygon,
    Method::Both,
];

/// The study of a file of `fixtures`.
fn study(path: &str) -> Study {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures");
    input::read(&fixtures.join(path)).unwrap().study
}

fn hard(name: &str) -> Study {
    study(&format!("reference/hard/{name}.toml"))
}

/// All poses of a pair by one method. That they come to an end at all was once the question.
fn poses(name: &str, method: Method) -> Vec<PoseResult> {
    let runs = simulate(&hard(name), method, &|| ControlFlow::Continue(())).unwrap();
    let poses = runs.into_iter().flat_map(|run| run.poses);
    poses.map(|pose| pose.simulated).collect()
}

/// Right results of a pair.
#[derive(Clone, Copy)]
enum Want {
    /// `j_wt` of a pose, and its tolerance, µm.
    Um(usize, f64, f64),
    /// `j_wt` of some pose of the exact method, µm.
    SomeUm(f64),
    /// The status of a pose.
    Status(usize, Status),
    /// The status of some pose, and of every pose.
    Some(Status),
    Every(Status),
}

/// Pairs that were wrong, or did not end.
const HARD: [(&str, &[Want]); 20] = {
    use Status::{Clear, Interference, Jammed};
    [
        // Polygon method, clearance of dense points and overlap agree; the exact method said 907.100.
        ("tip_corner_missed_9_7", &[Want::Um(0, 583.373, 1e-3)]),
        // Clearance and overlap agree with the polygon method. Source: brute force.
        (
            "tip_corner_missed_84_16",
            &[
                Want::Um(0, 2436.265549147, 1e-6),
                Want::Um(1, 2497.765989203, 1e-6),
            ],
        ),
        // Exact method, clearance and overlap; 8.2858 µm without part of a tip land.
        ("far_land_5_14", &[Want::Um(0, 4.2056, 1e-4)]),
        // Exact method and clearance; −624.6 µm without part of a tip land.
        ("far_land_5_30", &[Want::Um(0, -644.1, 0.05)]),
        // A space widened by 0.6 mm of pitch deviations had a hole in its middle: overlap of whole teeth says jammed. The poses a
        // pitch on, with the space beside it, are clear.
        (
            "root_gap_20_20",
            &[Want::Status(0, Jammed), Want::Some(Clear)],
        ),
        // Every space of the wheel is 300 µm wider than its nominal width: its polygons had a hole of that width in the middle of each
        // root, and called the pose clear from 0.0033 to 0.0127 rad. There the tip circle is inside the root circle up to 0.038 rad
        // beside the line of centres: a = r_a + r_f − 0.02 mm. Found by fuzzing.
        ("root_hole_20_20", &[Want::Status(0, Jammed)]),
        // The certificate of a jammed pose ran for minutes.
        ("jammed_hangs_15_16", &[Want::Some(Jammed)]),
        // Tips of both gears exactly on the other's root circle: no command ended. The stub pairs likewise, over revolutions.
        ("jammed_hangs_25_36", &[Want::Some(Jammed)]),
        ("stub_bad_13_1", &[Want::Some(Jammed)]),
        ("stub_bad_13_2", &[Want::Some(Jammed)]),
        // Brute force, at wheel 1, pinion 1; the polygon method left out part of a tip land.
        ("stub_bad_4_7", &[Want::SomeUm(652.942149435)]),
        // Brute force, as of all that follow.
        ("stub_c1", &[Want::Um(0, 388.578313674, 1e-6)]),
        // The exact method missed the wheel's tip corner on the pinion's involute.
        ("stub_n1", &[Want::Um(0, 1.437525722, 1e-6)]),
        // Interference, where the exact method said clear.
        ("stub_n10", &[Want::Um(0, -0.223222995, 1e-6)]),
        // Gears of 12 m; the exact method was 8.7 mm off.
        ("stub_n29", &[Want::Um(0, 479.949659, 1e-5)]),
        // The exact value is right to 40 digits; the polygon method's bound was 8.4 and 1.2 times too small.
        ("grazing_bound_a", &[]),
        ("grazing_bound_b", &[]),
        // A wheel of 14 teeth, eccentric by 0.8 mm, reaches over the axis of a pinion of three: its shaft stands there. Turned in, teeth
        // would meet from all sides; exact and polygon method named different ones.
        ("over_the_axis_14_3", &[Want::Every(Jammed)]),
        // A tooth that pitch deviations leave thinner than half its land kept that half, beyond its own far corner: jammed on metal that
        // is not there.
        ("thin_land_3_7", &[Want::Um(1, -53.379403666, 1e-6)]),
        // The search cut a fillet without end: that of a wheel of three teeth, which begins at its parameter 0, where a finer
        // piece always exists. It met an involute of 387 teeth whose finest piece is longer. The polygon method reports a jam.
        (
            "fine_fillet_3_387",
            &[Want::Status(1, Jammed), Want::Status(0, Interference)],
        ),
    ]
};

fn holds(want: Want, poses: &[PoseResult]) -> bool {
    let um = |pose: &PoseResult| pose.backlash.map(|mm| mm * 1e3);
    let near = |pose: &PoseResult, right: f64, within: f64| {
        um(pose).is_some_and(|um| (um - right).abs() <= within)
    };
    match want {
        Want::Um(place, right, within) => near(&poses[place], right, within),
        Want::SomeUm(right) => poses.iter().any(|pose| near(pose, right, 1e-6)),
        Want::Status(place, status) => poses[place].status() == status,
        Want::Some(status) => poses.iter().any(|pose| pose.status() == status),
        Want::Every(status) => poses.iter().all(|pose| pose.status() == status),
    }
}

/// Every pose is proven by every method, with one status and values within both bounds, and certified by polygons whichever
/// method found it.
#[test]
fn hard_pairs_are_right_by_every_method() {
    for (name, wants) in HARD {
        let [exact, polygon, both] = METHODS.map(|method| poses(name, method));
        for (place, pose) in exact.iter().enumerate() {
            let of_all = [pose, &polygon[place], &both[place]];
            let statuses = of_all.map(PoseResult::status);
            assert!(
                statuses[0] != Status::Unproven && statuses == [statuses[0]; 3],
                "{name}, pose {place}: {of_all:?}"
            );
            if let Some((one, other)) = pose.backlash.zip(polygon[place].backlash) {
                let bounds = pose.error_bound.unwrap() + polygon[place].error_bound.unwrap();
                assert!((one - other).abs() <= bounds, "{name}, pose {place}");
            }
        }
        // One rule: what is within both bounds is no disagreement, however large.
        let agreement = MethodAgreement::of(&both);
        assert!(agreement.agrees() && agreement.compared == both.len());
        for (k, want) in wants.iter().enumerate() {
            for poses in [&exact, &polygon, &both] {
                assert!(holds(*want, poses), "{name}, {k}: {poses:?}");
            }
        }
    }
}

/// The certificate confirms the results of the polygon method like those of the exact one.
#[test]
fn polygon_results_are_certified() {
    for name in [
        "tip_corner_missed_9_7",
        "far_land_5_14",
        "root_gap_20_20",
        "jammed_hangs_15_16",
    ] {
        let study = hard(name);
        let (_, wheel, pinion) = &study.materials[0];
        let coarse = CutPair::for_certificates(wheel, pinion);
        let cut = CutPair::new(wheel, pinion, study.chord);
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
    let study = study("grazing/tips_just_meet_5_18.toml");
    let runs = simulate(&study, Method::Both, &|| ControlFlow::Continue(())).unwrap();
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

/// The extremes as `simulate` and `check` ask for them.
fn cycles(path: &str) -> Vec<RunExtremes> {
    let going_on = || ControlFlow::Continue(());
    extremes(&study(path), METHODS[0], &going_on).unwrap().each
}

/// Their extremes took 4 to 25 s. They end by their effort, of which nothing depends on the machine: what is not proven by then says so, and its
/// bracket holds what was found.
#[test]
fn extremes_of_hard_pairs_end_by_their_effort() {
    for (name, status) in [
        ("reference/hard/grazing_bound_a.toml", Status::NoContact),
        ("reference/hard/grazing_bound_b.toml", Status::NoContact),
        (
            "reference/hard/tip_corner_missed_84_16.toml",
            Status::Interference,
        ),
        ("reference/hard/far_land_5_14.toml", Status::Jammed),
        ("grazing/lands_pass_clear.toml", Status::NoContact),
    ] {
        for run in cycles(name) {
            assert_eq!(run.status, status, "{name}");
            assert!(!run.is_proven(), "{name}");
            for extreme in run.least.iter().chain(&run.greatest) {
                let cut_short = [Doubt::Effort, Doubt::Unbounded, Doubt::OffInvolute];
                let doubt = extreme.doubt;
                assert!(
                    doubt.is_none_or(|doubt| cut_short.contains(&doubt)),
                    "{name}: {doubt:?}"
                );
                assert!(
                    (extreme.low..=extreme.high).contains(&extreme.found()),
                    "{name}"
                );
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
