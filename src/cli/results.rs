//! What a command prints of its results, and the folder that takes all of them.

use super::print;
use crate::characters::plain;
use crate::error::Error;
use crate::output::OutputFolder;
use clap::ValueEnum;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub(super) struct ResultsArgs {
    /// What to print; with json or csv nothing else is printed, and nothing written without -o
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    /// Folder for results and pictures [default: out/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Format {
    /// A readable table
    Text,
    /// The whole result
    Json,
    /// One table: a row a pose, or a tooth
    Csv,
}

impl ResultsArgs {
    /// Where the files go, tried before the work begins; `None`: nothing is written.
    ///
    /// # Errors
    /// [`Error::Output`].
    pub(super) fn folder(&self, stem: &str) -> Result<Option<OutputFolder>, Error> {
        let path = match (&self.output, self.format) {
            (Some(folder), _) => folder.clone(),
            (None, Format::Text) => Path::new("out").join(stem),
            (None, Format::Json | Format::Csv) => return Ok(None),
        };
        OutputFolder::prepare(&path).map(Some)
    }

    /// Writes `files` and, after a table, says where they are.
    ///
    /// # Errors
    /// [`Error::Output`].
    pub(super) fn write(
        &self,
        folder: OutputFolder,
        files: &[(String, String)],
    ) -> Result<(), Error> {
        self.write_instead(folder, files, [])
    }

    /// [`ResultsArgs::write`], and then removes those of the files named `possible`, all of them the
    /// command's own, that an earlier run left there and this one did not write.
    ///
    /// # Errors
    /// [`Error::Output`].
    pub(super) fn write_instead(
        &self,
        folder: OutputFolder,
        files: &[(String, String)],
        possible: impl IntoIterator<Item = String>,
    ) -> Result<(), Error> {
        let stale: Vec<String> = possible
            .into_iter()
            .filter(|name| files.iter().all(|(written, _)| written != name))
            .collect();
        let path = folder.write_instead(files, &stale)?;
        if self.format == Format::Text {
            print(&format!(
                "\n{} files in {}\n",
                files.len(),
                plain(&path.display().to_string())
            ));
        }
        Ok(())
    }
}
