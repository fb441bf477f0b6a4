//! Branch and bound over the pairs of curves of two half teeth.

use super::candidate::CandidateContact;
use super::curves::{Curves, SearchExhausted};
use super::placed::Placed;
use super::shape::C;
use crate::contact::gap::{Arc, greatest};
use crate::gear::ProfilePart;

/// The greatest gap of two half teeth over `curves`, if it exceeds `floor`; `nodes_left`, of which it takes what it needs.
pub(super) fn search(
    locked: &Placed,
    free: &Placed,
    origin: C,
    floor: f64,
    curves: Curves,
    nodes_left: &mut usize,
) -> Result<Option<CandidateContact>, SearchExhausted> {
    let mut nodes = Vec::new();
    let frees = ProfilePart::ALL.map(|curve| whole_free_arc(free, curve));
    for (curve, row) in ProfilePart::ALL.into_iter().zip(curves.0) {
        if row == [false; 4] || !locked.has(curve) {
            continue;
        }
        let (low, high) = locked.range(curve);
        let arc = Arc::new(locked.curve(curve), curve as usize, low, high);
        let free_arc = frees.iter().zip(row).filter(|(_, wanted)| *wanted);
        nodes.extend(free_arc.filter_map(|(free, _)| Some((arc, (*free)?))));
    }
    let part = |name: usize| ProfilePart::ALL[name];
    let found = greatest(nodes, origin, floor, nodes_left);
    let found = found.map_err(|(locked, free)| SearchExhausted(part(locked), part(free)))?;
    Ok(found.map(|found| {
        CandidateContact::new(
            (locked, (part(found.locked.0), found.locked.1)),
            (free, (part(found.free.0), found.free.1)),
            origin,
            found.slack,
        )
    }))
}

/// The whole of one curve of the free gear, if it has any length. About its own centre a land has one radius, on which
/// only its end farthest clockwise can touch: of the tip land the corner (which ends the involute
/// too), of the root land the middle of the space.
fn whole_free_arc<'a>(free: &Placed<'a>, curve: ProfilePart) -> Option<Arc<'a>> {
    if !free.has(curve) {
        return None;
    }
    let (low, high) = free.range(curve);
    let arc = |low, high| Some(Arc::new(free.curve(curve), curve as usize, low, high));
    if free.centre != C::ZERO {
        return arc(low, high);
    }
    match curve {
        ProfilePart::Tip => None,
        ProfilePart::Root => arc(high, high),
        _ => arc(low, high),
    }
}
