//! What a snapshot is of, and where things stand on its sheet.

use crate::kit::{Frame, Spot, TextStyle};
use gearlash::analysis::study::Material;
use gearlash::contact::{LostMotion, MeshSection, Scene, Unproven};
use gearlash::outline::AssembledPair;
use gearlash::pair::{Member, Pose};
use svg::node::element::Group;

/// What a snapshot shows.
#[derive(Debug, Clone, Copy)]
pub struct Snapshot<'a> {
    /// The pair's title.
    pub title: &'a str,
    /// The pair.
    pub assembly: &'a AssembledPair,
    /// The pose.
    pub pose: &'a Pose,
    /// Which thickness.
    pub material: Material,
    /// What the simulation found at the pose; of an unproven pose nothing is drawn as contact.
    pub found: Result<&'a LostMotion, &'a Unproven>,
    /// Of helical gears the section that is drawn; of spur gears `None`.
    pub section: Option<&'a MeshSection>,
}

impl<'a> Snapshot<'a> {
    /// What is drawn.
    pub(crate) fn scene(&self) -> Scene<'a> {
        match (self.section, self.found) {
            (Some(section), _) => Scene::in_section(section),
            (None, Ok(lost_motion)) => Scene::new(self.assembly, self.pose, lost_motion),
            (None, Err(_)) => Scene::unproven(self.assembly, self.pose),
        }
    }

    /// The pose as drawn: of helical gears that of the section.
    pub(crate) fn drawn_pose(&self) -> &'a Pose {
        self.section.map_or(self.pose, MeshSection::pose)
    }
}

/// The mesh zone's frame.
pub const MAIN: Frame = Frame {
    left: 30.0,
    top: 142.0,
    right: 610.0,
    bottom: 730.0,
};
/// The insets' frames, the upper one first.
pub const INSETS: [Frame; 2] = [
    Frame {
        left: 662.0,
        top: 162.0,
        right: 1158.0,
        bottom: 400.0,
    },
    Frame {
        left: 662.0,
        top: 492.0,
        right: 1158.0,
        bottom: 730.0,
    },
];

/// Where the legend begins.
pub const LEGEND: Spot = [MAIN.left, 772.0];

/// The gears' names over the mesh zone.
pub fn names(scene: &Scene) -> Group {
    let name = |member: Member| {
        let role = match member == scene.assembly().locked() {
            true => "locked",
            false => "free",
        };
        format!(
            "{} ({role}), z = {}",
            member.name(),
            scene.assembly().teeth(member)
        )
    };
    let (style, y) = (TextStyle::new(14.0), MAIN.top - 8.0);
    let wheel = style.text(&name(Member::Wheel), [MAIN.left, y]);
    let pinion = style.end().text(&name(Member::Pinion), [MAIN.right, y]);
    Group::new().add(wheel).add(pinion)
}
