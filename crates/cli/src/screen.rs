//! The terminal that standard output may be: its width and colours.

use gearlash_render::text::Screen;
use std::io::IsTerminal;

/// `--wide`: what the commands that print tables share.
#[derive(clap::Args)]
pub(super) struct ScreenArgs {
    /// Print tables in full on a terminal that is too narrow for them
    #[arg(long)]
    wide: bool,
}

impl ScreenArgs {
    /// What standard output is.
    pub(super) fn screen(&self) -> Screen {
        // No size where it is no terminal, or one that does not know its own.
        let size = ::console::Term::stdout().size_checked();
        Screen {
            width: size
                .map(|(_, columns)| columns.into())
                .filter(|_| !self.wide),
            colour: has_colours(&std::io::stdout()),
        }
    }
}

/// Whether `stream` shows colours and they are wanted (<https://no-color.org>).
pub(super) fn has_colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}
