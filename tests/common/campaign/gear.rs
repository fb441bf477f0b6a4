//! One gear of the campaign, as the numbers of a pair file.

use super::random::{Random, either};
use crate::kit::Make;
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, GearDesign, Hand};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_4, PI};

/// Addendum, dedendum and root radius of a rack in modules, at the pressure angle `alpha`.
fn rack(random: &mut Random, alpha: f64) -> [f64; 3] {
    let kind = random.one_of(6);
    let addendum = match kind {
        // ISO 53 A.
        1 => return [1.0, 1.25, 0.38],
        // Stub.
        2 if random.chance(0.5) => 0.8,
        2 => random.within(0.3, 0.8),
        // Long.
        3 => 1.3,
        _ => random.within(0.8, 1.25),
    };
    let dedendum = addendum + random.within(0.1, 0.4);
    // Half the tool's flat: π/4 − (h_fP − ρ) tan α − ρ/cos α = 0.
    let (sin, cos) = alpha.sin_cos();
    let fits = ((FRAC_PI_4 * cos - dedendum * sin) / (1.0 - sin)).clamp(0.0, dedendum);
    let root_radius = match kind {
        // Sharp, and full round.
        4 => 0.0,
        5 => fits,
        _ => random.within(0.0, fits.min(0.45)),
    };
    [addendum, dedendum, root_radius]
}

/// The numbers of one gear, as in a pair file.
pub struct Numbers {
    pub teeth: u32,
    pub module_mm: f64,
    pub pressure_angle_deg: f64,
    pub profile_shift: f64,
    pub rack: [f64; 3],
    pub tip_diameter_mm: f64,
    pub allowance_um: f64,
    pub face: Face,
    pub runout_um: f64,
    pub high_tooth: f64,
    pub per_tooth_um: Vec<f64>,
    pub right_um: Vec<f64>,
    pub left_um: Vec<f64>,
    /// Helix angle, degrees, and hand.
    pub helix: Option<(f64, Hand)>,
}

/// Pattern of the deviations around a gear.
#[derive(Clone, Copy)]
enum Pattern {
    Random,
    /// Every other tooth is offset: hand-over at tip corners.
    Alternating,
    /// A single tooth is off, by more than all could be.
    One(u32),
}

impl Numbers {
    /// The numbers of a gear that may be impossible.
    pub fn draw(
        random: &mut Random,
        teeth: u32,
        module_mm: f64,
        pressure_angle_deg: f64,
    ) -> Numbers {
        let rack = rack(random, pressure_angle_deg.to_radians());
        let none = random.chance(0.15);
        let profile_shift = if none { 0.0 } else { random.within(-0.6, 1.2) };
        let plain = f64::from(teeth) * module_mm + 2.0 * module_mm * (rack[0] + profile_shift);
        // As generated, turned down, or raised.
        let longer = match random.one_of(4) {
            1 | 2 => 0.0,
            3 => -random.decades(0.01, 0.8),
            _ => random.decades(0.01, 0.6),
        };
        let tip_diameter_mm = plain + 2.0 * module_mm * longer;
        let [low, high] = either(random, [[-0.03, 0.005], [-0.3, 0.25]]);
        let allowance = random.within(low, high);
        let mut numbers = Numbers {
            teeth,
            module_mm,
            pressure_angle_deg,
            profile_shift,
            rack,
            tip_diameter_mm,
            allowance_um: allowance * module_mm * 1e3,
            face: random.pick(&[Face::Front, Face::Back]),
            runout_um: 0.0,
            high_tooth: 1.0,
            per_tooth_um: vec![],
            right_um: vec![],
            left_um: vec![],
            helix: None,
        };
        numbers.deviate(random);
        numbers
    }

    /// The same teeth in the normal section, twisted: all circles grow by 1/cos β.
    pub fn wind(&mut self, angle_deg: f64, hand: Hand) {
        let reference = f64::from(self.teeth) * self.module_mm;
        self.tip_diameter_mm += reference / angle_deg.to_radians().cos() - reference;
        self.helix = Some((angle_deg, hand));
    }

    fn deviate(&mut self, random: &mut Random) {
        if random.chance(0.4) {
            // Half the runout: ordinary (10 µm at module 3), or up to 0.75 modules.
            let most = random.pick(&[0.003, 0.02, 0.75]);
            self.runout_um = 2e3 * random.within(0.0, most) * self.module_mm;
            self.high_tooth = random.within(1.0, f64::from(self.teeth) + 1.0);
        }
        if random.chance(0.35) {
            return;
        }
        // Ordinary, ten times that, or up to 0.3 of a pitch.
        let most = random.pick(&[0.003, 0.03, 0.3 * PI]);
        let um = random.within(0.0, most) * self.module_mm * 1e3;
        let pattern = match random.one_of(3) {
            1 => Pattern::Random,
            2 => Pattern::Alternating,
            _ => Pattern::One(random.one_of(self.teeth) - 1),
        };
        let mut list = |most: f64| -> Vec<f64> {
            let off = |k: u32| match pattern {
                Pattern::Random => random.within(-most, most),
                Pattern::Alternating => most * (0.2 * random.within(-1.0, 1.0) + f64::from(k % 2)),
                Pattern::One(tooth) if k == tooth => random.within(-most, most),
                Pattern::One(_) => 0.0,
            };
            (0..self.teeth).map(off).collect()
        };
        // Thickness by tooth moves a flank by half of it.
        match self.teeth % 3 {
            0 => self.per_tooth_um = list(um),
            1 => (self.right_um, self.left_um) = (list(um), list(um)),
            _ => {
                // Both flanks together: a tooth out of place with its thickness unchanged.
                self.right_um = list(um);
                self.left_um = self.right_um.clone();
            }
        }
    }

    /// The gear, if it is possible.
    pub fn build(&self) -> Option<AsBuilt> {
        let mm = |list: &[f64]| list.iter().map(|um| um / 1e3).collect::<Vec<f64>>();
        let alpha = self.pressure_angle_deg.to_radians();
        let (angle_deg, hand) = self.helix.unwrap_or((0.0, Hand::Right));
        let data = BasicGearData::new(self.teeth, self.module_mm, alpha).ok()?;
        let data = data.with_helix(angle_deg.to_radians(), hand).ok()?;
        let mut gear = Make::of(GearDesign::standard(data)).shift(self.profile_shift);
        gear.design.rack = BasicRack::new(self.rack[0], self.rack[1], self.rack[2]).ok()?;
        let gear = gear.tip_diameter(self.tip_diameter_mm);
        let gear = gear.allowance(self.allowance_um / 1e3);
        let gear = gear.runout(self.runout_um / 1e3 / 2.0, self.high_tooth);
        let gear = gear.per_tooth(mm(&self.per_tooth_um));
        let gear = match self.right_um.is_empty() {
            true => gear,
            false => gear.pitch(&mm(&self.right_um), &mm(&self.left_um)),
        };
        gear.try_built(self.face)
    }

    /// The gear as a table of a pair file, a helical one with its face, mm.
    pub fn table(&self, face: [f64; 2]) -> Value {
        let seen = match self.face {
            Face::Front => "front",
            Face::Back => "back",
        };
        let [addendum, dedendum, root_radius] = self.rack;
        let mut table = json!({
            "teeth": self.teeth,
            "reference_face": seen,
            "module_mm": self.module_mm,
            "pressure_angle_deg": self.pressure_angle_deg,
            "profile_shift": self.profile_shift,
            "tip_diameter_mm": self.tip_diameter_mm,
            "rack": { "addendum": addendum, "dedendum": dedendum, "root_radius": root_radius },
            "thickness": { "allowance_um": self.allowance_um },
        });
        if let Some((angle_deg, hand)) = self.helix {
            table["helix_angle_deg"] = json!(angle_deg);
            table["hand"] = json!(hand.name());
            table["face_mm"] = json!(face);
        }
        if !self.per_tooth_um.is_empty() {
            table["thickness"]["per_tooth_um"] = json!(self.per_tooth_um);
        }
        if self.runout_um > 0.0 {
            table["runout"] = json!({ "total_um": self.runout_um, "high_tooth": self.high_tooth });
        }
        if !self.right_um.is_empty() {
            let (right, left) = (&self.right_um, &self.left_um);
            table["pitch"] = json!({ "kind": "cumulative", "right_um": right, "left_um": left });
        }
        table
    }
}
