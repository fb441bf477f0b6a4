//! Deviations of one gear in the layout of an inspection sheet: tooth by tooth; and of profiles and leads, one panel per flank with the
//! evaluation range shaded.

use super::bars::{BarPanel, BarSeries, bar_panels};
use super::captions::{empty, entry};
use super::panel::{Look, Mark, Panel, Point, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gauge::{FlankTraces, LeadReadings, ProfileReadings, TraceReading};
use gearlash::gear::{Flank, Inspection, Pitch, PitchAxis};
use gearlash_text::numbers::{fixed, um};

/// Single and cumulative pitch of both flanks, thickness and runout of `gear` (its name). Panels without a deviation are left out.
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn inspection(
    heading: &Heading,
    gear: &str,
    inspection: &Inspection,
) -> Result<Chart, PictureError> {
    let plain = |name, values: &[f64]| vec![BarSeries::of_mm(name, values, Look::Plain)];
    let pitch = &inspection.pitch;
    let single = BarSeries::of_flanks(|side| pitch.single(side)).to_vec();
    let cumulative = BarSeries::of_flanks(|side| pitch.flank(side).to_vec()).to_vec();
    let thickness = plain("thickness", inspection.thickness());
    let runout = plain("displacement", inspection.runout());
    let groups = [
        ("single pitch deviation f_p", single),
        ("cumulative pitch deviation F_p", cumulative),
        ("tooth thickness − mean", thickness),
        ("displacement by the eccentricity, e·cos φ", runout),
    ];
    let moved = |series: &BarSeries| series.values.iter().flatten().any(|um| um.abs() > 1e-9);
    let deviating = groups.iter().filter(|(_, series)| series.iter().any(moved));
    let panels: Vec<BarPanel> = deviating
        .map(|(title, series)| BarPanel {
            title,
            y_axis: "µm",
            series,
            ..BarPanel::default()
        })
        .collect();
    let both = |value: fn(&Pitch, Flank) -> f64| Flank::BOTH.map(|side| um(value(pitch, side), 1));
    let [right, left] = both(Pitch::greatest_single);
    let [total_right, total_left] = both(Pitch::total);
    let details = if groups[0].1.iter().any(moved) {
        format!(
            "{gear} · f_p right {right}, left {left} µm · F_p right {total_right}, left {total_left} µm about its own axis · + along ascending numbers"
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
        return Ok(sheet::draw(heading, &details, &[], &[empty(x, words)]));
    }
    bar_panels(heading, &details, &x_axis, &panels)
}

/// [`inspection`], and below it the leads that the gear states. Leads alone are the whole chart.
///
/// # Errors
/// As [`inspection`].
pub fn inspection_and_leads(
    heading: &Heading,
    gear: &str,
    inspection: &Inspection,
    lead: Option<&LeadReadings>,
) -> Result<Chart, PictureError> {
    let teeth = self::inspection(heading, gear, inspection)?;
    match lead {
        None => Ok(teeth),
        Some(read) if inspection.deviates() => Ok(teeth.above(leads(heading, read)?)),
        Some(read) => {
            let heading = Heading {
                subtitle: gear,
                ..heading.clone()
            };
            leads(&heading, read)
        }
    }
}

/// Most curves beside the worst one; more could not be distinguished.
const MOST_OTHERS: usize = 11;
const HEIGHT: f64 = 236.0;
/// Least height of an axis of profiles and leads, µm.
const LEAST: f64 = 0.1;

/// The profiles of both flanks.
///
/// # Errors
/// [`PictureError`] when there are none.
pub fn profiles(heading: &Heading, read: &ProfileReadings) -> Result<Chart, PictureError> {
    let words = |side: Flank, profile: &TraceReading| {
        let [from, to] = read.evaluated_diameters[side.index()].map(|d| fixed(d, 3));
        format!(
            "f_Hα {}, f_fα {}, F_α {} µm · evaluated over d {from} … {to} mm",
            um(profile.slope, 2),
            um(profile.form, 2),
            um(profile.total, 2),
        )
    };
    let details = "plus = more material, against the involute of the mean thickness";
    let captions = ("roll length, mm", details);
    traces(heading, &read.flanks, captions, &[], words)
}

/// The leads of both flanks.
///
/// # Errors
/// As [`profiles`].
pub fn leads(heading: &Heading, read: &LeadReadings) -> Result<Chart, PictureError> {
    let words = |side: Flank, lead: &TraceReading| {
        let [from, to] = read.flank(side).evaluated.map(|z| fixed(z, 2));
        let hand = if read.is_helical {
            ""
        } else {
            " (as right hand)"
        };
        format!(
            "f_Hβ {}{hand}, f_fβ {}, F_β {}, C_β over the face width {} µm · evaluated over {from} … {to} mm",
            um(read.helix_slope(side, lead), 2),
            um(lead.form, 2),
            um(lead.total, 2),
            um(read.crowning(lead), 2),
        )
    };
    let flanks = read.flanks.iter();
    let worst = flanks.map(|flank| flank.tooth(flank.worst_tooth()));
    let lines = worst.flat_map(|lead| lead.mean_line.map(|end| end.1));
    let lines: Vec<f64> = lines.collect();
    let details = match read.axis {
        PitchAxis::Own => "plus = more material, about the axis of the teeth",
        PitchAxis::Datum => "plus = more material, about the rotation axis",
    };
    let captions = ("from the reference face, mm", details);
    traces(heading, &read.flanks, captions, &lines, words)
}

/// Traces of both flanks, right first. `words` describes one of a side. The y axis holds `more` values, mm.
fn traces(
    heading: &Heading,
    flanks: &[FlankTraces; 2],
    (x_axis, details): (&str, &str),
    more: &[f64],
    words: impl Fn(Flank, &TraceReading) -> String,
) -> Result<Chart, PictureError> {
    let points = || {
        let shapes = flanks.iter().flat_map(|flank| &flank.shapes);
        shapes.flat_map(|shape| &shape.points)
    };
    let x = range(points().map(|point| point.0), [0.02; 2], 1e-9);
    let values = points().map(|point| point.1).chain([0.0]);
    let values = values.chain(more.iter().copied()).map(|mm| 1e3 * mm);
    let y = range(values, [0.08; 2], LEAST);
    let (Some(x), Some(y)) = (x, y) else {
        return Err(PictureError("there are no values to draw".to_owned()));
    };
    let several = flanks.iter().any(|flank| flank.shapes.len() > 1);
    let mut entries = vec![
        entry("right flanks", Look::Right, Swatch::Line),
        entry("left flanks", Look::Left, Swatch::Line),
        entry("mean line", Look::Plain, Swatch::Line),
        entry("evaluation range", Look::Limit, Swatch::Band(SHADE)),
    ];
    if several {
        entries.insert(2, entry("other teeth", Look::Limit, Swatch::Line));
    }
    let panels: Vec<Panel> = Flank::BOTH
        .into_iter()
        .zip([Look::Right, Look::Left])
        .map(|(side, look)| {
            let flank = &flanks[side.index()];
            let axes = [Axis::new(x_axis, x), Axis::new("deviation, µm", y)];
            panel(side, look, flank, axes, &words)
        })
        .collect();
    Ok(sheet::draw(heading, details, &entries, &panels))
}

const SHADE: f64 = 0.16;

fn panel(
    side: Flank,
    look: Look,
    flank: &FlankTraces,
    [x, y]: [Axis; 2],
    words: &impl Fn(Flank, &TraceReading) -> String,
) -> Panel {
    let worst = flank.worst_tooth();
    let trace = flank.tooth(worst);
    let mut marks = vec![Mark::Shade(flank.evaluated, Look::Limit, SHADE)];
    let curve = |trace: &TraceReading| -> Vec<Point> {
        let points = trace.points.iter();
        points.map(|&(at, mm)| (at, Some(1e3 * mm))).collect()
    };
    let others = flank.shapes.iter().filter(|other| *other != trace);
    let others = others.take(MOST_OTHERS);
    marks.extend(others.map(|other| Mark::Line(curve(other), Look::Limit, 0.8)));
    marks.push(Mark::Line(curve(trace), look, 1.6));
    let mean = trace.mean_line.map(|(at, mm)| (at, Some(1e3 * mm)));
    marks.push(Mark::Line(mean.to_vec(), Look::Plain, 0.8));
    let tooth = match flank.shapes.len() {
        1 => "all teeth".to_owned(),
        _ => format!("worst tooth {worst}"),
    };
    let title = format!("{} flanks, {tooth} · {}", side.name(), words(side, trace));
    Panel::new(x, y, HEIGHT, marks).titled(title)
}
