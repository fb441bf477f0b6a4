//! One-dimensional numerics: bisection, false position, golden section, angles within one turn, mean and range, divisors and multiples.
//!
//! A search returns its bracket. The caller takes the end that is on the safe side.

use std::borrow::Borrow;
use std::convert::Infallible;
use std::f64::consts::TAU;

/// Golden section: the part of a bracket that one step keeps, `(√5 − 1)/2`.
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Arithmetic mean; 0 without values.
pub(crate) fn mean<V: Borrow<f64>>(values: impl IntoIterator<Item = V>) -> f64 {
    let mut count = 0_u32;
    let counted = values.into_iter().inspect(|_| count += 1);
    let sum: f64 = counted.map(|value| *value.borrow()).sum();
    sum / f64::from(count.max(1))
}

/// Least and greatest; infinities without values.
pub(crate) fn ends<V: Borrow<f64>>(values: impl IntoIterator<Item = V>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.into_iter().fold(none, |[least, most], value| {
        [least.min(*value.borrow()), most.max(*value.borrow())]
    })
}

/// Greatest less least; 0 without values.
pub(crate) fn range<V: Borrow<f64>>(values: impl IntoIterator<Item = V>) -> f64 {
    let [least, most] = ends(values);
    (most - least).max(0.0)
}

/// The greatest common divisor; the other number if one is 0.
pub(crate) fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The least common multiple; 0 if a number is 0.
pub(crate) fn lcm(a: u32, b: u32) -> u64 {
    u64::from(a / gcd(a, b).max(1)) * u64::from(b)
}

/// Halves the bracket `[inside, outside]` of a place where `holds` changes from true to false.
///
/// The bracket returned has the order of the given one, which may fall. It is at most `width` wide, or its ends are
/// neighbouring numbers. A `width` of 0 bisects to the last bit.
pub(crate) fn bisect(
    inside: f64,
    outside: f64,
    width: f64,
    mut holds: impl FnMut(f64) -> bool,
) -> [f64; 2] {
    let bracket = try_bisect(inside, outside, width, |x| Ok::<_, Infallible>(holds(x)));
    match bracket {
        Ok(bracket) => bracket,
        Err(never) => match never {},
    }
}

/// [`bisect`] with a predicate that can fail.
///
/// # Errors
/// The first error of `holds`.
pub(crate) fn try_bisect<E>(
    mut inside: f64,
    mut outside: f64,
    width: f64,
    mut holds: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    while (outside - inside).abs() > width {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            break;
        }
        if holds(middle)? {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Ok([inside, outside])
}

/// The bracket that [`bisect`] finds where `excess` is smooth and turns from negative to positive once, with fewer evaluations.
///
/// False position finds the root to some roundings. Halvings beside it need no evaluation.
pub(crate) fn bisect_smooth(
    inside: f64,
    outside: f64,
    width: f64,
    excess: impl Fn(f64) -> f64,
) -> [f64; 2] {
    let way = (outside - inside).signum();
    let mut known = [inside, outside];
    let mut see = |x: f64| {
        let value = excess(x);
        let side = usize::from(!(value < 0.0));
        if [(x - known[0]) * way, (known[1] - x) * way][side] > 0.0 {
            known[side] = x;
        }
        value
    };
    let ends = [inside, outside].map(|x| (x, see(x)));
    // Some roundings of the greater value.
    let root = root_beyond(ends, 4.0 * f64::EPSILON * ends[1].1, &mut see);
    for times in [-16.0, 16.0] {
        see(root + times * f64::EPSILON * root.abs());
    }
    bisect(inside, outside, width, |x| {
        let is_inside = (x - known[0]) * way <= 0.0;
        is_inside || ((known[1] - x) * way > 0.0 && excess(x) < 0.0)
    })
}

/// Steps of [`root_beyond`]: a smooth function needs three or four.
const MOST_STEPS: u32 = 12;

/// A place where `of` is from 0 to `fine`, or a greater value after [`MOST_STEPS`]. The given places have their values: the first is negative, the
/// second is not. By false position, with half of a value that stays twice (Illinois).
pub(crate) fn root_beyond(
    [mut below, mut beyond]: [(f64, f64); 2],
    fine: f64,
    mut of: impl FnMut(f64) -> f64,
) -> f64 {
    let (mut reached, mut was_beyond) = (beyond.1, None);
    for _ in 0..MOST_STEPS {
        if reached <= fine {
            break;
        }
        let next = below.0 + (beyond.0 - below.0) * below.1 / (below.1 - beyond.1);
        let value = of(next);
        let is_beyond = value >= 0.0;
        let stays_twice = was_beyond.replace(is_beyond) == Some(is_beyond);
        let (moves, stays) = if is_beyond {
            reached = value;
            (&mut beyond, &mut below)
        } else {
            (&mut below, &mut beyond)
        };
        *moves = (next, value);
        if stays_twice {
            stays.1 *= 0.5;
        }
    }
    beyond.0
}

/// The greatest value seen by a golden section of `[low, high]`, where `value` has one maximum, and the last bracket.
///
/// The bracket is at most `width` wide.
pub(crate) fn golden_section(
    mut low: f64,
    mut high: f64,
    width: f64,
    value: impl Fn(f64) -> f64,
) -> (f64, [f64; 2]) {
    let mut left = high - GOLDEN * (high - low);
    let mut right = low + GOLDEN * (high - low);
    let (mut at_left, mut at_right) = (value(left), value(right));
    while high - low > width {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = value(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = value(right);
        }
    }
    (at_left.max(at_right), [low, high])
}

/// `angle` less whole turns, in [−π, π].
pub(crate) fn wrap_angle(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// A whole number for each number, in the order of `f64::total_cmp`: the key of sorts.
///
/// `sort_by` is compiled for each type of elements, 5 kB each. Sorts by `u64` keys share one.
pub(crate) fn rank(number: f64) -> u64 {
    const SIGN: u64 = 1 << 63;
    match number.to_bits() {
        positive @ ..SIGN => positive | SIGN,
        negative => !negative,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

    /// Closed forms: √2, from either side; the sine is greatest at π/2.
    #[test]
    fn searches_bracket_a_root_and_a_maximum() {
        let [low, high] = bisect(1.0, 2.0, 0.0, |x| x * x < 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && low.next_up() == high);
        assert!((high - SQRT_2).abs() <= f64::EPSILON);
        let [high, low] = bisect(2.0, 1.0, 1e-3, |x| x * x >= 2.0);
        assert!(low < SQRT_2 && SQRT_2 <= high && high - low <= 1e-3);
        let (greatest, [low, high]) = golden_section(1.0, 2.0, 1e-6, f64::sin);
        assert!((greatest - 1.0).abs() < 1e-12 && high - low <= 1e-6);
        assert!(low - 1e-7 <= FRAC_PI_2 && FRAC_PI_2 <= high + 1e-7);
    }

    /// Source: plain bisection.
    #[test]
    fn bisection_of_a_smooth_function_finds_the_same_bracket() {
        let curves: [&dyn Fn(f64) -> f64; 4] = [
            &|x| x * x - 2.0,
            &|x| x.powi(9) - 3.0,
            &|x| 1.0 - 2.0 / x,
            &|x| (x - 1.5).signum(),
        ];
        for (k, curve) in curves.into_iter().enumerate() {
            let count = std::cell::Cell::new(0);
            let counted = |x| {
                count.set(count.get() + 1);
                curve(x)
            };
            for width in [1e-3, 1e-9, 0.0] {
                let plain = bisect(1.0, 2.5, width, |x| curve(x) < 0.0);
                assert_eq!(
                    bisect_smooth(1.0, 2.5, width, counted),
                    plain,
                    "{k} {width}"
                );
            }
            let falling = |x: f64| -curve(x);
            let plain = bisect(2.5, 1.0, 1e-9, |x| falling(x) < 0.0);
            assert_eq!(bisect_smooth(2.5, 1.0, 1e-9, falling), plain, "{k}");
            assert!(k > 0 || count.get() < 60, "{}", count.get());
        }
    }

    /// Roots in closed form: of x² − 2, of −x³ towards smaller places, and of a step, which has none.
    #[test]
    fn false_position_ends_just_beyond_a_root() {
        let curve = |x: f64| x * x - 2.0;
        let root = root_beyond([(0.0, -2.0), (2.0, 2.0)], 1e-6, curve);
        assert!((0.0..=1e-6).contains(&curve(root)));
        let root = root_beyond([(3.0, -27.0), (-1.0, 1.0)], 1e-3, |x| -x.powi(3));
        assert!((-0.1..=0.0).contains(&root));
        let step = |x: f64| if x < 0.3 { -1.0 } else { 1.0 };
        let place = root_beyond([(0.0, -1.0), (1.0, 1.0)], 1e-3, step);
        assert!((0.3..0.31).contains(&place), "{place}");
    }

    #[test]
    fn an_error_ends_the_bisection() {
        let mut count = 0;
        let found = try_bisect(0.0, 1.0, 0.0, |_| {
            count += 1;
            if count < 3 { Ok(true) } else { Err(count) }
        });
        assert_eq!(found, Err(3));
    }

    #[test]
    fn ranks_of_numbers_have_their_total_order() {
        let numbers = [
            -f64::NAN,
            f64::NEG_INFINITY,
            -2.0,
            -1.5,
            -0.0,
            0.0,
            1e-310,
            1.0,
            f64::INFINITY,
            f64::NAN,
        ];
        assert!(numbers.is_sorted_by(|one, other| one.total_cmp(other).is_lt()));
        assert!(numbers.is_sorted_by(|one, other| rank(*one) < rank(*other)));
    }

    #[test]
    fn angles_wrap_to_half_a_turn() {
        assert!((wrap_angle(1.5 * PI) + FRAC_PI_2).abs() < 1e-15);
        assert!((wrap_angle(-5.5 * PI) - FRAC_PI_2).abs() < 1e-14);
        assert_eq!(wrap_angle(0.25), 0.25);
    }
}
