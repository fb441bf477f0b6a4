//! Measured gears, of which each assembly takes one at random: their files, and the bands of thickness that they and a pair file state.

use crate::files::PairFile;
use crate::spec::{GearSpec, GearToleranceSpec, ToleranceSpec};
use crate::temperature::REFERENCE_C;
use gearlash::error::GearError;
use gearlash::gear::thickness::{allowance, per_normal_thickness};
use gearlash::gear::{AsBuilt, Deviations};
use gearlash::pair::Member;
use gearlash::population::Scatter;
use gearlash_text::numbers::{shortest, um_ascii};
use gearlash_text::{Reading, Table};
use glob::{MatchOptions, Pattern};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

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
        let found = matching_files(file.reading().folder(), name);
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
    let mut grouped = GroupedLines::default();
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

/// Most files and folders that are compared with a pattern: twice the gears that a list can have.
const MAX_VISITED: usize = 200_000;

#[derive(Debug, Default)]
pub struct MatchingFiles {
    /// Files, in the order of their names.
    pub files: Vec<PathBuf>,
    /// Matches that are ignored, and why.
    pub left_out: Vec<String>,
    /// Matches that cannot be read, and why.
    pub faults: Vec<String>,
}

/// The files that `name` stands for, relative to `folder`. `*`, `?` and `[` match letters within one path component. Case
/// matters.
pub fn matching_files(folder: &Path, name: &str) -> MatchingFiles {
    let mut files = MatchingFiles::default();
    if !name.contains(['*', '?', '[']) {
        let path = folder.join(name);
        match path.symlink_metadata() {
            Err(error) if error.kind() == ErrorKind::NotFound => (),
            _ => files.add(path, false),
        }
        return files;
    }
    let found = found(folder, name, &mut files.faults).unwrap_or_else(|error| {
        files.faults.push(format!("{name:?}: {error}"));
        Vec::new()
    });
    for (path, is_as_written) in found {
        if is_as_written {
            files.add(path, true)
        } else {
            files.left_out.push(format!(
                "{}: is as {name:?} but for capital letters, and is left out",
                path.display()
            ))
        }
    }
    files
}

/// Every path that matches the pattern `name`, in the order of the names, and whether case matched. Read errors are added to `faults`.
///
/// File names need not be UTF-8: an invalid byte counts as one letter.
fn found(
    folder: &Path,
    name: &str,
    faults: &mut Vec<String>,
) -> Result<Vec<(PathBuf, bool)>, String> {
    if name.contains("**") {
        return Err("`**` is not allowed, name each folder".to_owned());
    }
    let mut found = vec![(folder.to_path_buf(), true)];
    let mut visited = 0;
    for part in Path::new(name).components() {
        let text = part.as_os_str().to_string_lossy();
        if part == Component::CurDir {
            continue;
        }
        if !text.contains(['*', '?', '[']) {
            found.iter_mut().for_each(|(path, _)| path.push(part));
            found.retain(|(path, _)| path.symlink_metadata().is_ok());
            continue;
        }
        let pattern = Pattern::new(&text).map_err(|error| error.msg.to_owned())?;
        let mut next = Vec::new();
        for (path, is_as_written) in found {
            let inner = entries(&path, faults);
            visited += inner.len();
            if visited > MAX_VISITED {
                let reason = format!("a pattern meets more than {MAX_VISITED} files and folders");
                faults.push(reason);
                return Ok(Vec::new());
            }
            for path in inner {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let is_same = is_as_written && pattern.matches(&name);
                if pattern.matches_with(&name, IGNORE_CASE) {
                    next.push((path, is_same));
                }
            }
        }
        found = next;
    }
    Ok(found)
}

/// Matches names without regard to case.
const IGNORE_CASE: MatchOptions = MatchOptions {
    case_sensitive: false,
    require_literal_separator: false,
    require_literal_leading_dot: false,
};

/// The entries of `folder` by name; empty where it is no folder.
fn entries(folder: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    let at = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    if !at.is_dir() {
        return Vec::new();
    }
    let names = std::fs::read_dir(at).and_then(|entries| {
        let names = entries.map(|entry| Ok(entry?.file_name()));
        names.collect::<std::io::Result<Vec<OsString>>>()
    });
    match names {
        Ok(mut names) => {
            names.sort();
            names.into_iter().map(|name| folder.join(name)).collect()
        }
        Err(error) => {
            faults.push(format!("{}: {error}", folder.display()));
            Vec::new()
        }
    }
}

impl MatchingFiles {
    /// Adds the file at `path`. A folder is ignored where a pattern matched it.
    fn add(&mut self, path: PathBuf, is_of_pattern: bool) {
        let name = path.display();
        match path.metadata() {
            Ok(found) if found.is_file() => self.files.push(path),
            Ok(found) if found.is_dir() && is_of_pattern => {
                let reason = "is a folder, and is left out";
                self.left_out.push(format!("{name}: {reason}"));
            }
            Ok(_) => self.faults.push(format!("{name}: this is no file")),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let reason = "this is a link to a file that is not there";
                self.faults.push(format!("{name}: {reason}"));
            }
            Err(error) => self.faults.push(format!("{name}: {error}")),
        }
    }
}

/// Files of one folder whose names differ only in the extension, such as `p1.toml` and `p1.json`: the gear is ambiguous.
fn duplicates(files: &[PathBuf]) -> Vec<String> {
    let mut first: BTreeMap<(PathBuf, OsString), &PathBuf> = BTreeMap::new();
    let mut duplicates = Vec::new();
    for path in files {
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let stem = path.file_stem().unwrap_or_default().to_os_string();
        let before = *first.entry((folder, stem)).or_insert(path);
        if before != path {
            duplicates.push(format!(
                "{} and {}: two files of one gear",
                before.display(),
                path.display()
            ));
        }
    }
    duplicates
}

/// A warning for each band of `pair` that `tolerance` does not draw from, with the key to write.
pub fn unused_band_warnings(pair: &PairFile, tolerance: &ToleranceSpec) -> Vec<String> {
    let mut warnings = Vec::new();
    for member in Member::BOTH {
        let is_drawn = |spec: &GearToleranceSpec| spec.thickness.is_some() || spec.gears.is_some();
        if !tolerance.gear(member).is_some_and(is_drawn) && thickness_band(pair, member).is_some() {
            let name = member.name();
            warnings.push(format!(
                "{name}.thickness: states a band from which nothing is drawn, every {name} has its middle; to draw it, write thickness = {{ scatter = \"normal\" }} in [tolerance.{name}]"
            ));
        }
    }
    if tolerance.center_distance.is_none() && pair.study.distance_band.is_some() {
        warnings.push(
            "assembly.center_distance_mm: states a band from which nothing is drawn, every pair has the nominal distance; to draw it, write center_distance = { scatter = \"normal\" } in [tolerance]"
                .to_owned(),
        );
    }
    warnings
}

/// A warning that the `drawn` thickness repeats the stated one, to which it is added: its mean is the stated allowance, or beyond the band.
pub fn repeated_thickness(pair: &PairFile, member: Member, drawn: &Scatter) -> Option<String> {
    const ROUNDING_MM: f64 = 5e-4;
    let (_, wheel, pinion) = pair.study.materials.first()?;
    let gear = [wheel, pinion][member as usize].gear();
    let [_, half] = thickness_band(pair, member).unwrap_or_default();
    let scale = pair.spec.data(member)?.scale();
    let (stated, mean) = ((allowance(gear) - half) / scale, drawn.mean());
    let is_stated = (mean - stated).abs() <= ROUNDING_MM;
    let is_beyond = half > 0.0 && mean.abs() >= half;
    let is_repeated = mean.abs() > ROUNDING_MM && (is_stated || is_beyond);
    is_repeated.then(|| {
        let name = member.name();
        let [mean, stated] = [mean, stated].map(|mm| um_ascii(mm, 1));
        format!(
            "tolerance.{name}.thickness: its mean, {mean} µm, is added to the stated allowance, {stated} µm; if its limits repeat those of the {name}, leave them out"
        )
    })
}

/// The gear in the middle between the thickest and the thinnest.
pub fn middle<'a>(gears: impl IntoIterator<Item = &'a AsBuilt>) -> Result<AsBuilt, GearError> {
    let mut gears = gears.into_iter();
    let most = gears.next().ok_or(GearError::ThicknessField)?;
    match gears.last() {
        Some(least) => most.varied(-half_band(most, least), &Deviations::default()),
        None => Ok(most.clone()),
    }
}

/// Half the difference of the thicknesses of two gears, mm at the reference circle (in the normal section).
fn half_band(most: &AsBuilt, least: &AsBuilt) -> f64 {
    let [most, least] = [most.gear(), least.gear()];
    let per = per_normal_thickness(most.basic_data());
    0.5 * (most.base_thickness() - least.base_thickness()) / per
}

/// The band of a gear's thickness about its middle, mm: at the reference circle (in the normal section), or of a drawn gear along the normals
/// of its flanks.
pub fn thickness_band(pair: &PairFile, member: Member) -> Option<[f64; 2]> {
    let study = &pair.study;
    let by_data = study.materials.first().zip(study.materials.last());
    let by_data = by_data.map(|(most, least)| {
        let [most, least] = [most, least].map(|(_, wheel, pinion)| [wheel, pinion]);
        half_band(most[member as usize], least[member as usize])
    });
    let drawn = study.drawn.first().zip(study.drawn.last());
    let drawn = drawn.and_then(|(most, least)| {
        let [most, least] = [most, least].map(|(_, wheel, pinion)| [wheel, pinion]);
        // An offset moves both flanks of a tooth.
        Some(most[member as usize].flank_offset()? - least[member as usize].flank_offset()?)
    });
    let half = by_data.or(drawn)?;
    (half > 0.0).then_some([-half, half])
}

/// Texts, each with its files.
#[derive(Debug, Default)]
pub(crate) struct GroupedLines {
    each: Vec<(String, PathBuf, usize)>,
}

impl GroupedLines {
    /// Adds the `texts` of `file`.
    pub fn add(&mut self, file: &Path, texts: &[String]) {
        for text in texts {
            match self.each.iter_mut().find(|(known, ..)| known == text) {
                Some((.., more)) => *more += 1,
                None => self.each.push((text.clone(), file.to_path_buf(), 0)),
            }
        }
    }

    /// A line per text, in the order in which they were added: the first file with it, and the number of others.
    pub fn lines(&self) -> Vec<String> {
        let each = self.each.iter().map(|(text, file, more)| {
            let others = match more {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            format!("{}{others}: {text}", file.display())
        });
        each.collect()
    }
}
