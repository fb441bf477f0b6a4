//! The subject of a snapshot, and the layout of its sheet.

use crate::kit::{Frame, Spot, TextStyle, WIDTH};
use gearlash::analysis::study::Material;
use gearlash::contact::{LostMotion, MeshSection, PoseResult, Scene, Unproven};
use gearlash::outline::AssembledPair;
use gearlash::pair::{Member, Pose};
use svg::node::element::Group;

/// Content of a snapshot.
#[derive(Debug, Clone, Copy)]
pub struct Snapshot<'a> {
    /// The pair's title.
    pub title: &'a str,
    /// The pair.
    pub assembly: &'a AssembledPair,
    /// The pose.
    pub pose: &'a Pose,
    /// The thickness.
    pub material: Material,
    /// The result of the simulation at the pose. For an unproven pose no contact is drawn.
    pub found: Result<&'a LostMotion, &'a Unproven>,
    /// The section that is drawn for gears that vary along the face; `None` for others.
    pub section: Option<&'a MeshSection>,
}

impl<'a> Snapshot<'a> {
    /// The pose of `result`; `section` as [`Self::section`].
    pub fn of_result(
        title: &'a str,
        assembly: &'a AssembledPair,
        material: Material,
        result: &'a PoseResult,
        section: Option<&'a MeshSection>,
    ) -> Snapshot<'a> {
        Snapshot {
            title,
            assembly,
            pose: &result.pose,
            material,
            found: result.found.as_ref(),
            section,
        }
    }

    /// The drawn gears and contacts.
    pub(crate) fn scene(&self) -> Scene<'a> {
        match (self.section, self.found) {
            (Some(section), _) => Scene::in_section(section),
            (None, Ok(lost_motion)) => Scene::new(self.assembly, self.pose, lost_motion),
            (None, Err(_)) => Scene::unproven(self.assembly, self.pose),
        }
    }

    /// The pose as drawn: for gears that vary along the face that of the section.
    pub(crate) fn drawn_pose(&self) -> &'a Pose {
        self.section.map_or(self.pose, MeshSection::pose)
    }
}

pub const MAIN: Frame = Frame::new([30.0, 142.0], [610.0, 730.0]);
/// The insets' frames, the upper one first.
pub const INSETS: [Frame; 2] = [
    Frame::new([662.0, 162.0], [1158.0, 400.0]),
    Frame::new([662.0, 492.0], [1158.0, 730.0]),
];

#[derive(Debug, Clone, Copy)]
pub struct Layout {
    pub width: f64,
    pub main: Frame,
    /// The insets' frames, the upper one first.
    pub insets: [Frame; 2],
    pub legend: Spot,
    /// Whether the picture contains the caption and leaders to the insets.
    pub is_sheet: bool,
}

pub const SHEET: Layout = Layout {
    width: WIDTH,
    main: MAIN,
    insets: INSETS,
    legend: [MAIN.left, 772.0],
    is_sheet: true,
};

/// The layout for a screen 390 pixels wide: the insets are below the mesh zone, and the page has the caption.
pub const NARROW: Layout = Layout {
    width: 390.0,
    main: Frame::new([4.0, 26.0], [386.0, 416.0]),
    insets: [
        Frame::new([4.0, 490.0], [386.0, 680.0]),
        Frame::new([4.0, 754.0], [386.0, 944.0]),
    ],
    legend: [4.0, 988.0],
    is_sheet: false,
};

impl Layout {
    /// The room for text from the mesh zone's left edge on.
    pub fn room(&self) -> f64 {
        self.width - 2.0 * self.main.left
    }
}

/// The gears' names over the mesh zone.
pub fn names(scene: &Scene, main: &Frame) -> Group {
    let name = |member: Member| {
        let role = if member == scene.assembly().locked() {
            "locked"
        } else {
            "free"
        };
        let teeth = scene.assembly().teeth(member);
        format!("{} ({role}), z = {teeth}", member.name())
    };
    let (style, y) = (TextStyle::new(14.0), main.top - 8.0);
    let wheel = style.text(&name(Member::Wheel), [main.left, y]);
    let pinion = style.end().text(&name(Member::Pinion), [main.right, y]);
    Group::new().add(wheel).add(pinion)
}
