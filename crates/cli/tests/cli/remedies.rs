//! `check` says what to change: each remedy makes the pair assemble and meet its requirement, and 2 µm less of it does not.

use super::*;

/// Printed gears, each flank 0.1 mm too far out.
const PRINTED: &str = include_str!("../../../../tests/corpus/pairs/printed_jam.toml");

/// 24 and 36 teeth with tolerances, and room for `require`.
const TOLERANCED: &str = r#"
title = "toleranced"
[wheel]
teeth = 24
module_mm = 2.0
pressure_angle_deg = 20.0
[wheel.thickness]
allowance_um = { min = -70, max = -40 }
[wheel.runout]
total_um = 12.0
high_tooth = 3.5
[pinion]
teeth = 36
module_mm = 2.0
pressure_angle_deg = 20.0
reference_face = "back"
[pinion.thickness]
allowance_um = { min = -70, max = -40 }
[assembly]
center_distance_mm = 60.0
bearing_clearance_mm = 0.01
[require]
j_bn_um = LIMITS
"#;

/// The JSON of `check` for a pair file. It exits with 1 where something fails.
fn checked(folder: &Path, text: &str) -> Value {
    std::fs::write(folder.join("pair.toml"), text).unwrap();
    let (code, json, message) = run(folder, &["check", "pair.toml", "--format", "json"]);
    let json: Value = serde_json::from_str(&json).expect(&message);
    let found = json["files"][0].clone();
    let passes = fits(&found) && found["verdict"]["failed_checks"] == json!([]);
    assert_eq!(code, Some(i32::from(!passes)), "{found}");
    found
}

/// `what`, `gear` and `value` of each remedy of a pair that does not fit.
fn remedies(json: &Value) -> Vec<(&str, &str, f64)> {
    assert!(!fits(json), "{json}");
    let list = json["remedies"].as_array().unwrap().iter();
    list.map(|remedy| {
        let value = remedy["value"].as_f64().unwrap();
        let [low, high] = [0, 1].map(|end| remedy["bracket"][end].as_f64().unwrap());
        assert!(
            low <= high && high - low < 0.01 && (value - low).abs() < 2.2,
            "{remedy}"
        );
        let [what, gear] = ["what", "gear"].map(|key| remedy[key].as_str().unwrap());
        (what, gear, value)
    })
    .collect()
}

/// Whether the pair assembles and meets its requirement; the checks of other things are left out.
fn fits(json: &Value) -> bool {
    let verdict = &json["verdict"];
    verdict["assembles"] == true
        && ["met", "none"]
            .iter()
            .any(|word| verdict["requirement"] == *word)
}

/// `text` with the `value` of a remedy in place of the stated one; tolerances keep their width.
fn applied(text: &str, what: &str, gear: &str, value: f64) -> String {
    let mut pair: toml::Table = toml::from_str(text).unwrap();
    if what == "center_distance_mm" {
        pair["assembly"]["center_distance_mm"] = value.into();
        return pair.to_string();
    }
    for name in ["wheel", "pinion"] {
        if gear != name && gear != "both" {
            continue;
        }
        let thickness = pair[name]["thickness"].as_table_mut().unwrap();
        let width = thickness.get("allowance_um").and_then(|stated| {
            let end = |key| stated.get(key)?.as_integer();
            let width = (end("max")? - end("min")?) as f64;
            // Two offsets along the normals of the flanks are `A_sn cos α`, 20°.
            let per_um = 0.5e-3 * 20f64.to_radians().cos();
            let is_offset = what == "flank_offset_mm";
            Some(if is_offset { width * per_um } else { width })
        });
        thickness.clear();
        let stated = match width {
            None => value.into(),
            Some(width) => toml::Table::from_iter([
                ("min".to_owned(), (value - width).into()),
                ("max".to_owned(), value.into()),
            ])
            .into(),
        };
        let key = what.replace("thickness_allowance", "allowance");
        thickness.insert(key, stated);
    }
    pair.to_string()
}

/// Every remedy of `text` makes the pair fit, and 2 µm less of it, in the direction `looser` of backlash, does not. Returns what was found.
fn each_holds(text: &str, looser: f64) -> Value {
    let folder = empty_folder();
    let json = checked(folder.path(), text);
    for (what, gear, value) in remedies(&json) {
        let less = match what {
            "center_distance_mm" => value - looser * 2e-3,
            "flank_offset_mm" => value + looser * 2e-3,
            _ => value + looser * 2.0,
        };
        let found = checked(folder.path(), &applied(text, what, gear, value));
        assert!(fits(&found), "{what} {gear} {value}: {}", found["verdict"]);
        assert_eq!(found["remedies"], json!([]));
        let found = checked(folder.path(), &applied(text, what, gear, less));
        assert!(!fits(&found), "{what} {gear} {less}: {}", found["verdict"]);
    }
    json
}

/// By hand: no flank offset leaves no backlash at the nominal distance. One gear alone has to be as much thinner as the other is thicker,
/// `2 · 0.1 mm/cos 20° = 212.8 µm`. The distance is that of `assembles_from_mm`. The radial clearance of the thicker gear stays too small.
#[test]
fn a_jam_says_what_to_change() {
    let json = each_holds(PRINTED, 1.0);
    let found = remedies(&json);
    let expected = [
        ("center_distance_mm", "both", 48.561),
        ("flank_offset_mm", "both", 0.0),
        ("thickness_allowance_um", "both", 0.0),
        ("thickness_allowance_um", "wheel", -213.0),
    ];
    assert_eq!(found[..4], expected);
    // A thicker wheel's tips come to lie on the fillets of the pinion: more is needed.
    let [(_, "pinion", value)] = found[4..] else {
        panic!("{found:?}");
    };
    assert!(value <= -213.0, "{value}");
}

#[test]
fn too_little_and_too_much_backlash_say_what_to_change() {
    for (limits, looser) in [("{ min = 90 }", 1.0), ("{ max = 130 }", -1.0)] {
        let json = each_holds(&TOLERANCED.replace("LIMITS", limits), looser);
        assert_eq!(remedies(&json).len(), 5, "{json}");
    }
    // No single value of the mean makes a tolerance narrower.
    let folder = empty_folder();
    let narrow = TOLERANCED.replace("LIMITS", "{ min = 90, max = 95 }");
    assert_eq!(remedies(&checked(folder.path(), &narrow)), []);
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    let unfolded = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = "No single change is enough: the backlash is too little in one place and too great in another.";
    assert!(unfolded.contains(line), "{text}");
}

/// A drawn pair gets the distance of the gears that were drawn, within the 0.1 µm of each drawing and the step of 1 µm. They were drawn with flanks
/// 0.1 mm out: moved in by that on both gears, or by twice that on one, they have no backlash at the nominal distance.
#[test]
fn a_drawn_pair_gets_the_distance_of_its_data() {
    let folder = empty_folder();
    let folder = folder.path();
    std::fs::write(folder.join("pair.toml"), PRINTED).unwrap();
    for gear in ["wheel", "pinion"] {
        let words = format!(
            "outline pair.toml --gear {gear} --format dxf --tolerance-um 0.1 -o {gear}.dxf"
        );
        output(gearlash(folder).args(words.split(' ')));
    }
    let at = |distance: f64, require: &str| {
        let text = format!(
            "[wheel.outline]\nfile = \"wheel.dxf\"\n[pinion.outline]\nfile = \"pinion.dxf\"\n[assembly]\ncenter_distance_mm = {distance:.3}\n{require}"
        );
        checked(folder, &text)
    };
    // With too much backlash the axes come nearer.
    let limit = "[require]\nj_wt_um = { max = 200 }\n";
    for (distance, require, less) in [(48.0, "", -2e-3), (48.9, limit, 2e-3)] {
        let json = at(distance, require);
        let (what, gear, value) = remedies(&json)[0];
        assert_eq!((what, gear), ("center_distance_mm", "both"));
        assert!(fits(&at(value, require)));
        assert!(!fits(&at(value + less, require)));
    }
    let json = at(48.0, "");
    assert!(json["remedies_missing"].is_null(), "{json}");
    let offsets = &remedies(&json)[1..];
    assert_eq!(offsets.len(), 3);
    let expected = [("both", -0.1), ("wheel", -0.2), ("pinion", -0.2)];
    for ((what, gear, value), expected) in offsets.iter().zip(expected) {
        assert_eq!((*what, *gear), ("flank_offset_mm", expected.0));
        assert!((value - expected.1).abs() < 1.5e-3, "{gear}: {value}");
    }
}

/// The pair lacks 15.61 µm of `j_wt` on its flanks: `15.61 cos 20° / 4` = 3.7 µm on each of four flanks, 7.3 µm on each of two. Each
/// remedy makes it assemble, and 2 µm less does not.
#[test]
fn a_drawn_jam_says_which_offset_fits() {
    let folder = empty_folder();
    for name in ["wheel_20.dxf", "pinion_20.svg"] {
        std::fs::copy(fixture("outlines").join(name), folder.path().join(name)).unwrap();
    }
    let stated = std::fs::read_to_string(fixture("outlines/drawn_20x20.toml")).unwrap();
    let json = checked(folder.path(), &stated);
    let found = remedies(&json);
    assert_eq!(found[0].0, "center_distance_mm");
    let offset = |gear, value| ("flank_offset_mm", gear, value);
    let expected = [
        offset("both", -0.004),
        offset("wheel", -0.008),
        offset("pinion", -0.008),
    ];
    assert_eq!(found[1..], expected);
    for (_, gears, value) in expected {
        for (offset, fits) in [(value, true), (value + 0.002, false)] {
            let mut text = stated.clone();
            for gear in ["wheel", "pinion"] {
                if gears == gear || gears == "both" {
                    text += &format!("\n[{gear}.thickness]\nflank_offset_mm = {offset:?}\n");
                }
            }
            std::fs::write(folder.path().join("offset.toml"), text).unwrap();
            let json = json_of(folder.path(), "simulate offset.toml");
            assert_eq!(json["verdict"]["assembles"], fits, "{gears} {offset}");
        }
    }
}

/// Flanks of both gears 60 µm out raise both roots by 0.06/sin 20° = 0.175 mm, more than the clearance of the tips: no thickness of
/// one gear alone lowers the root of the other.
#[test]
fn a_gear_that_is_not_enough_alone_is_named() {
    let gear = "module_mm = 1\npressure_angle_deg = 20\nthickness.flank_offset_mm = 0.06\n";
    let pair = format!(
        "[wheel]\nteeth = 12\n{gear}[pinion]\nteeth = 30\n{gear}[assembly]\ncenter_distance_mm = 20.9\n"
    );
    let json = checked(empty_folder().path(), &pair);
    let is_of_both = remedies(&json).iter().all(|(_, gear, _)| *gear == "both");
    assert!(is_of_both, "{json}");
    let alone = ["wheel", "pinion"]
        .map(|gear| format!("No thickness of the {gear} alone was found that is enough."));
    assert_eq!(json["remedies_missing"], json!(alone));
}

/// A file states the thickness before its scale, and a remedy is the gear's own: it has the distance alone.
#[test]
fn a_scaled_pair_gets_the_distance_alone() {
    let folder = empty_folder();
    let scaled = PRINTED.replace("teeth = 12\n", "teeth = 12\nscale = 1.002\n");
    let json = checked(folder.path(), &scaled);
    let [(what @ "center_distance_mm", gear, value)] = remedies(&json)[..] else {
        panic!("{json}");
    };
    let missing = "The thickness is not changed: a gear has a scale.";
    assert_eq!(json["remedies_missing"], json!([missing]));
    let found = checked(folder.path(), &applied(&scaled, what, gear, value));
    assert!(fits(&found));
}
