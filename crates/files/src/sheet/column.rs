//! The columns a table may have: their names in plain words, and their units.

use crate::data_file::DataFile;
use crate::entry::Limits;
use gearlash::metrology::PitchKind;
use std::ops::Bound::{Excluded, Included};

/// A column of values beside the tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Column {
    /// Pitch deviation of the right flank, µm.
    Right(PitchKind),
    /// Pitch deviation of the left flank, µm.
    Left(PitchKind),
    /// What the tooth is thicker than the mean, µm.
    Thickness,
    /// Radial runout reading, µm.
    Runout,
    /// Span `W_k`, mm.
    Span,
    /// Dimension over pins `M_dK`, mm.
    OverPins,
    /// Of a profile trace: roll length `r_b ξ`, mm.
    RollLength,
    /// Of a profile trace: diameter, mm.
    Diameter,
    /// Of a profile trace: what the flank has beyond its involute, µm.
    Deviation,
}

const DEVIATION: Limits = Limits {
    allowed: "a number of µm, −1e7 … 1e7",
    range: (Included(-1e7), Included(1e7)),
    help: "correct the line",
};
const LENGTH: Limits = Limits {
    allowed: "a number of mm above 0 and up to 1e9",
    range: (Excluded(0.0), Included(1e9)),
    help: "correct the line",
};

const ROLL_LENGTH: Limits = Limits {
    allowed: "a number of mm, 0 … 1e9",
    range: (Included(0.0), Included(1e9)),
    help: "correct the line",
};

/// Names of the column of tooth numbers.
const TOOTH: &[&str] = &[
    "tooth",
    "tooth no",
    "tooth number",
    "zahn",
    "zahn nr",
    "zahnnummer",
];
/// Besides, of spans: a span is known by the first tooth it runs over.
const FIRST_TOOTH: &[&str] = &["first tooth", "erster zahn"];
/// Besides, of pins: they lie in spaces.
const SPACE: &[&str] = &["space", "space no", "lücke", "zahnlücke"];

/// Units that a header may name, each as written there and as meant.
const UNITS: [(&str, &str); 8] = [
    ("um", "µm"),
    ("µm", "µm"),
    // The Greek letter, where the line above has the micro sign.
    ("μm", "µm"),
    ("mm", "mm"),
    ("nm", "nm"),
    ("m", "m"),
    ("in", "in"),
    ("inch", "in"),
];

impl Column {
    /// Its names, the first of them for messages; white space, case, `-`, `_` and `.` do not count.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Column::Right(_) => &[
                "right",
                "right flank",
                "rechts",
                "rechte Flanke",
                "rechte Zahnflanke",
            ],
            Column::Left(_) => &[
                "left",
                "left flank",
                "links",
                "linke Flanke",
                "linke Zahnflanke",
            ],
            Column::Thickness => &["thickness", "tooth thickness", "Dicke", "Zahndicke"],
            Column::Runout => &["runout", "Fr", "Rundlauf", "Rundlaufabweichung"],
            Column::Span => &["span", "Wk", "Zahnweite"],
            Column::OverPins => &[
                "over pins",
                "pins",
                "MdK",
                "Zweirollenmaß",
                "Zweirollenmass",
            ],
            Column::RollLength => &["roll length", "Wälzlänge"],
            Column::Diameter => &["diameter", "Durchmesser"],
            Column::Deviation => &["deviation", "Abweichung"],
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Column::Span | Column::OverPins | Column::RollLength | Column::Diameter => "mm",
            _ => "µm",
        }
    }

    /// What its values may be.
    pub fn limits(self) -> &'static Limits {
        match self {
            Column::Span | Column::OverPins | Column::Diameter => &LENGTH,
            Column::RollLength => &ROLL_LENGTH,
            _ => &DEVIATION,
        }
    }
}

/// What one cell of the header names.
#[derive(Debug, Clone, PartialEq)]
pub enum Named {
    /// The tooth number.
    Tooth,
    /// The wanted column of this place.
    Wanted(usize),
    /// Something else: why it does not fit, and the way out.
    Wrong(String, String),
}

/// What the header cell `text` of `file` names among `wanted`.
pub fn named(file: &DataFile, text: &str, wanted: &[Column]) -> Named {
    let (name, unit) = name_and_unit(text);
    let is = |names: &[&str]| names.iter().any(|known| plain(known) == plain(name));
    let place = is(TOOTH)
        || is(FIRST_TOOTH) && wanted.contains(&Column::Span)
        || is(SPACE) && wanted.contains(&Column::OverPins);
    let (found, needed) = if place {
        (Named::Tooth, None)
    } else if let Some(place) = wanted.iter().position(|column| is(column.names())) {
        (Named::Wanted(place), Some(wanted[place].unit()))
    } else if wanted.contains(&Column::OverPins) && plain(name) == "threepins" {
        return Named::Wrong(
            format!("column {} is a dimension over three pins, allowed is one over two", file.quote(text)),
            "give the dimensions over two pins (gearlash gauge writes them beside these), or the span".to_owned(),
        );
    } else {
        return Named::Wrong(
            format!(
                "unknown column {}, allowed are {}",
                file.quote(text),
                headings(wanted)
            ),
            "correct its name, or remove the column".to_owned(),
        );
    };
    let Some(unit) = unit else { return found };
    let meant = UNITS
        .iter()
        .find(|(written, _)| *written == unit.to_lowercase());
    match (meant, needed) {
        (Some((_, meant)), Some(needed)) if *meant == needed => found,
        (_, Some(needed)) => Named::Wrong(
            format!(
                "column {} is in {}, allowed is {needed}",
                file.quote(text),
                file.bare(unit)
            ),
            format!(
                "convert its values to {needed} and name it \"{} ({needed})\"",
                file.bare(name)
            ),
        ),
        (_, None) => Named::Wrong(
            format!(
                "column {} has a unit, a tooth number has none",
                file.quote(text)
            ),
            format!("name it \"{}\"", file.bare(name)),
        ),
    }
}

/// "tooth, left (µm) and right (µm)".
pub fn headings(wanted: &[Column]) -> String {
    let columns: Vec<String> = wanted
        .iter()
        .map(|column| format!("{} ({})", column.names()[0], column.unit()))
        .collect();
    let place = match wanted.contains(&Column::Deviation) {
        true => "tooth, flank",
        false => "tooth",
    };
    match columns.split_last() {
        Some((last, [])) => format!("tooth and {last}"),
        Some((last, rest)) => format!("{place}, {} and {last}", rest.join(", ")),
        None => "tooth".to_owned(),
    }
}

/// A heading apart: `left (µm)`, `left [µm]`, `left_um` and `left µm` all have a unit.
fn name_and_unit(text: &str) -> (&str, Option<&str>) {
    let text = text.trim();
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((name, unit)) = text
            .strip_suffix(close)
            .and_then(|rest| rest.split_once(open))
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    let last = text.rsplit_once(|c: char| c == '_' || c.is_whitespace());
    match last {
        Some((name, unit)) if UNITS.iter().any(|(known, _)| *known == unit.to_lowercase()) => {
            (name.trim(), Some(unit))
        }
        _ => (text, None),
    }
}

/// `name` without what does not count.
fn plain(name: &str) -> String {
    let counts = |c: &char| !c.is_whitespace() && !matches!(c, '-' | '_' | '.');
    name.chars()
        .filter(counts)
        .flat_map(char::to_lowercase)
        .collect()
}
