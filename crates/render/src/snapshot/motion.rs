//! Motion of a picture over a pitch: SMIL elements.

use crate::kit::sheet::{Spot, number};
use svg::node::element::{Animate, AnimateTransform};

/// How long a pitch takes.
const DURATION: &str = "6s";

/// Turns about `axis`, a place of the sheet.
pub fn rotation(turns: &[f64], axis: Spot) -> AnimateTransform {
    // y is down on the sheet: clockwise is positive there.
    let [x, y] = axis.map(number);
    let value =
        |turn: &f64| format!("{:.4} {x} {y}", -turn.to_degrees()).replace("-0.0000 ", "0.0000 ");
    let values: Vec<String> = turns.iter().map(value).collect();
    AnimateTransform::new()
        .set("attributeName", "transform")
        .set("type", "rotate")
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.join(";"))
}

/// Values and key times of one coordinate; where other teeth take over, both places at one time.
pub fn course(spots: &[(Spot, [u32; 2])], axis: usize) -> [String; 2] {
    let last = (spots.len() - 1) as f64;
    let (mut values, mut times) = (Vec::new(), Vec::new());
    for (step, (spot, teeth)) in spots.iter().enumerate() {
        let time = format!("{:.5}", step as f64 / last);
        if step > 0 && spots[step - 1].1 != *teeth {
            values.push(number(spots[step - 1].0[axis]));
            times.push(time.clone());
        }
        values.push(number(spot[axis]));
        times.push(time);
    }
    [values.join(";"), times.join(";")]
}

/// Moves one coordinate along its course.
pub fn motion(attribute: &str, [values, times]: &[String; 2]) -> Animate {
    Animate::new()
        .set("attributeName", attribute)
        .set("dur", DURATION)
        .set("repeatCount", "indefinite")
        .set("values", values.as_str())
        .set("keyTimes", times.as_str())
}
