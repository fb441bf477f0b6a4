//! The data of a curve file: traces, the tables of pitch, and what is only counted: diameters and the probe's positions.
//!
//! A head closes what stands open before it. What follows a head that is wrong is passed over: one mistake is one problem.

use super::super::block::{self, Block};
use super::super::limits::MOST_ROWS;
use super::super::number::tooth as tooth_number;
use super::super::number::without_zero;
use super::content::{CORRECT, FlankTrace, P40, POSITIONS, PROFILES};
use super::trace_head::{self, Title};
use crate::data_file::DataFile;
use crate::problems::Problems;

const DIAMETERS: [(&str, &str); 2] = [
    ("Fußkreisdurchmesser", "root diameters"),
    ("Kopfkreisdurchmesser", "tip diameters"),
];
/// The head of the probe's positions.
const TEILUNG: &str = "Teilung:";
/// Their columns.
const COLUMNS: [&str; 6] = ["Z-Nr.", "Seite", "PHI", "X", "Y", "Z"];
/// One of their rows.
const POSITION: &str = "a tooth, R or L, and PHI in degrees, X, Y and Z in mm";

/// What the lines that follow belong to.
#[derive(Debug)]
enum Open {
    Nothing,
    /// Passed over, up to the next head.
    Wrong,
    /// Values of a trace: what it is called, and how many are to come.
    Values(&'static str, FlankTrace, usize),
    /// Diameters, by name.
    Diameters(&'static str),
    Block,
    /// Positions: whether their columns have been named.
    Positions(bool),
}

/// Where in the data of a file the reader is.
#[derive(Debug)]
pub struct Data<'f> {
    file: &'f DataFile,
    /// `Profil:`, `Flankenlinie:` or `Verschränkung:`, where one holds.
    title: Option<Title>,
    open: Open,
}

impl<'f> Data<'f> {
    /// Before the first line.
    pub fn new(file: &'f DataFile) -> Data<'f> {
        Data {
            file,
            title: None,
            open: Open::Nothing,
        }
    }

    /// Takes over a line.
    pub fn take<'a>(
        &mut self,
        p40: &mut P40<'a>,
        (line, text): (u64, &'a str),
        problems: &mut Problems,
    ) {
        let mut wrong = |reason: String| problems.add(self.file.problem_at(line, reason, CORRECT));
        let head = block::side(text).is_some()
            || Title::of(text).is_some()
            || text.starts_with(trace_head::BEGIN)
            || DIAMETERS.iter().any(|(known, _)| text.starts_with(known))
            || text == TEILUNG;
        if head {
            if let Some(reason) = self.cut_short() {
                wrong(format!("the trace before it ends too early: {reason}"));
            }
            match self.begin(p40, line, text) {
                Ok(open) => self.open = open,
                Err(reason) => {
                    self.open = Open::Wrong;
                    wrong(reason);
                }
            }
            return;
        }
        let file = self.file;
        let bad = match &mut self.open {
            Open::Wrong => Ok(()),
            Open::Values(..) => {
                self.take_values(p40, (line, text), problems);
                return;
            }
            Open::Diameters(name) => {
                let are_numbers = text
                    .split_whitespace()
                    .all(|word| without_zero(word).is_some());
                let count = text.split_whitespace().count();
                p40.count_unused(name, count);
                let reason = || format!("{} is not understood here", file.quote(text));
                are_numbers.then_some(()).ok_or_else(reason)
            }
            Open::Block => match take_row(file, p40, (line, text)) {
                Err((reason, true)) => {
                    self.open = Open::Wrong;
                    Err(reason)
                }
                Err((reason, false)) => Err(reason),
                Ok(()) => Ok(()),
            },
            Open::Positions(true) => {
                p40.count_unused(POSITIONS, 1);
                let reason = || format!("{}, allowed is {POSITION}", file.quote(text));
                is_position(text).then_some(()).ok_or_else(reason)
            }
            Open::Positions(false) => {
                let is_named = text.split_whitespace().eq(COLUMNS);
                self.open = if is_named {
                    Open::Positions(true)
                } else {
                    Open::Wrong
                };
                let reason = || format!("{}, allowed is {}", file.quote(text), COLUMNS.join(" "));
                is_named.then_some(()).ok_or_else(reason)
            }
            Open::Nothing => {
                self.open = Open::Wrong;
                Err(format!("{} is not understood here", file.quote(text)))
            }
        };
        if let Err(reason) = bad {
            problems.add(file.problem_at(line, reason, CORRECT));
        }
    }

    /// What is missing where the file ends now.
    pub fn cut_short(&self) -> Option<String> {
        match &self.open {
            Open::Values(_, curve, count) => Some(format!(
                "{} of {count} values into the trace of line {}",
                curve.values.len(),
                curve.line
            )),
            _ => None,
        }
    }

    /// What a head opens.
    fn begin(&mut self, p40: &mut P40, line: u64, text: &str) -> Result<Open, String> {
        if let Some(side) = block::side(text) {
            self.title = None;
            if p40.blocks.iter().any(|block| block.side == side) {
                return Err("duplicate block of this flank".to_owned());
            }
            p40.blocks.push(Block {
                side,
                line,
                columns: Vec::new(),
                rows: Vec::new(),
            });
            return Ok(Open::Block);
        }
        let mut diameters = DIAMETERS.iter();
        if let Some((_, name)) = diameters.find(|(known, _)| text.starts_with(known)) {
            self.title = None;
            return Ok(Open::Diameters(name));
        }
        if text == TEILUNG {
            self.title = None;
            return Ok(Open::Positions(false));
        }
        let mut rest = text;
        if let Some((title, behind)) = Title::of(text) {
            self.title = Some(title);
            rest = behind;
            if rest.is_empty() {
                return Ok(Open::Nothing);
            }
        }
        let Some(title) = self.title else {
            return Err(
                "a trace below none of Profil:, Flankenlinie: and Verschränkung:".to_owned(),
            );
        };
        let head = trace_head::read(self.file, rest, title)?;
        let curve = FlankTrace {
            line,
            tooth: head.tooth,
            flank: head.flank,
            values: Vec::new(),
        };
        Ok(Open::Values(head.name, curve, head.count))
    }

    /// Takes over values of the open trace.
    fn take_values(&mut self, p40: &mut P40, (line, text): (u64, &str), problems: &mut Problems) {
        let Open::Values(name, curve, count) = &mut self.open else {
            return;
        };
        let mut wrong = |reason: String| problems.add(self.file.problem_at(line, reason, CORRECT));
        for word in text.split_whitespace() {
            let number = without_zero(word).filter(|found| found.value.abs() <= 1e7);
            // What is no number is reported and leaves a hole: the values behind it keep their places.
            let measured = match number {
                Some(number) => Some(number.value).filter(|_| !p40.unmeasured.is(&number)),
                None => {
                    wrong(format!(
                        "{}, allowed is a number of µm: value {} of {count} of the trace of line {}",
                        self.file.quote(word),
                        curve.values.len() + 1,
                        curve.line
                    ));
                    None
                }
            };
            curve.values.push((line, measured));
        }
        let found = curve.values.len();
        if found < *count {
            return;
        }
        if found > *count {
            wrong(format!(
                "{found} values of the trace of line {}, which has {count}",
                curve.line
            ));
            self.open = Open::Wrong;
            return;
        }
        let name = *name;
        if let Open::Values(_, curve, _) = std::mem::replace(&mut self.open, Open::Nothing)
            && let Err(reason) = keep(p40, name, curve)
        {
            wrong(reason);
        }
    }
}

/// Keeps a whole trace, or counts it.
fn keep(p40: &mut P40, name: &'static str, curve: FlankTrace) -> Result<(), String> {
    if name != PROFILES {
        p40.count_unused(name, 1);
        return Ok(());
    }
    let same = |other: &&FlankTrace| (other.tooth, other.flank) == (curve.tooth, curve.flank);
    if let Some(first) = p40.profiles.iter().find(same) {
        return Err(format!(
            "the profile of tooth {}, {} flank, stands in line {} already",
            curve.tooth,
            curve.flank.name(),
            first.line
        ));
    }
    p40.profiles.push(curve);
    Ok(())
}

fn too_many() -> String {
    format!("more rows than the {MOST_ROWS} of both flanks of 10 000 teeth")
}

/// Takes over a line of a block; with a reason whether the rest of the block makes no sense.
fn take_row<'a>(
    file: &DataFile,
    p40: &mut P40<'a>,
    (line, text): (u64, &'a str),
) -> Result<(), (String, bool)> {
    let rows: usize = p40.blocks.iter().map(|block| block.rows.len()).sum();
    let unmeasured = p40.unmeasured;
    let Some(block) = p40.blocks.last_mut() else {
        return Ok(());
    };
    if block.columns.is_empty() {
        block.columns = block::names(file, text).map_err(|reason| (reason, true))?;
    } else if rows >= MOST_ROWS {
        return Err((too_many(), true));
    } else {
        let row = block::row(file, text, &block.columns, unmeasured, without_zero);
        let (tooth, values) = row.map_err(|reason| (reason, false))?;
        block.rows.push((line, tooth, values));
    }
    Ok(())
}

/// Whether `text` is a row of the probe's positions.
fn is_position(text: &str) -> bool {
    let mut words = text.split_whitespace();
    let tooth = words.next().and_then(tooth_number);
    let side = words.next();
    let numbers = words.map(without_zero).collect::<Option<Vec<_>>>();
    tooth.is_some()
        && matches!(side, Some("R" | "L"))
        && numbers.is_some_and(|four| four.len() == 4)
}
