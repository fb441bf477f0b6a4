//! Drawings on the command line.

use gearlash_files::drawing::Format;
use std::path::Path;

/// How drawings on the command line are read.
#[derive(clap::Args)]
pub(super) struct DrawnArgs {
    /// Unit of the drawings, where they state none
    #[arg(long, value_name = "UNIT", value_parser = ["mm", "inch", "cm", "m", "um"])]
    pub(super) units: Option<String>,
    /// Where the axes of the drawings are: of the circle through the tips, or of the one circle inside [default: 0,0]
    #[arg(long, value_name = "HOW", value_parser = ["fit", "bore"])]
    pub(super) center: Option<String>,
}

impl DrawnArgs {
    /// Whether any of it was asked for.
    pub(super) fn given(&self) -> bool {
        self.units.is_some() || self.center.is_some()
    }
}

/// Whether a file is a drawing, by its ending.
pub(super) fn is_drawing(path: &Path) -> bool {
    Format::of(path).is_some()
}
