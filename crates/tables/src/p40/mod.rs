//! Curve files `.mka` of Klingelnberg's P40 (GINA). Value files `.mew` are rejected: no number in them is known reliably to be of
//! use.
//!
//! Line 1 names the kind. A preamble `KEY value ! comment`, numbered header lines ` 22 :Zähnezahl z…: 52` and the data
//! ([`curves`]) follow. The owner has not published the grammar; this one comes from files seen by public readers. Every line
//! must be understood; a remark lists the parts that are understood but not used.

mod curves;
mod traces;

use super::column::Quantity;
use super::protocol::Blocks;
use super::protocol_header::ProtocolHeader;
use super::request::{Coverage, Request};
use super::rows::Row;
use crate::data_file::DataFile;
use curves::Data;
use gearlash::gear::Flank;
use gearlash_text::file_numbers::point_number;
use std::collections::{BTreeMap, HashSet};

const CORRECT: &str = "correct the line, or name a file as the machine wrote it";
/// Names of parts of a file in [`P40::unread`].
const PITCH: &str = "blocks of pitch";
const PROFILES: &str = "profile traces";
const LEADS: &str = "lead traces";
/// Angles must be in degrees; `Grad` is the German word.
const DEGREES: [&str; 5] = ["deg", "degree", "degrees", "grad", "°"];

#[derive(Debug)]
struct FlankTrace {
    line: u64,
    tooth: u32,
    flank: Flank,
    /// Each with its line, µm; `None`: not measured.
    values: Vec<(u64, Option<f64>)>,
}

#[derive(Debug)]
struct Numbered {
    line: u64,
    /// In lower case.
    label: String,
    numbers: Vec<f64>,
}

#[derive(Debug, Default)]
pub struct P40<'a> {
    header: ProtocolHeader,
    numbered: Vec<Numbered>,
    /// `PROFILE` of the preamble: the quantity that the profile is measured over.
    profile_by: Option<&'a str>,
    /// `UNDEFINED` of the preamble.
    unmeasured: Option<f64>,
    blocks: Blocks<'a>,
    profiles: Vec<FlankTrace>,
    leads: Vec<FlankTrace>,
    /// The number of each part that is never used.
    never_used: BTreeMap<&'static str, usize>,
    /// The numbers of header lines so far.
    codes: HashSet<u32>,
}

/// Whether `text` is a curve file by its first line.
pub fn is_curve_file(text: &str) -> bool {
    is_of_kind(text, "KS.MK.FILE")
}

/// Whether `text` is a value file by its first line.
pub fn is_value_file(text: &str) -> bool {
    is_of_kind(text, "KS.MW.FILE")
}

fn is_of_kind(text: &str, kind: &str) -> bool {
    let first = text.lines().next().unwrap_or_default();
    first.split_whitespace().eq(["HEADER", kind])
}

/// The rows that are wanted, and the header lines.
pub fn read(request: &Request, text: &str) -> Option<(Vec<Row>, ProtocolHeader)> {
    let (file, wanted) = (request.file, request.wanted);
    let p40 = parse(file, text)?;
    if wanted.has(Quantity::Height) {
        return traces::leads(file, &p40, wanted.teeth);
    }
    if let Coverage::Points { base_radius } = wanted.coverage {
        return traces::profiles(file, &p40, (wanted.teeth, base_radius));
    }
    if wanted.has(Quantity::Thickness) {
        return file.refuse(
            "is a curve file: thickness is not taken from the probe's positions",
            "name a table of the thickness of each tooth, or state the thickness by span or over_pins",
        );
    }
    let teeth = wanted.teeth.or(p40.header.teeth());
    let rows = p40.blocks.rows(&request.with_teeth(teeth))?;
    let mut header = p40.header.clone();
    header.set_unread(file, &p40.unread(PITCH));
    Some((rows, header))
}

/// Whether a curve file has profile traces.
pub fn has_profiles(text: &str) -> bool {
    text.lines().any(|line| line.trim().starts_with("Profil:"))
}

/// Whether a curve file has lead traces, and the face width that they need.
pub fn has_leads(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim);
    lines.clone().any(|line| line.starts_with("Flankenlinie:"))
        && lines.any(|line| line.to_lowercase().contains(traces::FACE_WIDTH))
}

/// Reads all lines of `text`; a line that is not understood is a problem.
pub fn parse<'a>(file: &DataFile, text: &'a str) -> Option<P40<'a>> {
    file.list(|| lines(file, text))
}

fn lines<'a>(file: &DataFile, text: &'a str) -> Option<P40<'a>> {
    let mut p40 = P40::default();
    let mut data = Data::new(file);
    let (mut in_body, mut last, mut rows) = (false, 1, 0);
    for (line, text) in (1..).zip(text.lines()).skip(1) {
        last = line;
        let text = text.trim();
        if text.is_empty() {
            continue;
        }
        rows += 1;
        if !in_body && p40.take_header(file, line, text)? {
            continue;
        }
        in_body = true;
        data.take(&mut p40, (line, text));
        if file.reading().is_full() {
            return None;
        }
    }
    let whole = "name a file that is whole";
    if let Some(reason) = data.cut_short() {
        file.add_at(last, format!("the file ends here, {reason}"), whole);
    }
    if !in_body {
        let reason = format!("the file ends here without data ({rows} lines of header)");
        file.add_at(last, reason, whole);
    }
    Some(p40)
}

impl<'a> P40<'a> {
    /// Counts a part that is never used.
    fn count_unused(&mut self, name: &'static str, count: usize) {
        *self.never_used.entry(name).or_default() += count;
    }

    /// The parts of the file that are not used beside `used`, for a remark.
    fn unread(&self, used: &str) -> String {
        let mut there = self.never_used.clone();
        there.insert(PROFILES, self.profiles.len());
        there.insert(LEADS, self.leads.len());
        there.insert(PITCH, self.blocks.count());
        there.retain(|name, count| *name != used && *count > 0);
        let named = there.iter().map(|(name, count)| format!("{count} {name}"));
        let named: Vec<String> = named.collect();
        if named.is_empty() {
            "nothing else".to_owned()
        } else {
            named.join(", ")
        }
    }

    /// Reads a line of the preamble or the header; `Some(false)` where it is neither, `None` where it ends the reading.
    fn take_header(&mut self, file: &DataFile, line: u64, text: &'a str) -> Option<bool> {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        let (code, behind) = text.split_at(digits);
        if let (1..=3, Some(rest)) = (digits, behind.trim_start().strip_prefix(':')) {
            if !code.parse().is_ok_and(|code| self.codes.insert(code)) {
                let reason = format!("the number {} stands twice", file.bare(code));
                return file.refuse_at(line, reason, CORRECT);
            }
            let (label, fields) = rest.split_once(':').unwrap_or((rest, ""));
            self.take_numbered(file, line, [code, label.trim_start(), fields]);
            return Some(true);
        }
        let body = text.split('!').next().unwrap_or_default().trim();
        let (key, value) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
        let is_key = key.chars().all(|c| c.is_ascii_uppercase()) && !key.is_empty();
        if !self.numbered.is_empty() || !is_key {
            return Some(false);
        }
        let value = value.trim();
        let words = value.to_lowercase();
        let allowed = match key {
            "UNDEFINED" => match point_number(value) {
                Some(number) => {
                    self.unmeasured = Some(number.value);
                    None
                }
                None => Some("a number with a decimal point"),
            },
            "UNITS" if words.contains("inch") => Some("mm and µm"),
            "ANGLE" if !DEGREES.contains(&&words[..]) => Some("degrees"),
            "PROFILE" => {
                self.profile_by = Some(value);
                None
            }
            _ => None,
        };
        if let Some(allowed) = allowed {
            let reason = format!("{key} is {}, allowed is {allowed}", file.quote(value));
            file.add_at(line, reason, CORRECT);
        }
        Some(true)
    }

    fn take_numbered(&mut self, file: &DataFile, line: u64, [code, label, fields]: [&str; 3]) {
        let words = fields
            .split([' ', '\t', ':'])
            .filter(|word| !word.is_empty());
        // The label belongs to the first number in several fields.
        let first = words.clone().next().unwrap_or_default();
        let first = match first.strip_prefix('-') {
            Some(rest) if rest.starts_with('.') => format!("-0{rest}"),
            None if first.starts_with('.') => format!("0{first}"),
            _ => first.to_owned(),
        };
        self.header.state(file, line, [code, label, fields], &first);
        let numbers = words.filter_map(point_number).map(|number| number.value);
        let (label, numbers) = (label.to_lowercase(), numbers.collect());
        self.numbered.push(Numbered {
            line,
            label,
            numbers,
        });
    }
}
