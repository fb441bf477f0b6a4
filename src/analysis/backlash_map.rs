//! Backlash of a drawn pair over its mesh cycle and the centre distance.

use super::diagnosis::Limit;
use super::extremes::RunExtremes;
use super::study::{Material, Study};
use crate::contact::{LostMotion, OutlineKernel, Status};
use crate::error::{Error, Tick};
use crate::gear::Side;
use crate::numeric::rank;
use crate::outline::OutlinePair;
use crate::pair::{Mating, Member, SweepPlan};
use crate::parallel;

/// Rows of a map (tuned: what can be distinguished on a sheet).
pub const BACKLASH_MAP_ROWS: u32 = 60;
/// Limit of columns, for the same reason.
const MOST_COLUMNS: u64 = 120;
/// Poses per mating, and limit of poses per row (tuned: a few seconds per map). Longer cycles are sampled more thinly.
const POSES_PER_MATING: u64 = 2;
const MOST_IN_ROW: u64 = 1200;
/// Margin above and below the range, in parts of the lesser tooth depth.
const MARGIN: f64 = 0.05;

/// A grid of poses of one material.
#[derive(Debug, Clone)]
pub struct BacklashMap {
    /// The thickness.
    pub material: Material,
    /// Teeth of wheel and pinion.
    pub teeth: [u32; 2],
    /// The mating of the first pose.
    pub start: Mating,
    /// Matings of the cycle, shared by the columns.
    pub matings: u64,
    /// Centre distances of the rows, mm, rising.
    pub distances: Vec<f64>,
    /// Number of cells per row.
    pub columns: usize,
    /// The cells, row by row.
    pub cells: Vec<BacklashCell>,
    /// Marked centre distances, ascending.
    pub limits: Vec<Limit>,
}

/// The pose of a cell: of its sampled poses the one that interferes most, otherwise one that is undecided or out of
/// mesh, otherwise the one with the least backlash.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BacklashCell {
    /// Pitches from the first pose.
    pub pitches: f64,
    /// Which teeth mate.
    pub mating: Mating,
    /// The status of the pose.
    pub status: Status,
    /// `j_wt`, mm.
    pub backlash: Option<f64>,
}

impl BacklashMap {
    /// The map of each material of a drawn pair around its first centre distance in `each`, the extremes of `study`;
    /// empty for gears by their data. `tick` is called after each row; a break ends it.
    ///
    /// # Errors
    /// [`Error::Interrupted`].
    pub fn of_study(
        study: &Study,
        each: &[RunExtremes],
        tick: &Tick,
    ) -> Result<Vec<BacklashMap>, Error> {
        let (wheel, pinion) = match study.sweep {
            Some(SweepPlan::Revolution { start, .. }) => start,
            _ => (1, 1),
        };
        let start = Mating::at(wheel, pinion, Side::Right);
        let run = |material| each.iter().find(move |run| run.material == material);
        let runs = study.material_names().filter_map(run);
        let maps =
            runs.filter_map(|run| Some(BacklashMap::new(run, run.assembly.drawn()?, start, tick)));
        maps.collect()
    }

    fn new(
        run: &RunExtremes,
        pair: &OutlinePair,
        start: Mating,
        tick: &Tick,
    ) -> Result<BacklashMap, Error> {
        let from = run.assembles_from.map(|from| from.high);
        let (distances, limits) = shown(pair, from);
        // A whole number of columns per mating if they fit.
        let columns = match run.matings {
            few if few <= MOST_COLUMNS => few * (MOST_COLUMNS / few),
            _ => MOST_COLUMNS,
        };
        let in_row = (POSES_PER_MATING * run.matings).min(MOST_IN_ROW);
        let in_cell = in_row.div_ceil(columns);
        let apart = run.matings as f64 / (columns * in_cell) as f64;
        let kernel = OutlineKernel::new(pair);
        let rows = parallel::map(distances.iter().copied(), |distance| {
            let pair = pair.at(distance)?;
            let radius = pair.operating_pitch_radius(pair.free());
            let cells = (0..columns).filter_map(|column| {
                let places = (column * in_cell..).take(in_cell as usize);
                let poses = places.map(|k| {
                    let pitches = k as f64 * apart;
                    let mating = start.onward(&pair, pitches);
                    let found = kernel.lost_motion_at(&pair, &mating);
                    let found = found.as_ref().ok();
                    BacklashCell {
                        pitches,
                        mating,
                        status: found.map_or(Status::Unproven, LostMotion::status),
                        backlash: found
                            .and_then(LostMotion::angle)
                            .map(|angle| angle * radius),
                    }
                });
                // A jammed pose has no value.
                let backlash = |cell: &BacklashCell| cell.backlash.unwrap_or(f64::NEG_INFINITY);
                poses.min_by(|a, b| {
                    let statuses = order(a.status).cmp(&order(b.status));
                    statuses.then(backlash(a).total_cmp(&backlash(b)))
                })
            });
            let cells: Vec<BacklashCell> = cells.collect();
            Error::if_stopped(tick(1)).map(|()| cells)
        });
        let rows: Result<Vec<Vec<BacklashCell>>, Error> = rows.into_iter().collect();
        Ok(BacklashMap {
            material: run.material,
            teeth: Member::BOTH.map(|member| pair.gear(member).teeth()),
            start,
            matings: run.matings,
            distances,
            columns: columns as usize,
            cells: rows?.concat(),
            limits,
        })
    }
}

/// Centre distances of the rows, mm, and the marked ones.
fn shown(pair: &OutlinePair, assembles_from: Option<f64>) -> (Vec<f64>, Vec<Limit>) {
    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
    let mut limits = vec![
        Limit::new("a of the pair", pair.center_distance()),
        Limit::new("a tip on a root circle", pair.tip_on_root()),
    ];
    limits.extend(assembles_from.map(|from| Limit::new("assembles from here on", from)));
    limits.sort_by_cached_key(|limit| rank(limit.distance));
    let depth = [wheel, pinion].map(|gear| gear.tip_radius() - gear.root_radius());
    let margin = MARGIN * f64::min(depth[0], depth[1]);
    let ends = |pick: fn(f64, f64) -> f64| limits.iter().map(|limit| limit.distance).reduce(pick);
    let a = pair.center_distance();
    let low = (ends(f64::min).unwrap_or(a) - margin).max(pair.least_distance());
    let high = ends(f64::max).unwrap_or(a) + margin;
    let rows = f64::from(BACKLASH_MAP_ROWS);
    let row = |row: u32| low + (high - low) * (f64::from(row) + 0.5) / rows;
    ((0..BACKLASH_MAP_ROWS).map(row).collect(), limits)
}

/// Rank of a status; the least one represents the cell.
fn order(status: Status) -> u8 {
    match status {
        Status::Jammed | Status::Interference => 0,
        Status::Unproven => 1,
        Status::NoContact => 2,
        Status::Clear => 3,
    }
}
