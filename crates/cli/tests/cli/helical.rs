//! Pictures and pages of helical pairs.

use super::{empty_folder, files, run};
use std::path::Path;

/// The pairs of docs/explanation/helical-gears.md in a folder of their own: common face −24 … 24 mm.
fn folder() -> tempfile::TempDir {
    let folder = empty_folder();
    let files = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/files");
    for (from, to) in [("helical", "pair"), ("helical_measured", "measured")] {
        let [from, to] = [from, to].map(|name| format!("{name}.toml"));
        std::fs::copy(files.join(from), folder.path().join(to)).unwrap();
    }
    folder
}

fn drawn(folder: &Path, args: &[&str]) -> String {
    let (code, picture, message) = run(folder, args);
    assert_eq!(code, Some(0), "{message}");
    picture
}

fn refused(folder: &Path, args: &[&str], why: &str) {
    let (code, _, message) = run(folder, args);
    assert_eq!(code, Some(2), "{message}");
    assert!(message.contains(why), "{message}");
}

const POSE: [&str; 6] = [
    "snapshot",
    "pair.toml",
    "--mating",
    "4,16",
    "--flank",
    "right",
];

fn section(folder: &Path, at: &[&str]) -> String {
    drawn(folder, &[&POSE[..], at, &["-o", "-"]].concat())
}

/// Teeth wind by b tan β/r: over 24 mm by 24 tan 21°/65.0720 rad, 0.6084 of a pitch of the 27 teeth. Eccentricities alone leave the backlash the
/// same in every section, so that the flanks touch wherever the picture is of.
#[test]
fn a_snapshot_is_of_a_section() {
    let folder = folder();
    let at = |z: &str| section(folder.path(), &["--section", z]);
    let [near, middle, far] = ["-24", "0", "24"].map(at);
    for (picture, z) in [(&near, "−24"), (&middle, "0"), (&far, "24")] {
        assert!(picture.contains(&format!("section at z = {z} mm")), "{z}");
        assert!(picture.contains("wheel 4 with pinion 16 at the right flank"));
        assert!(picture.contains("over the face −24 … 24 mm"));
        assert!(picture.contains("Right flanks touch"));
    }
    assert!(near != middle && middle != far);
    // By default where the flank touches.
    let own = section(folder.path(), &[]);
    assert!(own.contains("section at z = ") && own.contains("Right flanks touch"));
}

/// Over a pitch every section turns by 360°/z, the wheel's by 360°/27 (z_1 φ_1 = −z_2 φ_2 but for the eccentricities).
#[test]
fn an_animation_turns_a_section() {
    let folder = folder();
    let pose = [
        "--mating",
        "4,16",
        "--flank",
        "right",
        "--animate",
        "-o",
        "-",
    ];
    for at in [&[][..], &["--section", "-8"]] {
        let args = [&["snapshot", "measured.toml"], &pose[..], at].concat();
        let picture = drawn(folder.path(), &args);
        let document = roxmltree::Document::parse(&picture).unwrap();
        assert!(picture.contains("section at z = "));
        let turns = document
            .descendants()
            .filter(|node| node.has_tag_name("animateTransform"));
        let last = turns.map(|node| {
            let values = node.attribute("values").unwrap();
            let last = values.rsplit(';').next().unwrap();
            last.split(' ').next().unwrap().parse::<f64>().unwrap()
        });
        let last: Vec<f64> = last.collect();
        let wheel = last
            .iter()
            .filter(|turn| (turn.abs() - 360.0 / 27.0).abs() < 1e-3);
        let pinion = last
            .iter()
            .filter(|turn| (turn.abs() - 360.0 / 51.0).abs() < 0.02);
        assert!(wheel.count() >= 3 && pinion.count() >= 3, "{last:?}");
    }
    let own = section(folder.path(), &["--animate"]);
    assert_eq!(own, section(folder.path(), &["--animate"]));
}

#[test]
fn simulate_draws_sections() {
    let folder = folder();
    drawn(
        folder.path(),
        &["simulate", "pair.toml", "--snapshots", "-o", "out"],
    );
    let pictures = files(&folder.path().join("out"));
    let pictures: Vec<&String> = pictures
        .iter()
        .filter(|name| name.ends_with(".svg"))
        .collect();
    // The worst, and two a run: three distances, two materials.
    assert_eq!(pictures.len(), 1 + 12);
    for name in pictures {
        let picture = std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        assert!(picture.contains("section at z = "), "{name}");
    }
}

/// The binding contact has the name that `snapshot --worst` and the verdict use.
#[test]
fn a_chart_shows_the_field_of_action() {
    let folder = folder();
    let chart = |extra: &[&str]| {
        let args = [
            &["chart", "measured.toml", "--kind", "field", "-o", "-"],
            extra,
        ]
        .concat();
        drawn(folder.path(), &args)
    };
    let (_, _, message) = run(
        folder.path(),
        &["chart", "measured.toml", "--kind", "field", "-o", "-"],
    );
    assert!(message.contains("teeth 5·14 / 3·17"), "{message}");
    let picture = chart(&[]);
    roxmltree::Document::parse(&picture).unwrap();
    for words in [
        "Right flanks: wheel 5 on pinion 14 binds at z = −24 mm, tip-involute",
        "Left flanks: wheel 3 on pinion 17 binds along its line, z = ",
        "transverse gap, µm",
        "tip circle of the pinion",
        "axial position z, mm",
    ] {
        assert!(picture.contains(words), "{words}");
    }
    assert_eq!(chart(&["--center-distance", "190"]), picture);
    assert!(chart(&["--center-distance", "190.05"]).contains("a = 190.050 mm"));
    drawn(
        folder.path(),
        &[
            "chart",
            "pair.toml",
            "--kind",
            "field",
            "--material",
            "least",
        ],
    );
    assert_eq!(
        files(&folder.path().join("out/pair")),
        ["chart_field_a189.977_least.svg"]
    );
    let spur = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/karba_44x44.toml");
    refused(
        folder.path(),
        &["chart", spur.to_str().unwrap(), "--kind", "field"],
        "--kind field is for helical gears",
    );
}

#[test]
fn every_chart_is_drawn_of_helical_pairs() {
    let folder = folder();
    for kind in ["revolution", "distance", "difference", "inspection", "map"] {
        let args = ["chart", "measured.toml", "--kind", kind, "-o", "-"];
        let (_, picture, message) = run(folder.path(), &args);
        assert!(picture.starts_with("<svg"), "{kind}: {message}");
    }
}

/// The first screen is that of a spur pair. The loss by the face is that of the library, and j_n has its formula.
#[test]
fn a_page_tells_what_the_face_width_costs() {
    let folder = folder();
    let (code, page, message) = run(folder.path(), &["report", "measured.toml", "-o", "-"]);
    assert_eq!(code, Some(0), "{message}");
    let document = scraper::Html::parse_document(&page);
    let text = |selector: &str| -> Vec<String> {
        let selector = scraper::Selector::parse(selector).unwrap();
        let words = |element: scraper::ElementRef| {
            let words = element.text().flat_map(str::split_whitespace);
            words.collect::<Vec<_>>().join(" ")
        };
        document.select(&selector).map(words).collect()
    };
    assert_eq!(text("#result .answer")[0], "Assembles at a = 190.000 mm.");
    assert_eq!(text("#result .extremes .value")[0], "240.35 µm");
    let rows = text("#face table:first-of-type tbody tr");
    let widths: Vec<&String> = rows.iter().take(5).collect();
    for (row, width) in widths.iter().zip(["0 ", "12 ", "24 ", "36 ", "48 "]) {
        assert!(
            row.starts_with(width) && row.matches("proven").count() == 2,
            "{row}"
        );
    }
    assert!(
        widths[4].contains("240.35") && widths[4].contains("333.86"),
        "{}",
        widths[4]
    );
    let all = text("#face").join(" ");
    for words in [
        "j bt cos β b = j t cos α n cos β",
        "Three definitions of a normal backlash j n",
    ] {
        assert!(all.contains(words), "{words}");
    }
    let all = text("main").join(" ");
    assert!(!all.contains("Helical gears, lead"));
    for words in [
        "base helix angle",
        "normal module",
        "face offset: the pinion’s measuring plane",
        "All three count in the transverse section",
        "Accuracy grades after ISO 1328-1:2013",
        "by the reference diameter d and the normal module m n",
    ] {
        assert!(all.contains(words), "{words}");
    }
    assert!(all.contains("Drawn in the section at z = "));
}
