//! Accuracy grades of pitch and runout as measured by the gauge, beside the required ones; consistency of the statements about a gear.

use super::page::Page;
use super::phrases::symbol;
use super::table::{Table, cells, columns, marked};
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash::gauge::{GradedReading, PitchReadings};
use gearlash::gear::{Flank, GRADE_SOURCE, GradedQuantity, PitchAxis};
use gearlash::metrology::{AllRoundNote, Eccentricity, EccentricityNote, ThicknessStatements};
use gearlash_results::gauge::GearGrades;
use gearlash_text::numbers::{fixed, um};
use maud::{Markup, html};

pub(super) fn table(page: &Page) -> Markup {
    let gears = page.report.grades;
    let mut readings = gears.iter().flat_map(|gear| gear.graded.iter().flatten());
    let any = readings.next().is_some();
    let required = gears.iter().any(|gear| gear.required.is_some());
    let mut rows = Vec::new();
    for gear in gears {
        let readings = gear.graded.iter().flatten();
        rows.extend(readings.map(|reading| graded(gear, reading)));
        let pitches = gear.pitches.iter();
        for pitch in pitches.filter(|pitch| pitch.axis == PitchAxis::Datum) {
            let flanks = Flank::BOTH.map(|flank| ungraded(gear.name, pitch, flank));
            rows.extend(flanks.into_iter().flatten());
        }
    }
    let mut columns = columns(
        "gear | symbol:w | deviation | measured µm:n | grade:n | its tolerance µm:n | required grade",
    );
    columns[6].is_shown = required;
    html! {
        @if any {
            (Table::new("Accuracy grades", html! { "Accuracy grades " (GRADE_SOURCE) }, columns, rows).named_by(2))
            p.note {
                "Read on the modelled gears as “gearlash gauge” reads them: pitch about the datum axis, which is what a standard grades, "
                "and about the gear’s own centre; runout with a ball in every space, so that the pitch and the thickness of the teeth are in it, "
                "not the eccentricity alone. The formulas grade " (symbol("f", "p")) ", " (symbol("F", "p")) " and " (symbol("F", "r")) " alone"
                @if page.report.pair.study.is_helical() {
                    ", by the reference diameter " i { "d" } " and the normal module " (symbol("m", "n")) "; pitch in the transverse section of the measuring plane. "
                    "Helix deviations are not graded"
                }
                "."
            }
        }
        @for gear in gears {
            @if let Err(reason) = &gear.graded { p.note { "No accuracy grade for the " (gear.name) ": " (reason.to_string()) "." } }
            @if let (Ok([]), Some(grade)) = (gear.graded.as_deref(), gear.required) { p.note { "Grade " (grade) " is required of the " (gear.name) "; no deviation is given to be graded." } }
        }
    }
}

fn flank_and_axis(pitch: Option<(PitchAxis, Flank)>) -> String {
    pitch.map_or(String::new(), |(axis, flank)| {
        let about = match axis {
            PitchAxis::Datum => "datum axis",
            PitchAxis::Own => "own centre",
        };
        format!(", {} flanks, {about}", flank.name())
    })
}

fn graded(gear: &GearGrades, reading: &GradedReading) -> Vec<Markup> {
    let (sign, name) = match reading.quantity {
        GradedQuantity::SinglePitch => (symbol("f", "p"), "single pitch"),
        GradedQuantity::TotalPitch => (symbol("F", "p"), "total cumulative pitch"),
        GradedQuantity::Runout => (symbol("F", "r"), "runout, by a ball"),
    };
    let found = reading.grade;
    // Readings about the gear's own centre are outside the standard's grades.
    let own = matches!(reading.pitch, Some((PitchAxis::Own, _)));
    let wanted = gear.required.filter(|_| !own);
    let met = match wanted {
        None => html! { "–" },
        Some(wanted) if found.admits && found.grade <= wanted => {
            marked(CheckVerdict::Pass, &format!("{wanted}, met"))
        }
        Some(wanted) => marked(CheckVerdict::Fail, &format!("{wanted}, not met")),
    };
    cells![
        gear.name,
        sign,
        html! { (name) (flank_and_axis(reading.pitch)) },
        um(reading.measured, 3),
        found.words(),
        um(found.tolerance, 1),
        met,
    ]
}

/// Deviations that inspection sheets list in addition to graded ones.
fn ungraded(gear: &str, pitch: &PitchReadings, flank: Flank) -> [Vec<Markup>; 3] {
    let eighth = "cumulative pitch over an eighth of the teeth";
    let adjacent = pitch.cumulative.adjacent_difference(flank);
    let range = pitch.cumulative.single_range(flank);
    [
        ("f", "u", "difference of adjacent pitches", adjacent),
        ("F", "p(z/8)", eighth, pitch.cumulative.eighth(flank)),
        ("R", "p", "range of the single pitch", range),
    ]
    .map(|(letter, index, name, mm)| {
        let name = html! { (name) (flank_and_axis(Some((pitch.axis, flank)))) };
        let symbol = symbol(letter, index);
        cells![gear, symbol, name, um(mm, 3), "–", "–", "–"]
    })
}

pub(super) fn notes(page: &Page) -> Markup {
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
            fixed(of.um, 3),
            fixed(of.high_tooth, 2)
        )
    };
    html! {
        "the pitch, measured about the datum axis, contains an eccentricity of " (words(&note.in_pitch))
        @if let Some(stated) = &note.stated {
            "; the runout states " (words(stated))
            @if let Some(difference) = note.difference_um {
                ", " (fixed(difference, 3)) " µm from it"
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
            fixed(least, 5)
        } else {
            format!("{} … {}", fixed(least, 5), fixed(most, 5))
        }
    };
    html! {
        "base tooth thickness " (symbol("s", "b")) " is stated twice: " (range(note.counts))
        " mm counts, " (range(note.cross)) " mm is the cross-check, in the middle "
        (fixed(note.difference_um, 2)) " µm off. "
        @if note.agree() { "They agree." } @else {
            "They do not agree: " (fixed(note.gap_um, 2)) " µm lie between them, "
            (fixed(note.tolerance_um, 2)) " µm are allowed."
        }
    }
}
