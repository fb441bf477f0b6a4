//! A common point of two half teeth.

use super::placed::PlacedHalf;
use super::shape::C;
pub(super) use crate::contact::gap::slope;
use crate::contact::gap::{Origin, common_normal};
use crate::gear::ProfilePart;

/// A common point of a locked and a free half tooth.
#[derive(Debug, Clone, Copy)]
pub(super) struct CandidateContact {
    /// Gap, rad: the free gear's rotation, counted from the caller's `origin`.
    pub gap: f64,
    /// Bound on the error of a search, rad.
    pub slack: f64,
    /// `σ = ρ dθ/dρ` of the curve that determines how rounding shifts the gap.
    pub slope: f64,
    /// Profile part and parameter on the locked gear.
    pub locked: (ProfilePart, f64),
    /// Profile part and parameter on the free gear.
    pub free: (ProfilePart, f64),
    /// The locked gear's point.
    pub point: C,
    /// Unit normal there, out of the locked metal.
    pub normal: C,
}

impl CandidateContact {
    /// The candidate at one parameter each.
    pub fn new(
        (locked_half, locked): (&PlacedHalf, (ProfilePart, f64)),
        (free_half, free): (&PlacedHalf, (ProfilePart, f64)),
        origin: Origin,
        slack: f64,
    ) -> CandidateContact {
        let p = locked_half.at(locked.0, locked.1);
        let q = free_half.at(free.0, free.1);
        let turned = p.point * q.point.conj();
        let size = turned.norm_sqr().sqrt();
        let corners = [locked_half.is_corner(locked), free_half.is_corner(free)];
        let opposite = || -q.normal * turned / size;
        let (normal, slope) = common_normal(&p, &q, corners, opposite);
        CandidateContact {
            gap: origin.gap(turned),
            slack,
            slope,
            locked,
            free,
            point: p.point,
            normal,
        }
    }
}
