//! Names of poses, equal in pictures, charts and pages.

use gearlash::gear::Side;
use gearlash::pair::Mating;
use gearlash_text::numbers::trimmed;

/// Decimals of a pitch: enough to reproduce a pose with `snapshot`.
const DECIMALS: usize = 6;

/// Teeth, flank and the fraction of a pitch beyond it.
pub(crate) fn pose_name(mating: &Mating) -> String {
    format!(
        "wheel {} with pinion {} at the {} flank{}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name(),
        fraction_words(mating.fraction)
    )
}

/// The flanks at the start of a title.
pub(crate) fn flank_heading(side: Side) -> &'static str {
    match side {
        Side::Right => "Right",
        Side::Left => "Left",
    }
}

/// The phase of a run, as a suffix; empty without one.
pub(crate) fn phase_name(phase: Option<(u32, u32)>) -> String {
    phase.map_or(String::new(), |(wheel, pinion)| {
        format!(", phase {wheel}·{pinion}")
    })
}

/// The fraction of a pitch; empty for 0.
fn fraction_words(fraction: f64) -> String {
    let amount = trimmed(fraction.abs(), 0, DECIMALS);
    match amount.as_str() {
        "0" => String::new(),
        _ if fraction > 0.0 => format!(", {amount} pitch beyond"),
        _ => format!(", {amount} pitch before"),
    }
}
