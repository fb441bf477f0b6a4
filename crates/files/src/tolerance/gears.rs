//! Measured gears that are drawn whole.

use crate::place::Place;
use crate::problems::Problems;
use crate::read::GearsFile;
use crate::spec::GearSpec;
use crate::table::Table;
use gearlash::gear::AsBuilt;
use gearlash::pair::Member;
use std::path::{Path, PathBuf};

/// Gear files of one list: more would not be a folder of measurements.
const MOST_GEARS: usize = 100_000;

/// A measured gear and its table.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGear {
    pub gear: AsBuilt,
    pub spec: GearSpec,
}

/// The gears that `names` stand for, in the order of the names and of the files' names: of a pair file its `member`.
pub fn gears(
    names: &[String],
    member: Member,
    (file, key): (&Table, &str),
    problems: &mut Problems,
) -> Option<Vec<MeasuredGear>> {
    let mut bad = Problems::of_list();
    let mut wrong = |reason: String, help: &str| bad.add(file.problem(key, reason, help));
    let mut gears = Vec::new();
    for name in names {
        let found = paths(file.place(), name);
        match found {
            Err(reason) => wrong(format!("{name:?}: {reason}"), "correct the name"),
            Ok(found) if found.is_empty() => wrong(
                format!("{name:?}: there is no such file"),
                "name gear files, such as \"measured/*.toml\", beside the pair file",
            ),
            Ok(found) => {
                for path in found {
                    if gears.len() >= MOST_GEARS {
                        wrong(
                            format!("more than {MOST_GEARS} gears"),
                            "name fewer of them",
                        );
                        break;
                    }
                    match one(&path, member, file.place()) {
                        Ok(gear) => gears.push(gear),
                        Err(reason) => wrong(
                            format!("{}: {reason}", path.display()),
                            "correct the file: gearlash gauge says what is wrong with it",
                        ),
                    }
                }
            }
        }
    }
    let good = bad.is_empty();
    problems.add_list(key, bad);
    good.then_some(gears)
}

/// The files that `name` stands for.
fn paths(place: &Place, name: &str) -> Result<Vec<PathBuf>, String> {
    if !name.contains(['*', '?', '[']) {
        let path = place.folder().join(name);
        return Ok(path.is_file().then_some(path).into_iter().collect());
    }
    let folder = place.folder().to_string_lossy();
    let pattern = match (folder.as_ref(), Path::new(name).is_absolute()) {
        ("", _) | (_, true) => name.to_owned(),
        (folder, false) => format!("{}/{name}", glob::Pattern::escape(folder)),
    };
    let found = glob::glob(&pattern).map_err(|error| error.msg.to_owned())?;
    Ok(found.flatten().filter(|path| path.is_file()).collect())
}

/// The gear of a gear file, or the `member` of a pair file: of a band of thickness the middle.
fn one(path: &Path, member: Member, place: &Place) -> Result<MeasuredGear, String> {
    // What stands in the file is not quoted: it may lie outside the pair file's folder.
    let file: GearsFile = crate::read_gears(path).map_err(|error| match error.problems.len() {
        1 => "this is no gear file that can be read".to_owned(),
        several => format!("this is no gear file that can be read: {several} problems"),
    })?;
    place.read_too(&file.sources);
    let own = |name: &str| name == "gear" || name == member.name();
    let gear = file.gears.into_iter().find(|gear| own(gear.name));
    let gear = gear.ok_or("has no such gear")?;
    let middle = super::population::middle(gear.materials.iter().map(|(_, gear)| gear));
    Ok(MeasuredGear {
        gear: middle.map_err(|error| error.to_string())?,
        spec: gear.spec,
    })
}
