//! Gears that turn through a pitch, and gears whose deviations are drawn larger than they are.

use super::design::design;
use super::drawn::{Picture, ends};
use super::posed::{Posed, all, deviated, nominal};
use super::snapshots::check;
use super::{METHOD, on};
use gearlash::contact::{CutPair, Exaggeration, sweep};
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Side};
use gearlash::pair::{Mating, Member};
use gearlash_render::{animation, exaggerated};
use roxmltree::{Document, Node};

const STEPS: u32 = 12;

fn draw_turning(posed: &Posed) -> String {
    let start = *posed.pose.mating();
    let step = |step: u32| Mating {
        fraction: start.fraction + f64::from(step) / f64::from(STEPS),
        ..start
    };
    let matings: Vec<Mating> = (0..=STEPS).map(step).collect();
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| posed.pair.gear(m));
    let cut = CutPair::new(wheel, pinion, 1e-3);
    let poses = sweep(&posed.pair, &cut, METHOD, &matings, 0.0, &on).unwrap();
    animation(&posed.view(), &poses, &[])
}

fn draw_exaggerated(posed: &Posed, factor: f64) -> String {
    let gears = Exaggeration::new(&posed.pair, factor).unwrap();
    exaggerated(&posed.view(), &gears)
}

fn strong() -> Posed {
    deviated("deviated", 72.8, 0.1)
}

fn numbers(node: &Node, name: &str) -> Vec<f64> {
    let list = node.attribute(name).unwrap().split(';');
    list.map(|value| value.split(' ').next().unwrap().parse().unwrap())
        .collect()
}

/// Through a pitch a gear turns by 360°/z, its mate the other way (z_1 φ_1 = −z_2 φ_2).
#[test]
fn perfect_gears_turn_by_a_pitch() {
    let svg = draw_turning(&nominal());
    let document = Document::parse(&svg).unwrap();
    let nodes = document.descendants();
    let animated = nodes.filter(|node| node.has_tag_name("animateTransform"));
    let turns: Vec<Vec<f64>> = animated.map(|node| numbers(&node, "values")).collect();
    assert!(turns.len() >= 6);
    let mut wheel_senses = Vec::new();
    for turn in &turns {
        assert_eq!((turn.len(), turn[0]), (STEPS as usize + 1, 0.0));
        let whole = turn[STEPS as usize];
        let is_wheel = (360.0 / whole.abs() - 17.0).abs() < 1e-3;
        let is_turned = is_wheel || (360.0 / whole.abs() - 12.0).abs() < 1e-3;
        assert!(is_turned, "{whole}");
        let even = whole / f64::from(STEPS);
        let mut steps = turn.windows(2);
        assert!(steps.all(|pair| (pair[1] - pair[0] - even).abs() < 2e-4));
        wheel_senses.push(if is_wheel {
            whole.signum()
        } else {
            -whole.signum()
        });
    }
    wheel_senses.dedup();
    assert_eq!(wheel_senses.len(), 1, "{turns:?}");
}

#[test]
fn every_course_starts_where_the_still_picture_has_it() {
    for posed in all().iter().chain([&nominal()]) {
        let svg = draw_turning(posed);
        check(posed.title, &svg);
        // Self-contained: the only addresses are the name spaces.
        assert_eq!(svg.matches("http").count(), 2);
        assert_eq!(svg.matches("=\"http://www.w3.org/").count(), 2);
        let document = Document::parse(&svg).unwrap();
        let nodes = document.descendants();
        for node in nodes.filter(|node| node.has_tag_name("animate")) {
            let [values, times] = ["values", "keyTimes"].map(|name| numbers(&node, name));
            assert_eq!(values.len(), times.len());
            assert_eq!((times[0], times[times.len() - 1]), (0.0, 1.0));
            assert!(times.is_sorted());
            let circle = node.parent().unwrap();
            let start = circle.attribute(node.attribute("attributeName").unwrap());
            assert_eq!(start.unwrap().parse(), Ok(values[0]), "{}", posed.title);
        }
    }
}

#[test]
fn turning_gears_as_svg() {
    insta::assert_snapshot!(draw_turning(&nominal()));
}

/// A tooth 30 µm thicker by its mean and 20 µm by itself has each flank 25 µm out (half
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
                let off = (moved - factor * out).abs();
                assert!(off < 1e-13, "{side:?} {tooth} {moved}");
            }
        }
    }
    assert!(built.exaggerated(1000.0).is_err());
}

#[test]
fn the_picture_says_that_it_is_not_to_scale() {
    for (posed, factors) in [(strong(), [1.0, 8.0]), (nominal(), [1.0, 50_000.0])] {
        for factor in factors {
            let svg = draw_exaggerated(&posed, factor);
            check(posed.title, &svg);
            let picture = Picture::of(&svg);
            let words = format!("deviations × {factor}: not to scale");
            assert!(picture.says(|text| text.starts_with(&words)));
            // A scale bar would lie.
            assert!(!picture.says(|text| text.ends_with(" : 1")));
        }
    }
}

#[test]
fn exaggerated_deviations_as_svg() {
    let posed = strong();
    let svg = draw_exaggerated(&posed, 8.0);
    let picture = Picture::of(&svg);
    let told = "eccentricity 60.00 µm|towards tooth 3.5|eccentricity 100.00 µm|towards tooth 17";
    for words in told.split('|') {
        assert!(picture.has(words), "{words}");
    }
    let wheel = posed.pair.gear(Member::Wheel);
    let out = |tooth| Side::BOTH.map(|side| side.sense() * wheel.flank_offset(side, tooth) * 12.0);
    let expected = ends((1..=12).flat_map(out));
    let gears = Exaggeration::new(&posed.pair, 8.0).unwrap();
    let found = gears.found(Member::Wheel).flanks;
    let mut pairs = found.into_iter().zip(expected);
    assert!(pairs.all(|(one, other)| (one - other).abs() < 1e-12));
    insta::assert_snapshot!(svg);
}
