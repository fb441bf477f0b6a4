//! The contact snapshot: one pose, true to scale, on an A4 sheet. Gears that vary along the face are drawn in the section where the
//! flank of the pose touches.
//!
//! The mesh zone is on the left, both contacts enlarged on the right, the upper one above; caption above and legend below. Same
//! input, same bytes.

use super::contacts::{self, IN_MAIN};
use super::gears::Look;
use super::inset::Link;
use super::labels::tooth_numbers;
use super::subject::{Layout, NARROW, SHEET, Snapshot, names};
use super::view::{View, mesh_view};
use super::{caption, gears, inset, legend};
use crate::kit::{Frame, HEIGHT, Ids, Occupied, blank_sheet, hatch, in_page, scale};
use gearlash::analysis::study::Material;
use gearlash::contact::{DrawnContact, MeshSection, PoseResult, Scene, Status};
use gearlash::error::Error;
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use svg::node::element::{Group, SVG};

/// The SVG text of a snapshot, a sheet of its own.
pub fn snapshot(view: &Snapshot) -> String {
    let (sheet, _) = draw(view, &Ids::default(), &SHEET);
    format!("{sheet}\n")
}

/// Room below the last row of a picture in a page.
const FOOT: f64 = 16.0;

/// The picture, and the bottom of its last row.
fn draw(view: &Snapshot, ids: &Ids, layout: &Layout) -> (SVG, f64) {
    let scene = view.scene();
    let frame = layout.main;
    let main = mesh_view(&scene, frame);
    let mut occupied = Occupied::default();
    // The lines of action of both sides; a thin overlap is visible over the outlines.
    let look = Look {
        id: "mesh",
        ids,
        sides: &Side::BOTH,
        outlines_last: scene.status() == Status::Jammed,
        band: contacts::BANDS[0],
    };
    let drawn = gears::draw(&scene, &main, &look, &mut occupied);
    let mut over = Group::new().set("clip-path", ids.url("mesh-frame"));
    let mut links = Vec::new();
    let mut insets = Group::new();
    for (contact, side, frame) in slots(&scene, &main, layout) {
        insets = insets.add(inset::heading(view, &scene, side, contact, &frame));
        let Some(contact) = contact else {
            insets = insets.add(inset::empty(frame));
            continue;
        };
        let enlarged = inset::view(contact, frame, main.scale);
        let link = Link::new(&main, &enlarged);
        occupied.border(link.shown);
        links.push(link);
        over = over.add(contacts::marks(contact, &main, IN_MAIN, &mut occupied));
        let bar = scale::bar([frame.left, frame.bottom + 16.0], enlarged.scale);
        insets = insets
            .add(inset::draw(&scene, contact, &enlarged, ids))
            .add(bar);
    }
    let mating = view.drawn_pose().mating();
    let ([wheel_numbers, pinion_numbers], taken) =
        tooth_numbers(&scene, &main, mating, &mut occupied);
    let links = links.iter().fold(Group::new(), |group, link| {
        group.add(link.draw(&taken, layout.is_sheet))
    });
    // The result for the whole face can come from another section.
    let in_section = view.section.is_some() && scene.contacts().iter().any(|m| m.gap < 0.0);
    let overlap = in_section || matches!(scene.status(), Status::Interference | Status::Jammed);
    let (legend, last) = legend::draw(layout, &scene, &main, ids, overlap);
    let mut sheet = blank_sheet(layout.width, HEIGHT).add(hatch(ids));
    if layout.is_sheet {
        sheet = sheet.add(caption::draw(view, &scene, frame.left, layout.room()));
    }
    let sheet = sheet
        .add(names(&scene, &frame))
        .add(drawn.group)
        .add(frame.border())
        .add(over)
        .add(links)
        .add(insets)
        .add(wheel_numbers)
        .add(pinion_numbers)
        .add(scale::bar([frame.left, frame.bottom + 16.0], main.scale))
        .add(legend);
    (sheet, last)
}

/// Each side with its contact and its frame: the higher contact has the upper frame.
fn slots<'s>(
    scene: &'s Scene,
    main: &View,
    layout: &Layout,
) -> Vec<(Option<&'s DrawnContact>, Side, Frame)> {
    let mut contacts = Side::BOTH.map(|side| {
        let contact = scene.contacts().iter().find(|contact| contact.side == side);
        (contact, side)
    });
    if let [(Some(first), _), (Some(second), _)] = contacts
        && main.spot(second.on_locked)[1] < main.spot(first.on_locked)[1]
    {
        contacts.reverse();
    }
    let slots = contacts.into_iter().zip(layout.insets);
    slots
        .map(|((contact, side), frame)| (contact, side, frame))
        .collect()
}

/// `pose` of `assembly` as the SVG text of a sheet.
///
/// # Errors
/// As [`MeshSection::binding`].
pub fn pose_picture(
    title: &str,
    assembly: &AssembledPair,
    material: Material,
    pose: &PoseResult,
) -> Result<String, Error> {
    let section = MeshSection::binding(assembly, pose)?;
    let view = Snapshot::of_result(title, assembly, material, pose, section.as_ref());
    Ok(snapshot(&view))
}

/// The picture for a page, drawn for a wide and for a narrow screen, and its description. Its ids begin with `id`. `words`
/// describes it, given the place of the section of gears that vary along the face, mm.
pub(crate) fn pose_picture_in_page(
    title: &str,
    assembly: &AssembledPair,
    material: Material,
    pose: &PoseResult,
    (id, words): (&str, impl Fn(Option<f64>) -> String),
) -> Result<[String; 2], Error> {
    let section = MeshSection::binding(assembly, pose)?;
    let words = words(section.as_ref().map(MeshSection::at));
    let view = Snapshot::of_result(title, assembly, material, pose, section.as_ref());
    let narrow = format!("{id}-narrow");
    let drawn = [(id, &SHEET), (narrow.as_str(), &NARROW)].map(|(id, layout)| {
        let (picture, last) = draw(&view, &Ids::in_page(id), layout);
        let view_box = format!("0 0 {} {}", layout.width, last + FOOT);
        in_page(picture.set("viewBox", view_box), id, &words)
    });
    Ok([drawn.concat(), words])
}
