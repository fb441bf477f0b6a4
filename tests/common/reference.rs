//! The reference pairs of fixtures/reference/lost_motion, and what was found for them outside this project.

use crate::kit::{at_flank, pair_of, study};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating};
use serde::Deserialize;

/// All names of fixtures/reference/lost_motion, without extension.
pub fn reference_names() -> impl Iterator<Item = String> {
    let kinds = "clear deviated everything fillet handover interfering";
    let each = kinds.split(' ');
    each.flat_map(|kind| (1..=3).map(move |n| format!("{kind}_{n}")))
}

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
        let flank = match self.flank.as_str() {
            "right" => Side::Right,
            _ => Side::Left,
        };
        at_flank(self.wheel_tooth, self.pinion_tooth, flank, self.fraction)
    }

    pub fn contact(&self, side: Side) -> &ReferenceContact {
        match side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        }
    }
}

impl ReferenceContact {
    pub fn curves(&self) -> [&str; 2] {
        [&self.wheel_curve, &self.pinion_curve].map(String::as_str)
    }

    pub fn teeth(&self) -> (u32, u32) {
        (self.wheel_tooth, self.pinion_tooth)
    }
}

pub fn reference_file(name: &str) -> String {
    let path = format!("{}/fixtures/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

pub fn reference_pair(name: &str) -> ReferencePair {
    let poses = reference_file(&format!("lost_motion/{name}.json"));
    let pair = study(format!("fixtures/reference/lost_motion/{name}.toml"));
    ReferencePair {
        assembly: pair_of(&pair),
        poses: serde_json::from_str(&poses).unwrap(),
    }
}
