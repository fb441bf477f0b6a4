//! Options for the output of a command, and the folder of its results.

use super::console::print_note;
use crate::error::Error;
use crate::output::OutputFolder;
use clap::ValueEnum;
use gearlash_files::Sources;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub(super) struct ResultsArgs {
    /// Output format; json and csv write files only with -o
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    /// Folder for results and pictures [default: out/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Write no files
    #[arg(long, conflicts_with = "output")]
    no_files: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Format {
    /// A readable table
    Text,
    /// The whole result
    Json,
    /// One table, one row per pose or tooth
    Csv,
}

impl ResultsArgs {
    /// Whether a folder was named.
    pub(super) fn names_folder(&self) -> bool {
        self.output.is_some()
    }

    /// The folder of the files, tried before the work begins; `None`: nothing is written. `own` are the names of the command's
    /// files, which replace those of an earlier run; never one of `sources`.
    ///
    /// # Errors
    /// As [`OutputFolder::prepare`].
    pub(super) fn folder(
        &self,
        stem: &str,
        sources: &Sources,
        own: impl Fn(&str) -> bool + 'static,
    ) -> Result<Option<OutputFolder>, Error> {
        let path = self.path(stem);
        let prepared = path.map(|path| OutputFolder::prepare(&path, sources, own));
        prepared.transpose()
    }

    /// The path of the folder; `None`: nothing is written.
    pub(super) fn path(&self, stem: impl AsRef<Path>) -> Option<PathBuf> {
        let own = || Path::new("out").join(stem);
        let writes = self.format == Format::Text && !self.no_files;
        self.output.clone().or_else(|| writes.then(own))
    }

    /// Writes `files`, in addition to those already begun. After a table it also prints where they are.
    ///
    /// # Errors
    /// As [`OutputFolder::write`].
    pub(super) fn write(
        &self,
        folder: OutputFolder,
        files: &[(String, String)],
    ) -> Result<(), Error> {
        let written = folder.write(files)?;
        match self.format {
            Format::Text => print_note(&format!("\n{written}\n")),
            Format::Json | Format::Csv => Ok(()),
        }
    }
}
