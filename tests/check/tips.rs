//! Tips: how thick they are, and what of the mate they stand near to.

use super::*;
use gearlash::analysis::diagnosis::{PoseEvidence, failed_checks};
use gearlash::analysis::{Analysis, Plan};

const ON: fn() -> ControlFlow<()> = || ControlFlow::Continue(());

fn built(design: GearDesign, face: Face, deviations: &Deviations) -> AsBuilt {
    AsBuilt::new(Gear::nominal(design).unwrap(), face, deviations).unwrap()
}

/// A tooth thinner by `t` at the reference circle is thinner by `t r_a/r` at its tip: flanks turn about the centre. It is the one named.
#[test]
fn the_tip_of_a_thin_tooth_is_thin_by_as_much_of_an_angle() {
    let mut per_tooth = vec![0.0; 30];
    (per_tooth[2], per_tooth[7]) = (-0.06, -0.03);
    let thin = Deviations {
        per_tooth,
        ..Deviations::default()
    };
    let wheel = built(design(30, 2.0), Face::Front, &thin);
    let pinion = built(design(30, 2.0), Face::Back, &Deviations::default());
    let mean = limits::tip_thickness(wheel.gear());
    let pair = GearPair::new(wheel, pinion, 60.2).unwrap();
    let found = diagnosed(&Study::of_pair("thin", &pair, 4));
    let tip = check(&found, "tip_thickness", Some(Member::Wheel));
    let expected = mean - 0.06 * 32.0 / 30.0;
    assert!((tip.outlines.unwrap() - expected).abs() < 1e-12);
    assert!((tip.margin.unwrap() - (expected - 0.4)).abs() < 1e-12);
    assert_eq!(tip.note, "tooth 3");
    let tip = check(&found, "tip_thickness", Some(Member::Pinion));
    assert_eq!(tip.outlines, tip.formula);
    assert_eq!(tip.note, "");
}

/// Tips whose radial clearance is below 0.15 of a module fail, be it that the root is not deep enough or that eccentricities take
/// what a formula leaves: `h_f − h_a` modules of perfect gears at the sum of their reference radii, less both eccentricities.
#[test]
fn too_little_radial_clearance_fails_by_depth_and_by_eccentricity() {
    for (dedendum, eccentricity, fails) in [
        (1.05, 0.0, true),
        (1.14, 0.0, true),
        (1.16, 0.0, false),
        (1.25, 0.07, false),
        (1.25, 0.13, true),
    ] {
        let rack = BasicRack::new(1.0, dedendum, 0.1).unwrap();
        let [wheel, pinion] = [Face::Front, Face::Back].map(|face| {
            let deviations = Deviations {
                eccentricity,
                high_tooth: 1.0,
                ..Deviations::default()
            };
            built(
                GearDesign {
                    rack,
                    ..design(40, 2.0)
                },
                face,
                &deviations,
            )
        });
        let pair = GearPair::new(wheel, pinion, 80.0).unwrap();
        let study = Study::of_pair("near", &pair, 4);
        let plan = Plan::new(&study, Method::Exact { certify: false }).with_extremes();
        let analysis = Analysis::silently(&plan).unwrap();
        let evidence: Vec<PoseEvidence> =
            analysis.runs.iter().filter_map(PoseEvidence::of).collect();
        let failed = failed_checks(&study, &evidence, &analysis.extremes, &ON).unwrap();
        assert_eq!(
            failed.iter().any(|check| check.id == "radial_clearance"),
            fails,
            "{dedendum} {eccentricity}: {failed:?}"
        );
    }
}
