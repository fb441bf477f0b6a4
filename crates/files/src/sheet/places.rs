//! Which columns of a header are the tooth's and those that are wanted: one each, or an error that lists them.

use super::cell::Line;
use super::choice::{Choice, TOOTH};
use super::column::Column;
use super::head::{Head, Heading, letter};
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

/// The places of the tooth and the wanted columns that `head`, one of `lines`, names, or `choice`.
pub fn places<const N: usize>(
    head: &Head,
    lines: &[Line],
    file: &DataFile,
    wanted: &Wanted<N>,
    choice: &Choice,
    problems: &mut Problems,
) -> Option<Places<N>> {
    let tooth = tooth(head, lines, file, wanted, choice);
    let tooth = problems.keep(tooth);
    let columns = &wanted.columns;
    let missing = columns.map(|column| is_missing(head, column, choice));
    if let (true, Some(again)) = (missing.contains(&true), again(head, lines)) {
        problems.add(file.problem_at(
            again,
            format!(
                "names columns again, as line {} does: a table in two blocks, one below the other, is not read",
                head.line
            ),
            "put the blocks side by side: a row a tooth, with a column for each flank",
        ));
        return None;
    }
    if N > 1 && missing == [true; N] {
        problems.add(all_missing(head, file, columns));
        return None;
    }
    let found = columns.map(|column| {
        let places = in_unit(
            head,
            column,
            once(head, lines, head.places_of(column, choice)),
        );
        problems.keep(one(head, file, column, &places, choice))
    });
    let mut wanted = [0; N];
    for (place, found) in wanted.iter_mut().zip(found) {
        *place = found?;
    }
    let tooth = tooth?;
    problems.keep(alike(head, file, columns, &wanted, choice))?;
    problems.keep(apart(head, file, tooth, columns, &wanted))?;
    Some(Places { tooth, wanted })
}

/// Checks that no column is read as two things.
fn apart(
    head: &Head,
    file: &DataFile,
    tooth: usize,
    columns: &[Column],
    places: &[usize],
) -> Result<(), Problem> {
    let mut read = vec![("tooth", TOOTH, tooth)];
    for (column, place) in columns.iter().zip(places) {
        let (name, key) = (column.name(), column.key());
        if let Some((other, other_key, _)) = read.iter().find(|(.., taken)| taken == place) {
            return Err(file.problem_at(
                head.line,
                format!(
                    "column {} is read as {other} and as {name}",
                    head.shown(file, &[*place])
                ),
                format!("name two columns: {other_key} = \"…\", {key} = \"…\""),
            ));
        }
        read.push((name, key, *place));
    }
    Ok(())
}

/// Checks that of the columns of pitch all say their kind or none does: one that does not, beside one that does, may be of the other
/// kind, unless the pair file names it.
fn alike(
    head: &Head,
    file: &DataFile,
    columns: &[Column],
    places: &[usize],
    choice: &Choice,
) -> Result<(), Problem> {
    let says = |place: &usize| {
        let meaning = head.headings[*place].meaning;
        meaning.is_some_and(|meaning| matches!(meaning.quantity, Quantity::Pitch(Some(_))))
    };
    let open = |(column, place): &(&Column, &usize)| {
        column.kind().is_some() && choice.column(column.key()).is_none() && !says(place)
    };
    let unsaid = columns.iter().zip(places).find(open);
    match unsaid.filter(|_| places.iter().any(says)) {
        None => Ok(()),
        Some((column, place)) => Err(file.problem_at(
            head.line,
            format!(
                "column {} does not say whether it is fp or Fp, the other flank's does",
                head.shown(file, &[*place])
            ),
            format!(
                "say so in its heading, or name it: {} = \"{}\"",
                column.key(),
                letter(*place)
            ),
        )),
    }
}

/// The column of teeth.
fn tooth<const N: usize>(
    head: &Head,
    lines: &[Line],
    file: &DataFile,
    wanted: &Wanted<N>,
    choice: &Choice,
) -> Result<usize, Problem> {
    let places = head.teeth(&wanted.columns, choice);
    let Some(&first) = places.first() else {
        let key = choice.column(TOOTH).map(|name| (TOOTH, name));
        return Err(missing(head, file, "tooth", TOOTH, key));
    };
    match once(head, lines, places)[..] {
        [_] => unit(head, file, first, None).map(|()| first),
        ref places => Err(several(head, file, "tooth", TOOTH, places)),
    }
}

/// The first of `places` where all of them hold the same, else all.
pub fn once(head: &Head, lines: &[Line], places: Vec<usize>) -> Vec<usize> {
    let rows = &lines[head.at + 1..];
    let alike = |place: &usize| {
        rows.iter()
            .all(|row| row.cell(*place) == row.cell(places[0]))
    };
    match places.iter().all(alike) {
        true => places.into_iter().take(1).collect(),
        false => places,
    }
}

/// The one of `places` whose heading has the unit of `column`, where all others have another one.
fn in_unit(head: &Head, column: Column, places: Vec<usize>) -> Vec<usize> {
    let unit = |place: &usize| head.headings[*place].unit;
    let good = |place: &&usize| unit(place) == Some(column.unit());
    let say = places.iter().all(|place| unit(place).is_some());
    match places.iter().filter(good).collect::<Vec<_>>()[..] {
        [only] if say => vec![*only],
        _ => places,
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
    let meaning = head.headings[place].meaning;
    let said = meaning.map(|meaning| meaning.quantity);
    if meaning.is_some_and(|meaning| !column.may_be_named(meaning)) {
        return Err(file.problem_at(
            head.line,
            format!(
                "the heading of column {} says something else than {}",
                head.shown(file, &[place]),
                column.name()
            ),
            match column.kind() {
                Some(_) => "name the column of that flank; where the gear was seen from its other face, say so with reference_face",
                None => "name the column that holds it, or correct the heading",
            },
        ));
    }
    if let (Some(Quantity::Pitch(Some(said))), Some(kind)) = (said, column.kind())
        && said != kind
    {
        return Err(contradicts(head, file, place, kind));
    }
    unit(head, file, place, Some(column)).map(|()| place)
}

/// The line below `head` that has the same headings, or more than one that is known.
fn again(head: &Head, lines: &[Line]) -> Option<u64> {
    let known = |heading: &&Heading| heading.meaning.is_some();
    let is_again = |at: &usize| {
        let below = Head::of(lines, *at);
        !lines[*at].is_comment() && below.headings.iter().filter(known).count() > 1
    };
    let mut below = head.at + 2..lines.len();
    below.find(is_again).map(|at| lines[at].number)
}

/// Whether `head` has no column that may be `column`, nor one of the other kind, and none is named.
fn is_missing(head: &Head, column: Column, choice: &Choice) -> bool {
    let none = |column| head.places_of(column, choice).is_empty();
    choice.column(column.key()).is_none() && none(column) && none(column.of_other_kind())
}

/// The problem of a table that has none of the `columns`.
fn all_missing(head: &Head, file: &DataFile, columns: &[Column]) -> Problem {
    let names: Vec<&str> = columns.iter().map(|column| column.name()).collect();
    let keys: Vec<String> = columns
        .iter()
        .map(|column| format!("{} = \"…\"", column.key()))
        .collect();
    file.problem_at(
        head.line,
        format!(
            "columns {} are missing; the columns are {}",
            names.join(" and "),
            head.shown(file, &head.all())
        ),
        format!(
            "name them there, or say which they are, by heading or letter: {}",
            keys.join(", ")
        ),
    )
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
        format!("column {} is of {said}, asked for is kind = \"{stated}\"", head.shown(file, &[place])),
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
    let over_three = |place: &usize| {
        let meaning = head.headings[*place].meaning;
        meaning.is_some_and(|meaning| meaning.quantity == Quantity::OverThreePins)
    };
    if let Some(place) = all.iter().copied().find(over_three)
        && name == Column::OverPins.name()
    {
        return file.problem_at(
            head.line,
            format!(
                "column {} is a dimension over three pins, allowed is one over two",
                head.shown(file, &[place])
            ),
            "give the dimensions over two pins (gearlash gauge writes them beside those over three), or the span",
        );
    }
    let help = match key {
        "" => "name it there".to_owned(),
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
