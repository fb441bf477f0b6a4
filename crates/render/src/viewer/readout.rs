//! The contacts of a pose, the texts beside its picture, and the section of gears that vary along the face.

use super::precision::DEGREES;
use super::viewed::Viewed;
use crate::pose_name::{phase_name, pose_name};
use gearlash::analysis::study::Material;
use gearlash::contact::{Contact, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{GearPair, Member};
use gearlash_results::ContactRow;
use gearlash_text::numbers::{decades, fixed, rounded, trimmed, two_digits_up};
use serde::Serialize;
use std::collections::BTreeMap;

/// The contact on `side`; `None` for a pose without numbers.
pub fn touching(pose: &PoseResult, side: Side) -> Option<Contact> {
    let found = pose.proven()?;
    found.on(side).filter(|_| found.angle().is_some())
}

pub const LEGEND: &str = "Filled dot: the gears touch. Open dots: the two points of the other flanks that will meet. \
    Red and large: teeth have passed each other there. Blue: normals at the contacts, between involutes the line of action. \
    Red, where teeth overlap: metal of both gears. Dash-dotted: operating pitch circles.";

/// The name of a run: centre distance, material and phase.
pub fn run(viewed: &Viewed) -> String {
    let run = viewed.run;
    let distance = trimmed(run.run.assembly.center_distance(), 3, 6);
    let material = match run.run.material {
        Material::Most => ", most material",
        Material::Least => ", least material",
        Material::AsMeasured => "",
    };
    let phase = phase_name(run.run.phase);
    let worst = if viewed.is_worst_of_cycle {
        ", worst of the whole mesh cycle"
    } else {
        ""
    };
    format!("a = {distance} mm{material}{phase}{worst}")
}

/// The texts beside the picture of the pose at `number` of the run of `viewed`, each with the name of its element.
pub fn texts(viewed: &Viewed, number: usize) -> Vec<(&'static str, String)> {
    let run = viewed.run;
    let pose = &run.poses[number].simulated;
    let contact = |side| {
        touching(pose, side).map_or("none".to_owned(), |contact| {
            let row = ContactRow::new(&run.run.assembly, side, &pose.pose, &contact);
            let [wheel, pinion] = [contact.wheel.tooth, contact.pinion.tooth];
            let class = row.class_words();
            format!("wheel tooth {wheel} on pinion tooth {pinion}, {class}")
        })
    };
    let of_run = match run.poses.len() {
        0 | 1 => String::new(),
        poses => format!("{} of {poses}: ", number + 1),
    };
    let j_wt = pose.backlash.map(|j| j * 1e3);
    let overlap = j_wt.filter(|um| *um < 0.0).map(|um| {
        let deep = fixed(-um, 1);
        format!("Teeth overlap by {deep} µm at the red dots: zoom in to see it.")
    });
    let backlash = j_wt.map(|j| format!("{} µm", fixed(j, 3)));
    let bound = pose.error_bound.map(|bound| two_digits_up(bound * 1e3));
    let bound = bound.map(|um| format!("≤ {} µm", decades(um)));
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "none".to_owned());
    let mut texts = vec![
        ("pose", of_run + &pose_name(pose.pose.mating())),
        ("status", pose.status().name().replace('_', " ")),
        ("backlash", or_none(backlash)),
        ("overlapping", overlap.unwrap_or_default()),
        ("bound", or_none(bound)),
        ("right", contact(Side::Right)),
        ("left", contact(Side::Left)),
    ];
    if run.run.assembly.varies_along_face() {
        texts.push(("section-contacts", sections(pose)));
    }
    texts
}

pub fn draw(viewed: &Viewed, number: usize) -> String {
    let read = texts(viewed, number);
    // `collect` would sort them by code of their own.
    let mut texts = BTreeMap::new();
    texts.extend(read);
    texts.insert("run", run(viewed));
    let j_wt = viewed.run.poses[number].simulated.backlash;
    let full = j_wt.map_or(String::new(), |j| format!("{}", j * 1e3));
    let rows = [
        ("run", "Run"),
        ("pose", "Pose"),
        ("status", "Status"),
        ("bound", "Error of <i>j</i><sub>wt</sub>"),
        ("right", "Right contact"),
        ("left", "Left contact"),
    ];
    let rows = rows.map(|(id, name)| {
        let value = &texts[id];
        format!("<div><dt>{name}</dt><dd id=\"viewer-{id}\">{value}</dd></div>\n")
    });
    format!(
        "<p class=\"viewer-backlash\">Backlash <i>j</i><sub>wt</sub> = <output id=\"viewer-backlash\" aria-live=\"polite\" \
         data-um=\"{full}\">{}</output> <span id=\"viewer-overlapping\">{}</span></p>\n<dl class=\"viewer-readout\">\n{}</dl>\n",
        texts["backlash"],
        texts["overlapping"],
        rows.concat()
    )
}

const PLACE: usize = 6;
/// Decimals of a chosen section, mm.
const SECTION: usize = 2;

/// Data of gears that vary along the face for the script.
#[derive(Serialize)]
pub struct HelicalColumns {
    face_mm: [f64; 2],
    /// Twist of the teeth of wheel and pinion per mm.
    twist_deg_a_mm: [f64; 2],
    start_mm: f64,
}

impl HelicalColumns {
    /// The columns of `assembly`, with the section of `pose` shown first; `None` where all sections are equal.
    pub fn of(assembly: &AssembledPair, pose: &PoseResult) -> Option<HelicalColumns> {
        let start_mm = first(assembly, pose)?;
        let twist = |member| {
            let twist = assembly.twist(member);
            rounded(twist.to_degrees(), DEGREES + 4)
        };
        Some(HelicalColumns {
            // Steps of the slider start at the near end.
            face_mm: assembly.face().map(|end| rounded(end, SECTION)),
            twist_deg_a_mm: Member::BOTH.map(twist),
            start_mm: rounded(start_mm, PLACE),
        })
    }
}

/// The section shown first, mm: where the free gear touches on its right flanks, else the middle of the face; `None` where all
/// sections are equal.
pub fn first(assembly: &AssembledPair, pose: &PoseResult) -> Option<f64> {
    let [from, to] = assembly.face();
    let touching = touching(pose, Side::Right).map(|contact| contact.section);
    assembly
        .varies_along_face()
        .then(|| touching.unwrap_or(0.5 * (from + to)))
}

/// The sections in which the gears touch.
fn sections(pose: &PoseResult) -> String {
    let [right, left] = Side::BOTH.map(|side| {
        touching(pose, side).map_or("none".to_owned(), |contact| {
            format!("at z = {} mm", trimmed(contact.section, 0, SECTION))
        })
    });
    format!("Contacts: right {right}, left {left}. A contact in another section is pale.")
}

pub fn note(assembly: &AssembledPair, pose: &PoseResult) -> String {
    let Some(section) = first(assembly, pose) else {
        return String::new();
    };
    let deviates = assembly.data().is_some_and(GearPair::deviates_along_face);
    let without = if deviates {
        ", without deviations along the face"
    } else {
        ""
    };
    format!(
        "<p class=\"viewer-note\" id=\"viewer-section-text\">Drawn in the section<span id=\"viewer-section-here\"> at z = {} mm</span>{without}. \
         <span id=\"viewer-section-contacts\">{}</span></p>\n",
        trimmed(section, 0, SECTION),
        sections(pose)
    )
}
