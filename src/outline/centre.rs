//! The centre of an outline that states none: that of the circle on which its tips stand.

use super::error::OutlineError;
use super::path::ClosedPath;
use super::polygon;
use super::segment::PathSegment;
use super::teeth::find;
use nalgebra::{Matrix3, Point2, Vector3};

/// Rounds: each finds the tips anew about the centre of the round before; the centre moves by the tips' own spread at most (tuned).
const ROUNDS: u32 = 8;

/// A centre and how well it fits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedCentre {
    /// In the drawing, mm.
    pub centre: Point2<f64>,
    /// Greatest distance of a tip from the fitted circle, mm.
    pub residual: f64,
}

/// The centre of the circle through the middles of the tips, by least squares (Kåsa 1976: of `x² + y² + a x + b y + c`).
///
/// # Errors
/// As [`super::OutlineGear::new`].
pub fn fit_centre(segments: &[PathSegment]) -> Result<FittedCentre, OutlineError> {
    let mut fitted = FittedCentre {
        centre: centroid(segments),
        residual: 0.0,
    };
    for _ in 0..ROUNDS {
        let path = ClosedPath::new(segments, fitted.centre)?;
        let tips: Vec<Point2<f64>> = find(&path)?.iter().map(|tooth| tooth.tip).collect();
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for tip in &tips {
            let row = Vector3::new(tip.x, tip.y, 1.0);
            normal += row * row.transpose();
            right -= row * tip.coords.norm_squared();
        }
        let Some(solved) = normal.lu().solve(&right) else {
            return Ok(fitted);
        };
        let off = Point2::new(-0.5 * solved.x, -0.5 * solved.y);
        let radii = tips.iter().map(|tip| (tip - off).norm());
        let radius = (off.coords.norm_squared() - solved.z).sqrt();
        fitted = FittedCentre {
            centre: fitted.centre + off.coords,
            residual: radii
                .map(|found| (found - radius).abs())
                .fold(0.0, f64::max),
        };
    }
    Ok(fitted)
}

/// The centroid of the area that the segments' ends and middles enclose.
fn centroid(segments: &[PathSegment]) -> Point2<f64> {
    let points: Vec<Point2<f64>> = segments
        .iter()
        .flat_map(|segment| [segment.start(), segment.at(0.5)])
        .collect();
    // Of a path without area its first point: what follows says what is wrong with it.
    let first = points.first().copied().unwrap_or_default();
    polygon::centroid(&points).unwrap_or(first)
}
