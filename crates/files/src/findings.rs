//! Findings about the measurements of a gear, in words.

mod eccentricity;
mod outlier;
mod runout;
mod thickness;

use super::numbers::{ascii, rounded, shortest};
use super::statements::Statements;
use super::thickness::CROSS_CHECK;
use super::{lead, profile};
use gearlash::gear::DIN_3967_SOURCE;
use gearlash::metrology::{Finding, LeadKey, ProfileKey, Quantity, SameKind};

pub use outlier::suspected;

/// The line that the user reads, with the key it is about.
pub fn describe(of: &Statements, finding: &Finding) -> String {
    let key = |name: &str| of.table.path_of(name);
    match finding {
        Finding::PitchDoesNotClose {
            flank,
            sum_um,
            rounding_um,
        } => format!(
            "{}: the single pitch deviations of the {} flanks sum to {} µm instead of 0 (rounding leaves up to {} µm); \
             the rest is distributed evenly over the teeth",
            key(of.pitch_key(*flank)),
            flank.name(),
            ascii(*sum_um, 2),
            ascii(*rounding_um, 2),
        ),
        Finding::WobbleInLeads {
            um,
            tooth,
            apart_um,
        } => {
            let counts = match apart_um {
                None => "the gear wobbles so".to_owned(),
                Some(apart) => format!("the stated wobble counts, {} µm off it", ascii(*apart, 2)),
            };
            format!(
                "{}: the leads about the bore contain a wobble of {} µm over the teeth, towards tooth {}; it is taken out of them, and {counts}",
                key("lead.axis"),
                ascii(*um, 2),
                ascii(*tooth, 2)
            )
        }
        Finding::RunoutReadings(readings) => {
            let key = key("runout.file");
            format!("{key}: {}", runout::readings(readings))
        }
        Finding::RunoutContradictsFlanks(contradiction) => {
            let key = key("runout.file");
            format!("{key}: {}", runout::contradiction(contradiction))
        }
        Finding::RunoutWithoutDirection { total_um } => format!(
            "{}: {total_um} µm without high_tooth: least and greatest of the verdict are over every direction; single poses and the gauge have tooth 1 high",
            key("runout")
        ),
        Finding::EccentricityInPitch(note) => {
            format!("{}: {}", key("pitch"), eccentricity::in_pitch(note))
        }
        Finding::ProfileOfSomeTeeth {
            flank,
            measured,
            teeth,
        } => format!(
            "{}: traces of {measured} of {teeth} {} flanks; the other teeth take their mean",
            key(&profile::key_of(of.table, *flank, ProfileKey::Trace)),
            flank.name()
        ),
        Finding::LeadOfSomeTeeth {
            flank,
            measured,
            teeth,
        } => format!(
            "{}: traces of {measured} of {teeth} {} flanks; the other teeth take their mean",
            key(&lead::key_of(of.table, *flank, LeadKey::Trace)),
            flank.name()
        ),
        Finding::PinsGiveMeanOnly {
            readings,
            with_pitch,
        } => {
            let words = thickness::mean_by_pins(*readings, *with_pitch);
            format!("{}: {words}", key("thickness.over_pins"))
        }
        Finding::SpansGiveEachTooth {
            spanned,
            teeth,
            amplification,
            with_pitch,
        } => {
            let words =
                thickness::each_tooth_by_spans(*spanned, *teeth, *amplification, *with_pitch);
            format!("{}: {words}", key("thickness.span"))
        }
        Finding::SpansGiveMeanOnly {
            spanned,
            teeth,
            readings,
            why,
            pitch_in_mean,
        } => {
            let words = thickness::mean_by_spans(*spanned, *teeth, *readings, *why, *pitch_in_mean);
            format!("{}: {words}", key("thickness.span"))
        }
        Finding::LeftFlankReversed { eccentricity_um } => {
            eccentricity::left_reversed(of, *eccentricity_um)
        }
        Finding::ThicknessBesidePitch(beside) => {
            let key = key("thickness.per_tooth_um");
            let words = thickness::beside_pitch(beside, of.other_sense());
            format!("{key}: {words}")
        }
        Finding::SpansRefuseThickness { shown, spans_count } => format!(
            "{}: the spans contradict it (they show {} % of it): check its sign and tooth numbers, or leave it out; {}",
            key("thickness.per_tooth_um"),
            ascii(100.0 * shown, 0),
            if *spans_count {
                "the spans take precedence"
            } else {
                "it is used as given"
            }
        ),
        Finding::PerToothMeanTooLarge { mean_um } => format!(
            "{}: its mean is {} µm, more than a tenth of the module: each value is how much thicker than the mean the tooth is, in µm; if they are \
             thicknesses, subtract their mean; if they are in another unit, convert them",
            key("thickness.per_tooth_um"),
            ascii(*mean_um, 1)
        ),
        Finding::PerToothOffMean {
            mean_um,
            scatter_um,
        } => {
            let stated = of.thickness.statement.key().unwrap_or_default();
            format!(
                "{}: its mean, {} µm, adds to the stated {stated} (its values scatter about it by {} µm r.m.s.): if they were measured \
                 from the nominal thickness, and {stated} states the same, subtract their mean from the list",
                key("thickness.per_tooth_um"),
                ascii(*mean_um, 1),
                ascii(*scatter_um, 1)
            )
        }
        Finding::LooksLikeWhole { quantity, mean_um } => looks_like_whole(of, *quantity, *mean_um),
        Finding::ThicknessField {
            diameter_mm,
            upper_um,
            lower_um,
        } => format!(
            "{}: at reference diameter {} mm the allowances are {} and {} µm, {DIN_3967_SOURCE}",
            key("thickness.designation"),
            shortest(rounded(*diameter_mm, 4)),
            ascii(*upper_um, 0),
            ascii(*lower_um, 0)
        ),
        Finding::AllowanceThickens { um } => format!(
            "{}: {um} µm makes the teeth thicker than nominal, but an allowance for backlash makes them thinner: check its sign; if {} µm was \
             meant, write that",
            key("thickness.allowance_um"),
            -um
        ),
        Finding::AllowanceTooLarge { um } => format!(
            "{}: {um} µm takes more than a quarter of the module off the teeth: if nm were meant, write {}",
            key("thickness.allowance_um"),
            shortest(um / 1000.0)
        ),
        Finding::CrossCheckOfSameKind(kind) => same_kind(of, *kind),
        Finding::FirstHarmonicNotEccentricity {
            left_um,
            left_percent,
            alike,
            eccentricity_um,
        } => format!(
            "{}: the first harmonic is not that of an eccentricity alone, whose waves on right and left flanks are twice the pressure angle apart. {} µm of it remain \
             on a flank, {} % of its energy, and are used as the gear's own pitch{}. The eccentricity of {} µm is therefore uncertain: measure the runout, \
             and say in [pitch] which is used: eccentricity = \"pitch\" or \"runout\"",
            key("pitch"),
            ascii(*left_um, 3),
            ascii(*left_percent, 0),
            if *alike {
                " (both flanks vary equally, as from an index error of the machine)"
            } else {
                ""
            },
            ascii(*eccentricity_um, 3),
        ),
        Finding::OwnPitchHoldsEccentricity {
            in_pitch,
            in_runout,
            runout,
        } => {
            let key = key("pitch.axis");
            let words = eccentricity::in_own_pitch(*in_pitch, *in_runout, *runout);
            format!("{key}: {words}")
        }
        Finding::StatedEccentricityElsewhere { in_pitch, stated } => {
            let key = key("runout.high_tooth");
            let words = eccentricity::stated_elsewhere(*in_pitch, *stated);
            format!("{key}: {words}")
        }
        Finding::Outlier(outlier) => outlier::describe(of, outlier),
        Finding::ThicknessStatedTwice(compared) => thickness::stated_twice(of, compared),
    }
}

fn looks_like_whole(of: &Statements, quantity: Quantity, mean: f64) -> String {
    let (key, what) = match quantity {
        Quantity::Pitch => ("pitch", "the pitch itself"),
        Quantity::PerTooth => ("thickness.per_tooth_um", "the thickness itself"),
    };
    format!(
        "{}: the values are about {}, as {what} in mm; needed is the deviation of each tooth, in µm",
        of.table.path_of(key),
        ascii(mean, 3)
    )
}

fn same_kind(of: &Statements, kind: SameKind) -> String {
    let words = match kind {
        SameKind::Span => "a span over as many teeth",
        SameKind::OverPins => "a dimension over the same pins",
        SameKind::Chord => "a chord at the same height",
        SameKind::Allowance => "an allowance",
    };
    format!(
        "{}: is {words}, like the statement that is used, and repeats its faults: check by another kind of measurement (span, over pins, \
         another number of teeth or pin)",
        of.table.path_of(CROSS_CHECK)
    )
}
