//! Removed commands and options, and their successors.

use crate::error::Error;
use std::ffi::OsString;

/// Commands and options, and their successors as instructions or facts. An option has a space and its value where only that value is gone;
/// it is empty for a whole command.
const GONE: [(&str, &str, &str); 4] = [
    (
        "export",
        "",
        "gearlash check PAIR --format json has the least and greatest backlash of every run",
    ),
    (
        "merge",
        "",
        "gearlash tolerance PAIR --from-rows 'rows-*.csv' gives the statistics of the rows of several runs",
    ),
    (
        "tolerance",
        "--shard",
        "gearlash tolerance PAIR --first N --assemblies M --rows FILE.csv computes a range of assemblies",
    ),
    (
        "match",
        "--shard",
        "gearlash match compares all gears in one run; gearlash.dask in Python uses several machines",
    ),
];

/// The error of a command line that uses a removed command or option; `words` begin with the program's name.
pub(super) fn error(words: &[OsString]) -> Option<Error> {
    let words = words.iter().skip(1).map(|word| word.to_string_lossy());
    let words: Vec<String> = words.map(|word| word.replacen('=', " ", 1)).collect();
    let command = words.iter().find(|word| !word.starts_with('-'))?;
    let all = words.join(" ") + " ";
    let (_, option, instead) = GONE.iter().find(|(of, option, _)| {
        of == command && all.contains(format!(" {option} ").trim_start())
    })?;
    let what = format!("{command} {option}");
    let what = what.trim_end();
    Some(Error::Usage(format!("gearlash {what} is gone: {instead}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(line: &str) -> Option<String> {
        let words: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        error(&words).map(|error| error.to_string())
    }

    #[test]
    fn a_command_that_is_gone_names_what_to_do_instead() {
        let text = message("gearlash -q export box.rexs pair.toml --stage 10").unwrap();
        assert!(text.starts_with("gearlash export is gone: gearlash check PAIR --format json"));
        assert!(message("gearlash exports pair.toml").is_none());
        assert!(message("gearlash check export").is_none());
    }

    #[test]
    fn every_entry_is_found_by_its_own_words() {
        for (command, option, instead) in GONE {
            let line = format!("gearlash {command} {option} pair.toml");
            let text = message(&line.replace("  ", " ")).unwrap();
            assert!(text.ends_with(instead), "{text}");
        }
    }
}
