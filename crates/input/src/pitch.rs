//! `[pitch]`: pitch deviation of both flanks as the inspection sheet states it.

use super::known_gear::KnownGear;
use super::spec::PitchSpec;
use super::thickness::one_per_tooth;
use gearlash::gear::{Flank, Side};
use gearlash::metrology::{PitchSense, PitchStatement};
use gearlash_tables::{Column, Sheet};
use gearlash_text::Table;

impl PitchSpec {
    /// The pitch of both flanks of the gear's table `gear` with its values as lists; `Some(None)` where it has none.
    pub(crate) fn complete(self, gear: &Table, known: &KnownGear) -> Option<Option<PitchSpec>> {
        let (spec, table, teeth) = (self, gear.below("pitch"), known.teeth);
        if spec.table.is_some() {
            let kind = spec.kind;
            let columns = Side::BOTH.map(|side| Column::pitch(side, kind));
            let sheet = Sheet::of_every_tooth(&table, &columns, teeth)?;
            let spec = PitchSpec {
                right_um: Some(sheet.values(0)),
                left_um: Some(sheet.values(1)),
                table: None,
                left: None,
                right: None,
                ..spec
            };
            known.headers.borrow_mut().insert(0, sheet.header);
            return Some(Some(spec));
        }
        let lists = [&spec.right_um, &spec.left_um].map(|list| list.clone().unwrap_or_default());
        let wrong = |key: &str, reason: String, help: String| table.refuse(key, reason, help);
        let names = ["right_um", "left_um"];
        for (name, mate, own, other) in [
            (names[0], names[1], &lists[0], &lists[1]),
            (names[1], names[0], &lists[1], &lists[0]),
        ] {
            if own.is_empty() && !other.is_empty() {
                return wrong(
                    name,
                    format!(
                        "no values, {mate} has {}, expected are both flanks",
                        other.len()
                    ),
                    format!("give {name} too, or leave out both"),
                );
            }
        }
        if lists[0].is_empty() {
            if spec.eccentricity.is_some() {
                return wrong(
                    "eccentricity",
                    "there are no pitch values that could contain one".to_owned(),
                    "remove it, or give right_um and left_um".to_owned(),
                );
            }
            return Some(None);
        }
        if !table.has("kind") {
            wrong(
                "kind",
                "missing, expected \"cumulative\" or \"single\"".to_owned(),
                format!("add `kind` to [{}]", gear.path_of("pitch")),
            )?;
        }
        let [right, left] = lists;
        let right = one_per_tooth(&table, "right_um", right, teeth);
        let left = one_per_tooth(&table, "left_um", left, teeth);
        Some(Some(PitchSpec {
            right_um: Some(right?),
            left_um: Some(left?),
            ..spec
        }))
    }

    /// The measurement as the metrology takes it.
    pub(crate) fn for_metrology(&self) -> PitchStatement {
        PitchStatement {
            kind: self.kind,
            axis: self.axis,
            sense: self.sense,
            eccentricity: self.eccentricity,
            right_um: self.right_um.clone().unwrap_or_default(),
            left_um: self.left_um.clone().unwrap_or_default(),
        }
    }

    /// The `sense` that reads the left flank the other way round.
    pub(crate) fn other_sense(&self) -> &'static str {
        match self.sense {
            PitchSense::Numbers => "material",
            PitchSense::Material => "numbers",
        }
    }
}

/// The key, below the gear's table `gear`, that gives the values of a flank.
pub fn key_of(gear: &Table, flank: Flank) -> &'static str {
    match flank {
        _ if gear.has("pitch.file") => "pitch.file",
        _ if !gear.has("pitch") => "pitch",
        Flank::Right => "pitch.right_um",
        Flank::Left => "pitch.left_um",
    }
}
