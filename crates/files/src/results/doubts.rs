//! What is not proven of a pose, in words: the reason, and doubtful values named as such.

use crate::numbers::um_ascii;
use gearlash::compare::ComparedPose;
use gearlash::mesh::Unproven;

/// Why something is not proven, and the values that it leaves in doubt.
pub fn doubt(unproven: &Unproven) -> String {
    let told = |name: &str, value: Option<f64>| {
        let um = um_ascii(value?, 3);
        Some(format!("{name} method, not proven: {um} µm"))
    };
    let values = [
        told("exact", unproven.exact),
        told("polygon", unproven.polygon),
    ];
    let parts = [Some(unproven.reason.clone())].into_iter().chain(values);
    parts.flatten().collect::<Vec<_>>().join("; ")
}

/// Everything about `pose` that is not proven, in words.
pub fn doubts(pose: &ComparedPose) -> String {
    let swept = &pose.swept;
    let here = swept.found.as_ref().err().map(doubt);
    let ends = swept
        .with_clearance
        .iter()
        .flatten()
        .zip(["a − c", "a + c"]);
    let ends = ends.filter_map(|(end, name)| {
        let doubt = doubt(end.as_ref().err()?);
        Some(format!("at {name} of the bearing clearance: {doubt}"))
    });
    here.into_iter().chain(ends).collect::<Vec<_>>().join("; ")
}
