//! A run: its centre distance and material, and its summary.

use crate::column::{Row, Value, row_type, shown};
use crate::layout::pose_label;
use crate::pose::{ContactRow, PoseRow};
use gearlash::analysis::compare::{ComparedPose, Summary};
use gearlash::analysis::diagnosis::{ContactCount, Worst};
use gearlash::analysis::tally::RunTally;
use gearlash::outline::AssembledPair;
use gearlash::pair::{Member, arcmin};
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
    "operating_pressure_angle_deg" Plain => row.assembly.data().map(|pair| pair.operating_pressure_angle().to_degrees());
    "" Plain [people(shown("poses").spare(5))] => row.poses;
    "" Backlash [people(shown("least"))] => Value::um(row.summary.min);
    "" Plain [people(shown("at").broken())] => row.at[0].clone();
    "" Backlash [people(shown("mean").spare(2))] => Value::um(row.summary.mean);
    "" Backlash [people(shown("greatest"))] => Value::um(row.summary.max);
    "" Plain [people(shown("at").broken())] => row.at[1].clone();
    "" Plain [people(shown("a ± clearance").spare(1))] => row.band();
    "" Beside [people(shown("off model 2").spare(4))] => Value::um(row.summary.off_involute);
    "" Beside [people(shown("off model 3").spare(3))] => Value::um(row.summary.off_line_of_action);
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
        "contact": ContactRow::new(Some(&worst.assembly), worst.side, &worst.pose, &worst.contact).json(),
    })
}
