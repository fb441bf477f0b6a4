//! What the face width of helical gears costs: extremes of the lost motion over faces that hold each other.

use super::extremes::{RunExtreme, RunExtremes, extremes};
use super::study::Study;
use crate::contact::Method;
use crate::error::Error;
use std::ops::ControlFlow;

/// Widths between one section and the full face, both included.
const WIDTHS: u32 = 5;

/// The extremes over a part of the common face.
#[derive(Debug, Clone)]
pub struct AtWidth {
    /// The part, mm from the measuring plane.
    pub face: [f64; 2],
    /// Each centre distance, material and assembly phase.
    pub each: Vec<RunExtremes>,
}

impl AtWidth {
    /// How wide the part is, mm.
    pub fn width(&self) -> f64 {
        self.face[1] - self.face[0]
    }

    /// How much more the least and the greatest `j_wt` are than over `other`, mm.
    pub fn against(&self, other: &AtWidth) -> [Option<f64>; 2] {
        let more = |here: Option<&RunExtreme>, there: Option<&RunExtreme>| {
            Some(here?.found() - there?.found())
        };
        [
            more(self.least(), other.least()),
            more(self.greatest(), other.greatest()),
        ]
    }

    /// The run with the least `j_wt`; `None` where one is jammed, whose backlash is less than any.
    pub fn least(&self) -> Option<&RunExtreme> {
        let each: Option<Vec<&RunExtreme>> =
            self.each.iter().map(|run| run.least.as_ref()).collect();
        each?
            .into_iter()
            .min_by(|a, b| a.found().total_cmp(&b.found()))
    }

    /// That with the greatest; `None` where one is out of mesh.
    pub fn greatest(&self) -> Option<&RunExtreme> {
        let each: Option<Vec<&RunExtreme>> =
            self.each.iter().map(|run| run.greatest.as_ref()).collect();
        each?
            .into_iter()
            .max_by(|a, b| a.found().total_cmp(&b.found()))
    }
}

/// The extremes of `study` over parts of its common face, from one section to all of it (`full`, what was found there); none of spur gears.
///
/// The parts hold each other, about the place of the face nearest to the measuring plane: a wider one never has more play.
///
/// # Errors
/// As [`extremes`].
pub fn over_widths(
    study: &Study,
    full: &[RunExtremes],
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<AtWidth>, Error> {
    if !study.is_helical() || full.is_empty() {
        return Ok(Vec::new());
    }
    let [from, to] = study.face;
    let middle = 0f64.clamp(from, to);
    let mut widths = Vec::new();
    for step in 0..WIDTHS - 1 {
        let part = f64::from(step) / f64::from(WIDTHS - 1);
        let face = [from, to].map(|end| middle + (end - middle) * part);
        // Bearings are another question.
        let narrower = Study {
            face,
            bearing_clearance: 0.0,
            ..study.clone()
        };
        widths.push(AtWidth {
            face,
            each: extremes(&narrower, method, tick)?.each,
        });
    }
    widths.push(AtWidth {
        face: study.face,
        each: full.to_vec(),
    });
    Ok(widths)
}

/// How often [`over_widths`] looks through the runs of a study.
pub(super) fn searches(study: &Study) -> u64 {
    match study.is_helical() {
        true => u64::from(WIDTHS - 1),
        false => 0,
    }
}
