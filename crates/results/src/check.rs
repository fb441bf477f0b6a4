//! A check of a pair at one centre distance and material.

use crate::column::{Value, row_type, shown};
use gearlash::analysis::diagnosis::{Check, Group};
use gearlash::pair::Member;

/// A check at one centre distance and material.
#[derive(Debug)]
pub struct CheckRow {
    center_distance: f64,
    material: &'static str,
    /// Whether the pair has several centre distances or materials, so that tables for people must show this one.
    is_of_several: bool,
    check: Check,
}

impl CheckRow {
    /// The row of a `check` of `group`; `is_of_several`: the pair has several groups.
    pub fn new(group: &Group, check: &Check, is_of_several: bool) -> CheckRow {
        CheckRow {
            center_distance: group.assembly.center_distance(),
            material: group.material.name(),
            is_of_several,
            check: check.clone(),
        }
    }

    /// `value`, shown to people where there are several groups.
    fn of_several(&self, value: impl Into<Value>) -> Value {
        Value::optional(self.is_of_several.then_some(value))
    }

    fn details(&self) -> Value {
        let details = self.check.details.iter();
        let details = details.map(|(name, value)| ((*name).to_owned(), (*value).into()));
        Value::Json(serde_json::Value::Object(details.collect()))
    }

    /// The value on the outlines, as shown to people.
    fn outlines_shown(&self) -> Value {
        match (&self.check.unproven, self.check.outlines) {
            (Some(_), None) => "unproven".into(),
            (_, value) => value.into(),
        }
    }
}

row_type!(row: CheckRow {
    "" Grave [people(shown("verdict"))] => row.check.verdict.name();
    "id" Plain => row.check.id;
    "title" Plain [heading(shown("check").left().broken())] => row.check.title;
    "gear" Plain => row.check.gear.map(Member::name);
    "" Plain [people(shown("gear").left())] => row.check.gear.map_or("", Member::name);
    "" Distance [people(shown("a mm").spare(2))] => row.of_several(row.center_distance);
    "" Plain [people(shown("material").spare(2))] => row.of_several(row.material);
    "formula" Measure [heading(shown("formula").spare(1))] => row.check.formula;
    "outlines" Plain => row.check.outlines;
    "" Measure [people(shown("outlines"))] => row.outlines_shown();
    "limit" Measure [heading(shown("limit"))] => row.check.limit;
    "margin" Measure [heading(shown("margin"))] => row.check.margin;
    "unit" Plain => row.check.unit;
    "" Plain [people(shown("").left())] => unit(row.check.unit);
    "verdict" Plain => row.check.verdict.name();
    "center_distance_mm" Plain => row.center_distance;
    "material" Plain => row.material;
    "details" Plain => row.details();
    "note" Plain [heading(shown("").left().below())] => row.check.note.clone();
    "unproven" Plain => Value::optional(row.check.unproven.clone());
});

/// The unit of a check, as shown to people.
pub fn unit(unit: &'static str) -> &'static str {
    match unit {
        "1" => "",
        unit => unit,
    }
}
