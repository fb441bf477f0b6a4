//! Readings tooth by tooth as CSV, in the words a gear file's tables are read by.
//!
//! A dimension over three pins is named so that it is not read as one over two. Numbers are written so that they
//! read back to the same f64.

use super::GaugedGear;
use super::by_tooth::{columns, micrometres};
use super::file_names::FileName;
use gearlash::gauge::{OverPins, PitchReadings};
use gearlash::gear::Side;

/// A column: its heading, and a value a row.
type Column = (&'static str, Vec<f64>);

/// The CSV files of one gear: name and content. What could not be measured has none.
///
/// # Errors
/// None that readings can cause; the writer's otherwise.
pub fn csv_files(gauged: &GaugedGear) -> Result<Vec<(String, String)>, csv::Error> {
    let readings = &gauged.gauged;
    let mut files = Vec::new();
    let mut add = |name: FileName, columns: &[Column]| -> Result<(), csv::Error> {
        files.push((name.csv(&gauged.stem()), by_tooth(columns)?));
        Ok(())
    };
    if let Ok(spans) = &readings.spans {
        let lengths = spans.readings.iter().map(|span| span.length);
        add(FileName::Spans, &[("span", lengths.collect())])?;
    }
    if let Ok(pins) = &readings.pins {
        let lengths = |over: &[OverPins]| over.iter().map(|o| o.length).collect();
        add(FileName::Pins, &[("pins", lengths(&pins.two))])?;
        if !pins.three.is_empty() {
            add(FileName::ThreePins, &[("three_pins", lengths(&pins.three))])?;
        }
    }
    if let Ok(runout) = &readings.runout {
        add(
            FileName::Runout,
            &[("runout", micrometres(&runout.deviations()))],
        )?;
    }
    for (cumulative, single, pitch) in [
        (
            FileName::PitchOwn,
            FileName::SinglePitchOwn,
            &readings.pitch_own,
        ),
        (
            FileName::PitchDatum,
            FileName::SinglePitchDatum,
            &readings.pitch_datum,
        ),
    ] {
        if let Ok(pitch) = pitch {
            add(
                cumulative,
                &flanks(|side| pitch.cumulative.flank(side).to_vec()),
            )?;
            add(single, &flanks(|side| PitchReadings::single(pitch, side)))?;
        }
    }
    if let Ok(thickness) = &readings.thickness {
        add(
            FileName::Thickness,
            &[("thickness", micrometres(&thickness.deviations()))],
        )?;
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
        files.push((FileName::Roll.csv(&gauged.stem()), finish(writer)?));
    }
    Ok(files)
}

/// All readings by tooth of several gears, a row a tooth; what could not be measured is left empty.
///
/// # Errors
/// As [`csv_files`].
pub fn teeth_csv(gears: &[GaugedGear]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (index, gauged) in gears.iter().enumerate() {
        let columns = columns(&gauged.gauged);
        if index == 0 {
            let names = columns.iter().map(|column| column.name);
            writer.write_record(["gear", "material", "tooth"].into_iter().chain(names))?;
        }
        for tooth in 1..=gauged.gear.gear().basic_data().teeth() {
            let cells = columns.iter().map(|column| {
                let value = column.values.get(tooth as usize - 1);
                value.map_or(String::new(), f64::to_string)
            });
            let name = [
                gauged.name.to_owned(),
                gauged.material.name().to_owned(),
                tooth.to_string(),
            ];
            writer.write_record(name.into_iter().chain(cells))?;
        }
    }
    finish(writer)
}

fn flanks(values: impl Fn(Side) -> Vec<f64>) -> [Column; 2] {
    [("left", Side::Left), ("right", Side::Right)]
        .map(|(name, side)| (name, micrometres(&values(side))))
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
