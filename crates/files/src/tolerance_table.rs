//! `[tolerance]`: how the numbers of a pair scatter.

use super::entry::Entry;
use super::limits::{
    ASSEMBLIES, CAPABILITY, CONTRIBUTION_ROWS, CORRELATION, PPM, SCATTER, SEED, SHARE, SPREAD,
};
use super::node::Node;
use super::problems::Problems;
use super::spec::{
    DEFAULT_ASSEMBLIES, DEFAULT_IMPOSSIBLE, DEFAULT_ROWS, GearToleranceSpec, PhaseName,
    PitchScatterSpec, ScatterName, ScatterSpec, ToleranceSpec,
};
use super::table::Table;
use gearlash::gear::GRADES;
use std::ops::RangeInclusive;

const KEYS: &[&str] = &[
    "assemblies",
    "seed",
    "max_ppm",
    "max_impossible",
    "contribution_rows",
    "center_distance",
    "bearing_play",
    "phase",
    "thickness_correlation",
    "wheel",
    "pinion",
];
const GEAR_KEYS: &[&str] = &["thickness", "runout", "pitch", "per_tooth", "gears"];
const SCATTER_KEYS: &[&str] = &[
    "scatter",
    "lower_um",
    "upper_um",
    "mean_um",
    "sigma_um",
    "cpk",
    "mode_um",
    "scale_um",
    "value_um",
    "values_um",
];
const PHASES: [(&str, PhaseName); 2] = [("any", PhaseName::Any), ("marked", PhaseName::Marked)];
const SCATTERS: [(&str, ScatterName); 6] = [
    ("normal", ScatterName::Normal),
    ("uniform", ScatterName::Uniform),
    ("triangular", ScatterName::Triangular),
    ("fixed", ScatterName::Fixed),
    ("rayleigh", ScatterName::Rayleigh),
    ("table", ScatterName::Table),
];

/// Reads `[tolerance]`; `Some(None)` where the file has none.
pub fn tolerance(file: &Table, problems: &mut Problems) -> Option<Option<ToleranceSpec>> {
    if !(file.has("tolerance") || file.is_mistyped("tolerance")) {
        return Some(None);
    }
    let table = file.table("tolerance", KEYS, problems)?;
    let mut count = |key, default, range: RangeInclusive<u32>, help| {
        let found = table.optional_as(key, problems, |entry| entry.whole(range, help));
        found.map(|found| found.unwrap_or(default))
    };
    let assemblies = count(
        "assemblies",
        DEFAULT_ASSEMBLIES,
        ASSEMBLIES,
        "give how many assemblies are drawn",
    );
    let seed = count("seed", 1, SEED, "give any whole number");
    let rows = count(
        "contribution_rows",
        DEFAULT_ROWS,
        CONTRIBUTION_ROWS,
        "give the rows of the samples, 0 for none",
    );
    let max_ppm = table.optional_as("max_ppm", problems, |entry| entry.number(&PPM));
    let impossible = table.number_or("max_impossible", DEFAULT_IMPOSSIBLE, &SHARE, problems);
    let correlation = table.number_or("thickness_correlation", 0.0, &CORRELATION, problems);
    let center_distance = scatter(&table, "center_distance", problems);
    let bearing_play = scatter(&table, "bearing_play", problems);
    let phase = table.choice_or_first("phase", &PHASES, problems);
    let wheel = gear(&table, "wheel", problems);
    let pinion = gear(&table, "pinion", problems);
    Some(Some(ToleranceSpec {
        assemblies: assemblies?,
        seed: seed?,
        max_ppm: max_ppm?,
        max_impossible: impossible?,
        contribution_rows: rows?,
        center_distance: center_distance?,
        bearing_play: bearing_play?,
        phase: phase?,
        thickness_correlation: correlation?,
        wheel: wheel?,
        pinion: pinion?,
    }))
}

fn gear(
    tolerance: &Table,
    name: &'static str,
    problems: &mut Problems,
) -> Option<Option<GearToleranceSpec>> {
    if !(tolerance.has(name) || tolerance.is_mistyped(name)) {
        return Some(None);
    }
    let table = tolerance.table(name, GEAR_KEYS, problems)?;
    let thickness = scatter(&table, "thickness", problems);
    let runout = scatter(&table, "runout", problems);
    let per_tooth = scatter(&table, "per_tooth", problems);
    let pitch = pitch(&table, problems);
    let gears = gears(&table, problems);
    let beside = GEAR_KEYS
        .iter()
        .find(|key| **key != "gears" && table.has(key));
    if let (true, Some(beside)) = (table.has("gears"), beside) {
        problems.add(table.problem(
            "gears",
            format!("given together with {beside}: measured gears are taken whole"),
            "remove one or the other",
        ));
        return None;
    }
    Some(Some(GearToleranceSpec {
        thickness: thickness?,
        runout: runout?,
        pitch: pitch?,
        per_tooth: per_tooth?,
        gears: gears?,
    }))
}

/// Names of gear files: one, or several.
fn gears(table: &Table, problems: &mut Problems) -> Option<Option<Vec<String>>> {
    let Some(entry) = table.optional("gears")? else {
        return Some(None);
    };
    let help = "name gear files, such as \"measured/*.toml\"";
    let text = |entry: &Entry| match entry.text(help)? {
        "" => Err(entry.problem("an empty name, expected that of a gear file", help)),
        name => Ok(name.to_owned()),
    };
    let names = match entry.node() {
        Node::Text(_) => problems.keep(text(&entry)).map(|name| vec![name]),
        _ => {
            let list = problems.keep(entry.list("a string or a list of strings", help))?;
            if list.is_empty() {
                problems.add(entry.problem("an empty list, expected at least one name", help));
                return None;
            }
            entry.each(&list, problems, |name, _| text(name))
        }
    };
    names.map(Some)
}

fn pitch(table: &Table, problems: &mut Problems) -> Option<Option<PitchScatterSpec>> {
    if !(table.has("pitch") || table.is_mistyped("pitch")) {
        return Some(None);
    }
    let own = table.table("pitch", &["sigma_um", "grade"], problems)?;
    let sigma_um = own.optional_as("sigma_um", problems, |entry| entry.number(&SPREAD));
    let help = "give the accuracy grade, ISO 1328-1";
    let grade = own.optional_as("grade", problems, |entry| entry.whole(GRADES, help));
    let (sigma_um, grade) = (sigma_um?, grade?);
    if sigma_um.is_some() == grade.is_some() {
        problems.add(table.problem(
            "pitch",
            "expected either sigma_um or grade",
            "give one of the two",
        ));
        return None;
    }
    Some(Some(PitchScatterSpec { sigma_um, grade }))
}

/// The keys of each distribution: those that must be there, and those that may.
fn keys_of(scatter: ScatterName) -> &'static [&'static str] {
    match scatter {
        ScatterName::Fixed => &["value_um"],
        ScatterName::Uniform => &["lower_um", "upper_um"],
        ScatterName::Triangular => &["lower_um", "upper_um", "mode_um"],
        ScatterName::Normal => &["lower_um", "upper_um", "mean_um", "cpk", "sigma_um"],
        ScatterName::Rayleigh => &["scale_um", "upper_um"],
        ScatterName::Table => &["values_um"],
    }
}

/// Reads one distribution; `Some(None)` where there is none.
fn scatter(
    table: &Table,
    name: &'static str,
    problems: &mut Problems,
) -> Option<Option<ScatterSpec>> {
    if !(table.has(name) || table.is_mistyped(name)) {
        return Some(None);
    }
    let own = table.table(name, SCATTER_KEYS, problems)?;
    let kind = own
        .need("scatter", "the name of a distribution", problems)
        .and_then(|entry| problems.keep(entry.choice(&SCATTERS)));
    let mut um = |key, limits| own.optional_as(key, problems, |entry| entry.number(limits));
    let lower_um = um("lower_um", &SCATTER);
    let upper_um = um("upper_um", &SCATTER);
    let mean_um = um("mean_um", &SCATTER);
    let sigma_um = um("sigma_um", &SPREAD);
    let cpk = um("cpk", &CAPABILITY);
    let mode_um = um("mode_um", &SCATTER);
    let scale_um = um("scale_um", &SPREAD);
    let value_um = um("value_um", &SCATTER);
    let values_um = match own.optional("values_um") {
        Some(Some(entry)) => entry.numbers(&SCATTER, problems).map(Some),
        absent => absent.map(|_| None),
    };
    let kind = kind?;
    let mut right = true;
    let known = keys_of(kind);
    let strange = SCATTER_KEYS.iter().skip(1);
    for key in strange.filter(|key| own.has(key) && !known.contains(key)) {
        problems.add(own.problem(
            key,
            format!("no key of this distribution, expected {}", known.join(", ")),
            "remove it, or take another scatter",
        ));
        right = false;
    }
    let mut wrong = |reason: &str, help: &str| {
        problems.add(table.problem(name, reason, help));
        right = false;
    };
    match kind {
        ScatterName::Fixed if !own.has("value_um") => wrong("has no value_um", "add it"),
        ScatterName::Table if !own.has("values_um") => wrong("has no values_um", "add them"),
        ScatterName::Rayleigh if own.has("scale_um") == own.has("upper_um") => wrong(
            "expected either scale_um or upper_um",
            "give one of the two",
        ),
        ScatterName::Normal
            if own.has("sigma_um")
                && ["lower_um", "upper_um", "cpk"]
                    .iter()
                    .any(|key| own.has(key)) =>
        {
            wrong(
                "sigma_um stands beside limits or cpk, from which it follows",
                "give sigma_um, or limits with cpk",
            );
        }
        _ if own.has("lower_um") != own.has("upper_um") && kind != ScatterName::Rayleigh => wrong(
            "has one limit, expected lower_um and upper_um",
            "give both, or neither where the pair file states a band",
        ),
        _ => (),
    }
    let spec = ScatterSpec {
        scatter: kind,
        lower_um: lower_um?,
        upper_um: upper_um?,
        mean_um: mean_um?,
        sigma_um: sigma_um?,
        cpk: cpk?,
        mode_um: mode_um?,
        scale_um: scale_um?,
        value_um: value_um?,
        values_um: values_um?,
    };
    right.then_some(Some(spec))
}
