//! Drawings on the command line.

use crate::error::Error;
use gearlash_files::drawing::{Format, Unit};
use gearlash_files::outlines::OutlineOptions;
use std::path::Path;

/// Options for reading drawings.
#[derive(clap::Args)]
pub(super) struct DrawnArgs {
    /// Unit of drawings that state none
    #[arg(long, value_name = "UNIT", value_parser = Unit::NAMED.map(|(name, _)| name))]
    units: Option<String>,
    /// Axes of drawings: of the circle through the tips, or of the one circle inside [default: 0,0]
    #[arg(long, value_name = "HOW", value_parser = ["fit", "bore"])]
    center: Option<String>,
    /// DXF layer to read; of two drawings A,B
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    layer: Vec<String>,
    /// SVG element to read; of two drawings A,B
    #[arg(long, value_name = "ID", value_delimiter = ',')]
    id: Vec<String>,
    /// Outline to read, from 1 in the order of the file; of two drawings A,B
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=10_000))]
    number: Vec<u32>,
    /// A point inside the outline to read, mm; of two drawings twice
    #[arg(long, value_name = "X,Y", value_parser = point, allow_hyphen_values = true)]
    at_mm: Vec<[f64; 2]>,
}

impl DrawnArgs {
    /// The options that belong to drawings.
    pub(super) const NAMES: &'static str = "--units, --center, --layer, --id, --number and --at-mm";

    /// Whether any of them is given.
    pub(super) fn given(&self) -> bool {
        self.units.is_some()
            || self.center.is_some()
            || !self.layer.is_empty()
            || !self.id.is_empty()
            || !self.number.is_empty()
            || !self.at_mm.is_empty()
    }

    /// The options of `N` drawings. One value applies to all of them.
    pub(super) fn options<const N: usize>(&self) -> Result<[OutlineOptions<'_>; N], Error> {
        let counts = [
            ("--layer", self.layer.len()),
            ("--id", self.id.len()),
            ("--number", self.number.len()),
            ("--at-mm", self.at_mm.len()),
        ];
        if let Some((name, count)) = counts.into_iter().find(|(_, count)| *count > N) {
            return Err(Error::Usage(format!(
                "{name} has {count} values for {N} {}; give one for each",
                if N == 1 { "drawing" } else { "drawings" }
            )));
        }
        let options = std::array::from_fn(|k| OutlineOptions {
            units: self.units.as_deref(),
            center: self.center.as_deref(),
            layer: value_of(&self.layer, k).map(String::as_str),
            id: value_of(&self.id, k).map(String::as_str),
            number: value_of(&self.number, k).copied(),
            at_mm: value_of(&self.at_mm, k).copied(),
        });
        Ok(options)
    }
}

/// The value for the drawing `k`: its own, or the only one.
fn value_of<T>(values: &[T], k: usize) -> Option<&T> {
    match values {
        [one] => Some(one),
        several => several.get(k),
    }
}

/// A point from `x,y`.
fn point(text: &str) -> Result<[f64; 2], String> {
    let numbers = text.split_once(',').and_then(|(x, y)| {
        let [x, y] = [x, y].map(|number| number.trim().parse::<f64>().ok());
        Some([x?, y?])
    });
    let finite = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
    finite.ok_or_else(|| "expected x,y in mm, such as 12.5,-3".to_owned())
}

/// Whether a file is a drawing, by its extension.
pub(super) fn is_drawing(path: &Path) -> bool {
    Format::of(path).is_some()
}
