//! Whether and where a pair assembles, in words.

use gearlash::analysis::extremes::{RunExtremes, WIDTH};
use gearlash::analysis::study::Material;
use gearlash::contact::Status;
use gearlash_text::numbers::stated_distance;

/// The state of a pair at one centre distance, material and phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Jammed,
    Interferes,
    OutOfMesh,
    NotProven,
    WithoutBacklash,
    Assembles,
}

/// A centre distance, material and phase, and the pair's state there.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    distance: f64,
    material: Material,
    phase: Option<(u32, u32)>,
    state: State,
}

impl Place {
    /// The place of a run.
    pub fn of(run: &RunExtremes) -> Place {
        let least = run.least.as_ref();
        Place {
            distance: run.assembly.center_distance(),
            material: run.material,
            phase: run.phase,
            state: match (run.status, run.assembles()) {
                (Status::Jammed, _) => State::Jammed,
                (Status::NoContact, _) => State::OutOfMesh,
                (_, Some(false)) => State::Interferes,
                (_, None) => State::NotProven,
                _ if least.is_some_and(|least| least.found().abs() <= WIDTH) => {
                    State::WithoutBacklash
                }
                _ => State::Assembles,
            },
        }
    }
}

/// Whether and where the pair assembles: in full, then shorter.
pub fn status(all: &[Place]) -> [String; 2] {
    let of = |states: &[State]| -> Vec<Place> {
        let here = all.iter().filter(|place| states.contains(&place.state));
        here.copied().collect()
    };
    let is_jammed = all.iter().all(|place| place.state == State::Jammed);
    let fits = match of(&[State::WithoutBacklash])[..] {
        [] => "Assembles",
        _ => "Assembles without backlash",
    };
    let each = [
        ("Jammed", of(if is_jammed { &[State::Jammed] } else { &[] })),
        (FAILS, of(&[State::Jammed, State::Interferes])),
        ("Out of mesh", of(&[State::OutOfMesh])),
        (UNPROVEN, of(&[State::NotProven])),
    ];
    let found = each.into_iter().find(|(_, here)| !here.is_empty());
    let (words, here) = found.unwrap_or((fits, all.to_vec()));
    let count = |places: &[Place]| distinct(places.iter().map(|place| place.distance)).len();
    let is_at_all = count(all) > 1 && count(&here) == count(all);
    // "not … at all 3 distances" could be read as "at some of them".
    let at_none = match words {
        FAILS => Some("Assembles"),
        UNPROVEN => Some("Proven to assemble"),
        _ => None,
    };
    match at_none.filter(|_| is_at_all) {
        Some(words) => {
            let at = match count(all) {
                2 => "at neither distance".to_owned(),
                all => format!("at none of the {all} distances"),
            };
            let pairs = |places: &[Place]| {
                distinct(places.iter().map(|place| (place.distance, place.material))).len()
            };
            let only = match only_material(all, &here) {
                Some(material) => format!(" ({})", material.words()),
                // One material assembles at some of them.
                None if pairs(&here) < pairs(all) => " with every material".to_owned(),
                None => String::new(),
            };
            let phases = some_phases(all, &here);
            [(); 2].map(|()| format!("{words} {at}{only}{phases}."))
        }
        None => [true, false].map(|in_full| format!("{words} {}.", places(all, &here, in_full))),
    }
}

/// The state of a pair that does not assemble.
const FAILS: &str = "Does not assemble";
/// The state of a pair that may assemble.
const UNPROVEN: &str = "Not proven to assemble";

/// The centre distances, the material and the phases of the places `here`, where they are not all.
fn places(all: &[Place], here: &[Place], in_full: bool) -> String {
    let distances = distinct(here.iter().map(|place| place.distance));
    let everywhere = distinct(all.iter().map(|place| place.distance)).len();
    let mut text = match (distances.len(), everywhere) {
        (_, 1) => format!("at a = {} mm", stated_distance(distances[0])),
        (2, 2) => "at both distances".to_owned(),
        (some, all) if some == all => format!("at all {all} distances"),
        (some, all) => {
            let named: Vec<String> = distances.iter().map(|a| stated_distance(*a)).collect();
            let named = format!(" (a = {} mm)", named.join(", "));
            let named = if in_full { &named } else { "" };
            format!("at {some} of {all} distances{named}")
        }
    };
    if let Some(material) = only_material(all, here) {
        text += &format!(", {}", material.words());
    }
    text + &some_phases(all, here)
}

/// The places of `all` at the distances of `here`.
fn at_distances_of<'a>(all: &'a [Place], here: &'a [Place]) -> impl Iterator<Item = &'a Place> {
    let is_here = |place: &&Place| here.iter().any(|of| of.distance == place.distance);
    all.iter().filter(is_here)
}

/// The material of all places `here`, where there are two at their distances.
fn only_material(all: &[Place], here: &[Place]) -> Option<Material> {
    let [material] = distinct(here.iter().map(|place| place.material))[..] else {
        return None;
    };
    let materials = distinct(at_distances_of(all, here).map(|place| place.material));
    (materials.len() > 1).then_some(material)
}

/// ` in 2 of 6 phases`; empty where `here` has all phases of its distances.
fn some_phases(all: &[Place], here: &[Place]) -> String {
    let phases = distinct(here.iter().filter_map(|place| place.phase)).len();
    match distinct(at_distances_of(all, here).filter_map(|place| place.phase)).len() {
        possible if phases < possible => format!(" in {phases} of {possible} phases"),
        _ => String::new(),
    }
}

/// The different `items`, in their order.
pub(crate) fn distinct<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut each = Vec::new();
    for item in items {
        if !each.contains(&item) {
            each.push(item);
        }
    }
    each
}
