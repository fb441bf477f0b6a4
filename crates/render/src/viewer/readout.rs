//! The contacts of a pose, the texts beside its picture, and the section of helical gears.

use super::precision::{DEGREES, degrees};
use super::viewed::{Shown, Viewed};
use crate::pose_name::{phase_name, pose_name};
use gearlash::analysis::study::Material;
use gearlash::contact::{Contact, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_results::ContactRow;
use gearlash_text::numbers::{decades, fixed, rounded, trimmed, two_digits_up};
use serde::Serialize;

/// The contact on `side`; `None` for a pose without numbers.
pub fn touching(pose: &PoseResult, side: Side) -> Option<Contact> {
    let found = pose.proven()?;
    found.on(side).filter(|_| found.angle().is_some())
}

pub const LEGEND: &str = "Filled dot: the gears touch. Open dots: the two points of the other flanks that will meet. \
    Red and large: teeth have passed each other there. Blue: normals at the contacts, between involutes the line of action. \
    Red, where teeth overlap: metal of both gears. Dash-dotted: operating pitch circles.";

/// The name of a run: centre distance, material and phase.
pub fn run(shown: &Shown) -> String {
    let run = shown.run;
    let distance = trimmed(run.run.assembly.center_distance(), 3, 6);
    let material = match run.run.material {
        Material::Most => ", most material",
        Material::Least => ", least material",
        Material::AsMeasured => "",
    };
    let phase = phase_name(run.run.phase);
    let worst = if shown.is_worst_of_cycle {
        ", worst of the whole mesh cycle"
    } else {
        ""
    };
    format!("a = {distance} mm{material}{phase}{worst}")
}

/// The texts beside the picture of a pose.
pub struct Texts {
    pub pose: String,
    pub status: String,
    pub backlash: String,
    /// A sentence on teeth that overlap; empty without.
    pub overlapping: String,
    pub bound: String,
    pub right: String,
    pub left: String,
    /// The sections of the contacts of helical gears.
    pub sections: Option<String>,
}

impl Texts {
    /// The texts of the pose at `number` of the run of `viewed`.
    pub fn new(viewed: &Viewed, number: usize) -> Texts {
        let run = viewed.shown.run;
        let pose = &run.poses[number].simulated;
        let contact = |side| match touching(pose, side) {
            None => "none".to_owned(),
            Some(contact) => {
                let row = ContactRow::new(&run.run.assembly, side, &pose.pose, &contact);
                format!(
                    "wheel tooth {} on pinion tooth {}, {}",
                    contact.wheel.tooth,
                    contact.pinion.tooth,
                    row.class_words()
                )
            }
        };
        let of_run = if run.poses.len() > 1 {
            format!("{} of {}: ", number + 1, run.poses.len())
        } else {
            String::new()
        };
        let j_wt = pose.backlash.map(|j| j * 1e3);
        let overlap = j_wt.filter(|um| *um < 0.0);
        let bound = pose.error_bound;
        Texts {
            pose: of_run + &pose_name(pose.pose.mating()),
            status: pose.status().name().replace('_', " "),
            backlash: j_wt.map_or("none".to_owned(), |j| format!("{} µm", fixed(j, 3))),
            overlapping: overlap.map_or(String::new(), |um| {
                let deep = fixed(-um, 1);
                format!("Teeth overlap by {deep} µm at the red dots: zoom in to see it.")
            }),
            bound: bound.map_or("none".to_owned(), |bound| {
                format!("≤ {} µm", decades(two_digits_up(bound * 1e3)))
            }),
            right: contact(Side::Right),
            left: contact(Side::Left),
            sections: run.run.assembly.is_helical().then(|| sections(pose)),
        }
    }

    /// Each text with the name of its element.
    pub fn named(self) -> impl Iterator<Item = (&'static str, String)> {
        let each = [
            ("pose", self.pose),
            ("status", self.status),
            ("backlash", self.backlash),
            ("overlapping", self.overlapping),
            ("bound", self.bound),
            ("right", self.right),
            ("left", self.left),
        ];
        let sections = self.sections.map(|text| ("section-contacts", text));
        each.into_iter().chain(sections)
    }
}

pub fn draw(viewed: &Viewed, number: usize) -> String {
    let texts = Texts::new(viewed, number);
    let j_wt = viewed.shown.run.poses[number].simulated.backlash;
    let full = j_wt.map_or(String::new(), |j| format!("{}", j * 1e3));
    let title = j_wt.map_or(String::new(), |_| format!("{full} µm"));
    let rows = [
        ("run", "Run", run(&viewed.shown)),
        ("pose", "Pose", texts.pose),
        ("status", "Status", texts.status),
        ("bound", "Error of <i>j</i><sub>wt</sub>", texts.bound),
        ("right", "Right contact", texts.right),
        ("left", "Left contact", texts.left),
    ];
    let rows = rows.map(|(id, name, value)| {
        format!("<div><dt>{name}</dt><dd id=\"viewer-{id}\">{value}</dd></div>\n")
    });
    format!(
        "<p class=\"viewer-backlash\">Backlash <i>j</i><sub>wt</sub> = <output id=\"viewer-backlash\" aria-live=\"polite\" \
         title=\"{title}\" data-um=\"{full}\">{}</output> <span id=\"viewer-overlapping\">{}</span></p>\n<dl class=\"viewer-readout\">\n{}</dl>\n",
        texts.backlash,
        texts.overlapping,
        rows.concat()
    )
}

const PLACE: usize = 6;
/// Decimals of a chosen section, mm.
const SECTION: usize = 2;

/// Data of helical gears for the script.
#[derive(Serialize)]
pub struct HelicalColumns {
    face_mm: [f64; 2],
    /// Twist of the teeth of wheel and pinion per mm.
    twist_deg_a_mm: [f64; 2],
    start_mm: f64,
}

impl HelicalColumns {
    /// The columns of `assembly`, with the section of `pose` shown first; `None` for spur gears.
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

/// The section shown first, mm: where the free gear touches on its right flanks, else the middle of the face; `None` for spur
/// gears.
pub fn first(assembly: &AssembledPair, pose: &PoseResult) -> Option<f64> {
    let [from, to] = assembly.face();
    let touching = touching(pose, Side::Right).map(|contact| contact.section);
    assembly
        .is_helical()
        .then(|| touching.unwrap_or(0.5 * (from + to)))
}

/// The start position of a gear in the first section, for the script.
#[derive(Debug, Clone, Copy)]
pub struct Winding {
    pub name: &'static str,
    /// Rotation of its teeth in the section, degrees.
    pub turned: f64,
    /// Offset of its centre from its axis, mm.
    pub centre: [f64; 2],
}

impl Winding {
    /// The start position of the gear `placed` in `section`, mm.
    pub fn new(placed: &PlacedGear, member: Member, section: f64, decimals: usize) -> Winding {
        let centre = placed.centre() - placed.axis();
        let twist = placed.twist();
        Winding {
            name: member.name(),
            turned: degrees(twist * section),
            centre: [centre.x, centre.y].map(|value| rounded(value, decimals)),
        }
    }

    pub fn centre(&self) -> String {
        let [x, y] = self.centre;
        format!("{x} {y}")
    }
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
    format!(
        "<p class=\"viewer-note\" id=\"viewer-section-text\">Drawn in the section at z = <span id=\"viewer-section-here\">{}</span> mm. \
         <span id=\"viewer-section-contacts\">{}</span></p>\n",
        trimmed(section, 0, SECTION),
        sections(pose)
    )
}
