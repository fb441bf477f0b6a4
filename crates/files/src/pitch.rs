//! `[pitch]`: pitch deviation of both flanks as the inspection sheet states it.

use super::problems::Problems;
use super::sheet::{Column, Coverage, Header, Sheet, Wanted};
use super::spec::{self, PitchSpec};
use super::table::Table;
use super::thickness::one_a_tooth;
use gearlash::gear::{Flank, PitchAxis};
use gearlash::metrology::{EccentricitySource, PitchKind, PitchSense, PitchStatement};

/// The table's values, both flanks given.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchSheet {
    /// As in the pair file, the values as lists.
    pub spec: PitchSpec,
    /// Statements on the gear in the file of the values; `None`: they are lists.
    pub header: Option<Header>,
}

impl PitchSheet {
    /// Reads what `spec`, the table of the gear's table `gear`, says; `Some(None)` when it has no values.
    pub fn read(
        gear: &Table,
        spec: PitchSpec,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<PitchSheet>> {
        let table = gear.below("pitch");
        if spec.table.is_some() {
            let kind = kind(spec.kind);
            let wanted = Wanted {
                columns: &[Column::Right(kind), Column::Left(kind)],
                teeth,
                coverage: Coverage::EveryTooth,
            };
            let sheet = Sheet::read(&table, &wanted, problems)?;
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
        let mut wrong = |key: &str, reason: String, help: String| {
            problems.add(table.problem(key, reason, help));
            None
        };
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
        let right = one_a_tooth(&table, "right_um", right, teeth, problems);
        let left = one_a_tooth(&table, "left_um", left, teeth, problems);
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
    pub fn measured(&self) -> PitchStatement {
        let PitchSpec {
            right_um, left_um, ..
        } = &self.spec;
        PitchStatement {
            kind: kind(self.spec.kind),
            axis: match self.spec.axis {
                spec::PitchAxis::Own => PitchAxis::Own,
                spec::PitchAxis::Datum => PitchAxis::Datum,
            },
            sense: match self.spec.sense {
                spec::PitchSense::Numbers => PitchSense::Numbers,
                spec::PitchSense::Material => PitchSense::Material,
            },
            eccentricity: self.spec.eccentricity.map(|source| match source {
                spec::EccentricitySource::Pitch => EccentricitySource::Pitch,
                spec::EccentricitySource::Runout => EccentricitySource::Runout,
            }),
            right_um: right_um.clone().unwrap_or_default(),
            left_um: left_um.clone().unwrap_or_default(),
        }
    }

    /// The `sense` that reads the left flank the other way round.
    pub fn other_sense(&self) -> &'static str {
        match self.spec.sense {
            spec::PitchSense::Numbers => "material",
            spec::PitchSense::Material => "numbers",
        }
    }
}

fn kind(stated: spec::PitchKind) -> PitchKind {
    match stated {
        spec::PitchKind::Cumulative => PitchKind::Cumulative,
        spec::PitchKind::Single => PitchKind::Single,
    }
}
