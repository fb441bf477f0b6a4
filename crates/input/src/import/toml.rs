//! The tables of a file as lines of a pair file.

use super::table::{ImportedTable, Kind};
use std::path::Path;

/// A key that a table needs and that the file does not state: its meaning, after "The file does not say"; the line to complete.
type OpenKey = (&'static str, &'static str);

const PITCH_KIND: OpenKey = (
    "which pitch it has",
    "kind = …  # \"single\" (fp) or \"cumulative\" (Fp)",
);
const READING_PLACE: OpenKey = (
    "where the probe stood",
    "at = …  # \"tooth\" (fork) or \"space\" (ball, between it and the next)",
);
const SPANNED: OpenKey = ("how many teeth are spanned", "teeth = …");
const PIN: OpenKey = ("the diameter of the pins, mm", "pin_mm = …");
/// Conventions of leads at their defaults: no file states them.
const LEAD: &str = "\
# The file does not say these; change what differs.
from = \"reference\"  # or \"far\": the end where heights begin
axis = \"own\"  # or \"datum\": measured about the bore
# zero_mm = …  # the height where pitch and thickness were measured
";
const LEAD_TRACE: &str = "direction = \"transverse\"  # or \"normal\": square to the teeth\n";
/// Comment lines of a table that another one states, too.
const STATED: &str = "# Pitch of both flanks holds the thickness of each tooth. Where it was measured on its own, remove the #:\n";

/// The lines of a pair file that name the tables, and the keys that they need. A table that lacks a key is in comments, so that the
/// lines can be pasted as they are.
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
        // A ball is put into a space.
        let origin = table.origin.as_ref();
        let ball_mm = origin.and_then(|origin| origin.ball_mm);
        let by_space = ball_mm.is_some() || origin.is_some_and(|origin| origin.by_space);
        let by_space = by_space && table.kind == Kind::Runout;
        let pin = ball_mm.is_none().then_some(PIN);
        let (below, open) = match table.kind {
            Kind::Runout if by_space => ("runout", None),
            Kind::Pitch => ("pitch", table.pitch_kind.is_none().then_some(PITCH_KIND)),
            Kind::Runout => ("runout", Some(READING_PLACE)),
            Kind::Thickness => ("thickness.per_tooth_um", None),
            Kind::Span => (
                "thickness.span",
                table.spanned().is_none().then_some(SPANNED),
            ),
            // A second statement is compared with the first.
            Kind::OverPins if written.contains(&Kind::Span) => {
                ("thickness.cross_check.over_pins", pin)
            }
            Kind::OverPins => ("thickness.over_pins", pin),
            Kind::Trace => ("profile.trace", None),
            Kind::Lead => ("lead.trace", None),
        };
        if table.kind == Kind::Runout && written.contains(&Kind::Pitch) {
            lines += &format!(
                "# Pitch measured about the bore (axis = \"datum\") holds the eccentricity, too. Then leave [{gear}.runout] out,\n\
                 # or add eccentricity = \"pitch\" or \"runout\" to [{gear}.pitch].\n"
            );
        }
        let is_stated = table.kind == Kind::Thickness && written.contains(&Kind::Pitch);
        if is_stated {
            lines += STATED;
        }
        if let Some((what, _)) = open {
            lines += &format!(
                "# The file does not say {what}. Complete these lines and remove their #:\n"
            );
        }
        let mut block = format!("[{gear}.{below}]\nfile = {}\n", text(&name));
        if table.kind == Kind::Lead {
            block = format!("[{gear}.lead]\n{LEAD}{block}{LEAD_TRACE}");
        }
        if by_space {
            block += "at = \"space\"\n";
        }
        match (table.kind, ball_mm) {
            (Kind::Runout, Some(mm)) => block += &format!("ball_mm = {mm:?}\n"),
            (Kind::OverPins, Some(mm)) => block += &format!("pin_mm = {mm:?}\n"),
            _ => {}
        }
        match (open, table.pitch_kind, table.spanned()) {
            (Some((_, line)), ..) => block += &format!("{line}\n"),
            (None, Some(kind), _) => block += &format!("kind = \"{kind}\"\n"),
            (None, None, Some(teeth)) if table.kind == Kind::Span => {
                block += &format!("teeth = {teeth}\n");
            }
            (None, None, _) => {}
        }
        if table.kind == Kind::Pitch {
            block += "# axis = \"datum\"  # where it was measured about the bore, as machines do\n";
        }
        let is_said = |key: &str| keys.iter().any(|(known, _)| *known == key);
        if let Some(sheet) = table.sheet.as_ref().filter(|_| !is_said("sheet")) {
            block += &format!("sheet = {}\n", text(sheet));
        }
        for (key, value) in keys {
            let is_pitch = table.kind == Kind::Pitch;
            match *key {
                "left" | "right" if !is_pitch => {}
                "column" if is_pitch => {}
                "header_row" => block += &format!("{key} = {value}\n"),
                _ => block += &format!("{key} = {}\n", text(value)),
            }
        }
        for line in block.lines() {
            lines += &if open.is_some() || is_stated {
                format!("# {line}\n")
            } else {
                format!("{line}\n")
            };
        }
        written.push(table.kind);
    }
    lines
}
