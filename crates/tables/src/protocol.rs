//! The text protocol of a gear measuring machine, in the layout of Klingelnberg's.
//!
//! After numbered header lines, and among other data, the protocol has two blocks. A block is a line `linke Zahnflanke` or
//! `rechte Zahnflanke`, a line `Zahn-Nr. fp Fp Fr`, and a row per tooth, in µm. Only these and the known header lines are read.
//! Within a block everything must be a row until a blank line and other text. Curve files have the same blocks.

use super::column::{Column, Quantity};
use super::grid::MAX_ROWS;
use super::protocol_header::ProtocolHeader;
use super::request::Request;
use super::rows::{Row, ordered};
use crate::data_file::DataFile;
use gearlash::gear::Side;
use gearlash_text::file_numbers::{self, FileNumber, point_number};
use gearlash_text::numbers::ascii;
use std::collections::HashMap;

const NAMES: [(&str, Quantity); 5] = [
    ("Zahn-Nr.", Quantity::Tooth),
    ("fp", Quantity::SinglePitch),
    ("Fp", Quantity::CumulativePitch),
    ("Fr", Quantity::Runout),
    ("fu", Quantity::PitchDifference),
];

/// Numbers that machines print for a missing value, whatever the preamble states.
const KNOWN_UNMEASURED: [f64; 2] = [-2147483.648, -9999.0];

/// Whether `value` means a missing value: it equals a known number, or the one that the preamble `declared`, to its printed
/// digits. Its size does not matter.
pub fn is_unmeasured(value: &FileNumber, declared: Option<f64>) -> bool {
    // At most whole numbers: the last digit of 1e7 is seven places above them.
    let rounding = value.rounding.min(0.5);
    let mut numbers = KNOWN_UNMEASURED.into_iter().chain(declared);
    numbers.any(|number| (value.value - number).abs() <= rounding + 1e-12 * number.abs())
}

#[derive(Debug)]
struct Block<'a> {
    side: Side,
    line: u64,
    /// Its columns, `Zahn-Nr.` first; none before their line is read.
    columns: Vec<Quantity>,
    /// Line, tooth, and the values of the other columns.
    rows: Vec<Numbers<'a>>,
}

/// Line, tooth, and value of each row of a column.
type Values<'a> = Vec<(u64, u32, FileNumber<'a>)>;

/// Line, tooth, and values of the columns behind the tooth.
type Numbers<'a> = (u64, u32, Vec<FileNumber<'a>>);

#[derive(Debug, Default)]
pub struct Blocks<'a> {
    blocks: Vec<Block<'a>>,
    /// Rows so far, good and bad ones.
    rows: usize,
}

/// The fault of a line in a block, and a remedy.
pub struct BlockFault {
    pub reason: String,
    pub help: &'static str,
    /// Whether the rest of the block is unreadable.
    pub ends_block: bool,
}

/// The flank that the head of a block names.
pub fn side(line: &str) -> Option<Side> {
    match line.trim().trim_end_matches(':').to_lowercase().as_str() {
        "linke zahnflanke" => Some(Side::Left),
        "rechte zahnflanke" => Some(Side::Right),
        _ => None,
    }
}

/// The column that `word` names, perhaps with its unit.
fn column_of_symbol(word: &str) -> Option<Quantity> {
    let word = word.strip_suffix("[µm]").unwrap_or(word);
    let mut names = NAMES.iter();
    names
        .find(|(known, _)| *known == word)
        .map(|(_, name)| *name)
}

/// Whether `text` has the head of a block.
pub fn is_protocol(text: &str) -> bool {
    text.lines().any(|line| side(line).is_some())
}

/// Whether a line of `text` below the head of a block names `column`.
pub fn has(text: &str, column: Column) -> bool {
    if column.kind().is_none() && column.quantity != Quantity::Runout {
        return false;
    }
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    while lines.any(|line| side(line).is_some()) {
        let mut symbols = lines.next().unwrap_or_default().split_whitespace();
        if symbols.any(|word| column_of_symbol(word) == Some(column.quantity)) {
            return true;
        }
    }
    false
}

/// The wanted columns, by ascending tooth, and the header lines.
pub fn read(request: &Request, text: &str) -> Option<(Vec<Row>, ProtocolHeader)> {
    let (blocks, header) = parse(request.file, text)?;
    let teeth = request.wanted.teeth.or(header.teeth());
    Some((blocks.rows(&request.with_teeth(teeth))?, header))
}

fn parse<'a>(file: &DataFile, text: &'a str) -> Option<(Blocks<'a>, ProtocolHeader)> {
    let mut header = ProtocolHeader::default();
    let mut blocks = Blocks::default();
    let (mut is_open, mut after_blank) = (false, false);
    let mut good = Some(());
    for (line, text) in (1..).zip(text.lines()) {
        if text.trim().is_empty() {
            after_blank = true;
            continue;
        }
        let is_row = text.trim().starts_with(|c: char| c.is_ascii_digit());
        let mut taken = Ok(());
        if let Some(side) = side(text) {
            is_open = true;
            taken = blocks.begin(side, line);
        } else if is_open && after_blank && blocks.has_rows() && !is_row {
            is_open = false;
        } else if is_open {
            taken = blocks.take(file, line, text, None);
        }
        if let Err(wrong) = taken {
            file.add_at(line, wrong.reason, wrong.help);
            good = None;
            is_open &= !wrong.ends_block;
            if blocks.is_full() {
                break;
            }
        }
        if !is_open {
            header.take(file, line, text);
        }
        after_blank = false;
    }
    good.map(|()| (blocks, header))
}

impl<'a> Blocks<'a> {
    pub fn count(&self) -> usize {
        self.blocks.len()
    }

    /// Whether the last one has a row.
    fn has_rows(&self) -> bool {
        self.blocks
            .last()
            .is_some_and(|block| !block.rows.is_empty())
    }

    /// Whether no further row is read.
    fn is_full(&self) -> bool {
        self.rows >= MAX_ROWS
    }

    pub fn begin(&mut self, side: Side, line: u64) -> Result<(), BlockFault> {
        let first = self.blocks.iter().find(|block| block.side == side);
        let first = first.map(|first| first.line);
        self.blocks.push(Block {
            side,
            line,
            columns: Vec::new(),
            rows: Vec::new(),
        });
        match first {
            None => Ok(()),
            Some(first) => Err(BlockFault {
                reason: format!("duplicate block of this flank, the first begins in line {first}"),
                help: "keep one of the two",
                ends_block: false,
            }),
        }
    }

    /// Reads a line of the last block: the names of its columns, or a row.
    pub fn take(
        &mut self,
        file: &DataFile,
        line: u64,
        text: &'a str,
        unmeasured: Option<f64>,
    ) -> Result<(), BlockFault> {
        let is_full = self.is_full();
        let Some(block) = self.blocks.last_mut() else {
            return Ok(());
        };
        let wrong = |help: &'static str, ends_block: bool| {
            move |reason: String| BlockFault {
                reason,
                help,
                ends_block,
            }
        };
        if block.columns.is_empty() {
            let columns = columns(file, text);
            block.columns =
                columns.map_err(wrong("name the columns there: Zahn-Nr. fp Fp Fr", true))?;
        } else if is_full {
            let reason = format!("more rows than the {MAX_ROWS} of both flanks of 10 000 teeth");
            return Err(wrong("give a protocol of one gear", true)(reason));
        } else {
            self.rows += 1;
            let row = row(file, text, &block.columns, unmeasured);
            let (tooth, values) = row.map_err(wrong("correct the line", false))?;
            block.rows.push((line, tooth, values));
        }
        Ok(())
    }

    /// The wanted columns, by ascending tooth.
    pub fn rows(&self, request: &Request) -> Option<Vec<Row>> {
        let Request { file, wanted, .. } = request;
        let columns = wanted.columns.iter().map(|column| {
            let values = match (column.side, column.quantity) {
                (Some(side), pitch) => self.pitch(file, side, pitch),
                (None, Quantity::Runout) => self.runout(file),
                (None, _) => {
                    let reason = format!("is a pitch protocol, which has no {}", column.name());
                    file.refuse(reason, "name a table that has it")
                }
            };
            let row = |(line, tooth, value): (u64, u32, FileNumber)| Row {
                line,
                tooth: Some(tooth),
                flank: None,
                values: vec![value.value],
            };
            ordered(file, values?.into_iter().map(row).collect(), *wanted)
        });
        // All columns are read, so that every problem is reported.
        let columns: Vec<Option<Vec<Row>>> = columns.collect();
        let mut columns = columns.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
        // Every tooth is now known to be there once.
        if wanted.columns.iter().any(|column| column.kind().is_some()) {
            for block in &self.blocks {
                block.check_kinds_agree(file);
            }
        }
        let mut rows = columns.next()?;
        for column in columns {
            for (row, other) in rows.iter_mut().zip(&column) {
                if row.tooth != other.tooth {
                    return None;
                }
                row.values.extend(&other.values);
            }
        }
        Some(rows)
    }

    fn pitch(&self, file: &DataFile, side: Side, pitch: Quantity) -> Option<Values<'a>> {
        let Some(block) = self.blocks.iter().find(|block| block.side == side) else {
            let reason = match side {
                Side::Left => "has no block linke Zahnflanke",
                Side::Right => "has no block rechte Zahnflanke",
            };
            return file.refuse(reason, "give a protocol of both flanks");
        };
        let values = block.column(pitch);
        if values.is_none() {
            let reason = match pitch {
                Quantity::SinglePitch => "the block has no column fp",
                _ => "the block has no column Fp",
            };
            let help = "give the other kind, or a protocol that has it";
            file.add_at(block.line, reason, help);
        }
        values
    }

    /// `Fr` of the blocks that have it; both must state the same.
    fn runout(&self, file: &DataFile) -> Option<Values<'a>> {
        let mut columns = self
            .blocks
            .iter()
            .filter_map(|block| block.column(Quantity::Runout));
        let Some(first) = columns.next() else {
            return file.refuse("has no column Fr", "give a protocol that has it");
        };
        // The first of two rows of one tooth; the duplicate is reported elsewhere.
        let by_tooth = first
            .iter()
            .rev()
            .map(|(_, tooth, value)| (*tooth, value.value));
        let by_tooth: HashMap<u32, f64> = by_tooth.collect();
        let mut good = Some(());
        for (line, tooth, value) in columns.flatten() {
            if by_tooth.get(&tooth) != Some(&value.value) {
                let value = file.bare(value.text);
                file.add_at(
                    line,
                    format!("Fr of tooth {tooth} is {value} here, but not in the block of the other flank"),
                    "find the right one, and remove column Fr from the other block of a copy",
                );
                good = None;
            }
        }
        good.map(|()| first)
    }
}

impl<'a> Block<'a> {
    /// The values of a column, with their lines and teeth; `None` where the block does not have it.
    fn column(&self, name: Quantity) -> Option<Values<'a>> {
        let place = self.columns.iter().position(|column| *column == name)?;
        let value = |(line, tooth, values): &Numbers<'a>| {
            Some((*line, *tooth, *values.get(place.checked_sub(1)?)?))
        };
        self.rows.iter().map(value).collect()
    }

    /// Checks that single and cumulative pitch agree: `f_i = F_i − F_{i−1}`, within half a unit of the last printed digit of each
    /// of the three. The block has every tooth once.
    fn check_kinds_agree(&self, file: &DataFile) {
        let [Some(mut single), Some(mut cumulative)] =
            [Quantity::SinglePitch, Quantity::CumulativePitch].map(|name| self.column(name))
        else {
            return;
        };
        single.sort_by_cached_key(|value| u64::from(value.1));
        cumulative.sort_by_cached_key(|value| u64::from(value.1));
        let Some(mut before) = cumulative.last().copied() else {
            return;
        };
        for ((line, tooth, f), now) in single.into_iter().zip(cumulative) {
            let difference = now.2.value - before.2.value;
            let rounding = f.rounding + now.2.rounding + before.2.rounding;
            // Rounding of the subtraction: some ulps of the values.
            let slack = 1e-12 * (now.2.value.abs() + before.2.value.abs());
            if (f.value - difference).abs() > rounding + slack {
                let reason = format!(
                    "fp of tooth {tooth} is {}, but its Fp minus that of tooth {} is {}: the two columns differ by more than their rounding",
                    file.bare(f.text),
                    before.1,
                    file.bare(&ascii(difference, 4)),
                );
                let help =
                    "find the wrong one, or remove the other column from a copy of the protocol";
                file.add_at(line, reason, help);
            }
            before = now;
        }
    }
}

fn columns(file: &DataFile, text: &str) -> Result<Vec<Quantity>, String> {
    let mut names = Vec::new();
    for word in text.split_whitespace() {
        match column_of_symbol(word) {
            Some(name) if names.contains(&name) => {
                return Err(format!("duplicate column {}", file.quote(word)));
            }
            Some(name) => names.push(name),
            None => return Err(format!("unknown column {}", file.quote(word))),
        }
    }
    match names.first() {
        Some(Quantity::Tooth) => Ok(names),
        _ => Err("column Zahn-Nr. is missing".to_owned()),
    }
}

/// The tooth and the values of a row, in the order of the columns behind `Zahn-Nr.`.
fn row<'a>(
    file: &DataFile,
    text: &'a str,
    columns: &[Quantity],
    unmeasured: Option<f64>,
) -> Result<(u32, Vec<FileNumber<'a>>), String> {
    let mut words = text.split_whitespace();
    let (found, expected) = (words.clone().count(), columns.len());
    let Some(first) = words.next().filter(|_| found == expected) else {
        return Err(format!("{found} values, the block has {expected} columns"));
    };
    let tooth = file_numbers::tooth(first).filter(|tooth| (1..=10_000).contains(tooth));
    let Some(tooth) = tooth else {
        let found = file.quote(first);
        return Err(format!(
            "Zahn-Nr. is {found}, allowed is a whole number from 1 on"
        ));
    };
    let values = words.map(|word| match point_number(word) {
        Some(written) if is_unmeasured(&written, unmeasured) => {
            let source = if is_unmeasured(&written, None) {
                ""
            } else {
                ", as UNDEFINED of the preamble says"
            };
            let word = file.bare(word);
            Err(format!(
                "{word} stands for a value that was not measured{source}"
            ))
        }
        Some(written) if written.value.abs() <= 1e7 => Ok(written),
        _ => {
            let word = file.quote(word);
            Err(format!(
                "{word}, allowed is a number of µm with a decimal point, −1e7 … 1e7"
            ))
        }
    });
    Ok((tooth, values.collect::<Result<_, _>>()?))
}
