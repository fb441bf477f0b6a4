//! A pose's result depends on the pose alone: the same bits shuffled, singly, and on any number of threads.

use crate::common;

use common::random_pair::{Case, case, rough_case};
use gearlash::contact::{CutPair, ExactKernel, LostMotion, Method, PoseResult, sweep};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use proptest::prelude::*;
use std::ops::ControlFlow;

const METHODS: [Method; 2] = [Method::Exact { certify: false }, Method::Polygon];

fn swept(
    assembly: &GearPair,
    cut: &CutPair,
    method: Method,
    matings: &[Mating],
    threads: usize,
) -> Vec<PoseResult> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(|| {
        sweep(assembly, cut, method, matings, 0.0, &|| {
            ControlFlow::Continue(())
        })
        .unwrap()
    })
}

/// Every number of a result, bit by bit.
fn bits(found: &LostMotion) -> Vec<u64> {
    let contacts = [found.right, found.left].into_iter().flatten();
    contacts
        .flat_map(|c| {
            let numbers = [
                c.rotation,
                c.error,
                c.wheel.radius,
                c.pinion.radius,
                c.point.x,
                c.point.y,
                c.normal.x,
                c.normal.y,
            ];
            let teeth = [c.wheel.tooth, c.pinion.tooth].map(u64::from);
            numbers.map(f64::to_bits).into_iter().chain(teeth)
        })
        .collect()
}

fn all_bits(poses: &[PoseResult]) -> Vec<Vec<u64>> {
    poses
        .iter()
        .map(|pose| bits(pose.proven().unwrap()))
        .collect()
}

fn matings(case: &Case) -> Vec<Mating> {
    (0..9)
        .map(|k| Mating {
            fraction: case.mating.fraction + f64::from(k) / 9.0,
            ..case.mating
        })
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn a_result_depends_on_its_pose_alone(
        case in prop_oneof![case(), rough_case()],
        order in Just((0..9).collect::<Vec<usize>>()).prop_shuffle(),
    ) {
        let Ok(assembly) = case.try_assemble(1.0) else { return Ok(()) };
        let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m));
        let cut = CutPair::new(wheel, pinion, 1e-3);
        let matings = matings(&case);
        for method in METHODS {
            let expected = all_bits(&swept(&assembly, &cut, method, &matings, 1));
            for threads in [2, 7] {
                let found = swept(&assembly, &cut, method, &matings, threads);
                prop_assert_eq!(&all_bits(&found), &expected);
            }
            let shuffled: Vec<Mating> = order.iter().map(|&k| matings[k]).collect();
            let found = all_bits(&swept(&assembly, &cut, method, &shuffled, 2));
            for (found, &k) in found.iter().zip(&order) {
                prop_assert_eq!(found, &expected[k]);
            }
            for (mating, expected) in matings.iter().zip(&expected) {
                let single = swept(&assembly, &cut, method, &[*mating], 1);
                prop_assert_eq!(&bits(single[0].proven().unwrap()), expected);
            }
        }
    }

    /// A kernel that was moved keeps teeth and envelopes; one made there has its own.
    #[test]
    fn a_kernel_moved_to_another_distance_is_the_one_made_there(
        case in prop_oneof![case(), rough_case()],
    ) {
        let Ok(assembly) = case.try_assemble(1.0) else { return Ok(()) };
        let kernel = ExactKernel::new(&assembly);
        let module = assembly.gear(Member::Wheel).gear().basic_data().module();
        for step in -8..=8 {
            let Ok(there) = assembly.at(assembly.center_distance() + 0.1 * module * f64::from(step)) else { continue };
            let (moved, made) = (kernel.at(&there), ExactKernel::new(&there));
            for mating in matings(&case) {
                let pose = Pose::new(&there, mating);
                match (moved.lost_motion(&pose), made.lost_motion(&pose)) {
                    (Ok(moved), Ok(made)) => prop_assert_eq!(bits(&moved), bits(&made)),
                    (moved, made) => prop_assert_eq!(moved.is_ok(), made.is_ok()),
                }
            }
        }
    }
}
