//! Which columns of a header are the tooth's and those that are wanted: one each, or an error that lists them.

use super::choice::{Choice, TOOTH};
use super::column::Column;
use super::grid::Grid;
use super::head::{Head, letter};
use super::heading::Quantity;
use super::wanted::Wanted;
use crate::data_file::DataFile;
use crate::error::Problem;
use crate::node::Node;
use crate::problems::Problems;
use gearlash::metrology::PitchKind;

/// Where the columns stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places<const N: usize> {
    /// That of the tooth number.
    pub tooth: usize,
    /// Those of the wanted columns, in their order.
    pub wanted: [usize; N],
}

/// The places of the tooth and the wanted columns that `head` names, or `choice`.
pub fn places<const N: usize>(
    head: &Head,
    grid: &Grid,
    file: &DataFile,
    wanted: &Wanted<N>,
    choice: &Choice,
    problems: &mut Problems,
) -> Option<Places<N>> {
    let tooth = tooth(head, grid, file, wanted, choice);
    let tooth = problems.keep(tooth);
    let found = wanted.columns.map(|column| {
        let places = head.places_of(column, choice);
        problems.keep(one(head, file, column, &places, choice))
    });
    let mut wanted = [0; N];
    for (place, found) in wanted.iter_mut().zip(found) {
        *place = found?;
    }
    let tooth = tooth?;
    Some(Places { tooth, wanted })
}

/// The column of teeth; of several the first where all say the same.
fn tooth<const N: usize>(
    head: &Head,
    grid: &Grid,
    file: &DataFile,
    wanted: &Wanted<N>,
    choice: &Choice,
) -> Result<usize, Problem> {
    let places = head.teeth(&wanted.columns, choice);
    let Some(&first) = places.first() else {
        let key = choice.column(TOOTH).map(|name| (TOOTH, name));
        return Err(missing(head, file, "tooth", TOOTH, key));
    };
    let rows = &grid.lines[head.at + 1..];
    let alike = |place: &usize| rows.iter().all(|row| row.cell(*place) == row.cell(first));
    match places.iter().all(alike) {
        true => unit(head, file, first, None).map(|()| first),
        false => Err(several(head, file, "tooth", TOOTH, &places)),
    }
}

/// The one of `places` that is `column`.
pub fn one(
    head: &Head,
    file: &DataFile,
    column: Column,
    places: &[usize],
    choice: &Choice,
) -> Result<usize, Problem> {
    let named = choice.column(column.key());
    let place = match *places {
        [place] => place,
        [] => {
            return Err(other_kind(head, file, column, choice).unwrap_or_else(|| {
                let key = named.map(|name| (column.key(), name));
                missing(head, file, column.name(), column.key(), key)
            }));
        }
        _ => return Err(several(head, file, column.name(), column.key(), places)),
    };
    let said = head.headings[place].meaning.map(|meaning| meaning.quantity);
    if let (Some(Quantity::Pitch(Some(said))), Some(kind)) = (said, column.kind())
        && said != kind
    {
        return Err(contradicts(head, file, place, kind));
    }
    unit(head, file, place, Some(column)).map(|()| place)
}

/// The problem of a table that has the flank's pitch, but the other kind of it.
fn other_kind(head: &Head, file: &DataFile, column: Column, choice: &Choice) -> Option<Problem> {
    let kind = column.kind();
    let kind = kind.filter(|_| choice.column(column.key()).is_none())?;
    let other = column.of_other_kind();
    let place = *head.places_of(other, choice).first()?;
    Some(contradicts(head, file, place, kind))
}

/// The problem of a column of the other kind than `kind`.
fn contradicts(head: &Head, file: &DataFile, place: usize, kind: PitchKind) -> Problem {
    let (stated, said, key) = match kind {
        PitchKind::Single => ("single", "cumulative pitch deviations, Fp", "cumulative"),
        PitchKind::Cumulative => ("cumulative", "single pitch deviations, fp", "single"),
    };
    file.problem_at(
        head.line,
        format!("column {} is of {said}; the pair file has kind = \"{stated}\"", head.shown(file, &[place])),
        format!("write kind = \"{key}\", or name the column of the other kind: left = \"…\", right = \"…\""),
    )
}

fn missing(
    head: &Head,
    file: &DataFile,
    name: &str,
    key: &str,
    named: Option<(&str, &str)>,
) -> Problem {
    let reason = match named {
        Some((key, column)) => format!(
            "there is no column {key} = {}",
            Node::Text(column.to_owned()).shown()
        ),
        None => format!("column {name} is missing"),
    };
    let all = head.all();
    let three = |place: &usize| {
        let meaning = head.headings[*place].meaning;
        meaning.is_some_and(|meaning| meaning.quantity == Quantity::OverThreePins)
    };
    let help = match (name, all.iter().any(three)) {
        ("over pins", true) => {
            "give the dimensions over two pins (gearlash gauge writes them beside those over three), or the span".to_owned()
        }
        _ if key.is_empty() => "name it there".to_owned(),
        _ => format!("name it there, or say which it is, by heading or letter: {key} = \"…\""),
    };
    let columns = head.shown(file, &all);
    file.problem_at(
        head.line,
        format!("{reason}; the columns are {columns}"),
        help,
    )
}

/// The problem of more columns than one that may be it.
pub fn several(head: &Head, file: &DataFile, name: &str, key: &str, places: &[usize]) -> Problem {
    let letters: Vec<String> = places
        .iter()
        .map(|place| format!("{key} = \"{}\"", letter(*place)))
        .collect();
    file.problem_at(
        head.line,
        format!(
            "{} columns may be {name}: {}",
            places.len(),
            head.shown(file, places)
        ),
        format!("say which, by letter or heading: {}", letters.join(" or ")),
    )
}

/// Checks that the unit at `place`, where one is said, is that of `column`; a tooth has none.
fn unit(head: &Head, file: &DataFile, place: usize, column: Option<Column>) -> Result<(), Problem> {
    let needed = column.map(Column::unit);
    let Some(unit) = head.headings[place]
        .unit
        .filter(|unit| Some(*unit) != needed)
    else {
        return Ok(());
    };
    let shown = head.shown(file, &[place]);
    Err(match needed {
        Some(needed) => file.problem_at(
            head.line,
            format!("column {shown} is in {unit}, allowed is {needed}"),
            format!("convert its values to {needed} and write that unit in its heading"),
        ),
        None => file.problem_at(
            head.line,
            format!("column {shown} has a unit, a tooth number has none"),
            "remove the unit from its heading",
        ),
    })
}
