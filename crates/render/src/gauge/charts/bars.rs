//! What the charts of a gear share: heading, numbering of the teeth, bars over them.

use crate::chart::{BarPanel, Heading, bar_panels};
use crate::error::PictureError;
use gearlash_files::numbers::{fixed, rounded};
use gearlash_files::results::gauge::{GaugedGear, Reading};

/// Below this, µm, values are level: far below what a gauge in a shop tells, far above the rounding of readings. Axes
/// are a hundred times as high at least.
pub(super) const LEVEL: f64 = 1e-3;
/// How teeth are numbered and which way a chart runs.
pub(super) const NUMBERS: &str = "numbers ascend clockwise on the reference face";

/// File name and SVG of bars over teeth.
pub(super) fn bars(
    gauged: &GaugedGear,
    reading: Reading,
    x_axis: &str,
    panels: &[BarPanel],
) -> Result<(String, String), PictureError> {
    let stem = gauged.stem();
    let heading = Heading {
        prefix: &reading.file_stem(&stem),
        title: gauged.title,
        subtitle: &subtitle(gauged),
    };
    let x_axis = format!("{x_axis} · {NUMBERS}");
    Ok((
        reading.svg(&stem),
        bar_panels(&heading, &x_axis, panels)?.svg,
    ))
}

pub(super) fn subtitle(gauged: &GaugedGear) -> String {
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
pub(super) fn means(mean: f64, formula: Option<f64>) -> String {
    let formula = formula.map_or(String::new(), |mm| format!(", formula {} mm", fixed(mm, 6)));
    format!("mean {} mm{formula}", fixed(mean, 6))
}
