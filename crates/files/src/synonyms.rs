//! Names of keys in formulas, drawings and other programs.

/// A key and its other names, in small letters and without underscores.
const SYNONYMS: [(&str, &str); 15] = [
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
    ("root_radius", "rho rhof rhofp fillet filletradius"),
    ("total_um", "fr um"),
    ("over_pins", "overballs mdk mdr pins"),
    ("mm", "w wk"),
    ("helix_slope_um", "fhbeta fhb fhbetaum fhbum helixslope"),
];

/// The key of `known` that is also called `name`.
pub fn synonym<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    const LONGEST: usize = 64;
    let name = (name.len() <= LONGEST).then(|| name.to_lowercase().replace(['_', '-', '*'], ""))?;
    let called = |names: &str| names.split(' ').any(|other| other == name);
    let mut all = SYNONYMS.iter().filter(|(_, names)| called(names));
    all.find_map(|(key, _)| known.iter().copied().find(|known| known == key))
}
