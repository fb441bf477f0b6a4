//! Rows of a run: files with one assembly per line, and sums over rows of any origin.
//!
//! A file begins with a header (version, hash of the input, seed, first assembly, count) and the column names. Lengths have four decimals of a
//! micrometre, the whole tenths of a nanometre that statistics count in, so that they read back exactly.

use super::run::ToleranceRun;
use gearlash::population::{OutcomeKind, Overflow, Row, Tally};
use gearlash_text::characters::first_of;
use gearlash_text::{InputError, Problem};
use std::fmt::Display;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind};
use std::ops::Range;
use std::path::Path;

/// Tenths of a nanometre in a micrometre.
const TENTHS_PER_UM: f64 = 1e4;

/// The greatest length that text gives back exactly, tenths of a nanometre: 2^53.
const MAX_TENTHS: f64 = 9_007_199_254_740_992.0;

const FORMAT: &str = "# gearlash rows 1: ";

const COLUMNS: &str = "assembly,outcome,least_um,greatest_um,proven,below,above,margin_um";

/// The longest line that is read, bytes; a header is shorter.
const LONGEST_LINE: u64 = 1000;

/// Problems of one kind that are listed.
const MAX_LISTED: usize = 12;

/// The run of some rows, and their assemblies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowsHead {
    /// Version of gearlash.
    pub version: String,
    /// SHA-256 of the pair as understood, and of all gears that are drawn.
    pub input_sha256: String,
    /// Seed.
    pub seed: u64,
    /// Number of the first assembly.
    pub first: u64,
    /// Number of assemblies that the rows were to have.
    pub count: u64,
}

impl RowsHead {
    /// The header of the rows of `count` assemblies of `run` from `first` on.
    pub fn of(run: &ToleranceRun, first: u64, count: u64) -> RowsHead {
        let (input_sha256, seed) = run.identity();
        RowsHead {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            input_sha256: input_sha256.to_owned(),
            seed,
            first,
            count,
        }
    }

    /// The first lines of a file of rows.
    pub fn lines(&self) -> String {
        let (version, input, seed) = (&self.version, &self.input_sha256, self.seed);
        let (first, count) = (self.first, self.count);
        format!(
            "{FORMAT}version {version}, input_sha256 {input}, seed {seed}, first {first}, count {count}\n{COLUMNS}\n"
        )
    }

    fn parse(line: &str) -> Option<RowsHead> {
        let mut fields = line.strip_prefix(FORMAT)?.split(", ");
        let mut value = |name: &str| fields.next()?.strip_prefix(name)?.strip_prefix(' ');
        Some(RowsHead {
            version: value("version")?.to_owned(),
            input_sha256: value("input_sha256")?.to_owned(),
            seed: value("seed")?.parse().ok()?,
            first: value("first")?.parse().ok()?,
            count: value("count")?.parse().ok()?,
        })
    }
}

/// `tenths` of a nanometre in micrometres.
pub fn tenths_to_um(tenths: i64) -> f64 {
    tenths as f64 / TENTHS_PER_UM
}

/// The line of `row` in a file.
pub fn row_line(row: &Row) -> String {
    let um =
        |tenths: Option<i64>| tenths.map_or(String::new(), |one| tenths_to_um(one).to_string());
    format!(
        "{},{},{},{},{},{},{},{}\n",
        row.number,
        row.kind.name(),
        um(row.least),
        um(row.greatest),
        row.is_proven,
        row.is_below,
        row.is_above,
        um(row.margin)
    )
}

fn parse_row(line: &str) -> Option<Row> {
    let mut fields = line.split(',');
    let mut field = || fields.next();
    let um = |text: &str| -> Option<Option<i64>> {
        if text.is_empty() {
            return Some(None);
        }
        let tenths = (text.parse::<f64>().ok()? * TENTHS_PER_UM).round();
        (tenths.abs() <= MAX_TENTHS).then_some(Some(tenths as i64))
    };
    let kind = |name: &str| {
        OutcomeKind::ALL
            .into_iter()
            .find(|kind| kind.name() == name)
    };
    let row = Row {
        number: field()?.parse().ok().filter(|number| *number > 0)?,
        kind: kind(field()?)?,
        least: um(field()?)?,
        greatest: um(field()?)?,
        is_proven: field()?.parse().ok()?,
        is_below: field()?.parse().ok()?,
        is_above: field()?.parse().ok()?,
        margin: um(field()?)?,
    };
    field().is_none().then_some(row)
}

/// The rows of a file, line by line. A last line that is cut off, as after a kill, is ignored.
pub struct RowsReader<'a, R> {
    name: &'a str,
    text: R,
    /// Number of the last line that was read.
    number: u64,
    line: Vec<u8>,
}

impl<'a, R: BufRead> RowsReader<'a, R> {
    /// The header of the file called `name`, and its rows.
    ///
    /// # Errors
    /// [`InputError`]: the text is no file of rows.
    pub fn begin(name: &'a str, text: R) -> Result<(RowsHead, RowsReader<'a, R>), InputError> {
        let mut rows = RowsReader {
            name,
            text,
            number: 0,
            line: Vec::new(),
        };
        let head = rows.line()?.and_then(RowsHead::parse);
        let is_columns = rows.line()? == Some(COLUMNS);
        match head.filter(|_| is_columns) {
            Some(head) => Ok((head, rows)),
            None => Err(wrong(
                name,
                "is no file of rows: its first lines are no header",
                HELP,
            )),
        }
    }

    /// The next line without its end; `None` after the last one.
    fn line(&mut self) -> Result<Option<&str>, InputError> {
        self.line.clear();
        let mut text = std::io::Read::take(&mut self.text, LONGEST_LINE);
        let read = text.read_until(b'\n', &mut self.line);
        read.map_err(|error| unreadable(self.name, &error))?;
        self.number += 1;
        let is_long = self.line.len() as u64 == LONGEST_LINE;
        let is_whole = self.line.last() == Some(&b'\n') || is_long;
        let text = std::str::from_utf8(&self.line).unwrap_or("").trim_end();
        Ok(is_whole.then_some(text))
    }
}

impl<R: BufRead> Iterator for RowsReader<'_, R> {
    type Item = Result<Row, InputError>;

    fn next(&mut self) -> Option<Result<Row, InputError>> {
        let name = self.name;
        let row = match self.line() {
            Ok(None) => return None,
            Err(error) => return Some(Err(error)),
            Ok(Some(line)) => {
                parse_row(line).ok_or_else(|| line.chars().take(80).collect::<String>())
            }
        };
        let number = self.number;
        let wrong = |line| {
            let reason = format!("line {number} is no row: {line:?}");
            wrong(name, reason, "compute its rows again")
        };
        Some(row.map_err(wrong))
    }
}

/// Sums over the rows of a run from any number of sources, with the assemblies they cover.
pub struct RowsTally<'a> {
    run: &'a ToleranceRun<'a>,
    tally: Tally,
    sources: Vec<String>,
    /// Assemblies without a gap, each range with the index of its source.
    ranges: Vec<(Range<u64>, usize)>,
}

impl<'a> RowsTally<'a> {
    /// No rows of `run` yet.
    pub fn new(run: &'a ToleranceRun<'a>) -> RowsTally<'a> {
        RowsTally {
            run,
            tally: Tally::default(),
            sources: Vec::new(),
            ranges: Vec::new(),
        }
    }

    /// The sums over a range of the run.
    pub fn into_tally(self) -> Tally {
        self.tally
    }

    /// The sums so far.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Adds `row` of the current source.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, row: &Row) -> Result<(), Overflow> {
        self.tally.add(row, self.run.assemblies())?;
        let source = self.sources.len().saturating_sub(1);
        match self.ranges.last_mut() {
            Some((range, of)) if range.end == row.number && *of == source => range.end += 1,
            _ => self.ranges.push((row.number..row.number + 1, source)),
        }
        Ok(())
    }

    /// Adds the rows of the file at `path`.
    ///
    /// # Errors
    /// As [`RowsTally::add_text`]; also a file that cannot be read.
    pub fn add_file(&mut self, path: &Path) -> Result<(), InputError> {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|error| unreadable(&name, &error))?;
        self.add_text(&name, BufReader::with_capacity(1 << 16, file))
    }

    /// Adds the rows of the `text` of a file called `name`.
    ///
    /// # Errors
    /// [`InputError`]: rows of another run, or an invalid line.
    pub fn add_text(&mut self, name: &str, text: impl BufRead) -> Result<(), InputError> {
        let (head, rows) = RowsReader::begin(name, text)?;
        let wanted = RowsHead::of(self.run, head.first, head.count);
        for (what, own, wanted) in [
            ("version of gearlash", head.version, wanted.version),
            ("input_sha256", head.input_sha256, wanted.input_sha256),
            ("seed", head.seed.to_string(), wanted.seed.to_string()),
        ] {
            if own != wanted {
                let reason = format!("rows of another run: {what} {own}, not {wanted}");
                let help = "name rows of this pair file, seed and version";
                return Err(wrong(name, reason, help));
            }
        }
        self.sources.push(name.to_owned());
        for row in rows {
            let added = self.add(&row?);
            added.map_err(|error| wrong(name, error.to_string(), HELP))?;
        }
        Ok(())
    }

    /// The sums over all assemblies of the run.
    ///
    /// # Errors
    /// [`InputError`] of the pair file, which lists assemblies that are missing, duplicate or beyond the run.
    pub fn finish(mut self) -> Result<Tally, InputError> {
        let total = self.run.assemblies();
        self.ranges.sort_by_key(|(range, _)| range.start);
        let (mut missing, mut duplicate, mut beyond) = (Vec::new(), Vec::new(), Vec::new());
        let (mut next, mut before) = (1, 0);
        for (range, source) in &self.ranges {
            let name = &self.sources[*source];
            if range.start > next {
                missing.push(next..range.start.min(total + 1));
            }
            if range.start < next {
                let other = &self.sources[before];
                let doubled = range_words(&(range.start..range.end.min(next)));
                duplicate.push(format!("{doubled} in {name} and {other}"));
            }
            if range.end > total + 1 {
                let rest = range.start.max(total + 1)..range.end;
                beyond.push(format!("{} in {name}", range_words(&rest)));
            }
            if range.end > next {
                (next, before) = (range.end, *source);
            }
        }
        if next <= total {
            missing.push(next..total + 1);
        }
        missing.retain(|range| !range.is_empty());
        let command = missing.first().map_or(String::new(), |first| {
            let file = format!("rows_{}.csv", first.start);
            self.run.rows_command(first.clone(), Path::new(&file))
        });
        let found = [
            (
                missing.iter().map(range_words).collect(),
                format!("rows are missing, of {total} assemblies"),
                format!("compute them, the first by {command}"),
            ),
            (
                duplicate,
                "rows are there twice".to_owned(),
                "name rows of each assembly once".to_owned(),
            ),
            (
                beyond,
                format!("rows lie beyond the {total} assemblies of the run"),
                "state more with --assemblies, or leave them out".to_owned(),
            ),
        ];
        let found = found.into_iter().filter(|(list, ..)| !list.is_empty());
        let problems = found.map(|(list, what, help)| {
            Problem::of_file(format!("{what}: {}", first_of(list, MAX_LISTED)), help)
        });
        let problems: Vec<Problem> = problems.collect();
        if problems.is_empty() {
            Ok(self.tally)
        } else {
            Err(InputError::of(self.run.path(), problems))
        }
    }
}

/// The remedy for a file without rows.
const HELP: &str = "name files that gearlash tolerance --rows wrote";

fn unreadable(source: &str, error: &std::io::Error) -> InputError {
    let reason = match error.kind() {
        ErrorKind::NotFound => "file not found".to_owned(),
        _ => format!("cannot be read: {error}"),
    };
    wrong(source, reason, HELP)
}

fn wrong(source: &str, reason: impl Display, help: &str) -> InputError {
    InputError::of(Path::new(source), vec![Problem::of_file(reason, help)])
}

/// "assembly 7", "assemblies 7 to 9".
fn range_words(range: &Range<u64>) -> String {
    let last = range.end - 1;
    if range.start == last {
        format!("assembly {last}")
    } else {
        format!("assemblies {} to {last}", range.start)
    }
}
