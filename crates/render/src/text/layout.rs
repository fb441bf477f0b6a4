//! What all text for a terminal shares: aligned columns, and a pose in a word.

use comfy_table::{CellAlignment, Table, presets};
use gearlash::analysis::compare::ComparedPose;
use gearlash_files::numbers::rounded;

/// A table under `headings`, its columns aligned on the right.
pub fn table(headings: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    table.set_header(headings);
    for column in table.column_iter_mut() {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// Its text, without blanks at the ends of lines.
pub fn finish(table: &Table) -> String {
    let lines: Vec<String> = table
        .lines()
        .map(|line| line.trim_end().to_owned())
        .collect();
    lines.join("\n") + "\n"
}

/// A pose in a word: mating, fraction to four decimals, flank.
pub fn where_it_is(pose: &ComparedPose) -> String {
    let mating = pose.swept.pose.mating();
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!("+{}", rounded(fraction, 4)),
    };
    format!(
        "{},{}{beyond} {}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name()
    )
}
