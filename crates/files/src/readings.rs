//! Readings all round a gear: a list of lengths, and the tooth or space each was read at.

use super::limits::LENGTH;
use super::node::Node;
use super::problems::Problems;
use super::sheet::{self, Column, Coverage, Sheet, Wanted};
use super::table::Table;
use std::collections::HashSet;

/// Lengths, mm, and their places, from 1; as many of both, no place twice.
#[derive(Debug, Clone, PartialEq)]
pub struct LengthReadings {
    places: Vec<u32>,
    mm: Vec<f64>,
    /// The key that gave them: `mm` or `file`.
    key: &'static str,
}

impl LengthReadings {
    /// Reads `mm = [ … ]` and the places under `place_key`, which may be left out where every tooth has its reading, or
    /// the `column` of a file; `Some(None)` where `mm` is no list and there is no file.
    pub fn read(
        table: &Table,
        place_key: &'static str,
        column: Column,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<LengthReadings>> {
        if table.has("file") {
            return LengthReadings::of_file(table, place_key, column, teeth, problems).map(Some);
        }
        sheet::without_file(table, problems)?;
        let is_list = table
            .get("mm")
            .is_some_and(|entry| matches!(entry.node(), Node::List(_)));
        if !is_list {
            if let Some(name) = [place_key, "per_tooth"]
                .into_iter()
                .find(|name| table.has(name))
            {
                problems.add(table.problem(
                    name,
                    "goes with readings all round, mm = [ … ] or file = \"…\"",
                    "give the readings as a list or in a file, or remove it",
                ));
                return None;
            }
            return Some(None);
        }
        let allowed = "`mm` alone, or `min_mm` and `max_mm`";
        table.alone("mm", &["min_mm", "max_mm"], allowed, problems)?;
        let mm = table.numbers("mm", &LENGTH, problems)?;
        if mm.is_empty() {
            problems.add(table.problem(
                "mm",
                "no readings, expected at least one",
                "give what was measured, in mm",
            ));
            return None;
        }
        let places = LengthReadings::read_places(table, place_key, mm.len(), teeth?, problems)?;
        Some(Some(LengthReadings {
            places,
            mm,
            key: "mm",
        }))
    }

    fn of_file(
        table: &Table,
        place_key: &'static str,
        column: Column,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<LengthReadings> {
        let beside = ["mm", "min_mm", "max_mm", place_key];
        table.alone("file", &beside, "one of them", problems)?;
        let wanted = Wanted {
            columns: &[column],
            teeth,
            coverage: Coverage::SomeTeeth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        Some(LengthReadings {
            places: sheet.teeth(),
            mm: sheet.values(0),
            key: "file",
        })
    }

    fn read_places(
        table: &Table,
        key: &'static str,
        readings: usize,
        teeth: u32,
        problems: &mut Problems,
    ) -> Option<Vec<u32>> {
        let help = "give the number of each reading, in the order of mm";
        let Some(entry) = table.optional(key)? else {
            if readings == teeth as usize {
                return Some((1..=teeth).collect());
            }
            problems.add(table.problem(
                key,
                format!(
                    "missing, expected one number a reading: there are {readings} for {teeth} teeth"
                ),
                format!("add `{key}`: {help}"),
            ));
            return None;
        };
        let list = problems.keep(entry.list("a list of tooth numbers", help))?;
        if list.len() != readings {
            problems.add(table.problem(
                key,
                format!(
                    "length {}, expected {readings}: one number a reading",
                    list.len()
                ),
                help,
            ));
            return None;
        }
        let places = entry.each(&list, problems, |element, _| {
            element.whole(1..=teeth, "give a number of the gear's teeth")
        })?;
        let mut seen = HashSet::new();
        if let Some(twice) = places.iter().find(|place| !seen.insert(**place)) {
            problems.add(table.problem(
                key,
                format!("{twice} is listed twice, allowed is once"),
                "keep one reading of it, or their mean",
            ));
            return None;
        }
        Some(places)
    }

    /// The key that gave them: `mm` or `file`.
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// Each place with its length, mm.
    pub fn measured(&self) -> Vec<(u32, f64)> {
        self.places
            .iter()
            .copied()
            .zip(self.mm.iter().copied())
            .collect()
    }

    /// The places, in the order of the lengths.
    pub fn places(&self) -> &[u32] {
        &self.places
    }

    /// The lengths, mm.
    pub fn mm(&self) -> &[f64] {
        &self.mm
    }
}
