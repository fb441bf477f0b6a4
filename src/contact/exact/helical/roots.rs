//! Where along the face the tip of a tooth may come to its mate's root.
//!
//! Tips are deepest on the line of centres. The root of an eccentric free gear comes to a tip land as it turns: where both circles touch
//! it stands alike over all of the face where both lands are on the line of centres, from an end of one to an end of one. Beyond, an end of the tip
//! land touches, the farther from that line the later, until the root land ends.
//!
//! All teeth that pass the line of centres along the face have such places, a dozen each, and next to none of them is the tightest. So the pair of
//! teeth that a place belongs to is asked first whether anything but its involutes is tighter there than what is known, whether a root land is
//! near enough to jam, or whether its tip stands in the body of the mate: the centres of sections do not wind, so that both teeth are those of the measuring plane, wound.

use super::edges::tip_ends;
use super::turning::{Edge, FreeGear, Place, Turning, crossing_places};
use crate::contact::Effort;
use crate::contact::exact::branch::search;
use crate::contact::exact::curves::Curves;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::lands::{land_on_land, without_lands};
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::{C, turn};
use crate::contact::gap::MOST_NODES;
use crate::gear::ProfilePart;
use crate::pair::GearPair;

/// A pair of teeth of which one's tip may come to the other's root, and where.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact::exact) struct AtRoot {
    step: i64,
    /// Mm along the face.
    pub b: f64,
}

/// What is known of a pose, in which a pair of teeth has to come to more to be looked at.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact::exact) struct Floors {
    /// The gap, rad, above which it touches first.
    pub tighter: f64,
    /// The gap, rad, above which it may jam in its section, if a root land touches.
    pub jams: f64,
    /// The distance from the free axis, mm, within which a tip stands in the body of the free gear.
    pub solid: f64,
}

/// The teeth of a pose along the face, the free gear at the rotation that is known.
pub(in crate::contact::exact) struct Roots<'a> {
    posed: &'a PosedFlanks<'a>,
    assembly: &'a GearPair,
    stands: FreeGear,
    turnings: [Turning<'a>; 2],
}

impl<'a> Roots<'a> {
    /// With the free gear as it stands in the frame of `posed`.
    pub fn new(assembly: &'a GearPair, posed: &'a PosedFlanks<'a>, stands: FreeGear) -> Roots<'a> {
        let turnings = [
            Turning::locked(assembly, posed),
            Turning::free(assembly, posed, stands.rotation),
        ];
        Roots {
            posed,
            assembly,
            stands,
            turnings,
        }
    }

    /// Where both lands end together, mm along the face, if the free gear may come there, and where the tip or the root of a pair of teeth is on
    /// the line of centres.
    pub fn places(&self, effort: &Effort) -> (Vec<Place>, Vec<AtRoot>) {
        let (mut crossings, mut at_roots) = (Vec::new(), Vec::new());
        let (posed, stands) = (self.posed, self.stands);
        let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
        let ends = tip_ends(posed);
        let middles = [locked, free].map(|shape| Edge::corner(C::from(shape.tip_radius)));
        let roots = [
            Edge::root_end(locked, |step| posed.locked(step)),
            Edge::root_end(free, |step| posed.free(step)),
        ];
        for (which, tips) in ends.iter().enumerate() {
            let root = &roots[1 - which];
            for tip in tips {
                let edges = if which == 0 { [tip, root] } else { [root, tip] };
                let places = (&mut crossings, effort);
                crossing_places(posed, &self.turnings, edges, stands, places);
            }
            let touching = tangent_rotations(posed, middles[which].radius + root.radius);
            let rotations = std::iter::once(stands.rotation).chain(touching.into_iter().flatten());
            for rotation in rotations {
                let between = posed.free_centre_at(rotation) - posed.centre;
                let turnings = [
                    Turning::locked(self.assembly, posed),
                    Turning::free(self.assembly, posed, rotation),
                ];
                let towards = [between.arg(), (-between).arg()];
                let tooth = (&turnings[which], towards[which]);
                add(tooth, &middles[which], &ON_IT, &mut at_roots);
                for end in tips {
                    add(tooth, end, &BESIDE_IT, &mut at_roots);
                }
                let space = (&turnings[1 - which], towards[1 - which]);
                add(space, root, &BESIDE_IT, &mut at_roots);
            }
        }
        // The free gear is solid about its axis at every rotation, which is where its outline's centre is not.
        if posed.problem.free_off != C::ZERO {
            let tooth = (&self.turnings[0], (-posed.centre).arg());
            add(tooth, &middles[0], &ON_IT, &mut at_roots);
            for end in &ends[0] {
                add(tooth, end, &BESIDE_IT, &mut at_roots);
            }
        }
        (crossings, at_roots)
    }

    /// Whether the pair of teeth there may change what is known: tighten it, or jam.
    pub fn may_hold(&self, at: AtRoot, floors: Floors, effort: &Effort) -> bool {
        let wound = |placed: Placed<'a>, turning: &Turning| Placed {
            direction: placed.direction * turn(turning.twist * at.b),
            ..placed
        };
        let locked = wound(self.posed.locked(at.step), &self.turnings[0]);
        let free = wound(self.posed.free(at.step), &self.turnings[1]);
        effort.spend(1);
        if locked.least_land_radius() < floors.solid {
            return true;
        }
        // Both involutes are tightest in sections that are looked at anyway.
        let all = Curves::ALL.without(ProfilePart::Involute, ProfilePart::Involute);
        let roots = Curves::of(ProfilePart::Root);
        [(roots, floors.jams), (all.but(roots), floors.tighter)]
            .into_iter()
            .any(|(curves, floor)| self.is_tighter(&locked, &free, curves, floor, effort))
    }

    /// Whether a gap of `curves` may exceed `floor`, rad.
    fn is_tighter(
        &self,
        locked: &Placed<'a>,
        free: &Placed<'a>,
        curves: Curves,
        floor: f64,
        effort: &Effort,
    ) -> bool {
        let origin = self.posed.origin;
        let on_lands = land_on_land(locked, free, origin, curves);
        if on_lands.is_some_and(|candidate| candidate.gap > floor) {
            return true;
        }
        let most = effort.left().min(MOST_NODES as u64) as usize;
        let mut left = most;
        let curves = without_lands(curves);
        let found = search(locked, free, origin, floor, curves, &mut left);
        effort.spend((most - left) as u64);
        // What is not settled is looked at.
        found.map_or(true, |found| found.is_some())
    }
}

/// Where a place is looked at: there, or, where a land ends, on either side.
const ON_IT: [f64; 1] = [0.0];
const BESIDE_IT: [f64; 2] = [-1.0, 1.0];

/// Adds the places on the face at which `edge` of a tooth has a direction, rad.
fn add(
    (turning, direction): (&Turning, f64),
    edge: &Edge,
    sides: &[f64],
    at_roots: &mut Vec<AtRoot>,
) {
    for (step, b) in turning.standing(edge, direction) {
        let near = sides.iter().map(|side| b + side * turning.beside());
        let near = near.filter(|&b| turning.is_on_face(b));
        at_roots.extend(near.map(|b| AtRoot { step, b }));
    }
}

/// Rotations of the free gear at which circles about both outlines' centres touch, `sum` the sum of their radii: see
/// [`super::super::lands`].
pub(super) fn tangent_rotations(posed: &PosedFlanks, sum: f64) -> Option<[f64; 2]> {
    let (locked, free) = (posed.centre, posed.problem.free_off);
    let (far, off) = (locked.norm(), free.norm());
    let cos = ((far - sum) * (far + sum) + off * off) / (2.0 * far * off);
    let beside = (cos.abs() <= 1.0).then(|| cos.acos())?;
    let towards = (locked * free.conj()).arg();
    Some([towards + beside, towards - beside])
}
