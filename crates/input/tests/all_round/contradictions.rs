//! Data that contradict the file, both ways, and data that do not.

use super::reversed_flanks::{Dice, about_datum, negative, pitch};
use super::*;
use std::f64::consts::TAU;

/// One warning, with these words.
fn check_one(warnings: &[String], words: &str) {
    let is_one = warnings.len() == 1 && warnings[0].contains(words);
    assert!(is_one, "{words}: {warnings:?}");
}

#[test]
fn a_reversed_left_flank_is_reported() {
    let [right, left] = Dice::default().real(44, 0.5);
    let turned = negative(&left);
    assert_eq!(pair(&pitch("numbers", &right, &left)).warnings, [""; 0]);
    assert_eq!(pair(&pitch("material", &right, &turned)).warnings, [""; 0]);
    for (sense, left, other) in [
        ("numbers", &turned, "material"),
        ("material", &left, "numbers"),
    ] {
        let warnings = pair(&pitch(sense, &right, left)).warnings;
        check_one(&warnings, &format!("write sense = \"{other}\""));
        let key = "wheel.pitch.left_um: ";
        assert!(warnings[0].starts_with(key), "{warnings:?}");
    }
}

/// Flanks that vary opposite to each other on purpose: spans confirm one sign or the other.
/// W_6 = 15π cos α + s_b + cos α (F_R,i+5 − F_L,i), 1 µm of noise.
#[test]
fn spans_say_which_sign_is_meant() {
    let mut dice = Dice::default();
    let [right, left] = dice.real(44, 0.5);
    let turned = negative(&left);
    let noise = dice.list(44, 1.0);
    let spans: Vec<f64> = (0..44)
        .map(|i| {
            let um = 20f64.to_radians().cos() * (right[(i + 5) % 44] - turned[i]);
            50.55 + 1e-3 * (um + noise[i])
        })
        .collect();
    let with_spans = |sense: &str, left: &[f64]| {
        let keys = pitch(sense, &right, left);
        let span = format!("thickness.span = {{ teeth = 6, mm = {spans:?}, per_tooth = false }}");
        pair(&(keys + &span)).warnings
    };
    assert_eq!(with_spans("numbers", &turned), [""; 0]);
    let warnings = with_spans("numbers", &left);
    check_one(&warnings, "write sense = \"material\"");
}

#[test]
fn thickness_that_is_said_twice() {
    const ADDED: &str = "The two are added: where both were measured";
    let mut dice = Dice::default();
    let [right, left] = dice.real(44, 4.0);
    let mean = |list: &[f64]| list.iter().sum::<f64>() / 44.0;
    let thicker = |sign: f64| -> Vec<f64> {
        let thicker = |(r, l): (&f64, &f64)| r - mean(&right) - sign * (l - mean(&left));
        right.iter().zip(&left).map(thicker).collect()
    };
    let unrelated = dice.list(44, 5.0);
    let noise = dice.list(44, 0.5);
    let with_noise: Vec<f64> = thicker(1.0).iter().zip(noise).map(|(t, n)| t + n).collect();
    let mut moved = thicker(1.0);
    moved.rotate_right(1);
    let half: Vec<f64> = thicker(1.0).iter().map(|t| t / 2.0).collect();
    for (per_tooth, words) in [
        (vec![5.0; 44], None),
        (unrelated, Some(ADDED)),
        (half, Some(ADDED)),
        (moved, Some("shifted up by 1 in tooth number")),
        (
            with_noise,
            Some("repeats the pitch of both flanks (a tooth"),
        ),
        (negative(&thicker(1.0)), Some("cancels the thickness")),
        (thicker(-1.0), Some("write pitch.sense = \"material\"")),
    ] {
        let keys = pitch("numbers", &right, &left);
        let study = pair(&format!(
            "{keys}thickness = {{ allowance_um = -50, per_tooth_um = {per_tooth:?} }}"
        ));
        match words {
            None => assert_eq!(study.warnings, [""; 0]),
            Some(words) => check_one(&study.warnings, words),
        }
    }
}

/// The warning's numbers by hand: R − L is 6, −2, −2, −2 µm, … of four teeth, 8 µm of variation, the list 0, 3, 0, 1: about its
/// mean −1, 2, −1, 0, farthest from the pitch at tooth 1, by 7 µm.
#[test]
fn thickness_beside_pitch_is_reported_in_micrometres() {
    let keys = pitch("numbers", &[3.0, -1.0, -1.0, -1.0], &[-3.0, 1.0, 1.0, 1.0]);
    let stated = "thickness = { allowance_um = 0, per_tooth_um = [0.0, 3.0, 0.0, 1.0] }";
    let mut warnings = pair(&(keys + stated)).warnings;
    warnings.retain(|warning| warning.contains("per_tooth_um"));
    check_one(
        &warnings,
        "vary by 3.000 µm by this list and by 8.000 µm by the pitch",
    );
    check_one(&warnings, "at tooth 1 they are 7.000 µm apart. ");
}

/// Issue: own-axis data that hold the very eccentricity that is stated beside them count it twice.
#[test]
fn own_axis_pitch_that_holds_the_runout_is_reported() {
    let mut dice = Dice::default();
    let to = 32.0 * TAU / 44.0;
    let noise = || [vec![0.0; 44], vec![0.0; 44]];
    let [right, left] = about_datum(noise(), 20.0, to);
    let keys = pitch("numbers", &right, &left);
    let warning = |runout: &str| {
        let warnings = pair(&format!("{keys}runout = {{ {runout} }}")).warnings;
        warnings.iter().any(|warning| {
            warning.starts_with("wheel.pitch.axis: ") && warning.contains("Write axis = \"datum\"")
        })
    };
    assert!(warning("total_um = 40, high_tooth = 33"));
    assert!(warning("total_um = 34, high_tooth = 34"));
    // A quarter off, 15° off, opposite.
    assert!(!warning("total_um = 60, high_tooth = 33"));
    assert!(!warning("total_um = 40, high_tooth = 35.2"));
    assert!(!warning("total_um = 40, high_tooth = 11"));
    // A wave that moves both flanks of a tooth equally, in any direction, is no eccentricity (a fixture once warned).
    for high in 0..44 {
        let wave = |i: i32| 20.0 * (TAU * f64::from(i - high) / 44.0).cos();
        let flank: Vec<f64> = (0..44).map(wave).collect();
        let text = pitch("numbers", &flank, &flank);
        let runout = "runout = { total_um = 40, high_tooth = 33 }";
        assert_eq!(pair(&format!("{text}{runout}")).warnings, [""; 0], "{high}");
    }
    // Pitch of its own beside it.
    let [right, left] = dice.real(44, 1.0);
    let keys = pitch("numbers", &right, &left);
    let both = keys + "runout = { total_um = 40, high_tooth = 33 }";
    assert_eq!(pair(&both).warnings, [""; 0]);
}

/// (δ_i + δ_i+5) cos α/2 in the spans, the sign of the stated thickness right and wrong.
#[test]
fn thickness_that_the_spans_do_not_show() {
    let mut dice = Dice::default();
    let (per_tooth, noise) = (dice.list(44, 8.0), dice.list(44, 2.0));
    let spans: Vec<f64> = (0..44)
        .map(|i| {
            let um = 20f64.to_radians().cos() * (per_tooth[i] + per_tooth[(i + 5) % 44]) / 2.0;
            50.55 + 1e-3 * (um + noise[i])
        })
        .collect();
    let with = |per_tooth: &[f64]| {
        pair(&format!(
            "teeth = 44\nmodule_mm = 3\nthickness = {{ per_tooth_um = {per_tooth:?}, span = {{ teeth = 6, mm = {spans:?}, per_tooth = false }} }}"
        )).warnings
    };
    assert_eq!(with(&per_tooth), [""; 0]);
    let warnings = with(&negative(&per_tooth));
    check_one(&warnings, "the spans contradict it");
}

fn about_axis(list: &[String], words: &str) -> usize {
    let about = list.iter().filter(|warning| warning.contains(words));
    about.count()
}

const NOT_ALONE: &str = "the first harmonic is not that of an eccentricity alone";

/// The reviewers' file (z 40: 20 µm · sin(2πi/z) in both columns) was suspected of a reversed left flank. A share sin²(α −
/// π/(2z)) of the energy of the wave belongs to no eccentricity, 9 % at z 40.
#[test]
fn a_wave_of_both_flanks_about_the_datum_axis_is_no_turned_flank() {
    for z in [7, 20, 40, 101] {
        for high in [0.0, 1.0, 2.5] {
            let wave = |i: usize| {
                let um = 20.0 * (TAU * i as f64 / z as f64 - high).sin();
                (100.0 * um).round() / 100.0
            };
            let flank: Vec<f64> = (0..z).map(wave).collect();
            let keys = pitch("numbers", &flank, &flank).replace("sense", "axis = \"datum\", sense");
            let warning = pair(&keys).warnings;
            assert_eq!(about_axis(&warning, "vary opposite"), 0, "{warning:#?}");
            // z 7: π/(2z) is 12.9°, and sin² 7.1° = 0.015 of it is as an eccentricity leaves it.
            let is_told = usize::from(z > 7);
            assert_eq!(about_axis(&warning, NOT_ALONE), is_told, "{z} {warning:#?}");
            assert_eq!(about_axis(&warning, "both flanks vary equally"), is_told);
        }
    }
}

/// The number of 200 sheets with a warning of more than an eccentricity. White deviations cause one with e^−8 = 3e-4. Flanks of a
/// walk have a first harmonic of their own beside a small eccentricity, which does make it uncertain.
#[test]
fn an_eccentricity_alone_is_not_doubted() {
    let mut dice = Dice::default();
    for z in [20, 44] {
        for e in [0.0, 2.0, 20.0] {
            let mut count = |walk: bool| {
                let doubted = |_: &usize| {
                    let own = [0, 1].map(|_| match walk {
                        true => dice.walk(z),
                        false => dice.list(z, 3.0),
                    });
                    let to = dice.list(1, TAU / 2.0)[0];
                    let [right, left] = about_datum(own, e, to);
                    let keys = pitch("numbers", &right, &left);
                    let keys = keys.replace("sense", "axis = \"datum\", sense");
                    about_axis(&pair(&keys).warnings, NOT_ALONE) > 0
                };
                (0..140).filter(doubted).count()
            };
            let (white, walk) = (count(false), count(true));
            assert!(white <= 1, "z {z}, e {e}: {white}");
            assert!(e < 20.0 || walk <= 1, "z {z}, e {e}: {walk}");
        }
    }
}
