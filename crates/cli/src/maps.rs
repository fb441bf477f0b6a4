//! Maps over centre distance and mesh phase, for `check --map` and `chart --kind map`.

use crate::console::print_note_line;
use crate::error::Error;
use crate::progress::Progress;
use gearlash::analysis::Analysis;
use gearlash::analysis::backlash_map::{BACKLASH_MAP_ROWS, BacklashMap};
use gearlash::analysis::diagnosis::{CheckedPair, Diagnosis, MAP_ROWS, ZeroDistance, map};
use gearlash::analysis::extremes::RunExtremes;
use gearlash::analysis::study::{Material, Study};
use gearlash::pair::Member;
use gearlash_results::backlash_map_csv;

/// A map of one material.
pub(super) struct DrawnMap {
    material: Material,
    pub(super) svg: String,
    csv: String,
}

impl DrawnMap {
    /// As files of a folder.
    pub(super) fn files(self) -> [(String, String); 2] {
        let name = self.material.name();
        [
            (format!("map_{name}.svg"), self.svg),
            (format!("map_{name}.csv"), self.csv),
        ]
    }
}

/// Whether a map may be a file called `name`.
pub(super) fn is_own(name: &str) -> bool {
    let map = name.strip_prefix("map_");
    let map = map.and_then(|map| map.strip_suffix(".svg").or(map.strip_suffix(".csv")));
    let materials = [Material::Most, Material::Least, Material::AsMeasured];
    map.is_some_and(|map| materials.iter().any(|material| material.name() == map))
}

/// A map for each material, at the study's first centre distance: of the contacts of the checks, or of the backlash of a pair
/// without checks.
pub(super) fn of(analysis: &Analysis) -> Result<Vec<DrawnMap>, Error> {
    if analysis.diagnosis.groups.is_empty() {
        of_backlash(analysis.study, &analysis.extremes.each)
    } else {
        of_contacts(analysis.study, &analysis.diagnosis)
    }
}

fn of_contacts(study: &Study, diagnosis: &Diagnosis) -> Result<Vec<DrawnMap>, Error> {
    let mut drawn: Vec<(&CheckedPair, &ZeroDistance)> = Vec::new();
    let mut seen = Vec::new();
    for group in &diagnosis.groups {
        let material = group.material;
        if seen.contains(&material) {
            continue;
        }
        seen.push(material);
        match &group.zero {
            Ok(Some(zero)) => drawn.push((group, zero)),
            Ok(None) => {}
            Err(reason) => print_note_line(&format!(
                "note: no map of {}: the pose with the least backlash is unproven ({reason})",
                material.words()
            )),
        }
    }
    let progress = Progress::of(drawn.len() as u64 * u64::from(MAP_ROWS), "rows of the map");
    let maps = drawn.into_iter().map(|(group, zero)| {
        let material = group.material;
        let map = map(group, zero.pose, &|steps| progress.tick(steps))?;
        let teeth = |member| group.assembly.teeth(member);
        let caption = format!(
            "{} and {} teeth, {}: what touches, over one pitch from the pose with the least backlash",
            teeth(Member::Wheel),
            teeth(Member::Pinion),
            material.words(),
        );
        Ok(DrawnMap {
            material,
            svg: gearlash_render::map_picture(&map, &study.title, &caption),
            csv: gearlash_results::map_csv(&map),
        })
    });
    maps.collect()
}

/// The backlash maps of a pair with these extremes.
fn of_backlash(study: &Study, each: &[RunExtremes]) -> Result<Vec<DrawnMap>, Error> {
    let rows = study.material_count() as u64 * u64::from(BACKLASH_MAP_ROWS);
    let progress = Progress::of(rows, "rows of the map");
    let maps = BacklashMap::of_study(study, each, &|steps| progress.tick(steps))?;
    let drawn = maps.iter().map(|map| DrawnMap {
        material: map.material,
        svg: gearlash_render::backlash_map_picture(&study.title, map),
        csv: backlash_map_csv(map),
    });
    Ok(drawn.collect())
}
