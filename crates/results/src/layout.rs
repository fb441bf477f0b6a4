//! Common parts of all text for a terminal: tables and lines that fit it, verdicts in colour, and names of poses.
//!
//! Where the width is unknown, as in a pipe, tables are complete and lines are not broken.

use anstyle::{AnsiColor, Style};
use gearlash::analysis::compare::ComparedPose;
use gearlash_text::numbers::rounded;
use std::borrow::Cow;
use textwrap::Options;
use textwrap::core::display_width;

/// The output that text is shown on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Screen {
    /// Width in columns; `None`: unlimited.
    pub width: Option<usize>,
    /// Whether verdicts are in colour.
    pub colour: bool,
}

/// Severity of a verdict, which is its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// Green.
    Good,
    /// Yellow.
    Doubtful,
    /// Red.
    Bad,
}

impl Tone {
    /// The tone of a status or a verdict; `None` for a status that is no judgement of the pair.
    pub fn of(word: &str) -> Option<Tone> {
        match word {
            "interference" | "jammed" | "fail" => Some(Tone::Bad),
            "unproven" | "warn" => Some(Tone::Doubtful),
            "pass" => Some(Tone::Good),
            _ => None,
        }
    }
}

impl Screen {
    /// `word` in the colour of its `tone`, on a screen with colours.
    pub fn toned(&self, tone: Tone, word: &str) -> String {
        if !self.colour {
            return word.to_owned();
        }
        let colour = match tone {
            Tone::Good => AnsiColor::Green,
            Tone::Doubtful => AnsiColor::Yellow,
            Tone::Bad => AnsiColor::Red,
        };
        let style = Style::new().bold().fg_color(Some(colour.into()));
        format!("{style}{word}{style:#}")
    }

    /// Each line of `text` as a paragraph, broken at the screen's width or a readable one.
    pub fn paragraphs(&self, text: &str) -> String {
        let width = self.width.unwrap_or(PARAGRAPH_WIDTH).min(PARAGRAPH_WIDTH);
        textwrap::fill(text, width) + "\n"
    }

    /// `text` with each line that is too long broken between words, its continuation indented.
    pub fn fold(&self, text: &str) -> String {
        let Some(width) = self.width else {
            return text.to_owned();
        };
        let mut folded = String::with_capacity(text.len());
        for line in text.lines() {
            let blanks = line.len() - line.trim_start().len();
            let margin = match blanks {
                0 => String::new(),
                blanks => " ".repeat(blanks + 2),
            };
            let options = Options::new(width).subsequent_indent(&margin);
            folded += &textwrap::fill(line, options);
            folded.push('\n');
        }
        folded
    }
}

/// The treatment of a column where the table is too wide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fit {
    /// It stays.
    Kept,
    /// It is left out; the highest rank goes first.
    Spare(u8),
    /// Its cells are broken between words.
    Broken,
    /// Its cells move below their row.
    Below,
}

/// A column of a [`Table`].
#[derive(Debug, Clone)]
pub struct Column {
    heading: String,
    left: bool,
    fit: Fit,
}

impl Column {
    /// A column of numbers or short words, aligned on the right.
    pub fn new(heading: impl Into<String>) -> Column {
        Column {
            heading: heading.into(),
            left: false,
            fit: Fit::Kept,
        }
    }

    /// Its heading.
    pub fn heading(&self) -> &str {
        &self.heading
    }

    /// Whether its cells are words, aligned on the left.
    pub fn is_left(&self) -> bool {
        self.left
    }

    /// Whether its cells can move below their row.
    pub fn is_below(&self) -> bool {
        self.fit == Fit::Below
    }

    /// The column under another heading.
    pub(crate) fn renamed(&self, name: impl Fn(&str) -> String) -> Column {
        Column {
            heading: name(&self.heading),
            ..self.clone()
        }
    }

    /// Aligned on the left.
    pub fn left(self) -> Column {
        Column { left: true, ..self }
    }

    /// Left out where the table is too wide; the highest `rank` goes first.
    pub fn spare(self, rank: u8) -> Column {
        self.fit(Fit::Spare(rank))
    }

    /// Broken between words where the table is too wide.
    pub fn broken(self) -> Column {
        self.fit(Fit::Broken)
    }

    /// Moved below its row where the table is too wide.
    pub fn below(self) -> Column {
        self.fit(Fit::Below)
    }

    fn fit(self, fit: Fit) -> Column {
        Column { fit, ..self }
    }
}

/// Widest paragraph in columns (as in the help).
const PARAGRAPH_WIDTH: usize = 100;
/// Blanks between columns.
const GAP: usize = 2;
/// Columns that are broken between words stay at least this wide before another is left out (tuned: two words).
const BROKEN: usize = 24;
/// Indentation of a cell below its row.
const BELOW: usize = 12;

/// Aligned columns under headings, each with one cell per row.
#[derive(Debug, Clone)]
pub struct Table(pub Vec<(Column, Vec<String>)>);

impl Table {
    /// Its text on `screen`, without blanks at the ends of lines. Columns that were left out are listed below it.
    pub fn text(&self, screen: &Screen) -> String {
        let mut widths: Vec<usize> = (0..self.0.len()).map(|c| self.width(c)).collect();
        let mut shown: Vec<usize> = (0..widths.len()).collect();
        let mut left_out = Vec::new();
        let room = screen.width.unwrap_or(usize::MAX);
        // The last gap is not printed.
        let total = |shown: &[usize], widths: &[usize]| -> usize {
            shown.iter().map(|c| widths[*c] + GAP).sum::<usize>() - 1
        };
        let narrow = total(&shown, &widths) > room;
        if narrow {
            shown.retain(|c| self.fit(*c) != Fit::Below);
            let least: Vec<usize> = (0..widths.len())
                .map(|c| match self.fit(c) {
                    Fit::Broken => widths[c].min(BROKEN.max(self.longest_word(c))),
                    _ => widths[c],
                })
                .collect();
            while total(&shown, &least) > room
                && let Some(spare) = self.most_spare(&shown)
            {
                left_out.push(spare);
                shown.retain(|c| *c != spare);
            }
            while total(&shown, &widths) > room
                && let Some(widest) = self.widest_broken(&shown, &widths)
            {
                widths[widest] -= 1;
            }
        }
        let headings: Vec<&str> = self.0.iter().map(|(c, _)| &c.heading[..]).collect();
        let mut text = String::new();
        self.add_lines(&headings, &shown, &widths, &mut text);
        let rows = self.0.first().map_or(0, |(_, cells)| cells.len());
        for row in 0..rows {
            let row: Vec<&str> = self.0.iter().map(|(_, cells)| &cells[row][..]).collect();
            self.add_lines(&row, &shown, &widths, &mut text);
            if narrow {
                self.add_below(&row, room, &mut text);
            }
        }
        if !left_out.is_empty() {
            left_out.sort_unstable();
            let names: Vec<&str> = left_out.iter().map(|c| headings[*c]).collect();
            let names = names.join(", ");
            text += &screen.fold(&format!("Not shown: {names}; --wide shows all."));
        }
        text
    }

    /// Width of column `c` in full, in columns of the terminal.
    fn width(&self, c: usize) -> usize {
        self.cells(c).map(display_width).max().unwrap_or(0)
    }

    /// Width of the longest word in column `c`, which is never broken.
    fn longest_word(&self, c: usize) -> usize {
        let words = self.cells(c).flat_map(str::split_whitespace);
        words.map(display_width).max().unwrap_or(0)
    }

    /// The heading and the cells of column `c`.
    fn cells(&self, c: usize) -> impl Iterator<Item = &str> {
        let (column, cells) = &self.0[c];
        let heading = std::iter::once(&column.heading);
        heading.chain(cells).map(String::as_str)
    }

    fn fit(&self, c: usize) -> Fit {
        self.0[c].0.fit
    }

    /// The column of `shown` to be left out next.
    fn most_spare(&self, shown: &[usize]) -> Option<usize> {
        let rank = |c: &usize| match self.fit(*c) {
            Fit::Spare(rank) => Some((rank, *c)),
            _ => None,
        };
        shown.iter().filter_map(rank).max().map(|(_, c)| c)
    }

    /// The widest column of `shown` that can still be broken.
    fn widest_broken(&self, shown: &[usize], widths: &[usize]) -> Option<usize> {
        let can = |c: &&usize| self.fit(**c) == Fit::Broken && widths[**c] > self.longest_word(**c);
        let broken = shown.iter().filter(can).copied();
        broken.max_by_key(|c| widths[*c])
    }

    /// Adds the lines of a row.
    fn add_lines(&self, row: &[&str], shown: &[usize], widths: &[usize], text: &mut String) {
        let cells: Vec<Vec<Cow<str>>> = shown
            .iter()
            .map(|c| {
                if display_width(row[*c]) > widths[*c] {
                    textwrap::wrap(row[*c], widths[*c])
                } else {
                    vec![row[*c].into()]
                }
            })
            .collect();
        let lines = cells.iter().map(Vec::len).max().unwrap_or(0);
        for line in 0..lines {
            let mut whole = String::new();
            for (cell, c) in cells.iter().zip(shown) {
                let cell = cell.get(line).map_or("", |cell| cell.as_ref());
                let blanks = " ".repeat(widths[*c].saturating_sub(display_width(cell)));
                whole += &if self.0[*c].0.left {
                    format!(" {cell}{blanks} ")
                } else {
                    format!(" {blanks}{cell} ")
                };
            }
            text.push_str(whole.trim_end());
            text.push('\n');
        }
    }

    /// Adds the cells that moved below their row.
    fn add_below(&self, row: &[&str], room: usize, text: &mut String) {
        let margin = " ".repeat(BELOW);
        let options = Options::new(room)
            .initial_indent(&margin)
            .subsequent_indent(&margin);
        for ((column, _), cell) in self.0.iter().zip(row) {
            if column.fit == Fit::Below && !cell.is_empty() {
                *text += &textwrap::fill(cell, &options);
                text.push('\n');
            }
        }
    }
}

/// The name of a pose: mating, fraction to four decimals, flank.
pub fn pose_label(pose: &ComparedPose) -> String {
    let mating = pose.simulated.pose.mating();
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!("+{}", rounded(fraction, 4)),
    };
    format!(
        "{},{}{beyond} {}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let columns = [
            Column::new("a mm"),
            Column::new("mean").spare(1),
            Column::new("check").left().broken(),
            Column::new("poses").spare(2),
            Column::new("note").left().below(),
        ];
        let row = "37.3|12.000|radial clearance of the tip, above all|16|wheel tooth 3";
        let cells = row.split('|').map(|cell| vec![cell.to_owned()]);
        Table(columns.into_iter().zip(cells).collect())
    }

    fn shown(width: usize) -> String {
        table().text(&Screen {
            width: Some(width),
            colour: false,
        })
    }

    /// First notes move below, then columns are left out by rank, then words are broken.
    #[test]
    fn a_narrow_terminal_has_what_matters() {
        let at_50 = [
            " a mm    mean  check                         poses",
            " 37.3  12.000  radial clearance of the tip,     16",
            "               above all",
            "            wheel tooth 3",
        ];
        let at_34 = [
            " a mm  check",
            " 37.3  radial clearance of the",
            "       tip, above all",
            "            wheel tooth 3",
            "Not shown: mean, poses; --wide",
            "shows all.",
        ];
        assert!(shown(50).lines().eq(at_50), "{}", shown(50));
        assert!(shown(34).lines().eq(at_34), "{}", shown(34));
        for width in 34..90 {
            for line in shown(width).lines() {
                assert!(display_width(line) <= width, "{width}: {line}");
            }
        }
    }
}
