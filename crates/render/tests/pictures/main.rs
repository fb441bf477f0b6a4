//! Charts, snapshots and the scene they are drawn from: marks stand where the data are, texts keep clear, and any reader shows them.

mod altered;
mod bars;
mod clear;
mod curves;
#[path = "../../../../tests/common/design.rs"]
mod design;
mod drawn;
mod envelope;
mod field;
mod inspection;
mod places;
mod posed;
mod scene;
mod snapshots;
#[path = "../../../../tests/common/two_thick_teeth.rs"]
mod two_thick_teeth;

use drawn::Picture;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::{
    Course, Followed, OverDistance, courses, over_distance, revolution, with_sweep,
};
use gearlash::analysis::study::Study;
use gearlash::contact::Method;
use gearlash::error::go_on as on;
use gearlash::gear::Inspection;
use gearlash::pair::{BacklashUnit, SweepPlan};
use gearlash_render::chart::{self, Chart, Heading};
use std::path::Path;
use std::sync::LazyLock;

const UM: BacklashUnit = BacklashUnit::Um;

/// Certificates are tested elsewhere.
const METHOD: Method = Method::Exact { certify: false };

fn study(fixture: &str) -> Study {
    let fixtures = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures"));
    gearlash_input::read(&fixtures.join(fixture)).unwrap().study
}

fn study_of(text: &str) -> Study {
    let read = gearlash_input::read_text(Path::new("pair.toml"), text);
    read.unwrap().study
}

fn revolved(study: &Study) -> Vec<ComparedRun> {
    revolution(study, METHOD, &on).unwrap()
}

fn first_course(study: &Study) -> Course {
    courses(&revolved(study)).remove(0)
}

/// A sweep over `pitches` from teeth 1, 1 on.
fn over_pitches(mut study: Study, pitches: u64, steps_per_pitch: u32) -> Study {
    study.sweep = Some(SweepPlan::Revolution {
        pitches,
        steps_per_pitch,
        start: (1, 1),
    });
    study
}

fn course(fixture: &str, center_distance: f64) -> Course {
    let study = with_sweep(study(fixture)).at(vec![center_distance]);
    first_course(&study.unwrap())
}

fn over(study: &Study, wheel: u32, pinion: u32) -> OverDistance {
    let teeth = Followed::Teeth(wheel, pinion);
    over_distance(study, teeth, &[], METHOD, &on).unwrap()
}

fn heading<'h>(prefix: &'h str, title: &'h str) -> Heading<'h> {
    Heading {
        prefix,
        title,
        subtitle: "",
    }
}

/// The chart of a course, and what is drawn there.
fn of_course(course: &Course) -> (Chart, Picture) {
    let chart = chart::revolution(UM, &heading("r", "t"), course);
    let picture = Picture::of(&chart.svg);
    (chart, picture)
}

/// The chart of a course's differences, and what is drawn there.
fn of_difference(course: &Course) -> (Chart, Picture) {
    let chart = chart::difference(&heading("d", "t"), course, 0.1).unwrap();
    let picture = Picture::of(&chart.svg);
    (chart, picture)
}

const TITLE: &str = "A < B & \"C\" <script>alert('1')</script> ]]> \u{1}\u{ffff}";

/// Every kind once, of pairs that are clear, interfere and jam, with a title that is no XML.
static ALL_KINDS: LazyLock<Vec<Chart>> = LazyLock::new(|| {
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
        charts.push(Ok(chart::revolution(UM, &heading("r", TITLE), &course)));
        if course.least.is_some() {
            charts.push(chart::difference(&heading("d", TITLE), &course, 0.1));
        }
    }
    for (_, wheel, pinion) in &study("karba_44x44_pitch.toml").materials {
        for (name, gear) in [("wheel", wheel), ("pinion", pinion)] {
            let inspection = Inspection::of(gear);
            charts.push(chart::inspection(&heading("i", TITLE), name, &inspection));
        }
    }
    for (fixture, wheel, pinion) in [("karba_44x44.toml", 44, 44), ("karba_86x21.toml", 1, 1)] {
        let over = over(&study(fixture), wheel, pinion);
        charts.push(chart::distance(UM, &heading("a", TITLE), &over, &[]));
    }
    charts.into_iter().map(Result::unwrap).collect()
});
