//! The parts of an `.xlsx` workbook (ECMA-376): its sheets, shared texts, formats of dates, and cells.
//!
//! The relationships of the package name the workbook; those of the workbook name its sheets, texts and styles. Parts are UTF-8.
//! Names of parts do not distinguish upper and lower case.

use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

/// Letters and digits of the last cell of a spreadsheet, XFD1048576.
const MAX_LETTERS: usize = 3;
const MAX_DIGITS: usize = 7;

/// The unpacked parts of an archive by their names in lower case.
pub type Parts = BTreeMap<String, Vec<u8>>;

#[derive(Debug)]
pub enum Content<'a> {
    Number(f64),
    Text(Cow<'a, str>),
    Flag(bool),
    /// The name of an error, `#DIV/0!`.
    Error(String),
    Date,
}

#[derive(Debug)]
pub struct Workbook {
    parts: Parts,
    /// Name and part of each sheet with cells.
    sheets: Vec<(String, String)>,
    texts: Vec<String>,
    /// For each format of cells whether it shows a date or time.
    dates: Vec<bool>,
}

impl Workbook {
    /// The workbook in an archive with these parts; an error in words.
    pub fn new(parts: Parts) -> Result<Workbook, String> {
        let main = relationships(&parts, "")?;
        let main = main.into_values().find(|to| to.kind == "officeDocument");
        let main = main.ok_or("the archive names no workbook")?.part;
        let related = relationships(&parts, &main)?;
        let of_kind = |kind: &str| related.values().find(|to| to.kind == kind);
        let texts = of_kind("sharedStrings").map(|to| texts(part(&parts, &to.part)?));
        let dates = of_kind("styles").map(|to| dates(part(&parts, &to.part)?));
        let mut sheets = Vec::new();
        each_event(part(&parts, &main)?, |event| {
            if let Event::Start(tag) = event
                && is(&tag, "sheet")
            {
                let name = attribute(&tag, "name")?.unwrap_or_default();
                let id = attribute(&tag, "id")?.unwrap_or_default();
                let to = related.get(&id).ok_or("a sheet names no part")?;
                // Charts on sheets of their own hold no cells.
                if to.kind == "worksheet" {
                    sheets.push((name, to.part.clone()));
                }
            }
            Ok(ControlFlow::Continue(()))
        })?;
        Ok(Workbook {
            sheets,
            texts: texts.unwrap_or_else(|| Ok(Vec::new()))?,
            dates: dates.unwrap_or_else(|| Ok(Vec::new()))?,
            parts,
        })
    }

    pub fn sheets(&self) -> impl Iterator<Item = &str> {
        self.sheets.iter().map(|(name, _)| name.as_str())
    }

    /// The cells of the sheet called `name` that have content, each with its row and column from 0.
    ///
    /// A cell without a place follows the one before it.
    pub fn cells(&self, name: &str) -> Result<Vec<(u32, u32, Content<'_>)>, String> {
        let sheet = self.sheets.iter().find(|(known, _)| known == name);
        let (_, sheet) = sheet.ok_or("there is no such sheet")?;
        let (mut next_row, mut next_column) = (0, 0);
        let mut cells = Vec::new();
        let mut cell: Option<Cell> = None;
        let mut text = TextOf::default();
        let mut is_whole = false;
        each_event(part(&self.parts, sheet)?, |event| {
            match &event {
                Event::Start(tag) if is(tag, "row") => {
                    if let Some(row) = attribute(tag, "r")? {
                        next_row = place(&row)?.0;
                    }
                    next_column = 0;
                }
                Event::End(tag) if tag.local_name().as_ref() == "row" => next_row += 1,
                Event::Start(tag) if is(tag, "c") => {
                    let (row, column) = match attribute(tag, "r")? {
                        Some(stated) => {
                            let (row, column) = place(&stated)?;
                            let column = column.ok_or_else(|| no_cell(&stated))?;
                            (row, column)
                        }
                        None => (next_row, next_column),
                    };
                    next_column = column + 1;
                    let style = attribute(tag, "s")?.and_then(|style| style.parse().ok());
                    cell = Some(Cell {
                        row,
                        column,
                        kind: attribute(tag, "t")?,
                        is_date: style.is_some_and(|style: usize| {
                            self.dates.get(style).copied().unwrap_or(false)
                        }),
                    });
                    text = TextOf::default();
                }
                Event::End(tag) if tag.local_name().as_ref() == "c" => {
                    if let Some(cell) = cell.take() {
                        let content = self.content(&cell, std::mem::take(&mut text.found))?;
                        cells.extend(content.map(|content| (cell.row, cell.column, content)));
                    }
                }
                Event::End(tag) if tag.local_name().as_ref() == "sheetData" => {
                    is_whole = true;
                    return Ok(ControlFlow::Break(()));
                }
                _ => {}
            }
            if let Some(cell) = &cell {
                let holder = match cell.kind.as_deref() {
                    Some("inlineStr") => "t",
                    _ => "v",
                };
                text.hear(&event, holder)?;
            }
            Ok(ControlFlow::Continue(()))
        })?;
        if is_whole {
            Ok(cells)
        } else {
            Err("the part ends before its cells do".to_owned())
        }
    }

    /// The content of a cell with this text; `None` for an empty one.
    fn content(&self, cell: &Cell, text: String) -> Result<Option<Content<'_>>, String> {
        if text.is_empty() {
            return Ok(None);
        }
        let content = match cell.kind.as_deref() {
            Some("s") => {
                let number = text.trim().parse::<usize>().ok();
                let shared = number.and_then(|number| self.texts.get(number));
                let shared = shared.ok_or_else(|| format!("there is no shared text {text}"))?;
                Content::Text(Cow::Borrowed(shared))
            }
            Some("b") => match text.trim() {
                "0" | "false" => Content::Flag(false),
                "1" | "true" => Content::Flag(true),
                _ => return Err(format!("{text} is no boolean")),
            },
            Some("d") => Content::Date,
            Some("e") => Content::Error(text),
            Some("str" | "inlineStr") => Content::Text(Cow::Owned(text)),
            Some("n") | None => match text.trim().parse::<f64>() {
                Ok(_) if cell.is_date => Content::Date,
                Ok(number) => Content::Number(number),
                Err(_) if cell.kind.is_none() => Content::Text(Cow::Owned(text)),
                Err(_) => return Err(format!("{text} is no number")),
            },
            Some(kind) => return Err(format!("a cell of the unknown type {kind}")),
        };
        Ok(Some(content))
    }
}

/// A cell whose text is being read.
struct Cell {
    row: u32,
    column: u32,
    /// Its type, `t`.
    kind: Option<String>,
    is_date: bool,
}

/// Collects the text of an element. Phonetic readings, `rPh`, are left out.
#[derive(Default)]
struct TextOf {
    found: String,
    is_inside: bool,
    is_phonetic: bool,
}

impl TextOf {
    /// Takes the text of `event` inside an element called `holder`.
    fn hear(&mut self, event: &Event, holder: &str) -> Result<(), String> {
        match event {
            Event::Start(tag) if is(tag, "rPh") => self.is_phonetic = true,
            Event::End(tag) if tag.local_name().as_ref() == "rPh" => self.is_phonetic = false,
            Event::Start(tag) if is(tag, holder) => self.is_inside = !self.is_phonetic,
            Event::End(tag) if tag.local_name().as_ref() == holder => {
                self.is_inside = false;
                self.found = without_escapes(&self.found);
            }
            Event::Text(text) if self.is_inside => self.found.push_str(&text.xml10_content()),
            Event::CData(text) if self.is_inside => self.found.push_str(&text.xml10_content()),
            Event::GeneralRef(name) if self.is_inside => {
                match name.resolve_char_ref().map_err(|error| error.to_string())? {
                    Some(char) => self.found.push(char),
                    None => {
                        let known = resolve_predefined_entity(name);
                        let text =
                            known.ok_or_else(|| format!("the unknown entity {}", &**name))?;
                        self.found.push_str(text);
                    }
                }
            }
            _ => {}
        }
        Ok(())
    }
}

/// `text` with each `_x000D_` as the character that it stands for (ECMA-376, ST_Xstring).
fn without_escapes(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("_x") {
        let escaped = rest
            .get(at + 2..at + 6)
            .filter(|_| rest[at..].get(6..7) == Some("_"));
        let char = escaped.and_then(|digits| char::from_u32(u32::from_str_radix(digits, 16).ok()?));
        let (shown, length) = char.map_or(('_', 1), |char| (char, 7));
        plain.push_str(&rest[..at]);
        plain.push(shown);
        rest = &rest[at + length..];
    }
    plain + rest
}

struct Related {
    kind: String,
    part: String,
}

/// The parts that `from` names, by their ids; the whole package where `from` is empty.
fn relationships(parts: &Parts, from: &str) -> Result<BTreeMap<String, Related>, String> {
    let (folder, name) = from.rsplit_once('/').unwrap_or(("", from));
    let folder = if folder.is_empty() {
        String::new()
    } else {
        format!("{folder}/")
    };
    let mut found = BTreeMap::new();
    each_event(
        part(parts, &format!("{folder}_rels/{name}.rels"))?,
        |event| {
            if let Event::Start(tag) = event
                && is(&tag, "Relationship")
            {
                let value = |key| Ok::<String, String>(attribute(&tag, key)?.unwrap_or_default());
                let (kind, target) = (value("Type")?, value("Target")?);
                let part = match target.strip_prefix('/') {
                    Some(whole) => whole.to_owned(),
                    None => format!("{folder}{target}"),
                };
                let kind = kind.rsplit('/').next().unwrap_or_default().to_owned();
                found.insert(value("Id")?, Related { kind, part });
            }
            Ok(ControlFlow::Continue(()))
        },
    )?;
    Ok(found)
}

fn part<'a>(parts: &'a Parts, name: &str) -> Result<&'a str, String> {
    let bytes = parts.get(&name.to_lowercase());
    let bytes = bytes.ok_or_else(|| format!("it has no part {name}"))?;
    std::str::from_utf8(gearlash_text::without_mark(bytes))
        .map_err(|_| format!("{name}: not UTF-8"))
}

/// Hands each event of an XML text to `take`, until it breaks. An empty element starts and ends.
fn each_event(
    text: &str,
    mut take: impl FnMut(Event) -> Result<ControlFlow<()>, String>,
) -> Result<(), String> {
    let mut reader = Reader::from_str(text);
    reader.config_mut().expand_empty_elements = true;
    loop {
        let event = reader.read_event().map_err(|error| error.to_string())?;
        if event == Event::Eof || take(event)?.is_break() {
            return Ok(());
        }
    }
}

fn is(tag: &BytesStart, name: &str) -> bool {
    tag.local_name().as_ref() == name
}

/// The attribute of `tag` with this name in any namespace.
fn attribute(tag: &BytesStart, name: &str) -> Result<Option<String>, String> {
    // Duplicate names are not searched: the time would grow with the square of their number.
    for attribute in tag.attributes().with_checks(false) {
        let attribute = attribute.map_err(|error| error.to_string())?;
        if attribute.key.local_name().as_ref() == name {
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            return Ok(Some(value.map_err(|error| error.to_string())?.into_owned()));
        }
    }
    Ok(None)
}

/// Row and column from 0 of a reference, `B7`; a row alone, `7`, has no column.
fn place(reference: &str) -> Result<(u32, Option<u32>), String> {
    let letters = reference
        .bytes()
        .take_while(u8::is_ascii_alphabetic)
        .count();
    let (letters, digits) = reference.split_at(letters);
    let is_number = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
    if !is_number || letters.len() > MAX_LETTERS || digits.len() > MAX_DIGITS {
        return Err(no_cell(reference));
    }
    let row = digits
        .parse::<u32>()
        .ok()
        .and_then(|row| row.checked_sub(1));
    let column = letters.bytes().fold(0, |column, letter| {
        26 * column + u32::from(letter.to_ascii_uppercase() - b'A') + 1
    });
    Ok((
        row.ok_or_else(|| no_cell(reference))?,
        column.checked_sub(1),
    ))
}

fn no_cell(reference: &str) -> String {
    format!("no spreadsheet has a cell \"{reference}\"")
}

fn texts(part: &str) -> Result<Vec<String>, String> {
    let mut texts = Vec::new();
    let mut text = TextOf::default();
    each_event(part, |event| {
        match &event {
            Event::Start(tag) if is(tag, "si") => text = TextOf::default(),
            Event::End(tag) if tag.local_name().as_ref() == "si" => {
                texts.push(std::mem::take(&mut text.found));
            }
            _ => text.hear(&event, "t")?,
        }
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(texts)
}

/// For each format of cells whether it shows a date or time.
fn dates(part: &str) -> Result<Vec<bool>, String> {
    let mut own = BTreeSet::new();
    let mut dates = Vec::new();
    let mut is_of_cells = false;
    each_event(part, |event| {
        match &event {
            Event::Start(tag) if is(tag, "numFmt") => {
                let code = attribute(tag, "formatCode")?.unwrap_or_default();
                if shows_date(&code) {
                    own.extend(attribute(tag, "numFmtId")?);
                }
            }
            Event::Start(tag) if is(tag, "cellXfs") => is_of_cells = true,
            Event::End(tag) if tag.local_name().as_ref() == "cellXfs" => is_of_cells = false,
            Event::Start(tag) if is(tag, "xf") && is_of_cells => {
                let id = attribute(tag, "numFmtId")?.unwrap_or_default();
                let builtin = id.parse().is_ok_and(is_builtin_date);
                dates.push(own.contains(&id) || builtin);
            }
            _ => {}
        }
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(dates)
}

/// Whether a format that no workbook defines shows a date or time (ECMA-376, 18.8.30, those of East Asia included).
fn is_builtin_date(id: u32) -> bool {
    matches!(id, 14..=22 | 27..=36 | 45..=47 | 50..=58)
}

/// Whether a format shows a date or time: a letter of days, months, years, hours or seconds in its first section, outside quotes,
/// escapes and brackets; or `[h]`, `[mm]`, `[ss]`, the time gone.
fn shows_date(code: &str) -> bool {
    let is_unit = |char: char| "dmyhs".contains(char.to_ascii_lowercase());
    let mut chars = code.chars();
    while let Some(char) = chars.next() {
        match char {
            ';' => return false,
            '\\' | '_' | '*' => {
                chars.next();
            }
            '"' => {
                chars.by_ref().find(|char| *char == '"');
            }
            '[' => {
                let inside: Vec<char> = chars.by_ref().take_while(|char| *char != ']').collect();
                if !inside.is_empty() && inside.into_iter().all(is_unit) {
                    return true;
                }
            }
            _ if is_unit(char) => return true,
            _ => {}
        }
    }
    false
}
