//! The difference of two outlines of one gear, as text.

use crate::difference::{difference_sentence, turn_words};
use crate::layout::{Column, Screen, Table, Tone};
use gearlash::outline::Deviation;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{ascii, bound_um, signed_um, um_ascii};
use gearlash_files::outlines::ComparedOutlines;

/// The difference as text on `screen`, judged by `tolerance_um` if there is one.
pub fn text(compared: &ComparedOutlines, tolerance_um: Option<f64>, screen: &Screen) -> String {
    let [a, b] = &compared.files;
    let verdict = tolerance_um.map_or(String::new(), |tolerance| {
        let (tone, words) = if compared.passes(tolerance_um) {
            (Tone::Good, "Agree within")
        } else {
            (Tone::Bad, "DIFFER by more than")
        };
        let words = format!("{words} {tolerance} µm + error bound");
        format!("{}: ", screen.toned(tone, &words))
    });
    let title = plain(&format!("A {a} and B {b}"));
    let mut text = format!("{title}\n\n{verdict}{}\n\n", difference_sentence(compared));
    let found = &compared.difference;
    let mut places = Table::new([
        Column::new("").left(),
        Column::new("µm"),
        Column::new("tooth of A"),
        Column::new("x mm"),
        Column::new("y mm"),
        Column::new("radius mm"),
    ]);
    let mut add = |name: &str, at: &Deviation| {
        let place = compared.in_drawing(at);
        places.add(vec![
            name.to_owned(),
            signed_um(at.beyond, 2),
            at.tooth.to_string(),
            ascii(place.x, 4),
            ascii(place.y, 4),
            ascii(at.point.coords.norm(), 4),
        ]);
    };
    add("greatest", &found.greatest);
    add("least", &found.least);
    let mut drawings = Table::new([
        Column::new("").left(),
        Column::new("teeth"),
        Column::new("root diameter mm"),
        Column::new("tip diameter mm"),
        Column::new("centre mm").left(),
        Column::new("within µm"),
    ]);
    for (k, name) in ["A", "B"].into_iter().enumerate() {
        let (gear, centre) = (&compared.gears[k], compared.centres[k]);
        drawings.add(vec![
            name.to_owned(),
            gear.teeth().to_string(),
            ascii(2.0 * gear.root_radius(), 4),
            ascii(2.0 * gear.tip_radius(), 4),
            format!("{}, {}", ascii(centre.x, 4), ascii(centre.y, 4)),
            um_ascii(gear.bound(), 4),
        ]);
    }
    text += &format!(
        "{}\n{}\n{}\nPlus: B has more material. Places are in A's drawing; each deviation is within {} µm.\n",
        places.text(screen),
        drawings.text(screen),
        turn_words(compared),
        bound_um(found.bound)
    );
    screen.fold(&text)
}
