//! Findings about the eccentricity in pitch, in words.

use crate::numbers::ascii;
use crate::statements::Statements;
use gearlash::gear::Flank;
use gearlash::metrology::{Eccentricity, EccentricityNote, RunoutSource};

/// An eccentricity in words.
pub fn shown(e: Eccentricity) -> String {
    let [um, tooth] = [ascii(e.um, 3), ascii(e.high_tooth, 2)];
    format!("{um} µm towards tooth {tooth}")
}

/// The eccentricity contained in datum-axis pitch.
pub fn in_pitch(note: &EccentricityNote) -> String {
    let found = shown(note.in_pitch);
    match (note.stated, note.difference_um) {
        (Some(stated), Some(difference)) if note.stated_counts => format!(
            "the datum-axis values contain an eccentricity of {found}. That of [runout], {}, {} µm from it, is used and removed \
             from them; the first harmonic that remains is used as the gear's own pitch",
            shown(stated),
            ascii(difference, 3),
        ),
        (stated, difference) => {
            let beside = match (stated, difference) {
                (Some(stated), Some(difference)) => format!(
                    "; that of [runout], {}, {} µm from it, is not used",
                    shown(stated),
                    ascii(difference, 3)
                ),
                _ => String::new(),
            };
            format!(
                "the datum-axis values contain an eccentricity of {found}, which is used as the gear's \
                 (a first harmonic of its own pitch cannot be distinguished from it){beside}"
            )
        }
    }
}

/// An eccentricity in own-axis pitch, which should be free of it.
pub fn in_own_pitch(in_pitch: Eccentricity, stated: Eccentricity, runout: RunoutSource) -> String {
    format!(
        "the values look as if they were measured about the datum axis: their first harmonic is that of an eccentricity of {}, and {}: \
             if so, write axis = \"datum\" and eccentricity = \"pitch\" or \"runout\"",
        shown(in_pitch),
        match runout {
            RunoutSource::Total => {
                format!("[runout] says {}, which would count twice", shown(stated))
            }
            RunoutSource::Readings { left } => format!(
                "the readings of [runout] contain one of {}; used as the gear's own pitch the values explain the readings and leave {} as eccentricity",
                shown(stated),
                left.map_or("nothing".to_owned(), shown),
            ),
        },
    )
}

/// An eccentricity in own-axis pitch that points to another tooth than the stated one.
pub fn stated_elsewhere(in_pitch: Eccentricity, stated: Eccentricity) -> String {
    format!(
        "the pitch of both flanks contains the first harmonic of an eccentricity of {}, as large as the one stated here, {}, and both are \
         used: check the tooth, and whether the pitch was measured about the datum axis",
        shown(in_pitch),
        shown(stated),
    )
}

/// Left flanks that vary opposite to the right ones, with the eccentricity they contain if reversed and as stated.
pub fn left_reversed(of: &Statements, eccentricity_um: Option<[f64; 2]>) -> String {
    let eccentricities = eccentricity_um.map_or(String::new(), |[reversed, stated]| {
        let [reversed, stated] = [reversed, stated].map(|um| ascii(um, 3));
        format!(
            " (reversed they contain an eccentricity of {reversed} µm, as stated one of {stated} µm)"
        )
    });
    format!(
        "{}: the left flanks vary opposite to the right ones, as if their sign were reversed{eccentricities}: if + means plus material on both flanks \
         (or the gear was seen from the other face), write sense = {:?}",
        of.table.path_of(of.pitch_key(Flank::Left)),
        of.other_sense()
    )
}
