//! What measurements of one gear say of each other and of themselves: each finding with its numbers.
//!
//! A finding changes nothing: every value counts as it stands. `right` and `left` are the gear's *own* flanks.

use super::notes::{Eccentricity, EccentricityNote, ThicknessStatements};
use crate::gear::{Flank, Probe};

/// Something that a user should know of the measurements of one gear.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Finding {
    /// Single pitch deviations of a flank do not sum to 0; the rest is shared out evenly.
    PitchDoesNotClose {
        /// The own flank.
        flank: Flank,
        /// Their sum, µm.
        sum_um: f64,
        /// What rounding of the sheet may leave of it, µm.
        rounding_um: f64,
    },
    /// What was made of runout readings.
    RunoutReadings(FittedReadings),
    /// Runout readings contradict the flanks, which count.
    RunoutContradictsFlanks(RunoutContradiction),
    /// A runout has no direction: extremes are over all of them, single poses take tooth 1.
    RunoutWithoutDirection {
        /// `F_r`, µm.
        total_um: f64,
    },
    /// Pitch about the datum axis contains an eccentricity.
    EccentricityInPitch(EccentricityNote),
    /// Dimensions over pins give the mean thickness only.
    PinsGiveMeanOnly {
        /// How many there are.
        readings: usize,
        /// Whether pitch is known; otherwise it is taken as even.
        with_pitch: bool,
    },
    /// Spans all round give each tooth's thickness.
    SpansGiveEachTooth {
        /// `k`.
        spanned: u32,
        /// `z`, and as many spans.
        teeth: u32,
        /// The growth of a reading's error: at worst this, at random its root.
        amplification: u32,
        /// Whether pitch is known; otherwise all unevenness counts as thickness.
        with_pitch: bool,
    },
    /// Profiles were measured on some teeth; the others take their mean.
    ProfileOfSomeTeeth {
        /// The own flank.
        flank: Flank,
        /// How many teeth were measured.
        measured: u32,
        /// `z`.
        teeth: u32,
    },
    /// Spans give the mean thickness only.
    SpansGiveMeanOnly {
        /// `k`.
        spanned: u32,
        /// `z`.
        teeth: u32,
        /// How many spans.
        readings: usize,
        /// Why.
        why: MeanOnly,
        /// Whether unknown pitch at the teeth that were read stays in the mean thickness.
        pitch_in_mean: bool,
    },
    /// The left flanks go against the right ones, as if their sign were reversed.
    LeftFlankReversed {
        /// Of pitch about the datum axis the eccentricity that it holds with the left flanks reversed and as stated, µm.
        eccentricity_um: Option<[f64; 2]>,
    },
    /// Per-tooth thickness stands beside the pitch of both flanks, which gives it, too; the two add.
    ThicknessBesidePitch(ThicknessBesidePitch),
    /// Spans do not show the per-tooth thickness that is stated.
    SpansRefuseThickness {
        /// The part of it that they show: 1 where they agree.
        shown: f64,
        /// Whether the spans give each tooth's thickness, and so count.
        spans_count: bool,
    },
    /// The mean of per-tooth thickness is more than any allowance.
    PerToothMeanTooLarge {
        /// The mean, µm.
        mean_um: f64,
    },
    /// Per-tooth thickness varies about a mean that adds to the stated thickness.
    PerToothOffMean {
        /// The mean, µm.
        mean_um: f64,
        /// Standard deviation about it, µm.
        scatter_um: f64,
    },
    /// Values in µm are that of the whole tooth or pitch in mm.
    LooksLikeWhole {
        /// What they are.
        quantity: Quantity,
        /// Their mean, as stated in µm.
        mean_um: f64,
    },
    /// What a tolerance field of the tooth thickness means.
    ThicknessField {
        /// Reference diameter, mm.
        diameter_mm: f64,
        /// Upper allowance, µm.
        upper_um: f64,
        /// Lower allowance, µm.
        lower_um: f64,
    },
    /// An allowance makes the teeth thicker than nominal.
    AllowanceThickens {
        /// The greatest, µm.
        um: f64,
    },
    /// The cross-check is the same measurement as the statement that counts.
    CrossCheckOfSameKind(SameKind),
    /// The first harmonic of pitch about the datum axis is not that of an eccentricity alone; what is left counts as the gear's own pitch.
    FirstHarmonicNotEccentricity {
        /// Amplitude left on a flank, µm.
        left_um: f64,
        /// The part of its energy, per cent.
        left_percent: f64,
        /// Whether both flanks move alike, as an index error of the machine moves them.
        alike: bool,
        /// The eccentricity taken from it, µm.
        eccentricity_um: f64,
    },
    /// Pitch about the gear's own axis holds the very eccentricity that the runout states.
    OwnPitchHoldsEccentricity {
        /// In the pitch.
        in_pitch: Eccentricity,
        /// In the runout.
        in_runout: Eccentricity,
        /// How the runout is stated.
        runout: RunoutSource,
    },
    /// Pitch about the gear's own axis holds an eccentricity as large as the stated one, towards another tooth.
    StatedEccentricityElsewhere {
        /// In the pitch.
        in_pitch: Eccentricity,
        /// As stated.
        stated: Eccentricity,
    },
    /// A single value far from all the others.
    Outlier(Outlier),
    /// The thickness is stated twice.
    ThicknessStatedTwice(ThicknessStatements),
}

impl Finding {
    /// Whether it tells of something that is in order.
    pub fn is_in_order(&self) -> bool {
        match self {
            Finding::ThicknessStatedTwice(compared) => compared.agree(),
            Finding::RunoutWithoutDirection { .. }
            | Finding::ProfileOfSomeTeeth { .. }
            | Finding::ThicknessField { .. } => true,
            _ => false,
        }
    }
}

/// What is known of the flanks on which a runout was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum FlankKnowledge {
    /// No pitch.
    NoPitch,
    /// Pitch free of eccentricity.
    Pitch,
    /// Pitch about the datum axis that holds the eccentricity, the one of the readings being taken out of it.
    DatumPitch,
}

/// What was made of runout readings.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FittedReadings {
    /// What was known of the flanks.
    pub knowledge: FlankKnowledge,
    /// What touched them.
    pub probe: Probe,
    /// How far another ball moves the eccentricity at most, µm; `None` where the ball is stated or there is none.
    pub by_ball_um: Option<f64>,
    /// The gear's.
    pub eccentricity: Eccentricity,
    /// The readings' own first harmonic, as if the flanks stood where they belong.
    pub first_harmonic: Eccentricity,
    /// Whether what the stated flanks do to that harmonic was taken out.
    pub flanks_taken_out: bool,
    /// `F_r`: greatest reading less least, µm.
    pub range_um: f64,
    /// What of a reading is neither eccentricity nor said by the flanks, µm at most.
    pub left_um: f64,
}

/// Runout readings beside what the flanks say of them, without mean and first harmonic.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RunoutContradiction {
    /// What touched the flanks.
    pub probe: Probe,
    /// By how much the readings vary at most, µm.
    pub read_um: f64,
    /// By how much they would by the flanks, µm.
    pub said_um: f64,
    /// The tooth where they lie farthest apart: at it, or in the space after it.
    pub tooth: u32,
    /// How far, µm.
    pub apart_um: f64,
    /// `F_r` of the readings, µm.
    pub range_um: f64,
    /// `F_r` of the gear as stated, µm.
    pub known_range_um: f64,
}

/// Why spans give the mean thickness only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum MeanOnly {
    /// No more was asked for.
    AsAsked,
    /// There are fewer spans than teeth.
    TooFew,
    /// Thickness that alternates shows in none of them; spans over `other` teeth would show it.
    Undetermined {
        /// The least such number, if there is any.
        other: Option<u32>,
    },
}

/// Per-tooth thickness beside that of the pitch of both flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ThicknessBesidePitch {
    /// It says the same.
    Same,
    /// It takes back what the pitch says.
    TakenBack,
    /// It says what the pitch would with the left flanks reversed.
    SameIfReversed,
    /// It says the same, moved in tooth number.
    SameIfMoved {
        /// By so many teeth.
        by: usize,
        /// Down, towards lower numbers; otherwise up.
        down: bool,
    },
    /// It says something else.
    Different {
        /// Greatest less least by the list, µm.
        list_um: f64,
        /// The same by the pitch, µm.
        pitch_um: f64,
        /// The tooth where they lie farthest apart.
        tooth: u32,
        /// How far, µm.
        apart_um: f64,
    },
}

/// A list or value stated in µm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Quantity {
    /// Per-tooth thickness.
    PerTooth,
    /// Pitch deviation.
    Pitch,
}

/// What two statements of the thickness have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum SameKind {
    /// A span over as many teeth.
    Span,
    /// A dimension over the same pins.
    OverPins,
    /// An allowance.
    Allowance,
}

/// How a runout is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum RunoutSource {
    /// Its amount and high tooth.
    Total,
    /// By readings.
    Readings {
        /// The eccentricity that is left to them beside the pitch.
        left: Option<Eccentricity>,
    },
}

/// A single value that lies far from all the others.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Outlier {
    /// Of spans or dimensions over pins.
    Reading(ReadingOutlier),
    /// Of pitch deviations.
    Pitch(PitchOutlier),
}

/// A length that stands out.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ReadingOutlier {
    /// Whether it is a dimension over pins, read at a space; otherwise a span, read at a tooth.
    pub over_pins: bool,
    /// The tooth or space.
    pub place: u32,
    /// The reading, mm.
    pub mm: f64,
    /// Its distance from the median, µm.
    pub off_um: f64,
    /// The median, mm.
    pub median_mm: f64,
    /// Of so many readings.
    pub readings: usize,
    /// Whether what the stated flanks do was taken out of them first.
    pub flanks_taken_out: bool,
    /// Why that is too far.
    pub why: TooFar,
}

/// Why a length lies too far from the others.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum TooFar {
    /// By more than even a coarse gear varies, µm.
    CoarseGear(f64),
    /// Half of the others lie within so many µm.
    HalfWithin(f64),
}

/// A pitch deviation that stands out.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PitchOutlier {
    /// The own flank.
    pub flank: Flank,
    /// The tooth.
    pub tooth: u32,
    /// The value as stated, µm.
    pub um: f64,
    /// Its distance from the median (single) or from its neighbours' mean (cumulative), µm.
    pub off_um: f64,
    /// Whether that is the distance from the neighbours' mean.
    pub from_neighbours: bool,
    /// What even a coarse gear varies by, µm.
    pub coarse_um: f64,
    /// Half of the others lie within so many µm.
    pub half_within_um: f64,
}
