//! The readings as charts, one a gauge: what each tooth reads less the mean.
//!
//! Each says what gear it is of, how its teeth are numbered, where its zero stands, and, where there is an accuracy
//! grade, between which lines that grade wants the values.

mod deviations;
mod lengths;
mod roll;

use super::GaugedGear;
use super::file_names::FileName;
use crate::chart::{BarPanel, Heading, bar_panels};
use crate::error::PictureError;
use gearlash_files::numbers::{fixed, rounded};

/// Below this, µm, values are level: far below what a gauge in a shop tells, far above the rounding of readings. Axes
/// are a hundred times as high at least.
const LEVEL: f64 = 1e-3;
/// How teeth are numbered and which way a chart runs.
const NUMBERS: &str = "numbers ascend clockwise on the reference face";

/// The charts of one gear: file name and SVG. What could not be measured has none.
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let mut files = lengths::charts(gauged)?;
    files.extend(deviations::charts(gauged)?);
    files.extend(roll::chart(gauged)?);
    Ok(files)
}

/// File name and SVG of bars over teeth.
fn by_tooth(
    gauged: &GaugedGear,
    name: FileName,
    x_axis: &str,
    panels: &[BarPanel],
) -> Result<(String, String), PictureError> {
    let stem = gauged.stem();
    let heading = Heading {
        prefix: &name.prefix(&stem),
        title: gauged.title,
        subtitle: &subtitle(gauged),
    };
    let x_axis = format!("{x_axis} · {NUMBERS}");
    Ok((name.svg(&stem), bar_panels(&heading, &x_axis, panels)?.svg))
}

fn subtitle(gauged: &GaugedGear) -> String {
    let design = gauged.gear.gear().design();
    let (basic_data, shift) = (&design.basic_data, design.profile_shift);
    // Degrees do not convert exactly.
    let degrees = rounded(basic_data.pressure_angle().to_degrees(), 9);
    format!(
        "{} · z {}, m {} mm, α {degrees}°, x {shift} · material {}",
        gauged.name,
        basic_data.teeth(),
        basic_data.module(),
        gauged.material.name(),
    )
}

/// The mean, on which the chart's zero stands, and the formula's value.
fn means(mean: f64, formula: Option<f64>) -> String {
    let formula = formula.map_or(String::new(), |mm| format!(", formula {} mm", fixed(mm, 6)));
    format!("mean {} mm{formula}", fixed(mean, 6))
}
