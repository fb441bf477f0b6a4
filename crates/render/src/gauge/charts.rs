//! Charts of the readings, one per gauge: each tooth's reading less the mean.
//!
//! Each chart names its gear, the numbering of its teeth and the place of its zero. Where there is an accuracy grade, lines show
//! the range of that grade.

use crate::chart::{
    BarPanel, BarSeries, Heading, Limits, Look, PictureError, bar_panels, curve, leads, profiles,
};
use gearlash::gauge::{GradedReading, PitchReadings, Roll, RollPose, RunoutReadings};
use gearlash::gear::{Flank, Grade, GradedQuantity, Pitch, PitchAxis};
use gearlash_results::gauge::{ByTooth, Chart, GaugedGear, Length, lengths, page_name};
use gearlash_text::characters::plain;
use gearlash_text::numbers::{fixed, rounded, um};
use maud::{DOCTYPE, PreEscaped, html};

/// Values below this, µm, count as level: far below the resolution of a gauge in a shop, far above the rounding of readings.
const LEVEL: f64 = 1e-3;
/// Least height of an axis, µm.
const LEAST: f64 = 100.0 * LEVEL;
/// The numbering of teeth and the direction of a chart.
const NUMBERS: &str = "numbers ascend clockwise on the reference face";

/// The charts of one gear: file name and SVG. Readings that were not taken or deviate nowhere have none.
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let read = &gauged.gauged;
    let mut files: Vec<File> = Vec::new();
    for length in lengths(gauged) {
        let by_tooth = length.by_tooth.iter();
        files.extend(by_tooth.map(|by_tooth| length_chart(gauged, &length, by_tooth)));
    }
    files.extend(read.runout.iter().map(|read| runout(gauged, read)));
    for (chart, read) in [
        (Chart::PITCH_OWN, &read.pitch_own),
        (Chart::PITCH_DATUM, &read.pitch_datum),
    ] {
        files.extend(read.iter().map(|read| pitch(gauged, chart, read)));
    }
    let profile = read.profile.iter().filter(|read| read.deviates());
    files.extend(
        profile.map(|read| file(gauged, Chart::PROFILE, |heading| profiles(heading, read))),
    );
    // About the axis of the teeth, and about the rotation axis where they differ.
    let along_face = read.along_face.iter().flat_map(|found| found.leads());
    files.extend(along_face.map(|read| {
        let chart = match read.axis {
            PitchAxis::Own => Chart::LEAD_OWN,
            PitchAxis::Datum => Chart::LEAD_DATUM,
        };
        file(gauged, chart, |heading| leads(heading, read))
    }));
    files.extend(read.roll.iter().map(|roll| roll_chart(gauged, roll)));
    files.into_iter().filter_map(Result::transpose).collect()
}

/// The charts of one gear on one page: file name and HTML; `None` without charts.
///
/// # Errors
/// As [`charts`].
pub fn page(gauged: &GaugedGear) -> Result<Option<(String, String)>, PictureError> {
    let charts = charts(gauged)?;
    if charts.is_empty() {
        return Ok(None);
    }
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { (plain(gauged.title)) ", " (gauged.words()) }
                style { "body{max-width:60rem;margin:auto}svg{width:100%;height:auto;break-inside:avoid}" }
            }
            body { @for (_, chart) in &charts { (PreEscaped(chart)) } }
        }
    };
    Ok(Some((page_name(&gauged.stem()), page.into_string())))
}

/// File name and SVG of a chart; `None` where nothing would be visible.
type File = Result<Option<(String, String)>, PictureError>;

fn bars(gauged: &GaugedGear, chart: Chart, x_axis: &str, panels: &[BarPanel]) -> File {
    let series = panels.iter().flat_map(|panel| panel.series);
    let mut values = series.flat_map(|bars| &bars.values).flatten();
    if values.all(|um| um.abs() < LEVEL) {
        return Ok(None);
    }
    let x_axis = format!("{x_axis} · {NUMBERS}");
    file(gauged, chart, |heading| {
        bar_panels(heading, "", &x_axis, panels)
    })
}

fn file(
    gauged: &GaugedGear,
    chart: Chart,
    draw: impl FnOnce(&Heading) -> Result<crate::chart::Chart, PictureError>,
) -> File {
    let stem = gauged.stem();
    let drawn = draw(&Heading {
        prefix: &chart.file_stem(&stem),
        title: gauged.title,
        subtitle: &subtitle(gauged),
    })?;
    Ok(Some((chart.svg(&stem), drawn.svg)))
}

fn subtitle(gauged: &GaugedGear) -> String {
    let Some((gear, _)) = gauged.data else {
        return gauged.words();
    };
    let design = gear.gear().design();
    let (basic_data, shift) = (&design.basic_data, design.profile_shift);
    // Degrees do not convert exactly.
    let degrees = rounded(basic_data.pressure_angle().to_degrees(), 9);
    format!(
        "{} · z {}, m {} mm, α {degrees}°{}, x {shift} · {}",
        gauged.name,
        basic_data.teeth(),
        basic_data.module(),
        gauged.helix(),
        gauged.material.words(),
    )
}

/// The mean, which is the chart's zero, and the formula's value.
fn mean_words(mean: f64, formula: Option<f64>) -> String {
    let formula = formula.map_or(String::new(), |mm| format!(", formula {} mm", fixed(mm, 6)));
    format!("mean {} mm{formula}", fixed(mean, 6))
}

/// Spans, dimensions over pins and thickness: each reading less the mean.
fn length_chart(gauged: &GaugedGear, length: &Length, by_tooth: &ByTooth) -> File {
    let values = by_tooth.values.iter();
    let less = values.map(|mm| Some((mm - length.readings.mean) * 1e3));
    let series = [BarSeries {
        name: "reading",
        values: less.collect(),
        look: Look::Plain,
    }];
    let mean = mean_words(length.readings.mean, length.formula);
    let panel = BarPanel {
        title: &format!("{}, {mean}", length.name),
        y_axis: &format!("{} − mean, µm", by_tooth.symbol),
        series: &series,
        limits: None,
        level: LEVEL,
    };
    bars(gauged, by_tooth.chart, by_tooth.tooth, &[panel])
}

fn runout(gauged: &GaugedGear, read: &RunoutReadings) -> File {
    let eccentricity = gauged.gauged.eccentricity.as_ref().ok();
    let title = format!(
        "ball {} mm in each space · F_r {} µm, 2 e {} µm",
        read.diameter,
        um(read.total(), 3),
        um(eccentricity.map(|found| 2.0 * found.amount), 3)
    );
    let series = [BarSeries::of_mm("ball", &read.deviations(), Look::Plain)];
    let radii = read.radii();
    let ends = radii.ends.map(|end| end - radii.mean);
    let graded = coarsest(gauged, GradedQuantity::Runout, None);
    let limits = graded.map(|graded| range(&graded, ends));
    let panel = BarPanel {
        title: &title,
        y_axis: "radius − mean, µm",
        series: &series,
        limits,
        level: LEVEL,
    };
    bars(gauged, Chart::RUNOUT, "tooth before the ball", &[panel])
}

/// Single pitch above cumulative pitch.
fn pitch(gauged: &GaugedGear, chart: Chart, read: &PitchReadings) -> File {
    let about = match read.axis {
        PitchAxis::Own => "the gear's own centre",
        PitchAxis::Datum => "the rotation axis",
    };
    let pitch = &read.cumulative;
    let both =
        |of: fn(&Pitch, Flank) -> f64| Flank::BOTH.map(|side| um(of(pitch, side), 3)).join(" / ");
    let graded = |quantity| coarsest(gauged, quantity, Some(read.axis));
    let total = graded(GradedQuantity::TotalPitch).map_or(String::new(), |graded| {
        format!(", F_p {}", tolerance(&graded).1)
    });
    let titles = [
        format!(
            "single pitch deviation about {about} · f_p {} µm (right / left)",
            both(Pitch::greatest_single)
        ),
        format!(
            "cumulative pitch deviation about {about} · F_p {} µm (right / left){total}",
            both(Pitch::total)
        ),
    ];
    let single = BarSeries::of_flanks(|side| pitch.single(side));
    let cumulative = BarSeries::of_flanks(|side| pitch.flank(side).to_vec());
    let limits = graded(GradedQuantity::SinglePitch).map(|graded| {
        let (tolerance, name) = tolerance(&graded);
        Limits {
            values: [-tolerance, tolerance],
            name: format!("f_p {name}"),
        }
    });
    let panels = [
        BarPanel {
            title: &titles[0],
            y_axis: "f from the mean pitch, µm",
            series: &single,
            limits,
            level: LEVEL,
        },
        BarPanel {
            title: &titles[1],
            y_axis: "F − mean of the flank, µm",
            series: &cumulative,
            // The ranges of the flanks have different middles, so the title states the tolerance.
            limits: None,
            level: LEVEL,
        },
    ];
    let x_axis = "tooth · + along ascending numbers";
    bars(gauged, chart, x_axis, &panels)
}

/// The greatest reading of `quantity` about `axis`; of both flanks the one with the coarser grade.
fn coarsest(
    gauged: &GaugedGear,
    quantity: GradedQuantity,
    axis: Option<PitchAxis>,
) -> Option<GradedReading> {
    let grades = gauged.gauged.grades.as_ref().ok()?;
    let is_of =
        |one: &GradedReading| one.quantity == quantity && one.pitch.map(|(axis, _)| axis) == axis;
    grades.iter().copied().filter(is_of).reduce(|one, other| {
        if other.measured > one.measured {
            other
        } else {
            one
        }
    })
}

/// Tolerance, µm, and its name.
fn tolerance(graded: &GradedReading) -> (f64, String) {
    let Grade {
        grade,
        tolerance,
        admits,
    } = graded.grade;
    let beyond = if admits { "" } else { "beyond " };
    let um = 1e3 * tolerance;
    (um, format!("{beyond}grade {grade}, {} µm", rounded(um, 1)))
}

/// The tolerance of a range, centred between `ends`, mm.
fn range(graded: &GradedReading, [least, most]: [f64; 2]) -> Limits {
    let (tolerance, name) = tolerance(graded);
    let middle = 0.5e3 * (least + most);
    Limits {
        values: [middle - 0.5 * tolerance, middle + 0.5 * tolerance],
        name: format!("{} {name}", graded.quantity.symbol()),
    }
}

/// The double-flank roll test as a curve over one revolution.
fn roll_chart(gauged: &GaugedGear, roll: &Roll) -> File {
    let mean = roll.distances().mean;
    let teeth = gauged.teeth;
    let value = |pose: &RollPose| Some(1e3 * (pose.distance - mean));
    let place = |pose: &RollPose| f64::from(pose.mating.wheel_tooth) + pose.mating.fraction;
    let poses = roll.poses.iter().chain(&roll.between);
    let points = poses.map(|pose| (place(pose), value(pose)));
    let mut points: Vec<(f64, Option<f64>)> = points.collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The first pose again, to close the revolution.
    let first = points.first().and_then(|point| point.1);
    points.push((f64::from(teeth) + 1.0, first));
    let level = |point: &(f64, Option<f64>)| point.1.is_none_or(|um| um.abs() < LEVEL);
    if points.iter().all(level) {
        return Ok(None);
    }
    let title = format!(
        "roll test with a master of z {} · F_i'' {}, f_i'' {} µm · {}",
        roll.master.basic_data().teeth(),
        um(roll.total.found, 3),
        um(roll.tooth_to_tooth.found, 3),
        mean_words(mean, gauged.gauged.formula.distance)
    );
    let x = format!("tooth of the gear at the master, one revolution back to 1 · {NUMBERS}");
    let titles = [&title[..], &x, "a'' − mean, µm"];
    file(gauged, Chart::ROLL, |heading| {
        curve(heading, titles, teeth, LEAST, points)
    })
}
