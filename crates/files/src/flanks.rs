//! The flanks of a gear as its sheets state them, and the mean thickness that goes with them.

use super::eccentricity::{self, Counts};
use super::faults::Drawing;
use super::pitch::PitchSheet;
use super::problems::Problems;
use super::runout::{Knowledge, ReadingsFit, Runout};
use super::stated::Stated;
use gearlash::gear::{Deviations, Gear, Pitch};
use gearlash::metrology::{AllRoundNote, Eccentricity, EccentricityNote};

/// What the tables of one gear say of its flanks.
pub struct Sheets<'a> {
    /// Stated thickness of each tooth beyond the mean, mm; may be empty.
    pub per_tooth: Vec<f64>,
    pub runout: &'a Runout,
    /// The sheet and its curves, as measured.
    pub pitch: Option<(&'a PitchSheet, Pitch)>,
}

/// The gear in one or both materials, and where its flanks stand.
pub struct Flanks {
    pub gears: Stated<Gear>,
    /// What the sheets state, the eccentricity taken out of the pitch; without what spans add.
    pub stated: Deviations,
    /// All there is.
    pub deviations: Deviations,
    pub eccentricity: Option<EccentricityNote>,
    pub all_round: Option<AllRoundNote>,
    /// As stated, or as its readings say beside all that is known.
    pub runout: Runout,
    /// The eccentricity that `[runout]` shows by itself.
    pub in_runout: Option<Eccentricity>,
    /// What the user should know of the readings.
    pub told: Vec<String>,
}

/// Each round of mean thickness and eccentricity leaves about `e/r` of the error.
const MOST_ROUNDS: usize = 50;

impl Flanks {
    /// Of datum-axis pitch the eccentricity is taken out, which takes the mean thickness (where on a tooth its
    /// flanks stand); readings all round give the mean thickness once the pitch is known. So the two take turns.
    pub fn settle(drawing: &Drawing, sheets: Sheets, problems: &mut Problems) -> Option<Flanks> {
        let (datum, own) = match sheets.pitch {
            Some((sheet, pitch)) if sheet.is_datum() => (Some((sheet, pitch)), None),
            own => (None, own.map(|(_, pitch)| pitch)),
        };
        let counts = datum.as_ref().and_then(|(sheet, _)| sheet.counts());
        let mut runout = sheets.runout.clone();
        let mut stated = Deviations {
            per_tooth: sheets.per_tooth,
            pitch: own,
            eccentricity: 0.0,
            high_tooth: 1.0,
        };
        let mut gears = drawing.gears(&stated, problems)?;
        if runout.check(drawing.table, &gears, problems).is_none() {
            // It is told; the rest is checked without it.
            runout = Runout::default();
        }
        // Without the pitch, from which it is to be taken out.
        let mut fit = fitted(drawing, &mut runout, &gears, &stated, problems)?;
        let mut in_pitch = None;
        let mut settled = datum.is_none();
        if let Some((sheet, readings)) = &datum {
            // Rounding of the thickness is some ulps of the radius.
            let rounding = 1e-13 * drawing.design.basic_data.reference_radius();
            for _ in 0..MOST_ROUNDS {
                let parts = eccentricity::separate(readings, gears.most(), sheet.counts(), &runout);
                let parts = parts.map_err(|error| {
                    let help =
                        "check the values, or write axis = \"own\" if they are free of eccentricity";
                    drawing.table.problem("pitch.axis", error.to_string(), help)
                });
                let (pitch, found) = problems.keep(parts)?;
                stated.pitch = Some(pitch);
                in_pitch = Some(found);
                let next = drawing.gears(&stated, problems)?;
                let change = next.most().base_thickness() - gears.most().base_thickness();
                gears = next;
                if change.abs() <= rounding {
                    settled = true;
                    break;
                }
            }
        }
        if !settled {
            problems.add(drawing.table.problem(
                "pitch.axis",
                "no eccentricity goes with the stated thickness",
                "check the pitch values and the readings of the thickness",
            ));
            return None;
        }
        let found = drawing
            .statement
            .per_tooth(&drawing.design.basic_data, &stated);
        let found = problems.keep(found.map_err(|error| {
            let help = "check the readings";
            drawing
                .table
                .problem("thickness.span", error.to_string(), help)
        }))?;
        let mut deviations = stated.clone();
        if let Some(found) = &found {
            deviations.per_tooth.resize(found.thickness.len(), 0.0);
            for (thickness, more) in deviations.per_tooth.iter_mut().zip(&found.thickness) {
                *thickness += more;
            }
        }
        let by_runout = counts == Some(Counts::Runout);
        if !by_runout {
            fit = fitted(drawing, &mut runout, &gears, &deviations, problems)?;
        }
        let told = match (&fit, &runout.sheet) {
            (Some(fit), Some(sheet)) => {
                let knowledge = match (&deviations.pitch, by_runout) {
                    (None, _) => Knowledge::NoPitch,
                    (Some(_), false) => Knowledge::Pitch,
                    (Some(_), true) => Knowledge::DatumPitch,
                };
                let table = drawing.table;
                let all = match by_runout {
                    true => sheet.fit(table, gears.most(), &deviations, problems)?.fit,
                    false => fit.fit.clone(),
                };
                fit.told(table, knowledge, &all)
            }
            _ => Vec::new(),
        };
        let basic_data = &drawing.design.basic_data;
        let note = in_pitch.map(|found| eccentricity::beside(found, counts, &runout, basic_data));
        let (eccentricity, high_tooth) = match note.filter(|note| !note.stated_counts) {
            Some(note) => (note.in_pitch.um / 1000.0, note.in_pitch.high_tooth),
            None => (runout.eccentricity(), runout.high_tooth.unwrap_or(1.0)),
        };
        for all in [&mut stated, &mut deviations] {
            (all.eccentricity, all.high_tooth) = (eccentricity, high_tooth);
        }
        Some(Flanks {
            gears,
            stated,
            deviations,
            eccentricity: note,
            all_round: drawing.statement.readings().map(|readings| AllRoundNote {
                readings: readings.count(),
                amplification: found.map(|found| found.amplification),
            }),
            in_runout: match &fit {
                Some(fit) => fit.first_harmonic(),
                None => runout.stated(),
            },
            runout,
            told,
        })
    }
}

/// Gives `runout` the eccentricity that its readings hold beside what is `known`, if it has readings; `None` when that fails.
fn fitted(
    drawing: &Drawing,
    runout: &mut Runout,
    gears: &Stated<Gear>,
    known: &Deviations,
    problems: &mut Problems,
) -> Option<Option<ReadingsFit>> {
    let Some(sheet) = &runout.sheet else {
        return Some(None);
    };
    let fit = sheet.fit(drawing.table, gears.most(), known, problems)?;
    *runout = runout.fitted(fit.fit.eccentricity, fit.fit.high_tooth);
    runout.check(drawing.table, gears, problems)?;
    Some(Some(fit))
}
