//! One block of a protocol: its head, its columns, its rows.

use super::number::{self, Decimal, Unmeasured, Written};
use crate::data_file::DataFile;
use crate::numbers::ascii;
use crate::problems::Problems;
use gearlash::gear::Side;

/// A column of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Name {
    /// `Zahn-Nr.`
    Tooth,
    /// `fp`: single pitch deviation.
    Single,
    /// `Fp`: cumulative pitch deviation.
    Cumulative,
    /// `Fr`: runout reading.
    Runout,
    /// `fu`: difference of neighbouring single pitches, which the others contain.
    Jump,
}

const NAMES: [(&str, Name); 5] = [
    ("Zahn-Nr.", Name::Tooth),
    ("fp", Name::Single),
    ("Fp", Name::Cumulative),
    ("Fr", Name::Runout),
    ("fu", Name::Jump),
];

/// The rows of one flank.
#[derive(Debug)]
pub struct Block<'a> {
    /// Which.
    pub side: Side,
    /// The line of its head.
    pub line: u64,
    /// Its columns, `Zahn-Nr.` first; none before their line is read.
    pub columns: Vec<Name>,
    /// Line, tooth, and the values of the other columns.
    pub rows: Vec<(u64, u32, Vec<Written<'a>>)>,
}

/// The flank a block's head names.
pub fn side(line: &str) -> Option<Side> {
    match line.trim().trim_end_matches(':').to_lowercase().as_str() {
        "linke zahnflanke" => Some(Side::Left),
        "rechte zahnflanke" => Some(Side::Right),
        _ => None,
    }
}

/// The column that `word` names, perhaps with its unit.
pub fn named(word: &str) -> Option<Name> {
    let word = word.strip_suffix("[µm]").unwrap_or(word);
    let mut names = NAMES.iter();
    names
        .find(|(known, _)| *known == word)
        .map(|(_, name)| *name)
}

/// The columns of a block.
pub fn names(file: &DataFile, text: &str) -> Result<Vec<Name>, String> {
    let mut names = Vec::new();
    for word in text.split_whitespace() {
        match named(word) {
            Some(name) if names.contains(&name) => {
                return Err(format!("duplicate column {}", file.quote(word)));
            }
            Some(name) => names.push(name),
            None => return Err(format!("unknown column {}", file.quote(word))),
        }
    }
    if names.first() != Some(&Name::Tooth) {
        return Err("column Zahn-Nr. is missing".to_owned());
    }
    Ok(names)
}

/// The tooth and the values of a row, those in the order of the columns behind `Zahn-Nr.`.
pub fn row<'a>(
    file: &DataFile,
    text: &'a str,
    columns: &[Name],
    unmeasured: Unmeasured,
    number: impl Fn(&'a str) -> Option<Written<'a>>,
) -> Result<(u32, Vec<Written<'a>>), String> {
    let found = text.split_whitespace().count();
    let mut words = text.split_whitespace();
    let (Some(first), true) = (words.next(), found == columns.len()) else {
        return Err(format!(
            "{found} values, the block has {} columns",
            columns.len()
        ));
    };
    let tooth = number::tooth(first).filter(|&tooth| (1..=10_000).contains(&tooth));
    let tooth = tooth.ok_or_else(|| {
        format!(
            "Zahn-Nr. is {}, allowed is a whole number from 1 on",
            file.quote(first)
        )
    })?;
    let mut values = Vec::new();
    for word in words {
        let written = number(word).filter(|written| written.decimal != Some(Decimal::Comma));
        let written =
            written.filter(|written| written.value.abs() <= 1e7 && !number::zero_first(word));
        let written = written.ok_or_else(|| {
            format!(
                "{}, allowed is a number of µm with a decimal point, −1e7 … 1e7",
                file.quote(word)
            )
        })?;
        if unmeasured.is(&written) {
            return Err(format!(
                "{} {}",
                file.bare(word),
                unmeasured.words(&written)
            ));
        }
        values.push(written);
    }
    Ok((tooth, values))
}

impl<'a> Block<'a> {
    /// The values of a column, with their lines and teeth; `None` when the block does not have it.
    pub fn column(&self, name: Name) -> Option<Vec<(u64, u32, Written<'a>)>> {
        let place = self.columns.iter().position(|column| *column == name)?;
        let values = self.rows.iter();
        let value = |(line, tooth, values): &(u64, u32, Vec<Written<'a>>)| {
            Some((*line, *tooth, *values.get(place.checked_sub(1)?)?))
        };
        values.map(value).collect()
    }
}

/// Checks that single and cumulative pitch tell the same story: `f_i = F_i − F_{i−1}`, within half a unit of the last printed digit of each of the three, of a block that has
/// every tooth once.
pub fn check_story(file: &DataFile, block: &Block, problems: &mut Problems) {
    let (Some(mut single), Some(mut cumulative)) =
        (block.column(Name::Single), block.column(Name::Cumulative))
    else {
        return;
    };
    single.sort_by_key(|value| value.1);
    cumulative.sort_by_key(|value| value.1);
    let Some(mut before) = cumulative.last().copied() else {
        return;
    };
    for ((line, tooth, f), now) in single.into_iter().zip(cumulative) {
        let difference = now.2.value - before.2.value;
        let rounding = f.rounding + now.2.rounding + before.2.rounding;
        // Rounding of the subtraction itself: some ulps of the values.
        let slack = 1e-12 * (now.2.value.abs() + before.2.value.abs());
        if (f.value - difference).abs() > rounding + slack {
            problems.add(file.problem_at(
                line,
                format!(
                    "fp of tooth {tooth} is {}, but its Fp minus that of tooth {} is {}: the two columns differ by more than their rounding",
                    file.bare(f.text),
                    before.1,
                    file.bare(&ascii(difference, 4)),
                ),
                "find the wrong one, or remove the other column from a copy of the protocol",
            ));
        }
        before = now;
    }
}
