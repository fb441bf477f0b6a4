//! Maps over centre distance and mesh phase: of the contacts, and of the backlash of drawn gears.

mod grid;
mod outlines;

use crate::kit::Axis;
use crate::pose_name::pose_name;
use gearlash::analysis::diagnosis::{Map, MapCell};
use gearlash::contact::{ContactKind, PoseClass};
use grid::Grid;
pub(crate) use outlines::backlash_map_in_page;
pub use outlines::backlash_map_picture;

/// The quantity of a cell's colour; distinguished by lightness first.
#[derive(Clone, Copy, PartialEq)]
enum Shade {
    Involute,
    Overlap,
    Corner,
    Fillet,
    Jam,
    Nothing,
    Unproven,
}

impl Shade {
    /// All shades, in order.
    const ALL: [Shade; 7] = [
        Shade::Involute,
        Shade::Overlap,
        Shade::Corner,
        Shade::Fillet,
        Shade::Jam,
        Shade::Nothing,
        Shade::Unproven,
    ];

    fn of(cell: &MapCell) -> Shade {
        match cell.class {
            PoseClass::NoContact => Shade::Nothing,
            PoseClass::Jammed => Shade::Jam,
            PoseClass::Unproven => Shade::Unproven,
            PoseClass::Contact(ContactKind::Involute) => {
                if cell.backlash.is_some_and(|j| j < 0.0) {
                    Shade::Overlap
                } else {
                    Shade::Involute
                }
            }
            PoseClass::Contact(ContactKind::TipInvolute | ContactKind::TipTip) => Shade::Corner,
            PoseClass::Contact(_) => Shade::Fillet,
        }
    }

    fn colour(self) -> &'static str {
        match self {
            Shade::Nothing => "#ffffff",
            Shade::Involute => "#d7ebdf",
            Shade::Overlap => "#a9c7e0",
            Shade::Corner => "#f0b45a",
            Shade::Fillet => "#c8452f",
            Shade::Jam => "#4a1f2e",
            Shade::Unproven => "#ff00ff",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Shade::Nothing => "nothing touches",
            Shade::Involute => "involutes, with backlash",
            Shade::Overlap => "involutes, interference",
            Shade::Corner => "tip corner off the line",
            Shade::Fillet => "fillet or undercut edge",
            Shade::Jam => "jam: tip in root",
            Shade::Unproven => "unproven: contact lost",
        }
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
        shades: Shade::ALL
            .map(|shade| (shade.colour(), shade.name().to_owned()))
            .to_vec(),
        cells: map
            .cells
            .iter()
            .map(|cell| Shade::of(cell) as usize)
            .collect(),
    };
    format!("{}\n", grid.picture(title, caption))
}
