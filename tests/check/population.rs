//! Populations against closed forms: perfect gears, whose backlash is linear in thickness.
//!
//! `j_wt = p_w − s_w1 − s_w2` with `s_w = 2 r_w (s_b/(2 r_b) − inv α_wt)` (ISO 21771).

use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, involute, thickness as shop};
use gearlash::outline::{OutlineGear, OutlinePair};
use gearlash::pair::{GearPair, Member};
use gearlash::population::{
    Draw, Factor, GearScatter, Population, PopulationError, Requirement, Run, Sample, Scatter,
    Scatters, Statistics, Tally, contributions, limit_cases,
};
use std::ops::ControlFlow;

pub(super) fn go_on() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// The sums over the assemblies 1 to `total`.
pub(super) fn sums(sample: &Sample, total: u64) -> Tally {
    let mut tally = Tally::default();
    for row in sample.rows(1..total + 1, &go_on).unwrap() {
        tally.count(&row, total).unwrap();
    }
    tally
}

pub(super) fn gear(teeth: u32, face: Face) -> AsBuilt {
    let basic_data = BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap();
    let gear = Gear::nominal(GearDesign::standard(basic_data)).unwrap();
    AsBuilt::perfect(gear, face)
}

pub(super) fn pair(center_distance: f64) -> GearPair {
    GearPair::new(gear(44, Face::Front), gear(44, Face::Back), center_distance).unwrap()
}

/// `j_wt`, mm, of perfect 44/44, m 3, 20° whose teeth are thicker by so much, mm at the reference circle.
pub(super) fn closed_form(center_distance: f64, thicker: [f64; 2]) -> f64 {
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

pub(super) fn of_thickness(wheel: Option<Scatter>, pinion: Option<Scatter>) -> Scatters {
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

pub(super) fn normal(sigma: f64) -> Option<Scatter> {
    Some(Scatter::normal(0.0, sigma).unwrap())
}

/// Thickness, runout, pitch, distance, play and phase of 30/20.
pub(super) fn everything() -> Population {
    let of = |sigma| GearScatter {
        thickness: normal(sigma),
        runout: Some(Scatter::rayleigh(0.01).unwrap()),
        pitch: Some(0.003),
        per_tooth: Some(Scatter::uniform(-0.002, 0.002).unwrap()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        center_distance: Some(Scatter::triangular(-0.02, 0.0, 0.02).unwrap()),
        bearing_play: Some(Scatter::uniform(0.0, 0.01).unwrap()),
        phase: true,
        thickness_correlation: 0.5,
        ..Scatters::default()
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
        };
        let tally = sums(&all, 400);
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
        };
        let tally = sums(&all, 4000);
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

/// Three linear quantities: each index is its share of the sum of squares, both first-order and total (Saltelli et al.
/// 2010, additive case). 2.04 standard errors of 32 groups are 95 %.
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
        let [least, greatest] = contributions(&population, seed, 512, &go_on).unwrap();
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

/// One wheel with a runout of any direction, drawn whole, against a pinion with the same number of teeth and a known
/// high tooth. Assembled in one phase, only the direction varies, so its index is 1.
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
    for found in contributions(&population, 1, 256, &go_on).unwrap() {
        let [direction, which] = [found.each[0], found.each[1]];
        assert!(direction.total.admits(1.0, 5.0) && direction.first.admits(1.0, 5.0));
        assert_eq!(which.total.value, 0.0);
    }
}

/// Rows however cut, counted backwards, on any number of threads.
#[test]
fn sums_do_not_depend_on_how_their_rows_were_cut() {
    let population = everything();
    let all = Sample {
        population: &population,
        requirement: Requirement::new(Some(0.05), Some(0.4)),
        seed: 11,
    };
    let whole = sums(&all, 200);
    assert!(
        whole.outside > 0 && whole.outside < 200,
        "{}",
        whole.outside
    );
    let contributed = contributions(&population, 11, 40, &go_on).unwrap();
    for cuts in [3u64, 7, 64] {
        let mut tally = Tally::default();
        for k in (0..cuts).rev() {
            let range = 1 + 200 * k / cuts..1 + 200 * (k + 1) / cuts;
            for row in all.rows(range, &go_on).unwrap().iter().rev() {
                tally.count(row, 200).unwrap();
            }
        }
        assert_eq!(tally, whole, "{cuts}");
    }
    for threads in [1, 2, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        let tally = pool.install(|| sums(&all, 200));
        assert_eq!(tally, whole, "{threads}");
        let again = pool.install(|| contributions(&population, 11, 40, &go_on).unwrap());
        assert_eq!(again, contributed, "{threads}");
    }
}

/// With play the least is that of the axes nearer by it, the greatest that of the axes further apart by it.
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

/// A pair of outlines scatters as the same pair by data: each assembly has the same extremes, and the limits are the same. Source: the exact
/// method's extremes of the gears by data.
#[test]
fn outlines_scatter_as_their_data() {
    let by_data = GearPair::new(gear(20, Face::Front), gear(20, Face::Back), 60.3).unwrap();
    let outline = |member| OutlineGear::from(by_data.gear(member));
    let (wheel, pinion) = (outline(Member::Wheel), outline(Member::Pinion));
    let drawn = OutlinePair::new(wheel, pinion, 60.3, Member::Wheel).unwrap();
    let axes = || Scatters {
        center_distance: Some(Scatter::normal(0.0, 0.02).unwrap()),
        bearing_play: Some(Scatter::uniform(0.0, 0.01).unwrap()),
        ..Scatters::default()
    };
    let runout = |highest| GearScatter {
        runout: Some(Scatter::uniform(0.0, highest).unwrap()),
        ..GearScatter::default()
    };
    let all = || Scatters {
        wheel: runout(0.05),
        pinion: runout(0.03),
        ..axes()
    };
    let populations = [
        Population::new(by_data.clone(), all()).unwrap(),
        Population::new(drawn.clone(), all()).unwrap(),
    ];
    let rows = populations.each_ref().map(|population| {
        let sample = Sample {
            population,
            requirement: Requirement::new(None, None),
            seed: 3,
        };
        sample.rows(1..5, &go_on).unwrap()
    });
    // Tenths of a nanometre: proven brackets of outlines are 50 nm wide.
    let is_near =
        |one: Option<i64>, other: Option<i64>| (one.unwrap() - other.unwrap()).abs() < 500;
    for (data, drawn) in rows[0].iter().zip(&rows[1]) {
        assert!(drawn.is_proven && data.kind == drawn.kind, "{drawn:?}");
        assert!(is_near(data.least, drawn.least), "{data:?} {drawn:?}");
        assert!(is_near(data.greatest, drawn.greatest), "{data:?} {drawn:?}");
    }
    assert_eq!(limit_cases(&populations[1]).unwrap(), None);
    let limits = [
        limit_cases(&Population::new(by_data, axes()).unwrap()),
        limit_cases(&Population::new(drawn.clone(), axes()).unwrap()),
    ];
    let [data, outlines] = limits.map(|found| found.unwrap().unwrap());
    for (data, outline) in data.worst.iter().zip(&outlines.worst) {
        assert!((data.unwrap() - outline.unwrap()).abs() < 5e-5);
    }
    let thickness = of_thickness(Some(Scatter::normal(0.0, 0.01).unwrap()), None);
    let refused = Population::new(drawn, thickness).unwrap_err();
    assert_eq!(refused, PopulationError::Drawn);
}
