//! The bounds of the arcs of a node, each compared with the curves.

use super::*;
use crate::contact::gap::turn;
use crate::gear::{Gear, GearDesign, PartCurve, Profile, ProfilePart};

fn gear(teeth: u32) -> Gear {
    Gear::nominal(GearDesign::plain(teeth, 2.0)).unwrap()
}

/// A curve away from the axis of its radii: of a free gear displaced by `centre`, or of a locked one there.
fn placed(curve: &PartCurve, centre: C, direction: C) -> PlacedCurve<'_> {
    PlacedCurve {
        curve,
        mirrored: false,
        centre,
        direction,
    }
}

/// `dσ/d ln ρ` at a parameter, by a difference.
fn change_of_slope(placed: &PlacedCurve, t: f64) -> f64 {
    const STEP: f64 = 1e-5;
    let [one, other] = [t - STEP, t + STEP].map(|t| placed.at(t));
    (slope(&other) - slope(&one)) / (length(other.point) / length(one.point)).ln()
}

/// Bounds of the change of slope hold at every place of an arc, and approach it as the arc shrinks. Flanks and fillets of free and locked
/// gears; the fillet of the undercut one overhangs, with `ψ` = 0. Source: differences of the curve's own slope.
#[test]
fn the_change_of_slope_lies_within_its_bounds() {
    let (mut seen, mut through_zero) = ([[0; 2]; 2], 0);
    for teeth in [9, 40] {
        let gear = gear(teeth);
        let profile = Profile::new(&gear);
        for (k, part) in [ProfilePart::Involute, ProfilePart::Fillet]
            .into_iter()
            .enumerate()
        {
            let (from, to) = profile.part(part).range();
            let curve = &profile.part(part).curve;
            // A free gear displaced by 0.3 mm, and a locked one whose centre is further away.
            for (free, centre, direction) in [
                (1, C::new(0.2, 0.22), turn(0.3)),
                (0, C::new(f64::from(teeth) + 30.0, 0.4), turn(3.1)),
            ] {
                let placed = placed(curve, centre, direction);
                for parts in [20, 400] {
                    let length = (to - from) / f64::from(parts);
                    for part in 0..parts {
                        let low = from + length * f64::from(part);
                        let arc = Arc::new(placed, 0, low, low + length);
                        let Some((least, most)) = arc.slope_change(arc.radii.0, arc.radii.1) else {
                            continue;
                        };
                        let here: Vec<f64> = [0.1, 0.5, 0.9]
                            .map(|share| change_of_slope(&placed, low + share * length))
                            .into();
                        for change in &here {
                            let case = format!("{teeth} {part:?} {free}: {least} {change} {most}");
                            let off = 1e-6 * change.abs().max(1.0);
                            assert!(least <= change + off && *change <= most + off, "{case}");
                        }
                        if parts == 400 {
                            // First order of all parts of the bounds: the turn of the arc, and the length of its radii.
                            let (low, high, _) = arc.slope.unwrap();
                            let wide = (high - low) * (1.0 + here[1].abs())
                                / high.abs().max(low.abs()).cos().powi(4);
                            let case =
                                format!("{teeth} {part:?} {free}: {least} {here:?} {most} {wide}");
                            assert!(most - least <= 8.0 * wide, "{case}");
                            through_zero += i32::from(low < 0.0 && high > 0.0);
                            seen[k][free] += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(
        seen.iter().flatten().all(|seen| *seen > 100) && through_zero > 0,
        "{seen:?} {through_zero}"
    );
}

/// Two flanks that touch between their ends: the gap at the summit is that of the best of 2000 radii, within rounding.
/// A monotone gap is greatest at an end. Source: the gap radius by radius.
#[test]
fn the_summit_is_where_the_gap_is_greatest() {
    let gears = [gear(40), gear(23)];
    let [one, other] = gears.each_ref().map(Profile::new);
    let [locked, free] = [&one, &other].map(|profile| profile.part(ProfilePart::Involute));
    let mut at = [0; 3];
    for k in -24..=24 {
        let angle = PI + 0.02 * f64::from(k);
        let locked_curve = placed(&locked.curve, C::new(63.0, 0.0), turn(angle));
        let free_curve = placed(&free.curve, C::new(0.05, 0.03), C::ONE);
        let [one, other] = [(locked_curve, locked), (free_curve, free)].map(|(placed, part)| {
            let (low, high) = part.range();
            Arc::new(placed, 0, low, high)
        });
        // Where both are monotone: the whole free flank, and the part of the locked one that the free gear reaches.
        let monotone =
            |arc: &Arc| arc.placed.at(arc.low).point.norm() > arc.placed.at(arc.high).point.norm();
        assert!(monotone(&one) && !monotone(&other));
        let ends = |arc: &Arc| {
            let [a, b] = [arc.low, arc.high].map(|t| length(arc.placed.at(t).point));
            (a.min(b), a.max(b))
        };
        let (a, b) = (ends(&one), ends(&other));
        let (inner, outer) = (a.0.max(b.0), a.1.min(b.1));
        if inner >= outer {
            continue;
        }
        let arcs = [(&one, a), (&other, b)].map(|(arc, radii)| Arc { radii, ..*arc });
        let steps = Cell::new(0);
        let gap = |rho: f64| {
            let p = arcs[0]
                .placed
                .at(arcs[0].at_radius(rho, false, &steps))
                .point;
            let q = arcs[1]
                .placed
                .at(arcs[1].at_radius(rho, true, &steps))
                .point;
            (p * q.conj()).arg()
        };
        let best = (0..=2000)
            .map(|k| gap(inner + (outer - inner) * f64::from(k) / 2000.0))
            .fold(f64::MIN, f64::max);
        let (rho, slack) = summit(&arcs[0], &arcs[1], (false, true), (inner, outer), &steps);
        assert!(gap(rho) >= best - 1e-14, "{k}: {rho} {} {best}", gap(rho));
        assert!((0.0..=1e-15).contains(&slack), "{k}: {slack}");
        let place = if rho == inner {
            0
        } else if rho == outer {
            2
        } else {
            1
        };
        at[place] += 1;
    }
    assert!(at.iter().all(|count| *count > 0), "{at:?}");
}
