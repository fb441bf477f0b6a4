//! Every gauge on one gear.

use super::Unmeasured;
use super::eccentricity::{Eccentricity, eccentricity};
use super::flanks::{PitchReadings, ThicknessReadings, pitch, thickness};
use super::formula::{Formula, formula};
use super::grades::{GradedReading, grades};
use super::lead::{FaceReadings, along_face};
use super::pins::{Pins, pins};
use super::profile::{ProfileReadings, profile};
use super::roll::{Roll, roll};
use super::root::{RootReading, root};
use super::runout::{RunoutReadings, runout};
use super::seat::seats;
use super::span::{Spans, spans};
use super::stated::{StatedThickness, stated};
use super::workpiece::Workpiece;
use crate::error::{Error, Tick};
use crate::gear::{AsBuilt, Gear, PitchAxis, ProfilePart, involute, thickness as formula};
use crate::numeric::bisect;

/// The choices of a measurement. `None` selects a default that depends on the gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// `k`, teeth spanned; default: contact near mid-height.
    pub span_teeth: Option<u32>,
    /// `D_M`, mm; default: the pin that touches near mid-height, rounded up.
    pub pin: Option<f64>,
    /// Ball for the runout, mm; default: the pin.
    pub ball: Option<f64>,
    /// Teeth of the master gear.
    pub master_teeth: Option<u32>,
    /// Poses per pitch of the roll test.
    pub steps_per_pitch: u32,
    /// Ends of the face, mm along the axis from the measuring plane. The master of a helical gear rolls on it.
    pub face: [f64; 2],
    /// Evaluation range of leads, heights from the reference face's end of the teeth, mm; default: that of ISO 1328-1.
    pub lead_range: Option<[f64; 2]>,
    /// Evaluation ranges of the profiles of the own right flanks and the own left ones, as radii in mm; default: root
    /// form circle to tip circle.
    pub evaluation: [Option<[f64; 2]>; 2],
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            span_teeth: None,
            pin: None,
            ball: None,
            master_teeth: None,
            steps_per_pitch: 16,
            face: [0.0; 2],
            lead_range: None,
            evaluation: [None; 2],
        }
    }
}

impl Settings {
    /// These choices, with span and pin that are usual for `gear` where none are chosen.
    #[must_use]
    pub fn with_usual(self, gear: &AsBuilt) -> Settings {
        let (span_teeth, pin) = (self.span_teeth, self.pin);
        Settings {
            span_teeth: span_teeth.or_else(|| Some(usual_span(gear.gear()))),
            pin: pin.or_else(|| Some(usual_pin(gear.gear()))),
            ..self
        }
    }
}

/// Readings of all gauges on one gear. Lengths in mm; each reading carries the bound on its error.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Gauged {
    /// `W_k`.
    pub spans: Result<Spans, Unmeasured>,
    /// `M_dK`.
    pub pins: Result<Pins, Unmeasured>,
    /// `F_r`.
    pub runout: Result<RunoutReadings, Unmeasured>,
    /// The gear's own pitch deviation.
    pub pitch_own: Result<PitchReadings, Unmeasured>,
    /// The pitch deviation about the rotation axis.
    pub pitch_datum: Result<PitchReadings, Unmeasured>,
    /// Tooth thickness at the reference circle.
    pub thickness: Result<ThicknessReadings, Unmeasured>,
    /// Profile deviation of both flanks.
    pub profile: Result<ProfileReadings, Unmeasured>,
    /// Leads, and readings at several heights; `None` for a gear that does not deviate along its face.
    pub along_face: Option<FaceReadings>,
    /// The tip circle's centre.
    pub eccentricity: Result<Eccentricity, Unmeasured>,
    /// Double-flank roll test.
    pub roll: Result<Roll, Unmeasured>,
    /// The root circle.
    pub root: Result<RootReading, Unmeasured>,
    /// The tooth thickness as a gear file states it, or the reason why it cannot.
    pub stated: Result<StatedThickness, Unmeasured>,
    /// Pitch and runout with their accuracy grades, as far as they were measured.
    pub grades: Result<Vec<GradedReading>, Unmeasured>,
    /// Values by formula.
    pub formula: Formula,
}

/// Number of even poses that [`gauge`] takes, without those reported by `more`.
pub fn pose_count(gear: &AsBuilt, settings: &Settings) -> u64 {
    u64::from(gear.gear().basic_data().teeth()) * u64::from(settings.steps_per_pitch)
}

/// Measures `gear`. `tick` is called as each pose of the roll test begins, from any thread; a break ends the work.
/// `more` is called with the number of further poses, in addition to [`pose_count`].
///
/// # Errors
/// A contact that the exact kernel lost; [`Error::Interrupted`].
pub fn gauge(
    gear: &AsBuilt,
    settings: &Settings,
    more: &dyn Fn(usize),
    tick: &Tick,
) -> Result<Gauged, Error> {
    let work = Workpiece::new(gear);
    let k = settings.span_teeth.unwrap_or(usual_span(gear.gear()));
    let pin = settings.pin.unwrap_or(usual_pin(gear.gear()));
    let spans = spans(&work, k);
    let pins = over_pins(&work, pin);
    let ball = settings.ball.unwrap_or(pin);
    let runout = runout(&work, ball);
    let roll = roll(
        gear,
        settings.master_teeth,
        settings.steps_per_pitch,
        settings.face,
        more,
        tick,
    )?;
    let diameters = [
        pins.as_ref().ok().map(|p| p.diameter),
        runout.as_ref().ok().map(|r| r.diameter),
    ];
    let pitch_own = pitch(&work, PitchAxis::Own);
    let pitch_datum = pitch(&work, PitchAxis::Datum);
    let (thickness, root) = (thickness(&work), root(&work));
    Ok(Gauged {
        stated: stated(gear, &spans, &thickness, &pitch_own, &root),
        grades: grades(
            gear.gear().basic_data(),
            [&pitch_datum, &pitch_own].into_iter().flatten(),
            runout.as_ref().ok(),
        ),
        formula: formula(
            gear,
            spans.as_ref().ok().map(|spans| spans.teeth),
            diameters,
            roll.as_ref().ok(),
        ),
        spans,
        pins,
        runout,
        pitch_own,
        pitch_datum,
        thickness,
        root,
        profile: profile(&work, settings.evaluation),
        along_face: along_face(gear, settings.face, settings.lead_range, (k, ball)),
        eccentricity: Ok(eccentricity(&work)),
        roll,
    })
}

/// Measures over pins of the diameter `pin`, mm.
fn over_pins(work: &Workpiece, pin: f64) -> Result<Pins, Unmeasured> {
    let gear = work.as_built.gear();
    let is_helical = gear.basic_data().hand().is_some();
    pins(
        seats(work, pin)?,
        pin,
        gear.tip_radius(),
        work.bound(),
        is_helical,
    )
}

/// The pitch readings of [`gauge`] for `gear`, about the datum axis and about the gear's own centre, as far as possible.
pub fn pitches(gear: &AsBuilt) -> Vec<PitchReadings> {
    let work = Workpiece::new(gear);
    let read = [PitchAxis::Datum, PitchAxis::Own].map(|axis| pitch(&work, axis));
    read.into_iter().flatten().collect()
}

/// The profile readings of [`gauge`] for `gear`, evaluated as in [`Settings::evaluation`].
///
/// # Errors
/// A flank that is no involute, or that the stylus leaves.
pub fn profiles(
    gear: &AsBuilt,
    evaluation: [Option<[f64; 2]>; 2],
) -> Result<ProfileReadings, Unmeasured> {
    profile(&Workpiece::new(gear), evaluation)
}

/// Accuracy grades of the pitch and runout readings of [`gauge`] for `gear`. The runout uses a ball of `ball` mm in
/// every space (default as in [`Settings`]).
///
/// # Errors
/// A gear outside the validity of the grades' formulas.
pub fn graded(gear: &AsBuilt, ball: Option<f64>) -> Result<Vec<GradedReading>, Unmeasured> {
    let work = Workpiece::new(gear);
    let runout = runout(&work, ball.unwrap_or(usual_pin(gear.gear())));
    grades(
        gear.gear().basic_data(),
        pitches(gear).iter(),
        runout.as_ref().ok(),
    )
}

/// The least and greatest pin diameters, mm, that touch the involutes of every space of `gear` and protrude from it.
/// They are searched around the usual pin and rounded inwards to 0.01 mm. `None`: the usual pin does not touch them.
pub fn pin_sizes(gear: &AsBuilt) -> Option<[f64; 2]> {
    /// Width of the bracket of an end, as a part of a step: 12 halvings, sufficient for 0.001 of a diameter.
    const WIDTH: f64 = 1.0 / 4095.0;
    let work = Workpiece::new(gear);
    let fits = |pin| {
        over_pins(&work, pin).is_ok_and(|pins| {
            let mut touched = pins.seats.iter().flat_map(|seat| &seat.touched);
            touched.all(|touch| touch.curve == ProfilePart::Involute)
        })
    };
    let usual = usual_pin(gear.gear());
    if !fits(usual) {
        return None;
    }
    let end = |factor: f64| {
        let (mut inner, mut outer) = (usual, usual * factor);
        // A pin of a thousand times the usual size touches no involute.
        for _ in 0..10 {
            if !fits(outer) {
                break;
            }
            (inner, outer) = (outer, outer * factor);
        }
        bisect(inner, outer, WIDTH * (outer - inner).abs(), fits)[0]
    };
    Some([
        (100.0 * end(0.5)).ceil() / 100.0,
        (100.0 * end(2.0)).floor() / 100.0,
    ])
}

/// Roll at the middle of the active flank's height.
fn mid_roll(gear: &Gear) -> f64 {
    involute::roll_at(
        0.5 * (gear.form_radius() + gear.tip_radius()),
        gear.base_radius(),
    )
}

/// The `k` whose symmetric contact, `W_k cos β_b = ((k − 1) p_bt + s_bt) cos² β_b = 2 r_b ξ`, is nearest to mid-height
/// (for a gear without profile shift the usual `z α/π + 0.5`).
fn usual_span(gear: &Gear) -> u32 {
    let leaning = gear.basic_data().base_helix_angle().cos();
    let line = 2.0 * gear.base_radius() * mid_roll(gear) / (leaning * leaning);
    let steps = (line - gear.base_thickness()) / gear.basic_data().base_pitch();
    // Far below 2^32; the cast turns negative values into 0.
    (steps.round() as u32 + 1).clamp(1, gear.basic_data().teeth() / 2)
}

/// Diameter `D_M`, mm, of the pin that touches at mid-height, rounded up to a quarter of the module's decade
/// (0.25 mm from 1 mm to below 10 mm).
fn usual_pin(gear: &Gear) -> f64 {
    let touching = formula::pin_touching(gear.basic_data(), mid_roll(gear), gear.base_thickness());
    // Whole quarters over a power of ten: the decimal number as one would write it.
    let places = 10f64.powf(2.0 - gear.basic_data().module().log10().floor());
    let rounded = 25.0 * (touching * places / 25.0).ceil() / places;
    // No pin touches there if the flanks of the space are parallel or open inwards.
    if rounded.is_finite() && rounded > 0.0 {
        rounded
    } else {
        2.0 * gear.basic_data().module()
    }
}
