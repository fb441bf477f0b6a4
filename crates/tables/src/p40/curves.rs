//! The data of a curve file: traces, the tables of pitch, and parts that are only counted: diameters and positions of the probe.
//!
//! A head closes the part before it. Lines below a wrong head are skipped: one mistake is one problem.

use super::{CORRECT, FlankTrace, LEADS, P40, PROFILES};
use crate::data_file::DataFile;
use crate::protocol::{self, is_unmeasured};
use gearlash::gear::Flank;
use gearlash_text::file_numbers::{point_number, tooth as tooth_number};

const DIAMETERS: [(&str, &str); 2] = [
    ("Fußkreisdurchmesser", "root diameters"),
    ("Kopfkreisdurchmesser", "tip diameters"),
];
/// The head of the probe's positions, their columns, and one of their rows.
const TEILUNG: &str = "Teilung:";
const COLUMNS: [&str; 6] = ["Z-Nr.", "Seite", "PHI", "X", "Y", "Z"];
const POSITION: &str = "a tooth, R or L, and PHI in degrees, X, Y and Z in mm";
/// Start of the head of a trace.
const ZAHN: &str = "Zahn-Nr.:";

/// Kind of the traces below a title.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Title {
    Profile,
    Lead,
    Twist,
}

const TITLES: [(&str, Title); 3] = [
    ("Profil:", Title::Profile),
    ("Flankenlinie:", Title::Lead),
    ("Verschränkung:", Title::Twist),
];

impl Title {
    /// The title that `text` begins with, and what follows it.
    fn of(text: &str) -> Option<(Title, &str)> {
        let mut titles = TITLES.into_iter();
        titles.find_map(|(known, title)| Some((title, text.strip_prefix(known)?.trim_start())))
    }
}

/// The part that the next lines belong to.
#[derive(Debug)]
enum Open {
    Nothing,
    Wrong,
    Values(Trace),
    /// Diameters, by name.
    Diameters(&'static str),
    Block,
    /// Positions; `true` after the line of their columns.
    Positions(bool),
}

/// A trace that is being read: the name of its kind, and how many values it has.
#[derive(Debug)]
struct Trace {
    name: &'static str,
    curve: FlankTrace,
    count: usize,
}

/// The reader's position in the data of a file.
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

    /// Describes the values that are missing if the file ends here.
    pub fn cut_short(&self) -> Option<String> {
        let Open::Values(Trace { curve, count, .. }) = &self.open else {
            return None;
        };
        let found = curve.values.len();
        Some(format!(
            "{found} of {count} values into the trace of line {}",
            curve.line
        ))
    }

    pub fn take<'a>(&mut self, p40: &mut P40<'a>, (line, text): (u64, &'a str)) {
        let file = self.file;
        let wrong = |reason: String| file.add_at(line, reason, CORRECT);
        let is_head = protocol::side(text).is_some()
            || Title::of(text).is_some()
            || text.starts_with(ZAHN)
            || DIAMETERS.iter().any(|(known, _)| text.starts_with(known))
            || text == TEILUNG;
        if is_head {
            if let Some(reason) = self.cut_short() {
                wrong(format!("the trace before it ends too early: {reason}"));
            }
            self.open = self.begin(p40, line, text).unwrap_or_else(|reason| {
                wrong(reason);
                Open::Wrong
            });
            return;
        }
        let words = || text.split_whitespace();
        let not_understood = || format!("{} is not understood here", file.quote(text));
        self.open = match std::mem::replace(&mut self.open, Open::Wrong) {
            Open::Wrong => Open::Wrong,
            Open::Values(mut trace) => match take_values(p40, file, &mut trace, (line, text)) {
                Ok(false) => Open::Values(trace),
                Ok(true) => {
                    keep(p40, trace).unwrap_or_else(wrong);
                    Open::Nothing
                }
                Err(reason) => {
                    wrong(reason);
                    Open::Wrong
                }
            },
            Open::Diameters(name) => {
                p40.count_unused(name, words().count());
                if !words().all(|word| point_number(word).is_some()) {
                    wrong(not_understood());
                }
                Open::Diameters(name)
            }
            Open::Block => {
                let taken = p40.blocks.take(file, line, text, p40.unmeasured);
                let ends_block = taken.as_ref().is_err_and(|bad| bad.ends_block);
                taken.unwrap_or_else(|bad| wrong(bad.reason));
                if ends_block { Open::Wrong } else { Open::Block }
            }
            Open::Positions(true) => {
                p40.count_unused("positions of the probe", 1);
                if !is_position(text) {
                    wrong(format!("{}, allowed is {POSITION}", file.quote(text)));
                }
                Open::Positions(true)
            }
            Open::Positions(false) if words().eq(COLUMNS) => Open::Positions(true),
            Open::Positions(false) => {
                let (found, columns) = (file.quote(text), COLUMNS.join(" "));
                wrong(format!("{found}, allowed is {columns}"));
                Open::Wrong
            }
            Open::Nothing => {
                wrong(not_understood());
                Open::Wrong
            }
        };
    }

    fn begin(&mut self, p40: &mut P40, line: u64, text: &str) -> Result<Open, String> {
        let mut rest = text;
        if let Some((title, behind)) = Title::of(text) {
            self.title = Some(title);
            rest = behind;
            if rest.is_empty() {
                return Ok(Open::Nothing);
            }
        }
        let trace = |title| head_of_trace(self.file, line, rest, title);
        if rest.starts_with(ZAHN) || rest != text {
            let title = self
                .title
                .ok_or("a trace below none of Profil:, Flankenlinie: and Verschränkung:")?;
            return Ok(Open::Values(trace(title)?));
        }
        self.title = None;
        if let Some(side) = protocol::side(text) {
            p40.blocks.begin(side, line).map_err(|wrong| wrong.reason)?;
            return Ok(Open::Block);
        }
        let mut diameters = DIAMETERS
            .iter()
            .filter(|(known, _)| text.starts_with(known));
        Ok(diameters
            .next()
            .map_or(Open::Positions(false), |(_, name)| Open::Diameters(name)))
    }
}

/// Reads values of a trace; whether it is complete.
fn take_values(
    p40: &P40,
    file: &DataFile,
    Trace { curve, count, .. }: &mut Trace,
    (line, text): (u64, &str),
) -> Result<bool, String> {
    let of = curve.line;
    for word in text.split_whitespace() {
        let number = point_number(word).filter(|found| found.value.abs() <= 1e7);
        // A word that is no number is reported and leaves a gap: the values behind it keep their places.
        if number.is_none() {
            let (word, place) = (file.quote(word), curve.values.len() + 1);
            let reason = format!(
                "{word}, allowed is a number of µm: value {place} of {count} of the trace of line {of}"
            );
            file.add_at(line, reason, CORRECT);
        }
        let measured = number.filter(|number| !is_unmeasured(number, p40.unmeasured));
        let value = measured.map(|number| number.value);
        curve.values.push((line, value));
    }
    let found = curve.values.len();
    if found > *count {
        return Err(format!(
            "{found} values of the trace of line {of}, which has {count}"
        ));
    }
    Ok(found == *count)
}

/// Keeps a whole profile or lead, or counts another trace.
fn keep(p40: &mut P40, Trace { name, curve, .. }: Trace) -> Result<(), String> {
    let (kept, kind) = match name {
        PROFILES => (&mut p40.profiles, "profile"),
        LEADS => (&mut p40.leads, "lead"),
        _ => {
            p40.count_unused(name, 1);
            return Ok(());
        }
    };
    let same = |other: &&FlankTrace| (other.tooth, other.flank) == (curve.tooth, curve.flank);
    if let Some(first) = kept.iter().find(same) {
        let (tooth, flank) = (curve.tooth, curve.flank.name());
        return Err(format!(
            "the {kind} of tooth {tooth}, {flank} flank, stands in line {} already",
            first.line
        ));
    }
    kept.push(curve);
    Ok(())
}

/// The head of a trace, `Zahn-Nr.: 44 links / 480  Werte  z= 7.500`; a letter behind the tooth marks a trace beside the main one.
fn head_of_trace(file: &DataFile, line: u64, text: &str, title: Title) -> Result<Trace, String> {
    let wrong = || {
        let words = file.quote(text);
        format!("{words}, allowed is such as Zahn-Nr.: 44 links / 480 Werte z= 7.500")
    };
    let behind = text.strip_prefix(ZAHN).ok_or_else(wrong)?;
    let behind = behind.replace('/', " ").replace('=', "= ");
    let mut words: Vec<&str> = behind.split_whitespace().collect();
    // A twist trace names its main trace.
    if words.get(1).is_some_and(|word| word.contains(':')) {
        words.remove(1);
    }
    let [tooth, flank, count, "Werte", axis, at] = words[..] else {
        return Err(wrong());
    };
    let tag = tooth.trim_start_matches(|c: char| c.is_ascii_digit());
    let number = tooth_number(&tooth[..tooth.len() - tag.len()])
        .filter(|number| (1..=10_000).contains(number));
    let flank = match flank {
        "links" => Some(Flank::Left),
        "rechts" => Some(Flank::Right),
        _ => None,
    };
    let count = tooth_number(count).filter(|count| (2..=100_000).contains(count));
    let axes: &[&str] = if title == Title::Profile {
        &["z="]
    } else {
        &["x=", "z=", "d="]
    };
    let is_tag = tag.len() <= 1 && tag.chars().all(|c| c.is_ascii_lowercase());
    let is_good = is_tag && axes.contains(&axis) && point_number(at).is_some();
    let (Some(tooth), Some(flank), Some(count), true) = (number, flank, count, is_good) else {
        return Err(wrong());
    };
    let name = match (title, tag) {
        (Title::Lead, "") => LEADS,
        (Title::Lead, _) => "lead traces beside the main ones",
        (Title::Twist, _) => "twist traces",
        (Title::Profile, "") => PROFILES,
        (Title::Profile, _) => "profile traces beside the main ones",
    };
    let curve = FlankTrace {
        line,
        tooth,
        flank,
        values: Vec::new(),
    };
    Ok(Trace {
        name,
        curve,
        count: count as usize,
    })
}

/// Whether `text` is a row of the probe's positions.
fn is_position(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    let [tooth, "R" | "L", numbers @ ..] = &words[..] else {
        return false;
    };
    let are_numbers = numbers.iter().all(|word| point_number(word).is_some());
    tooth_number(tooth).is_some() && numbers.len() == 4 && are_numbers
}
