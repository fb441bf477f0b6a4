//! Outlines where gears by their data are needed.

use crate::check::Checked;
use crate::gear_file;
use crate::node::Node;
use crate::place::Place;
use crate::problems::Problems;
use crate::spec::{GEAR, PAIR};
use std::path::Path;

/// Whether a gear of a pair or gear file is an outline.
pub(crate) fn has_outline(entries: &[(String, Node)]) -> bool {
    let is_outline = |node: &Node| match node {
        Node::Table(keys) => keys.iter().any(|(key, _)| key == "outline"),
        _ => false,
    };
    let gears = entries
        .iter()
        .filter(|(key, _)| ["wheel", "pinion", "gear"].contains(&key.as_str()));
    gears.into_iter().any(|(_, node)| is_outline(node))
}

/// The problem of a pair or gear file with an outline where gears by their data are needed.
pub(crate) fn refused(
    path: &Path,
    place: &Place,
    entries: &[(String, Node)],
    problems: &mut Problems,
) {
    let schema = if gear_file::is_one(entries) {
        &GEAR
    } else {
        &PAIR
    };
    let file = Checked::new(schema, place, entries, problems);
    let file = file.table();
    for name in ["wheel", "pinion", "gear"] {
        let key = format!("{name}.outline");
        if file.has(&key) {
            problems.add(file.problem(
                &key,
                "an outline has no module, no base circle and no line of action, which this command needs",
                format!(
                    "use `gearlash check`, `simulate`, `snapshot`, `chart`, `report` or `gauge` with {}, or give the gear by its data",
                    path.display()
                ),
            ));
        }
    }
}
