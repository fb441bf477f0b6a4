//! The readings as charts, one a gauge: what each tooth reads less the mean.

use super::GaugedGear;
use crate::error::Error;
use crate::gauge::{PitchAxis, PitchReadings};
use crate::gear::Side;
use crate::render::chart::{BarSeries, Heading, LineAxes, LineSeries, Look, bars, lines};

/// The least height of an axis, µm: far below what a gauge in a shop tells, far above the rounding of readings.
const LEAST: f64 = 0.1;

/// One series: name, look and lengths in mm.
type Series = (&'static str, Look, Vec<f64>);

/// The charts of one gear: file name and SVG. What could not be measured has none.
///
/// # Errors
/// [`Error::Chart`]: none for a gear that has teeth.
pub fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, Error> {
    let read = &gauged.gauged;
    let formula = &read.formula;
    let mut files = Vec::new();
    let mut by_tooth = |name: &str, what: String, axes: [&str; 2], series: &[Series]| {
        let bars_of = |(name, look, lengths): &Series| BarSeries {
            name,
            values: lengths.iter().map(|mm| Some(mm * 1e3)).collect(),
            look: *look,
        };
        let (file, heading) = (
            format!("{}_{name}.svg", gauged.stem()),
            subtitle(gauged, &what),
        );
        let heading = Heading {
            prefix: &format!("{}_{name}", gauged.stem()),
            title: gauged.title,
            subtitle: &heading,
        };
        let series: Vec<BarSeries> = series.iter().map(bars_of).collect();
        files.push((file, bars(&heading, axes, &series)?.svg));
        Ok::<(), Error>(())
    };
    if let Ok(spans) = &read.spans {
        let lengths: Vec<f64> = spans.readings.iter().map(|span| span.length).collect();
        let mean = spans.mean();
        let what = format!("span W_{}, {}", spans.teeth, means(mean, formula.span));
        let axes = [
            "first tooth spanned",
            &format!("W_{} − mean, µm", spans.teeth),
        ];
        by_tooth(
            "spans",
            what,
            axes,
            &[("span", Look::Plain, less(&lengths, mean))],
        )?;
    }
    if let Ok(pins) = &read.pins {
        for (file, count, list, formula, axis) in [
            (
                "pins",
                "two",
                &pins.two,
                formula.over_two,
                "tooth before the first pin",
            ),
            (
                "three_pins",
                "three",
                &pins.three,
                formula.over_three,
                "tooth before the single pin",
            ),
        ] {
            if list.is_empty() {
                continue;
            }
            let lengths: Vec<f64> = list.iter().map(|over| over.length).collect();
            let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
            let what = format!(
                "M_dK over {count} pins {} mm, {}",
                pins.diameter,
                means(mean, formula)
            );
            by_tooth(
                file,
                what,
                [axis, "M_dK − mean, µm"],
                &[("over pins", Look::Plain, less(&lengths, mean))],
            )?;
        }
    }
    if let Ok(runout) = &read.runout {
        let what = format!(
            "ball {} mm in each space, F_r {:.3} µm, 2 e {:.3} µm",
            runout.diameter,
            1e3 * runout.total(),
            2e3 * read.eccentricity.amount
        );
        by_tooth(
            "runout",
            what,
            ["tooth before the ball", "radius of the ball − mean, µm"],
            &[("ball", Look::Plain, runout.deviations())],
        )?;
    }
    for pitch in [&read.pitch_own, &read.pitch_datum].into_iter().flatten() {
        let flanks = [
            (Side::Right, "right flanks", Look::Right),
            (Side::Left, "left flanks", Look::Left),
        ];
        by_tooth(
            &format!("pitch_{}", pitch.axis.name()),
            pitch_words(pitch),
            ["tooth", "cumulative pitch deviation F, µm"],
            &flanks.map(|(side, name, look)| (name, look, pitch.cumulative.flank(side).to_vec())),
        )?;
    }
    if let Ok(thickness) = &read.thickness {
        let what = format!(
            "arc thickness s at the reference circle, {}",
            means(thickness.mean(), Some(formula.thickness))
        );
        by_tooth(
            "thickness",
            what,
            ["tooth", "s − mean, µm"],
            &[("thickness", Look::Plain, thickness.deviations())],
        )?;
    }
    if let Ok(roll) = &read.roll {
        let mean = roll.mean();
        let steps = f64::from(roll.steps_per_pitch);
        let point = |(i, pose): (usize, &crate::gauge::RollPose)| {
            (1.0 + i as f64 / steps, Some(1e3 * (pose.distance - mean)))
        };
        let what = format!(
            "roll test F_i'' {:.2}, f_i'' {:.2} µm · {}",
            1e3 * roll.total().found,
            1e3 * roll.tooth_to_tooth().found,
            means(mean, formula.distance)
        );
        let heading = Heading {
            prefix: &format!("{}_roll", gauged.stem()),
            title: gauged.title,
            subtitle: &subtitle(gauged, &what),
        };
        let line = LineSeries {
            name: "a''",
            points: roll.poses.iter().enumerate().map(point).collect(),
            look: Look::Plain,
            dots: false,
        };
        let axes = LineAxes {
            x: "tooth of the gear at the master",
            teeth: Some(gauged.gear.gear().toothing().teeth()),
            y: "a'' − mean, µm",
            least: LEAST,
        };
        let chart = lines(&heading, axes, &[line])?;
        files.push((format!("{}_roll.svg", gauged.stem()), chart.svg));
    }
    Ok(files)
}

fn subtitle(gauged: &GaugedGear, what: &str) -> String {
    let material = match gauged.material {
        crate::study::Material::AsMeasured => String::new(),
        material => format!(", material {}", material.name()),
    };
    format!("{}{material} · {what}", gauged.name)
}

fn pitch_words(pitch: &PitchReadings) -> String {
    let both = |of: fn(&PitchReadings, Side) -> f64| {
        Side::BOTH
            .map(|side| format!("{:.3}", 1e3 * of(pitch, side)))
            .join(" / ")
    };
    format!(
        "pitch about {} · f_p {}, F_p {} µm (right / left)",
        match pitch.axis {
            PitchAxis::Own => "the gear's own centre",
            PitchAxis::Datum => "the rotation axis",
        },
        both(PitchReadings::greatest_single),
        both(PitchReadings::total),
    )
}

/// The mean, on which the chart's zero stands, and the formula's value.
fn means(mean: f64, formula: Option<f64>) -> String {
    let formula = formula.map_or(String::new(), |mm| format!(", formula {mm:.6} mm"));
    format!("mean {mean:.6} mm{formula}")
}

fn less(lengths: &[f64], mean: f64) -> Vec<f64> {
    lengths.iter().map(|length| length - mean).collect()
}
