//! Gearbox models (REXS): `import` and `export`.

use super::*;
use std::f64::consts::PI;

fn model() -> String {
    std::fs::read_to_string(fixture("rexs/gearbox.rexs")).unwrap()
}

/// The number of an attribute of a component in a model.
fn value(model: &str, component: &str, attribute: &str) -> f64 {
    let from = model.find(component).unwrap();
    let whole = &model[from..from + model[from..].find("</component>").unwrap()];
    let name = format!("id=\"{attribute}\" unit=\"mm\">");
    let text = &whole[whole.find(&name).unwrap() + name.len()..];
    text[..text.find('<').unwrap()].parse().unwrap()
}

/// Normal and transverse backlash of two gears of this helix angle and allowance of the thickness at a centre distance, mm: the involute by hand,
/// of 20° and a module in the normal section.
fn by_hand(normal: f64, beta: f64, teeth: [f64; 2], allowance: f64, a: f64) -> [f64; 2] {
    let alpha = (20f64.to_radians().tan() / beta.cos()).atan();
    let (module, allowance) = (normal / beta.cos(), allowance / beta.cos());
    let inv = |angle: f64| angle.tan() - angle;
    let sum = teeth[0] + teeth[1];
    let working = (0.5 * module * sum * alpha.cos() / a).acos();
    let thickness: f64 = teeth
        .map(|z| {
            let half = (0.5 * PI * module + allowance) / (module * z) + inv(alpha) - inv(working);
            2.0 * a * z / sum * half
        })
        .iter()
        .sum();
    let j_wt = 2.0 * PI * a / sum - thickness;
    let j_bt = j_wt * working.cos();
    let base = (beta.sin() * 20f64.to_radians().cos()).asin();
    [j_bt * base.cos(), j_bt / alpha.cos()]
}

#[test]
fn a_stage_goes_out_as_a_pair_and_comes_back_with_its_backlash() {
    // Sun and planet of FVA's public planetary sample (REXS 1.1) as an external pair: 17/22, m 4, no helix, a 78 js7, both c25.
    // DIN 3967, d = 68 and 88 mm: −85/−125 µm. ISO 286, 78 mm: ± 15 µm.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("box.rexs"), model()).unwrap();
    gearlash(folder.path())
        .args(["import", "box.rexs", "--stage", "10", "-o", "new/pair.toml"])
        .assert()
        .success()
        .stdout(predicate::str::contains(
            "z 17/22, m 4, a 78 js7, thickness 25c / 25c",
        ));
    gearlash(folder.path())
        .args(["export", "box.rexs", "new/pair.toml", "--stage", "10"])
        .args(["--output", "copy.rexs"])
        .assert()
        .success();
    let copy = std::fs::read_to_string(folder.path().join("copy.rexs")).unwrap();
    let least = by_hand(4.0, 0.0, [17.0, 22.0], -0.085, 77.985);
    let greatest = by_hand(4.0, 0.0, [17.0, 22.0], -0.125, 78.015);
    for (k, section) in ["normal", "transverse"].into_iter().enumerate() {
        for (end, expected) in [("minimum", least[k]), ("maximum", greatest[k])] {
            let found = value(
                &copy,
                "<component id=\"10\"",
                &format!("{end}_{section}_backlash"),
            );
            println!("{end} {section}: {found}, by hand {expected}");
            assert!(
                (found - expected).abs() < 1e-6,
                "{end} {section}: {found} {expected}"
            );
        }
    }
    // Without those four lines it is the model.
    let rest = copy.lines().filter(|line| {
        let of_stage_20 = line.contains(">0.5<");
        !line.contains("_backlash\"") || of_stage_20
    });
    assert_eq!(rest.collect::<Vec<_>>().join("\n") + "\n", model());
}

/// The same stage wound by 15°: a 80.8 js7 is ± 17.5 µm (ISO 286), c25 the same (DIN 3967, d = 70.4 and 91.1 mm). A pair whose hands are exchanged
/// is another one.
#[test]
fn a_helical_stage_comes_back_with_its_backlash() {
    let folder = tempfile::tempdir().unwrap();
    let wound = model()
        .replacen("unit=\"deg\">-0.0<", "unit=\"deg\">15.0<", 1)
        .replacen("unit=\"deg\">0.0<", "unit=\"deg\">-15.0<", 1)
        .replacen(">78.0<", ">80.8<", 1);
    std::fs::write(folder.path().join("box.rexs"), wound).unwrap();
    let import = ["import", "box.rexs", "--stage", "10", "-o", "pair.toml"];
    gearlash(folder.path()).args(import).assert().success();
    let export = "export box.rexs pair.toml --stage 10 -o copy.rexs";
    gearlash(folder.path())
        .args(export.split(' '))
        .assert()
        .success();
    let copy = std::fs::read_to_string(folder.path().join("copy.rexs")).unwrap();
    let beta = f64::to_radians(15.0);
    let least = by_hand(4.0, beta, [17.0, 22.0], -0.085, 80.7825);
    let greatest = by_hand(4.0, beta, [17.0, 22.0], -0.125, 80.8175);
    for (k, section) in ["normal", "transverse"].into_iter().enumerate() {
        for (end, expected) in [("minimum", least[k]), ("maximum", greatest[k])] {
            let found = value(
                &copy,
                "<component id=\"10\"",
                &format!("{end}_{section}_backlash"),
            );
            assert!(
                (found - expected).abs() < 1e-6,
                "{end} {section}: {found} {expected}"
            );
        }
    }
    let pair = std::fs::read_to_string(folder.path().join("pair.toml")).unwrap();
    let other = pair
        .replace("\"left\"", "\"l\"")
        .replace("\"right\"", "\"left\"")
        .replace("\"l\"", "\"right\"");
    assert_ne!(other, pair);
    std::fs::write(folder.path().join("pair.toml"), other).unwrap();
    gearlash(folder.path())
        .args(export.split(' '))
        .assert()
        .code(2)
        .stderr(predicate::str::contains("hand"));
}

#[test]
fn import_names_what_it_leaves_out_and_asks_for_a_stage() {
    let folder = tempfile::tempdir().unwrap();
    let file = fixture("rexs/gearbox.rexs");
    let all = output(gearlash(folder.path()).arg("import").arg(&file));
    for told in [
        "REXS 2.0.0 of gearlash tests, 2 of 8 stages can be read",
        "the flanks of cylindrical_gear 31 have no normal_pressure_angle",
        "ring_gear 43 is internal",
        "Left out: 1 bevel_stage",
        "choose one with --stage ID",
    ] {
        assert!(all.contains(told), "{told}: {all}");
    }
    let one = output(
        gearlash(folder.path())
            .arg("import")
            .arg(&file)
            .args(["--stage", "20"]),
    );
    assert!(
        one.contains("Not used of cylindrical_gear 22: face_width, number_of_teeth"),
        "{one}"
    );
    let toml = &one[one.find("title = ").unwrap()..];
    let written = output(
        gearlash(folder.path())
            .arg("import")
            .arg(&file)
            .args(["--stage", "20", "-o", "-"]),
    );
    assert_eq!(toml, written);
    gearlash(folder.path())
        .args(["simulate", "-"])
        .write_stdin(written)
        .assert()
        .success();
}

#[test]
fn what_cannot_be_done_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("box.rexs"), model()).unwrap();
    std::fs::write(at("small.toml"), SMALL).unwrap();
    let pair = gearlash(folder.path())
        .args(["import", "box.rexs", "--stage", "20", "-o", "pair.toml"])
        .assert()
        .success();
    drop(pair);
    let tight = std::fs::read_to_string(at("pair.toml")).unwrap();
    let tight = tight.replace("nominal_mm = 30.0", "nominal_mm = 28.6");
    std::fs::write(at("jammed.toml"), tight).unwrap();
    std::fs::write(at("jammed.rexs"), model().replace(">30.0<", ">28.6<")).unwrap();
    for (args, code, told) in [
        (
            "import box.rexs -o out.toml",
            2,
            "Several stages can be read",
        ),
        (
            "import box.rexs --stage 30 -o out.toml",
            2,
            "stage 30 is left out: the flanks of cylindrical_gear 31 have no normal_pressure_angle",
        ),
        (
            "import box.rexs --stage 7 -o out.toml",
            2,
            "has no stage 7, its stages are 10, 20",
        ),
        (
            "import box.rexs --stage 10 -o box.rexs",
            2,
            "which was read and would be lost",
        ),
        (
            "export box.rexs pair.toml --stage 20 -o box.rexs",
            2,
            "which was read and would be lost",
        ),
        (
            "export box.rexs pair.toml --stage 20 -o pair.toml",
            2,
            "which was read and would be lost",
        ),
        (
            "export box.rexs pair.toml --stage 10 -o out.rexs",
            2,
            "stage 10 has 17/22 teeth, m 4, the pair file 20/40 teeth, m 1",
        ),
        (
            "export box.rexs small.toml --stage 30 -o out.rexs",
            2,
            "stage 30 is left out: the flanks of cylindrical_gear 31 have no normal_pressure_angle",
        ),
        (
            "export box.rexs jammed.toml --stage 20 -o out.rexs",
            2,
            "stage 20 has centre distance 29.9895…30.0105 mm, the pair file 28.5895…28.6105 mm; export the pair file that gearlash import",
        ),
        (
            "export jammed.rexs jammed.toml --stage 20 -o out.rexs",
            1,
            "nothing is written",
        ),
        ("import small.toml", 2, "no line names a column of teeth"),
    ] {
        gearlash(folder.path())
            .args(args.split(' '))
            .assert()
            .code(code)
            .stderr(predicate::str::contains(told));
    }
    assert_eq!(std::fs::read_to_string(at("box.rexs")).unwrap(), model());
    let mut left: Vec<_> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    left.sort();
    assert_eq!(
        left,
        [
            "box.rexs",
            "jammed.rexs",
            "jammed.toml",
            "pair.toml",
            "small.toml"
        ]
    );
}
