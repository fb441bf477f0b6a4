//! A measured gear of a folder.

use crate::Sources;
use crate::error::{InputError, Problem};
use crate::numbers::shortest;
use crate::read::PairFile;
use crate::spec::GearSpec;
use crate::temperature::REFERENCE_C;
use crate::tolerance::{middle, placed};
use gearlash::gear::AsBuilt;
use gearlash::pair::Member;
use std::ffi::OsStr;
use std::path::Path;

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

pub struct ReadGear {
    pub gear: NamedGear,
    pub table: &'static str,
    pub sources: Sources,
    /// File and key of its thickness, where that is a band.
    pub band: Option<String>,
    pub warnings: Vec<String>,
    pub remarks: Vec<String>,
}

/// The gear of a gear file, or the `member` of a pair file. It must match a gear of `pair`, and faces as that does.
pub fn one(path: &Path, member: Member, pair: &PairFile) -> Result<ReadGear, InputError> {
    let file = crate::read_gears_by_data(path)?;
    let wrong = |problem| InputError::of(path, vec![problem]);
    let entry = file.of(member);
    let Some((entry, spec)) = entry.and_then(|entry| Some((entry, entry.spec.data()?))) else {
        let problem = Problem::of_file("has no such gear", "name a gear file");
        return Err(wrong(problem));
    };
    if let Some(problem) = warm(file.temperature_c) {
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
pub fn warm(temperature_c: Option<f64>) -> Option<Problem> {
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
pub fn thickness_key(name: &str, gear: &GearSpec) -> String {
    let key = gear.thickness.statement.key();
    let key = key.map_or(String::new(), |key| format!(".{key}"));
    format!("{name}.thickness{key}")
}
