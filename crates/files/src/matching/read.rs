//! A pair file and the folders of its wheels and pinions.

use crate::error::{InputError, Problem};
use crate::read::PairFile;
use crate::tolerance::middle;
use gearlash::gear::AsBuilt;
use gearlash::matching::Terms;
use gearlash::pair::{GearPair, Member};
use gearlash::population::Requirement;
use std::path::{Path, PathBuf};

/// A measured gear and the file that it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedGear {
    /// Name of the file without its folder and ending.
    pub name: String,
    /// The gear; in the middle of a band of thickness.
    pub gear: AsBuilt,
}

/// What is to be matched.
#[derive(Debug, Clone)]
pub struct MatchFile {
    /// The pair: centre distance, bearings, requirement.
    pub pair: PairFile,
    /// In the order of their names.
    pub wheels: Vec<NamedGear>,
    /// In the order of their names.
    pub pinions: Vec<NamedGear>,
    /// How they are put together.
    pub terms: Terms,
    /// What the user should know, beside the pair's warnings.
    pub warnings: Vec<String>,
}

/// Reads the pair file at `path` and every gear file (`.toml`, `.json`) of the folders `wheels` and `pinions`; `target` is the wanted
/// backlash, mm.
///
/// # Errors
/// [`InputError`] of each file that cannot be used, all of them.
pub fn read_match(
    path: &Path,
    [wheels, pinions]: [&Path; 2],
    target: Option<f64>,
) -> Result<MatchFile, Vec<InputError>> {
    let pair = crate::read(path).map_err(|error| vec![error])?;
    let mut pair = pair;
    let mut errors = Vec::new();
    let mut gears = |folder: &Path, member: Member| {
        let own = pair.study.materials.first();
        let own = own.map(|(_, wheel, pinion)| match member {
            Member::Wheel => wheel,
            Member::Pinion => pinion,
        });
        let mut gears = Vec::new();
        for file in files(folder, &mut errors) {
            match one(&file, member, own) {
                Ok((gear, sources)) => {
                    pair.sources.extend(&sources);
                    gears.push(gear);
                }
                Err(error) => errors.push(error),
            }
        }
        gears
    };
    let (wheels, pinions) = (gears(wheels, Member::Wheel), gears(pinions, Member::Pinion));
    if !errors.is_empty() {
        return Err(errors);
    }
    let distances = &pair.study.center_distances;
    let ends = |fold: fn(f64, f64) -> f64| distances.iter().copied().reduce(fold);
    let ends = pair
        .study
        .band
        .or(ends(f64::min).zip(ends(f64::max)).map(<[f64; 2]>::from));
    let Some(center_distances) = ends else {
        return Err(vec![problem(path, "no centre distance", "give one")]);
    };
    let (requirement, warnings) = crate::tolerance::requirement(&pair);
    let terms = Terms {
        center_distances,
        clearance: pair.study.bearing_clearance,
        locked: pair.study.locked,
        requirement,
        target,
    };
    let near = center_distances[0] - terms.clearance;
    for gear in wheels
        .iter()
        .flat_map(|wheel| pinions.first().map(|pinion| (wheel, pinion)))
    {
        let (wheel, pinion) = (gear.0.gear.clone(), gear.1.gear.clone());
        if let Err(reason) = GearPair::with_locked(wheel, pinion, near, terms.locked) {
            return Err(vec![problem(
                path,
                &format!("{} and {} make no pair: {reason}", gear.0.name, gear.1.name),
                "match gears of one pair",
            )]);
        }
    }
    Ok(MatchFile {
        pair,
        wheels,
        pinions,
        terms,
        warnings,
    })
}

impl MatchFile {
    /// What each pair must keep.
    pub fn requirement(&self) -> &Requirement {
        &self.terms.requirement
    }
}

/// The gear files of a folder, in the order of their names.
fn files(folder: &Path, errors: &mut Vec<InputError>) -> Vec<PathBuf> {
    let entries = match std::fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(reason) => {
            errors.push(problem(
                folder,
                &format!("cannot be read: {reason}"),
                "name a folder of gear files",
            ));
            return Vec::new();
        }
    };
    let is_gear = |path: &PathBuf| {
        let ending = path.extension().and_then(|ending| ending.to_str());
        path.is_file() && matches!(ending, Some("toml" | "json"))
    };
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(is_gear);
    files.sort();
    if files.is_empty() {
        errors.push(problem(
            folder,
            "holds no gear file (.toml, .json)",
            "name a folder of gear files, one a gear",
        ));
    }
    files
}

/// The gear of a gear file, or the `member` of a pair file, of as many teeth as `own` has.
fn one(
    path: &Path,
    member: Member,
    own: Option<&AsBuilt>,
) -> Result<(NamedGear, crate::Sources), InputError> {
    let file = crate::read_gears(path)?;
    let named = |name: &str| name == "gear" || name == member.name();
    let entry = file.gears.iter().find(|gear| named(gear.name));
    let Some(entry) = entry else {
        return Err(problem(path, "has no such gear", "name a gear file"));
    };
    let gear = middle(entry.materials.iter().map(|(_, gear)| gear));
    let gear = gear.map_err(|reason| problem(path, &reason.to_string(), "correct the file"))?;
    let teeth = |gear: &AsBuilt| gear.gear().basic_data().teeth();
    if let Some(own) = own.map(teeth).filter(|own| *own != teeth(&gear)) {
        let reason = format!(
            "{} teeth, the pair file's {} has {own}",
            teeth(&gear),
            member.name()
        );
        return Err(problem(path, &reason, "match gears of one pair"));
    }
    let name = path
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    let name = name.unwrap_or_default();
    Ok((NamedGear { name, gear }, file.sources))
}

fn problem(path: &Path, reason: &str, help: &str) -> InputError {
    InputError {
        file: path.to_path_buf(),
        problems: vec![Problem {
            key: String::new(),
            value: None,
            reason: reason.to_owned(),
            help: help.to_owned(),
        }],
        text: String::new(),
    }
}
