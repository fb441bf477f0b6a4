//! A rig's measurements beside the bands they should lie in.

use crate::layout::{Column, Screen, Table};
use crate::unit;
use gearlash::analysis::measured::{Band, MeasuredMating, sides};
use gearlash::analysis::study::Study;
use gearlash::pair::BacklashUnit;
use gearlash_files::numbers::{NONE, backlash_ascii, stated_distance};
use std::fmt::Write;

fn band(band: Option<Band>, unit: BacklashUnit, a: f64) -> String {
    let cell = |um: f64| backlash_ascii(unit, um, a, 1);
    match band {
        Some(band) => format!("{} … {}", cell(band.min_um), cell(band.max_um)),
        None => NONE.to_owned(),
    }
}

pub fn measured_table(measured: &[MeasuredMating], unit: BacklashUnit, screen: &Screen) -> String {
    let mut table = Table::new([
        Column::new("mating"),
        Column::new("a mm"),
        Column::new("predicted (printed)"),
        Column::new("analytic").spare(1),
        Column::new("simulated"),
        Column::new("measured right"),
        Column::new("left"),
    ]);
    for mating in measured {
        let a = mating.row.center_distance;
        let marked = |value: f64| {
            let mark = match mating.printed.side_of(value) {
                0 => ' ',
                1 => '↑',
                _ => '↓',
            };
            match unit {
                BacklashUnit::Um => format!("{value} {mark}"),
                unit => format!("{} {mark}", backlash_ascii(unit, value, a, 1)),
            }
        };
        table.add(vec![
            format!("{},{}", mating.row.wheel_tooth, mating.row.pinion_tooth),
            stated_distance(a),
            band(Some(mating.printed), unit, a),
            band(mating.analytic, unit, a),
            band(mating.simulated, unit, a),
            marked(mating.row.right_um),
            marked(mating.row.left_um),
        ]);
    }
    table.text(screen)
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
    text + &screen.paragraphs(&format!("{}{LEGEND}", unit::measure(unit)))
}

const LEGEND: &str = "\
. Bands run from most to least material. Predicted: as printed beside the measurement. \
Analytic: model 2 (involute); simulated: on the tooth outlines; both are means of the mating's right-flank \
and left-flank pose. ↓ ↑: measured below or above the predicted band.";
