//! Lengths with their least, mean and greatest reading.

use crate::table::{finish, table};
use gearlash::gauge::{Gauged, OverPins};
use gearlash_files::numbers::{ascii, order_um, um_ascii};

/// One length, mm: `[least, greatest]`, mean, bound on the error of a reading, what a formula says.
struct Row {
    name: String,
    ends: [f64; 2],
    mean: f64,
    error: f64,
    formula: Option<f64>,
}

pub(super) fn table_of(read: &Gauged) -> String {
    let mut table = table(&[
        "", "least", "mean", "greatest", "range", "formula", "off", "bound",
    ]);
    for row in rows(read) {
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

fn rows(read: &Gauged) -> Vec<Row> {
    let formula = &read.formula;
    let mut rows = Vec::new();
    if let Ok(spans) = &read.spans {
        rows.push(Row {
            name: format!("span W_{}", spans.teeth),
            ends: spans.ends(),
            mean: spans.mean(),
            error: spans.error(),
            formula: formula.span,
        });
    }
    if let Ok(pins) = &read.pins {
        for (count, list, formula) in [
            ("two", &pins.two, formula.over_two),
            ("three", &pins.three, formula.over_three),
        ] {
            if !list.is_empty() {
                rows.push(Row {
                    name: format!("M_dK, {count} pins {} mm", pins.diameter),
                    ends: OverPins::ends(list),
                    mean: OverPins::mean(list),
                    error: OverPins::error(list),
                    formula,
                });
            }
        }
    }
    if let Ok(thickness) = &read.thickness {
        rows.push(Row {
            name: "thickness s".to_owned(),
            ends: thickness.ends(),
            mean: thickness.mean(),
            error: thickness.error,
            formula: Some(formula.thickness),
        });
    }
    if let Ok(runout) = &read.runout {
        rows.push(Row {
            name: format!("ball {} mm", runout.diameter),
            ends: runout.ends(),
            mean: runout.mean(),
            error: runout.reading_error(),
            formula: formula.ball_centre,
        });
    }
    if let Ok(root) = &read.root {
        rows.push(Row {
            name: "root diameter".to_owned(),
            ends: [2.0 * root.radius; 2],
            mean: 2.0 * root.radius,
            error: 2.0 * root.error,
            formula: Some(2.0 * formula.root),
        });
    }
    if let Ok(roll) = &read.roll {
        rows.push(Row {
            name: format!("a'', master z {}", roll.master.basic_data().teeth()),
            ends: roll.ends(),
            mean: roll.mean(),
            error: roll.reading_error(),
            formula: formula.distance,
        });
    }
    rows
}
