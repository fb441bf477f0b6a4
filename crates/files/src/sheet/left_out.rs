//! What of a file is no part of the table, in words.

use super::head::{Head, letter};
use crate::data_file::DataFile;

/// Of how many lines and columns the names are reported. Tuned: a remark of a few lines.
const NAMED: usize = 8;

/// Lines and columns beside a table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LeftOut {
    /// In order, with their labels.
    lines: Vec<(u64, Option<String>)>,
    pub columns: Vec<usize>,
}

impl LeftOut {
    /// Adds a line.
    pub fn line(&mut self, number: u64) {
        self.lines.push((number, None));
    }

    /// Adds a line that has a label.
    pub fn labelled(&mut self, number: u64, label: &str) {
        self.lines.push((number, Some(label.to_owned())));
    }

    /// "lines 1–3 and 50 (\"max\"), columns \"fu\" (D)"; `None` where nothing is.
    pub fn words(&self, head: &Head, file: &DataFile) -> Option<String> {
        let mut lines = self.lines.clone();
        lines.sort();
        let mut runs: Vec<[u64; 2]> = Vec::new();
        for (line, _) in &lines {
            match runs.last_mut() {
                Some([_, last]) if *last + 1 == *line => *last = *line,
                _ => runs.push([*line; 2]),
            }
        }
        let shown = |[first, last]: &[u64; 2]| match first == last {
            true => first.to_string(),
            false => format!("{first}–{last}"),
        };
        let mut words = Vec::new();
        if !lines.is_empty() {
            let labels = lines.iter().filter_map(|(_, label)| label.as_ref());
            let labels = some(labels.map(|label| file.quote(label)).collect());
            let plural = if lines.len() == 1 { "" } else { "s" };
            let named = if labels.is_empty() {
                labels
            } else {
                format!(" ({labels})")
            };
            words.push(format!(
                "line{plural} {}{named}",
                some(runs.iter().map(shown).collect())
            ));
        }
        if !self.columns.is_empty() {
            let plural = if self.columns.len() == 1 { "" } else { "s" };
            let column = |place: &usize| match &head.headings[*place].shown[..] {
                "" => letter(*place),
                name => format!("{} ({})", file.quote(name), letter(*place)),
            };
            words.push(format!(
                "column{plural} {}",
                some(self.columns.iter().map(column).collect())
            ));
        }
        (!words.is_empty()).then(|| words.join("; "))
    }
}

/// The first of `words`, and how many more there are.
fn some(words: Vec<String>) -> String {
    let named = words
        .iter()
        .take(NAMED)
        .cloned()
        .collect::<Vec<_>>()
        .join(", ");
    match words.len().saturating_sub(NAMED) {
        0 => named,
        more => format!("{named} and {more} more"),
    }
}
