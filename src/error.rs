//! What can go wrong, and the way out of it.
//!
//! Three layers: [`GearError`] is a gear or pair that cannot exist, in the
//! terms of the geometry; [`Problem`] ties such a reason to the key of a pair
//! file; [`Error`] is what a command ends with. An interfering, jammed or
//! unmeshed pair is a result, never an error.

use crate::characters;
use std::fmt;
use std::path::PathBuf;

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
    /// The two gears do not share module or pressure angle.
    #[error("{what} differs: wheel {wheel}, pinion {pinion}; a pair shares it")]
    Unequal {
        /// Module or pressure angle.
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
    /// Readings all round that no gear has.
    #[error("{0}")]
    Readings(&'static str),
    /// Datum-axis pitch data whose eccentricity cannot be separated.
    #[error("{0}")]
    DatumPitch(&'static str),
}

/// One thing wrong with one value of a pair file.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Dotted path of the key, such as `wheel.runout.high_tooth`; empty for the whole file.
    pub key: String,
    /// The value as written, where there is one.
    pub value: Option<String>,
    /// What is wrong and what is allowed.
    pub reason: String,
    /// What to do.
    pub help: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.key.is_empty() {
            write!(f, "{}", self.key)?;
            if let Some(value) = &self.value {
                write!(f, " = {value}")?;
            }
            write!(f, ": ")?;
        }
        write!(f, "{}; {}", self.reason, self.help)
    }
}

/// What a command ends with when it cannot do its work.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// All problems of one input file.
    #[error("{}", self.lines().join("\n"))]
    Input {
        /// The file.
        file: PathBuf,
        /// At least one.
        problems: Vec<Problem>,
    },
    /// What is wrong with several files.
    #[error("{}", self.lines().join("\n"))]
    Several(Vec<Error>),
    /// A command-line value that does not suit the file.
    #[error("{0}")]
    Usage(String),
    /// A pair that cannot be assembled, asked for outside a pair file.
    #[error(transparent)]
    Gear(#[from] GearError),
    /// A chart that cannot be drawn.
    #[error("the chart cannot be drawn: {0}")]
    Chart(String),
    /// A result that cannot be written.
    #[error("{}: cannot be written: {source}; choose another place with -o", path.display())]
    Output {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A result that would take the place of a file that was read.
    #[error(
        "{}: this is the file {}, which was read and would be lost; name another place for the result",
        output.display(), input.display()
    )]
    OverInput {
        /// Where the result was to go.
        output: PathBuf,
        /// The name under which the file was read.
        input: PathBuf,
    },
    /// A folder that another run is about to write to.
    #[error("{}: another run of gearlash writes to this folder; wait for its end, or name another folder with -o", folder.display())]
    Busy {
        /// The folder.
        folder: PathBuf,
    },
    /// A folder in which files of two runs stand, because neither the new ones nor the old ones could be put in place.
    #[error(
        "{}: holds files of this run beside older ones: {reason}; putting these back failed, too: {source}. The next run that can write there puts them back",
        folder.display()
    )]
    HalfWritten {
        /// The folder.
        folder: PathBuf,
        /// What failed first.
        reason: String,
        /// What failed then.
        source: std::io::Error,
    },
    /// Standard output that takes no more.
    #[error("standard output: cannot be written: {0}")]
    Printing(std::io::Error),
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
    /// Ctrl-C.
    #[error("interrupted; nothing was written")]
    Interrupted,
}

/// Characters of a line of an error message: a path as long as Linux allows (4096 bytes) and what is said of it. Nothing should
/// come near it; where something does, the line is cut visibly.
const LONGEST_LINE: usize = 6000;

impl Error {
    /// The message, a line for each problem: whatever stands in the files, it breaks no line and acts on no terminal or log.
    pub fn lines(&self) -> Vec<String> {
        let line = |text: String| characters::cut(&characters::plain(&text), LONGEST_LINE);
        match self {
            Error::Input { file, problems } => {
                let problems = problems.iter();
                let told = problems.map(|problem| line(format!("{}: {problem}", file.display())));
                told.collect()
            }
            Error::Several(errors) => errors.iter().flat_map(Error::lines).collect(),
            other => vec![line(other.to_string())],
        }
    }

    /// What the process ends with: 1 when a result did not hold, 2 when there was none to be had or it could not be
    /// written, 130 (128 + SIGINT, as shells count) when the work was to stop. (A signal ends the program by itself.)
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::CertificateFailed { .. } | Error::ContactLost { .. } => 1,
            Error::Interrupted => 130,
            _ => 2,
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
                "the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} ({flank} flanks) was lost: {reason}"
            )),
            Error::CertificateFailed { side, reason, .. } => Some(format!(
                "the certificate failed: on the {side} side {reason}"
            )),
            _ => None,
        }
    }
}
