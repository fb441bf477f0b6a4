//! `lead`, `wobble_um` and `misalignment` of `[tolerance]`. Expected values are the closed forms of slopes, wobble and leaning axes to first order, as in
//! `shafts.rs`, over a face of 20 mm whose evaluation range is 18 mm.

use super::leads::SPUR;
use super::*;
use gearlash_files::read_text;
use gearlash_files::tolerance::ToleranceResult;
use std::f64::consts::PI;

/// The spur pair with these keys of `[wheel]`, `[pinion]` and `[assembly]`, and `[tolerance]`.
fn text([wheel, pinion, assembly]: [&str; 3], tolerance: &str) -> String {
    let own = SPUR.replace("WHEEL", wheel).replace("PINION", pinion);
    let own = own.split("[sweep]").next().unwrap();
    format!(
        "{own}{assembly}\n[require]\nj_wt_um = {{ min = 100 }}\n[tolerance]\nphase = \"marked\"\ncontribution_rows = 0\n{tolerance}"
    )
}

fn result(text: &str) -> ToleranceResult {
    let folder = folder(&[("pair.toml", text)]);
    drawn_from(&folder.path().join("pair.toml")).unwrap_or_else(|error| panic!("{error}"))
}

/// Least `j_wt` over all poses, µm.
fn least(text: &str) -> f64 {
    let file = read_text(Path::new("pair"), text).unwrap_or_else(|error| panic!("{error}"));
    1e3 * of_study(&file.study).each[0]
        .least
        .as_ref()
        .unwrap()
        .found()
}

fn plain() -> f64 {
    least(text([""; 3], "").split("[tolerance]").next().unwrap())
}

/// Slopes of both flanks cost their amounts at an end of the face: of normal ones `√(2/π) σ` each on average.
#[test]
fn normal_slopes_cost_their_mean_amount() {
    const COUNT: f64 = 400.0;
    let found = result(&text(
        [""; 3],
        "assemblies = 400\n[tolerance.wheel]\nlead = { slope_um = { sigma = 3 } }\n",
    ));
    // At the end, 10 mm of 18, on the pitch circle.
    let sigma = 3.0 * 10.0 / 18.0 / (60.0 * 20f64.to_radians().cos() / 60.2);
    let loss = 2.0 * sigma * (2.0 / PI).sqrt();
    let scatter = sigma * (2.0 * (1.0 - 2.0 / PI)).sqrt();
    let least = &found.statistics.least;
    let mean = 1e3 * least.mean.unwrap();
    assert!(
        (plain() - loss - mean).abs() < 4.0 * scatter / COUNT.sqrt(),
        "{mean}, {}",
        plain() - loss
    );
    let deviation = 1e3 * least.sigma.unwrap();
    assert!(
        (deviation / scatter - 1.0).abs() < 0.2,
        "{deviation}, {scatter}"
    );
}

/// Limits of slopes add on both flanks of both gears; axes add the greater of `2 sin α_wt` and `2 cos α_wt` of their lean, and wobble its whole amount.
#[test]
fn limits_are_those_of_closed_forms() {
    let cos = 60.0 * 20f64.to_radians().cos() / 60.2;
    let over = "misalignment = { over_mm = 100 }";
    let both = |keys: &str| format!("[tolerance.wheel]\n{keys}\n[tolerance.pinion]\n{keys}\n");
    let axes = |inner: f64, outer: f64| {
        format!(
            "misalignment = {{ in_plane_um = {{ max = {inner} }}, out_of_plane_um = {{ max = {outer} }} }}\n"
        )
    };
    let slopes = both("lead = { slope_um = { max = 9 } }");
    let sin = (1.0 - cos * cos).sqrt();
    let cases = [
        (
            "[tolerance.wheel]\nlead = { slope_um = { sigma = 3 } }\n".to_owned(),
            10.0 / cos,
            1e-3,
        ),
        (slopes.clone(), 20.0 / cos, 1e-3),
        // A hollow of 6 µm that thickness was measured in: what stands out at both ends.
        (
            "[tolerance.wheel]\nlead = { crowning_um = { max = 6 } }\n".to_owned(),
            12.0 / cos,
            1e-3,
        ),
        (axes(10.0, 10.0), 2.0, 5e-3),
        (axes(30.0, 2.0), 6.0 * sin / cos, 2e-2),
        (axes(10.0, 10.0) + &slopes, 2.0 + 20.0 / cos, 5e-3),
        (
            "[tolerance.wheel]\nwobble_um = { max = 8 }\n".to_owned(),
            8.0,
            2e-2,
        ),
    ];
    for (tolerance, loss, near) in cases {
        let found = result(&text(
            ["", "", over],
            &format!("assemblies = 2\n{tolerance}"),
        ));
        let [mean, worst, _] = found.about.limit_cases.unwrap();
        let [mean, worst] = [mean, worst].map(|ends| 1e3 * ends[0].unwrap());
        assert!((mean - plain()).abs() < 2e-3, "{tolerance}: {mean}");
        assert!(
            (plain() - loss - worst).abs() < near,
            "{tolerance}: {worst}, {}",
            plain() - loss
        );
    }
}

/// Every drawn assembly as a pair file: `simulate` finds its least backlash, with leads, wobble and axes stated beside the drawn ones, a pinion in another
/// plane, and scaled gears.
#[test]
fn the_worst_assemblies_state_what_was_drawn() {
    let wheel = "lead = { crowning_um = 4, over = \"face\", zero_mm = 8, right = { slope_um = 5 } }\nrunout = { total_um = 0, face_runout = { um = 9, diameter_mm = 60, high_tooth = 4, face = \"far\" } }";
    let assembly = "face_offset_mm = 2\nmisalignment = { in_plane_um = 4, out_of_plane_um = -3, over_mm = 50 }";
    let stated = text(
        [
            "",
            "runout = { total_um = 8, high_tooth = 3 }",
            "face_offset_mm = 2",
        ],
        "assemblies = 2\n[tolerance.pinion]\nwobble_um = { max = 20 }\nrunout = { scatter = \"rayleigh\", scale_um = 5 }\n",
    );
    let scaled = text(
        [&format!("scale = 1.01\n{wheel}"), "scale = 1.01", assembly],
        "assemblies = 3\nmisalignment = { in_plane_um = { sigma = 5 }, out_of_plane_um = { sigma = 5 } }\n\
         [tolerance.wheel]\nlead = { slope_um = { sigma = 6 }, crowning_um = { max = 9 } }\n",
    );
    for text in [stated, scaled.replace("60.2", "60.8")] {
        let found = result(&text);
        assert!(found.worst.len() > 1);
        for worst in &found.worst {
            let wanted = 1e3 * worst.least_mm.unwrap();
            let again = least(&worst.to_toml().unwrap());
            assert!((again - wanted).abs() < 2e-3, "{again}, {wanted}");
        }
        let losses = found.worst.iter().map(|worst| worst.least_mm.unwrap());
        let spread = losses.clone().fold(f64::MIN, f64::max) - losses.fold(f64::MAX, f64::min);
        assert!(spread > 1e-4, "{spread}");
    }
}
