//! Two gears in contact: contact of their outlines, lost motion, sweeps of poses.

mod agreement;
mod body;
mod by_sections;
mod class;
mod cycle_search;
mod drawn_contact;
mod effort;
mod exact;
mod exaggeration;
mod face_place;
mod gap;
mod kernel;
mod lost_motion;
mod mesh_section;
mod outline;
mod outline_contact;
mod over_face;
mod overlap;
mod pair_at_distance;
mod parry;
mod plane_extremes;
mod polygon;
mod pose_result;
mod ranked;
mod scene;
mod sweep;

pub(crate) use effort::Effort;
pub(crate) use parry::PolylineShape;

pub use agreement::MethodAgreement;
pub use class::{ContactClass, ContactKind, Moment, PoseClass};
pub use drawn_contact::DrawnContact;
pub use exact::{
    Doubt, ExactKernel, Extreme, Extremes, PROVEN_WIDTH, PROVEN_WIDTH_DRAWN, cycle_extremes,
};
pub(crate) use exact::{End, is_proven, keeps_to_involutes};
pub use exaggeration::{Exaggeration, MeasuredOnGear};
pub use face_place::FacePlace;
pub use kernel::{Piece, Proof, Prover, Reason, Separation, SideProof, TouchProof};
pub use lost_motion::{Contact, LostMotion, Status, ToothPlace, Touch};
pub use mesh_section::MeshSection;
pub(crate) use outline::OutlineCycle;
pub use outline::{OutlineCertifier, OutlineKernel};
pub use outline_contact::{ContactNotConfirmed, SearchExhausted};
pub use overlap::Overlap;
pub use pair_at_distance::PairAtDistance;
pub(crate) use pair_at_distance::{BRACKET_WIDTH, reach, root_of_play};
pub(crate) use plane_extremes::cycle_extremes_within;
pub use polygon::{Certifier, CutPair, PolygonKernel};
pub use pose_result::{
    FirstLeast, PolygonDifference, PoseResult, Unproven, first_least, worst_pose,
};
pub use scene::{FreePlacement, LineOfAction, Scene};
pub use sweep::{
    BLOCK, METHODS_AGREE_WITHIN, Method, POLYGONS_EVERY, lost_motion_at, sweep, sweep_blocks,
};
