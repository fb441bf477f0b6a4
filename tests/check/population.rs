//! Populations against closed forms: perfect gears, whose backlash is linear in thickness.

use super::*;
use gearlash::error::go_on;
use gearlash::outline::{OutlinePair, OutlineReading, of_gear as of_gear_path};
use gearlash::population::{
    AssemblyLimits, Draw, Estimate, Factor, GearScatter, OutcomeKind, Population, PopulationError,
    Sample, SampleKind, Scatter, Scatters, Statistics, TENTHS_NM_PER_MM, Tally, contributions,
    limit_cases,
};
use nalgebra::Point2;

pub(super) fn sample(population: &Population, limits: AssemblyLimits, seed: u64) -> Sample<'_> {
    Sample {
        population,
        requirement: limits,
        seed,
    }
}

/// The sums over the assemblies 1 to `total`.
pub(super) fn sums(sample: &Sample, total: u64) -> Tally {
    let mut tally = Tally::default();
    for row in sample.rows(1..total + 1, &go_on).unwrap() {
        tally.add(&row, total).unwrap();
    }
    tally
}

pub(super) fn drawn(seed: u64, number: u64) -> Draw {
    Draw {
        seed,
        sample: SampleKind::Population,
        number,
    }
}

/// Perfect gears of module 3.
pub(super) fn perfect(teeth: [u32; 2], center_distance: f64) -> GearPair {
    pair(&spur(teeth[0], 3.0), &spur(teeth[1], 3.0), center_distance)
}

/// 44/44 at 132.1 mm.
pub(super) fn rig() -> GearPair {
    perfect([44, 44], 132.1)
}

/// `j_wt`, mm, of perfect 44/44, m 3, 20° whose teeth are thicker by so much, mm at the reference circle.
pub(super) fn closed_form(center_distance: f64, thicker: [f64; 2]) -> f64 {
    kit::j_wt(center_distance, 132.0, -thicker[0] - thicker[1])
}

/// How much `j_wt` changes with the thickness of a gear.
fn slope() -> f64 {
    (closed_form(132.1, [0.01, 0.0]) - closed_form(132.1, [0.0; 2])) / 0.01
}

pub(super) fn of_gear(thickness: Option<Scatter>, runout: Option<Scatter>) -> GearScatter {
    GearScatter {
        thickness,
        runout,
        ..GearScatter::default()
    }
}

pub(super) fn of_thickness(wheel: Option<Scatter>, pinion: Option<Scatter>) -> Scatters {
    Scatters {
        wheel: of_gear(wheel, None),
        pinion: of_gear(pinion, None),
        ..Scatters::default()
    }
}

pub(super) fn of_wheel(wheel: GearScatter) -> Scatters {
    Scatters {
        wheel,
        ..Scatters::default()
    }
}

pub(super) fn normal(sigma: f64) -> Option<Scatter> {
    Some(Scatter::normal(0.0, sigma).unwrap())
}

pub(super) fn within(low: f64, high: f64) -> Option<Scatter> {
    Some(Scatter::uniform(low, high).unwrap())
}

/// Thickness, runout, pitch, distance, play and phase of 30/20.
pub(super) fn everything() -> Population {
    let of = |sigma| GearScatter {
        pitch: Some(0.003),
        per_tooth: within(-0.002, 0.002),
        ..of_gear(normal(sigma), Some(Scatter::rayleigh(0.01).unwrap()))
    };
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        center_distance: Some(Scatter::triangular(-0.02, 0.0, 0.02).unwrap()),
        bearing_clearance: within(0.0, 0.01),
        phase: true,
        thickness_correlation: 0.5,
        ..Scatters::default()
    };
    Population::new(perfect([30, 20], 75.2), scatters).unwrap()
}

/// Moments of a normal population: mean and σ within four standard errors.
#[test]
fn spread_of_thickness_is_the_closed_form() {
    for (thickness_correlation, sigma) in [
        (0.0, 0.02),
        (1.0, 0.028),
        (-1.0, 0.004),
        (0.5, 0.02433105012119288),
    ] {
        let scatters = Scatters {
            thickness_correlation,
            ..of_thickness(normal(0.012), normal(0.016))
        };
        let population = Population::new(rig(), scatters).unwrap();
        let requirement = AssemblyLimits::new(None, None);
        let tally = sums(&sample(&population, requirement, 3), 4000);
        let found = Statistics::of(&tally, &requirement).least;
        let sigma = -slope() * sigma;
        let (mean, root) = (closed_form(132.1, [0.0; 2]), 4000f64.sqrt());
        let what = thickness_correlation;
        near(what, found.mean.unwrap(), mean, 4.0 * sigma / root);
        let share = found.sigma.unwrap() / sigma;
        near(what, share, 1.0, 4.0 / (2f64.sqrt() * root));
    }
}

/// Whether a value differs from an estimate by no more than `errors` standard errors and the rounding of lengths.
fn admits(estimate: &Estimate, value: f64, errors: f64) -> bool {
    (estimate.value - value).abs() <= errors * estimate.error + 1.0 / TENTHS_NM_PER_MM
}

/// Three linear quantities: each index is its share of the sum of squares, both first-order and total (Saltelli et al.
/// 2010, additive case). 2.04 standard errors of 32 groups are 95 %.
#[test]
fn contributions_of_a_linear_case_lie_within_their_errors() {
    let scatters = Scatters {
        center_distance: normal(0.01),
        ..of_thickness(normal(0.008), normal(0.012))
    };
    let population = Population::new(rig(), scatters).unwrap();
    let at = |distance| closed_form(132.1 + distance, [0.0; 2]);
    let by_distance = (at(1e-3) - at(-1e-3)) / 2e-3;
    let parts = [slope() * 0.008, slope() * 0.012, by_distance * 0.01].map(|part| part * part);
    let sum: f64 = parts.iter().sum();
    let (mut inside, mut all) = (0, 0);
    for seed in 0..20 {
        for found in contributions(&population, seed, 512, &go_on).unwrap() {
            let counts = (found.rows, found.unused_rows, found.each.len());
            assert_eq!(counts, (512, 0, 3));
            for (one, part) in found.each.iter().zip(parts) {
                for estimate in [one.first, one.total] {
                    all += 1;
                    inside += u32::from(admits(&estimate, part / sum, 2.04));
                    assert!(admits(&estimate, part / sum, 5.0), "{seed}: {one:?}");
                }
            }
        }
    }
    let share = f64::from(inside) / f64::from(all);
    assert!(share >= 0.93, "{inside} of {all}");
}

/// One wheel with a runout of any direction, drawn whole, against a pinion with the same number of teeth and a known
/// high tooth. Assembled in one phase, only the direction varies, so its index is 1.
#[test]
fn the_direction_of_whole_gears_contributes() {
    let open = spur(44, 3.0).front().with_runout(0.015, None);
    let pair = pair(&spur(44, 3.0), &spur(44, 3.0).runout(0.01, 7.0), 132.1);
    let scatters = of_wheel(GearScatter {
        gears: Some([open.unwrap()].into()),
        ..GearScatter::default()
    });
    let population = Population::new(pair, scatters).unwrap();
    let wheel = Member::Wheel;
    let factors = [Factor::Runout(wheel), Factor::Gear(wheel)];
    assert_eq!(population.factors(), factors);
    for found in contributions(&population, 1, 256, &go_on).unwrap() {
        let [direction, which] = [found.each[0], found.each[1]];
        assert!(admits(&direction.total, 1.0, 5.0) && admits(&direction.first, 1.0, 5.0));
        assert_eq!(which.total.value, 0.0);
    }
}

/// Rows however cut, counted backwards, on any number of threads.
#[test]
fn sums_do_not_depend_on_how_their_rows_were_cut() {
    let population = everything();
    let all = sample(&population, AssemblyLimits::new(Some(0.05), Some(0.4)), 11);
    let whole = sums(&all, 200);
    assert!((1..200).contains(&whole.outside), "{}", whole.outside);
    let contributed = contributions(&population, 11, 40, &go_on).unwrap();
    for cuts in [3u64, 7, 64] {
        let mut tally = Tally::default();
        for k in (0..cuts).rev() {
            let range = 1 + 200 * k / cuts..1 + 200 * (k + 1) / cuts;
            for row in all.rows(range, &go_on).unwrap().iter().rev() {
                tally.add(row, 200).unwrap();
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
    let population = Population::new(rig(), scatters).unwrap();
    let population = population.with_bearing_clearance(0.02);
    let found = population.assembly(drawn(0, 1)).unwrap().outcome().unwrap();
    let [least, greatest] = [132.08, 132.12].map(|a| closed_form(a, [0.01, 0.0]));
    near("least", found.least.unwrap(), least, 1e-9);
    near("greatest", found.greatest.unwrap(), greatest, 1e-9);
}

/// A pair of outlines scatters as the same pair by data: each assembly has the same extremes, and the limits are the same. Source: the exact
/// method's extremes of the gears by data.
#[test]
fn outlines_scatter_as_their_data() {
    let by_data = perfect([20, 20], 60.3);
    let outline = |member| OutlineGear::from(by_data.gear(member));
    let (wheel, pinion) = (outline(Member::Wheel), outline(Member::Pinion));
    let by_outline = OutlinePair::new(wheel, pinion, 60.3, Member::Wheel).unwrap();
    let axes = || Scatters {
        center_distance: normal(0.02),
        bearing_clearance: within(0.0, 0.01),
        ..Scatters::default()
    };
    let all = || Scatters {
        wheel: of_gear(None, within(0.0, 0.05)),
        pinion: of_gear(None, within(0.0, 0.03)),
        ..axes()
    };
    let populations = [
        Population::new(by_data.clone(), all()).unwrap(),
        Population::new(by_outline.clone(), all()).unwrap(),
    ];
    let rows = populations.each_ref().map(|population| {
        let sample = sample(population, AssemblyLimits::new(None, None), 3);
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
    let [data, outlines] = [
        Population::new(by_data, axes()).unwrap(),
        Population::new(by_outline.clone(), axes()).unwrap(),
    ]
    .map(|population| limit_cases(&population).unwrap().unwrap().worst);
    for (data, outline) in data.into_iter().zip(outlines) {
        near("worst", outline.unwrap(), data.unwrap(), 5e-5);
    }
    let refused = Population::new(by_outline, of_thickness(normal(0.01), None)).unwrap_err();
    assert_eq!(refused, PopulationError::Drawn);
}

/// Teeth thicker by `t cos α` along the normals are thicker by `t` at the reference circle. Source: the same pair by data.
#[test]
fn drawn_teeth_scatter_in_thickness_as_those_of_data() {
    let by_data = perfect([20, 20], 60.3);
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: Face::Front,
        teeth: Some(20),
        first_tooth: None,
        bound: 1e-5,
    };
    let [wheel, pinion] = Member::BOTH.map(|member| {
        let path = of_gear_path(by_data.gear(member), reading.bound);
        OutlineGear::new(&path, &reading).unwrap()
    });
    let by_outline = OutlinePair::new(wheel, pinion, 60.3, Member::Wheel).unwrap();
    let thicker = |share: f64| {
        let each = || within(-0.03 * share, 0.01 * share);
        of_thickness(each(), each())
    };
    let populations = [
        Population::new(by_data, thicker(1.0)).unwrap(),
        Population::new(by_outline, thicker(20f64.to_radians().cos())).unwrap(),
    ];
    let [data, drawn] = populations.each_ref().map(|population| {
        let each = (1..4).map(|number| population.assembly(drawn(1, number)).unwrap());
        let each = each.map(|assembly| assembly.outcome().unwrap());
        let each = each.flat_map(|found| [found.least, found.greatest]);
        let worst = limit_cases(population).unwrap().unwrap().worst;
        each.chain(worst).map(Option::unwrap).collect::<Vec<f64>>()
    });
    for (drawn, data) in drawn.into_iter().zip(data) {
        near("least or greatest", drawn, data, 1.5e-4);
    }
}

/// Closed on the circle, flanks apart, the standard deviation of the single values within four standard errors.
#[test]
fn drawn_pitch_closes_and_has_its_standard_deviation() {
    let population = everything();
    let radius = 45.0;
    let (mut squares, mut count) = (0.0, 0.0);
    for number in 1..=200 {
        let assembly = population.assembly(drawn(1, number)).unwrap();
        let wheel = assembly.pair.data().unwrap().gear(Member::Wheel);
        // Both flanks of a tooth are turned apart by its thickness: their mean is the pitch's alone.
        let middle = |tooth| {
            let both = Side::BOTH.map(|side| wheel.flank_offset(side, tooth));
            0.5 * radius * (both[0] + both[1])
        };
        let mean: f64 = (1..=30).map(middle).sum::<f64>() / 30.0;
        near("mean", mean, 0.0, 1e-15);
        for tooth in 1..=30 {
            let single = middle(tooth) - middle(tooth % 30 + 1);
            squares += single * single;
            count += 1.0;
        }
    }
    // The mean of two independent flanks has σ/√2.
    let sigma = (squares / count).sqrt() / (0.003 / 2f64.sqrt());
    near("σ", sigma, 1.0, 4.0 / (2.0 * count).sqrt());
}

/// Teeth of 5 mm more are pointed: half of them are no gear, and each is counted.
#[test]
fn impossible_gears_are_counted() {
    let scatters = of_thickness(Some(Scatter::table(&[0.0, 5.0]).unwrap()), None);
    let population = Population::new(rig(), scatters).unwrap();
    let all = sample(&population, AssemblyLimits::new(None, None), 2);
    let tally = sums(&all, 100);
    let first = tally.first_impossible.unwrap();
    assert!(population.assembly(all.draw(first)).is_err());
    assert!((20..80).contains(&tally.outside));
    let [clear, impossible] =
        [OutcomeKind::Clear, OutcomeKind::Impossible].map(|kind| tally.counts.of(kind));
    assert_eq!(clear + impossible, 100);
    assert_eq!((tally.outside, tally.below), (impossible, 0));
}

/// Each about as often: within five standard errors.
#[test]
fn whole_gears_are_drawn_alike() {
    let thinner = [0.0, -0.01, -0.02].map(|by| spur(44, 3.0).allowance(by).front());
    let wheel = GearScatter {
        gears: Some(thinner.into()),
        ..GearScatter::default()
    };
    let population = Population::new(rig(), of_wheel(wheel.clone())).unwrap();
    assert_eq!(population.factors(), [Factor::Gear(Member::Wheel)]);
    let requirement = AssemblyLimits::new(Some(closed_form(132.1, [-0.005, 0.0])), None);
    let tally = sums(&sample(&population, requirement, 2), 900);
    near("below", tally.below as f64, 300.0, 5.0 * 200f64.sqrt());
    let both = of_wheel(GearScatter {
        thickness: normal(0.01),
        ..wheel
    });
    let refused = Population::new(rig(), both);
    assert_eq!(refused.unwrap_err(), PopulationError::WholeGears);
}

#[test]
fn scatter_that_cannot_be_is_refused() {
    let refused = |scatters| Population::new(rig(), scatters).unwrap_err();
    assert_eq!(refused(Scatters::default()), PopulationError::Nothing);
    let normal_runout = Scatter::normal(0.02, 0.001).ok();
    for runout in [normal_runout, within(-0.01, 0.01)] {
        let error = refused(of_wheel(of_gear(None, runout)));
        assert!(matches!(error, PopulationError::Negative { .. }), "{error}");
    }
    let correlated = |thickness_correlation, pinion| Scatters {
        thickness_correlation,
        ..of_thickness(normal(0.01), pinion)
    };
    let nothing = refused(correlated(0.5, None));
    assert_eq!(nothing, PopulationError::NothingToCorrelate);
    let too_much = refused(correlated(1.5, normal(0.01)));
    assert_eq!(too_much, PopulationError::Correlation(1.5));
}
