//! A short table of each gear.

mod deviations;
mod grades;
mod lengths;
mod positions;
mod remarks;

pub use remarks::missing;

use gearlash::gear::GRADE_SOURCE;
use gearlash_files::characters::plain;
use gearlash_files::results::gauge::GaugedGear;
use std::fmt::Write;

/// The text `gauge` prints; with `by_position` every reading tooth by tooth, too.
pub fn text(title: &str, gears: &[GaugedGear], by_position: bool) -> String {
    let mut text = format!("{}\n", plain(title));
    for gauged in gears {
        let _ = write!(text, "\n{}\n\n", gauged.words());
        text += &lengths::table_of(&gauged.gauged);
        text += &deviations::lines(&gauged.gauged);
        text += &grades::table_of(&gauged.gauged);
        text += &remarks::lines(&gauged.gauged);
        if by_position {
            text += &positions::table_of(gauged);
        }
    }
    text += LEGEND;
    let _ = writeln!(text, "Grades: {GRADE_SOURCE}.");
    text
}

const LEGEND: &str = "
Lengths in mm; range, off and bound in µm. Formula: of the mean thickness, no deviations. Off: mean less formula.
Ball: its centre from the rotation axis, so its range is F_r. a'': tight mesh with the master, its range is F_i''.
F_r of an eccentricity e alone is 2 e, down to 2 e cos(π/z) where no space is in line with the high tooth;
pitch and thickness of the teeth add to it.
Thickness is an arc of the reference circle. Pitch: own, about the gear's own centre; datum, about its rotation axis,
which is what a standard grades. Grade: the finest that admits the value, with its tolerance; measured and tolerance in µm.
--positions, --format csv and the CSV files have every reading tooth by tooth.
";
