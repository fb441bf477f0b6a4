//! One gear's deviations tooth by tooth, in the layout of an inspection sheet.

use super::bars::{BarPanel, BarSeries, bar_panels};
use super::captions::empty;
use super::panel::Look;
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gear::{Flank, Inspection};
use gearlash_files::numbers::um;

/// Single and cumulative pitch of both flanks, thickness and runout of `gear` (its name). Panels without a deviation are left out.
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn inspection(
    heading: &Heading,
    gear: &str,
    inspection: &Inspection,
) -> Result<Chart, PictureError> {
    let pitch = |values: fn(&Inspection, Flank) -> Vec<f64>| {
        let right = values(inspection, Flank::Right);
        let left = values(inspection, Flank::Left);
        vec![
            BarSeries::of_mm("right flanks", &right, Look::Right),
            BarSeries::of_mm("left flanks", &left, Look::Left),
        ]
    };
    let plain = |name, values: &[f64]| vec![BarSeries::of_mm(name, values, Look::Plain)];
    let single = pitch(|inspection, side| inspection.single(side));
    let cumulative = pitch(|inspection, side| inspection.cumulative(side).to_vec());
    let thickness = plain("thickness", inspection.thickness());
    let runout = plain("displacement", inspection.runout());
    let groups = [
        ("single pitch deviation f_p", single),
        ("cumulative pitch deviation F_p", cumulative),
        ("tooth thickness − mean", thickness),
        ("displacement by the eccentricity, e·cos φ", runout),
    ];
    let moved = |series: &BarSeries| series.values.iter().flatten().any(|value| *value != 0.0);
    let deviating = groups.iter().filter(|(_, series)| series.iter().any(moved));
    let panels: Vec<BarPanel> = deviating
        .map(|(title, series)| BarPanel {
            title,
            y_axis: "µm",
            series,
            limits: Vec::new(),
            level: 0.0,
        })
        .collect();
    let both = |value: fn(&Inspection, Flank) -> f64| {
        Flank::BOTH.map(|side| um(value(inspection, side), 1))
    };
    let [right, left] = both(Inspection::largest_single);
    let [total_right, total_left] = both(Inspection::total_cumulative);
    let details = if groups[0].1.iter().any(moved) {
        format!(
            "{gear} · f_p right {right}, left {left} µm · F_p right {total_right}, left {total_left} µm · + along ascending numbers"
        )
    } else {
        format!("{gear} · no pitch deviations")
    };
    let x_axis = format!("tooth of the {gear}");
    if panels.is_empty() {
        let words = "no pitch, thickness or runout deviations are given";
        let teeth = inspection.runout().len();
        let ends = [0.4, teeth as f64 + 0.6];
        let x = Axis::of_teeth(&x_axis, ends, u32::try_from(teeth).ok());
        return sheet::draw(heading, &details, &[], &[empty(x, words)]);
    }
    bar_panels(heading, &details, &x_axis, &panels)
}
