//! The reference pairs of fixtures/reference/lost_motion, read without the library's input stage.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member};
use serde::Deserialize;
use std::collections::BTreeMap;

/// All names of fixtures/reference/lost_motion, without extension.
pub fn reference_names() -> Vec<String> {
    let kinds = "clear deviated everything fillet handover interfering";
    let each = kinds.split(' ');
    each.flat_map(|kind| (1..=3).map(move |n| format!("{kind}_{n}")))
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
                _ => Side::Left,
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
    let text = reference_file(&format!("lost_motion/{name}.toml"));
    let pair: PairTable = toml::from_str(&text).unwrap();
    let assembly = GearPair::with_locked(
        pair.wheel.as_built(),
        pair.pinion.as_built(),
        pair.assembly["center_distance_mm"],
        Member::Wheel,
    )
    .unwrap();
    let poses = serde_json::from_str(&reference_file(&format!("lost_motion/{name}.json"))).unwrap();
    ReferencePair { assembly, poses }
}

#[derive(Deserialize)]
struct PairTable {
    wheel: GearTable,
    pinion: GearTable,
    assembly: BTreeMap<String, f64>,
}

/// The keys that the reference pairs use, and no others.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GearTable {
    teeth: u32,
    module_mm: f64,
    pressure_angle_deg: f64,
    profile_shift: f64,
    reference_face: String,
    rack: BTreeMap<String, f64>,
    thickness: Option<ThicknessTable>,
    runout: Option<BTreeMap<String, f64>>,
    pitch: Option<PitchTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ThicknessTable {
    allowance_um: f64,
    #[serde(default)]
    per_tooth_um: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PitchTable {
    kind: String,
    right_um: Vec<f64>,
    left_um: Vec<f64>,
}

impl GearTable {
    fn as_built(&self) -> AsBuilt {
        let mm = |um: &[f64]| -> Vec<f64> { um.iter().map(|um| um * 1e-3).collect() };
        let angle = self.pressure_angle_deg.to_radians();
        let basic_data = BasicGearData::new(self.teeth, self.module_mm, angle).unwrap();
        let rack = ["addendum", "dedendum", "root_radius"].map(|key| self.rack[key]);
        let design = GearDesign {
            basic_data,
            profile_shift: self.profile_shift,
            rack: BasicRack::new(rack[0], rack[1], rack[2]).unwrap(),
            tip_diameter: None,
        };
        let mut base = design.nominal_base_thickness();
        let mut deviations = Deviations::default();
        if let Some(stated) = &self.thickness {
            let allowance = stated.allowance_um * 1e-3;
            base = thickness::base_from_allowance(&basic_data, base, allowance);
            deviations.per_tooth = mm(&stated.per_tooth_um);
        }
        if let Some(runout) = &self.runout {
            deviations.eccentricity = runout["total_um"] * 1e-3 / 2.0;
            deviations.high_tooth = runout["high_tooth"];
        }
        if let Some(pitch) = &self.pitch {
            assert_eq!(pitch.kind, "cumulative");
            let [right, left] = [mm(&pitch.right_um), mm(&pitch.left_um)];
            deviations.pitch = Some(Pitch::from_cumulative(&right, &left));
        }
        let face = match self.reference_face.as_str() {
            "front" => Face::Front,
            _ => Face::Back,
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    }
}
