//! Pairs on the line of action, compared with the placed teeth.

use super::*;
use crate::contact::exact::section::Section;
use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Pitch, Side};
use crate::pair::{GearPair, Mating, Member, Pose};

/// 25 and 18 teeth, both eccentric, with pitch deviations of up to a hundredth of a pitch.
fn pair() -> GearPair {
    let gear = |teeth: u32, face, eccentricity| {
        let gear = Gear::nominal(GearDesign::plain(teeth, 2.0)).unwrap();
        let curve = |shift: f64| -> Vec<f64> {
            let each = 0..teeth;
            each.map(|k| 0.06 * (1.7 * f64::from(k) + shift).sin())
                .collect()
        };
        let deviations = Deviations {
            eccentricity,
            high_tooth: 3.5,
            pitch: Some(Pitch::from_cumulative(&curve(0.3), &curve(1.1))),
            ..Deviations::default()
        };
        AsBuilt::new(gear, face, &deviations).unwrap()
    };
    let (wheel, pinion) = (gear(25, Face::Front, 0.05), gear(18, Face::Back, 0.08));
    GearPair::with_locked(wheel, pinion, 43.3, Member::Wheel).unwrap()
}

/// 200 poses, of either side.
fn each(mut of: impl FnMut(&PosedFlanks, &TangentVariation)) {
    let pair = pair();
    let section = Section::new(&pair);
    let variation = &section.solver.as_ref().unwrap().variation;
    for k in 0..200 {
        let mating = Mating {
            wheel_tooth: 1 + k % 25,
            pinion_tooth: 1 + k % 18,
            flank: Side::Right,
            fraction: f64::from(k) / 200.0,
        };
        let pose = Pose::new(&pair, mating);
        for problem in [&section.right, &section.left] {
            of(&section.posed(problem, &pose), variation);
        }
    }
}

/// The steps include every one whose rolls are on both involutes within the tolerances, and few others. Source: the
/// rolls of every step in reach.
#[test]
fn steps_on_the_line_are_those_whose_rolls_are() {
    let (mut on, mut none) = (0, 0);
    each(|posed, variation| {
        let (line, _) = posed.start(variation).unwrap();
        for plays in [(0.0, 0.0), (0.15, 0.0), (0.0, 0.2), (0.1, 0.15)] {
            let steps = posed.steps_on(&line, plays);
            let all = posed.steps();
            let holds: Vec<i64> = all
                .filter(|&step| posed.on_path(posed.rolls(&line, &posed.pair(step)), plays))
                .collect();
            let case = format!("{plays:?}: {holds:?} of {steps:?}");
            assert!(holds.iter().all(|step| steps.contains(step)), "{case}");
            assert!(steps.count() <= holds.len() + 2, "{case}");
            on += holds.len();
            none += usize::from(holds.is_empty());
        }
    });
    assert!(on > 2000 && none < 20, "{on} {none}");
}

/// `σ = ρ dθ/dρ` of a contact on the line is that of the locked flank about the free axis, and determines its bound.
/// Source: the flank slightly to either side.
#[test]
fn the_slope_of_a_contact_is_that_of_the_locked_flank() {
    const STEP: f64 = 1e-5;
    let mut compared = 0;
    each(|posed, variation| {
        let mut tightest = TightestContacts::new(posed.problem);
        assert!(posed.on_line(variation, &mut tightest));
        let Some(touching) = tightest.choose() else {
            return;
        };
        let (part, roll) = touching.candidate.locked;
        let locked = posed.locked(touching.step);
        let [one, other] = [roll - STEP, roll + STEP].map(|roll| locked.at(part, roll).point);
        let turned = (other * one.conj()).arg();
        let farther = (other.norm_sqr() / one.norm_sqr()).ln() / 2.0;
        let slope = turned / farther;
        let found = touching.candidate.slope;
        assert!(
            (found - slope).abs() < 1e-3 * slope.abs().max(1e-3),
            "{found} {slope}"
        );
        compared += 1;
    });
    assert!(compared > 300, "{compared}");
}
