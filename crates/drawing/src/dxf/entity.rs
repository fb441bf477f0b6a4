//! The pairs of a DXF file, a group code and a value, one per line; and its entities, which are checked before they are read.

use crate::DrawingError;
use crate::error::LONGEST_NAME;
use gearlash_text::characters::cut;
use nalgebra::Point3;

/// Group codes that an entity must have once, and codes that it may have several times.
struct Rule {
    kind: &'static str,
    single: &'static [u16],
    repeated: &'static [u16],
}

/// The entities that are read. A point is listed by its x alone: y must follow.
const RULES: [Rule; 10] = [
    rule("LINE", &[10, 11], &[]),
    rule("ARC", &[10, 40, 50, 51], &[]),
    rule("CIRCLE", &[10, 40], &[]),
    rule("ELLIPSE", &[10, 11, 40, 41, 42], &[]),
    // Some programs write a z at each vertex.
    rule("LWPOLYLINE", &[90], &[10, 20, 30, 40, 41, 42, 91]),
    rule("POLYLINE", &[], &[]),
    rule("VERTEX", &[10], &[]),
    rule("SEQEND", &[], &[]),
    rule("INSERT", &[2, 10], &[]),
    rule("SPLINE", &[71, 72, 73], &[10, 20, 30, 11, 21, 31, 40, 41]),
];

const fn rule(kind: &'static str, single: &'static [u16], repeated: &'static [u16]) -> Rule {
    Rule {
        kind,
        single,
        repeated,
    }
}

/// Kinds that belong to no outline; they are ignored with a remark.
const IGNORED: [&str; 21] = [
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

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Handling {
    Read,
    Insert,
    Ignore,
    Reject,
}

#[derive(Debug, Default)]
pub struct Entity<'a> {
    /// Its kind, such as `LINE`.
    pub kind: &'a str,
    /// The line of the file where it begins.
    pub line: usize,
    /// Its number, from 1.
    pub number: usize,
    /// The block that it is part of; empty in the section ENTITIES.
    pub block: &'a str,
    /// Its pairs of geometry and of properties; extended data and handles left out.
    pub pairs: Vec<Pair<'a>>,
    /// The vertices of a POLYLINE and their bulges.
    pub vertices: Vec<(Point3<f64>, f64)>,
}

impl<'a> Entity<'a> {
    /// Adds a pair if it concerns the geometry.
    pub fn push(&mut self, pair: Pair<'a>) {
        let named = pair.code == 2 && matches!(self.kind, "INSERT" | "BLOCK");
        if named || matches!(pair.code, 8 | 10..=59 | 60 | 66..=79 | 90..=99 | 210..=239) {
            self.pairs.push(pair);
        }
    }

    /// The value of `code`, if there is one.
    pub fn value(&self, code: u16) -> Option<&'a str> {
        let pair = self.pairs.iter().find(|pair| pair.code == code);
        pair.map(|pair| pair.value)
    }

    pub fn layer(&self) -> &'a str {
        self.value(8).unwrap_or("0")
    }

    /// "line 12: entity 7 (LWPOLYLINE on layer "TEETH")", with the block that holds it.
    pub fn place(&self) -> String {
        let block = match self.block {
            "" => String::new(),
            name => format!(" of block \"{}\"", cut(name, LONGEST_NAME)),
        };
        format!(
            "line {}: entity {}{block} ({} on layer \"{}\")",
            self.line,
            self.number,
            cut(self.kind, LONGEST_NAME),
            cut(self.layer(), LONGEST_NAME)
        )
    }

    pub fn handling(&self) -> Handling {
        match self.kind {
            "INSERT" => Handling::Insert,
            kind if RULES.iter().any(|rule| rule.kind == kind) => Handling::Read,
            kind if IGNORED.contains(&kind) => Handling::Ignore,
            _ => Handling::Reject,
        }
    }

    /// The number of its pairs with `code`.
    fn count(&self, code: u16) -> usize {
        self.pairs.iter().filter(|pair| pair.code == code).count()
    }

    /// Checks that it has every value that its kind needs, once.
    pub fn check(&self) -> Result<(), DrawingError> {
        let wrong = |place: String, reason: String| {
            let help = "export it again as DXF, from another program if need be";
            Err(DrawingError::at(place, reason, help))
        };
        let Some(rule) = RULES.iter().find(|rule| rule.kind == self.kind) else {
            return Ok(());
        };
        let mut seen = [false; 240];
        for (index, pair) in self.pairs.iter().enumerate() {
            let code = usize::from(pair.code);
            if !matches!(pair.code, 2 | 8) && !is_number(pair) {
                let value = cut(pair.value, LONGEST_NAME);
                let reason = format!("group {code} of {} is not a number: \"{value}\"", self.kind);
                return wrong(pair.place(), reason);
            }
            if seen[code] && !rule.repeated.contains(&pair.code) {
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
        let missing = rule.single.iter().find(|code| !seen[usize::from(**code)]);
        if let Some(code) = missing {
            let reason = format!("group {code} of {} is missing", self.kind);
            return wrong(self.place(), reason);
        }
        let counts: &[(u16, u16)] = match self.kind {
            "LWPOLYLINE" => &[(90, 10)],
            "SPLINE" => &[(72, 40), (73, 10)],
            _ => &[],
        };
        for &(stated, of) in counts {
            let (words, count) = (self.value(stated).unwrap_or_default(), self.count(of));
            if words.parse() != Ok(count) {
                return wrong(
                    self.place(),
                    format!(
                        "group {stated} is {words}, but there are {count} values of group {of}"
                    ),
                );
            }
        }
        Ok(())
    }

    /// The number of `code`, or `default`.
    pub fn number(&self, code: u16, default: f64) -> f64 {
        let value = self.value(code).and_then(|value| value.parse().ok());
        value.unwrap_or(default)
    }

    /// The bits of the flags, group 70.
    pub fn flags(&self) -> i32 {
        let value = self.value(70).and_then(|value| value.parse().ok());
        value.unwrap_or(0)
    }

    pub fn numbers(&self, code: u16) -> Vec<f64> {
        let pairs = self.pairs.iter().filter(|pair| pair.code == code);
        pairs.filter_map(|pair| pair.value.parse().ok()).collect()
    }

    /// The point whose x is of `code`; what is missing is 0.
    pub fn point(&self, code: u16) -> Point3<f64> {
        Point3::from([code, code + 10, code + 20].map(|code| self.number(code, 0.0)))
    }

    /// The direction of x, 1 or −1: an entity can be seen from behind.
    pub fn hand(&self) -> Result<f64, &'static str> {
        let extrusion = [(210, 0.0), (220, 0.0), (230, 1.0)];
        let [x, y, z] = extrusion.map(|(code, default)| self.number(code, default));
        // Printed values: 1 up to their last digits.
        if x.abs().max(y.abs()) > 1e-12 || z == 0.0 {
            return Err("an extrusion direction other than 0, 0, ±1");
        }
        Ok(if z < 0.0 { -1.0 } else { 1.0 })
    }

    /// All points whose x is of `code`, each with its bulge, group 42. A z that is missing is `z`.
    pub fn points(&self, code: u16, z: f64) -> Vec<(Point3<f64>, f64)> {
        let mut points: Vec<(Point3<f64>, f64)> = Vec::new();
        for pair in &self.pairs {
            let Ok(value) = pair.value.parse() else {
                continue;
            };
            if pair.code == code {
                points.push((Point3::new(value, 0.0, z), 0.0));
            } else if let Some((point, bulge)) = points.last_mut() {
                match pair.code {
                    42 => *bulge = value,
                    y if y == code + 10 => point.y = value,
                    y if y == code + 20 => point.z = value,
                    _ => {}
                }
            }
        }
        points
    }
}

/// Whether the value is a number as its code asks: whole or finite.
fn is_number(pair: &Pair) -> bool {
    match pair.code {
        // Numbers of knots and points.
        72..=74 | 90..=99 => pair.value.parse::<i32>().is_ok(),
        60..=79 => pair.value.parse::<i16>().is_ok(),
        _ => pair.value.parse::<f64>().is_ok_and(f64::is_finite),
    }
}

/// First bytes of a binary DXF.
const BINARY: &[u8] = b"AutoCAD Binary DXF";
/// First bytes of a DWG.
const DWG: &[u8] = b"AC10";
/// The remedy for a file that is not whole.
pub const EXPORT: &str = "export it again as DXF";

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<'a> {
    /// The code: what the value means.
    pub code: u16,
    /// The value without the white space around it.
    pub value: &'a str,
    pub line: usize,
}

impl Pair<'_> {
    /// "line 12", the place of its value.
    pub fn place(&self) -> String {
        format!("line {}", self.line + 1)
    }
}

/// The pairs of a text, comments left out.
pub struct Pairs<'a> {
    lines: std::str::Split<'a, char>,
    line: usize,
}

/// Rejects files that are not ASCII DXF.
pub fn check_format(bytes: &[u8]) -> Result<(), DrawingError> {
    let kind = match bytes {
        _ if bytes.starts_with(BINARY) => "a binary DXF",
        _ if bytes.starts_with(DWG) => "a DWG",
        _ => return Ok(()),
    };
    let help = "save it as DXF in ASCII";
    Err(DrawingError::refused("byte 1", kind, help))
}

impl<'a> Pairs<'a> {
    pub fn of(text: &'a str) -> Pairs<'a> {
        Pairs {
            lines: text.split('\n'),
            line: 0,
        }
    }

    /// The next, which must be there: a DXF ends with a pair of its own.
    pub fn next(&mut self) -> Result<Pair<'a>, DrawingError> {
        loop {
            let line = self.line + 1;
            let (Some(code), Some(value)) = (self.lines.next(), self.lines.next()) else {
                let reason = "the file ends without EOF: it is truncated";
                return Err(DrawingError::at(format!("line {line}"), reason, EXPORT));
            };
            self.line += 2;
            let value = value.trim();
            let known = code.trim().parse::<u16>().ok().filter(|code| *code <= 1071);
            let Some(code) = known else {
                let reason = "not a group code, expected a whole number from 0 to 1071";
                return Err(DrawingError::at(format!("line {line}"), reason, EXPORT));
            };
            // 999 is a comment.
            if code != 999 {
                return Ok(Pair { code, value, line });
            }
        }
    }
}
