//! The readings of a gear tooth by tooth, for CSV and for people, and their charts.

use super::GaugedGear;
use crate::column::{Column, Format, Row, Value, columns, row_type, shown};
use crate::layout::Screen;
use gearlash::gauge::{Gauged, OverPins, Pins, PitchReadings, TraceReading};
use gearlash::gear::{Flank, PitchAxis};

/// The values of a reading, one per tooth; `None` where it was not taken.
type Get = fn(&Gauged) -> Option<Vec<f64>>;

/// The column for helical gears only.
const LYING: &str = "over_lying_pins_mm";

/// Every reading per tooth: its name in CSV, its heading for people, and its values.
#[rustfmt::skip]
const READINGS: [(&str, &str, Get); 20] = [
    ("span_mm", "W_k mm", spans),
    ("over_two_pins_mm", "two pins mm", |read| pins(read, |pins| &pins.two)),
    ("over_three_pins_mm", "three pins mm", |read| pins(read, |pins| &pins.three)),
    (LYING, "lying pins mm", |read| pins(read, |pins| &pins.lying)),
    ("runout_um", "ball", |read| in_um(&read.runout.as_ref().ok()?.deviations())),
    ("single_pitch_own_left_um", "f own left", |read| single(read, PitchAxis::Own, Flank::Left)),
    ("single_pitch_own_right_um", "f own right", |read| single(read, PitchAxis::Own, Flank::Right)),
    ("pitch_own_left_um", "F own left", |read| cumulative(read, PitchAxis::Own, Flank::Left)),
    ("pitch_own_right_um", "F own right", |read| cumulative(read, PitchAxis::Own, Flank::Right)),
    ("single_pitch_datum_left_um", "f datum left", |read| single(read, PitchAxis::Datum, Flank::Left)),
    ("single_pitch_datum_right_um", "f datum right", |read| single(read, PitchAxis::Datum, Flank::Right)),
    ("pitch_datum_left_um", "F datum left", |read| cumulative(read, PitchAxis::Datum, Flank::Left)),
    ("pitch_datum_right_um", "F datum right", |read| cumulative(read, PitchAxis::Datum, Flank::Right)),
    ("thickness_um", "s − mean", |read| in_um(&read.thickness.as_ref().ok()?.deviations())),
    ("profile_slope_left_um", "f_Hα left", |read| profile(read, Flank::Left, |one| one.slope)),
    ("profile_slope_right_um", "f_Hα right", |read| profile(read, Flank::Right, |one| one.slope)),
    ("profile_form_left_um", "f_fα left", |read| profile(read, Flank::Left, |one| one.form)),
    ("profile_form_right_um", "f_fα right", |read| profile(read, Flank::Right, |one| one.form)),
    ("profile_total_left_um", "F_α left", |read| profile(read, Flank::Left, |one| one.total)),
    ("profile_total_right_um", "F_α right", |read| profile(read, Flank::Right, |one| one.total)),
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
    in_um(&pitch(read, axis)?.cumulative.single(flank))
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

/// The readings of a tooth.
struct ToothRow {
    gear: &'static str,
    material: &'static str,
    tooth: usize,
    /// In the order of [`READINGS`].
    values: Vec<Option<f64>>,
}

row_type!(ToothRow = tooth_columns());

fn tooth_columns() -> Vec<Column<ToothRow>> {
    let mut columns = columns!(row: ToothRow {
        "gear" Plain => row.gear;
        "material" Plain => row.material;
        "tooth" Plain [heading(shown("tooth"))] => row.tooth;
    });
    for (index, (name, heading, _)) in READINGS.into_iter().enumerate() {
        let decimals = if name.ends_with("_mm") { 6 } else { 3 };
        let value = move |row: &ToothRow| Value::optional(row.values[index]);
        let column =
            Column::new(name, Format::Fixed(decimals), Box::new(value)).heading(shown(heading));
        columns.push(if name == LYING {
            column.optional_in_csv().rank(1)
        } else {
            column
        });
    }
    columns
}

fn tooth_rows(gear: &GaugedGear) -> Vec<ToothRow> {
    let readings = READINGS.map(|(_, _, values)| values(&gear.gauged));
    let row = |tooth: usize| ToothRow {
        gear: gear.name,
        material: gear.material.name(),
        tooth,
        values: readings
            .each_ref()
            .map(|values| values.as_ref()?.get(tooth - 1).copied())
            .to_vec(),
    };
    (1..=gear.teeth as usize).map(row).collect()
}

/// A table for people, one row per tooth; a column without values is left out.
pub fn tooth_table(gear: &GaugedGear) -> String {
    ToothRow::columns().text(&tooth_rows(gear), &Screen::default())
}

/// The readings of several gears as CSV, one row per tooth; a reading that was not taken is empty.
pub fn teeth_csv(gears: &[GaugedGear]) -> String {
    let rows: Vec<ToothRow> = gears.iter().flat_map(tooth_rows).collect();
    let lying = READINGS.iter().position(|(name, ..)| *name == LYING);
    let has_lying = |row: &ToothRow| lying.is_some_and(|index| row.values[index].is_some());
    ToothRow::columns().csv_with(&rows, rows.iter().any(has_lying))
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
