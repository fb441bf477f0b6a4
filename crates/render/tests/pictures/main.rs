//! Charts: that they are valid, that marks stand where the data are, and the `chart` command.

mod bars;
mod curves;
mod drawn;
mod empty;
mod envelope;
mod field;
mod inspection;
mod labels;
mod one_assembly;
mod places;
mod texts;
#[path = "../../../../tests/common/two_thick_teeth.rs"]
mod two_thick_teeth;

use gearlash::analysis::curves::{
    Course, Followed, OverDistance, courses, over_distance, revolution, with_sweep,
};
use gearlash::analysis::study::Study;
use gearlash::contact::Method;
use gearlash::gear::{Inspection, Side};
use gearlash_render::chart::{self, Chart, Heading};
use std::ops::ControlFlow;
use std::path::Path;

/// Certificates are tested elsewhere.
const METHOD: Method = Method::Exact { certify: false };

fn study(fixture: &str) -> Study {
    let fixtures = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures"));
    gearlash_files::read(&fixtures.join(fixture)).unwrap().study
}

fn course(fixture: &str, center_distance: f64) -> Course {
    let study = with_sweep(study(fixture))
        .at(vec![center_distance])
        .unwrap();
    let runs = revolution(&study, METHOD, &|| ControlFlow::Continue(())).unwrap();
    courses(&runs).remove(0)
}

fn over(fixture: &str, (wheel, pinion): (u32, u32)) -> OverDistance {
    let tick = || ControlFlow::Continue(());
    let teeth = Followed::Teeth(wheel, pinion);
    over_distance(&study(fixture), teeth, &[], METHOD, &tick).unwrap()
}

fn heading<'h>(prefix: &'h str, title: &'h str) -> Heading<'h> {
    Heading {
        prefix,
        title,
        subtitle: "",
    }
}

/// Every kind once, of pairs that are clear, interfere and jam, with a title that is no XML.
fn all_kinds(title: &str) -> Vec<Chart> {
    let pitch = study("karba_44x44_pitch.toml");
    let mut charts = Vec::new();
    for (fixture, a) in [
        ("karba_44x44.toml", 132.21),
        ("karba_44x44_pitch.toml", 132.0),
        ("karba_86x21.toml", 160.47),
        // Partly and wholly jammed.
        ("tip_on_fillet_86x21.toml", 159.72),
        ("tip_on_fillet_86x21.toml", 159.6),
    ] {
        let course = course(fixture, a);
        charts.push(chart::revolution(&heading("r", title), &course).unwrap());
        if course.least.is_some() {
            charts.push(chart::difference(&heading("d", title), &course, 0.1).unwrap());
        }
    }
    for (_, wheel, pinion) in &pitch.materials {
        for (name, gear) in [("wheel", wheel), ("pinion", pinion)] {
            let inspection = Inspection::of(gear);
            charts.push(chart::inspection(&heading("i", title), name, &inspection).unwrap());
        }
    }
    charts.push(
        chart::distance(
            &heading("a", title),
            &over("karba_44x44.toml", (44, 44)),
            &[],
        )
        .unwrap(),
    );
    charts.push(
        chart::distance(&heading("a", title), &over("karba_86x21.toml", (1, 1)), &[]).unwrap(),
    );
    charts
}

fn simulated(course: &Course, flank: Side) -> Vec<Vec<(f64, f64)>> {
    let lines = course.lines.iter().filter(|line| line.flank == flank);
    let points = lines.map(|line| {
        let points = line.points.iter();
        points.map(|point| (point.x, point.simulated_um.unwrap()))
    });
    points.map(Iterator::collect).collect()
}
