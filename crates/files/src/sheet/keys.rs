//! The keys that may stand beside `file`, of every table that may be in a file of its own.

use crate::problems::Problems;
use crate::table::Table;

/// Keys that name a table; others may stand beside them.
pub const KEYS: &[&str] = &[
    "file",
    "sheet",
    "header_row",
    "tooth_column",
    "column",
    "decimal",
];

/// The keys of a table that has its `own` ones beside [`KEYS`].
pub const fn keys_beside<const OWN: usize, const ALL: usize>(
    own: [&'static str; OWN],
) -> [&'static str; ALL] {
    assert!(OWN + KEYS.len() == ALL);
    let mut all = [""; ALL];
    let mut at = 0;
    while at < ALL {
        all[at] = if at < OWN { own[at] } else { KEYS[at - OWN] };
        at += 1;
    }
    all
}

/// Checks that nothing is said of a file that `table` does not name.
pub fn without_file(table: &Table, problems: &mut Problems) -> Option<()> {
    let mut keys = KEYS.iter().chain(&["left", "right"]);
    let Some(name) = keys.find(|name| table.has(name)) else {
        return Some(());
    };
    problems.add(table.problem(name, "given without `file`", "add the file, or remove it"));
    None
}
