//! Populations against closed forms: perfect gears, whose backlash is linear in thickness.
//!
//! `j_wt = p_w − s_w1 − s_w2` with `s_w = 2 r_w (s_b/(2 r_b) − inv α_wt)` (ISO 21771).

use gearlash::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Pitch, Side, involute,
    thickness as shop,
};
use gearlash::pair::{GearPair, Member};
use gearlash::population::{
    ContributionSums, Draw, Factor, GearScatter, LimitCases, Population, PopulationError,
    Requirement, Run, Sample, Scatter, Scatters, Statistics, Tally, contribution_sums, limit_cases,
    sample,
};
use std::ops::ControlFlow;

fn go_on() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn gear(teeth: u32, face: Face) -> AsBuilt {
    let basic_data = BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap();
    let gear = Gear::nominal(GearDesign::standard(basic_data)).unwrap();
    AsBuilt::perfect(gear, face)
}

fn pair(center_distance: f64) -> GearPair {
    GearPair::new(gear(44, Face::Front), gear(44, Face::Back), center_distance).unwrap()
}

/// `j_wt`, mm, of perfect 44/44, m 3, 20° whose teeth are thicker by so much, mm at the reference circle.
fn closed_form(center_distance: f64, thicker: [f64; 2]) -> f64 {
    let gear = gear(44, Face::Front);
    let (data, nominal) = (gear.gear().basic_data(), gear.gear().base_thickness());
    let pressure = (2.0 * data.base_radius() / center_distance).acos();
    let radius = 0.5 * center_distance;
    let thickness = thicker.map(|thicker| {
        let base = shop::base_from_allowance(data, nominal, thicker);
        2.0 * radius * (base / (2.0 * data.base_radius()) - involute::inv(pressure))
    });
    std::f64::consts::TAU * radius / 44.0 - thickness[0] - thickness[1]
}

fn of_thickness(wheel: Option<Scatter>, pinion: Option<Scatter>) -> Scatters {
    let gear = |thickness| GearScatter {
        thickness,
        ..GearScatter::default()
    };
    Scatters {
        wheel: gear(wheel),
        pinion: gear(pinion),
        ..Scatters::default()
    }
}

fn normal(sigma: f64) -> Option<Scatter> {
    Some(Scatter::normal(0.0, sigma).unwrap())
}

/// Thickness, runout, pitch, distance, play and phase of 30/20.
fn everything() -> Population {
    let of = |sigma| GearScatter {
        thickness: normal(sigma),
        runout: Some(Scatter::rayleigh(0.01).unwrap()),
        pitch: Some(0.003),
        per_tooth: Some(Scatter::uniform(-0.002, 0.002).unwrap()),
        gears: None,
    };
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        center_distance: Some(Scatter::triangular(-0.02, 0.0, 0.02).unwrap()),
        bearing_play: Some(Scatter::uniform(0.0, 0.01).unwrap()),
        phase: true,
        thickness_correlation: 0.5,
    };
    let pair = GearPair::new(gear(30, Face::Front), gear(20, Face::Back), 75.2).unwrap();
    Population::new(pair, scatters).unwrap()
}

/// The share of a normal population below a limit is Φ((limit − mean)/σ): inside the interval of 95 % in 95 % of samples or more. Three
/// standard errors of a count of 200 below that: 180.
#[test]
fn the_interval_holds_the_closed_form_as_often_as_it_says() {
    let population = Population::new(pair(132.1), of_thickness(normal(0.012), None)).unwrap();
    // Where 5 % lie below; j_wt is linear in the thickness.
    let slope = (closed_form(132.1, [0.01, 0.0]) - closed_form(132.1, [0.0; 2])) / 0.01;
    let limit = closed_form(132.1, [0.0; 2]) + slope * 0.012 * 1.6448536269514722;
    let holds = (0..200).filter(|&seed| {
        let requirement = Requirement::new(Some(limit), None);
        let all = Sample {
            population: &population,
            requirement,
            seed,
            total: 400,
        };
        let tally = sample(&all, 1..401, &go_on).unwrap();
        let below = Statistics::of(&tally, &requirement).below;
        below.low <= 0.05 && 0.05 <= below.high
    });
    let holds = holds.count();
    assert!(holds >= 180, "{holds} of 200");
}

/// Moments of a normal population: mean and σ within four standard errors.
#[test]
fn spread_of_thickness_is_the_closed_form() {
    let both = of_thickness(normal(0.012), normal(0.016));
    for (correlation, sigma) in [
        (0.0, 0.02),
        (1.0, 0.028),
        (-1.0, 0.004),
        (0.5, 0.02433105012119288),
    ] {
        let scatters = Scatters {
            thickness_correlation: correlation,
            ..both.clone()
        };
        let population = Population::new(pair(132.1), scatters).unwrap();
        let requirement = Requirement::new(None, None);
        let all = Sample {
            population: &population,
            requirement,
            seed: 3,
            total: 4000,
        };
        let tally = sample(&all, 1..4001, &go_on).unwrap();
        let found = Statistics::of(&tally, &requirement).least;
        let slope = (closed_form(132.1, [0.0; 2]) - closed_form(132.1, [0.01, 0.0])) / 0.01;
        let sigma = slope * sigma;
        let root = 4000f64.sqrt();
        let off = found.mean.unwrap() - closed_form(132.1, [0.0; 2]);
        assert!(off.abs() < 4.0 * sigma / root, "{correlation}: {off}");
        let off = found.sigma.unwrap() / sigma - 1.0;
        assert!(
            off.abs() < 4.0 / (2f64.sqrt() * root),
            "{correlation}: {off}"
        );
    }
}

/// Three linear quantities: each index is its share of the sum of squares (Saltelli et al. 2010, additive case), first-order and total alike.
/// 2.04 standard errors of 32 groups are 95 %.
#[test]
fn contributions_of_a_linear_case_lie_within_their_errors() {
    let center_distance = normal(0.01);
    let scatters = Scatters {
        center_distance,
        ..of_thickness(normal(0.008), normal(0.012))
    };
    let population = Population::new(pair(132.1), scatters).unwrap();
    let at = |thick, distance| closed_form(132.1 + distance, [thick, 0.0]);
    let by_thickness = (at(1e-3, 0.0) - at(-1e-3, 0.0)) / 2e-3;
    let by_distance = (at(0.0, 1e-3) - at(0.0, -1e-3)) / 2e-3;
    let parts = [
        by_thickness * 0.008,
        by_thickness * 0.012,
        by_distance * 0.01,
    ];
    let parts = parts.map(|part| part * part);
    let sum: f64 = parts.iter().sum();
    let (mut inside, mut all) = (0, 0);
    for seed in 0..50 {
        let sums = contribution_sums(&population, seed, 1..513, &go_on).unwrap();
        let [least, greatest] = sums.contributions(population.factors());
        for found in [least, greatest] {
            assert_eq!((found.rows, found.left_out, found.each.len()), (512, 0, 3));
            for (one, part) in found.each.iter().zip(parts) {
                for estimate in [one.first, one.total] {
                    all += 1;
                    inside += u32::from(estimate.admits(part / sum, 2.04));
                    assert!(estimate.admits(part / sum, 5.0), "{seed}: {one:?}");
                }
            }
        }
    }
    assert!(
        f64::from(inside) >= 0.93 * f64::from(all),
        "{inside} of {all}"
    );
}

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
        total: 500,
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
        total: 300,
    };
    for number in 1..=300 {
        let (found, _) = sample.outcome(number).unwrap();
        assert!(found.is_proven && found.least.unwrap() >= least, "{number}");
        assert!(found.greatest.unwrap() <= greatest, "{number}");
    }
}

/// One wheel with a runout of any direction, drawn whole, against a pinion whose high tooth is known, of as many teeth: put together alike,
/// all that varies is the direction, so that its index is 1.
#[test]
fn the_direction_of_whole_gears_contributes() {
    let open = gear(44, Face::Front).with_runout_of_any_direction(0.015);
    let pinion = gear(44, Face::Back).with_runout(0.01, 7.0).unwrap();
    let pair = GearPair::new(gear(44, Face::Front), pinion, 132.1).unwrap();
    let scatters = Scatters {
        wheel: GearScatter {
            gears: Some([open.unwrap()].into()),
            ..GearScatter::default()
        },
        ..Scatters::default()
    };
    let population = Population::new(pair, scatters).unwrap();
    let wheel = Member::Wheel;
    let factors = [Factor::Runout(wheel), Factor::Gear(wheel)];
    assert_eq!(population.factors(), factors);
    let sums = contribution_sums(&population, 1, 1..257, &go_on).unwrap();
    for found in sums.contributions(&factors) {
        let [direction, which] = [found.each[0], found.each[1]];
        assert!(direction.total.admits(1.0, 5.0) && direction.first.admits(1.0, 5.0));
        assert_eq!(which.total.value, 0.0);
    }
}

/// Sums however cut, on any number of threads, forwards and backwards.
#[test]
fn sums_do_not_depend_on_how_they_were_cut() {
    let population = everything();
    let requirement = Requirement::new(Some(0.05), Some(0.4));
    let all = Sample {
        population: &population,
        requirement,
        seed: 11,
        total: 200,
    };
    let whole = sample(&all, 1..201, &go_on).unwrap();
    assert!(
        whole.outside > 0 && whole.outside < 200,
        "{}",
        whole.outside
    );
    let contributions = contribution_sums(&population, 11, 1..41, &go_on).unwrap();
    for cuts in [3u64, 7, 64] {
        let mut tally = Tally::default();
        let mut sums = ContributionSums::new(population.factors().len());
        for k in (0..cuts).rev() {
            let part = 1 + 200 * k / cuts..1 + 200 * (k + 1) / cuts;
            tally.add(&sample(&all, part, &go_on).unwrap()).unwrap();
            let rows = 1 + 40 * k / cuts..1 + 40 * (k + 1) / cuts;
            let part = contribution_sums(&population, 11, rows, &go_on).unwrap();
            sums.add(&part).unwrap();
        }
        assert_eq!((&tally, &sums), (&whole, &contributions), "{cuts}");
    }
    for threads in [1, 2, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        let tally = pool.install(|| sample(&all, 1..201, &go_on).unwrap());
        assert_eq!(tally, whole, "{threads}");
    }
}

/// Closed on the circle, flanks apart, the standard deviation of the single values within four standard errors.
#[test]
fn drawn_pitch_closes_and_has_its_standard_deviation() {
    let population = everything();
    let radius = 45.0;
    let (mut squares, mut count) = (0.0, 0.0);
    for number in 1..=200 {
        let draw = Draw {
            seed: 1,
            run: Run::Population,
            number,
        };
        let assembly = population.assembly(draw).unwrap();
        let wheel = assembly.pair().gear(Member::Wheel);
        // Both flanks of a tooth are turned apart by its thickness: their mean is the pitch's alone.
        let middle = |tooth| {
            let both = Side::BOTH.map(|side| wheel.flank_offset(side, tooth));
            0.5 * radius * (both[0] + both[1])
        };
        let mean: f64 = (1..=30).map(middle).sum::<f64>() / 30.0;
        assert!(mean.abs() < 1e-15, "{mean}");
        for tooth in 1..=30 {
            let single = middle(tooth) - middle(tooth % 30 + 1);
            squares += single * single;
            count += 1.0;
        }
    }
    // Of two independent flanks the mean has σ/√2.
    let sigma = (squares / count).sqrt() / (0.003 / 2f64.sqrt());
    assert!((sigma - 1.0).abs() < 4.0 / (2.0 * count).sqrt(), "{sigma}");
}

/// With play the least is that of the axes nearer by it, the greatest that of the axes farther apart.
#[test]
fn play_of_the_bearings_moves_both_extremes() {
    let scatters = of_thickness(Some(Scatter::table(&[0.01]).unwrap()), None);
    let population = Population::new(pair(132.1), scatters).unwrap();
    let population = population.with_bearing_clearance(0.02);
    let draw = Draw {
        seed: 0,
        run: Run::Population,
        number: 1,
    };
    let found = population.assembly(draw).unwrap().outcome().unwrap();
    let closed = [132.08, 132.12].map(|a| closed_form(a, [0.01, 0.0]));
    assert!((found.least.unwrap() - closed[0]).abs() < 1e-9);
    assert!((found.greatest.unwrap() - closed[1]).abs() < 1e-9);
}

/// Teeth of 5 mm more are pointed: half of them are no gear, and each is counted.
#[test]
fn impossible_gears_are_counted() {
    let scatters = of_thickness(Some(Scatter::table(&[0.0, 5.0]).unwrap()), None);
    let population = Population::new(pair(132.1), scatters).unwrap();
    let requirement = Requirement::new(None, None);
    let all = Sample {
        population: &population,
        requirement,
        seed: 2,
        total: 100,
    };
    let tally = sample(&all, 1..101, &go_on).unwrap();
    let first = tally.first_impossible.unwrap();
    assert!(population.assembly(all.draw(first)).is_err());
    assert!((20..80).contains(&tally.counts.impossible));
    assert_eq!(tally.counts.clear + tally.counts.impossible, 100);
    assert_eq!((tally.outside, tally.below), (tally.counts.impossible, 0));
}

/// Whole gears are drawn each about as often: within five standard errors.
#[test]
fn whole_gears_are_drawn_alike() {
    let thicker = |by: f64| {
        gear(44, Face::Front)
            .varied(by, &Default::default())
            .unwrap()
    };
    let wheel = GearScatter {
        gears: Some([0.0, -0.01, -0.02].map(thicker).into()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: wheel.clone(),
        ..Scatters::default()
    };
    let population = Population::new(pair(132.1), scatters).unwrap();
    assert_eq!(population.factors(), [Factor::Gear(Member::Wheel)]);
    let requirement = Requirement::new(Some(closed_form(132.1, [-0.005, 0.0])), None);
    let all = Sample {
        population: &population,
        requirement,
        seed: 2,
        total: 900,
    };
    let tally = sample(&all, 1..901, &go_on).unwrap();
    assert!((tally.below as f64 - 300.0).abs() < 5.0 * 200f64.sqrt());
    let both = Scatters {
        wheel: GearScatter {
            thickness: normal(0.01),
            ..wheel
        },
        ..Scatters::default()
    };
    let refused = Population::new(pair(132.1), both);
    assert_eq!(refused.unwrap_err(), PopulationError::WholeGears);
}

#[test]
fn scatter_that_cannot_be_is_refused() {
    let refused = |scatters| Population::new(pair(132.1), scatters).unwrap_err();
    assert_eq!(refused(Scatters::default()), PopulationError::Nothing);
    let runout = |scatter| Scatters {
        wheel: GearScatter {
            runout: Some(scatter),
            ..GearScatter::default()
        },
        ..Scatters::default()
    };
    let normal_runout = Scatter::normal(0.02, 0.001).unwrap();
    let negative = Scatter::uniform(-0.01, 0.01).unwrap();
    for scatter in [normal_runout, negative] {
        let error = refused(runout(scatter));
        assert!(matches!(error, PopulationError::Negative { .. }), "{error}");
    }
    let correlated = |thickness_correlation, pinion| Scatters {
        thickness_correlation,
        ..of_thickness(normal(0.01), pinion)
    };
    assert_eq!(
        refused(correlated(0.5, None)),
        PopulationError::NothingToCorrelate
    );
    assert_eq!(
        refused(correlated(1.5, normal(0.01))),
        PopulationError::Correlation(1.5)
    );
}
