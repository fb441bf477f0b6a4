//! Outlines through a mesh cycle, against the proven extremes of the same gears.

use super::*;
use gearlash::analysis::outlines::{OutlineRun, OutlineStudy};
use gearlash::analysis::study::Material;
use gearlash::contact::Status;
use gearlash::outline::OutlineGear;

fn run_of(pair: &GearPair) -> OutlineRun {
    let gear = |member| OutlineGear::from(pair.gear(member));
    let study = OutlineStudy {
        title: "outlines".to_owned(),
        materials: vec![(
            Material::AsMeasured,
            gear(Member::Wheel),
            gear(Member::Pinion),
        )],
        locked: pair.locked(),
        center_distances: vec![pair.center_distance()],
        start: FIRST,
        steps_per_pitch: 8,
        requirements: Vec::new(),
    };
    let runs = study.runs(&|| ControlFlow::Continue(())).unwrap();
    runs.into_iter().next().unwrap()
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
