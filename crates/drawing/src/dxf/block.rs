//! Blocks of a DXF, and where an INSERT places them.
//!
//! An INSERT at `P` with the scales `S` and the rotation `φ` takes a point `p` of a block with the base point `b` to `P + R(φ) S (p − b)`. Seen from behind
//! (extrusion direction 0, 0, −1) x and z of that point are reversed.

use super::entity::Entity;
use crate::affine::Affine;
use crate::curve::Curve;
use nalgebra::{Matrix2, Point3, Rotation2, Vector2};
use std::rc::Rc;

#[derive(Debug, Default)]
pub struct Block<'a> {
    /// The point that an INSERT puts at its own.
    pub base: Point3<f64>,
    /// Its entities, in order.
    pub entities: Vec<Rc<Entity<'a>>>,
}

/// Where an entity is placed, in units of the drawing.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    /// Within the plane; `None`: as drawn.
    map: Option<Affine>,
    /// Its z is the first number plus the second times the own z of the entity.
    height: [f64; 2],
}

impl Default for Placement {
    fn default() -> Placement {
        Placement {
            map: None,
            height: [0.0, 1.0],
        }
    }
}

impl Placement {
    /// The places of a block with the base point `base`, one for each column and row of an INSERT.
    /// Errors: extrusion directions and scales that are not supported.
    pub fn copies(
        insert: &Entity,
        base: Point3<f64>,
    ) -> Result<impl Iterator<Item = Placement>, &'static str> {
        let hand = insert.hand()?;
        let scale = [41, 42, 43].map(|code| insert.number(code, 1.0));
        if scale[0] == 0.0 || scale[1] == 0.0 {
            return Err("an INSERT of scale 0");
        }
        let at = insert.point(10);
        let turn = Rotation2::new(insert.number(50, 0.0).to_radians());
        let seen = Matrix2::new(hand, 0.0, 0.0, 1.0);
        let map = seen * turn.matrix() * Matrix2::from_diagonal(&Vector2::new(scale[0], scale[1]));
        let shift = seen * at.xy().coords - map * base.xy().coords;
        let height = [hand * (at.z - scale[2] * base.z), hand * scale[2]];
        let [columns, rows] = [70, 71].map(|code| insert.number(code, 1.0).max(1.0) as u32);
        let step = [44, 45].map(|code| insert.number(code, 0.0));
        let copies = (0..columns).flat_map(move |column| (0..rows).map(move |row| (column, row)));
        Ok(copies.map(move |(column, row)| {
            let moved = Vector2::new(step[0] * f64::from(column), step[1] * f64::from(row));
            Placement {
                map: Some(Affine::new(map, shift + seen * (turn * moved))),
                height,
            }
        }))
    }

    /// The place of an entity that is placed at `inner` in this one.
    pub fn after(&self, inner: &Placement) -> Placement {
        let map = match (&self.map, &inner.map) {
            (Some(outer), Some(inner)) => Some(outer.after(inner)),
            (one, other) => one.or(*other),
        };
        let [shift, scale] = self.height;
        Placement {
            map,
            height: [shift + scale * inner.height[0], scale * inner.height[1]],
        }
    }

    /// The z of a point whose own is `z`.
    pub fn height(&self, z: f64) -> f64 {
        self.height[0] + self.height[1] * z
    }

    /// `curve`, drawn in units of `scale` mm, in its place.
    pub fn curve(&self, curve: Curve, scale: f64) -> Curve {
        let Some(map) = &self.map else {
            return curve;
        };
        let map = map.in_units(scale);
        let mut placed = Curve::default();
        for segment in &curve.segments {
            placed.add(map.segment(segment));
        }
        placed.bound += curve.bound * map.stretch();
        placed
    }
}
