//! The analytic models: published tables, closed forms, properties of random pairs.

mod analytic;
#[path = "../common/mod.rs"]
mod common;
mod deviating;
mod examples;
mod helical;
#[path = "../check/kit.rs"]
mod kit;
mod properties;
mod published;
mod rack_positions;

use common::random_pair::{ROUNDING, case, rough_case};
use gearlash::analytic::{
    InvolutePair, LineOfAction, SideContact, effective_center_distance, evaluate, limits,
};
use gearlash::contact::{ExactKernel, LostMotion, Method};
use gearlash::error::GearError;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Hand, Modification, Profile,
    ProfilePart, Relief, Side, involute, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use kit::{Make, ends, inv, near, on, pair, spur};
use nalgebra::{Point2, Rotation2, Vector2};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_4, PI, TAU};
use std::path::Path;
