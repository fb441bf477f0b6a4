//! What can go wrong in the library.
//!
//! [`GearError`] is a gear or pair that cannot exist, in the terms of the geometry; [`Error`] is what a calculation ends with.
//! An interfering, jammed or unmeshed pair is a result, never an error.

use crate::outline::OutlineError;
use std::ops::ControlFlow;

/// A gear or a pair that cannot exist. Lengths in mm, angles in radians inside;
/// the messages print mm and degrees.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GearError {
    /// A number outside its range.
    #[error("{what} is {value}, allowed is {allowed}")]
    OutOfRange {
        /// The quantity, in words.
        what: &'static str,
        /// The value given.
        value: f64,
        /// The allowed range, in words.
        allowed: &'static str,
    },
    /// `c_0 < 0`: the tool's two tip rounds overlap.
    #[error(
        "the tool's tip round {root_radius} m does not fit its tooth: at most {most:.6} m with this dedendum and pressure angle"
    )]
    TipRoundTooLarge {
        /// `ρ_fP*` given.
        root_radius: f64,
        /// Greatest `ρ_fP*` that fits, in modules.
        most: f64,
    },
    /// The envelope of the tool's tip round runs back on itself.
    #[error(
        "the fillet this tool generates has a cusp: the profile shift {generating_shift:.4} m lifts the tip round too far above the pitch line"
    )]
    FilletCusp {
        /// `x_E` in modules.
        generating_shift: f64,
    },
    /// Tip thickness ≤ 0.
    #[error(
        "the tooth is pointed at diameter {pointed_diameter_mm:.6} mm, below its tip diameter {tip_diameter_mm:.6} mm"
    )]
    Pointed {
        /// Diameter at which both flanks meet.
        pointed_diameter_mm: f64,
        /// Tip diameter asked for.
        tip_diameter_mm: f64,
    },
    /// Tip circle at or below the root or form circle.
    #[error(
        "nothing is left of the involute: it starts at diameter {form_diameter_mm:.6} mm, the tip diameter is {tip_diameter_mm:.6} mm"
    )]
    NoInvolute {
        /// Root form diameter.
        form_diameter_mm: f64,
        /// Tip diameter.
        tip_diameter_mm: f64,
    },
    /// The teeth are so thick that no root land or space is left.
    #[error("no tooth space is left: base tooth thickness {base_thickness_mm:.6} mm")]
    NoSpace {
        /// `s_b`.
        base_thickness_mm: f64,
    },
    /// Undercut from both sides meets in the middle of the tooth.
    #[error(
        "undercut from both sides meets and cuts the teeth off: base tooth thickness {base_thickness_mm:.6} mm"
    )]
    NoNeck {
        /// `s_b`.
        base_thickness_mm: f64,
    },
    /// A span contact off the involute.
    #[error(
        "a span over {teeth} teeth touches at diameter {contact_diameter_mm:.4} mm, off the involute ({form_diameter_mm:.4} … {tip_diameter_mm:.4} mm)"
    )]
    SpanOffInvolute {
        /// `k`.
        teeth: u32,
        /// Diameter of the symmetric contact.
        contact_diameter_mm: f64,
        /// Root form diameter.
        form_diameter_mm: f64,
        /// Tip diameter.
        tip_diameter_mm: f64,
    },
    /// A pin contact off the involute.
    #[error(
        "a pin of {pin_mm} mm touches at diameter {contact_diameter_mm:.4} mm, off the involute ({form_diameter_mm:.4} … {tip_diameter_mm:.4} mm)"
    )]
    PinOffInvolute {
        /// `D_M`.
        pin_mm: f64,
        /// Diameter of the contact.
        contact_diameter_mm: f64,
        /// Root form diameter.
        form_diameter_mm: f64,
        /// Tip diameter.
        tip_diameter_mm: f64,
    },
    /// A pin that does not stand out of its space.
    #[error(
        "a pin of {pin_mm} mm reaches diameter {pin_top_diameter_mm:.4} mm, below the tip diameter {tip_diameter_mm:.4} mm: it cannot be measured over"
    )]
    PinBelowTip {
        /// `D_M`.
        pin_mm: f64,
        /// Diameter of the pin's outermost points.
        pin_top_diameter_mm: f64,
        /// Tip diameter.
        tip_diameter_mm: f64,
    },
    /// A pin that touches the root before the flanks.
    #[error(
        "a pin of {pin_mm} mm reaches down to diameter {pin_bottom_diameter_mm:.4} mm, into the root circle {root_diameter_mm:.4} mm"
    )]
    PinInRoot {
        /// `D_M`.
        pin_mm: f64,
        /// Diameter of the pin's innermost points.
        pin_bottom_diameter_mm: f64,
        /// Root diameter.
        root_diameter_mm: f64,
    },
    /// No tolerance field of the tooth thickness.
    #[error("no tolerance field of DIN 3967")]
    ThicknessField,
    /// A study that runs exactly its measured rows has no other centre distances.
    #[error("a study without a sweep runs exactly its measured rows, at their centre distances")]
    MeasuredRows,
    /// No tolerance field of a centre distance.
    #[error("no tolerance field of a centre distance")]
    DistanceField,
    /// A profile deviation that no flank can have.
    #[error("the profile deviation is too large: the flank {what}")]
    Profile {
        /// What it makes of the flank.
        what: &'static str,
    },
    /// A list with the wrong number of values.
    #[error("{what} has {found} values, the gear has {teeth} teeth")]
    WrongLength {
        /// The list.
        what: &'static str,
        /// Values given.
        found: usize,
        /// Values needed.
        teeth: u32,
    },
    /// The two gears do not share module, pressure angle or helix angle.
    #[error("{what} differs: wheel {wheel}, pinion {pinion}; a pair shares it")]
    Unequal {
        /// Module, pressure angle or helix angle.
        what: &'static str,
        /// The wheel's.
        wheel: f64,
        /// The pinion's.
        pinion: f64,
    },
    /// `a ≤ r_b1 + r_b2`.
    #[error(
        "the base circles overlap at centre distance {center_distance_mm} mm: it must exceed {least_mm:.6} mm"
    )]
    BaseCirclesOverlap {
        /// `a`.
        center_distance_mm: f64,
        /// `r_b1 + r_b2`.
        least_mm: f64,
    },
    /// Two external helical gears of one hand.
    #[error("both gears are {hand}-handed: teeth of an external pair wind opposite ways")]
    SameHand {
        /// The hand of both.
        hand: &'static str,
    },
    /// A face that is none.
    #[error(
        "the common face runs from {from_mm} to {to_mm} mm: the gears face each other over none"
    )]
    NoCommonFace {
        /// Its near end.
        from_mm: f64,
        /// Its far end.
        to_mm: f64,
    },
    /// A section where the gears do not face each other.
    #[error(
        "at {at_mm} mm the gears do not face each other: the common face runs from {from_mm} to {to_mm} mm"
    )]
    OutsideFace {
        /// Where, mm from the measuring plane.
        at_mm: f64,
        /// Near end of the common face.
        from_mm: f64,
        /// Its far end.
        to_mm: f64,
    },
    /// A tooth number beyond the gear's.
    #[error("the gear has teeth 1 … {teeth}, not {tooth}")]
    NoSuchTooth {
        /// The number given.
        tooth: u32,
        /// How many there are.
        teeth: u32,
    },
    /// Readings all round that no gear has.
    #[error("{0}")]
    Readings(&'static str),
    /// Datum-axis pitch data whose eccentricity cannot be separated.
    #[error("{0}")]
    DatumPitch(&'static str),
}

/// What a calculation ends with when it has no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A pair that cannot be assembled.
    #[error(transparent)]
    Gear(#[from] GearError),
    /// An outline that is no gear, or a pair of outlines that cannot be put together.
    #[error(transparent)]
    Outline(#[from] OutlineError),
    /// The contact search gave up on a pair of flanks: a fault of gearlash. In a sweep the pose is unproven; elsewhere exit 1.
    #[error(
        "the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} ({flank} flanks) was lost at locked rotation {locked_rotation_rad} rad: {reason}"
    )]
    ContactLost {
        /// Wheel tooth number.
        wheel_tooth: u32,
        /// Pinion tooth number.
        pinion_tooth: u32,
        /// `right` or `left`, as seen from the front.
        flank: &'static str,
        /// Rotation of the locked gear.
        locked_rotation_rad: f64,
        /// What the search saw.
        reason: &'static str,
    },
    /// A pose whose result polygons do not bear out: a fault of gearlash. In a sweep the pose is unproven; elsewhere exit 1.
    #[error(
        "certificate failed at mating {wheel_tooth},{pinion_tooth}, {flank} flank, fraction {fraction}, centre distance {center_distance_mm} mm: on the {side} side {reason}"
    )]
    CertificateFailed {
        /// The mating's wheel tooth.
        wheel_tooth: u32,
        /// The mating's pinion tooth.
        pinion_tooth: u32,
        /// The mating's flank.
        flank: &'static str,
        /// The mating's fraction.
        fraction: f64,
        /// Centre distance, mm.
        center_distance_mm: f64,
        /// The side of the contact in question.
        side: &'static str,
        /// What was seen.
        reason: String,
    },
    /// The caller's `tick` asked to stop.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

/// What helps where a search ends by its effort.
const TRY_ANOTHER_POSE: &str =
    "Another fraction of a pitch, or a trace with fewer points, may be proven.";

/// What helps where two methods contradict each other.
pub(crate) const REPORT_PAIR: &str =
    "Rely on neither value; please report the pair file, with which the pose can be run again.";

impl Error {
    /// Ends a calculation whose `tick` asked to stop.
    pub(crate) fn if_stopped(tick: ControlFlow<()>) -> Result<(), Error> {
        match tick {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Error::Interrupted),
        }
    }

    /// What was seen, in words, where it concerns nothing but the pose at hand: a contact that was lost, a certificate
    /// that failed. `None` of all that ends a command.
    pub fn of_one_pose(&self) -> Option<String> {
        match self {
            Error::ContactLost {
                wheel_tooth,
                pinion_tooth,
                flank,
                reason,
                ..
            } => Some(format!(
                "the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} ({flank} flanks) was lost: {reason}. {TRY_ANOTHER_POSE}"
            )),
            Error::CertificateFailed { side, reason, .. } => {
                let help = if reason.contains("effort") {
                    TRY_ANOTHER_POSE
                } else {
                    REPORT_PAIR
                };
                Some(format!(
                    "the certificate failed: on the {side} side {reason}. {help}"
                ))
            }
            _ => None,
        }
    }
}
