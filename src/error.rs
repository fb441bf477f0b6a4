//! Errors of the library.
//!
//! [`GearError`] is a gear or pair that cannot exist, [`OutlineError`] an outline that is no gear, [`Error`] the error of a calculation.
//! An interfering, jammed or unmeshed pair is a result, never an error.

use nalgebra::Point2;
use std::ops::ControlFlow;

/// Called from any thread with 1 as a step of a calculation begins, and with 0 many times a second within long steps.
///
/// A break ends the calculation with [`Error::Interrupted`]. Further calls must break, too.
pub type Tick<'a> = dyn Fn(u64) -> ControlFlow<()> + Sync + 'a;

/// A [`Tick`] that never ends the calculation.
pub fn go_on(_: u64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A gear or a pair that cannot exist. Values are in mm and radians; messages print mm and degrees.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GearError {
    /// A number outside its range.
    #[error("{what} is {}, allowed is {allowed}", printed(*.value))]
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
    /// A chord whose ends do not touch the involute.
    #[error(
        "a chord {height_mm:.4} mm below the tip touches at diameter {contact_diameter_mm:.4} mm, off the involute ({form_diameter_mm:.4} … {tip_diameter_mm:.4} mm)"
    )]
    ChordOffInvolute {
        /// Depth below the tip.
        height_mm: f64,
        /// Diameter of the contacts.
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
    /// No tolerance of a centre distance.
    #[error("no tolerance of a centre distance")]
    DistanceField,
    /// A profile deviation that no flank can have.
    #[error("the profile deviation is too large: the flank {what}")]
    Profile {
        /// The effect on the flank, in words.
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

/// A value without the rounding of what it is computed from: twelve significant digits.
fn printed(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

impl GearError {
    /// Checks a value: [`GearError::OutOfRange`] unless it `holds`.
    pub(crate) fn require(
        holds: bool,
        what: &'static str,
        value: f64,
        allowed: &'static str,
    ) -> Result<(), GearError> {
        let error = GearError::OutOfRange {
            what,
            value,
            allowed,
        };
        if holds { Ok(()) } else { Err(error) }
    }
}

/// An outline that is no gear. Points are in the drawing's frame, mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OutlineError {
    /// No segment, or one with a number that is not finite or a circle without radius.
    #[error("segment {index} of the outline is not a curve with finite numbers")]
    NotFinite {
        /// Counted from 0.
        index: usize,
    },
    /// Two ends that should meet do not.
    #[error(
        "the outline is open: from {} to {} nothing is drawn, {gap_mm:.6} mm",
        at(from),
        at(to)
    )]
    Open {
        /// Where a segment ends.
        from: Point2<f64>,
        /// Where the next one starts.
        to: Point2<f64>,
        /// Their distance.
        gap_mm: f64,
    },
    /// The path crosses itself.
    #[error("the outline crosses itself near {}", at(near))]
    SelfCrossing {
        /// Within a chord of the crossing.
        near: Point2<f64>,
    },
    /// The centre is not inside.
    #[error("the centre {} does not lie inside the outline", at(centre))]
    CentreOutside {
        /// The centre.
        centre: Point2<f64>,
    },
    /// Fewer than three teeth.
    #[error(
        "teeth between diameters {root_diameter_mm:.4} and {tip_diameter_mm:.4} mm: {found}; a gear has at least 3"
    )]
    TooFewTeeth {
        /// How many.
        found: usize,
        /// Twice the least radius.
        root_diameter_mm: f64,
        /// Twice the greatest radius.
        tip_diameter_mm: f64,
    },
    /// Another number of teeth than stated.
    #[error(
        "{found} teeth are found, {stated} are stated; the first one found points to {}",
        at(first)
    )]
    OtherTeeth {
        /// How many are there.
        found: usize,
        /// How many there should be.
        stated: u32,
        /// The tip of tooth 1.
        first: Point2<f64>,
    },
    /// Teeth at uneven distances: one is missing, or something else sticks out.
    #[error(
        "the teeth are not evenly spaced: the one at {} stands {pitches:.3} of a pitch from its even place",
        at(tip)
    )]
    Uneven {
        /// The tip of the tooth farthest off.
        tip: Point2<f64>,
        /// How far, in pitches, counter-clockwise positive.
        pitches: f64,
    },
    /// A runout that leaves the axis outside.
    #[error(
        "an eccentricity of {eccentricity_mm} mm is allowed up to half the tooth depth, {depth_mm:.4} mm"
    )]
    Eccentric {
        /// Given.
        eccentricity_mm: f64,
        /// Tip minus root radius.
        depth_mm: f64,
    },
    /// A flank offset that closes spaces, removes teeth or leaves too little of them.
    #[error(
        "moved {} by {} mm, the outline does not keep half the depth of its {teeth} teeth: at most {greatest_mm:.3} mm is possible",
        if *offset_mm > 0.0 { "out" } else { "in" },
        offset_mm.abs()
    )]
    Offset {
        /// Given; out of the metal positive.
        offset_mm: f64,
        /// Teeth of the outline as drawn.
        teeth: u32,
        /// Greatest possible in this direction, rounded down.
        greatest_mm: f64,
    },
    /// Two outlines that are not of one gear.
    #[error(
        "{} and {} teeth are found: two outlines of one gear have as many",
        teeth[0],
        teeth[1]
    )]
    OtherGear {
        /// Number of teeth of each outline.
        teeth: [u32; 2],
    },
    /// A centre distance at which nothing can turn.
    #[error(
        "the centre distance {center_distance_mm} mm must be above {least_mm:.4} mm, at which a tip reaches the mate's axis"
    )]
    TooNear {
        /// Given.
        center_distance_mm: f64,
        /// Greater of the two reaches.
        least_mm: f64,
    },
}

fn at(point: &Point2<f64>) -> String {
    // Never −0.
    let [x, y] = [point.x, point.y].map(|mm| (mm * 1e4).round() / 1e4 + 0.0);
    format!("({x:.4}, {y:.4})")
}

/// The error of a calculation without a result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A pair that cannot be assembled.
    #[error(transparent)]
    Gear(#[from] GearError),
    /// An outline that is no gear, or a pair of outlines that cannot be put together.
    #[error(transparent)]
    Outline(#[from] OutlineError),
    /// A change that is impossible beside a drawn gear.
    #[error("beside a drawing each gear's runout can change, and the thickness of a drawn one")]
    ChangeOfDrawn,
    /// The contact search failed for a pair of flanks: a fault of gearlash. In a sweep the pose is unproven; elsewhere exit 1.
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
        /// The reason, in words.
        reason: String,
    },
    /// The polygons do not confirm a pose: a fault of gearlash. In a sweep the pose is unproven; elsewhere exit 1.
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
        /// The reason, in words.
        reason: String,
    },
    /// The caller's `tick` asked to stop.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

/// Advice for a search that ends by its effort.
const TRY_ANOTHER_POSE: &str =
    "Another fraction of a pitch, or a trace with fewer points, may be proven.";

/// Advice for two methods that contradict each other.
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

    /// Message of an error that concerns a single pose: a lost contact or a failed certificate. `None` for other errors.
    pub fn pose_failure(&self) -> Option<String> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_computed_value_is_printed_without_its_rounding() {
        let text = |value| {
            let error = GearError::require(false, "runout (mm)", value, "less");
            error.unwrap_err().to_string()
        };
        assert_eq!(
            text(3.5999999999999996),
            "runout (mm) is 3.6, allowed is less"
        );
        assert_eq!(
            text(132.180001),
            "runout (mm) is 132.180001, allowed is less"
        );
        assert_eq!(text(f64::NAN), "runout (mm) is NaN, allowed is less");
    }
}
