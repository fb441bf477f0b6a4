//! What is said of many files alike, said once.

use std::path::{Path, PathBuf};

/// Texts, each of the files that it is said of.
#[derive(Debug, Default)]
pub(crate) struct SaidOnce {
    each: Vec<(String, PathBuf, usize)>,
}

impl SaidOnce {
    /// `texts` are said of `file`.
    pub fn add(&mut self, file: &Path, texts: &[String]) {
        for text in texts {
            match self.each.iter_mut().find(|(said, ..)| said == text) {
                Some((.., more)) => *more += 1,
                None => self.each.push((text.clone(), file.to_path_buf(), 0)),
            }
        }
    }

    /// A line a text, in the order in which they were added: the first file that it is said of, and how many others.
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
