//! `[rack]`: the basic rack.

use crate::entry::Limits;
use crate::problems::Problems;
use crate::table::Table;
use gearlash::error::GearError;
use gearlash::gear::BasicRack;

const KEYS: &[&str] = &["addendum", "dedendum", "root_radius"];

const DEPTH: Limits = Limits {
    allowed: "a number of modules above 0 and up to 10",
    holds: |modules| modules > 0.0 && modules <= 10.0,
    help: "give it in modules; ISO 53 A has addendum 1.0 and dedendum 1.25",
};
const ROOT_RADIUS: Limits = Limits {
    allowed: "a number of modules, 0 up to the dedendum",
    holds: |modules| modules >= 0.0,
    help: "give the tool's tip round in modules; ISO 53 A has 0.38",
};

/// The rack of a gear's table, ISO 53 A where it says nothing.
pub fn read(gear: &Table, problems: &mut Problems) -> Option<BasicRack> {
    let table = gear.table("rack", KEYS, problems)?;
    let standard = BasicRack::ISO_53_A;
    let addendum = table.number_or("addendum", standard.addendum(), &DEPTH, problems);
    let dedendum = table.number_or("dedendum", standard.dedendum(), &DEPTH, problems);
    let root_radius = table.number_or(
        "root_radius",
        standard.root_radius(),
        &ROOT_RADIUS,
        problems,
    );
    let rack = BasicRack::new(addendum?, dedendum?, root_radius?);
    problems.keep(rack.map_err(|error| match error {
        GearError::OutOfRange { value, allowed, .. } => table.problem(
            "root_radius",
            format!("{value} is out of range, allowed is {allowed}"),
            "reduce it, or give a greater dedendum",
        ),
        other => table.problem("root_radius", other.to_string(), "correct the rack"),
    }))
}
