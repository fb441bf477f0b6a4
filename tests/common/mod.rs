//! The reference pairs of `fixtures/reference/lost_motion`, read without gearlash's own input stage.
#![allow(dead_code)]

use gearlash::gear::{
    AsBuilt, Blank, Deviations, Face, Gear, Pitch, Rack, Side, Toothing, thickness,
};
use gearlash::pair::{Assembly, Mating, Member};
use serde_json::Value as Json;
use toml::Value;

pub const REFERENCES: [&str; 18] = [
    "clear_1",
    "clear_2",
    "clear_3",
    "deviated_1",
    "deviated_2",
    "deviated_3",
    "everything_1",
    "everything_2",
    "everything_3",
    "fillet_1",
    "fillet_2",
    "fillet_3",
    "handover_1",
    "handover_2",
    "handover_3",
    "interfering_1",
    "interfering_2",
    "interfering_3",
];

fn path(name: &str) -> String {
    format!(
        "{}/fixtures/reference/lost_motion/{name}",
        env!("CARGO_MANIFEST_DIR")
    )
}

fn number(value: &Value) -> f64 {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|i| i as f64))
        .unwrap()
}

fn numbers_mm(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|v| number(v) * 1e-3)
        .collect()
}

fn gear(table: &Value) -> AsBuilt {
    let get = |key: &str| table.get(key);
    let toothing = Toothing::new(
        get("teeth").unwrap().as_integer().unwrap() as u32,
        number(get("module_mm").unwrap()),
        number(get("pressure_angle_deg").unwrap()).to_radians(),
    )
    .unwrap();
    let rack = get("rack").map_or(Rack::ISO_53_A, |rack| {
        Rack::new(
            number(&rack["addendum"]),
            number(&rack["dedendum"]),
            number(&rack["root_radius"]),
        )
        .unwrap()
    });
    let blank = Blank {
        toothing,
        profile_shift: get("profile_shift").map_or(0.0, number),
        rack,
        tip_diameter: get("tip_diameter_mm").map(number),
    };
    let thick = get("thickness");
    let allowance = thick
        .and_then(|t| t.get("allowance_um"))
        .map_or(0.0, |v| number(v) * 1e-3);
    let base = thickness::base_from_allowance(&toothing, blank.nominal_base_thickness(), allowance);
    let face = match get("reference_face").and_then(Value::as_str) {
        Some("back") => Face::Back,
        _ => Face::Front,
    };
    let runout = get("runout");
    let deviations = Deviations {
        per_tooth: thick
            .and_then(|t| t.get("per_tooth_um"))
            .map_or(vec![], numbers_mm),
        pitch: get("pitch").map(|p| {
            Pitch::from_cumulative(&numbers_mm(&p["right_um"]), &numbers_mm(&p["left_um"]))
        }),
        eccentricity: runout.map_or(0.0, |r| number(&r["total_um"]) * 0.5e-3),
        high_tooth: runout.map_or(1.0, |r| number(&r["high_tooth"])),
    };
    AsBuilt::new(Gear::new(blank, base).unwrap(), face, &deviations).unwrap()
}

/// The pair of a reference file.
pub fn reference_pair(name: &str) -> Assembly {
    let text = std::fs::read_to_string(path(&format!("{name}.toml"))).unwrap();
    let file: Value = text.parse::<toml::Table>().map(Value::Table).unwrap();
    Assembly::new(
        gear(&file["wheel"]),
        gear(&file["pinion"]),
        number(&file["assembly"]["center_distance_mm"]),
        Member::Wheel,
    )
    .unwrap()
}

/// One reference pose: the mating and the slow program's result.
pub struct ReferencePose {
    pub mating: Mating,
    pub wheel_rotation: f64,
    pub lost_motion: f64,
    pub j_wt_um: f64,
    pub json: Json,
}

/// The poses of a reference file.
pub fn reference_poses(name: &str) -> Vec<ReferencePose> {
    let text = std::fs::read_to_string(path(&format!("{name}.json"))).unwrap();
    let poses: Vec<Json> = serde_json::from_str(&text).unwrap();
    let one = |json: Json| ReferencePose {
        mating: Mating {
            wheel_tooth: json["wheel_tooth"].as_u64().unwrap() as u32,
            pinion_tooth: json["pinion_tooth"].as_u64().unwrap() as u32,
            flank: if json["flank"] == "right" {
                Side::Right
            } else {
                Side::Left
            },
            fraction: json["fraction"].as_f64().unwrap(),
        },
        wheel_rotation: json["wheel_rotation_rad"].as_f64().unwrap(),
        lost_motion: json["lost_motion_rad"].as_f64().unwrap(),
        j_wt_um: json["j_wt_um"].as_f64().unwrap(),
        json,
    };
    poses.into_iter().map(one).collect()
}
