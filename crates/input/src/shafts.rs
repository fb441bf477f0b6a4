//! Shafts that are not parallel: `assembly.misalignment`, and centre distances at two places.

use super::spec::{AssemblySpec, CenterDistanceSpec, Either};
use gearlash::analysis::study::Material;
use gearlash::gear::AsBuilt;
use gearlash::pair::MOST_LEAN;
use gearlash_text::Table;
use gearlash_text::numbers::ascii;

/// Lean of axes above which it is doubted, mm per mm: 0.25 mm over 50 mm.
const DOUBTED: f64 = 5e-3;

/// Checks that the keys of the shafts go together.
pub fn check_keys(file: &Table, spec: &AssemblySpec) -> Option<()> {
    for (key, greatest) in ["in_plane_um", "out_of_plane_um"]
        .iter()
        .zip(spec.open_lean())
    {
        if greatest < 0.0 {
            return file.refuse(
                &format!("assembly.misalignment.{key}.max"),
                "below 0, allowed is a number of µm, 0 or more: it counts in either sense",
                "write the greatest amount",
            );
        }
    }
    let bearings = &spec.bearing_clearance_mm;
    let is_list = |stated| matches!(stated, Either::Other(_));
    if bearings.at_mm.is_none() && (is_list(bearings.wheel) || is_list(bearings.pinion)) {
        return file.refuse(
            "assembly.bearing_clearance_mm.at_mm",
            "missing, expected the places of both bearings beside a clearance at each",
            "write at_mm = [place, place], along the axes from the wheel's measuring plane",
        );
    }
    if let Some([one, _]) = spec
        .bearing_clearance_mm
        .at_mm
        .filter(|[one, other]| one == other)
    {
        return file.refuse(
            "assembly.bearing_clearance_mm.at_mm",
            format!("both bearings are at {one} mm, allowed are two places"),
            "write at_mm = [place, place], along the axes from the wheel's measuring plane",
        );
    }
    const ENDS: &str = "assembly.center_distance_mm.ends_mm";
    let CenterDistanceSpec::Ends(ends) = &spec.center_distance_mm else {
        return Some(());
    };
    let [[one, first], [other, second]] = ends.ends_mm;
    if one == other {
        return file.refuse(
            ENDS,
            format!("both distances are at {one} mm, allowed are two places"),
            "write ends_mm = [[place, distance], [place, distance]], places along the axes from the wheel's measuring plane",
        );
    }
    if first.min(second) <= 0.0 {
        return file.refuse(
            ENDS,
            "a centre distance is not above 0 mm",
            "write ends_mm = [[place, distance], [place, distance]]",
        );
    }
    let mut twice = ["in_plane_um", "at_mm"]
        .map(|key| format!("assembly.misalignment.{key}"))
        .into_iter();
    match twice.find(|key| file.has(key)) {
        Some(key) => file.refuse(
            &key,
            "given beside two centre distances, which state it",
            "remove it, or give one centre distance",
        ),
        None => Some(()),
    }
}

/// Checks the lean of the shafts and of the teeth on them. Returns warnings of a great lean and of conventions that the file leaves open.
pub fn check(
    file: &Table,
    spec: &AssemblySpec,
    gears: Option<&(Material, AsBuilt, AsBuilt)>,
) -> Option<Vec<String>> {
    let mut warnings = Vec::new();
    let ([in_plane, out_of_plane], open) = (spec.lean(), spec.open_lean());
    let shafts = (in_plane.abs() + open[0]).hypot(out_of_plane.abs() + open[1]);
    let wobbles = gears.map_or([0.0; 2], |(_, wheel, pinion)| {
        [wheel.wobble(), pinion.wobble()]
    });
    let lean = shafts + wobbles[0] + wobbles[1];
    let stated = [
        ("assembly.misalignment", shafts),
        ("wheel.runout", wobbles[0]),
        ("pinion.runout", wobbles[1]),
    ];
    let greatest = stated
        .into_iter()
        .max_by(|one, other| one.1.total_cmp(&other.1));
    let key = match (greatest, &spec.center_distance_mm) {
        (Some(("assembly.misalignment", _)) | None, CenterDistanceSpec::Ends(_)) => {
            "assembly.center_distance_mm"
        }
        (Some((key, _)), _) => key,
        (None, _) => "assembly",
    };
    let words = format!("axes of the teeth lean by {} mm per mm", ascii(lean, 4));
    if lean > MOST_LEAN {
        return file.refuse(
            key,
            format!("{words}, allowed is up to {MOST_LEAN} in all"),
            "check the units: deviations in µm, lengths and places in mm; crossed axes are not modelled",
        );
    }
    if lean > DOUBTED {
        warnings.push(format!(
            "{key}: {words}, more than gears run with; check the units: deviations in µm, lengths and places in mm"
        ));
    }
    let is_open = spec
        .misalignment
        .is_some_and(|stated| stated.at_mm.is_none());
    let in_plane = in_plane.abs() + open[0];
    if is_open && in_plane != 0.0 && !matches!(spec.center_distance_mm, CenterDistanceSpec::Ends(_))
    {
        warnings.push(format!(
            "assembly.misalignment.at_mm: not stated, the centre distance counts as that in the wheel's measuring plane; write at_mm = 0, or the \
             place along the axes where it was measured: it changes by {} µm every 10 mm",
            ascii(1e4 * in_plane, 2)
        ));
    }
    Some(warnings)
}
