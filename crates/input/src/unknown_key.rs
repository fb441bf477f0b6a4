//! Unknown keys: those that are not supported, with the reason; removed ones, with their successors; and the known key or word that a
//! misspelt one means.

use gearlash_text::Node;

const INTERNAL: &str = "internal gears are not modelled yet: both gears are external";

/// Parts of a key's words that mean a deviation of the lead; its reason and the remedy outside its table.
const LEAD: (&str, &str, &str) = (
    "lead helix_slope helix_form f_h_beta f_hb crown",
    "deviations of the lead have a table of their own",
    "write it in [lead] below the gear: slope_um, helix_slope_um, crowning_um, end_relief or trace",
);

/// Parts of a key's words, the reason for no such key, and the remedy.
const UNSUPPORTED: [(&str, &str, &str); 4] = [
    (
        "shaft_angle axis_angle axes_angle crossed",
        "the axes are nearly parallel: crossed ones are not modelled",
        "remove it",
    ),
    (
        "tilt skew misalign parallelism f_sigma",
        "shafts that are not parallel have a key of their own",
        "write misalignment = { in_plane_um = …, out_of_plane_um = …, over_mm = … } in [assembly]",
    ),
    (
        "wobble swash axial_runout face_runout",
        "wobble is stated by the runout",
        "write planes = […] or face_runout = { … } in [runout] below the gear",
    ),
    ("internal ring_gear", INTERNAL, "remove it"),
];

/// Removed keys: the end of the path, the reason and the remedy.
const REMOVED: [(&str, &str, &str); 1] = [(
    "thickness.file",
    "the key is gone: thickness is not taken from the probe's positions in a curve file",
    "state the thickness by `span`, `over_pins` or another key of the table",
)];

/// The reason why this number of `teeth`, or a word beside it, is not allowed, where it means an internal gear.
pub fn teeth_reason(path: &str, node: &Node) -> Option<&'static str> {
    let is_internal = match node {
        Node::Whole(teeth) => *teeth < 0 && path.ends_with("teeth"),
        Node::Text(word) => word.eq_ignore_ascii_case("internal"),
        _ => false,
    };
    is_internal.then_some(INTERNAL)
}

/// The reason and the remedy for a key `name` that is not supported, by its dotted `path` and value.
pub fn key_reason(path: &str, name: &str, node: &Node) -> Option<(&'static str, &'static str)> {
    let gone = REMOVED.iter().find(|(end, ..)| path.ends_with(end));
    if let Some((_, reason, help)) = gone {
        return Some((reason, help));
    }
    if let Some(reason) = teeth_reason(path, node) {
        return Some((reason, "remove it"));
    }
    let name = name.to_lowercase();
    // Only at the beginning of a word: `misleading` does not match.
    let starts = |part: &str| {
        name.match_indices(part)
            .any(|(at, _)| at == 0 || name[..at].ends_with('_'))
    };
    let is_one_of = |parts: &str| parts.split(' ').any(starts);
    let (parts, reason, help) = LEAD;
    // A gear's own key, not a slip in one of its tables.
    if is_one_of(parts) && path.matches('.').count() == 1 {
        return Some((reason, help));
    }
    let mut taken = UNSUPPORTED.iter();
    let (_, reason, help) = taken.find(|(parts, ..)| is_one_of(parts))?;
    Some((reason, help))
}

/// The longest word that is compared with known ones, characters.
const LONGEST: usize = 64;

/// The word of `known` with the least edit distance from `word`, and that distance.
///
/// The first wins a tie. A word over 64 characters has none: no known word is half as long.
pub fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<(&'k str, usize)> {
    if word.chars().nth(LONGEST).is_some() {
        return None;
    }
    known
        .iter()
        .map(|&candidate| (candidate, strsim::osa_distance(word, candidate)))
        .min_by_key(|&(_, distance)| distance)
}

/// Whether `distance` is so small that `word` must be a typing error: at most two in five of its letters.
///
/// Tuned: `theet` is `teeth`, `phases` is not `start`.
pub fn is_slip(word: &str, distance: usize) -> bool {
    5 * distance <= 2 * word.chars().count()
}

/// A key and its other names, in small letters and without underscores.
const SYNONYMS: [(&str, &str); 16] = [
    ("teeth", "z z1 z2 n numberofteeth numteeth zaehnezahl"),
    ("module_mm", "m mn module modul normalmodule"),
    (
        "pressure_angle_deg",
        "alpha alphan alphadeg pressureangle angle",
    ),
    (
        "profile_shift",
        "x x1 x2 shift addendummodification profileshiftcoefficient",
    ),
    ("helix_angle_deg", "beta betadeg helixangle helix"),
    ("face_width_mm", "b width widthmm facewidth"),
    ("tip_diameter_mm", "da tipdiameter outsidediameter"),
    (
        "center_distance_mm",
        "a centerdistance centredistance axisdistance",
    ),
    ("addendum", "ha hap"),
    ("dedendum", "hf hfp"),
    (
        "root_radius",
        "rho rhof rhofp fillet filletradius tipradius",
    ),
    ("rack", "basicrack toolrack tool referenceprofile"),
    ("total_um", "fr um"),
    ("over_pins", "overballs mdk mdr pins"),
    ("mm", "w wk"),
    ("helix_slope_um", "fhbeta fhb fhbetaum fhbum helixslope"),
];

/// The key of `known` that is also called `name`.
pub fn synonym<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    let name = (name.len() <= LONGEST).then(|| name.to_lowercase().replace(['_', '-', '*'], ""))?;
    let called = |names: &str| names.split(' ').any(|other| other == name);
    let mut all = SYNONYMS.iter().filter(|(_, names)| called(names));
    all.find_map(|(key, _)| known.iter().copied().find(|known| known == key))
}
