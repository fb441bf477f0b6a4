//! The exact method against everything outside it: reference poses, closed forms, a brute-force search, and hard cases.

#[path = "../common/along_face.rs"]
mod along_face;
#[path = "../common/campaign/mod.rs"]
mod campaign;
#[path = "../common/clearance/mod.rs"]
mod clearance;
#[path = "../common/cycle.rs"]
mod cycle;
mod drawn;
mod extremes;
mod field;
#[cfg(feature = "offset")]
mod flank_offset;
mod hard_cases;
mod helical;
mod helical_extremes;
mod helical_pairs;
#[path = "../common/kit.rs"]
mod kit;
mod leads;
mod methods;
mod outline_extremes;
mod outlines;
#[path = "../common/paths.rs"]
mod paths;
mod perfect;
#[path = "../common/posed.rs"]
mod posed;
mod profiles;
mod proofs;
mod random;
#[path = "../common/random_pair.rs"]
#[allow(dead_code)] // its twin tests use the rest
mod random_pair;
mod witnesses;
mod witnesses_extremes;

use campaign::{Depth, Drawn, Pair, Teeth, complaints, differ, with_contact, without_turns};
use gearlash::analysis::extremes::extremes;
use gearlash::analysis::study::Study;
use gearlash::analytic::{InvolutePair, LineOfAction};
use gearlash::contact::{
    Certifier, Contact, CutPair, ExactKernel, LostMotion, Method, OutlineKernel, Status, sweep,
};
use gearlash::error::go_on;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Flank, Gear, GearDesign, Hand,
    Modification, Pitch, ProfilePart, Side, Trace, involute,
};
use gearlash::outline::{OutlineError, OutlineGear, OutlinePair, OutlineReading, PathSegment};
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use kit::{Make, at, at_flank, halved, near, pair, rows, spur, spur_of_angle, um};
use nalgebra::{Point2, Vector2};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
