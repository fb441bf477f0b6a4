//! The analytic models: published tables, closed forms, properties of random pairs.

mod analytic;
#[path = "../common/mod.rs"]
mod common;
mod deviating;
mod examples;
mod helical;
#[path = "../common/kit.rs"]
mod kit;
mod properties;
mod published;
mod rack_positions;

use common::random_pair::{ROUNDING, case, rough_case};
use gearlash::analytic::{
    InvolutePair, LineOfAction, SideContact, effective_center_distance, evaluate, limits,
};
use gearlash::contact::{ExactKernel, Method};
use gearlash::error::GearError;
use gearlash::gear::{
    AsBuilt, BasicRack, Face, Gear, GearDesign, Hand, Modification, Profile, ProfilePart, Relief,
    Side, involute, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use kit::{Make, at, ends, halved, inv, j_wt, near, pair, rows, spur, spur_of_angle};
use nalgebra::{Point2, Rotation2, Vector2};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_4, PI, TAU};
use std::path::Path;
