//! The text protocol of a gear measuring machine, in the layout of Klingelnberg's.
//!
//! After numbered header lines, and among other data, stand two blocks: a line
//! `linke Zahnflanke` or `rechte Zahnflanke`, a line `Zahn-Nr. fp Fp Fr`, and a
//! row a tooth, in µm. Only these and the known header lines are read. Within
//! a block everything must be a row until a blank line and other text.

use super::column::Column;
use super::header::Header;
use super::number::{self, Decimal, Written};
use super::{Row, Wanted, by_tooth};
use crate::gear::Side;
use crate::input::data_file::DataFile;
use crate::input::pitch::Kind;
use crate::input::problems::Problems;

/// What such machines print for a value that was not measured.
const NOT_MEASURED: [f64; 2] = [-2147483.648, -9999.0];

/// A column of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Name {
    Tooth,
    Single,
    Cumulative,
    Runout,
}

const NAMES: [(&str, Name); 4] = [
    ("Zahn-Nr.", Name::Tooth),
    ("fp", Name::Single),
    ("Fp", Name::Cumulative),
    ("Fr", Name::Runout),
];

/// The rows of one flank.
#[derive(Debug)]
struct Block<'a> {
    side: Side,
    /// The line of its head.
    line: u64,
    columns: Vec<Name>,
    rows: Vec<(u64, u32, Vec<Written<'a>>)>,
}

/// Whether `text` has the head of a block.
pub fn is_one(text: &str) -> bool {
    text.lines().any(|line| side(line).is_some())
}

/// The flank a block's head names.
fn side(line: &str) -> Option<Side> {
    match line.trim().trim_end_matches(':').to_lowercase().as_str() {
        "linke zahnflanke" => Some(Side::Left),
        "rechte zahnflanke" => Some(Side::Right),
        _ => None,
    }
}

/// The wanted columns, by ascending tooth, and the header lines.
pub fn read<const N: usize>(
    file: &DataFile,
    text: &str,
    wanted: &Wanted<N>,
    problems: &mut Problems,
) -> Option<(Vec<Row<N>>, Header)> {
    let (blocks, header) = parse(file, text, problems)?;
    let mut columns = Vec::new();
    for column in wanted.columns {
        let rows: Option<Vec<Row<1>>> = match column {
            Column::Right(kind) => pitch(file, &blocks, Side::Right, kind, problems),
            Column::Left(kind) => pitch(file, &blocks, Side::Left, kind, problems),
            Column::Runout => runout(file, &blocks, problems),
            other => {
                problems.add(file.problem(
                    format!("is a pitch protocol, which has no {}", other.names()[0]),
                    "name a table that has it",
                ));
                None
            }
        };
        columns.push(rows.and_then(|rows| by_tooth::ordered(file, rows, wanted, problems)));
    }
    let columns: Vec<Vec<Row<1>>> = columns.into_iter().collect::<Option<_>>()?;
    let rows = columns.first()?.iter().enumerate().map(|(index, row)| {
        let mut values = [0.0; N];
        for (value, column) in values.iter_mut().zip(&columns) {
            *value = column
                .get(index)
                .filter(|other| other.tooth == row.tooth)?
                .values[0];
        }
        Some(Row {
            line: row.line,
            tooth: row.tooth,
            values,
        })
    });
    Some((rows.collect::<Option<_>>()?, header))
}

fn parse<'a>(
    file: &DataFile,
    text: &'a str,
    problems: &mut Problems,
) -> Option<(Vec<Block<'a>>, Header)> {
    let mut header = Header::default();
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    let mut after_blank = false;
    let mut good = Some(());
    for (index, text) in text.lines().enumerate() {
        let line = index as u64 + 1;
        let mut wrong = |reason: String, way_out: &str| {
            problems.add(file.problem_at(line, reason, way_out));
            good = None;
        };
        if let Some(side) = side(text) {
            if let Some(first) = blocks.iter().find(|block| block.side == side) {
                wrong(
                    format!(
                        "a second block of this flank, the first begins in line {}",
                        first.line
                    ),
                    "keep one of the two",
                );
            }
            blocks.push(Block {
                side,
                line,
                columns: Vec::new(),
                rows: Vec::new(),
            });
            open = true;
        } else if text.trim().is_empty() {
            after_blank = true;
            continue;
        } else if let Some(block) = blocks.last_mut().filter(|_| open) {
            if block.columns.is_empty() {
                match names(text) {
                    Ok(names) => block.columns = names,
                    Err(reason) => {
                        wrong(reason, "name the columns there: Zahn-Nr. fp Fp Fr");
                        open = false;
                    }
                }
            } else if after_blank
                && !block.rows.is_empty()
                && !text.trim().starts_with(|c: char| c.is_ascii_digit())
            {
                open = false;
            } else {
                match row(text, &block.columns) {
                    Ok((tooth, values)) => block.rows.push((line, tooth, values)),
                    Err(reason) => wrong(reason, "correct the line"),
                }
            }
        }
        if !open {
            header.take(file, line, text, problems);
        }
        after_blank = false;
    }
    good?;
    Some((blocks, header))
}

/// The columns of a block.
fn names(text: &str) -> Result<Vec<Name>, String> {
    let mut names = Vec::new();
    for word in text.split_whitespace() {
        match NAMES.iter().find(|(known, _)| *known == word) {
            Some((_, name)) if names.contains(name) => return Err(format!("column {word} twice")),
            Some((_, name)) => names.push(*name),
            None => return Err(format!("unknown column {word:?}")),
        }
    }
    if names.first() != Some(&Name::Tooth) {
        return Err("column Zahn-Nr. is missing".to_owned());
    }
    Ok(names)
}

/// The tooth and the values of a row, those in the order of the columns behind `Zahn-Nr.`.
fn row<'a>(text: &'a str, columns: &[Name]) -> Result<(u32, Vec<Written<'a>>), String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let (Some(first), true) = (words.first(), words.len() == columns.len()) else {
        return Err(format!(
            "{} values, the block has {} columns",
            words.len(),
            columns.len()
        ));
    };
    let tooth = number::tooth(first).filter(|&tooth| (1..=10_000).contains(&tooth));
    let tooth = tooth
        .ok_or_else(|| format!("Zahn-Nr. is {first:?}, allowed is a whole number from 1 on"))?;
    let mut values = Vec::new();
    for word in words.iter().skip(1) {
        let written =
            number::written(word).filter(|written| written.decimal != Some(Decimal::Comma));
        let written = written.filter(|written| written.value.abs() <= 1e7);
        let written = written.ok_or_else(|| {
            format!("{word:?}, allowed is a number of µm with a decimal point, −1e7 … 1e7")
        })?;
        if NOT_MEASURED.contains(&written.value) {
            return Err(format!("{word} stands for a value that was not measured"));
        }
        values.push(written);
    }
    Ok((tooth, values))
}

impl<'a> Block<'a> {
    /// The values of a column, with their lines and teeth; `None` when the block does not have it.
    fn column(&self, name: Name) -> Option<Vec<(u64, u32, Written<'a>)>> {
        let place = self.columns.iter().position(|column| *column == name)?;
        let values = self.rows.iter();
        let value = |(line, tooth, values): &(u64, u32, Vec<Written<'a>>)| {
            Some((*line, *tooth, *values.get(place.checked_sub(1)?)?))
        };
        values.map(value).collect()
    }
}

fn pitch(
    file: &DataFile,
    blocks: &[Block],
    side: Side,
    kind: Kind,
    problems: &mut Problems,
) -> Option<Vec<Row<1>>> {
    let Some(block) = blocks.iter().find(|block| block.side == side) else {
        let head = if side == Side::Left {
            "linke"
        } else {
            "rechte"
        };
        problems.add(file.problem(
            format!("has no block {head} Zahnflanke"),
            "give a protocol of both flanks",
        ));
        return None;
    };
    let name = match kind {
        Kind::Single => Name::Single,
        Kind::Cumulative => Name::Cumulative,
    };
    let Some(values) = block.column(name) else {
        problems.add(file.problem_at(
            block.line,
            format!(
                "the block has no column {}",
                if kind == Kind::Single { "fp" } else { "Fp" }
            ),
            "give the other kind, or a protocol that has it",
        ));
        return None;
    };
    check_story(file, block, problems)?;
    Some(
        values
            .iter()
            .map(|&(line, tooth, value)| Row {
                line,
                tooth,
                values: [value.value],
            })
            .collect(),
    )
}

/// `f_i = F_i − F_{i−1}`, within half a unit of the last printed digit of each of the three.
fn check_story(file: &DataFile, block: &Block, problems: &mut Problems) -> Option<()> {
    let (Some(mut single), Some(mut cumulative)) =
        (block.column(Name::Single), block.column(Name::Cumulative))
    else {
        return Some(());
    };
    // Rows twice or missing are told elsewhere.
    single.sort_by_key(|value| value.1);
    cumulative.sort_by_key(|value| value.1);
    let Some(mut before) = cumulative.last().copied() else {
        return Some(());
    };
    let count = cumulative.len() as u32;
    let mut good = Some(());
    for ((line, tooth, f), now) in single.into_iter().zip(cumulative) {
        let difference = now.2.value - before.2.value;
        let rounding = f.rounding + now.2.rounding + before.2.rounding;
        let consecutive = now.1 == before.1 + 1 || now.1 == 1 && before.1 == count;
        // Rounding of the subtraction itself: some ulps of the values.
        let slack = 1e-12 * (now.2.value.abs() + before.2.value.abs());
        if consecutive && (f.value - difference).abs() > rounding + slack {
            problems.add(file.problem_at(
                line,
                format!(
                    "fp of tooth {tooth} is {}, its Fp less that of tooth {} is {difference:.4}: the two columns differ by more than their rounding",
                    f.text, before.1
                ),
                "find the wrong one, or remove the other column from a copy of the protocol",
            ));
            good = None;
        }
        before = now;
    }
    good
}

/// `Fr` of the blocks that have it; both must say the same.
fn runout(file: &DataFile, blocks: &[Block], problems: &mut Problems) -> Option<Vec<Row<1>>> {
    let columns: Vec<_> = blocks
        .iter()
        .filter_map(|block| block.column(Name::Runout))
        .collect();
    let Some(first) = columns.first() else {
        problems.add(file.problem("has no column Fr", "give a protocol that has it"));
        return None;
    };
    let mut good = Some(());
    for (line, tooth, value) in columns.iter().skip(1).flatten() {
        let other = first.iter().find(|(_, same, _)| same == tooth);
        let other = other.filter(|(_, _, other)| other.value == value.value);
        if other.is_none() {
            problems.add(file.problem_at(
                *line,
                format!(
                    "Fr of tooth {tooth} is {} here and not in the block of the other flank",
                    value.text
                ),
                "find the right one, and remove column Fr from the other block of a copy",
            ));
            good = None;
        }
    }
    good?;
    Some(
        first
            .iter()
            .map(|&(line, tooth, value)| Row {
                line,
                tooth,
                values: [value.value],
            })
            .collect(),
    )
}
