//! The centre distance at which a drawn pair meshes without play.

use super::study::Study;
use super::verdict::Verdict;
use crate::error::Error;
use crate::pair::Member;

/// Steps of 1 mm to which the distance is rounded up.
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

/// The centre distance, mm, at which a tip of the first drawn pair of `study` touches a root; `None` for a pair by data.
///
/// # Errors
/// As [`Study::runs`].
pub fn tips_on_roots(study: &Study) -> Result<Option<f64>, Error> {
    let runs = study.runs()?;
    let pair = runs.first().and_then(|run| run.assembly.drawn());
    Ok(pair.map(|pair| {
        let touching = |member: Member| {
            pair.gear(member).tip_radius() + pair.gear(member.mate()).root_radius()
        };
        touching(Member::Wheel).max(touching(Member::Pinion))
    }))
}
