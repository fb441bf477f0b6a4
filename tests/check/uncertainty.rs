//! The expanded uncertainty of an extreme beside the spread of redrawn inputs: the propagation of JCGM 100 against sampling as in
//! JCGM 101, which shares nothing with it but the gears.

use super::outlines::{extremes_of_outlines, study_of};
use super::*;
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::gear::Hand;

fn unit(random: &mut Random) -> f64 {
    random.within(0.0, 1.0)
}

/// Standard normal (Box and Muller).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - unit(random)).ln()).sqrt();
    radius * (std::f64::consts::TAU * unit(random)).cos()
}

/// A module of 2 mm; the gear that shows its back is left-handed.
fn wound(teeth: u32, helix_deg: f64, face: Face) -> GearDesign {
    let spur = design(teeth, 2.0);
    let hand = match face {
        Face::Front => Hand::Right,
        Face::Back => Hand::Left,
    };
    let helix = helix_deg.to_radians();
    GearDesign {
        basic_data: spur.basic_data.with_helix(helix, hand).unwrap(),
        ..spur
    }
}

/// The inputs of a pair.
#[derive(Clone)]
struct Inputs {
    teeth: [u32; 2],
    base_thickness: [f64; 2],
    runout: [f64; 2],
    high_tooth: [f64; 2],
    distance: f64,
    helix_deg: f64,
}

impl Inputs {
    fn draw(random: &mut Random, helix_deg: f64) -> Inputs {
        let teeth = [0, 1].map(|_| 20 + (30.0 * unit(random)) as u32);
        let design = |teeth| wound(teeth, helix_deg, Face::Front);
        let base = teeth.map(|teeth| {
            let design = design(teeth);
            design.nominal_base_thickness() - 0.02 - 0.02 * unit(random)
        });
        Inputs {
            teeth,
            base_thickness: base,
            runout: [0, 1].map(|_| 0.01 + 0.02 * unit(random)),
            high_tooth: teeth.map(|teeth| 1.0 + unit(random) * f64::from(teeth - 1)),
            distance: f64::from(teeth[0] + teeth[1]) / helix_deg.to_radians().cos() + 0.05,
            helix_deg,
        }
    }

    fn pair(&self) -> GearPair {
        let gear = |k: usize, face| {
            let design = wound(self.teeth[k], self.helix_deg, face);
            let gear = Gear::new(design, self.base_thickness[k]).unwrap();
            let deviations = Deviations {
                eccentricity: 0.5 * self.runout[k],
                high_tooth: self.high_tooth[k],
                ..Deviations::default()
            };
            AsBuilt::new(gear, face, &deviations).unwrap()
        };
        let pair = GearPair::new(gear(0, Face::Front), gear(1, Face::Back), self.distance).unwrap();
        pair.with_face([-15.0, 15.0]).unwrap()
    }

    fn redrawn(&self, of: &Uncertainty, random: &mut Random) -> Inputs {
        let mut off = |value: f64, by: f64| value + by * normal(random);
        Inputs {
            base_thickness: [0, 1].map(|k| off(self.base_thickness[k], of.base_thickness[k])),
            runout: self.runout.map(|runout| off(runout, of.runout)),
            distance: off(self.distance, of.center_distance),
            ..self.clone()
        }
    }
}

/// `j_wt` of the least and of the greatest.
fn least_and_greatest(pair: &GearPair) -> [f64; 2] {
    let kernel = ExactKernel::new(pair);
    let matings = cycle::matings(pair);
    let found = kernel.extremes(pair, Mating::FIRST, matings, 1e-6).unwrap();
    [found.least, found.greatest].map(|extreme| extreme.unwrap().low)
}

/// Thickness of either gear 1 µm, runout 2 µm, centre distance 2 µm: within 5 % (issue 14), of which sampling takes up 1/√(2 n).
fn hold(pairs: u32, redraws: u32, helix_deg: f64) {
    let mut random = Random(14);
    for _ in 0..pairs {
        let inputs = Inputs::draw(&mut random, helix_deg);
        let pair = inputs.pair();
        let uncertainty = Uncertainty {
            base_thickness: [1e-3; 2],
            runout: 2e-3,
            center_distance: 2e-3,
            coverage: 2.0,
            ..Uncertainty::default()
        };
        let run = extremes_of(&pair);
        let told = [&run.least, &run.greatest].map(|extreme| {
            uncertainty
                .of(&run.assembly, &extreme.as_ref().unwrap().pose.simulated)
                .unwrap()
        });
        let mut sums = [[0.0; 2]; 2];
        let centre = least_and_greatest(&pair);
        for _ in 0..redraws {
            let drawn = least_and_greatest(&inputs.redrawn(&uncertainty, &mut random).pair());
            for k in 0..2 {
                let off = drawn[k] - centre[k];
                sums[k][0] += off;
                sums[k][1] += off * off;
            }
        }
        let n = f64::from(redraws);
        for k in 0..2 {
            let [sum, square] = sums[k];
            let spread = 2.0 * (square / n - (sum / n).powi(2)).sqrt();
            assert!(
                (told[k] / spread - 1.0).abs() < 0.05,
                "{:?}: {} told, {spread} found",
                inputs.teeth,
                told[k]
            );
        }
    }
}

#[test]
fn the_uncertainty_is_that_of_redrawn_inputs() {
    hold(3, 2000, 0.0);
}

/// Helical pairs whose least is where a face of 30 mm has it.
#[test]
fn the_uncertainty_of_helical_pairs_is_that_of_redrawn_inputs() {
    hold(2, 2000, 18.0);
}

/// Gears by data and their outlines have the same uncertainty. Source: arms and normals of the same contacts.
#[test]
fn outlines_have_the_uncertainty_of_their_data() {
    let mut random = Random(44);
    for _ in 0..3 {
        let pair = Inputs::draw(&mut random, 0.0).pair();
        let drawn = extremes_of_outlines(&study_of(&pair));
        let data = extremes_of(&pair);
        let uncertainty = Uncertainty {
            runout: 2e-3,
            center_distance: 3e-3,
            coverage: 2.0,
            ..Uncertainty::default()
        };
        for (drawn, data) in [
            (&drawn.least, &data.least),
            (&drawn.greatest, &data.greatest),
        ] {
            let [drawn, data] = [drawn, data].map(|extreme| {
                let extreme = extreme.as_ref().unwrap();
                let of = uncertainty.of(&extreme.assembly, &extreme.pose.simulated);
                of.unwrap()
            });
            assert!((drawn / data - 1.0).abs() < 1e-3, "{drawn} {data}");
        }
    }
}

/// As issue 14 asks; some minutes.
#[test]
#[ignore = "20 pairs, 10 000 redraws each: minutes"]
fn the_uncertainty_of_twenty_pairs() {
    hold(20, 10_000, 0.0);
}
