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
    let page = stdout(
        command
            .current_dir(folder.path())
            .args("report p.toml -o - --no-certify".split(' ')),
    );
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
