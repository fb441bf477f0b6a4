//! Spans and pins on a gear by its outline: anvils and pins brought to the curves as drawn.
//!
//! Nothing is guessed: there is no form circle, so the anvils reach down to a stated share of the depth, and what touches the tip or the root
//! says so. Readings have the meaning of those of a gear by its data ([`super::Spans`], [`super::Pins`]).

mod place;
mod seat;
mod span;

use super::Unmeasured;
use super::pins::{OverPins, over};
use super::spread::{ends, mean};
use crate::contact::Touch;
use crate::outline::OutlineGear;
use nalgebra::Point2;

/// One span on an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineSpan {
    /// First of the teeth spanned, in ascending numbers.
    pub first_tooth: u32,
    /// Distance of the anvils, mm.
    pub length: f64,
    /// Bound on its error, mm: what the search left, and twice how far the outline may lie from what was drawn.
    pub error: f64,
    /// Where the anvils touched: the first tooth's own left flank, the last one's own right flank.
    pub touched: [Touch; 2],
}

/// Spans at every first tooth of an outline.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineSpans {
    /// `k`.
    pub teeth: u32,
    /// By first tooth, from tooth 1.
    pub readings: Vec<OutlineSpan>,
}

/// A pin at rest in a space of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineSeat {
    /// The space after this tooth, towards the next number.
    pub tooth: u32,
    /// The pin's centre, mm, about the geometric centre; tooth 1 stands on +x.
    pub centre: Point2<f64>,
    /// Bound on the error of the centre, mm.
    pub error: f64,
    /// What it touches: own right flank of `tooth`, own left flank of the next.
    pub touched: [Touch; 2],
}

/// Pins in every space of an outline.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlinePins {
    /// Pin diameter, mm.
    pub diameter: f64,
    /// The pins where they lie, by the tooth before the space.
    pub seats: Vec<OutlineSeat>,
    /// As [`super::Pins::two`].
    pub two: Vec<OverPins>,
    /// As [`super::Pins::three`].
    pub three: Vec<OverPins>,
}

/// What was asked for of an outline. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OutlineGauged {
    /// Spans.
    pub spans: Option<Result<OutlineSpans, Unmeasured>>,
    /// Over pins.
    pub pins: Option<Result<OutlinePins, Unmeasured>>,
}

impl OutlineSpans {
    /// Mean span, mm.
    pub fn mean(&self) -> f64 {
        mean(self.readings.iter().map(|span| span.length))
    }

    /// Least and greatest span, mm.
    pub fn ends(&self) -> [f64; 2] {
        ends(self.readings.iter().map(|span| span.length))
    }
}

/// Measures spans over `span_teeth` teeth and over pins of the diameter `pin`, mm (> 0), on `gear`: those that are given.
///
/// ```
/// # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
/// use gearlash::gauge::gauge_outline;
/// use gearlash::outline::OutlineGear;
///
/// # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
/// let outline = OutlineGear::from(&AsBuilt::perfect(gear, Face::Front));
/// let spans = gauge_outline(&outline, Some(3), None).spans.ok_or("not asked for")??;
/// // As of the gear by its data, ISO 21771.
/// let alpha = 20f64.to_radians();
/// let span = 2.0 * alpha.cos() * (2.5 * std::f64::consts::PI + 20.0 * (alpha.tan() - alpha));
/// assert!((spans.mean() - span).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gauge_outline(
    gear: &OutlineGear,
    span_teeth: Option<u32>,
    pin: Option<f64>,
) -> OutlineGauged {
    OutlineGauged {
        spans: span_teeth.map(|k| span::spans(gear, k)),
        pins: pin.map(|diameter| pins(gear, diameter)),
    }
}

fn pins(gear: &OutlineGear, diameter: f64) -> Result<OutlinePins, Unmeasured> {
    let seats = seat::seats(gear, diameter)?;
    let at = |tooth: u32| {
        let seat = &seats[tooth as usize - 1];
        (seat.centre, seat.error)
    };
    let (two, three) = over(gear.teeth(), diameter, place::rounding(gear), at);
    Ok(OutlinePins {
        diameter,
        two,
        three,
        seats,
    })
}

/// The tooth `steps` ascending numbers after `tooth`.
fn after(gear: &OutlineGear, tooth: u32, steps: u32) -> u32 {
    (tooth - 1 + steps) % gear.teeth() + 1
}
