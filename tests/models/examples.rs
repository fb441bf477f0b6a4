//! The output of the programs of each `examples/`.

// The frame of each program is not run here.
#[allow(dead_code)]
#[path = "../../examples/drawing_pair.rs"]
mod drawing_pair;
#[allow(dead_code)]
#[path = "../../examples/gauge.rs"]
mod gauge;
#[allow(dead_code)]
#[path = "../../examples/measured_pair.rs"]
mod measured_pair;

use super::*;
use std::fs;

/// The numbers before `µm`, a line each.
fn um(table: &str) -> Vec<f64> {
    let numbers = table.lines().map(|line| {
        let (before, _) = line.split_once(" µm").unwrap();
        before.split_whitespace().last().unwrap().parse().unwrap()
    });
    numbers.collect()
}

/// Thicker by the shift of the pinion, thinner by both allowances.
#[test]
fn a_pair_as_drawn_has_the_play_of_the_formula() {
    let table = drawing_pair::table().unwrap();
    let thinner = 0.11 - 4.0 * 0.2 * 20f64.to_radians().tan();
    for (a, found) in [74.3, 74.35, 74.4, 74.45].into_iter().zip(um(&table)) {
        near(a, found, 1e3 * j_wt(a, 74.0, thinner), 2e-3);
    }
    assert_eq!(table.lines().count(), 4);
}

/// Between centred gears of the stated spans: `W = m cos α ((k − ½) π + z inv α) + Δs_b`; eccentricities move the axes by up to their sum.
#[test]
fn a_pair_from_spans_and_runout_has_its_play() {
    let table = measured_pair::table().unwrap();
    let alpha = 20f64.to_radians();
    let nominal = 3.0 * alpha.cos() * (5.5 * PI + 44.0 * inv(alpha));
    let thinner = (2.0 * nominal - 50.55 - 50.56) / alpha.cos();
    let j_wt = |a: f64| 1e3 * j_wt(a, 132.0, thinner);
    let found = um(&table);
    assert_eq!(found.len(), 4);
    let [least, most] = ends(found.iter().copied());
    let allowed = [-0.026, 0.026].map(|by| j_wt(132.15 + by));
    assert!(least > allowed[0] && most < allowed[1], "{table}");
    // Over half a turn each the mean is that of the centred gears, but for the second order.
    let mean = found.iter().sum::<f64>() / 4.0;
    near("mean", mean, j_wt(132.15), 0.5);
}

/// `W_3 = m cos α (2.5 π + z inv α)`; a ball reads twice the eccentricity.
#[test]
fn the_gauge_reads_what_the_formulas_say() {
    let alpha = 20f64.to_radians();
    let span = 2.0 * alpha.cos() * (2.5 * PI + 20.0 * inv(alpha));
    let readings = gauge::readings().unwrap();
    let want = format!("span over 3 teeth  {span:8.4} mm\n");
    assert!(readings.starts_with(&want), "{want}{readings}");
    near("ball", um(&readings.replace(&want, ""))[0], 10.0, 0.2);
}

/// A program to copy from is short.
#[test]
fn each_is_under_forty_lines() {
    for folder in ["examples", "examples/python", "crates/render/examples"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                let lines = fs::read_to_string(&path).unwrap().lines().count();
                assert!(lines < 40, "{path:?}: {lines} lines");
            }
        }
    }
}
