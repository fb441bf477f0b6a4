//! Errors that end a command, and exit codes.

use gearlash::error::GearError;
use gearlash_render::PictureError;
use gearlash_text::{InputError, characters};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// An error that ends a command.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// All problems of one input file.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The errors of several files.
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
        path: PathBuf,
        source: std::io::Error,
    },
    /// A result (the first path) that would overwrite a file that was read (the second).
    #[error(
        "{}: this is the file {}, which was read and would be lost; name another place for the result",
        .0.display(), .1.display()
    )]
    OverInput(PathBuf, PathBuf),
    /// A failed write to standard output.
    #[error("standard output: cannot be written: {0}")]
    Printing(std::io::Error),
}

impl From<GearError> for Error {
    fn from(error: GearError) -> Error {
        Error::Run(error.into())
    }
}

/// The exit code of a command that finished: 1 where a result did not hold.
pub fn exit_code(holds: bool) -> u8 {
    u8::from(!holds)
}

impl Error {
    /// [`Error::Usage`] with this message.
    pub fn usage(message: &str) -> Error {
        Error::Usage(message.to_owned())
    }

    /// The error of a result at `output`, which would overwrite a file that was read as `input`.
    pub fn over_input(output: &Path, input: &Path) -> Error {
        Error::OverInput(output.to_path_buf(), input.to_path_buf())
    }

    /// The error of `what`, which the library cannot convert to text.
    pub fn unwritable<E: Display>(what: &str) -> impl FnOnce(E) -> Error {
        move |reason| Error::Usage(format!("{what} cannot be written: {reason}"))
    }

    /// Ctrl-C.
    pub const INTERRUPTED: Error = Error::Run(gearlash::error::Error::Interrupted);

    /// The message, one line per problem. Content of files breaks no line and acts on no terminal or log.
    pub fn lines(&self) -> Vec<String> {
        match self {
            Error::Input(input) => input.lines(),
            Error::Several(errors) => errors.iter().flat_map(Error::lines).collect(),
            other => vec![characters::line(&other.to_string())],
        }
    }

    /// The exit code. 1: a result did not hold. 2: there is no result, or it could not be written. 130 (128 + SIGINT, as shells
    /// count): the work was interrupted. (A signal itself ends the program.)
    pub fn exit_code(&self) -> u8 {
        use gearlash::error::Error as Run;
        match self {
            Error::Run(Run::CertificateFailed { .. } | Run::ContactLost { .. }) => 1,
            Error::Run(Run::Interrupted) => 130,
            _ => 2,
        }
    }
}
