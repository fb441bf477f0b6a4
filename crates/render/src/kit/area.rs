//! Areas that a picture fills, strokes and clips by, each under an id of its own.
//!
//! What readers do not understand is left out: Inkscape 1.2 shows no `<use>` but by XLink's `href`, LibreOffice 7.4 neither
//! clips by a `<use>` nor clips one. So `href` is XLink's, a clip has its own copy of the path, and what is clipped is a group.

use super::frame::Spot;
use super::sheet::{Ids, path_data};
use svg::node::element::{ClipPath, Definitions, Group, Path, Use};

/// `definitions` with the inside of `points` as the area `name`.
pub fn define_area(
    definitions: Definitions,
    ids: &Ids,
    name: &str,
    points: &[Spot],
) -> Definitions {
    let path = Path::new().set("d", path_data(points, true));
    definitions.add(path.clone().set("id", ids.of(name))).add(
        ClipPath::new()
            .set("id", ids.of(&format!("{name}-clip")))
            .add(path),
    )
}

/// The area `name`, to be filled or stroked.
pub fn area(ids: &Ids, name: &str) -> Use {
    Use::new().set("xlink:href", format!("#{}", ids.of(name)))
}

/// A group of which only what lies within the area `name` shows.
pub fn within_area(ids: &Ids, name: &str) -> Group {
    Group::new().set("clip-path", ids.url(&format!("{name}-clip")))
}

/// The outline of the area `name`, on its inner side alone: half the stroke's width shows.
pub fn inner_outline(ids: &Ids, name: &str, colour: &str, width: &str) -> Group {
    let stroke = area(ids, name)
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", width)
        .set("stroke-linejoin", "round");
    within_area(ids, name).add(stroke)
}
