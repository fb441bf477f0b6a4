//! Dimensions over pins between displaced flanks, found by rolling both flanks until one circle touches both.

use super::random_pair::case;
use super::spans::drawing;
use super::*;
use gearlash::gear::{Face, thickness};
use nalgebra::{Complex, Matrix2, Vector2};
use proptest::prelude::*;

/// The centre of the circle of `radius` between two involutes of the base circle `base`. One starts at the angle `low` and winds
/// back, the other starts at `high` and winds on. Points are `r_b e^{i(o ∓ ξ)}(1 ± iξ)`, normals along the base tangent. Newton
/// in both rolls.
pub(super) fn centre(base: f64, low: f64, high: f64, radius: f64) -> Complex<f64> {
    let beside = |origin: f64, sense: f64, roll: f64| {
        let tangent = Complex::from_polar(base, origin - sense * roll);
        tangent * Complex::new(1.0, sense * (roll + radius / base))
    };
    let mut rolls = Vector2::new(0.4, 0.4);
    for _ in 0..60 {
        let gap = |u: f64, v: f64| {
            let separation = beside(low, 1.0, u) - beside(high, -1.0, v);
            Vector2::new(separation.re, separation.im)
        };
        let h = 1e-6;
        let (at, u, v) = (gap(rolls.x, rolls.y), rolls.x, rolls.y);
        let by_u = (gap(u + h, v) - gap(u - h, v)) / (2.0 * h);
        let by_v = (gap(u, v + h) - gap(u, v - h)) / (2.0 * h);
        rolls -= Matrix2::from_columns(&[by_u, by_v]).try_inverse().unwrap() * at;
    }
    (beside(low, 1.0, rolls.x) + beside(high, -1.0, rolls.y)) / Complex::new(2.0, 0.0)
}

/// The dimension over pins at each space: in the space after tooth i and in the one z/2 (rounded down) beyond it.
fn over_pins(gear: &AsBuilt, pin: f64) -> Vec<f64> {
    let basic_data = gear.gear().basic_data();
    let (z, base) = (basic_data.teeth(), gear.gear().base_radius());
    let sign = gear.face().ascending();
    let centre_of = |space: u32| {
        let next = space % z + 1;
        // Counted along ascending numbers; the flanks at the ascending end of a tooth are own right ones.
        let (ahead, behind) = match gear.face() {
            Face::Front => (Side::Right, Side::Left),
            Face::Back => (Side::Left, Side::Right),
        };
        let middle = f64::from(space - 1) * basic_data.angular_pitch();
        let low = middle + sign * place(gear, ahead, space) / base;
        let high = middle + basic_data.angular_pitch() + sign * place(gear, behind, next) / base;
        centre(base, low, high, pin / 2.0)
    };
    (1..=z)
        .map(|space| (centre_of(space) - centre_of((space - 1 + z / 2) % z + 1)).norm() + pin)
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn pins_all_round_give_the_mean_thickness_back(case in case(), few in 1usize..10) {
        let recipe = &case.wheel;
        let gear = recipe.build(1.0).unwrap();
        let pin = 1.75 * 2.0;
        prop_assume!(thickness::check_pins(gear.gear(), pin).is_ok());
        let per_tooth: Vec<f64> = recipe.per_tooth_um.iter().map(|row| row[0]).collect();
        let mut over = over_pins(&gear, pin);
        let keys = |list: &[f64], space: &str| format!(
            "{}thickness = {{ per_tooth_um = {per_tooth:?}, over_pins = {{ pin_mm = {pin}, mm = {list:?}{space} }} }}",
            drawing(recipe)
        );
        let study = pair(&keys(&over, ""));
        let base = |study: &PairFile| wheel(study).gear().base_thickness();
        prop_assert!((base(&study) - gear.gear().base_thickness()).abs() < 1e-9);
        prop_assert!(study.warnings.iter().any(|w| w.contains("no thickness by tooth")));
        // A few of them, in any order.
        let spaces: Vec<u32> = (1..=few as u32).rev().collect();
        over.truncate(few);
        over.reverse();
        let study = pair(&keys(&over, &format!(", space = {spaces:?}")));
        prop_assert!((base(&study) - gear.gear().base_thickness()).abs() < 1e-9);
    }
}
