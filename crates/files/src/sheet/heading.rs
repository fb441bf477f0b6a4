//! What a heading says: the words of a column's own cell and of the group above it, in German or English, and its unit.
//!
//! Every word must be known: "left limit" is no left flank. `fp` and `Fp` are told apart by their case, and
//! nothing else tells them apart: `FP` is neither. So is `Fr`, the runout, from `FR`, which may be a right flank.

use gearlash::gear::Side;
use gearlash::metrology::PitchKind;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// Not said; a flank alone was named.
    Unsaid,
    Tooth,
    /// A number, of what is not said.
    Number,
    /// The first tooth of a span.
    FirstTooth,
    /// The tooth before a space.
    Space,
    /// Of which kind, where it is said.
    Pitch(Option<PitchKind>),
    Runout,
    Thickness,
    Span,
    OverPins,
    OverThreePins,
    RollLength,
    Diameter,
    Deviation,
    /// Which flank, a word a row.
    Flank,
}

use Quantity::*;

/// What a heading says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meaning {
    pub side: Option<Side>,
    pub quantity: Quantity,
}

/// Symbols whose case tells what they are.
const SYMBOLS: [(&str, Quantity); 6] = [
    ("Fr", Runout),
    ("fp", Pitch(Some(PitchKind::Single))),
    ("fpi", Pitch(Some(PitchKind::Single))),
    ("fpt", Pitch(Some(PitchKind::Single))),
    ("Fp", Pitch(Some(PitchKind::Cumulative))),
    ("Fpi", Pitch(Some(PitchKind::Cumulative))),
];

/// Names as [`plain`] leaves them.
const NAMES: [(Quantity, &[&str]); 15] = [
    (
        Tooth,
        &[
            "tooth",
            "toothno",
            "toothnr",
            "toothnumber",
            "zahn",
            "zahnnr",
            "zahnnummer",
            "znr",
        ],
    ),
    (Number, &["nr", "no", "number", "nummer"]),
    (FirstTooth, &["firsttooth", "ersterzahn"]),
    (Space, &["space", "spaceno", "lücke", "zahnlücke"]),
    (
        Pitch(Some(PitchKind::Single)),
        &[
            "single",
            "singlepitch",
            "singlepitchdeviation",
            "einzelteilung",
            "einzelteilungsabweichung",
            "teilungseinzelabweichung",
        ],
    ),
    (
        Pitch(Some(PitchKind::Cumulative)),
        &[
            "cumulative",
            "cumulativepitch",
            "cumulativepitchdeviation",
            "summenteilung",
            "summenteilungsabweichung",
            "teilungssummenabweichung",
            "teilungsgesamtabweichung",
        ],
    ),
    (
        Pitch(None),
        &[
            "pitch",
            "pitchdeviation",
            "teilung",
            "teilungsabweichung",
            "teilungsfehler",
        ],
    ),
    (
        Runout,
        &[
            "runout",
            "radialrunout",
            "rundlauf",
            "rundlaufabweichung",
            "rundlauffehler",
        ],
    ),
    (
        Thickness,
        &["thickness", "tooththickness", "dicke", "zahndicke"],
    ),
    (Span, &["span", "wk", "zahnweite"]),
    (
        OverPins,
        &[
            "overpins",
            "overtwopins",
            "pins",
            "mdk",
            "zweirollenmaß",
            "zweirollenmass",
        ],
    ),
    (OverThreePins, &["threepins", "overthreepins"]),
    (RollLength, &["rolllength", "wälzlänge", "wälzweg"]),
    (Diameter, &["diameter", "durchmesser"]),
    (Deviation, &["deviation", "abweichung"]),
];

const LEFT: &[&str] = &["left", "links", "linke", "li", "lf", "linksflanke"];
const RIGHT: &[&str] = &["right", "rechts", "rechte", "re", "rf", "rechtsflanke"];
/// One letter is a flank only beside a quantity or the word.
const LETTERS: [(&str, Side); 2] = [("l", Side::Left), ("r", Side::Right)];
const FLANK: &[&str] = &[
    "flank",
    "flanks",
    "flanke",
    "flanken",
    "zahnflanke",
    "zahnflanken",
];
/// Words that say nothing beside a quantity.
const FILLERS: &[&str] = &[
    "deviation",
    "deviations",
    "abweichung",
    "abweichungen",
    "error",
    "fehler",
    "measured",
    "value",
    "reading",
    "gemessen",
    "messwert",
    "istwert",
    "in",
    "no",
    "nr",
    "number",
    "nummer",
];

/// Units, each as it may be written, in lower case, and as meant.
const UNITS: [(&str, &str); 19] = [
    ("um", "µm"),
    ("µm", "µm"),
    // The Greek letter, where the line above has the micro sign.
    ("μm", "µm"),
    ("micrometre", "µm"),
    ("micrometres", "µm"),
    ("micrometer", "µm"),
    ("micrometers", "µm"),
    ("mikrometer", "µm"),
    ("micron", "µm"),
    ("microns", "µm"),
    ("mm", "mm"),
    ("millimetre", "mm"),
    ("millimeter", "mm"),
    ("nm", "nm"),
    ("m", "m"),
    ("in", "in"),
    ("inch", "in"),
    ("mil", "mil"),
    ("mils", "mil"),
];
/// What stands in a row of units below a column without one.
const NO_UNIT: &[&str] = &["-", "–", "—", "nr", "no", "#", "1"];

/// The unit that `text` is, perhaps in brackets.
pub fn unit(text: &str) -> Option<&'static str> {
    let bare = text.trim().trim_start_matches(['(', '[']);
    let bare = bare.trim_end_matches([')', ']']).trim().to_lowercase();
    let bare = bare.strip_prefix("in ").unwrap_or(&bare);
    let mut known = UNITS.iter();
    known
        .find(|(written, _)| *written == bare)
        .map(|(_, meant)| *meant)
}

/// Whether `text` stands for no unit in a row of units.
pub fn is_no_unit(text: &str) -> bool {
    let bare = text.trim_matches(['(', ')', '[', ']', '.', ' ']);
    NO_UNIT.contains(&bare.to_lowercase().as_str())
}

/// A heading apart: `left (µm)`, `left [µm]`, `left_um` and `left / µm` all have a unit. What else stands in brackets is
/// part of the name.
pub fn name_and_unit(text: &str) -> (&str, Option<&'static str>) {
    let text = text.trim();
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((name, inner)) = text
            .strip_suffix(close)
            .and_then(|rest| rest.rsplit_once(open))
            && let Some(unit) = unit(inner)
        {
            return (name.trim(), Some(unit));
        }
    }
    let last = text.rsplit_once(|c: char| matches!(c, '_' | '/') || c.is_whitespace());
    match last.map(|(name, word)| (name, unit(word))) {
        Some((name, Some(unit))) => (name.trim_end_matches(['/', ' ']), Some(unit)),
        _ => (text, None),
    }
}

/// What `name`, without its unit, says below the `group` heading; `None` where a word is not known, or two contradict.
pub fn meaning(name: &str, group: Option<&str>) -> Option<Meaning> {
    let own = of_words(name);
    let Some(group) = group else { return own };
    match own.map(|own| own.quantity) {
        Some(Unsaid | Pitch(_)) | None => of_words(&format!("{group} {name}")),
        // What else stands below a flank's heading is not of the flank.
        Some(_) => own,
    }
}

/// The flank that a cell's word is, a letter too.
pub fn side(text: &str) -> Option<Side> {
    let word = plain(text);
    let letter = LETTERS.iter().find(|(letter, _)| *letter == word);
    match of_words(text) {
        Some(Meaning {
            side,
            quantity: Unsaid,
        }) => side,
        _ => letter.map(|(_, side)| *side),
    }
}

fn of_words(name: &str) -> Option<Meaning> {
    let (mut side, mut rest, mut has_flank) = (None, Vec::new(), false);
    let (mut is_letter, mut is_both) = (false, false);
    let separators = |c: char| c.is_whitespace() || "_/,:()[]|".contains(c);
    for word in name.split(separators).filter(|word| !word.is_empty()) {
        // `Zahn-Nr.` is one word, `Fp-links` are two.
        let whole = plain(word);
        let parts = match of_word(word, &whole).is_some() {
            true => vec![word],
            false => word.split('-').filter(|part| !part.is_empty()).collect(),
        };
        for part in parts {
            let small = plain(part);
            let found = match &small[..] {
                word if LEFT.contains(&word) => Side::Left,
                word if RIGHT.contains(&word) => Side::Right,
                word if FLANK.contains(&word) => {
                    has_flank = true;
                    continue;
                }
                word => match LETTERS.iter().find(|(letter, _)| *letter == word) {
                    Some((_, side)) => {
                        is_letter = true;
                        *side
                    }
                    None => {
                        rest.push(part);
                        continue;
                    }
                },
            };
            is_both |= side.replace(found).is_some_and(|side| side != found);
        }
    }
    if is_both {
        // "Flanke L/R": which of them, a word a row.
        let quantity = (has_flank && rest.is_empty()).then_some(Flank);
        return quantity.map(|quantity| Meaning {
            side: None,
            quantity,
        });
    }
    let said = |quantity| Some(Meaning { side, quantity });
    if rest.is_empty() {
        let quantity = match side {
            Some(_) => Unsaid,
            None => Flank,
        };
        return said(quantity).filter(|_| has_flank || (side.is_some() && !is_letter));
    }
    let whole = rest.concat();
    if let Some(quantity) = of_word(&whole, &plain(&whole)) {
        return said(quantity);
    }
    let mut found = None;
    for word in rest {
        let small = plain(word);
        if FILLERS.contains(&small.as_str()) {
            continue;
        }
        let quantity = of_word(word, &small)?;
        found = Some(match (found, quantity) {
            (None, quantity) => quantity,
            (Some(Pitch(None)), Pitch(kind)) | (Some(Pitch(kind)), Pitch(None)) => Pitch(kind),
            (Some(before), quantity) if before == quantity => quantity,
            _ => return None,
        });
    }
    found.and_then(said)
}

fn of_word(word: &str, plain: &str) -> Option<Quantity> {
    let mut symbols = SYMBOLS.iter();
    if let Some((_, quantity)) = symbols.find(|(symbol, _)| *symbol == word.trim_end_matches('.')) {
        return Some(*quantity);
    }
    let mut names = NAMES.iter();
    names
        .find(|(_, names)| names.contains(&plain))
        .map(|(quantity, _)| *quantity)
}

/// `name` without what does not count.
pub fn plain(name: &str) -> String {
    let counts = |c: &char| !c.is_whitespace() && !matches!(c, '-' | '_' | '.' | ':');
    name.chars()
        .filter(counts)
        .flat_map(char::to_lowercase)
        .collect()
}
