//! Lost motion on polygons: the free gear is turned in safe steps until it touches.
//!
//! Only the half teeth of one side decide the contact of that side, so the same path gives the negative value of an interfering pair. One
//! search (`search`) takes every pair of facing half teeth within reach, and turns in and cuts finer the tightest.

mod certificate;
mod chord;
mod examination;
mod facing_pair;
mod graphs;
mod kernel;
mod place;
mod search;

pub use certificate::Certifier;
pub use chord::CutPair;
pub use kernel::PolygonKernel;
