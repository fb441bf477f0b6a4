//! Helical gears: the contact over a whole common face from that of some of its transverse sections.
//!
//! Rotation keeps points in their section, so the free gear stops where the first section does: `φ_R = max_b φ_R(b)`, `φ_L = min_b φ_L(b)`.
//! A section is a spur pair ([`Section`]) with its teeth rolled on by their twist `τ(b)`. Between involutes
//!
//! ```text
//! r_bF φ = Σ (arg B + α) − T − r_bL (λ − ψ_bL) + r_bF ψ_bF        (see `line`)
//! ```
//!
//! does not depend on `b`: `B` runs between the centres of the sections, which do not wind, and `r_bL τ_L + r_bF τ_F = 0`, since `r_b τ = ∓b tan β_b`
//! whatever the base radius. So it is of gears whose base pitches differ, as those of unlike temperature do: each is wound by its own lead, but both by one `β_b`
//! (a gear that expands alike in all directions keeps its angles). Then each pair has a rotation of its own, and wider faces have more pairs. Only
//! the rolls do: a pair touches so over one stretch of the face, as long as its path of contact over `tan β_b`. Beyond it an end of an
//! involute touches, and the gap falls: a normal of the mate's involute passes through the pitch point on the line of action alone,
//! so away from it the gap has a slope of one sign, down to the face's end. Therefore sections no farther apart than the shortest such
//! stretch, both ends of the face among them, hold the tightest of all pairs of involutes exactly, however many or few they are.
//!
//! A section alone is [`GearPair::section`](crate::pair::GearPair::section) and [`Pose::in_section`](crate::pair::Pose::in_section); `over_face` takes
//! the tightest of those that nothing can slip between. Polygons and certificate see one section at a time (`by_sections`).
//!
//! Where an edge comes to a fillet, or paths of contact are next to none, more is to be seen between ([`edges`]).

mod edges;
mod facing;
mod roots;
#[cfg(test)]
mod tests;
mod turning;

use super::flank_problem::FlankProblem;
use super::section::{Section, Wanted, floor};
use super::teeth::Teeth;
use crate::contact::Effort;
use crate::contact::body::solid_radius;
use crate::contact::lost_motion::LostMotion;
use crate::contact::over_face::{FoundOverFace, OverFace};
use crate::error::Error;
use crate::pair::{GearPair, Member, Pose};
use edges::Edges;
use facing::{Facing, Floors};
use turning::FreeGear;

/// Shortest stretch of line contact, in base pitches, that sections are spaced by (tuned: the less, the more sections). Of a pair whose path of
/// contact is shorter, a stretch may lie between two sections, and is looked for by itself ([`edges`]).
const SHORTEST: f64 = 0.125;

/// Nodes of a pose after which a section is asked for no more than what is tighter than those before (tuned: ordinary pairs take a tenth).
const UNHURRIED: u64 = 20_000;

/// Times the places of [`edges`] are looked for: each leaves the square of what the last one left.
const MOST_ROUNDS: usize = 4;

/// A change, rad, of the free gear's rotation after which no other round is needed: the square is below rounding.
const SETTLED: f64 = 1e-7;

/// A pair of helical gears.
#[derive(Debug, Clone)]
pub(super) struct Helical {
    assembly: GearPair,
    /// The measuring plane.
    plane: Section,
    /// Places along the face, mm, and the sections there, that nearest to the measuring plane first.
    sections: Vec<(f64, Section)>,
    /// Where between them more is to be seen.
    edges: Option<Edges>,
}

impl Helical {
    /// The sections of `assembly`, whose measuring plane is `plane`.
    pub fn new(assembly: &GearPair, plane: &Section) -> Helical {
        let [from, to] = assembly.face();
        let stretch = shortest_stretch(assembly);
        let spaces = if to > from {
            // Rounding: a millionth more than needed.
            ((to - from) / stretch * (1.0 + 1e-6)).ceil().max(1.0)
        } else {
            0.0
        };
        let mut sections: Vec<(f64, Section)> = (0..=spaces as u64)
            .map(|k| {
                // The last place is exactly the end of the face.
                if k as f64 >= spaces {
                    to
                } else {
                    from + (to - from) * (k as f64 / spaces)
                }
            })
            .map(|b| (b, plane.turned(&assembly.section(b))))
            .collect();
        sections.sort_by(|one, other| one.0.abs().total_cmp(&other.0.abs()));
        let base_pitch = assembly
            .gear(Member::Wheel)
            .gear()
            .basic_data()
            .base_pitch();
        let path = shortest_path(assembly);
        let mut edges = Edges::new(assembly, &plane.right, path < SHORTEST * base_pitch);
        if let Some(solver) = &plane.solver
            && let Some(spread) = spread_on_line(plane, path, base_pitch)
        {
            let deepest = [solver.proof.locked_fillet, solver.proof.free_fillet];
            edges = edges.and_then(|edges| edges.without_fillets(&plane.right, deepest, spread));
        }
        Helical {
            edges,
            assembly: assembly.clone(),
            plane: plane.clone(),
            sections,
        }
    }

    /// Places along the face, mm, and the sections there that hold the tightest of all pairs of involutes.
    pub fn sections(&self) -> &[(f64, Section)] {
        &self.sections
    }

    /// Places along the face, mm, whose sections hold the tightest of all pairs of involutes.
    pub fn places(&self) -> impl Iterator<Item = f64> {
        self.sections.iter().map(|&(b, _)| b)
    }

    /// The sections at both ends of the face, and where they are, mm.
    pub fn ends(&self) -> [(f64, &Section); 2] {
        self.assembly.face().map(|end| {
            let mut at = self.sections.iter().filter(|(b, _)| *b == end);
            let (b, section) = at.next().expect("both ends are among the sections");
            (*b, section)
        })
    }

    /// Whether every pair of teeth touches on the line of action over some length, wherever the eccentricities have the centres.
    pub fn has_line_contact(&self) -> bool {
        shortest_path(&self.assembly) > 0.0
    }

    /// Both contacts of `pose`, as `method` finds them in each section, with what `effort` allows for all of them; of a section that jams the gears
    /// by itself those in it, for nothing turns then, whatever touches elsewhere.
    pub fn over(
        &self,
        pose: &Pose,
        effort: &Effort,
        method: impl Fn(&Section, &Pose, Wanted) -> Result<LostMotion, Error>,
    ) -> Result<FoundOverFace, Error> {
        let on_roots = self.edges.as_ref().is_some_and(|edges| edges.jams);
        let mut looking = Looking {
            helical: self,
            pose,
            effort,
            method,
            may_jam: on_roots || self.plane.bodies.is_some(),
            over: OverFace::default(),
        };
        for (b, section) in &self.sections {
            looking.look(*b, section, 0.0)?;
        }
        if let Some(edges) = &self.edges {
            looking.between(edges, &self.plane.right)?;
            looking.between(edges, &self.plane.left)?;
        }
        let over = looking.over;
        Ok(over.found(pose.free_rotation(), self.plane.free_pitch()))
    }
}

/// The sections of a pose that were looked at so far.
struct Looking<'a, M> {
    helical: &'a Helical,
    pose: &'a Pose,
    effort: &'a Effort,
    /// Finds both contacts in a section.
    method: M,
    /// Whether a section may jam by itself.
    may_jam: bool,
    over: OverFace,
}

impl<M: Fn(&Section, &Pose, Wanted) -> Result<LostMotion, Error>> Looking<'_, M> {
    /// Looks at the section at `b`, mm, unless the gears are jammed; `doubt`, rad, is beside the errors of what touches there.
    fn look(&mut self, b: f64, section: &Section, doubt: f64) -> Result<(), Error> {
        if self.over.is_solid() {
            return Ok(());
        }
        let effort = self.effort;
        let here = self.pose.in_section(&self.helical.assembly, b);
        let known = self.over.known(self.may_jam);
        let mut found = None;
        if effort.used() > UNHURRIED && known[0].is_finite() {
            let tighter = (self.method)(section, &here, Wanted { effort, known })?;
            let clear = |found: &LostMotion| !OverFace::may_overlap(&here, found, known);
            found = Some(tighter).filter(|found| !self.may_jam || clear(found));
        }
        let mut found = match found {
            Some(found) => found,
            None => (self.method)(section, &here, Wanted::all(effort))?,
        };
        for contact in [&mut found.right, &mut found.left].into_iter().flatten() {
            contact.error += doubt;
        }
        self.over.take(b, &here, found);
        Ok(())
    }

    /// Looks where an edge may touch tightest between the sections: on the side of `problem`.
    fn between(&mut self, edges: &Edges, problem: &FlankProblem) -> Result<(), Error> {
        let (helical, pose, side) = (self.helical, self.pose, problem.side);
        let assembly = &helical.assembly;
        let posed = helical.plane.posed(problem, pose);
        let facing = Facing::new(assembly, &posed, edges.short);
        let solid = solid_radius(assembly.gear(assembly.free()));
        // An eccentric free gear's centre stands where its rotation puts it: looked at anew until that is settled.
        let is_eccentric = problem.free_off.norm() > 0.0;
        let rounds = if is_eccentric { MOST_ROUNDS } else { 1 };
        let mut last = None;
        for _ in 0..rounds {
            let beyond = self.over.beyond(side);
            let is_settled = |last: Option<f64>| match last.zip(beyond) {
                Some((last, beyond)) => (beyond - last).abs() <= SETTLED,
                None => last == beyond,
            };
            if last.is_some_and(is_settled) {
                break;
            }
            // Where nothing touches in any section so far, it may between them, wherever the free gear comes to stand.
            let stands = FreeGear {
                rotation: -side.sense() * (pose.free_rotation() + beyond.unwrap_or(0.0)),
                is_held: beyond.is_some(),
            };
            for place in edges.places(assembly, &posed, stands, self.effort) {
                if self.over.is_solid() {
                    return Ok(());
                }
                // What jams may let the free gear farther than what is known.
                let [tighter, jams] = [false, self.may_jam]
                    .map(|may_jam| floor(&posed, self.over.known(may_jam), pose));
                let floors = Floors {
                    tighter,
                    jams,
                    solid,
                };
                if facing.may_hold(&place, floors, self.effort) {
                    let section = helical.plane.turned(&assembly.section(place.b));
                    self.look(place.b, &section, place.doubt)?;
                }
            }
            last = Some(beyond);
        }
        Ok(())
    }
}

/// How much the places of all flanks differ, rad of the free gear, where at any pose some pair touches on the line of action, whose path is no
/// shorter than `path`, mm, in any section: flanks follow each other within a pitch and what they are off.
fn spread_on_line(plane: &Section, path: f64, base_pitch: f64) -> Option<f64> {
    let sides = [&plane.right, &plane.left];
    let range = |teeth: &Teeth| teeth.extremes.1 - teeth.extremes.0;
    let spread = |problem: &FlankProblem| {
        let ratio = problem.locked.shape.base * problem.per_free_base;
        ratio * range(&problem.locked) + range(&problem.free)
    };
    let covers = |problem: &&FlankProblem| {
        let off = problem.locked.shape.base * range(&problem.locked);
        problem.per_step == 0.0 && path > base_pitch + off
    };
    let all = sides.iter().all(covers);
    all.then(|| spread(sides[0]).max(spread(sides[1])))
}

/// Least length along the axis, mm, over which a pair of teeth touches on the line of action at any rotation: the path of contact winds
/// by `tan β_b` a mm.
fn shortest_stretch(assembly: &GearPair) -> f64 {
    let basic_data = assembly.gear(Member::Wheel).gear().basic_data();
    let path = shortest_path(assembly).max(SHORTEST * basic_data.base_pitch());
    path / (basic_data.base_radius() * basic_data.twist().abs())
}

/// Least length of the path of contact at any rotation, mm.
///
/// The path between both tips, or from an involute's beginning where that comes first, is a least of functions linear in
/// the base tangent `T`: concave, so least at the least or at the greatest distance of the displaced centres.
fn shortest_path(assembly: &GearPair) -> f64 {
    let gears = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let [one, other] = gears.map(|gear| {
        let gear = gear.gear();
        [gear.form_roll(), gear.tip_roll()].map(|roll| gear.base_radius() * roll)
    });
    let sum: f64 = gears.iter().map(|gear| gear.gear().base_radius()).sum();
    let off: f64 = gears.iter().map(|gear| gear.eccentricity()).sum();
    let path = [-off, off].map(|off| {
        let distance = assembly.center_distance() + off;
        let tangent = (distance * distance - sum * sum).max(0.0).sqrt();
        (tangent - other[0]).min(one[1]) - (tangent - other[1]).max(one[0])
    });
    path[0].min(path[1])
}
