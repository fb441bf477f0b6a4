//! Measured gears that are drawn as a whole.

use super::bands::middle;
use super::gear_names::{duplicates, named};
use crate::grouped_warnings::GroupedWarnings;
use crate::numbers::shortest;
use crate::reading::Reading;
use crate::spec::GearSpec;
use crate::table::Table;
use crate::temperature::REFERENCE_C;
use gearlash::gear::AsBuilt;
use gearlash::pair::Member;
use std::path::Path;

/// Most gear files of one list: a folder of measurements has fewer.
const MAX_GEARS: usize = 100_000;

/// Warnings of one list, at most (tuned: they fit a screen beside others).
const MAX_WARNINGS: usize = 12;

#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGear {
    pub gear: AsBuilt,
    pub spec: GearSpec,
}

/// The gears that `names` stand for, in the order of the names and of the file names, with warnings. A pair file gives its
/// `member`.
pub fn gears(
    names: &[String],
    member: Member,
    (file, key): (&Table, &str),
) -> Option<(Vec<MeasuredGear>, Vec<String>)> {
    let wrong = |reason: String, help: &str| file.add(key, reason, help);
    let (mut files, mut warnings) = (Vec::new(), Vec::new());
    for name in names {
        let found = named(file.reading().folder(), name);
        if found.files.is_empty() && found.faults.is_empty() {
            let beside = found.left_out.iter().take(MAX_WARNINGS);
            let beside: String = beside.map(|left_out| format!("; {left_out}")).collect();
            wrong(
                format!("{name:?}: there is no such file{beside}"),
                "name gear files, such as \"measured/*.toml\", beside the pair file",
            );
        }
        for fault in found.faults {
            wrong(fault, "correct it, take it away, or name the others");
        }
        let left_out = found.left_out.into_iter();
        warnings.extend(left_out.map(|left_out| format!("{key}: {left_out}")));
        files.extend(found.files);
    }
    for duplicate in duplicates(&files) {
        wrong(duplicate, "take one away, or name the other alone");
    }
    if files.len() > MAX_GEARS {
        let reason = format!("more than {MAX_GEARS} gears");
        wrong(reason, "name fewer of them");
        files.truncate(MAX_GEARS);
    }
    let (mut gears, mut banded) = (Vec::new(), Vec::new());
    let mut grouped = GroupedWarnings::default();
    for path in files {
        match read_one(&path, member, file.reading()) {
            Ok((gear, has_band, warned)) => {
                gears.push(gear);
                grouped.add(&path, &warned);
                banded.extend(has_band.then_some(path));
            }
            Err(reason) => wrong(
                format!("{}: {reason}", path.display()),
                "correct the file: gearlash gauge says what is wrong with it",
            ),
        }
    }
    if let Some(first) = banded.first() {
        let first = first.display();
        let others = match banded.len() {
            1 => String::new(),
            count => format!(" and {} more", count - 1),
        };
        let warning = format!(
            "{key}: {first}{others}: states a band of thickness, the gear drawn has its middle; give the thickness that was measured"
        );
        // Before the ignored files, because it changes results.
        warnings.insert(0, warning);
    }
    let grouped = grouped.lines().into_iter();
    warnings.extend(grouped.map(|line| format!("{key}: {line}")));
    let more = warnings.len().saturating_sub(MAX_WARNINGS);
    warnings.truncate(MAX_WARNINGS);
    if more > 0 {
        warnings.push(format!("{key}: {more} more warnings like these"));
    }
    Some((gears, warnings))
}

/// The gear of a gear file, or the `member` of a pair file: the middle of a thickness band, whether there is a band, and the
/// file's warnings.
fn read_one(
    path: &Path,
    member: Member,
    reading: &Reading,
) -> Result<(MeasuredGear, bool, Vec<String>), String> {
    // The file's content is not quoted, because it can be outside the pair file's folder.
    let file = crate::read_gears_by_data(path).map_err(|error| match error.problems.len() {
        1 => "this is no gear file that can be read".to_owned(),
        several => format!("this is no gear file that can be read: {several} problems"),
    })?;
    if let Some(celsius) = file.temperature_c.filter(|celsius| *celsius != REFERENCE_C) {
        return Err(format!(
            "stands at {} °C, gears are drawn at the {REFERENCE_C} °C at which they were measured",
            shortest(celsius)
        ));
    }
    reading.read_too(&file.sources);
    let gear = file.of(member).ok_or("has no such gear")?;
    let middle = middle(gear.materials.iter().map(|(_, gear)| gear));
    let measured = MeasuredGear {
        gear: middle.map_err(|error| error.to_string())?,
        spec: gear.spec.data().ok_or("has no such gear")?.clone(),
    };
    Ok((measured, gear.materials.len() > 1, file.warnings))
}
