//! The extremes of the mesh cycle, each with its bracket, pose and proof, and the verdict from them, as JSON.

use crate::column::{Column, Row, Value, columns, row_type};
use crate::pose::PoseRow;
use crate::verdict::{doubt, in_words, lines};
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::extremes::{CoveredPhases, RunExtreme, RunExtremes};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Doubt;
use gearlash::outline::AssembledPair;
use gearlash::pair::{FaceDeviation, Member, arcmin};
use gearlash_files::characters;
use serde_json::json;

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
        let open = run.assembly.data().filter(|_| run.any_direction());
        let high_teeth = open.zip(assembly.data()).map(|(open, worst)| {
            Member::BOTH.map(|member| {
                let is_open = open.gear(member).any_direction();
                is_open.then(|| worst.gear(member).high_tooth())
            })
        });
        ExtremeRow {
            bracket: [extreme.low, extreme.high],
            found: extreme.found(),
            proven: extreme.is_proven(),
            uncertainty: verdict.expanded(extreme),
            doubt: doubt(extreme),
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

row_type!(ExtremeRow = columns());

fn columns() -> Vec<Column<ExtremeRow>> {
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
    runs.map(|run| of_run(verdict, run)).collect()
}

fn of_run(verdict: &Verdict, run: &RunExtremes) -> serde_json::Value {
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
            value[key.replace("_mm", "_doubt")] = in_words(why).into();
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
            "status": [play.pressed.status.name(), play.apart.status.name()],
            "least": one(&play.pressed.extreme),
            "greatest": one(&play.apart.extreme),
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
