//! How often each class of contact occurs in a run, and what it costs, as a result writes it.

use super::{ContactRecord, MatingRecord, contact_record, mating_record, um};
use gearlash::diagnosis::{ContactCount, Worst};
use serde::Serialize;

/// What touched over a run; `classes` counts poses by the graver of their contacts.
#[derive(Debug, Clone, Serialize)]
pub struct ContactCountRecord {
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

/// `count` as results write it.
pub fn contact_count_record(count: &ContactCount) -> ContactCountRecord {
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
