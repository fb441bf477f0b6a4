//! The centre distance at which a drawn pair meshes without play.

use super::study::Study;
use super::verdict::Verdict;
use crate::error::Error;
use crate::outline::PlacedGear;
use crate::pair::Member;

/// Steps per mm to which the distance is rounded up.
const STEPS_PER_MM: f64 = 1000.0;

/// A centre distance without play, or as near to it as tips and roots allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WithoutPlay {
    /// Centre distance, mm, rounded up to 1 µm.
    pub distance: f64,
    /// Whether flanks bind there; otherwise a tip touches a root first.
    pub flanks_bind: bool,
}

impl WithoutPlay {
    /// The distance from the `verdict` on a pair at `nearest`, where a tip touches a root; `None` where it is not proven.
    pub fn of(verdict: &Verdict, nearest: f64) -> Option<WithoutPlay> {
        let from = if verdict.assembles()? {
            nearest
        } else {
            let from = verdict.assembles_from()?;
            from.doubt.is_none().then_some(from.high)?
        };
        Some(WithoutPlay {
            distance: (from * STEPS_PER_MM).ceil() / STEPS_PER_MM,
            flanks_bind: from > nearest,
        })
    }
}

/// The centre distance, mm, at which a tip of the first pair of `study` touches a root; `None` for a study without runs.
///
/// # Errors
/// As [`Study::runs`].
pub fn tips_on_roots(study: &Study) -> Result<Option<f64>, Error> {
    let runs = study.runs()?;
    Ok(runs.first().map(|run| {
        let [wheel, pinion] =
            Member::BOTH.map(|member| PlacedGear::new(&run.run.assembly, member, 0.0).radii());
        (wheel[0] + pinion[1]).max(pinion[0] + wheel[1])
    }))
}
