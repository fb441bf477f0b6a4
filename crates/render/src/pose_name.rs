//! How a pose is called: alike in pictures, charts and pages.

use gearlash::pair::Mating;
use gearlash_files::numbers::trimmed;

/// Decimals of a pitch: enough to give a pose to `snapshot` again.
const DECIMALS: usize = 6;

/// Teeth, flank and the part of a pitch that the gears are turned beyond it.
pub(crate) fn pose_name(mating: &Mating) -> String {
    format!(
        "wheel {} with pinion {} at the {} flank{}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name(),
        beyond(mating.fraction)
    )
}

/// The part of a pitch; nothing where there is none.
fn beyond(fraction: f64) -> String {
    let amount = trimmed(fraction.abs(), 0, DECIMALS);
    match amount.as_str() {
        "0" => String::new(),
        _ if fraction > 0.0 => format!(", {amount} pitch beyond"),
        _ => format!(", {amount} pitch before"),
    }
}
