//! The numbers of `simulate` and the lines of verdicts. `tests/sessions/simulate.txt`, `units.txt` and `verdicts.txt` hold what is printed.

use super::*;
use std::f64::consts::PI;

/// The output of `simulate` of a pair file, with these further arguments, as JSON.
fn simulated(folder: &Path, text: &str, arguments: &[&str]) -> Value {
    std::fs::write(folder.join("pair.toml"), text).unwrap();
    let mut command = gearlash(folder);
    command.args(["simulate", "pair.toml", "--format", "json"]);
    serde_json::from_str(&output(command.args(arguments))).unwrap()
}

/// The last columns of the CSV, by their places in a pose of the JSON.
const LAST_COLUMNS: [(&str, &str); 3] = [
    ("/j_r_um", "j_r_um"),
    ("/lost_motion_arcmin/wheel", "lost_motion_wheel_arcmin"),
    ("/lost_motion_arcmin/pinion", "lost_motion_pinion_arcmin"),
];

/// By the lost motion φ of the pinion: j_t = φ m z/2, j_bn = φ r_b, j_wt = φ r_w with r_w = a z/(z_1 + z_2). The lost motions of both gears are as
/// their teeth; 10 800' are π (ISO 21771). j_r = a − a_0, where j_wt cos α_wt = (d_b1 + d_b2) (inv α_wt − inv α_w0), cos α_wt = (r_b1 + r_b2)/a
/// (module 2): a_0 by halving.
#[test]
fn every_pose_has_every_unit_in_json_and_csv() {
    let folder = empty_folder();
    let small = include_str!("small.toml");
    let result = simulated(folder.path(), small, &["-o", "out"]);
    let mut rows = csv::Reader::from_path(folder.path().join("out/result.csv")).unwrap();
    let names = rows.headers().unwrap().clone();
    let mut rows = rows.records();
    for run in result["runs"].as_array().unwrap() {
        let a = run["center_distance_mm"].as_f64().unwrap();
        let arcmin_per_um = |teeth: f64| 10_800.0 / PI * 1e-3 / (a * teeth / 37.0);
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
            let number = |path: &str| pose.pointer(path).unwrap().as_f64().unwrap();
            let (phi, j_wt) = (number("/lost_motion_rad"), number("/j_wt_um"));
            assert!((number("/left_rad") - number("/right_rad") - phi).abs() < 1e-15);
            assert!((-PI..=PI).contains(&number("/right_rad")));
            let [low, high] = ["/j_wt_range_um/0", "/j_wt_range_um/1"].map(number);
            assert!(low < j_wt && j_wt < high);
            let um = 17.0 * 1e3 * phi;
            for (path, expected) in [
                ("/j_t_um", um),
                ("/j_bn_um", um * 20f64.to_radians().cos()),
                ("/j_wt_um", um * a / 37.0),
            ] {
                assert!((number(path) - expected).abs() < 1e-9, "{path}: {pose}");
            }
            let row = rows.next().unwrap().unwrap();
            let last = row.len() - 3..row.len();
            let arcmin = [20.0, 17.0].map(|teeth| j_wt * arcmin_per_um(teeth));
            let expected = [radial_um(j_wt), arcmin[0], arcmin[1]];
            for (column, ((path, name), expected)) in last.zip(LAST_COLUMNS.iter().zip(expected)) {
                // a − a_0 to the rounding of 37 mm, 1e-11 µm and that of the halving.
                let off = (number(path) - expected).abs();
                assert!(off < 1e-12 * expected.abs() + 1e-9, "{path}: {pose}");
                assert_eq!(&names[column], *name);
                assert_eq!(row[column].parse(), Ok(number(path)));
            }
        }
        let summary = &run["summary"];
        for end in ["min", "max"] {
            let j_wt = summary[format!("{end}_j_wt_um")].as_f64().unwrap();
            let wheel = &summary[format!("{end}_lost_motion_arcmin")]["wheel"];
            let off = wheel.as_f64().unwrap() - j_wt * arcmin_per_um(20.0);
            assert!(off.abs() < 1e-12, "{summary}");
        }
    }
    assert!(rows.next().is_none());
}

/// Source: model 3, which asks pair by pair which stretch of the face it touches over, and polygons section by section; widths as
/// [`a_wider_face_never_has_more_play`](../../../tests/exact/helical.rs) in the library.
#[test]
fn helical_gears_have_the_backlash_of_their_face() {
    let folder = empty_folder();
    let text = std::fs::read_to_string(fixture("../docs/files/helical.toml")).unwrap();
    let pitch = "runout = { total_um = 30, high_tooth = 4 }";
    let list: Vec<i32> = (0..27).map(|k| 4 * ((k * 7) % 5) - 8).collect();
    let with = format!(
        "{pitch}\npitch = {{ kind = \"cumulative\", right_um = {list:?}, left_um = {list:?} }}"
    );
    let text = text.replace(pitch, &with) + "\n[sweep]\nsteps_per_pitch = 4\n";
    let mut last = f64::INFINITY;
    for width in [1, 12, 48] {
        let stated = format!("face_width_mm = {width}");
        let text = text
            .replace("face_width_mm = 50", &stated)
            .replace("face_width_mm = 48", &stated);
        let result = simulated(folder.path(), &text, &["--method", "both"]);
        let (mut mean, mut compared) = (0.0, 0);
        let poses = result["runs"][0]["poses"].as_array().unwrap();
        for pose in poses {
            let found = pose["j_wt_um"].as_f64().unwrap();
            let model = pose["analytic"]["line_of_action_um"].as_f64().unwrap();
            // A tip that touches before its pair comes to the line of action leaves less room than the model has.
            let on_line = ["right", "left"]
                .iter()
                .all(|side| pose[side]["class"] == "involute-involute");
            let less = model - found;
            assert!(less > -1e-6 && (less < 1e-6 || !on_line), "{found} {model}");
            compared += u32::from(on_line);
            let section = pose["right"]["section_mm"].as_f64().unwrap();
            assert!(section.abs() <= 0.5 * f64::from(width));
            mean += found / poses.len() as f64;
        }
        assert!(compared > 70, "{compared}");
        assert!(mean < last - 0.1, "{width}: {mean} {last}");
        last = mean;
        let text = result["verdict"]["text"].as_str().unwrap();
        assert!(text.contains(" Proven"), "{text}");
    }
}

/// 5100 poses are written in several pieces, laid out as serde_json lays out the whole; the title's escape is ours. `tests/sessions/large.txt` has numbers.
#[test]
fn a_result_in_pieces_is_laid_out_as_a_whole() {
    let folder = empty_folder();
    let gear = |teeth: u32| json!({ "teeth": teeth, "module_mm": 2.0, "pressure_angle_deg": 20.0 });
    let pair = json!({
        "title": "##[error] in two pieces",
        "wheel": gear(17),
        "pinion": gear(25),
        "assembly": { "center_distance_mm": 42.1 },
        "sweep": { "revolutions": "hunting", "steps_per_pitch": 12 },
    });
    std::fs::write(folder.path().join("large.json"), pair.to_string()).unwrap();
    let words = ["simulate", "large.json", "--no-certify", "--format", "json"];
    let written = output(gearlash(folder.path()).args(words));
    let value: Value = serde_json::from_str(&written).unwrap();
    assert_eq!(value["runs"][0]["poses"].as_array().unwrap().len(), 5100);
    let whole = serde_json::to_string_pretty(&value).unwrap() + "\n";
    assert!(whole.contains("\"##[error]") && !written.contains("##"));
    assert_eq!(written, whole.replace("##[error]", "#\\u0023[error]"));
}

/// The corpus holds the verdicts of some sixty pairs: spur, helical, drawn, jammed, out of mesh.
#[test]
fn every_verdict_of_the_corpus_has_six_short_lines_at_most() {
    let mut count = 0;
    for entry in std::fs::read_dir(fixture("../tests/corpus/expected")).unwrap() {
        let stored = std::fs::read_to_string(entry.unwrap().path()).unwrap_or_default();
        let verdicts = stored.split("verdict.text = ").skip(1);
        for verdict in verdicts.map(|rest| rest.lines().next().unwrap()) {
            let verdict: String = serde_json::from_str(verdict).unwrap();
            count += 1;
            let is_short = verdict.lines().all(|line| line.chars().count() <= 80);
            assert!(is_short && verdict.lines().count() <= 6, "{verdict}");
        }
    }
    assert!(count >= 60, "{count}");
}
