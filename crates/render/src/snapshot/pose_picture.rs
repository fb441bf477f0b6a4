//! A pose as a picture; for helical gears in the section where the flank of the pose touches.

use super::picture::{snapshot, snapshot_in_page};
use super::subject::Snapshot;
use gearlash::analysis::study::Material;
use gearlash::contact::{MeshSection, PoseResult};
use gearlash::error::Error;
use gearlash::outline::AssembledPair;

/// The section that is drawn for helical gears.
fn section(assembly: &AssembledPair, pose: &PoseResult) -> Result<Option<MeshSection>, Error> {
    match assembly.data() {
        Some(pair) => MeshSection::binding(pair, pose),
        None => Ok(None),
    }
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
    let section = section(assembly, pose)?;
    let view = Snapshot::of_result(title, assembly, material, pose, section.as_ref());
    Ok(snapshot(&view))
}

/// The picture for a page, with ids that begin with `id`. `words` describes it, given the place of the section of helical gears,
/// mm.
pub(crate) fn pose_picture_in_page(
    title: &str,
    assembly: &AssembledPair,
    material: Material,
    pose: &PoseResult,
    (id, words): (&str, impl Fn(Option<f64>) -> String),
) -> Result<[String; 2], Error> {
    let section = section(assembly, pose)?;
    let words = words(section.as_ref().map(MeshSection::at));
    let view = Snapshot::of_result(title, assembly, material, pose, section.as_ref());
    Ok([snapshot_in_page(&view, id, &words), words])
}
