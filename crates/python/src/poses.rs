//! Lost motion: at one pose, at many, over whole revolutions.

use crate::call::work;
use crate::error::Outcome;
use crate::pair::{Pair, mating};
use gearlash::analysis::compare::compared;
use gearlash::contact::{Method, PoseResult, lost_motion_at, sweep_blocks};
use gearlash::error::{Error, Tick};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{Mating, SweepPlan};
use gearlash_results::{Array, Values, pose_arrays, pose_json};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use rayon::prelude::*;

/// One pose as the JSON of results.
#[pyfunction]
pub fn lost_motion(
    py: Python<'_>,
    pair: &Pair,
    teeth: [i64; 2],
    left: bool,
    fraction: f64,
    distance: Option<f64>,
    material: Option<&str>,
) -> Outcome<String> {
    let (_, assembly) = pair.assembly(distance, material)?;
    let mating = mating(&assembly, teeth, left, fraction)?;
    let found = py.detach(|| {
        let pose = lost_motion_at(&assembly, mating)?;
        let pose = compared(&assembly, pose, pair.study().tolerance_um);
        Ok::<_, Error>(pose_json(&assembly, &pose))
    });
    Ok(found?)
}

/// Centre distance, material, whether poses are proven, and threads: a tuple in Python.
#[derive(FromPyObject)]
pub struct PoseOptions(Option<f64>, Option<String>, bool, Option<usize>);

impl PoseOptions {
    fn assembly(&self, pair: &Pair) -> Outcome<AssembledPair> {
        let PoseOptions(distance, material, ..) = self;
        let (_, assembly) = pair.assembly(*distance, material.as_deref())?;
        Ok(assembly)
    }
}

/// The poses of these arrays of equal length, as arrays.
#[pyfunction]
pub fn lost_motions<'py>(
    py: Python<'py>,
    pair: &Pair,
    teeth: [PyReadonlyArray1<'py, i64>; 2],
    left: PyReadonlyArray1<'py, bool>,
    fraction: PyReadonlyArray1<'py, f64>,
    how: PoseOptions,
) -> Outcome<Bound<'py, PyDict>> {
    let assembly = how.assembly(pair)?;
    let [wheels, pinions] = teeth.each_ref().map(|teeth| teeth.as_array());
    let (lefts, fractions) = (left.as_array(), fraction.as_array());
    let mut matings = Vec::with_capacity(wheels.len());
    for (((wheel, pinion), left), fraction) in wheels.iter().zip(pinions).zip(lefts).zip(fractions)
    {
        matings.push(mating(&assembly, [*wheel, *pinion], *left, *fraction)?);
    }
    pose_columns(py, assembly, matings, &how)
}

/// One wheel revolution, or every mating of the cycle, on one flank.
#[pyfunction]
pub fn revolution<'py>(
    py: Python<'py>,
    pair: &Pair,
    steps_per_pitch: u32,
    start: [i64; 2],
    hunting: bool,
    left: bool,
    how: PoseOptions,
) -> Outcome<Bound<'py, PyDict>> {
    let assembly = how.assembly(pair)?;
    let first = mating(&assembly, start, false, 0.0)?;
    let first = (first.wheel_tooth, first.pinion_tooth);
    let plan = if hunting {
        SweepPlan::hunting_cycle(&assembly, steps_per_pitch, first)
    } else {
        SweepPlan::wheel_revolution(&assembly, steps_per_pitch, first)
    };
    let poses = plan.poses();
    if !(1..=MOST_POSES).contains(&poses) {
        let allowed = format!("{poses} poses, allowed are 1 … {MOST_POSES}");
        return Err(format!("steps_per_pitch = {steps_per_pitch}: {allowed}").into());
    }
    let mut matings = plan.matings(&assembly);
    if left {
        for mating in &mut matings {
            *mating = mating.at_flank(&assembly, Side::Left);
        }
    }
    pose_columns(py, assembly, matings, &how)
}

/// Most poses that one call generates: 90 bytes each while it works.
const MOST_POSES: u64 = 100_000_000;

/// Poses whose array entries a thread makes in one step (tuned: some 0.1 ms).
const POSES_PER_TASK: usize = 256;

/// The columns of the poses `matings` as arrays by name, and the centre distance.
fn pose_columns<'py>(
    py: Python<'py>,
    pair: AssembledPair,
    matings: Vec<Mating>,
    PoseOptions(_, _, certify, threads): &PoseOptions,
) -> Outcome<Bound<'py, PyDict>> {
    let distance = pair.center_distance();
    let found = work(py, *threads, |tick| arrays(&pair, &matings, *certify, tick))?;
    let columns = PyDict::new(py);
    for Array { name, values } in found {
        match values {
            Values::Counts(counts) => columns.set_item(name, counts.into_pyarray(py))?,
            Values::Numbers(numbers) => columns.set_item(name, numbers.into_pyarray(py))?,
            Values::Words(places, words) => {
                columns.set_item(name, (places.into_pyarray(py), PyTuple::new(py, words)?))?;
            }
        }
    }
    let poses = PyDict::new(py);
    poses.set_item("center_distance_mm", distance)?;
    poses.set_item("columns", columns)?;
    Ok(poses)
}

fn arrays(
    pair: &AssembledPair,
    matings: &[Mating],
    certify: bool,
    tick: &Tick,
) -> Result<Vec<Array>, Error> {
    let mut all = pose_arrays(pair, []);
    let each = &mut |poses: Vec<PoseResult>| {
        let parts = poses.into_par_iter().chunks(POSES_PER_TASK);
        let parts = parts.map(|poses| pose_arrays(pair, poses));
        for part in parts.collect::<Vec<_>>() {
            for (array, more) in all.iter_mut().zip(part) {
                array.append(more);
            }
        }
        Ok::<(), Error>(())
    };
    let method = Method::Exact { certify };
    sweep_blocks(pair, None, method, matings, 0.0, tick, each)?;
    Ok(all)
}
