//! Lengths with their least, mean and greatest reading: the rows of the text, and the charts of each less its mean.

use super::{Chart, GaugedGear};
use crate::column::{Row, Value, row_type, shown};
use crate::layout::Screen;
use gearlash::gauge::{Pins, Summary};
use gearlash_text::numbers::{ascii, order_um, um_ascii};

/// One length, mm.
pub struct Length {
    /// The name of the gauge.
    pub name: String,
    /// Its readings.
    pub readings: Summary,
    /// The value by formula at the mean thickness.
    pub formula: Option<f64>,
    /// The length at each tooth, where it varies.
    pub by_tooth: Option<ByTooth>,
    has_formula: bool,
}

/// A length at each tooth.
pub struct ByTooth {
    /// The chart of the lengths.
    pub chart: Chart,
    /// The lengths, mm, from tooth 1 on.
    pub values: Vec<f64>,
    /// Its symbol.
    pub symbol: String,
    /// The position of the tooth in a reading.
    pub tooth: &'static str,
}

impl Length {
    /// The tooth of an end, where the readings differ by more than their error bound.
    fn tooth(&self, end: usize) -> Value {
        let Summary { ends, error, .. } = self.readings;
        let values = self.by_tooth.iter().filter(|_| ends[1] - ends[0] > error);
        let place = values.flat_map(|of| of.values.iter().position(|mm| *mm == ends[end]));
        Value::optional(place.map(|place| place + 1).next())
    }

    /// `cell`, which is absent in tables of gears without formulas.
    fn by_formula(&self, cell: impl FnOnce(Option<f64>) -> String) -> Value {
        Value::optional(self.has_formula.then(|| cell(self.formula)))
    }
}

row_type!(row: Length {
    "" Plain [heading(shown(""))] => row.name.clone();
    "" Plain [heading(shown("least"))] => ascii(row.readings.ends[0], 6);
    "" Plain [heading(shown("at").spare(4))] => row.tooth(0);
    "" Plain [heading(shown("mean"))] => ascii(row.readings.mean, 6);
    "" Plain [heading(shown("greatest"))] => ascii(row.readings.ends[1], 6);
    "" Plain [heading(shown("at").spare(4))] => row.tooth(1);
    "" Plain [heading(shown("range"))] => um_ascii(row.readings.ends[1] - row.readings.ends[0], 3);
    "" Plain [heading(shown("formula").spare(1))] => row.by_formula(|formula| ascii(formula, 6));
    "" Plain [heading(shown("off").spare(2))] => row.by_formula(|formula| um_ascii(formula.map(|formula| row.readings.mean - formula), 3));
    "" Plain [heading(shown("bound").spare(3))] => order_um(row.readings.error);
});

/// The lengths of `gauged` as a table for a terminal; empty without any.
pub fn length_table(gauged: &GaugedGear, screen: &Screen) -> String {
    match &lengths(gauged)[..] {
        [] => String::new(),
        rows => Length::columns().text(rows, screen),
    }
}

/// Every measured length.
pub fn lengths(gauged: &GaugedGear) -> Vec<Length> {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let (is_helical, has_formula) = (gauged.is_helical(), gauged.data.is_some());
    let mut rows = Vec::new();
    let mut add = |name: String, readings, formula, by_tooth| {
        rows.push(Length {
            name,
            readings,
            formula,
            by_tooth,
            has_formula,
        });
    };
    let by_tooth = |chart, values, symbol: &str, tooth| {
        Some(ByTooth {
            chart,
            values,
            symbol: symbol.to_owned(),
            tooth,
        })
    };
    if let Ok(spans) = &read.spans {
        let symbol = format!("W_{}", spans.teeth);
        let name = format!("span {symbol}{}", if is_helical { ", normal" } else { "" });
        let values = spans.readings.iter().map(|one| one.length).collect();
        let each = by_tooth(Chart::SPANS, values, &symbol, "first tooth spanned");
        add(name, spans.summary(), formula.span, each);
    }
    if let Ok(pins) = &read.pins {
        let gauges = if is_helical { "balls" } else { "pins" };
        let [two, three] = ["two", "three"].map(|count| format!("{count} {gauges}"));
        let lying = "two lying pins".to_owned();
        #[rustfmt::skip]
        let each = [
            (&pins.two, formula.over_two, Chart::PINS, two, "M_dK", "tooth before the first pin"),
            (&pins.three, formula.over_three, Chart::THREE_PINS, three, "M_dK", "tooth before the single pin"),
            (&pins.lying, formula.over_lying, Chart::LYING_PINS, lying, "M_dR", "tooth before the first pin"),
        ];
        for (list, formula, chart, what, symbol, tooth) in each {
            if list.is_empty() {
                continue;
            }
            let name = format!("{symbol}, {what} {} mm", pins.diameter);
            let values = list.iter().map(|one| one.length).collect();
            let each = by_tooth(chart, values, symbol, tooth);
            add(name, Pins::summary(list), formula, each);
        }
    }
    if let Ok(thickness) = &read.thickness {
        let (symbol, section) = if is_helical {
            ("s_t", ", transverse")
        } else {
            ("s", "")
        };
        let name = format!("thickness {symbol}{section}");
        let arcs = thickness.summary();
        let each = by_tooth(Chart::THICKNESS, thickness.arcs.clone(), symbol, "tooth");
        add(name, arcs, formula.thickness, each);
        if is_helical {
            let name = "thickness s_n, normal".to_owned();
            let normal = |arc: f64| arc * thickness.normal;
            let readings = Summary {
                ends: arcs.ends.map(normal),
                mean: normal(arcs.mean),
                error: arcs.error,
            };
            add(name, readings, formula.thickness.map(normal), None);
        }
    }
    if let Ok(runout) = &read.runout {
        let name = format!("ball {} mm", runout.diameter);
        add(name, runout.radii(), formula.ball_centre, None);
    }
    if let Ok(root) = &read.root {
        let (name, d) = ("root diameter".to_owned(), 2.0 * root.radius);
        let by_formula = formula.root.map(|root| 2.0 * root);
        let readings = Summary {
            ends: [d; 2],
            mean: d,
            error: 2.0 * root.error,
        };
        add(name, readings, by_formula, None);
    }
    if let Ok(roll) = &read.roll {
        let name = format!("a'', master z {}", roll.master.basic_data().teeth());
        add(name, roll.distances(), formula.distance, None);
    }
    rows
}
