//! Spans and pins read on outlines, as tables, JSON and CSV: keys and columns as of gears by their data.

use crate::gauge::{json_of, of};
use crate::{Cell, Column, Table, Unit};
use gearlash::contact::OutlineTouch;
use gearlash::gauge::{OutlineGauged, OverPins, Unmeasured};
use gearlash_files::outlines::OutlineGearEntry;
use serde_json::{Value, json};

/// One gear and what was read on it.
#[derive(Debug)]
pub struct GaugedOutline<'a> {
    /// The gear.
    pub entry: &'a OutlineGearEntry,
    /// The readings.
    pub gauged: OutlineGauged,
}

impl GaugedOutline<'_> {
    /// The gear in a few words.
    pub fn words(&self) -> String {
        let OutlineGearEntry {
            name,
            material,
            gear,
        } = self.entry;
        format!(
            "{name}, outline of {} teeth, material {}",
            gear.teeth(),
            material.name()
        )
    }

    /// What was asked for and not measured, and why: a line each.
    pub fn unmeasured(&self) -> Vec<String> {
        let spans = self.gauged.spans.iter();
        let spans = spans.filter_map(|spans| Some(("span", spans.as_ref().err()?)));
        let pins = self.gauged.pins.iter();
        let pins = pins.filter_map(|pins| Some(("over pins", pins.as_ref().err()?)));
        let line = |(what, reason): (&str, &Unmeasured)| format!("not measured, {what}: {reason}");
        spans.chain(pins).map(line).collect()
    }

    /// Every reading, a row a tooth, each column with its heading in a narrow table; what was not measured has no cells.
    pub fn by_tooth(&self) -> Vec<(&'static str, Column)> {
        let spans = self.gauged.spans.iter().flatten();
        let pins = || self.gauged.pins.iter().flatten();
        let mm = |name, lengths| Column::new::<f64>(name, Unit::Mm, lengths);
        let lengths =
            |list: &[OverPins]| -> Vec<f64> { list.iter().map(|one| one.length).collect() };
        let spans: Vec<f64> = spans
            .flat_map(|spans| &spans.readings)
            .map(|one| one.length)
            .collect();
        vec![
            ("W_k mm", mm("span_mm", spans)),
            (
                "two pins mm",
                mm(
                    "over_two_pins_mm",
                    pins().flat_map(|pins| lengths(&pins.two)).collect(),
                ),
            ),
            (
                "three pins mm",
                mm(
                    "over_three_pins_mm",
                    pins().flat_map(|pins| lengths(&pins.three)).collect(),
                ),
            ),
        ]
    }

    fn table(&self) -> Table {
        let teeth = self.entry.gear.teeth();
        let same = |name, word: &'static str| {
            Column::new(name, Unit::None, vec![Cell::from(word); teeth as usize])
        };
        let columns = [
            same("gear", self.entry.name),
            same("material", self.entry.material.name()),
            Column::new("tooth", Unit::None, 1..=teeth),
        ];
        let readings = self.by_tooth().into_iter().map(|(_, column)| column);
        Table {
            name: "teeth",
            columns: columns.into_iter().chain(readings).collect(),
        }
    }
}

/// All readings of several gears as CSV, a row a tooth.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
pub fn gauged_csv(gears: &[GaugedOutline]) -> Result<String, csv::Error> {
    let tables: Vec<Table> = gears.iter().map(GaugedOutline::table).collect();
    Table::all_to_csv(&tables)
}

/// All gears as JSON: lengths in mm, bounds in µm. What was asked for and not measured is `{ "not_measured": reason }`; what was not asked for
/// has no key.
///
/// # Errors
/// As [`gauged_csv`].
pub fn gauged_json(title: &str, gears: &[GaugedOutline]) -> Result<String, serde_json::Error> {
    json_of(title, gears.iter().map(gear).collect())
}

fn gear(gauged: &GaugedOutline) -> Value {
    let gear = &gauged.entry.gear;
    let mut value = json!({
        "gear": gauged.entry.name,
        "material": gauged.entry.material.name(),
        "teeth": gear.teeth(),
        "outline_bound_um": gear.bound() * 1e3,
    });
    if let Some(spans) = &gauged.gauged.spans {
        value["spans"] = of(spans, |spans| {
            let row = |one: &gearlash::gauge::OutlineSpan| {
                json!({
                    "tooth": one.first_tooth,
                    "mm": one.length,
                    "error_bound_um": one.error * 1e3,
                    "touched": touched(&one.touched),
                })
            };
            json!({ "teeth": spans.teeth, "readings": spans.readings.iter().map(row).collect::<Value>() })
        });
    }
    if let Some(pins) = &gauged.gauged.pins {
        value["pins"] = of(pins, |pins| {
            let row = |seat: &gearlash::gauge::OutlineSeat| {
                json!({
                    "tooth": seat.tooth,
                    "centre_mm": [seat.centre.x, seat.centre.y],
                    "error_bound_um": seat.error * 1e3,
                    "touched": touched(&seat.touched),
                })
            };
            json!({
                "pin_mm": pins.diameter,
                "two": over(&pins.two),
                "three": over(&pins.three),
                "seats": pins.seats.iter().map(row).collect::<Value>(),
            })
        });
    }
    value
}

fn over(list: &[OverPins]) -> Value {
    let row = |one: &OverPins| json!({ "tooth": one.tooth, "opposite": one.opposite, "mm": one.length, "error_bound_um": one.error * 1e3 });
    list.iter().map(row).collect()
}

fn touched(touches: &[OutlineTouch]) -> Value {
    let one = |touch: &OutlineTouch| json!({ "tooth": touch.tooth, "region": touch.curve.name(), "radius_mm": touch.radius });
    touches.iter().map(one).collect()
}
