//! Land on land in closed form: two arcs, one of which turns about an axis off its centre. A tip on a tip, or on a root.
//!
//! Along both lands the gap is greatest where an arc ends (the end of one land on the other), or where the circles
//! touch. `C` is the centre of the locked arc, `E` that of the free one at rotation 0, and `S` the sum of their radii.
//! The circles touch at the rotation `μ` with `|C − E e^{iμ}| = S`:
//!
//! ```text
//! cos(arg C − arg E − μ) = (|C|² + |E|² − S²)/(2 |C| |E|).
//! ```
//!
//! (Where an arc's radius about the axis turns, the gap continues along the arc: no extremum.) A search would be
//! slowest here: a free land is so nearly round about the axis that its polar slope bounds nothing.

use super::candidate::CandidateContact;
use super::corner::on_land;
use super::curves::CurvePairs;
use super::flank_problem::PosedFlanks;
use super::placed::PlacedHalf;
use super::shape::{C, turn};
use super::tightest::TightestContacts;
use crate::contact::gap::Origin;
use crate::gear::ProfilePart::{self, Root, Tip};

/// The pairs of lands that can touch, the locked gear's first. Two roots never touch.
pub(super) const LANDS: [(ProfilePart, ProfilePart); 3] = [(Tip, Tip), (Tip, Root), (Root, Tip)];

/// `curves` without pairs of lands.
pub(super) fn without_lands(curves: CurvePairs) -> CurvePairs {
    LANDS
        .into_iter()
        .fold(curves, |rest, (locked_land, free_land)| {
            rest.without(locked_land, free_land)
        })
}

/// The greatest gap of the pairs of lands in `curves`.
#[cold]
pub(super) fn land_on_land(
    locked: &PlacedHalf,
    free: &PlacedHalf,
    origin: Origin,
    curves: CurvePairs,
) -> Option<CandidateContact> {
    LANDS
        .into_iter()
        .filter(|&(locked_land, free_land)| {
            curves.has(locked_land, free_land) && locked.has(locked_land) && free.has(free_land)
        })
        .filter_map(|lands| greatest(locked, free, lands, origin))
        .reduce(greater)
}

/// Offers the greatest gap of the pairs of lands in `curves`, step by step.
pub(super) fn offer_lands(
    posed: &PosedFlanks,
    curves: CurvePairs,
    tightest_contacts: &mut TightestContacts,
) {
    for step in posed.steps() {
        let (locked, free) = (posed.locked(step), posed.free(step));
        if let Some(candidate) = land_on_land(&locked, &free, posed.origin_of(step), curves)
            && tightest_contacts.admits(candidate.gap)
        {
            tightest_contacts.offer(step, candidate);
        }
    }
}

fn greater(one: CandidateContact, other: CandidateContact) -> CandidateContact {
    if other.gap > one.gap { other } else { one }
}

fn greatest(
    locked: &PlacedHalf,
    free: &PlacedHalf,
    (locked_land, free_land): (ProfilePart, ProfilePart),
    origin: Origin,
) -> Option<CandidateContact> {
    let candidate = |t: f64, u: f64| {
        CandidateContact::new(
            (locked, (locked_land, t)),
            (free, (free_land, u)),
            origin,
            0.0,
        )
    };
    let ends = |placed: &PlacedHalf, curve: ProfilePart| {
        let (low, high) = placed.range(curve);
        [low, high].map(|t| (t, placed.at(curve, t).point.norm()))
    };
    let locked_ends = ends(locked, locked_land)
        .into_iter()
        .filter_map(|(t, rho)| Some(candidate(t, on_land(free, free_land, rho)?)));
    let free_ends = ends(free, free_land)
        .into_iter()
        .filter_map(|(u, rho)| Some(candidate(on_land(locked, locked_land, rho)?, u)));
    let first_contact = tangents(locked, free, (locked_land, free_land))
        .into_iter()
        .flatten()
        .map(|(t, u)| candidate(t, u));
    locked_ends
        .chain(free_ends)
        .chain(first_contact)
        .reduce(greater)
}

/// Parameters on both lands where the circles touch.
fn tangents(
    locked: &PlacedHalf,
    free: &PlacedHalf,
    (on_locked, on_free): (ProfilePart, ProfilePart),
) -> [Option<(f64, f64)>; 2] {
    let (locked_centre, free_centre) = (locked.centre, free.centre);
    let radius = locked.shape.radius(on_locked, 0.0);
    let sum = radius + free.shape.radius(on_free, 0.0);
    let (far, off) = (locked_centre.norm(), free_centre.norm());
    // (|C| − S)(|C| + S): no difference of large squares.
    let cos = ((far - sum) * (far + sum) + off * off) / (2.0 * far * off);
    if !(cos.abs() <= 1.0) {
        return [None; 2];
    }
    let on = |placed: &PlacedHalf, curve: ProfilePart, centre: C, point: C| {
        let t = -((point - centre) * placed.direction.conj()).arg();
        let (low, high) = placed.range(curve);
        (low..=high).contains(&t).then_some(t)
    };
    [cos.acos(), -cos.acos()].map(|beside| {
        let rotation = (locked_centre * free_centre.conj()).arg() + beside;
        let centre = free_centre * turn(rotation);
        let point = locked_centre + (centre - locked_centre) * (radius / sum);
        let back = point * turn(-rotation);
        let on_locked = on(locked, on_locked, locked_centre, point)?;
        Some((on_locked, on(free, on_free, free_centre, back)?))
    })
}
