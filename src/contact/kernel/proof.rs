//! The proof of a pose: on each side, directions that keep all teeth apart, and a point in the metal of both touching teeth.
//!
//! The directions hold at a slightly more open rotation of the free gear, the point at a slightly more closed one. [`Proof::verify`] checks
//! both from the outlines alone.

use crate::gear::Side;
use nalgebra::{Point2, Vector2};

/// The proof of both contacts of a pose. In helical gears it covers each section in which they were proven.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Proof {
    /// Right and left side, section by section.
    pub sides: Vec<SideProof>,
}

/// The proof of one side of one transverse section.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SideProof {
    /// The flanks.
    pub side: Side,
    /// Place along the axes, mm from the measuring plane; 0 for spur gears.
    #[cfg_attr(feature = "serde", serde(rename = "section_mm"))]
    pub section: f64,
    /// Rotation of the free gear in that section, rad, at which all pairs are apart; `None` if nothing touches at any rotation.
    #[cfg_attr(feature = "serde", serde(rename = "open_rad"))]
    pub open: Option<f64>,
    /// Rotation, rad, up to which they stay apart: the middle between both contacts. `None`: as far as the free gear can turn.
    #[cfg_attr(feature = "serde", serde(rename = "until_rad"))]
    pub until: Option<f64>,
    /// The point in both metals; `None` without contact, and in sections in which another one touches first.
    pub touch: Option<TouchProof>,
    /// The separation of each pair of pieces in reach.
    pub apart: Vec<Separation>,
}

/// A point in the metal of two teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TouchProof {
    /// Rotation of the free gear, rad, at which both teeth have the point.
    #[cfg_attr(feature = "serde", serde(rename = "closed_rad"))]
    pub closed: f64,
    /// Tooth of the locked gear.
    pub locked_tooth: u32,
    /// Tooth of the free gear.
    pub free_tooth: u32,
    /// The point in the picture, mm.
    #[cfg_attr(feature = "serde", serde(rename = "point_mm"))]
    pub point: Point2<f64>,
}

/// Two pieces of two half teeth, and their separation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Separation {
    /// Tooth of the locked gear.
    pub locked_tooth: u32,
    /// Tooth of the free gear.
    pub free_tooth: u32,
    /// Piece of the locked half tooth.
    pub locked: Piece,
    /// Piece of the free half tooth.
    pub free: Piece,
    /// The reason why they are apart.
    pub by: Reason,
    /// Unit vector out of the locked metal, in the picture: the direction of the reason, or the middle one of the tangents' normals.
    pub normal: Vector2<f64>,
}

/// A piece of a half tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Piece {
    /// Form point, involute, tip corner and tip land, up to the far corner.
    Top,
    /// The tops of both half teeth of the locked tooth.
    Tooth,
    /// The fillet between two of its parameters, rad.
    Fillet([f64; 2]),
    /// The fillet of the locked tooth's other half.
    FarFillet([f64; 2]),
    /// The root land.
    Root,
}

/// Why two pieces are apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Reason {
    /// A line across the normal separates them, and the free piece moves away from it as it turns further.
    Direction,
    /// A line across the normal separates the locked piece from the disc in which the free gear's teeth turn.
    OutOfReach,
    /// The locked fillet's tangent at each of its points separates it from the mate.
    LockedTangents,
    /// The free fillet's tangent at each of its points separates it from the mate.
    FreeTangents,
}
