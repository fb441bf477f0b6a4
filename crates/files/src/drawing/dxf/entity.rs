//! One entity of a DXF, checked before it is read: that nothing it needs is missing, duplicate or no number.

use super::pairs::Pair;
use crate::characters::cut;
use crate::drawing::DrawingError;
use crate::drawing::error::LONGEST_NAME;

/// What must stand in an entity once, and what may stand in it often.
struct Rule {
    kind: &'static str,
    once: &'static [u16],
    often: &'static [u16],
}

/// The entities that are read. Of a point its x alone is listed: y must follow.
const RULES: [Rule; 9] = [
    rule("LINE", &[10, 11], &[]),
    rule("ARC", &[10, 40, 50, 51], &[]),
    rule("CIRCLE", &[10, 40], &[]),
    rule("ELLIPSE", &[10, 11, 40, 41, 42], &[]),
    rule("LWPOLYLINE", &[90], &[10, 20, 40, 41, 42, 91]),
    rule("POLYLINE", &[], &[]),
    rule("VERTEX", &[10], &[]),
    rule("SEQEND", &[], &[]),
    rule("SPLINE", &[71, 72, 73], &[10, 20, 30, 11, 21, 31, 40, 41]),
];

const fn rule(kind: &'static str, once: &'static [u16], often: &'static [u16]) -> Rule {
    Rule { kind, once, often }
}

/// What is beside the outline, or is none: left out with a remark.
const BESIDE: [&str; 21] = [
    "ACAD_TABLE",
    "ARC_DIMENSION",
    "ATTDEF",
    "ATTRIB",
    "DIMENSION",
    "IMAGE",
    "LARGE_RADIAL_DIMENSION",
    "LEADER",
    "LIGHT",
    "MTEXT",
    "MULTILEADER",
    "OLE2FRAME",
    "POINT",
    "RAY",
    "SHAPE",
    "SUN",
    "TEXT",
    "TOLERANCE",
    "VIEWPORT",
    "WIPEOUT",
    "XLINE",
];

/// What is to be done with an entity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fate {
    /// Read it.
    Read,
    /// Leave it out with a remark.
    Beside,
    /// Refuse it.
    Refuse,
}

/// An entity as written.
#[derive(Debug, Default)]
pub struct Entity<'a> {
    /// Its kind, such as `LINE`.
    pub kind: &'a str,
    /// The line of the file where it begins.
    pub line: usize,
    /// Its number, from 1.
    pub number: usize,
    /// Its pairs of geometry and of properties; extended data and handles left out.
    pub pairs: Vec<Pair<'a>>,
}

impl<'a> Entity<'a> {
    /// Adds a pair, if it says anything of the geometry.
    pub fn push(&mut self, pair: Pair<'a>) {
        if matches!(pair.code, 8 | 10..=59 | 60 | 66..=79 | 90..=99 | 210..=239) {
            self.pairs.push(pair);
        }
    }

    /// The value of `code`, if there is one.
    pub fn value(&self, code: u16) -> Option<&'a str> {
        let pair = self.pairs.iter().find(|pair| pair.code == code);
        pair.map(|pair| pair.value)
    }

    /// The layer it is on.
    pub fn layer(&self) -> &'a str {
        self.value(8).unwrap_or("0")
    }

    /// "line 12: entity 7 (LWPOLYLINE on layer "TEETH")"
    pub fn place(&self) -> String {
        format!(
            "line {}: entity {} ({} on layer \"{}\")",
            self.line,
            self.number,
            cut(self.kind, LONGEST_NAME),
            cut(self.layer(), LONGEST_NAME)
        )
    }

    /// What is to be done with it.
    pub fn fate(&self) -> Fate {
        match self.kind {
            kind if RULES.iter().any(|rule| rule.kind == kind) => Fate::Read,
            kind if BESIDE.contains(&kind) => Fate::Beside,
            _ => Fate::Refuse,
        }
    }

    /// How often `code` stands in it.
    fn count(&self, code: u16) -> usize {
        self.pairs.iter().filter(|pair| pair.code == code).count()
    }

    /// Checks that it says what its kind needs, and says it once.
    pub fn check(&self) -> Result<(), DrawingError> {
        let wrong = |place: String, reason: String| {
            Err(DrawingError::syntax(
                place,
                reason,
                "export it again as DXF, from another program if need be",
            ))
        };
        let Some(rule) = RULES.iter().find(|rule| rule.kind == self.kind) else {
            return Ok(());
        };
        let mut seen = [false; 240];
        for (index, pair) in self.pairs.iter().enumerate() {
            let code = usize::from(pair.code);
            if pair.code != 8 && !is_number(pair) {
                let value = cut(pair.value, LONGEST_NAME);
                let reason = format!("group {code} of {} is not a number: \"{value}\"", self.kind);
                return wrong(pair.place(), reason);
            }
            if seen[code] && !rule.often.contains(&pair.code) {
                let reason = format!("group {code} of {} appears twice", self.kind);
                return wrong(pair.place(), reason);
            }
            seen[code] = true;
            // x and y of a point, next to each other.
            let before = index.checked_sub(1).map(|before| self.pairs[before].code);
            let after = self.pairs.get(index + 1).map(|after| after.code);
            let whole = match pair.code {
                10..=18 => after == Some(pair.code + 10),
                20..=28 => before == Some(pair.code - 10),
                _ => true,
            };
            if !whole {
                let reason = format!("group {code} of {}: a point without x or y", self.kind);
                return wrong(pair.place(), reason);
            }
        }
        let missing = rule.once.iter().find(|code| !seen[usize::from(**code)]);
        if let Some(code) = missing {
            let reason = format!("group {code} of {} is missing", self.kind);
            return wrong(self.place(), reason);
        }
        let counts: &[(u16, u16)] = match self.kind {
            "LWPOLYLINE" => &[(90, 10)],
            "SPLINE" => &[(72, 40), (73, 10)],
            _ => &[],
        };
        for &(said, of) in counts {
            let (words, count) = (self.value(said).unwrap_or_default(), self.count(of));
            if words.parse() != Ok(count) {
                let reason =
                    format!("group {said} is {words}, but there are {count} values of group {of}");
                return wrong(self.place(), reason);
            }
        }
        Ok(())
    }

    /// Adds it to `text` as the reader of geometry gets it.
    pub fn write(&self, text: &mut String) {
        let mut line = |code: u16, value: &str| {
            *text += &code.to_string();
            text.push('\n');
            *text += value;
            text.push('\n');
        };
        line(0, self.kind);
        for (index, pair) in self.pairs.iter().enumerate() {
            // Names have been read, and numbers of elements are those of the elements.
            if matches!(pair.code, 8 | 60..=68 | 72..=74 | 90..=99) {
                continue;
            }
            line(pair.code, pair.value);
            // The crate drops points of a spline without a z.
            let z = pair.code + 10;
            let after = self.pairs.get(index + 1).map(|after| after.code);
            if self.kind == "SPLINE" && matches!(pair.code, 20 | 21) && after != Some(z) {
                line(z, "0");
            }
        }
    }
}

/// Whether the value is a number as its code asks: whole or finite.
fn is_number(pair: &Pair) -> bool {
    match pair.code {
        // Numbers of knots and points, which are not passed on.
        72..=74 | 90..=99 => pair.value.parse::<i32>().is_ok(),
        60..=79 => pair.value.parse::<i16>().is_ok(),
        _ => pair.value.parse::<f64>().is_ok_and(f64::is_finite),
    }
}
