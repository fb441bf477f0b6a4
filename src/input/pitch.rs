//! `[pitch]`: pitch deviation of both flanks as the inspection sheet states it.

use super::eccentricity::{COUNTS, Counts};
use super::entry::Limits;
use super::per_tooth::one_a_tooth;
use super::problems::Problems;
use super::sheet::{Column, Coverage, Header, Sheet, Wanted};
use super::table::Table;
use crate::gear::{Pitch, Side, Toothing};
use serde_json::{Value, json};
use std::f64::consts::PI;

pub const KEYS: &[&str] = &[
    "kind",
    "axis",
    "sense",
    "eccentricity",
    "right_um",
    "left_um",
    "file",
    "sheet",
];

const DEVIATION: Limits = Limits {
    allowed: "a number of µm, −1e7 … 1e7",
    holds: |um| um.abs() <= 1e7,
    way_out: "give a deviation for every tooth, measured at the reference circle",
};

/// Sheets round single pitch deviations to 0.1 µm: half of that a tooth, 0.05 µm, may be left in
/// their sum; more is a slip, or not a list of single deviations.
const ROUNDING_UM: f64 = 0.05;

/// What a pitch value counts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// `F`: from the first tooth, or any one place.
    Cumulative,
    /// `f`: from the tooth before.
    Single,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Axis {
    Own,
    Datum,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Sense {
    Numbers,
    Material,
}

const KINDS: [(&str, Kind); 2] = [("cumulative", Kind::Cumulative), ("single", Kind::Single)];
const AXES: [(&str, Axis); 2] = [("own", Axis::Own), ("datum", Axis::Datum)];
const SENSES: [(&str, Sense); 2] = [("numbers", Sense::Numbers), ("material", Sense::Material)];

/// The table's values, both flanks given.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchSheet {
    kind: Kind,
    axis: Axis,
    sense: Sense,
    counts: Option<Counts>,
    right_um: Vec<f64>,
    left_um: Vec<f64>,
    /// What the file they come from says of the gear.
    header: Header,
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
                header,
            }));
        }
        let right = table.numbers("right_um", &DEVIATION, problems);
        let left = table.numbers("left_um", &DEVIATION, problems);
        let lengths = [&right, &left].map(|list| list.as_ref().map(Vec::len));
        for (name, mate, lengths) in [
            ("right_um", "left_um", lengths),
            ("left_um", "right_um", [lengths[1], lengths[0]]),
        ] {
            if let [Some(0), Some(found @ 1..)] = lengths {
                problems.add(table.problem(
                    name,
                    format!("no values, {mate} has {found}, needed are both flanks"),
                    format!("give {name} too, or leave out both"),
                ));
                return None;
            }
        }
        let kind = if lengths == [Some(0), Some(0)] && table.optional("kind")?.is_none() {
            Some(Kind::Cumulative)
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
            header: Header::default(),
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

    fn read_kind(table: &Table, problems: &mut Problems) -> Option<Kind> {
        let needed = "\"cumulative\" or \"single\"";
        let entry = table.need("kind", needed, problems)?;
        problems.keep(entry.choice(&KINDS))
    }

    /// Both flanks' values from the file that `table` names, right first.
    fn read_file(
        table: &Table,
        kind: Option<Kind>,
        teeth: Option<u32>,
        problems: &mut Problems,
    ) -> Option<([Vec<f64>; 2], Header)> {
        let listed = ["right_um", "left_um"]
            .into_iter()
            .find(|name| table.has(name));
        if let Some(listed) = listed {
            problems.add(table.problem(
                "file",
                format!("stands beside {listed}, allowed is one of file and the lists"),
                "remove one or the other",
            ));
            return None;
        }
        // A kind that is wrong is told already; the file is read for its own problems.
        let kind = kind.unwrap_or(Kind::Cumulative);
        let wanted = Wanted {
            columns: [Column::Right(kind), Column::Left(kind)],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        Some(([sheet.values(0), sheet.values(1)], sheet.header))
    }

    /// What the file they come from says of the gear.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The cumulative curves about the gear's own centre, each within half a pitch.
    pub fn curves(
        &self,
        gear: &Table,
        toothing: &Toothing,
        problems: &mut Problems,
    ) -> Option<Pitch> {
        let mm = |um: &[f64]| -> Vec<f64> { um.iter().map(|um| um / 1000.0).collect() };
        let (right, left) = (mm(&self.right_um), mm(&self.left_um));
        let mut pitch = match self.kind {
            Kind::Cumulative => Pitch::from_cumulative(&right, &left),
            Kind::Single => Pitch::from_single(&right, &left),
        };
        if self.sense == Sense::Material {
            pitch = pitch.read_as_material();
        }
        self.check_half_pitch(gear, &pitch, toothing, problems)?;
        Some(pitch)
    }

    /// Whether the values were measured about the datum axis.
    pub fn is_datum(&self) -> bool {
        self.axis == Axis::Datum
    }

    /// Which eccentricity counts, where the file says so.
    pub fn counts(&self) -> Option<Counts> {
        self.counts
    }

    /// The `sense` that reads the left flank the other way round.
    pub fn other_sense(&self) -> &'static str {
        match self.sense {
            Sense::Numbers => name_of(Sense::Material, &SENSES),
            Sense::Material => name_of(Sense::Numbers, &SENSES),
        }
    }

    fn check_half_pitch(
        &self,
        gear: &Table,
        pitch: &Pitch,
        toothing: &Toothing,
        problems: &mut Problems,
    ) -> Option<()> {
        let half = PI * toothing.module() / 2.0;
        let mut good = Some(());
        for (side, name) in [
            (Side::Right, "pitch.right_um"),
            (Side::Left, "pitch.left_um"),
        ] {
            let worst = pitch
                .flank(side)
                .iter()
                .enumerate()
                .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            if let Some((index, f)) = worst.filter(|(_, f)| !(f.abs() < half)) {
                problems.add(gear.problem(
                    name,
                    format!(
                        "tooth {} stands {:.1} µm from the mean, allowed is less than half a pitch, {:.1} µm",
                        index + 1,
                        1000.0 * f,
                        1000.0 * half
                    ),
                    "check the unit (µm) and whether the values are single or cumulative",
                ));
                good = None;
            }
        }
        good
    }

    /// A warning for each flank whose single pitches do not close the circle.
    pub fn warnings(&self, gear: &Table) -> Vec<String> {
        if self.kind != Kind::Single {
            return Vec::new();
        }
        let flanks = [("right_um", &self.right_um), ("left_um", &self.left_um)];
        flanks
            .into_iter()
            .filter_map(|(name, um)| {
                let sum: f64 = um.iter().sum();
                let rounding = ROUNDING_UM * um.len() as f64;
                (sum.abs() > rounding).then(|| {
                    format!(
                        "{}.{name}: the single pitch deviations sum to {sum:.2} µm instead of 0 (rounding leaves up to {rounding:.2} µm); \
                         the rest is shared out evenly over the teeth",
                        gear.path_of("pitch")
                    )
                })
            })
            .collect()
    }

    /// As in the pair file.
    pub fn echo(&self) -> Value {
        let mut echo = json!({
            "kind": name_of(self.kind, &KINDS),
            "axis": name_of(self.axis, &AXES),
            "sense": name_of(self.sense, &SENSES),
            "right_um": self.right_um,
            "left_um": self.left_um,
        });
        if let Some(counts) = self.counts {
            echo["eccentricity"] = json!(name_of(counts, &COUNTS));
        }
        echo
    }
}

fn name_of<T: PartialEq>(value: T, names: &[(&'static str, T)]) -> &'static str {
    names
        .iter()
        .find(|(_, choice)| *choice == value)
        .map_or("", |&(name, _)| name)
}
