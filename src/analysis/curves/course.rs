//! A run's poses as curves over the teeth.

use crate::analysis::compare::{ComparedPose, ComparedRun};
use crate::analysis::extremes::{CoveredPhases, RunExtreme, RunExtremes};
use crate::analysis::requirement::Requirements;
use crate::analysis::study::Material;
use crate::contact::{Contact, End, PoseResult, Status, first_least};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::{Mating, Member, ToothNumbers};

/// All curves of one centre distance and phase.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Course {
    /// `a`, mm.
    pub center_distance: f64,
    /// The assembly phase, if phases are run separately.
    pub phase: Option<(u32, u32)>,
    /// First and last place: wheel teeth, or pitches since the first pose.
    pub span: [f64; 2],
    /// Number of wheel teeth if places are tooth numbers (which restart at 1); `None` if they are pitches since the first pose.
    pub teeth: Option<u32>,
    /// Wheel and pinion tooth of the first right-flank pose.
    pub start: (u32, u32),
    /// Material by material, right flank before left.
    pub lines: Vec<CourseLine>,
    /// The least backlash of all lines.
    pub least: Option<Extreme>,
    /// The greatest.
    pub greatest: Option<Extreme>,
    /// Least and greatest `j_wt` of the whole mesh cycle at this centre distance, over its phases and every material, µm; `None` if unknown.
    pub cycle_um: [Option<f64>; 2],
    /// The assembly phases that these hold for.
    pub cycle_phases: CoveredPhases,
    /// The requirements on the pair.
    pub required: Requirements,
}

impl Course {
    /// Adds what is `required`, and the extremes of the mesh cycle among `runs`. An extreme on the course replaces the course's own, so that
    /// verdict and chart name the same teeth.
    #[must_use]
    pub fn with_cycle(mut self, runs: &[RunExtremes], required: &Requirements) -> Course {
        let here = |run: &&RunExtremes| run.assembly.center_distance() == self.center_distance;
        let ends = End::BOTH.map(|end| {
            let ends = runs.iter().filter(here);
            let ends = ends.filter_map(|run| Some((run.material, run.at(end)?)));
            first_least(
                ends.map(|(material, run)| ((material, run), end.sign() * run.found(), 0.0)),
            )
        });
        self.cycle_um = ends.map(|end| end.map(|(_, extreme)| extreme.found() * 1e3));
        self.cycle_phases = CoveredPhases::of(runs.iter().filter(here));
        let place = |(material, extreme)| self.extreme_of_cycle(material, extreme);
        let [least, greatest] = ends.map(|end| end.and_then(place));
        self.least = least.or(self.least);
        self.greatest = greatest.or(self.greatest);
        self.required.clone_from(required);
        self
    }

    /// An extreme of the mesh cycle as one of this course; `None` if its teeth do not meet in it.
    fn extreme_of_cycle(&self, material: Material, extreme: &RunExtreme) -> Option<Extreme> {
        let result = &extreme.pose.simulated;
        let mating = result.pose.mating();
        let is_of = |line: &&CourseLine| (line.material, line.flank) == (material, mating.flank);
        let points = self.lines.iter().find(is_of)?.points.iter();
        let um = result.backlash? * 1e3;
        let is_at =
            |point: &&CoursePoint| point.mating == *mating && point.simulated_um == Some(um);
        let x = points.clone().find(is_at)?.x;
        extreme_of(x, material, result)
    }
}

/// The poses of one material and flank.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CourseLine {
    /// The thickness.
    pub material: Material,
    /// The flank that passes through the pitch point, seen from the front.
    pub flank: Side,
    /// The points, in the order of the run's poses of this flank.
    pub points: Vec<CoursePoint>,
}

/// One pose of a curve; values in µm of `j_wt`, `None` without a value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CoursePoint {
    /// Place: the wheel tooth at the pitch point plus the part of a pitch past it, or pitches since the first pose.
    pub x: f64,
    /// The teeth that mate there.
    pub mating: Mating,
    /// The status of the pose, which explains a missing value.
    pub status: Status,
    /// Simulated.
    pub simulated_um: Option<f64>,
    /// Bound on its error.
    pub error_bound_um: Option<f64>,
    /// Simulated minus model 1, Michalec.
    pub off_michalec_um: Option<f64>,
    /// Simulated minus model 2, involute.
    pub off_involute_um: Option<f64>,
    /// Simulated minus model 3, line of action.
    pub off_line_of_action_um: Option<f64>,
}

/// The pose with the least or the greatest backlash, and its contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extreme {
    /// Its place.
    pub x: f64,
    /// `j_wt`, µm.
    pub backlash_um: f64,
    /// Its line's material.
    pub material: Material,
    /// Its line's flank.
    pub flank: Side,
    /// Wheel and pinion tooth whose right flanks touch.
    pub right: (u32, u32),
    /// Wheel and pinion tooth whose left flanks touch.
    pub left: (u32, u32),
}

/// The curves of `runs`, one course per centre distance and phase, in their order.
///
/// The poses of one flank of a run must continue from pitch to pitch, as in a revolution.
pub fn courses(runs: &[ComparedRun]) -> Vec<Course> {
    let key = |run: &ComparedRun| (run.run.assembly.center_distance(), run.run.phase);
    let mut places: Vec<(f64, Option<(u32, u32)>)> = Vec::new();
    for run in runs {
        if !places.contains(&key(run)) {
            places.push(key(run));
        }
    }
    let of_place = |place| {
        let here = runs.iter().filter(|run| key(run) == place).collect();
        course(place, here)
    };
    places.into_iter().map(of_place).collect()
}

fn course((center_distance, phase): (f64, Option<(u32, u32)>), runs: Vec<&ComparedRun>) -> Course {
    let mut lines = Vec::new();
    let mut placed: Vec<(f64, Material, &ComparedPose)> = Vec::new();
    let (mut span, mut teeth, mut start) = ([0.0, 1.0], None, (1, 1));
    for run in runs {
        let assembly = &run.run.assembly;
        for flank in Side::BOTH {
            let poses = flank_poses(run, flank);
            let (Some((_, first)), Some((last, _))) = (poses.first(), poses.last()) else {
                continue;
            };
            let first = first.simulated.pose.mating();
            let scale = Scale::new(assembly, first, *last);
            (span, teeth) = (scale.span(), scale.teeth);
            let first = first.at_flank(assembly, Side::Right);
            start = (first.wheel_tooth, first.pinion_tooth);
            let points = poses.into_iter();
            let points = points.map(|(pitches, pose)| (scale.place(pitches), pose));
            placed.extend(points.clone().map(|(x, pose)| (x, run.run.material, pose)));
            lines.push(CourseLine {
                material: run.run.material,
                flank,
                points: points.map(|(x, pose)| point(x, pose)).collect(),
            });
        }
    }
    let extreme = |sign: f64| {
        let known = placed.iter().filter_map(|placed| {
            let result = &placed.2.simulated;
            Some((placed, sign * result.backlash?, result.error_bound?))
        });
        let (x, material, pose) = first_least(known)?;
        extreme_of(*x, *material, &pose.simulated)
    };
    Course {
        center_distance,
        phase,
        span,
        teeth,
        start,
        least: extreme(1.0),
        greatest: extreme(-1.0),
        cycle_um: [None; 2],
        cycle_phases: CoveredPhases::All,
        required: Requirements::new(),
        lines,
    }
}

/// A pose at `x` as an extreme, if it has a backlash.
fn extreme_of(x: f64, material: Material, pose: &PoseResult) -> Option<Extreme> {
    let lost_motion = pose.proven()?;
    let teeth = |contact: &Contact| (contact.wheel.tooth, contact.pinion.tooth);
    Some(Extreme {
        x,
        backlash_um: pose.backlash? * 1e3,
        material,
        flank: pose.pose.mating().flank,
        right: teeth(lost_motion.right.as_ref()?),
        left: teeth(lost_motion.left.as_ref()?),
    })
}

fn point(x: f64, pose: &ComparedPose) -> CoursePoint {
    let result = &pose.simulated;
    let off = |model: Option<f64>| Some((result.backlash? - model?) * 1e3);
    CoursePoint {
        x,
        mating: *result.pose.mating(),
        status: result.status(),
        simulated_um: result.backlash.map(|mm| mm * 1e3),
        error_bound_um: result.error_bound.map(|mm| mm * 1e3),
        off_michalec_um: off(pose.michalec),
        off_involute_um: off(pose.involute),
        off_line_of_action_um: off(pose.line_of_action),
    }
}

/// Conversion of pitches to places on the horizontal axis of a curve over the teeth.
struct Scale {
    start: f64,
    sense: f64,
    pitches: f64,
    /// Number of wheel teeth if places are tooth numbers.
    teeth: Option<u32>,
}

impl Scale {
    /// The scale of consecutive poses from the mating `first` on, up to `last` pitches from it.
    fn new(assembly: &AssembledPair, first: &Mating, last: f64) -> Scale {
        // The last step counts in whole.
        let pitches = last.floor() + 1.0;
        let teeth = assembly.teeth(Member::Wheel);
        if pitches > f64::from(teeth) {
            return Scale {
                start: 0.0,
                sense: 1.0,
                pitches,
                teeth: None,
            };
        }
        Scale {
            start: f64::from(first.wheel_tooth),
            sense: wheel_sense(assembly),
            pitches,
            teeth: Some(teeth),
        }
    }

    /// The place at `pitches` from the first pose.
    fn place(&self, pitches: f64) -> f64 {
        self.start + self.sense * pitches
    }

    /// First and last place.
    fn span(&self) -> [f64; 2] {
        let end = self.place(self.pitches);
        [self.start.min(end), self.start.max(end)]
    }
}

/// The poses of one flank of `run`, each with its pitches from the first one's tooth: one more with each change of teeth.
pub(super) fn flank_poses(run: &ComparedRun, flank: Side) -> Vec<(f64, &ComparedPose)> {
    let (mut last, mut whole) = (None, 0u32);
    let poses = run.poses.iter();
    let matings = poses.map(|pose| (pose.simulated.pose.mating(), pose));
    let of_flank = matings.filter(|(mating, _)| mating.flank == flank);
    let placed = of_flank.map(|(mating, pose)| {
        let teeth = (mating.wheel_tooth, mating.pinion_tooth);
        let before = last.replace(teeth);
        whole += u32::from(before.is_some_and(|before| before != teeth));
        (f64::from(whole) + mating.fraction, pose)
    });
    placed.collect()
}

/// The sense in which wheel tooth numbers come into mesh: +1 ascending, −1 descending.
///
/// Ascending teeth of the locked gear come into mesh. On its mate numbers ascend with them if the two faces point in opposite directions.
fn wheel_sense(assembly: &AssembledPair) -> f64 {
    let ascending = |member| assembly.shown_face(member).ascending();
    match assembly.locked() {
        Member::Wheel => 1.0,
        Member::Pinion => -ascending(Member::Wheel) * ascending(Member::Pinion),
    }
}
