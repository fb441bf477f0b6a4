//! Which poses are run, and where they stand.

use super::*;
use gearlash::pair::Pose;
use serde_json::Value;
use std::f64::consts::TAU;

/// The 126 poses of the reference data, in their order, and the wheel's rotation at each (1e-12 rad):
/// it takes teeth, face, thickness and centre distance to get it right.
#[test]
fn matings_of_the_reference_poses() {
    let mut poses = 0;
    for path in fixtures() {
        let Ok(text) = fs::read_to_string(path.with_extension("json")) else {
            continue;
        };
        let reference: Vec<Value> = serde_json::from_str(&text).unwrap();
        let runs = read(&path).unwrap().study.runs().unwrap();
        let ours = runs
            .iter()
            .flat_map(|run| run.matings.iter().map(move |mating| (run, *mating)));
        assert_eq!(ours.clone().count(), reference.len());
        for ((run, mating), reference) in ours.zip(&reference) {
            let distance = run.run.assembly.center_distance();
            assert_eq!(distance, reference["center_distance_mm"]);
            assert_eq!(run.run.material.name(), reference["material"]);
            assert_eq!(mating.wheel_tooth, reference["wheel_tooth"]);
            assert_eq!(mating.pinion_tooth, reference["pinion_tooth"]);
            assert_eq!(mating.flank.name(), reference["flank"]);
            assert_eq!(mating.fraction, reference["fraction"]);
            let rotation = Pose::new(run.run.assembly.data().unwrap(), mating).locked_rotation();
            let expected = reference["wheel_rotation_rad"].as_f64().unwrap();
            let turns = (rotation - expected) / TAU;
            let is_whole = (turns - turns.round()).abs() * TAU < 1e-12;
            assert!(is_whole, "{}", path.display());
            poses += 1;
        }
    }
    assert_eq!(poses, 126);
}
