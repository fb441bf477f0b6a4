//! Findings about the measurements of one gear, each with its numbers.
//!
//! A finding changes no value. `right` and `left` are the gear's *own* flanks.

use crate::gear::{BasicGearData, Flank, Probe};

/// Distance of a wobble in leads from the stated one, over the length of the teeth, that is no contradiction, µm: readings of runouts and leads
/// of 1 µm each leave as much.
const MOST_WOBBLE_APART_UM: f64 = 2.0;

/// A finding about the measurements of one gear.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Finding {
    /// Single pitch deviations of a flank do not sum to 0; the rest is distributed evenly.
    PitchDoesNotClose {
        /// The own flank.
        flank: Flank,
        /// Their sum, µm.
        sum_um: f64,
        /// Greatest sum from rounding of the sheet, µm.
        rounding_um: f64,
    },
    /// The eccentricity fitted to runout readings.
    RunoutReadings(FittedReadings),
    /// Runout readings contradict the stated flanks; the flanks are used.
    RunoutContradictsFlanks(RunoutContradiction),
    /// A runout has no direction: extremes cover all directions, single poses use tooth 1.
    RunoutWithoutDirection {
        /// `F_r`, µm.
        total_um: f64,
    },
    /// Leads about the datum axis contain a wobble.
    WobbleInLeads {
        /// Its lean over the length of the teeth, µm.
        um: f64,
        /// The tooth towards which the teeth lean away from the reference face.
        tooth: f64,
        /// Distance from the stated one, µm over the length of the teeth.
        apart_um: Option<f64>,
    },
    /// Pitch about the datum axis contains an eccentricity.
    EccentricityInPitch(EccentricityNote),
    /// Dimensions over pins give the mean thickness only.
    PinsGiveMeanOnly {
        /// Number of readings.
        readings: usize,
        /// Whether pitch is known; otherwise it counts as even.
        with_pitch: bool,
    },
    /// Spans all round give each tooth's thickness.
    SpansGiveEachTooth {
        /// `k`.
        spanned: u32,
        /// `z`, the number of spans.
        teeth: u32,
        /// Amplification of a reading's error: this factor at worst, its square root for random errors.
        amplification: u32,
        /// Whether pitch is known; otherwise all unevenness counts as thickness.
        with_pitch: bool,
    },
    /// Profiles were measured on some teeth; the others use their mean.
    ProfileOfSomeTeeth(SomeTeeth),
    /// Leads were measured on some teeth; the others use their mean.
    LeadOfSomeTeeth(SomeTeeth),
    /// Spans give the mean thickness only.
    SpansGiveMeanOnly {
        /// `k`.
        spanned: u32,
        /// `z`.
        teeth: u32,
        /// Number of spans.
        readings: usize,
        /// The reason.
        why: MeanOnly,
        /// Whether unknown pitch at the measured teeth affects the mean thickness.
        pitch_in_mean: bool,
    },
    /// The left flanks oppose the right ones, as if their sign were reversed.
    LeftFlankReversed {
        /// Eccentricity in datum-axis pitch with the left flanks reversed and as stated, µm.
        eccentricity_um: Option<[f64; 2]>,
    },
    /// Per-tooth thickness is stated although the pitch of both flanks contains it; the two add.
    ThicknessBesidePitch(ThicknessBesidePitch),
    /// Spans contradict the thickness in the pitch of both flanks.
    SpansRefusePitch {
        /// The share of it that the spans show: 1 if they agree, -1 with exchanged flanks, 0 if it does not vary.
        shown: f64,
        /// Variation of the spans beside it, µm r.m.s.
        left_um: f64,
        /// Whether the spans determine each tooth's thickness.
        spans_count: bool,
    },
    /// Spans contradict the stated per-tooth thickness.
    SpansRefuseThickness {
        /// The share of it that the spans show: 1 if they agree.
        shown: f64,
        /// Whether the spans determine each tooth's thickness.
        spans_count: bool,
    },
    /// The mean of per-tooth thickness exceeds any allowance.
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
    /// Values in µm equal the whole tooth thickness or pitch in mm.
    LooksLikeWhole {
        /// The quantity.
        quantity: Quantity,
        /// Their mean, as stated in µm.
        mean_um: f64,
    },
    /// The allowances of a tolerance field of the tooth thickness.
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
        /// The greatest allowance, µm.
        um: f64,
    },
    /// An allowance takes a large part of the tooth thickness.
    AllowanceTooLarge {
        /// The least of its size, µm.
        um: f64,
    },
    /// The cross-check is the same kind of measurement as the thickness statement.
    CrossCheckOfSameKind(SameKind),
    /// The first harmonic of datum-axis pitch is not that of an eccentricity alone; the rest counts as the gear's own pitch.
    FirstHarmonicNotEccentricity {
        /// Remaining amplitude on a flank, µm.
        left_um: f64,
        /// Remaining share of its energy, per cent.
        left_percent: f64,
        /// Whether both flanks move together, as by an index error of the machine.
        alike: bool,
        /// Whether it is that of an eccentricity once right and left flanks are exchanged.
        exchanged: bool,
        /// The eccentricity taken from it, µm.
        eccentricity_um: f64,
    },
    /// Pitch about the gear's own axis contains the eccentricity of the stated runout.
    OwnPitchHoldsEccentricity {
        /// The eccentricity in the pitch.
        in_pitch: Eccentricity,
        /// The eccentricity in the runout.
        in_runout: Eccentricity,
        /// Form of the runout statement.
        runout: RunoutSource,
    },
    /// Pitch about the gear's own axis contains an eccentricity of the stated amount towards another tooth.
    StatedEccentricityElsewhere {
        /// The eccentricity in the pitch.
        in_pitch: Eccentricity,
        /// The stated eccentricity.
        stated: Eccentricity,
        /// How one of the two statements may be reversed.
        reversal: Option<Reversal>,
    },
    /// A single value far from all the others.
    Outlier(Outlier),
    /// The thickness is stated twice.
    ThicknessStatedTwice(ThicknessStatements),
}

impl Finding {
    /// Whether the finding needs no action.
    pub fn is_in_order(&self) -> bool {
        match self {
            Finding::ThicknessStatedTwice(compared) => compared.agree(),
            Finding::RunoutWithoutDirection { .. }
            | Finding::ProfileOfSomeTeeth { .. }
            | Finding::LeadOfSomeTeeth { .. }
            | Finding::ThicknessField { .. } => true,
            Finding::RunoutReadings(readings) => {
                let agree = |(pitch, apart): (Eccentricity, f64)| {
                    apart <= readings.left_um.max(SAME_ECCENTRICITY * pitch.um)
                };
                // The user has stated that the readings count, and EccentricityInPitch tells where they differ.
                readings.knowledge == FlankKnowledge::DatumPitch
                    || readings.in_pitch.is_some_and(agree)
            }
            Finding::EccentricityInPitch(note) => {
                let same = SAME_ECCENTRICITY * note.in_pitch.um;
                note.is_alone || note.difference_um.is_some_and(|um| um <= same)
            }
            Finding::WobbleInLeads { apart_um, .. } => {
                apart_um.is_none_or(|um| um <= MOST_WOBBLE_APART_UM)
            }
            _ => false,
        }
    }
}

/// A flank that was traced on some teeth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SomeTeeth {
    /// The own flank.
    pub flank: Flank,
    /// Number of measured teeth.
    pub measured: u32,
    /// `z`.
    pub teeth: u32,
}

/// Knowledge of the flanks on which a runout was read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum FlankKnowledge {
    /// No pitch.
    NoPitch,
    /// Pitch free of eccentricity.
    Pitch,
    /// Datum-axis pitch that contains the eccentricity; the eccentricity of the readings is removed from it.
    DatumPitch,
}

/// The eccentricity fitted to runout readings.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FittedReadings {
    /// Knowledge of the flanks.
    pub knowledge: FlankKnowledge,
    /// The probe.
    pub probe: Probe,
    /// Greatest change of the eccentricity by another ball, µm; `None` with a stated ball or a fork.
    pub by_ball_um: Option<f64>,
    /// The eccentricity of the readings.
    pub eccentricity: Eccentricity,
    /// The eccentricity of datum-axis pitch where it is the gear's, and its distance from that of the readings, µm.
    pub in_pitch: Option<(Eccentricity, f64)>,
    /// The readings' first harmonic without any effect of the flanks.
    pub first_harmonic: Eccentricity,
    /// Whether the effect of the stated flanks on that harmonic was removed.
    pub flanks_taken_out: bool,
    /// `F_r`: greatest minus least reading, µm.
    pub range_um: f64,
    /// Greatest part of a reading that neither eccentricity nor flanks explain, µm.
    pub left_um: f64,
}

/// Runout readings and their values expected from the flanks, without mean and first harmonic.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RunoutContradiction {
    /// The probe.
    pub probe: Probe,
    /// Greatest variation of the readings, µm.
    pub read_um: f64,
    /// Greatest variation expected from the flanks, µm.
    pub said_um: f64,
    /// The tooth of the greatest difference: at the tooth, or in the space after it.
    pub tooth: u32,
    /// The greatest difference, µm.
    pub apart_um: f64,
    /// `F_r` of the readings, µm.
    pub range_um: f64,
    /// `F_r` of the flanks as stated with the eccentricity of the readings, µm.
    pub known_range_um: f64,
}

/// The reason why spans give the mean thickness only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum MeanOnly {
    /// Per-tooth thickness was not requested.
    AsAsked,
    /// There are fewer spans than teeth.
    TooFew,
    /// The spans do not show alternating thickness; spans over `other` teeth would.
    Undetermined {
        /// The least such number; `None` if there is none.
        other: Option<u32>,
    },
}

/// Stated per-tooth thickness compared with the thickness in the pitch of both flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ThicknessBesidePitch {
    /// Both are equal.
    Same,
    /// They are equal with opposite signs.
    TakenBack,
    /// They are equal with the left flanks reversed.
    SameIfReversed,
    /// They are equal after a shift in tooth numbers.
    SameIfMoved {
        /// Number of teeth.
        by: usize,
        /// Whether the shift is towards lower numbers.
        down: bool,
    },
    /// They differ.
    Different {
        /// Greatest minus least thickness of the list, µm.
        list_um: f64,
        /// Greatest minus least thickness in the pitch, µm.
        pitch_um: f64,
        /// The tooth of the greatest difference.
        tooth: u32,
        /// The greatest difference, µm.
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

/// The common kind of two thickness statements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum SameKind {
    /// Spans over the same number of teeth.
    Span,
    /// Dimensions over the same pins.
    OverPins,
    /// Chords at the same height.
    Chord,
    /// Allowances.
    Allowance,
}

/// Form of a runout statement.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum RunoutSource {
    /// Amount and high tooth.
    Total,
    /// Readings.
    Readings {
        /// The eccentricity in the readings beyond that of the pitch.
        left: Option<Eccentricity>,
    },
}

/// A single value far from all others.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Outlier {
    /// A span or a dimension over pins.
    Reading(ReadingOutlier),
    /// A pitch deviation.
    Pitch(PitchOutlier),
}

/// An outlier among spans or dimensions over pins.
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
    /// Number of readings.
    pub readings: usize,
    /// Whether the effect of the stated flanks was removed from the readings.
    pub flanks_taken_out: bool,
    /// The criterion.
    pub why: TooFar,
}

/// The criterion of an outlier among lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum TooFar {
    /// The distance exceeds the variation of a coarse gear, µm.
    CoarseGear(f64),
    /// Half of the other values lie within this distance, µm.
    HalfWithin(f64),
}

/// An outlier among pitch deviations.
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
    /// Variation of a coarse gear, µm.
    pub coarse_um: f64,
    /// Half of the other values lie within this distance, µm.
    pub half_within_um: f64,
}

/// Results about one gear for tables and reports.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GearNotes {
    /// The eccentricity of datum-axis pitch.
    pub eccentricity: Option<EccentricityNote>,
    /// The evaluation of readings all round.
    pub all_round: Option<AllRoundNote>,
    /// The comparison with a second thickness statement.
    pub thickness: Option<ThicknessStatements>,
}

/// An eccentricity: amount and direction.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Eccentricity {
    /// `e`, µm.
    pub um: f64,
    /// The tooth (fractional) in the direction of the eccentricity.
    pub high_tooth: f64,
}

impl Eccentricity {
    /// An eccentricity of `mm` towards a tooth.
    pub(super) fn new(mm: f64, high_tooth: f64) -> Eccentricity {
        Eccentricity {
            um: 1000.0 * mm,
            high_tooth,
        }
    }

    /// Distance between the two displacements, µm.
    pub(super) fn distance_um(&self, other: &Eccentricity, basic_data: &BasicGearData) -> f64 {
        let angle = (other.high_tooth - self.high_tooth) * basic_data.angular_pitch();
        let (sin, cos) = angle.sin_cos();
        (other.um * cos - self.um).hypot(other.um * sin)
    }

    /// Whether the `other` one is the same.
    pub(super) fn is_same(&self, other: &Eccentricity, basic_data: &BasicGearData) -> bool {
        self.distance_um(other, basic_data) <= SAME_ECCENTRICITY * self.um
    }

    /// Whether the amount of the `other` one is the same.
    pub(super) fn is_as_large(&self, other: &Eccentricity) -> bool {
        (other.um - self.um).abs() <= SAME_ECCENTRICITY * self.um
    }

    /// How this eccentricity or the `other` one may be reversed; `None` if they are the same, or differ in another way.
    pub(super) fn reversal(
        &self,
        other: &Eccentricity,
        basic_data: &BasicGearData,
    ) -> Option<Reversal> {
        if self.is_same(other, basic_data) || self.um < LEAST_UM {
            return None;
        }
        let turned = other.high_tooth + f64::from(basic_data.teeth()) / 2.0;
        // Counted the other way from tooth 1.
        let mirrored = 2.0 - other.high_tooth;
        let each = [(turned, Reversal::Sign), (mirrored, Reversal::Numbering)];
        let off = |high_tooth| {
            self.distance_um(
                &Eccentricity {
                    high_tooth,
                    ..*other
                },
                basic_data,
            )
        };
        let each = each.map(|(high_tooth, reversal)| (off(high_tooth), reversal));
        let near = each
            .into_iter()
            .filter(|(off, _)| *off <= SAME_ECCENTRICITY * self.um);
        let nearest = near.min_by(|(one, _), (two, _)| one.total_cmp(two));
        nearest.map(|(_, reversal)| reversal)
    }
}

/// Greatest relative difference at which two eccentricities count as one: 25 % of the amount or 14.5° of the direction. A harmonic of
/// the gear's own pitch, of any direction and up to twice the amount, comes so near once in 64 times.
const SAME_ECCENTRICITY: f64 = 0.25;

/// Less eccentricity, µm, is within the rounding of a sheet.
const LEAST_UM: f64 = 1.0;

/// How two statements of one eccentricity can differ by a slip.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Reversal {
    /// Half a turn: the sign of one.
    Sign,
    /// Mirrored about tooth 1: the sense in which the teeth of one are numbered.
    Numbering,
}

/// The eccentricity in datum-axis pitch, and the stated one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EccentricityNote {
    /// From the pitch of both flanks; a first harmonic of the gear's own pitch is indistinguishable from it.
    pub in_pitch: Eccentricity,
    /// Whether no runout is stated.
    pub is_alone: bool,
    /// From the runout, if stated with its direction.
    pub stated: Option<Eccentricity>,
    /// Whether the gear has the stated eccentricity; otherwise that of the pitch.
    pub stated_counts: bool,
    /// Distance between the two displacements, µm, if both are known.
    pub difference_um: Option<f64>,
    /// How one of the two may be reversed.
    pub reversal: Option<Reversal>,
}

/// Evaluation of readings all round.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AllRoundNote {
    /// Number of readings.
    pub readings: usize,
    /// Amplification of a reading's error in a tooth's thickness: this factor at worst, its square root for random errors.
    ///
    /// `None` if the readings give the mean thickness only.
    pub amplification: Option<u32>,
}

/// Two statements of the thickness of one gear, as base thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ThicknessStatements {
    /// Least and greatest `s_b` of the thickness statement, mm.
    pub counts: [f64; 2],
    /// Least and greatest `s_b` of the cross-check, mm.
    pub cross: [f64; 2],
    /// Middle of the cross-check minus middle of the thickness statement, µm.
    pub difference_um: f64,
    /// Gap between the two ranges, µm; 0 if they share a value.
    pub gap_um: f64,
    /// Greatest gap at which they agree, µm.
    pub tolerance_um: f64,
}

impl ThicknessStatements {
    /// Compares two ranges of `s_b`, mm, least value first.
    pub fn new(counts: [f64; 2], cross: [f64; 2], tolerance_um: f64) -> ThicknessStatements {
        let middle = |range: [f64; 2]| (range[0] + range[1]) / 2.0;
        let gap = (cross[0] - counts[1]).max(counts[0] - cross[1]);
        ThicknessStatements {
            counts,
            cross,
            difference_um: 1000.0 * (middle(cross) - middle(counts)),
            gap_um: 1000.0 * gap.max(0.0),
            tolerance_um,
        }
    }

    /// Whether both may describe one tooth.
    pub fn agree(&self) -> bool {
        self.gap_um <= self.tolerance_um
    }
}
