//! A pair file and the folders of its wheels and pinions.

use crate::common_face;
use crate::files::PairFile;
use crate::spec::GearSpec;
use crate::temperature::REFERENCE_C;
use crate::tolerance::{GroupedLines, Tick, middle, placed, sha256, shape_difference};
use gearlash::error::{Error, GearError};
use gearlash::gear::AsBuilt;
use gearlash::matching::{Matrix, PairConditions, PairFit};
use gearlash::pair::{GearPair, Member};
use gearlash::population::AssemblyLimits;
use gearlash_text::numbers::shortest;
use gearlash_text::{InputError, Problem, Sources};
use serde_json::json;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The gears that are matched, and the conditions of assembly.
#[derive(Debug, Clone)]
pub struct MatchFile {
    /// The pair: centre distance, bearings, requirement.
    pub pair: PairFile,
    /// In the order of their names.
    pub wheels: Vec<NamedGear>,
    /// In the order of their names.
    pub pinions: Vec<NamedGear>,
    /// The conditions of assembly.
    pub conditions: PairConditions,
    /// Warnings beside those of the pair.
    pub warnings: Vec<String>,
    /// Warnings of the gears' files, each with the first file that has it.
    pub gear_warnings: Vec<String>,
    /// Notes on the gears' files, each with the first file that has it.
    pub gear_remarks: Vec<String>,
}

/// Reads the pair file at `path` and every gear file (`.toml`, `.json`) of the folders `wheels` and `pinions`; `target` is the wanted
/// backlash, mm. The gears face as those of the pair file do.
///
/// # Errors
/// [`InputError`] of every file that cannot be used; of the pair file alone where it is one of them.
pub fn read_match(
    path: &Path,
    [wheels, pinions]: [&Path; 2],
    target: Option<f64>,
) -> Result<MatchFile, Vec<InputError>> {
    let mut pair = crate::read_by_data(path).map_err(|error| vec![error])?;
    if let Some(problem) = temperature_problem(pair.spec.assembly.temperature_c) {
        return Err(vec![InputError::of(path, vec![problem])]);
    }
    let (mut errors, mut bands, mut tables) = (Vec::new(), Vec::new(), Vec::new());
    let (mut gear_warnings, mut gear_remarks) = (GroupedLines::default(), GroupedLines::default());
    let mut gears = |folder: &Path, member: Member| {
        let mut gears = Vec::new();
        for file in gear_files(folder, &mut errors) {
            match read_gear(&file, member, &pair) {
                Ok(found) => {
                    bands.extend(found.band);
                    gear_warnings.add(&file, &found.warnings);
                    gear_remarks.add(&file, &found.remarks);
                    pair.sources.extend(&found.sources);
                    tables.push((file, found.table, member));
                    gears.push(found.gear);
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
    let gears = || wheels.iter().chain(&pinions);
    let why = common_face::reason_of_gears(gears().map(|one| &one.gear));
    common_face::add_to(&mut pair, why)
        .map_err(|problem| vec![InputError::of(path, vec![problem])])?;
    for (one, (file, table, member)) in gears().zip(&tables) {
        errors.extend(shape_difference(&one.spec, &pair, *member).map(|reason| {
            let help = "match gears whose teeth wind and end as those of the pair";
            InputError::of(file, vec![Problem::at(*table, reason, help)])
        }));
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let wrong = |key: &str, reason: String, help: &str| {
        vec![InputError::of(path, vec![Problem::at(key, reason, help)])]
    };
    if pair.study.open_lean != [0.0; 2] || pair.study.bearing_ends.is_some() {
        let help = "state signed deviations in assembly.misalignment, and one bearing clearance for each gear";
        let reason = "axes of unknown lean are not matched".to_owned();
        return Err(wrong("", reason, help));
    }
    let distances = &pair.study.center_distances;
    let extreme = |fold: fn(f64, f64) -> f64| distances.iter().copied().reduce(fold);
    let range = pair.study.distance_band.or(extreme(f64::min)
        .zip(extreme(f64::max))
        .map(<[f64; 2]>::from));
    let Some(center_distances) = range else {
        return Err(wrong("", "no centre distance".to_owned(), "give one"));
    };
    let requirement = AssemblyLimits::of(&pair.study.requirements);
    let mut warnings: Vec<String> = unused_warning(&pair).into_iter().collect();
    warnings.extend(band_warning(&bands));
    let mut conditions = PairConditions {
        center_distances,
        clearance: pair.study.bearing_clearance,
        locked: pair.study.locked,
        face: pair.study.face,
        lean: pair.study.lean,
        requirement,
        target,
    };
    if let (Some(wheel), Some(pinion)) = (wheels.first(), pinions.first()) {
        let pairs = extreme_pairs(&conditions, wheel, pinion).map_err(|reason| {
            let key = "assembly.center_distance_mm";
            let help = "correct the distance, or the bearings' clearance";
            wrong(key, reason.to_string(), help)
        })?;
        let limits = requirement.as_operating_backlash(&pairs);
        if target.is_none() && requirement.others().next().is_some() {
            let requirement = AssemblyLimits::new(limits.min, limits.max);
            conditions.target = Some(
                PairConditions {
                    requirement,
                    ..conditions
                }
                .target_backlash(),
            );
        }
    }
    Ok(MatchFile {
        pair,
        wheels,
        pinions,
        conditions,
        warnings,
        gear_warnings: gear_warnings.lines(),
        gear_remarks: gear_remarks.lines(),
    })
}

/// A wheel and a pinion at the least and greatest distance that the list and the bearings allow.
fn extreme_pairs(
    conditions: &PairConditions,
    wheel: &NamedGear,
    pinion: &NamedGear,
) -> Result<[GearPair; 2], GearError> {
    let [near, far] = conditions.center_distances;
    let pair = |distance: f64| {
        let (wheel, pinion) = (wheel.gear.clone(), pinion.gear.clone());
        GearPair::with_locked(wheel, pinion, distance, conditions.locked)?
            .with_face(conditions.face)?
            .with_lean(conditions.lean)
    };
    Ok([
        pair(near - conditions.clearance)?,
        pair(far + conditions.clearance)?,
    ])
}

impl MatchFile {
    /// Every pinion with each of the `wheels`, counted from 0: their cells of the matrix, wheel by wheel. `tick` is called for each pair.
    ///
    /// # Errors
    /// As [`Matrix::cells`].
    pub fn cells(&self, wheels: Range<usize>, tick: Tick) -> Result<Vec<PairFit>, Error> {
        let (all, pinions) = self.gears();
        let wheels = all.get(wheels).unwrap_or_default();
        Matrix::cells(wheels, &pinions, &self.conditions, tick)
    }

    /// Wheels and pinions.
    pub(super) fn gears(&self) -> (Vec<AsBuilt>, Vec<AsBuilt>) {
        let gears = |named: &[NamedGear]| named.iter().map(|one| one.gear.clone()).collect();
        (gears(&self.wheels), gears(&self.pinions))
    }

    /// The hash of the pair as understood, of each gear with its name, and of the wanted backlash.
    pub fn input_sha256(&self) -> String {
        let mut spec = self.pair.spec.clone();
        spec.tolerance = None;
        let gears = [&self.wheels, &self.pinions].map(|gears| {
            let each = gears.iter().map(|one| (&one.name, &one.spec));
            each.collect::<Vec<_>>()
        });
        let wanted = self.conditions.target_backlash();
        sha256(&json!({ "pair": spec, "gears": gears, "wanted": wanted }).to_string())
    }

    /// The limits that each pair must keep.
    pub fn requirement(&self) -> &AssemblyLimits {
        &self.conditions.requirement
    }
}

/// A warning that scatter and thickness bands of the pair file's own gears are ignored for measured gears.
fn unused_warning(pair: &PairFile) -> Option<String> {
    let (_, most_wheel, most_pinion) = pair.study.materials.first()?;
    let (_, least_wheel, least_pinion) = pair.study.materials.last()?;
    let [wheel, pinion] = pair.spec.by_data()?;
    let keys = [
        (most_wheel != least_wheel).then(|| thickness_key("wheel", wheel)),
        (most_pinion != least_pinion).then(|| thickness_key("pinion", pinion)),
        pair.spec
            .tolerance
            .is_some()
            .then(|| "tolerance".to_owned()),
    ];
    let keys: Vec<String> = keys.into_iter().flatten().collect();
    (!keys.is_empty()).then(|| {
        format!(
            "{}: not used: gears are matched as the files of the two folders have them",
            keys.join(", ")
        )
    })
}

/// A warning of gear files that state a band of thickness.
fn band_warning(bands: &[String]) -> Option<String> {
    let first = bands.first()?;
    let others = match bands.len() - 1 {
        0 => String::new(),
        1 => ", as in one file more".to_owned(),
        more => format!(", as in {more} files more"),
    };
    Some(format!(
        "{first}: a band, whose middle is matched{others}: state one value to match another"
    ))
}

/// The gear files of `folder`, those with the ending `.toml` or `.json`, in the order of their names.
///
/// An entry that cannot be read, is no file, or has the name of another gear becomes one of `errors`.
fn gear_files(folder: &Path, errors: &mut Vec<InputError>) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = match entries {
        Ok(entries) => entries,
        Err(reason) => {
            let reason = format!("cannot be read: {reason}");
            errors.push(problem(folder, &reason, "name a folder of gear files"));
            return Vec::new();
        }
    };
    let mut files: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
    files.retain(|path| is_gear_file_name(path));
    files.sort();
    if files.is_empty() {
        errors.push(problem(
            folder,
            "holds no gear file (.toml, .json)",
            "name a folder of gear files, one a gear",
        ));
    }
    files.retain(|path| {
        // Reading a pipe or other special file might never end.
        let reason = match std::fs::metadata(path) {
            Ok(found) if found.is_file() => return true,
            Ok(_) => "is no file".to_owned(),
            Err(reason) => format!("cannot be read: {reason}"),
        };
        let help = "correct it, or remove it from the folder";
        errors.push(problem(path, &reason, help));
        false
    });
    let mut names: BTreeMap<&OsStr, &Path> = BTreeMap::new();
    for path in &files {
        let name = path.file_stem().unwrap_or_default();
        let first = *names.entry(name).or_insert(path);
        if first != path {
            let first = first.file_name().unwrap_or_default().display();
            let reason = format!("{first} is a gear of the same name");
            let help = "rename one of them, or remove it: a gear has the name of its file without the ending";
            errors.push(problem(path, &reason, help));
        }
    }
    files
}

fn is_gear_file_name(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    let mut known = ["toml", "json"].into_iter();
    known.any(|known| ending.eq_ignore_ascii_case(known))
}

fn problem(path: &Path, reason: &str, help: &str) -> InputError {
    InputError::of(path, vec![Problem::of_file(reason, help)])
}

/// A measured gear with the name of its file.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedGear {
    /// Name of the file without its folder and ending.
    pub name: String,
    /// The gear, in the middle of a band of thickness.
    pub gear: AsBuilt,
    /// Its file as understood.
    pub spec: GearSpec,
}

struct ReadGear {
    pub gear: NamedGear,
    pub table: &'static str,
    pub sources: Sources,
    /// File and key of its thickness, where that is a band.
    pub band: Option<String>,
    pub warnings: Vec<String>,
    pub remarks: Vec<String>,
}

/// The gear of a gear file, or the `member` of a pair file. It must match a gear of `pair`, and faces as that does.
fn read_gear(path: &Path, member: Member, pair: &PairFile) -> Result<ReadGear, InputError> {
    let file = crate::read_gears_by_data(path)?;
    let wrong = |problem| InputError::of(path, vec![problem]);
    let entry = file.of(member);
    let Some((entry, spec)) = entry.and_then(|entry| Some((entry, entry.spec.data()?))) else {
        let problem = Problem::of_file("has no such gear", "name a gear file");
        return Err(wrong(problem));
    };
    if let Some(problem) = temperature_problem(file.temperature_c) {
        return Err(wrong(problem));
    }
    let mates = pair.study.materials.first();
    let Some(((_, wheel, pinion), own)) = mates.zip(pair.spec.data(member)) else {
        return Err(wrong(Problem::of_file("has no mate", "name a pair file")));
    };
    let face = [wheel, pinion][member as usize].face();
    let stated = [spec, own].map(|gear| {
        [
            ("teeth", f64::from(gear.teeth)),
            ("module_mm", gear.module_mm * gear.scale()),
            ("pressure_angle_deg", gear.pressure_angle_deg),
            ("helix_angle_deg", gear.helix_angle_deg.unwrap_or(0.0)),
        ]
    });
    let others = stated[0].iter().zip(stated[1]);
    let others = others.filter(|((_, found), (_, wanted))| found != wanted);
    let others = others.map(|((key, found), (_, wanted))| Problem {
        key: format!("{}.{key}", entry.name),
        value: Some(shortest(*found)),
        reason: format!(
            "{}.{key} of the pair file is {}",
            member.name(),
            shortest(wanted)
        ),
        help: "match gears of one pair".to_owned(),
    });
    let others: Vec<Problem> = others.collect();
    if !others.is_empty() {
        return Err(InputError::of(path, others));
    }
    let gear = middle(entry.materials.iter().map(|(_, gear)| gear));
    let gear = gear.map_err(|reason| wrong(Problem::of_file(reason, "correct the file")))?;
    let is_band = entry.materials.len() > 1;
    let name = path.file_stem().map(in_utf8);
    Ok(ReadGear {
        gear: NamedGear {
            name: name.unwrap_or_default(),
            gear: placed(gear.facing(face), pair, member),
            spec: spec.clone(),
        },
        table: entry.name,
        band: is_band.then(|| {
            let key = thickness_key(entry.name, spec);
            format!("{}: {key}", path.display())
        }),
        sources: file.sources,
        warnings: file.warnings,
        remarks: file.remarks,
    })
}

/// A name with bytes that are not UTF-8 as `\xff`, so that different names stay different.
fn in_utf8(name: &OsStr) -> String {
    let chunks = name.as_encoded_bytes().utf8_chunks();
    let text = chunks.map(|chunk| format!("{}{}", chunk.valid(), chunk.invalid().escape_ascii()));
    text.collect()
}

/// The problem of a pair at another temperature than the reference.
fn temperature_problem(temperature_c: Option<f64>) -> Option<Problem> {
    let celsius = temperature_c.filter(|celsius| *celsius != REFERENCE_C)?;
    Some(Problem {
        key: "assembly.temperature_c".to_owned(),
        value: Some(shortest(celsius)),
        ..Problem::of_file(
            format!("gears are matched at the {REFERENCE_C} °C at which they were measured"),
            "remove the temperature",
        )
    })
}

/// The key of the thickness of a gear that is called `name`.
fn thickness_key(name: &str, gear: &GearSpec) -> String {
    let key = gear.thickness.statement.key();
    let key = key.map_or(String::new(), |key| format!(".{key}"));
    format!("{name}.thickness{key}")
}
