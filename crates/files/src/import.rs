//! What a file of a measuring machine, a workbook or a CSV holds: every table that gearlash reads, its numbers, and the lines of a pair
//! file that name it.
//!
//! Each kind of table is read as the pair file would have it read, so that the lines give the same numbers.

use crate::data_file::DataFile;
use crate::error::{InputError, Problem};
use crate::node::Node;
use crate::place::Place;
use crate::problems::Problems;
use crate::rexs;
use crate::sheet::{
    self, Choice, Column, Coverage, Header, Origin, Position, Sheet, TraceSheet, Wanted,
};
use crate::source;
use crate::sources::Sources;
use crate::table::Table;
use gearlash::metrology::PitchKind;
use serde::Serialize;
use std::path::Path;

/// What a file is, by what it holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// A table in cells (CSV, a workbook), or the text protocol or curve file of a measuring machine.
    Table,
    /// A gearbox model, REXS.
    GearboxModel,
}

impl Content {
    /// What the file at `path` with these bytes is; standard input is a gearbox model.
    pub fn of(path: &Path, bytes: &[u8]) -> Content {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        // No table begins like XML or JSON.
        let begins = matches!(text.trim_ascii_start().first(), Some(b'<' | b'{'));
        match begins || rexs::is_rexs(path) || path == Path::new(crate::STANDARD_INPUT) {
            true => Content::GearboxModel,
            false => Content::Table,
        }
    }
}

/// The bytes of the file at `path`.
///
/// # Errors
/// [`InputError`] where it cannot be read.
pub fn bytes(path: &Path) -> Result<Vec<u8>, InputError> {
    source::bytes(path).map_err(|problem| InputError {
        file: path.to_owned(),
        problems: vec![problem],
        text: String::new(),
    })
}

/// What a table holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Pitch deviation of both flanks.
    Pitch,
    /// Radial runout readings.
    Runout,
    /// Thickness of each tooth.
    Thickness,
    /// Positions of a probe at every flank, from which the thickness of each tooth follows.
    Positions,
    /// Spans all round.
    Span,
    /// Dimensions over pins all round.
    OverPins,
    /// Profile traces.
    Trace,
}

/// What the user says of a file.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options<'a> {
    /// Only tables of this kind.
    pub only: Option<Kind>,
    /// Keys of the pair file, and their text or whole number.
    pub keys: &'a [(&'static str, String)],
    /// The table of the gear in the file to be written: `wheel`, `pinion` or `gear`.
    pub gear: &'a str,
}

/// What was understood of a file.
#[derive(Debug, Clone, Serialize)]
pub struct Imported {
    /// The file's name.
    pub file: String,
    /// At least one.
    pub tables: Vec<ImportedTable>,
    /// What is there, but not read, and why.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_read: Vec<String>,
    /// To be pasted into a pair file or gear file beside the file.
    pub toml: String,
    /// The files that were read.
    #[serde(skip)]
    pub sources: Sources,
}

impl Imported {
    /// As JSON.
    pub fn to_json(&self) -> String {
        // Names are strings and numbers are finite: nothing that JSON cannot hold.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// One table.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedTable {
    /// What it holds.
    pub kind: Kind,
    /// Its name in words.
    pub title: String,
    /// Of pitch, "single" or "cumulative" where the table says it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_kind: Option<&'static str>,
    /// Of a workbook that has several, its sheet.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// The line of its header; none in a protocol.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub header_row: Option<u64>,
    /// What of the file is no part of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<String>,
    /// Its columns, as many values in each.
    pub columns: Vec<ImportedColumn>,
}

/// One column.
#[derive(Debug, Clone, Serialize)]
pub struct ImportedColumn {
    /// What it is, with its unit: `tooth`, `right_um`.
    pub name: &'static str,
    /// Its heading in the file, and its letter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<(String, String)>,
    /// A value a row.
    pub values: Vec<Value>,
}

/// A value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A tooth.
    Whole(u32),
    /// A deviation or a length.
    Number(f64),
    /// A flank.
    Word(&'static str),
    /// Nothing.
    None,
}

/// The tables in the `bytes` of the file at `path`: CSV, a workbook, or a text protocol.
///
/// # Errors
/// [`InputError`] with all that is wrong with its tables; keys are those of a pair file.
pub fn tables(path: &Path, bytes: Vec<u8>, options: &Options) -> Result<Imported, InputError> {
    let place = Place::of_working_folder();
    let name = path.display().to_string();
    let mut entries = vec![("file".to_owned(), Node::Text(name.clone()))];
    for (key, text) in options.keys {
        let node = match (*key, text.parse()) {
            ("header_row", Ok(row)) => Node::Whole(row),
            _ => Node::Text(text.clone()),
        };
        entries.push(((*key).to_owned(), node));
    }
    let mut problems = Problems::of_list();
    let mut not_read = Problems::of_list();
    let found = [&mut problems, &mut not_read];
    let tables = read(&entries, bytes, &place, options, found);
    // Without anything else that is there, it is what is wrong.
    let is_alone = tables.as_ref().is_some_and(|tables| tables.is_empty());
    if is_alone {
        problems.add_list(
            "file",
            std::mem::replace(&mut not_read, Problems::of_list()),
        );
    }
    match tables {
        Some(tables) if problems.is_empty() => Ok(Imported {
            not_read: not_read
                .into_list()
                .into_iter()
                .map(|problem| of_file(problem, &name).to_string())
                .collect(),
            file: name.clone(),
            toml: toml(&tables, path, options),
            tables,
            sources: place.sources(),
        }),
        _ => {
            // Columns of neither kind of pitch are read as both.
            let mut told: Vec<Problem> = Vec::new();
            for problem in problems.into_list() {
                let problem = of_file(problem, &name);
                if !told.contains(&problem) {
                    told.push(problem);
                }
            }
            Err(InputError {
                file: path.to_owned(),
                problems: told,
                text: String::new(),
            })
        }
    }
}

/// A problem without the key and the path, which name the file once more.
fn of_file(problem: Problem, name: &str) -> Problem {
    let reason = problem.reason.strip_prefix(&format!("{name}: "));
    Problem {
        key: problem
            .key
            .strip_prefix("file")
            .unwrap_or(&problem.key)
            .to_owned(),
        value: None,
        reason: reason.unwrap_or(&problem.reason).to_owned(),
        ..problem
    }
}

const KEYS: &[&str] = &sheet::keys_beside::<2, 8>(["left", "right"]);

fn read(
    entries: &[(String, Node)],
    bytes: Vec<u8>,
    place: &Place,
    options: &Options,
    [problems, not_read]: [&mut Problems; 2],
) -> Option<Vec<ImportedTable>> {
    let table = Table::new("", place, entries, KEYS, problems);
    let file = DataFile::of(&table, "the name of a table", problems)?;
    let choice = Choice::read(&table, problems)?;
    let content = sheet::content(&file, bytes, &table, &choice, problems)?;
    let from = From {
        file: &file,
        content: &content,
        choice: &choice,
    };
    let mut tables = Vec::new();
    let is_asked = |kind| options.only.is_none_or(|only| only == kind);
    if is_asked(Kind::Pitch) {
        from.pitch(
            options.only.is_some(),
            &mut tables,
            [&mut *problems, &mut *not_read],
        );
    }
    let singles = [
        (Kind::Runout, Column::Runout, "runout_um", "Runout F_r, µm"),
        (
            Kind::Thickness,
            Column::Thickness,
            "thickness_um",
            "Thickness beyond the mean, µm",
        ),
        (Kind::Span, Column::Span, "span_mm", "Span W_k, mm"),
        (
            Kind::OverPins,
            Column::OverPins,
            "over_pins_mm",
            "Dimension over pins M_dK, mm",
        ),
    ];
    for (kind, column, name, title) in singles {
        if kind == Kind::Thickness && is_asked(kind) && content.has_positions() {
            let found = content.positions(&file, problems);
            tables.extend(found.map(|(positions, header)| positioned(&positions, &header)));
            continue;
        }
        // A key that names the column says nothing of what it holds.
        let named = choice.column("column").is_none() || options.only.is_some();
        if is_asked(kind) && named && (options.only.is_some() || from.has(&[column])) {
            let coverage = match kind {
                Kind::Runout | Kind::Thickness => Coverage::EveryTooth,
                _ => Coverage::SomeTeeth,
            };
            // What is not asked for by its name hides nothing else.
            let told = match from.has_each([column], coverage) || options.only.is_some() {
                true => &mut *problems,
                false => &mut *not_read,
            };
            if let Some(sheet) = from.sheet([column], coverage, told) {
                tables.push(ImportedTable::of(kind, title.to_owned(), [name], &sheet));
            }
        }
    }
    if is_asked(Kind::Trace) && (options.only.is_some() || from.has_trace()) {
        let traces = TraceSheet::of(&content, &file, &choice, (None, None), problems);
        tables.extend(traces.as_ref().map(traced));
    }
    if tables.is_empty() && problems.is_empty() && content.is_p40() {
        content.positions(&file, problems)?;
        problems.add(file.problem(
            "has no pitch (linke, rechte Zahnflanke), no profile trace (Profil:) and no positions of the probe (Teilung:)",
            "name a file that has one of them",
        ));
        return None;
    }
    if tables.is_empty() && problems.is_empty() && not_read.is_empty() {
        problems.add(file.problem(
            "no line names a column of teeth and one of pitch, runout, thickness, span or dimension over pins, nor of a profile",
            "say what it holds and where, by letter or heading: --only pitch --header-row 1 --tooth-column A --left B --right C",
        ));
    }
    Some(tables)
}

/// What is read from.
struct From<'a> {
    file: &'a DataFile,
    content: &'a sheet::Content,
    choice: &'a Choice<'a>,
}

impl From<'_> {
    fn has(&self, columns: &[Column]) -> bool {
        self.content.has(columns, self.choice)
    }

    fn has_each<const N: usize>(&self, columns: [Column; N], coverage: Coverage) -> bool {
        let wanted = Wanted {
            columns,
            teeth: None,
            coverage,
        };
        self.content.has_each(self.file, &wanted, self.choice)
    }

    fn has_trace(&self) -> bool {
        self.content.has_trace(self.choice)
    }

    /// Cumulative and single pitch, or what a table has that does not say which.
    fn pitch(
        &self,
        asked: bool,
        tables: &mut Vec<ImportedTable>,
        [problems, not_read]: [&mut Problems; 2],
    ) {
        let columns = |kind| [Column::Right(kind), Column::Left(kind)];
        let chosen = ["left", "right"].map(|key| self.choice.column(key));
        let chosen = chosen.iter().any(Option::is_some);
        let mut first: Option<Option<Origin>> = None;
        let mut faults = Vec::new();
        for kind in [PitchKind::Cumulative, PitchKind::Single] {
            let only_other = self.has(&columns(kind).map(Column::of_other_kind));
            if !(self.has(&columns(kind)) || asked && kind == PitchKind::Cumulative && !only_other)
            {
                continue;
            }
            let mut bad = Problems::of_list();
            let sheet = self.sheet(columns(kind), Coverage::EveryTooth, &mut bad);
            let Some(sheet) = sheet.filter(|_| bad.is_empty()) else {
                faults.push((bad, self.has_each(columns(kind), Coverage::EveryTooth)));
                continue;
            };
            // Columns of neither kind may be of both.
            if first
                .as_ref()
                .is_some_and(|first| first.is_some() && *first == sheet.origin)
            {
                continue;
            }
            let said = match &sheet.origin {
                Some(origin) => origin.kind,
                None => Some(kind),
            };
            let (pitch_kind, title) = match said {
                Some(PitchKind::Single) => (Some("single"), "Single pitch deviation fp, µm"),
                Some(PitchKind::Cumulative) => {
                    (Some("cumulative"), "Cumulative pitch deviation Fp, µm")
                }
                None => (None, "Pitch deviation, fp or Fp, µm"),
            };
            let table = ImportedTable::of(
                Kind::Pitch,
                title.to_owned(),
                ["right_um", "left_um"],
                &sheet,
            );
            tables.push(ImportedTable {
                pitch_kind,
                ..table
            });
            first = Some(sheet.origin);
        }
        // Columns that were named are of one kind: that they are not of the other is no fault.
        match (chosen, &first) {
            (true, Some(_)) => faults.clear(),
            (true, None) => faults.truncate(1),
            (false, _) => {}
        }
        for (bad, has_each) in faults {
            // Beside the one kind, of which there is a column a flank, the other hides nothing.
            let told = match has_each || first.is_none() {
                true => &mut *problems,
                false => &mut *not_read,
            };
            told.add_list(self.file.key(), bad);
        }
    }

    fn sheet<const N: usize>(
        &self,
        columns: [Column; N],
        coverage: Coverage,
        problems: &mut Problems,
    ) -> Option<Sheet<N>> {
        let mut wanted = Wanted {
            columns,
            teeth: None,
            coverage,
        };
        let sheet = Sheet::of(self.content, self.file, self.choice, &wanted, problems)?;
        // As many teeth as the file says, or as there are: one that is missing is told.
        let last = sheet.rows.last().map(|row| row.tooth);
        wanted.teeth = sheet.header.teeth().or(last);
        match coverage {
            Coverage::EveryTooth => {
                Sheet::of(self.content, self.file, self.choice, &wanted, problems)
            }
            Coverage::SomeTeeth => Some(sheet),
        }
    }
}

impl ImportedTable {
    fn of<const N: usize>(
        kind: Kind,
        title: String,
        names: [&'static str; N],
        sheet: &Sheet<N>,
    ) -> ImportedTable {
        let heading = |place: usize| Some(sheet.origin.as_ref()?.columns.get(place)?.clone());
        let tooth = sheet.rows.iter().map(|row| Value::Whole(row.tooth));
        let mut columns = vec![ImportedColumn {
            name: "tooth",
            heading: heading(0),
            values: tooth.collect(),
        }];
        for (place, name) in names.into_iter().enumerate() {
            columns.push(ImportedColumn {
                name,
                heading: heading(place + 1),
                values: sheet.values(place).into_iter().map(Value::Number).collect(),
            });
        }
        ImportedTable {
            kind,
            title,
            pitch_kind: None,
            sheet: sheet
                .origin
                .as_ref()
                .and_then(|origin| origin.sheet.clone()),
            header_row: sheet.origin.as_ref().map(|origin| origin.header_row),
            left_out: left_out(sheet.origin.as_ref(), &sheet.header),
            columns,
        }
    }
}

/// What of the file is no part of a table, in words.
fn left_out(origin: Option<&Origin>, header: &Header) -> Option<String> {
    match origin {
        Some(origin) => origin.left_out.clone(),
        None => header.unused().map(str::to_owned),
    }
}

fn positioned(positions: &[Position], header: &Header) -> ImportedTable {
    let column = |name, value: &dyn Fn(&Position) -> Value| ImportedColumn {
        name,
        heading: None,
        values: positions.iter().map(value).collect(),
    };
    ImportedTable {
        kind: Kind::Positions,
        title: "Positions of the probe (Teilung:), which give the thickness of each tooth"
            .to_owned(),
        pitch_kind: None,
        sheet: None,
        header_row: None,
        left_out: left_out(None, header),
        columns: vec![
            column("tooth", &|at| Value::Whole(at.tooth)),
            column("flank", &|at| Value::Word(at.flank.name())),
            column("phi_deg", &|at| Value::Number(at.at[0])),
            column("x_mm", &|at| Value::Number(at.at[1])),
            column("y_mm", &|at| Value::Number(at.at[2])),
        ],
    }
}

fn traced(traces: &TraceSheet) -> ImportedTable {
    let rows = &traces.rows;
    let origin = traces.origin.as_ref();
    let tooth = rows
        .iter()
        .map(|row| row.tooth.map_or(Value::None, Value::Whole));
    let flank = rows.iter().map(|row| {
        row.flank
            .map_or(Value::None, |flank| Value::Word(flank.name()))
    });
    let at = match traces.by {
        Column::Diameter => "diameter_mm",
        _ => "roll_length_mm",
    };
    let columns: [(&str, Vec<Value>); 4] = [
        ("tooth", tooth.collect()),
        ("flank", flank.collect()),
        (
            at,
            rows.iter().map(|row| Value::Number(row.at_mm)).collect(),
        ),
        (
            "deviation_um",
            rows.iter()
                .map(|row| Value::Number(row.deviation_um))
                .collect(),
        ),
    ];
    let there = columns
        .into_iter()
        .filter(|(_, values)| values.iter().any(|value| *value != Value::None));
    ImportedTable {
        kind: Kind::Trace,
        title: "Profile traces, mm and µm".to_owned(),
        pitch_kind: None,
        sheet: origin.and_then(|origin| origin.sheet.clone()),
        header_row: origin.map(|origin| origin.header_row),
        left_out: left_out(origin, &traces.header),
        columns: there
            .map(|(name, values)| ImportedColumn {
                name,
                heading: None,
                values,
            })
            .collect(),
    }
}

/// The lines of a pair file that name the tables, and what else it must say of them.
fn toml(tables: &[ImportedTable], path: &Path, options: &Options) -> String {
    let text = |text: &str| toml::Value::String(text.to_owned()).to_string();
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
            Kind::Pitch => ("pitch", "kind = \"single\" (fp) or \"cumulative\" (Fp)"),
            Kind::Runout => (
                "runout",
                "at = \"tooth\" (fork) or \"space\" (ball, between it and the next)",
            ),
            Kind::Thickness => ("thickness.per_tooth_um", ""),
            Kind::Positions => ("thickness", ""),
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
        lines += &format!("[{}.{below}]\nfile = {}\n", options.gear, text(&name));
        match table.pitch_kind {
            Some(kind) => lines += &format!("kind = \"{kind}\"\n"),
            None if unsaid.is_empty() => {}
            None => lines += &format!("# To be added, for the file does not say it: {unsaid}\n"),
        }
        let is_said = |key: &str| options.keys.iter().any(|(known, _)| *known == key);
        if let Some(sheet) = table.sheet.as_ref().filter(|_| !is_said("sheet")) {
            lines += &format!("sheet = {}\n", text(sheet));
        }
        for (key, said) in options.keys {
            let is_pitch = table.kind == Kind::Pitch;
            match *key {
                "left" | "right" if !is_pitch => {}
                "column" if is_pitch => {}
                "header_row" => lines += &format!("{key} = {said}\n"),
                _ => lines += &format!("{key} = {}\n", text(said)),
            }
        }
        written.push(table.kind);
    }
    lines
}
