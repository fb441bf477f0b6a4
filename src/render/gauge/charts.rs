//! The readings as charts, one a gauge: what each tooth reads less the mean.

use super::GaugedGear;
use crate::error::Error;
use crate::gauge::PitchReadings;
use crate::gear::Side;
use crate::render::chart::{BarSeries, Heading, LineSeries, Look, bars, lines};

/// The charts of one gear: file name and SVG. What could not be measured has none.
///
/// # Errors
/// [`Error::Chart`]: none for a gear that has teeth.
pub fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, Error> {
    let read = &gauged.gauged;
    let mut files = Vec::new();
    let mut by_tooth = |name: &str, what: String, series: &[(&'static str, Look, Vec<f64>)]| {
        let bars_of = |(name, look, lengths): &(&'static str, Look, Vec<f64>)| BarSeries {
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
        files.push((file, bars(&heading, "µm", &series)?.svg));
        Ok::<(), Error>(())
    };
    if let Ok(spans) = &read.spans {
        let lengths: Vec<f64> = spans.readings.iter().map(|span| span.length).collect();
        let what = format!(
            "span W_{} from each first tooth, less the mean {:.6} mm",
            spans.teeth,
            spans.mean()
        );
        by_tooth(
            "spans",
            what,
            &[("span", Look::Plain, less(&lengths, spans.mean()))],
        )?;
    }
    if let Ok(pins) = &read.pins {
        let mean = pins.mean();
        let lengths: Vec<f64> = pins.two.iter().map(|over| over.length).collect();
        let what = format!(
            "M_dK over two pins {} mm, less the mean {mean:.6} mm",
            pins.diameter
        );
        by_tooth(
            "pins",
            what,
            &[("over two pins", Look::Plain, less(&lengths, mean))],
        )?;
    }
    if let Ok(runout) = &read.runout {
        let what = format!(
            "ball {} mm after each tooth, less the mean · F_r {:.3} µm",
            runout.diameter,
            1e3 * runout.total()
        );
        by_tooth(
            "runout",
            what,
            &[("ball", Look::Plain, runout.deviations())],
        )?;
    }
    for pitch in [&read.pitch_own, &read.pitch_datum].into_iter().flatten() {
        let flanks = [
            (
                "right flanks",
                Look::Right,
                pitch.cumulative.flank(Side::Right).to_vec(),
            ),
            (
                "left flanks",
                Look::Left,
                pitch.cumulative.flank(Side::Left).to_vec(),
            ),
        ];
        by_tooth(
            &format!("pitch_{}", pitch.axis.name()),
            pitch_words(pitch),
            &flanks,
        )?;
    }
    if let Ok(thickness) = &read.thickness {
        let what = format!(
            "arc thickness at the reference circle, less the mean {:.6} mm",
            thickness.mean()
        );
        by_tooth(
            "thickness",
            what,
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
            "double-flank roll test, a'' less the mean {mean:.6} mm · F_i'' {:.3} µm, f_i'' {:.3} µm",
            1e3 * roll.total(),
            1e3 * roll.tooth_to_tooth()
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
        let axis = "tooth of the gear at the master";
        let chart = lines(&heading, axis, "µm", &[line])?;
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
        "cumulative pitch F about the {} axis · f_p {}, F_p {} µm (right / left)",
        pitch.axis.name(),
        both(PitchReadings::greatest_single),
        both(PitchReadings::total),
    )
}

fn less(lengths: &[f64], mean: f64) -> Vec<f64> {
    lengths.iter().map(|length| length - mean).collect()
}
