//! The limits and the rows of a map of poses, compared with the meaning of each limit.

use super::*;
use gearlash::analysis::diagnosis::{MAP_ROWS, map};

/// How far along the line of action the mate's tip comes from the base circle of `gear`, mm, at a centre distance.
fn tip_from_base(pair: &GearPair, gear: Member, distance: f64) -> f64 {
    let [own, mate] = [gear, gear.mate()].map(|member| pair.gear(member).gear());
    let sum = own.base_radius() + mate.base_radius();
    let line = (distance * distance - sum * sum).sqrt();
    line - (mate.tip_radius().powi(2) - mate.base_radius().powi(2)).sqrt()
}

/// At the limits a tip is on the form circle, or on the base circle, of one gear and outside that of the other. Tips have the named
/// clearance from one gear's roots, and more from the other's. The rows cover all limits plus a 20th of a module, but not tips in roots.
#[test]
fn limits_of_a_map_have_their_meaning() {
    for (distance, high) in [
        (132.3, [(0.01, 1.0), (0.02, 3.0)]),
        (112.9, [(0.0, 1.0), (0.02, 3.0)]),
    ] {
        let pinion = if distance > 120.0 { 44 } else { 31 };
        let pair = eccentric(distance, high, pinion);
        let found = diagnosed(&Study::of_pair("map", &pair, 1));
        let on = || ControlFlow::Continue(());
        let map = map(&found.groups[0], mating(1, 1), &on).unwrap();
        let at = |name: &str| {
            let mut all = map.limits.iter().filter(|limit| limit.name == name);
            let one = all.next().map(|limit| limit.distance);
            assert!(all.next().is_none());
            one
        };
        assert_eq!(at("a of the pair"), Some(distance));
        let zero = found.groups[0].zero.clone().unwrap().unwrap();
        assert_eq!(at("zero backlash, outlines"), Some(zero.distance));
        let base = at("tip at base circle, K (8)").unwrap();
        let form = at("tip at form circle").unwrap();
        let from = |member: Member, distance: f64| {
            let gear = pair.gear(member).gear();
            let own = (gear.form_radius().powi(2) - gear.base_radius().powi(2)).sqrt();
            tip_from_base(&pair, member, distance) - own
        };
        let least = Member::BOTH
            .map(|member| from(member, form))
            .into_iter()
            .fold(f64::MAX, f64::min);
        assert!(least.abs() < 1e-9, "{least}");
        let each = Member::BOTH.map(|member| tip_from_base(&pair, member, base));
        let least = each.into_iter().fold(f64::MAX, f64::min);
        assert!(least.abs() < 1e-9, "{least}");
        let clearance = |distance: f64| {
            let each = Member::BOTH.map(|member| {
                let (tip, root) = (pair.gear(member).gear(), pair.gear(member.mate()).gear());
                distance - tip.tip_radius() - root.root_radius()
            });
            each[0].min(each[1])
        };
        for modules in [limits::LEAST_CLEARANCE, limits::RECOMMENDED_CLEARANCE] {
            let at = at(&format!("radial clearance {modules} m")).unwrap();
            assert!((clearance(at) - 3.0 * modules).abs() < 1e-9, "{modules}");
        }
        let sum = pair.gear(Member::Wheel).gear().base_radius()
            + pair.gear(Member::Pinion).gear().base_radius();
        assert!(
            map.limits
                .windows(2)
                .all(|pair| pair[0].distance <= pair[1].distance)
        );
        assert!(map.limits.iter().all(|limit| limit.distance > sum));
        // Rows are the middles of as many stretches.
        assert_eq!(map.distances.len(), MAP_ROWS as usize);
        let step = map.distances[1] - map.distances[0];
        let (low, high) = (
            map.distances[0] - 0.5 * step,
            map.distances[MAP_ROWS as usize - 1] + 0.5 * step,
        );
        let [first, last] =
            [map.limits.first(), map.limits.last()].map(|limit| limit.unwrap().distance);
        let jam = distance - clearance(distance);
        assert!(
            (low - (first.max(jam) - 0.15)).abs() < 1e-9,
            "{low} {first} {jam}"
        );
        assert!((high - (last + 0.15)).abs() < 1e-9, "{high} {last}");
        let even = map
            .fractions
            .iter()
            .zip(0..)
            .all(|(fraction, k)| (fraction - f64::from(k) / 60.0).abs() < 1e-15);
        assert!(even && map.fractions.len() == 60);
    }
}
