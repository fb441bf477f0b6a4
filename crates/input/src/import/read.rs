//! The tables of a file: each kind is searched for, and read as for a pair file that names it.

use super::table::{ImportedTable, Kind};
use crate::check::check;
use crate::spec::TABLE;
use gearlash::gear::Side;
use gearlash::metrology::PitchKind;
use gearlash_tables::DataFile;
use gearlash_tables::{
    Choice, Column, Content, Coverage, MAX_CELLS, Origin, Quantity, Request, Sheet, Wanted,
};
use gearlash_text::{Problem, Problems, Table};

/// The tables of the file that `table` names, all or of one kind. Ambiguous tables are added to `not_read`.
pub(super) fn tables(
    table: &Table,
    bytes: Vec<u8>,
    only: Option<Kind>,
    not_read: &mut Vec<Problem>,
) -> Option<Vec<ImportedTable>> {
    let reading = table.reading();
    check(&TABLE, table);
    table.is_good("").then_some(())?;
    let (file, choice) = (DataFile::of(table)?, Choice::of(table));
    let content = Content::read(&file, (bytes, MAX_CELLS), table, &choice)?;
    let from = TableSource {
        file: &file,
        content: &content,
        choice: &choice,
    };
    let mut tables = Vec::new();
    let is_asked = |kind| only.is_none_or(|only| only == kind);
    if is_asked(Kind::Pitch) {
        from.pitch(only.is_some(), &mut tables, not_read);
    }
    let singles = [
        (
            Kind::Runout,
            Quantity::Runout,
            "runout_um",
            "Runout F_r, µm",
        ),
        (
            Kind::Thickness,
            Quantity::Thickness,
            "thickness_um",
            "Thickness beyond the mean, µm",
        ),
        (Kind::Span, Quantity::Span, "span_mm", "Span W_k, mm"),
        (
            Kind::OverPins,
            Quantity::OverPins,
            "over_pins_mm",
            "Dimension over pins M_dK, mm",
        ),
    ];
    for (kind, quantity, name, title) in singles {
        // A key that names the column does not tell its quantity.
        let named = choice.column("column").is_none() || only.is_some();
        let coverage = match kind {
            Kind::Runout | Kind::Thickness => Coverage::EveryTooth,
            _ => Coverage::SomeTeeth,
        };
        let columns = [Column::of(quantity)];
        let request = from.request(&columns, coverage);
        if is_asked(kind) && named && (only.is_some() || content.has(&request)) {
            let (sheet, faults) = reading.capture_problems(|| from.sheet(&request));
            // A table that was not requested by name hides no other.
            let is_wrong = content.has_each(&request) || only.is_some();
            from.report(faults, is_wrong, not_read);
            let table = |sheet| ImportedTable::of(kind, title.to_owned(), &[name], &sheet);
            tables.extend(sheet.map(table));
        }
    }
    for (kind, place) in [
        (Kind::Trace, Quantity::RollLength),
        (Kind::Lead, Quantity::Height),
    ] {
        let columns = [place, Quantity::Deviation].map(Column::of);
        let request = from.request(&columns, Coverage::Points { base_radius: None });
        if is_asked(kind) && (only.is_some() || content.has(&request)) {
            let traces = Sheet::of(&content, &request);
            tables.extend(traces.map(|traces| ImportedTable::of_traces(kind, &traces)));
        }
    }
    if tables.is_empty() && reading.is_good() && content.is_p40() {
        content.check_p40(&file)?;
        return file.refuse(
            "has no pitch (linke, rechte Zahnflanke), no profile trace (Profil:) and no lead trace (Flankenlinie:) with its face width (Zahnbreite)",
            "name a file that has one of them",
        );
    }
    if tables.is_empty() && reading.is_good() && not_read.is_empty() {
        const VALUES: &str = "pitch, runout, thickness, span or dimension over pins";
        let columns = [Quantity::Runout, Quantity::Span].map(Column::of);
        let request = from.request(&columns, Coverage::SomeTeeth);
        let reason = content.heading_without(&request, VALUES);
        let reason = reason.unwrap_or_else(|| {
            format!("no line names a column of teeth and one of {VALUES}, nor of a profile or lead")
        });
        file.add(reason, super::NAME_COLUMNS);
    }
    let all = tables.clone();
    for table in &mut tables {
        table.exclude_columns_of(&all);
    }
    Some(tables)
}

struct TableSource<'a> {
    file: &'a DataFile,
    content: &'a Content,
    choice: &'a Choice,
}

impl TableSource<'_> {
    fn request<'r>(&'r self, columns: &'r [Column], coverage: Coverage) -> Request<'r> {
        Request {
            file: self.file,
            choice: self.choice,
            wanted: Wanted {
                columns,
                teeth: None,
                coverage,
            },
        }
    }

    /// Cumulative and single pitch; `not_read` receives columns whose kind is not stated.
    fn pitch(&self, requested: bool, tables: &mut Vec<ImportedTable>, not_read: &mut Vec<Problem>) {
        let chosen = ["left", "right"].map(|key| self.choice.column(key));
        let chosen = chosen.iter().any(Option::is_some);
        let mut first: Option<Option<Origin>> = None;
        let mut faults = Vec::new();
        for kind in [PitchKind::Cumulative, PitchKind::Single] {
            let columns = Side::BOTH.map(|side| Column::pitch(side, kind));
            let others = columns.map(Column::of_other_kind);
            let request = self.request(&columns, Coverage::EveryTooth);
            let other = self.request(&others, Coverage::EveryTooth);
            let is_default =
                requested && kind == PitchKind::Cumulative && !self.content.has(&other);
            if !self.content.has(&request) {
                let by_spaces = self.content.pitch_by_spaces(&request);
                if by_spaces.is_some() || !is_default {
                    // Columns that options name can be of either kind: they are tried as cumulative, once.
                    not_read.extend(by_spaces.filter(|one| !not_read.contains(one)));
                    continue;
                }
            }
            let (sheet, bad) = self
                .file
                .reading()
                .capture_problems(|| self.sheet(&request));
            let Some(sheet) = sheet.filter(|_| bad.is_empty()) else {
                faults.push((bad, self.content.has_each(&request)));
                continue;
            };
            // Columns of neither kind may be of both.
            if first
                .as_ref()
                .is_some_and(|first| first.is_some() && *first == sheet.origin)
            {
                continue;
            }
            let stated_kind = match &sheet.origin {
                Some(origin) => origin.kind,
                None => Some(kind),
            };
            let (pitch_kind, title) = match stated_kind {
                Some(PitchKind::Single) => (Some("single"), "Single pitch deviation fp, µm"),
                Some(PitchKind::Cumulative) => {
                    (Some("cumulative"), "Cumulative pitch deviation Fp, µm")
                }
                None => (None, "Pitch deviation, fp or Fp, µm"),
            };
            let table = ImportedTable::of(
                Kind::Pitch,
                title.to_owned(),
                &["right_um", "left_um"],
                &sheet,
            );
            tables.push(ImportedTable {
                pitch_kind,
                ..table
            });
            first = Some(sheet.origin);
        }
        // Named columns are of one kind. Faults of the other kind do not count.
        if chosen {
            faults.truncate(usize::from(first.is_none()));
        }
        for (bad, has_each) in faults {
            // A kind without one column for each flank does not hide the other kind.
            self.report(bad, has_each || first.is_none(), not_read);
        }
    }

    /// Reports `faults`, or adds them to the tables that are not read.
    fn report(&self, faults: Problems, is_wrong: bool, not_read: &mut Vec<Problem>) {
        if is_wrong {
            self.file.reading().add_list(self.file.key(), faults);
        } else {
            not_read.extend(faults.into_list());
        }
    }

    /// A table with as many teeth as the file states, or as it has; a missing tooth is reported.
    fn sheet(&self, request: &Request) -> Option<Sheet> {
        let sheet = Sheet::of(self.content, request)?;
        if request.wanted.coverage != Coverage::EveryTooth {
            return Some(sheet);
        }
        let last = sheet.teeth().last().copied();
        let teeth = sheet.header.teeth().or(last);
        Sheet::of(self.content, &request.with_teeth(teeth))
    }
}
