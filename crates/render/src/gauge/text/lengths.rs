//! Lengths with their least, mean and greatest reading.

use crate::gauge::lengths::lengths;
use crate::text::{finish, table};
use gearlash::gauge::Gauged;
use gearlash_files::numbers::{ascii, order_um, um_ascii};

pub(super) fn table_of(read: &Gauged) -> String {
    let mut table = table(&[
        "", "least", "mean", "greatest", "range", "formula", "off", "bound",
    ]);
    for row in lengths(read) {
        let [least, most] = row.ends;
        table.add_row(vec![
            row.name,
            ascii(least, 6),
            ascii(row.mean, 6),
            ascii(most, 6),
            um_ascii(most - least, 3),
            ascii(row.formula, 6),
            um_ascii(row.formula.map(|formula| row.mean - formula), 3),
            order_um(row.error),
        ]);
    }
    finish(&table)
}
