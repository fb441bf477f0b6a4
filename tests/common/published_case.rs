//! One case of fixtures/reference/published.json, and the gears it states.

use super::reference_file;
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign};
use gearlash::pair::{GearPair, Member};
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeSet;

pub fn file() -> Vec<Value> {
    serde_json::from_str(&reference_file("published.json")).unwrap()
}

/// One case; every output must be compared, or be named to [`Case::finish`] as not this program's.
pub struct Case {
    pub value: Value,
    compared: RefCell<BTreeSet<String>>,
}

impl Case {
    pub fn load(id: &str) -> Case {
        let value = file().into_iter().find(|case| case["id"] == id).unwrap();
        Case {
            value,
            compared: RefCell::default(),
        }
    }

    pub fn input(&self, key: &str) -> Option<f64> {
        number(&self.value["inputs"][key])
    }

    pub fn expect(&self, key: &str, found: f64) {
        let expected = number(&self.value["outputs"][key]).unwrap();
        let tolerance = self.tolerance(key);
        assert!(
            (found - expected).abs() <= tolerance,
            "{key}: {found}, published {expected} within {tolerance:e}"
        );
        self.mark(key);
    }

    /// As [`Case::expect`] for an output that only some cases of the kind print.
    pub fn expect_if_printed(&self, key: &str, found: f64) {
        if self.value["outputs"].get(key).is_some() {
            self.expect(key, found);
        }
    }

    fn tolerance(&self, key: &str) -> f64 {
        let digits = &self.value["digits_or_tolerance"];
        digits
            .as_f64()
            .or(digits[key].as_f64())
            .or(digits["default"].as_f64())
            .unwrap()
    }

    pub fn mark(&self, key: &str) {
        self.compared.borrow_mut().insert(key.to_owned());
    }

    pub fn finish(self, not_ours: &[(&str, &str, &str)]) {
        let excused = |key: &str| {
            let id = &self.value["id"];
            not_ours.iter().any(|entry| id == entry.0 && key == entry.1)
        };
        for key in self.value["outputs"].as_object().unwrap().keys() {
            let compared = self.compared.borrow().contains(key);
            assert!(compared != excused(key), "{key} was not compared");
        }
    }

    /// The gear of `z{n}`, `x{n}`, `d_a{n}_mm`; `n` is empty where the case has one gear only.
    pub fn design(&self, n: &str) -> GearDesign {
        let input = |keys: &[&str], default: f64| {
            keys.iter()
                .find_map(|key| self.input(key))
                .unwrap_or(default)
        };
        // The stress cases state x twice: as a formula, and to full precision.
        let shift = input(&["x_full", &format!("x{n}")], 0.0);
        GearDesign {
            basic_data: BasicGearData::new(
                self.input(&format!("z{n}")).unwrap() as u32,
                self.input("m_n").unwrap(),
                self.input("alpha_n_deg").unwrap().to_radians(),
            )
            .unwrap(),
            profile_shift: shift,
            rack: BasicRack::new(
                1.0,
                input(
                    &["tool_h_aP0_star", "tool_h_fP_star", "dedendum_star"],
                    1.25,
                ),
                input(&["tool_rho_aP0_star", "tool_rho_fP_star"], 0.38),
            )
            .unwrap(),
            tip_diameter: self.input(&format!("d_a{n}_mm")),
        }
    }

    /// Both gears, perfect and of nominal thickness, at `distance`.
    pub fn nominal_pair(&self, distance: f64) -> GearPair {
        let gear = |n, face| AsBuilt::perfect(Gear::nominal(self.design(n)).unwrap(), face);
        GearPair::with_locked(
            gear("1", Face::Front),
            gear("2", Face::Back),
            distance,
            Member::Wheel,
        )
        .unwrap()
    }
}

/// A number, or a number written as a string.
fn number(value: &Value) -> Option<f64> {
    value.as_f64().or_else(|| value.as_str()?.parse().ok())
}
