//! Spans predicted from the places of the flanks give these places back.

use super::random_pair::{Recipe, case};
use super::*;
use gearlash::gear::{Face, thickness};
use proptest::prelude::*;
use std::fmt::Write;

/// The span at each tooth: along the base tangent from the first tooth's flank that looks to lower
/// numbers to the last tooth's flank that looks to higher ones. Seen from the front, numbers ascend
/// clockwise on a front face: there the first flank is a left one.
fn spans(gear: &AsBuilt, k: u32) -> Vec<f64> {
    let basic_data = gear.gear().basic_data();
    let z = basic_data.teeth();
    let separation = f64::from(k - 1) * basic_data.base_pitch();
    (1..=z)
        .map(|first| {
            let last = (first + k - 2) % z + 1;
            let (left, right) = match gear.face() {
                Face::Front => (first, last),
                Face::Back => (last, first),
            };
            separation + place(gear, Side::Left, left) - place(gear, Side::Right, right)
        })
        .collect()
}

/// The recipe's drawing and pitch, for a pair file.
pub(super) fn drawing(recipe: &Recipe) -> String {
    let column = |n: usize| -> Vec<f64> { recipe.per_tooth_um.iter().map(|row| row[n]).collect() };
    let face = ["back", "front"][usize::from(recipe.face == Face::Front)];
    format!(
        "teeth = {}\nmodule_mm = 2.0\nprofile_shift = {:?}\nreference_face = {face:?}\n\
         pitch = {{ kind = \"cumulative\", right_um = {:?}, left_um = {:?} }}\n",
        recipe.teeth,
        recipe.shift,
        column(1),
        column(2),
    )
}

fn check_same(found: &AsBuilt, expected: &AsBuilt, bound: f64) {
    for side in Side::BOTH {
        for tooth in 1..=expected.gear().basic_data().teeth() {
            let separation = place(found, side, tooth) - place(expected, side, tooth);
            let is_met = separation.abs() < bound;
            assert!(is_met, "{side:?} {tooth}: {separation} mm");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn spans_all_round_give_every_flank_back(case in case(), by in 0u32..100) {
        let recipe = &case.wheel;
        let gear = recipe.build(1.0).unwrap();
        let z = recipe.teeth;
        // No thickness alternates along the steps of k − 1 when z/gcd(z, k − 1) is odd.
        let odd = |k: u32| (1..=z).find(|n| (n * (k - 1)).is_multiple_of(z)).unwrap() % 2 == 1;
        let k = (1..=z).find(|&k| odd(k) && thickness::check_span(gear.gear(), k).is_ok());
        prop_assume!(k.is_some());
        let k = k.unwrap();
        let spans = spans(&gear, k);
        let study = pair(&format!("{}thickness.span = {{ teeth = {k}, mm = {spans:?}, per_tooth = true }}", drawing(recipe)));
        check_same(wheel(&study), &gear, 1e-9);
        prop_assert_eq!(study.study.materials.len(), 1);
        prop_assert_eq!(study.study.materials[0].0.name(), "as-measured");

        // Teeth renumbered: the same gear, renumbered. Order of the readings does not matter.
        let by = by % z;
        let first: Vec<u32> = (1..=z).map(|tooth| recipe.renumber(tooth, by)).collect();
        let turned = recipe.renumbered(by);
        let again = pair(&format!(
            "{}thickness.span = {{ teeth = {k}, mm = {spans:?}, first_tooth = {first:?}, per_tooth = true }}",
            drawing(&turned)
        ));
        check_same(wheel(&again), &turned.build(1.0).unwrap(), 1e-9);
    }

    /// Some of the spans, the deviations known: the mean thickness is that of the gear.
    #[test]
    fn some_spans_give_the_mean_thickness(case in case(), some in proptest::collection::vec(any::<bool>(), 90)) {
        let recipe = &case.wheel;
        let gear = recipe.build(1.0).unwrap();
        let k = (2..=recipe.teeth).find(|&k| thickness::check_span(gear.gear(), k).is_ok());
        prop_assume!(k.is_some());
        let k = k.unwrap();
        let spans = spans(&gear, k);
        let chosen: Vec<u32> = (1..=recipe.teeth).filter(|tooth| some[*tooth as usize - 1]).collect();
        prop_assume!(!chosen.is_empty() && chosen.len() < recipe.teeth as usize);
        let per_tooth: Vec<f64> = recipe.per_tooth_um.iter().map(|row| row[0]).collect();
        let mut table = "tooth;span\r\n".to_owned();
        for tooth in chosen.iter().rev() {
            write!(table, "{tooth};{}\r\n", spans[*tooth as usize - 1].to_string().replace('.', ",")).unwrap();
        }
        let study = pair_beside(
            &format!(
                "{}thickness = {{ per_tooth_um = {per_tooth:?}, span = {{ teeth = {k}, file = \"spans.csv\", per_tooth = true }} }}",
                drawing(recipe)
            ),
            &table,
        ).unwrap();
        check_same(wheel(&study), &gear, 1e-9);
        prop_assert!(study.warnings.iter().any(|w| w.contains("only the mean thickness is used")));
        prop_assert_eq!(study.study.notes[0].all_round.unwrap().readings, chosen.len());
    }
}

/// z 44, k 6: steps of 5 teeth make one cycle of 44, an even number; over 5 teeth four of 11.
#[test]
fn thickness_that_no_span_shows_is_not_made_up() {
    let spans = |k: u32, mm: f64, rest: &str| {
        pair(&format!(
            "teeth = 44\nmodule_mm = 3\nthickness.span = {{ teeth = {k}, mm = {:?}{rest} }}",
            (1..=44)
                .map(|i| mm + if i == 7 { 0.004 } else { 0.0 })
                .collect::<Vec<f64>>()
        ))
    };
    let six = spans(6, 50.55, "");
    assert!(wheel(&six).flank_offset(Side::Left, 7) == 0.0);
    assert_eq!(six.study.notes[0].all_round.unwrap().amplification, None);
    assert_eq!(six.warnings.len(), 1, "{:?}", six.warnings);
    let words = "spans over 5 teeth would";
    assert!(six.warnings[0].contains(words), "{:?}", six.warnings);

    // By hand: one reading 4 µm up raises teeth of its cycle by ±4 µm/cos α, all others by none, about the mean of 4/44 µm.
    let five = spans(5, 41.69, "");
    let amplification = five.study.notes[0].all_round.unwrap().amplification;
    assert_eq!(amplification, Some(11));
    let words = "up to 11-fold, 3.3-fold when random";
    assert!(five.warnings[0].contains(words), "{:?}", five.warnings);
    let base = 41.69 + 0.004 / 44.0 - 4.0 * 3.0 * std::f64::consts::PI * 20f64.to_radians().cos();
    assert!((wheel(&five).gear().base_thickness() - base).abs() < 1e-12);
    for tooth in 1..=44u32 {
        // Backwards from 7 in steps of 4: +, −, +, …
        let steps = (0..11).find(|n| (tooth + 4 * n) % 44 == 7);
        let up = steps.map_or(0.0, |n| if n % 2 == 0 { 4.0 } else { -4.0 });
        let expected = (up - 4.0 / 44.0) / 20f64.to_radians().cos() / 2.0;
        let found = 66_000.0 * wheel(&five).flank_offset(Side::Left, tooth);
        let is_near = (found - expected).abs() < 1e-8;
        assert!(is_near, "{tooth}: {found} {expected}");
    }
    let mean_only = spans(5, 41.69, ", per_tooth = false");
    assert!(wheel(&mean_only).flank_offset(Side::Left, 7) == 0.0);
    assert_eq!(mean_only.warnings, [""; 0]);
}
