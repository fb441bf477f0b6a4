//! Requirements on each assembly of a population, compared with the verdict of the same pair alone.

use super::population::sums;
use gearlash::analysis::extremes::extremes;
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::study::Study;
use gearlash::analysis::verdict::{Requirement as Kept, Verdict};
use gearlash::contact::Method;
use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
use gearlash::pair::{GearPair, Member, SweepPlan};
use gearlash::population::{
    Draw, GearScatter, OutcomeKind, Population, Requirement, Run, Sample, Scatter, Scatters,
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

/// 30/20 with thickness, runout, centre distance, play and phase drawn.
fn population() -> Population {
    let of = |sigma| GearScatter {
        thickness: Some(Scatter::normal(0.0, sigma).unwrap()),
        runout: Some(Scatter::rayleigh(0.01).unwrap()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        center_distance: Some(Scatter::triangular(-0.02, 0.0, 0.02).unwrap()),
        bearing_play: Some(Scatter::uniform(0.002, 0.01).unwrap()),
        phase: true,
        ..Scatters::default()
    };
    let pair = GearPair::new(gear(30, Face::Front), gear(20, Face::Back), 75.2).unwrap();
    Population::new(pair, scatters).unwrap()
}

const QUANTITIES: [Quantity; 7] = [
    Quantity::OperatingBacklash,
    Quantity::ReferenceBacklash,
    Quantity::NormalBacklash,
    Quantity::RadialBacklash,
    Quantity::LostMotion(Member::Wheel),
    Quantity::LostMotion(Member::Pinion),
    Quantity::RadialClearance,
];

fn limited(quantity: Quantity, limit: f64, is_max: bool) -> (Quantity, Limits) {
    let limits = if is_max {
        Limits {
            min: None,
            max: Some(limit),
        }
    } else {
        Limits {
            min: Some(limit),
            max: None,
        }
    };
    (quantity, limits)
}

/// Limits 0.1 µm (or the lost motion of as much) to either side of what an assembly has, whose bracket is 0.001 µm wide: whatever is limited, the
/// verdict of that pair alone says the same.
#[test]
fn every_requirement_is_judged_as_the_verdict_of_the_pair_judges_it() {
    let population = population();
    for number in 1..=6 {
        let draw = Draw {
            seed: 3,
            run: Run::Population,
            number,
        };
        let assembly = population.assembly(draw).unwrap();
        let outcome = assembly.outcome().unwrap();
        assert_eq!(outcome.kind, OutcomeKind::Clear);
        let (pair, play) = (assembly.pair().data().unwrap(), assembly.clearance());
        let at = |farther: f64| pair.at(pair.center_distance() + farther).unwrap();
        let [near, far] = [at(-play), at(play)];
        let start = (1, assembly.phase());
        let study = Study {
            bearing_clearance: play,
            sweep: Some(SweepPlan::wheel_revolution(pair, 1, start)),
            ..Study::of_pair("alone", pair, 1)
        };
        let method = Method::Exact { certify: false };
        let found = extremes(&study, method, &go_on).unwrap();
        for quantity in QUANTITIES {
            let least = quantity.value(&near, outcome.least.unwrap(), false);
            let greatest = quantity.value(&far, outcome.greatest.unwrap(), true);
            let hair = match quantity {
                Quantity::LostMotion(member) => 1e-4 / pair.operating_pitch_radius(member),
                _ => 1e-4,
            };
            for (value, is_max) in [(least, false), (greatest, true)] {
                for by in [-hair, hair] {
                    let required = vec![limited(quantity, value + by, is_max)];
                    let verdict = Verdict::new(&found.each, &required, None, Vec::new());
                    let missed = verdict.requirement == Kept::NotMet;
                    let told = format!("{number} {quantity:?} {is_max} {by}");
                    assert_eq!(missed, (by < 0.0) == is_max, "{told}");
                    let standing = Requirement::of(&required).standing(&assembly, &outcome);
                    assert_eq!(standing.below, missed && !is_max, "{told}");
                    assert_eq!(standing.above, missed && is_max, "{told}");
                }
            }
        }
    }
}

/// `j_bn = j_wt cos α_wt` and the like: at one centre distance a limit of each backlash is one of `j_wt`, and the same assemblies miss it.
#[test]
fn a_limit_in_another_unit_is_missed_by_the_same_assemblies() {
    let of = |sigma| GearScatter {
        thickness: Some(Scatter::normal(0.0, sigma).unwrap()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: of(0.01),
        pinion: of(0.02),
        ..Scatters::default()
    };
    let pair = GearPair::new(gear(30, Face::Front), gear(20, Face::Back), 75.2).unwrap();
    let population = Population::new(pair.clone(), scatters).unwrap();
    let tally = |required| {
        let all = Sample {
            population: &population,
            requirement: Requirement::of(&required),
            seed: 8,
        };
        sums(&all, 300)
    };
    for (limit, is_max) in [(0.12, false), (0.16, true)] {
        let wanted = tally(vec![limited(Quantity::OperatingBacklash, limit, is_max)]);
        assert!((10..290).contains(&wanted.outside), "{}", wanted.outside);
        for quantity in QUANTITIES.into_iter().take(6) {
            let value = quantity.value(&pair, limit, is_max);
            let found = tally(vec![limited(quantity, value, is_max)]);
            let counted = [&wanted, &found].map(|all| (all.below, all.above, all.outside));
            assert_eq!(counted[0], counted[1], "{quantity:?}");
        }
    }
    // Thinner teeth have deeper roots: a − r_a − r_f of each gear's tip in its mate's root, the least of both.
    let clearance = |number| {
        let draw = Draw {
            seed: 8,
            run: Run::Population,
            number,
        };
        let assembly = population.assembly(draw).unwrap();
        let [wheel, pinion] = [Member::Wheel, Member::Pinion]
            .map(|member| assembly.pair().data().unwrap().gear(member).gear());
        let distance = assembly.pair().center_distance();
        let ends = [
            distance - wheel.tip_radius() - pinion.root_radius(),
            distance - pinion.tip_radius() - wheel.root_radius(),
        ];
        ends[0].min(ends[1])
    };
    let limit = Quantity::RadialClearance.value(&pair, 0.0, false);
    let below = (1..=300)
        .filter(|&number| clearance(number) < limit)
        .count() as u64;
    assert!((10..290).contains(&below), "{below}");
    for (is_max, missed) in [(false, below), (true, 300 - below)] {
        let found = tally(vec![limited(Quantity::RadialClearance, limit, is_max)]);
        assert_eq!(found.outside, missed);
    }
}
