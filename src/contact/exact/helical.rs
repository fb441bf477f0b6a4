//! Pairs that vary along the face, helical or with lead deviations: the contact over the common face from that of a few transverse sections.
//!
//! Rotation keeps points in their section, so the first section to touch stops the free gear: `φ_R = max_b φ_R(b)`, `φ_L = min_b φ_L(b)`. A
//! section is a spur pair ([`Section`]) with its teeth turned by their twist `τ(b)`. The contact of two involutes
//!
//! ```text
//! r_bF φ = Σ (arg B + α) − T − r_bL (λ − ψ_bL) + r_bF ψ_bF        (see `line`)
//! ```
//!
//! does not depend on `b`. `B` joins the centres of the sections, which are constant along the face, and `r_bL τ_L +
//! r_bF τ_F = 0`, because `r_b τ = ∓b tan β_b` for any base radius. This also holds for gears with different base
//! pitches, such as gears at different temperatures. Each follows its own lead, but both have one `β_b`, because
//! uniform expansion keeps angles. Then each pair of teeth has its own rotation, and wider faces have more pairs.
//!
//! Only the rolls depend on `b`. A pair has line contact over one stretch of the face, as long as its path of contact over `tan β_b`.
//! Outside it an end of an involute touches and the gap falls. A normal of the mate's involute passes through the pitch point only on the
//! line of action. So off that line the slope of the gap keeps its sign to the end of the face. Therefore sections spaced by at most the
//! shortest such stretch, with both ends of the face, hold the tightest of all pairs of involutes exactly.
//!
//! Leads turn the flanks of a section, and leaning axes move and stretch it: [`leads`] finds the places where that makes a pair tightest.
//!
//! One section is [`GearPair::section`](crate::pair::GearPair::section) and [`Pose::in_section`](crate::pair::Pose::in_section);
//! `over_face` takes the tightest of them. Polygons and certificate treat one section at a time (`by_sections`). If an edge can reach a
//! fillet, or paths of contact are very short, further sections are needed ([`edges`]).

mod edges;
mod leads;
mod place_filter;
mod profiled_flank;
pub(super) mod profiles;
mod roots;
mod search_free_sections;
mod turning;

use super::flank_problem::{FlankProblem, PosedFlanks};
use super::section::{Section, SectionRequest, floor};
use super::teeth::{Teeth, reduced};
use crate::contact::Effort;
use crate::contact::body::solid_radius;
use crate::contact::lost_motion::LostMotion;
use crate::contact::over_face::{FoundOverFace, OverFace};
use crate::error::Error;
use crate::gear::Side;
use crate::numeric::rank;
use crate::pair::{GearPair, Member, Pose, beyond_ends_bound, section_at};
use edges::Edges;
use leads::{AlongFace, EndlessPair, FaceBounds, MOST_BY_ARMS};
use place_filter::{GapLimits, PlaceFilter};
use profiles::{AlongFlanks, HighestPlace, LEVEL};
use search_free_sections::SearchFreeSections;
use std::borrow::Cow;
use turning::FreeGear;

/// Shortest stretch of line contact, in base pitches, that sets the spacing of sections (tuned: smaller values give
/// more sections). A pair with a shorter path of contact can have its stretch between two sections; [`edges`] finds it.
const SHORTEST: f64 = 0.125;

/// Nodes of a pose after which a section looks only for tighter contacts than known (tuned: ordinary pairs use a tenth).
const NODES_BEFORE_FLOOR: u64 = 20_000;

/// Effort of building a section of gears that deviate along the face, nodes (tuned: 10 µs of 40 teeth).
const BUILT_SECTION: u64 = 40;

/// Greatest number of rounds over the places of [`edges`]. Each round squares the remaining error.
const MOST_ROUNDS: usize = 4;

/// Greatest number of rounds over the places of [`profiles`]: two or three are usual. A height left over is added to the error.
const MOST_ROUNDS_OF_PROFILES: usize = 8;

/// Change of the free gear's rotation, rad, that ends the rounds: its square is below rounding.
const SETTLED: f64 = 1e-7;

/// A pair that varies along the face.
#[derive(Debug, Clone)]
pub(super) struct Helical {
    assembly: GearPair,
    /// The measuring plane.
    plane: Section,
    /// Places along the face, mm, and their sections, the one nearest to the measuring plane first.
    sections: Vec<(f64, Section)>,
    /// Further places between the sections where an edge may touch tightest.
    edges: Option<Edges>,
    /// Error of each contact that sections of leaning axes neglect, rad of the free gear.
    omitted_error: f64,
    bounds: FaceBounds,
    /// The solver of sections that need no search; `None` if one may need it.
    search_free: Option<Box<SearchFreeSections>>,
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
        if assembly.deviates_along_face() && from < 0.0 && to > 0.0 {
            sections.push((0.0, plane.clone()));
        }
        sections.sort_by_cached_key(|section| rank(section.0.abs()));
        let wheel = assembly.gear(Member::Wheel).gear().basic_data();
        let path = shortest_path(assembly);
        let short = path < SHORTEST * wheel.base_pitch();
        let mut edges = Edges::new(assembly, &plane.right, short);
        let base = assembly.gear(assembly.free()).gear().base_radius();
        let most_moved = most_moved(assembly);
        // Flanks in a section differ by their leads and leans, too.
        let moved = if assembly.deviates_along_face() {
            MOST_BY_ARMS * most_moved
        } else {
            0.0
        };
        if let Some(solver) = plane.solver.as_ref().filter(|_| !assembly.is_modified())
            && let Some(spread) = spread_on_line(plane, path - moved, wheel.base_pitch())
        {
            let deepest = [solver.proof.locked_fillet, solver.proof.free_fillet];
            let spread = (spread + moved / base, assembly.shift_bound());
            edges = edges.and_then(|edges| edges.without_fillets(&plane.right, deepest, spread));
        }
        let in_fillets = edges.as_ref().is_some_and(Edges::in_fillets);
        let edges = edges.filter(|_| assembly.is_helical());
        let omitted_error = if assembly.leans() {
            (assembly.section_error_bound() + beyond_ends_bound(assembly)) / base
        } else if assembly.is_modified() {
            2.0 * LEVEL / base
        } else {
            0.0
        };
        let search_free = SearchFreeSections::new(assembly, plane, edges.as_ref());
        let mut helical = Helical {
            bounds: FaceBounds {
                most_moved,
                most_lead: Side::BOTH.map(|side| most_lead(assembly, side)),
                lead_change: assembly.lead_change_bound(),
                in_fillets,
            },
            search_free: None,
            edges,
            omitted_error,
            assembly: assembly.clone(),
            plane: plane.clone(),
            sections,
        };
        helical.search_free =
            search_free.map(|search_free| Box::new(search_free.with_one_place(&helical)));
        helical
    }

    /// The section at `b`, mm, at `pose`, perhaps without the teeth out of reach, and the pose there; `kept` is the one of
    /// [`Helical::sections`] there.
    fn section_at<'a>(
        &self,
        pose: &Pose,
        b: f64,
        kept: Option<&'a Section>,
    ) -> (Cow<'a, Section>, Pose) {
        let here = pose.in_section(&self.assembly, b);
        let kept = kept.filter(|_| !self.assembly.leans());
        if let Some(section) = kept {
            return (Cow::Borrowed(section), here);
        }
        let search_free = self.search_free.as_ref();
        let section = search_free.and_then(|own| own.section_in_reach(self, pose, &here, b));
        if let Some(section) = section {
            return (Cow::Owned(section), here);
        }
        if self.assembly.leans() {
            let (pair, here) = section_at(&self.assembly, pose, b);
            return (Cow::Owned(self.plane.leaning(&pair)), here);
        }
        let section = self.plane.turned(&self.assembly.section(b));
        (Cow::Owned(section), here)
    }

    /// Calls `each` for every kept section at `pose`, and for those at the `further` places, with the pose there and the place, mm.
    ///
    /// # Errors
    /// The first of `each`.
    pub fn each_section<E>(
        &self,
        pose: &Pose,
        further: impl Iterator<Item = f64>,
        mut each: impl FnMut(&Section, &Pose, f64) -> Result<(), E>,
    ) -> Result<(), E> {
        for (b, section) in &self.sections {
            let (section, here) = self.section_at(pose, *b, Some(section));
            each(&section, &here, *b)?;
        }
        let is_kept = |place: &f64| self.places().any(|b| b == *place);
        let mut further: Vec<f64> = further.filter(|place| !is_kept(place)).collect();
        further.dedup();
        for b in further {
            let (section, here) = self.section_at(pose, b, None);
            each(&section, &here, b)?;
        }
        Ok(())
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

    /// Whether every pair of teeth has line contact over some length, for any direction of the eccentricities.
    pub fn has_line_contact(&self) -> bool {
        shortest_path(&self.assembly) > 0.0
    }

    /// The teeth of a side of the measuring plane, and the gap at the nominal rotation.
    fn posed<'a>(&self, problem: &'a FlankProblem, pose: &Pose) -> (PosedFlanks<'a>, f64) {
        let posed = self.plane.posed(problem, pose);
        let nominal = reduced(-problem.side.sense() * pose.free_rotation());
        (posed, reduced(nominal - posed.rotation(0.0)))
    }

    /// The teeth of `posed` over the face. The nominal rotation is at the gap `nominal`.
    fn along_face<'a>(
        &'a self,
        posed: &'a PosedFlanks,
        nominal: f64,
        effort: &'a Effort<'a>,
    ) -> AlongFace<'a> {
        AlongFace::new(&self.assembly, posed, nominal, self.bounds, effort)
    }

    /// Places, mm, at which leads and leans make a pair of `posed` tightest, with a gap above `floor`, and the tightest gap. The nominal
    /// rotation is at the gap `nominal`; `steps` are those of [`AlongFace::steps`].
    fn places_of_leads(
        &self,
        along: &AlongFace,
        steps: &[(EndlessPair, f64)],
        posed: &PosedFlanks,
        nominal: f64,
        floor: f64,
    ) -> (Vec<f64>, f64) {
        let (assembly, in_fillets) = (&self.assembly, self.bounds.in_fillets);
        // Leads can hold a pair that the known contact would leave out.
        let stands = FreeGear {
            rotation: posed.rotation(if floor.is_finite() { floor } else { nominal }),
            is_held: false,
        };
        let deepest = self.edges.iter().filter(|_| in_fillets);
        let deepest = deepest.flat_map(|edges| edges.deepest(assembly, posed, stands));
        let tie = posed.problem.tie;
        along.places(steps, floor + tie, tie, deepest)
    }

    /// Both contacts of `pose`, where no section needs a search; `None` where [`Helical::over`] has to find them.
    pub fn lost_motion_without_search(
        &self,
        pose: &Pose,
        effort: &Effort,
    ) -> Option<FoundOverFace> {
        self.search_free.as_ref()?.lost_motion(self, pose, effort)
    }

    /// Both contacts of `pose`, as `method` finds them in each section, within the common budget `effort`. If one
    /// section jams the gears, its contacts are the result, because nothing can turn then.
    pub fn over(
        &self,
        pose: &Pose,
        effort: &Effort,
        method: impl Fn(&Section, &Pose, SectionRequest) -> Result<LostMotion, Error>,
    ) -> Result<FoundOverFace, Error> {
        let on_roots = self.edges.as_ref().is_some_and(|edges| edges.jams);
        let mut examined = ExaminedSections {
            helical: self,
            pose,
            effort,
            method,
            may_jam: on_roots || self.plane.bodies.is_some(),
            over: OverFace::default(),
        };
        for (b, section) in &self.sections {
            examined.section(*b, Some(section), 0.0)?;
        }
        if let Some(edges) = &self.edges {
            examined.examine_edges(edges, &self.plane.right)?;
            examined.examine_edges(edges, &self.plane.left)?;
        }
        if self.assembly.binds_anywhere() {
            examined.examine_leads(&self.plane.right)?;
            examined.examine_leads(&self.plane.left)?;
        }
        if self.assembly.is_modified() {
            examined.examine_profiles(&self.plane.right)?;
            examined.examine_profiles(&self.plane.left)?;
        }
        let over = examined.over;
        Ok(over.found(pose.free_rotation(), self.plane.free_pitch()))
    }
}

/// The sections of a pose that were examined so far.
struct ExaminedSections<'a, M> {
    helical: &'a Helical,
    pose: &'a Pose,
    effort: &'a Effort<'a>,
    /// Finds both contacts in a section.
    method: M,
    /// Whether a single section can jam.
    may_jam: bool,
    over: OverFace,
}

impl<M: Fn(&Section, &Pose, SectionRequest) -> Result<LostMotion, Error>> ExaminedSections<'_, M> {
    /// Examines the section at `b`, mm, unless the gears are jammed; `kept` is the kept one there. `doubt`, rad, is added to the contact
    /// errors there.
    fn section(&mut self, b: f64, kept: Option<&Section>, doubt: f64) -> Result<(), Error> {
        if self.over.is_solid() {
            return Ok(());
        }
        let effort = self.effort;
        let (section, here) = self.helical.section_at(self.pose, b, kept);
        if matches!(section, Cow::Owned(_)) && self.helical.assembly.binds_anywhere() {
            effort.spend(BUILT_SECTION);
        }
        let section = &section;
        let known = self.over.known(self.may_jam);
        let mut found = None;
        if effort.used() > NODES_BEFORE_FLOOR && known[0].is_finite() {
            let tighter = (self.method)(section, &here, SectionRequest { effort, known })?;
            let clear = |found: &LostMotion| !OverFace::may_overlap(&here, found, known);
            found = Some(tighter).filter(|found| !self.may_jam || clear(found));
        }
        let mut found = match found {
            Some(found) => found,
            None => (self.method)(section, &here, SectionRequest::all(effort))?,
        };
        for contact in [&mut found.right, &mut found.left].into_iter().flatten() {
            contact.error += doubt + self.helical.omitted_error;
        }
        self.over.add(b, &here, found);
        Ok(())
    }

    /// Examines the places between the sections where an edge may touch tightest, on the side of `problem`.
    fn examine_edges(&mut self, edges: &Edges, problem: &FlankProblem) -> Result<(), Error> {
        let (helical, pose, side) = (self.helical, self.pose, problem.side);
        let assembly = &helical.assembly;
        let posed = helical.plane.posed(problem, pose);
        let facing = PlaceFilter::new(assembly, &posed, edges.short);
        let solid = solid_radius(assembly.gear(assembly.free()));
        // The centre of an eccentric free gear depends on its rotation: repeat until both are settled.
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
            // If nothing touches in any section so far, a touch between them is possible at any rotation of the free gear.
            let stands = FreeGear {
                rotation: -side.sense() * (pose.free_rotation() + beyond.unwrap_or(0.0)),
                is_held: beyond.is_some(),
            };
            for place in edges.places(assembly, &posed, stands, self.effort) {
                if self.over.is_solid() {
                    return Ok(());
                }
                // A jam can let the free gear turn further than the known limit.
                let [tighter, jams] = [false, self.may_jam]
                    .map(|may_jam| floor(&posed, self.over.known(may_jam), pose));
                let floors = GapLimits {
                    tighter,
                    jams,
                    solid,
                };
                if facing.may_be_tighter_or_jam(&place, floors, self.effort) {
                    self.section(place.b, None, place.doubt)?;
                }
            }
            last = Some(beyond);
        }
        Ok(())
    }

    /// Examines the places at which leads make a pair tightest, on the side of `problem`.
    fn examine_leads(&mut self, problem: &FlankProblem) -> Result<(), Error> {
        let (helical, pose, side) = (self.helical, self.pose, problem.side);
        let (posed, nominal) = helical.posed(problem, pose);
        let known = self.over.beyond(side);
        let floor = known.map_or(f64::NEG_INFINITY, |known| nominal - side.sense() * known);
        let along = helical.along_face(&posed, nominal, self.effort);
        let steps = along.steps(floor);
        let (places, _) = helical.places_of_leads(&along, &steps, &posed, nominal, floor);
        for b in places {
            self.section(b, None, 0.0)?;
        }
        Ok(())
    }

    /// Examines the places at which profile deviations make a pair tightest, on the side of `problem`. Each round is at the gap of the last.
    fn examine_profiles(&mut self, problem: &FlankProblem) -> Result<(), Error> {
        let (helical, pose, side) = (self.helical, self.pose, problem.side);
        let (posed, nominal) = helical.posed(problem, pose);
        for round in 1..=MOST_ROUNDS_OF_PROFILES {
            let Some(beyond) = self.over.beyond(side).filter(|_| !self.over.is_solid()) else {
                return Ok(());
            };
            let gap = nominal - side.sense() * beyond;
            let along = AlongFlanks::new(&helical.assembly, &posed, gap, self.effort);
            let highest = along.map_or(Ok(None), |along| along.highest());
            let (b, doubt) = match highest {
                Ok(None) => return Ok(()),
                Ok(Some(HighestPlace { b, .. })) if round < MOST_ROUNDS_OF_PROFILES => (b, 0.0),
                Ok(Some(HighestPlace { b, height, .. })) => {
                    (b, 2.0 * height * problem.per_free_base)
                }
                // The section reports it.
                Err(_) => (helical.assembly.face()[0], 0.0),
            };
            self.section(b, None, doubt)?;
        }
        Ok(())
    }
}

/// Greatest move of both flanks of any pair by leads, leans and profile deviations, mm along the base tangent.
pub(super) fn most_moved(assembly: &GearPair) -> f64 {
    let wheel = assembly.gear(Member::Wheel).gear().basic_data();
    let wound = wheel.base_helix_angle().tan();
    let of_gear = |member| {
        let gear = assembly.gear(member);
        let flanks = Side::BOTH.into_iter().flat_map(|side| {
            let range = move |tooth| {
                let curve = gear.lead_curve(side, tooth);
                curve.map_or(0.0, |curve| curve.range())
            };
            gear.teeth_by_lead().map(range)
        });
        let profiles = Side::BOTH
            .into_iter()
            .flat_map(|side| gear.deviations(side));
        let profiles = profiles.map(|[least, most]| least.abs().max(most.abs()));
        flanks.fold(0.0, f64::max) + profiles.fold(0.0, f64::max)
    };
    let reach = Member::BOTH.map(|member| assembly.gear(member).reach());
    let leaning = assembly.shift_bound() + assembly.lean_bound() * wound * (reach[0] + reach[1]);
    of_gear(Member::Wheel) + of_gear(Member::Pinion) + leaning
}

/// Greatest sum of the leads of any flanks of a side over the face, less that in the measuring plane, mm.
fn most_lead(assembly: &GearPair, side: Side) -> f64 {
    let of_gear = |member| {
        let gear = assembly.gear(member);
        let most = |tooth| {
            let [_, most] = gear.lead_bounds(side, tooth, assembly.face())[0];
            most - gear.lead(side, tooth, 0.0)
        };
        gear.teeth_by_lead()
            .map(most)
            .fold(f64::NEG_INFINITY, f64::max)
    };
    of_gear(Member::Wheel) + of_gear(Member::Pinion)
}

/// Greatest difference between the places of all flanks, rad of the free gear. `path` is the least path of contact in any section, mm.
/// `None` unless some pair is always on the line of action: flanks follow each other within a pitch plus their offset.
fn spread_on_line(plane: &Section, path: f64, base_pitch: f64) -> Option<f64> {
    let sides = [&plane.right, &plane.left];
    let range = |teeth: &Teeth| teeth.offset_range.1 - teeth.offset_range.0;
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

/// Least length along the axis, mm, over which a pair of teeth has line contact at any rotation. Along the axis the
/// path of contact advances by `tan β_b` per mm.
fn shortest_stretch(assembly: &GearPair) -> f64 {
    let basic_data = assembly.gear(Member::Wheel).gear().basic_data();
    let path = shortest_path(assembly).max(SHORTEST * basic_data.base_pitch());
    path / (basic_data.base_radius() * basic_data.twist().abs())
}

/// Least length of the path of contact at any rotation, mm.
///
/// The path runs between both tips, or from the start of an involute if that is nearer. It is a minimum of functions linear in the base
/// tangent `T`, so it is concave. Its least value is at the least or greatest distance of the displaced centres.
fn shortest_path(assembly: &GearPair) -> f64 {
    let gears = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let [one, other] = gears.map(|gear| {
        let gear = gear.gear();
        [gear.form_roll(), gear.tip_roll()].map(|roll| gear.base_radius() * roll)
    });
    let sum: f64 = gears.iter().map(|gear| gear.gear().base_radius()).sum();
    let off: f64 = gears.iter().map(|gear| gear.eccentricity()).sum();
    let off = off + assembly.shift_bound();
    let path = [-off, off].map(|off| {
        let distance = assembly.center_distance() + off;
        let tangent = (distance * distance - sum * sum).max(0.0).sqrt();
        (tangent - other[0]).min(one[1]) - (tangent - other[1]).max(one[0])
    });
    path[0].min(path[1])
}
