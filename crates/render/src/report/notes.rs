//! Consistency of the statements about a gear.

use super::page::Page;
use super::phrases::symbol;
use gearlash::metrology::{AllRoundNote, Eccentricity, EccentricityNote, ThicknessStatements};
use gearlash_files::numbers::fixed;
use maud::{Markup, html};

pub(super) fn list(page: &Page) -> Markup {
    let notes = &page.report.pair.study.notes;
    let first = page.report.pair.study.materials.first();
    let teeth = first.map_or([0; 2], |(_, wheel, pinion)| {
        [wheel, pinion].map(|gear| gear.gear().basic_data().teeth() as usize)
    });
    let gears = || {
        let named = ["Wheel", "Pinion"].into_iter().zip(teeth);
        named.zip(notes)
    };
    let any = gears().any(|(_, of)| {
        of.eccentricity.is_some() || of.all_round.is_some() || of.thickness.is_some()
    });
    html! {
        @if any {
            h3 { "What the measurements say of each other" }
            ul {
                @for ((gear, teeth), of) in gears() {
                    @if let Some(note) = &of.eccentricity { li { (gear) ": " (eccentricity(note)) } }
                    @if let Some(note) = &of.all_round { li { (gear) ": " (all_round(note, teeth)) } }
                    @if let Some(note) = &of.thickness { li { (gear) ": " (thickness(note)) } }
                }
            }
        }
    }
}

fn eccentricity(note: &EccentricityNote) -> Markup {
    let words = |of: &Eccentricity| {
        format!(
            "{} µm towards tooth {}",
            fixed(Some(of.um), 3),
            fixed(Some(of.high_tooth), 2)
        )
    };
    html! {
        "the pitch, measured about the datum axis, contains an eccentricity of " (words(&note.in_pitch))
        @if let Some(stated) = &note.stated {
            "; the runout states " (words(stated))
            @if let Some(difference) = note.difference_um {
                ", " (fixed(Some(difference), 3)) " µm from it"
            }
        }
        @if note.stated_counts { "; the stated one is the gear’s." } @else { "; the gear is given that of the pitch." }
    }
}

fn all_round(note: &AllRoundNote, teeth: usize) -> Markup {
    html! {
        (note.readings) " readings"
        @if note.readings == teeth { " all round " } @else { ", not all round, " }
        @match note.amplification {
            Some(1) => "give each tooth’s own thickness; an error of a reading does not grow in it.",
            Some(times) => {
                "give each tooth’s own thickness; an error of a reading grows in it " (times) " times at worst."
            }
            None => "give the mean thickness alone.",
        }
    }
}

fn thickness(note: &ThicknessStatements) -> Markup {
    let range = |[least, most]: [f64; 2]| {
        if least == most {
            fixed(Some(least), 5)
        } else {
            format!("{} … {}", fixed(Some(least), 5), fixed(Some(most), 5))
        }
    };
    html! {
        "base tooth thickness " (symbol("s", "b")) " is stated twice: " (range(note.counts))
        " mm counts, " (range(note.cross)) " mm is the cross-check, in the middle "
        (fixed(Some(note.difference_um), 2)) " µm off. "
        @if note.agree() { "They agree." } @else {
            "They do not agree: " (fixed(Some(note.gap_um), 2)) " µm lie between them, "
            (fixed(Some(note.tolerance_um), 2)) " µm are allowed."
        }
    }
}
