//! Pairs on the line of action, compared with the placed teeth.

use super::*;
use crate::contact::exact::section::Section;
use crate::gear::{Deviations, Face, GearDesign, Side};
use crate::pair::{GearPair, Mating, Pose};

/// 200 poses, of either side. Gears of 25 and 18 teeth, both eccentric, with pitch deviations of up to a hundredth of a pitch.
fn each(mut of: impl FnMut(&PosedFlanks, &TangentVariation)) {
    let gear = |teeth: u32, face, eccentricity| {
        let curve = |shift: f64| -> Vec<f64> {
            let each = 0..teeth;
            each.map(|k| 0.06 * (1.7 * f64::from(k) + shift).sin())
                .collect()
        };
        let deviations = Deviations::off_axis(eccentricity, 3.5);
        let deviations = deviations.with_pitch(&curve(0.3), &curve(1.1));
        GearDesign::plain(teeth, 2.0).built(face, &deviations)
    };
    let (wheel, pinion) = (gear(25, Face::Front, 0.05), gear(18, Face::Back, 0.08));
    let pair = GearPair::new(wheel, pinion, 43.3).unwrap();
    let section = Section::new(&pair);
    let variation = &section.solver.as_ref().unwrap().variation;
    for (k, problem) in (0..200).flat_map(|k| [(k, &section.right), (k, &section.left)]) {
        let mating = Mating {
            fraction: f64::from(k) / 200.0,
            ..Mating::at(1 + k % 25, 1 + k % 18, Side::Right)
        };
        of(
            &section.posed(problem, &Pose::new(&pair, mating)),
            variation,
        );
    }
}

/// The steps include every one whose rolls are on both involutes within the tolerances, and few others. Source: the
/// rolls of every step in reach.
#[test]
fn steps_on_the_line_are_those_whose_rolls_are() {
    let (mut on, mut none) = (0, 0);
    each(|posed, variation| {
        let (line, _) = start_line(posed, variation).unwrap();
        for plays in [(0.0, 0.0), (0.15, 0.0), (0.0, 0.2), (0.1, 0.15)] {
            let steps = steps_on(posed, &line, plays);
            let all = posed.steps();
            let holds: Vec<i64> = all
                .filter(|&step| {
                    let rolls = InvolutePair::new(posed, step).rolls_on(posed.problem, &line);
                    is_on_path(posed.problem, rolls, plays)
                })
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
        assert!(offer_pairs_on_line(posed, variation, &mut tightest));
        let Some(first_contact) = tightest.choose() else {
            return;
        };
        let (part, roll) = first_contact.candidate.locked;
        let locked = posed.locked(first_contact.step);
        let [one, other] = [roll - STEP, roll + STEP].map(|roll| locked.at(part, roll).point);
        let turned = (other * one.conj()).arg();
        let farther = (other.norm_sqr() / one.norm_sqr()).ln() / 2.0;
        let slope = turned / farther;
        let found = first_contact.candidate.slope;
        assert!(
            (found - slope).abs() < 1e-3 * slope.abs().max(1e-3),
            "{found} {slope}"
        );
        compared += 1;
    });
    assert!(compared > 300, "{compared}");
}
