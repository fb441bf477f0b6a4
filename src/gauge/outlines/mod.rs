//! Spans and pins on a gear given by its outline: anvils and pins touch the curves as drawn.
//!
//! There is no form circle, so the anvils reach down to a stated share of the depth, and a contact at tip or root is
//! reported. Readings mean the same as those of a gear by its data ([`super::Spans`], [`super::Pins`]).

mod place;
mod seat;
mod span;

use super::pins::{Pins, over};
use super::{Formula, Gauged, Unmeasured};
use crate::outline::OutlineGear;

/// Measures spans over `span_teeth` teeth and over pins of the diameter `pin`, mm (> 0), on `gear`. Other gauges need an involute.
///
/// ```
/// # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
/// use gearlash::gauge::gauge_outline;
/// use gearlash::outline::OutlineGear;
///
/// # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
/// let outline = OutlineGear::from(&AsBuilt::perfect(gear, Face::Front));
/// let spans = gauge_outline(&outline, Some(3), None).spans?;
/// // As of the gear by its data, ISO 21771.
/// let alpha = 20f64.to_radians();
/// let span = 2.0 * alpha.cos() * (2.5 * std::f64::consts::PI + 20.0 * (alpha.tan() - alpha));
/// assert!((spans.mean() - span).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gauge_outline(gear: &OutlineGear, span_teeth: Option<u32>, pin: Option<f64>) -> Gauged {
    let no_involute = || Unmeasured("an outline has no involute".to_owned());
    let not_asked = |what: &str| Unmeasured(format!("no {what} is given"));
    Gauged {
        spans: span_teeth.map_or(Err(not_asked("number of teeth")), |k| span::spans(gear, k)),
        pins: pin.map_or(Err(not_asked("diameter")), |diameter| pins(gear, diameter)),
        runout: Err(no_involute()),
        pitch_own: Err(no_involute()),
        pitch_datum: Err(no_involute()),
        thickness: Err(no_involute()),
        profile: Err(no_involute()),
        along_face: None,
        eccentricity: Err(no_involute()),
        roll: Err(no_involute()),
        root: Err(no_involute()),
        stated: Err(no_involute()),
        grades: Err(no_involute()),
        formula: Formula::default(),
    }
}

fn pins(gear: &OutlineGear, diameter: f64) -> Result<Pins, Unmeasured> {
    let seats = seat::seats(gear, diameter)?;
    let at = |tooth: u32| {
        let seat = &seats[tooth as usize - 1];
        (seat.centre, seat.error)
    };
    let (two, three) = over(gear.teeth(), diameter, place::rounding(gear), at);
    Ok(Pins {
        diameter,
        two,
        three,
        lying: Vec::new(),
        seats,
    })
}
