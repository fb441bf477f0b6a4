//! Proofs by separating directions. They prove a pose that any method found from the outlines, without a search for the contact.

mod checker;
mod convex;
mod facing_halves;
mod facing_pair;
mod hollow;
mod proof;
mod prover;

pub use proof::{Piece, Proof, Reason, Separation, SideProof, TouchProof};
pub use prover::Prover;
