//! Tip land on tip land, in closed form: two arcs, one of which turns about an axis off its centre.
//!
//! Along both lands the gap has its greatest value where an arc ends (a corner of one land on the other land), or
//! where the circles touch. With `C` the centre of the locked arc, `E` that of the free one at rotation 0, and `S` the sum of
//! their radii, the circles touch at the rotation `μ` for which `|C − E e^{iμ}| = S`:
//!
//! ```text
//! cos(arg C − arg E − μ) = (|C|² + |E|² − S²)/(2 |C| |E|).
//! ```
//!
//! (Where an arc's radius about the axis turns, the gap goes on along the arc: no extremum.) A search would take the
//! longest here: a free land runs so nearly round the axis that its polar slope bounds nothing.

use super::corner::on_land;
use super::hit::Hit;
use super::placed::Placed;
use super::shape::{C, turn};
use crate::gear::Curve::Tip;

/// The greatest gap of two lands.
#[cold]
pub(super) fn land_on_land(locked: &Placed, free: &Placed, origin: C) -> Option<Hit> {
    let hit = |ours: f64, theirs: f64| {
        Hit::new((locked, (Tip, ours)), (free, (Tip, theirs)), origin, 0.0)
    };
    let radius = |placed: &Placed, t: f64| placed.at(Tip, t).point.norm();
    let ends = |placed: &Placed| {
        let (far, near) = placed.range(Tip);
        [far, near]
    };
    let ours = ends(locked)
        .into_iter()
        .filter_map(|t| Some(hit(t, on_land(free, radius(locked, t))?)));
    let theirs = ends(free)
        .into_iter()
        .filter_map(|t| Some(hit(on_land(locked, radius(free, t))?, t)));
    let touching = tangents(locked, free)
        .into_iter()
        .flatten()
        .map(|(ours, theirs)| hit(ours, theirs));
    ours.chain(theirs)
        .chain(touching)
        .reduce(|a, b| if b.gap > a.gap { b } else { a })
}

/// Parameters on both lands where the circles touch.
fn tangents(locked: &Placed, free: &Placed) -> [Option<(f64, f64)>; 2] {
    let (ours, theirs) = (locked.centre, free.centre);
    let radius = locked.shape.tip_radius;
    let sum = radius + free.shape.tip_radius;
    let (far, off) = (ours.norm(), theirs.norm());
    // (|C| − S)(|C| + S): no difference of large squares.
    let cos = ((far - sum) * (far + sum) + off * off) / (2.0 * far * off);
    if !(cos.abs() <= 1.0) {
        return [None; 2];
    }
    let on = |placed: &Placed, centre: C, point: C| {
        let t = -((point - centre) * placed.direction.conj()).arg();
        let (low, high) = placed.range(Tip);
        (low..=high).contains(&t).then_some(t)
    };
    [cos.acos(), -cos.acos()].map(|beside| {
        let rotation = (ours * theirs.conj()).arg() + beside;
        let centre = theirs * turn(rotation);
        let point = ours + (centre - ours) * (radius / sum);
        let back = point * turn(-rotation);
        Some((on(locked, ours, point)?, on(free, theirs, back)?))
    })
}
