//! Contacts of pairs that bind anywhere on the face and need no search: each side by itself, from few sections.
//!
//! Every contact of such a pair is on the line of action or at a corner ([`super::super::search_free_proof`]). So [`super::leads`] knows the
//! places of all that can be tightest. Where the gears interfere, one section alone can jam. [`Helical::over`] finds these poses.

use super::{Edges, Helical};
use crate::contact::Effort;
use crate::contact::body::FarFlanks;
use crate::contact::exact::direct::DirectSolver;
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::path::InvolutePair;
use crate::contact::exact::section::Section;
use crate::contact::exact::section_side::{SectionPlace, SectionSide};
use crate::contact::exact::separation::InvoluteArc;
use crate::contact::exact::shape::HalfToothShape;
use crate::contact::exact::tightest::FirstContact;
use crate::contact::lost_motion::{Contact, LostMotion};
use crate::contact::over_face::{FoundOverFace, OverFace};
use crate::gear::{ProfilePart, Side};
use crate::pair::{GearPair, Mating, Pose};

/// Number of poses of a pitch in which teeth on the line of action are sought. With a contact ratio above 1 most poses have them.
const POSES: u32 = 8;

/// The data of a pair whose sections need no search.
#[derive(Debug, Clone)]
pub(super) struct SearchFreeSections {
    /// The solver of all sections.
    solver: DirectSolver,
    /// Both sides of the measuring plane, with all teeth that can reach the mate in any section.
    sides: [FlankProblem; 2],
    /// For spur gears with one lead each: where each side is tightest while teeth are on the line of action, mm, and that side there.
    one_place: [Option<(f64, FlankProblem)>; 2],
    /// For spur gears with one lead each: bounds, for either side, on the turn of a locked flank over the face and on the change of a gap by
    /// both leads, rad.
    turns: [[f64; 2]; 2],
}

impl SearchFreeSections {
    /// `None` if a section of `assembly`, whose measuring plane is `plane`, may need a search.
    pub fn new(
        assembly: &GearPair,
        plane: &Section,
        edges: Option<&Edges>,
    ) -> Option<SearchFreeSections> {
        let is_plain = assembly.binds_anywhere()
            && !assembly.is_modified()
            && plane.bodies.is_none()
            && !plane.never_assembles
            && plane.far_flanks == FarFlanks::Clear
            && edges.is_none_or(|edges| !edges.jams && !edges.short);
        let solver = plane.solver.as_ref().filter(|_| is_plain)?;
        let (solver, sides) = if assembly.leans() {
            let envelopes = solver.envelopes.clone();
            (
                DirectSolver::over_leans(&plane.right, assembly, envelopes)?,
                [&plane.right, &plane.left].map(|side| side.over_leans(assembly)),
            )
        } else {
            (solver.clone(), [plane.right.clone(), plane.left.clone()])
        };
        let one_place = [None, None];
        let turns = sides.each_ref().map(|problem| {
            let members = [assembly.locked(), assembly.free()];
            let [locked, free] = members.map(|member| {
                let curve = assembly.gear(member).lead_curve(problem.side, 1);
                curve.map_or(0.0, |curve| curve.range())
            });
            [
                locked * problem.per_locked_base,
                (locked + free) * problem.per_free_base,
            ]
        });
        solver.proof.is_direct().then_some(SearchFreeSections {
            solver,
            sides,
            one_place,
            turns,
        })
    }

    /// Whether no pair of `at` is tighter anywhere on the face of spur gears with one lead each than `found` in this section, where the leads
    /// take most.
    ///
    /// There endless involutes are tightest. Teeth are no tighter than these, less the room of the ends that they have passed. The lead of the
    /// locked gear turns it against the line of action; that of the free gear moves the gap alone.
    fn is_tightest(&self, at: &PosedFlanks, found: &FirstContact) -> bool {
        let (problem, variation) = (at.problem, &self.solver.variation);
        let (locked, free) = (found.candidate.locked, found.candidate.free);
        // Corners are named by the roll of the end that they are.
        let is_within = |(curve, roll): (ProfilePart, f64), shape: &HalfToothShape| {
            curve == ProfilePart::Involute && roll > shape.form_roll && roll < shape.tip_roll
        };
        if !is_within(locked, &problem.locked.shape) || !is_within(free, &problem.free.shape) {
            return false;
        }
        let own = InvolutePair::new(at, found.step);
        let ratio = problem.locked.shape.base * problem.per_free_base;
        let [turned, change] = self.turns[problem.side.index()];
        let arcs = InvoluteArc::both(problem);
        // A Newton step falls short by the slope of G.
        let shrink = 1.0 - self.solver.free_off * problem.per_free_base;
        at.steps().filter(|step| *step != found.step).all(|step| {
            let pair = InvolutePair::new(at, step);
            let behind = ratio * (pair.locked_base - own.locked_base);
            let tighter = (own.free_base - pair.free_base - behind) / shrink;
            let rolls = [
                locked.1 + own.locked_base - pair.locked_base,
                free.1 + behind,
            ];
            let plays = variation.plays_at(problem, tighter.abs() + change);
            let plays = [plays.0 + turned, plays.1 + ratio * turned];
            let is_above_form = (0..2).all(|k| rolls[k] - plays[k] >= arcs[k].form);
            if is_above_form && tighter <= problem.tie {
                return true;
            }
            let room = InvoluteArc::room_of_both(&arcs, rolls, plays);
            room >= 0.0 && tighter - room / problem.most_turning() <= problem.tie
        })
    }

    /// This solver of `helical` with [`SearchFreeSections::one_place`].
    pub fn with_one_place(self, helical: &Helical) -> SearchFreeSections {
        let assembly = &helical.assembly;
        let is_spur = !assembly.is_helical() && !assembly.leans();
        if !assembly.has_one_lead() || !is_spur || helical.bounds.in_fillets {
            return self;
        }
        let one_place = self.sides.each_ref().map(|problem| {
            let effort = Effort::of_pose();
            let mut poses = (0..POSES).map(|k| {
                let pitches = f64::from(k) / f64::from(POSES);
                Pose::new(assembly, Mating::FIRST.onward(assembly, pitches))
            });
            let places = poses.find_map(|pose| {
                let (posed, nominal) = helical.posed(problem, &pose);
                let found = helical.plane.first_contact(&posed, &self.solver, &effort)?;
                self.is_tightest(&posed, &found).then_some(())?;
                let along = helical.along_face(&posed, nominal, &effort);
                let (steps, floor) = (along.steps(f64::NEG_INFINITY), f64::NEG_INFINITY);
                Some(helical.places_of_leads(&along, &steps, &posed, nominal, floor))
            });
            let [b] = places?.0[..] else {
                return None;
            };
            let plane = helical.plane.side(problem.side);
            Some((b, plane.turned(&assembly.section(b))))
        });
        SearchFreeSections { one_place, ..self }
    }

    /// Both contacts of `pose` of `helical`; `None` where [`Helical::over`] has to find them.
    pub fn lost_motion(
        &self,
        helical: &Helical,
        pose: &Pose,
        effort: &Effort,
    ) -> Option<FoundOverFace> {
        let mut over = OverFace::default();
        for problem in &self.sides {
            self.add_side(helical, problem, pose, effort, &mut over)?;
        }
        let found = over.found(pose.free_rotation(), helical.plane.free_pitch());
        let (angle, bound) = found.lost_motion.angle().zip(found.lost_motion.error())?;
        (angle > bound).then_some(found)
    }

    /// The section at `b`, mm, at its pose `here`, with only the teeth in reach; `pose` is that of the measuring plane. `None` if sections are
    /// searched.
    pub fn section_in_reach(
        &self,
        helical: &Helical,
        pose: &Pose,
        here: &Pose,
        b: f64,
    ) -> Option<Section> {
        let place = SectionPlace {
            assembly: &helical.assembly,
            whole: pose,
            here,
            b,
            near: None,
        };
        let side = |problem| SectionSide::new(&helical.plane, problem, place, None);
        let [right, left] = self.sides.each_ref().map(side);
        let sides = [right?.into_problem(), left?.into_problem()];
        let section = helical.plane.with_sides(sides);
        Some(section.with_solver(self.solver.clone()))
    }

    /// Adds the contact of one side.
    fn add_side(
        &self,
        helical: &Helical,
        problem: &FlankProblem,
        pose: &Pose,
        effort: &Effort,
        over: &mut OverFace,
    ) -> Option<()> {
        let (assembly, side) = (&helical.assembly, problem.side);
        let mut take = |b: f64, here: &Pose, contact: Contact| {
            let on = |own: Side| {
                (own == side).then_some(Contact {
                    error: contact.error + helical.omitted_error,
                    ..contact
                })
            };
            let found = LostMotion {
                right: on(Side::Right),
                left: on(Side::Left),
                solid: false,
            };
            over.add(b, here, found);
            over.beyond(side)
        };
        if let Some((b, there)) = &self.one_place[side.index()] {
            let here = pose.in_section(assembly, *b);
            let at = helical.plane.posed(there, &here);
            let found = helical.plane.first_contact(&at, &self.solver, effort)?;
            if self.is_tightest(&at, &found) {
                return take(*b, &here, helical.plane.contact(&at, &found)).map(|_| ());
            }
        }
        let (posed, nominal) = helical.posed(problem, pose);
        let along = helical.along_face(&posed, nominal, effort);
        let gap_at = |beyond: f64| nominal - side.sense() * beyond;
        // The radius of a far corner is less than one and a half base radii.
        let moved = 2.0 * helical.bounds.most_moved + assembly.shift_bound();
        let mut section = |b: f64, near: Option<&[usize]>| {
            let here = pose.in_section(assembly, b);
            let place = SectionPlace {
                assembly,
                whole: pose,
                here: &here,
                b,
                near,
            };
            let at = SectionSide::new(&helical.plane, problem, place, Some((&self.solver, moved)))?;
            let at = at.posed();
            let found = helical.plane.first_contact(&at, &self.solver, effort)?;
            take(b, &here, helical.plane.contact(&at, &found))
        };
        // Fillets are searched only for what exceeds a known contact.
        let floor = if helical.bounds.in_fillets {
            let [from, to] = assembly.face();
            gap_at(section(0f64.clamp(from, to), None)?)
        } else {
            f64::NEG_INFINITY
        };
        let steps = along.steps(floor);
        let (places, tightest) = helical.places_of_leads(&along, &steps, &posed, nominal, floor);
        let near = assembly.leans().then(|| along.near(&steps, tightest));
        let near = near.flatten();
        for b in places {
            section(b, near.as_deref())?;
        }
        // Without a place that is tight, or with another contact than those of `places`, sections are searched.
        let gap = gap_at(over.beyond(side)?);
        ((gap - tightest).abs() <= problem.tie + helical.omitted_error).then_some(())
    }
}
