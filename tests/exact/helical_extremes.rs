//! Proven extremes of helical pairs against poses of the exact method over the same face, which know nothing of their bounds.

use crate::extremes::cycle::{FIRST, matings, spread};
use crate::helical::{Draws, drawn, pair_of_the_prototype};
use gearlash::contact::{Doubt, ExactKernel, Extremes};
use gearlash::gear::Hand;
use gearlash::pair::GearPair;

/// What a bracket may be wide, mm.
const WIDTH: f64 = 1e-6;

/// Values of one pose are known to 1e-10 mm at the very worst (rounding).
const ROUNDING: f64 = 1e-10;

/// The extremes of `pair`, after `count` poses of its cycle were found within them.
fn held(pair: &GearPair, count: u32) -> Extremes {
    let kernel = ExactKernel::new(pair);
    let found = kernel.extremes(pair, FIRST, matings(pair), WIDTH).unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    for pose in spread(pair, count) {
        let Some(angle) = kernel.lost_motion(&pose).unwrap().angle() else {
            continue;
        };
        let j = angle * radius;
        if let Some(least) = found.least.filter(|e| e.low.is_finite()) {
            assert!(j >= least.low - ROUNDING, "{j} below {least:?}");
        }
        if let Some(most) = found
            .greatest
            .filter(|one| one.is_proven() || one.doubt == Some(Doubt::Effort))
        {
            assert!(j <= most.high + ROUNDING, "{j} above {most:?}");
        }
    }
    found
}

/// The prototype's pair, of six curves of pitch each: proven both ways at any width, and the least no greater of the wider.
#[test]
fn ordinary_helical_pairs_are_proven_and_hold() {
    for seed in 0..6 {
        let mut last = [f64::INFINITY; 2];
        for width in [0.0, 1.0, 12.5, 25.0, 50.0, 100.0] {
            let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, seed);
            let pair = pair.with_face([-0.5 * width, 0.5 * width]).unwrap();
            let found = held(&pair, 300);
            let ends = [found.least, found.greatest].map(Option::unwrap);
            for (end, last) in ends.iter().zip(&mut last) {
                assert!(end.is_proven() && end.high - end.low <= WIDTH + ROUNDING);
                assert!(end.low <= *last + WIDTH, "{width} {seed}: {end:?} {last}");
                *last = end.low;
            }
        }
    }
}

/// Pairs from far beyond any shop, tips on fillets among them: most are proven, and what is not says so.
#[test]
fn helical_pairs_hold_or_are_doubted() {
    let mut rng = Draws(9);
    let (mut proven, mut brackets) = (0, 0);
    for _ in 0..60 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        let found = held(&pair, 150);
        for end in [found.least, found.greatest].into_iter().flatten() {
            proven += u32::from(end.is_proven());
            brackets += 1;
        }
    }
    println!("{proven} of {brackets} proven");
    assert!(proven * 4 > brackets * 3, "{proven} of {brackets}");
}
