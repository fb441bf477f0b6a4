//! What is wrong with an outline.

use nalgebra::Point2;

/// A path that is no gear. Places are in the drawing's own frame, mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OutlineError {
    /// No segment, or one with a number that is not finite or a circle without radius.
    #[error("segment {index} of the outline is not a curve with finite numbers")]
    NotFinite {
        /// Counted from 0.
        index: usize,
    },
    /// Two ends that should meet do not.
    #[error(
        "the outline is open: from {} to {} nothing is drawn, {gap_mm:.6} mm",
        at(from),
        at(to)
    )]
    Open {
        /// Where a segment ends.
        from: Point2<f64>,
        /// Where the next one starts.
        to: Point2<f64>,
        /// Their distance.
        gap_mm: f64,
    },
    /// The path crosses itself.
    #[error("the outline crosses itself near {}", at(near))]
    SelfCrossing {
        /// Within a chord of the crossing.
        near: Point2<f64>,
    },
    /// The centre is not inside.
    #[error("the centre {} does not lie inside the outline", at(centre))]
    CentreOutside {
        /// The centre.
        centre: Point2<f64>,
    },
    /// Fewer than three teeth.
    #[error(
        "of teeth {found} are found between diameters {root_diameter_mm:.4} and {tip_diameter_mm:.4} mm; a gear has at least 3"
    )]
    TooFewTeeth {
        /// How many.
        found: usize,
        /// Twice the least radius.
        root_diameter_mm: f64,
        /// Twice the greatest radius.
        tip_diameter_mm: f64,
    },
    /// Another number of teeth than stated.
    #[error(
        "{found} teeth are found, {stated} are stated; the first one found points to {}",
        at(first)
    )]
    OtherTeeth {
        /// How many are there.
        found: usize,
        /// How many there should be.
        stated: u32,
        /// The tip of tooth 1.
        first: Point2<f64>,
    },
    /// Teeth at uneven distances: one is missing, or something else sticks out.
    #[error(
        "the teeth are not evenly spaced: the one at {} stands {pitches:.3} of a pitch from its even place",
        at(tip)
    )]
    Uneven {
        /// The tip of the tooth farthest off.
        tip: Point2<f64>,
        /// How far, in pitches, counter-clockwise positive.
        pitches: f64,
    },
    /// A runout that leaves the axis outside.
    #[error(
        "an eccentricity of {eccentricity_mm} mm is allowed up to half the tooth depth, {depth_mm:.4} mm"
    )]
    Eccentric {
        /// Given.
        eccentricity_mm: f64,
        /// Tip minus root radius.
        depth_mm: f64,
    },
    /// Two outlines that are not of one gear.
    #[error(
        "{} and {} teeth are found: two outlines of one gear have as many",
        teeth[0],
        teeth[1]
    )]
    OtherGear {
        /// Of each.
        teeth: [u32; 2],
    },
    /// A centre distance at which nothing can turn.
    #[error(
        "the centre distance {center_distance_mm} mm must be above {least_mm:.4} mm, at which a tip reaches the mate's axis"
    )]
    TooNear {
        /// Given.
        center_distance_mm: f64,
        /// Greater of the two reaches.
        least_mm: f64,
    },
}

fn at(point: &Point2<f64>) -> String {
    // Never −0.
    let [x, y] = [point.x, point.y].map(|mm| (mm * 1e4).round() / 1e4 + 0.0);
    format!("({x:.4}, {y:.4})")
}
