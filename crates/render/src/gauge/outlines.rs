//! Spans and pins read on outlines, as a short table of each gear.

use gearlash::contact::{ToothPlace, Touch};
use gearlash::gauge::OverPins;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{ascii, order_um, um_ascii};
use gearlash_results::gauge::GaugedOutline;
use gearlash_results::text::{Column, Screen, Table};
use std::fmt::Write;

const LEGEND: &str = "
Lengths in mm; range and bound in µm. At: the first tooth spanned, or the tooth before the space of the (first) pin. The anvils reach \
down to a third of the depth above the root. Pitch, thickness and the roll test need an involute, which an outline has not.";

/// The text `gauge` prints of outlines on `screen`; with `by_position` every reading tooth by tooth, too.
pub fn outlines(
    title: &str,
    gears: &[GaugedOutline],
    by_position: bool,
    screen: &Screen,
) -> String {
    let mut text = format!("{}\n", plain(title));
    for gauged in gears {
        let _ = write!(text, "\n{}\n\n", gauged.words());
        text += &lengths(gauged, screen);
        for line in gauged.unmeasured() {
            let _ = writeln!(text, "{line}");
        }
        text += &remarks(gauged);
        if by_position {
            text += &positions(gauged);
        }
    }
    text += &screen.paragraphs(LEGEND);
    screen.fold(&text)
}

/// A reading: tooth, length and bound, mm.
type Read = (u32, f64, f64);

fn lengths(gauged: &GaugedOutline, screen: &Screen) -> String {
    let headings = ["", "least", "at", "mean", "greatest", "at"].map(Column::new);
    let spare = [Column::new("range").spare(1), Column::new("bound").spare(2)];
    let mut table = Table::new(headings.into_iter().chain(spare));
    let mut rows = 0;
    let mut add = |name: String, mean: f64, read: Vec<Read>| {
        let least = read.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let most = read.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let bound = read.iter().fold(0.0, |most, one| f64::max(most, one.2));
        let (Some(least), Some(most)) = (least, most) else {
            return;
        };
        let range = most.1 - least.1;
        // What differs by less than it is known stands nowhere in particular.
        let at = |tooth: u32| match range > bound {
            true => tooth.to_string(),
            false => String::new(),
        };
        rows += 1;
        table.add(vec![
            name,
            ascii(least.1, 4),
            at(least.0),
            ascii(mean, 4),
            ascii(most.1, 4),
            at(most.0),
            um_ascii(range, 3),
            order_um(bound),
        ]);
    };
    if let Some(Ok(spans)) = &gauged.gauged.spans {
        let read = spans.readings.iter();
        let read = read.map(|one| (one.first_tooth, one.length, one.error));
        add(
            format!("span W_{}", spans.teeth),
            spans.mean(),
            read.collect(),
        );
    }
    if let Some(Ok(pins)) = &gauged.gauged.pins {
        for (list, count) in [(&pins.two, "two"), (&pins.three, "three")] {
            if !list.is_empty() {
                let read = list.iter().map(|one| (one.tooth, one.length, one.error));
                let name = format!("M_dK, {count} pins {} mm", pins.diameter);
                add(name, OverPins::mean(list), read.collect());
            }
        }
    }
    match rows {
        0 => String::new(),
        _ => table.text(screen),
    }
}

/// What touched the tip or the root.
fn remarks(gauged: &GaugedOutline) -> String {
    let spans = gauged.gauged.spans.iter().flatten();
    let spans = spans
        .flat_map(|spans| &spans.readings)
        .map(|one| one.touched);
    let pins = gauged.gauged.pins.iter().flatten();
    let pins = pins.flat_map(|pins| &pins.seats).map(|seat| seat.touched);
    let kinds: [(&str, Vec<[Touch; 2]>); 2] =
        [("spans", spans.collect()), ("pins", pins.collect())];
    let mut text = String::new();
    for (what, touches) in &kinds {
        for region in [ToothPlace::Tip, ToothPlace::Root] {
            let on = |both: &&[Touch; 2]| both.iter().any(|touch| touch.curve == region);
            let count = touches.iter().filter(on).count();
            if count > 0 {
                let (all, region) = (touches.len(), region.name());
                let _ = writeln!(
                    text,
                    "{count} of {all} {what} touch the {region}, not the flanks alone"
                );
            }
        }
    }
    text
}

fn positions(gauged: &GaugedOutline) -> String {
    format!("\n{}", gauged.by_tooth().text())
}
