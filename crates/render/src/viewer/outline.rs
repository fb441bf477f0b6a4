//! A gear's outline as path data about its axis, tooth 1 turned to its mate.

use super::precision::Precision;
use gearlash::gear::Placed;
use std::fmt::Write;

/// The whole outline, displaced by its eccentricity: relative path data in units of the last decimal.
///
/// Whole numbers stay whole: browsers add up single-precision numbers, and theirs hold 24 bits.
pub fn path(gear: &Placed, precision: Precision) -> String {
    // A disc about the axis, no smaller than the gear, holds its centre: all teeth.
    let reach = gear.as_built().reach();
    let mut data = String::new();
    let mut last: Option<[i64; 2]> = None;
    for point in gear.outline_near(gear.axis(), reach, precision.chord) {
        let [x, y] = [point.x, point.y].map(|value| precision.units(value));
        let _ = match last {
            None => write!(data, "M{x} {y}l"),
            Some(before) if before == [x, y] => Ok(()),
            Some([left, low]) => {
                let [dx, dy] = [x - left, y - low];
                // A minus sign parts two numbers as well as a space.
                let apart = if data.ends_with('l') || dx < 0 {
                    ""
                } else {
                    " "
                };
                let between = if dy < 0 { "" } else { " " };
                write!(data, "{apart}{dx}{between}{dy}")
            }
        };
        last = Some([x, y]);
    }
    data.push('z');
    data
}
