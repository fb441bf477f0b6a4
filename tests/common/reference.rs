//! The reference pairs of fixtures/reference/lost_motion, read without the library's input stage.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member};
use serde::Deserialize;
use toml::Table;

/// All names of fixtures/reference/lost_motion, without extension.
pub fn reference_names() -> Vec<String> {
    let kinds = [
        "clear",
        "deviated",
        "everything",
        "fillet",
        "handover",
        "interfering",
    ];
    kinds
        .iter()
        .flat_map(|kind| (1..=3).map(move |n| format!("{kind}_{n}")))
        .collect()
}

/// A reference pair and what was found for it, outside this project.
pub struct ReferencePair {
    pub assembly: GearPair,
    pub poses: Vec<ReferencePose>,
}

#[derive(Debug, Deserialize)]
pub struct ReferencePose {
    pub wheel_tooth: u32,
    pub pinion_tooth: u32,
    pub flank: String,
    pub fraction: f64,
    pub wheel_rotation_rad: f64,
    pub lost_motion_rad: f64,
    pub j_wt_um: f64,
    pub right: ReferenceContact,
    pub left: ReferenceContact,
}

#[derive(Debug, Deserialize)]
pub struct ReferenceContact {
    pub wheel_tooth: u32,
    pub pinion_tooth: u32,
    pub wheel_curve: String,
    pub pinion_curve: String,
    pub wheel_radius_mm: f64,
    pub pinion_radius_mm: f64,
}

impl ReferencePose {
    pub fn mating(&self) -> Mating {
        Mating {
            wheel_tooth: self.wheel_tooth,
            pinion_tooth: self.pinion_tooth,
            flank: match self.flank.as_str() {
                "right" => Side::Right,
                "left" => Side::Left,
                other => panic!("flank {other}"),
            },
            fraction: self.fraction,
        }
    }

    pub fn contact(&self, side: Side) -> &ReferenceContact {
        match side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        }
    }
}

impl ReferenceContact {
    pub fn is_involute(&self) -> bool {
        self.wheel_curve == "involute" && self.pinion_curve == "involute"
    }
}

pub fn reference_file(name: &str) -> String {
    let path = format!("{}/fixtures/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

pub fn reference_pair(name: &str) -> ReferencePair {
    let pair: Table = reference_file(&format!("lost_motion/{name}.toml"))
        .parse()
        .unwrap();
    let distance = number(table(&pair, "assembly").unwrap(), "center_distance_mm").unwrap();
    let assembly = GearPair::with_locked(
        as_built(table(&pair, "wheel").unwrap()),
        as_built(table(&pair, "pinion").unwrap()),
        distance,
        Member::Wheel,
    )
    .unwrap();
    let poses = serde_json::from_str(&reference_file(&format!("lost_motion/{name}.json"))).unwrap();
    ReferencePair { assembly, poses }
}

/// The keys that the reference pairs use, and no others.
fn as_built(gear: &Table) -> AsBuilt {
    check_keys(
        gear,
        "teeth module_mm pressure_angle_deg profile_shift reference_face rack thickness runout pitch",
    );
    let basic_data = BasicGearData::new(
        u32::try_from(gear["teeth"].as_integer().unwrap()).unwrap(),
        number(gear, "module_mm").unwrap(),
        number(gear, "pressure_angle_deg").unwrap().to_radians(),
    )
    .unwrap();
    let rack = table(gear, "rack").unwrap();
    check_keys(rack, "addendum dedendum root_radius");
    let design = GearDesign {
        basic_data,
        profile_shift: number(gear, "profile_shift").unwrap(),
        rack: BasicRack::new(
            number(rack, "addendum").unwrap(),
            number(rack, "dedendum").unwrap(),
            number(rack, "root_radius").unwrap(),
        )
        .unwrap(),
        tip_diameter: None,
    };
    let mut base = design.nominal_base_thickness();
    let mut deviations = Deviations::default();
    if let Some(stated) = table(gear, "thickness") {
        check_keys(stated, "allowance_um per_tooth_um");
        base = thickness::base_from_allowance(
            &basic_data,
            base,
            number(stated, "allowance_um").unwrap() * 1e-3,
        );
        deviations.per_tooth = list_um(stated, "per_tooth_um");
    }
    if let Some(runout) = table(gear, "runout") {
        check_keys(runout, "total_um high_tooth");
        deviations.eccentricity = number(runout, "total_um").unwrap() * 1e-3 / 2.0;
        deviations.high_tooth = number(runout, "high_tooth").unwrap();
    }
    if let Some(pitch) = table(gear, "pitch") {
        check_keys(pitch, "kind right_um left_um");
        assert_eq!(pitch["kind"].as_str(), Some("cumulative"));
        deviations.pitch = Some(Pitch::from_cumulative(
            &list_um(pitch, "right_um"),
            &list_um(pitch, "left_um"),
        ));
    }
    let face = match gear["reference_face"].as_str().unwrap() {
        "front" => Face::Front,
        "back" => Face::Back,
        other => panic!("face {other}"),
    };
    AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
}

fn check_keys(table: &Table, known: &str) {
    for key in table.keys() {
        assert!(
            known.split_whitespace().any(|k| k == key),
            "{key} is not read here"
        );
    }
}

fn table<'a>(parent: &'a Table, key: &str) -> Option<&'a Table> {
    parent.get(key).map(|value| value.as_table().unwrap())
}

fn number(table: &Table, key: &str) -> Option<f64> {
    let value = table.get(key)?;
    Some(
        value
            .as_float()
            .unwrap_or_else(|| value.as_integer().unwrap() as f64),
    )
}

/// A list in µm, in mm; empty where there is none.
fn list_um(table: &Table, key: &str) -> Vec<f64> {
    let Some(values) = table.get(key) else {
        return Vec::new();
    };
    let values = values.as_array().unwrap();
    values
        .iter()
        .map(|value| value.as_float().unwrap() * 1e-3)
        .collect()
}
