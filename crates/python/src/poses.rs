//! Lost motion: at one pose, at many, over whole revolutions.

use crate::call::{Tick, work};
use crate::error::error;
use crate::pair::{Pair, mating};
use gearlash::analysis::compare::compare;
use gearlash::analysis::simulate::Run;
use gearlash::contact::{CutPair, ExactKernel, Method, Status, sweep_blocks};
use gearlash::error::Error;
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use gearlash_results::pose_json;
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
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
) -> PyResult<String> {
    let (material, assembly) = pair.assembly(py, distance, material)?;
    let mating = mating(py, &assembly, teeth, left, fraction)?;
    let found = py.detach(|| {
        let pose = assembly.lost_motion(mating)?;
        let run = Run {
            material,
            assembly: assembly.into(),
            phase: None,
            poses: vec![pose],
        };
        let compared = compare(vec![run], pair.study().tolerance_um);
        let json = compared[0].poses.first();
        let assembly = &compared[0].run.assembly;
        Ok::<_, Error>(json.map(|pose| pose_json(assembly, pose)))
    });
    let json = found.map_err(|reason| error(py, reason))?;
    let json = json.ok_or_else(|| error(py, "no pose was found"))?;
    json.map_err(|reason| error(py, reason))
}

/// Of which gears, and how: a tuple in Python.
#[derive(FromPyObject)]
pub struct How(Option<f64>, Option<String>, bool, Option<usize>);

impl How {
    fn assembly(&self, py: Python<'_>, pair: &Pair) -> PyResult<GearPair> {
        let How(distance, material, ..) = self;
        let (_, assembly) = pair.assembly(py, *distance, material.as_deref())?;
        Ok(assembly)
    }
}

/// The poses of these arrays, all of one length, as arrays.
#[pyfunction]
pub fn lost_motions<'py>(
    py: Python<'py>,
    pair: &Pair,
    teeth: [PyReadonlyArray1<'py, i64>; 2],
    left: PyReadonlyArray1<'py, bool>,
    fraction: PyReadonlyArray1<'py, f64>,
    how: How,
) -> PyResult<Bound<'py, PyDict>> {
    let assembly = how.assembly(py, pair)?;
    let [wheels, pinions] = teeth.each_ref().map(|teeth| teeth.as_array());
    let (lefts, fractions) = (left.as_array(), fraction.as_array());
    let mut matings = Vec::with_capacity(wheels.len());
    for (((wheel, pinion), left), fraction) in wheels.iter().zip(pinions).zip(lefts).zip(fractions)
    {
        matings.push(mating(py, &assembly, [*wheel, *pinion], *left, *fraction)?);
    }
    found(py, &assembly, matings, &how)
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
    how: How,
) -> PyResult<Bound<'py, PyDict>> {
    let assembly = how.assembly(py, pair)?;
    let first = mating(py, &assembly, start, false, 0.0)?;
    let first = (first.wheel_tooth, first.pinion_tooth);
    let plan = match hunting {
        true => SweepPlan::hunting_cycle(&assembly, steps_per_pitch, first),
        false => SweepPlan::wheel_revolution(&assembly, steps_per_pitch, first),
    };
    if !(1..=MOST_POSES).contains(&plan.poses()) {
        let poses = plan.poses();
        return Err(error(
            py,
            format!(
                "steps_per_pitch = {steps_per_pitch}: {poses} poses, allowed are 1 … {MOST_POSES}"
            ),
        ));
    }
    let mut matings = plan.matings(&assembly);
    if left {
        for mating in &mut matings {
            *mating = mating.at_flank(&assembly, Side::Left);
        }
    }
    found(py, &assembly, matings, &how)
}

/// Poses of one call that makes its own: 80 bytes each while it works.
const MOST_POSES: u64 = 100_000_000;

/// What an array keeps of a pose.
struct FoundPose {
    j_wt_um: f64,
    error_bound_um: f64,
    status: Status,
}

fn um(mm: Option<f64>) -> f64 {
    mm.map_or(f64::NAN, |mm| mm * 1e3)
}

/// The poses, each proven.
fn certified(assembly: &GearPair, matings: &[Mating], tick: Tick) -> Result<Vec<FoundPose>, Error> {
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear(member));
    let cut = CutPair::for_certificates(wheel, pinion);
    let method = Method::Exact { certify: true };
    let mut all = Vec::with_capacity(matings.len());
    sweep_blocks(assembly, &cut, method, matings, 0.0, tick, &mut |poses| {
        all.extend(poses.iter().map(|pose| FoundPose {
            j_wt_um: um(pose.backlash),
            error_bound_um: um(pose.error_bound),
            status: pose.status(),
        }));
        Ok::<(), Error>(())
    })?;
    Ok(all)
}

/// The same by the exact method alone. Its poses take less than a microsecond each: nothing of them is kept that an array does not.
fn exact(assembly: &GearPair, matings: &[Mating], tick: Tick) -> Result<Vec<FoundPose>, Error> {
    let kernel = ExactKernel::new(assembly);
    let radius = assembly.operating_pitch_radius(assembly.free());
    let one = |mating: &Mating| {
        if tick().is_break() {
            return Err(Error::Interrupted);
        }
        match kernel.lost_motion(&Pose::new(assembly, *mating)) {
            Ok(found) => {
                let angle = found.angle();
                Ok(FoundPose {
                    j_wt_um: um(angle.map(|angle| angle * radius)),
                    error_bound_um: um(angle.and(found.error()).map(|error| error * radius)),
                    status: found.status(),
                })
            }
            Err(error) if error.pose_failure().is_some() => Ok(FoundPose {
                j_wt_um: f64::NAN,
                error_bound_um: f64::NAN,
                status: Status::Unproven,
            }),
            Err(error) => Err(error),
        }
    };
    matings.par_iter().with_min_len(LEAST).map(one).collect()
}

/// Poses that a thread takes at once, at least: some 0.1 ms.
const LEAST: usize = 128;

/// What is found at `matings`: arrays by name, and what one mm of `j_wt` is in other units.
fn found<'py>(
    py: Python<'py>,
    assembly: &GearPair,
    matings: Vec<Mating>,
    How(_, _, certify, threads): &How,
) -> PyResult<Bound<'py, PyDict>> {
    let found = work(py, *threads, |tick| match certify {
        true => certified(assembly, &matings, tick),
        false => exact(assembly, &matings, tick),
    })?;
    let arrays = PyDict::new(py);
    let of = |value: fn(&FoundPose) -> f64| -> Vec<f64> { found.iter().map(value).collect() };
    let (j_wt, error_bound) = (of(|found| found.j_wt_um), of(|found| found.error_bound_um));
    let statuses: Vec<u8> = found.iter().map(|found| found.status as u8).collect();
    let each = || matings.iter();
    let wheel: Vec<u32> = each().map(|mating| mating.wheel_tooth).collect();
    let pinion: Vec<u32> = each().map(|mating| mating.pinion_tooth).collect();
    let left: Vec<u8> = each()
        .map(|mating| u8::from(mating.flank == Side::Left))
        .collect();
    let fraction: Vec<f64> = each().map(|mating| mating.fraction).collect();
    arrays.set_item("wheel_tooth", wheel.into_pyarray(py))?;
    arrays.set_item("pinion_tooth", pinion.into_pyarray(py))?;
    arrays.set_item("flank", left.into_pyarray(py))?;
    arrays.set_item("fraction", fraction.into_pyarray(py))?;
    arrays.set_item("j_wt_um", j_wt.into_pyarray(py))?;
    arrays.set_item("error_bound_um", error_bound.into_pyarray(py))?;
    arrays.set_item("status", statuses.into_pyarray(py))?;
    let one = assembly.backlash(1.0);
    let units = [
        one.j_t,
        one.j_bn,
        one.arcmin(Member::Wheel) * 1e-3,
        one.arcmin(Member::Pinion) * 1e-3,
    ];
    arrays.set_item("units", units)?;
    arrays.set_item("center_distance_mm", assembly.center_distance())?;
    Ok(arrays)
}
