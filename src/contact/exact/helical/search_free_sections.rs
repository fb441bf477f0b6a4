//! Contacts of pairs that bind anywhere on the face and need no search: each side by itself, from few sections.
//!
//! Every contact of such a pair is on the line of action or at a corner ([`super::super::search_free_proof`]). So [`super::leads`] knows the
//! places of all that can be tightest. Where the gears interfere, one section alone can jam. [`Helical::over`] finds these poses.

use super::{Edges, Helical, reduced};
use crate::contact::Effort;
use crate::contact::body::FarFlanks;
use crate::contact::exact::direct::DirectSolver;
use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::section::Section;
use crate::contact::exact::section_side::{SectionPlace, SectionSide};
use crate::contact::lost_motion::{Contact, LostMotion};
use crate::contact::over_face::{FoundOverFace, OverFace};
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Member, Pose};

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
        solver.proof.is_direct().then_some(SearchFreeSections {
            solver,
            sides,
            one_place,
        })
    }
}

impl Helical {
    /// This pair with [`SearchFreeSections::one_place`].
    pub(super) fn with_one_place(mut self) -> Helical {
        let assembly = &self.assembly;
        let has_one_lead = Member::BOTH
            .iter()
            .all(|member| assembly.gear(*member).has_one_lead());
        let is_asked = has_one_lead && !assembly.is_helical() && !assembly.leans();
        let Some(search_free) = self.search_free.as_ref().filter(|_| is_asked) else {
            return self;
        };
        let found = search_free.sides.each_ref().map(|problem| {
            let effort = Effort::of_pose();
            let mut poses = (0..POSES).map(|k| {
                let pitches = f64::from(k) / f64::from(POSES);
                Pose::new(assembly, Mating::FIRST.onward(assembly, pitches))
            });
            let places = poses.find_map(|pose| {
                let (posed, nominal) = self.posed(problem, &pose);
                let along = self.along_face(&posed, nominal, &effort);
                along.tightest_on_line()?;
                Some(self.places_of_leads(&along, &posed, nominal, f64::NEG_INFINITY))
            });
            let [b] = places?.0[..] else {
                return None;
            };
            let plane = self.plane.side(problem.side);
            Some((b, plane.turned(&assembly.section(b))))
        });
        if let Some(search_free) = &mut self.search_free {
            search_free.one_place = found;
        }
        self
    }

    /// The teeth of a side of the measuring plane, and the gap at the nominal rotation.
    pub(super) fn posed<'a>(
        &self,
        problem: &'a FlankProblem,
        pose: &Pose,
    ) -> (PosedFlanks<'a>, f64) {
        let posed = self.plane.posed(problem, pose);
        let nominal = reduced(-problem.side.sense() * pose.free_rotation());
        (posed, reduced(nominal - posed.rotation(0.0)))
    }

    /// Both contacts of `pose`; `None` where [`Helical::over`] has to find them.
    pub fn lost_motion_without_search(
        &self,
        pose: &Pose,
        effort: &Effort,
    ) -> Option<FoundOverFace> {
        let search_free = self.search_free.as_ref()?;
        let mut over = OverFace::default();
        for problem in &search_free.sides {
            self.add_side_without_search(search_free, problem, pose, effort, &mut over)?;
        }
        let found = over.found(pose.free_rotation(), self.plane.free_pitch());
        let (angle, bound) = found.lost_motion.angle().zip(found.lost_motion.error())?;
        (angle > bound).then_some(found)
    }

    /// The section at `b`, mm, at its pose `here`, with only the teeth in reach; `pose` is that of the measuring plane. `None` if sections are
    /// searched.
    pub(super) fn section_in_reach(&self, pose: &Pose, here: &Pose, b: f64) -> Option<Section> {
        let search_free = self.search_free.as_ref()?;
        let place = SectionPlace {
            assembly: &self.assembly,
            whole: pose,
            here,
            b,
        };
        let side = |problem| SectionSide::new(&self.plane, problem, place, None);
        let [right, left] = search_free.sides.each_ref().map(side);
        let sides = [right?.into_problem(), left?.into_problem()];
        Some(self.plane.with_sides(sides))
    }

    /// Adds the contact of one side.
    fn add_side_without_search(
        &self,
        search_free: &SearchFreeSections,
        problem: &FlankProblem,
        pose: &Pose,
        effort: &Effort,
        over: &mut OverFace,
    ) -> Option<()> {
        let (assembly, side) = (&self.assembly, problem.side);
        let mut take = |b: f64, here: &Pose, contact: Contact| {
            let on = |own: Side| {
                (own == side).then_some(Contact {
                    error: contact.error + self.omitted_error,
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
        let (posed, nominal) = self.posed(problem, pose);
        let along = self.along_face(&posed, nominal, effort);
        let gap_at = |beyond: f64| nominal - side.sense() * beyond;
        if let Some((b, there)) = &search_free.one_place[side.index()]
            && let Some(tightest) = along.tightest_on_line()
        {
            let here = pose.in_section(assembly, *b);
            let at = self.plane.posed(there, &here);
            let contact = self.plane.contact(&at, &search_free.solver, effort)?;
            let gap = gap_at(take(*b, &here, contact)?);
            return (gap <= tightest + problem.tie).then_some(());
        }
        // The radius of a far corner is less than one and a half base radii.
        let moved = 2.0 * self.bounds.most_moved + assembly.most_shift();
        let mut section = |b: f64| {
            let here = pose.in_section(assembly, b);
            let place = SectionPlace {
                assembly,
                whole: pose,
                here: &here,
                b,
            };
            let at = SectionSide::new(
                &self.plane,
                problem,
                place,
                Some((&search_free.solver, moved)),
            )?;
            let contact = self
                .plane
                .contact(&at.posed(), &search_free.solver, effort)?;
            take(b, &here, contact)
        };
        // Fillets are searched only for what exceeds a known contact.
        let floor = if self.bounds.in_fillets {
            let [from, to] = assembly.face();
            gap_at(section(0f64.clamp(from, to))?)
        } else {
            f64::NEG_INFINITY
        };
        let (places, tightest) = self.places_of_leads(&along, &posed, nominal, floor);
        for b in places {
            section(b)?;
        }
        // Without a place that is tight, or with a contact tighter than those of `places`, sections are searched.
        let gap = gap_at(over.beyond(side)?);
        (gap <= tightest + problem.tie + self.omitted_error).then_some(())
    }
}
