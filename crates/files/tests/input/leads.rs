//! Lead deviations as they are read. `tests/corpus/bad/lead-*.toml` holds what is refused, `tests/sessions/along_face.txt` what is warned of.

use super::*;
use gearlash::contact::ExactKernel;
use gearlash::gear::Side;
use gearlash::pair::{Mating, Pose};

/// A spur pair, its wheel with the keys `WHEEL`, its pinion with `PINION`; both 20 mm wide and centred.
pub(super) const SPUR: &str = include_str!("spur.toml");

fn spur(wheel: &str, pinion: &str) -> PairFile {
    study(&SPUR.replace("WHEEL", wheel).replace("PINION", pinion))
}

/// These teeth a fifth of a pitch on.
pub(super) fn mating((wheel_tooth, pinion_tooth): (u32, u32), flank: Side) -> Mating {
    Mating {
        wheel_tooth,
        pinion_tooth,
        flank,
        fraction: 0.2,
    }
}

/// `j_bt` of the first pair at a mating of these teeth, µm.
pub(super) fn j_bt(file: &PairFile, teeth: (u32, u32), flank: Side) -> f64 {
    let run = &file.study.runs().unwrap()[0];
    let pair = run.run.assembly.data().unwrap();
    let pose = Pose::new(pair, mating(teeth, flank));
    let lost = ExactKernel::new(pair).lost_motion(&pose);
    1e3 * lost.unwrap().angle().unwrap() * pair.gear(Member::Pinion).gear().base_radius()
}

/// Backlash that these leads take from the spur pair, µm on the base circles.
fn loss(wheel: &str, pinion: &str) -> f64 {
    let at = |file: &PairFile| j_bt(file, (1, 1), Side::Right);
    at(&spur("", "")) - at(&spur(wheel, pinion))
}

/// Source: a closed form, exact where all teeth are equal: the loss is the greatest sum of leads on the right plus that on the left.
#[test]
fn leads_cost_what_closed_forms_say() {
    for (keys, expected) in [
        // A crown costs nothing if pitch and thickness were measured on it, twice its height if they were measured at an end.
        ("lead = { crowning_um = 8, zero_mm = 10 }", 0.0),
        ("lead = { crowning_um = 8, zero_mm = 0 }", 16.0),
        ("lead = { crowning_um = 8, zero_mm = 20 }", 16.0),
        // Tapered teeth: half the slope on both flanks at one end.
        ("lead = { slope_um = 6, over = \"face\" }", 6.0),
        // The evaluation range is 1 mm shorter at both ends: 5 % of the width.
        (
            "lead = { slope_um = 6, over = \"range\" }",
            6.0 * 20.0 / 18.0,
        ),
        ("lead = { slope_um = 6, range_mm = [5, 15] }", 12.0),
        // A turned helix: half of it at the far end of one flank, and at the near end of the other.
        ("lead = { helix_slope_um = \"6 r\", over = \"face\" }", 6.0),
        ("lead = { helix_slope_um = \"6 l\", over = \"face\" }", 6.0),
        // A helix slope of one flank: half of it.
        (
            "lead.right = { helix_slope_um = \"6 r\" }\nlead.over = \"face\"",
            3.0,
        ),
        // Reliefs only take material off.
        ("lead = { end_relief = { um = 9, length_mm = 4 } }", 0.0),
        // Where the teeth were measured at a relieved end, the rest is thicker.
        (
            "lead = { end_relief = { um = 9, length_mm = 4, end = \"far\" }, zero_mm = 20 }",
            18.0,
        ),
    ] {
        for found in [loss(keys, ""), loss("", keys)] {
            assert!((found - expected).abs() < 1e-6, "{keys}: {found}");
        }
    }
    // Equal slopes of both gears from opposite reference faces cancel: the teeth taper towards each other.
    let tapered = "lead = { slope_um = 6, over = \"face\" }";
    assert!(loss(tapered, tapered).abs() < 1e-6);
    // Equal hands of an external pair add up, opposite ones mesh.
    let turned = "lead = { helix_slope_um = \"6 r\", over = \"face\" }";
    assert!((loss(turned, turned) - 12.0).abs() < 1e-6);
    let mate = "lead = { helix_slope_um = \"6 l\", over = \"face\" }";
    assert!(loss(turned, mate).abs() < 1e-6);
}

/// The offset of the faces moves the pinion's leads: of teeth that taper over 20 mm, 4 mm beyond the middle are in mesh.
#[test]
fn the_offset_moves_the_leads_of_a_spur_pinion() {
    let off = |keys: &str| {
        let text = SPUR.replace("WHEEL", "lead = { crowning_um = 0 }");
        let text = text.replace("= 60.2", "= 60.2\nface_offset_mm = 6");
        j_bt(&study(&text.replace("PINION", keys)), (1, 1), Side::Right)
    };
    let tapered = "lead = { slope_um = 6, over = \"face\" }";
    // Seen by its back, the pinion's reference face is the far one: its thick end is in mesh.
    assert!((off("") - off(tapered) - 6.0).abs() < 1e-6);
    let other = "lead = { slope_um = -6, over = \"face\" }";
    assert!((off("") - off(other) - 6.0 * 8.0 / 20.0).abs() < 1e-6);
}

/// A helical pair with leads of single teeth; hands as written, `FACES` to fill in.
const HELICAL: &str = include_str!("helical_leads.toml");

fn helical(wheel: &str, pinion: &str) -> PairFile {
    study(
        &HELICAL
            .replace("WHEEL_FACE", wheel)
            .replace("PINION_FACE", pinion),
    )
}

/// The pair seen from behind: faces swap, heights change their sign, the right flanks of the picture become the left ones.
#[test]
fn the_pair_seen_from_behind_has_the_same_backlash() {
    let [front, back] = ["front", "back"].map(|name| format!("reference_face = \"{name}\"\n"));
    let (wheel, pinion) = ("face_mm = [-12, 18]", "face_mm = [-5, 40]");
    let front_view = helical(&(front.clone() + wheel), &(back.clone() + pinion));
    let (wheel, pinion) = ("face_mm = [-18, 12]", "face_mm = [-40, 5]");
    let behind = helical(&(back + wheel), &(front + pinion));
    for teeth in [(1, 1), (2, 1), (9, 4)] {
        let seen = j_bt(&front_view, teeth, Side::Right);
        let mirrored = j_bt(&behind, teeth, Side::Left);
        assert!(
            (seen - mirrored).abs() < 1e-6,
            "{teeth:?}: {seen} {mirrored}"
        );
    }
}

/// Every default of `[lead]` is in the echo, which gives the same gears without a warning.
#[test]
fn the_echo_of_leads_states_every_convention() {
    let faces = [
        "face_mm = [-12, 18]",
        "reference_face = \"back\"\nface_mm = [-5, 40]",
    ];
    let helical = helical(faces[0], faces[1]);
    let spur = spur("lead = { helix_slope_um = -4, crowning_um = 3 }", "");
    for file in [&helical, &spur] {
        assert!(!file.warnings.is_empty());
        let again = read_as("pair.json", echo(file).to_string());
        assert_eq!(again.study, file.study);
        assert_eq!(again.spec, file.spec);
        assert_eq!(again.warnings, [""; 0]);
    }
    let lead = &echo(&spur)["wheel"]["lead"];
    let expected = serde_json::json!({
        "helix_slope_um": "4 l", "crowning_um": 3.0, "zero_mm": 10.0, "range_mm": [1.0, 19.0],
        "over": "range", "from": "reference", "axis": "own",
    });
    assert_eq!(*lead, expected);
    let trace = &echo(&helical)["pinion"]["lead"]["left"]["trace"];
    // Heights from the far end of 45 mm.
    let expected = serde_json::json!({
        "from_reference_face_mm": [1.0, 36.0, 44.0], "deviation_um": [2.0, 1.0, -3.0], "direction": "transverse",
    });
    assert_eq!(*trace, expected);
}

/// A reading normal to the teeth is cos β_b of the deviation in the transverse section.
#[test]
fn normal_deviations_become_transverse_ones() {
    let file = helical("face_mm = [-12, 18]", "face_mm = [-5, 40]");
    let helix: f64 = 15f64.to_radians();
    let base = (helix.sin() * 20f64.to_radians().cos()).asin();
    let wheel = file.spec.wheel.data().unwrap();
    let right = wheel.lead.as_ref().unwrap().flanks.right.as_ref().unwrap();
    let trace = &right.trace.as_ref().unwrap().as_list()[0];
    let found = trace.deviation_um.as_ref().unwrap();
    for (found, stated) in found.iter().zip([3.0, 0.0, -4.0]) {
        assert!((found - stated / base.cos()).abs() < 1e-12);
    }
}

/// A table of traces is the same lists, in JSON byte for byte.
#[test]
fn a_table_of_traces_is_the_same_as_lists() {
    let rows = [
        (1, "right", 1.5, 2.25),
        (1, "right", 18.0, -3.5),
        (1, "left", 1.5, -0.75),
        (1, "left", 18.0, 1.0),
        (19, "right", 1.5, 4.0),
        (19, "right", 18.0, 0.5),
    ];
    let mut table = "tooth,flank,from_reference_face_mm,deviation_um\n".to_owned();
    for (tooth, flank, height, um) in rows {
        table += &format!("{tooth},{flank},{height},{um}\n");
    }
    let one = |tooth: u32, um: [f64; 2]| {
        format!("{{ tooth = {tooth}, from_reference_face_mm = [1.5, 18], deviation_um = {um:?} }}")
    };
    let (right, other) = (one(1, [2.25, -3.5]), one(19, [4.0, 0.5]));
    let left = one(1, [-0.75, 1.0]);
    let lists = format!(
        "lead = {{ right = {{ trace = [{right}, {other}] }}, left = {{ trace = {left} }} }}"
    );
    let file = "lead = { trace = { file = \"lead.csv\" } }";
    let german = table.replace(',', ";").replace('.', ",");
    let german = german.replace("from_reference_face_mm", "Höhe [mm]");
    let mut texts = Vec::new();
    for (keys, table) in [(lists.as_str(), &table), (file, &table), (file, &german)] {
        let pair = SPUR.replace("WHEEL", keys).replace("PINION", "");
        let folder = folder(&[("lead.csv", table), ("pair.toml", &pair)]);
        let read = read(&folder.path().join("pair.toml"));
        let read = read.unwrap_or_else(|error| panic!("{error}"));
        let remarks = read.remarks.concat();
        let words = "traces of 2 of 36 right flanks";
        assert!(remarks.contains(words), "{remarks}");
        texts.push(echo(&read).to_string());
    }
    assert_eq!(texts[0], texts[1]);
    assert_eq!(texts[0], texts[2]);
}

/// Without leads the faces of spur gears change nothing.
#[test]
fn faces_alone_change_nothing() {
    let plain = spur("", "");
    assert_eq!(plain.study.face, [0.0; 2]);
    assert_eq!(spur("lead = { crowning_um = 0 }", "").study.face, [0.0; 2]);
    assert_eq!(
        spur("lead = { crowning_um = 1 }", "").study.face,
        [-10.0, 10.0]
    );
}
