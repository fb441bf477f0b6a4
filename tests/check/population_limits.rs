//! Requirements on each assembly of a population, compared with the verdict of the same pair alone; and its worst case, with no assembly beyond it.

use super::population::*;
use super::*;
use gearlash::population::{
    AssemblyLimits, GearScatter, LimitCases, OutcomeKind, Population, Scatter, Scatters,
    limit_cases,
};

fn limited(quantity: Quantity, limit: f64, is_max: bool) -> Vec<(Quantity, Limits)> {
    let limits = Limits {
        min: (!is_max).then_some(limit),
        max: is_max.then_some(limit),
    };
    vec![(quantity, limits)]
}

/// Limits 0.1 µm (or the lost motion of as much) to either side of what an assembly has, whose bracket is 0.001 µm wide: whatever is limited, the
/// verdict of that pair alone says the same.
#[test]
fn every_requirement_is_judged_as_the_verdict_of_the_pair_judges_it() {
    // 30/20 with thickness, runout, centre distance, play and phase drawn.
    let of = |sigma| of_gear(normal(sigma), Some(Scatter::rayleigh(0.01).unwrap()));
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        center_distance: Some(Scatter::triangular(-0.02, 0.0, 0.02).unwrap()),
        bearing_clearance: within(0.002, 0.01),
        phase: true,
        ..Scatters::default()
    };
    let population = Population::new(perfect([30, 20], 75.2), scatters).unwrap();
    for number in 1..=6 {
        let assembly = population.assembly(drawn(3, number)).unwrap();
        let outcome = assembly.outcome().unwrap();
        assert_eq!(outcome.kind, OutcomeKind::Clear);
        let (pair, play) = (assembly.pair.data().unwrap(), assembly.clearance);
        let [near, far] = [-play, play].map(|by| pair.at(pair.center_distance() + by).unwrap());
        let start = (1, assembly.phase);
        let study = Study {
            bearing_clearance: play,
            sweep: Some(SweepPlan::wheel_revolution(pair, 1, start)),
            ..Study::of_pair("alone", pair, 1)
        };
        let found = runs_of(&study, false);
        let others = Quantity::BESIDE_OPERATING_BACKLASH;
        for quantity in [Quantity::OperatingBacklash].into_iter().chain(others) {
            let value = |end: &GearPair, j_wt: Option<f64>, is_max| {
                let ends = quantity.bracket(&end.clone().into(), [j_wt.unwrap(); 2], is_max);
                ends.unwrap()[0]
            };
            let least = value(&near, outcome.least, false);
            let greatest = value(&far, outcome.greatest, true);
            let hair = match quantity {
                Quantity::LostMotion(member) => 1e-4 / pair.operating_pitch_radius(member),
                _ => 1e-4,
            };
            for (value, is_max) in [(least, false), (greatest, true)] {
                for by in [-hair, hair] {
                    let required = limited(quantity, value + by, is_max);
                    let verdict = Verdict::new(&found, &required, None, Vec::new());
                    let missed = verdict.requirement == RequirementOutcome::NotMet;
                    let case = format!("{number} {quantity:?} {is_max} {by}");
                    assert_eq!(missed, (by < 0.0) == is_max, "{case}");
                    let standing = AssemblyLimits::of(&required).standing(&assembly, &outcome);
                    assert_eq!(standing.below, missed && !is_max, "{case}");
                    assert_eq!(standing.above, missed && is_max, "{case}");
                }
            }
        }
    }
}

/// Perfect gears with bands: every length at its end.
#[test]
fn the_worst_case_of_perfect_gears_is_the_closed_form() {
    let pinion = Scatter::normal_within(-0.02, 0.02, 0.0, 1.33).unwrap();
    let scatters = Scatters {
        center_distance: within(-0.02, 0.03),
        bearing_clearance: Some(Scatter::fixed(0.01).unwrap()),
        ..of_thickness(within(-0.03, 0.01), Some(pinion))
    };
    let population = Population::new(rig(), scatters).unwrap();
    let found = limit_cases(&population).unwrap().unwrap();
    let [least, greatest] = found.worst.map(Option::unwrap);
    near("least", least, closed_form(132.07, [0.01, 0.02]), 1e-9);
    let expected = closed_form(132.14, [-0.03, -0.02]);
    near("greatest", greatest, expected, 1e-9);
}

/// No assembly of bounded scatter lies beyond the worst case, and the root sum of squares lies within it.
fn none_is_worse(population: &Population, limits: &LimitCases, count: u64) {
    let [least, greatest] = limits.worst.map(Option::unwrap);
    let [low, high] = limits.root_sum_of_squares.map(Option::unwrap);
    assert!(least < low && low < high && high < greatest);
    let all = sample(population, AssemblyLimits::new(None, None), 5);
    for number in 1..=count {
        let (found, _) = all.outcome(number).unwrap();
        assert!(found.is_proven && found.least.unwrap() >= least, "{number}");
        assert!(found.greatest.unwrap() <= greatest, "{number}");
    }
}

#[test]
fn no_assembly_is_worse_than_the_worst_case() {
    let gear = || GearScatter {
        per_tooth: Some(Scatter::triangular(-0.004, 0.0, 0.004).unwrap()),
        ..of_gear(within(-0.02, 0.02), within(0.0, 0.04))
    };
    let scatters = Scatters {
        wheel: gear(),
        pinion: gear(),
        center_distance: within(-0.01, 0.01),
        phase: true,
        ..Scatters::default()
    };
    let population = Population::new(rig(), scatters).unwrap();
    let limits = limit_cases(&population).unwrap().unwrap();
    none_is_worse(&population, &limits, 500);
}

/// 30/20 of which a tooth each stands beside its place: of its 10 phases each has a worst case of its own, and that of the population is the
/// worst of these; no assembly of bounded scatter in any phase lies beyond.
#[test]
fn the_worst_case_is_that_of_all_phases() {
    // Tooth 1 has its flanks before their places.
    let gear = |teeth: u32, off: f64| {
        let mut cumulative = vec![0.0; teeth as usize];
        cumulative[0] = off;
        spur(teeth, 3.0).pitch(&cumulative, &cumulative)
    };
    let population = |phase| {
        let scatters = Scatters {
            center_distance: within(-0.01, 0.01),
            phase,
            ..of_thickness(within(-0.005, 0.005), None)
        };
        Population::new(pair(&gear(30, 0.03), &gear(20, -0.025), 75.2), scatters).unwrap()
    };
    let limits = |population: &Population| limit_cases(population).unwrap().unwrap();
    let whole = population(true);
    let all = limits(&whole);
    let each = (1..=10).map(|phase| limits(&population(false).with_phase(phase)));
    let each: Vec<LimitCases> = each.collect();
    let worst: fn(&LimitCases) -> [Option<f64>; 2] = |case| case.worst;
    for of in [worst, |case| case.mean] {
        let ends = |end: usize| each.iter().map(move |case| of(case)[end].unwrap());
        let [least, _] = kit::ends(ends(0));
        let [_, greatest] = kit::ends(ends(1));
        assert_eq!(of(&all).map(Option::unwrap), [least, greatest]);
        // Some phase is not the worst by more than a µm.
        assert!(ends(0).any(|other| other > least + 1e-3));
    }
    none_is_worse(&whole, &all, 300);
}
