//! A map of contact classes over centre distance and mesh phase.

use super::checks::CheckedPair;
use super::onset::first_form_onset;
use crate::analytic::limits;
use crate::contact::{PairAtDistance, PoseClass, reach};
use crate::error::{Error, Tick};
use crate::numeric::rank;
use crate::pair::{GearPair, Mating, Member};
use crate::parallel;

/// Rows and columns of a map (tuned: what can be distinguished on a sheet).
pub const MAP_ROWS: u32 = 60;
const COLUMNS: u32 = 60;
/// Margin above and below the range, modules.
const ROOM: f64 = 0.05;

/// A grid of poses.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Map {
    /// Mating of the first column; the columns cover one pitch from there.
    pub start: Mating,
    /// Centre distances of the rows, mm, rising.
    pub distances: Vec<f64>,
    /// Fractions of a pitch of the columns.
    pub fractions: Vec<f64>,
    /// The cells, row by row.
    pub cells: Vec<MapCell>,
    /// Marked centre distances, ascending; some may be below the rows.
    pub limits: Vec<Limit>,
}

/// One pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MapCell {
    /// Class of the contacts.
    pub class: PoseClass,
    /// `j_wt`, mm.
    pub backlash: Option<f64>,
}

/// A significant centre distance.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Limit {
    /// Its name.
    pub name: String,
    /// The distance, mm.
    pub distance: f64,
}

impl Limit {
    pub(in crate::analysis) fn new(name: &str, distance: f64) -> Limit {
        let name = name.to_owned();
        Limit { name, distance }
    }
}

/// The map of `group`'s pair over one pitch from `start`. `tick` is called after each row; a break ends it.
///
/// # Errors
/// [`Error::Interrupted`]. A lost contact leaves its cell [`PoseClass::Unproven`].
pub fn map(group: &CheckedPair, start: Mating, tick: &Tick) -> Result<Map, Error> {
    let assembly = &group.assembly;
    let limits = limits_of(group);
    let module = assembly.gear(Member::Wheel).gear().basic_data().module();
    let [nearest, farthest] = reach(assembly);
    let ends = |pick: fn(f64, f64) -> f64| limits.iter().map(|limit| limit.distance).reduce(pick);
    let middle = assembly.center_distance();
    // Not far below the distance at which tips enter roots: further down every pose is jammed.
    let jam = middle - least_clearance(assembly);
    let lowest = ends(f64::min).unwrap_or(middle).max(jam).min(middle);
    let low = (lowest - ROOM * module).max(nearest);
    let high = (ends(f64::max).unwrap_or(middle) + ROOM * module).min(farthest);
    let distances: Vec<f64> = (0..MAP_ROWS)
        .map(|row| low + (high - low) * (f64::from(row) + 0.5) / f64::from(MAP_ROWS))
        .collect();
    let fractions: Vec<f64> = (0..COLUMNS)
        .map(|column| f64::from(column) / f64::from(COLUMNS))
        .collect();
    let as_assembled = PairAtDistance::new(assembly);
    let rows = parallel::map(distances.iter().copied(), |distance| {
        let there = as_assembled.at(distance)?;
        let radius = there
            .assembly()
            .operating_pitch_radius(there.assembly().free());
        let cells: Result<Vec<MapCell>, Error> = fractions
            .iter()
            .map(|&fraction| {
                let mating = start.onward(there.assembly(), fraction);
                match there.lost_motion(&mating) {
                    Ok(found) => Ok(MapCell {
                        class: PoseClass::of(there.assembly(), &found),
                        backlash: found.angle().map(|angle| angle * radius),
                    }),
                    Err(error) if error.pose_failure().is_some() => Ok(MapCell {
                        class: PoseClass::Unproven,
                        backlash: None,
                    }),
                    Err(error) => Err(error),
                }
            })
            .collect();
        Error::if_stopped(tick(1)).and(cells)
    });
    let mut cells = Vec::new();
    for row in rows {
        cells.extend(row?);
    }
    Ok(Map {
        start,
        distances,
        fractions,
        cells,
        limits,
    })
}

fn limits_of(group: &CheckedPair) -> Vec<Limit> {
    let assembly: &GearPair = &group.assembly;
    let a = assembly.center_distance();
    let module = assembly.gear(Member::Wheel).gear().basic_data().module();
    let mut limits = vec![Limit::new("a of the pair", a)];
    let zero = limits::zero_backlash_distance(assembly);
    limits.extend(zero.map(|zero| Limit::new("zero backlash, K (17)", zero)));
    if let Ok(Some(zero)) = &group.zero {
        limits.push(Limit::new("zero backlash, outlines", zero.distance));
    }
    if let Ok(Some(onset)) = &group.onset {
        limits.push(Limit::new("non-involute contact, outlines", onset.distance));
    }
    limits.push(Limit::new("tip at form circle", first_form_onset(assembly)));
    // K (8) is violated where a tip reaches the end of the base tangent.
    let [wheel, pinion] = Member::BOTH.map(|member| {
        let tangent = limits::tip_tangent(assembly.gear(member).gear());
        tangent.hypot(assembly.least_distance())
    });
    limits.push(Limit::new("tip at base circle, K (8)", wheel.max(pinion)));
    // a − r_a − r_f is below the required clearance by this.
    let least = least_clearance(assembly);
    for modules in [limits::LEAST_CLEARANCE, limits::RECOMMENDED_CLEARANCE] {
        limits.push(Limit::new(
            &format!("radial clearance {modules} m"),
            a - least + modules * module,
        ));
    }
    let [nearest, _] = reach(assembly);
    limits.retain(|limit| limit.distance >= nearest);
    limits.sort_by_cached_key(|limit| rank(limit.distance));
    limits
}

fn least_clearance(assembly: &GearPair) -> f64 {
    f64::min(
        assembly.radial_clearance(Member::Wheel),
        assembly.radial_clearance(Member::Pinion),
    )
}
