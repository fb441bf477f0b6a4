//! `[assembly]`: how the two gears are put together.

use super::common_face;
use super::entry::Entry;
use super::gear::GearPart;
use super::limits::{
    CENTER_DISTANCE, CENTER_DISTANCE_DEVIATION, CENTER_DISTANCE_TOLERANCE, CLEARANCE, EXPANSION,
    MOST_DISTANCES, TEMPERATURE,
};
use super::node::Node;
use super::numbers::ascii;
use super::problems::Problems;
use super::spec::{
    BearingClearanceSpec, CenterDistanceSpec, DesignatedDistanceSpec, DistanceBandSpec,
};
use super::stated::{self, Keys};
use super::table::Table;
use gearlash::error::GearError;
use gearlash::metrology::Toleranced;
use gearlash::pair::Member;
use std::collections::HashSet;

pub const KEYS: &[&str] = &[
    "center_distance_mm",
    "centre_distance_mm",
    "locked",
    "bearing_clearance_mm",
    "face_offset_mm",
    "temperature_c",
    "housing_expansion_per_k",
];
const BAND_KEYS: &[&str] = &["nominal_mm", "tolerance_um", "upper_um", "lower_um"];
const DEVIATIONS: Keys = Keys {
    single: Some("tolerance_um"),
    min: "lower_um",
    max: "upper_um",
};
/// The ways to write centre distances.
const ALLOWED: &str = "a number of mm above 0 and up to 1e9, a list of such, a designation such as \"30 js7\", \
                       { nominal_mm = …, tolerance_um = … } or { nominal_mm = …, upper_um = …, lower_um = … }";
const MEMBERS: [(&str, Member); 2] = [("wheel", Member::Wheel), ("pinion", Member::Pinion)];

/// What is good of the table.
#[derive(Debug)]
pub struct AssemblyPart {
    /// Centre distances; `Some(None)` when not given.
    pub distances: Option<Option<CenterDistanceSpec>>,
    pub locked: Option<Member>,
    pub bearings: Option<BearingClearanceSpec>,
    /// mm; `Some(None)` when not given.
    pub face_offset_mm: Option<Option<f64>>,
    /// °C; `Some(None)` when not given.
    pub temperature_c: Option<Option<f64>>,
    /// 1/K; `Some(None)` when not given.
    pub housing_expansion_per_k: Option<Option<f64>>,
}

impl AssemblyPart {
    /// Reads the table; the centre distances may be absent when not `needed`.
    pub fn read(table: &Table, needed: bool, problems: &mut Problems) -> AssemblyPart {
        let name = spelling(|name| table.has(name));
        let entry = if name != KEYS[0] && table.has(KEYS[0]) {
            problems.add(table.problem(
                name,
                format!(
                    "given together with {}, the same in another spelling",
                    KEYS[0]
                ),
                "remove one or the other",
            ));
            None
        } else if needed {
            table.need(name, ALLOWED, problems).map(Some)
        } else {
            table.optional(name)
        };
        AssemblyPart {
            distances: match entry {
                Some(Some(entry)) => match entry.node() {
                    Node::Text(text) => {
                        designated(&entry, text, problems).map(CenterDistanceSpec::Designated)
                    }
                    Node::Table(_) => band(table, name, problems).map(CenterDistanceSpec::Band),
                    _ => distances(&entry, problems).map(CenterDistanceSpec::Distances),
                }
                .map(Some),
                absent => absent.map(|_| None),
            },
            locked: table.choice_or_first("locked", &MEMBERS, problems),
            bearings: bearings(table, problems),
            face_offset_mm: common_face::face_offset(table, problems),
            temperature_c: table.optional_as("temperature_c", problems, |entry| {
                entry.number(&TEMPERATURE)
            }),
            housing_expansion_per_k: table.optional_as(
                "housing_expansion_per_k",
                problems,
                |entry| entry.number(&EXPANSION),
            ),
        }
    }
}

/// The key of the centre distances, in British or American spelling: the one that `stands` there.
fn spelling(stands: impl Fn(&str) -> bool) -> &'static str {
    KEYS[usize::from(stands(KEYS[1]))]
}

/// `bearing_clearance_mm`: one for both, or one for each; none: 0.
fn bearings(table: &Table, problems: &mut Problems) -> Option<BearingClearanceSpec> {
    let Some(entry) = table.optional("bearing_clearance_mm")? else {
        return Some(BearingClearanceSpec {
            wheel: 0.0,
            pinion: 0.0,
        });
    };
    match entry.node() {
        Node::Table(_) => {
            let each = table.table("bearing_clearance_mm", &["wheel", "pinion"], problems)?;
            let wheel = each.number("wheel", &CLEARANCE, problems);
            let pinion = each.number("pinion", &CLEARANCE, problems);
            Some(BearingClearanceSpec {
                wheel: wheel?,
                pinion: pinion?,
            })
        }
        Node::Whole(_) | Node::Number(_) => {
            let both = problems.keep(entry.number(&CLEARANCE))?;
            Some(BearingClearanceSpec {
                wheel: both,
                pinion: both,
            })
        }
        _ => {
            let allowed = format!("{}, or {{ wheel = …, pinion = … }}", CLEARANCE.allowed);
            problems.add(entry.wrong_type(&allowed, CLEARANCE.help));
            None
        }
    }
}

/// A nominal distance and its tolerance, the table `name` in `assembly`.
fn band(assembly: &Table, name: &'static str, problems: &mut Problems) -> Option<DistanceBandSpec> {
    let table = assembly.table(name, BAND_KEYS, problems)?;
    let nominal_mm = table.number("nominal_mm", &CENTER_DISTANCE, problems);
    let limits = match table.has("tolerance_um") {
        true => &CENTER_DISTANCE_TOLERANCE,
        false => &CENTER_DISTANCE_DEVIATION,
    };
    let deviations = stated::read(&table, &DEVIATIONS, limits, problems);
    let (tolerance_um, lower_um, upper_um) = match deviations? {
        Toleranced::Single(tolerance) => (Some(tolerance), None, None),
        Toleranced::Band { least, most } => (None, Some(least), Some(most)),
    };
    Some(DistanceBandSpec {
        nominal_mm: nominal_mm?,
        tolerance_um,
        upper_um,
        lower_um,
    })
}

/// A designation, such as `"30 js7"`.
fn designated(
    entry: &Entry,
    text: &str,
    problems: &mut Problems,
) -> Option<DesignatedDistanceSpec> {
    let help = "write the nominal distance and js5 … js10, or { nominal_mm = …, tolerance_um = … }";
    let spec = text
        .parse()
        .and_then(|stated| DesignatedDistanceSpec::new(&stated));
    problems.keep(spec.map_err(|error| match error {
        GearError::DistanceField if !text.contains(char::is_alphabetic) => {
            entry.wrong_type(ALLOWED, CENTER_DISTANCE.help)
        }
        GearError::DistanceField => entry.problem(
            format!("no distance with a tolerance field of ISO 286 that is known, js5 … js10; allowed is {ALLOWED}"),
            help,
        ),
        _ => entry.problem(error.to_string(), help),
    }))
}

fn distances(entry: &Entry, problems: &mut Problems) -> Option<Vec<f64>> {
    let list = match entry.node() {
        Node::List(_) => entry.numbers(&CENTER_DISTANCE, problems)?,
        Node::Whole(_) | Node::Number(_) => {
            return problems
                .keep(entry.number(&CENTER_DISTANCE))
                .map(|mm| vec![mm]);
        }
        _ => {
            problems.add(entry.wrong_type(ALLOWED, CENTER_DISTANCE.help));
            return None;
        }
    };
    let mut seen = HashSet::new();
    let wrong = if list.is_empty() {
        "an empty list, expected at least one centre distance".to_owned()
    } else if list.len() > MOST_DISTANCES {
        format!("{} centre distances, allowed are up to 10 000", list.len())
    } else if let Some(twice) = list.iter().find(|mm| !seen.insert(mm.to_bits())) {
        format!("{twice:?} is listed twice, allowed is each distance once")
    } else {
        return Some(list);
    };
    problems.add(entry.problem(wrong, "list each centre distance to be run once"));
    None
}

/// Reports module or pressure angle that the gears do not share; `None` then, or when either is not known.
pub fn check_shared(
    file: &Table,
    wheel: &GearPart,
    pinion: &GearPart,
    problems: &mut Problems,
) -> Option<()> {
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
            problems.add(file.problem(
                &format!("pinion.{name}"),
                format!("differs from wheel.{name} = {wheel:?}, must be equal on both gears"),
                "correct one of them: gears of different basic racks do not mesh",
            ));
            shared = None;
        }
    }
    shared
}

/// What is wrong with the centre distance `a`, mm, between gears of these base radii' sum, if anything.
pub fn overlap(a: f64, base_radii: f64) -> Option<String> {
    let overlap = GearError::BaseCirclesOverlap {
        center_distance_mm: a,
        least_mm: base_radii,
    };
    (a <= base_radii).then(|| overlap.to_string())
}

/// Reports each distance of the pair file at which base circles overlap.
pub fn check_distances(file: &Table, list: &[f64], base_radii: f64, problems: &mut Problems) {
    let mut bad = Problems::of_list();
    let key = spelling(|name| file.has(&format!("assembly.{name}")));
    let key = format!("assembly.{key}");
    for reason in list.iter().filter_map(|&a| overlap(a, base_radii)) {
        bad.add(file.problem(
            &key,
            reason,
            "check the distance, teeth and module: a pair without profile shift runs at m (z_1 + z_2)/2",
        ));
    }
    problems.add_list(&key, bad);
}

/// Reports a bearing clearance that lets the base circles overlap at the least good distance of `list`.
pub fn check_clearance(
    file: &Table,
    list: &[f64],
    base_radii: f64,
    clearance: f64,
    problems: &mut Problems,
) {
    let least = list
        .iter()
        .copied()
        .filter(|&a| a > base_radii)
        .min_by(f64::total_cmp);
    if let Some(a) = least.filter(|&a| a - clearance <= base_radii) {
        problems.add(file.problem(
            "assembly.bearing_clearance_mm",
            format!(
                "lets the gears at {a:?} mm approach to {} mm, where base circles overlap: allowed is both clearances together below {} mm",
                ascii(a - clearance, 6),
                ascii(a - base_radii, 6)
            ),
            "check the unit: mm, as radial play",
        ));
    }
}
