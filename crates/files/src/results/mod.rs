//! The result as JSON and CSV: the keys of the interface, units in their names.

use gearlash::compare::{ComparedPose, Summary};
use gearlash::diagnosis::ContactCount;
use gearlash::gear::Side;
use gearlash::mesh::{Contact, ContactClass, LostMotion, PoseResult, Touch, Unproven};
use gearlash::pair::{GearPair, Mating, Member};
use gearlash::tally::RunTally;
use serde::Serialize;
use std::f64::consts::TAU;

mod contacts;
mod csv_row;
mod json;
mod notes;
mod written;

pub use contacts::{ContactCountRecord, contact_count_record};
pub use written::{ResultFile, ResultWriter, result_file};

/// What a result says of a run before its poses.
#[derive(Debug, Clone, Copy)]
struct RunHead {
    center_distance_mm: f64,
    material: &'static str,
    phase: Option<PhaseRecord>,
    operating_pressure_angle_deg: f64,
}

impl RunHead {
    fn of(run: &RunTally) -> RunHead {
        RunHead {
            center_distance_mm: run.assembly.center_distance(),
            material: run.material.name(),
            phase: run.phase.map(|(wheel_tooth, pinion_tooth)| PhaseRecord {
                wheel_tooth,
                pinion_tooth,
            }),
            operating_pressure_angle_deg: run.assembly.operating_pressure_angle().to_degrees(),
        }
    }
}

/// The mating that names an assembly phase, where phases are run apart.
#[derive(Debug, Clone, Copy, Serialize)]
struct PhaseRecord {
    wheel_tooth: u32,
    pinion_tooth: u32,
}

#[derive(Debug, Serialize)]
struct PoseRecord {
    #[serde(skip_serializing_if = "Option::is_none")]
    wheel_rotation_rad: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pinion_rotation_rad: Option<f64>,
    mating: MatingRecord,
    right_rad: Option<f64>,
    left_rad: Option<f64>,
    lost_motion_rad: Option<f64>,
    j_wt_um: Option<f64>,
    j_t_um: Option<f64>,
    j_bn_um: Option<f64>,
    j_wt_range_um: [Option<f64>; 2],
    error_bound_um: Option<f64>,
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven: Option<UnprovenRecord>,
    /// At `a − c` and at `a + c`; left out where both are proven.
    #[serde(skip_serializing_if = "Option::is_none")]
    unproven_range: Option<[Option<UnprovenRecord>; 2]>,
    class: &'static str,
    right: Option<ContactRecord>,
    left: Option<ContactRecord>,
    analytic: AnalyticRecord,
}

/// Why a pose is not proven, and the values that nothing vouches for.
#[derive(Debug, Clone, Serialize)]
pub struct UnprovenRecord {
    reason: String,
    exact_j_wt_um: Option<f64>,
    polygon_j_wt_um: Option<f64>,
}

/// Which teeth mate, and how far beyond.
#[derive(Debug, Clone, Serialize)]
pub struct MatingRecord {
    wheel_tooth: u32,
    pinion_tooth: u32,
    flank: &'static str,
    fraction: f64,
}

#[derive(Debug, Clone, Serialize)]
struct ContactRecord {
    wheel_tooth: u32,
    pinion_tooth: u32,
    wheel_curve: &'static str,
    pinion_curve: &'static str,
    wheel_radius_mm: f64,
    pinion_radius_mm: f64,
    point_mm: [f64; 2],
    normal: [f64; 2],
    class: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_gear: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_moment: Option<&'static str>,
}

#[derive(Debug, Serialize)]
struct AnalyticRecord {
    michalec_um: Option<f64>,
    involute_um: Option<f64>,
    line_of_action_um: Option<f64>,
}

#[derive(Debug, Serialize)]
struct SummaryRecord {
    min_j_wt_um: Option<f64>,
    max_j_wt_um: Option<f64>,
    mean_j_wt_um: Option<f64>,
    /// Poses that are not proven, and of which no value counts.
    unproven: usize,
    with_bearing_clearance: BandRecord,
    max_deviation_um: DeviationRecord,
    contact: ContactCountRecord,
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

fn um(length: f64) -> f64 {
    length * 1e3
}

fn pose_record(assembly: &GearPair, pose: &ComparedPose) -> PoseRecord {
    let free = assembly.gear(assembly.free()).gear();
    let swept = &pose.swept;
    let mating = swept.pose.mating();
    let found = swept.proven();
    let angle = found.and_then(LostMotion::angle);
    let rotation =
        |member: Member| (assembly.locked() == member).then(|| swept.pose.locked_rotation());
    // Nothing of a jammed, unmeshed or unproven pose is a number.
    let on = |side| {
        let found = angle.and(found)?;
        match side {
            Side::Right => found.right.as_ref(),
            Side::Left => found.left.as_ref(),
        }
    };
    let contact = |side| Some(contact_record(assembly, side, on(side)?));
    let right = on(Side::Right).map(|contact| principal(contact.rotation));
    PoseRecord {
        wheel_rotation_rad: rotation(Member::Wheel),
        pinion_rotation_rad: rotation(Member::Pinion),
        mating: mating_record(mating),
        right_rad: right,
        left_rad: right.zip(angle).map(|(right, angle)| right + angle),
        lost_motion_rad: angle,
        j_wt_um: swept.backlash.map(um),
        j_t_um: angle.map(|phi| um(phi * free.basic_data().reference_radius())),
        j_bn_um: angle.map(|phi| um(phi * free.base_radius())),
        j_wt_range_um: swept.range().map(|end| end.map(um)),
        error_bound_um: angle.and(swept.error_bound).map(um),
        status: swept.status().name(),
        unproven: swept.found.as_ref().err().map(unproven_record),
        unproven_range: unproven_range(swept),
        class: swept.class(assembly).name(),
        right: contact(Side::Right),
        left: contact(Side::Left),
        analytic: AnalyticRecord {
            michalec_um: pose.michalec.map(um),
            involute_um: pose.involute.map(um),
            line_of_action_um: pose.line_of_action.map(um),
        },
    }
}

/// `unproven` as results write it.
pub fn unproven_record(unproven: &Unproven) -> UnprovenRecord {
    UnprovenRecord {
        reason: unproven.reason.clone(),
        exact_j_wt_um: unproven.exact.map(um),
        polygon_j_wt_um: unproven.polygon.map(um),
    }
}

/// What is not proven at the ends of the bearing clearance; `None` where both are.
fn unproven_range(swept: &PoseResult) -> Option<[Option<UnprovenRecord>; 2]> {
    let ends = swept.with_clearance.as_ref()?;
    let ends = ends
        .each_ref()
        .map(|end| end.as_ref().err().map(unproven_record));
    ends.iter().any(Option::is_some).then_some(ends)
}

/// The same rotation in (−π, π].
fn principal(rotation: f64) -> f64 {
    let turned = rotation - TAU * (rotation / TAU).round();
    if turned <= -std::f64::consts::PI {
        turned + TAU
    } else {
        turned
    }
}

fn contact_record(assembly: &GearPair, side: Side, contact: &Contact) -> ContactRecord {
    let class = ContactClass::of(assembly, side, contact);
    let Touch {
        tooth,
        curve,
        radius,
    } = contact.wheel;
    ContactRecord {
        wheel_tooth: tooth,
        pinion_tooth: contact.pinion.tooth,
        wheel_curve: curve.name(),
        pinion_curve: contact.pinion.curve.name(),
        wheel_radius_mm: radius,
        pinion_radius_mm: contact.pinion.radius,
        point_mm: [contact.point.x, contact.point.y],
        normal: [contact.normal.x, contact.normal.y],
        class: class.kind.name(),
        tip_gear: class.tip.map(Member::name),
        tip_moment: class.moment.map(|moment| moment.name()),
    }
}

fn summary_record(summary: &Summary, contact: &ContactCount) -> SummaryRecord {
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
        contact: contact_count_record(contact),
    }
}

/// `mating` as results write it.
pub fn mating_record(mating: &Mating) -> MatingRecord {
    MatingRecord {
        wheel_tooth: mating.wheel_tooth,
        pinion_tooth: mating.pinion_tooth,
        flank: mating.flank.name(),
        fraction: mating.fraction,
    }
}
