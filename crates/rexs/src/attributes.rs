//! The attributes of a component, and their units.

use super::document::{Component, shown};
use gearlash_text::Problem;
use std::cell::RefCell;
use std::fmt::Display;

/// Allowances and half a grade of a table are printed in whole µm. For an allowance of a span that is 0.5 µm, as thickness at pressure
/// angles up to 60° 1 µm.
pub const ROUNDING_UM: f64 = 1.0;

/// Whether two pairs of allowances differ by more than their rounding, µm.
pub fn differ(ones: [f64; 2], others: [f64; 2]) -> bool {
    let mut pairs = ones.into_iter().zip(others);
    pairs.any(|(one, other)| (one - other).abs() > ROUNDING_UM)
}

/// A unit of the format: its names in the versions. The sign written as `mum` is U+00B5 or U+03BC.
pub type Unit = &'static [&'static str];
pub const MILLIMETRE: Unit = &["mm"];
pub const MICROMETRE: Unit = &["mum", "µm", "μm"];
pub const DEGREE: Unit = &["deg", "°"];
pub const NUMBER: Unit = &["none", ""];

/// The attributes of a component; it remembers which were read.
pub struct Attributes<'a> {
    component: &'a Component,
    read: RefCell<Vec<String>>,
}

impl<'a> Attributes<'a> {
    /// The attributes of `component`, none read.
    pub fn of(component: &'a Component) -> Attributes<'a> {
        Attributes {
            component,
            read: RefCell::default(),
        }
    }

    pub fn component(&self) -> &'a Component {
        self.component
    }

    /// The text of an attribute; `None` where it is absent or has no single value.
    pub fn text(&self, id: &str) -> Option<&'a str> {
        let value = self.component.attribute(id)?.value.as_deref()?;
        self.read.borrow_mut().push(id.to_owned());
        Some(value)
    }

    /// A number.
    /// Errors: the text is no number, or its unit differs.
    pub fn number(&self, id: &str, unit: Unit) -> Result<Option<f64>, String> {
        let Some(text) = self.text(id) else {
            return Ok(None);
        };
        let wrong = |reason: &str, help: &str| {
            let problem = Problem {
                value: Some(shown(text)),
                ..Problem::at(self.component.place_of(id), reason, help)
            };
            problem.to_string()
        };
        let stated = self.component.attribute(id).and_then(|a| a.unit.as_deref());
        if let Some(other) = stated.filter(|stated| !unit.contains(stated)) {
            let (other, unit) = (shown(other), unit[0]);
            let reason = format!("in the unit {other}, the format has {unit}");
            return Err(wrong(&reason, "convert it, or export the file again"));
        }
        // Exponents without digits, "inf" and "nan" are no numbers of the format.
        let digits = text.trim_start_matches(['-', '+']);
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        match number.filter(|_| digits.starts_with(|c: char| c.is_ascii_digit() || c == '.')) {
            Some(number) => Ok(Some(number)),
            None => Err(wrong("not a number", "give a number with a decimal point")),
        }
    }

    /// A number that must be present.
    /// Errors: as [`Attributes::number`]; the attribute is absent.
    pub fn need(&self, id: &str, unit: Unit) -> Result<f64, String> {
        let found = self.number(id, unit)?;
        found.ok_or_else(|| self.left_out(format!("has no {id}")))
    }

    /// Why the component keeps its stage from becoming a pair.
    pub fn left_out(&self, why: impl Display) -> String {
        format!("{} {why}", self.component.place())
    }

    /// A whole number from 1 on; `None` where it is absent.
    /// Errors: as [`Attributes::number`]; a fraction, zero or negative.
    pub fn count(&self, id: &str) -> Result<Option<u32>, String> {
        let Some(number) = self.number(id, NUMBER)? else {
            return Ok(None);
        };
        if number.fract() == 0.0 && (1.0..=1e9).contains(&number) {
            return Ok(Some(number as u32));
        }
        let (place, reason) = (self.component.place_of(id), "not a whole number above 0");
        let problem = Problem {
            value: Some(number.to_string()),
            ..Problem::at(place, reason, "correct it")
        };
        Err(problem.to_string())
    }

    /// Ids of the attributes that were not read.
    pub fn unread(&self) -> Vec<&'a str> {
        let read = self.read.borrow();
        let ids = self.component.attributes.iter().map(|a| a.id.as_str());
        ids.filter(|id| !read.iter().any(|one| one == id)).collect()
    }
}
