//! The legend of lines, marks and colours.

use super::contact_bands;
use super::contact_bands::FORM_DASH;
use super::gears::{BASE_DASH, CENTRES_DASH, PITCH_DASH};
use crate::kit::{
    ACTION, Frame, GAP, GREY, INK, Ids, OVERLAP, PATH, PINION, Spot, TextStyle, WHEEL, arrow,
    diamond, dot, line,
};
use gearlash::gear::ProfilePart;
use svg::node::element::Group;

/// Samples that only some kinds of gear have.
const WHEEL_NAME: &str = "wheel";
const PINION_NAME: &str = "pinion";
const MEETING: &str = "points that meet as the free gear turns";
const OF_ACTION: &str = "line of action, path of contact";

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
    /// A gap.
    pub gap: bool,
    /// An overlap.
    pub overlap: bool,
    /// The kinds of touching curves.
    pub touching: Vec<ProfilePart>,
    /// A form circle.
    pub form: bool,
    /// A base tangent point.
    pub tangent: bool,
    /// A drawn pair: no base circle, no line of action.
    pub outlines: bool,
}

/// Rows of samples with their names, no wider than `room`, from the left end `at`; and the bottom of the last row.
pub fn draw(at: Spot, room: f64, shown: &Shown, ids: &Ids) -> (Group, f64) {
    let hatch = ids.url("hatch");
    let dashed = |x: f64, y: f64, dash: &str| {
        Group::new().add(line(&[[x, y], [x + SAMPLE, y]], GREY, 1.1).set("stroke-dasharray", dash))
    };
    let swatch = |x: f64, y: f64, fills: &[&str]| {
        let frame = Frame::new([x + 4.0, y - 6.0], [x + SAMPLE - 4.0, y + 6.0]);
        fills.iter().fold(Group::new(), |group, fill| {
            group.add(
                frame
                    .rectangle()
                    .set("fill", *fill)
                    .set("stroke", INK)
                    .set("stroke-width", "0.80"),
            )
        })
    };
    type Swatch<'a> = Box<dyn Fn(f64, f64) -> Group + 'a>;
    let mut samples: Vec<(&str, Swatch)> = vec![
        (
            "contact, normal out of the locked gear",
            Box::new(|x, y| {
                Group::new()
                    .add(arrow([x + 5.0, y], [x + SAMPLE, y], 1.8))
                    .add(dot([x + 5.0, y], 4.0, true))
            }),
        ),
        (
            MEETING,
            Box::new(|x, y| {
                Group::new().add(dot([x + 8.0, y], 4.0, false)).add(dot(
                    [x + SAMPLE - 8.0, y],
                    4.0,
                    false,
                ))
            }),
        ),
        (
            OF_ACTION,
            Box::new(|x, y| {
                Group::new()
                    .add(line(&[[x + 8.0, y], [x + SAMPLE - 8.0, y]], PATH, 6.0))
                    .add(line(&[[x, y], [x + SAMPLE, y]], ACTION, 1.2))
            }),
        ),
        (WHEEL_NAME, Box::new(|x, y| swatch(x, y, &[WHEEL]))),
        (PINION_NAME, Box::new(|x, y| swatch(x, y, &[PINION]))),
        ("gap", Box::new(|x, y| swatch(x, y, &[GAP]))),
        ("overlap", Box::new(|x, y| swatch(x, y, &[OVERLAP, &hatch]))),
        (
            "operating pitch circle",
            Box::new(|x, y| dashed(x, y, PITCH_DASH)),
        ),
        ("base circle", Box::new(|x, y| dashed(x, y, BASE_DASH))),
        ("form circle", Box::new(|x, y| dashed(x, y, FORM_DASH))),
        (
            "base tangent point",
            Box::new(|x, y| Group::new().add(diamond([x + 0.5 * SAMPLE, y]))),
        ),
        (
            "line of centres",
            Box::new(|x, y| dashed(x, y, CENTRES_DASH)),
        ),
    ];
    samples.retain(|(name, _)| match *name {
        "gap" => shown.gap,
        "overlap" => shown.overlap,
        "form circle" => shown.form,
        "base tangent point" => shown.tangent,
        // For gears by data, the lines over the metal distinguish them.
        WHEEL_NAME | PINION_NAME => shown.outlines,
        OF_ACTION | "base circle" => !shown.outlines,
        _ => true,
    });
    for curve in ProfilePart::ALL {
        if shown.touching.contains(&curve) {
            let name = match curve {
                ProfilePart::Involute => "touching involute",
                ProfilePart::Fillet => "touching fillet",
                ProfilePart::Tip => "touching tip",
                ProfilePart::Root => "touching root",
            };
            samples.push((
                name,
                Box::new(move |x, y| contact_bands::sample(x, y, SAMPLE, curve)),
            ));
        }
    }
    let mut group = Group::new();
    let [mut x, mut y] = at;
    for (name, sample) in &samples {
        let width = SAMPLE + 8.0 + WORDS.width(name);
        if x + width > at[0] + room {
            [x, y] = [at[0], y + 25.0];
        }
        let words = WORDS.text(name, [x + SAMPLE + 8.0, y + 4.5]);
        group = group.add(sample(x, y)).add(words);
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
