//! Findings about the tooth thickness, in words.

use crate::numbers::ascii;
use crate::statements::Statements;
use gearlash::metrology::{MeanOnly, StatementRole, ThicknessBesidePitch, ThicknessStatements};

/// `readings` spans over `k` of `z` teeth, which give only the mean.
pub fn mean_by_spans(
    k: u32,
    z: u32,
    readings: usize,
    why: MeanOnly,
    pitch_in_mean: bool,
) -> String {
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
pub fn beside_pitch(beside: &ThicknessBesidePitch, other_sense: &str) -> String {
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
            "the teeth vary by {} µm by this list and by {} µm by the pitch of both flanks (right minus left), \
             {} µm apart at tooth {tooth}; the two are added: where both were measured on the same teeth, leave one of them out",
            ascii(*list_um, 3),
            ascii(*pitch_um, 3),
            ascii(*apart_um, 3)
        ),
    }
}

/// The cross-check compared with the statement that counts, in words.
pub fn stated_twice(of: &Statements, compared: &ThicknessStatements) -> String {
    let range = |[least, most]: [f64; 2]| {
        if least == most {
            format!("{} mm", ascii(least, 6))
        } else {
            format!("{} … {} mm", ascii(least, 6), ascii(most, 6))
        }
    };
    let bands = [compared.counts, compared.cross].map(|[least, most]| least < most);
    let [gap, tolerance] = [compared.gap_um, compared.tolerance_um].map(|um| ascii(um, 1));
    let outside = match bands {
        [false, false] => "".to_owned(),
        [true, true] => format!("the bands lie {gap} µm apart, "),
        _ => format!("the single value lies {gap} µm outside the band, "),
    };
    let verdict = match (compared.agree(), compared.gap_um > 0.0) {
        (true, false) => "they agree".to_owned(),
        (true, true) => {
            format!("{outside}within the tolerance of {tolerance} µm: they agree")
        }
        (false, _) => format!(
            "{outside}{tolerance} µm is allowed: check both measurements, the pins and the number of teeth spanned"
        ),
    };
    let key = |role| of.of_thickness(role).0.key().unwrap_or_default();
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
