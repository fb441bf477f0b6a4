//! The files of `gearlash gauge`: each is readable as its kind, and none of another gear stays.

use super::command::{folder, gauge, stdout};
use gearlash_files as input;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

fn gear(teeth: u32, more: &str) -> String {
    format!(
        "title = \"g\"\n[gear]\nteeth = {teeth}\nmodule_mm = 1.0\npressure_angle_deg = 20.0\n{more}\n"
    )
}

fn run(folder: &Path, text: &str, more: &[&str]) -> String {
    std::fs::write(folder.join("g.toml"), text).unwrap();
    let arguments = [&["g.toml", "-o", "out", "--steps-per-pitch", "1"], more].concat();
    stdout(&mut gauge(folder, &arguments))
}

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = std::fs::read_dir(folder.join("out")).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// The gear file can be read for every span, and gives the base thickness of the gear by its allowance A_s: s_b = cos α (m π/2 +
/// A_s + m z inv α). W_20 at z 100 touches the tip, as W_12 does at z 44, W_1 and W_2 the form circle.
#[test]
fn a_gear_file_is_never_refused_and_never_wrong() {
    for (teeth, requested) in [
        (100, &["1", "5", "12", "20", "50"][..]),
        (44, &["1", "2", "5", "12", "22", "23"]),
        (45, &["1", "6", "22"]),
        (5, &["1", "2"]),
    ] {
        for k in requested {
            let folder = folder();
            let shift = if teeth < 17 {
                "profile_shift = 0.5\ntip_diameter_mm = 6.6"
            } else {
                ""
            };
            let thin = format!("{shift}\nthickness.allowance_um = -30.0");
            run(folder.path(), &gear(teeth, &thin), &["--span-teeth", k]);
            let read = input::read_gears(&folder.path().join("out/gauge_gear.toml")).unwrap();
            let (_, part) = &read.gears[0].materials[0];
            let alpha = 20f64.to_radians();
            let x = if teeth < 17 { 0.5 } else { 0.0 };
            let thickness = std::f64::consts::FRAC_PI_2 + 2.0 * x * alpha.tan() - 0.03;
            let expected = alpha.cos() * (thickness + f64::from(teeth) * (alpha.tan() - alpha));
            let off = part.gear().base_thickness() - expected;
            assert!(off.abs() < 1e-9, "z {teeth} k {k}: {off}");
        }
    }
}

/// With x = 1.2 the reference circle lies below the involute: no pitch is read, and a gear file would leave it out.
#[test]
fn without_a_statement_there_is_no_gear_file() {
    let folder = folder();
    let text = run(folder.path(), &gear(40, "profile_shift = 1.2"), &[]);
    assert!(
        text.contains("no gear file: the reference circle"),
        "{text}"
    );
    assert!(!folder.path().join("out/gauge_gear.toml").exists());
    assert!(folder.path().join("out/gauge_gear.csv").exists());
}

/// The column of a dimension over three pins is not taken for one over two: that was 35 µm of thickness.
#[test]
fn three_pins_are_not_read_as_two() {
    let folder = folder();
    run(folder.path(), &gear(21, ""), &["--pin-mm", "1.75"]);
    let over = |name: &str| {
        let table = std::fs::read_to_string(folder.path().join("out/gauge_gear.csv")).unwrap();
        let mut others = ["over_two_pins_mm", "over_three_pins_mm"].into_iter();
        let other = others.find(|other| *other != name).unwrap();
        std::fs::write(
            folder.path().join("out/one.csv"),
            table.replacen(other, "other", 1),
        )
        .unwrap();
        let thickness = "thickness.over_pins = { pin_mm = 1.75, file = \"out/one.csv\" }";
        std::fs::write(folder.path().join("again.toml"), gear(21, thickness)).unwrap();
        input::read_gears(&folder.path().join("again.toml"))
    };
    assert!(over("over_two_pins_mm").is_ok());
    let refused = over("over_three_pins_mm").unwrap_err().to_string();
    assert!(
        refused.contains("is a dimension over three pins, allowed is one over two"),
        "{refused}"
    );
}

/// Pitch deviations of both flanks, equally large but different, which every gauge detects. Single pitches are up to 3 µm.
fn uneven(teeth: u32) -> String {
    let right: Vec<f64> = (0..teeth).map(|i| f64::from(i % 4)).collect();
    let left: Vec<f64> = right.iter().rev().copied().collect();
    format!("pitch = {{ kind = \"cumulative\", right_um = {right:?}, left_um = {left:?} }}")
}

/// Files of our own names that belong to the gear before are removed; all others stay, and a failed run removes nothing.
#[test]
fn files_of_another_gear_do_not_stay() {
    let folder = folder();
    run(folder.path(), &gear(21, &uneven(21)), &[]);
    assert!(names(folder.path()).contains("gauge_gear_three_pins.svg"));
    let mine = [
        "gauge_gear_pins_mine.svg",
        "notes.txt",
        "gauge_wheel_pins.svg",
        "gauge_gear_most_pins.svg",
    ];
    for name in mine {
        std::fs::write(folder.path().join("out").join(name), "mine").unwrap();
    }
    // A folder of such a name is not ours.
    std::fs::create_dir(folder.path().join("out/gauge_gear_single_pitch_own.svg")).unwrap();
    let before = names(folder.path());
    std::fs::write(folder.path().join("g.toml"), gear(2, "")).unwrap();
    gauge(folder.path(), &["g.toml", "-o", "out"])
        .assert()
        .code(2);
    assert_eq!(names(folder.path()), before);

    run(folder.path(), &gear(20, &uneven(20)), &[]);
    let after = names(folder.path());
    let gone: Vec<&String> = before.difference(&after).collect();
    assert_eq!(gone, ["gauge_gear_pins.svg", "gauge_gear_three_pins.svg"]);
    assert_eq!(after.difference(&before).count(), 0);
}

/// Single pitch f_i = F_i − F_(i−1), that of tooth 1 from the last: in JSON, in a file of its own that is read as such, in the table
/// a row a tooth, and by position in the text.
#[test]
fn single_pitch_is_gauged_out() {
    let folder = folder();
    let cumulative = [
        0.0, 3.0, -1.5, 4.0, 0.5, 2.0, 1.0, -3.0, 0.0, 2.5, 1.0, -0.5, 3.5, 0.0, -2.0, 1.5, 2.5,
        0.0,
    ];
    let single: Vec<f64> = (0..18)
        .map(|i| cumulative[i] - cumulative[(i + 17) % 18])
        .collect();
    let text = gear(
        18,
        &format!(
            "pitch = {{ kind = \"cumulative\", right_um = {cumulative:?}, left_um = {cumulative:?} }}"
        ),
    );
    let printed = run(folder.path(), &text, &["--positions"]);
    let near = |found: f64, tooth: usize| (found - single[tooth]).abs() < 1e-6;
    let row = printed
        .lines()
        .find(|line| line.trim_start().starts_with("4 "))
        .unwrap();
    assert!(row.contains(" 5.500 "), "{row}");
    assert!(!run(folder.path(), &text, &[]).contains("f own left"));

    let csv = run(folder.path(), &text, &["--format", "csv"]);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let column = reader
        .headers()
        .unwrap()
        .iter()
        .position(|name| name == "single_pitch_own_right_um")
        .unwrap();
    for (tooth, row) in reader.records().enumerate() {
        assert!(near(row.unwrap()[column].parse().unwrap(), tooth));
    }
    let json: Value =
        serde_json::from_str(&run(folder.path(), &text, &["--format", "json"])).unwrap();
    for (tooth, value) in json["gears"][0]["pitch_datum"]["left"]["single_um"]
        .as_array()
        .unwrap()
        .iter()
        .enumerate()
    {
        assert!(near(value.as_f64().unwrap(), tooth));
    }
    for read in ["runout", "roll"] {
        let list = json["gears"][0][read][if read == "roll" { "poses" } else { "readings" }]
            .as_array()
            .unwrap();
        assert!(
            list.iter()
                .all(|one| one["error_bound_um"].as_f64().unwrap() > 0.0),
            "{read}"
        );
    }

    let again = gear(
        18,
        "pitch = { kind = \"single\", file = \"out/gauge_gear.csv\", left = \"single_pitch_own_left_um\", right = \"single_pitch_own_right_um\" }",
    );
    std::fs::write(folder.path().join("again.toml"), again).unwrap();
    let [one, other] = ["g.toml", "again.toml"].map(|name| {
        let read = input::read_gears(&folder.path().join(name)).unwrap();
        read.gears[0].materials[0].1.clone()
    });
    for tooth in 1..=18 {
        for side in gearlash::gear::Side::BOTH {
            let off = one.flank_offset(side, tooth) - other.flank_offset(side, tooth);
            assert!(9.0 * off.abs() < 1e-9);
        }
    }
}

/// The pin that only a cross-check names is the pin: 5.25 mm, where 5.5 would be the usual one.
#[test]
fn a_cross_check_names_the_pin() {
    let folder = folder();
    let text = gear(44, "").replace("module_mm = 1.0", "module_mm = 3.0")
        + "[gear.thickness]\nspan = { teeth = 5, mm = 41.7 }\n[gear.thickness.cross_check]\nover_pins = { pin_mm = 5.25, mm = 139.5 }\n";
    let json: Value =
        serde_json::from_str(&run(folder.path(), &text, &["--format", "json"])).unwrap();
    assert_eq!(json["gears"][0]["pins"]["pin_mm"], 5.25);
    assert_eq!(json["gears"][0]["spans"]["teeth"], 5);
}

/// A chart says what gear it is of, where its zero is, how teeth are numbered, and where its grade's tolerance lies.
#[test]
fn charts_say_what_they_show() {
    let folder = folder();
    run(folder.path(), &gear(21, &uneven(21)), &[]);
    let chart = |name: &str| {
        let svg = std::fs::read_to_string(folder.path().join(format!("out/gauge_gear_{name}.svg")))
            .unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let texts = document.descendants().filter(|node| node.is_text());
        // Symbols have their subscripts in texts of their own.
        let texts = texts.filter_map(|node| node.text());
        texts
            .filter(|text| !text.trim().is_empty())
            .collect::<String>()
    };
    for name in ["spans", "pins", "runout", "pitch_own", "thickness", "roll"] {
        let text = chart(name);
        assert!(text.contains("z 21, m 1 mm, α 20°, x 0"), "{name}: {text}");
        assert!(
            text.contains("numbers ascend clockwise on the reference face"),
            "{name}: {text}"
        );
        assert!(text.contains("− mean"), "{name}: {text}");
    }
    // f_p = 3 µm and d = 21: (0.001 · 21 + 0.4 + 5) √2^(A−5) is 3.83 → 3.8 µm at A = 4, 2.71 → 2.7 at 3.
    let pitch = chart("pitch_own");
    assert!(
        pitch.contains("fpgrade 4, 3.8 µm") && pitch.contains("f from the mean pitch"),
        "{pitch}"
    );
    assert!(
        pitch.contains("Fpgrade") && pitch.contains("right flanks"),
        "{pitch}"
    );
    assert!(chart("runout").contains("Frgrade"));
    assert!(chart("roll").contains("one revolution back to 1"));
    assert!(!chart("spans").contains(">reading<"));
}

/// Seven charts of flat lines were written of a perfect gear.
#[test]
fn a_perfect_gear_has_no_charts() {
    let folder = folder();
    run(folder.path(), &gear(20, ""), &[]);
    let written = names(folder.path());
    let expected = ["gauge_gear.csv", "gauge_gear.toml"].map(str::to_owned);
    assert_eq!(written, BTreeSet::from(expected));
    run(folder.path(), &gear(20, ""), &["--page"]);
    assert_eq!(names(folder.path()), written);
}

/// One page in place of a file each: the same charts, which the page's own ids keep apart.
#[test]
fn a_page_holds_all_charts_of_a_gear() {
    let folder = folder();
    let eccentric = gear(20, "runout = { total_um = 20.0, high_tooth = 3.0 }");
    run(folder.path(), &eccentric, &[]);
    let all = names(folder.path());
    let (charts, others): (Vec<String>, Vec<String>) =
        all.into_iter().partition(|name| name.ends_with(".svg"));
    let read = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let charts: Vec<String> = charts.iter().map(|name| read(name)).collect();
    assert!(charts.len() > 2, "{}", charts.len());
    run(folder.path(), &eccentric, &["--page"]);
    let mut with_page = others.clone();
    with_page.push("gauge_gear.html".to_owned());
    assert_eq!(names(folder.path()), with_page.into_iter().collect());
    let page = read("gauge_gear.html");
    assert!(charts.iter().all(|chart| page.contains(chart)));
    let ids: Vec<&str> = page
        .split(" id=\"")
        .skip(1)
        .map(|id| id.split('"').next().unwrap())
        .collect();
    let distinct: std::collections::BTreeSet<&&str> = ids.iter().collect();
    assert_eq!(distinct.len(), ids.len());
}

/// It began with the number of the last one, 101.
#[test]
fn a_roll_chart_of_many_teeth_begins_with_tooth_one() {
    let folder = folder();
    let eccentric = "runout = { total_um = 20.0, high_tooth = 3.0 }";
    run(folder.path(), &gear(101, eccentric), &[]);
    let svg = |name: &str| {
        std::fs::read_to_string(folder.path().join(format!("out/gauge_gear_{name}.svg"))).unwrap()
    };
    let roll = svg("roll");
    let roll = roxmltree::Document::parse(&roll).unwrap();
    let texts = roll.descendants().filter(|node| node.has_tag_name("text"));
    let numbers: Vec<&str> = texts
        .filter_map(|node| node.text())
        .map(str::trim)
        .filter(|text| text.parse::<u32>().is_ok())
        .collect();
    assert!(numbers.contains(&"20"), "{numbers:?}");
    assert!(!numbers.contains(&"101"), "{numbers:?}");
}

/// One gear has one runout and one grade: what the report shows is what the gauge reads.
#[test]
fn report_and_gauge_grade_alike() {
    let folder = folder();
    let curve = |by: f64| -> Vec<f64> { (0..20).map(|i| by * f64::from((i * 7) % 5)).collect() };
    let wheel = format!(
        "[wheel]\nteeth = 20\nmodule_mm = 1.0\npressure_angle_deg = 20.0\nrunout = {{ total_um = 6.5, high_tooth = 3.2 }}\n\
         pitch = {{ kind = \"cumulative\", right_um = {:?}, left_um = {:?} }}\nthickness.over_pins = {{ pin_mm = 1.75, mm = 22.3 }}\n",
        curve(1.5),
        curve(-1.1)
    );
    let pinion = "[pinion]\nteeth = 21\nmodule_mm = 1.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n";
    let pair = format!(
        "title = \"p\"\n{wheel}{pinion}[assembly]\ncenter_distance_mm = 20.6\n[sweep]\nmating = [[1, 1]]\n"
    );
    std::fs::write(folder.path().join("p.toml"), pair).unwrap();
    let mut command = assert_cmd::Command::cargo_bin("gearlash").unwrap();
    let page = stdout(command.current_dir(folder.path()).args([
        "report",
        "p.toml",
        "-o",
        "-",
        "--no-certify",
    ]));
    let quick = [
        "p.toml",
        "--format",
        "json",
        "--steps-per-pitch",
        "1",
        "--gear",
        "wheel",
    ];
    let read: Value = serde_json::from_str(&stdout(&mut gauge(folder.path(), &quick))).unwrap();
    let graded = read["gears"][0]["grades"]["values"].as_array().unwrap();
    assert_eq!(graded.len(), 9);
    let table = &page[page.find("Accuracy grades").unwrap()..];
    let table = &table[..table.find("</table>").unwrap()];
    // The grades by the standard's formulas.
    let graded_row = |row: &&str| !row.contains("<td class=\"n\">–</td>");
    let rows: Vec<&str> = table.split("<tr>").skip(2).filter(graded_row).collect();
    assert_eq!(rows.len(), 9, "the perfect pinion has none: {table}");
    for (row, one) in rows.iter().zip(graded) {
        let cells = format!(
            "<td class=\"n\">{:.3}</td><td class=\"n\">{}</td>",
            one["measured_um"].as_f64().unwrap(),
            one["grade"]
        );
        assert!(row.contains(&cells), "{row} {cells}");
    }
    // The runout by a ball is not twice the eccentricity.
    let runout = graded.last().unwrap()["measured_um"].as_f64().unwrap();
    assert!(
        graded.last().unwrap()["symbol"] == "F_r" && runout > 7.5,
        "{runout}"
    );
}
