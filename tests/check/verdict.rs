//! The verdict over several runs: runs of one pair, with their extremes set by hand.

use super::*;
use gearlash::analysis::assembles_from::Threshold;
use gearlash::analysis::extremes::{CoveredPhases, WIDTH, extremes_of_phase, run_count};

const HIGH: [(f64, f64); 2] = [(0.01, 1.0), (0.02, 3.0)];

fn run() -> RunExtremes {
    let run = extremes_of(&eccentric(113.0, HIGH, 31));
    assert!(run.is_proven() && run.status == Status::Clear);
    run
}

/// A run with this bracket of the least, its lower end attained.
fn with_least(run: &RunExtremes, [low, high]: [f64; 2]) -> RunExtremes {
    let mut run = run.clone();
    let least = run.least.as_mut().unwrap();
    (least.low, least.high, least.pose.simulated.backlash) = (low, high, Some(low));
    run
}

fn with_status(run: &RunExtremes, status: Status) -> RunExtremes {
    RunExtremes {
        status,
        ..run.clone()
    }
}

fn said(runs: &[RunExtremes]) -> Verdict<'_> {
    Verdict::new(runs, &Vec::new(), None, Vec::new())
}

/// Jammed or out of mesh it does not assemble, nor with all of the bracket below 0. With its lower end not below 0 by more than brackets are wide it does.
/// Else nothing is known.
#[test]
fn a_run_assembles_by_the_bracket_of_its_least() {
    let run = run();
    for (bracket, assembles) in [
        ([0.1, 0.1], Some(true)),
        ([0.0, 0.0], Some(true)),
        ([-0.5 * WIDTH, 0.5 * WIDTH], Some(true)),
        ([-WIDTH, 0.0], Some(true)),
        ([-2.0 * WIDTH, 0.0], None),
        ([-0.1, 0.1], None),
        ([-0.1, -1e-9], Some(false)),
    ] {
        let one = with_least(&run, bracket);
        let interferes = with_status(&one, Status::Interference);
        for one in [&one, &interferes] {
            assert_eq!(one.assembles(), assembles, "{bracket:?}");
        }
        // The bracket decides alone, however wide it is.
        let mut unbounded = one.clone();
        let least = unbounded.least.as_mut().unwrap();
        (least.low, least.doubt) = (f64::NEG_INFINITY, Some(Doubt::OffInvolute));
        let known = assembles.filter(|assembles| !assembles);
        assert_eq!(unbounded.assembles(), known, "{bracket:?}");
        assert!(!unbounded.is_proven() && !unbounded.least.unwrap().holds());
        for status in [Status::Jammed, Status::NoContact] {
            assert_eq!(with_status(&one, status).assembles(), Some(false));
        }
    }
    let mut none = RunExtremes { least: None, ..run };
    assert_eq!(none.assembles(), None);
    none.greatest.as_mut().unwrap().high += 2.0 * WIDTH;
    assert!(!none.is_proven());
}

/// All assemble, or one does not, or nothing is proven; and of nothing that was run nothing is.
#[test]
fn a_pair_assembles_if_every_run_does() {
    let run = run();
    let yes = with_least(&run, [0.1, 0.1]);
    let no = with_least(&run, [-0.1, -0.1]);
    let unknown = with_least(&run, [-0.1, 0.1]);
    for (runs, assembles, state) in [
        (vec![], None, CheckVerdict::Unproven),
        (vec![&yes], Some(true), CheckVerdict::Pass),
        (vec![&yes, &yes], Some(true), CheckVerdict::Pass),
        (vec![&yes, &unknown], None, CheckVerdict::Unproven),
        (vec![&unknown, &no], Some(false), CheckVerdict::Fail),
        (vec![&no, &yes], Some(false), CheckVerdict::Fail),
    ] {
        let runs: Vec<RunExtremes> = runs.into_iter().cloned().collect();
        let said = said(&runs);
        assert_eq!((said.assembles(), said.state()), (assembles, state));
        let most = if runs.is_empty() { 0 } else { 44 * 31 };
        assert_eq!(said.matings(), most);
    }
}

/// Among runs that differ by less than the width of brackets, the first; otherwise the one with the least, or the greatest, backlash.
#[test]
fn the_foremost_run_is_the_first_of_equals() {
    let run = run();
    let at = |low: f64| {
        let mut run = with_least(&run, [low, low]);
        run.greatest.as_mut().unwrap().pose.simulated.backlash = Some(low);
        run
    };
    let little = 0.9 * WIDTH;
    let more = 1.1 * WIDTH;
    for (backlashes, is_max, which) in [
        ([0.2, 0.1, 0.3], false, 1),
        ([0.2, 0.1, 0.3], true, 2),
        ([0.1 + little, 0.1, 0.3], false, 0),
        ([0.3, 0.1, 0.3 + little], true, 0),
        ([0.1 + more, 0.1, 0.3], false, 1),
        ([-0.3, -0.2, -0.3 - more], false, 2),
    ] {
        let runs = backlashes.map(at);
        let said = said(&runs);
        let both = [said.least(), said.greatest()];
        let (found, _) = both[usize::from(is_max)].unwrap();
        let is_it = std::ptr::eq(found, &runs[which]);
        assert!(is_it, "{backlashes:?} {is_max}");
    }
    // A pose without a value leaves the value that the search attained.
    let mut open = with_least(&run, [0.1, 0.3]);
    let least = open.least.as_mut().unwrap();
    (least.pose.simulated.backlash, least.found) = (None, 0.2);
    assert_eq!(least.found(), 0.2);
    // The worst is the least, or before it a jammed pose.
    let runs = [at(0.2), at(0.1)];
    let worst = said(&runs).worst().unwrap();
    assert!(std::ptr::eq(worst.0, &runs[1]) && worst.2.simulated.backlash == Some(0.1));
    let jammed = extremes_of(&eccentric(110.0, HIGH, 31));
    assert_eq!(jammed.status, Status::Jammed);
    let runs = [at(0.2), jammed];
    let worst = said(&runs).worst().unwrap();
    assert!(std::ptr::eq(worst.0, &runs[1]) && worst.2.simulated.backlash.is_none());
}

/// The greatest distance from which a run that jams assembles, and the least up to which one out of mesh is in mesh. None where one has none.
#[test]
fn distances_are_of_all_runs_that_fail() {
    let run = run();
    let between = |low, high| Threshold {
        low,
        high,
        doubt: None,
        mating: Mating::FIRST,
    };
    let failing = |high: Option<f64>| RunExtremes {
        assembles_from: high.map(|high| between(high - WIDTH, high)),
        ..with_status(&run, Status::Jammed)
    };
    let apart = |low: Option<f64>| RunExtremes {
        meshes_to: low.map(|low| between(low, low + WIDTH)),
        ..with_status(&run, Status::NoContact)
    };
    let (clear, other) = (run.clone(), apart(Some(140.0)));
    let from = |runs: &[RunExtremes]| said(runs).assembles_from().map(|from| from.high);
    let to = |runs: &[RunExtremes]| said(runs).meshes_to().map(|to| to.low);
    let [near, far, never] = [Some(133.0), Some(134.0), None].map(failing);
    let [apart_more, apart_never] = [Some(141.0), None].map(apart);
    let not_assembled = with_least(&near, [-0.1, -0.1]);
    for (runs, assembles_from, meshes_to) in [
        (vec![&near, &far, &clear], Some(134.0), None),
        (vec![&far, &near, &other], Some(134.0), Some(140.0)),
        (vec![&far, &never], None, None),
        (vec![&clear, &other], None, Some(140.0)),
        (vec![&not_assembled], Some(133.0), None),
        (vec![&apart_more, &other, &near], Some(133.0), Some(140.0)),
        (vec![&other, &apart_more, &clear], None, Some(140.0)),
        (vec![&other, &apart_never], None, None),
    ] {
        let runs: Vec<RunExtremes> = runs.into_iter().cloned().collect();
        assert_eq!(from(&runs), assembles_from);
        assert_eq!(to(&runs), meshes_to);
    }
}

/// A limit is met where the whole bracket keeps it, not met where the whole bracket misses it, and else not proven.
#[test]
fn a_limit_is_met_missed_or_not_proven() {
    let runs = [with_least(&run(), [0.1, 0.2])];
    for (min, requirement) in [
        (0.05, RequirementOutcome::Met),
        (0.1, RequirementOutcome::Met),
        (0.15, RequirementOutcome::NotProven),
        (0.2, RequirementOutcome::NotProven),
        (0.3, RequirementOutcome::NotMet),
    ] {
        let (min, max) = (Some(min), None);
        let limits = Limits { min, max };
        let required = vec![(Quantity::OperatingBacklash, limits)];
        let said = Verdict::new(&runs, &required, None, Vec::new());
        assert_eq!(said.requirement, requirement, "{min:?}");
        let missed = said.unmet.first().map(|unmet| unmet.is_missed);
        let expected = (requirement != RequirementOutcome::Met)
            .then_some(requirement == RequirementOutcome::NotMet);
        assert_eq!(missed, expected, "{min:?}");
    }
    assert_eq!(said(&runs).requirement, RequirementOutcome::None);
}

/// Runs of a study: one for all phases where a gear has like teeth, else one for each that its matings are of; a run of one phase is what the search of
/// that phase finds. Source: least common multiples.
#[test]
fn a_study_has_a_run_for_each_phase_that_differs() {
    let gear = |teeth: u32, pitch_um: f64, eccentricity| {
        let wave = (0..teeth).map(|k| 1e-3 * pitch_um * f64::from(k * 7 % 5));
        let wave: Vec<f64> = wave.collect();
        let gear = spur(teeth, 2.0).runout(eccentricity, 2.0);
        if pitch_um > 0.0 {
            gear.pitch(&wave, &wave)
        } else {
            gear
        }
    };
    for (pitches, eccentricity, like, phases) in [
        // 24 and 18 teeth meet in 72 of 432 pairs: six phases.
        ([3.0, 2.0], 0.01, false, 6),
        ([3.0, 0.0], 0.0, false, 1),
        ([0.0, 0.0], 0.0, true, 1),
    ] {
        let [wheel, pinion] =
            [(24, pitches[0]), (18, pitches[1])].map(|(teeth, um)| gear(teeth, um, eccentricity));
        let pair = pair(&wheel, &pinion, 42.3);
        let mut study = Study::of_pair("phases", &pair, 1);
        study.sweep = Some(SweepPlan::Matings {
            matings: (1..=18).map(|tooth| (1, tooth)).collect(),
            fractions: vec![0.0, 0.3, 0.6],
        });
        assert_eq!(study.pose_count(), 108);
        assert_eq!(run_count(&study).unwrap(), phases, "{pitches:?}");
        let found = runs_of(&study, false);
        assert_eq!(found.len() as u64, phases);
        for (k, run) in (1..).zip(&found) {
            assert_eq!(run.has_like_teeth(), like);
            assert!(!run.any_direction());
            assert_eq!(run.matings, 72);
            assert_eq!(run.phase, (phases > 1).then_some((1, k)));
            let alone = extremes_of_phase(&pair.clone().into(), k, WIDTH).unwrap();
            assert_eq!(alone.least.unwrap().low, run.least.as_ref().unwrap().low);
        }
    }
}

/// 24/24 teeth, both with a runout of 30 µm: 102.01 … 151.61 µm over all 24 phases, 125.12 … 128.37 µm in the first. Source: an independent program.
#[test]
fn extremes_are_of_every_assembly_phase_or_of_those_listed() {
    let gear = |allowance, high| {
        let gear = spur(24, 2.0).shift(0.2).allowance(allowance);
        gear.runout(0.015, high)
    };
    let pair = pair(&gear(-0.05, 1.0), &gear(-0.04, 13.0), 48.8);
    let mut study = Study::of_pair("phases", &pair, 1);
    for (all_phases, expected, phases) in [
        (true, [102.01, 151.61], CoveredPhases::All),
        (false, [125.12, 128.37], CoveredPhases::Some(vec![(1, 1)])),
    ] {
        study.all_phases = all_phases;
        let found = runs_of(&study, false);
        assert_eq!(CoveredPhases::of(&found), phases);
        let verdict = said(&found);
        let ends = [verdict.least(), verdict.greatest()];
        for (end, expected) in ends.into_iter().zip(expected) {
            near(all_phases, 1e3 * end.unwrap().1.found(), expected, 0.006);
        }
    }
}
