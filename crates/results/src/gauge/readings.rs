//! The readings of a gear tooth by tooth: one list of columns for CSV and for people.

use super::GaugedGear;
use crate::layout::{self, Screen, Table};
use gearlash::gauge::{Gauged, OverPins, Pins, PitchReadings, TraceReading};
use gearlash::gear::{Flank, PitchAxis};
use gearlash_files::characters::csv_text;
use gearlash_files::numbers::ascii;

/// A column: its name in CSV, its heading for people, and its values, one per tooth.
struct Column {
    name: &'static str,
    heading: &'static str,
    values: fn(&Gauged) -> Option<Vec<f64>>,
}

impl Column {
    const fn new(
        name: &'static str,
        heading: &'static str,
        values: fn(&Gauged) -> Option<Vec<f64>>,
    ) -> Column {
        Column {
            name,
            heading,
            values,
        }
    }
}

/// The column for helical gears only.
const LYING: &str = "over_lying_pins_mm";

/// Every reading per tooth.
#[rustfmt::skip]
const COLUMNS: [Column; 20] = [
    Column::new("span_mm", "W_k mm", spans),
    Column::new("over_two_pins_mm", "two pins mm", |read| pins(read, |pins| &pins.two)),
    Column::new("over_three_pins_mm", "three pins mm", |read| pins(read, |pins| &pins.three)),
    Column::new(LYING, "lying pins mm", |read| pins(read, |pins| &pins.lying)),
    Column::new("runout_um", "ball", |read| in_um(&read.runout.as_ref().ok()?.deviations())),
    Column::new("single_pitch_own_left_um", "f own left", |read| single(read, PitchAxis::Own, Flank::Left)),
    Column::new("single_pitch_own_right_um", "f own right", |read| single(read, PitchAxis::Own, Flank::Right)),
    Column::new("pitch_own_left_um", "F own left", |read| cumulative(read, PitchAxis::Own, Flank::Left)),
    Column::new("pitch_own_right_um", "F own right", |read| cumulative(read, PitchAxis::Own, Flank::Right)),
    Column::new("single_pitch_datum_left_um", "f datum left", |read| single(read, PitchAxis::Datum, Flank::Left)),
    Column::new("single_pitch_datum_right_um", "f datum right", |read| single(read, PitchAxis::Datum, Flank::Right)),
    Column::new("pitch_datum_left_um", "F datum left", |read| cumulative(read, PitchAxis::Datum, Flank::Left)),
    Column::new("pitch_datum_right_um", "F datum right", |read| cumulative(read, PitchAxis::Datum, Flank::Right)),
    Column::new("thickness_um", "s − mean", |read| in_um(&read.thickness.as_ref().ok()?.deviations())),
    Column::new("profile_slope_left_um", "f_Hα left", |read| profile(read, Flank::Left, |one| one.slope)),
    Column::new("profile_slope_right_um", "f_Hα right", |read| profile(read, Flank::Right, |one| one.slope)),
    Column::new("profile_form_left_um", "f_fα left", |read| profile(read, Flank::Left, |one| one.form)),
    Column::new("profile_form_right_um", "f_fα right", |read| profile(read, Flank::Right, |one| one.form)),
    Column::new("profile_total_left_um", "F_α left", |read| profile(read, Flank::Left, |one| one.total)),
    Column::new("profile_total_right_um", "F_α right", |read| profile(read, Flank::Right, |one| one.total)),
];

fn spans(read: &Gauged) -> Option<Vec<f64>> {
    let spans = read.spans.as_ref().ok()?.readings.iter();
    Some(spans.map(|one| one.length).collect())
}

fn pins(read: &Gauged, of: fn(&Pins) -> &[OverPins]) -> Option<Vec<f64>> {
    let list = of(read.pins.as_ref().ok()?);
    (!list.is_empty()).then(|| list.iter().map(|one| one.length).collect())
}

fn pitch(read: &Gauged, axis: PitchAxis) -> Option<&PitchReadings> {
    match axis {
        PitchAxis::Own => read.pitch_own.as_ref().ok(),
        PitchAxis::Datum => read.pitch_datum.as_ref().ok(),
    }
}

fn single(read: &Gauged, axis: PitchAxis, flank: Flank) -> Option<Vec<f64>> {
    in_um(&pitch(read, axis)?.single(flank))
}

fn cumulative(read: &Gauged, axis: PitchAxis, flank: Flank) -> Option<Vec<f64>> {
    in_um(pitch(read, axis)?.cumulative.flank(flank))
}

/// Profile deviations; `None` where no flank deviates.
fn profile(read: &Gauged, flank: Flank, of: fn(&TraceReading) -> f64) -> Option<Vec<f64>> {
    let found = read.profile.as_ref().ok()?;
    found
        .deviates()
        .then(|| in_um(&found.flank(flank).by_tooth(of)))?
}

fn in_um(lengths: &[f64]) -> Option<Vec<f64>> {
    Some(lengths.iter().map(|mm| mm * 1e3).collect())
}

/// The columns with their values.
fn columns(gauged: &Gauged) -> impl Iterator<Item = (&'static Column, Option<Vec<f64>>)> {
    let columns = COLUMNS.iter();
    columns.map(move |column| (column, (column.values)(gauged)))
}

/// A table for people, one row per tooth; a column without values is left out.
pub fn position_table(gear: &GaugedGear) -> String {
    let shown: Vec<(&Column, Vec<f64>)> = columns(&gear.gauged)
        .filter_map(|(column, values)| Some((column, values?)))
        .collect();
    let headings = shown.iter().map(|(column, _)| column.heading);
    let headings = std::iter::once("tooth").chain(headings);
    let mut table = Table::new(headings.map(layout::Column::new));
    for tooth in 1..=gear.teeth() {
        let cells = shown.iter().map(|(column, values)| {
            let value = values.get(tooth as usize - 1).copied();
            let is_length = column.name.ends_with("_mm");
            ascii(value, if is_length { 6 } else { 3 })
        });
        table.add(std::iter::once(tooth.to_string()).chain(cells).collect());
    }
    table.text(&Screen::default())
}

/// The readings of several gears as CSV, one row per tooth; a reading that was not taken is empty.
///
/// # Errors
/// None: the text is in memory.
pub fn teeth_csv(gears: &[GaugedGear]) -> Result<String, csv::Error> {
    let each = gears.iter().map(|gear| columns(&gear.gauged).collect());
    let each: Vec<Vec<_>> = each.collect();
    let is_shown = |index: &usize| {
        COLUMNS[*index].name != LYING || each.iter().any(|columns| columns[*index].1.is_some())
    };
    let shown: Vec<usize> = (0..COLUMNS.len()).filter(is_shown).collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = shown.iter().map(|index| COLUMNS[*index].name);
    writer.write_record(["gear", "material", "tooth"].into_iter().chain(names))?;
    for (gear, columns) in gears.iter().zip(&each) {
        for tooth in 1..=gear.teeth() {
            let cell = |index: &usize| {
                let value = columns[*index].1.as_ref()?.get(tooth as usize - 1)?;
                Some(value.to_string())
            };
            let cells = shown.iter().map(|index| cell(index).unwrap_or_default());
            let head = [
                gear.name.to_owned(),
                gear.material.name().to_owned(),
                tooth.to_string(),
            ];
            writer.write_record(head.into_iter().chain(cells))?;
        }
    }
    csv_text(writer)
}

/// A reading with a chart. The name of the chart's file begins with the stem of the gear (`gauge_wheel`, `gauge_wheel_most`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Chart(&'static str);

impl Chart {
    /// Span W_k over each tooth and the next.
    pub const SPANS: Chart = Chart("spans");
    /// Dimension over two pins.
    pub const PINS: Chart = Chart("pins");
    /// Dimension over three pins.
    pub const THREE_PINS: Chart = Chart("three_pins");
    /// Dimension over two cylindrical pins along the spaces of a helical gear.
    pub const LYING_PINS: Chart = Chart("lying_pins");
    /// Ball in each space.
    pub const RUNOUT: Chart = Chart("runout");
    /// Pitch about the gear's own centre.
    pub const PITCH_OWN: Chart = Chart("pitch_own");
    /// Pitch about the rotation axis.
    pub const PITCH_DATUM: Chart = Chart("pitch_datum");
    /// Arc thickness.
    pub const THICKNESS: Chart = Chart("thickness");
    /// Double-flank roll test.
    pub const ROLL: Chart = Chart("roll");
    /// Profile deviation.
    pub const PROFILE: Chart = Chart("profile");
    /// Leads about the axis of the teeth.
    pub const LEAD_OWN: Chart = Chart("lead_own");
    /// Leads about the rotation axis.
    pub const LEAD_DATUM: Chart = Chart("lead_datum");
    /// Every chart.
    pub const ALL: [Chart; 12] = [
        Chart::SPANS,
        Chart::PINS,
        Chart::THREE_PINS,
        Chart::LYING_PINS,
        Chart::RUNOUT,
        Chart::PITCH_OWN,
        Chart::PITCH_DATUM,
        Chart::THICKNESS,
        Chart::ROLL,
        Chart::PROFILE,
        Chart::LEAD_OWN,
        Chart::LEAD_DATUM,
    ];

    /// Its file name without extension, for the gear of `stem`.
    pub fn file_stem(self, stem: &str) -> String {
        format!("{stem}_{}", self.0)
    }

    /// Its file name.
    pub fn svg(self, stem: &str) -> String {
        format!("{}.svg", self.file_stem(stem))
    }
}
