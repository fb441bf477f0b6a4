//! Spans, dimensions over pins and thickness: each reading less the mean.

use super::bars::{LEVEL, bars, means};
use crate::chart::{BarPanel, BarSeries, Look};
use crate::error::PictureError;
use crate::gauge::lengths::{ByTooth, Length, lengths};
use gearlash_files::results::gauge::GaugedGear;

pub(super) fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let drawn = lengths(&gauged.gauged).into_iter().filter_map(|length| {
        let by_tooth = length.by_tooth.as_ref()?;
        Some(draw(gauged, &length, by_tooth))
    });
    drawn.collect()
}

fn draw(
    gauged: &GaugedGear,
    length: &Length,
    by_tooth: &ByTooth,
) -> Result<(String, String), PictureError> {
    let table = by_tooth.reading.table(&gauged.gauged);
    let column = table
        .as_ref()
        .and_then(|table| table.column(by_tooth.column));
    let lengths = column.map_or(Vec::new(), |column| column.numbers());
    let less = lengths.iter().map(|mm| Some((mm - length.mean) * 1e3));
    let series = [BarSeries {
        name: "reading",
        values: less.collect(),
        look: Look::Plain,
    }];
    let panel = BarPanel {
        title: &format!("{}, {}", length.name, means(length.mean, length.formula)),
        y_axis: &format!("{} − mean, µm", by_tooth.symbol),
        series: &series,
        limits: Vec::new(),
        level: LEVEL,
    };
    bars(gauged, by_tooth.reading, by_tooth.tooth, &[panel])
}
