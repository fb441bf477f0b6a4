//! Backlash of a pair of outlines over its mesh cycle and the centre distance.

use super::cycle::{Cycle, OutlinePose};
use super::{OutlineRun, OutlineStudy, TurnsFrom};
use crate::analysis::diagnosis::Limit;
use crate::contact::{OutlineKernel, Status};
use crate::error::Error;
use crate::pair::{Mating, Member};
use crate::parallel;
use std::ops::ControlFlow;

/// Rows of a map (tuned: what can be told apart on a sheet).
pub const OUTLINE_MAP_ROWS: u32 = 60;
/// Columns at most, likewise.
const MOST_COLUMNS: u64 = 120;
/// Poses a mating, and poses of a row at most (tuned: some seconds for a map); longer cycles are looked at more thinly.
const EACH: u64 = 2;
const MOST_IN_ROW: u64 = 1200;
/// Room above and below what is shown, of the lesser tooth depth.
const ROOM: f64 = 0.05;

/// A grid of poses.
#[derive(Debug, Clone)]
pub struct OutlineMap {
    /// The mating of the first pose.
    pub start: Mating,
    /// Matings of the cycle, shared by the columns.
    pub matings: u64,
    /// Centre distances of the rows, mm, rising.
    pub distances: Vec<f64>,
    /// Cells of a row.
    pub columns: usize,
    /// Row by row: of the poses looked at in a cell the one that binds most, else one that is not settled or out of mesh, else the one with the
    /// least backlash.
    pub cells: Vec<OutlinePose>,
    /// What is drawn across, from the least centre distance up.
    pub limits: Vec<Limit>,
}

impl OutlineRun {
    /// The map round this run's centre distance and `zero`, its zero-backlash distance, from the first pose of `study` on. `tick` is called after each row; a
    /// break ends it.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn map(
        &self,
        study: &OutlineStudy,
        zero: Option<&TurnsFrom>,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<OutlineMap, Error> {
        let start = study.start;
        let (distances, limits) = self.shown(zero);
        // A whole number of columns a mating where they fit.
        let columns = match self.matings {
            few if few <= MOST_COLUMNS => few * (MOST_COLUMNS / few),
            _ => MOST_COLUMNS,
        };
        let in_cell = (EACH * self.matings).min(MOST_IN_ROW).div_ceil(columns);
        let apart = self.matings as f64 / (columns * in_cell) as f64;
        let kernel = OutlineKernel::new(&self.pair);
        let rows = parallel::map(distances.iter().copied(), |distance| {
            let pair = self.pair.at(distance)?;
            let cells = (0..columns).filter_map(|column| {
                let places = (column * in_cell..).take(in_cell as usize);
                let poses = places.map(|k| Cycle::pose(&kernel, &pair, &start, k as f64 * apart));
                poses.min_by(|a, b| {
                    order(a)
                        .partial_cmp(&order(b))
                        .unwrap_or(std::cmp::Ordering::Equal)
                })
            });
            let cells: Vec<OutlinePose> = cells.collect();
            Error::if_stopped(tick()).map(|()| cells)
        });
        let rows: Result<Vec<Vec<OutlinePose>>, Error> = rows.into_iter().collect();
        Ok(OutlineMap {
            start,
            matings: self.matings,
            distances,
            columns: columns as usize,
            cells: rows?.concat(),
            limits,
        })
    }

    /// Centre distances of the rows, mm, and what is drawn across them.
    fn shown(&self, zero: Option<&TurnsFrom>) -> (Vec<f64>, Vec<Limit>) {
        let [wheel, pinion] = Member::BOTH.map(|member| self.pair.gear(member));
        let limit = |name: &str, distance: f64| Limit {
            name: name.to_owned(),
            distance,
        };
        let bottom = f64::max(
            wheel.tip_radius() + pinion.root_radius(),
            pinion.tip_radius() + wheel.root_radius(),
        );
        let mut limits = vec![
            limit("a of the pair", self.pair.center_distance()),
            limit("a tip on a root circle", bottom),
        ];
        limits.extend(zero.map(|zero| limit("turns freely from here on", zero.rounded())));
        limits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let depth = [wheel, pinion].map(|gear| gear.tip_radius() - gear.root_radius());
        let room = ROOM * f64::min(depth[0], depth[1]);
        let ends =
            |pick: fn(f64, f64) -> f64| limits.iter().map(|limit| limit.distance).reduce(pick);
        let a = self.pair.center_distance();
        let low = ends(f64::min).unwrap_or(a) - room;
        let low = low.max(self.pair.least_distance());
        let high = ends(f64::max).unwrap_or(a) + room;
        let rows = f64::from(OUTLINE_MAP_ROWS);
        let row = |row: u32| low + (high - low) * (f64::from(row) + 0.5) / rows;
        ((0..OUTLINE_MAP_ROWS).map(row).collect(), limits)
    }
}

/// The pose that a cell stands for comes first.
fn order(pose: &OutlinePose) -> (u8, f64) {
    match pose.status() {
        Status::Jammed | Status::Interference => (0, pose.room()),
        Status::Unproven => (1, 0.0),
        Status::NoContact => (2, 0.0),
        Status::Clear => (3, pose.room()),
    }
}
