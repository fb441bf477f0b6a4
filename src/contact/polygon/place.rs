//! The contact where two half teeth are closest: curves, radii, point and normal.

use super::chord::{Chord, Half};
use super::facing_pair::FacingPair;
use crate::contact::lost_motion::{Contact, Touch};
use crate::contact::parry::Closest;
use crate::gear::ProfilePart;
use crate::pair::Member;
use nalgebra::{Point2, Vector2};

/// A point this near the tip circle, mm, is the tip corner (the rule of the reference data). A point this near the root
/// circle is the root, below which the gear is solid all round.
const CORNER: f64 = 1e-7;

/// The touching curves and the place in the picture.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub locked: Touch,
    pub free: Touch,
    pub point: Point2<f64>,
    /// Points out of the metal of the locked gear.
    pub normal: Vector2<f64>,
    /// Greatest curvature of the gap along the curves, 1/mm: the lesser of the two; at an edge that of the other curve.
    pub curvature: f64,
    /// How many of the two curves are a fillet there, or end at one.
    pub hollow: u32,
}

/// One half tooth's side of a contact.
struct SideOfContact {
    touch: Touch,
    /// `None` at an edge.
    normal: Option<Vector2<f64>>,
    curvature: f64,
    hollow: bool,
}

impl Place {
    /// The contact at the opening `touching`, where `chords` are `closest`.
    pub fn new(
        problem: &FacingPair,
        touching: f64,
        chords: &[Chord; 2],
        closest: &Closest,
    ) -> Place {
        let free_frame = problem.at(touching);
        let points = closest.points;
        let locked = part(
            &problem.locked,
            problem.locked_tooth,
            &chords[0],
            &points[0],
        );
        let on_free = free_frame.inverse_transform_point(&points[1]);
        let free = part(&problem.free, problem.free_tooth, &chords[1], &on_free);
        let frame = &problem.locked_frame;
        let point = frame * nalgebra::center(&points[0], &points[1]);
        // At an edge the other curve gives the normal; between two edges it is their direction of approach.
        let normal: Vector2<f64> = match (locked.normal, free.normal) {
            (Some(normal), _) => frame * normal,
            (None, Some(normal)) => -(frame * (free_frame * normal)),
            (None, None) => {
                let axis = problem.assembly.axis(problem.assembly.free());
                let arm = (point - axis).normalize();
                problem.side.sense() * Vector2::new(arm.y, -arm.x)
            }
        };
        let curvature = match (locked.normal.is_some(), free.normal.is_some()) {
            (true, true) => locked.curvature.min(free.curvature),
            (true, false) => locked.curvature,
            (false, true) => free.curvature,
            (false, false) => locked.curvature.max(free.curvature),
        };
        Place {
            hollow: u32::from(locked.hollow) + u32::from(free.hollow),
            locked: locked.touch,
            free: free.touch,
            point,
            normal,
            curvature,
        }
    }

    /// The contact with teeth, curves, radii, point and normal, and with the side's `rotation` and `error`.
    pub fn contact(&self, locked: Member, rotation: f64, error: f64) -> Contact {
        let (wheel, pinion, normal) = match locked {
            Member::Wheel => (self.locked, self.free, self.normal),
            Member::Pinion => (self.free, self.locked, -self.normal),
        };
        Contact {
            rotation,
            error,
            wheel,
            pinion,
            point: self.point,
            normal,
            section: 0.0,
        }
    }
}

/// The contact's side on `half`, at the point `at` of its chord in its own frame.
fn part(half: &Half, tooth: u32, chord: &Chord, at: &Point2<f64>) -> SideOfContact {
    let profile = &half.profile;
    let gear = profile.gear();
    let (curve, parameter) = (chord.curve, chord.parameter_at(at));
    let radius = at.coords.norm();
    let normal = profile.normal(curve, parameter, half.side);
    let named = match curve {
        _ if radius >= gear.tip_radius() - CORNER => ProfilePart::Tip,
        ProfilePart::Fillet if radius < gear.root_radius() + CORNER => ProfilePart::Root,
        _ => curve,
    };
    let end = |curve, parameter: f64| {
        let (from, to) = profile.range(curve);
        from > to && parameter == to
    };
    SideOfContact {
        touch: Touch {
            tooth,
            curve: named.into(),
            radius,
        },
        normal: (!is_edge(half, curve, parameter, radius)).then_some(normal),
        // A fillet is hollow. Elsewhere an unknown curvature is small beside the arm.
        curvature: half.curvature(chord).unwrap_or(0.0),
        hollow: match curve {
            ProfilePart::Fillet | ProfilePart::Root => true,
            ProfilePart::Involute => end(ProfilePart::Involute, chord.parameters[1]),
            ProfilePart::Tip => false,
        },
    }
}

/// Whether a half tooth has an edge or ends at this place: a corner of its tip, or the middle of the space.
fn is_edge(half: &Half, curve: ProfilePart, parameter: f64, radius: f64) -> bool {
    let profile = &half.profile;
    let gear = profile.gear();
    let inside = CORNER / radius;
    // Chords end at the edges of a curve.
    let edges = profile.part(curve).curve.edges();
    if edges.contains(&parameter) {
        return true;
    }
    match curve {
        ProfilePart::Tip => {
            parameter >= profile.range(ProfilePart::Tip).1 - inside
                || parameter <= half.land_start() + inside
        }
        ProfilePart::Involute => radius >= gear.tip_radius() - CORNER,
        ProfilePart::Fillet => {
            half.root_end() <= profile.range(ProfilePart::Root).0
                && radius <= gear.root_radius() + CORNER
        }
        ProfilePart::Root => parameter >= half.root_end() - inside,
    }
}

#[cfg(test)]
mod tests {
    use super::super::chord::CutGear;
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign, Side};

    /// Edges lie within `CORNER` of the ends of the tip land, of the tip circle on the flank and of the middle of the
    /// space. A fillet without a root land also has one within `CORNER` of the root circle. Spaces are alternately
    /// wider and narrower; the narrower ones have no root land.
    #[test]
    fn edges_are_the_corners_of_the_tip_and_the_middle_of_the_space() {
        let wave: Vec<f64> = (0..20).map(|k| 0.6 * f64::from(k % 2)).collect();
        let deviations = Deviations::default().with_pitch(&wave, &wave);
        let gear = GearDesign::plain(20, 2.0).built(Face::Front, &deviations);
        let cut = CutGear::new(&gear, 1e-2);
        let (tip, root) = (gear.gear().tip_radius(), gear.gear().root_radius());
        let mut lands = [0; 2];
        for (side, tooth) in Side::BOTH
            .into_iter()
            .flat_map(|side| [(side, 1), (side, 2)])
        {
            let half = Half::new(gear.profile(side, tooth), &cut, side, tooth);
            let range = |part| half.profile.range(part);
            let has_root = half.root_end() > range(ProfilePart::Root).0;
            lands[usize::from(has_root)] += 1;
            let land_end = range(ProfilePart::Tip).1;
            for (off, is_near) in [(0.5 * CORNER, true), (2.0 * CORNER, false)] {
                for (part, at, radius, expected) in [
                    (ProfilePart::Tip, land_end - off / tip, tip, is_near),
                    (
                        ProfilePart::Tip,
                        half.land_start() + off / tip,
                        tip,
                        is_near,
                    ),
                    (ProfilePart::Involute, 0.5, tip - off, is_near),
                    (ProfilePart::Fillet, 0.5, root + off, is_near && !has_root),
                    (
                        ProfilePart::Root,
                        half.root_end() - off / root,
                        root,
                        is_near,
                    ),
                ] {
                    let case = format!("{side:?} {tooth} {part:?} {off}");
                    assert_eq!(is_edge(&half, part, at, radius), expected, "{case}");
                }
            }
        }
        assert_eq!(lands, [2, 2]);
    }
}
