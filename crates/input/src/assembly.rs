//! `[assembly]`: the assembly of the two gears, checked together with them.

use super::check::Checked;
use super::gear::GearPart;
use super::shafts;
use super::spec::{AssemblySpec, CenterDistanceSpec};
use gearlash::error::GearError;
use gearlash_text::numbers::ascii;
use gearlash_text::{Node, Table};
use std::collections::HashSet;

/// Reads `[assembly]`; the centre distances may be absent when not `needed`.
pub fn read(file: &Checked, needed: bool) -> Option<AssemblySpec> {
    const KEY: &str = "assembly.center_distance_mm";
    let empty = Node::Table(Vec::new());
    let stated = file.read::<AssemblySpec>("assembly")?;
    let spec = stated.or_else(|| empty.to::<AssemblySpec>().ok())?;
    shafts::check_keys(file.table(), &spec)?;
    let CenterDistanceSpec::Distances(list) = &spec.center_distance_mm else {
        return Some(spec);
    };
    let table = file.table();
    if list.is_empty() && needed {
        return table.refuse(
            KEY,
            "missing, expected a number of mm above 0 and up to 1e9",
            "add `center_distance_mm` to [assembly]",
        );
    }
    let mut seen = HashSet::new();
    let duplicate = list.iter().find(|mm| !seen.insert(mm.to_bits()));
    if let Some(duplicate) = duplicate {
        return table.refuse(
            spelling(table),
            format!("{duplicate:?} is listed twice, allowed is each distance once"),
            "list each centre distance to be run once",
        );
    }
    Some(spec)
}

/// The key of the centre distances, in British or American spelling.
fn spelling(file: &Table) -> &'static str {
    let british = "assembly.centre_distance_mm";
    if file.has(british) {
        british
    } else {
        "assembly.center_distance_mm"
    }
}

/// Reports module or pressure angle that the gears do not share; `None` then, or when either is not known.
pub fn check_shared(file: &Table, wheel: &GearPart, pinion: &GearPart) -> Option<()> {
    let mut shared = Some(());
    for (name, wheel, pinion) in [
        ("module_mm", wheel.module_mm, pinion.module_mm),
        (
            "pressure_angle_deg",
            wheel.pressure_angle_deg,
            pinion.pressure_angle_deg,
        ),
    ] {
        let (Some(wheel), Some(pinion)) = (wheel, pinion) else {
            shared = None;
            continue;
        };
        if wheel != pinion {
            file.add(
                &format!("pinion.{name}"),
                format!("differs from wheel.{name} = {wheel:?}, must be equal on both gears"),
                "correct one of them: gears of different basic racks do not mesh",
            );
            shared = None;
        }
    }
    shared
}

/// The fault of the centre distance `a`, mm, where the base circles overlap; `base_radii` is the sum of both radii.
pub fn overlap(a: f64, base_radii: f64) -> Option<String> {
    let overlap = GearError::BaseCirclesOverlap {
        center_distance_mm: a,
        least_mm: base_radii,
    };
    (a <= base_radii).then(|| overlap.to_string())
}

/// Reports each distance of the pair file at which base circles overlap.
pub fn check_distances(file: &Table, list: &[f64], base_radii: f64) {
    let key = spelling(file);
    file.reading().list(key, || {
        for reason in list.iter().filter_map(|&a| overlap(a, base_radii)) {
            file.add(
                key,
                reason,
                "check the distance, teeth and module: a pair without profile shift runs at m (z_1 + z_2)/2",
            );
        }
        Some(())
    });
}

/// Reports a bearing clearance that lets the base circles overlap at the least good distance of `list`.
pub fn check_clearance(file: &Table, list: &[f64], base_radii: f64, clearance: f64) {
    let least = list
        .iter()
        .copied()
        .filter(|&a| a > base_radii)
        .min_by(f64::total_cmp);
    if let Some(a) = least.filter(|&a| a - clearance <= base_radii) {
        file.add(
            "assembly.bearing_clearance_mm",
            format!(
                "lets the gears at {a:?} mm approach to {} mm, where base circles overlap: allowed is both clearances together below {} mm",
                ascii(a - clearance, 6),
                ascii(a - base_radii, 6)
            ),
            "check the unit: mm, as radial play",
        );
    }
}
