//! One gear's deviations tooth by tooth, as an inspection sheet shows them.

use super::bars::{BarSeries, panel};
use super::captions::empty;
use super::paint::Look;
use super::panel::{Panel, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gear::{Flank, Inspection};
use gearlash_files::numbers::um;

/// Height of a panel.
const PANEL: f64 = 132.0;

/// Single and cumulative pitch of both flanks, thickness and runout of `gear` (its name).
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn inspection(
    heading: &Heading,
    gear: &str,
    inspection: &Inspection,
) -> Result<Chart, PictureError> {
    let flanks = [
        (Flank::Right, "right flanks", Look::Right),
        (Flank::Left, "left flanks", Look::Left),
    ];
    let pitch = |values: fn(&Inspection, Flank) -> Vec<f64>| {
        flanks.map(|(side, name, look)| series(name, &values(inspection, side), look))
    };
    let single = pitch(|inspection, side| inspection.single(side));
    let cumulative = pitch(|inspection, side| inspection.cumulative(side).to_vec());
    let thickness = [series("thickness", inspection.thickness(), Look::Plain)];
    let runout = [series("displacement", inspection.runout(), Look::Plain)];
    let tooth = format!("tooth of the {gear}");
    let [single, cumulative] = [single, cumulative].map(|[right, left]| [[right], [left]]);
    let groups: [&[(&str, &[BarSeries])]; 4] = [
        &[
            ("single pitch deviation f_p, right flanks", &single[0]),
            ("single pitch deviation f_p, left flanks", &single[1]),
        ],
        &[
            (
                "cumulative pitch deviation F_p, right flanks",
                &cumulative[0],
            ),
            (
                "cumulative pitch deviation F_p, left flanks",
                &cumulative[1],
            ),
        ],
        &[("tooth thickness − mean", &thickness)],
        &[("displacement by the eccentricity, e·cos φ", &runout)],
    ];
    // Groups without data are left out.
    let deviates = |group: &&[(&str, &[BarSeries])]| {
        let mut series = group.iter().flat_map(|(_, series)| *series);
        series.any(moved)
    };
    let groups = groups.into_iter().filter(deviates);
    let mut shown: Vec<Panel> = groups.flat_map(alike).collect();
    if shown.is_empty() {
        let words = "no pitch, thickness or runout deviations are given";
        let teeth = inspection.runout().len() as f64;
        shown.push(empty(Axis::new("", [0.4, teeth + 0.6]), words));
    }
    if let Some(last) = shown.last_mut() {
        last.x.name = tooth;
        last.x.teeth = u32::try_from(inspection.runout().len()).ok();
    }
    let both = |value: fn(&Inspection, Flank) -> f64| {
        Flank::BOTH.map(|side| um(value(inspection, side), 1))
    };
    let [right, left] = both(Inspection::largest_single);
    let [total_right, total_left] = both(Inspection::total_cumulative);
    let subtitle = match single.iter().flatten().any(moved) {
        true => format!(
            "{gear} · f_p right {right}, left {left} µm · F_p right {total_right}, left {total_left} µm · + along ascending numbers"
        ),
        false => format!("{gear} · no pitch deviations"),
    };
    sheet::draw(heading, &subtitle, &[], &shown)
}

/// Panels whose y axes go over the same range.
fn alike(group: &[(&str, &[BarSeries])]) -> Vec<Panel> {
    let panels = group.iter();
    let mut panels: Vec<Panel> = panels
        .filter_map(|(title, series)| panel([title, "", "µm"], PANEL, series))
        .collect();
    let ends = panels.iter().flat_map(|panel| panel.y.range);
    if let Some(y) = range(ends, [0.0; 2], 0.0) {
        panels.iter_mut().for_each(|panel| panel.y.range = y);
    }
    panels
}

/// Whether some value is not zero.
fn moved(series: &BarSeries) -> bool {
    series.values.iter().flatten().any(|value| *value != 0.0)
}

fn series<'a>(name: &'a str, values_mm: &[f64], look: Look) -> BarSeries<'a> {
    BarSeries {
        name,
        values: values_mm.iter().map(|mm| Some(mm * 1e3)).collect(),
        look,
    }
}
