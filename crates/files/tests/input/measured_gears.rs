//! Measured gears that deviate along the face, in `[tolerance]` and in matchings with a pair file whose own gears do not.
//! Expected losses are the closed form of tapered teeth: twice the greatest lead, on the base circles.

use super::*;
use gearlash_files::matching::read_match;
use gearlash_files::read_text;
use gearlash_files::tolerance::ToleranceResult;
use std::ops::ControlFlow;

const WHEEL: &str = "teeth = 36\nmodule_mm = 2\npressure_angle_deg = 20\nface_mm = [-10, 20]\n";
const PINION: &str = "teeth = 24\nmodule_mm = 2\npressure_angle_deg = 20\nreference_face = \"back\"\nface_mm = [-20, 10]\n";
/// 30 µm of material over the 27 mm of the evaluation range, 0 in the measuring plane, to be stated of either gear.
const TAPER: &str = "lead = { slope_um = 30, over = \"range\", zero_mm = 10 }\n";
const PLANES: &str = "runout.planes = [{ from_reference_face_mm = 2, total_um = 12, high_tooth = 5 }, { from_reference_face_mm = 28, total_um = 30, high_tooth = 20 }]\n";
const SHOULDER: &str = "runout = { total_um = 4, high_tooth = 3, face_runout = { um = 30, diameter_mm = 60, high_tooth = 9, face = \"far\" } }\n";
/// The measuring planes are 3 mm apart, so the common face is −10 … 13 mm.
const ASSEMBLY: &str = "[assembly]\ncenter_distance_mm = 60.2\nface_offset_mm = 3\n[require]\nj_wt_um = { min = 10 }\n";

fn pair(wheel: &str, pinion: &str) -> String {
    format!("[wheel]\n{WHEEL}{wheel}[pinion]\n{PINION}{pinion}{ASSEMBLY}")
}

fn gear(text: &str) -> String {
    format!("[gear]\n{text}")
}

/// Least and greatest `j_wt` of the pair file's own gears, µm.
fn of_pair(text: &str) -> [f64; 2] {
    let run = of_study(&study(text).study).each.remove(0);
    [run.least, run.greatest].map(|one| 1e3 * one.unwrap().found())
}

/// Assemblies of the plain pair in `folder` with gears of the files that `gears` names.
fn drawn(folder: &TempDir, member: &str, gears: &str, assemblies: u32) -> ToleranceResult {
    let path = folder.path().join("pair.toml");
    let text = format!(
        "{}[tolerance]\nassemblies = {assemblies}\nphase = \"marked\"\ncontribution_rows = 0\n[tolerance.{member}]\ngears = \"{gears}\"\n",
        pair("", "")
    );
    fs::write(&path, text).unwrap();
    drawn_from(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn ends(result: &ToleranceResult) -> [f64; 2] {
    let worst = &result.worst[0];
    [worst.least_mm, worst.greatest_mm].map(|mm| 1e3 * mm.unwrap())
}

fn assert_near(found: [f64; 2], expected: [f64; 2], name: &str) {
    let near = |(found, expected): (f64, f64)| (found - expected).abs() < 2e-3;
    assert!(
        found.into_iter().zip(expected).all(near),
        "{name}: {found:?}, {expected:?}"
    );
}

/// `j_wt` that a taper takes, µm: its lead at 13 mm on either flank.
fn taper_loss() -> f64 {
    let cos = 60.0 * 20f64.to_radians().cos() / 60.2;
    2.0 * 30.0 / 27.0 * 13.0 / cos
}

/// Leads of gear files, of pair files and of files that face the other way.
#[test]
fn leads_of_drawn_gears_count_in_a_population() {
    let expected = of_pair(&pair("", "")).map(|um| um - taper_loss());
    let front = PINION
        .replace("back", "front")
        .replace("[-20, 10]", "[-10, 20]");
    let cases = [
        ("wheel", "w.toml", gear(&format!("{WHEEL}{TAPER}"))),
        ("pinion", "p.toml", gear(&format!("{PINION}{TAPER}"))),
        ("pinion", "p.toml", gear(&format!("{front}{TAPER}"))),
        ("pinion", "p.toml", pair("", TAPER)),
    ];
    for (member, name, text) in cases {
        let folder = folder(&[(name, &text)]);
        let result = drawn(&folder, member, name, 1);
        assert_near(ends(&result), expected, &text);
        let again = of_pair(&result.worst[0].to_toml().unwrap());
        assert_near(again, expected, "worst");
    }
}

/// Runout in two planes and face runout: as in a pair file that states them of its own wheel.
#[test]
fn wobble_of_drawn_gears_counts_in_a_population() {
    let plain = of_pair(&pair("", ""));
    for runout in [PLANES, SHOULDER] {
        let folder = folder(&[("w.toml", &gear(&format!("{WHEEL}{runout}")))]);
        let found = ends(&drawn(&folder, "wheel", "w.toml", 1));
        assert!(found[0] < plain[0] - 1.0, "{found:?}, {plain:?}");
        assert_near(found, of_pair(&pair(runout, "")), runout);
    }
}

/// Two gears that differ by their leads alone: the file of the worst assembly states those of the gear drawn.
#[test]
fn the_worst_assembly_states_the_leads_of_its_gear() {
    let other = TAPER.replace("slope_um = 30", "slope_um = 6");
    let folder = folder(&[
        ("w.toml", &gear(&format!("{WHEEL}{other}"))),
        ("w2.toml", &gear(&format!("{WHEEL}{TAPER}"))),
    ]);
    let result = drawn(&folder, "wheel", "w*.toml", 8);
    let mut seen = Vec::new();
    for worst in &result.worst {
        let found = [worst.least_mm, worst.greatest_mm].map(|mm| 1e3 * mm.unwrap());
        let text = worst.to_toml().unwrap();
        let spec = read_text(Path::new("worst"), &text).unwrap().spec;
        let lead = spec.wheel.data().unwrap().lead.clone().unwrap();
        let um = lead.flanks.both.slope_um.unwrap();
        seen.push(um);
        let loss = taper_loss() * um / 30.0;
        let expected = of_pair(&pair("", "")).map(|plain| plain - loss);
        assert_near(found, expected, &text);
    }
    assert!(seen.contains(&30.0) && seen.contains(&6.0), "{seen:?}");
}

/// Gears of folders: their leads and wobble count. `tests/sessions/along_face.txt` holds what is refused.
#[test]
fn leads_and_wobble_of_matched_gears_count() {
    let own = pair("", "");
    let plain = gear(PINION);
    let matched = |keys: &str| {
        let wheel = gear(&format!("{WHEEL}{keys}"));
        let folder = folder(&[
            ("w/a.toml", &wheel),
            ("pair.toml", &own),
            ("p/a.toml", &plain),
        ]);
        let [file, w, p] = ["pair.toml", "w", "p"].map(|name| folder.path().join(name));
        let found =
            read_match(&file, [&w, &p], None).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let cells = found.cells(0..1, &|| ControlFlow::Continue(())).unwrap();
        let outcome = cells[0].best.outcome;
        [outcome.least, outcome.greatest].map(|mm| 1e3 * mm.unwrap())
    };
    assert_near(
        matched(TAPER),
        of_pair(&own).map(|um| um - taper_loss()),
        TAPER,
    );
    let wobbling = PLANES.replace("total_um = 12", "total_um = 20");
    assert!(matched(&wobbling)[0] < of_pair(&own)[0] - 1.0);
}
