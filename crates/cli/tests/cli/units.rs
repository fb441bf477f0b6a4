//! Backlash in every unit: `--unit`, `--at`, and the keys of the results.

use super::*;
use std::f64::consts::PI;

/// Arcmin at a gear per µm of j_wt, from `r_w = a z/(z_1 + z_2)` (ISO 21771) and 10 800' = π.
fn arcmin_per_um(a: f64, teeth: f64, both: f64) -> f64 {
    10_800.0 / PI * 1e-3 / (a * teeth / both)
}

/// j_r = a − a_0, where j_wt cos α_wt = (d_b1 + d_b2) (inv α_wt − inv α_w0), cos α_wt = (r_b1 + r_b2)/a (module 2): a_0 by halving. The lost
/// motions of both gears are as their teeth (ISO 21771).
#[test]
fn every_pose_has_every_unit_in_json_and_csv() {
    let folder = empty_folder();
    small(folder.path());
    let (_, result) = simulated(folder.path(), &["small.toml", "-o", "out"]);
    let mut rows = csv::Reader::from_path(folder.path().join("out/result.csv")).unwrap();
    let names = rows.headers().unwrap().clone();
    let last = [
        "j_r_um",
        "lost_motion_wheel_arcmin",
        "lost_motion_pinion_arcmin",
    ];
    assert!(
        names
            .iter()
            .rev()
            .zip(last.iter().rev())
            .all(|(a, b)| a == *b)
    );
    let mut rows = rows.records();
    for run in result["runs"].as_array().unwrap() {
        let a = run["center_distance_mm"].as_f64().unwrap();
        let sum = 37.0 * 20f64.to_radians().cos();
        let angle = |a: f64| (sum / a).acos();
        let inv = |a: f64| angle(a).tan() - angle(a);
        let radial_um = |j_wt_um: f64| {
            let wanted = inv(a) - 1e-3 * j_wt_um * angle(a).cos() / (2.0 * sum);
            let (mut low, mut high) = (sum, 2.0 * sum);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if inv(middle) < wanted {
                    low = middle
                } else {
                    high = middle
                }
            }
            1e3 * (a - low)
        };
        for pose in run["poses"].as_array().unwrap() {
            let j_wt = pose["j_wt_um"].as_f64().unwrap();
            let at = &pose["lost_motion_arcmin"];
            let found = [&pose["j_r_um"], &at["wheel"], &at["pinion"]].map(|v| v.as_f64().unwrap());
            let expected = [
                radial_um(j_wt),
                j_wt * arcmin_per_um(a, 20.0, 37.0),
                j_wt * arcmin_per_um(a, 17.0, 37.0),
            ];
            let row = rows.next().unwrap().unwrap();
            for (i, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                // a − a_0 to the rounding of 37 mm, 1e-11 µm and that of the halving.
                assert!(
                    (found - expected).abs() < 1e-12 * expected.abs() + 1e-9,
                    "{pose}"
                );
                let cell: f64 = row[names.len() - 3 + i].parse().unwrap();
                assert_eq!(cell, found);
            }
        }
        let summary = &run["summary"];
        for end in ["min", "max"] {
            let j_wt = summary[format!("{end}_j_wt_um")].as_f64().unwrap();
            let at = &summary[format!("{end}_lost_motion_arcmin")];
            let wheel = at["wheel"].as_f64().unwrap();
            assert!((wheel - j_wt * arcmin_per_um(a, 20.0, 37.0)).abs() < 1e-12);
        }
    }
    assert!(rows.next().is_none());
}

/// The same table in µm and in arcmin: every value times `1/r_w`, to half a digit of either.
#[test]
fn a_table_in_arcmin_is_the_one_in_um_times_a_factor() {
    let folder = empty_folder();
    let table = |options: &[&str]| -> Vec<Vec<String>> {
        let mut command = gearlash(folder.path());
        let file = fixture("karba_86x21.toml");
        let text = output(
            command
                .arg("simulate")
                .arg(file)
                .arg("--no-files")
                .args(options),
        );
        // Below the verdict.
        let rows = text.lines().skip_while(|line| !line.contains(" mating "));
        let rows = rows.take(7);
        let cells = |row: &str| row.split("  ").map(|cell| cell.trim().to_owned()).collect();
        rows.map(|row| -> Vec<String> { cells(row) })
            .map(|row| row.into_iter().filter(|cell| !cell.is_empty()).collect())
            .collect()
    };
    let um = table(&[]);
    // The pinion turns: it is taken where no gear is named.
    for (options, name, teeth) in [
        (&["--unit", "arcmin"][..], "pinion arcmin", 21.0),
        (&["--unit", "arcmin", "--at", "wheel"], "wheel arcmin", 86.0),
    ] {
        let arcmin = table(options);
        let column = arcmin[0].iter().position(|cell| cell == name).unwrap();
        assert_eq!(um[0][column], "j_wt");
        for (um, arcmin) in um.iter().zip(&arcmin).skip(1) {
            let a: f64 = um[0].parse().unwrap();
            let factor = arcmin_per_um(a, teeth, 107.0);
            // The simulated value, and Michalec's, involute's and the line of action's.
            let last = um.len() - 3..um.len();
            for column in last.chain([column]) {
                let [um, arcmin] = [um, arcmin].map(|row| row[column].parse::<f64>().unwrap());
                assert!((um * factor - arcmin).abs() < 0.6e-4 + 0.6e-3 * factor);
            }
        }
    }
}
