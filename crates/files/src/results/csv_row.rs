//! One pose of a result as a flat row.

use super::{PoseRecord, RunHead};
use serde::Serialize;

/// One pose as a flat row.
#[derive(Debug, Serialize)]
pub(super) struct CsvRow<'r> {
    center_distance_mm: f64,
    material: &'static str,
    phase_wheel_tooth: Option<u32>,
    phase_pinion_tooth: Option<u32>,
    wheel_tooth: u32,
    pinion_tooth: u32,
    flank: &'static str,
    fraction: f64,
    wheel_rotation_rad: Option<f64>,
    pinion_rotation_rad: Option<f64>,
    right_rad: Option<f64>,
    left_rad: Option<f64>,
    lost_motion_rad: Option<f64>,
    j_wt_um: Option<f64>,
    j_t_um: Option<f64>,
    j_bn_um: Option<f64>,
    j_wt_range_min_um: Option<f64>,
    j_wt_range_max_um: Option<f64>,
    error_bound_um: Option<f64>,
    status: &'static str,
    class: &'static str,
    right_wheel_tooth: Option<u32>,
    right_pinion_tooth: Option<u32>,
    right_wheel_curve: Option<&'static str>,
    right_pinion_curve: Option<&'static str>,
    left_wheel_tooth: Option<u32>,
    left_pinion_tooth: Option<u32>,
    left_wheel_curve: Option<&'static str>,
    left_pinion_curve: Option<&'static str>,
    michalec_um: Option<f64>,
    involute_um: Option<f64>,
    line_of_action_um: Option<f64>,
    unproven_reason: Option<&'r str>,
    unproven_exact_j_wt_um: Option<f64>,
    unproven_polygon_j_wt_um: Option<f64>,
    unproven_range_min_reason: Option<&'r str>,
    unproven_range_max_reason: Option<&'r str>,
}

impl<'r> CsvRow<'r> {
    pub(super) fn new(run: &RunHead, pose: &'r PoseRecord) -> CsvRow<'r> {
        let unproven = pose.unproven.as_ref();
        let end = |end: usize| {
            let ends = pose.unproven_range.as_ref()?;
            Some(ends[end].as_ref()?.reason.as_str())
        };
        let (right, left) = (pose.right.as_ref(), pose.left.as_ref());
        CsvRow {
            center_distance_mm: run.center_distance_mm,
            material: run.material,
            phase_wheel_tooth: run.phase.map(|phase| phase.wheel_tooth),
            phase_pinion_tooth: run.phase.map(|phase| phase.pinion_tooth),
            wheel_tooth: pose.mating.wheel_tooth,
            pinion_tooth: pose.mating.pinion_tooth,
            flank: pose.mating.flank,
            fraction: pose.mating.fraction,
            wheel_rotation_rad: pose.wheel_rotation_rad,
            pinion_rotation_rad: pose.pinion_rotation_rad,
            right_rad: pose.right_rad,
            left_rad: pose.left_rad,
            lost_motion_rad: pose.lost_motion_rad,
            j_wt_um: pose.j_wt_um,
            j_t_um: pose.j_t_um,
            j_bn_um: pose.j_bn_um,
            j_wt_range_min_um: pose.j_wt_range_um[0],
            j_wt_range_max_um: pose.j_wt_range_um[1],
            error_bound_um: pose.error_bound_um,
            status: pose.status,
            class: pose.class,
            right_wheel_tooth: right.map(|c| c.wheel_tooth),
            right_pinion_tooth: right.map(|c| c.pinion_tooth),
            right_wheel_curve: right.map(|c| c.wheel_curve),
            right_pinion_curve: right.map(|c| c.pinion_curve),
            left_wheel_tooth: left.map(|c| c.wheel_tooth),
            left_pinion_tooth: left.map(|c| c.pinion_tooth),
            left_wheel_curve: left.map(|c| c.wheel_curve),
            left_pinion_curve: left.map(|c| c.pinion_curve),
            michalec_um: pose.analytic.michalec_um,
            involute_um: pose.analytic.involute_um,
            line_of_action_um: pose.analytic.line_of_action_um,
            unproven_reason: unproven.map(|of| of.reason.as_str()),
            unproven_exact_j_wt_um: unproven.and_then(|of| of.exact_j_wt_um),
            unproven_polygon_j_wt_um: unproven.and_then(|of| of.polygon_j_wt_um),
            unproven_range_min_reason: end(0),
            unproven_range_max_reason: end(1),
        }
    }
}
