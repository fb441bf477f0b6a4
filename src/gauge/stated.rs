//! The tooth thickness that a gear file states after the readings.
//!
//! Mean thickness is what `[thickness]` states, and it alone sets pose, root and fillet; per-tooth thickness is added flank
//! by flank, its mean not removed. At the flanks the two cannot be told apart: teeth of −20 µm with −40 µm on every one
//! and teeth of −60 µm have the same spans. The root can tell: the tool was fed for the mean
//! thickness, so the root circle's radius has `x_E` in it. The thickness that goes with the root is the mean;
//! what the flanks are thicker or thinner all round is stated tooth by tooth. How thickness varies from tooth
//! to tooth is in the pitch of both flanks.

use super::Unmeasured;
use super::flanks::{PitchReadings, ThicknessReadings};
use super::root::RootReading;
use super::span::Spans;
use crate::gear::{AsBuilt, Gear, thickness};

/// The thickness as a gear file states it. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum StatedThickness {
    /// The spans as read; no tooth is thicker or thinner than the root says.
    Spans,
    /// `A_sn`, in the normal section at the reference circle, and what every tooth is thicker beside.
    Allowance {
        /// Allowance of the mean thickness.
        allowance: f64,
        /// Mean of the thickness by tooth: 0 where it lies within the error of the readings.
        per_tooth: f64,
        /// Whether a reader of the file can hold the spans against it.
        cross_check: bool,
    },
}

/// The readings a statement may rest on.
pub(super) struct Readings<'a> {
    pub spans: &'a Result<Spans, Unmeasured>,
    pub thickness: &'a Result<ThicknessReadings, Unmeasured>,
    pub pitch: &'a Result<PitchReadings, Unmeasured>,
    pub root: &'a Result<RootReading, Unmeasured>,
}

/// States the thickness of `gear`, or says why no gear file can.
///
/// Spans are stated only where a reader of the file finds the same: `k` whose contact lies on the involute of a
/// gear of that thickness. An allowance is that of the involutes: what the profiles of `as_built` add at the reference circle is no part of it.
pub(super) fn stated(as_built: &AsBuilt, read: &Readings) -> Result<StatedThickness, Unmeasured> {
    let gear = as_built.gear();
    if let Err(reason) = read.pitch {
        return Err(reason.clone());
    }
    let (design, basic_data) = (gear.design(), gear.basic_data());
    let nominal = design.nominal_base_thickness();
    let cos = basic_data.pressure_angle().cos();
    // Base thickness by the flanks.
    let spans = read.spans.as_ref().ok();
    let by_spans = |spans: &Spans| thickness::base_from_span(basic_data, spans.teeth, spans.mean());
    let (base, error) = match (read.thickness, spans) {
        (Ok(arcs), _) => {
            // A gear file states the normal section.
            let allowance = (arcs.mean() - as_built.arc_of_profiles() - arcs.nominal) * arcs.normal;
            let base = thickness::base_from_allowance(basic_data, nominal, allowance);
            (base, arcs.error)
        }
        (Err(_), Some(spans)) => (by_spans(spans), spans.error() / cos),
        (Err(reason), None) => return Err(reason.clone()),
    };
    let allowance = thickness::allowance_from_base(basic_data, nominal, base);
    // Thickness by the root, where it shows.
    let beyond = read.root.as_ref().map_or(0.0, |root| {
        let beyond = allowance - (root.thickness - design.nominal_thickness());
        if beyond.abs() <= error + root.thickness_error {
            0.0
        } else {
            beyond
        }
    });
    let readable = |base, spans: &Spans| {
        let gear = Gear::new(*design, base);
        let checked = gear.and_then(|gear| thickness::check_span(&gear, spans.teeth));
        checked.is_ok()
    };
    if spans.is_some_and(|spans| beyond == 0.0 && readable(by_spans(spans), spans)) {
        return Ok(StatedThickness::Spans);
    }
    let allowance = allowance - beyond;
    let base = thickness::base_from_allowance(basic_data, nominal, allowance);
    Gear::new(*design, base).map_err(|error| Unmeasured(error.to_string()))?;
    Ok(StatedThickness::Allowance {
        allowance,
        per_tooth: beyond,
        cross_check: spans.is_some_and(|spans| readable(base, spans)),
    })
}
