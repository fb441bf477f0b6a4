//! What an outline cannot do, and what is wrong with a drawing or its pair file.

use super::outlines::copied;
use crate::run;

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
        // It asked for a centre distance of "two drawings".
        (
            &["check", "drawn_20x20.toml", "--map", "map.svg"],
            "--map writes into the folder of -o",
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

/// A smooth curve says where its points have kinks; of several circles inside each centre is reported.
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
    let (code, _, said) = run(folder.path(), &["check", "smooth.toml", "--verbose"]);
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
