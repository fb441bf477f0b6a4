//! Readings tooth by tooth as CSV, in the words a gear file's tables are read by.
//!
//! Numbers are written so that they read back to the same f64.

use super::GaugedGear;
use crate::gauge::PitchReadings;
use crate::gear::Side;

/// A column: its heading, and a value a row.
type Column = (&'static str, Vec<f64>);

/// The CSV files of one gear: name and content. What could not be measured has none.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
pub fn csv_files(gauged: &GaugedGear) -> Result<Vec<(String, String)>, csv::Error> {
    let readings = &gauged.gauged;
    let mut files = Vec::new();
    let mut add = |name: &str, columns: &[Column]| -> Result<(), csv::Error> {
        files.push((format!("{}_{name}.csv", gauged.stem()), by_tooth(columns)?));
        Ok(())
    };
    if let Ok(spans) = &readings.spans {
        let lengths = spans.readings.iter().map(|span| span.length);
        add("spans", &[("span", lengths.collect())])?;
    }
    if let Ok(pins) = &readings.pins {
        let lengths = |over: &[crate::gauge::OverPins]| over.iter().map(|o| o.length).collect();
        add("pins", &[("pins", lengths(&pins.two))])?;
        if !pins.three.is_empty() {
            add("three_pins", &[("pins", lengths(&pins.three))])?;
        }
    }
    if let Ok(runout) = &readings.runout {
        add("runout", &[("runout", um(&runout.deviations()))])?;
    }
    for (name, pitch) in [
        ("pitch_own", &readings.pitch_own),
        ("pitch_datum", &readings.pitch_datum),
    ] {
        if let Ok(pitch) = pitch {
            add(name, &flanks(pitch))?;
        }
    }
    if let Ok(thickness) = &readings.thickness {
        add("thickness", &[("thickness", um(&thickness.deviations()))])?;
    }
    if let Ok(roll) = &readings.roll {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record([
            "tooth",
            "fraction",
            "rotation_rad",
            "a_mm",
            "error_bound_um",
            "class",
        ])?;
        for pose in &roll.poses {
            writer.write_record([
                pose.mating.wheel_tooth.to_string(),
                pose.mating.fraction.to_string(),
                pose.rotation.to_string(),
                pose.distance.to_string(),
                (pose.error * 1e3).to_string(),
                pose.class.name().to_owned(),
            ])?;
        }
        files.push((format!("{}_roll.csv", gauged.stem()), finish(writer)?));
    }
    Ok(files)
}

/// All readings by tooth of several gears, a row a tooth; what could not be measured is left empty.
///
/// # Errors
/// As [`csv_files`].
pub fn teeth_csv(gears: &[GaugedGear]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "gear",
        "material",
        "tooth",
        "span_mm",
        "over_two_pins_mm",
        "over_three_pins_mm",
        "runout_um",
        "pitch_own_left_um",
        "pitch_own_right_um",
        "pitch_datum_left_um",
        "pitch_datum_right_um",
        "thickness_um",
    ])?;
    for gauged in gears {
        let readings = &gauged.gauged;
        let pins = readings.pins.as_ref();
        let pitch = |pitch: &Result<PitchReadings, _>, side| {
            pitch
                .as_ref()
                .map_or(Vec::new(), |pitch| um(pitch.cumulative.flank(side)))
        };
        let columns = [
            readings.spans.as_ref().map_or(Vec::new(), |spans| {
                spans.readings.iter().map(|span| span.length).collect()
            }),
            pins.map_or(Vec::new(), |pins| {
                pins.two.iter().map(|over| over.length).collect()
            }),
            pins.map_or(Vec::new(), |pins| {
                pins.three.iter().map(|over| over.length).collect()
            }),
            readings
                .runout
                .as_ref()
                .map_or(Vec::new(), |runout| um(&runout.deviations())),
            pitch(&readings.pitch_own, Side::Left),
            pitch(&readings.pitch_own, Side::Right),
            pitch(&readings.pitch_datum, Side::Left),
            pitch(&readings.pitch_datum, Side::Right),
            readings
                .thickness
                .as_ref()
                .map_or(Vec::new(), |read| um(&read.deviations())),
        ];
        for tooth in 1..=gauged.gear.gear().toothing().teeth() {
            let cell = |column: &Vec<f64>| {
                column
                    .get(tooth as usize - 1)
                    .map_or(String::new(), f64::to_string)
            };
            let name = [
                gauged.name.to_owned(),
                gauged.material.name().to_owned(),
                tooth.to_string(),
            ];
            writer.write_record(name.into_iter().chain(columns.iter().map(cell)))?;
        }
    }
    finish(writer)
}

fn flanks(pitch: &PitchReadings) -> [Column; 2] {
    [("left", Side::Left), ("right", Side::Right)]
        .map(|(name, side)| (name, um(pitch.cumulative.flank(side))))
}

fn um(lengths: &[f64]) -> Vec<f64> {
    lengths.iter().map(|mm| mm * 1e3).collect()
}

fn by_tooth(columns: &[Column]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = columns.iter().map(|column| column.0);
    writer.write_record(std::iter::once("tooth").chain(names))?;
    let rows = columns
        .iter()
        .map(|column| column.1.len())
        .min()
        .unwrap_or(0);
    for row in 0..rows {
        let values = columns.iter().map(|column| column.1[row].to_string());
        writer.write_record(std::iter::once((row + 1).to_string()).chain(values))?;
    }
    finish(writer)
}

fn finish(writer: csv::Writer<Vec<u8>>) -> Result<String, csv::Error> {
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
