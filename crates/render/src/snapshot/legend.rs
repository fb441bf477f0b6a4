//! The legend of lines, marks and colours.

use super::contacts::{self, FORM_DASH};
use super::gears::{BASE_DASH, CENTRES_DASH, PITCH_DASH};
use super::subject::Layout;
use super::view::View;
use crate::kit::{
    self, ACTION, Frame, GAP, GREY, INK, Ids, OVERLAP, PATH, PINION, Spot, TextStyle, WHEEL, arrow,
    dashed, diamond, dot, line,
};
use gearlash::contact::{DrawnContact, Scene};
use gearlash::gear::ProfilePart;
use gearlash::pair::Member;
use svg::node::element::Group;

/// A note that applies to the printed sheet only.
const PAPER_NOTE: &str = "scales hold in print on A4";

/// Room for a sample, units of the sheet.
const SAMPLE: f64 = 36.0;

const WORDS: TextStyle = TextStyle::new(13.0);

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

/// Rows of samples with their names for what the picture of `scene` in `main` contains; and the bottom of the last row.
pub fn draw(layout: &Layout, scene: &Scene, main: &View, ids: &Ids, overlap: bool) -> (Group, f64) {
    let (at, room) = (layout.legend, layout.room());
    let any = |holds: &dyn Fn(&DrawnContact) -> bool| scene.contacts().iter().any(holds);
    // A drawn pair has no base circles and lines of action.
    let base_circles = scene.placed(Member::Wheel).base_radius().is_some();
    let form = any(&|contact| contacts::below_form(scene, contact).next().is_some());
    let tangent = any(&|contact| !contacts::tangent_points(scene, contact, main).is_empty());
    let touches = |contact: &DrawnContact, curve: ProfilePart| {
        let mut parts = Member::BOTH
            .into_iter()
            .filter_map(|member| contacts::part_on(scene, contact, member));
        parts.any(|(part, _)| part == curve)
    };
    let hatch = ids.url("hatch");
    let hatched = [OVERLAP, &hatch];
    let contact = "contact, normal out of the locked gear";
    let meeting = "points that meet as the free gear turns";
    let of_action = "line of action, path of contact";
    let samples = [
        (contact, Sample::Contact, true),
        (meeting, Sample::Meeting, true),
        (of_action, Sample::OfAction, base_circles),
        // For gears by data, the lines over the metal distinguish them.
        ("wheel", Sample::Fills(&[WHEEL]), !base_circles),
        ("pinion", Sample::Fills(&[PINION]), !base_circles),
        (
            "gap",
            Sample::Fills(&[GAP]),
            any(&|contact| !scene.room_between(contact, main.chord()).is_empty()),
        ),
        ("overlap", Sample::Fills(&hatched), overlap),
        ("operating pitch circle", Sample::Dashes(PITCH_DASH), true),
        ("base circle", Sample::Dashes(BASE_DASH), base_circles),
        ("form circle", Sample::Dashes(FORM_DASH), form),
        ("base tangent point", Sample::Tangent, tangent),
        ("line of centres", Sample::Dashes(CENTRES_DASH), true),
    ];
    let curves = ProfilePart::ALL.map(|curve| {
        let name = match curve {
            ProfilePart::Involute => "touching involute",
            ProfilePart::Fillet => "touching fillet",
            ProfilePart::Tip => "touching tip",
            ProfilePart::Root => "touching root",
        };
        let is_shown = any(&|contact| touches(contact, curve));
        (name, Sample::Curve(curve), is_shown)
    });
    let samples = samples.into_iter().chain(curves);
    let samples = samples.filter(|(.., is_shown)| *is_shown);
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
    // In a page the size varies.
    if !ids.is_sheet() {
        return (group, y);
    }
    if x + WORDS.width(PAPER_NOTE) > at[0] + room {
        y += 25.0;
    }
    let note = WORDS.grey().end();
    (group.add(note.text(PAPER_NOTE, [at[0] + room, y + 4.5])), y)
}
