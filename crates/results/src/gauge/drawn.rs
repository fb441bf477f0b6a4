//! Spans and pins read on outlines, as tables, JSON and CSV: keys and columns as of gears by their data.

use super::json::{json_of, of, over};
use super::{ByTooth, Readings};
use gearlash::contact::Touch;
use gearlash::gauge::{OutlineGauged, Unmeasured};
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

    /// The readings tooth by tooth.
    pub fn by_tooth(&self) -> ByTooth<'_> {
        ByTooth {
            gear: self.entry.name,
            material: self.entry.material.name(),
            teeth: self.entry.gear.teeth(),
            readings: Readings::Drawn(&self.gauged),
        }
    }
}

/// All gears as JSON: lengths in mm, bounds in µm. What was asked for and not measured is `{ "not_measured": reason }`; what was not asked for
/// has no key.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
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

fn touched(touches: &[Touch]) -> Value {
    let one = |touch: &Touch| json!({ "tooth": touch.tooth, "curve": touch.curve.name(), "radius_mm": touch.radius });
    touches.iter().map(one).collect()
}
