//! 44 and 44 teeth can be put together in 44 ways. All poses of a curve are of one of them.

use super::two_thick_teeth::two_thick_teeth;
use super::{METHOD, heading};
use gearlash::analysis::curves::{Followed, binding, courses, over_distance, revolution};
use gearlash::analysis::outcome::by_distance;
use gearlash::analysis::study::Study;
use gearlash::gear::{AsBuilt, Face, Side};
use gearlash::pair::{Mating, Pose};
use gearlash_render::chart;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn tick() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn study(keys: &str) -> Study {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pair.toml");
    std::fs::write(&path, two_thick_teeth(44, 3.0, keys)).unwrap();
    gearlash_files::read(&path).unwrap().study
}

/// From a pose to another of the same assembly both gears turn by the same arc, but for backlash: 0.1 mm of it are
/// 1/90 of a pitch. Left-flank poses were those of the next assembly, a whole pitch off.
#[test]
fn left_flank_poses_are_of_the_same_assembly() {
    for (face, locked) in [
        (Face::Back, "wheel"),
        (Face::Back, "pinion"),
        (Face::Front, "wheel"),
        (Face::Front, "pinion"),
    ] {
        let mut study = study(&format!("locked = \"{locked}\"\n"));
        for (_, _, pinion) in &mut study.materials {
            *pinion = AsBuilt::perfect(pinion.gear().clone(), face);
        }
        let runs = revolution(&study, METHOD, &tick).unwrap();
        let assembly = &runs[0].run.assembly;
        let matings = runs[0]
            .poses
            .iter()
            .map(|pose| *pose.simulated.pose.mating());
        let (right, left): (Vec<Mating>, Vec<Mating>) =
            matings.partition(|mating| mating.flank == Side::Right);
        assert_eq!((right.len(), left.len()), (44 * 16, 44 * 16));
        for (right, left) in right.iter().zip(&left) {
            let [one, other] = [right, left].map(|mating| assembly.pose(*mating));
            let turned = |rotation: fn(&Pose) -> f64| rotation(&other) - rotation(&one);
            let pitches =
                (turned(Pose::locked_rotation) + turned(Pose::free_rotation)) / TAU * 44.0;
            let off = pitches - 44.0 * (pitches / 44.0).round();
            assert!(off.abs() < 0.02, "{face:?} {locked} {right:?} {left:?}");
        }
    }
}

/// A full period of right-flank poses of phase 1, 1, by `phases = "all"`, has the same least: 3.65 µm. Phase 1, 2
/// interferes by 26 µm, and the curves of phase 1, 1 said so.
#[test]
fn the_least_of_a_curve_is_that_of_its_assembly() {
    let phases = study("[sweep]\nphases = \"all\"\n");
    let runs = gearlash::analysis::simulate::simulate(&phases, METHOD, &tick).unwrap();
    let least = |phase: (u32, u32)| {
        let mut runs = runs.iter();
        let run = runs.find(|run| run.phase == Some(phase)).unwrap();
        let backlash = run.poses.iter().map(|pose| 1e3 * pose.backlash.unwrap());
        backlash.fold(f64::INFINITY, f64::min)
    };
    let curves = revolution(&study(""), METHOD, &tick).unwrap();
    let course = courses(&curves).remove(0);
    let found = course.least.unwrap().backlash_um;
    assert!(
        found > 3.0 && (found - least((1, 1))).abs() < 1e-3,
        "{found}"
    );
    assert!(least((1, 2)) < -20.0);

    // Over the centre distance, too: no measured mating is near, so the very pose that binds is followed.
    let pair = study("");
    let binding = binding(&pair, curves.iter());
    let all: Vec<_> = curves.iter().collect();
    let ranges = by_distance(&all, &[]);
    let curve = over_distance(&pair, binding, &[], METHOD, &tick).unwrap();
    let range = &ranges[0];
    assert_eq!(ranges.len(), 1);
    let least = range.all.least.unwrap().pose.simulated.backlash.unwrap();
    assert!((1e3 * least - found).abs() < 1e-6);
    let middle = &curve.points[20];
    assert!((middle.center_distance - range.center_distance).abs() < 1e-9);
    let band = middle.bands.simulated.unwrap();
    assert!((band.min_um - found).abs() < 1e-3, "{band:?}");
    let drawn = chart::distance(&heading("a", "thick"), &curve, &ranges).unwrap();
    assert!(drawn.svg.contains("least and greatest of all poses"));
}

/// Values measured at 132.04 … 132.21 mm beside a sweep at 132.04 and 132.1 were drawn on the right edge, at 132.106.
#[test]
fn measured_values_widen_the_axis() {
    let mut study = crate::study("karba_44x44.toml");
    study.center_distances = vec![132.04, 132.1];
    let curve = over_distance(&study, Followed::Teeth(11, 11), &[], METHOD, &tick).unwrap();
    let ends = [curve.points.first(), curve.points.last()].map(|end| end.unwrap().center_distance);
    assert_eq!(curve.measured.len(), 4);
    for row in &curve.measured {
        assert!(
            ends[0] < row.center_distance && row.center_distance < ends[1],
            "{ends:?}"
        );
    }
}
