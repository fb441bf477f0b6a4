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

fn checked(folder: &Path, text: &str) -> (Option<i32>, Value) {
    std::fs::write(folder.join("pair.toml"), text).unwrap();
    let (code, json, message) = run(folder, &["check", "pair.toml", "--format", "json"]);
    let json: Value = serde_json::from_str(&json).expect(&message);
    (code, json["files"][0].clone())
}

/// `what`, `gear` and `value` of each remedy.
fn remedies(json: &Value) -> Vec<(String, String, f64)> {
    let word = |remedy: &Value, key: &str| remedy[key].as_str().unwrap().to_owned();
    let list = json["remedies"].as_array().unwrap().iter();
    list.map(|remedy| {
        let value = remedy["value"].as_f64().unwrap();
        let [low, high] = [0, 1].map(|end| remedy["bracket"][end].as_f64().unwrap());
        assert!(
            low <= high && high - low < 0.01 && (value - low).abs() < 2.2,
            "{remedy}"
        );
        (word(remedy, "what"), word(remedy, "gear"), value)
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

/// Every remedy of `text` makes the pair fit, and 2 µm less of it, in the direction `looser` of backlash, does not.
fn each_holds(text: &str, looser: f64) -> Vec<(String, String, f64)> {
    let folder = empty_folder();
    let (code, json) = checked(folder.path(), text);
    assert!(code == Some(1) && !fits(&json));
    let found = remedies(&json);
    for (what, gear, value) in &found {
        let (unit, sense) = match what.as_str() {
            "center_distance_mm" => (1e-3, 1.0),
            "flank_offset_mm" => (1e-3, -1.0),
            _ => (1.0, -1.0),
        };
        let (code, json) = checked(folder.path(), &applied(text, what, gear, *value));
        let verdict = &json["verdict"];
        assert!(fits(&json), "{what} {gear} {value}: {verdict}");
        assert_eq!(code == Some(0), verdict["failed_checks"] == json!([]));
        assert_eq!(json["remedies"], json!([]));
        let less = value - looser * sense * 2.0 * unit;
        let (code, json) = checked(folder.path(), &applied(text, what, gear, less));
        assert!(
            code == Some(1) && !fits(&json),
            "{what} {gear} {less}: {}",
            json["verdict"]
        );
    }
    found
}

/// By hand: no flank offset leaves no backlash at the nominal distance. One gear alone has to be as much thinner as the other is thicker,
/// `2 · 0.1 mm/cos 20° = 212.8 µm`. The distance is that of `assembles_from_mm`. The radial clearance of the thicker gear stays too small.
#[test]
fn a_jam_says_what_to_change() {
    let mut found = each_holds(PRINTED, 1.0);
    let both = |what: &str, value| (what.to_owned(), "both".to_owned(), value);
    assert_eq!(found.remove(0), both("center_distance_mm", 48.561));
    assert_eq!(found.remove(0), both("flank_offset_mm", 0.0));
    assert_eq!(found.remove(0), both("thickness_allowance_um", 0.0));
    let one = |gear: &str, value| ("thickness_allowance_um".to_owned(), gear.to_owned(), value);
    assert_eq!(found[0], one("wheel", -213.0));
    // A thicker wheel's tips come to lie on the fillets of the pinion: more is needed.
    assert!(found[1].1 == "pinion" && found[1].2 <= -213.0, "{found:?}");
    assert_eq!(found.len(), 2);
}

#[test]
fn too_little_and_too_much_backlash_say_what_to_change() {
    let too_little = each_holds(&TOLERANCED.replace("LIMITS", "{ min = 90 }"), 1.0);
    assert_eq!(too_little.len(), 5, "{too_little:?}");
    let too_much = each_holds(&TOLERANCED.replace("LIMITS", "{ max = 130 }"), -1.0);
    assert_eq!(too_much.len(), 5, "{too_much:?}");
    // No single value of the mean makes a tolerance narrower.
    let folder = empty_folder();
    let narrow = TOLERANCED.replace("LIMITS", "{ min = 90, max = 95 }");
    let (code, json) = checked(folder.path(), &narrow);
    assert_eq!((code, &json["remedies"]), (Some(1), &json!([])));
    let (_, text, _) = run(folder.path(), &["check", "pair.toml"]);
    let line = "No single change is enough: the backlash is too little in one place and too great in another.";
    assert!(unfolded(&text).contains(line), "{text}");
}

/// `text` in one line.
fn unfolded(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A drawn pair gets the distance of the gears that were drawn, within the 0.1 µm of each drawing and the step of 1 µm. They were drawn with flanks
/// 0.1 mm out: moved in by that on both gears, or by twice that on one, they have no backlash at the nominal distance.
#[test]
fn a_drawn_pair_gets_the_distance_of_its_data() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("pair.toml"), PRINTED).unwrap();
    for gear in ["wheel", "pinion"] {
        let file = format!("{gear}.dxf");
        let words =
            format!("outline pair.toml --gear {gear} --format dxf --tolerance-um 0.1 -o {file}");
        let words: Vec<&str> = words.split(' ').collect();
        let (code, _, message) = run(folder.path(), &words);
        assert_eq!(code, Some(0), "{message}");
    }
    let at = |distance: &str, require: &str| {
        let text = format!(
            "[wheel.outline]\nfile = \"wheel.dxf\"\n[pinion.outline]\nfile = \"pinion.dxf\"\n[assembly]\ncenter_distance_mm = {distance}\n{require}"
        );
        checked(folder.path(), &text)
    };
    let (code, json) = at("48.0", "");
    assert_eq!(code, Some(1));
    let found = remedies(&json);
    let [(what, gear, value), offsets @ ..] = &found[..] else {
        panic!("{found:?}");
    };
    assert_eq!((&what[..], &gear[..]), ("center_distance_mm", "both"));
    let of_data = remedies(&checked(folder.path(), PRINTED).1);
    assert!((value - of_data[0].2).abs() < 1.5e-3, "{value} {of_data:?}");
    assert!(fits(&at(&format!("{value:.3}"), "").1));
    assert!(!fits(&at(&format!("{:.3}", value - 2e-3), "").1));
    assert!(json["remedies_missing"].is_null(), "{json}");
    for (found, (gear, expected)) in
        offsets
            .iter()
            .zip([("both", -0.1), ("wheel", -0.2), ("pinion", -0.2)])
    {
        assert_eq!((&found.0[..], &found.1[..]), ("flank_offset_mm", gear));
        assert!((found.2 - expected).abs() < 1.5e-3, "{found:?}");
    }
    assert_eq!(offsets.len(), 3);
    // With too much backlash the axes come nearer.
    let limit = "[require]\nj_wt_um = { max = 200 }\n";
    let (code, json) = at("48.9", limit);
    assert_eq!(code, Some(1));
    let found = remedies(&json);
    let (_, _, value) = &found[0];
    assert!(fits(&at(&format!("{value:.3}"), limit).1));
    assert!(!fits(&at(&format!("{:.3}", value + 2e-3), limit).1));
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
    let (_, json) = checked(folder.path(), &stated);
    let mut found = remedies(&json);
    assert_eq!(found.remove(0).0, "center_distance_mm");
    let values: Vec<(&str, f64)> = found.iter().map(|found| (&found.1[..], found.2)).collect();
    assert_eq!(
        values,
        [("both", -0.004), ("wheel", -0.008), ("pinion", -0.008)]
    );
    for (gears, value) in values {
        for (offset, fits) in [(value, true), (value + 0.002, false)] {
            let mut text = stated.clone();
            for gear in ["wheel", "pinion"] {
                if gears == gear || gears == "both" {
                    text += &format!("\n[{gear}.thickness]\nflank_offset_mm = {offset:?}\n");
                }
            }
            std::fs::write(folder.path().join("offset.toml"), text).unwrap();
            let words = ["simulate", "offset.toml", "--format", "json"];
            let (_, json, message) = run(folder.path(), &words);
            let json: Value = serde_json::from_str(&json).expect(&message);
            assert_eq!(json["verdict"]["assembles"], fits, "{gears} {offset}");
        }
    }
}

/// Flanks of both gears 60 µm out raise both roots by 0.06/sin 20° = 0.175 mm, more than the clearance of the tips: no thickness of
/// one gear alone lowers the root of the other.
#[test]
fn a_gear_that_is_not_enough_alone_is_named() {
    let gear = |teeth| {
        format!(
            "teeth = {teeth}\nmodule_mm = 1\npressure_angle_deg = 20\nthickness.flank_offset_mm = 0.06\n"
        )
    };
    let pair = format!(
        "[wheel]\n{}[pinion]\n{}[assembly]\ncenter_distance_mm = 20.9\n",
        gear(12),
        gear(30)
    );
    let folder = empty_folder();
    let (_, json) = checked(folder.path(), &pair);
    assert!(
        remedies(&json).iter().all(|(_, gear, _)| gear == "both"),
        "{json}"
    );
    let alone = ["wheel", "pinion"]
        .map(|gear| format!("No thickness of the {gear} alone was found that is enough."));
    assert_eq!(json["remedies_missing"], json!(alone));
}

/// A file states the thickness before its scale, and a remedy is the gear's own: it has the distance alone.
#[test]
fn a_scaled_pair_gets_the_distance_alone() {
    let folder = empty_folder();
    let scaled = PRINTED.replace("teeth = 12\n", "teeth = 12\nscale = 1.002\n");
    let (code, json) = checked(folder.path(), &scaled);
    assert_eq!(code, Some(1));
    let [(what, _, value)] = &remedies(&json)[..] else {
        panic!("{json}");
    };
    assert_eq!(what, "center_distance_mm");
    let missing = "The thickness is not changed: a gear has a scale.";
    assert_eq!(json["remedies_missing"], json!([missing]));
    assert!(fits(
        &checked(folder.path(), &applied(&scaled, what, "both", *value)).1
    ));
}
