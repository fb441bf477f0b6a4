//! A pose of a result: the keys of the interface, units in their names.

use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::tally::RunTally;
use gearlash::contact::{Contact, ContactClass, LostMotion, PoseResult, Touch, Unproven};
use gearlash::gear::Side;
use gearlash::pair::{Backlash, GearPair, Mating, Member};
use gearlash_files::numbers::um_ascii;
use serde::Serialize;
use std::f64::consts::TAU;

/// What a result says of a run before its poses.
#[derive(Debug, Clone, Copy)]
pub(super) struct RunHead {
    pub(super) center_distance_mm: f64,
    pub(super) material: &'static str,
    pub(super) phase: Option<PhaseRecord>,
    pub(super) operating_pressure_angle_deg: f64,
}

impl RunHead {
    pub(super) fn of(run: &RunTally) -> RunHead {
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
pub(super) struct PhaseRecord {
    pub(super) wheel_tooth: u32,
    pub(super) pinion_tooth: u32,
}

#[derive(Debug, Serialize)]
pub(super) struct PoseRecord {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) wheel_rotation_rad: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) pinion_rotation_rad: Option<f64>,
    pub(super) mating: MatingRecord,
    pub(super) right_rad: Option<f64>,
    pub(super) left_rad: Option<f64>,
    pub(super) lost_motion_rad: Option<f64>,
    pub(super) j_wt_um: Option<f64>,
    pub(super) j_t_um: Option<f64>,
    pub(super) j_bn_um: Option<f64>,
    pub(super) j_r_um: Option<f64>,
    pub(super) lost_motion_arcmin: ArcminRecord,
    pub(super) j_wt_range_um: [Option<f64>; 2],
    pub(super) error_bound_um: Option<f64>,
    pub(super) status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) unproven: Option<UnprovenRecord>,
    /// At `a − c` and at `a + c`; left out where both are proven.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) unproven_range: Option<[Option<UnprovenRecord>; 2]>,
    pub(super) class: &'static str,
    pub(super) right: Option<ContactRecord>,
    pub(super) left: Option<ContactRecord>,
    pub(super) analytic: AnalyticRecord,
}

/// Lost motion at each gear, its mate standing still.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct ArcminRecord {
    pub(super) wheel: Option<f64>,
    pub(super) pinion: Option<f64>,
}

impl ArcminRecord {
    pub(super) fn of(backlash: Option<Backlash>) -> ArcminRecord {
        let at = |gear| Some(backlash?.arcmin(gear));
        ArcminRecord {
            wheel: at(Member::Wheel),
            pinion: at(Member::Pinion),
        }
    }
}

/// Why a pose is not proven, and the values that nothing vouches for.
#[derive(Debug, Clone, Serialize)]
pub(super) struct UnprovenRecord {
    pub(super) reason: String,
    pub(super) exact_j_wt_um: Option<f64>,
    pub(super) polygon_j_wt_um: Option<f64>,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct MatingRecord {
    pub(super) wheel_tooth: u32,
    pub(super) pinion_tooth: u32,
    pub(super) flank: &'static str,
    pub(super) fraction: f64,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct ContactRecord {
    pub(super) wheel_tooth: u32,
    pub(super) pinion_tooth: u32,
    pub(super) wheel_curve: &'static str,
    pub(super) pinion_curve: &'static str,
    pub(super) wheel_radius_mm: f64,
    pub(super) pinion_radius_mm: f64,
    pub(super) point_mm: [f64; 2],
    /// Of helical gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) section_mm: Option<f64>,
    pub(super) normal: [f64; 2],
    pub(super) class: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) tip_gear: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) tip_moment: Option<&'static str>,
}

#[derive(Debug, Serialize)]
pub(super) struct AnalyticRecord {
    pub(super) michalec_um: Option<f64>,
    pub(super) involute_um: Option<f64>,
    pub(super) line_of_action_um: Option<f64>,
}

pub(super) fn um(length: f64) -> f64 {
    length * 1e3
}

pub(super) fn pose_record(assembly: &GearPair, pose: &ComparedPose) -> PoseRecord {
    let result = &pose.simulated;
    let backlash = result.backlash.map(|j_wt| assembly.backlash(j_wt));
    let mating = result.pose.mating();
    let found = result.proven();
    let angle = found.and_then(LostMotion::angle);
    let rotation =
        |member: Member| (assembly.locked() == member).then(|| result.pose.locked_rotation());
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
        j_wt_um: result.backlash.map(um),
        j_t_um: backlash.map(|of| um(of.j_t)),
        j_bn_um: backlash.map(|of| um(of.j_bn)),
        j_r_um: backlash.and_then(|of| of.j_r).map(um),
        lost_motion_arcmin: ArcminRecord::of(backlash),
        j_wt_range_um: result.range().map(|end| end.map(um)),
        error_bound_um: angle.and(result.error_bound).map(um),
        status: result.status().name(),
        unproven: result.found.as_ref().err().map(unproven_record),
        unproven_range: unproven_range(result),
        class: result.class(assembly).name(),
        right: contact(Side::Right),
        left: contact(Side::Left),
        analytic: AnalyticRecord {
            michalec_um: pose.michalec.map(um),
            involute_um: pose.involute.map(um),
            line_of_action_um: pose.line_of_action.map(um),
        },
    }
}

pub(super) fn unproven_record(unproven: &Unproven) -> UnprovenRecord {
    UnprovenRecord {
        reason: unproven.reason.clone(),
        exact_j_wt_um: unproven.exact.map(um),
        polygon_j_wt_um: unproven.polygon.map(um),
    }
}

/// What is not proven at the ends of the bearing clearance; `None` where both are.
pub(super) fn unproven_range(result: &PoseResult) -> Option<[Option<UnprovenRecord>; 2]> {
    let ends = result.with_clearance.as_ref()?;
    let ends = ends
        .each_ref()
        .map(|end| end.as_ref().err().map(unproven_record));
    ends.iter().any(Option::is_some).then_some(ends)
}

/// The same rotation in (−π, π].
pub(super) fn principal(rotation: f64) -> f64 {
    let turned = rotation - TAU * (rotation / TAU).round();
    if turned <= -std::f64::consts::PI {
        turned + TAU
    } else {
        turned
    }
}

pub(super) fn contact_record(assembly: &GearPair, side: Side, contact: &Contact) -> ContactRecord {
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
        section_mm: assembly.is_helical().then_some(contact.section),
        normal: [contact.normal.x, contact.normal.y],
        class: class.kind.name(),
        tip_gear: class.tip.map(Member::name),
        tip_moment: class.moment.map(|moment| moment.name()),
    }
}

pub(super) fn mating_record(mating: &Mating) -> MatingRecord {
    MatingRecord {
        wheel_tooth: mating.wheel_tooth,
        pinion_tooth: mating.pinion_tooth,
        flank: mating.flank.name(),
        fraction: mating.fraction,
    }
}

/// Why something is not proven, and the values that it leaves in doubt.
fn doubt(unproven: &Unproven) -> String {
    let value = |name: &str, value: Option<f64>| {
        let um = um_ascii(value?, 3);
        Some(format!("{name} method, not proven: {um} µm"))
    };
    let values = [
        value("exact", unproven.exact),
        value("polygon", unproven.polygon),
    ];
    let parts = [Some(unproven.reason.clone())].into_iter().chain(values);
    parts.flatten().collect::<Vec<_>>().join("; ")
}

/// Everything about `pose` that is not proven, in words.
pub fn doubts(pose: &ComparedPose) -> String {
    let result = &pose.simulated;
    let here = result.found.as_ref().err().map(doubt);
    let ends = result
        .with_clearance
        .iter()
        .flatten()
        .zip(["a − c", "a + c"]);
    let ends = ends.filter_map(|(end, name)| {
        let doubt = doubt(end.as_ref().err()?);
        Some(format!("at {name} of the bearing clearance: {doubt}"))
    });
    here.into_iter().chain(ends).collect::<Vec<_>>().join("; ")
}
