//! Deviations drawn larger than they are.

use crate::check_labels;
use crate::design::design;
use crate::picture::read;
use crate::solved::{Solved, deviated};
use gearlash::contact::Exaggeration;
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Side};
use gearlash::pair::Member;
use gearlash_render::{Snapshot, exaggerated};

fn draw(solved: &Solved, factor: f64) -> String {
    let gears = Exaggeration::new(&solved.assembly, factor).unwrap();
    let view = Snapshot {
        title: solved.name,
        assembly: &solved.assembled(),
        pose: &solved.pose,
        material: gearlash::analysis::study::Material::AsMeasured,
        found: Ok(&solved.lost_motion),
        section: None,
    };
    exaggerated(&view, &gears)
}

fn strong() -> Solved {
    let (assembly, pose) = deviated(72.8, 0.1);
    Solved::new("deviated", assembly, pose)
}

/// A tooth 30 µm thicker by its mean and 20 µm by itself has each flank 25 µm out (design section 4: half
/// to each side), eccentricity is as given; all of it times the factor.
#[test]
fn every_flank_moves_by_its_deviation_times_the_factor() {
    let design = GearDesign {
        profile_shift: 0.1,
        ..design(30, 2.0)
    };
    // s_b = cos α (s + 2 r inv α): base thickness grows by the cosine of the reference thickness.
    let thicker = design.nominal_base_thickness() + 0.03 * 20f64.to_radians().cos();
    let mut per_tooth = vec![0.0; 30];
    per_tooth[4] = 0.02;
    let deviations = Deviations {
        per_tooth,
        eccentricity: 0.01,
        high_tooth: 7.5,
        ..Deviations::default()
    };
    let gear = Gear::new(design, thicker).unwrap();
    let built = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
    for factor in [0.0, 1.0, 20.0] {
        let large = built.exaggerated(factor).unwrap();
        assert!((large.eccentricity() - 0.01 * factor).abs() < 1e-15);
        assert_eq!(large.high_tooth(), 7.5);
        assert_eq!(large.gear(), &Gear::nominal(design).unwrap());
        for (tooth, out) in [(5, 0.025), (6, 0.015)] {
            for side in Side::BOTH {
                let moved = side.sense() * large.flank_offset(side, tooth) * 30.0;
                assert!(
                    (moved - factor * out).abs() < 1e-13,
                    "{side:?} {tooth} {moved}"
                );
            }
        }
    }
    assert!(built.exaggerated(1000.0).is_err());
}

#[test]
fn the_picture_says_that_it_is_not_to_scale() {
    for (solved, factors) in [
        (strong(), [1.0, 8.0]),
        (crate::solved::nominal(), [1.0, 50_000.0]),
    ] {
        for factor in factors {
            let svg = draw(&solved, factor);
            check_labels(solved.name, &svg);
            let words = format!("deviations × {factor}: not to scale");
            let texts = read(&svg).texts;
            assert!(texts.iter().any(|(text, _)| text.starts_with(&words)));
            // A scale bar would lie.
            assert!(!texts.iter().any(|(text, _)| text.ends_with(" : 1")));
            assert_eq!(svg, draw(&solved, factor));
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
        }
    }
}

#[test]
fn the_picture_tells_what_was_found() {
    let solved = strong();
    let gears = Exaggeration::new(&solved.assembly, 8.0).unwrap();
    let texts = read(&draw(&solved, 8.0)).texts;
    let has = |wanted: &str| texts.iter().any(|(text, _)| text == wanted);
    assert!(has("eccentricity 60.00 µm") && has("towards tooth 3.5"));
    assert!(has("eccentricity 100.00 µm") && has("towards tooth 17"));
    let [least, most] = gears.found(Member::Wheel).flanks;
    let all: Vec<f64> = (1..=12)
        .flat_map(|tooth| {
            let gear = solved.assembly.gear(Member::Wheel);
            Side::BOTH.map(|side| side.sense() * gear.flank_offset(side, tooth) * 12.0)
        })
        .collect();
    let extreme = |pick: fn(f64, f64) -> f64| all.iter().copied().reduce(pick).unwrap();
    assert!((least - extreme(f64::min)).abs() < 1e-12);
    assert!((most - extreme(f64::max)).abs() < 1e-12);
}

#[test]
fn exaggerated_deviations_as_svg() {
    insta::assert_snapshot!(draw(&strong(), 8.0));
}
