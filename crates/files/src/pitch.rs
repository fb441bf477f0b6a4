//! `[pitch]`: pitch deviation of both flanks as the inspection sheet states it.

use super::limits::PITCH;
use super::per_tooth::one_a_tooth;
use super::problems::Problems;
use super::sheet::{self, Column, Coverage, Header, Sheet, Wanted};
use super::spec::{self, PitchSpec};
use super::table::Table;
use gearlash::gear::Flank;
use gearlash::gear::PitchAxis;
use gearlash::metrology::{EccentricitySource, PitchKind, PitchSense, PitchStatement};

pub const KEYS: &[&str] = &[
    "kind",
    "axis",
    "sense",
    "eccentricity",
    "right_um",
    "left_um",
    "file",
    "sheet",
    "header_row",
    "tooth_column",
    "left",
    "right",
    "decimal",
];

const KINDS: [(&str, PitchKind); 2] = [
    ("cumulative", PitchKind::Cumulative),
    ("single", PitchKind::Single),
];
const AXES: [(&str, PitchAxis); 2] = [("own", PitchAxis::Own), ("datum", PitchAxis::Datum)];
const SENSES: [(&str, PitchSense); 2] = [
    ("numbers", PitchSense::Numbers),
    ("material", PitchSense::Material),
];
const COUNTS: [(&str, EccentricitySource); 2] = [
    ("pitch", EccentricitySource::Pitch),
    ("runout", EccentricitySource::Runout),
];

/// The table's values, both flanks given.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchSheet {
    kind: PitchKind,
    axis: PitchAxis,
    sense: PitchSense,
    counts: Option<EccentricitySource>,
    right_um: Vec<f64>,
    left_um: Vec<f64>,
    /// What the file they come from says of the gear; `None`: they are lists.
    header: Option<Header>,
}

impl PitchSheet {
    /// Reads `[pitch]` of a gear's table; `Some(None)` when it has no values.
    pub fn read(
        gear: &Table,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<Option<PitchSheet>> {
        let table = gear.table("pitch", KEYS, problems)?;
        let axis = table.choice_or_first("axis", &AXES, problems);
        let sense = table.choice_or_first("sense", &SENSES, problems);
        let counts = match table.optional("eccentricity")? {
            Some(entry) => problems.keep(entry.choice(&COUNTS)).map(Some),
            None => Some(None),
        };
        if table.has("file") {
            let kind = Self::read_kind(&table, problems);
            let (flanks, header) = Self::read_file(&table, kind, teeth, problems)?;
            let [right_um, left_um] = flanks;
            return Some(Some(PitchSheet {
                kind: kind?,
                axis: axis?,
                sense: sense?,
                counts: counts?,
                right_um,
                left_um,
                header: Some(header),
            }));
        }
        sheet::without_file(&table, problems)?;
        let right = table.numbers("right_um", &PITCH, problems);
        let left = table.numbers("left_um", &PITCH, problems);
        let lengths = [&right, &left].map(|list| list.as_ref().map(Vec::len));
        for (name, mate, lengths) in [
            ("right_um", "left_um", lengths),
            ("left_um", "right_um", [lengths[1], lengths[0]]),
        ] {
            if let [Some(0), Some(found @ 1..)] = lengths {
                problems.add(table.problem(
                    name,
                    format!("no values, {mate} has {found}, expected are both flanks"),
                    format!("give {name} too, or leave out both"),
                ));
                return None;
            }
        }
        let kind = if lengths == [Some(0), Some(0)] && table.optional("kind")?.is_none() {
            Some(PitchKind::Cumulative)
        } else {
            Self::read_kind(&table, problems)
        };
        let right = right.and_then(|um| one_a_tooth(&table, "right_um", um, teeth, problems));
        let left = left.and_then(|um| one_a_tooth(&table, "left_um", um, teeth, problems));
        let sheet = PitchSheet {
            kind: kind?,
            axis: axis?,
            sense: sense?,
            counts: counts?,
            right_um: right?,
            left_um: left?,
            header: None,
        };
        if let (true, Some(_)) = (sheet.right_um.is_empty(), counts?) {
            problems.add(table.problem(
                "eccentricity",
                "there are no pitch values that could contain one",
                "remove it, or give right_um and left_um",
            ));
            return None;
        }
        Some((!sheet.right_um.is_empty()).then_some(sheet))
    }

    fn read_kind(table: &Table, problems: &mut Problems) -> Option<PitchKind> {
        let needed = "\"cumulative\" or \"single\"";
        let entry = table.need("kind", needed, problems)?;
        problems.keep(entry.choice(&KINDS))
    }

    /// Both flanks' values from the file that `table` names, right first.
    fn read_file(
        table: &Table,
        kind: Option<PitchKind>,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<([Vec<f64>; 2], Header)> {
        let lists = ["right_um", "left_um"];
        table.alone("file", &lists, "one of file and the lists", problems)?;
        // A kind that is wrong is reported already; the file is read for its own problems.
        let kind = kind.unwrap_or(PitchKind::Cumulative);
        let wanted = Wanted {
            columns: &[Column::Right(kind), Column::Left(kind)],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        Some(([sheet.values(0), sheet.values(1)], sheet.header))
    }

    /// What the file they come from says of the gear.
    pub fn header(&self) -> Option<&Header> {
        self.header.as_ref()
    }

    /// The key, below the gear's table, that gives the values of a flank.
    pub fn key(&self, side: Flank) -> &'static str {
        match (side, &self.header) {
            (_, Some(_)) => "pitch.file",
            (Flank::Right, None) => "pitch.right_um",
            (Flank::Left, None) => "pitch.left_um",
        }
    }

    /// What was measured.
    pub fn measured(&self) -> PitchStatement {
        PitchStatement {
            kind: self.kind,
            axis: self.axis,
            sense: self.sense,
            eccentricity: self.counts,
            right_um: self.right_um.clone(),
            left_um: self.left_um.clone(),
        }
    }

    /// The `sense` that reads the left flank the other way round.
    pub fn other_sense(&self) -> &'static str {
        match self.sense {
            PitchSense::Numbers => name_of(PitchSense::Material, &SENSES),
            PitchSense::Material => name_of(PitchSense::Numbers, &SENSES),
        }
    }

    /// As in the pair file.
    pub fn spec(&self) -> PitchSpec {
        PitchSpec {
            kind: match self.kind {
                PitchKind::Cumulative => spec::PitchKind::Cumulative,
                PitchKind::Single => spec::PitchKind::Single,
            },
            axis: match self.axis {
                PitchAxis::Own => spec::PitchAxis::Own,
                PitchAxis::Datum => spec::PitchAxis::Datum,
            },
            sense: match self.sense {
                PitchSense::Numbers => spec::PitchSense::Numbers,
                PitchSense::Material => spec::PitchSense::Material,
            },
            right_um: Some(self.right_um.clone()),
            left_um: Some(self.left_um.clone()),
            eccentricity: self.counts.map(|counts| match counts {
                EccentricitySource::Pitch => spec::EccentricitySource::Pitch,
                EccentricitySource::Runout => spec::EccentricitySource::Runout,
            }),
            table: None,
            left: None,
            right: None,
        }
    }
}

fn name_of<T: PartialEq>(value: T, names: &[(&'static str, T)]) -> &'static str {
    names
        .iter()
        .find(|(_, choice)| *choice == value)
        .map_or("", |&(name, _)| name)
}
