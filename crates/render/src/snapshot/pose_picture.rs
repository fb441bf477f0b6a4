//! A pose as a picture, be its gears known by data or by drawings; of helical gears in the section where the flank of the pose touches.

use super::outlines::{outline_snapshot, outline_snapshot_in_page};
use super::picture::{snapshot, snapshot_in_page};
use super::subject::Snapshot;
use gearlash::analysis::study::Material;
use gearlash::contact::{MeshSection, PoseResult};
use gearlash::error::Error;
use gearlash::outline::AssembledPair;

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
    let pair = match assembly {
        AssembledPair::Data(pair) => pair,
        AssembledPair::Drawn(pair) => return Ok(outline_snapshot(title, pair, material, pose)),
    };
    let section = MeshSection::binding(pair, pose)?;
    Ok(snapshot(&Snapshot {
        title,
        assembly: pair,
        pose: &pose.pose,
        material,
        found: pose.found.as_ref(),
        section: section.as_ref(),
    }))
}

/// The same for a page, with ids that begin with `id`. `words` says what is drawn, given where the section of helical gears is, mm.
pub(crate) fn pose_picture_in_page(
    title: &str,
    assembly: &AssembledPair,
    material: Material,
    pose: &PoseResult,
    (id, words): (&str, impl Fn(Option<f64>) -> String),
) -> Result<[String; 2], Error> {
    let pair = match assembly {
        AssembledPair::Data(pair) => pair,
        AssembledPair::Drawn(pair) => {
            let words = words(None);
            let names = [id, words.as_str()];
            let picture = outline_snapshot_in_page(title, pair, material, pose, names);
            return Ok([picture, words]);
        }
    };
    let section = MeshSection::binding(pair, pose)?;
    let words = words(section.as_ref().map(MeshSection::at));
    let view = Snapshot {
        title,
        assembly: pair,
        pose: &pose.pose,
        material,
        found: pose.found.as_ref(),
        section: section.as_ref(),
    };
    Ok([snapshot_in_page(&view, id, &words), words])
}
