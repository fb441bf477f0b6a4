//! Rows in the order of the teeth, each tooth there as often as it must be.

use super::wanted::{Coverage, Row, Wanted};
use crate::data_file::DataFile;
use crate::problems::Problems;

/// How many missing teeth are named one by one. Tuned: a line of a message holds them.
const NAMED: usize = 10;

/// `rows` by ascending tooth; a tooth that the gear does not have, given twice or missing is a problem.
pub fn ordered<const N: usize, const M: usize>(
    file: &DataFile,
    mut rows: Vec<Row<N>>,
    wanted: &Wanted<M>,
    problems: &mut Problems,
) -> Option<Vec<Row<N>>> {
    let Some(last) = rows.iter().map(|row| row.line).max() else {
        problems.add(file.problem("no rows below the header", "add a row for each tooth"));
        return None;
    };
    // Stable: the first of two rows stays the first.
    rows.sort_by_key(|row| row.tooth);
    let mut good = Some(());
    let teeth = wanted.teeth.unwrap_or(u32::MAX);
    for row in rows.iter().filter(|row| row.tooth > teeth) {
        problems.add(file.problem_at(
            row.line,
            format!(
                "tooth {}, allowed is 1 … {teeth}",
                file.bare(&row.tooth.to_string())
            ),
            "remove the line, or correct its number or teeth",
        ));
        good = None;
    }
    let twice = rows
        .windows(2)
        .filter(|pair| pair[0].tooth == pair[1].tooth);
    for pair in twice {
        problems.add(file.problem_at(
            pair[1].line,
            format!(
                "duplicate tooth {}, already given in line {}",
                pair[1].tooth, pair[0].line
            ),
            "remove one of the two, or correct its number",
        ));
        good = None;
    }
    if let (Coverage::EveryTooth, Some(teeth)) = (wanted.coverage, wanted.teeth) {
        let mut there = vec![false; teeth as usize];
        for row in &rows {
            if let Some(there) = there.get_mut(row.tooth as usize - 1) {
                *there = true;
            }
        }
        let missing: Vec<usize> = (1..=there.len())
            .filter(|tooth| !there[tooth - 1])
            .collect();
        if !missing.is_empty() {
            problems.add(file.problem_at(
                last,
                format!("the table ends here without {}", teeth_named(&missing)),
                format!("give all {teeth} teeth, each once"),
            ));
            good = None;
        }
    }
    good.map(|()| rows)
}

/// "tooth 3", "teeth 3, 5", "teeth 3, 5, … (20 in all)".
fn teeth_named(teeth: &[usize]) -> String {
    let named: Vec<String> = teeth.iter().take(NAMED).map(usize::to_string).collect();
    let named = named.join(", ");
    match teeth.len() {
        1 => format!("tooth {named}"),
        count if count <= NAMED => format!("teeth {named}"),
        count => format!("teeth {named}, … ({count} in all)"),
    }
}
