//! The command line: parse, run, exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    match gearlash::cli::run() {
        Ok(code) => code,
        Err(error) => {
            for line in error.lines() {
                eprintln!("error: {line}");
            }
            ExitCode::from(error.exit_code())
        }
    }
}
