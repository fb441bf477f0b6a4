//! Discs and ends of pairs, compared with points of their teeth.

use super::super::proof::Reason;
use super::*;
use crate::contact::gap::dot;
use crate::pair::Mating;
use std::f64::consts::PI;

/// Source: points of the free tooth at 720 rotations.
#[test]
fn a_disc_holds_its_tooth_at_every_rotation() {
    let pair = GearPair::plain([17, 23], [0.3; 2], 40.2, Member::Wheel);
    let kernel = ExactKernel::new(&pair);
    let prover = Prover::new(&pair, &kernel);
    let pose = Pose::new(&pair, Mating::FIRST);
    let found = kernel.lost_motion(&pose).unwrap();
    let mut compared = 0;
    let checked = prover.over(&pose, &found, |section, here, _| {
        let posed = section.posed(section.side(Side::Right), here);
        let tried = Cell::new(0);
        let proving = SideProver::new(&prover, &posed, section.free(), &found, &tried);
        for step in posed.steps_of_whole_teeth() {
            let pair = proving.pair(step, 0.0, C::ONE);
            let [_, free] = &pair.placed;
            let parts = [ProfilePart::Tip, ProfilePart::Involute];
            let points = parts.into_iter().flat_map(|part| {
                let (low, high) = free.range(part);
                (0..=40).map(move |k| {
                    let at = low + (high - low) * f64::from(k) / 40.0;
                    free.centre + free.direction * free.shape.at(part, at).point
                })
            });
            let points: Vec<C> = points.collect();
            for n in [1.0, 2.5, 4.0].map(turn) {
                let supports = pair.at.supports(&pair.tops[0], &pair.tops[1], n.arg(), n);
                let apart = Apart {
                    by: Reason::OutOfReach,
                    normal: n,
                };
                let along = EndsAlong::new(&pair, apart, supports);
                let turns = (0..720).map(|k| turn(PI / 360.0 * f64::from(k)));
                let starts =
                    turns.flat_map(|turned| points.iter().map(move |p| dot(turned * p, n)));
                let off = starts.fold(f64::INFINITY, f64::min) - along.top.at;
                assert!((-1e-12..1e-3).contains(&off), "{step}: {off:e}");
                compared += 1;
            }
        }
        Ok(())
    });
    checked.unwrap();
    assert!(compared > 5, "{compared}");
}
