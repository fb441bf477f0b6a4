//! What the user should know of readings all round.

use super::faults::Drawing;
use super::flanks::Flanks;
use super::thickness::Statement;
use gearlash::gear::{Gear, Spans, thickness};

/// A warning where readings all round determine more or less than one might think.
pub fn told(drawing: &Drawing, flanks: &Flanks) -> Option<String> {
    let table = drawing.table;
    let note = flanks.all_round?;
    let (readings, z) = (note.readings, drawing.design.basic_data.teeth());
    let with_pitch = flanks.stated.pitch.is_some();
    match &drawing.statement {
        Statement::Pins { .. } => {
            let pitch = match with_pitch {
                true => "",
                false => "; without [pitch] that is taken as even",
            };
            Some(format!(
                "{}: {readings} dimensions over pins give the mean thickness only, no thickness by tooth{pitch}",
                table.path_of("thickness.over_pins")
            ))
        }
        Statement::Spans {
            teeth: k,
            per_tooth,
            ..
        } => {
            let key = table.path_of("thickness.span");
            if let Some(growth) = note.amplification {
                let pitch = match with_pitch {
                    true => "",
                    false => "; without [pitch] all unevenness of the spans counts as thickness",
                };
                return Some(format!(
                    "{key}: {z} spans over {k} teeth give each tooth's thickness; an error of the readings grows in it up to {growth}-fold, \
                     {:.1}-fold when random (per_tooth = false takes the mean only){pitch}",
                    f64::from(growth).sqrt()
                ));
            }
            let mean_only = match (readings < z as usize, with_pitch) {
                (true, true) => "",
                (true, false) => {
                    "; without [pitch] its part in these places stays in the mean thickness"
                }
                // All round the pitch of each flank is 0 in the mean.
                (false, _) => "",
            };
            if !per_tooth {
                return (!mean_only.is_empty())
                    .then(|| format!("{key}: {readings} spans, {z} teeth{mean_only}"));
            }
            let why = if readings < z as usize {
                format!("{readings} spans do not determine {z} teeth")
            } else {
                let other = other_span(flanks.gears.most())
                    .map_or(String::new(), |k| format!(" (spans over {k} teeth would)"));
                format!(
                    "{z} spans over {k} teeth do not determine single teeth{other}: thickness that alternates from tooth i to tooth i + {} shows in none of them",
                    k - 1
                )
            };
            Some(format!(
                "{key}: {why}; only the mean thickness is taken{mean_only}"
            ))
        }
        _ => None,
    }
}

/// A number of teeth whose spans all round determine every tooth of `gear`.
fn other_span(gear: &Gear) -> Option<u32> {
    let z = gear.basic_data().teeth();
    (2..=z).find(|&k| Spans::determine(z, k) && thickness::check_span(gear, k).is_ok())
}
