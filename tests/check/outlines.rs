//! Outlines through a mesh cycle against the proven extremes of the same gears, and the uncertainty of an extreme.

use super::*;
use gearlash::analysis::backlash_map::BacklashMap;
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::error::go_on;

fn study_of(pair: &GearPair) -> Study {
    let [wheel, pinion] = Member::BOTH.map(|member| OutlineGear::from(pair.gear(member)));
    let gears = vec![(Material::AsMeasured, wheel, pinion)];
    let sweep = SweepPlan::hunting_cycle(pair, 8, (1, 1));
    let distances = vec![pair.center_distance()];
    Study::of_drawn("outlines", gears, pair.locked(), distances, sweep)
}

/// Polygons of 8 chords a flank: their backlash peaks between sampled poses, at 221.57 µm. Source: an independent polar gap of both outlines.
#[test]
fn the_peak_between_sampled_poses_is_found() {
    let study = study("tests/corpus/pairs/chords_32_12.toml");
    let plan = Plan::new(&study, Method::Exact { certify: true });
    let analysis = Analysis::silently(&plan.with_revolution().with_extremes()).unwrap();
    let greatest = analysis.extremes.each[0].greatest.as_ref().unwrap();
    let checked = run_of(&study).greatest.unwrap().found();
    near("checked", 1e3 * checked, 221.57, 0.005);
    near("shown", 1e3 * greatest.found(), 221.57, 0.005);
    let drawn = analysis.curves[0].poses.iter();
    let [_, most] = ends(drawn.filter_map(|pose| pose.simulated.backlash));
    assert!(greatest.is_proven() && most <= greatest.high);
    assert_eq!(analysis.verdict().requirement, RequirementOutcome::NotMet);
}

/// A pair too near, and one out of mesh: said so, and from where on it assembles.
#[test]
fn what_jams_says_from_where_it_assembles() {
    let at = |distance| run_of(&study_of(&pair(&spur(20, 2.0), &spur(20, 2.0), distance)));
    let jammed = at(39.0);
    assert_eq!(jammed.assembles(), Some(false));
    // Perfect gears without backlash at the sum of their pitch radii.
    near("from", jammed.assembles_from.unwrap().high, 40.0, 2e-5);
    let apart = at(44.5);
    assert_eq!(apart.status, Status::NoContact);
    assert!(apart.greatest.is_none() && apart.assembles_from.is_none());
}

/// Perfect gears above the sum of their pitch radii, 40 mm, have the closed form at every pose of the map, and as extremes; with bearing play at a ∓ c.
#[test]
fn a_pair_that_turns_has_a_map_and_the_play_of_its_bearings() {
    let known = |a: f64| kit::j_wt(a, 40.0, 0.0);
    let mut study = study_of(&pair(&spur(20, 2.0), &spur(20, 2.0), 40.3));
    study.bearing_clearance = 0.05;
    let run = run_of(&study);
    assert_eq!(run.assembles(), Some(true));
    let play = run.bearings.as_ref().unwrap();
    for (end, a) in [
        (&run.least, 40.3),
        (&run.greatest, 40.3),
        (&play.pressed.extreme, 40.25),
        (&play.pulled_apart.extreme, 40.35),
    ] {
        near(a, end.as_ref().unwrap().found(), known(a), 1e-9);
    }
    let each = [run];
    let maps = BacklashMap::of_study(&study, &each, &go_on).unwrap();
    let map = &maps[0];
    assert_eq!(map.cells.len(), map.distances.len() * map.columns);
    for (a, row) in map.distances.iter().zip(map.cells.chunks(map.columns)) {
        // Below 40 mm tips reach fillets, and above 41 mm corners touch.
        if (40.0..41.0).contains(a) {
            for cell in row {
                near(a, cell.backlash.unwrap(), known(*a), 1e-9);
            }
        }
    }
    // Stopped, there is no map.
    assert!(BacklashMap::of_study(&study, &each, &|_| ControlFlow::Break(())).is_err());
}

fn unit(random: &mut Random) -> f64 {
    random.within(0.0, 1.0)
}

/// Standard normal (Box and Muller).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - unit(random)).ln()).sqrt();
    radius * (TAU * unit(random)).cos()
}

/// The inputs of a pair.
#[derive(Clone)]
struct Inputs {
    gears: [Make; 2],
    distance: f64,
}

impl Inputs {
    /// A module of 2 mm; the gear that shows its back is left-handed.
    fn draw(random: &mut Random, helix_deg: f64) -> Inputs {
        let teeth = [0, 1].map(|_| 20 + (30.0 * unit(random)) as u32);
        let thinner = teeth.map(|_| 0.02 + 0.02 * unit(random));
        let runout = [0, 1].map(|_| 0.01 + 0.02 * unit(random));
        let high = teeth.map(|teeth| 1.0 + unit(random) * f64::from(teeth - 1));
        let gear = |k: usize, hand| {
            let gear = spur(teeth[k], 2.0).helix(helix_deg, hand);
            gear.thinner(thinner[k]).runout(0.5 * runout[k], high[k])
        };
        Inputs {
            gears: [gear(0, Hand::Right), gear(1, Hand::Left)],
            distance: f64::from(teeth[0] + teeth[1]) / helix_deg.to_radians().cos() + 0.05,
        }
    }

    fn pair(&self) -> GearPair {
        let pair = pair(&self.gears[0], &self.gears[1], self.distance);
        pair.with_face([-15.0, 15.0]).unwrap()
    }

    fn redrawn(&self, of: &Uncertainty, random: &mut Random) -> Inputs {
        let mut all = self.clone();
        for (gear, by) in all.gears.iter_mut().zip(of.base_thickness) {
            gear.thinner -= by * normal(random);
        }
        for gear in &mut all.gears {
            gear.deviations.eccentricity += 0.5 * of.runout * normal(random);
        }
        all.distance += of.center_distance * normal(random);
        all
    }
}

/// `j_wt` of the least and of the greatest.
fn least_and_greatest(pair: &GearPair) -> [f64; 2] {
    let kernel = ExactKernel::new(pair);
    let matings = cycle::matings(pair);
    let found =
        gearlash::contact::cycle_extremes(&kernel, pair, Mating::FIRST, matings, 1e-6).unwrap();
    [found.least, found.greatest].map(|extreme| extreme.unwrap().low)
}

/// The expanded uncertainty of the least and of the greatest.
fn expanded(run: &RunExtremes, uncertainty: &Uncertainty) -> [f64; 2] {
    [&run.least, &run.greatest].map(|extreme| {
        let extreme = extreme.as_ref().unwrap();
        let of = uncertainty.of(&extreme.assembly, &extreme.pose.simulated);
        of.unwrap()
    })
}

/// The propagation of JCGM 100 against sampling as in JCGM 101, which shares nothing with it but the gears. Thickness of either gear 1 µm, runout
/// 2 µm, centre distance 2 µm: within 5 % (issue 14), of which sampling takes up 1/√(2 n). The least of helical pairs is where a face of 30 mm has it.
#[test]
fn the_uncertainty_is_that_of_redrawn_inputs() {
    const REDRAWS: u32 = 1400;
    let [mut spur, mut helical] = [Random(14), Random(14)];
    let uncertainty = Uncertainty {
        base_thickness: [1e-3; 2],
        runout: 2e-3,
        center_distance: 2e-3,
        coverage: 2.0,
        ..Uncertainty::default()
    };
    for k in 0..5 {
        let is_spur = k < 3;
        let helix_deg = if is_spur { 0.0 } else { 18.0 };
        let random = if is_spur { &mut spur } else { &mut helical };
        let inputs = Inputs::draw(random, helix_deg);
        let pair = inputs.pair();
        let uncertain = expanded(&extremes_of(&pair), &uncertainty);
        let mut sums = [[0.0; 2]; 2];
        let centre = least_and_greatest(&pair);
        for _ in 0..REDRAWS {
            let drawn = least_and_greatest(&inputs.redrawn(&uncertainty, random).pair());
            for k in 0..2 {
                let off = drawn[k] - centre[k];
                sums[k][0] += off;
                sums[k][1] += off * off;
            }
        }
        let n = f64::from(REDRAWS);
        for (uncertain, [sum, square]) in uncertain.into_iter().zip(sums) {
            let spread = 2.0 * (square / n - (sum / n).powi(2)).sqrt();
            near(inputs.distance, uncertain / spread, 1.0, 0.05);
        }
    }
}

/// Gears by data and their outlines have the same extremes, proven, and the same uncertainty. Source: the exact method; arms and normals of the
/// same contacts.
#[test]
fn outlines_have_the_extremes_and_uncertainty_of_their_data() {
    let mut random = Random(44);
    let uncertainty = Uncertainty {
        runout: 2e-3,
        center_distance: 3e-3,
        coverage: 2.0,
        ..Uncertainty::default()
    };
    let mut inputs = Inputs::draw(&mut random, 0.0);
    inputs.distance -= 0.25; // They interfere.
    let pair = inputs.pair();
    let [drawn, data] = [run_of(&study_of(&pair)), extremes_of(&pair)];
    assert_eq!(drawn.matings, data.matings);
    let ends = [&drawn.least, &drawn.greatest].map(|end| end.as_ref().unwrap());
    let known = [&data.least, &data.greatest].map(|end| end.as_ref().unwrap());
    for (end, known) in ends.into_iter().zip(known) {
        assert!(end.is_proven(), "{end:?}");
        // Rounding of two methods.
        assert!(known.low <= end.high + 1e-10 && end.low <= known.high + 1e-10);
        near("extreme", end.found(), known.low, 1e-5);
    }
    let [from, known] = [&drawn, &data].map(|run| run.assembles_from.unwrap().high);
    near("assembles from", from, known, 3e-5);
    let of_each = [&drawn, &data].map(|run| expanded(run, &uncertainty));
    for (drawn, data) in of_each[0].into_iter().zip(of_each[1]) {
        near("drawn by data", drawn / data, 1.0, 1e-3);
    }
}
