//! How numbers, symbols and the user's words get into the page.

pub(super) use crate::bound::bound;
use crate::bound::scientific;
use crate::caption::decimals;
use crate::decimal::{fixed, shortest};
use gearlash::mesh::Contact;
use gearlash::outcome::Found;
use gearlash::study::Material;
pub(super) use gearlash_files::characters::plain;
use maud::{Markup, html};

/// A length given in mm as µm, with a true minus sign, never `−0.00`; a dash for none.
pub(super) fn um(length: Option<f64>, decimals: usize) -> String {
    value(length.map(|mm| mm * 1e3), decimals)
}

/// A number with so many decimals, likewise.
pub(super) fn value(number: Option<f64>, decimals: usize) -> String {
    let Some(number) = number else {
        return "–".to_owned();
    };
    fixed(number, decimals)
}

/// As short as reads back to the same number: what a user wrote.
pub(super) fn written(number: f64) -> String {
    shortest(number)
}

/// A centre distance in mm: three decimals, or as many as it has.
pub(super) fn distance(mm: f64) -> String {
    decimals(mm, 3, 9)
}

/// A difference, given in mm, in µm: four decimals, or its size where they would show none of it.
pub(super) fn fine(length: Option<f64>) -> String {
    match length {
        Some(mm) if mm != 0.0 && mm.abs() < 5e-7 => {
            let um = mm.abs() * 1e3;
            let power = um.log10().floor();
            let sign = if mm < 0.0 { "−" } else { "" };
            let digit = (um / 10f64.powf(power)).round();
            format!("{sign}{}", scientific(digit, power))
        }
        other => um(other, 4),
    }
}

/// `least … greatest`, in µm.
pub(super) fn band(ends: [Option<f64>; 2], decimals: usize) -> String {
    match ends {
        [None, None] => "–".to_owned(),
        [least, greatest] => format!("{} … {}", um(least, decimals), um(greatest, decimals)),
    }
}

/// `j_wt` as a symbol.
pub(super) fn j_wt() -> Markup {
    symbol("j", "wt")
}

/// A symbol with its index.
pub(super) fn symbol(letter: &str, index: &str) -> Markup {
    html! { i { (letter) } @if !index.is_empty() { sub { (index) } } }
}

/// What “K (8)” means.
pub(super) fn study() -> Markup {
    html! {
        p.note {
            "K (n): equation n of Karba, Yıldırım, Erdoğan, Vardar: "
            cite { "A study on prediction & validation of meshing gear pair backlash under various manufacturing and assembly errors" }
            "; model 1 below is its linear formula, named as there."
        }
    }
}

/// A material in words.
pub(super) fn material(material: Material) -> &'static str {
    match material {
        Material::Most => "most material",
        Material::Least => "least material",
        Material::AsMeasured => "as measured",
    }
}

/// Wheel and pinion tooth of a contact.
fn teeth(contact: &Option<Contact>) -> String {
    contact.as_ref().map_or("–".to_owned(), |contact| {
        format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth)
    })
}

/// The teeth that touch: right flanks, left flanks; wheel and pinion tooth each.
pub(super) fn touching(found: Option<Found>) -> [String; 2] {
    match found.and_then(|found| found.pose.swept.proven()) {
        None => ["–".to_owned(), "–".to_owned()],
        Some(lost_motion) => [teeth(&lost_motion.right), teeth(&lost_motion.left)],
    }
}

/// At most six of `all` by name.
pub(super) fn few<T>(all: &[T], name: impl Fn(&T) -> String) -> String {
    let named: Vec<String> = all.iter().take(6).map(name).collect();
    let more = if all.len() > 6 { ", …" } else { "" };
    named.join(", ") + more
}

/// A pose in words: mating, flank, fraction.
pub(super) fn pose(found: Found) -> String {
    let mating = found.pose.swept.pose.mating();
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!(", {} pitch beyond", decimals(fraction, 0, 4)),
    };
    let phase = found.run.run.phase;
    let phase = phase.map_or(String::new(), |(w, p)| format!(", phase {w}·{p}"));
    format!(
        "wheel {} with pinion {} at the {} flank{beyond}{phase}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_they_are_set() {
        assert_eq!(um(Some(-0.0162741), 2), "−16.27");
        assert_eq!(um(Some(-1e-9), 2), "0.00");
        assert_eq!(um(None, 2), "–");
        assert_eq!(distance(132.04), "132.040");
        assert_eq!(distance(132.12345), "132.12345");
        assert_eq!(distance(160.0), "160.000");
    }

    #[test]
    fn a_small_difference_shows_its_size() {
        assert_eq!(fine(Some(-2.2e-15)), "−2·10⁻¹²");
        assert_eq!(fine(Some(-2.25218e-2)), "−22.5218");
    }
}
