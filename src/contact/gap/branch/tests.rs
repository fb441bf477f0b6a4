//! The bounds of the arcs of a node, each compared with the curves.

use super::*;
use crate::contact::gap::turn;
use crate::gear::{GearDesign, PartCurve, Profile, ProfilePart};

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
    let (mut seen, mut through_zero) = ([0; 2], 0);
    for (teeth, part) in [9, 40]
        .into_iter()
        .flat_map(|teeth| [ProfilePart::Involute, ProfilePart::Fillet].map(|part| (teeth, part)))
    {
        let gear = GearDesign::plain(teeth, 2.0).gear();
        let profile = Profile::new(&gear);
        let (from, to) = profile.part(part).range();
        // A free gear displaced by 0.3 mm, and a locked one whose centre is further away.
        for (free, centre, direction) in [
            (1, C::new(0.2, 0.22), turn(0.3)),
            (0, C::new(f64::from(teeth) + 30.0, 0.4), turn(3.1)),
        ] {
            let placed = placed(&profile.part(part).curve, centre, direction);
            for (parts, k) in [20, 400]
                .into_iter()
                .flat_map(|parts| (0..parts).map(move |k| (parts, k)))
            {
                let length = (to - from) / f64::from(parts);
                let low = from + length * f64::from(k);
                let arc = CurveArc::new(placed, 0, low, low + length);
                let Some((least, most)) = arc.slope_change(arc.radii.0, arc.radii.1) else {
                    continue;
                };
                let here = [0.1, 0.5, 0.9].map(|at| change_of_slope(&placed, low + at * length));
                let case = format!("{teeth} {part:?} {free}: {least} {here:?} {most}");
                for change in here {
                    let off = 1e-6 * change.abs().max(1.0);
                    assert!(least <= change + off && change <= most + off, "{case}");
                }
                if parts == 400 {
                    // First order of all parts of the bounds: the turn of the arc, and the length of its radii.
                    let (low, high, _) = arc.slope.unwrap();
                    let wide = (high - low) * (1.0 + here[1].abs())
                        / high.abs().max(low.abs()).cos().powi(4);
                    assert!(most - least <= 8.0 * wide, "{case} {wide}");
                    through_zero += i32::from(low < 0.0 && high > 0.0);
                    seen[free] += 1;
                }
            }
        }
    }
    assert!(
        seen.iter().all(|seen| *seen > 400) && through_zero > 0,
        "{seen:?} {through_zero}"
    );
}

/// Two flanks that touch between their ends: the gap at the summit is that of the best of 2000 radii, within rounding.
/// A monotone gap is greatest at an end. Source: the gap radius by radius.
#[test]
fn the_summit_is_where_the_gap_is_greatest() {
    let gears = [40, 23].map(|teeth| GearDesign::plain(teeth, 2.0).gear());
    let profiles = gears.each_ref().map(Profile::new);
    let [locked, free] = profiles
        .each_ref()
        .map(|profile| profile.part(ProfilePart::Involute));
    let mut at = [0; 3];
    for k in -24..=24 {
        let direction = turn(PI + 0.02 * f64::from(k));
        let curves = [
            placed(&locked.curve, C::new(63.0, 0.0), direction),
            placed(&free.curve, C::new(0.05, 0.03), C::ONE),
        ];
        // Where both are monotone: the whole free flank, and the part of the locked one that the free gear reaches.
        let arcs = [0, 1].map(|which| {
            let (low, high) = [locked, free][which].range();
            let arc = CurveArc::new(curves[which], 0, low, high);
            let ends = [low, high].map(|t| length(curves[which].at(t).point));
            assert_eq!(ends[0] > ends[1], which == 0);
            CurveArc {
                radii: (ends[0].min(ends[1]), ends[0].max(ends[1])),
                ..arc
            }
        });
        let (inner, outer) = (
            arcs[0].radii.0.max(arcs[1].radii.0),
            arcs[0].radii.1.min(arcs[1].radii.1),
        );
        if inner >= outer {
            continue;
        }
        let steps = Cell::new(0);
        let gap = |rho: f64| {
            let [p, q] = [(0, false), (1, true)].map(|(which, rises)| {
                let arc: &CurveArc = &arcs[which];
                arc.placed.at(arc.at_radius(rho, rises, &steps)).point
            });
            (p * q.conj()).arg()
        };
        let best = (0..=2000)
            .map(|k| gap(inner + (outer - inner) * f64::from(k) / 2000.0))
            .fold(f64::MIN, f64::max);
        let (rho, slack) = summit(&arcs[0], &arcs[1], (false, true), (inner, outer), &steps);
        assert!(gap(rho) >= best - 1e-14, "{k}: {rho} {} {best}", gap(rho));
        assert!((0.0..=1e-15).contains(&slack), "{k}: {slack}");
        at[usize::from(rho > inner) + usize::from(rho == outer)] += 1;
    }
    assert!(at.iter().all(|count| *count > 0), "{at:?}");
}
