//! The pairs of fixtures/reference/hard by the polygon method and by the certificate. What is right there was found by others:
//! each test names who (`fixtures/reference/hard/README.md`).

use gearlash::input;
use gearlash::mesh::{Certifier, CutPair, ExactKernel, LostMotion, Status};
use gearlash::pair::{Assembly, Pose};
use std::f64::consts::TAU;
use std::path::Path;
use std::time::{Duration, Instant};

/// A pose of any pair takes less by either (issue 11). On a busy machine the second try counts.
const LONGEST: Duration = Duration::from_millis(100);

/// What was found at one pose.
struct Found {
    polygon: LostMotion,
    exact: LostMotion,
    /// Of the exact result.
    certified: bool,
    /// Of the polygon method's own result.
    own_certified: bool,
    um: f64,
}

impl Found {
    fn j_wt_um(&self) -> f64 {
        self.polygon.angle().unwrap() * self.um
    }

    /// By how much the two methods differ, and what both error bounds allow, µm.
    fn difference(&self) -> (f64, f64) {
        let bound = |found: &LostMotion| found.error().unwrap() * self.um;
        let exact = self.exact.angle().unwrap() * self.um;
        let allowed = bound(&self.polygon) + bound(&self.exact);
        ((self.j_wt_um() - exact).abs(), allowed)
    }
}

/// All poses of a pair.
fn all(name: &str) -> Vec<Found> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/reference/hard");
    let study = input::read(&path.join(format!("{name}.toml"))).unwrap();
    let (_, wheel, pinion) = &study.materials[0];
    let distance = study.center_distances[0];
    let assembly = Assembly::new(wheel.clone(), pinion.clone(), distance, study.locked).unwrap();
    let cut = CutPair::new(wheel, pinion, study.chord);
    let coarse = CutPair::for_certificates(wheel, pinion);
    let exact = ExactKernel::new(&assembly);
    let kernel = cut.refined_kernel(&assembly);
    let certifier = Certifier::new(coarse.kernel(&assembly));
    let matings = study.sweep.as_ref().unwrap().matings(&assembly);
    let at = |mating| {
        let pose = Pose::new(&assembly, mating);
        let found = exact.lost_motion(&pose).unwrap();
        let polygon = in_time(|| kernel.lost_motion(&pose).unwrap());
        let own = certifier.check(&pose, &polygon);
        Found {
            certified: in_time(|| certifier.check(&pose, &found).is_ok()),
            own_certified: own.is_ok(),
            exact: found,
            polygon,
            um: 1e3 * assembly.operating_pitch_radius(assembly.free()),
        }
    };
    matings.into_iter().map(at).collect()
}

fn in_time<T>(work: impl Fn() -> T) -> T {
    for _ in 0..2 {
        let start = Instant::now();
        let done = work();
        if start.elapsed() <= LONGEST {
            return done;
        }
    }
    panic!("a pose took longer than {LONGEST:?}, twice");
}

/// The first pose's `j_wt` as two other referees have it; every pose by both methods alike, and certified.
fn is(name: &str, want_um: f64, within_um: f64) {
    let poses = all(name);
    let off = (poses[0].j_wt_um() - want_um).abs();
    assert!(off <= within_um, "{name}: {} µm", poses[0].j_wt_um());
    for found in poses {
        assert!(found.certified && found.own_certified, "{name}");
        assert_eq!(found.polygon.status(), found.exact.status());
        if found.polygon.angle().is_some() {
            let (off, allowed) = found.difference();
            assert!(off <= allowed, "{name}: {off:e} µm, allowed {allowed:e} µm");
        }
    }
}

/// Exact method, clearance of dense points and overlap: 4.2056 µm; 8.2858 µm without part of a tip land.
#[test]
fn a_tip_land_that_its_middle_does_not_bound() {
    is("far_land_5_14", 4.2056, 1e-4);
}

/// Exact method and clearance of dense points: −644.1 µm; −624.6 µm without part of a tip land.
#[test]
fn a_far_land_of_an_eccentric_gear() {
    is("far_land_5_30", -644.1, 0.05);
}

/// A space widened by 0.6 mm of pitch deviations had a hole in its middle: overlap of whole teeth says jammed.
#[test]
fn a_tip_in_the_middle_of_a_widened_space() {
    let poses = all("root_gap_20_20");
    let jammed = |found: &Found| found.polygon.status() == Status::Jammed;
    assert!(jammed(&poses[0]) && poses[0].own_certified);
}

/// Every space of the wheel is 300 µm wider than its nominal width, none is not: its polygons had a hole of that width in the
/// middle of each root, and called the pose clear from 0.0033 to 0.0127 rad. There tooth 1 stands so many rad beside the line of
/// centres, and the tip circle is inside the root circle up to 0.038 rad beside it: a = r_a + r_f − 0.02 mm. The exact method says
/// jammed. Found by fuzzing.
#[test]
fn a_tip_in_a_gear_whose_spaces_are_all_widened() {
    let poses = all("root_hole_20_20");
    assert_eq!(poses[0].polygon.status(), Status::Jammed);
    for found in poses {
        assert_eq!(found.polygon.status(), found.exact.status());
        assert!(found.certified && found.own_certified);
        for (one, other) in [
            (found.exact.right, found.polygon.right),
            (found.exact.left, found.polygon.left),
        ] {
            let (one, other) = (one.unwrap(), other.unwrap());
            let turn = one.rotation - other.rotation;
            let apart = (turn - TAU * (turn / TAU).round()).abs();
            assert!(apart <= one.error + other.error, "{apart:e} rad");
        }
    }
}

/// Tips of both gears on the other's root circle, and lands on lands: jammed, and in no time.
#[test]
fn jammed_poses_come_to_an_end() {
    for name in [
        "jammed_hangs_15_16",
        "jammed_hangs_25_36",
        "stub_bad_13_1",
        "stub_bad_13_2",
    ] {
        let poses = all(name);
        assert!(
            poses
                .iter()
                .any(|found| found.polygon.status() == Status::Jammed)
        );
        for found in poses {
            assert_eq!(found.polygon.status(), found.exact.status(), "{name}");
            assert!(found.own_certified, "{name}");
        }
    }
}

/// The exact value is right to 40 digits. Its bound alone does not allow what the polygons are off by.
#[test]
fn the_error_bound_holds_where_tips_graze() {
    for name in ["grazing_bound_a", "grazing_bound_b"] {
        for found in all(name) {
            assert_eq!(found.polygon.status(), found.exact.status());
            if found.polygon.angle().is_some() {
                let (off, allowed) = found.difference();
                assert!(off <= allowed, "{name}: {off:e} µm, allowed {allowed:e} µm");
            }
        }
    }
}

/// Polygon method, clearance and overlap agree on 583.373 µm.
#[test]
fn a_tip_corner_on_the_other_gears_involute() {
    let poses = all("tip_corner_missed_9_7");
    assert!(
        (poses[0].j_wt_um() - 583.373).abs() < 1e-3,
        "{}",
        poses[0].j_wt_um()
    );
    assert!(poses.iter().all(|found| found.own_certified));
}
