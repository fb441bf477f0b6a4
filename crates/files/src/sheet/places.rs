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
    // The tooth, and behind it the wanted ones.
    let slot = |text: &str| match column::named(file, text, &wanted.columns) {
        Named::Tooth => Ok(0),
        Named::Wanted(index) => Ok(1 + index),
        Named::Wrong(reason, help) => Err((reason, help)),
    };
    let (found, good) = slots(header, file, &help, 1 + N, slot, problems);
    let (tooth, places) = (found[0], &found[1..]);
    // A name that is not understood may be the one that is missing.
    if !good {
        return None;
    }
    let names = wanted.columns.map(|column| column.names()[0]);
    for (name, place) in [("tooth", tooth)]
        .into_iter()
        .chain(names.into_iter().zip(places.iter().copied()))
    {
        if place.is_none() {
            problems.add(file.problem_at(line, format!("column {name} is missing"), help.clone()));
        }
    }
    let mut found = [0; N];
    for (found, place) in found.iter_mut().zip(places) {
        *found = (*place)?;
    }
    Some(Places {
        tooth: tooth?,
        wanted: found,
    })
}

/// A reason and the way out.
pub(super) type Wrong = (String, String);

/// Where each of `count` columns stands in a header, `slot` telling which of them a name is; and whether every cell is one of them, none twice.
/// What is not is added to `problems`.
pub(super) fn slots(
    header: &Line,
    file: &DataFile,
    help: &str,
    count: usize,
    slot: impl Fn(&str) -> Result<usize, Wrong>,
    problems: &mut Problems,
) -> (Vec<Option<usize>>, bool) {
    let mut places = vec![None; count];
    let mut good = true;
    let mut wrong = |(reason, help): Wrong| {
        problems.add(file.problem_at(header.number, reason, help));
        good = false;
    };
    for (place, cell) in header.cells.iter().enumerate() {
        let text = match cell {
            Cell::Empty => continue,
            Cell::Text(text) => text,
            cell => {
                let reason = format!("{} is not a column name", cell.shown(file));
                wrong((reason, help.to_owned()));
                continue;
            }
        };
        match slot(text) {
            Ok(slot) => {
                if places[slot].replace(place).is_some() {
                    let reason = format!("duplicate column {}", file.quote(text));
                    wrong((reason, "remove one".to_owned()));
                }
            }
            Err(found) => wrong(found),
        }
    }
    (places, good)
}
