//! Every reading tooth by tooth.

use super::super::GaugedGear;
use super::super::by_tooth::columns;
use crate::table::{finish, table};
use gearlash_files::numbers::ascii;

pub(super) fn table_of(gauged: &GaugedGear) -> String {
    let columns = columns(&gauged.gauged);
    let shown = || columns.iter().filter(|column| !column.values.is_empty());
    let headings: Vec<&str> = std::iter::once("tooth")
        .chain(shown().map(|column| column.heading))
        .collect();
    let mut table = table(&headings);
    for tooth in 1..=gauged.gear.gear().basic_data().teeth() {
        let cells = shown().map(|column| {
            let value = column.values.get(tooth as usize - 1);
            ascii(value.copied(), column.decimals)
        });
        table.add_row(std::iter::once(tooth.to_string()).chain(cells));
    }
    format!(
        "\nBy tooth, in µm where not mm. Span: first tooth spanned; pins and ball: tooth before the space of the (first) pin.\n\
         f: single pitch, F: cumulative; ball and s less their means.\n{}",
        finish(&table)
    )
}
