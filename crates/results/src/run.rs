//! A run: its centre distance and material, its summary, and the extremes of its mesh cycle, each with its bracket, pose and proof;
//! the verdict from them, as JSON.

use crate::column::{Column, Row, Value, columns, row_type, shown};
use crate::layout::pose_label;
use crate::pose::{ContactRow, PoseRow};
use crate::verdict::{doubt_words, extreme_doubt, lines};
use gearlash::analysis::compare::{ComparedPose, Summary};
use gearlash::analysis::diagnosis::{ContactCount, Worst};
use gearlash::analysis::extremes::{CoveredPhases, RunExtreme, RunExtremes};
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Doubt;
use gearlash::outline::AssembledPair;
use gearlash::pair::{FaceDeviation, Member, arcmin};
use gearlash_text::characters;
use serde_json::json;

/// A run and its summary.
#[derive(Debug)]
pub struct RunRow {
    assembly: AssembledPair,
    material: &'static str,
    phase: Option<(u32, u32)>,
    poses: usize,
    unproven: usize,
    summary: Summary,
    contact: Option<serde_json::Value>,
    /// The places of the least and the greatest backlash.
    at: [Option<String>; 2],
    /// Radial clearance of both bearings, mm.
    clearance: f64,
}

impl RunRow {
    /// The row of `run`, with the bearing clearance of its study, mm.
    pub fn new(run: &RunTally, clearance: f64) -> RunRow {
        let (least, greatest) = run.extremes().unzip();
        let at = |pose: Option<&ComparedPose>| pose.map(pose_label);
        let evidence = run.evidence.as_ref();
        RunRow {
            assembly: run.assembly.clone(),
            material: run.material.name(),
            phase: run.phase,
            poses: run.poses,
            unproven: run.unproven,
            summary: run.summary(),
            contact: evidence.map(|evidence| contact_count(&evidence.contact)),
            at: [at(least), at(greatest)],
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

    /// The number of poses that are not proven at either end of the bearing clearance.
    fn unproven_ends(&self) -> Value {
        let ends = self.summary.unproven_ends;
        Value::optional((ends != [0, 0]).then(|| json!(ends)))
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
    "material" Plain [heading(shown("material"))] => row.material;
    "phase.wheel_tooth" Plain => Value::optional(row.phase.map(|phase| phase.0));
    "phase.pinion_tooth" Plain => Value::optional(row.phase.map(|phase| phase.1));
    "operating_pressure_angle_deg" Plain => row.assembly.operating_pressure_angle().map(f64::to_degrees);
    "" Plain [people(shown("poses").spare(5))] => row.poses;
    "" Backlash [people(shown("least"))] => Value::um(row.summary.min);
    "" Plain [people(shown("at").broken())] => row.at[0].clone();
    "" Backlash [people(shown("mean").spare(2))] => Value::um(row.summary.mean);
    "" Backlash [people(shown("greatest"))] => Value::um(row.summary.max);
    "" Plain [people(shown("at").broken())] => row.at[1].clone();
    "" Plain [people(shown("a ± clearance").spare(1))] => row.band();
    "" BacklashAgain [people(shown("off model 2").spare(4))] => Value::um(row.summary.off_involute);
    "" BacklashAgain [people(shown("off model 3").spare(3))] => Value::um(row.summary.off_line_of_action);
    "" Plain [people(shown("unproven"))] => Value::optional((row.unproven > 0).then_some(row.unproven));
    "summary.min_j_wt_um" Plain => Value::um(row.summary.min);
    "summary.max_j_wt_um" Plain => Value::um(row.summary.max);
    "summary.mean_j_wt_um" Plain => Value::um(row.summary.mean);
    "summary.unproven" Plain => row.summary.unproven;
    "summary.polygon_checked" Plain => row.summary.polygon_checked;
    "summary.with_bearing_clearance.min_j_wt_um" Plain => Value::um(row.summary.with_clearance[0]);
    "summary.with_bearing_clearance.max_j_wt_um" Plain => Value::um(row.summary.with_clearance[1]);
    "summary.with_bearing_clearance.unproven" Plain => row.unproven_ends();
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
        "mating": PoseRow::mating_json(worst.pose.mating()),
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
    /// The bracket of `j_wt`, mm; an unknown end is infinite.
    bracket: [f64; 2],
    found: f64,
    proven: bool,
    uncertainty: Option<f64>,
    doubt: Option<String>,
    assembly: AssembledPair,
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
        let high_teeth = run.any_direction().then(|| Member::BOTH.map(high_tooth));
        ExtremeRow {
            bracket: [extreme.low, extreme.high],
            found: extreme.found(),
            proven: extreme.is_proven(),
            uncertainty: verdict.expanded(extreme),
            doubt: extreme_doubt(extreme),
            high_teeth,
            pose: PoseRow::new(assembly, &extreme.pose),
            assembly: assembly.clone(),
        }
    }

    /// The lost motion at one end of the bracket; null where the end is unknown.
    fn lost_motion(&self, end: usize) -> Value {
        let free = self.assembly.free();
        let angle = |j_wt| self.assembly.angle(free, j_wt);
        known(self.bracket[end]).map(angle).into()
    }

    fn arcmin(&self, member: Member) -> f64 {
        arcmin(self.assembly.angle(member, self.found))
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
        "j_wt_um.0" Plain => Value::um(known(row.bracket[0]));
        "j_wt_um.1" Plain => Value::um(known(row.bracket[1]));
        "found_j_wt_um" Backlash => Value::um(row.found);
        "lost_motion_rad.0" Plain => row.lost_motion(0);
        "lost_motion_rad.1" Plain => row.lost_motion(1);
        "lost_motion_arcmin.wheel" Plain => row.arcmin(Member::Wheel);
        "lost_motion_arcmin.pinion" Plain => row.arcmin(Member::Pinion);
        "proven" Plain => row.proven;
        "uncertainty_um" Plain => Value::um(row.uncertainty);
        "doubt" Plain => Value::optional(row.doubt.clone());
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
    let mut distance = |key: &str, bracket: Option<[f64; 2]>, why: Option<Doubt>| {
        value[key] = json!(bracket);
        if let Some(why) = why {
            value[key.replace("_mm", "_doubt")] = doubt_words(why).into();
        }
    };
    let from = run.assembles_from;
    distance(
        "assembles_from_mm",
        from.map(|from| [from.low, from.high]),
        from.and_then(|from| from.doubt),
    );
    if let Some(to) = run.meshes_to {
        distance("meshes_to_mm", Some([to.low, to.high]), to.doubt);
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
