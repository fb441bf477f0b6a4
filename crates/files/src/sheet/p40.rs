//! Curve files `.mka` and value files `.mew` of Klingelnberg's P40 (GINA).
//!
//! Line 1 names the kind; behind it stand a preamble `KEY value ! comment`, numbered header lines, and the data: of a curve file
//! traces, diameters, the tables of pitch and the probe's positions, of a value file lines `10111 : fHb links 1 : -2.9`. The
//! grammar is not published by its owner; it is that of files seen by public readers. Every line must be understood; what is
//! understood and not used is named in a remark.

use super::block::{self, Block};
use super::header::Header;
use super::limits::MOST_ROWS;
use super::number::{self, Decimal, Written};
use crate::data_file::DataFile;
use crate::problems::Problems;
use gearlash::gear::Flank;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The number that stands for a point that was not measured, where the preamble names no other.
const UNDEFINED: f64 = -2147483.648;
const CORRECT: &str = "correct the line, or name a file as the machine wrote it";
const POSITIONS: [&str; 6] = ["Z-Nr.", "Seite", "PHI", "X", "Y", "Z"];

/// A profile trace.
#[derive(Debug)]
pub struct Curve {
    /// The line of its head.
    pub line: u64,
    pub tooth: u32,
    pub flank: Flank,
    /// Each with its line, µm; `None`: undefined.
    pub values: Vec<(u64, Option<f64>)>,
}

/// Where the probe was at a flank.
#[derive(Debug)]
pub struct Position {
    pub line: u64,
    pub tooth: u32,
    pub flank: Flank,
    /// Rotation `PHI`, degrees, and `X`, `Y`, mm.
    pub at: [f64; 3],
}

/// A numbered header line.
#[derive(Debug)]
pub struct Numbered {
    pub line: u64,
    /// In lower case.
    pub label: String,
    pub numbers: Vec<f64>,
}

/// A file as read.
#[derive(Debug, Default)]
pub struct P40<'a> {
    pub header: Header,
    pub numbered: Vec<Numbered>,
    pub blocks: Vec<Block<'a>>,
    pub profiles: Vec<Curve>,
    pub positions: Vec<Position>,
    /// How many there are of what is never used.
    unused: BTreeMap<&'static str, usize>,
    preamble: HashMap<&'a str, &'a str>,
}

/// Whether `text` says that it is one.
pub fn is_one(text: &str) -> bool {
    kind(text.lines().next().unwrap_or_default()).is_some()
}

/// Whether the first line is that of a curve file, and not of a value file.
fn kind(line: &str) -> Option<bool> {
    let mut words = line.split_whitespace();
    let known = words.next() == Some("HEADER");
    match (words.next(), words.next()) {
        (Some("KS.MK.FILE"), None) if known => Some(true),
        (Some("KS.MW.FILE"), None) if known => Some(false),
        _ => None,
    }
}

/// `word` as a number: as elsewhere, and without the 0 before the point, as these machines leave it out.
fn written(word: &str) -> Option<Written<'_>> {
    let at = usize::from(word.starts_with(['-', '+']));
    if !word[at..].starts_with('.') {
        let found = number::written(word)?;
        return (found.decimal != Some(Decimal::Comma) && !number::zero_first(word))
            .then_some(found);
    }
    let full = format!("{}0{}", &word[..at], &word[at..]);
    let found = number::written(&full)?;
    Some(Written {
        text: word,
        value: found.value,
        decimal: found.decimal,
        may_be_thousands: found.may_be_thousands,
        rounding: found.rounding,
    })
}

/// What the lines that follow belong to.
enum Open {
    Nothing,
    /// `Profil:`, `Flankenlinie:` or `Verschränkung:`, by name.
    Title(&'static str),
    /// Values of a trace: how many are to come, and whether it is kept.
    Values(&'static str, Curve, usize),
    /// Diameters.
    Diameters(&'static str),
    Block,
    /// Positions: whether their columns have been named.
    Positions(bool),
}

/// All lines of `text`; whatever is not understood is a problem.
pub fn parse<'a>(file: &DataFile, text: &'a str, problems: &mut Problems) -> Option<P40<'a>> {
    let mut read = P40::default();
    let mut lines = (1..).zip(text.lines());
    let curves = kind(lines.next()?.1)?;
    let mut open = Open::Nothing;
    let mut in_body = false;
    let mut seen = HashSet::new();
    let mut rows = 0;
    let mut last = 1;
    let mut good = true;
    for (line, text) in lines {
        last = line;
        let text = text.trim();
        if text.is_empty() {
            continue;
        }
        rows += 1;
        let found = if !in_body && read.take_header(file, line, text, problems, &mut seen)? {
            Ok(())
        } else {
            in_body = true;
            match curves {
                true => read.take(file, line, text, &mut open),
                false => read.take_value(file, text, &mut seen),
            }
        };
        if let Err(reason) = found {
            problems.add(file.problem_at(line, reason, CORRECT));
            good = false;
        }
        if problems.is_full() {
            return None;
        }
    }
    if let Open::Values(_, curve, count) = &open {
        let found = curve.values.len();
        let reason = format!("the file ends here, {found} of {count} values into a trace");
        problems.add(file.problem_at(last, reason, "name a file that is whole"));
        good = false;
    }
    if !in_body && good {
        let reason = format!("the file ends here without data ({rows} lines of header)");
        problems.add(file.problem_at(last, reason, "name a file that is whole"));
        return None;
    }
    good.then_some(read)
}

impl<'a> P40<'a> {
    /// Takes over a line of the header; `Some(false)` where it is none.
    fn take_header(
        &mut self,
        file: &DataFile,
        line: u64,
        text: &'a str,
        problems: &mut Problems,
        seen: &mut HashSet<u32>,
    ) -> Option<bool> {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        let behind = text[digits..].trim_start();
        if (1..=3).contains(&digits) && behind.starts_with(':') {
            if !text[..digits].parse().is_ok_and(|code| seen.insert(code)) {
                let reason = format!("the number {} stands twice", file.bare(&text[..digits]));
                problems.add(file.problem_at(line, reason, CORRECT));
                return None;
            }
            let (label, fields) = behind[1..].split_once(':').unwrap_or((&behind[1..], ""));
            let words = fields.split([' ', '\t', ':']);
            let numbers: Vec<f64> = words.filter_map(written).map(|found| found.value).collect();
            // Of several fields the first number is what the label says.
            let first = fields.split([' ', '\t', ':']).find(|word| !word.is_empty());
            let said = format!("{} {label}: {}", &text[..digits], first.unwrap_or_default());
            let said = said.replace(": .", ": 0.").replace(": -.", ": -0.");
            self.header.take(file, line, &said, problems);
            self.numbered.push(Numbered {
                line,
                label: label.to_lowercase(),
                numbers,
            });
            return Some(true);
        }
        let body = text.split('!').next().unwrap_or_default().trim();
        let (key, value) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
        let is_key = key.chars().all(|c| c.is_ascii_uppercase()) && !key.is_empty();
        if !self.numbered.is_empty() || !is_key {
            return Some(false);
        }
        let value = value.trim();
        let fits = match key {
            "UNDEFINED" => written(value).is_some(),
            "UNITS" => !value.to_lowercase().contains("inch"),
            _ => true,
        };
        if !fits {
            let allowed = match key {
                "UNITS" => "mm and µm",
                _ => "a number with a decimal point",
            };
            let reason = format!("{key} is {}, allowed is {allowed}", file.quote(value));
            problems.add(file.problem_at(line, reason, CORRECT));
            return None;
        }
        self.preamble.insert(key, value);
        Some(true)
    }

    /// Takes over a line of the data of a curve file.
    fn take(
        &mut self,
        file: &DataFile,
        line: u64,
        text: &'a str,
        open: &mut Open,
    ) -> Result<(), String> {
        if let Open::Values(title, curve, count) = open {
            for word in text.split_whitespace() {
                let value = written(word).filter(|found| found.value.abs() <= 1e7);
                let value = value.ok_or_else(|| {
                    format!(
                        "{}, allowed is a number of µm: the trace of line {} has {} of {count} values",
                        file.quote(word),
                        curve.line,
                        curve.values.len()
                    )
                })?;
                let undefined = self
                    .preamble
                    .get("UNDEFINED")
                    .and_then(|word| written(word));
                let undefined = undefined.map_or(UNDEFINED, |found| found.value);
                let value = (value.value > undefined + 1.0).then_some(value.value);
                curve.values.push((line, value));
            }
            if curve.values.len() > *count {
                return Err(format!(
                    "{} values of the trace of line {}, which has {count}",
                    curve.values.len(),
                    curve.line
                ));
            }
            if curve.values.len() == *count {
                let title = *title;
                if let Open::Values(_, curve, _) = std::mem::replace(open, Open::Title(title)) {
                    self.keep(title, curve)?;
                }
            }
            return Ok(());
        }
        if let Some(side) = block::side(text) {
            if self.blocks.iter().any(|block| block.side == side) {
                return Err("duplicate block of this flank".to_owned());
            }
            self.blocks.push(Block {
                side,
                line,
                columns: Vec::new(),
                rows: Vec::new(),
            });
            *open = Open::Block;
            return Ok(());
        }
        let titles = [
            ("Profil:", "profile traces"),
            ("Flankenlinie:", "lead traces"),
            ("Verschränkung:", "twist traces"),
        ];
        let mut rest = text;
        if let Some((known, title)) = titles
            .into_iter()
            .find(|(known, _)| text.starts_with(known))
        {
            *open = Open::Title(title);
            rest = text[known.len()..].trim();
            if rest.is_empty() {
                return Ok(());
            }
        }
        if rest.starts_with("Zahn-Nr.:") {
            let Open::Title(title) = *open else {
                return Err(
                    "a trace below none of Profil:, Flankenlinie: and Verschränkung:".to_owned(),
                );
            };
            let (title, curve, count) = curve_head(file, line, rest, title)?;
            *open = Open::Values(title, curve, count);
            return Ok(());
        }
        let diameters = [
            ("Fußkreisdurchmesser", "root diameters"),
            ("Kopfkreisdurchmesser", "tip diameters"),
        ];
        if let Some((_, name)) = diameters
            .into_iter()
            .find(|(known, _)| text.starts_with(known))
        {
            *open = Open::Diameters(name);
            return Ok(());
        }
        if text == "Teilung:" {
            if !self.positions.is_empty() {
                return Err("duplicate block Teilung:".to_owned());
            }
            *open = Open::Positions(false);
            return Ok(());
        }
        match open {
            Open::Diameters(name) => {
                let count = text
                    .split_whitespace()
                    .map(written)
                    .map(|found| found.map(|_| 1));
                let count: Option<usize> = count.sum();
                let count = count.ok_or_else(|| not_understood(file, text))?;
                *self.unused.entry(name).or_default() += count;
                Ok(())
            }
            Open::Block => self.take_row(file, line, text),
            Open::Positions(named) if !*named => {
                *named = text.split_whitespace().eq(POSITIONS);
                let reason = format!("{}, allowed is {}", file.quote(text), POSITIONS.join(" "));
                named.then_some(()).ok_or(reason)
            }
            Open::Positions(_) => self.take_position(file, line, text),
            _ => Err(not_understood(file, text)),
        }
    }

    fn take_row(&mut self, file: &DataFile, line: u64, text: &'a str) -> Result<(), String> {
        let rows: usize = self.blocks.iter().map(|block| block.rows.len()).sum();
        let Some(block) = self.blocks.last_mut() else {
            return Err(not_understood(file, text));
        };
        if block.columns.is_empty() {
            block.columns = block::names(file, text)?;
        } else if rows >= MOST_ROWS {
            return Err(format!(
                "more rows than the {MOST_ROWS} of both flanks of 10 000 teeth"
            ));
        } else {
            let (tooth, values) = block::row(file, text, &block.columns, written)?;
            block.rows.push((line, tooth, values));
        }
        Ok(())
    }

    fn take_position(&mut self, file: &DataFile, line: u64, text: &str) -> Result<(), String> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let wrong = || {
            let words = file.quote(text);
            format!("{words}, allowed is a tooth, R or L, and PHI in degrees, X, Y and Z in mm")
        };
        let [tooth, side, numbers @ ..] = &words[..] else {
            return Err(wrong());
        };
        let tooth = number::tooth(tooth).filter(|tooth| (1..=10_000).contains(tooth));
        let flank = match *side {
            "R" => Some(Flank::Right),
            "L" => Some(Flank::Left),
            _ => None,
        };
        let small = |word: &&str| {
            written(word)
                .map(|found| found.value)
                .filter(|v| v.abs() <= 1e6)
        };
        let numbers: Option<Vec<f64>> = numbers.iter().map(small).collect();
        let (Some(tooth), Some(flank), Some(&[phi, x, y, _])) = (tooth, flank, numbers.as_deref())
        else {
            return Err(wrong());
        };
        if self.positions.len() >= MOST_ROWS {
            return Err(format!(
                "more rows than the {MOST_ROWS} of both flanks of 10 000 teeth"
            ));
        }
        self.positions.push(Position {
            line,
            tooth,
            flank,
            at: [phi, x, y],
        });
        Ok(())
    }

    fn keep(&mut self, title: &'static str, curve: Curve) -> Result<(), String> {
        if title != "profile traces" {
            *self.unused.entry(title).or_default() += 1;
            return Ok(());
        }
        let same = |other: &&Curve| (other.tooth, other.flank) == (curve.tooth, curve.flank);
        if let Some(first) = self.profiles.iter().find(same) {
            return Err(format!(
                "the profile of tooth {}, {} flank, stands in line {} already",
                curve.tooth,
                curve.flank.name(),
                first.line
            ));
        }
        self.profiles.push(curve);
        Ok(())
    }

    /// Takes over a line of a value file: five digits, what it is, and a number.
    fn take_value(
        &mut self,
        file: &DataFile,
        text: &str,
        seen: &mut HashSet<u32>,
    ) -> Result<(), String> {
        let parts: Vec<&str> = text.split(':').map(str::trim).collect();
        let [code, label, value] = parts[..] else {
            return Err(not_understood(file, text));
        };
        let Some(number) = number::tooth(code).filter(|_| code.len() == 5 && !label.is_empty())
        else {
            return Err(not_understood(file, text));
        };
        let Some(value) = written(value) else {
            let value = file.quote(value);
            return Err(format!("{value}, allowed is a number with a decimal point"));
        };
        if !seen.insert(number) {
            return Err(format!("the number {} stands twice", file.bare(code)));
        }
        // Not measured, not available; and the tip diameters that repeat those of the roots.
        let name = match (value.value, number) {
            (-9999.0 | 8999.0, _) => "values not measured or not available",
            (_, 26711..=26715) => {
                "tip diameters 26711–26715 (such files repeat the root diameters there)"
            }
            _ => "values",
        };
        *self.unused.entry(name).or_default() += 1;
        Ok(())
    }

    /// The first header line whose label holds one of `words`.
    pub fn labelled(&self, words: &[&str]) -> Option<&Numbered> {
        let has = |line: &&Numbered| words.iter().any(|word| line.label.contains(word));
        self.numbered.iter().find(has)
    }

    /// The problem of a value file, where there is one.
    pub fn refuse_values(&self, file: &DataFile, problems: &mut Problems) -> Option<()> {
        let values = self.unused.keys().any(|name| name.contains("values"));
        if values {
            problems.add(file.problem(
                "is a value file (.mew): results by number, of which none is known for certain to be a span or a dimension over pins",
                "name the curve file of the same measurement (.mka), or write the values into the pair file",
            ));
        }
        (!values).then_some(())
    }

    /// What of the file is read and left unused, for a remark.
    pub fn unused(&self, used: &str) -> String {
        let mut there = self.unused.clone();
        there.insert("profile traces", self.profiles.len());
        there.insert("blocks of pitch", self.blocks.len());
        there.insert("positions of the probe", self.positions.len());
        there.remove(used);
        let named = there.iter().filter(|(_, count)| **count > 0);
        let named: Vec<String> = named
            .map(|(name, count)| format!("{count} {name}"))
            .collect();
        match named.is_empty() {
            true => "nothing else".to_owned(),
            false => named.join(", "),
        }
    }

    /// Whether the profile is measured over diameters, as far as the preamble says.
    pub fn profile_by(&self) -> Option<&str> {
        self.preamble.get("PROFILE").copied()
    }
}

fn not_understood(file: &DataFile, text: &str) -> String {
    format!("{} is not understood here", file.quote(text))
}

/// `Zahn-Nr.: 44 links / 480  Werte  z= 7.500`; with a letter behind the tooth a trace beside the main one.
fn curve_head(
    file: &DataFile,
    line: u64,
    text: &str,
    title: &'static str,
) -> Result<(&'static str, Curve, usize), String> {
    let wrong = || {
        let words = file.quote(text);
        format!("{words}, allowed is such as Zahn-Nr.: 44 links / 480 Werte z= 7.500")
    };
    let behind = text.strip_prefix("Zahn-Nr.:").unwrap_or(text);
    let behind = behind.replace('/', " ").replace('=', "= ");
    let mut words: Vec<&str> = behind.split_whitespace().collect();
    // Of a twist trace the one it belongs to.
    if words.get(1).is_some_and(|word| word.contains(':')) {
        words.remove(1);
    }
    let [tooth, flank, count, "Werte", axis, at] = words[..] else {
        return Err(wrong());
    };
    let tag = tooth.trim_start_matches(|c: char| c.is_ascii_digit());
    let number = number::tooth(&tooth[..tooth.len() - tag.len()]);
    let number = number.filter(|number| (1..=10_000).contains(number));
    let flank = match flank {
        "links" => Some(Flank::Left),
        "rechts" => Some(Flank::Right),
        _ => None,
    };
    let count = number::tooth(count).filter(|count| (2..=100_000).contains(count));
    let place = match (title, axis) {
        ("profile traces", "z=") => Some(title),
        ("profile traces", _) => None,
        (_, "x=" | "z=" | "d=") => Some(title),
        _ => None,
    };
    let is_tag = tag.len() <= 1 && tag.chars().all(|c| c.is_ascii_lowercase());
    let (Some(tooth), Some(flank), Some(count), Some(title), Some(_), true) =
        (number, flank, count, place, written(at), is_tag)
    else {
        return Err(wrong());
    };
    let title = match (tag, title) {
        ("", _) | (_, "lead traces" | "twist traces") => title,
        _ => "profile traces beside the main ones",
    };
    let curve = Curve {
        line,
        tooth,
        flank,
        values: Vec::new(),
    };
    Ok((title, curve, count as usize))
}
