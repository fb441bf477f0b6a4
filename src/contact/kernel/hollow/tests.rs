//! Hollow curves and their mates, compared with points and with each other.

use super::*;
use crate::gear::{Gear, GearDesign, ProfilePart};
use std::cell::Cell;

/// A fillet of 30 teeth whose gear is locked, at the angle 0, with a mate whose own centre is at `centre`. The free axis is where the
/// mate has a long lever about it.
fn facing(normal: C, centre: C) -> FacingHalves<'static> {
    let shift = -normal * C::i() * 50.0;
    FacingHalves {
        centres: [shift, shift + centre],
        angles: [0.0, 0.0],
        directions: [C::ONE; 2],
        play: f64::INFINITY,
        radius: 100.0,
        margin: 1e-14,
        tried: Box::leak(Box::new(Cell::new(0))),
    }
}

fn is_off(at: &FacingHalves, hollow: &Hollow, mate: &Convex) -> bool {
    is_off_hollow(at, (0, hollow), (mate, C::ONE), &mut |_, _| ())
}

/// A disc of this radius, or a corner.
fn round(radius: f64) -> Convex<'static> {
    if radius > 0.0 {
        Convex::arc(radius, -PI, PI)
    } else {
        Convex::Chord([C::ZERO; 2])
    }
}

/// Fillets of ordinary and of shifted teeth, whose tools' tip radii have their centres inside and outside the pitch line.
fn fillets() -> impl Iterator<Item = Hollow> {
    [(9, 0.0), (30, 0.0), (30, 1.1), (60, 1.3), (100, 1.0)]
        .into_iter()
        .map(|(teeth, shift)| {
            let design = GearDesign {
                profile_shift: shift,
                ..GearDesign::plain(teeth, 2.0)
            };
            let gear = Gear::nominal(design).unwrap();
            let radius = gear.basic_data().reference_radius();
            Hollow::new(gear.part(ProfilePart::Fillet), radius, false)
        })
}

/// Source: points of the stretch, 400 of each.
#[test]
fn a_stretch_reaches_no_further_than_its_bound() {
    for hollow in fillets() {
        for stretch in &hollow.stretches {
            let [low, high] = stretch.ends;
            let at = |k: u32| hollow.curve.at(low + (high - low) * f64::from(k) / 400.0);
            let points: Vec<C> = (0..=400).map(|k| at(k).0).collect();
            for k in 0..90 {
                let n = turn(0.003 + PI * f64::from(k) / 45.0);
                let farthest = points.iter().map(|p| dot(*p, n)).fold(f64::MIN, f64::max);
                let least = points.iter().map(|p| along(*p, n)).fold(f64::MAX, f64::min);
                let (reach, lever) = stretch.bound(n);
                assert!(reach >= farthest - 1e-12 && lever <= least + 1e-12, "{k}");
                // Both ends reach as far as any point of a hollow stretch towards the mate.
                let is_towards = stretch.normals.iter().all(|normal| dot(n, *normal) > 0.0);
                let is_exact = reach - farthest < 1e-12;
                assert!(!is_towards || stretch.radii.is_none() || is_exact, "{k}");
            }
        }
    }
}

/// Source: differences of points and normals. A curve that bulges somewhere has no radii.
#[test]
fn radii_are_those_of_differences() {
    let mut known = 0;
    for hollow in fillets() {
        for stretch in &hollow.stretches {
            let [low, high] = stretch.ends;
            let radius = |k: u32| {
                let t = low + (high - low) * (0.5 + f64::from(k)) / 50.0;
                let step = 1e-3 * (high - low);
                let [(p, n), (q, m)] = [t - step, t + step].map(|t| hollow.curve.at(t));
                (q - p).norm() / along(n, m)
            };
            let all: Vec<f64> = (0..50).map(radius).collect();
            let is_hollow =
                all.iter().all(|radius| *radius < 0.0) || all.iter().all(|radius| *radius > 0.0);
            let Some([least, most]) = stretch.radii else {
                continue;
            };
            known += 1;
            assert!(is_hollow);
            let all = all.iter().map(|radius| radius.abs());
            let found = [
                all.clone().fold(f64::MAX, f64::min),
                all.fold(0.0, f64::max),
            ];
            let is_within = least <= found[0] * (1.0 + 1e-5) && most >= found[1] * (1.0 - 1e-5);
            assert!(
                is_within && least > 0.3 * found[0] && most < 3.0 * found[1],
                "{found:?}, {least} {most}"
            );
        }
    }
    assert!(known > 15, "{known}");
}

/// Where the tangents of a stretch hold together, each holds. Source: single tangents, 100 of each stretch; free axes in all directions.
#[test]
fn tangents_of_a_stretch_hold_each() {
    let mut held = 0;
    for hollow in fillets() {
        for stretch in &hollow.stretches {
            let (point, normal) = hollow.curve.at(0.5 * (stretch.ends[0] + stretch.ends[1]));
            for k in 0..60 {
                let shift = turn(0.003 + PI * f64::from(k) / 30.0) * f64::from(1 + k % 7);
                for (disc, gap) in [(0.0, 1e-6), (0.0, 0.01), (0.1, 1e-6), (0.1, 0.01)] {
                    let mate = round(disc);
                    let centre = point + normal * (disc + gap);
                    for owner in 0..2 {
                        let mut centres = [shift; 2];
                        centres[1 - owner] += centre;
                        let at = FacingHalves {
                            centres,
                            ..facing(normal, centre)
                        };
                        if !is_off_tangents(&at, (owner, &hollow), stretch, &mate) {
                            continue;
                        }
                        held += 1;
                        let [low, high] = stretch.ends;
                        for k in 0..=100 {
                            let t = low + (high - low) * f64::from(k) / 100.0;
                            let off = off_tangent(&at, owner, hollow.curve.at(t), &mate);
                            assert!(at.stays_apart(off.room, off.arm), "{k}: {off:?}");
                        }
                    }
                }
            }
        }
    }
    assert!(held > 300, "{held}");
}

/// Discs and corners that are 1e-12 mm off a fillet are proven off it, those that overlap it by as much are not, at any place. Source:
/// the curve's own points and normals, and its radius of curvature by differences.
#[test]
fn a_fillet_and_a_touching_mate_are_distinguished() {
    let gear = Gear::nominal(GearDesign::plain(30, 2.0)).unwrap();
    let part = gear.part(ProfilePart::Fillet);
    let hollow = Hollow::new(part, gear.basic_data().reference_radius(), false);
    let (low, high) = part.range();
    // The free axis is where the mate has a lever in all directions of the fillet.
    let (_, middle) = hollow.curve.at(0.5 * (low + high));
    let mut tried = 0;
    for k in 1..40 {
        let t = low + (high - low) * f64::from(k) / 40.0;
        let (point, normal) = hollow.curve.at(t);
        let [(p, n), (q, m)] = [t - 1e-6, t + 1e-6].map(|t| hollow.curve.at(t));
        let radius = (q - p).norm() / along(n, m).abs();
        for share in [0.0, 0.3, 0.9] {
            let disc = share * radius;
            let points = (0..=2000).map(|k| {
                hollow
                    .curve
                    .at(low + (high - low) * f64::from(k) / 2000.0)
                    .0
            });
            let distances = points.map(|p| (p - point - normal * disc).norm());
            if distances.fold(f64::MAX, f64::min) < disc - 1e-9 {
                // Nearer to the root the fillet is too narrow for this disc.
                continue;
            }
            tried += 1;
            for (gap, expected) in [(1e-12, true), (-1e-12, false)] {
                let there = facing(middle, point + normal * (disc + gap));
                let found = is_off(&there, &hollow, &round(disc));
                assert_eq!(found, expected, "{k} {share} {gap}");
            }
        }
        // A disc behind the fillet that reaches through it is not off it, whatever its direction.
        let behind = FacingHalves {
            play: 1e-12,
            ..facing(middle, point - normal * 0.299)
        };
        assert!(!is_off(&behind, &hollow, &round(0.3)), "{k}");
        // A disc rounder than the fillet overlaps it on both sides of its touch.
        let there = facing(middle, point + normal * (1.2 * radius));
        let inside = k > 4 && k < 36;
        assert!(
            !inside || !is_off(&there, &hollow, &round(1.2 * radius)),
            "{k}"
        );
    }
    assert!(tried > 60, "{tried}");
}

/// Points of the curve in a stretch, and their normals, at the position of gear `k`.
fn sampled(at: &FacingHalves, k: usize, hollow: &Hollow, [low, high]: [f64; 2]) -> Vec<(C, C)> {
    let place = |i: u32| {
        let (point, normal) = hollow.curve.at(low + (high - low) * f64::from(i) / 40.0);
        (
            at.centres[k] + at.directions[k] * point,
            at.directions[k] * normal,
        )
    };
    (0..=40).map(place).collect()
}

/// Whether `proof` of a stretch of gear `owner` holds for points of both pieces, the owner's with normals.
fn holds_for(owner: usize, own: &[(C, C)], mate: &[C], proof: Apart) -> bool {
    let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    let own_points: Vec<C> = own.iter().map(|(point, _)| *point).collect();
    let (locked, free) = match owner {
        0 => (&own_points[..], mate),
        _ => (mate, &own_points[..]),
    };
    let n = proof.normal;
    let room = match proof.by {
        Reason::Direction => {
            least(&mut free.iter().map(|p| dot(*p, n)))
                + least(&mut locked.iter().map(|p| -dot(*p, n)))
        }
        Reason::OutOfReach => {
            least(&mut locked.iter().map(|p| -dot(*p, n)))
                + least(&mut free.iter().map(|p| -p.norm()))
        }
        Reason::LockedTangents | Reason::FreeTangents => least(
            &mut own
                .iter()
                .flat_map(|(p, n)| mate.iter().map(move |q| dot(*q - *p, *n))),
        ),
    };
    room > -1e-12
}

/// The gear whose tangents prove it.
fn tangents_of(proof: Apart) -> Option<usize> {
    [Reason::LockedTangents, Reason::FreeTangents]
        .into_iter()
        .position(|by| by == proof.by)
}

/// Proofs of stretches hold for the curves themselves, with both gears turned. The mate is a chord or another fillet. Source: 41 points and
/// normals of each stretch.
#[test]
fn proofs_of_stretches_hold_for_their_curves() {
    let fillets: Vec<Hollow> = fillets().collect();
    let mut compared = [[0; 2]; 2];
    for k in 0..4000u32 {
        let part = |step: u32| f64::from((k * step + 11 * (k % 89) * k) % 97) / 97.0;
        let [a, b] = [17, 31].map(|step| &fillets[(part(step) * 4.99) as usize]);
        let place = |hollow: &Hollow, at: f64| {
            let [low, high] = hollow.whole.ends;
            hollow.curve.at(low + (high - low) * at)
        };
        let ((p, n), (q, m)) = (place(a, part(41)), place(b, part(53)));
        let first = turn(6.0 * part(61));
        let out = first * n;
        let second = -out * m.conj() * turn(1.5 * part(71) - 0.75);
        // The free axis is where the mate has a long lever about it.
        let shift = -out * C::i() * 50.0;
        let gap = [1e-6, 0.01, 0.2, 1.0][(k % 4) as usize];
        for owner in 0..2 {
            let mut centres = [shift; 2];
            let mut directions = [first; 2];
            centres[1 - owner] += first * p + out * gap - second * q;
            directions[1 - owner] = second;
            let at = FacingHalves {
                centres,
                angles: directions.map(C::arg),
                directions,
                play: 1e-3,
                ..facing(n, q)
            };
            let facing = out_of_locked(&at, owner, n);
            let chord = [q, q + m * turn(1.3 * part(83) - 2.0) * 0.3];
            let ends = chord.map(|end| centres[1 - owner] + second * end);
            let mut check = |both: bool, own: &[(C, C)], mate: &[C], by, proof: Apart| {
                let case = format!("{k} {owner} {both}: {proof:?}");
                assert!(holds_for(by, own, mate, proof), "{case}");
                let is_tangents = tangents_of(proof).is_some();
                compared[usize::from(both)][usize::from(is_tangents)] += 1;
            };
            let mate = (&Convex::Chord(chord), facing);
            is_off_hollow(&at, (owner, a), mate, &mut |ends_of, proof| {
                check(false, &sampled(&at, owner, a, ends_of), &ends, owner, proof);
            });
            let hollows = if owner == 0 { [a, b] } else { [b, a] };
            is_off_both(&at, (hollows, facing.arg()), &mut |ends_of, proof| {
                let points = [0, 1].map(|k| sampled(&at, k, hollows[k], ends_of[k]));
                let by = tangents_of(proof).unwrap_or(0);
                let mate: Vec<C> = points[1 - by].iter().map(|(point, _)| *point).collect();
                check(true, &points[by], &mate, by, proof);
            });
        }
    }
    assert!(
        compared.iter().flatten().all(|count| *count > 100),
        "{compared:?}"
    );
}

/// The bound of a room over a stretch of directions, compared with samples of a function with the same second derivative.
#[test]
fn no_room_is_less_than_the_least() {
    for (room, slope, m) in [
        (0.1, 0.3, 2.0),
        (1e-9, 1e-6, 0.5),
        (0.2, -0.5, -0.3),
        (2.0, 0.1, 1.0),
    ] {
        let w = 0.4;
        let at = |x: f64| m + (room - m) * x.cos() + slope * x.sin();
        let sampled = (-1000..=1000)
            .map(|k| at(w * f64::from(k) / 1000.0))
            .fold(f64::MAX, f64::min);
        let least = least_room(room, slope, m, w);
        assert!(
            least <= sampled + 1e-15 && sampled - least < 1e-6 * (1.0 + m.abs()),
            "{room} {slope} {m}: {least}, {sampled}"
        );
    }
}
