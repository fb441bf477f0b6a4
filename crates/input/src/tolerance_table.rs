//! `[tolerance]`: allowed keys for each distribution.

use super::spec::{ScatterName, ScatterSpec, ToleranceSpec};
use gearlash_text::Table;

const SCATTERS: &str = "center_distance bearing_play wheel.thickness wheel.runout wheel.per_tooth pinion.thickness pinion.runout pinion.per_tooth";

/// Reads `[tolerance]`; `Some(None)` where the file has none.
pub fn tolerance(file: &Table) -> Option<Option<ToleranceSpec>> {
    let mut good = Some(());
    for path in SCATTERS.split(' ').map(|name| format!("tolerance.{name}")) {
        let scatter = file.read::<ScatterSpec>(&path).flatten();
        if let Some((key, reason, help)) = scatter.and_then(|spec| fault(file, &path, spec.scatter))
        {
            file.add(&key, reason, help);
            good = None;
        }
    }
    good?;
    file.read("tolerance")
}

/// The fault of the keys of the distribution at `path`: key, reason and remedy.
fn fault(file: &Table, path: &str, scatter: ScatterName) -> Option<(String, String, &'static str)> {
    let table = file.below(path);
    let has = |key: &str| table.has(key);
    let known: &[&str] = match scatter {
        ScatterName::Fixed => &["value_um"],
        ScatterName::Uniform => &["lower_um", "upper_um"],
        ScatterName::Triangular => &["lower_um", "upper_um", "mode_um"],
        ScatterName::Normal => &["lower_um", "upper_um", "mean_um", "cpk", "sigma_um"],
        ScatterName::Rayleigh => &["scale_um", "upper_um"],
        ScatterName::Table => &["values_um"],
    };
    let mut keys = table.entries().iter().map(|(key, _)| key.as_str());
    if let Some(key) = keys.find(|key| *key != "scatter" && !known.contains(key)) {
        return Some((
            format!("{path}.{key}"),
            format!("no key of this distribution, expected {}", known.join(", ")),
            "remove it, or take another scatter",
        ));
    }
    let (reason, help) = match scatter {
        ScatterName::Fixed if !has("value_um") => ("has no value_um", "add it"),
        ScatterName::Table if !has("values_um") => ("has no values_um", "add them"),
        ScatterName::Rayleigh if has("scale_um") == has("upper_um") => (
            "expected either scale_um or upper_um",
            "give one of the two",
        ),
        ScatterName::Normal
            if has("sigma_um") && ["lower_um", "upper_um", "cpk"].iter().any(|key| has(key)) =>
        {
            (
                "sigma_um stands beside limits or cpk, from which it follows",
                "give sigma_um, or limits with cpk",
            )
        }
        ScatterName::Rayleigh => return None,
        _ if has("lower_um") != has("upper_um") => (
            "has one limit, expected lower_um and upper_um",
            "give both, or neither where the pair file states a band",
        ),
        _ => return None,
    };
    Some((path.to_owned(), reason.to_owned(), help))
}
