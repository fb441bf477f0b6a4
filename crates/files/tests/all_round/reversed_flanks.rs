//! Left flanks with reversed sign: found at the stated rate, and reported.

use super::*;
use gearlash::gear::{BasicGearData, BasicRack, Gear, GearDesign, Pitch};
use gearlash::metrology::{anticorrelation_p_value, datum_anticorrelation_p_value};
use proptest::collection::vec;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use std::f64::consts::TAU;

pub(super) struct Dice(pub TestRunner);

impl Dice {
    /// Uniform values, µm.
    pub fn list(&mut self, count: usize, most: f64) -> Vec<f64> {
        vec(-most..most, count)
            .new_tree(&mut self.0)
            .unwrap()
            .current()
    }

    /// A random walk round the gear that closes.
    pub fn walk(&mut self, count: usize) -> Vec<f64> {
        let steps = self.list(count, 1.0);
        let mean = steps.iter().sum::<f64>() / count as f64;
        let mut at = 0.0;
        steps
            .iter()
            .map(|step| {
                at += step - mean;
                at
            })
            .collect()
    }

    /// Waves of 1 to 3 a revolution, up to 5 µm, and noise.
    pub fn real(&mut self, count: usize, noise: f64) -> [Vec<f64>; 2] {
        let waves = self.list(6, 5.0);
        let common: Vec<f64> = (0..count)
            .map(|i| {
                let turn = TAU * i as f64 / count as f64;
                (1..=3)
                    .map(|h| waves[h - 1] * (h as f64 * turn + waves[h + 2]).sin())
                    .sum()
            })
            .collect();
        [0, 1].map(|_| {
            let noise = self.list(count, noise);
            common.iter().zip(noise).map(|(c, n)| c + n).collect()
        })
    }
}

pub(super) fn negative(list: &[f64]) -> Vec<f64> {
    list.iter().map(|f| -f).collect()
}

pub(super) fn pitch(sense: &str, right: &[f64], left: &[f64]) -> String {
    format!(
        "teeth = {}\nmodule_mm = 3\npitch = {{ kind = \"cumulative\", sense = {sense:?}, right_um = {right:?}, left_um = {left:?} }}\n",
        right.len()
    )
}

pub(super) const GEARS: usize = 4000;

/// How many gears out of [`GEARS`] have flanks that count as reversed, 1e-3 being the limit that is stated.
fn suspected(name: &str, dice: &mut Dice, flanks: impl Fn(&mut Dice) -> [Vec<f64>; 2]) -> usize {
    let suspect = |_: &usize| {
        let [right, left] = flanks(dice);
        anticorrelation_p_value(&Pitch::from_cumulative(&right, &left)) < 1e-3
    };
    let count = (0..GEARS).filter(suspect).count();
    println!("{name}: {count} of {GEARS}");
    count
}

#[test]
fn unrelated_flanks_are_hardly_ever_suspected() {
    let mut dice = Dice(TestRunner::deterministic());
    for z in [7, 20, 44] {
        let white = suspected("white", &mut dice, |d| [d.list(z, 5.0), d.list(z, 5.0)]);
        let walks = suspected("random walks", &mut dice, |d| [d.walk(z), d.walk(z)]);
        assert!(white.max(walks) <= GEARS / 1000, "z {z}: {white}, {walks}");
    }
}

#[test]
fn flanks_that_a_tool_cut_are_told_from_turned_ones() {
    let mut dice = Dice(TestRunner::deterministic());
    for (z, share) in [(20, 0.8), (44, 0.9)] {
        assert_eq!(suspected("real", &mut dice, |d| d.real(z, 2.0)), 0);
        let found = suspected("real, turned", &mut dice, |d| {
            let [right, left] = d.real(z, 1.0);
            [right, negative(&left)]
        });
        assert!(found as f64 > share * GEARS as f64, "z {z}: {found}");
    }
}

/// Datum-axis readings of flanks with the own pitch `own`, µm: the pattern of design section 6, F = −e sin(ψ ∓ α)/cos α, added to it,
/// rounded to 0.1 µm as sheets are. Teeth of half a pitch, so a flank stands π/(2z) from its tooth's centre.
pub(super) fn about_datum(own: [Vec<f64>; 2], e: f64, to: f64) -> [Vec<f64>; 2] {
    let alpha = 20f64.to_radians();
    let mut ahead = -1.0;
    own.map(|list| {
        ahead = -ahead;
        let z = list.len() as f64;
        let read = |(i, f): (usize, &f64)| {
            let flank = TAU * i as f64 / z + ahead * TAU / (4.0 * z) - to;
            let um = f - e * (flank - ahead * alpha).sin() / alpha.cos();
            (10.0 * um).round() / 10.0
        };
        list.iter().enumerate().map(read).collect()
    })
}

/// How many of [`GEARS`] datum-axis sheets count as reversed; `e` as given, in any direction.
fn suspected_about_datum(
    name: &str,
    dice: &mut Dice,
    e: f64,
    turned: bool,
    flanks: impl Fn(&mut Dice) -> [Vec<f64>; 2],
) -> usize {
    let basic_data =
        |z: usize| BasicGearData::new(u32::try_from(z).unwrap(), 3.0, 20f64.to_radians());
    let suspect = |_: &usize| {
        let own = flanks(dice);
        let gear = Gear::nominal(GearDesign {
            basic_data: basic_data(own[0].len()).unwrap(),
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        })
        .unwrap();
        let to = dice.list(1, TAU / 2.0)[0];
        let [right, left] = about_datum(own, e, to);
        let left = if turned { negative(&left) } else { left };
        datum_anticorrelation_p_value(&Pitch::from_cumulative(&right, &left), &gear) < 1e-3
    };
    let count = (0..GEARS).filter(suspect).count();
    println!("{name}, e = {e} µm: {count} of {GEARS}");
    count
}

/// 1e-3 is the limit that is stated; with an eccentricity nothing at all.
#[test]
fn datum_axis_flanks_are_hardly_ever_suspected() {
    let mut dice = Dice(TestRunner::deterministic());
    for z in [7, 20, 44] {
        for e in [0.0, 2.0, 20.0] {
            let white = suspected_about_datum("white", &mut dice, e, false, |d| {
                [d.list(z, 5.0), d.list(z, 5.0)]
            });
            let walks = suspected_about_datum("random walks", &mut dice, e, false, |d| {
                [d.walk(z), d.walk(z)]
            });
            let real = suspected_about_datum("real", &mut dice, e, false, |d| d.real(z, 2.0));
            assert!(
                white.max(walks).max(real) <= GEARS / 1000,
                "z {z}, e {e}: {white}, {walks}, {real}"
            );
        }
    }
}

/// The reviewers' case (e = 20 µm, 1 µm of noise, the left column reversed), with and without common waves of the own pitch.
#[test]
fn a_reversed_left_flank_about_the_datum_axis_is_found() {
    let mut dice = Dice(TestRunner::deterministic());
    for (z, e, share) in RATES {
        let noise = suspected_about_datum("noise alone, turned", &mut dice, e, true, |d| {
            [d.list(z, 3f64.sqrt()), d.list(z, 3f64.sqrt())]
        });
        let real = suspected_about_datum("real, turned", &mut dice, e, true, |d| d.real(z, 1.0));
        assert!(
            noise.min(real) as f64 >= share * GEARS as f64,
            "z {z}, e {e}: {noise}, {real}"
        );
    }
}

/// Teeth, eccentricity in µm, and the share that is found at least. Found: 63 and 96 %, 57 and 82 %, then all.
const RATES: [(usize, f64, f64); 6] = [
    (20, 5.0, 0.6),
    (44, 5.0, 0.55),
    (20, 20.0, 1.0),
    (44, 20.0, 1.0),
    (20, 50.0, 1.0),
    (44, 50.0, 1.0),
];

/// The whole way: the reviewers' file, told with what either sign makes of it.
#[test]
fn the_file_with_a_reversed_left_flank_about_the_datum_axis_is_reported() {
    let mut dice = Dice(TestRunner::deterministic());
    let own = [dice.list(44, 1.7), dice.list(44, 1.7)];
    let [right, left] = about_datum(own, 20.0, 32.0 * TAU / 44.0);
    let warnings_of = |left: &[f64]| {
        let keys = pitch("numbers", &right, left).replace("sense", "axis = \"datum\", sense");
        let mut warnings = pair(&keys).warnings;
        warnings.retain(|warning| warning.starts_with("wheel.pitch.left_um: "));
        warnings
    };
    assert_eq!(warnings_of(&left), [""; 0]);
    let turned = warnings_of(&negative(&left));
    assert_eq!(turned.len(), 1, "{turned:?}");
    // 20 µm but for the noise.
    for words in [
        "reversed they contain an eccentricity of 19.",
        "write sense = \"material\"",
    ] {
        assert!(turned[0].contains(words), "{}", turned[0]);
    }
}
