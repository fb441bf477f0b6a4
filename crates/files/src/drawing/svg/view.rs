//! User space of an SVG: transforms, view boxes, the length of its unit.

use crate::drawing::affine::Affine;
use nalgebra::{Matrix2, Vector2};
use svgtypes::{Align, AspectRatio, Length, LengthUnit, ViewBox};

/// The length of a unit of the outermost user space by the size of the page, in words and mm; `None` where the page has no size on
/// paper, and `Err` in words where width and height do not agree.
pub fn page_unit(
    size: [Option<Length>; 2],
    view: Option<ViewBox>,
    aspect: AspectRatio,
) -> Result<Option<(String, f64)>, String> {
    let ([Some(width), Some(height)], Some(view)) = (size, view) else {
        return Ok(None);
    };
    let (Some(wide), Some(high)) = (on_paper(&width), on_paper(&height)) else {
        return Ok(None);
    };
    let scales = [wide / view.w, high / view.h];
    let scale = fitted(scales, aspect);
    if !(scale[0] > 0.0 && scale[0].is_finite()) {
        return Err("a page without size".to_owned());
    }
    // A stretch by the last printed digit is rounding.
    if (scale[1] / scale[0] - 1.0).abs() > 1e-6 {
        return Err("preserveAspectRatio=\"none\" with a page of other proportions".to_owned());
    }
    let words = format!("width {wide} mm of {} units", view.w);
    Ok(Some((words, scale[0])))
}

/// A length in mm, where its unit is one of paper: CSS Values 3, 6.2. A px belongs to a screen in practice.
fn on_paper(length: &Length) -> Option<f64> {
    let mm = match length.unit {
        LengthUnit::Mm => 1.0,
        LengthUnit::Cm => 10.0,
        LengthUnit::In => 25.4,
        LengthUnit::Pt => 25.4 / 72.0,
        LengthUnit::Pc => 25.4 / 6.0,
        _ => return None,
    };
    Some(length.number * mm)
}

/// Both scales by `preserveAspectRatio`.
fn fitted([x, y]: [f64; 2], aspect: AspectRatio) -> [f64; 2] {
    match (aspect.align, aspect.slice) {
        (Align::None, _) => [x, y],
        (_, false) => [x.min(y); 2],
        (_, true) => [x.max(y); 2],
    }
}

/// The map from the user space of a nested `svg` at `corner` with `size` to the one around it: SVG 2, 8.2.
pub fn viewport(corner: [f64; 2], size: [f64; 2], view: ViewBox, aspect: AspectRatio) -> Affine {
    let scale = fitted([size[0] / view.w, size[1] / view.h], aspect);
    let share = match aspect.align {
        Align::None | Align::XMinYMin => [0.0, 0.0],
        Align::XMidYMin => [0.5, 0.0],
        Align::XMaxYMin => [1.0, 0.0],
        Align::XMinYMid => [0.0, 0.5],
        Align::XMidYMid => [0.5, 0.5],
        Align::XMaxYMid => [1.0, 0.5],
        Align::XMinYMax => [0.0, 1.0],
        Align::XMidYMax => [0.5, 1.0],
        Align::XMaxYMax => [1.0, 1.0],
    };
    let shift = |axis: usize, from: f64, length: f64| {
        let rest = size[axis] - length * scale[axis];
        corner[axis] - from * scale[axis] + share[axis] * rest
    };
    Affine::new(
        Matrix2::from_diagonal(&Vector2::from(scale)),
        Vector2::new(shift(0, view.x, view.w), shift(1, view.y, view.h)),
    )
}
