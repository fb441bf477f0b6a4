//! Distributions of a pair file, converted for the library.

use crate::spec::{ScatterName, ScatterSpec, SpreadSpec};
use crate::table::Table;
use gearlash::population::{LIMIT_SIGMAS, Scatter, ScatterError};

const MM: f64 = 1e-3;

/// The normal distribution about 0, or that of the amount of a vector, at `key` of the pair file, in units of `um` µm; `Some(None)` where
/// none is stated.
pub fn spread(
    spec: Option<SpreadSpec>,
    um: f64,
    is_vector: bool,
    (file, key): (&Table, &str),
) -> Option<Option<Scatter>> {
    let Some(spec) = spec else {
        return Some(None);
    };
    let made = match (spec.sigma, spec.max.unwrap_or_default()) {
        (Some(sigma), _) if is_vector => Scatter::rayleigh(sigma / um),
        (None, max) if is_vector => Scatter::rayleigh_below(max / um),
        (Some(sigma), _) => Scatter::normal(0.0, sigma / um),
        (None, max) => Scatter::normal(0.0, max / LIMIT_SIGMAS / um),
    };
    file.keep(key, made, "correct the number").map(Some)
}

/// The distribution at `key` of the pair file, mm; `Some(None)` where none is stated. Absent limits are those of the `band`, mm.
pub fn scatter(
    spec: &Option<ScatterSpec>,
    band: Option<[f64; 2]>,
    (file, key): (&Table, &str),
) -> Option<Option<Scatter>> {
    let Some(spec) = spec else {
        return Some(None);
    };
    let limits = match (spec.lower_um, spec.upper_um) {
        (Some(low), Some(high)) => Some([low * MM, high * MM]),
        _ => band,
    };
    let middle = |limits: [f64; 2]| 0.5 * (limits[0] + limits[1]);
    let um = |value: Option<f64>| value.map(|um| um * MM);
    let within = |of: &dyn Fn([f64; 2]) -> Result<Scatter, ScatterError>| limits.map(of);
    let made = match spec.scatter {
        ScatterName::Fixed => um(spec.value_um).map(Scatter::fixed),
        ScatterName::Uniform => within(&|[low, high]| Scatter::uniform(low, high)),
        ScatterName::Triangular => within(&|[low, high]| {
            let mode = um(spec.mode_um).unwrap_or(middle([low, high]));
            Scatter::triangular(low, mode, high)
        }),
        ScatterName::Normal => match um(spec.sigma_um) {
            Some(sigma) => Some(Scatter::normal(um(spec.mean_um).unwrap_or(0.0), sigma)),
            None => within(&|[low, high]| {
                let mean = um(spec.mean_um).unwrap_or(middle([low, high]));
                Scatter::normal_within(low, high, mean, spec.cpk.unwrap_or(1.0))
            }),
        },
        ScatterName::Rayleigh => match (um(spec.scale_um), um(spec.upper_um)) {
            (Some(scale), _) => Some(Scatter::rayleigh(scale)),
            (None, Some(high)) => Some(Scatter::rayleigh_below(high)),
            (None, None) => None,
        },
        ScatterName::Table => spec.values_um.as_ref().map(|values| {
            let values: Vec<f64> = values.iter().map(|um| um * MM).collect();
            Scatter::table(&values)
        }),
    };
    let Some(made) = made else {
        let reason = "has no limits, and the pair file states no band that they could be";
        return file.refuse(key, reason, "give lower_um and upper_um");
    };
    // The library's message has numbers in mm, another unit than the file.
    let made = made.map_err(|error| match error {
        ScatterError::Limits { .. } => "the lower limit lies above the upper one".to_owned(),
        ScatterError::Outside { what, .. } => format!("{what} lies outside the limits"),
        ScatterError::NotPositive { what, .. } => format!("{what} is not above 0"),
        other => other.to_string(),
    });
    let help = "correct the numbers of this distribution";
    file.keep(key, made, help).map(Some)
}
