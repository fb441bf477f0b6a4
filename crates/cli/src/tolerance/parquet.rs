//! Each assembly of a run as a row of Parquet: in groups of rows, so that no more than one of them is in memory.

use gearlash::population::Outcome;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use std::io::{Error, Write};
use std::sync::Arc;

/// Rows of a group (tuned: a few MB of memory; a footer of some 100 groups for 10 million rows).
const GROUP: usize = 1 << 17;

/// The columns, as those of the CSV.
const SCHEMA: &str = "message assemblies {
    required int64 assembly;
    required binary outcome (STRING);
    optional double least_um;
    optional double greatest_um;
    required boolean proven;
}";

/// A file that rows are added to.
pub(super) struct ParquetRows<W: Write + Send> {
    file: SerializedFileWriter<W>,
    rows: Group,
}

/// The rows that are not written yet, column by column.
#[derive(Default)]
struct Group {
    numbers: Vec<i64>,
    words: Vec<&'static str>,
    lengths: [Vec<Option<f64>>; 2],
    proven: Vec<bool>,
}

fn failed(error: ParquetError) -> Error {
    match error {
        ParquetError::External(source) => match source.downcast::<Error>() {
            Ok(source) => *source,
            Err(source) => Error::other(source),
        },
        other => Error::other(other),
    }
}

impl<W: Write + Send> ParquetRows<W> {
    /// Begins a file.
    pub fn new(file: W) -> std::io::Result<ParquetRows<W>> {
        let schema = parse_message_type(SCHEMA).map_err(failed)?;
        // Of every page a record would stand in memory to the end.
        let properties = WriterProperties::builder()
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .build();
        let file = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties));
        Ok(ParquetRows {
            file: file.map_err(failed)?,
            rows: Group::default(),
        })
    }

    /// Adds assembly `number`, which ends as `word` says; lengths in µm.
    pub fn add(
        &mut self,
        number: u64,
        word: &'static str,
        lengths: [Option<f64>; 2],
        outcome: &Outcome,
    ) -> std::io::Result<()> {
        let rows = &mut self.rows;
        rows.numbers
            .push(i64::try_from(number).map_err(Error::other)?);
        rows.words.push(word);
        for (column, length) in rows.lengths.iter_mut().zip(lengths) {
            column.push(length);
        }
        rows.proven.push(outcome.is_proven);
        match rows.numbers.len() < GROUP {
            true => Ok(()),
            false => self.write_group(),
        }
    }

    fn write_group(&mut self) -> std::io::Result<()> {
        let rows = std::mem::take(&mut self.rows);
        rows.written(&mut self.file).map_err(failed)
    }

    /// Writes what is left and the footer.
    pub fn finish(mut self) -> std::io::Result<W> {
        if !self.rows.numbers.is_empty() {
            self.write_group()?;
        }
        self.file.into_inner().map_err(failed)
    }
}

impl Group {
    fn written<W: Write + Send>(
        self,
        file: &mut SerializedFileWriter<W>,
    ) -> Result<(), ParquetError> {
        let mut group = file.next_row_group()?;
        let mut lengths = self.lengths.iter();
        while let Some(mut column) = group.next_column()? {
            match column.untyped() {
                ColumnWriter::Int64ColumnWriter(column) => {
                    column.write_batch(&self.numbers, None, None)?;
                }
                ColumnWriter::ByteArrayColumnWriter(column) => {
                    let words: Vec<ByteArray> =
                        self.words.iter().copied().map(ByteArray::from).collect();
                    column.write_batch(&words, None, None)?;
                }
                ColumnWriter::DoubleColumnWriter(column) => {
                    let each = lengths.next().map_or(&[][..], Vec::as_slice);
                    let there: Vec<f64> = each.iter().copied().flatten().collect();
                    let levels: Vec<i16> =
                        each.iter().map(|one| i16::from(one.is_some())).collect();
                    column.write_batch(&there, Some(&levels), None)?;
                }
                ColumnWriter::BoolColumnWriter(column) => {
                    column.write_batch(&self.proven, None, None)?;
                }
                // The schema has no others.
                _ => {
                    return Err(ParquetError::General(
                        "a column of no known type".to_owned(),
                    ));
                }
            }
            column.close()?;
        }
        group.close()?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gearlash::population::OutcomeKind;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    /// Two groups and a half, with lengths that are there and such that are not, read back by the crate's own reader.
    #[test]
    fn several_groups_are_read_back() {
        let length = |number: u64| (!number.is_multiple_of(3)).then_some(number as f64 / 1e4);
        let mut rows = ParquetRows::new(Vec::new()).unwrap();
        let count = 5 * GROUP as u64 / 2;
        for number in 1..=count {
            let outcome = Outcome {
                kind: OutcomeKind::Clear,
                least: None,
                greatest: None,
                is_proven: number % 2 == 0,
            };
            let word = ["clear", "jammed"][number as usize % 2];
            let both = [length(number), length(number + 1)];
            rows.add(number, word, both, &outcome).unwrap();
            assert!(rows.rows.numbers.len() < GROUP);
        }
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(&rows.finish().unwrap()).unwrap();
        let read = SerializedFileReader::new(file).unwrap();
        assert_eq!(read.num_row_groups(), 3);
        let mut number = 0;
        for row in read.get_row_iter(None).unwrap() {
            let row = row.unwrap();
            number += 1;
            assert_eq!(row.get_long(0).unwrap() as u64, number);
            let word = ["clear", "jammed"][number as usize % 2];
            assert_eq!(row.get_string(1).unwrap(), word);
            assert_eq!(row.get_double(2).ok(), length(number));
            assert_eq!(row.get_double(3).ok(), length(number + 1));
            assert_eq!(row.get_bool(4).unwrap(), number % 2 == 0);
        }
        assert_eq!(number, count);
    }
}
