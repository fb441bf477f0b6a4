//! Where the columns of a table stand, by its header.

use super::cell::{Cell, Line};
use super::column::{self, Named};
use super::wanted::Wanted;
use crate::data_file::DataFile;
use crate::problems::Problems;

/// Where the columns stand.
pub struct Places<const N: usize> {
    /// That of the tooth number.
    pub tooth: usize,
    /// Those of the wanted columns, in their order.
    pub wanted: [usize; N],
}

/// The places of the tooth and the wanted columns that `header` names; every name it does not understand is a problem.
pub fn places<const N: usize>(
    header: &Line,
    file: &DataFile,
    wanted: &Wanted<N>,
    problems: &mut Problems,
) -> Option<Places<N>> {
    let help = format!(
        "name the columns {} there",
        column::headings(&wanted.columns)
    );
    let line = header.number;
    let mut tooth = None;
    let mut places = [None; N];
    let mut good = Some(());
    let mut wrong = |reason: String, help: String| {
        problems.add(file.problem_at(line, reason, help));
        good = None;
    };
    for (place, cell) in header.cells.iter().enumerate() {
        if *cell == Cell::Empty {
            continue;
        }
        let Cell::Text(text) = cell else {
            wrong(
                format!("{} is not a column name", cell.shown(file)),
                help.clone(),
            );
            continue;
        };
        let slot = match column::named(file, text, &wanted.columns) {
            Named::Tooth => &mut tooth,
            Named::Wanted(index) => &mut places[index],
            Named::Wrong(reason, help) => {
                wrong(reason, help);
                continue;
            }
        };
        if slot.is_some() {
            wrong(
                format!("duplicate column {}", file.quote(text)),
                "remove one".to_owned(),
            );
        }
        *slot = Some(place);
    }
    // A name that is not understood may be the one that is missing.
    good?;
    let names = wanted.columns.map(|column| column.names()[0]);
    for (name, place) in [("tooth", tooth)]
        .into_iter()
        .chain(names.into_iter().zip(places))
    {
        if place.is_none() {
            problems.add(file.problem_at(line, format!("column {name} is missing"), help.clone()));
        }
    }
    let mut found = [0; N];
    for (found, place) in found.iter_mut().zip(places) {
        *found = place?;
    }
    Some(Places {
        tooth: tooth?,
        wanted: found,
    })
}
