//! Accuracy grades, or why there are none.

use crate::text::{finish, table};
use gearlash::gauge::{Gauged, GradedReading};
use gearlash::gear::Grade;
use gearlash_files::numbers::um_ascii;

pub(super) fn table_of(read: &Gauged) -> String {
    let graded = match &read.grades {
        Ok(graded) if graded.is_empty() => return String::new(),
        Ok(graded) => graded,
        Err(reason) => return format!("\nno accuracy grades: {reason}\n"),
    };
    let mut table = table(&["", "measured", "grade", "tolerance"]);
    for one in graded {
        let (grade, tolerance) = match one.grade {
            Grade::Within { grade, tolerance } => (grade.to_string(), tolerance),
            Grade::Beyond { last, tolerance } => (format!("beyond {last}"), tolerance),
        };
        table.add_row(vec![
            words(one),
            um_ascii(one.measured, 3),
            grade,
            um_ascii(tolerance, 1),
        ]);
    }
    format!("\n{}", finish(&table))
}

fn words(one: &GradedReading) -> String {
    let symbol = one.quantity.symbol();
    match one.pitch {
        Some((axis, side)) => format!("{symbol} {}, {} flanks", axis.name(), side.name()),
        None => symbol.to_owned(),
    }
}
