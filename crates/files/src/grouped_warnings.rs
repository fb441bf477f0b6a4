//! Groups equal warnings of many files, one line per distinct warning.

use std::path::{Path, PathBuf};

/// Texts, each with its files.
#[derive(Debug, Default)]
pub(crate) struct GroupedWarnings {
    each: Vec<(String, PathBuf, usize)>,
}

impl GroupedWarnings {
    /// Adds the `texts` of `file`.
    pub fn add(&mut self, file: &Path, texts: &[String]) {
        for text in texts {
            match self.each.iter_mut().find(|(known, ..)| known == text) {
                Some((.., more)) => *more += 1,
                None => self.each.push((text.clone(), file.to_path_buf(), 0)),
            }
        }
    }

    /// A line per text, in the order in which they were added: the first file with it, and the number of others.
    pub fn lines(&self) -> Vec<String> {
        let each = self.each.iter().map(|(text, file, more)| {
            let others = match more {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            format!("{}{others}: {text}", file.display())
        });
        each.collect()
    }
}
