//! A row type and its one list of columns; JSON, CSV and tables for people are made from the list.
//!
//! A [`Row`] is one line of a result: a pose, a run, an extreme, a check. Each of its values is one [`Column`], stated once:
//!
//! - *key*: the path in JSON. `right.wheel_tooth` is the key `wheel_tooth` of the object `right`; `j_wt_range_um.0` is the first
//!   element of a list.
//! - *csv*: the column's name in CSV. Without another name it is the key with `_` for the dots.
//! - *value*: a function of the row.
//! - *heading*: the heading in a table for people. A column without a heading is not in it.
//! - *array*, *page*: the column's name among the arrays for numpy, and in the data of a page.
//!
//! JSON has the order of the list. [`Column::rank`] moves a column in CSV: a program can depend on the position of a CSV column,
//! so a new column gets a rank that places it last.

use crate::layout::{self, Screen, Table, Tone};
use gearlash::pair::BacklashUnit;
use gearlash_text::characters::{self, cell, plain};
use gearlash_text::numbers::{NONE, backlash, backlash_ascii, fixed, power, stated_distance};
use serde::{Serialize, Serializer};
use serde_json::{Value as Json, json};
use std::iter;

/// A row type.
pub trait Row: Sized + 'static {
    /// Its columns.
    fn columns() -> &'static Columns<Self>;

    /// The row as a JSON object, for a serializer.
    fn object(&self) -> Object {
        let columns = Self::columns().columns.iter();
        let cells =
            columns.filter_map(|column| Some((column.key.as_deref()?, (column.value)(self))));
        Object(cells.filter(|(_, value)| *value != Value::Absent).collect())
    }

    /// The row as a JSON object.
    fn json(&self) -> Json {
        json!(self.object())
    }
}

/// Rows as a list of JSON.
pub(crate) fn list<'r, R: Row>(rows: impl IntoIterator<Item = &'r R>) -> Json {
    rows.into_iter().map(R::json).collect()
}

/// CSV of these records in memory. Each is a list of as many plain values, which CSV can hold.
pub(crate) fn csv_text<R: Serialize>(records: impl IntoIterator<Item = R>) -> String {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    for record in records {
        let written = writer.serialize(record);
        debug_assert!(written.is_ok(), "{written:?}");
    }
    let bytes = writer.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// `value` as JSON with a line end.
pub(crate) fn json_text(value: &Json) -> String {
    characters::json(format!("{value:#}")) + "\n"
}

/// The value of a column in one row.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// The key is left out. In a list, in CSV and for people it means no value.
    Absent,
    /// A least and a greatest backlash, µm, each with the centre distance, mm, at which it is a lost motion.
    Band([(Option<f64>, f64); 2]),
    /// A word of the interface. A pose has many, and copies none.
    Word(&'static str),
    /// A value of JSON; null for no value.
    Json(Json),
}

impl Value {
    /// No value.
    pub const NULL: Value = Value::Json(Json::Null);

    /// `value`; without one the key is left out.
    pub fn optional(value: Option<impl Into<Value>>) -> Value {
        value.map_or(Value::Absent, Into::into)
    }

    /// A word of the interface; without one null.
    pub fn word(word: impl Into<Option<&'static str>>) -> Value {
        word.into().map_or(Value::NULL, Value::Word)
    }

    /// A length in µm; `mm` is in mm.
    pub fn um(mm: impl Into<Option<f64>>) -> Value {
        mm.into().map(|mm| mm * 1e3).into()
    }

    /// The number of a measure; `None` for a count and for anything else.
    pub fn measure(&self) -> Option<f64> {
        match self {
            Value::Json(Json::Number(number)) if number.is_f64() => number.as_f64(),
            _ => None,
        }
    }

    /// Its text; `None` for anything else.
    pub fn text(&self) -> Option<&str> {
        match self {
            Value::Word(word) => Some(word),
            Value::Json(Json::String(text)) => Some(text),
            _ => None,
        }
    }
}

impl<T: Into<Json>> From<T> for Value {
    fn from(value: T) -> Value {
        Value::Json(value.into())
    }
}

/// The format of a number for people.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A word, or a number as it is.
    Plain,
    /// Words of a file, unchanged.
    Name,
    /// A centre distance, mm, as stated.
    Distance,
    /// A backlash in µm, or in the requested unit; the heading names the unit.
    Backlash,
    /// A backlash beside another one: the heading does not name the unit again.
    BacklashAgain,
    /// An error bound of a backlash, by its order of magnitude.
    Bound,
    /// A measure with this number of decimals.
    Fixed(usize),
    /// A status or a verdict, coloured by its severity.
    Severity,
    /// An angle, rad; degrees in a page.
    Angle,
    /// A place in a picture, mm; in a page with the decimals of its outlines.
    Place,
}

/// The value of a row in one column.
type Get<R> = Box<dyn Fn(&R) -> Value + Send + Sync>;

/// One column of a row type.
pub struct Column<R> {
    key: Option<String>,
    csv: Option<String>,
    rank: u8,
    /// Whether CSV has it only where the caller asks for it.
    optional_in_csv: bool,
    format: Format,
    heading: Option<layout::Column>,
    /// Its values are empty.
    array: Option<Array>,
    page: Option<String>,
    value: Get<R>,
}

impl<R: 'static> Column<R> {
    /// A column of JSON and CSV; without a key, of CSV where it has a name there.
    pub fn new(key: &str, format: Format, value: Get<R>) -> Column<R> {
        Column {
            key: Some(key.to_owned()).filter(|key| !key.is_empty()),
            csv: Some(key.replace('.', "_")).filter(|name| !name.is_empty()),
            rank: 1,
            optional_in_csv: false,
            format,
            heading: None,
            array: None,
            page: None,
            value,
        }
    }

    /// Another name in CSV.
    pub fn csv(mut self, name: &str) -> Column<R> {
        self.csv = Some(name.to_owned());
        self
    }

    /// Not in CSV.
    pub fn no_csv(mut self) -> Column<R> {
        self.csv = None;
        self
    }

    /// In CSV, columns of a lower rank come first; the default is 1.
    pub fn rank(mut self, rank: u8) -> Column<R> {
        self.rank = rank;
        self
    }

    /// Last in CSV, and only where the caller asks for it.
    pub fn optional_in_csv(mut self) -> Column<R> {
        self.optional_in_csv = true;
        self.rank(u8::MAX)
    }

    /// The heading for people.
    pub fn heading(mut self, heading: layout::Column) -> Column<R> {
        self.heading = Some(heading);
        self
    }

    /// The column's name among the arrays for numpy, and the type of its entries there.
    pub fn array(mut self, name: &'static str, values: Values) -> Column<R> {
        self.array = Some(Array { name, values });
        self
    }

    /// The column's name in the data of a page.
    pub fn page(mut self, name: &str) -> Column<R> {
        self.page = Some(name.to_owned());
        self
    }
}

/// Columns of a row type, one per line: key, format, further properties of [`Column`], and value.
macro_rules! columns {
    ($row:ident: $type:ty { $($key:literal $format:ident $(($decimals:literal))? $([$($with:ident $(($($to:expr),*))?),*])? => $value:expr;)* }) => {
        vec![$($crate::column::Column::<$type>::new(
            $key,
            $crate::column::Format::$format $(($decimals))?,
            Box::new(|$row: &$type| $crate::column::Value::from($value)),
        )$($(.$with($($($to),*)?))*)?),*]
    };
}
pub(crate) use columns;

/// Implements [`Row`]: for the columns as [`columns!`] takes them, or for a list of them.
macro_rules! row_type {
    ($row:ident: $type:ty { $($columns:tt)* }) => {
        $crate::column::row_type!($type = $crate::column::columns!($row: $type { $($columns)* }));
    };
    ($type:ty = $columns:expr) => {
        impl $crate::column::Row for $type {
            fn columns() -> &'static $crate::column::Columns<$type> {
                static COLUMNS: std::sync::LazyLock<$crate::column::Columns<$type>> =
                    std::sync::LazyLock::new(|| $crate::column::Columns::new($columns));
                &COLUMNS
            }
        }
    };
}
pub(crate) use row_type;

/// A column for people with this heading.
pub(crate) fn shown(heading: &str) -> layout::Column {
    layout::Column::new(heading)
}

/// The columns of a row type.
pub struct Columns<R> {
    columns: Vec<Column<R>>,
    /// The indices of the columns in CSV order.
    csv: Vec<usize>,
}

impl<R: Row> Columns<R> {
    /// The `columns` of a row type.
    pub fn new(columns: Vec<Column<R>>) -> Columns<R> {
        let mut csv: Vec<usize> = (0..columns.len())
            .filter(|number| columns[*number].csv.is_some())
            .collect();
        csv.sort_by_cached_key(|number| columns[*number].rank);
        Columns { columns, csv }
    }

    /// The columns for another row type that contains such a row under `prefix`.
    pub fn within<O: 'static>(
        &'static self,
        prefix: &str,
        row: fn(&O) -> Option<&R>,
    ) -> impl Iterator<Item = Column<O>> {
        let is_held = |column: &&Column<R>| column.key.is_some() || column.page.is_some();
        self.columns.iter().filter(is_held).map(move |column| {
            let joined = |name: &String| format!("{prefix}_{name}");
            Column {
                key: column.key.as_ref().map(|key| format!("{prefix}.{key}")),
                csv: column.csv.as_ref().map(joined),
                rank: column.rank,
                optional_in_csv: column.optional_in_csv,
                format: column.format,
                heading: None,
                array: None,
                page: column.page.as_ref().map(joined),
                value: Box::new(move |whole| match row(whole) {
                    Some(row) => (column.value)(row),
                    None => Value::Absent,
                }),
            }
        })
    }

    /// The name of each column: its key in JSON, else its name in CSV.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let columns = self.columns.iter();
        columns.filter_map(|column| column.key.as_deref().or(column.csv.as_deref()))
    }

    /// The columns in CSV, with or without the optional ones.
    fn in_csv(&self, with_optional: bool) -> impl Iterator<Item = &Column<R>> {
        let columns = self.csv.iter().map(|number| &self.columns[*number]);
        columns.filter(move |column| with_optional || !column.optional_in_csv)
    }

    /// The names of the columns in CSV, with or without the optional ones.
    pub fn csv_names(&self, with_optional: bool) -> impl Iterator<Item = &str> {
        self.in_csv(with_optional)
            .filter_map(|column| column.csv.as_deref())
    }

    /// The values of `row` in CSV, with or without the optional ones.
    pub fn csv_values(&self, row: &R, with_optional: bool) -> Vec<Value> {
        let columns = self.in_csv(with_optional);
        columns.map(|column| (column.value)(row)).collect()
    }

    /// The numpy arrays of `rows`.
    pub fn arrays(&self, rows: &[R]) -> Vec<Array> {
        let columns = self.columns.iter().filter_map(|column| {
            let mut array = column.array.clone()?;
            rows.iter().for_each(|row| array.push(&(column.value)(row)));
            Some(array)
        });
        columns.collect()
    }

    /// The columns of `rows` for a page: names, formats and values.
    pub fn page(&self, rows: &[R]) -> Vec<(&str, Format, Vec<Value>)> {
        let columns = self.columns.iter().filter_map(|column| {
            let values = rows.iter().map(|row| (column.value)(row));
            Some((column.page.as_deref()?, column.format, values.collect()))
        });
        columns.collect()
    }

    /// `rows` as CSV.
    pub fn csv(&self, rows: &[R]) -> String {
        self.csv_with(rows, false)
    }

    /// As [`Columns::csv`], with or without the optional columns.
    pub(crate) fn csv_with(&self, rows: &[R], with_optional: bool) -> String {
        let text = |value: Value| match value.text() {
            Some(text) => cell(text),
            None if value == Value::NULL => String::new(),
            None => display_text(&value, Format::Plain, BacklashUnit::Um, f64::NAN),
        };
        let names = self.csv_names(with_optional).map(str::to_owned).collect();
        let records = rows.iter().map(|row| {
            let values = self.csv_values(row, with_optional);
            values.into_iter().map(text).collect()
        });
        csv_text::<Vec<String>>(iter::once(names).chain(records))
    }

    /// The columns of `rows` for people, backlash in `unit`. A column without any value is left out. `distance` is the centre
    /// distance of a row, mm.
    pub fn for_people(
        &self,
        rows: &[R],
        distance: impl Fn(&R) -> f64,
        unit: BacklashUnit,
    ) -> Vec<PeopleColumn> {
        let shown = self.columns.iter().filter_map(|column| {
            let heading = column.heading.as_ref()?;
            let values: Vec<Value> = rows.iter().map(|row| (column.value)(row)).collect();
            // Without any value of a model, its column is empty.
            let is_empty = values.iter().all(|value| {
                *value == Value::Absent
                    || *value == Value::NULL && column.format == Format::BacklashAgain
            });
            let cells = values.iter().zip(rows);
            let cells =
                cells.map(|(value, row)| display_text(value, column.format, unit, distance(row)));
            (!is_empty).then(|| PeopleColumn {
                heading: match column.format {
                    Format::Backlash => heading.renamed(|name| column_heading(unit, name)),
                    _ => heading.clone(),
                },
                format: column.format,
                cells: cells.collect(),
            })
        });
        shown.collect()
    }

    /// The columns of `rows` for people, backlash in µm.
    pub(crate) fn in_um(&self, rows: &[R]) -> Vec<PeopleColumn> {
        self.for_people(rows, |_| f64::NAN, BacklashUnit::Um)
    }

    /// A table of `rows` for a terminal, as [`Columns::for_people`].
    pub fn table(
        &self,
        rows: &[R],
        distance: impl Fn(&R) -> f64,
        unit: BacklashUnit,
        screen: &Screen,
    ) -> String {
        let shown = self.for_people(rows, distance, unit).into_iter();
        let columns = shown.map(|column| {
            let cells = column.cells.into_iter();
            let cells = cells.map(|cell| match (column.format, Tone::of(&cell)) {
                (Format::Severity, Some(tone)) => screen.toned(tone, &cell),
                (Format::Name, _) => cell,
                _ => cell.replace('−', "-"),
            });
            (column.heading, cells.collect())
        });
        Table(columns.collect()).text(screen)
    }

    /// A table of `rows` in Markdown, backlash in µm.
    pub fn markdown(&self, rows: &[R]) -> String {
        let shown = self.in_um(rows);
        let line = |cell: &dyn Fn(&PeopleColumn) -> String| {
            let cells: Vec<String> = shown.iter().map(cell).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let mut text = line(&|column| column.heading.heading().to_owned());
        let rule = |is_left: bool| if is_left { ":--" } else { "--:" };
        text += &line(&|column| rule(column.heading.is_left()).to_owned());
        for number in 0..rows.len() {
            text += &line(&|column| column.cells[number].replace('−', "-"));
        }
        text
    }

    /// A table of `rows` whose backlash is in µm, for a terminal.
    pub fn text(&self, rows: &[R], screen: &Screen) -> String {
        self.table(rows, |_| f64::NAN, BacklashUnit::Um, screen)
    }
}

/// The values of one column, one entry per row.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// The name of the column.
    pub name: &'static str,
    /// Its values.
    pub values: Values,
}

/// The entries of an array.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers of teeth.
    Counts(Vec<u32>),
    /// Numbers; NaN for no value.
    Numbers(Vec<f64>),
    /// Words by their index in the list.
    Words(Vec<u8>, Vec<&'static str>),
}

impl Values {
    /// An empty list of counts.
    pub(crate) const COUNTS: Values = Values::Counts(Vec::new());
    /// An empty list of numbers.
    pub(crate) const NUMBERS: Values = Values::Numbers(Vec::new());

    /// An empty list of these words.
    pub(crate) fn words<const N: usize>(words: [&'static str; N]) -> Values {
        Values::Words(Vec::new(), words.to_vec())
    }
}

impl Array {
    /// Adds the entry of `value`.
    fn push(&mut self, value: &Value) {
        match &mut self.values {
            Values::Counts(counts) => counts.push(match value {
                Value::Json(count) => count.as_u64().map_or(0, |count| count as u32),
                _ => 0,
            }),
            Values::Numbers(numbers) => numbers.push(value.measure().unwrap_or(f64::NAN)),
            Values::Words(places, words) => {
                let place = words.iter().position(|word| value.text() == Some(word));
                places.push(place.unwrap_or(words.len()) as u8);
            }
        }
    }

    /// Adds the entries of `more`, an array of the same column.
    pub fn append(&mut self, more: Array) {
        match (&mut self.values, more.values) {
            (Values::Counts(all), Values::Counts(more)) => all.extend(more),
            (Values::Numbers(all), Values::Numbers(more)) => all.extend(more),
            (Values::Words(all, _), Values::Words(more, _)) => all.extend(more),
            _ => {}
        }
    }
}

/// A column for people, with true minus signs.
#[derive(Debug, Clone)]
pub struct PeopleColumn {
    /// Its heading.
    pub heading: layout::Column,
    /// The format of its values.
    pub format: Format,
    /// One cell per row.
    pub cells: Vec<String>,
}

/// `value` for people, at centre distance `a`, mm.
fn display_text(value: &Value, format: Format, unit: BacklashUnit, a: f64) -> String {
    if let Some(number) = value.measure() {
        return match format {
            Format::Backlash | Format::BacklashAgain => backlash(unit, number, a, 3),
            Format::Bound => power(unit.of_um(number, a), 0),
            Format::Distance => stated_distance(number),
            Format::Fixed(decimals) => fixed(number, decimals),
            _ => number.to_string(),
        };
    }
    match value {
        Value::Absent => String::new(),
        Value::Band(ends) => {
            let [least, greatest] = ends.map(|(um, a)| backlash(unit, um, a, 1));
            format!("{least} … {greatest}")
        }
        Value::Json(Json::Null) => NONE.to_owned(),
        Value::Word(word) => plain(word),
        Value::Json(Json::String(text)) => plain(text),
        Value::Json(value) => value.to_string(),
    }
}

/// `j_wt`, given in mm, at centre distance `a`, mm, in ASCII; with `decimals` decimals if in µm.
pub(crate) fn backlash_cell(
    unit: BacklashUnit,
    j_wt: Option<f64>,
    a: f64,
    decimals: usize,
) -> String {
    backlash_ascii(unit, j_wt.map(|mm| mm * 1e3), a, decimals)
}

/// The heading of a column: its name with the unit; lost motion with its gear.
fn column_heading(unit: BacklashUnit, name: &str) -> String {
    match unit {
        BacklashUnit::Um => name.to_owned(),
        BacklashUnit::Arcmin { at, .. } if name == "j_wt" => format!("{} arcmin", at.name()),
        BacklashUnit::Arcmin { at, .. } => format!("{name}, {}", at.name()),
    }
}

/// The quantity at the head of a legend.
pub(crate) fn quantity_words(unit: BacklashUnit) -> String {
    match unit {
        BacklashUnit::Um => "Backlash j_wt in µm".to_owned(),
        BacklashUnit::Arcmin { at, .. } => format!("Lost motion at the {} in arcmin", at.name()),
    }
}

/// The keys and values of a row as a JSON object.
pub struct Object(Vec<(&'static str, Value)>);

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let (cells, start) = (&self.0[..], 0);
        Part { cells, start }.serialize(to)
    }
}

/// Neighbouring cells whose keys agree before the byte `start`.
struct Part<'a> {
    cells: &'a [(&'static str, Value)],
    start: usize,
}

impl<'a> Part<'a> {
    /// The names of the next level, each with its part.
    fn inner(&self) -> impl Iterator<Item = (&'static str, Part<'a>)> {
        let start = self.start;
        let name = move |(key, _): &(&'static str, Value)| {
            let rest = &key[start..];
            rest.split_once('.').map_or(rest, |(name, _)| name)
        };
        let parts = self
            .cells
            .chunk_by(move |one, other| name(one) == name(other));
        parts.map(move |cells| {
            let name = name(&cells[0]);
            let start = start + name.len() + 1;
            (name, Part { cells, start })
        })
    }
}

impl Serialize for Part<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self.cells {
            [(key, value)] if key.len() < self.start => value.serialize(to),
            // A list has two elements.
            [(key, _), ..] if key[self.start..].starts_with(['0', '1']) => {
                let element = |of: &str| self.inner().find(|(name, _)| *name == of);
                ["0", "1"]
                    .map(|of| element(of).map(|(_, part)| part))
                    .serialize(to)
            }
            _ => to.collect_map(self.inner()),
        }
    }
}
