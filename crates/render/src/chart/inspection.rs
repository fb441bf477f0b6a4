//! One gear's deviations tooth by tooth, as an inspection sheet shows them.

use super::bars::{BarSeries, legend, panel};
use super::captions::{empty, entry};
use super::paint::Look;
use super::panel::Sample;
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gear::{Flank, Inspection};
use gearlash_files::numbers::um;

/// Height of a panel.
const PANEL: f64 = 168.0;

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
    let panels: [(&str, &[BarSeries]); 4] = [
        ("single pitch deviation f", &single),
        ("cumulative pitch deviation F", &cumulative),
        ("tooth thickness − mean", &thickness),
        ("displacement by the eccentricity, e·cos φ", &runout),
    ];
    // Panels without data are left out.
    let deviates = |all: &[BarSeries]| {
        let mut values = all.iter().flat_map(|series| series.values.iter().flatten());
        values.any(|value| *value != 0.0)
    };
    let mut shown: Vec<_> = panels
        .iter()
        .filter(|(_, series)| deviates(series))
        .filter_map(|(title, series)| panel([title, "", "µm"], PANEL, series))
        .collect();
    if shown.is_empty() {
        let words = "no pitch, thickness or runout deviations are given";
        let teeth = inspection.runout().len() as f64;
        shown.push(empty(Axis::new("", [0.4, teeth + 0.6]), words));
    }
    if let Some(last) = shown.last_mut() {
        last.x.name = tooth;
        last.x.teeth = u32::try_from(inspection.runout().len()).ok();
    }
    let mut names = Vec::new();
    if deviates(&single) {
        names.extend(legend(&single));
    }
    let plain = match (deviates(&thickness), deviates(&runout)) {
        (true, true) => "thickness, displacement",
        (true, false) => "thickness",
        (false, _) => "displacement",
    };
    if deviates(&thickness) || deviates(&runout) {
        names.push(entry(plain, Look::Plain, Sample::Bar));
    }
    let both = |value: fn(&Inspection, Flank) -> f64| {
        Flank::BOTH.map(|side| um(value(inspection, side), 1))
    };
    let [right, left] = both(Inspection::largest_single);
    let [total_right, total_left] = both(Inspection::total_cumulative);
    let subtitle = match deviates(&single) {
        true => format!(
            "{gear} · f_p right {right}, left {left} µm · F_p right {total_right}, left {total_left} µm · + along ascending numbers"
        ),
        false => format!("{gear} · no pitch deviations"),
    };
    sheet::draw(heading, &subtitle, &names, &shown)
}

fn series<'a>(name: &'a str, values_mm: &[f64], look: Look) -> BarSeries<'a> {
    BarSeries {
        name,
        values: values_mm.iter().map(|mm| Some(mm * 1e3)).collect(),
        look,
    }
}
