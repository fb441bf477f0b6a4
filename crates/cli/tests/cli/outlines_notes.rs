//! Places that `check` reports of a drawing: kinks and bores.

use super::outlines::copied;
use crate::run;

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
    let (code, _, notes) = run(folder.path(), &["check", "smooth.toml", "--verbose"]);
    assert_eq!(code, Some(0), "{notes}");
    // A trapezoid has four corners a tooth, all of more than 30°.
    assert!(
        notes.contains("wheel: 12 teeth") && notes.contains("48 of them kinks of more than 30°"),
        "{notes}"
    );
    write(
        "bores.toml",
        &pair("file = \"bores.svg\"\ncenter_mm = \"bore\""),
    );
    let (code, _, notes) = run(folder.path(), &["check", "bores.toml"]);
    assert_eq!(code, Some(2), "{notes}");
    assert!(
        notes.contains("2 are drawn, about (20.0000, -20.0000) and (26.0000, -20.0000)"),
        "{notes}"
    );
}
