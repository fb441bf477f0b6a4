//! Branch and bound over the pairs of curves of two half teeth.

use super::candidate::CandidateContact;
use super::curves::{CurvePairs, SearchExhausted};
use super::placed::PlacedHalf;
use super::shape::C;
use crate::contact::gap::{CurveArc, OpenPairs, Origin, PlacedCurve, greatest};
use crate::gear::{ProfilePart, smooth};

/// The greatest gap of two half teeth over `curves`, if it exceeds `floor`. The nodes used are subtracted from `nodes_left`.
pub(super) fn search(
    locked: &PlacedHalf,
    free: &PlacedHalf,
    origin: Origin,
    floor: f64,
    curves: CurvePairs,
    nodes_left: &mut usize,
) -> Result<Option<CandidateContact>, SearchExhausted> {
    let frees = ProfilePart::ALL.into_iter().filter_map(|curve| {
        let wanted = ProfilePart::ALL.iter().any(|own| curves.has(*own, curve));
        let range = wanted.then(|| free_range(free, curve)).flatten()?;
        Some((curve, range, free.around(curve)))
    });
    let frees: Vec<_> = frees.collect();
    let [_, room] = locked.rounding(free);
    let mut open = OpenPairs::default();
    for curve in ProfilePart::ALL {
        let wanted = ProfilePart::ALL.iter().any(|mate| curves.has(curve, *mate));
        if !(wanted && locked.has(curve)) {
            continue;
        }
        let around = locked.around(curve);
        let mates = frees.iter().filter(|(mate, _, other)| {
            // Without a common radius there is no gap.
            curves.has(curve, *mate) && around.meets(other, room)
        });
        let mates = mates.flat_map(|&(mate, range, _)| arcs(free.curve(mate), mate, range));
        open.add_all(arcs(locked.curve(curve), curve, locked.range(curve)), mates);
    }
    let part = |name: usize| ProfilePart::ALL[name];
    let found = greatest(&mut open, origin, floor, nodes_left);
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

/// A curve between two parameters, cut at its edges.
pub(super) fn arcs<'a>(
    on: PlacedCurve<'a>,
    curve: ProfilePart,
    (low, high): (f64, f64),
) -> impl Iterator<Item = CurveArc<'a>> + use<'a> {
    let arc = move |(low, high)| CurveArc::new(on, curve as usize, low, high);
    smooth(on.curve.edges(), low, high).map(arc)
}

/// One whole curve of the free gear, if it has any length. About its own centre a land has one radius, on which only its clockwise end can
/// touch. That is the corner of a tip land (which also ends the involute), or the middle of the space for a root land.
fn free_range(free: &PlacedHalf, curve: ProfilePart) -> Option<(f64, f64)> {
    if !free.has(curve) {
        return None;
    }
    let (low, high) = free.range(curve);
    match curve {
        ProfilePart::Tip if free.centre == C::ZERO => None,
        ProfilePart::Root if free.centre == C::ZERO => Some((high, high)),
        _ => Some((low, high)),
    }
}
