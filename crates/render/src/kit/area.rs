//! Areas that a picture fills, strokes and clips by, each with an id.
//!
//! Programs limit what can be used. Inkscape 1.2 shows `<use>` only with XLink's `href`. LibreOffice 7.4 neither clips by a
//! `<use>` nor clips one. So `href` is XLink's, a clip has its own copy of the path, and the clipped element is a group.

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

/// A group clipped to the area `name`.
pub fn within_area(ids: &Ids, name: &str) -> Group {
    Group::new().set("clip-path", ids.url(&format!("{name}-clip")))
}

/// The outline of the area `name`, on its inner side only: half the stroke's width is visible.
pub fn inner_outline(ids: &Ids, name: &str, colour: &str, width: &str) -> Group {
    let stroke = area(ids, name)
        .set("fill", "none")
        .set("stroke", colour)
        .set("stroke-width", width)
        .set("stroke-linejoin", "round");
    within_area(ids, name).add(stroke)
}
