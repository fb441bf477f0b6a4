//! Rejects outlines where gears given by data are needed.

use crate::Tree;
use crate::check::Checked;
use crate::gear_file;
use crate::spec::{GEAR, PAIR};

/// The keys of gears given by an outline.
fn outlines(file: &Tree) -> impl Iterator<Item = String> {
    let keys = ["wheel", "pinion", "gear"].map(|name| format!("{name}.outline"));
    let table = file.table();
    keys.into_iter().filter(move |key| table.has(key))
}

/// Whether a gear of a pair or gear file is given by an outline.
pub(crate) fn has_outline(file: &Tree) -> bool {
    outlines(file).next().is_some()
}

/// Rejects a pair or gear file with an outline where gears given by data are needed.
pub(crate) fn refuse(file: &Tree) -> Option<()> {
    if !has_outline(file) {
        return Some(());
    }
    let is_gear = gear_file::is_one(file);
    let schema = if is_gear { &GEAR } else { &PAIR };
    let checked = Checked::new(schema, file.table());
    for key in outlines(file) {
        checked.table().add(
            &key,
            "an outline has no module, no base circle and no line of action, which this command needs",
            format!(
                "use `gearlash check`, `simulate`, `snapshot`, `chart`, `report` or `gauge` with {}, or give the gear by its data",
                file.path.display()
            ),
        );
    }
    None
}
