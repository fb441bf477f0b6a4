//! What a file holds, line for line.

use super::super::block::Block;
use super::super::header::Header;
use super::super::number::Unmeasured;
use crate::data_file::DataFile;
use crate::problems::Problems;
use gearlash::gear::Flank;
use std::collections::BTreeMap;

/// What to do about a line that is wrong.
pub const CORRECT: &str = "correct the line, or name a file as the machine wrote it";
/// What [`P40::unused`] calls the blocks of both flanks.
pub const PITCH: &str = "blocks of pitch";
/// What it calls the profile traces.
pub const PROFILES: &str = "profile traces";
/// What it calls the rows of `Teilung:`.
pub const POSITIONS: &str = "positions of the probe";

/// Which of the two kinds of file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// `.mka`: curves.
    Curves,
    /// `.mew`: values by number.
    Values,
}

/// A trace.
#[derive(Debug)]
pub struct FlankTrace {
    /// The line of its head.
    pub line: u64,
    pub tooth: u32,
    pub flank: Flank,
    /// Each with its line, µm; `None`: not measured.
    pub values: Vec<(u64, Option<f64>)>,
}

/// A numbered header line.
#[derive(Debug)]
pub struct Numbered {
    pub line: u64,
    /// In lower case.
    pub label: String,
    pub numbers: Vec<f64>,
}

/// A file as read.
#[derive(Debug)]
pub struct P40<'a> {
    pub kind: Kind,
    pub header: Header,
    pub numbered: Vec<Numbered>,
    /// What the profile is measured over, as far as the preamble says.
    pub profile_by: Option<&'a str>,
    pub unmeasured: Unmeasured,
    pub blocks: Vec<Block<'a>>,
    pub profiles: Vec<FlankTrace>,
    /// How many there are of what is never used.
    unused: BTreeMap<&'static str, usize>,
}

impl P40<'_> {
    /// With nothing in it yet.
    pub fn new(kind: Kind) -> Self {
        P40 {
            kind,
            header: Header::default(),
            numbered: Vec::new(),
            profile_by: None,
            unmeasured: Unmeasured::default(),
            blocks: Vec::new(),
            profiles: Vec::new(),
            unused: BTreeMap::new(),
        }
    }

    /// Counts what is never used.
    pub fn count_unused(&mut self, name: &'static str, count: usize) {
        *self.unused.entry(name).or_default() += count;
    }

    /// The first header line whose label holds one of `words`.
    pub fn labelled(&self, words: &[&str]) -> Option<&Numbered> {
        let has = |line: &&Numbered| words.iter().any(|word| line.label.contains(word));
        self.numbered.iter().find(has)
    }

    /// The problem of a value file, where it is one.
    pub fn refuse_values(&self, file: &DataFile, problems: &mut Problems) -> Option<()> {
        let is_values = self.kind == Kind::Values;
        if is_values {
            problems.add(file.problem(
                "is a value file (.mew): results by number, of which none is known for certain to be a span or a dimension over pins",
                "name the curve file of the same measurement (.mka), or write the values into the pair file",
            ));
        }
        (!is_values).then_some(())
    }

    /// What of the file is read and left unused where `used` is not, for a remark.
    pub fn unused(&self, used: &str) -> String {
        let mut there = self.unused.clone();
        there.insert(PROFILES, self.profiles.len());
        there.insert(PITCH, self.blocks.len());
        there.remove(used);
        let named = there.iter().filter(|(_, count)| **count > 0);
        let named: Vec<String> = named
            .map(|(name, count)| format!("{count} {name}"))
            .collect();
        match named.is_empty() {
            true => "nothing else".to_owned(),
            false => named.join(", "),
        }
    }
}
