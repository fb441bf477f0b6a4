//! The text protocol of a gear measuring machine, in the layout of Klingelnberg's.
//!
//! After numbered header lines, and among other data, stand two blocks: a line
//! `linke Zahnflanke` or `rechte Zahnflanke`, a line `Zahn-Nr. fp Fp Fr`, and a
//! row a tooth, in µm. Only these and the known header lines are read. Within
//! a block everything must be a row until a blank line and other text.

use super::block::{Block, Name, check_story, named, names, row, side};
use super::by_tooth;
use super::column::Column;
use super::header::Header;
use super::limits::MOST_ROWS;
use super::number::Unmeasured;
use super::number::{self, Written};
use super::wanted::{Row, Wanted};
use crate::data_file::DataFile;
use crate::problems::Problems;
use gearlash::gear::Side;
use gearlash::metrology::PitchKind;
use std::collections::HashMap;

/// Whether `text` has the head of a block.
pub fn is_one(text: &str) -> bool {
    text.lines().any(|line| side(line).is_some())
}

/// Whether a line of `text` below the head of a block names `column`.
pub fn has(text: &str, column: Column) -> bool {
    let name = match column {
        Column::Right(kind) | Column::Left(kind) => name_of(kind),
        Column::Runout => Name::Runout,
        _ => return false,
    };
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    while lines.any(|line| side(line).is_some()) {
        let symbols = lines.next().unwrap_or_default().split_whitespace();
        if symbols.into_iter().any(|word| named(word) == Some(name)) {
            return true;
        }
    }
    false
}

/// The wanted columns, by ascending tooth, and the header lines.
pub fn read<const N: usize>(
    file: &DataFile,
    text: &str,
    wanted: &Wanted<N>,
    problems: &mut Problems,
) -> Option<(Vec<Row<N>>, Header)> {
    let (blocks, header) = parse(file, text, problems)?;
    let wanted = Wanted {
        teeth: wanted.teeth.or(header.teeth()),
        ..*wanted
    };
    Some((of_blocks(file, &blocks, &wanted, problems)?, header))
}

/// The wanted columns of `blocks`, by ascending tooth.
pub fn of_blocks<const N: usize>(
    file: &DataFile,
    blocks: &[Block],
    wanted: &Wanted<N>,
    problems: &mut Problems,
) -> Option<Vec<Row<N>>> {
    let mut columns = Vec::new();
    for column in wanted.columns {
        let rows: Option<Vec<Row<1>>> = match column {
            Column::Right(kind) => pitch(file, blocks, Side::Right, kind, problems),
            Column::Left(kind) => pitch(file, blocks, Side::Left, kind, problems),
            Column::Runout => runout(file, blocks, problems),
            other => {
                problems.add(file.problem(
                    format!("is a pitch protocol, which has no {}", other.name()),
                    "name a table that has it",
                ));
                None
            }
        };
        columns.push(rows.and_then(|rows| by_tooth::ordered(file, rows, wanted, problems)));
    }
    let columns: Vec<Vec<Row<1>>> = columns.into_iter().collect::<Option<_>>()?;
    // Now that every tooth is there once.
    if wanted
        .columns
        .iter()
        .any(|column| *column != Column::Runout)
    {
        for block in blocks {
            check_story(file, block, problems);
        }
    }
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
    rows.collect()
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
    let mut line_count = 0;
    let mut good = Some(());
    for (index, text) in text.lines().enumerate() {
        let line = index as u64 + 1;
        let mut wrong = |reason: String, help: &str| {
            problems.add(file.problem_at(line, reason, help));
            good = None;
        };
        if let Some(side) = side(text) {
            if let Some(first) = blocks.iter().find(|block| block.side == side) {
                wrong(
                    format!(
                        "duplicate block of this flank, the first begins in line {}",
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
                match names(file, text) {
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
                if line_count == MOST_ROWS {
                    wrong(
                        format!("more rows than the {MOST_ROWS} of both flanks of 10 000 teeth"),
                        "give a protocol of one gear",
                    );
                    break;
                }
                line_count += 1;
                match row(
                    file,
                    text,
                    &block.columns,
                    Unmeasured::default(),
                    number::written,
                ) {
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

fn name_of(kind: PitchKind) -> Name {
    match kind {
        PitchKind::Single => Name::Single,
        PitchKind::Cumulative => Name::Cumulative,
    }
}

fn pitch(
    file: &DataFile,
    blocks: &[Block],
    side: Side,
    kind: PitchKind,
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
    let Some(values) = block.column(name_of(kind)) else {
        problems.add(file.problem_at(
            block.line,
            format!(
                "the block has no column {}",
                if kind == PitchKind::Single {
                    "fp"
                } else {
                    "Fp"
                }
            ),
            "give the other kind, or a protocol that has it",
        ));
        return None;
    };
    Some(rows_of(&values))
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
    // The first of two rows of one tooth: that there are two is reported elsewhere.
    let by_tooth: HashMap<u32, f64> = first
        .iter()
        .rev()
        .map(|(_, tooth, value)| (*tooth, value.value))
        .collect();
    for (line, tooth, value) in columns.iter().skip(1).flatten() {
        if by_tooth.get(tooth) != Some(&value.value) {
            problems.add(file.problem_at(
                *line,
                format!(
                    "Fr of tooth {tooth} is {} here, but not in the block of the other flank",
                    file.bare(value.text)
                ),
                "find the right one, and remove column Fr from the other block of a copy",
            ));
            good = None;
        }
    }
    good?;
    Some(rows_of(first))
}

/// The values of a column as rows of their own.
fn rows_of(column: &[(u64, u32, Written)]) -> Vec<Row<1>> {
    let row = |&(line, tooth, value): &(u64, u32, Written)| Row {
        line,
        tooth,
        values: [value.value],
    };
    column.iter().map(row).collect()
}
