//! Every reading tooth by tooth.

use crate::text::{finish, table};
use gearlash_files::numbers::ascii;
use gearlash_files::results::gauge::{GaugedGear, by_tooth};

pub(super) fn table_of(gauged: &GaugedGear) -> String {
    let columns = by_tooth(&gauged.gauged);
    let shown = || {
        columns
            .iter()
            .filter(|(_, column)| !column.cells.is_empty())
    };
    let headings: Vec<&str> = std::iter::once("tooth")
        .chain(shown().map(|(heading, _)| *heading))
        .collect();
    let mut table = table(&headings);
    for tooth in 1..=gauged.gear.gear().basic_data().teeth() {
        let cells = shown().map(|(_, column)| {
            let value = column.cell(tooth as usize - 1).number();
            ascii(value, column.unit.decimals())
        });
        table.add_row(std::iter::once(tooth.to_string()).chain(cells));
    }
    format!(
        "\nBy tooth, in µm where not mm. Span: first tooth spanned; pins and ball: tooth before the space of the (first) pin.\n\
         f: single pitch, F: cumulative; ball and s less their means.\n{}",
        finish(&table)
    )
}
