//! The results as the script reads them: a column a quantity, an entry a pose.

use super::contacts::{Contacts, touching};
use super::precision::{Precision, degrees};
use super::readout;
use super::section::{self, HelicalColumns};
use super::viewed::{Viewed, gears};
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::{Course, CourseLine};
use gearlash::analysis::study::Study;
use gearlash::contact::{LostMotion, PoseResult, Status};
use gearlash::gear::{AsBuilt, Side};
use gearlash::pair::Member;
use gearlash_files::numbers::{rounded, two_digits_up};
use serde::Serialize;

/// All runs.
#[derive(Serialize)]
pub struct Columns {
    free: &'static str,
    /// What the contacts' classes count.
    classes: Vec<String>,
    /// What each run's statuses counts.
    statuses: [&'static str; 5],
    runs: Vec<RunColumns>,
    /// Run and pose shown first.
    start: [usize; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    helical: Option<HelicalColumns>,
}

impl Columns {
    /// The columns of `runs`, first shown at `start`: a run and a pose of those viewed.
    pub fn new(
        study: &Study,
        runs: &[Viewed],
        charts: &[(&str, &Course)],
        start: [usize; 2],
        outlines: &[[&AsBuilt; 2]],
        precision: Precision,
    ) -> Columns {
        let mut classes = Vec::new();
        let helical = runs.get(start[0]).and_then(|first| {
            let pose = first.poses().nth(start[1])?;
            HelicalColumns::of(&first.shown.run.run.assembly, &pose.simulated)
        });
        let runs = runs
            .iter()
            .map(|viewed| RunColumns::new(viewed, charts, outlines, precision, &mut classes));
        Columns {
            free: study.locked.mate().name(),
            runs: runs.collect(),
            classes,
            statuses: Status::ALL.map(Status::name),
            start,
            helical,
        }
    }
}

/// Which of the `outlines` `run` has.
pub fn outline_of(outlines: &[[&AsBuilt; 2]], run: &ComparedRun) -> usize {
    let gears = gears(run);
    let own = |own: &[&AsBuilt; 2]| Some(*own) == gears;
    outlines.iter().position(own).unwrap_or(0)
}

/// Where the free gear is drawn first: in right-flank contact, or else at its nominal rotation.
pub fn free_rotation(pose: &PoseResult) -> f64 {
    touching(pose, Side::Right).map_or(pose.pose.free_rotation(), |contact| contact.rotation)
}

/// What the script knows of a run.
#[derive(Serialize)]
pub struct RunColumns {
    label: String,
    center_distance_mm: f64,
    /// Which of the outlines.
    outlines: usize,
    pitch_radius_mm: [f64; 2],
    /// How many poses the run has.
    of: usize,
    /// Which of them these are, from 1; none: all.
    number: Option<Vec<usize>>,
    /// Id of the chart, and each pose's place on its horizontal axis.
    chart: Option<String>,
    chart_x: Vec<Option<f64>>,
    mating: [Vec<u32>; 2],
    left_flank: Vec<u8>,
    fraction: Vec<f64>,
    locked_deg: Vec<f64>,
    /// The free gear at right-flank contact; its nominal rotation where there is no lost motion.
    free_deg: Vec<f64>,
    lost_motion_deg: Vec<Option<f64>>,
    j_wt_um: Vec<Option<f64>>,
    error_bound_um: Vec<Option<f64>>,
    status: Vec<usize>,
    right: Contacts,
    left: Contacts,
    /// Of helical gears, where along the face these are.
    #[serde(skip_serializing_if = "Option::is_none")]
    section_mm: Option<[Vec<Option<f64>>; 2]>,
}

impl RunColumns {
    /// The columns of `viewed`. Classes of contact that are not in `classes` yet are added there.
    pub fn new(
        viewed: &Viewed,
        charts: &[(&str, &Course)],
        outlines: &[[&AsBuilt; 2]],
        precision: Precision,
        classes: &mut Vec<String>,
    ) -> RunColumns {
        let run = viewed.shown.run;
        let assembly = &run.run.assembly;
        let poses = || viewed.poses().map(|pose| &pose.simulated);
        let mating = |member| {
            poses()
                .map(|pose| pose.pose.mating().tooth(member))
                .collect()
        };
        let [right, left] =
            Side::BOTH.map(|side| Contacts::of(assembly, side, poses(), precision, classes));
        let a = assembly.center_distance();
        let is_of = |course: &Course| {
            let is_phase = viewed.shown.is_beyond || course.phase == run.run.phase;
            is_phase && course.center_distance == a
        };
        let mut drawn = charts.iter().filter(|(_, course)| is_of(course));
        let drawn = drawn.find_map(|(id, course)| {
            let places = places(run, course);
            let any = places.iter().any(Option::is_some);
            any.then(|| ((*id).to_owned(), places))
        });
        let (chart, places) = drawn.unzip();
        let places = places.unwrap_or_default();
        let place = |number: &usize| places.get(*number).copied().flatten();
        let all = viewed.numbers.len() == run.poses.len();
        RunColumns {
            label: readout::run(&viewed.shown),
            center_distance_mm: assembly.center_distance(),
            outlines: outline_of(outlines, run),
            pitch_radius_mm: Member::BOTH
                .map(|member| rounded(assembly.operating_pitch_radius(member), precision.decimals)),
            of: run.poses.len(),
            number: (!all).then(|| viewed.numbers.iter().map(|number| number + 1).collect()),
            chart,
            chart_x: viewed.numbers.iter().map(place).collect(),
            mating: Member::BOTH.map(mating),
            left_flank: poses().map(|pose| u8::from(is_left(pose))).collect(),
            fraction: poses()
                .map(|pose| rounded(pose.pose.mating().fraction, 6))
                .collect(),
            locked_deg: poses()
                .map(|pose| degrees(pose.pose.locked_rotation()))
                .collect(),
            free_deg: poses().map(|pose| degrees(free_rotation(pose))).collect(),
            lost_motion_deg: poses()
                .map(|pose| pose.proven().and_then(LostMotion::angle).map(degrees))
                .collect(),
            j_wt_um: poses().map(|pose| pose.backlash.map(|j| j * 1e3)).collect(),
            error_bound_um: poses()
                .map(|pose| pose.error_bound.map(|bound| two_digits_up(bound * 1e3)))
                .collect(),
            status: poses().map(|pose| pose.status() as usize).collect(),
            right,
            left,
            section_mm: section::sections(assembly, poses()),
        }
    }
}

/// Each pose's place in the curves of `course`, which go through the poses of a flank in their order; none for a pose that has no
/// point there.
fn places(run: &ComparedRun, course: &Course) -> Vec<Option<f64>> {
    let mut lines = Side::BOTH.map(|flank| {
        let of_run =
            move |line: &&CourseLine| (line.material, line.flank) == (run.run.material, flank);
        let lines = course.lines.iter().filter(of_run);
        lines.flat_map(|line| &line.points)
    });
    let poses = run.poses.iter();
    poses
        .map(|pose| {
            let mating = pose.simulated.pose.mating();
            let line = &mut lines[usize::from(is_left(&pose.simulated))];
            let point = line.find(|point| point.mating == *mating)?;
            Some(rounded(point.x, 6))
        })
        .collect()
}

fn is_left(pose: &PoseResult) -> bool {
    pose.pose.mating().flank == Side::Left
}
