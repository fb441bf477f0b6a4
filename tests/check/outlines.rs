//! Outlines through a mesh cycle, against the proven extremes of the same gears.

use super::*;
use gearlash::analysis::backlash_map::BacklashMap;
use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::verdict::Requirement;
use gearlash::analysis::{Analysis, Plan};
use gearlash::contact::{Method, Status};
use gearlash::outline::OutlineGear;
use gearlash::pair::SweepPlan;

pub(super) fn extremes_of_outlines(study: &Study) -> RunExtremes {
    let on = || ControlFlow::Continue(());
    let found = extremes(study, Method::Exact { certify: true }, &on).unwrap();
    found.each.into_iter().next().unwrap()
}

pub(super) fn study_of(pair: &GearPair) -> Study {
    let gear = |member| OutlineGear::from(pair.gear(member));
    Study::of_drawn(
        "outlines",
        vec![(
            Material::AsMeasured,
            gear(Member::Wheel),
            gear(Member::Pinion),
        )],
        pair.locked(),
        vec![pair.center_distance()],
        SweepPlan::hunting_cycle(pair, 8, (1, 1)),
    )
}

/// 51/23 with a hunting cycle of 1173 matings: both brackets hold the same extremes. Source: the exact method's.
#[test]
fn a_hunting_pair_has_the_extremes_that_are_proven() {
    let file = input::read(&fixture("hunting_51x23.toml")).unwrap();
    let (_, wheel, pinion) = file.study.materials[0].clone();
    let pair = GearPair::new(wheel, pinion, file.study.center_distances[0]).unwrap();
    let proven = extremes_of(&pair);
    let run = extremes_of_outlines(&study_of(&pair));
    assert_eq!(run.matings, proven.matings);
    let (least, greatest) = (proven.least.unwrap(), proven.greatest.unwrap());
    for (known, end) in [(&least, &run.least), (&greatest, &run.greatest)] {
        let end = end.as_ref().unwrap();
        assert!(end.is_proven(), "{end:?}");
        // Rounding of two methods.
        assert!(known.low <= end.high + 1e-10 && end.low <= known.high + 1e-10);
        assert!((known.low - end.found()).abs() < 1e-5, "{known:?} {end:?}");
    }
    assert_eq!(run.assembles(), Some(false));
    let from = run.assembles_from.unwrap();
    let known = proven.assembles_from.unwrap();
    assert!((from.high - known.high).abs() < 3e-5, "{from:?} {known:?}");
}

/// Polygons of 8 chords a flank: their backlash peaks between sampled poses, at 221.57 µm. Source: a polar gap written independently, on both
/// outlines.
#[test]
fn the_peak_between_sampled_poses_is_found() {
    let file = input::read(Path::new("tests/corpus/pairs/chords_32_12.toml")).unwrap();
    let plan = Plan::new(&file.study, Method::Exact { certify: true });
    let analysis = Analysis::silently(&plan.with_revolution().with_extremes()).unwrap();
    let checked = extremes_of_outlines(&file.study).greatest.unwrap().found();
    let drawn = analysis.curves[0].poses.iter();
    let curve = drawn.filter_map(|pose| pose.simulated.backlash);
    let shown = analysis.extremes.each[0].greatest.as_ref().unwrap().found();
    assert!((1e3 * checked - 221.57).abs() < 0.005, "{checked}");
    assert!((1e3 * shown - 221.57).abs() < 0.005, "{shown}");
    let greatest = analysis.extremes.each[0].greatest.as_ref().unwrap();
    assert!(greatest.is_proven() && curve.fold(0.0, f64::max) <= greatest.high);
    assert_eq!(analysis.verdict().requirement, Requirement::NotMet);
}

/// A pair too near, and one out of mesh: said so, and from where on it assembles.
#[test]
fn what_jams_says_from_where_it_assembles() {
    let gear = |face| AsBuilt::perfect(Gear::nominal(design(20, 2.0)).unwrap(), face);
    let at = |distance| {
        let pair = GearPair::new(gear(Face::Front), gear(Face::Back), distance).unwrap();
        extremes_of_outlines(&study_of(&pair))
    };
    let jammed = at(39.0);
    assert_eq!(jammed.assembles(), Some(false));
    // Perfect gears without backlash at the sum of their pitch radii.
    let from = jammed.assembles_from.unwrap();
    assert!((from.high - 40.0).abs() < 2e-5, "{from:?}");
    let apart = at(44.5);
    assert_eq!(apart.status, Status::NoContact);
    assert!(apart.greatest.is_none() && apart.assembles_from.is_none());
}

/// Perfect gears above the sum of their pitch radii, 40 mm: j_wt = 2 a (inv α_w − inv α) with cos α_w = 40 cos α / a at every pose of the map, and as
/// the extremes; with play in the bearings those at a ∓ c.
#[test]
fn a_pair_that_turns_has_a_map_and_the_play_of_its_bearings() {
    let gear = |face| AsBuilt::perfect(Gear::nominal(design(20, 2.0)).unwrap(), face);
    let angle = 20f64.to_radians();
    let involute = |angle: f64| angle.tan() - angle;
    let known = |a: f64| {
        let operating = (40.0 * angle.cos() / a).min(1.0).acos();
        2.0 * a * (involute(operating) - involute(angle))
    };
    let pair = GearPair::new(gear(Face::Front), gear(Face::Back), 40.3).unwrap();
    let mut study = study_of(&pair);
    study.bearing_clearance = 0.05;
    let run = extremes_of_outlines(&study);
    assert_eq!(run.assembles(), Some(true));
    let play = run.bearings.as_ref().unwrap();
    let ends = [
        (&run.least, 40.3),
        (&run.greatest, 40.3),
        (&play.pressed.extreme, 40.25),
        (&play.apart.extreme, 40.35),
    ];
    for (end, a) in ends {
        let found = end.as_ref().unwrap().found();
        assert!((found - known(a)).abs() < 1e-9, "{a} {found}");
    }
    let each = [run];
    let maps = BacklashMap::of_study(&study, &each, &|| ControlFlow::Continue(())).unwrap();
    let map = &maps[0];
    assert_eq!(map.cells.len(), map.distances.len() * map.columns);
    for (a, row) in map.distances.iter().zip(map.cells.chunks(map.columns)) {
        // Below 40 mm tips reach fillets, and above 41 mm corners touch.
        if !(40.0..41.0).contains(a) {
            continue;
        }
        for cell in row {
            let j_wt = cell.backlash.unwrap();
            assert!((j_wt - known(*a)).abs() < 1e-9, "{a} {j_wt}");
        }
    }
    // Stopped, there is no map.
    assert!(BacklashMap::of_study(&study, &each, &|| ControlFlow::Break(())).is_err());
}
