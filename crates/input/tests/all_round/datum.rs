//! Pitch about the datum axis: readings made here by bisection on displaced involutes, apart from the program.

use super::*;
use gearlash::gear::{
    BasicGearData, BasicRack, EccentricitySeparation, Gear, GearDesign, Pitch,
    separate_eccentricity,
};
use nalgebra::{Complex, DVector, Dyn, OMatrix, RowVector4, U4};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use std::f64::consts::{PI, TAU};

const ALPHA_DEG: f64 = 20.0;

/// A gear with nominal teeth: half a tooth is the angle π/(2z) at the reference circle.
struct Drawn {
    z: u32,
    module: f64,
}

impl Drawn {
    fn r(&self) -> f64 {
        self.module * f64::from(self.z) / 2.0
    }

    fn gear(&self) -> Gear {
        Gear::nominal(GearDesign {
            basic_data: BasicGearData::new(self.z, self.module, ALPHA_DEG.to_radians()).unwrap(),
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        })
        .unwrap()
    }

    /// Undisturbed angle of a flank at the reference circle, ascending, from tooth 1; `ahead` is 1 for right flanks.
    fn flank(&self, index: u32, ahead: f64) -> f64 {
        TAU * f64::from(index) / f64::from(self.z) + ahead * PI / (2.0 * f64::from(self.z))
    }

    /// A machine's reading: the place where the flank, displaced by `own`, crosses the reference circle about the axis when its
    /// centre is displaced by `e`. The involute's points are `r_b e^{i(o ∓ ξ)}(1 ± iξ)`; bisection in ξ.
    fn read(&self, index: u32, ahead: f64, own: f64, e: Complex<f64>) -> f64 {
        let alpha = ALPHA_DEG.to_radians();
        let (r, base) = (self.r(), self.r() * alpha.cos());
        let origin = ahead * (alpha.tan() - alpha) + own / r;
        // Seen from the undisturbed crossing.
        let e = e * Complex::from_polar(1.0, -self.flank(index, ahead));
        let point = |roll: f64| {
            Complex::from_polar(base, origin - ahead * roll) * Complex::new(1.0, ahead * roll) + e
        };
        let (mut low, mut high) = (0.0, 2.0 * alpha.tan());
        assert!(point(low).norm() < r && point(high).norm() > r);
        for _ in 0..80 {
            let middle = (low + high) / 2.0;
            if point(middle).norm() < r {
                low = middle
            } else {
                high = middle
            }
        }
        r * point((low + high) / 2.0).arg()
    }

    /// Separates the readings of a gear with `own` pitch (right, left), mm, displaced by `e` towards the angle `to`.
    fn separate(&self, own: &[Vec<f64>; 2], e: f64, to: f64) -> EccentricitySeparation {
        let e = Complex::from_polar(e, to);
        let sheet = |list: &[f64], ahead: f64| -> Vec<f64> {
            let flanks = (0..self.z).zip(list);
            flanks
                .map(|(i, own)| self.read(i, ahead, *own, e))
                .collect()
        };
        let pitch = Pitch::from_cumulative(&sheet(&own[0], 1.0), &sheet(&own[1], -1.0));
        separate_eccentricity(&pitch, &self.gear()).unwrap()
    }

    /// The direction found, rad.
    fn direction(&self, found: &EccentricitySeparation) -> f64 {
        (found.high_tooth - 1.0) * TAU / f64::from(self.z)
    }

    /// `own` without anything of the runout pattern (sin and cos of `ψ − α` on right, `ψ + α` on left
    /// flanks), both flanks together, nor mean of a flank: less its projection on them over all 2z values.
    fn without_pattern(&self, own: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
        let alpha = ALPHA_DEG.to_radians();
        let flanks = [1.0, -1.0].into_iter();
        let rows = flanks.flat_map(|ahead| (0..self.z).map(move |i| (i, ahead)));
        let rows = rows.map(|(i, ahead)| {
            let (sin, cos) = (self.flank(i, ahead) - ahead * alpha).sin_cos();
            RowVector4::new(f64::from(ahead > 0.0), f64::from(ahead < 0.0), sin, cos)
        });
        let patterns = OMatrix::<f64, Dyn, U4>::from_rows(&rows.collect::<Vec<_>>());
        let q = patterns.qr().q();
        let mut values = DVector::from_vec(own.concat());
        // Twice, for rounding.
        for _ in 0..2 {
            values -= &q * q.tr_mul(&values);
        }
        let (right, left) = values.as_slice().split_at(self.z as usize);
        [right.to_vec(), left.to_vec()]
    }
}

/// 1e-6 µm and 1e-6 rad, issue 5, from a tenth of a micrometre to a tenth of a millimetre.
#[test]
fn eccentricity_comes_back_whatever_else_the_pitch_holds() {
    let mut runner = TestRunner::deterministic();
    let (mut worst_um, mut worst_rad, mut worst_own_um) = (0.0f64, 0.0f64, 0.0f64);
    for z in [7, 8, 12, 21, 44, 97, 200] {
        for module in [1.0, 3.0] {
            let drawn = Drawn { z, module };
            for e_um in [0.1, 1.0, 10.0, 100.0] {
                let lists = proptest::collection::vec(-0.01f64..0.01, 2 * z as usize + 1);
                let mut list = lists.new_tree(&mut runner).unwrap().current();
                let to = PI * (1.0 + 99.0 * list.pop().unwrap());
                let left = list.split_off(z as usize);
                let own = drawn.without_pattern([list, left]);
                let found = drawn.separate(&own, e_um / 1000.0, to);
                worst_um = worst_um.max((1000.0 * found.eccentricity - e_um).abs());
                let off = (drawn.direction(&found) - to + PI).rem_euclid(TAU) - PI;
                worst_rad = worst_rad.max(off.abs());
                for (side, own) in Flank::BOTH.into_iter().zip(&own) {
                    for (found, own) in found.pitch.flank(side).iter().zip(own) {
                        worst_own_um = worst_own_um.max(1000.0 * (found - own).abs());
                    }
                }
            }
        }
    }
    println!(
        "eccentricity within {worst_um:.1e} µm, direction within {worst_rad:.1e} rad, own pitch within {worst_own_um:.1e} µm"
    );
    let worst = [worst_um, worst_rad, worst_own_um];
    assert!(worst.iter().all(|one| *one < 1e-6), "{worst:?}");
}

/// A first harmonic of the gear's own counts as eccentricity. Take F_R = A sin(iτ), F_L = 0 and c = π/(2z) − α. The sums are `Σ
/// sin x sin(x + c) = z cos c/2` and `Σ sin x cos(x + c) = −z sin c/2`. The part of the pattern is thus `(A cos α/2)(−cos c, −sin
/// c)`; the rest is of second order in lengths over r.
#[test]
fn a_first_harmonic_of_the_own_pitch_biases_by_its_closed_form() {
    for (z, e, a) in [
        (44, 0.01, 0.005),
        (44, 0.0, 0.005),
        (12, 0.02, 0.002),
        (200, 0.1, 0.02),
    ] {
        let drawn = Drawn { z, module: 3.0 };
        let wave = |i| a * f64::sin(TAU * f64::from(i) / f64::from(z));
        let own = [(0..z).map(wave).collect(), vec![0.0; z as usize]];
        let to = 1.0;
        let found = drawn.separate(&own, e, to);
        let alpha = ALPHA_DEG.to_radians();
        let c = PI / (2.0 * f64::from(z)) - alpha;
        let bias = Complex::from_polar(-a * alpha.cos() / 2.0, c);
        let expected = Complex::from_polar(e, to) + bias;
        let difference =
            Complex::from_polar(found.eccentricity, drawn.direction(&found)) - expected;
        let second_order = (e + a) * (e + a) / drawn.r();
        let off = difference.norm();
        assert!(off < second_order, "{z}: {off} mm, {second_order}");
        assert!(bias.norm() > 20.0 * second_order, "the bias is seen");
    }
}

/// Readings of one gear, e 10 µm towards tooth 12.5, whose own pitch has a first harmonic of 2 µm.
fn sheet(axis: &str) -> (String, Vec<f64>) {
    let drawn = Drawn { z: 44, module: 3.0 };
    let own: Vec<f64> = (0..44)
        .map(|i| 0.002 * (TAU * f64::from(i) / 44.0).sin())
        .collect();
    let e = Complex::from_polar(0.01, 11.5 * TAU / 44.0);
    let flank = |ahead: f64| -> Vec<f64> {
        (0..44)
            .zip(&own)
            .map(|(i, own)| 1000.0 * drawn.read(i, ahead, *own, e))
            .collect()
    };
    let keys = format!(
        "teeth = 44\nmodule_mm = 3\npitch = {{ kind = \"cumulative\", axis = \"datum\", {axis} right_um = {:?}, left_um = {:?} }}\n",
        flank(1.0),
        flank(-1.0)
    );
    (keys, own)
}

#[test]
fn the_file_says_which_eccentricity_counts() {
    let runout = "runout = { total_um = 20, high_tooth = 12.5 }\n";
    let (keys, own) = sheet("eccentricity = \"runout\",");
    let study = pair(&(keys + runout));
    let gear = wheel(&study);
    assert_eq!((gear.eccentricity(), gear.high_tooth()), (0.01, 12.5));
    for (tooth, own) in (1..).zip(&own) {
        for side in Side::BOTH {
            let found = -gear.flank_offset(side, tooth) * 66.0;
            assert!((found - own).abs() < 1e-9, "{tooth}: {found} {own}");
        }
    }
    let note = study.study.notes[0].eccentricity.unwrap();
    assert!(note.stated_counts && note.stated.unwrap().um == 10.0);
    let words = "That of [runout], 10.000 µm towards tooth 12.50";
    assert!(study.remarks[0].contains(words), "{:?}", study.remarks);

    let (keys, _) = sheet("eccentricity = \"pitch\",");
    let study = pair(&(keys.clone() + runout));
    let note = study.study.notes[0].eccentricity.unwrap();
    assert!(!note.stated_counts);
    assert_eq!(wheel(&study).eccentricity(), note.in_pitch.um / 1000.0);
    // F = A sin(iτ) on both flanks: b = A cos α cos c (−1, 0), c as above (the parts along y cancel).
    let c = PI / 88.0 - ALPHA_DEG.to_radians();
    let bias = 2.0 * ALPHA_DEG.to_radians().cos() * c.cos();
    let off = note.difference_um.unwrap() - bias;
    assert!(off.abs() < 3e-3, "{note:?} {bias}");
    let words = "looks alike; that of [runout], 10.000";
    assert!(study.remarks[0].contains(words), "{:?}", study.remarks);
    // The key changes nothing without a runout: the pitch counts anyway.
    let alone = pair(&keys);
    assert_eq!(wheel(&alone), wheel(&study));
    assert_eq!(alone.study.notes[0].eccentricity.unwrap().stated, None);
}

/// The mean thickness by some spans takes the own pitch, and the eccentricity the mean thickness: both are found.
#[test]
fn some_spans_beside_datum_axis_pitch() {
    let (keys, own) = sheet("eccentricity = \"runout\",");
    let cos = ALPHA_DEG.to_radians().cos();
    // The teeth are nominal, as for the readings above: s_b = cos α (π m/2 + 2 r inv α).
    let alpha = ALPHA_DEG.to_radians();
    let base = cos * (1.5 * PI + 132.0 * (alpha.tan() - alpha));
    let span = |first: usize| 15.0 * PI * cos + base + cos * (own[first + 4] - own[first - 1]);
    let study = pair(&format!(
        "{keys}runout = {{ total_um = 20, high_tooth = 12.5 }}\nthickness.span = {{ teeth = 6, mm = [{:?}, {:?}], first_tooth = [3, 20] }}",
        span(3),
        span(20)
    ));
    let found = wheel(&study).gear().base_thickness();
    assert!((found - base).abs() < 1e-9, "{found} {base}");
}
