//! Findings about the measurements of a gear, in words.

use super::lead;
use super::pitch;
use super::profile;
use super::statements::Statements;
use super::thickness::CROSS_CHECK;
use gearlash::gear::{DIN_3967_SOURCE, Flank, Probe};
use gearlash::metrology::{
    Eccentricity, EccentricityNote, Finding, FittedReadings, FlankKnowledge, LeadKey, MeanOnly,
    Outlier, ProfileKey, Quantity, Reversal, RunoutSource, SameKind, StatementRole,
    ThicknessBesidePitch, ThicknessStatements, TooFar,
};
use gearlash_text::numbers::{ascii, rounded, shortest};
use std::borrow::Cow;

const PER_TOOTH: &str = "thickness.per_tooth_um";

/// The line that the user reads, with the key it is about.
pub fn describe(statements: &Statements, finding: &Finding) -> String {
    let key = statements.table.path_of(&key(statements, finding));
    format!("{key}: {}", words(statements, finding))
}

/// The key, below the gear's table, that a finding is about.
fn key(statements: &Statements, finding: &Finding) -> Cow<'static, str> {
    let table = statements.table;
    let key = match finding {
        Finding::PitchDoesNotClose { flank, .. } => pitch::key_of(table, *flank),
        Finding::LeftFlankReversed { .. } => pitch::key_of(table, Flank::Left),
        Finding::Outlier(Outlier::Pitch(found)) => pitch::key_of(table, found.flank),
        Finding::Outlier(Outlier::Reading(found)) if found.over_pins => "thickness.over_pins",
        Finding::Outlier(Outlier::Reading(_)) => "thickness.span",
        Finding::ProfileOfSomeTeeth(some) => {
            return profile::key_of(table, some.flank, ProfileKey::Trace).into();
        }
        Finding::LeadOfSomeTeeth(some) => {
            return lead::key_of(table, some.flank, LeadKey::Trace).into();
        }
        Finding::WobbleInLeads { .. } => "lead.axis",
        Finding::RunoutReadings(_) | Finding::RunoutContradictsFlanks(_) => "runout.file",
        Finding::RunoutWithoutDirection { .. } | Finding::StatedEccentricityElsewhere { .. } => {
            "runout"
        }
        Finding::EccentricityInPitch(_)
        | Finding::SpansRefusePitch { .. }
        | Finding::FirstHarmonicNotEccentricity { .. } => "pitch",
        Finding::OwnPitchHoldsEccentricity { .. } => "pitch.axis",
        Finding::PinsGiveMeanOnly { .. } => "thickness.over_pins",
        Finding::SpansGiveEachTooth { .. } | Finding::SpansGiveMeanOnly { .. } => "thickness.span",
        Finding::ThicknessBesidePitch(_)
        | Finding::SpansRefuseThickness { .. }
        | Finding::PerToothMeanTooLarge { .. }
        | Finding::PerToothOffMean { .. } => PER_TOOTH,
        Finding::LooksLikeWhole { quantity, .. } => match quantity {
            Quantity::Pitch => "pitch",
            Quantity::PerTooth => PER_TOOTH,
        },
        Finding::ThicknessField { .. } => "thickness.designation",
        Finding::AllowanceThickens { .. } | Finding::AllowanceTooLarge { .. } => {
            "thickness.allowance_um"
        }
        Finding::CrossCheckOfSameKind(_) | Finding::ThicknessStatedTwice(_) => CROSS_CHECK,
    };
    key.into()
}

fn words(statements: &Statements, finding: &Finding) -> String {
    match finding {
        Finding::PitchDoesNotClose {
            flank,
            sum_um,
            rounding_um,
        } => format!(
            "the single pitch deviations of the {} flanks sum to {} µm instead of 0 (rounding leaves up to {rounding_um:.2} µm); \
             the rest is distributed evenly over the teeth",
            flank.name(),
            ascii(*sum_um, 2),
        ),
        Finding::WobbleInLeads {
            um,
            tooth,
            apart_um,
        } => {
            let counts = match apart_um {
                None => "the gear wobbles so".to_owned(),
                Some(apart) => format!("the stated wobble counts, {apart:.2} µm off it"),
            };
            format!(
                "the leads about the bore contain a wobble of {um:.2} µm over the teeth, towards tooth {tooth:.2}; it is taken out of them, and {counts}"
            )
        }
        Finding::RunoutReadings(readings) => runout_readings(readings),
        Finding::RunoutContradictsFlanks(found) => format!(
            "beyond the first harmonic the readings contradict the flanks, which take precedence there. The readings vary by up to {:.3} µm, the stated flanks by \
             {:.3} µm; {} {} they differ by {:.3} µm. F_r of the readings is {:.3} µm. Check the gear, its tooth numbers, `sense` and `at`",
            found.read_um,
            found.said_um,
            match found.probe {
                Probe::Ball(_) => "after tooth",
                Probe::Fork => "at tooth",
            },
            found.tooth,
            found.apart_um,
            found.range_um,
        ),
        Finding::RunoutWithoutDirection { total_um } => format!(
            "{total_um} µm without high_tooth: least and greatest of the verdict are over every direction; single poses and the gauge have tooth 1 high"
        ),
        Finding::EccentricityInPitch(note) => in_pitch(note),
        Finding::ProfileOfSomeTeeth(some) | Finding::LeadOfSomeTeeth(some) => format!(
            "traces of {} of {} {} flanks; the other teeth take their mean",
            some.measured,
            some.teeth,
            some.flank.name()
        ),
        Finding::PinsGiveMeanOnly {
            readings,
            with_pitch,
        } => {
            let assumed = if *with_pitch {
                ""
            } else {
                "; without [pitch] the pitch is assumed even"
            };
            format!(
                "{readings} dimensions over pins give the mean thickness only, no thickness by tooth{assumed}"
            )
        }
        Finding::SpansGiveEachTooth {
            spanned,
            teeth,
            amplification,
            with_pitch,
        } => {
            let random = f64::from(*amplification).sqrt();
            let assumed = if *with_pitch {
                ""
            } else {
                "; without [pitch] all variation of the spans counts as thickness"
            };
            format!(
                "{teeth} spans over {spanned} teeth give each tooth's thickness; an error of the readings is amplified up to {amplification}-fold, \
                 {random:.1}-fold when random, as [uncertainty] counts it (per_tooth = false uses the mean only){assumed}"
            )
        }
        Finding::SpansGiveMeanOnly {
            spanned,
            teeth,
            readings,
            why,
            pitch_in_mean,
        } => mean_by_spans(*spanned, *teeth, *readings, *why, *pitch_in_mean),
        Finding::LeftFlankReversed { eccentricity_um } => {
            let contained = eccentricity_um.map_or(String::new(), |[reversed, stated]| {
                format!(" (reversed they contain an eccentricity of {reversed:.3} µm, as stated one of {stated:.3} µm)")
            });
            format!(
                "the left flanks vary opposite to the right ones, as if their sign were reversed{contained}: if + means plus material on both flanks \
                 (or the gear was seen from the other face), write sense = {:?}",
                statements.other_sense()
            )
        }
        Finding::ThicknessBesidePitch(beside) => beside_pitch(beside, statements.other_sense()),
        Finding::SpansRefusePitch {
            shown,
            left_um,
            spans_count,
        } => format!(
            "the spans contradict the thickness by its flanks, right minus left (they show {} % of it, and vary by {left_um:.1} µm r.m.s. beside it): check right and left, sign and tooth numbers; {}",
            ascii(100.0 * shown, 0),
            precedence(*spans_count)
        ),
        Finding::SpansRefuseThickness { shown, spans_count } => format!(
            "the spans contradict it (they show {} % of it): check its sign and tooth numbers, or leave it out; {}",
            ascii(100.0 * shown, 0),
            precedence(*spans_count)
        ),
        Finding::PerToothMeanTooLarge { mean_um } => format!(
            "its mean is {} µm, more than a tenth of the module: each value is how much thicker than the mean the tooth is, in µm; if they are \
             thicknesses, subtract their mean; if they are in another unit, convert them",
            ascii(*mean_um, 1)
        ),
        Finding::PerToothOffMean {
            mean_um,
            scatter_um,
        } => {
            let stated = statements.thickness.statement.key().unwrap_or_default();
            format!(
                "its mean, {} µm, adds to the stated {stated} (its values scatter about it by {scatter_um:.1} µm r.m.s.): if they were measured \
                 from the nominal thickness, and {stated} states the same, subtract their mean from the list",
                ascii(*mean_um, 1)
            )
        }
        Finding::LooksLikeWhole { quantity, mean_um } => {
            let what = match quantity {
                Quantity::Pitch => "the pitch itself",
                Quantity::PerTooth => "the thickness itself",
            };
            let mean = ascii(*mean_um, 3);
            format!(
                "the values are about {mean}, as {what} in mm; needed is the deviation of each tooth, in µm"
            )
        }
        Finding::ThicknessField {
            diameter_mm,
            upper_um,
            lower_um,
        } => format!(
            "at reference diameter {} mm the allowances are {} and {} µm, {DIN_3967_SOURCE}",
            shortest(rounded(*diameter_mm, 4)),
            ascii(*upper_um, 0),
            ascii(*lower_um, 0)
        ),
        Finding::AllowanceThickens { um } => format!(
            "{um} µm makes the teeth thicker than nominal, but an allowance for backlash makes them thinner: check its sign; if {} µm was \
             meant, write that",
            -um
        ),
        Finding::AllowanceTooLarge { um } => format!(
            "{um} µm takes more than a quarter of the module off the teeth: if nm were meant, write {}",
            shortest(um / 1000.0)
        ),
        Finding::CrossCheckOfSameKind(kind) => {
            let kind = match kind {
                SameKind::Span => "a span over as many teeth",
                SameKind::OverPins => "a dimension over the same pins",
                SameKind::Chord => "a chord at the same height",
                SameKind::Allowance => "an allowance",
            };
            format!(
                "is {kind}, like the statement that is used, and repeats its faults: check by another kind of measurement (span, over pins, \
                 another number of teeth or pin)"
            )
        }
        Finding::FirstHarmonicNotEccentricity {
            left_um,
            left_percent,
            alike,
            exchanged,
            eccentricity_um,
        } => {
            let (first, why) = if *alike {
                (
                    "",
                    "; both flanks vary equally, as from an index error of the machine",
                )
            } else if *exchanged {
                (
                    "right and left look exchanged: the other way round, their first harmonic is that of an eccentricity. Check which column is \
                     which. As stated, ",
                    "",
                )
            } else {
                ("", "")
            };
            format!(
                "{first}the first harmonic is not that of an eccentricity alone, whose waves on right and left flanks are twice the pressure angle apart. Of it, {left_um:.3} µm \
                 on a flank, {left_percent:.0} % of its energy, are used as the gear's own pitch{why}. The eccentricity of {eccentricity_um:.3} µm is therefore uncertain: measure the runout, \
                 and say in [pitch] which is used: eccentricity = \"pitch\" or \"runout\""
            )
        }
        Finding::OwnPitchHoldsEccentricity {
            in_pitch,
            in_runout,
            runout,
        } => {
            let own = shown(*in_runout);
            let runout = match runout {
                RunoutSource::Total => format!("[runout] says {own}, which would count twice"),
                RunoutSource::Readings { left } => format!(
                    "the readings of [runout] contain one of {own}. Used as the gear's own pitch the values explain the readings and leave {} as eccentricity",
                    left.map_or("nothing".to_owned(), shown),
                ),
            };
            format!(
                "the values look as if they were measured about the datum axis. Write axis = \"datum\" and eccentricity = \"pitch\" or \"runout\" \
                 if so. The first harmonic of the values is that of an eccentricity of {}; {runout}",
                shown(*in_pitch)
            )
        }
        Finding::StatedEccentricityElsewhere {
            in_pitch,
            stated,
            reversal,
        } => format!(
            "the pitch of both flanks contains the first harmonic of an eccentricity of {}; the one stated here is as large, {}{}. Both are \
             used: check the tooth, and whether the pitch was measured about the datum axis",
            shown(*in_pitch),
            shown(*stated),
            reversed(*reversal),
        ),
        Finding::Outlier(found) => outlier(found),
        Finding::ThicknessStatedTwice(compared) => stated_twice(statements, compared),
    }
}

fn precedence(spans_count: bool) -> &'static str {
    if spans_count {
        "the spans take precedence"
    } else {
        "it is used as given"
    }
}

fn shown(e: Eccentricity) -> String {
    format!("{:.3} µm towards tooth {:.2}", e.um, e.high_tooth)
}

/// How one of two statements of an eccentricity may be reversed, after the second.
fn reversed(reversal: Option<Reversal>) -> &'static str {
    match reversal {
        Some(Reversal::Sign) => " (half a turn apart: a sign may be reversed)",
        Some(Reversal::Numbering) => " (mirrored: check the numbering)",
        None => "",
    }
}

fn in_pitch(note: &EccentricityNote) -> String {
    let found = format!(
        "the datum-axis values contain an eccentricity of {}",
        shown(note.in_pitch)
    );
    let stated = note.stated.zip(note.difference_um).map(|(stated, um)| {
        let reversed = reversed(note.reversal);
        format!("{}, {um:.3} µm from it{reversed}", shown(stated))
    });
    match stated {
        Some(stated) if note.stated_counts => format!(
            "{found}. That of [runout], {stated}, is used and removed from them; the first harmonic that remains is used as the gear's own pitch"
        ),
        stated => format!(
            "{found}; it is used as the gear's, as a first harmonic of its own pitch looks alike{}",
            stated.map_or(String::new(), |stated| format!(
                "; that of [runout], {stated}, is not used"
            ))
        ),
    }
}

fn outlier(outlier: &Outlier) -> String {
    let why = match outlier {
        Outlier::Reading(reading) => match reading.why {
            TooFar::CoarseGear(um) => {
                format!("more than the {um:.0} µm by which even a coarse gear varies")
            }
            TooFar::HalfWithin(um) => format!("half of them within {um:.1} µm"),
        },
        Outlier::Pitch(pitch) => format!(
            "more than the {:.0} µm of even a coarse gear, half of the others within {:.1} µm",
            pitch.coarse_um, pitch.half_within_um
        ),
    };
    let (name, deviation) = (outlier_name(outlier), deviation(outlier));
    format!("{name} is {deviation}; {why}: check it; it is used as given")
}

/// The outlier as the end of a help text for impossible measurements.
pub fn suspected(outlier: &Outlier) -> String {
    format!(
        ", above all {}: it is {}",
        outlier_name(outlier),
        deviation(outlier)
    )
}

fn outlier_name(outlier: &Outlier) -> String {
    match outlier {
        Outlier::Reading(reading) => {
            let place = if reading.over_pins { "space" } else { "tooth" };
            format!(
                "the reading at {place} {}, {} mm,",
                reading.place, reading.mm
            )
        }
        Outlier::Pitch(pitch) => format!(
            "tooth {} of the {} flanks, {} µm,",
            pitch.tooth,
            pitch.flank.name(),
            pitch.um
        ),
    }
}

/// Its deviation and the reference it deviates from.
fn deviation(outlier: &Outlier) -> String {
    match outlier {
        Outlier::Reading(reading) => format!(
            "{} µm from the median of all {}, {}",
            ascii(reading.off_um, 1),
            reading.readings,
            if reading.flanks_taken_out {
                format!(
                    "{} mm, with the stated flanks' effect removed",
                    ascii(reading.median_mm, 4)
                )
            } else {
                format!("{} mm", reading.median_mm)
            }
        ),
        Outlier::Pitch(pitch) => format!(
            "{} µm from {}",
            ascii(pitch.off_um, 1),
            if pitch.from_neighbours {
                "its neighbours' mean"
            } else {
                "the median"
            }
        ),
    }
}

/// The eccentricity of runout readings.
fn runout_readings(readings: &FittedReadings) -> String {
    let [range, left] = [readings.range_um, readings.left_um].map(|um| ascii(um, 3));
    let fitted = shown(readings.eccentricity);
    match readings.knowledge {
        FlankKnowledge::NoPitch => format!(
            "the readings' first harmonic{} is an eccentricity of {fitted}, which is used as the gear's: without [pitch] a first harmonic of its own tooth \
             thickness cannot be distinguished from it. F_r, their range, is {range} µm; up to {left} µm of a reading is residual and ignored",
            if readings.flanks_taken_out {
                ", after removing the effect of the stated tooth thickness,"
            } else {
                ""
            },
        ),
        FlankKnowledge::Pitch => {
            let (probe, first) = (probe(readings.probe), shown(readings.first_harmonic));
            let found = match readings.in_pitch {
                None => format!(
                    "the eccentricity used, {fitted}, is from these readings, without the flanks' effect on {probe}. With it, their first harmonic is {first}"
                ),
                Some((used, apart)) => format!(
                    "the eccentricity used is {}, from [pitch]. The readings give {first}. With the flanks' effect on {probe} taken out, that is \
                     {fitted}, {apart:.3} µm off",
                    shown(used)
                ),
            };
            let ball = readings.by_ball_um.map_or(String::new(), |um| format!(
                ". State ball_mm: the ball is taken to touch at the reference circle; another that fits changes it by up to {um:.3} µm"
            ));
            format!(
                "{found}. F_r, their range, is {range} µm; up to {left} µm of a reading is residual and ignored{ball}"
            )
        }
        FlankKnowledge::DatumPitch => format!(
            "the readings' first harmonic is an eccentricity of {fitted}; datum-axis pitch cannot separate it from a first harmonic of the gear's own tooth \
             thickness, which looks the same in both. F_r, their range, is {range} µm; up to {left} µm of a reading is in neither that harmonic nor the pitch",
        ),
    }
}

fn probe(probe: Probe) -> String {
    match probe {
        Probe::Fork => "a fork at the pressure angle".to_owned(),
        Probe::Ball(mm) => format!("a ball of {mm:.3} mm"),
    }
}

/// `readings` spans over `k` of `z` teeth, which give only the mean.
fn mean_by_spans(k: u32, z: u32, readings: usize, why: MeanOnly, pitch_in_mean: bool) -> String {
    let mean_only = if pitch_in_mean {
        "; without [pitch] the pitch at these places stays in the mean thickness"
    } else {
        ""
    };
    let why = match why {
        MeanOnly::AsAsked => return format!("{readings} spans, {z} teeth{mean_only}"),
        MeanOnly::TooFew => format!("{readings} spans do not determine {z} teeth"),
        MeanOnly::Undetermined { other } => {
            let other = other.map_or(String::new(), |k| format!(" (spans over {k} teeth would)"));
            format!(
                "{z} spans over {k} teeth do not determine single teeth{other}: thickness that alternates from tooth i to tooth i + {} shows in no span",
                k - 1
            )
        }
    };
    format!("{why}; only the mean thickness is used{mean_only}")
}

/// Per-tooth thickness compared with the pitch of both flanks; `other_sense` reads the left flank the other way round.
fn beside_pitch(beside: &ThicknessBesidePitch, other_sense: &str) -> String {
    match beside {
        ThicknessBesidePitch::Same => {
            "repeats the pitch of both flanks (a tooth is thicker by right minus left pitch deviation), and the two are added: \
             leave it out, unless the teeth are thicker by that much again"
                .to_owned()
        }
        ThicknessBesidePitch::TakenBack => {
            "cancels the thickness that the pitch of both flanks gives (right minus left pitch deviation): check which of the two is reversed; \
             where both were measured on the same teeth, leave it out"
                .to_owned()
        }
        ThicknessBesidePitch::SameIfReversed => format!(
            "is the thickness that the pitch would give with the left flanks reversed: write pitch.sense = {other_sense:?} and leave it out, \
             since the two are added"
        ),
        ThicknessBesidePitch::SameIfMoved { by, down } => format!(
            "repeats the pitch of both flanks, shifted {} by {by} in tooth number, and the two are added: check the tooth \
             numbers of both; if they are of the same teeth, leave it out",
            if *down { "down" } else { "up" }
        ),
        ThicknessBesidePitch::Different {
            list_um,
            pitch_um,
            tooth,
            apart_um,
        } => format!(
            "the teeth vary by {list_um:.3} µm by this list and by {pitch_um:.3} µm by the pitch of both flanks (right minus left); \
             at tooth {tooth} they are {apart_um:.3} µm apart. The two are added: where both were measured on the same teeth, leave one of them out"
        ),
    }
}

/// The cross-check compared with the statement that counts, in words.
fn stated_twice(statements: &Statements, compared: &ThicknessStatements) -> String {
    let range = |[least, most]: [f64; 2]| {
        if least == most {
            format!("{least:.6} mm")
        } else {
            format!("{least:.6} … {most:.6} mm")
        }
    };
    let bands = [compared.counts, compared.cross].map(|[least, most]| least < most);
    let [gap, tolerance] = [compared.gap_um, compared.tolerance_um].map(|um| ascii(um, 1));
    let outside = match bands {
        [false, false] => "".to_owned(),
        [true, true] => format!("the bands lie {gap} µm apart, "),
        _ => format!("the single value lies {gap} µm outside the band, "),
    };
    let verdict = if !compared.agree() {
        format!(
            "{outside}{tolerance} µm is allowed: check both measurements, the pins and the number of teeth spanned"
        )
    } else if compared.gap_um > 0.0 {
        format!("{outside}within the tolerance of {tolerance} µm: they agree")
    } else {
        "they agree".to_owned()
    };
    let key = |role| statements.of_thickness(role).0.key().unwrap_or_default();
    format!(
        "base thickness {} by {}, {} by {}, difference{} {} µm: {verdict}",
        range(compared.counts),
        key(StatementRole::Counts),
        range(compared.cross),
        key(StatementRole::CrossCheck),
        if bands == [false, false] {
            ""
        } else {
            " of the means"
        },
        ascii(compared.difference_um, 2),
    )
}
