//! Proofs by separating directions: a pose that any method found is proven from the outlines, without a search of its own for the contact.

mod at;
mod checker;
mod convex;
mod hollow;
mod proof;
mod prover;

pub use proof::{Piece, Proof, Reason, Separation, SideProof, TouchProof};
pub use prover::Prover;
