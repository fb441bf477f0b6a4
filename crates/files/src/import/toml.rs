//! The tables of a file as lines of a pair file.

use super::table::{ImportedTable, Kind};
use std::path::Path;

/// The lines of a pair file that name the tables, and the keys that they need.
pub(super) fn lines(
    tables: &[ImportedTable],
    path: &Path,
    gear: &str,
    keys: &[(&str, String)],
) -> String {
    let text = |text: &str| ::toml::Value::String(text.to_owned()).to_string();
    let name = path
        .file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy();
    let mut lines = String::new();
    let mut written = Vec::new();
    for table in tables {
        if written.contains(&table.kind) {
            let kind = table.pitch_kind.unwrap_or_default();
            lines += &format!("# The file has the other kind, too: kind = \"{kind}\"\n");
            continue;
        }
        let (below, unsaid) = match table.kind {
            Kind::Runout if table.by_space => ("runout", ""),
            Kind::Pitch => ("pitch", "kind = \"single\" (fp) or \"cumulative\" (Fp)"),
            Kind::Runout => (
                "runout",
                "at = \"tooth\" (fork) or \"space\" (ball, between it and the next)",
            ),
            Kind::Thickness => ("thickness.per_tooth_um", ""),
            Kind::Span => ("thickness.span", "teeth = …, the teeth spanned"),
            // A second statement is compared with the first.
            Kind::OverPins if written.contains(&Kind::Span) => (
                "thickness.cross_check.over_pins",
                "pin_mm = …, the diameter of the pins",
            ),
            Kind::OverPins => (
                "thickness.over_pins",
                "pin_mm = …, the diameter of the pins",
            ),
            Kind::Trace => ("profile.trace", ""),
        };
        lines += &format!("[{}.{below}]\nfile = {}\n", gear, text(&name));
        if table.kind == Kind::Runout && written.contains(&Kind::Pitch) {
            lines += &format!(
                "# Pitch measured about the bore holds the eccentricity, too: leave this table out,\n\
                 # or add eccentricity = \"pitch\" or \"runout\" to [{gear}.pitch]\n"
            );
        }
        let spanned = table.spanned().filter(|_| table.kind == Kind::Span);
        if table.by_space && table.kind == Kind::Runout {
            lines += "at = \"space\"\n";
        }
        match (table.pitch_kind, spanned) {
            (Some(kind), _) => lines += &format!("kind = \"{kind}\"\n"),
            (None, Some(teeth)) => lines += &format!("teeth = {teeth}\n"),
            (None, None) if unsaid.is_empty() => {}
            (None, None) => {
                lines += &format!("# To be added, for the file does not say it: {unsaid}\n")
            }
        }
        if table.kind == Kind::Pitch {
            lines += "# axis = \"datum\"  # where it was measured about the bore, as machines do\n";
        }
        let is_said = |key: &str| keys.iter().any(|(known, _)| *known == key);
        if let Some(sheet) = table.sheet.as_ref().filter(|_| !is_said("sheet")) {
            lines += &format!("sheet = {}\n", text(sheet));
        }
        for (key, value) in keys {
            let is_pitch = table.kind == Kind::Pitch;
            match *key {
                "left" | "right" if !is_pitch => {}
                "column" if is_pitch => {}
                "header_row" => lines += &format!("{key} = {value}\n"),
                _ => lines += &format!("{key} = {}\n", text(value)),
            }
        }
        written.push(table.kind);
    }
    lines
}
