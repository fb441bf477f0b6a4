//! Draws of a population: their frequency and width as specified, and no impossible values.

use super::population::{closed_form, everything, gear, normal, of_thickness, pair, sums};
use gearlash::gear::{Face, Side};
use gearlash::pair::Member;
use gearlash::population::{
    Draw, Factor, GearScatter, Population, PopulationError, Requirement, Run, Sample, Scatter,
    Scatters,
};

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
        let wheel = assembly.pair().data().unwrap().gear(Member::Wheel);
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
    // The mean of two independent flanks has σ/√2.
    let sigma = (squares / count).sqrt() / (0.003 / 2f64.sqrt());
    assert!((sigma - 1.0).abs() < 4.0 / (2.0 * count).sqrt(), "{sigma}");
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
    };
    let tally = sums(&all, 100);
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
    };
    let tally = sums(&all, 900);
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
