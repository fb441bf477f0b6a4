//! Outlines through a mesh cycle, against the proven extremes of the same gears.

use super::*;
use gearlash::analysis::outlines::{OutlineRun, OutlineStudy};
use gearlash::analysis::study::Material;
use gearlash::contact::Status;
use gearlash::outline::OutlineGear;

fn run_of(pair: &GearPair) -> OutlineRun {
    let runs = study_of(pair).runs(true, &|| ControlFlow::Continue(()));
    let runs = runs.unwrap();
    runs.into_iter().next().unwrap()
}

fn study_of(pair: &GearPair) -> OutlineStudy {
    let gear = |member| OutlineGear::from(pair.gear(member));
    OutlineStudy {
        title: "outlines".to_owned(),
        materials: vec![(
            Material::AsMeasured,
            gear(Member::Wheel),
            gear(Member::Pinion),
        )],
        locked: pair.locked(),
        center_distances: vec![pair.center_distance()],
        start: Mating::FIRST,
        steps_per_pitch: 8,
        requirements: Vec::new(),
    }
}

/// 51/23 with a hunting cycle of 1173 matings: what is found of sampled poses lies inside what is proven, and no more than a hundredth of a
/// micrometre inside. Source: the proven brackets.
#[test]
fn a_hunting_pair_has_the_extremes_that_are_proven() {
    let file = input::read(&fixture("hunting_51x23.toml")).unwrap();
    let (_, wheel, pinion) = file.study.materials[0].clone();
    let pair = GearPair::new(wheel, pinion, file.study.center_distances[0]).unwrap();
    let proven = extremes_of(&pair);
    let run = run_of(&pair);
    assert_eq!(run.matings, proven.matings);
    let value = |pose: &Option<gearlash::analysis::outlines::OutlinePose>| {
        pose.as_ref().unwrap().j_wt.unwrap().0
    };
    let (least, greatest) = (proven.least.unwrap(), proven.greatest.unwrap());
    let (low, high) = (value(&run.least), value(&run.greatest));
    assert!(
        low > least.low - 1e-10 && low < least.high + 1e-5,
        "{low} {least:?}"
    );
    assert!(
        high < greatest.high + 1e-10 && high > greatest.low - 1e-5,
        "{high}"
    );
    assert_eq!(run.turns(), Some(false));
    let from = run.turns_from.unwrap();
    let known = proven.assembles_from.unwrap();
    assert!((from.high - known.high).abs() < 3e-5, "{from:?} {known:?}");
}

/// A pair too near, and one out of mesh: said so, and from where on it turns.
#[test]
fn what_jams_says_from_where_it_turns() {
    let gear = |face| AsBuilt::perfect(Gear::nominal(design(20, 2.0)).unwrap(), face);
    let at =
        |distance| run_of(&GearPair::new(gear(Face::Front), gear(Face::Back), distance).unwrap());
    let jammed = at(39.0);
    assert_eq!(jammed.turns(), Some(false));
    // Perfect gears without backlash at the sum of their pitch radii.
    let from = jammed.turns_from.unwrap();
    assert!((from.high - 40.0).abs() < 2e-5, "{from:?}");
    let apart = at(44.5);
    assert_eq!((apart.turns(), apart.count(Status::NoContact)), (None, 160));
}

/// Perfect gears: no backlash at the sum of their pitch radii, 40 mm, from whichever side it is looked for; above, j_wt = 2 a (inv α_w − inv α) with
/// cos α_w = 40 cos α / a, at every pose of the map.
#[test]
fn a_pair_that_turns_has_a_zero_backlash_distance_and_a_map() {
    let gear = |face| AsBuilt::perfect(Gear::nominal(design(20, 2.0)).unwrap(), face);
    let angle = 20f64.to_radians();
    let involute = |angle: f64| angle.tan() - angle;
    for distance in [40.001, 40.3, 41.5] {
        let pair = GearPair::new(gear(Face::Front), gear(Face::Back), distance).unwrap();
        let (study, run) = (study_of(&pair), run_of(&pair));
        assert_eq!(run.turns(), Some(true));
        let zero = run.zero_backlash(&study).unwrap().unwrap();
        assert!(
            (zero.high - 40.0).abs() < 2e-5 && zero.low < zero.high,
            "{distance} {zero:?}"
        );
        assert!(zero.rounded() >= zero.high && zero.rounded() < zero.high + 1.1e-4);
        let map = run
            .map(&study, Some(&zero), &|| ControlFlow::Continue(()))
            .unwrap();
        assert_eq!(map.cells.len(), map.distances.len() * map.columns);
        for (a, row) in map.distances.iter().zip(map.cells.chunks(map.columns)) {
            // Below 40 mm tips reach fillets, and above 41 mm corners touch.
            if !(40.0..41.0).contains(a) {
                continue;
            }
            let operating = (40.0 * angle.cos() / a).min(1.0).acos();
            let known = 2.0 * a * (involute(operating) - involute(angle));
            for cell in row {
                let (j_wt, _) = cell.j_wt.unwrap();
                assert!((j_wt - known).abs() < 1e-9, "{a} {j_wt} {known}");
            }
        }
        let names: Vec<&str> = map.limits.iter().map(|limit| limit.name.as_str()).collect();
        assert_eq!(names.len(), 3, "{names:?}");
    }
    // Out of mesh there is none; stopped, there is no map.
    let apart = GearPair::new(gear(Face::Front), gear(Face::Back), 44.5).unwrap();
    let (study, run) = (study_of(&apart), run_of(&apart));
    assert!(run.zero_backlash(&study).unwrap().is_none());
    assert!(run.map(&study, None, &|| ControlFlow::Break(())).is_err());
}
