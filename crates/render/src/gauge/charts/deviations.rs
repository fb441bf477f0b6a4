//! Runout and pitch, with the lines of their accuracy grades.

use super::bars::{LEVEL, bars};
use crate::chart::{BarPanel, BarSeries, Limits, Look};
use crate::error::PictureError;
use gearlash::gauge::{GradedReading, PitchAxis, PitchReadings, RunoutReadings};
use gearlash::gear::{Grade, GradedQuantity, Side};
use gearlash_files::numbers::{rounded, um};
use gearlash_files::results::gauge::{GaugedGear, Reading};

pub(super) fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let read = &gauged.gauged;
    let mut files = Vec::new();
    if let Ok(read) = &read.runout {
        files.push(runout(gauged, read)?);
    }
    for (name, read) in [
        (Reading::PitchOwn, &read.pitch_own),
        (Reading::PitchDatum, &read.pitch_datum),
    ] {
        if let Ok(read) = read {
            files.push(pitch(gauged, name, read)?);
        }
    }
    Ok(files)
}

fn runout(gauged: &GaugedGear, read: &RunoutReadings) -> Result<(String, String), PictureError> {
    let title = format!(
        "ball {} mm in each space · F_r {} µm, 2 e {} µm",
        read.diameter,
        um(read.total(), 3),
        um(2.0 * gauged.gauged.eccentricity.amount, 3)
    );
    let series = [series("ball", &read.deviations(), Look::Plain)];
    let panel = BarPanel {
        title: &title,
        y_axis: "radius − mean, µm",
        series: &series,
        limits: coarsest(gauged, GradedQuantity::Runout, None)
            .map(|graded| range(&graded, read.ends().map(|end| end - read.mean())))
            .into_iter()
            .collect(),
        level: LEVEL,
    };
    bars(gauged, Reading::Runout, "tooth before the ball", &[panel])
}

/// Single pitch above cumulative pitch.
fn pitch(
    gauged: &GaugedGear,
    reading: Reading,
    read: &PitchReadings,
) -> Result<(String, String), PictureError> {
    let about = match read.axis {
        PitchAxis::Own => "the gear's own centre",
        PitchAxis::Datum => "the rotation axis",
    };
    let both = |of: fn(&PitchReadings, Side) -> f64| {
        Side::BOTH.map(|side| um(of(read, side), 3)).join(" / ")
    };
    let graded = |quantity| coarsest(gauged, quantity, Some(read.axis));
    let total = graded(GradedQuantity::TotalPitch).map_or(String::new(), |graded| {
        format!(", F_p {}", tolerance(&graded).1)
    });
    let titles = [
        format!(
            "single pitch deviation about {about} · f_p {} µm (right / left)",
            both(PitchReadings::greatest_single)
        ),
        format!(
            "cumulative pitch deviation about {about} · F_p {} µm (right / left){total}",
            both(PitchReadings::total)
        ),
    ];
    let flanks = |values: fn(&PitchReadings, Side) -> Vec<f64>| {
        [
            (Side::Right, "right flanks", Look::Right),
            (Side::Left, "left flanks", Look::Left),
        ]
        .map(|(side, name, look)| series(name, &values(read, side), look))
    };
    let single = flanks(PitchReadings::single);
    let cumulative = flanks(|read, side| read.cumulative.flank(side).to_vec());
    let panels = [
        BarPanel {
            title: &titles[0],
            y_axis: "f from the mean pitch, µm",
            series: &single,
            limits: graded(GradedQuantity::SinglePitch)
                .map(|graded| {
                    let (tolerance, name) = tolerance(&graded);
                    Limits {
                        values: [-tolerance, tolerance],
                        name: format!("f_p {name}"),
                    }
                })
                .into_iter()
                .collect(),
            level: LEVEL,
        },
        BarPanel {
            title: &titles[1],
            y_axis: "F − mean of the flank, µm",
            series: &cumulative,
            // A range of each flank, which stand at different heights: the title has its tolerance.
            limits: Vec::new(),
            level: LEVEL,
        },
    ];
    let x_axis = "tooth · + along ascending numbers";
    bars(gauged, reading, x_axis, &panels)
}

/// The greatest reading of `quantity` about `axis`: of both flanks that with the coarser grade.
fn coarsest(
    gauged: &GaugedGear,
    quantity: GradedQuantity,
    axis: Option<PitchAxis>,
) -> Option<GradedReading> {
    let grades = gauged.gauged.grades.as_ref().ok()?;
    let of = grades
        .iter()
        .copied()
        .filter(|one| one.quantity == quantity && one.pitch.map(|(axis, _)| axis) == axis);
    of.reduce(|one, other| match other.measured > one.measured {
        true => other,
        false => one,
    })
}

/// Tolerance, µm, and what to call it.
fn tolerance(graded: &GradedReading) -> (f64, String) {
    match graded.grade {
        Grade::Within { grade, tolerance } => (
            1e3 * tolerance,
            format!("grade {grade}, {} µm", rounded(1e3 * tolerance, 1)),
        ),
        Grade::Beyond { last, tolerance } => (
            1e3 * tolerance,
            format!("beyond grade {last}, {} µm", rounded(1e3 * tolerance, 1)),
        ),
    }
}

/// The tolerance of a range, laid about the middle of `ends`, mm.
fn range(graded: &GradedReading, [least, most]: [f64; 2]) -> Limits {
    let (tolerance, name) = tolerance(graded);
    let middle = 0.5e3 * (least + most);
    Limits {
        values: [middle - 0.5 * tolerance, middle + 0.5 * tolerance],
        name: format!("{} {name}", graded.quantity.symbol()),
    }
}

fn series<'a>(name: &'a str, lengths: &[f64], look: Look) -> BarSeries<'a> {
    BarSeries {
        name,
        values: lengths.iter().map(|mm| Some(mm * 1e3)).collect(),
        look,
    }
}
