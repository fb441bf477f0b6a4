//! Lengths with their least, mean and greatest reading: the rows of the text, and the charts of each less its mean.

use super::{Chart, GaugedGear};
use crate::column::{Columns, Row, Value, columns};
use crate::layout::{self, Screen};
use gearlash::gauge::OverPins;
use gearlash_files::numbers::{ascii, order_um, um_ascii};
use std::sync::LazyLock;

/// One length, mm.
pub struct Length {
    /// The name of the gauge.
    pub name: String,
    /// Least and greatest reading.
    ends: [f64; 2],
    /// Mean of the readings.
    pub mean: f64,
    /// Bound on the error of a reading.
    error: f64,
    /// The value by formula at the mean thickness.
    pub formula: Option<f64>,
    /// The length at each tooth, where it varies.
    pub by_tooth: Option<ByTooth>,
    is_drawn: bool,
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
        let range = self.ends[1] - self.ends[0];
        let values = self.by_tooth.iter().filter(|_| range > self.error);
        let place = values.flat_map(|of| of.values.iter().position(|mm| *mm == self.ends[end]));
        Value::optional(place.map(|place| place + 1).next())
    }

    /// `cell`, which is absent in tables of drawn gears.
    fn by_formula(&self, cell: impl FnOnce(Option<f64>) -> String) -> Value {
        Value::optional((!self.is_drawn).then(|| cell(self.formula)))
    }
}

impl Row for Length {
    fn columns() -> &'static Columns<Length> {
        static COLUMNS: LazyLock<Columns<Length>> = LazyLock::new(|| {
            let shown = layout::Column::new;
            Columns::new(columns!(row: Length {
                "" Plain [people(shown(""))] => row.name.clone();
                "" Plain [people(shown("least"))] => ascii(row.ends[0], 6);
                "" Plain [people(shown("at").spare(4))] => row.tooth(0);
                "" Plain [people(shown("mean"))] => ascii(row.mean, 6);
                "" Plain [people(shown("greatest"))] => ascii(row.ends[1], 6);
                "" Plain [people(shown("at").spare(4))] => row.tooth(1);
                "" Plain [people(shown("range"))] => um_ascii(row.ends[1] - row.ends[0], 3);
                "" Plain [people(shown("formula").spare(1))] => row.by_formula(|formula| ascii(formula, 6));
                "" Plain [people(shown("off").spare(2))] => row.by_formula(|formula| um_ascii(formula.map(|formula| row.mean - formula), 3));
                "" Plain [people(shown("bound").spare(3))] => order_um(row.error);
            }))
        });
        &COLUMNS
    }
}

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
    let (wound, is_drawn) = (gauged.is_helical(), gauged.basic_data().is_none());
    let mut rows = Vec::new();
    if let Ok(spans) = &read.spans {
        rows.push(Length {
            name: if wound {
                format!("span W_{}, normal", spans.teeth)
            } else {
                format!("span W_{}", spans.teeth)
            },
            ends: spans.ends(),
            mean: spans.mean(),
            error: spans.error(),
            formula: formula.span,
            by_tooth: Some(ByTooth {
                chart: Chart::SPANS,
                values: spans.readings.iter().map(|one| one.length).collect(),
                symbol: format!("W_{}", spans.teeth),
                tooth: "first tooth spanned",
            }),
            is_drawn,
        });
    }
    if let Ok(pins) = &read.pins {
        let two = (&pins.two, formula.over_two, Chart::PINS);
        let three = (&pins.three, formula.over_three, Chart::THREE_PINS);
        let lying = (&pins.lying, formula.over_lying, Chart::LYING_PINS);
        let [twice, thrice] = if wound {
            ["two balls", "three balls"]
        } else {
            ["two pins", "three pins"]
        };
        for ((list, formula, chart), what, symbol, tooth) in [
            (two, twice, "M_dK", "tooth before the first pin"),
            (three, thrice, "M_dK", "tooth before the single pin"),
            (
                lying,
                "two lying pins",
                "M_dR",
                "tooth before the first pin",
            ),
        ] {
            if !list.is_empty() {
                rows.push(Length {
                    name: format!("{symbol}, {what} {} mm", pins.diameter),
                    ends: OverPins::ends(list),
                    mean: OverPins::mean(list),
                    error: OverPins::error(list),
                    formula,
                    by_tooth: Some(ByTooth {
                        chart,
                        values: list.iter().map(|one| one.length).collect(),
                        symbol: symbol.to_owned(),
                        tooth,
                    }),
                    is_drawn,
                });
            }
        }
    }
    if let Ok(thickness) = &read.thickness {
        rows.push(Length {
            name: if wound {
                "thickness s_t, transverse".to_owned()
            } else {
                "thickness s".to_owned()
            },
            ends: thickness.ends(),
            mean: thickness.mean(),
            error: thickness.error,
            formula: formula.thickness,
            by_tooth: Some(ByTooth {
                chart: Chart::THICKNESS,
                values: thickness.arcs.clone(),
                symbol: if wound { "s_t" } else { "s" }.to_owned(),
                tooth: "tooth",
            }),
            is_drawn,
        });
    }
    let whole = |name, ends, mean, error, formula| Length {
        name,
        ends,
        mean,
        error,
        formula,
        by_tooth: None,
        is_drawn,
    };
    if let (true, Ok(thickness)) = (wound, &read.thickness) {
        let normal = thickness.normal;
        rows.push(whole(
            "thickness s_n, normal".to_owned(),
            thickness.ends().map(|end| end * normal),
            thickness.mean() * normal,
            thickness.error,
            formula.thickness.map(|arc| arc * normal),
        ));
    }
    if let Ok(runout) = &read.runout {
        let name = format!("ball {} mm", runout.diameter);
        let error = runout.reading_error();
        rows.push(whole(
            name,
            runout.ends(),
            runout.mean(),
            error,
            formula.ball_centre,
        ));
    }
    if let Ok(root) = &read.root {
        let (name, d) = ("root diameter".to_owned(), 2.0 * root.radius);
        rows.push(whole(
            name,
            [d; 2],
            d,
            2.0 * root.error,
            formula.root.map(|root| 2.0 * root),
        ));
    }
    if let Ok(roll) = &read.roll {
        let name = format!("a'', master z {}", roll.master.basic_data().teeth());
        rows.push(whole(
            name,
            roll.ends(),
            roll.mean(),
            roll.reading_error(),
            formula.distance,
        ));
    }
    rows
}
