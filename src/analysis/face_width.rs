//! Cost of the face width of pairs that vary along the face: extremes of the lost motion over nested faces.

use super::extremes::{RunExtreme, RunExtremes, extremes};
use super::study::Study;
use crate::contact::{End, Method};
use crate::error::{Error, Tick};

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
    /// Width of the part, mm.
    pub fn width(&self) -> f64 {
        self.face[1] - self.face[0]
    }

    /// The least `j_wt` of all runs; `None` if a run is jammed.
    pub fn least(&self) -> Option<FaceExtreme<'_>> {
        FaceExtreme::of(&self.each, End::Least)
    }

    /// The greatest `j_wt` of all runs; `None` if a run is out of mesh.
    pub fn greatest(&self) -> Option<FaceExtreme<'_>> {
        FaceExtreme::of(&self.each, End::Greatest)
    }
}

/// The least or the greatest `j_wt` of all runs, mm.
#[derive(Debug, Clone, Copy)]
pub struct FaceExtreme<'a> {
    /// The found value.
    pub found: f64,
    /// Lower bound.
    pub low: f64,
    /// Upper bound.
    pub high: f64,
    /// A run whose bracket is too wide; one whose bracket does not hold has priority.
    pub doubtful: Option<&'a RunExtreme>,
}

impl<'a> FaceExtreme<'a> {
    /// The least, or the greatest, of `runs`.
    fn of(runs: &'a [RunExtremes], end: End) -> Option<FaceExtreme<'a>> {
        let runs: Vec<&RunExtreme> = runs.iter().map(|run| run.at(end)).collect::<Option<_>>()?;
        let first = |value: fn(&RunExtreme) -> f64| {
            let values = runs.iter().map(|run| value(run));
            let is_first = |a: f64, b: f64| end.sign() * a <= end.sign() * b;
            values.reduce(|a, b| if is_first(a, b) { a } else { b })
        };
        let doubtful = runs.iter().filter(|run| !run.is_proven());
        Some(FaceExtreme {
            found: first(RunExtreme::found)?,
            low: first(|run| run.low)?,
            high: first(|run| run.high)?,
            doubtful: doubtful.min_by_key(|run| run.holds()).copied(),
        })
    }

    /// Whether the bracket holds.
    pub fn holds(&self) -> bool {
        self.doubtful.is_none_or(RunExtreme::holds)
    }

    /// The range of the difference from `other`, mm; `None` if a bracket does not hold.
    pub fn against(&self, other: &FaceExtreme) -> Option<[f64; 2]> {
        let hold = self.holds() && other.holds();
        hold.then_some([self.low - other.high, self.high - other.low])
    }
}

/// The extremes of `study` over parts of its common face, from one section to the whole face (`full` is its result); empty for a pair
/// whose sections are all equal. Where axes lean, the narrowest part is a quarter of the face: single sections of such gears miss each other.
///
/// The parts are nested about the middle of the common face, like narrower gears in the same place; the measuring plane
/// stays fixed. A wider part never has more play.
///
/// # Errors
/// As [`extremes`].
pub fn over_widths(
    study: &Study,
    full: &[RunExtremes],
    method: Method,
    tick: &Tick,
) -> Result<Vec<AtWidth>, Error> {
    if !study.varies_along_face() || full.is_empty() {
        return Ok(Vec::new());
    }
    let [from, to] = study.face;
    let middle = 0.5 * (from + to);
    let mut widths = Vec::new();
    for step in narrowest(study)..WIDTHS - 1 {
        let part = f64::from(step) / f64::from(WIDTHS - 1);
        let face = [from, to].map(|end| middle + (end - middle) * part);
        // Without bearing clearance.
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

/// The number of the narrowest width.
fn narrowest(study: &Study) -> u32 {
    u32::from(study.leans())
}

/// Number of searches of [`over_widths`] over the runs of a study.
pub(super) fn searches(study: &Study) -> u64 {
    if study.varies_along_face() {
        u64::from(WIDTHS - 1 - narrowest(study))
    } else {
        0
    }
}
