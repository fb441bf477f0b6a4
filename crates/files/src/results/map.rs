//! The map of what touches over centre distance and mesh phase, as CSV.

use super::table::{Column, Table, Unit};
use gearlash::diagnosis::Map;

/// `map` as CSV, a row a pose.
///
/// # Errors
/// None that a map can cause; the writer's otherwise.
pub fn map_csv(map: &Map) -> Result<String, csv::Error> {
    let distances = map.distances.iter();
    let places = distances.flat_map(|distance| {
        let fractions = map.fractions.iter();
        fractions.map(|fraction| (*distance, *fraction))
    });
    let (distances, fractions): (Vec<f64>, Vec<f64>) = places.unzip();
    let cells = || map.cells.iter();
    let table = Table {
        name: "map",
        columns: vec![
            Column::new("center_distance_mm", Unit::Mm, distances),
            Column::new("fraction", Unit::None, fractions),
            Column::new("class", Unit::None, cells().map(|cell| cell.class.name())),
            Column::new(
                "j_wt_um",
                Unit::Um,
                cells().map(|cell| cell.backlash.map(|j| j * 1e3)),
            ),
        ],
    };
    table.to_csv()
}
