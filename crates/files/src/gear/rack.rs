//! `[rack]`: the basic rack.

use crate::limits::{RACK_DEPTH, ROOT_RADIUS};
use crate::problems::Problems;
use crate::table::Table;
use gearlash::error::GearError;
use gearlash::gear::BasicRack;

const KEYS: &[&str] = &["addendum", "dedendum", "root_radius"];

/// The rack of a gear's table, ISO 53 A where it says nothing.
pub fn read(gear: &Table, problems: &mut Problems) -> Option<BasicRack> {
    let table = gear.table("rack", KEYS, problems)?;
    let standard = BasicRack::ISO_53_A;
    let addendum = table.number_or("addendum", standard.addendum(), &RACK_DEPTH, problems);
    let dedendum = table.number_or("dedendum", standard.dedendum(), &RACK_DEPTH, problems);
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
