//! Pairs of outlines: pair files with drawings, and two drawings by themselves.

use crate::{fixture, run};
use serde_json::Value;
use std::path::PathBuf;

fn drawn() -> PathBuf {
    fixture("outlines")
}

fn copied() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(drawn()).unwrap() {
        let path = entry.unwrap().path();
        std::fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    folder
}

/// The seventh tooth of the wheel is 180 µm thicker than the others (`wheel_20.toml`): it binds, and nothing else.
#[test]
fn check_names_the_tooth_that_binds() {
    let folder = copied();
    let (code, text, notes) = run(folder.path(), &["check", "drawn_20x20.toml"]);
    assert_eq!(code, Some(1));
    insta::assert_snapshot!(text);
    assert!(notes.contains("20 teeth between diameters"), "{notes}");
}

/// Two drawings and a centre distance say the same as the pair file.
#[test]
fn two_drawings_need_no_pair_file() {
    let folder = copied();
    let drawings = [
        "check",
        "wheel_20.dxf",
        "pinion_20.svg",
        "--center-distance",
        "40.05",
    ];
    let (code, text, _) = run(folder.path(), &drawings);
    let (_, of_file, _) = run(folder.path(), &["check", "drawn_20x20.toml"]);
    let after_title = |text: &str| text.split_once("\n\n").unwrap().1.to_owned();
    assert_eq!((code, after_title(&text)), (Some(1), after_title(&of_file)));
    // Their axes may be found by the tips, which stand on circles about 0,0.
    let fitted = [&drawings[..], &["--center", "fit"]].concat();
    let (code, text, notes) = run(folder.path(), &fitted);
    assert!(
        code == Some(1) && text.contains("Binds at a = 40.050 mm"),
        "{text}"
    );
    assert!(
        notes.contains("centre fitted to the tips: (0.00"),
        "{notes}"
    );
    // Where every tooth has room it turns: exit code 0.
    let apart = [&drawings[..4], &["40.2"]].concat();
    let (code, text, _) = run(folder.path(), &apart);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("Turns freely at a = 40.200 mm"), "{text}");
}

/// The least backlash of the drawn pair is that of the gears they were drawn from, within both tolerances of 20 µm.
#[test]
fn simulate_writes_what_it_found() {
    let folder = copied();
    let (code, _, _) = run(
        folder.path(),
        &["simulate", "drawn_20x20.toml", "-o", "out"],
    );
    assert_eq!(code, Some(0));
    let out = folder.path().join("out");
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    let result: Value = serde_json::from_str(&result).unwrap();
    let run_of = &result["runs"][0];
    assert_eq!(run_of["turns"], false);
    assert_eq!(run_of["poses"].as_array().unwrap().len(), 320);
    assert_eq!(run_of["least"]["right"]["wheel_tooth"], 7);
    let pair = "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[wheel.thickness]\nallowance_um = -60.0\n\
                per_tooth_um = [0, 0, 0, 0, 0, 0, 180, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n\
                [pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[pinion.thickness]\nallowance_um = -60.0\n\
                [assembly]\ncenter_distance_mm = 40.05\n";
    std::fs::write(folder.path().join("data.toml"), pair).unwrap();
    let (_, json, _) = run(
        folder.path(),
        &["simulate", "data.toml", "--format", "json"],
    );
    let data: Value = serde_json::from_str(&json).unwrap();
    let known = data["extremes"][0]["least"]["j_wt_um"]
        .as_array()
        .map_or_else(
            || data["extremes"][0]["least"]["j_wt_um"].as_f64().unwrap(),
            |bracket| bracket[0].as_f64().unwrap(),
        );
    let found = run_of["least"]["j_wt_um"].as_f64().unwrap();
    // Chords cut off metal: two flanks of two gears, each along its normal by up to 20 µm.
    assert!(
        found >= known - 0.01 && found <= known + 4.0 * 20.0 / 20f64.to_radians().cos(),
        "{known} {found}"
    );
    let csv = std::fs::read_to_string(out.join("result.csv")).unwrap();
    assert_eq!(csv.lines().count(), 321);
    let picture = std::fs::read_to_string(out.join("worst.svg")).unwrap();
    assert!(picture.contains("wheel tooth 7"), "{picture}");
}

/// A listed pose, the worst one, and where no picture was asked for.
#[test]
fn snapshots_of_outlines() {
    let folder = copied();
    let pose = [
        "snapshot",
        "drawn_20x20.toml",
        "--mating",
        "3,19",
        "--flank",
        "left",
        "-o",
        "-",
    ];
    let (code, picture, _) = run(folder.path(), &pose);
    assert_eq!(code, Some(0));
    assert!(picture.contains("<svg") && picture.contains("wheel tooth 3 and pinion tooth 19"));
    let (code, picture, said) = run(
        folder.path(),
        &["snapshot", "drawn_20x20.toml", "--worst", "-o", "-"],
    );
    assert_eq!(code, Some(0));
    assert!(
        picture.contains("interference") && said.contains("Binds at"),
        "{said}"
    );
    // The teeth that the sentence names, in the enlarged views and in the mesh zone, and what the colours are.
    assert!(said.contains("at teeth 7·15") && said.contains("and 7·16"));
    for words in [
        ">wheel 7<",
        ">pinion 15<",
        ">pinion 16<",
        ">7<",
        ">15<",
        ">16<",
        ">wheel<",
        ">pinion<",
        ">overlap<",
        ">contact, normal out of the wheel<",
    ] {
        assert!(picture.contains(words), "{words}");
    }
    // Nothing of what only involutes have.
    for words in ["base circle", "line of action"] {
        assert!(!picture.contains(words), "{words}");
    }
    let (code, _, said) = run(
        folder.path(),
        &[
            "snapshot",
            "drawn_20x20.toml",
            "--mating",
            "21,1",
            "--flank",
            "left",
        ],
    );
    assert_eq!(code, Some(2));
    assert!(
        said.contains("the wheel has teeth 1 … 20, not 21"),
        "{said}"
    );
}

/// What needs an involute says so, and what to use; what has no meaning for an outline is refused.
#[test]
fn what_an_outline_cannot_do_is_said() {
    let folder = copied();
    for command in ["compare", "chart", "outline"] {
        let mut args = vec![command, "drawn_20x20.toml"];
        args.extend(match command {
            "chart" => &["--kind", "difference"][..],
            "outline" => &["--format", "svg", "--gear", "wheel"],
            _ => &[],
        });
        let (code, _, said) = run(folder.path(), &args);
        assert_eq!(code, Some(2), "{command}: {said}");
        assert!(
            said.contains("an outline has no module"),
            "{command}: {said}"
        );
    }
    for (args, reason) in [
        (
            &["check", "drawn_20x20.toml", "--method", "polygon"][..],
            "is for gears by their data",
        ),
        (
            &["check", "wheel_20.dxf", "pinion_20.svg"],
            "need their centre distance",
        ),
        (
            &["check", "wheel_20.dxf", "--center-distance", "40"],
            "give two drawings",
        ),
        (
            &["check", "drawn_20x20.toml", "--center-distance", "40"],
            "belong to two drawings",
        ),
        (
            &[
                "simulate",
                "drawn_20x20.toml",
                "--unit",
                "arcmin",
                "--format",
                "csv",
            ],
            "JSON and CSV have every unit",
        ),
        (
            &["simulate", "drawn_20x20.toml", "--at", "wheel"],
            "--at belongs to --unit arcmin",
        ),
        (
            &[
                "chart",
                "drawn_20x20.toml",
                "--kind",
                "map",
                "--unit",
                "arcmin",
            ],
            "--unit belongs to --kind revolution or distance",
        ),
        (
            &["snapshot", "drawn_20x20.toml", "--worst", "--animate"],
            "are for gears by their data",
        ),
    ] {
        let (code, _, said) = run(folder.path(), args);
        assert_eq!(code, Some(2), "{args:?}: {said}");
        assert!(said.contains(reason), "{args:?}: {said}");
    }
}

/// All problems of a pair file at once, each with its key and the way out.
#[test]
fn faults_of_an_outline_have_their_key() {
    let folder = copied();
    let text = "[wheel]\nteeth = 20\n[wheel.outline]\nfile = \"wheel_20.dxf\"\n\
                [pinion.outline]\nfile = \"pinion_20.svg\"\nteeth = 21\nlayer = \"X\"\n\
                [assembly]\ncenter_distance_mm = 20.0\nbearing_clearance_mm = 0.1\n[require]\nj_wt_um = { min = 1 }\nj_bn_um = { min = 1 }\n\
                j_t_um = { max = 1 }\nj_r_um = { max = 1 }\n";
    std::fs::write(folder.path().join("bad.toml"), text).unwrap();
    let (code, _, said) = run(folder.path(), &["check", "bad.toml"]);
    assert_eq!(code, Some(2));
    for reason in [
        "wheel.teeth = 20: given together with outline",
        "pinion.outline.layer = \"X\": belongs to a .dxf file",
        "require.j_bn_um = { min = 1 }: lies along a line of action, which an outline has not",
        "require.j_t_um = { max = 1 }: is an arc of the reference circle",
        "require.j_r_um = { max = 1 }: is worked out of an involute",
    ] {
        assert!(said.contains(reason), "{reason}: {said}");
    }
    let near = "[wheel.outline]\nfile = \"wheel_20.dxf\"\n[pinion.outline]\nfile = \"pinion_20.svg\"\n\
                [assembly]\ncenter_distance_mm = 20.0\n";
    std::fs::write(folder.path().join("near.toml"), near).unwrap();
    let (code, _, said) = run(folder.path(), &["check", "near.toml"]);
    assert_eq!(code, Some(2));
    assert!(said.contains("must be above 22.0000 mm"), "{said}");
}

/// Nothing of a drawing outside the pair file's folder is shown.
#[test]
fn a_drawing_elsewhere_is_not_quoted() {
    let folder = copied();
    let inner = folder.path().join("inner");
    std::fs::create_dir(&inner).unwrap();
    std::fs::write(folder.path().join("secret.csv"), "x,y\npassword,hunter2\n").unwrap();
    let text = "[wheel.outline]\nfile = \"../secret.csv\"\nunits = \"mm\"\n\
                [pinion.outline]\nfile = \"../wheel_20.dxf\"\nlayer = \"X\"\n[assembly]\ncenter_distance_mm = 40\n";
    std::fs::write(inner.join("pair.toml"), text).unwrap();
    let (code, _, said) = run(&inner, &["check", "pair.toml"]);
    assert_eq!(code, Some(2));
    assert!(
        !said.contains("password") && !said.contains("hunter2") && !said.contains("OUTLINE"),
        "{said}"
    );
    assert!(said.contains("not shown"), "{said}");
}

/// What was drawn from a gear looks like it: module, pressure angle, and the shift that its allowance comes to, −60 µm / (2 m tan 20°); a
/// gear of module 1.9 like no standard one, by its m cos 20°. A gear by its data is known and not guessed.
#[test]
fn an_outline_looks_like_what_it_was_drawn_from() {
    let folder = tempfile::tempdir().unwrap();
    let angle = 20f64.to_radians();
    for (name, module) in [("two", "2.0"), ("odd", "1.9")] {
        let gear = format!(
            "[gear]\nteeth = 20\nmodule_mm = {module}\npressure_angle_deg = 20.0\n[gear.thickness]\nallowance_um = -60.0\n"
        );
        std::fs::write(folder.path().join("gear.toml"), gear).unwrap();
        let file = format!("{name}.csv");
        let draw = ["outline", "gear.toml", "--format", "csv", "-o", &file];
        assert_eq!(run(folder.path(), &draw).0, Some(0));
    }
    let pair = "[wheel.outline]\nfile = \"two.csv\"\n[pinion.outline]\nfile = \"odd.csv\"\n[assembly]\ncenter_distance_mm = 39.5\n";
    std::fs::write(folder.path().join("pair.toml"), pair).unwrap();
    let (_, json, said) = run(
        folder.path(),
        &["simulate", "pair.toml", "--format", "json"],
    );
    let result: Value = serde_json::from_str(&json).unwrap_or_else(|_| panic!("{said}"));
    let [two, odd] = &result["fitted_involutes"].as_array().unwrap()[..] else {
        panic!("{result}");
    };
    let standard = &two["standard"][0];
    assert_eq!(
        (&standard["module_mm"], &standard["pressure_angle_deg"]),
        (&2.0.into(), &20.0.into())
    );
    let shift = standard["generating_shift"].as_f64().unwrap();
    assert!((shift + 0.06 / (4.0 * angle.tan())).abs() < 1e-6, "{shift}");
    assert_eq!(odd["standard"], Value::Array(Vec::new()));
    let found = odd["module_times_cos_mm"].as_f64().unwrap();
    assert!((found - 1.9 * angle.cos()).abs() < 1e-6, "{found}");
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    assert!(
        text.contains("the wheel looks like module 2.0 mm, 20°, 20 teeth, x = −0.041"),
        "{text}"
    );
    let data = "[wheel.outline]\nfile = \"two.csv\"\n[pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n[assembly]\ncenter_distance_mm = 40.1\n";
    std::fs::write(folder.path().join("pair.toml"), data).unwrap();
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    assert!(
        text.contains("the wheel looks like") && !text.contains("the pinion looks like"),
        "{text}"
    );
}

/// Source: `check` of the same pair, whose least is −15.61 µm at teeth 7·15 and 7·16 (its snapshot); the wheel's first tooth mates first, and seven pitches on
/// or so the seventh.
#[test]
fn a_chart_marks_where_it_binds() {
    let folder = copied();
    let chart = ["chart", "drawn_20x20.toml", "--kind", "revolution"];
    let (code, _, said) = run(folder.path(), &[&chart[..], &["-o", "chart.svg"]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("Binds at a = 40.050 mm"), "{said}");
    let svg = std::fs::read_to_string(folder.path().join("chart.svg")).unwrap();
    for text in [
        "least −15.6 µm: right flanks 7·15, left flanks 7·16 touch",
        "greatest 174.2 µm: right flanks",
        ">interference<",
        "a = 40.050 mm · 20 pitches, the whole mesh cycle, from mating 1·1 on",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    // Farther apart it turns: nothing below zero.
    let far = [&chart[..], &["--center-distance", "40.2", "-o", "far.svg"]].concat();
    assert_eq!(run(folder.path(), &far).0, Some(0));
    let svg = std::fs::read_to_string(folder.path().join("far.svg")).unwrap();
    assert!(!svg.contains("interference"));
    let (code, _, said) = run(
        folder.path(),
        &[&chart[..], &["--material", "most"]].concat(),
    );
    assert!(
        code == Some(2) && said.contains("is for gears by their data"),
        "{said}"
    );
}

/// Source: −15.61 and 174.18 µm on pitch radii of 40.05/2 mm are −2.680 and 29.901 arcmin, at either gear: both have 20 teeth.
#[test]
fn tables_and_charts_show_lost_motion() {
    let folder = copied();
    for at in [&[][..], &["--at", "wheel"]] {
        let arcmin = [&["--unit", "arcmin"], at].concat();
        let gear = if at.is_empty() { "pinion" } else { "wheel" };
        let table = ["simulate", "drawn_20x20.toml", "--no-files"];
        let (code, text, said) = run(folder.path(), &[&table[..], &arcmin].concat());
        assert_eq!(code, Some(0), "{said}");
        let mut rows = text.lines().skip_while(|row| !row.contains(" arcmin  "));
        assert!(rows.next().unwrap().contains(&format!("{gear} arcmin")));
        assert!(rows.any(|row| row.contains(" -2.680 ")), "{text}");
        let chart = ["chart", "drawn_20x20.toml", "--kind", "revolution"];
        let (code, _, said) = run(folder.path(), &[&chart[..], &arcmin].concat());
        assert_eq!(code, Some(0), "{said}");
        let file = format!("out/drawn_20x20/chart_revolution_a40.05_arcmin_{gear}.svg");
        let svg = std::fs::read_to_string(folder.path().join(file)).unwrap();
        for words in ["least −2.68 arcmin", "greatest 29.90 arcmin"] {
            assert!(svg.contains(words), "{words}");
        }
    }
}

/// Polygons bear out every pose, and leave it where that is not wanted: the same numbers.
#[test]
fn polygons_bear_out_every_pose() {
    let folder = copied();
    let simulate = ["simulate", "drawn_20x20.toml", "--format", "json"];
    let [certified, plain] = [&[][..], &["--no-certify"]].map(|more| {
        let (code, json, said) = run(folder.path(), &[&simulate[..], more].concat());
        assert_eq!(code, Some(0), "{said}");
        serde_json::from_str::<Value>(&json).unwrap()
    });
    assert_eq!(certified["verdict"]["certified"], true);
    assert_eq!(plain["verdict"]["certified"], false);
    let borne_out = |result: &Value| {
        let sentence = result["verdict"]["sentence"].as_str().unwrap();
        sentence.contains("proven and checked by polygons")
    };
    assert!(borne_out(&certified) && !borne_out(&plain));
    assert_eq!(certified["runs"], plain["runs"]);
    assert_eq!(certified["runs"][0]["counts"]["unproven"], 0);
}

/// Source: `simulate` of the same pair at a row's centre distance with as many poses a pitch as the map has columns, 120 / 20, and the same pair's
/// zero-backlash distance.
#[test]
fn a_map_is_what_simulate_finds_at_each_distance() {
    let folder = copied();
    let map = ["check", "drawn_20x20.toml", "--map", "-o", "out"];
    let (code, _, said) = run(folder.path(), &map);
    assert_eq!(code, Some(1), "{said}");
    let svg = std::fs::read_to_string(folder.path().join("out/map_as-measured.svg")).unwrap();
    for text in [
        "40.0714 turns freely from here on",
        "39.4176 a tip on a root circle",
        "pitches from mating 1·1 on",
        "jammed: a tip in a root",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    let csv = std::fs::read_to_string(folder.path().join("out/map_as-measured.csv")).unwrap();
    let cells: Vec<Vec<&str>> = csv
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(cells.len(), 60 * 120);
    for row in cells.chunks(120) {
        let a: f64 = row[0][0].parse().unwrap();
        let binds = row.iter().any(|cell| cell[5] != "clear");
        // Between samples a little is missed, just below.
        assert!(
            binds == (a < 40.0714) || (40.06..40.0714).contains(&a),
            "{a}"
        );
    }
    for row in [20, 40, 59] {
        let row = &cells[120 * row..120 * (row + 1)];
        let text = format!(
            "[wheel.outline]\nfile = \"wheel_20.dxf\"\n[pinion.outline]\nfile = \"pinion_20.svg\"\n\
             [assembly]\ncenter_distance_mm = {}\n[sweep]\nrevolutions = \"hunting\"\nsteps_per_pitch = 6\n",
            row[0][0]
        );
        std::fs::write(folder.path().join("row.toml"), text).unwrap();
        let (_, csv, said) = run(folder.path(), &["simulate", "row.toml", "--format", "csv"]);
        let poses: Vec<Vec<&str>> = csv
            .lines()
            .skip(1)
            .map(|line| line.split(',').collect())
            .collect();
        assert_eq!(poses.len(), 120, "{said}");
        for (cell, pose) in row.iter().zip(&poses) {
            // Wheel tooth, pinion tooth; status; j_wt.
            assert_eq!((&cell[2..4], cell[5]), (&pose[2..4], pose[5]));
            let [there, here] = [cell[6], pose[6]].map(|um| um.parse().unwrap_or(f64::NAN));
            assert!(
                (there - here).abs() < 1e-6 || there.is_nan() && here.is_nan(),
                "{cell:?} {pose:?}"
            );
        }
    }
    // The chart is the same picture.
    let chart = ["chart", "drawn_20x20.toml", "--kind", "map", "-o", "-"];
    let (code, drawn, _) = run(folder.path(), &chart);
    assert_eq!(code, Some(0));
    assert!(drawn == svg);
}

/// `chart --kind map` draws what `check --map` does of gears by their data, too.
#[test]
fn a_map_of_gears_by_their_data_is_a_chart_too() {
    let folder = tempfile::tempdir().unwrap();
    let pair = fixture("karba_86x21.toml");
    let pair = pair.to_str().unwrap();
    run(folder.path(), &["check", pair, "--map", "-o", "out"]);
    let (code, drawn, said) = run(folder.path(), &["chart", pair, "--kind", "map", "-o", "-"]);
    assert_eq!(code, Some(0), "{said}");
    let map = std::fs::read_dir(folder.path().join("out")).unwrap();
    let map = map
        .map(|entry| entry.unwrap().path())
        .find(|path| path.ends_with("map_as-measured.svg"));
    assert!(drawn == std::fs::read_to_string(map.unwrap()).unwrap());
}

/// Source: `check` of the same pair without requirements: −15.61 … 174.18 µm, −2.680 … 29.901 arcmin; jammed at 39.3 mm. Radial clearance: tips at 22 mm,
/// roots at 17.5 mm less what the allowance shifts the rack at most, 0.06/(2 tan 20°) = 0.08 mm: 0.55 … 0.63 mm.
#[test]
fn a_requirement_decides_the_exit_code() {
    let folder = copied();
    let pair = std::fs::read_to_string(folder.path().join("drawn_20x20.toml")).unwrap();
    let jammed = pair.replace("40.05", "39.3");
    for (pair, limits, kept) in [
        (&pair, "j_wt_um = { min = -16, max = 175 }", true),
        (&pair, "j_wt_um = { min = -15 }", false),
        (&pair, "j_wt_um = { max = 174 }", false),
        (
            &pair,
            "lost_motion_arcmin = { max = 29.91, at = \"pinion\" }",
            true,
        ),
        (
            &pair,
            "lost_motion_arcmin = { max = 29.89, at = \"pinion\" }",
            false,
        ),
        (&jammed, "j_wt_um = { max = 1000 }", false),
        (
            &pair,
            "radial_clearance_mm = { min = 0.5, max = 0.7 }",
            true,
        ),
        (&pair, "radial_clearance_mm = { min = 0.7 }", false),
        (&pair, "radial_clearance_mm = { max = 0.5 }", false),
    ] {
        std::fs::write(
            folder.path().join("pair.toml"),
            format!("{pair}[require]\n{limits}\n"),
        )
        .unwrap();
        for command in ["simulate", "check"] {
            let (code, json, said) =
                run(folder.path(), &[command, "pair.toml", "--format", "json"]);
            assert_eq!(
                code,
                Some(if kept { 0 } else { 1 }),
                "{command} {limits}: {said}"
            );
            let verdict: Value = serde_json::from_str(&json).unwrap();
            let verdict = &verdict["verdict"];
            assert_eq!(verdict["requirement"], if kept { "met" } else { "not_met" });
            let sentence = verdict["sentence"].as_str().unwrap();
            let words = if kept {
                "At the poses looked at the pair meets its requirement."
            } else {
                "The pair does not meet its requirement ("
            };
            assert!(sentence.contains(words), "{sentence}");
        }
    }
}

/// A smooth curve says where its points have kinks; of several circles inside each centre is told.
#[test]
fn kinks_and_bores_have_their_places() {
    let folder = copied();
    let points: String = (0..48)
        .map(|k| {
            let (pitch, corner) = (f64::from(k / 4), k % 4);
            let (radius, off) =
                [(10.0, -0.3), (13.0, -0.1), (13.0, 0.1), (10.0, 0.3)][corner as usize];
            let angle = std::f64::consts::FRAC_PI_2 - (pitch + off) * std::f64::consts::TAU / 12.0;
            format!("{:.9},{:.9}\n", radius * angle.cos(), radius * angle.sin())
        })
        .collect();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("points.csv", &format!("# unit: mm\n{points}"));
    let circle = |x: u32| format!("<circle cx=\"{x}\" cy=\"20\" r=\"2\"/>");
    let path: Vec<String> = points.lines().map(|line| line.replace(',', " ")).collect();
    let drawn = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40mm\" height=\"40mm\" viewBox=\"0 0 40 40\">\
         <path transform=\"translate(20 20)\" d=\"M{} Z\"/>{}{}</svg>",
        path.join(" L"),
        circle(20),
        circle(26)
    );
    write("bores.svg", &drawn);
    let pair = |wheel: &str| {
        format!(
            "title = \"t\"\n[wheel.outline]\n{wheel}\n[pinion.outline]\nfile = \"points.csv\"\n[assembly]\ncenter_distance_mm = 23.5\n"
        )
    };
    write(
        "smooth.toml",
        &pair("file = \"points.csv\"\nkind = \"smooth\""),
    );
    let (code, _, said) = run(folder.path(), &["check", "smooth.toml"]);
    assert_eq!(code, Some(0), "{said}");
    // A trapezoid has four corners a tooth, all of more than 30°.
    assert!(
        said.contains("wheel: 12 teeth") && said.contains("48 of them kinks of more than 30°"),
        "{said}"
    );
    write(
        "bores.toml",
        &pair("file = \"bores.svg\"\ncenter_mm = \"bore\""),
    );
    let (code, _, said) = run(folder.path(), &["check", "bores.toml"]);
    assert_eq!(code, Some(2), "{said}");
    assert!(
        said.contains("2 are drawn, about (20.0000, -20.0000) and (26.0000, -20.0000)"),
        "{said}"
    );
}
