//! Snapshots, charts and maps of outlines.

use super::outlines::copied;
use crate::{fixture, run};

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
    assert!(picture.contains("<svg") && picture.contains("wheel 3 with pinion 19"));
    let (code, picture, said) = run(
        folder.path(),
        &["snapshot", "drawn_20x20.toml", "--worst", "-o", "-"],
    );
    assert_eq!(code, Some(0));
    assert!(
        picture.contains("interference") && said.contains("Does not assemble at"),
        "{said}"
    );
    // The teeth that the verdict names, in the enlarged views and in the mesh zone, and what the colours are.
    assert!(said.contains("teeth 7·15 / 7·16"), "{said}");
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
        ">contact, normal out of the locked gear<",
    ] {
        assert!(picture.contains(words), "{words}");
    }
    // Nothing that only involutes have.
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

/// Source: `check` of the same pair, whose least is −15.61 µm at teeth 7·15 and 7·16 (its snapshot); the wheel's first tooth mates first, and seven pitches on
/// or so the seventh.
#[test]
fn a_chart_marks_where_it_binds() {
    let folder = copied();
    let chart = ["chart", "drawn_20x20.toml", "--kind", "revolution"];
    let (code, _, said) = run(folder.path(), &[&chart[..], &["-o", "chart.svg"]].concat());
    assert_eq!(code, Some(0), "{said}");
    assert!(
        said.contains("Does not assemble at a = 40.050 mm"),
        "{said}"
    );
    let svg = std::fs::read_to_string(folder.path().join("chart.svg")).unwrap();
    for text in [
        "least −15.6 µm: right flanks 7·15, left flanks 7·16 touch",
        "greatest 174.2 µm: right flanks",
        ">interference<",
        "a = 40.050 mm",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    // At a greater distance it turns: nothing below zero.
    let far = [&chart[..], &["--center-distance", "40.2", "-o", "far.svg"]].concat();
    assert_eq!(run(folder.path(), &far).0, Some(0));
    let svg = std::fs::read_to_string(folder.path().join("far.svg")).unwrap();
    assert!(!svg.contains("interference"));
    let (code, _, said) = run(
        folder.path(),
        &[&chart[..], &["--material", "most"]].concat(),
    );
    assert!(
        code == Some(2) && said.contains("states one thickness a gear"),
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
        assert!(text.contains(&format!("−2.680′ {gear}")), "{text}");
        let mut rows = text.lines().skip_while(|row| !row.contains("greatest, "));
        assert!(rows.next().unwrap().contains(&format!("least, {gear}")));
        // −15.607 µm: the least of the poses swept.
        assert!(rows.any(|row| row.contains(" -2.6794 ")), "{text}");
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
        "40.0714 assembles from here on",
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
            assert_eq!((&cell[2..4], cell[5]), (&pose[4..6], pose[19]));
            let [there, here] = [cell[6], pose[13]].map(|um| um.parse().unwrap_or(f64::NAN));
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
