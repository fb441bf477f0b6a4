//! The text beside the picture of a pose. `viewer.js` writes equal texts for the others.

use super::contacts::touching;
use super::viewed::{Shown, Viewed};
use crate::pose_name::{phase_name, pose_name};
use gearlash::analysis::study::Material;
use gearlash::gear::Side;
use gearlash_files::numbers::{decades, fixed, trimmed, two_digits_up};
use gearlash_results::ContactRow;

/// Legend of the marks.
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

/// The list beside the picture.
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
