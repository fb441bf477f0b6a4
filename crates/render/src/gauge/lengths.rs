//! Lengths with their least, mean and greatest reading: the rows of the text, the charts of each less its mean.

use gearlash::gauge::OverPins;
use gearlash_results::gauge::{Chart, GaugedGear};

/// One length, mm.
pub(super) struct Length {
    /// What was read.
    pub name: String,
    /// Least and greatest reading.
    pub ends: [f64; 2],
    pub mean: f64,
    /// Bound on the error of a reading.
    pub error: f64,
    /// What a formula says of the mean thickness.
    pub formula: Option<f64>,
    /// Where each tooth has a length of its own.
    pub by_tooth: Option<ByTooth>,
}

/// A length at each tooth.
pub(super) struct ByTooth {
    pub chart: Chart,
    /// The lengths, mm, from tooth 1 on.
    pub values: Vec<f64>,
    /// Its symbol.
    pub symbol: String,
    /// What the tooth of a reading is to it.
    pub tooth: &'static str,
}

/// Every length that was measured.
pub(super) fn lengths(gauged: &GaugedGear) -> Vec<Length> {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let wound = gauged.gear.gear().basic_data().hand().is_some();
    let mut rows = Vec::new();
    if let Ok(spans) = &read.spans {
        rows.push(Length {
            name: match wound {
                true => format!("span W_{}, normal", spans.teeth),
                false => format!("span W_{}", spans.teeth),
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
        });
    }
    if let Ok(pins) = &read.pins {
        let two = (&pins.two, formula.over_two, Chart::PINS);
        let three = (&pins.three, formula.over_three, Chart::THREE_PINS);
        let lying = (&pins.lying, formula.over_lying, Chart::LYING_PINS);
        let [twice, thrice] = match wound {
            true => ["two balls", "three balls"],
            false => ["two pins", "three pins"],
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
                });
            }
        }
    }
    if let Ok(thickness) = &read.thickness {
        rows.push(Length {
            name: match wound {
                true => "thickness s_t, transverse".to_owned(),
                false => "thickness s".to_owned(),
            },
            ends: thickness.ends(),
            mean: thickness.mean(),
            error: thickness.error,
            formula: Some(formula.thickness),
            by_tooth: Some(ByTooth {
                chart: Chart::THICKNESS,
                values: thickness.arcs.clone(),
                symbol: if wound { "s_t" } else { "s" }.to_owned(),
                tooth: "tooth",
            }),
        });
    }
    let whole = |name, ends, mean, error, formula| Length {
        name,
        ends,
        mean,
        error,
        formula,
        by_tooth: None,
    };
    if let (true, Ok(thickness)) = (wound, &read.thickness) {
        let normal = thickness.normal;
        rows.push(whole(
            "thickness s_n, normal".to_owned(),
            thickness.ends().map(|end| end * normal),
            thickness.mean() * normal,
            thickness.error,
            Some(formula.thickness * normal),
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
            Some(2.0 * formula.root),
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
