//! One case of fixtures/reference/published.json, and the gears it states.

use super::reference_file;
use crate::kit::{Make, near, pair, spur_of_angle};
use gearlash::gear::GearDesign;
use gearlash::pair::GearPair;
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeSet;

pub fn file() -> Vec<Value> {
    serde_json::from_str(&reference_file("published.json")).unwrap()
}

/// One case; every output must be compared or marked.
pub struct Case {
    pub value: Value,
    compared: RefCell<BTreeSet<String>>,
}

impl Case {
    pub fn new(value: Value) -> Case {
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
        near(key, found, expected, self.tolerance(key));
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
        let own = digits.as_f64().or(digits[key].as_f64());
        own.or(digits["default"].as_f64()).unwrap()
    }

    pub fn mark(&self, key: &str) {
        self.compared.borrow_mut().insert(key.to_owned());
    }

    pub fn finish(self) {
        for key in self.value["outputs"].as_object().unwrap().keys() {
            assert!(self.compared.borrow().contains(key), "{key}");
        }
    }

    /// The gear of `z{n}`, `x{n}`, `d_a{n}_mm`; `n` is empty where the case has one gear only.
    pub fn design(&self, n: &str) -> GearDesign {
        let input = |keys: &[&str], default: f64| {
            let stated = keys.iter().find_map(|key| self.input(key));
            stated.unwrap_or(default)
        };
        let own = |key: &str| self.input(key).unwrap();
        let gear = spur_of_angle(own(&format!("z{n}")) as u32, own("m_n"), own("alpha_n_deg"));
        let dedendum = ["tool_h_aP0_star", "tool_h_fP_star", "dedendum_star"];
        let dedendum = input(&dedendum, 1.25);
        let gear = gear.rack(
            1.0,
            dedendum,
            input(&["tool_rho_aP0_star", "tool_rho_fP_star"], 0.38),
        );
        GearDesign {
            tip_diameter: self.input(&format!("d_a{n}_mm")),
            // The stress cases state x twice: as a formula, and to full precision.
            ..gear.shift(input(&["x_full", &format!("x{n}")], 0.0)).design
        }
    }

    /// Both gears, perfect and of nominal thickness, at `distance`.
    pub fn nominal_pair(&self, distance: f64) -> GearPair {
        let [wheel, pinion] = ["1", "2"].map(|n| Make::of(self.design(n)));
        pair(&wheel, &pinion, distance)
    }
}

/// A number, or a number written as a string.
fn number(value: &Value) -> Option<f64> {
    value.as_f64().or_else(|| value.as_str()?.parse().ok())
}
