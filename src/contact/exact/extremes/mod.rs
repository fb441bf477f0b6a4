//! The least and the greatest lost motion of a pair over its whole mesh cycle and every rotation, proven.
//!
//! Each side has room until its tightest pair of half teeth touches; the lost motion is the sum of both. Two bounds hold over a stretch of
//! a mating: from below, that of each pair as if both were nothing but involutes and their ends, and below the form circle what the
//! fillets leave ([`separation`], [`dip`]); from above, that of any pair at all. Tables ([`table`]) rule out nearly every mating of a
//! long cycle; what is left is cut where its bound is worst until no stretch can beat the best pose found by more than the width
//! asked for. So the bracket holds every rotation of every mating, and one of its ends is a pose of the exact method.
//!
//! What the lower bound asks of a pair is what spares the exact method its searches ([`super::search_free_proof`]). Where that does not
//! hold, poses are sampled, and the result says so.

mod cell;
mod clearance;
mod corner_path;
mod course;
mod dip;
mod dips_over_face;
mod enclosed;
mod extreme;
mod fillet;
mod line_bends;
mod over;
mod rolls;
mod room;
mod sample;
mod search;
mod separation;
mod shift;
mod side_table;
mod table;

use super::ExactKernel;
use crate::contact::effort::Effort;
use crate::error::Error;
use crate::pair::{GearPair, Mating};
use course::Course;
use extreme::Which;
pub(crate) use extreme::is_proven;
pub use extreme::{Doubt, Extreme, Extremes, PROVEN_WIDTH, PROVEN_WIDTH_DRAWN};
use extreme::{PosesSeen, UNKNOWN};
use sample::Until;
use search::Search;
use table::Table;

/// Of the effort that is left a search of one cycle takes one part in so many at most, one for an end of it alone at one of some ten other centre
/// distances as well (tuned).
const PARTS_OF_EFFORT: [u64; 2] = [2, 4];

impl ExactKernel {
    /// The extremes of `assembly`, which is this kernel's, over `matings` pitches from `first` on, each bracket no wider than `width` mm
    /// where it is proven.
    ///
    /// # Errors
    /// None of a pair that has a kernel: a contact that is lost is a [`Doubt`].
    pub fn extremes(
        &self,
        assembly: &GearPair,
        first: Mating,
        matings: u64,
        width: f64,
    ) -> Result<Extremes, Error> {
        self.extremes_within(
            assembly,
            (first, matings),
            width,
            &Effort::of_extremes(assembly),
        )
    }

    /// The same with what `effort` allows, and no more than a part of that ([`PARTS_OF_EFFORT`]).
    ///
    /// # Errors
    /// As [`ExactKernel::extremes`].
    pub(crate) fn extremes_within(
        &self,
        assembly: &GearPair,
        over: (Mating, u64),
        width: f64,
        effort: &Effort,
    ) -> Result<Extremes, Error> {
        self.sought_within(
            assembly,
            over,
            width,
            effort,
            &[Which::Greatest, Which::Least],
        )
    }

    /// As [`ExactKernel::extremes_within`] but for the least, and no further than to the first pose that is out of mesh.
    ///
    /// # Errors
    /// As [`ExactKernel::extremes`].
    pub(crate) fn greatest(
        &self,
        assembly: &GearPair,
        over: (Mating, u64),
        width: f64,
        effort: &Effort,
    ) -> Result<Extremes, Error> {
        Ok(Extremes {
            least: None,
            ..self.sought_within(assembly, over, width, effort, &[Which::Greatest])?
        })
    }

    /// As [`ExactKernel::extremes_within`], but for the greatest, and no further than to the first pose that is jammed.
    ///
    /// # Errors
    /// As [`ExactKernel::extremes`].
    pub(crate) fn least(
        &self,
        assembly: &GearPair,
        over: (Mating, u64),
        width: f64,
        effort: &Effort,
    ) -> Result<Extremes, Error> {
        Ok(Extremes {
            greatest: None,
            ..self.sought_within(assembly, over, width, effort, &[Which::Least])?
        })
    }

    /// Whether it is clear at once that no tip comes to a fillet or a root at any pose of `assembly`, which is this kernel's, nor at any
    /// greater centre distance: involutes, their ends and tip lands touch before.
    pub(crate) fn keeps_to_involutes(&self, assembly: &GearPair) -> bool {
        if assembly.is_modified()
            || self.section.blocked
            || self.section.bodies.is_some()
            || !self.is_direct()
        {
            return false;
        }
        let first = Mating::FIRST;
        let effort = Effort::endless();
        let course = Course::new(self, assembly, (first, 1), &effort);
        self.stays_on_involutes(&course) && !Table::new(&course).has_dips()
    }

    /// The extremes `of` a cycle, with a part of `effort`.
    fn sought_within(
        &self,
        assembly: &GearPair,
        over: (Mating, u64),
        width: f64,
        effort: &Effort,
        of: &[Which],
    ) -> Result<Extremes, Error> {
        let parts = match of {
            [_] => PARTS_OF_EFFORT[1],
            _ => PARTS_OF_EFFORT[0],
        };
        let own = effort.part(parts);
        let found = self.sought(&Course::new(self, assembly, over, &own), width, of);
        effort.spend(own.used());
        found
    }

    fn sought(&self, course: &Course, width: f64, of: &[Which]) -> Result<Extremes, Error> {
        let until = match of {
            [Which::Least] => Until::Jammed,
            [Which::Greatest] => Until::Unmeshed,
            _ => Until::End,
        };
        let mut found = PosesSeen::default();
        if course.assembly.is_modified() {
            sample::sample(course, &mut found, until)?;
            let bounds = enclosed::bounds(course, width, of)?;
            return Ok(found.extremes(course, bounds));
        }
        // Without a solver flanks are no involutes, or base circles may overlap.
        let helical = self.helical.as_ref();
        if self.section.blocked
            || self.section.bodies.is_some()
            || self.section.solver.is_none()
            || helical.is_some_and(|helical| !helical.has_line_contact())
        {
            sample::sample(course, &mut found, until)?;
            return Ok(found.extremes(course, [UNKNOWN; 2]));
        }
        let table = Table::new(course);
        let width = width / course.per_radian();
        let search = |which| Search {
            course,
            table: &table,
            width: search::PROOF_SHARE * width,
            equal: search::EQUAL_SHARE * width,
            which,
            // A third each to both searches and to the poses that are sampled if they do not close. A search for the least alone samples none.
            spare: match which {
                Which::Greatest => course.effort.left() / 3 * 2,
                Which::Least if until == Until::Jammed => 0,
                Which::Least => course.effort.left() / 3,
            },
            until,
        };
        let stays = self.stays_on_involutes(course);
        let wanted = of.iter().copied();
        let wanted = wanted.filter(|which| stays || *which == Which::Greatest);
        let searches: Vec<Search> = wanted.map(search).collect();
        let (mut least, mut greatest) = (UNKNOWN, UNKNOWN);
        let mut ranked = search::rank(&searches, &mut found)?;
        for (search, ranked) in searches.iter().zip(&mut ranked) {
            let proof = search.run(ranked, &mut found)?;
            match search.which {
                Which::Least => least = proof,
                Which::Greatest => greatest = proof,
            }
        }
        if !stays && of.contains(&Which::Least) {
            sample::sample(course, &mut found, until)?;
        }
        for (search, ranked) in searches.iter().zip(ranked) {
            search.name_first(ranked.near, &mut found)?;
        }
        Ok(found.extremes(course, [least, greatest]))
    }

    /// Whether nothing but involutes, their ends and tip lands can touch, but for corners on fillets, which [`dip`] bounds.
    fn stays_on_involutes(&self, course: &Course) -> bool {
        let side = &course.sides[0];
        let problem = side.problem;
        let forms = problem.locked.shape.form_radius() + problem.free.shape.form_radius();
        self.is_direct() && forms + side.off[0] + side.off[1] < problem.distance
    }
}
