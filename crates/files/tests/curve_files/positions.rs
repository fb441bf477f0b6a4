//! Tooth thickness from the positions of `Teilung:`.

use super::made::{Made, PROBE, tenths};
use super::{good, pair, read_with, told};
use std::f64::consts::TAU;

const THICKNESS: &str = "thickness = { file = \"gear.mka\" }";

/// Each tooth by its positions, centre or contact: within the digits printed.
#[test]
fn each_tooth_by_its_positions() {
    for centre in [true, false] {
        let made = Made {
            centre,
            each: |tooth| tenths(tooth) / 1000.0,
            ..Made::new(21)
        };
        for keys in [
            "thickness = { file = \"gear.mka\" }",
            "thickness.per_tooth_um = { file = \"gear.mka\" }",
        ] {
            let study = good(&made, keys);
            let found = study.spec.wheel.thickness.per_tooth_um.unwrap();
            let mean: f64 = (1..=21).map(tenths).sum::<f64>() / 21.0;
            for (tooth, um) in (1..).zip(&found) {
                let expected = (tenths(tooth) - mean) / 20f64.to_radians().cos();
                assert!((um - expected).abs() < 0.2, "{tooth}: {um} {expected}");
            }
        }
    }
}

/// Positions are about the bore: where a runout is stated, what varies once a turn is the eccentricity, and counts once.
#[test]
fn beside_a_runout_nothing_once_a_turn_is_left() {
    let made = Made {
        each: |tooth| 0.002 * (f64::from(tooth) * TAU / 21.0).sin(),
        ..Made::new(21)
    };
    let runout = "runout = { total_um = 10, high_tooth = 3 }";
    for keys in [
        "thickness = { file = \"gear.mka\" }",
        "thickness.per_tooth_um = { file = \"gear.mka\" }",
    ] {
        let of = |keys: &str| {
            let thickness = good(&made, keys).spec.wheel.thickness;
            let values = thickness.per_tooth_um.unwrap().into_iter().zip(0..);
            let [mut re, mut im] = [0.0, 0.0];
            for (um, tooth) in values {
                let angle = f64::from(tooth) * TAU / 21.0;
                re += um * angle.cos();
                im += um * angle.sin();
            }
            f64::hypot(re, im) / 10.5
        };
        let (alone, beside) = (of(keys), of(&format!("{runout}\n{keys}")));
        assert!(alone > 0.1, "{alone}");
        assert!(beside < 1e-9, "{beside}");
    }
}

/// Mean base thickness and remarks, or what is reported.
fn thickness(made: &Made) -> Result<(f64, String), String> {
    let text = made.text();
    match super::read_with(text.as_bytes(), &super::pair(made.teeth, THICKNESS)) {
        Ok(found) => {
            let mean = found.spec.wheel.thickness.statement.base_thickness_mm;
            let Some(gearlash_files::spec::Either::One(mean)) = mean else {
                panic!("{mean:?}");
            };
            Ok((mean, found.remarks.join("\n")))
        }
        Err(_) => Err(told(&text, made.teeth, THICKNESS)),
    }
}

/// Where X and Y turn with the gear, its numbers have a direction: R must lie ahead of L in it, as the convention has it.
#[test]
fn flanks_exchanged_are_refused() {
    for centre in [true, false] {
        for beyond in [0.0, 0.3] {
            let made = |exchanged| Made {
                centre,
                beyond,
                exchanged,
                on_gear: true,
                ..Made::new(44)
            };
            let (mean, remarks) = thickness(&made(false)).unwrap();
            // Positions are printed to 0.1 µm.
            assert!((mean - made(false).base_thickness).abs() < 1e-4, "{mean}");
            assert!(remarks.contains("PHI not counted"), "{remarks}");
            let told = thickness(&made(true)).unwrap_err();
            let expected = "in the direction of the tooth numbers R lies behind L";
            assert!(told.contains(expected), "{told}");
        }
    }
}

/// Where PHI alone turns the gear, its sense is that under which R lies ahead of L: the file does not say it, and the teeth are the same.
#[test]
fn the_sense_of_phi_follows_from_the_flanks() {
    for (exchanged, words) in [(false, "PHI taken off"), (true, "PHI added")] {
        let made = Made {
            exchanged,
            ..Made::new(44)
        };
        let (mean, remarks) = thickness(&made).unwrap();
        assert!((mean - made.base_thickness).abs() < 1e-4, "{mean}");
        assert!(remarks.contains(words), "{remarks}");
    }
}

/// Flanks of spaces are never taken for teeth, whatever they are called.
#[test]
fn spaces_are_not_taken_for_teeth() {
    for bits in 0..16 {
        let made = Made {
            spaces: true,
            centre: bits & 1 > 0,
            on_gear: bits & 2 > 0,
            exchanged: bits & 4 > 0,
            each: if bits & 8 > 0 {
                |tooth| tenths(tooth) / 1000.0
            } else {
                |_| 0.0
            },
            ..Made::new(44)
        };
        let told = thickness(&made).expect_err(&format!("{bits}"));
        let words = ["R lies behind L", "fit the gear in 0 ways"];
        assert!(
            words.iter().any(|words| told.contains(words)),
            "{bits}: {told}"
        );
    }
}

/// On the reference circle tooth and space are as wide: contacts there, of a gear that PHI turns, may be of either.
#[test]
fn a_tooth_that_may_be_a_space_is_refused() {
    let made = Made {
        centre: false,
        beyond: 0.0,
        ..Made::new(44)
    };
    let told = thickness(&made).unwrap_err();
    assert!(told.contains("fit the gear in 2 ways"), "{told}");
    assert!(
        told.contains("the probe's contact at spaces, PHI added"),
        "{told}"
    );
}

/// One tooth whose R and L are exchanged.
#[test]
fn one_tooth_exchanged_is_refused() {
    let made = Made {
        on_gear: true,
        centre: false,
        ..Made::new(17)
    };
    let text = made.text();
    let [right, left] = ["\r\n  5  R  ", "\r\n  5  L  "];
    assert!(text.contains(right) && text.contains(left));
    let text = text
        .replace(right, "\n#")
        .replace(left, right)
        .replace("\n#", left);
    let told = told(&text, 17, THICKNESS);
    assert!(told.contains("fit the gear in 0 ways"), "{told}");
}

/// The pair of a helical `made`, whose `keys` the wheel has.
fn helical_pair(made: &Made, keys: &str) -> String {
    let hand = |right: bool| match right {
        true => "right",
        false => "left",
    };
    let helix = |right: bool| {
        let beta = made.beta_deg.abs();
        format!(
            "pressure_angle_deg = 20.0\nhelix_angle_deg = {beta:?}\nhand = \"{}\"\nface_width_mm = 20\n",
            hand(right)
        )
    };
    let right = made.beta_deg > 0.0;
    let distance = 3.0 * f64::from(made.teeth) / made.beta_deg.to_radians().cos() + 0.2;
    let text = pair(made.teeth, keys)
        .replacen("pressure_angle_deg = 20.0\n", &helix(right), 1)
        .replace("pressure_angle_deg = 20.0\nhelix", "HELIX")
        .replace("pressure_angle_deg = 20.0\n", &helix(!right))
        .replace("HELIX", "pressure_angle_deg = 20.0\nhelix");
    let at = text.find("center_distance_mm").unwrap();
    let end = at + text[at..].find('\n').unwrap();
    format!(
        "{}center_distance_mm = {distance:?}{}",
        &text[..at],
        &text[end..]
    )
}

/// Helical teeth of either hand: centres of the probe in one plane, contacts in one plane, and the contacts of a probe whose centre stays in one plane,
/// which stand `d/2 · sin β_b` off it to either side, all tell the same teeth.
#[test]
fn helical_teeth_by_their_positions() {
    for beta_deg in [18.0, -25.0] {
        let plain = Made {
            on_gear: true,
            each: |tooth| tenths(tooth) / 1000.0,
            ..Made::helical(33, beta_deg)
        };
        let off = PROBE / 2.0 * plain.lean();
        for (centre, height) in [(true, 0.0), (false, 0.0), (false, off), (false, -off)] {
            let made = Made {
                centre,
                height,
                ..plain
            };
            let text = helical_pair(&made, THICKNESS);
            let read = read_with(made.text().as_bytes(), &text);
            let read = read.unwrap_or_else(|problems| panic!("{problems:#?}"));
            let mean: f64 = (1..=33).map(tenths).sum::<f64>() / 33.0;
            let wheel = &read.study.materials[0].1;
            let base = wheel.gear().base_thickness();
            // Positions are printed to 0.1 µm.
            let expected = made.base_thickness + mean / 1000.0;
            assert!((base - expected).abs() < 1e-4, "{base} {expected}");
            let cos = beta_deg.to_radians().cos();
            let alpha_t = (20f64.to_radians().tan() / cos).atan();
            let found = read.spec.wheel.thickness.per_tooth_um.unwrap();
            for (tooth, um) in (1..).zip(&found) {
                // `s_bt = s_n cos α_t/cos β`.
                let expected = (tenths(tooth) - mean) * cos / alpha_t.cos();
                assert!((um - expected).abs() < 0.2, "{tooth}: {um} {expected}");
            }
        }
    }
}
