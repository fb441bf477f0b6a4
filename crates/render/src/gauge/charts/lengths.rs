//! Spans, dimensions over pins and thickness: each reading less the mean.

use super::super::GaugedGear;
use super::super::by_tooth::micrometres;
use super::super::file_names::FileName;
use super::{LEVEL, by_tooth, means};
use crate::chart::{BarPanel, BarSeries, Look};
use crate::error::PictureError;
use gearlash::gauge::OverPins;

/// One chart: file, what is read, x and y axis, readings and their mean, mm.
struct Chart<'a> {
    name: FileName,
    title: String,
    x_axis: &'a str,
    y_axis: String,
    lengths: Vec<f64>,
    mean: f64,
}

pub(super) fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let mut charts = Vec::new();
    if let Ok(spans) = &read.spans {
        let k = spans.teeth;
        charts.push(Chart {
            name: FileName::Spans,
            title: format!("span W_{k}, {}", means(spans.mean(), formula.span)),
            x_axis: "first tooth spanned",
            y_axis: format!("W_{k} − mean, µm"),
            lengths: spans.readings.iter().map(|span| span.length).collect(),
            mean: spans.mean(),
        });
    }
    if let Ok(pins) = &read.pins {
        for (name, count, list, formula, x_axis) in [
            (
                FileName::Pins,
                "two",
                &pins.two,
                formula.over_two,
                "tooth before the first pin",
            ),
            (
                FileName::ThreePins,
                "three",
                &pins.three,
                formula.over_three,
                "tooth before the single pin",
            ),
        ] {
            if list.is_empty() {
                continue;
            }
            let mean = OverPins::mean(list);
            charts.push(Chart {
                name,
                title: format!(
                    "M_dK over {count} pins {} mm, {}",
                    pins.diameter,
                    means(mean, formula)
                ),
                x_axis,
                y_axis: "M_dK − mean, µm".to_owned(),
                lengths: list.iter().map(|over| over.length).collect(),
                mean,
            });
        }
    }
    if let Ok(thickness) = &read.thickness {
        charts.push(Chart {
            name: FileName::Thickness,
            title: format!(
                "arc thickness s at the reference circle, {}",
                means(thickness.mean(), Some(formula.thickness))
            ),
            x_axis: "tooth",
            y_axis: "s − mean, µm".to_owned(),
            lengths: thickness.arcs.clone(),
            mean: thickness.mean(),
        });
    }
    let drawn = charts.iter().map(|chart| draw(gauged, chart));
    drawn.collect()
}

fn draw(gauged: &GaugedGear, chart: &Chart) -> Result<(String, String), PictureError> {
    let less: Vec<f64> = chart.lengths.iter().map(|mm| mm - chart.mean).collect();
    let series = [BarSeries {
        name: "reading",
        values: micrometres(&less).into_iter().map(Some).collect(),
        look: Look::Plain,
    }];
    let panel = BarPanel {
        title: &chart.title,
        y_axis: &chart.y_axis,
        series: &series,
        limits: Vec::new(),
        level: LEVEL,
    };
    by_tooth(gauged, chart.name, chart.x_axis, &[panel])
}
