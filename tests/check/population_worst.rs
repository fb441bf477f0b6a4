//! The worst case of a population: closed forms, and no assembly beyond it.

use super::population::{closed_form, gear, of_thickness, pair};
use gearlash::gear::{AsBuilt, Deviations, Face, Pitch};
use gearlash::pair::GearPair;
use gearlash::population::{
    GearScatter, LimitCases, Population, Requirement, Sample, Scatter, Scatters, limit_cases,
};

/// Perfect gears with bands: every length at its end.
#[test]
fn the_worst_case_of_perfect_gears_is_the_closed_form() {
    let scatters = Scatters {
        center_distance: Some(Scatter::uniform(-0.02, 0.03).unwrap()),
        bearing_play: Some(Scatter::fixed(0.01).unwrap()),
        ..of_thickness(
            Some(Scatter::uniform(-0.03, 0.01).unwrap()),
            Some(Scatter::normal_within(-0.02, 0.02, 0.0, 1.33).unwrap()),
        )
    };
    let population = Population::new(pair(132.1), scatters).unwrap();
    let found = limit_cases(&population).unwrap().unwrap();
    let [least, greatest] = found.worst.map(Option::unwrap);
    let closed = [
        closed_form(132.07, [0.01, 0.02]),
        closed_form(132.14, [-0.03, -0.02]),
    ];
    assert!((least - closed[0]).abs() < 1e-9, "{least} {closed:?}");
    assert!((greatest - closed[1]).abs() < 1e-9, "{greatest} {closed:?}");
}

/// No assembly of bounded scatter lies beyond the worst case, and the root sum of squares lies within it.
#[test]
fn no_assembly_is_worse_than_the_worst_case() {
    let gear = || GearScatter {
        thickness: Some(Scatter::uniform(-0.02, 0.02).unwrap()),
        runout: Some(Scatter::uniform(0.0, 0.04).unwrap()),
        per_tooth: Some(Scatter::triangular(-0.004, 0.0, 0.004).unwrap()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: gear(),
        pinion: gear(),
        center_distance: Some(Scatter::uniform(-0.01, 0.01).unwrap()),
        phase: true,
        ..Scatters::default()
    };
    let population = Population::new(pair(132.1), scatters).unwrap();
    let limits = limit_cases(&population).unwrap().unwrap();
    let [least, greatest] = limits.worst.map(Option::unwrap);
    let [low, high] = limits.root_sum_of_squares.map(Option::unwrap);
    assert!(least < low && low < high && high < greatest);
    let requirement = Requirement::new(None, None);
    let all = Sample {
        population: &population,
        requirement,
        seed: 5,
    };
    for number in 1..=500 {
        let (found, _) = all.outcome(number).unwrap();
        assert!(found.is_proven && found.least.unwrap() >= least);
        assert!(found.greatest.unwrap() <= greatest);
    }
}

/// A gear whose tooth 1 has its flanks `off` before their places, mm, own flanks as numbers ascend.
fn with_pitch(teeth: u32, face: Face, off: f64) -> AsBuilt {
    let cumulative: Vec<f64> = (1..=teeth)
        .map(|tooth| if tooth == 1 { off } else { 0.0 })
        .collect();
    let pitch = Pitch::from_cumulative(&cumulative, &cumulative);
    let deviations = Deviations {
        pitch: Some(pitch),
        ..Deviations::default()
    };
    gear(teeth, face).varied(0.0, &deviations).unwrap()
}

/// 30/20 of which a tooth each stands beside its place: of its 10 phases each has a worst case of its own, and that of the population is the
/// worst of these; no assembly of bounded scatter in any phase lies beyond.
#[test]
fn the_worst_case_is_that_of_all_phases() {
    let own = || {
        let wheel = with_pitch(30, Face::Front, 0.03);
        GearPair::new(wheel, with_pitch(20, Face::Back, -0.025), 75.2).unwrap()
    };
    let scatters = |phase| Scatters {
        center_distance: Some(Scatter::uniform(-0.01, 0.01).unwrap()),
        phase,
        ..of_thickness(Some(Scatter::uniform(-0.005, 0.005).unwrap()), None)
    };
    let population = Population::new(own(), scatters(true)).unwrap();
    let all = limit_cases(&population).unwrap().unwrap();
    let each = (1..=10).map(|phase| {
        let population = Population::new(own(), scatters(false)).unwrap();
        limit_cases(&population.with_phase(phase)).unwrap().unwrap()
    });
    let each: Vec<LimitCases> = each.collect();
    type Both = [Option<f64>; 2];
    for of in [
        |case: &LimitCases| case.worst,
        |case: &LimitCases| case.mean,
    ] as [fn(&LimitCases) -> Both; 2]
    {
        let ends = |end: usize| each.iter().map(move |case| of(case)[end].unwrap());
        let least = ends(0).fold(f64::INFINITY, f64::min);
        let greatest = ends(1).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(of(&all).map(Option::unwrap), [least, greatest]);
        // Some phase is not the worst by more than a µm.
        assert!(ends(0).any(|other| other > least + 1e-3));
    }
    let [low, high] = all.root_sum_of_squares.map(Option::unwrap);
    let [least, greatest] = all.worst.map(Option::unwrap);
    assert!(least < low && high < greatest);
    let requirement = Requirement::new(None, None);
    let sample = Sample {
        population: &population,
        requirement,
        seed: 5,
    };
    for number in 1..=300 {
        let (found, _) = sample.outcome(number).unwrap();
        assert!(found.is_proven && found.least.unwrap() >= least, "{number}");
        assert!(found.greatest.unwrap() <= greatest, "{number}");
    }
}
