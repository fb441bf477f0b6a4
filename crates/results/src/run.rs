//! A run: its centre distance and material, its summary, and the extremes of its mesh cycle, each with its bracket, pose and proof;
//! the verdict from them, as JSON.

use crate::column::{Column, Row, Value, columns, row_type, shown};
use crate::layout::pose_label;
use crate::pose::{ContactRow, PoseRow};
use crate::verdict::{doubt_words, extreme_doubt, lines};
use gearlash::analysis::assembles_from::Threshold;
use gearlash::analysis::compare::{ComparedPose, Summary};
use gearlash::analysis::diagnosis::{ContactCount, Worst};
use gearlash::analysis::extremes::{CoveredPhases, RunExtreme, RunExtremes};
use gearlash::analysis::study::Material;
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::verdict::Verdict;
use gearlash::outline::AssembledPair;
use gearlash::pair::{FaceDeviation, Member, arcmin};
use gearlash_text::characters;
use serde_json::json;

/// A run and its summary.
#[derive(Debug)]
pub struct RunRow {
    assembly: AssembledPair,
    material: Material,
    phase: Option<(u32, u32)>,
    poses: usize,
    unproven: usize,
    contact: Option<serde_json::Value>,
    /// The names of the poses with the least and the greatest backlash.
    at: [Option<String>; 2],
    summary: Summary,
    /// Radial clearance of both bearings, mm.
    clearance: f64,
}

/// The names of the poses of `run` with the least and the greatest backlash.
pub(crate) fn extremes_at(run: &RunTally) -> [Option<String>; 2] {
    let (least, greatest) = run.extremes().unzip();
    [least, greatest].map(|pose| pose.map(pose_label))
}

impl RunRow {
    /// The row of `run`, with the bearing clearance of its study, mm.
    pub fn new(run: &RunTally, clearance: f64) -> RunRow {
        RunRow {
            assembly: run.assembly.clone(),
            material: run.material,
            phase: run.phase,
            poses: run.poses,
            unproven: run.unproven,
            contact: (run.evidence.as_ref()).map(|evidence| contact_count(&evidence.contact)),
            at: extremes_at(run),
            summary: run.summary(),
            clearance,
        }
    }

    /// Its centre distance, mm.
    pub fn center_distance(&self) -> f64 {
        self.assembly.center_distance()
    }

    fn arcmin(&self, j_wt: Option<f64>, member: Member) -> Option<f64> {
        Some(arcmin(self.assembly.angle(member, j_wt?)))
    }

    /// The least and the greatest backlash with the bearing clearance, each with its own centre distance.
    fn band(&self) -> Value {
        if !(self.clearance > 0.0) {
            return Value::Absent;
        }
        let ends = self.summary.with_clearance;
        let [near, far] = ends.map(|end| end.map(|mm| mm * 1e3));
        let a = self.center_distance();
        Value::Band([(near, a - self.clearance), (far, a + self.clearance)])
    }
}

row_type!(row: RunRow {
    "center_distance_mm" Distance [heading(shown("a mm"))] => row.center_distance();
    "material" Plain [heading(shown("material"))] => row.material.name();
    "phase.wheel_tooth" Plain => Value::optional(row.phase.map(|phase| phase.0));
    "phase.pinion_tooth" Plain => Value::optional(row.phase.map(|phase| phase.1));
    "operating_pressure_angle_deg" Plain => row.assembly.operating_pressure_angle().map(f64::to_degrees);
    "" Plain [heading(shown("poses").spare(5))] => row.poses;
    "" Backlash [heading(shown("least"))] => Value::um(row.summary.min);
    "" Plain [heading(shown("at").broken())] => row.at[0].clone();
    "" Backlash [heading(shown("mean").spare(2))] => Value::um(row.summary.mean);
    "" Backlash [heading(shown("greatest"))] => Value::um(row.summary.max);
    "" Plain [heading(shown("at").broken())] => row.at[1].clone();
    "" Plain [heading(shown("a ± clearance").spare(1))] => row.band();
    "" BacklashAgain [heading(shown("off model 2").spare(4))] => Value::um(row.summary.off_involute);
    "" BacklashAgain [heading(shown("off model 3").spare(3))] => Value::um(row.summary.off_line_of_action);
    "" Plain [heading(shown("unproven"))] => Value::optional((row.unproven > 0).then_some(row.unproven));
    "summary.min_j_wt_um" Plain => Value::um(row.summary.min);
    "summary.max_j_wt_um" Plain => Value::um(row.summary.max);
    "summary.mean_j_wt_um" Plain => Value::um(row.summary.mean);
    "summary.unproven" Plain => row.summary.unproven;
    "summary.polygon_checked" Plain => row.summary.polygon_checked;
    "summary.with_bearing_clearance.min_j_wt_um" Plain => Value::um(row.summary.with_clearance[0]);
    "summary.with_bearing_clearance.max_j_wt_um" Plain => Value::um(row.summary.with_clearance[1]);
    "summary.with_bearing_clearance.unproven" Plain => Value::optional((row.summary.unproven_ends != [0, 0]).then(|| json!(row.summary.unproven_ends)));
    "summary.max_deviation_um.involute" Plain => Value::um(row.summary.off_involute);
    "summary.max_deviation_um.line_of_action" Plain => Value::um(row.summary.off_line_of_action);
    "summary.contact" Plain => row.contact.clone();
    "summary.min_lost_motion_arcmin.wheel" Plain => row.arcmin(row.summary.min, Member::Wheel);
    "summary.min_lost_motion_arcmin.pinion" Plain => row.arcmin(row.summary.min, Member::Pinion);
    "summary.max_lost_motion_arcmin.wheel" Plain => row.arcmin(row.summary.max, Member::Wheel);
    "summary.max_lost_motion_arcmin.pinion" Plain => row.arcmin(row.summary.max, Member::Pinion);
});

/// The contacts of a run as JSON; `classes` counts poses by the more severe of their contacts.
pub(crate) fn contact_count(count: &ContactCount) -> serde_json::Value {
    let classes = count.classes.iter();
    let classes: serde_json::Map<_, _> = classes
        .map(|(class, poses)| (class.name().to_owned(), (*poses).into()))
        .collect();
    let loss = count.loss.as_ref();
    json!({
        "classes": classes,
        "least_loss_um": loss.map(|loss| loss.least * 1e3),
        "mean_loss_um": loss.map(|loss| loss.mean * 1e3),
        "worst_loss_um": loss.map(|loss| loss.worst.loss * 1e3),
        "worst": loss.map(|loss| worst(&loss.worst)),
    })
}

/// The pose with the greatest loss, and the contact that causes it.
fn worst(worst: &Worst) -> serde_json::Value {
    json!({
        "center_distance_mm": worst.assembly.center_distance(),
        "material": worst.material.name(),
        "mating": worst.pose.mating().json(),
        "class": worst.class.name(),
        "j_wt_um": worst.backlash * 1e3,
        "formula_um": (worst.backlash + worst.loss) * 1e3,
        "side": worst.side.name(),
        "contact": ContactRow::new(&worst.assembly.clone().into(), worst.side, &worst.pose, &worst.contact).json(),
    })
}

/// The least or the greatest backlash of a cycle.
#[derive(Debug)]
pub struct ExtremeRow {
    extreme: RunExtreme,
    uncertainty: Option<f64>,
    /// The worst high tooth of each gear with an undirected runout.
    high_teeth: Option<[Option<f64>; 2]>,
    pose: PoseRow,
}

impl ExtremeRow {
    /// The row of `extreme`, which belongs to `run` and `verdict`.
    pub fn new(verdict: &Verdict, run: &RunExtremes, extreme: &RunExtreme) -> ExtremeRow {
        let assembly = &extreme.assembly;
        let high_tooth = |member| {
            let is_open = run.assembly.any_direction(member);
            is_open.then(|| assembly.high_tooth(member))
        };
        ExtremeRow {
            uncertainty: verdict.expanded(extreme),
            high_teeth: run.any_direction().then(|| Member::BOTH.map(high_tooth)),
            pose: PoseRow::new(assembly, &extreme.pose),
            extreme: extreme.clone(),
        }
    }

    /// The lost motion at one end of the bracket; null where the end is unknown.
    fn lost_motion(&self, end: f64) -> Option<f64> {
        let assembly = &self.extreme.assembly;
        known(end).map(|j_wt| assembly.angle(assembly.free(), j_wt))
    }

    fn arcmin(&self, member: Member) -> f64 {
        arcmin(self.extreme.assembly.angle(member, self.extreme.found()))
    }

    fn high_tooth(&self, gear: usize) -> Value {
        self.high_teeth
            .map_or(Value::Absent, |teeth| teeth[gear].into())
    }
}

fn known(length: f64) -> Option<f64> {
    length.is_finite().then_some(length)
}

row_type!(ExtremeRow = extreme_columns());

fn extreme_columns() -> Vec<Column<ExtremeRow>> {
    let mut columns = columns!(row: ExtremeRow {
        "j_wt_um.0" Plain => Value::um(known(row.extreme.low));
        "j_wt_um.1" Plain => Value::um(known(row.extreme.high));
        "found_j_wt_um" Backlash => Value::um(row.extreme.found());
        "lost_motion_rad.0" Plain => row.lost_motion(row.extreme.low);
        "lost_motion_rad.1" Plain => row.lost_motion(row.extreme.high);
        "lost_motion_arcmin.wheel" Plain => row.arcmin(Member::Wheel);
        "lost_motion_arcmin.pinion" Plain => row.arcmin(Member::Pinion);
        "proven" Plain => row.extreme.is_proven();
        "uncertainty_um" Plain => Value::um(row.uncertainty);
        "doubt" Plain => Value::optional(extreme_doubt(&row.extreme));
        "high_tooth.wheel" Plain => row.high_tooth(0);
        "high_tooth.pinion" Plain => row.high_tooth(1);
    });
    columns.extend(PoseRow::columns().within("pose", |row: &ExtremeRow| Some(&row.pose)));
    columns
}

/// The extremes of `verdict` as JSON, one object per centre distance, material and assembly phase.
pub(crate) fn extremes(verdict: &Verdict) -> Vec<serde_json::Value> {
    let runs = verdict.runs.iter();
    runs.map(|run| extremes_of_run(verdict, run)).collect()
}

fn extremes_of_run(verdict: &Verdict, run: &RunExtremes) -> serde_json::Value {
    let one = |extreme: &Option<RunExtreme>| {
        Some(ExtremeRow::new(verdict, run, extreme.as_ref()?).json())
    };
    let mut value = json!({
        "center_distance_mm": run.assembly.center_distance(),
        "material": run.material.name(),
        "phase": run.phase.map(|(wheel, pinion)| [wheel, pinion]),
        "status": run.status.name(),
    });
    let mut distance = |name: &str, found: Option<Threshold>| {
        value[format!("{name}_mm")] = json!(found.map(|found| [found.low, found.high]));
        if let Some(why) = found.and_then(|found| found.doubt) {
            value[format!("{name}_doubt")] = doubt_words(why).into();
        }
    };
    distance("assembles_from", run.assembles_from);
    if run.meshes_to.is_some() {
        distance("meshes_to", run.meshes_to);
    }
    if let Some(loss) = &run.face_loss {
        let um = |kind| loss.by(kind).map(|mm| mm * 1e3);
        value["along_face_um"] = json!({
            "lead": um(FaceDeviation::Lead),
            "wobble": um(FaceDeviation::Wobble),
            "shafts": um(FaceDeviation::Shafts),
        });
    }
    value["least"] = json!(one(&run.least));
    value["greatest"] = json!(one(&run.greatest));
    if let Some(play) = &run.bearings {
        value["with_bearing_clearance"] = json!({
            "clearance_mm": play.clearance,
            "status": [play.pressed.status.name(), play.pulled_apart.status.name()],
            "least": one(&play.pressed.extreme),
            "greatest": one(&play.pulled_apart.extreme),
        });
    }
    value
}

/// The extremes behind `verdict` as JSON: the list under `extremes` in results.
pub fn extremes_json(verdict: &Verdict) -> String {
    characters::json(json!(extremes(verdict)).to_string())
}

/// A pose of `assembly` as JSON, as in results.
pub fn pose_json(assembly: &AssembledPair, pose: &ComparedPose) -> String {
    characters::json(PoseRow::new(assembly, pose).json().to_string())
}

/// `verdict` as JSON. Its assembly phases are `"all"`, or the wheel and pinion tooth of each.
pub(crate) fn verdict_record(verdict: &Verdict) -> serde_json::Value {
    let failed = verdict.failed_checks.iter().map(|check| check.id);
    json!({
        "text": lines(verdict).to_string(),
        "assembles": verdict.assembles(),
        "requirement": verdict.requirement.name(),
        "phases": match CoveredPhases::of(verdict.runs) {
            CoveredPhases::All => json!("all"),
            CoveredPhases::Some(phases) => json!(phases),
        },
        "failed_checks": failed.collect::<Vec<_>>(),
        "matings": verdict.matings(),
    })
}
