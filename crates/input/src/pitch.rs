//! `[pitch]`: pitch deviation of both flanks as the inspection sheet states it.

use super::spec::PitchSpec;
use super::thickness::one_per_tooth;
use gearlash::gear::{Flank, Side};
use gearlash::metrology::{PitchSense, PitchStatement};
use gearlash_tables::{Column, ProtocolHeader, Sheet};
use gearlash_text::Table;

/// The values of the table, with both flanks.
#[derive(Debug, Clone)]
pub struct PitchSheet {
    /// As in the pair file, the values as lists.
    pub spec: PitchSpec,
    /// Statements about the gear in the file of the values; `None` for lists.
    pub header: Option<ProtocolHeader>,
}

impl PitchSheet {
    /// Reads the pitch `spec` of the gear's table `gear`; `Some(None)` where it has no values.
    pub fn read(gear: &Table, spec: PitchSpec, teeth: Option<u32>) -> Option<Option<PitchSheet>> {
        let table = gear.below("pitch");
        if spec.table.is_some() {
            let kind = spec.kind;
            let columns = Side::BOTH.map(|side| Column::pitch(side, kind));
            let sheet = Sheet::of_every_tooth(&table, &columns, teeth)?;
            return Some(Some(PitchSheet {
                spec: PitchSpec {
                    right_um: Some(sheet.values(0)),
                    left_um: Some(sheet.values(1)),
                    table: None,
                    left: None,
                    right: None,
                    ..spec
                },
                header: Some(sheet.header),
            }));
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
        let spec = PitchSpec {
            right_um: Some(right?),
            left_um: Some(left?),
            ..spec
        };
        Some(Some(PitchSheet { spec, header: None }))
    }

    /// The key, below the gear's table, that gives the values of a flank.
    pub fn key(&self, side: Flank) -> &'static str {
        match (side, &self.header) {
            (_, Some(_)) => "pitch.file",
            (Flank::Right, None) => "pitch.right_um",
            (Flank::Left, None) => "pitch.left_um",
        }
    }

    /// The measurement as the metrology takes it.
    pub fn for_metrology(&self) -> PitchStatement {
        let PitchSpec {
            right_um, left_um, ..
        } = &self.spec;
        PitchStatement {
            kind: self.spec.kind,
            axis: self.spec.axis,
            sense: self.spec.sense,
            eccentricity: self.spec.eccentricity,
            right_um: right_um.clone().unwrap_or_default(),
            left_um: left_um.clone().unwrap_or_default(),
        }
    }

    /// The `sense` that reads the left flank the other way round.
    pub fn other_sense(&self) -> &'static str {
        match self.spec.sense {
            PitchSense::Numbers => "material",
            PitchSense::Material => "numbers",
        }
    }
}
