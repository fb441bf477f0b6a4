//! The quick method for a pair that [`super::search_free_proof`] covers: the line of action, then the corners.
//!
//! At the greatest gap so far most corners are clear of the mate's metal. A table of lines shows that
//! ([`super::envelope`]); only the other corners are compared with the curves.

use super::candidate::CandidateContact;
use super::corner::{Sense, least_flank_radius, meet, nearest_turn, on_land, tip_arm};
use super::curves::{Curves, SearchExhausted};
use super::envelope::Envelope;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::lands::{land_on_land, without_lands};
use super::line::TangentVariation;
use super::placed::Placed;
use super::search::{self, SideRequest};
use super::search_free_proof::{SearchFreeProof, Setting};
use super::shape::{C, turn};
use super::tightest::{TightestContacts, Touching};
use crate::contact::gap::MOST_NODES;
use crate::gear::ProfilePart;
use crate::pair::GearPair;
use std::sync::Arc;

/// The data of the quick method besides the teeth.
#[derive(Debug, Clone)]
pub(super) struct DirectSolver {
    pub proof: SearchFreeProof,
    pub variation: TangentVariation,
    pub envelopes: Envelopes,
    /// Eccentricity of the free gear.
    pub free_off: f64,
    /// Greatest radius of the free gear about its axis.
    pub outmost: f64,
}

/// The regions clear of each gear's teeth. They hold at every centre distance at which the teeth reach each other.
#[derive(Debug, Clone)]
pub(super) struct Envelopes {
    pub locked: Arc<Envelope>,
    pub free: Arc<Envelope>,
}

impl Envelopes {
    /// The envelopes of both gears of `assembly`, whose flanks are those of `problem`.
    pub fn new(problem: &FlankProblem, assembly: &GearPair) -> Envelopes {
        Envelopes::with_room(problem, assembly, 0.0)
    }

    /// The envelopes, wider by `room` mm.
    pub fn with_room(problem: &FlankProblem, assembly: &GearPair, room: f64) -> Envelopes {
        let (locked, free) = (
            assembly.gear(assembly.locked()),
            assembly.gear(assembly.free()),
        );
        // A tie below the greatest gap must not be ruled out: the points of both gears move by less than this.
        // Leaning axes shift the outlines of a section.
        let shift = assembly.most_shift();
        let farthest = problem.distance.max(locked.reach() + free.reach()) + shift;
        let margin =
            room + 4.0 * problem.tie_at(farthest) * (farthest + problem.locked.shape.tip_radius);
        Envelopes {
            locked: Arc::new(Envelope::new(locked.gear(), margin, 0.0)),
            free: Arc::new(Envelope::new(
                free.gear(),
                margin,
                free.eccentricity() + shift,
            )),
        }
    }
}

/// The first contact; without a solver, by the search.
///
/// # Errors
/// The step whose pair could not be settled.
pub(super) fn touching(
    posed: &PosedFlanks,
    solver: Option<&DirectSolver>,
    request: SideRequest,
) -> Result<Option<Touching>, (i64, SearchExhausted)> {
    let Some(solver) = solver else {
        return search::touching(posed, request);
    };
    let mut tightest_contacts = TightestContacts::new(posed.problem);
    if !posed.on_line(&solver.variation, &mut tightest_contacts) {
        return search::touching(posed, request);
    }
    let proof = &solver.proof;
    if proof.tangents {
        posed.on_tangents(solver.free_off > 0.0, &mut tightest_contacts);
    }
    posed.on_corners(solver, &mut tightest_contacts);
    if proof.is_direct() {
        return Ok(tightest_contacts.choose());
    }
    if !proof.open.is_empty() {
        posed.on_lands(proof.open, &mut tightest_contacts);
    }
    let rest = without_lands(proof.open);
    let curves = |locked: &Placed| {
        let mut curves = rest;
        if proof
            .steep_arm
            .is_some_and(|arm| solver.is_steep(locked, arm))
        {
            curves.add(ProfilePart::Involute, ProfilePart::Tip);
        }
        curves
    };
    search::over(posed, tightest_contacts, curves, request, MOST_NODES)
}

impl DirectSolver {
    /// The solver of a pair; `None` if the pair must be searched throughout, as any with flanks other than involutes.
    pub fn new(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
    ) -> Option<DirectSolver> {
        DirectSolver::of(problem, assembly, envelopes, problem)
    }

    /// The solver for all sections of leaning axes, whose outlines stand further off their axes than those of `problem`.
    pub fn over_leans(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
    ) -> Option<DirectSolver> {
        let shift = assembly.most_shift();
        let [from, to] = assembly.face();
        let wobble = assembly.gear(assembly.free()).wobble() * from.abs().max(to.abs());
        DirectSolver::with_offs(problem, assembly, envelopes, problem, [shift, wobble])
    }

    /// The solver for `modified`, whose profiles deviate from those of `problem` and `assembly`.
    pub fn of(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
        modified: &FlankProblem,
    ) -> Option<DirectSolver> {
        DirectSolver::with_offs(problem, assembly, envelopes, modified, [0.0; 2])
    }

    /// As [`DirectSolver::of`], with outlines up to `more` mm further off their axes.
    fn with_offs(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
        modified: &FlankProblem,
        more: [f64; 2],
    ) -> Option<DirectSolver> {
        let locked_gear = assembly.gear(assembly.locked());
        let free_gear = assembly.gear(assembly.free());
        if locked_gear.is_modified() || free_gear.is_modified() {
            return None;
        }
        let setting = Setting {
            locked: &problem.locked.shape,
            free: &problem.free.shape,
            locked_teeth: &modified.locked,
            free_teeth: &modified.free,
            locked_off: locked_gear.eccentricity() + more[0],
            free_off: free_gear.eccentricity() + more[1],
            distance: problem.distance,
        };
        Some(DirectSolver {
            proof: setting.prove()?,
            free_off: setting.free_off,
            outmost: free_gear.reach() + more[1],
            variation: TangentVariation::new(problem, setting.locked_off, setting.free_off)?,
            envelopes,
        })
    }

    /// Whether the arm `X` of a locked involute within reach can be `arm` or less.
    ///
    /// `X = D cos η − r_b`, where `η` is the angle of `E` from the line of centres and falls from the tip inwards. `X`
    /// is least at the tip, or where `η` is negative; the proof covers that case.
    fn is_steep(&self, locked: &Placed, arm: f64) -> bool {
        tip_arm(locked) <= arm && least_flank_radius(locked) <= self.outmost
    }
}

impl PosedFlanks<'_> {
    /// Offers the greatest gap of the pairs of lands in `curves`, step by step.
    pub(super) fn on_lands(&self, curves: Curves, tightest_contacts: &mut TightestContacts) {
        for step in self.steps() {
            let (locked, free) = (self.locked(step), self.free(step));
            if let Some(candidate) = land_on_land(&locked, &free, self.origin_of(step), curves)
                && tightest_contacts.admits(candidate.gap)
            {
                tightest_contacts.offer(step, candidate);
            }
        }
    }

    /// Offers every corner whose gap can exceed the greatest so far: tip corners and undercut joints.
    ///
    /// `R` is the free gear's rotation at the greatest gap so far; `C_F` and `D_F` hold at rotation 0. A locked point
    /// `C_L + D_L p` is at `(R* (C_L + D_L p) − C_F) D_F*` in the free tooth's own frame. A free point is at `(R (C_F +
    /// D_F p) − C_L) D_L*` in the locked tooth's.
    fn on_corners(&self, solver: &DirectSolver, tightest_contacts: &mut TightestContacts) {
        let mut level = AtRotation::at(self, tightest_contacts.greatest());
        let (locked_teeth, free_teeth) = (&self.problem.locked, &self.problem.free);
        let steps = self.steps();
        // The pair at the line of centres first: its contact leaves the others clear.
        let middle = steps.contains(&0).then_some(0);
        for step in middle.into_iter().chain(steps.filter(|&step| step != 0)) {
            let (locked_place, free_place) = self.places(step);
            let toward = free_teeth.direction(free_place);
            let seen = level.direction * locked_teeth.direction(locked_place);
            let (centre, known) = (level.centre, level.known);
            for &corner in locked_teeth.shape.corners() {
                let near = (centre + seen * corner.1) * toward.conj();
                if !(known && solver.envelopes.free.clears(near)) {
                    let edge = (ProfilePart::Involute, corner.0);
                    self.locked_corner(
                        solver,
                        step,
                        (edge, corner.1, near),
                        &mut level,
                        tightest_contacts,
                    );
                }
            }
            if solver.proof.tangents {
                let far = locked_teeth.far(locked_place);
                let near = (centre + seen * far) * toward.conj();
                if !(known && solver.envelopes.free.clears(near)) {
                    let edge = (ProfilePart::Tip, -far.arg());
                    self.locked_corner(
                        solver,
                        step,
                        (edge, far, near),
                        &mut level,
                        tightest_contacts,
                    );
                }
            }
            // A land that is not exactly round about its axis can pass the near corner and touch the far one.
            if solver.free_off > 0.0 {
                self.far_corner(solver, step, locked_place, &mut level, tightest_contacts);
            }
            for &corner in free_teeth.shape.corners() {
                let near = (toward * corner.1 - centre) * seen.conj();
                let clear =
                    known && level.is_ahead(near, seen) && solver.envelopes.locked.clears(near);
                if !clear || solver.proof.turns_back {
                    self.free_corner(
                        solver,
                        step,
                        (corner, near, clear),
                        &mut level,
                        tightest_contacts,
                    );
                }
            }
        }
    }

    /// Examines a corner of the locked gear that the envelope does not show clear.
    #[cold]
    fn locked_corner(
        &self,
        solver: &DirectSolver,
        step: i64,
        (edge, corner, near): ((ProfilePart, f64), C, C),
        level: &mut AtRotation,
        tightest_contacts: &mut TightestContacts,
    ) {
        let (locked, free) = (self.locked(step), self.free(step));
        let rho = locked.own_to_axis(corner);
        if level.known && solver.envelopes.free.is_beyond_tip(near) && rho > solver.outmost {
            return;
        }
        if let Some(met) = meet(&free, Sense::Free, solver.proof.free_fillet, rho, near) {
            let candidate =
                CandidateContact::new((&locked, edge), (&free, met), self.origin_of(step), 0.0);
            level.offer(self, tightest_contacts, step, candidate);
        }
    }

    /// Examines the far corner of a locked land against the free tip land at its radius.
    ///
    /// In all other cases the near corners, or a search, have the greatest gap ([`super::search_free_proof`]).
    #[inline]
    fn far_corner(
        &self,
        solver: &DirectSolver,
        step: i64,
        place: usize,
        level: &mut AtRotation,
        tightest_contacts: &mut TightestContacts,
    ) {
        let Some(square) = self.far_corner_reaches(solver, place) else {
            return;
        };
        let (locked, free) = (self.locked(step), self.free(step));
        if let Some(met) = on_land(&free, ProfilePart::Tip, square.sqrt()) {
            let edge = (
                &locked,
                (ProfilePart::Tip, locked.range(ProfilePart::Tip).0),
            );
            let candidate = CandidateContact::new(
                edge,
                (&free, (ProfilePart::Tip, met)),
                self.origin_of(step),
                0.0,
            );
            level.offer(self, tightest_contacts, step, candidate);
        }
    }

    /// Squared radius of the far corner of the locked land at `place` if a free tip land can have that radius, mm².
    #[inline]
    pub(super) fn far_corner_reaches(&self, solver: &DirectSolver, place: usize) -> Option<f64> {
        let (locked_teeth, free_tip) = (&self.problem.locked, self.problem.free.shape.tip_radius);
        let point =
            self.centre - self.turned * locked_teeth.direction(place) * locked_teeth.far(place);
        let square = point.norm_sqr();
        // |ρ² − r²| ≤ e (2r + e) on a circle that is e off its axis.
        let off = (square - free_tip * free_tip).abs();
        (off <= solver.free_off * (2.0 * free_tip + solver.free_off)).then_some(square)
    }

    /// Whether [`PosedFlanks::far_corner_reaches`] can hold in a section whose corners move by up to `moved`, mm.
    pub(super) fn far_corner_may_reach(
        &self,
        solver: &DirectSolver,
        step: i64,
        moved: f64,
    ) -> bool {
        let (place, _) = self.places(step);
        let (locked_teeth, free_tip) = (&self.problem.locked, self.problem.free.shape.tip_radius);
        let point =
            self.centre - self.turned * locked_teeth.direction(place) * locked_teeth.far(place);
        let off = solver.free_off + moved;
        let beyond = point.norm_sqr() - free_tip * free_tip;
        solver.free_off > 0.0 && beyond.abs() <= off * (2.0 * free_tip + off)
    }

    /// Examines a corner of the free gear that the envelope does not reliably show clear.
    #[cold]
    fn free_corner(
        &self,
        solver: &DirectSolver,
        step: i64,
        ((roll, corner), near, clear): ((f64, C), C, bool),
        level: &mut AtRotation,
        tightest_contacts: &mut TightestContacts,
    ) {
        let (locked, free) = (self.locked(step), self.free(step));
        let rho = free.own_to_axis(corner);
        // A flank that turns back can hide a clear point behind it, if the point came that near.
        let behind =
            solver.proof.turns_back && tip_arm(&locked) <= 0.0 && rho >= nearest_turn(&locked);
        let trusted = level.known && !behind;
        let over =
            || solver.envelopes.locked.is_beyond_tip(near) && rho < locked.least_land_radius();
        if trusted && (clear || over()) {
            return;
        }
        if let Some(met) = meet(
            &locked,
            Sense::Locked,
            solver.proof.locked_fillet,
            rho,
            near,
        ) {
            let edge = (&free, (ProfilePart::Involute, roll));
            let candidate = CandidateContact::new((&locked, met), edge, self.origin_of(step), 0.0);
            level.offer(self, tightest_contacts, step, candidate);
        }
    }
}

/// Both gears in the frame of the free one at the greatest gap so far.
pub(super) struct AtRotation {
    greatest: f64,
    /// False before the first candidate, when nothing can be ruled out.
    known: bool,
    /// `R* C_L − C_F`.
    pub centre: C,
    /// `−R*` times the locked gear's rotation.
    pub direction: C,
    /// The free axis from the centre of the locked outline.
    axis: C,
}

impl AtRotation {
    /// The gears at the gap `greatest`; −∞ before the first candidate.
    pub fn at(posed: &PosedFlanks, greatest: f64) -> AtRotation {
        let mut level = AtRotation {
            greatest: 0.0,
            known: false,
            centre: C::ZERO,
            direction: C::ZERO,
            axis: C::ZERO,
        };
        level.set(posed, greatest);
        level
    }

    fn set(&mut self, posed: &PosedFlanks, greatest: f64) {
        self.known = greatest > f64::NEG_INFINITY;
        self.greatest = greatest;
        let gap = if self.known { greatest } else { 0.0 };
        let back = turn(-gap) * posed.origin;
        self.centre = back * posed.centre - posed.problem.free_off;
        self.direction = -back * posed.turned;
        self.axis = -back * posed.centre;
    }

    /// Whether a free point is ahead of the axis along the locked tooth, where a point that turns in approaches the
    /// tooth's centre line. `near` is the point in the tooth's frame, `seen` the tooth's direction.
    #[inline]
    pub fn is_ahead(&self, near: C, seen: C) -> bool {
        near.re < self.axis.re * seen.re + self.axis.im * seen.im
    }

    fn offer(
        &mut self,
        posed: &PosedFlanks,
        tightest_contacts: &mut TightestContacts,
        step: i64,
        candidate: CandidateContact,
    ) {
        if tightest_contacts.admits(candidate.gap) {
            tightest_contacts.offer(step, candidate);
            if tightest_contacts.greatest() > self.greatest {
                self.set(posed, tightest_contacts.greatest());
            }
        }
    }
}
