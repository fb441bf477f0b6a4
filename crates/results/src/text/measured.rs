//! Measurements of a rig, compared with their bands.

use crate::column::{Row, Shown, Value, quantity_words, row_type, shown};
use crate::layout::Screen;
use gearlash::analysis::measured::{Band, MeasuredMating, sides};
use gearlash::analysis::study::Study;
use gearlash::pair::BacklashUnit;
use gearlash_files::numbers::{backlash_ascii, stated_distance};
use std::fmt::Write;

/// A measured mating.
struct MeasuredRow {
    mating: MeasuredMating,
    /// The band that the measured values are compared with.
    beside: Option<Band>,
    unit: BacklashUnit,
    /// Whether the band with bearing clearance is a column.
    with_clearance: bool,
}

impl MeasuredRow {
    fn center_distance(&self) -> f64 {
        self.mating.row.center_distance
    }

    fn band(&self, band: Option<Band>) -> Value {
        let a = self.center_distance();
        let ends = band.map(|band| [band.min_um, band.max_um].map(|um| (Some(um), a)));
        ends.map_or(Value::Null, Value::Band)
    }

    /// A measured value, with a mark above or below its band.
    fn marked(&self, um: f64) -> String {
        let mark = match self.beside.map_or(0, |band| band.side_of(um)) {
            0 => ' ',
            1 => '↑',
            _ => '↓',
        };
        match self.unit {
            BacklashUnit::Um => format!("{um} {mark}"),
            unit => format!(
                "{} {mark}",
                backlash_ascii(unit, um, self.center_distance(), 1)
            ),
        }
    }
}

row_type!(row: MeasuredRow {
    "" Plain [people(shown("mating"))] => format!("{},{}", row.mating.row.wheel_tooth, row.mating.row.pinion_tooth);
    "" Distance [people(shown("a mm"))] => row.center_distance();
    "" Beside [people(shown("predicted (printed)"))] => row.band(Some(row.mating.printed));
    "" Beside [people(shown("analytic").spare(1))] => row.band(row.mating.analytic);
    "" Beside [people(shown("simulated"))] => row.band(row.mating.simulated);
    "" Beside [people(shown("with bearing clearance"))] => Value::optional(row.with_clearance.then(|| row.band(row.mating.with_clearance)));
    "" Beside [people(shown("measured right"))] => row.marked(row.mating.row.right_um);
    "" Beside [people(shown("left"))] => row.marked(row.mating.row.left_um);
});

/// The `measured` matings, each compared with the band `beside` it.
fn rows(
    measured: &[MeasuredMating],
    beside: fn(&MeasuredMating) -> Option<Band>,
    unit: BacklashUnit,
    with_clearance: bool,
) -> Vec<MeasuredRow> {
    let row = |mating: &MeasuredMating| MeasuredRow {
        beside: beside(mating),
        mating: mating.clone(),
        unit,
        with_clearance,
    };
    measured.iter().map(row).collect()
}

/// The measured matings for a page, compared with the simulated bands.
pub fn measured_shown(study: &Study, measured: &[MeasuredMating]) -> Vec<Shown> {
    let (unit, played) = (BacklashUnit::Um, study.bearing_clearance > 0.0);
    let rows = rows(measured, |mating| mating.simulated, unit, played);
    MeasuredRow::columns().shown(&rows, MeasuredRow::center_distance, unit)
}

/// The measured matings for a terminal, compared with the printed bands.
pub fn measured_table(measured: &[MeasuredMating], unit: BacklashUnit, screen: &Screen) -> String {
    let rows = rows(measured, |mating| Some(mating.printed), unit, false);
    MeasuredRow::columns().table(&rows, MeasuredRow::center_distance, unit, screen)
}

pub fn measured_count(
    study: &Study,
    measured: &[MeasuredMating],
    unit: BacklashUnit,
    screen: &Screen,
) -> String {
    let [below, inside, above] = sides(measured, |mating| Some(mating.printed));
    let total = below + inside + above;
    let mut text = format!(
        "\n{inside} of {total} measured values lie inside the predicted band: {below} below it (↓), {above} above it (↑).\n",
    );
    if study.bearing_clearance > 0.0 {
        let [_, inside, _] = sides(measured, |mating| mating.with_clearance);
        let _ = writeln!(
            text,
            "With the bearing clearance taken in (a ± {} mm), {inside} of {total} lie inside the simulated band.",
            stated_distance(study.bearing_clearance)
        );
    }
    text + &screen.paragraphs(&format!("{}{LEGEND}", quantity_words(unit)))
}

const LEGEND: &str = "\
. Bands run from most to least material. Predicted: as printed beside the measurement. \
Analytic: model 2 (involute); simulated: on the tooth outlines; both are means of the mating's right-flank \
and left-flank pose. ↓ ↑: measured below or above the predicted band.";
