//! What a run comes to, as a result writes it: least, mean and greatest, and what touched.

use super::records::{
    ArcminRecord, ContactRecord, MatingRecord, contact_record, mating_record, um,
};
use gearlash::analysis::diagnosis::{ContactCount, Worst};
use gearlash::analysis::tally::RunTally;
use serde::Serialize;

/// What touched over a run; `classes` counts poses by the graver of their contacts.
#[derive(Debug, Clone, Serialize)]
pub(super) struct ContactCountRecord {
    classes: serde_json::Map<String, serde_json::Value>,
    least_loss_um: Option<f64>,
    mean_loss_um: Option<f64>,
    worst_loss_um: Option<f64>,
    worst: Option<WorstRecord>,
}

/// The pose that loses most, and the tooth pair whose contact costs it.
#[derive(Debug, Clone, Serialize)]
struct WorstRecord {
    center_distance_mm: f64,
    material: &'static str,
    mating: MatingRecord,
    class: &'static str,
    j_wt_um: f64,
    formula_um: f64,
    side: &'static str,
    contact: ContactRecord,
}

pub(super) fn contact_count_record(count: &ContactCount) -> ContactCountRecord {
    let classes = count.classes.iter();
    let classes = classes.map(|(class, n)| (class.name().to_owned(), (*n).into()));
    let loss = count.loss.as_ref();
    ContactCountRecord {
        classes: classes.collect(),
        least_loss_um: loss.map(|loss| um(loss.least)),
        mean_loss_um: loss.map(|loss| um(loss.mean)),
        worst_loss_um: loss.map(|loss| um(loss.worst.loss)),
        worst: loss.map(|loss| worst_record(&loss.worst)),
    }
}

fn worst_record(worst: &Worst) -> WorstRecord {
    let mating = worst.pose.mating();
    WorstRecord {
        center_distance_mm: worst.assembly.center_distance(),
        material: worst.material.name(),
        mating: mating_record(mating),
        class: worst.class.name(),
        j_wt_um: um(worst.backlash),
        formula_um: um(worst.backlash + worst.loss),
        side: worst.side.name(),
        contact: contact_record(&worst.assembly, worst.side, &worst.contact),
    }
}

/// What a run comes to.
#[derive(Debug, Serialize)]
pub(super) struct SummaryRecord {
    min_j_wt_um: Option<f64>,
    max_j_wt_um: Option<f64>,
    mean_j_wt_um: Option<f64>,
    /// Poses that are not proven, and of which no value counts.
    unproven: usize,
    with_bearing_clearance: BandRecord,
    max_deviation_um: DeviationRecord,
    contact: ContactCountRecord,
    min_lost_motion_arcmin: ArcminRecord,
    max_lost_motion_arcmin: ArcminRecord,
}

#[derive(Debug, Serialize)]
struct BandRecord {
    min_j_wt_um: Option<f64>,
    max_j_wt_um: Option<f64>,
    /// Poses that are not proven at `a − c`, and at `a + c`; left out where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven: Option<[usize; 2]>,
}

#[derive(Debug, Serialize)]
struct DeviationRecord {
    involute: Option<f64>,
    line_of_action: Option<f64>,
}

pub(super) fn summary_record(run: &RunTally) -> SummaryRecord {
    let summary = run.summary();
    let lost_motion =
        |j_wt: Option<f64>| ArcminRecord::of(j_wt.map(|j_wt| run.assembly.backlash(j_wt)));
    SummaryRecord {
        min_j_wt_um: summary.min.map(um),
        max_j_wt_um: summary.max.map(um),
        mean_j_wt_um: summary.mean.map(um),
        unproven: summary.unproven,
        with_bearing_clearance: BandRecord {
            min_j_wt_um: summary.with_clearance[0].map(um),
            max_j_wt_um: summary.with_clearance[1].map(um),
            unproven: (summary.unproven_ends != [0, 0]).then_some(summary.unproven_ends),
        },
        max_deviation_um: DeviationRecord {
            involute: summary.off_involute.map(um),
            line_of_action: summary.off_line_of_action.map(um),
        },
        contact: contact_count_record(&run.seen.contact),
        min_lost_motion_arcmin: lost_motion(summary.min),
        max_lost_motion_arcmin: lost_motion(summary.max),
    }
}
