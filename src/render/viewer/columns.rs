//! The results as the script reads them: a column a quantity, an entry a pose.

use super::precision::{Precision, rounded, two_digits_up};
use super::readout;
use crate::compare::{ComparedPose, ComparedRun};
use crate::curves::{Course, CourseLine};
use crate::gear::Side;
use crate::mesh::{Contact, Status, SweptPose};
use crate::pair::{Assembly, Member};
use crate::study::Study;
use serde::Serialize;

/// Decimals of a rotation in degrees: 2 nm at a radius of 130 mm.
pub const DEGREES: usize = 6;
/// Decimals of a normal's direction in degrees: 0.1 µm along the longest line drawn at module 3.
pub const NORMAL: usize = 3;

const STATUSES: [Status; 4] = [
    Status::Clear,
    Status::Interference,
    Status::Jammed,
    Status::NoContact,
];

/// All runs.
#[derive(Serialize)]
pub struct Columns {
    free: &'static str,
    /// What [`Contacts::class`] counts.
    classes: Vec<String>,
    /// What [`RunColumns::status`] counts.
    statuses: [&'static str; 4],
    runs: Vec<RunColumns>,
    /// Run and pose shown first.
    start: [usize; 2],
}

#[derive(Serialize)]
struct RunColumns {
    label: String,
    center_distance_mm: f64,
    /// Which of the outlines.
    outlines: usize,
    pitch_radius_mm: [f64; 2],
    /// Id of the chart, and each pose's place on its horizontal axis.
    chart: Option<String>,
    chart_x: Vec<f64>,
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
}

#[derive(Default, Serialize)]
struct Contacts {
    wheel: Vec<Option<u32>>,
    pinion: Vec<Option<u32>>,
    class: Vec<Option<usize>>,
    x_mm: Vec<Option<f64>>,
    y_mm: Vec<Option<f64>>,
    normal_deg: Vec<Option<f64>>,
}

impl Columns {
    /// The columns of `runs`, first shown at `start`.
    pub fn new(
        study: &Study,
        runs: &[ComparedRun],
        charts: &[(&str, &Course)],
        start: [usize; 2],
        precision: Precision,
    ) -> Columns {
        let mut classes = Vec::new();
        let runs = runs
            .iter()
            .map(|run| RunColumns::new(study, run, charts, precision, &mut classes));
        Columns {
            free: study.locked.mate().name(),
            runs: runs.collect(),
            classes,
            statuses: STATUSES.map(Status::name),
            start,
        }
    }
}

impl RunColumns {
    fn new(
        study: &Study,
        run: &ComparedRun,
        charts: &[(&str, &Course)],
        precision: Precision,
        classes: &mut Vec<String>,
    ) -> RunColumns {
        let key = (run.run.assembly.center_distance(), run.run.phase);
        let mut charts = charts.iter();
        let chart = charts.find(|(_, course)| (course.center_distance, course.phase) == key);
        let assembly = &run.run.assembly;
        let poses = || run.poses.iter().map(|pose| &pose.swept);
        let mating = |member| {
            poses()
                .map(|pose| pose.pose.mating().tooth(member))
                .collect()
        };
        let mut contacts = |side| {
            let mut columns = Contacts::default();
            for pose in poses() {
                columns.push(assembly, side, touching(pose, side), precision, classes);
            }
            columns
        };
        let [right, left] = Side::BOTH.map(&mut contacts);
        RunColumns {
            label: readout::run(run),
            center_distance_mm: assembly.center_distance(),
            outlines: outlines(study, run),
            pitch_radius_mm: [Member::Wheel, Member::Pinion]
                .map(|member| rounded(assembly.operating_pitch_radius(member), precision.decimals)),
            chart: chart.map(|(id, _)| (*id).to_owned()),
            chart_x: chart.map_or(Vec::new(), |(_, course)| places(run, course)),
            mating: [Member::Wheel, Member::Pinion].map(mating),
            left_flank: poses().map(|pose| u8::from(is_left(pose))).collect(),
            fraction: poses()
                .map(|pose| rounded(pose.pose.mating().fraction, 6))
                .collect(),
            locked_deg: poses()
                .map(|pose| degrees(pose.pose.locked_rotation()))
                .collect(),
            free_deg: poses().map(|pose| degrees(free_rotation(pose))).collect(),
            lost_motion_deg: poses()
                .map(|pose| pose.lost_motion.angle().map(degrees))
                .collect(),
            j_wt_um: poses().map(|pose| pose.backlash.map(|j| j * 1e3)).collect(),
            error_bound_um: poses()
                .map(|pose| pose.error_bound.map(|bound| two_digits_up(bound * 1e3)))
                .collect(),
            status: poses()
                .filter_map(|pose| {
                    let status = pose.lost_motion.status();
                    STATUSES.iter().position(|known| *known == status)
                })
                .collect(),
            right,
            left,
        }
    }
}

impl Contacts {
    fn push(
        &mut self,
        assembly: &Assembly,
        side: Side,
        contact: Option<&Contact>,
        precision: Precision,
        classes: &mut Vec<String>,
    ) {
        let class = contact.map(|contact| {
            let class = readout::class(assembly, side, contact);
            let known = classes.iter().position(|known| *known == class);
            known.unwrap_or_else(|| {
                classes.push(class);
                classes.len() - 1
            })
        });
        let place = |value: f64| rounded(value, precision.decimals);
        self.wheel.push(contact.map(|c| c.wheel.tooth));
        self.pinion.push(contact.map(|c| c.pinion.tooth));
        self.class.push(class);
        self.x_mm.push(contact.map(|c| place(c.point.x)));
        self.y_mm.push(contact.map(|c| place(c.point.y)));
        self.normal_deg.push(contact.map(normal_degrees));
    }
}

/// Each pose's place in the curves of `course`, where the poses of a flank follow each other.
fn places(run: &ComparedRun, course: &Course) -> Vec<f64> {
    let mut lines = Side::BOTH.map(|flank| {
        let of_run =
            move |line: &&CourseLine| (line.material, line.flank) == (run.run.material, flank);
        let points = course
            .lines
            .iter()
            .filter(of_run)
            .flat_map(|line| &line.points);
        points.map(|point| rounded(point.x, 6))
    });
    let of_flank = |pose: &ComparedPose| lines[usize::from(is_left(&pose.swept))].next();
    run.poses.iter().filter_map(of_flank).collect()
}

fn is_left(pose: &SweptPose) -> bool {
    pose.pose.mating().flank == Side::Left
}

/// Which of the study's materials `run` has, in their order.
pub fn outlines(study: &Study, run: &ComparedRun) -> usize {
    let mut materials = study.materials.iter();
    materials
        .position(|(material, ..)| *material == run.run.material)
        .unwrap_or(0)
}

/// The contact on `side`; none where nothing of the pose is a number.
pub fn touching(pose: &SweptPose, side: Side) -> Option<&Contact> {
    let contact = match side {
        Side::Right => &pose.lost_motion.right,
        Side::Left => &pose.lost_motion.left,
    };
    contact
        .as_ref()
        .filter(|_| pose.lost_motion.angle().is_some())
}

/// Where the free gear is drawn first: in right-flank contact, or else at its nominal rotation.
pub fn free_rotation(pose: &SweptPose) -> f64 {
    touching(pose, Side::Right).map_or(pose.pose.free_rotation(), |contact| contact.rotation)
}

/// A rotation, rad, in degrees as shown.
pub fn degrees(rotation: f64) -> f64 {
    rounded(rotation.to_degrees(), DEGREES)
}

/// Direction of a contact's normal, degrees.
pub fn normal_degrees(contact: &Contact) -> f64 {
    rounded(
        contact.normal.y.atan2(contact.normal.x).to_degrees(),
        NORMAL,
    )
}
