//! The section of helical gears in the viewer.

use super::contacts::touching;
use super::precision::{DEGREES, degrees};
use gearlash::contact::PoseResult;
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_files::numbers::{rounded, trimmed};
use serde::Serialize;

/// Decimals of a position along the face, mm.
const PLACE: usize = 6;

/// Data of helical gears for the script.
#[derive(Serialize)]
pub struct HelicalColumns {
    /// Ends of the common face.
    face_mm: [f64; 2],
    /// Twist of the teeth of wheel and pinion per mm.
    twist_deg_a_mm: [f64; 2],
    /// The section shown first.
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
    /// `wheel` or `pinion`.
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

    /// Its centre, formatted for the script.
    pub fn centre(&self) -> String {
        let [x, y] = self.centre;
        format!("{x} {y}")
    }
}

/// The note below the picture.
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
