//! The results in columns for the script: one entry per pose.

use super::precision::{Precision, degrees};
use super::readout::{self, HelicalColumns, texts, touching};
use super::viewed::Viewed;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::{Course, CourseLine};
use gearlash::contact::PoseResult;
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::Member;
use gearlash_results::{Format, Value, pose_page};
use gearlash_text::numbers::{rounded, two_digits_up};
use indexmap::IndexSet;
use serde::Serialize;
use std::collections::BTreeMap;

/// The words of a column by its name; its values are indices into them.
#[derive(Default, Serialize)]
#[serde(transparent)]
pub struct Words(BTreeMap<String, IndexSet<String>>);

impl Words {
    /// The index of `word` in the column `name`.
    fn index(&mut self, name: &str, word: String) -> Value {
        let known = self.0.entry(name.to_owned()).or_default();
        known.insert_full(word).0.into()
    }
}

/// Decimals of a number that is neither a backlash nor a place.
const DECIMALS: usize = 6;

#[derive(Serialize)]
pub struct Columns {
    pub free: &'static str,
    pub words: Words,
    pub runs: Vec<RunColumns>,
    /// Index of the run and pose shown first.
    pub start: [usize; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub helical: Option<HelicalColumns>,
}

pub fn outline_of(outlines: &[&AssembledPair], run: &ComparedRun) -> usize {
    let own = |pair: &&AssembledPair| pair.has_gears_of(&run.run.assembly);
    outlines.iter().position(own).unwrap_or(0)
}

/// The first rotation of the free gear: in right-flank contact, or else nominal.
pub fn free_rotation(pose: &PoseResult) -> f64 {
    touching(pose, Side::Right).map_or(pose.pose.free_rotation(), |contact| contact.rotation)
}

#[derive(Serialize)]
pub struct RunColumns {
    label: String,
    center_distance_mm: f64,
    /// Index of its outlines.
    outlines: usize,
    pitch_radius_mm: [f64; 2],
    of: usize,
    /// Numbers of the contained poses, from 1; `None`: all.
    number: Option<Vec<usize>>,
    /// Id of the chart, and each pose's place on its horizontal axis.
    chart: Option<String>,
    chart_x: Vec<Option<f64>>,
    /// The columns of its poses, one entry per pose.
    #[serde(flatten)]
    poses: BTreeMap<String, Vec<Value>>,
}

impl RunColumns {
    /// The columns of `viewed`. New words are added to `words`.
    pub fn new(
        viewed: &Viewed,
        charts: &[(String, &Course)],
        outlines: &[&AssembledPair],
        precision: Precision,
        words: &mut Words,
    ) -> RunColumns {
        let run = viewed.run;
        let assembly = &run.run.assembly;
        let a = assembly.center_distance();
        let is_of = |course: &Course| {
            let is_phase = viewed.is_worst_of_cycle || course.phase == run.run.phase;
            is_phase && course.center_distance == a
        };
        let mut drawn = charts.iter().filter(|(_, course)| is_of(course));
        let drawn = drawn.find_map(|(id, course)| {
            let places = places(run, course);
            let any = places.iter().any(Option::is_some);
            any.then(|| (id.clone(), places))
        });
        let (chart, places) = drawn.unzip();
        let places = places.unwrap_or_default();
        let place = |number: &usize| places.get(*number).copied().flatten();
        let all = viewed.numbers.len() == run.poses.len();
        RunColumns {
            label: readout::run(viewed),
            center_distance_mm: a,
            outlines: outline_of(outlines, run),
            pitch_radius_mm: Member::BOTH
                .map(|member| rounded(assembly.operating_pitch_radius(member), precision.decimals)),
            of: run.poses.len(),
            number: (!all).then(|| viewed.numbers.iter().map(|number| number + 1).collect()),
            chart,
            chart_x: viewed.numbers.iter().map(place).collect(),
            poses: poses(assembly, viewed, precision, words),
        }
    }
}

/// The columns and texts of the poses of `viewed` by their names, rounded; angles in degrees. A column without any value is left out.
fn poses(
    assembly: &AssembledPair,
    viewed: &Viewed,
    precision: Precision,
    words: &mut Words,
) -> BTreeMap<String, Vec<Value>> {
    let mut columns: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    for (name, format, values) in pose_page(assembly, viewed.poses()) {
        if values.iter().all(|value| *value == Value::Absent) {
            continue;
        }
        let name = match (format, name.strip_suffix("_rad")) {
            (Format::Angle, Some(name)) => format!("{name}_deg"),
            _ => name.to_owned(),
        };
        let values = values.into_iter().map(|value| {
            if let Some(word) = value.text() {
                return words.index(&name, word.to_owned());
            }
            match (value.measure(), format) {
                (Some(angle), Format::Angle) => degrees(angle).into(),
                (Some(place), Format::Place) => rounded(place, precision.decimals).into(),
                (Some(um), Format::Bound) => two_digits_up(um).into(),
                (Some(number), Format::Plain) => rounded(number, DECIMALS).into(),
                _ => value,
            }
        });
        let values = values.collect();
        columns.insert(name, values);
    }
    for number in &viewed.numbers {
        for (name, text) in texts(viewed, *number) {
            let name = format!("{name}_text");
            let index = words.index(&name, text);
            columns.entry(name).or_default().push(index);
        }
    }
    columns
}

/// Each pose's place in the curves of `course`, which have the poses of a flank in order; `None` for a pose without a point
/// there.
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
            let line = &mut lines[usize::from(mating.flank == Side::Left)];
            let point = line.find(|point| point.mating == *mating)?;
            Some(rounded(point.x, 6))
        })
        .collect()
}
