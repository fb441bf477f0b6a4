//! The line of action of a pair in contact: the common tangent of the displaced base circles, and the limits of the path of contact.

use crate::contact::Contact;
use crate::gear::{Placed, Side};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{UnitComplex, Vector2};

/// Limit of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PathLimit {
    /// The tip circle of this gear.
    Tip(Member),
    /// The form circle of this gear, below which its flank is no involute.
    Form(Member),
}

/// The common tangent of the displaced base circles.
pub(super) struct Tangent {
    /// Base radii of wheel and pinion, mm.
    pub base: [f64; 2],
    /// Its length, mm.
    length: f64,
    /// From the origin to the pitch point on it, mm.
    pitch_point: Vector2<f64>,
    /// From the wheel's end to the pinion's.
    direction: Vector2<f64>,
}

impl Tangent {
    /// The tangent of `side` with the free gear at `rotation`; `None` where the base circles overlap.
    pub fn new(assembly: &GearPair, pose: &Pose, side: Side, rotation: f64) -> Option<Tangent> {
        let centre = |member: Member| {
            let turned = if member == assembly.locked() {
                pose.locked_rotation()
            } else {
                rotation
            };
            let tooth_1 = assembly.mate_direction(member) + turned;
            Placed::new(assembly.gear(member), assembly.axis(member), tooth_1).centre()
        };
        let [wheel, pinion] = Member::BOTH.map(centre);
        let base = Member::BOTH.map(|m| assembly.gear(m).gear().base_radius());
        let between = pinion - wheel;
        let (distance, sum) = (between.norm(), base[0] + base[1]);
        if distance <= sum {
            return None;
        }
        // As in `Scene::line_of_action`.
        let radial =
            UnitComplex::new(-side.sense() * (sum / distance).acos()) * (between / distance);
        let ends = [wheel + base[0] * radial, pinion - base[1] * radial];
        let along = ends[1] - ends[0];
        let length = ((distance - sum) * (distance + sum)).sqrt();
        Some(Tangent {
            base,
            length,
            pitch_point: ends[0].coords + along * (base[0] / sum),
            direction: along / length,
        })
    }

    /// The wheel's part of a length from one end to the other.
    fn share(&self) -> f64 {
        self.base[0] / (self.base[0] + self.base[1])
    }

    /// Place of a contact with these rolls of wheel and pinion, mm from the pitch point.
    pub fn place(&self, rolls: [f64; 2]) -> f64 {
        let arms = [self.base[0] * rolls[0], self.base[1] * rolls[1]];
        arms[0] - (arms[0] + arms[1]) * self.share()
    }

    /// The foot of the perpendicular from a contact.
    pub fn foot(&self, contact: &Contact) -> f64 {
        (contact.point.coords - self.pitch_point).dot(&self.direction)
    }

    /// Both ends of the path of contact, mm from the pitch point, and their limits.
    pub fn path(&self, assembly: &GearPair) -> ([f64; 2], [PathLimit; 2]) {
        let arms = |member: Member, base: f64| {
            let gear = assembly.gear(member).gear();
            [gear.form_roll(), gear.tip_roll()].map(|roll| base * roll)
        };
        let [form_1, tip_1] = arms(Member::Wheel, self.base[0]);
        let [form_2, tip_2] = arms(Member::Pinion, self.base[1]).map(|arm| self.length - arm);
        let (low, begins) = if tip_2 >= form_1 {
            (tip_2, PathLimit::Tip(Member::Pinion))
        } else {
            (form_1, PathLimit::Form(Member::Wheel))
        };
        let (high, ends) = if tip_1 <= form_2 {
            (tip_1, PathLimit::Tip(Member::Wheel))
        } else {
            (form_2, PathLimit::Form(Member::Pinion))
        };
        let origin = self.length * self.share();
        ([low - origin, high - origin], [begins, ends])
    }
}
