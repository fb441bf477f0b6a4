//! Profile and lead deviations in the layout of an inspection sheet: one panel per flank, the evaluation range shaded.

use super::captions::entry;
use super::panel::{Look, Mark, Panel, Point, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gauge::{FlankTraces, LeadReadings, ProfileReadings, TraceReading};
use gearlash::gear::{Flank, PitchAxis};
use gearlash_files::numbers::{fixed, um};

/// Most curves beside the worst one; more could not be distinguished.
const MOST_OTHERS: usize = 11;
const HEIGHT: f64 = 236.0;

/// The profiles of both flanks. The y axis is at least `least` high, µm.
///
/// # Errors
/// [`PictureError`] when there are none.
pub fn profiles(
    heading: &Heading,
    read: &ProfileReadings,
    least: f64,
) -> Result<Chart, PictureError> {
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
    traces(heading, &read.flanks, captions, (least, &[]), words)
}

/// The leads of both flanks. The y axis is at least `least` high, µm.
///
/// # Errors
/// As [`profiles`].
pub fn leads(heading: &Heading, read: &LeadReadings, least: f64) -> Result<Chart, PictureError> {
    let words = |side: Flank, lead: &TraceReading| {
        let [from, to] = read.flank(side).evaluated.map(|z| fixed(z, 2));
        format!(
            "f_Hβ {}{}, f_fβ {}, F_β {}, C_β {} µm · evaluated over {from} … {to} mm",
            um(read.helix_slope(side, lead), 2),
            if read.is_helical {
                ""
            } else {
                " (as right hand)"
            },
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
    traces(heading, &read.flanks, captions, (least, &lines), words)
}

/// Traces of both flanks, right first. `words` describes one of a side. The y axis is at least `least` high, µm, and holds `more` values, mm.
fn traces(
    heading: &Heading,
    flanks: &[FlankTraces; 2],
    (x_axis, details): (&str, &str),
    (least, more): (f64, &[f64]),
    words: impl Fn(Flank, &TraceReading) -> String,
) -> Result<Chart, PictureError> {
    let points = || {
        let shapes = flanks.iter().flat_map(|flank| &flank.shapes);
        shapes.flat_map(|shape| &shape.points)
    };
    let x = range(points().map(|point| point.0), [0.02; 2], 1e-9);
    let y = range(
        (points().map(|point| 1e3 * point.1).chain([0.0])).chain(more.iter().map(|mm| 1e3 * mm)),
        [0.08; 2],
        least,
    );
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
    sheet::draw(heading, details, &entries, &panels)
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
    let mut marks = vec![Mark::shade(flank.evaluated, Look::Limit, SHADE)];
    let curve = |trace: &TraceReading| -> Vec<Point> {
        let points = trace.points.iter();
        points.map(|&(at, mm)| (at, Some(1e3 * mm))).collect()
    };
    let others = flank.shapes.iter().filter(|other| *other != trace);
    let others = others.take(MOST_OTHERS);
    marks.extend(others.map(|other| Mark::line(curve(other), Look::Limit, 0.8)));
    marks.push(Mark::line(curve(trace), look, 1.6));
    let mean = trace.mean_line.map(|(at, mm)| (at, Some(1e3 * mm)));
    marks.push(Mark::line(mean.to_vec(), Look::Plain, 0.8));
    let tooth = match flank.shapes.len() {
        1 => "all teeth".to_owned(),
        _ => format!("worst tooth {worst}"),
    };
    let title = format!("{} flanks, {tooth} · {}", side.name(), words(side, trace));
    Panel::new(x, y, HEIGHT, marks).titled(title)
}
