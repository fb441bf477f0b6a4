//! The program `gearlash`.

use std::process::ExitCode;

fn main() -> ExitCode {
    gearlash_cli::run(std::env::args_os())
}
