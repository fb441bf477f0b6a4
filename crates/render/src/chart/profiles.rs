//! Profile deviation over the roll length, in the layout of an inspection sheet: one panel per flank, the evaluation range
//! shaded.

use super::captions::entry;
use super::paint::Look;
use super::panel::{Mark, Panel, Point, Swatch, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::Axis;
use gearlash::gauge::{FlankProfiles, ProfileReading, ProfileReadings};
use gearlash::gear::Flank;
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
    let points = || {
        let flanks = read.flanks.iter();
        let shapes = flanks.flat_map(|flank| &flank.shapes);
        shapes.flat_map(|shape| &shape.points)
    };
    let x = range(points().map(|point| point.0), [0.02; 2], 1e-9);
    let y = range(
        points().map(|point| 1e3 * point.1).chain([0.0]),
        [0.08; 2],
        least,
    );
    let (Some(x), Some(y)) = (x, y) else {
        return Err(PictureError("there are no values to draw".to_owned()));
    };
    let several = read.flanks.iter().any(|flank| flank.shapes.len() > 1);
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
        .map(|(side, look)| panel(side, look, read.flank(side), [x, y]))
        .collect();
    let details = "plus = more material, against the involute of the mean thickness";
    sheet::draw(heading, details, &entries, &panels)
}

/// Opacity of the evaluation range.
const SHADE: f64 = 0.16;

fn panel(side: Flank, look: Look, flank: &FlankProfiles, [x, y]: [[f64; 2]; 2]) -> Panel {
    let worst = flank.worst_tooth();
    let profile = flank.tooth(worst);
    let mut marks = vec![Mark::shade(flank.evaluated, Look::Limit, SHADE)];
    let line = |points: Vec<Point>, look, width| Mark::line(points, look, width);
    let curve = |profile: &ProfileReading| -> Vec<Point> {
        let points = profile.points.iter();
        points.map(|&(at, mm)| (at, Some(1e3 * mm))).collect()
    };
    let others = flank.shapes.iter().filter(|other| *other != profile);
    marks.extend(
        others
            .take(MOST_OTHERS)
            .map(|other| line(curve(other), Look::Limit, 0.8)),
    );
    marks.push(line(curve(profile), look, 1.6));
    let mean = profile.mean_line.map(|(at, mm)| (at, Some(1e3 * mm)));
    marks.push(line(mean.to_vec(), Look::Plain, 0.8));
    let tooth = match flank.shapes.len() {
        1 => "all teeth".to_owned(),
        _ => format!("worst tooth {worst}"),
    };
    let [from, to] = flank.evaluated_diameters.map(|d| fixed(d, 3));
    Panel {
        title: format!(
            "{} flanks, {tooth} · f_Hα {}, f_fα {}, F_α {} µm · evaluated over d {from} … {to} mm",
            side.name(),
            um(profile.slope, 2),
            um(profile.form, 2),
            um(profile.total, 2),
        ),
        x: Axis::new("roll length, mm", x),
        y: Axis::new("deviation, µm", y),
        height: HEIGHT,
        marks,
    }
}
