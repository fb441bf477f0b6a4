//! Maps over centre distance and mesh phase: of the contacts, and of the backlash of drawn gears.

mod grid;

use crate::kit::Axis;
use crate::pose_name::pose_name;
use gearlash::analysis::backlash_map::BacklashMap;
use gearlash::analysis::diagnosis::{Map, MapCell};
use gearlash::analysis::study::Material;
use gearlash::contact::{ContactKind, PoseClass, Status};
use gearlash_files::numbers::shortest;
use grid::Grid;
use svg::node::element::SVG;

/// Colours of cells and their meanings, distinguished by lightness first.
const SHADES: [(&str, &str); 7] = [
    ("#d7ebdf", "involutes, with backlash"),
    ("#a9c7e0", "involutes, interference"),
    ("#f0b45a", "tip corner off the line"),
    ("#c8452f", "fillet or undercut edge"),
    ("#4a1f2e", "jam: tip in root"),
    ("#ffffff", "nothing touches"),
    ("#ff00ff", "unproven: contact lost"),
];

/// The index of a cell's shade.
fn shade(cell: &MapCell) -> usize {
    match cell.class {
        PoseClass::Contact(ContactKind::Involute) => {
            usize::from(cell.backlash.is_some_and(|j| j < 0.0))
        }
        PoseClass::Contact(ContactKind::TipInvolute | ContactKind::TipTip) => 2,
        PoseClass::Contact(_) => 3,
        PoseClass::Jammed => 4,
        PoseClass::NoContact => 5,
        PoseClass::Unproven => 6,
    }
}

/// `map` as SVG, with `title` and `caption` (the pair) above.
pub fn map_picture(map: &Map, title: &str, caption: &str) -> String {
    let phase = format!("pitches on from {}", pose_name(&map.start));
    let grid = Grid {
        distances: &map.distances,
        columns: map.fractions.len(),
        phase: Axis::new(&phase, [0.0, 1.0]),
        limits: &map.limits,
        shades: SHADES
            .map(|(colour, name)| (colour, name.to_owned()))
            .to_vec(),
        cells: map.cells.iter().map(shade).collect(),
    };
    format!("{}\n", grid.picture(title, caption))
}

/// Steps of backlash above zero.
const STEPS: usize = 4;

/// Darker colours mean less backlash, also in black and white.
const COLOURS: [&str; 9] = [
    "#4a1f2e", "#a83224", "#e08a3c", "#8fc7a6", "#b5dac4", "#d7ebdf", "#eef7f1", "#ffffff",
    "#ff00ff",
];

/// `map` as SVG with `title` above.
pub fn backlash_map_picture(title: &str, map: &BacklashMap) -> String {
    let [picture, _] = draw(title, map);
    format!("{picture}\n")
}

/// The map as part of a page, for a wide and for a narrow screen. Its ids begin with `prefix`.
pub(crate) fn backlash_map_in_page(prefix: &str, title: &str, map: &BacklashMap) -> String {
    let label = "Backlash over mesh cycle and centre distance";
    let pictures = draw(title, map).into_iter();
    let named = pictures.zip([prefix.to_owned(), format!("{prefix}-narrow")]);
    let named = named.map(|(picture, id)| {
        let picture = picture.set("id", id).set("role", "img");
        format!("{}\n", picture.set("aria-label", label))
    });
    named.collect()
}

/// The map for a wide and for a narrow screen.
fn draw(title: &str, map: &BacklashMap) -> [SVG; 2] {
    let [wheel, pinion] = map.teeth;
    let caption = format!(
        "{wheel} and {pinion} teeth{}: backlash j_wt over the whole mesh cycle, the least in each cell",
        match map.material {
            Material::AsMeasured => String::new(),
            material => format!(", {}", material.words()),
        }
    );
    let cells = map.cells.iter();
    let um = cells.filter_map(|cell| Some(1e3 * cell.backlash?));
    let greatest = um.fold(0.0, f64::max);
    let step = step(greatest / STEPS as f64);
    let upto = |steps: usize| shortest(step * steps as f64);
    let mut names = vec![
        "jammed: a tip in a root".to_owned(),
        format!("interference beyond {} µm", upto(1)),
        format!("interference up to {} µm", upto(1)),
    ];
    names.extend((1..STEPS).map(|k| format!("backlash {} … {} µm", upto(k - 1), upto(k))));
    names.push(format!("backlash above {} µm", upto(STEPS - 1)));
    names.push("out of mesh".to_owned());
    names.push("not settled".to_owned());
    let cells = map.cells.iter().map(|cell| match cell.status {
        Status::Unproven => 8,
        Status::NoContact => 7,
        Status::Jammed => 0,
        Status::Clear | Status::Interference => {
            let steps = cell.backlash.map_or(0.0, |mm| 1e3 * mm / step);
            // From −1 step on, one shade per step.
            (steps.floor() + 3.0).clamp(1.0, 6.0) as usize
        }
    });
    let phase = format!(
        "pitches from mating {}·{} on",
        map.start.wheel_tooth, map.start.pinion_tooth
    );
    let grid = Grid {
        distances: &map.distances,
        columns: map.columns,
        phase: Axis::new(&phase, [0.0, map.matings as f64]),
        limits: &map.limits,
        shades: COLOURS.into_iter().zip(names).collect(),
        cells: cells.collect(),
    };
    [grid.picture(title, &caption), grid.narrow()]
}

/// The least of 1, 2 and 5 times a power of ten, µm, that is at least `least`.
fn step(least: f64) -> f64 {
    let power = 10f64.powf(least.max(1e-3).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|times| times * power);
    let found = steps.into_iter().find(|step| *step >= least * (1.0 - 1e-9));
    found.unwrap_or(10.0 * power)
}
