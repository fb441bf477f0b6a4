//! Branch and bound over the pairs of curves of two half teeth.

use super::candidate::CandidateContact;
use super::curves::{Curves, SearchExhausted};
use super::placed::Placed;
use super::shape::C;
use crate::contact::gap::{Arc, greatest};
use crate::gear::{ProfilePart, smooth};

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
    let frees = ProfilePart::ALL.map(|curve| whole_free_arcs(free, curve));
    for (curve, row) in ProfilePart::ALL.into_iter().zip(curves.0) {
        if row == [false; 4] || !locked.has(curve) {
            continue;
        }
        for arc in stretches(locked, curve) {
            let free_arcs = frees.iter().zip(row).filter(|(_, wanted)| *wanted);
            let free_arcs = free_arcs.flat_map(|(arcs, _)| arcs);
            nodes.extend(free_arcs.map(|free| (arc, *free)));
        }
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

/// One whole curve, cut at its edges.
fn stretches<'a>(placed: &Placed<'a>, curve: ProfilePart) -> Vec<Arc<'a>> {
    let (low, high) = placed.range(curve);
    let on = placed.curve(curve);
    let arc = |(low, high)| Arc::new(on, curve as usize, low, high);
    smooth(on.curve.edges(), low, high).map(arc).collect()
}

/// The whole of one curve of the free gear, if it has any length. About its own centre a land has one radius, on which
/// only its end farthest clockwise can touch: of the tip land the corner (which ends the involute
/// too), of the root land the middle of the space.
fn whole_free_arcs<'a>(free: &Placed<'a>, curve: ProfilePart) -> Vec<Arc<'a>> {
    if !free.has(curve) {
        return Vec::new();
    }
    let centred = free.centre == C::ZERO;
    match curve {
        ProfilePart::Tip if centred => Vec::new(),
        ProfilePart::Root if centred => {
            let (_, high) = free.range(curve);
            vec![Arc::new(free.curve(curve), curve as usize, high, high)]
        }
        _ => stretches(free, curve),
    }
}
