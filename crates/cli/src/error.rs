//! What a command ends with when it cannot do its work, and the exit code that says so.

use gearlash::error::GearError;
use gearlash_files::InputError;
use gearlash_files::characters;
use gearlash_render::PictureError;
use std::fmt::Display;
use std::path::PathBuf;
use std::process::ExitCode;

/// What a command ends with when it cannot do its work.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// All problems of one input file.
    #[error(transparent)]
    Input(#[from] InputError),
    /// What is wrong with several files.
    #[error("{}", self.lines().join("\n"))]
    Several(Vec<Error>),
    /// A command-line value that does not suit the file.
    #[error("{0}")]
    Usage(String),
    /// A calculation without a result.
    #[error(transparent)]
    Run(#[from] gearlash::error::Error),
    /// A picture that cannot be drawn.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A result that cannot be written.
    #[error("{}: cannot be written: {source}; choose another place with -o", path.display())]
    Output {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A result that would take the place of a file that was read.
    #[error(
        "{}: this is the file {}, which was read and would be lost; name another place for the result",
        output.display(), input.display()
    )]
    OverInput {
        /// Where the result was to go.
        output: PathBuf,
        /// The name under which the file was read.
        input: PathBuf,
    },
    /// Standard output that takes no more.
    #[error("standard output: cannot be written: {0}")]
    Printing(std::io::Error),
}

impl From<GearError> for Error {
    fn from(error: GearError) -> Error {
        Error::Run(error.into())
    }
}

/// What a command ends with that did its work: 1 where a result did not hold.
pub fn exit_code(holds: bool) -> ExitCode {
    match holds {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(1),
    }
}

impl Error {
    /// The error of `what`, which the library cannot put into text for a reason of its own.
    pub fn unwritable<E: Display>(what: &str) -> impl FnOnce(E) -> Error {
        move |reason| Error::Usage(format!("{what} cannot be written: {reason}"))
    }

    /// Ctrl-C.
    pub const INTERRUPTED: Error = Error::Run(gearlash::error::Error::Interrupted);

    /// The message, a line for each problem: whatever stands in the files, it breaks no line and acts on no terminal or log.
    pub fn lines(&self) -> Vec<String> {
        match self {
            Error::Input(input) => input.lines(),
            Error::Several(errors) => errors.iter().flat_map(Error::lines).collect(),
            other => vec![characters::line(&other.to_string())],
        }
    }

    /// What the process ends with: 1 when a result did not hold, 2 when there was none to be had or it could not be
    /// written, 130 (128 + SIGINT, as shells count) when the work was to stop. (A signal ends the program by itself.)
    pub fn exit_code(&self) -> u8 {
        use gearlash::error::Error as Run;
        match self {
            Error::Run(Run::CertificateFailed { .. } | Run::ContactLost { .. }) => 1,
            Error::Run(Run::Interrupted) => 130,
            _ => 2,
        }
    }
}
