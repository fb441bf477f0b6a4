//! The contacts of a pose, the text beside its picture, and the section of helical gears. `viewer.js` writes equal texts for the others.

use super::precision::{DEGREES, degrees};
use super::viewed::{Shown, Viewed};
use crate::pose_name::{phase_name, pose_name};
use gearlash::analysis::study::Material;
use gearlash::contact::{Contact, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_files::numbers::{decades, fixed, rounded, trimmed, two_digits_up};
use gearlash_results::ContactRow;
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

pub fn draw(viewed: &Viewed, number: usize) -> String {
    let run = viewed.shown.run;
    let pose = &run.poses[number];
    let mating = pose.simulated.pose.mating();
    let contact = |side| match touching(&pose.simulated, side) {
        None => "none".to_owned(),
        Some(contact) => {
            let pair = run.run.assembly.data();
            let row = ContactRow::new(pair, side, &pose.simulated.pose, &contact);
            format!(
                "wheel tooth {} on pinion tooth {}, {}",
                contact.wheel.tooth,
                contact.pinion.tooth,
                row.class_words()
            )
        }
    };
    let j_wt = pose.simulated.backlash.map(|j| j * 1e3);
    let shown = j_wt.map_or("none".to_owned(), |j| format!("{} µm", fixed(j, 3)));
    let full = j_wt.map_or(String::new(), |j| format!("{j}"));
    let title = j_wt.map_or(String::new(), |j| format!("{j} µm"));
    let bound = pose.simulated.error_bound;
    let bound = bound.map_or("none".to_owned(), |bound| {
        format!("≤ {} µm", decades(two_digits_up(bound * 1e3)))
    });
    let of_run = if run.poses.len() > 1 {
        format!("{} of {}: ", number + 1, run.poses.len())
    } else {
        String::new()
    };
    let status = pose.simulated.status().name().replace('_', " ");
    let overlap = j_wt.filter(|um| *um < 0.0);
    let overlapping = overlap.map_or(String::new(), |um| {
        let deep = fixed(-um, 1);
        format!("Teeth overlap by {deep} µm at the red dots: zoom in to see it.")
    });
    let rows = [
        ("run", "Run", self::run(&viewed.shown)),
        ("pose", "Pose", of_run + &pose_name(mating)),
        ("status", "Status", status),
        ("bound", "Error of <i>j</i><sub>wt</sub>", bound),
        ("right", "Right contact", contact(Side::Right)),
        ("left", "Left contact", contact(Side::Left)),
    ];
    let rows = rows.map(|(id, name, value)| {
        format!("<div><dt>{name}</dt><dd id=\"viewer-{id}\">{value}</dd></div>\n")
    });
    format!(
        "<p class=\"viewer-backlash\">Backlash <i>j</i><sub>wt</sub> = <output id=\"viewer-backlash\" aria-live=\"polite\" \
         title=\"{title}\" data-um=\"{full}\">{shown}</output> <span id=\"viewer-overlapping\">{}</span></p>\n<dl class=\"viewer-readout\">\n{}</dl>\n",
        overlapping,
        rows.concat()
    )
}

const PLACE: usize = 6;

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
        let pair = assembly.data()?;
        let twist = |member| {
            let data = *pair.gear(member).gear().basic_data();
            rounded(data.twist().to_degrees(), DEGREES + 4)
        };
        Some(HelicalColumns {
            face_mm: pair.face(),
            twist_deg_a_mm: Member::BOTH.map(twist),
            start_mm: rounded(start_mm, PLACE),
        })
    }
}

/// The section shown first, mm: where the free gear touches on its right flanks, else the middle of the face; `None` for spur
/// gears.
pub fn first(assembly: &AssembledPair, pose: &PoseResult) -> Option<f64> {
    let [from, to] = assembly.data()?.face();
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
        let twist = placed
            .data()
            .map_or(0.0, |placed| placed.as_built().gear().basic_data().twist());
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

pub fn note(assembly: &AssembledPair, pose: &PoseResult) -> String {
    let Some(section) = first(assembly, pose) else {
        return String::new();
    };
    let mm = |place: f64| trimmed(place, 0, 2);
    let contact = |side: Side| match touching(pose, side) {
        Some(contact) => format!("{} contact at z = {} mm", side.name(), mm(contact.section)),
        None => format!("no {} contact", side.name()),
    };
    format!(
        "<p class=\"viewer-note\" id=\"viewer-section-text\">Drawn in the section at z = {} mm; {}, {}.</p>\n",
        mm(section),
        contact(Side::Right),
        contact(Side::Left)
    )
}
