//! Lengths and counts that every format of drawings keeps to.

/// Ends of drawn lines nearer than this are one point, mm. Tuned: drawings print six decimals of an inch (0.03 µm) and round twice,
/// and no gear has a straight edge of 1 µm that matters.
pub const JOIN_MM: f64 = 0.001;
/// Gaps up to this are rounding of the same point, mm: a coordinate of `FARTHEST_MM` is known to 1.2e-10 mm.
pub(super) const SAME_MM: f64 = 1e-9;
/// Coordinates and radii beyond this are no gear's, mm: a kilometre.
pub(super) const FARTHEST_MM: f64 = 1e6;
/// Bound on the fit of curves without an exact form, mm: 0.01 µm, a tenth of the finest outline that makes sense to write. Tuned:
/// a tenth of it takes twice the curves.
pub(super) const FIT_MM: f64 = 1e-5;
/// Bytes of a drawing: a text file of a million segments.
pub(super) const MAX_BYTES: usize = 64 << 20;
/// Segments of a drawing: some thousand for each tooth of the largest gears.
pub(super) const MAX_SEGMENTS: usize = 1_000_000;
pub(super) const MAX_NAMED: usize = 10;
