//! Runout readings from a file.

use crate::limits::BALL;
use crate::problems::Problems;
use crate::sheet::{Column, Coverage, Header, Sheet, Wanted};
use crate::table::Table;
use gearlash::metrology::{ProbeReadings, ReadWith};

/// Where a reading was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
enum At {
    /// By a fork astride the tooth of its number.
    Tooth,
    /// By a ball in the space after it.
    Space,
}

const PLACES: [(&str, At); 2] = [("tooth", At::Tooth), ("space", At::Space)];

/// The readings, one a tooth.
#[derive(Debug, Clone, PartialEq)]
pub struct RunoutSheet {
    um: Vec<f64>,
    at: At,
    ball_mm: Option<f64>,
    header: Header,
}

impl RunoutSheet {
    /// Reads the file that `[runout]` names.
    pub fn read(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<RunoutSheet> {
        let values = ["total_um", "high_tooth"];
        table.alone("file", &values, "one of file and the values", problems)?;
        let needed = "\"tooth\" (at its centre line) or \"space\" (between it and the next number)";
        let at = table
            .need("at", needed, problems)
            .and_then(|entry| problems.keep(entry.choice(&PLACES)));
        let ball_mm = match table.optional("ball_mm")? {
            Some(entry) => problems.keep(entry.number(&BALL)).map(Some),
            None => Some(None),
        };
        let wanted = Wanted {
            columns: &[Column::Runout],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        let (at, ball_mm) = (at?, ball_mm?);
        if at == At::Tooth && sheet.origin.as_ref().is_some_and(|origin| origin.by_space) {
            problems.add(table.problem(
                "at",
                "the readings of the file are numbered by spaces",
                "write at = \"space\"",
            ));
            return None;
        }
        if at == At::Tooth && ball_mm.is_some() {
            problems.add(table.problem(
                "ball_mm",
                "goes with at = \"space\": no ball stands at a tooth's centre line",
                "remove it, or write at = \"space\"",
            ));
            return None;
        }
        Some(RunoutSheet {
            um: sheet.values(0),
            at,
            ball_mm,
            header: sheet.header,
        })
    }

    /// What the file says of the gear.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// What was measured.
    pub fn measured(&self) -> ProbeReadings {
        ProbeReadings {
            um: self.um.clone(),
            with: match (self.at, self.ball_mm) {
                (At::Tooth, _) => ReadWith::Fork,
                (At::Space, Some(diameter)) => ReadWith::Ball(diameter),
                (At::Space, None) => ReadWith::AnyBall,
            },
        }
    }
}
