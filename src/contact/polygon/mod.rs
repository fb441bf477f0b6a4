//! Lost motion on polygons: the free gear is turned in safe steps until it touches.
//!
//! Each side is a matter of the half teeth of that side alone, so an interfering
//! pair gives its negative value by the same path as a clear one. Every pair of
//! facing half teeth within reach takes part in one search (`search`), which
//! turns in and cuts finer whatever is tightest.

mod certificate;
mod chord;
mod flank_problem;
mod graphs;
mod kernel;
mod look;
mod place;
mod search;

pub use certificate::Certifier;
pub use chord::CutGear;
pub use kernel::PolygonKernel;
