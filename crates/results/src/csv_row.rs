//! Poses of a result as flat rows.

use super::records::{PoseRecord, RunHead};
use super::table::Cell;
use std::io::{Error, Result, Write};

/// CSV as it grows: names above the first row, a row a pose.
pub(super) struct Csv<W: Write> {
    writer: csv::Writer<W>,
    begun: bool,
}

impl<W: Write> Csv<W> {
    pub fn new(out: W) -> Csv<W> {
        Csv {
            writer: csv::Writer::from_writer(out),
            begun: false,
        }
    }

    pub fn row(&mut self, run: &RunHead, pose: &PoseRecord) -> Result<()> {
        let columns = columns(run, pose);
        if !self.begun {
            self.begun = true;
            let names = columns.iter().map(|(name, _)| name);
            self.writer.write_record(names).map_err(of_csv)?;
        }
        let cells = columns.map(|(_, cell)| cell);
        self.writer.serialize(cells.as_slice()).map_err(of_csv)
    }

    pub fn finish(mut self) -> Result<()> {
        self.writer.flush()
    }
}

/// Name and value of each column.
fn columns(run: &RunHead, pose: &PoseRecord) -> [(&'static str, Cell); 40] {
    let unproven = pose.unproven.as_ref();
    let end = |end: usize| {
        let ends = pose.unproven_range.as_ref()?;
        Some(ends[end].as_ref()?.reason.clone())
    };
    let (right, left) = (pose.right.as_ref(), pose.left.as_ref());
    [
        ("center_distance_mm", run.center_distance_mm.into()),
        ("material", run.material.into()),
        (
            "phase_wheel_tooth",
            run.phase.map(|phase| phase.wheel_tooth).into(),
        ),
        (
            "phase_pinion_tooth",
            run.phase.map(|phase| phase.pinion_tooth).into(),
        ),
        ("wheel_tooth", pose.mating.wheel_tooth.into()),
        ("pinion_tooth", pose.mating.pinion_tooth.into()),
        ("flank", pose.mating.flank.into()),
        ("fraction", pose.mating.fraction.into()),
        ("wheel_rotation_rad", pose.wheel_rotation_rad.into()),
        ("pinion_rotation_rad", pose.pinion_rotation_rad.into()),
        ("right_rad", pose.right_rad.into()),
        ("left_rad", pose.left_rad.into()),
        ("lost_motion_rad", pose.lost_motion_rad.into()),
        ("j_wt_um", pose.j_wt_um.into()),
        ("j_t_um", pose.j_t_um.into()),
        ("j_bn_um", pose.j_bn_um.into()),
        ("j_wt_range_min_um", pose.j_wt_range_um[0].into()),
        ("j_wt_range_max_um", pose.j_wt_range_um[1].into()),
        ("error_bound_um", pose.error_bound_um.into()),
        ("status", pose.status.into()),
        ("class", pose.class.into()),
        ("right_wheel_tooth", right.map(|c| c.wheel_tooth).into()),
        ("right_pinion_tooth", right.map(|c| c.pinion_tooth).into()),
        ("right_wheel_curve", right.map(|c| c.wheel_curve).into()),
        ("right_pinion_curve", right.map(|c| c.pinion_curve).into()),
        ("left_wheel_tooth", left.map(|c| c.wheel_tooth).into()),
        ("left_pinion_tooth", left.map(|c| c.pinion_tooth).into()),
        ("left_wheel_curve", left.map(|c| c.wheel_curve).into()),
        ("left_pinion_curve", left.map(|c| c.pinion_curve).into()),
        ("michalec_um", pose.analytic.michalec_um.into()),
        ("involute_um", pose.analytic.involute_um.into()),
        ("line_of_action_um", pose.analytic.line_of_action_um.into()),
        (
            "unproven_reason",
            unproven.map(|of| of.reason.clone()).into(),
        ),
        (
            "unproven_exact_j_wt_um",
            unproven.and_then(|of| of.exact_j_wt_um).into(),
        ),
        (
            "unproven_polygon_j_wt_um",
            unproven.and_then(|of| of.polygon_j_wt_um).into(),
        ),
        ("unproven_range_min_reason", end(0).into()),
        ("unproven_range_max_reason", end(1).into()),
        ("j_r_um", pose.j_r_um.into()),
        (
            "lost_motion_wheel_arcmin",
            pose.lost_motion_arcmin.wheel.into(),
        ),
        (
            "lost_motion_pinion_arcmin",
            pose.lost_motion_arcmin.pinion.into(),
        ),
    ]
}

/// The writer's own error, where it is one.
fn of_csv(error: csv::Error) -> Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => Error::other(format!("{other:?}")),
    }
}
