//! The double-flank roll test as a curve over one revolution.

use super::bars::{LEVEL, NUMBERS, means, subtitle};
use crate::chart::{Heading, LineAxes, LineSeries, Look, lines};
use crate::error::PictureError;
use gearlash::gauge::RollPose;
use gearlash_files::numbers::um;
use gearlash_files::results::gauge::{GaugedGear, Reading};

pub(super) fn chart(gauged: &GaugedGear) -> Result<Option<(String, String)>, PictureError> {
    let Ok(roll) = &gauged.gauged.roll else {
        return Ok(None);
    };
    let mean = roll.mean();
    let teeth = gauged.gear.gear().basic_data().teeth();
    let value = |pose: &RollPose| Some(1e3 * (pose.distance - mean));
    let place = |pose: &RollPose| f64::from(pose.mating.wheel_tooth) + pose.mating.fraction;
    let mut points: Vec<(f64, Option<f64>)> = roll
        .poses
        .iter()
        .chain(&roll.between)
        .map(|pose| (place(pose), value(pose)))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Once round: the first pose comes again.
    let first = points.first().and_then(|point| point.1);
    points.push((f64::from(teeth) + 1.0, first));
    let level = match points
        .iter()
        .all(|point| point.1.is_none_or(|um| um.abs() < LEVEL))
    {
        true => format!(" · level within {LEVEL} µm"),
        false => String::new(),
    };
    let stem = gauged.stem();
    let heading = Heading {
        prefix: &Reading::Roll.file_stem(&stem),
        title: gauged.title,
        subtitle: &subtitle(gauged),
    };
    let title = format!(
        "roll test with a master of z {} · F_i'' {}, f_i'' {} µm · {}{level}",
        roll.master.basic_data().teeth(),
        um(roll.total().found, 3),
        um(roll.tooth_to_tooth().found, 3),
        means(mean, gauged.gauged.formula.distance)
    );
    let x = format!("tooth of the gear at the master, one revolution back to 1 · {NUMBERS}");
    let axes = LineAxes {
        title: &title,
        x: &x,
        teeth: Some(teeth),
        y: "a'' − mean, µm",
        least: 100.0 * LEVEL,
    };
    let line = LineSeries {
        name: "a''",
        points,
        look: Look::Plain,
        dots: false,
    };
    let svg = lines(&heading, axes, &[line])?.svg;
    Ok(Some((Reading::Roll.svg(&stem), svg)))
}
