//! A gear measured on its outline.

use crate::call::work;
use crate::error::Outcome;
use crate::gear::Gear;
use gearlash::gauge::{Settings, gauge as measure};
use gearlash_results::gauge::{GaugedGear, json};
use pyo3::prelude::*;

/// Teeth spanned, diameters of pins and ball, mm, teeth of the master gear, poses per pitch: a tuple in Python.
#[derive(FromPyObject)]
pub struct Sizes(Option<u32>, Option<f64>, Option<f64>, Option<u32>, u32);

/// The gauges' readings, as the JSON of `gearlash gauge`.
#[pyfunction]
pub fn gauge(
    py: Python<'_>,
    gear: &Gear,
    sizes: Sizes,
    material: Option<&str>,
    threads: Option<usize>,
) -> Outcome<String> {
    let Sizes(span_teeth, pin_mm, ball_mm, master_teeth, steps_per_pitch) = sizes;
    let (material, as_built) = gear.as_built(material)?;
    let teeth = as_built.gear().basic_data().teeth();
    for (name, value, least, most) in [
        ("span_teeth", span_teeth, 1, teeth),
        ("master_teeth", master_teeth, 3, 10_000),
        ("steps_per_pitch", Some(steps_per_pitch), 1, 1000),
    ] {
        if let Some(value) = value.filter(|value| !(least..=most).contains(value)) {
            return Err(format!("{name} = {value}: allowed is {least} … {most}").into());
        }
    }
    for (name, diameter) in [("pin_mm", pin_mm), ("ball_mm", ball_mm)] {
        if let Some(mm) = diameter.filter(|mm| !(*mm > 0.0 && *mm <= 1e6)) {
            let reason = format!("{name} = {mm}: a number of mm above 0 and up to 1e6 is needed");
            return Err(reason.into());
        }
    }
    let spec = &gear.spec;
    let settings = spec.gauge_settings(Settings {
        span_teeth,
        pin: pin_mm,
        ball: ball_mm,
        master_teeth,
        steps_per_pitch,
        ..Settings::default()
    });
    let gauged = work(py, threads, |tick| {
        measure(as_built, &settings, &|_| (), tick)
    })?;
    let gauged = GaugedGear {
        title: &gear.title,
        name: gear.entry.name,
        material,
        teeth: spec.teeth,
        data: Some((as_built, spec)),
        outline_bound: None,
        gauged,
    };
    Ok(json(&gear.title, &[gauged]))
}
