//! The pairs of fixtures/reference/hard by every method: exact and certified, polygon, both. The right results have other sources; each
//! test names its own (`fixtures/reference/hard/README.md`; brute force is `tests/common/clearance`).

use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::simulate::simulate;
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

/// All poses of a pair by one method. That they come to an end at all was once the question.
fn poses(name: &str, method: Method) -> Vec<PoseResult> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/reference/hard");
    let study = input::read(&folder.join(format!("{name}.toml")))
        .unwrap()
        .study;
    let runs = simulate(&study, method, &|| ControlFlow::Continue(())).unwrap();
    runs.into_iter().flat_map(|run| run.poses).collect()
}

/// Every pose is proven by every method, with one status and values within both bounds, and certified by polygons whichever
/// method found it; the poses listed have these `j_wt`, µm.
fn is(name: &str, want: &[(usize, f64, f64)]) {
    let [exact, polygon, both] = METHODS.map(|method| poses(name, method));
    for (place, pose) in exact.iter().enumerate() {
        let of_all = [pose, &polygon[place], &both[place]];
        let statuses = of_all.map(PoseResult::status);
        assert!(
            statuses[0] != Status::Unproven && statuses == [statuses[0]; 3],
            "{name}, pose {place}: {of_all:?}"
        );
        if let (Some(one), Some(other)) = (pose.backlash, polygon[place].backlash) {
            let bounds = pose.error_bound.unwrap() + polygon[place].error_bound.unwrap();
            assert!((one - other).abs() <= bounds, "{name}, pose {place}");
        }
    }
    // One rule: what is within both bounds is no disagreement, however large.
    let agreement = MethodAgreement::of(&both);
    assert!(agreement.agrees() && agreement.compared == both.len());
    for &(place, want_um, within_um) in want {
        for found in [&exact, &polygon, &both] {
            let j_wt_um = found[place].backlash.unwrap() * 1e3;
            assert!(
                (j_wt_um - want_um).abs() <= within_um,
                "{name}, pose {place}: {j_wt_um} µm"
            );
        }
    }
}

fn is_jammed(name: &str, jammed: impl Fn(&[PoseResult]) -> bool) {
    is(name, &[]);
    for method in METHODS {
        assert!(jammed(&poses(name, method)), "{name} by {method:?}");
    }
}

/// Polygon method, clearance of dense points and overlap agree on 583.373 µm; the exact method said 907.100.
#[test]
fn tip_corner_missed_9_7() {
    is("tip_corner_missed_9_7", &[(0, 583.373, 1e-3)]);
}

/// Clearance and overlap agree with the polygon method; brute force: 2436.265549147 and 2497.765989203 µm.
#[test]
fn tip_corner_missed_84_16() {
    let want = [(0, 2436.265549147, 1e-6), (1, 2497.765989203, 1e-6)];
    is("tip_corner_missed_84_16", &want);
}

/// Exact method, clearance and overlap: 4.2056 µm; 8.2858 µm without part of a tip land.
#[test]
fn far_land_5_14() {
    is("far_land_5_14", &[(0, 4.2056, 1e-4)]);
}

/// Exact method and clearance: −644.1 µm; −624.6 µm without part of a tip land.
#[test]
fn far_land_5_30() {
    is("far_land_5_30", &[(0, -644.1, 0.05)]);
}

/// A space widened by 0.6 mm of pitch deviations had a hole in its middle: overlap of whole teeth says jammed. The poses a
/// pitch on, with the space beside it, are clear.
#[test]
fn root_gap_20_20() {
    is_jammed("root_gap_20_20", |poses| {
        let statuses: Vec<Status> = poses.iter().map(PoseResult::status).collect();
        statuses[0] == Status::Jammed && statuses.contains(&Status::Clear)
    });
}

/// Every space of the wheel is 300 µm wider than its nominal width: its polygons had a hole of that width in the middle of each
/// root, and called the pose clear from 0.0033 to 0.0127 rad. There the tip circle is inside the root circle up to 0.038 rad
/// beside the line of centres: a = r_a + r_f − 0.02 mm. Found by fuzzing.
#[test]
fn root_hole_20_20() {
    is_jammed("root_hole_20_20", |poses| {
        poses[0].status() == Status::Jammed
    });
}

/// The certificate of a jammed pose ran for minutes.
#[test]
fn jammed_hangs_15_16() {
    is_jammed("jammed_hangs_15_16", |poses| {
        poses.iter().any(|pose| pose.status() == Status::Jammed)
    });
}

/// Tips of both gears exactly on the other's root circle: no command ended.
#[test]
fn jammed_hangs_25_36() {
    is_jammed("jammed_hangs_25_36", |poses| {
        poses.iter().any(|pose| pose.status() == Status::Jammed)
    });
}

/// Likewise, over revolutions.
#[test]
fn stub_bad_13() {
    for name in ["stub_bad_13_1", "stub_bad_13_2"] {
        is_jammed(name, |poses| {
            poses.iter().any(|pose| pose.status() == Status::Jammed)
        });
    }
}

/// Brute force: 652.942149435 µm at wheel 1, pinion 1; the polygon method left out part of a tip land.
#[test]
fn stub_bad_4_7() {
    is("stub_bad_4_7", &[]);
    let found = poses("stub_bad_4_7", METHODS[0]);
    let near = |pose: &&PoseResult| {
        pose.backlash
            .is_some_and(|j| (j * 1e3 - 652.942149435).abs() < 1e-6)
    };
    assert!(found.iter().any(|pose| near(&pose)));
}

/// Brute force: 388.578313674 µm.
#[test]
fn stub_c1() {
    is("stub_c1", &[(0, 388.578313674, 1e-6)]);
}

/// Brute force: 1.437525722 µm; the exact method missed the wheel's tip corner on the pinion's involute.
#[test]
fn stub_n1() {
    is("stub_n1", &[(0, 1.437525722, 1e-6)]);
}

/// Brute force: −0.223222995 µm, interference, where the exact method said clear.
#[test]
fn stub_n10() {
    is("stub_n10", &[(0, -0.223222995, 1e-6)]);
}

/// Brute force: 479.949659 µm; the exact method was 8.7 mm off. Gears of 12 m.
#[test]
fn stub_n29() {
    is("stub_n29", &[(0, 479.949659, 1e-5)]);
}

/// The exact value is right to 40 digits; the polygon method's bound was 8.4 and 1.2 times too small.
#[test]
fn grazing_bounds() {
    is("grazing_bound_a", &[]);
    is("grazing_bound_b", &[]);
}

/// The certificate confirms the results of the polygon method like those of the exact one.
#[test]
fn polygon_results_are_certified() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/reference/hard");
    for name in [
        "tip_corner_missed_9_7",
        "far_land_5_14",
        "root_gap_20_20",
        "jammed_hangs_15_16",
    ] {
        let study = input::read(&folder.join(format!("{name}.toml")))
            .unwrap()
            .study;
        let (_, wheel, pinion) = &study.materials[0];
        let coarse = CutPair::for_certificates(wheel, pinion);
        for plan in study.runs().unwrap() {
            let cut = CutPair::new(wheel, pinion, study.chord);
            let kernel = cut.refined_kernel(plan.assembly.data().unwrap());
            let certifier = Certifier::new(coarse.kernel(plan.assembly.data().unwrap()));
            for mating in &plan.matings {
                let pose = Pose::new(plan.assembly.data().unwrap(), *mating);
                certifier
                    .check(&pose, &kernel.lost_motion(&pose).unwrap())
                    .unwrap();
            }
        }
    }
}

/// A wheel of 14 teeth, eccentric by 0.8 mm, reaches over the axis of a pinion of three: its shaft stands there. Turned in, teeth
/// would meet from all sides; exact and polygon method named different ones.
#[test]
fn over_the_axis_14_3() {
    is_jammed("over_the_axis_14_3", |poses| {
        poses.iter().all(|pose| pose.status() == Status::Jammed)
    });
}

/// A tooth that pitch deviations leave thinner than half its land kept that half, beyond its own far corner: jammed on metal that
/// is not there. Brute force: −53.379403666 µm.
#[test]
fn thin_land_3_7() {
    is("thin_land_3_7", &[(1, -53.379403666, 1e-6)]);
}

/// The search cut a fillet without end: that of a wheel of three teeth, which begins at its parameter 0, where a finer
/// piece always exists. It met an involute of 387 teeth whose finest piece is longer. The polygon method reports a jam.
#[test]
fn fine_fillet_3_387() {
    is_jammed("fine_fillet_3_387", |poses| {
        poses[1].status() == Status::Jammed && poses[0].status() == Status::Interference
    });
}

/// Found by fuzzing: tip circles that meet to the last bit of their radii (`a` is 1e-13 mm from `r_a1 + r_a2`). Whether a tip is in
/// reach of the mate's is rounding; the exact method says yes, polygons say no, and neither may pass for proven beside the other.
#[test]
fn tips_that_just_meet_5_18() {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/grazing/tips_just_meet_5_18.toml");
    let study = input::read(&path).unwrap().study;
    let runs = simulate(&study, Method::Both, &|| ControlFlow::Continue(())).unwrap();
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| {
        runs[0]
            .assembly
            .data()
            .unwrap()
            .gear(member)
            .gear()
            .tip_radius()
    });
    assert!((runs[0].assembly.center_distance() - wheel - pinion).abs() < 2e-13);
    let right = &runs[0].poses[0];
    assert!(right.is_unproven(), "{right:?}");
    let agreement = MethodAgreement::of(&runs[0].poses);
    assert_eq!((agreement.one_alone, agreement.compared), (1, 1));
    assert!(!agreement.agrees() && agreement.largest == 0.0);
    let left = &runs[0].poses[1];
    assert_eq!(left.status(), Status::NoContact, "{left:?}");
}

/// The extremes as `simulate` and `check` ask for them.
fn cycles(path: &str) -> Vec<RunExtremes> {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures");
    let study = input::read(&fixtures.join(path)).unwrap().study;
    let method = Method::Exact { certify: true };
    extremes(&study, method, &|| ControlFlow::Continue(()))
        .unwrap()
        .each
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
