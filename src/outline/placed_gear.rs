//! A gear of a pair at its position, whichever way its outline is known.

use super::assembled_pair::AssembledPair;
use super::pair::OutlinePair;
use crate::gear::Placed;
use crate::pair::Member;
use nalgebra::Point2;

/// A gear at its position.
#[derive(Debug, Clone, Copy)]
pub enum PlacedGear<'a> {
    /// A gear by its data.
    Data(Placed<'a>),
    /// A gear of a drawn pair, at this rotation, rad.
    Drawn(&'a OutlinePair, Member, f64),
}

impl<'a> PlacedGear<'a> {
    /// A gear of `assembly` on its axis at `rotation`, rad, counted from tooth 1 pointing at the mate.
    pub fn new(assembly: &'a AssembledPair, member: Member, rotation: f64) -> PlacedGear<'a> {
        match assembly {
            AssembledPair::Data(pair) => PlacedGear::Data(Placed::new(
                pair.gear(member),
                pair.axis(member),
                pair.mate_direction(member) + rotation,
            )),
            AssembledPair::Drawn(pair) => PlacedGear::Drawn(pair, member, rotation),
        }
    }

    /// The gear by its data; `None` for a drawn pair.
    pub fn data(&self) -> Option<&Placed<'a>> {
        match self {
            PlacedGear::Data(placed) => Some(placed),
            PlacedGear::Drawn(..) => None,
        }
    }

    /// Its rotation axis, mm.
    pub fn axis(&self) -> Point2<f64> {
        match self {
            PlacedGear::Data(placed) => placed.axis(),
            PlacedGear::Drawn(pair, member, _) => pair.axis(*member),
        }
    }

    /// Its rotation, rad, up to a constant of the gear.
    pub fn rotation(&self) -> f64 {
        match self {
            PlacedGear::Data(placed) => placed.direction(1),
            PlacedGear::Drawn(_, _, rotation) => *rotation,
        }
    }

    /// Its geometric centre, mm.
    pub fn centre(&self) -> Point2<f64> {
        match self {
            PlacedGear::Data(placed) => placed.centre(),
            PlacedGear::Drawn(pair, member, rotation) => pair.centre(*member, *rotation),
        }
    }

    /// The outline within at least `reach` of `place`, mm, with chords within `chordal_error` mm.
    pub fn outline_near(
        &self,
        place: Point2<f64>,
        reach: f64,
        chordal_error: f64,
    ) -> Vec<Point2<f64>> {
        match self {
            PlacedGear::Data(placed) => placed.outline_near(place, reach, chordal_error),
            PlacedGear::Drawn(pair, member, rotation) => {
                pair.outline(*member, *rotation, chordal_error)
            }
        }
    }

    /// The teeth within `reach` of `place`, mm, each with its direction from the centre, rad.
    pub fn teeth_near(&self, place: Point2<f64>, reach: f64) -> Vec<(u32, f64)> {
        match self {
            PlacedGear::Data(placed) => {
                let teeth = placed.teeth_near(place, reach).into_iter();
                teeth
                    .map(|tooth| (tooth, placed.direction(tooth)))
                    .collect()
            }
            PlacedGear::Drawn(pair, member, rotation) => {
                pair.teeth_near(*member, *rotation, place, reach)
            }
        }
    }

    /// Tip and root radius, mm.
    pub fn radii(&self) -> [f64; 2] {
        match self {
            PlacedGear::Data(placed) => {
                let gear = placed.as_built().gear();
                [gear.tip_radius(), gear.root_radius()]
            }
            PlacedGear::Drawn(pair, member, _) => {
                let gear = pair.gear(*member);
                [gear.tip_radius(), gear.root_radius()]
            }
        }
    }

    /// Twist of its teeth, rad per mm of the face.
    pub fn twist(&self) -> f64 {
        let data = self.data();
        data.map_or(0.0, |placed| placed.as_built().gear().basic_data().twist())
    }

    /// Base radius, mm; `None` for a drawn pair.
    pub fn base_radius(&self) -> Option<f64> {
        Some(self.data()?.as_built().gear().base_radius())
    }
}
