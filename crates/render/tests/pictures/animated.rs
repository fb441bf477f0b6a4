//! The gears turning through a pitch.

use crate::check_labels;
use crate::solved::{Solved, all, nominal};
use gearlash::contact::{CutPair, Method, PoseResult, sweep};
use gearlash::pair::{Mating, Member};
use gearlash_render::{Snapshot, animation};
use roxmltree::{Document, Node};
use std::ops::ControlFlow;

const STEPS: u32 = 12;

fn steps(solved: &Solved) -> Vec<PoseResult> {
    let start = *solved.pose.mating();
    let matings: Vec<Mating> = (0..=STEPS)
        .map(|step| Mating {
            fraction: start.fraction + f64::from(step) / f64::from(STEPS),
            ..start
        })
        .collect();
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| solved.assembly.gear(m));
    let cut = CutPair::new(wheel, pinion, 1e-3);
    let method = Method::Exact { certify: false };
    let go_on = || ControlFlow::Continue(());
    sweep(&solved.assembly, &cut, method, &matings, 0.0, &go_on).unwrap()
}

fn draw(solved: &Solved) -> String {
    let view = Snapshot {
        title: solved.name,
        assembly: &solved.assembled(),
        pose: &solved.pose,
        material: gearlash::analysis::study::Material::AsMeasured,
        found: Ok(&solved.lost_motion),
        section: None,
    };
    animation(&view, &steps(solved), &[])
}

fn numbers(node: &Node, name: &str) -> Vec<f64> {
    let list = node.attribute(name).unwrap().split(';');
    list.map(|value| value.split(' ').next().unwrap().parse().unwrap())
        .collect()
}

/// Through a pitch a gear turns by 360°/z, its mate the other way (z_1 φ_1 = −z_2 φ_2).
#[test]
fn perfect_gears_turn_by_a_pitch() {
    let svg = draw(&nominal());
    let document = Document::parse(&svg).unwrap();
    let all = document.descendants();
    let turns: Vec<Vec<f64>> = all
        .filter(|node| node.has_tag_name("animateTransform"))
        .map(|node| numbers(&node, "values"))
        .collect();
    assert!(turns.len() >= 6);
    for turn in &turns {
        assert_eq!(turn.len(), STEPS as usize + 1);
        assert_eq!(turn[0], 0.0);
        let teeth = 360.0 / turn[STEPS as usize];
        let is = |z: f64| (teeth.abs() - z).abs() < 1e-3;
        assert!(is(17.0) || is(12.0), "{teeth}");
        let even = turn[STEPS as usize] / f64::from(STEPS);
        assert!(
            turn.windows(2)
                .all(|pair| (pair[1] - pair[0] - even).abs() < 2e-4)
        );
    }
    let senses = |z: f64| -> Vec<f64> {
        let of = turns.iter().map(|turn| turn[STEPS as usize]);
        of.filter(|turn| (360.0 / turn.abs() - z).abs() < 1e-3)
            .map(f64::signum)
            .collect()
    };
    let (wheel, pinion) = (senses(17.0), senses(12.0));
    assert!(wheel.iter().all(|sign| *sign == wheel[0]));
    assert!(pinion.iter().all(|sign| *sign == -wheel[0]));
}

#[test]
fn every_course_starts_where_the_still_picture_has_it() {
    for solved in all().iter().chain([&nominal()]) {
        let svg = draw(solved);
        check_labels(solved.name, &svg);
        assert_eq!(svg, draw(solved));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        // Self-contained: the only addresses are the name spaces.
        assert_eq!(svg.matches("http").count(), 2);
        assert_eq!(svg.matches("=\"http://www.w3.org/").count(), 2);
        let document = Document::parse(&svg).unwrap();
        for node in document
            .descendants()
            .filter(|node| node.has_tag_name("animate"))
        {
            let (values, times) = (numbers(&node, "values"), numbers(&node, "keyTimes"));
            assert_eq!(values.len(), times.len());
            assert_eq!((times[0], times[times.len() - 1]), (0.0, 1.0));
            assert!(times.windows(2).all(|pair| pair[0] <= pair[1]));
            let circle = node.parent().unwrap();
            let start = circle.attribute(node.attribute("attributeName").unwrap());
            assert_eq!(
                start.unwrap().parse::<f64>().unwrap(),
                values[0],
                "{}",
                solved.name
            );
        }
    }
}

#[test]
fn turning_gears_as_svg() {
    insta::assert_snapshot!(draw(&nominal()));
}
