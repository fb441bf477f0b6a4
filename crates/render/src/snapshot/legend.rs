//! The legend of lines, marks and colours.

use super::contacts;
use super::contacts::FORM_DASH;
use super::gears::{BASE_DASH, CENTRES_DASH, PITCH_DASH};
use crate::kit::{
    self, ACTION, Frame, GAP, GREY, INK, Ids, OVERLAP, PATH, PINION, Spot, TextStyle, WHEEL, arrow,
    dashed, diamond, dot, line,
};
use gearlash::gear::ProfilePart;
use svg::node::element::Group;

/// A note that applies to the printed sheet only.
const PAPER_NOTE: &str = "scales hold in print on A4";

/// Room for a sample, units of the sheet.
const SAMPLE: f64 = 36.0;

const WORDS: TextStyle = TextStyle::new(13.0);

/// The optional parts that a picture contains.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// A sheet of its own, true to scale in print; in a page the size varies.
    pub on_paper: bool,
    pub gap: bool,
    pub overlap: bool,
    pub touching: Vec<ProfilePart>,
    pub form: bool,
    pub tangent: bool,
    /// Base circles and lines of action; a drawn pair has none.
    pub base_circles: bool,
}

enum Sample<'a> {
    Contact,
    Meeting,
    OfAction,
    Tangent,
    /// A box with fills, one over the other.
    Fills(&'a [&'a str]),
    Dashes(&'a str),
    Curve(ProfilePart),
}

impl Sample<'_> {
    fn draw(&self, [x, y]: Spot) -> Group {
        let far = x + SAMPLE;
        let part = Group::new();
        match self {
            Sample::Contact => {
                part.add(arrow([x + 5.0, y], [far, y], 1.8))
                    .add(dot([x + 5.0, y], 4.0, true))
            }
            Sample::Meeting => kit::group([x + 8.0, far - 8.0].map(|x| dot([x, y], 4.0, false))),
            Sample::OfAction => part
                .add(line(&[[x + 8.0, y], [far - 8.0, y]], PATH, 6.0))
                .add(line(&[[x, y], [far, y]], ACTION, 1.2)),
            Sample::Tangent => part.add(diamond([x + 0.5 * SAMPLE, y])),
            Sample::Fills(fills) => {
                let frame = Frame::new([x + 4.0, y - 6.0], [far - 4.0, y + 6.0]);
                kit::group(fills.iter().map(|fill| frame.painted(fill, INK, "0.80")))
            }
            Sample::Dashes(dashes) => part.add(dashed(&[[x, y], [far, y]], GREY, 1.1, dashes)),
            Sample::Curve(curve) => contacts::sample(x, y, SAMPLE, *curve),
        }
    }
}

/// Rows of samples with their names, no wider than `room`, from the left end `at`; and the bottom of the last row.
pub fn draw(at: Spot, room: f64, shown: &Shown, ids: &Ids) -> (Group, f64) {
    let hatch = ids.url("hatch");
    let hatched = [OVERLAP, &hatch];
    let samples = [
        (
            "contact, normal out of the locked gear",
            Sample::Contact,
            true,
        ),
        (
            "points that meet as the free gear turns",
            Sample::Meeting,
            true,
        ),
        (
            "line of action, path of contact",
            Sample::OfAction,
            shown.base_circles,
        ),
        // For gears by data, the lines over the metal distinguish them.
        ("wheel", Sample::Fills(&[WHEEL]), !shown.base_circles),
        ("pinion", Sample::Fills(&[PINION]), !shown.base_circles),
        ("gap", Sample::Fills(&[GAP]), shown.gap),
        ("overlap", Sample::Fills(&hatched), shown.overlap),
        ("operating pitch circle", Sample::Dashes(PITCH_DASH), true),
        ("base circle", Sample::Dashes(BASE_DASH), shown.base_circles),
        ("form circle", Sample::Dashes(FORM_DASH), shown.form),
        ("base tangent point", Sample::Tangent, shown.tangent),
        ("line of centres", Sample::Dashes(CENTRES_DASH), true),
    ];
    let curves = ProfilePart::ALL.map(|curve| {
        let name = match curve {
            ProfilePart::Involute => "touching involute",
            ProfilePart::Fillet => "touching fillet",
            ProfilePart::Tip => "touching tip",
            ProfilePart::Root => "touching root",
        };
        (name, Sample::Curve(curve), shown.touching.contains(&curve))
    });
    let samples = samples
        .into_iter()
        .chain(curves)
        .filter(|(.., is_shown)| *is_shown);
    let mut group = Group::new();
    let [mut x, mut y] = at;
    for (name, sample, _) in samples {
        let width = SAMPLE + 8.0 + WORDS.width(name);
        if x + width > at[0] + room {
            [x, y] = [at[0], y + 25.0];
        }
        let words = WORDS.text(name, [x + SAMPLE + 8.0, y + 4.5]);
        group = group.add(sample.draw([x, y])).add(words);
        x += width + 16.0;
    }
    if !shown.on_paper {
        return (group, y);
    }
    if x + WORDS.width(PAPER_NOTE) > at[0] + room {
        y += 25.0;
    }
    let note = WORDS.grey().end();
    (group.add(note.text(PAPER_NOTE, [at[0] + room, y + 4.5])), y)
}
