//! Curve files `.mka` and value files `.mew` of Klingelnberg's P40 (GINA).
//!
//! Line 1 names the kind; behind it stand a preamble and numbered header lines ([`head`]), and the data, of a curve file ([`curves`])
//! or of a value file ([`values`]). The grammar is not published by its owner; it is that of files seen by public readers. Every
//! line must be understood; what is understood and not used is named in a remark.

mod content;
mod curves;
mod head;
mod profiles;
mod trace_head;
mod values;

use super::header::Header;
use super::wanted::TraceRow;
use crate::data_file::DataFile;
use crate::problems::Problems;
use content::{CORRECT, Kind};
pub use content::{P40, PITCH};
use curves::Data;
use head::Head;
use values::Values;

/// Whether `text` says that it is one.
pub fn is_one(text: &str) -> bool {
    kind(text.lines().next().unwrap_or_default()).is_some()
}

fn kind(line: &str) -> Option<Kind> {
    let mut words = line.split_whitespace();
    let known = words.next() == Some("HEADER");
    match (words.next(), words.next()) {
        (Some("KS.MK.FILE"), None) if known => Some(Kind::Curves),
        (Some("KS.MW.FILE"), None) if known => Some(Kind::Values),
        _ => None,
    }
}

/// All lines of `text`; whatever is not understood is a problem.
pub fn parse<'a>(file: &DataFile, text: &'a str, problems: &mut Problems) -> Option<P40<'a>> {
    problems.of_list_at(file.key(), |bad| lines(file, text, bad))
}

fn lines<'a>(file: &DataFile, text: &'a str, problems: &mut Problems) -> Option<P40<'a>> {
    let mut lines = (1..).zip(text.lines());
    let mut p40 = P40::new(kind(lines.next()?.1)?);
    let mut head = Head::default();
    let mut data = Data::new(file);
    let mut values = Values::default();
    let mut in_body = false;
    let (mut last, mut rows) = (1, 0);
    for (line, text) in lines {
        last = line;
        let text = text.trim();
        if text.is_empty() {
            continue;
        }
        rows += 1;
        if !in_body && head.take(file, &mut p40, (line, text), problems)? {
            continue;
        }
        in_body = true;
        match p40.kind {
            Kind::Curves => data.take(&mut p40, (line, text), problems),
            Kind::Values => {
                if let Err(reason) = values.take(file, &mut p40, text) {
                    problems.add(file.problem_at(line, reason, CORRECT));
                }
            }
        }
        if problems.is_full() {
            return None;
        }
    }
    let whole = "name a file that is whole";
    if let Some(reason) = data.cut_short() {
        problems.add(file.problem_at(last, format!("the file ends here, {reason}"), whole));
    }
    if !in_body {
        let reason = format!("the file ends here without data ({rows} lines of header)");
        problems.add(file.problem_at(last, reason, whole));
    }
    Some(p40)
}

/// The profiles of a curve file, and what it says of the gear.
pub fn profiles(
    file: &DataFile,
    text: &str,
    known: (Option<u32>, Option<f64>),
    problems: &mut Problems,
) -> Option<(Vec<TraceRow>, Header)> {
    profiles::read(file, &parse(file, text, problems)?, known, problems)
}
