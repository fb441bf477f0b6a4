//! Which checks fail, found without what is sought only to be reported: the same as every check made.

use super::*;
use gearlash::analysis::diagnosis::{PoseEvidence, failed_checks};
use gearlash::analysis::{Analysis, Plan};
use gearlash::gear::thickness;

const ON: fn() -> ControlFlow<()> = || ControlFlow::Continue(());

/// The ids by every check, and by those that have to be made.
fn both(study: &Study) -> [Vec<&'static str>; 2] {
    let plan = Plan::new(study, Method::Exact { certify: false })
        .with_extremes()
        .with_checks();
    let analysis = Analysis::silently(&plan).unwrap();
    let evidence: Vec<PoseEvidence> = analysis.runs.iter().filter_map(PoseEvidence::of).collect();
    let needed = failed_checks(study, &evidence, &analysis.extremes, &ON).unwrap();
    [analysis.diagnosis.failed(), needed]
        .map(|failed| failed.iter().map(|check| check.id).collect())
}

#[test]
fn of_every_fixture() {
    for name in [
        "karba_44x44.toml",
        "karba_44x44_pitch.toml",
        "karba_86x21.toml",
        "hunting_51x23.toml",
        "tip_on_fillet_86x21.toml",
        "profiled_44x44.toml",
    ] {
        let study = input::read(&fixture(name)).unwrap().study;
        let [all, needed] = both(&study);
        assert_eq!(all, needed, "{name}");
    }
}

/// Few teeth and many, close and far apart, undercut, with little clearance of the tips: most checks fail somewhere.
#[test]
fn of_pairs_at_random() {
    let mut failing = std::collections::BTreeSet::new();
    for index in 0..60 {
        let mut random = Random::of(14, index);
        let mut gear = |face| {
            let teeth = random.within(9.0, 50.0) as u32;
            let data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
            let (dedendum, round) = random.pick(&[(1.25, 0.38), (1.25, 0.2), (1.13, 0.2)]);
            let rack = BasicRack::new(1.0, dedendum, round).unwrap();
            let design = GearDesign {
                profile_shift: random.within(-0.1, 0.4),
                rack,
                ..GearDesign::standard(data)
            };
            let base = thickness::base_from_allowance(
                &design.basic_data,
                design.nominal_base_thickness(),
                random.within(-0.1, 0.0),
            );
            let deviations = Deviations {
                eccentricity: random.pick(&[0.0, 0.01, 0.03]),
                high_tooth: 2.0,
                any_direction: random.chance(0.3),
                ..Deviations::default()
            };
            AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
        };
        let (wheel, pinion) = (gear(Face::Front), gear(Face::Back));
        let zero = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
        let distance = zero.center_distance(0.0).unwrap() + random.within(-0.1, 0.4);
        let distance = distance + random.pick(&[0.0, 0.0, 1.5]);
        let pair = GearPair::new(wheel, pinion, distance).unwrap();
        let [all, needed] = both(&Study::of_pair("random", &pair, 4));
        assert_eq!(all, needed, "pair {index}");
        failing.extend(all);
    }
    // Without these the test would say little.
    for id in [
        "radial_clearance",
        "zero_backlash_distance",
        "contact_ratio",
        "non_involute_onset",
    ] {
        assert!(failing.contains(id), "{failing:?}");
    }
}
