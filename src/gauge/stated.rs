//! The tooth thickness that a gear file states for these readings.
//!
//! `[thickness]` states the mean thickness, which alone determines pose, root and fillet. Thickness by tooth is added
//! flank by flank, and its mean is kept. The flanks cannot distinguish the two: teeth of −20 µm with −40 µm on every
//! one have the same spans as teeth of −60 µm. The root can: the tool was fed for the mean thickness, so the radius of
//! the root circle contains `x_E`. The thickness that matches the root is the mean; a further offset of all flanks is
//! stated tooth by tooth. The variation from tooth to tooth is in the pitch of both flanks.

use super::flanks::{PitchReadings, ThicknessReadings};
use super::root::RootReading;
use super::span::Spans;
use super::{Summary, Unmeasured};
use crate::gear::{AsBuilt, Gear, thickness as formula};

/// The thickness in a gear file. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum StatedThickness {
    /// The measured spans; no tooth differs from the thickness by the root.
    Spans,
    /// `A_sn`, in the normal section at the reference circle, and an additional thickness of every tooth.
    Allowance {
        /// Allowance of the mean thickness.
        allowance: f64,
        /// Mean of the thickness by tooth; 0 within the error of the readings.
        per_tooth: f64,
        /// Whether the spans can confirm it when the file is read.
        cross_check: bool,
    },
}

/// The thickness of `gear` for a gear file, or the reason why none can state it.
///
/// Spans are stated only if reading the file gives the same spans: `k` must have its contact on the involute of a gear of that thickness.
/// An allowance is that of the involutes, without the contribution of `as_built`'s profiles at the reference circle.
pub(super) fn stated(
    as_built: &AsBuilt,
    spans: &Result<Spans, Unmeasured>,
    thickness: &Result<ThicknessReadings, Unmeasured>,
    pitch: &Result<PitchReadings, Unmeasured>,
    root: &Result<RootReading, Unmeasured>,
) -> Result<StatedThickness, Unmeasured> {
    let gear = as_built.gear();
    if let Err(reason) = pitch {
        return Err(reason.clone());
    }
    let (design, basic_data) = (gear.design(), gear.basic_data());
    let nominal = design.nominal_base_thickness();
    let cos = basic_data.pressure_angle().cos();
    // Base thickness by the flanks.
    // Anvils on helical teeth touch beside the measuring plane, where leads add to the thickness.
    let has_leads = as_built.has_leads() && basic_data.hand().is_some();
    let spans = spans.as_ref().ok().filter(|_| !has_leads);
    let by_spans = |spans: &Spans| {
        let Summary { mean, error, .. } = spans.summary();
        let base = formula::base_from_span(basic_data, spans.teeth, mean);
        (base, error / cos)
    };
    let (base, error) = match (thickness, spans) {
        (Ok(arcs), _) => {
            // A gear file states the normal section.
            let allowance =
                (arcs.summary().mean - as_built.arc_of_profiles() - arcs.nominal) * arcs.normal;
            let base = formula::base_from_allowance(basic_data, nominal, allowance);
            (base, arcs.error)
        }
        (Err(_), Some(spans)) => by_spans(spans),
        (Err(reason), None) => return Err(reason.clone()),
    };
    let allowance = formula::allowance_from_base(basic_data, nominal, base);
    // Thickness by the root, if it is visible.
    let beyond = root.as_ref().map_or(0.0, |root| {
        let beyond = allowance - (root.thickness - design.nominal_thickness());
        if beyond.abs() <= error + root.thickness_error {
            0.0
        } else {
            beyond
        }
    });
    let readable = |base, spans: &Spans| {
        let gear = Gear::new(*design, base);
        let checked = gear.and_then(|gear| formula::check_span(&gear, spans.teeth));
        checked.is_ok()
    };
    if spans.is_some_and(|spans| beyond == 0.0 && readable(by_spans(spans).0, spans)) {
        return Ok(StatedThickness::Spans);
    }
    let allowance = allowance - beyond;
    let base = formula::base_from_allowance(basic_data, nominal, allowance);
    Gear::new(*design, base).map_err(|error| Unmeasured(error.to_string()))?;
    Ok(StatedThickness::Allowance {
        allowance,
        per_tooth: beyond,
        cross_check: spans.is_some_and(|spans| readable(base, spans)),
    })
}
