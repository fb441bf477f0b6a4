//! Reads `fixtures/reference/lost_motion`: pairs as TOML, poses as JSON. Only the keys those files use.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member};
use serde_json::Value as Json;
use std::path::{Path, PathBuf};
use toml::Value as Toml;

/// One pose of the reference data.
pub struct Case {
    pub name: String,
    pub mating: Mating,
    pub j_wt_um: f64,
    pub result: Json,
}

/// All pairs with their poses.
pub fn pairs() -> Vec<(GearPair, Vec<Case>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/reference/lost_motion");
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .expect("reference folder")
        .map(|entry| entry.expect("entry").path())
        .filter(|path| path.extension().is_some_and(|ext| ext == "toml"))
        .collect();
    files.sort();
    files.iter().map(|path| pair(path)).collect()
}

fn pair(path: &Path) -> (GearPair, Vec<Case>) {
    let text = std::fs::read_to_string(path).expect("pair file");
    let file: Toml = toml::from_str(&text).expect("TOML");
    let distance = number(&file["assembly"]["center_distance_mm"]);
    let assembly = GearPair::with_locked(
        gear(&file["wheel"]),
        gear(&file["pinion"]),
        distance,
        Member::Wheel,
    )
    .expect("pair");
    let text = std::fs::read_to_string(path.with_extension("json")).expect("results");
    let results: Vec<Json> = serde_json::from_str(&text).expect("JSON");
    let cases = results
        .into_iter()
        .map(|result| {
            let tooth = |key: &str| result[key].as_u64().expect("tooth") as u32;
            let mating = Mating {
                wheel_tooth: tooth("wheel_tooth"),
                pinion_tooth: tooth("pinion_tooth"),
                flank: match result["flank"].as_str() {
                    Some("right") => Side::Right,
                    _ => Side::Left,
                },
                fraction: result["fraction"].as_f64().expect("fraction"),
            };
            Case {
                name: format!("{} {mating:?}", path.file_stem().unwrap().display()),
                mating,
                j_wt_um: result["j_wt_um"].as_f64().expect("j_wt"),
                result,
            }
        })
        .collect();
    (assembly, cases)
}

fn gear(table: &Toml) -> AsBuilt {
    let value = |key: &str| number(&table[key]);
    let rack = &table["rack"];
    let teeth = table["teeth"].as_integer().expect("teeth") as u32;
    let basic_data = BasicGearData::new(
        teeth,
        value("module_mm"),
        value("pressure_angle_deg").to_radians(),
    )
    .expect("toothing");
    let design = GearDesign {
        basic_data,
        profile_shift: value("profile_shift"),
        rack: BasicRack::new(
            number(&rack["addendum"]),
            number(&rack["dedendum"]),
            number(&rack["root_radius"]),
        )
        .expect("rack"),
        tip_diameter: None,
    };
    let allowance = table
        .get("thickness")
        .and_then(|table| table.get("allowance_um"))
        .map_or(0.0, number);
    let base = thickness::base_from_allowance(
        &basic_data,
        design.nominal_base_thickness(),
        allowance / 1000.0,
    );
    let mut deviations = Deviations::default();
    if let Some(list) = table.get("thickness").and_then(|t| t.get("per_tooth_um")) {
        deviations.per_tooth = numbers(list);
    }
    if let Some(runout) = table.get("runout") {
        deviations.eccentricity = number(&runout["total_um"]) / 2000.0;
        deviations.high_tooth = number(&runout["high_tooth"]);
    }
    if let Some(pitch) = table.get("pitch") {
        assert_eq!(pitch["kind"].as_str(), Some("cumulative"));
        deviations.pitch = Some(Pitch::from_cumulative(
            &numbers(&pitch["right_um"]),
            &numbers(&pitch["left_um"]),
        ));
    }
    let face = match table["reference_face"].as_str() {
        Some("back") => Face::Back,
        _ => Face::Front,
    };
    AsBuilt::new(Gear::new(design, base).expect("gear"), face, &deviations).expect("as built")
}

fn number(value: &Toml) -> f64 {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|whole| whole as f64))
        .expect("number")
}

/// A list of µm as mm.
fn numbers(value: &Toml) -> Vec<f64> {
    let list = value.as_array().expect("list");
    list.iter().map(|entry| number(entry) / 1000.0).collect()
}
