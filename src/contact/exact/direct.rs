//! The quick method for a pair that [`super::search_free_proof`] covers: the line of action, then the corners.
//!
//! At the greatest gap so far most corners are clear of the mate's metal. A table of lines shows that
//! ([`super::envelope`]); only the other corners are compared with the curves.

use super::candidate::CandidateContact;
use super::corner::{least_flank_radius, meet, nearest_turn, on_land, tip_arm};
use super::envelope::Envelope;
use super::flank_problem::{FlankProblem, PosedFlanks};
use super::lands::{offer_lands, without_lands};
use super::line::TangentVariation;
use super::path::offer_pairs_on_line;
use super::placed::{PlacedHalf, Role};
use super::search::{self, SideFound, SideRequest};
use super::search_free_proof::{ProofInput, SearchFreeProof};
use super::shape::{C, turn};
use super::tangent::offer_land_tangents;
use super::tightest::TightestContacts;
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
    /// The envelopes of both gears of `assembly`, whose flanks are those of `problem`, wider by `room` mm.
    pub fn new(problem: &FlankProblem, assembly: &GearPair, room: f64) -> Envelopes {
        let [locked, free] =
            [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        // A tie below the greatest gap must not be ruled out: the points of both gears move by less than this.
        // Leaning axes shift the outlines of a section.
        let shift = assembly.shift_bound();
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
pub(super) fn first_contact(
    posed: &PosedFlanks,
    solver: Option<&DirectSolver>,
    request: SideRequest,
) -> SideFound {
    let Some(solver) = solver else {
        return search::first_contact(posed, request);
    };
    let mut tightest_contacts = TightestContacts::new(posed.problem);
    if !offer_pairs_on_line(posed, &solver.variation, &mut tightest_contacts) {
        return search::first_contact(posed, request);
    }
    let proof = &solver.proof;
    if proof.tangents {
        offer_land_tangents(posed, solver.free_off > 0.0, &mut tightest_contacts);
    }
    CornerSearch {
        posed,
        solver,
        gears: AtRotation::at(posed, tightest_contacts.greatest()),
        tightest_contacts: &mut tightest_contacts,
    }
    .run();
    if proof.is_direct() {
        return Ok(tightest_contacts.choose());
    }
    if !proof.open.is_empty() {
        offer_lands(posed, proof.open, &mut tightest_contacts);
    }
    let rest = without_lands(proof.open);
    let curves = |locked: &PlacedHalf| {
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
    /// The solver for `modified`, whose profiles may deviate from those of `problem` and `assembly`. `None` if the pair must be searched
    /// throughout, as any with flanks other than involutes.
    pub fn new(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
        modified: &FlankProblem,
    ) -> Option<DirectSolver> {
        DirectSolver::with_offs(problem, assembly, envelopes, modified, [0.0; 2])
    }

    /// The solver for all sections of leaning axes, whose outlines stand further off their axes than those of `problem`.
    pub fn over_leans(
        problem: &FlankProblem,
        assembly: &GearPair,
        envelopes: Envelopes,
    ) -> Option<DirectSolver> {
        let shift = assembly.shift_bound();
        let [from, to] = assembly.face();
        let wobble = assembly.gear(assembly.free()).wobble() * from.abs().max(to.abs());
        DirectSolver::with_offs(problem, assembly, envelopes, problem, [shift, wobble])
    }

    /// As [`DirectSolver::new`], with outlines up to `more` mm further off their axes.
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
        let setting = ProofInput {
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
    fn is_steep(&self, locked: &PlacedHalf, arm: f64) -> bool {
        tip_arm(locked) <= arm && least_flank_radius(locked) <= self.outmost
    }
}

/// Squared radius of the far corner of the locked land at `place` if a free tip land can have that radius, mm².
#[inline]
pub(super) fn far_corner_reaches(
    posed: &PosedFlanks,
    solver: &DirectSolver,
    place: usize,
) -> Option<f64> {
    let (square, free_tip) = far_corner_square(posed, place);
    // |ρ² − r²| ≤ e (2r + e) on a circle that is e off its axis.
    let off = (square - free_tip * free_tip).abs();
    (off <= solver.free_off * (2.0 * free_tip + solver.free_off)).then_some(square)
}

/// Whether [`far_corner_reaches`] can hold in a section whose corners move by up to `moved`, mm.
pub(super) fn far_corner_may_reach(
    posed: &PosedFlanks,
    solver: &DirectSolver,
    step: i64,
    moved: f64,
) -> bool {
    let (square, free_tip) = far_corner_square(posed, posed.places(step).0);
    let off = solver.free_off + moved;
    let beyond = square - free_tip * free_tip;
    solver.free_off > 0.0 && beyond.abs() <= off * (2.0 * free_tip + off)
}

/// Squared radius of the far corner of the locked land at `place`, mm², and the free tip radius, mm.
#[inline]
fn far_corner_square(posed: &PosedFlanks, place: usize) -> (f64, f64) {
    let half = posed.problem.locked.half(place);
    let corner = posed.centre - posed.turned * half.direction * half.far;
    (corner.norm_sqr(), posed.problem.free.shape.tip_radius)
}

/// Offers every corner whose gap can exceed the greatest so far: tip corners and undercut joints.
///
/// `R` is the free gear's rotation at the greatest gap so far; `C_F` and `D_F` hold at rotation 0. A locked point
/// `C_L + D_L p` is at `(R* (C_L + D_L p) − C_F) D_F*` in the free tooth's own frame. A free point is at `(R (C_F +
/// D_F p) − C_L) D_L*` in the locked tooth's.
struct CornerSearch<'a, 'p> {
    posed: &'a PosedFlanks<'p>,
    solver: &'a DirectSolver,
    /// Both gears at the greatest gap so far.
    gears: AtRotation,
    tightest_contacts: &'a mut TightestContacts,
}

impl CornerSearch<'_, '_> {
    fn run(mut self) {
        let (posed, solver) = (self.posed, self.solver);
        let (locked_teeth, free_teeth) = (&posed.problem.locked, &posed.problem.free);
        let steps = posed.steps();
        // The pair at the line of centres first: its contact leaves the others clear.
        let middle = steps.contains(&0).then_some(0);
        for step in middle.into_iter().chain(steps.filter(|&step| step != 0)) {
            let (locked_place, free_place) = posed.places(step);
            let toward = free_teeth.half(free_place).direction;
            let locked_half = locked_teeth.half(locked_place);
            let seen = self.gears.direction * locked_half.direction;
            let (centre, known) = (self.gears.centre, self.gears.known);
            for &corner in locked_teeth.shape.corners() {
                let near = (centre + seen * corner.1) * toward.conj();
                if !(known && solver.envelopes.free.clears(near)) {
                    let edge = (ProfilePart::Involute, corner.0);
                    self.locked_corner(step, edge, corner.1, near);
                }
            }
            if solver.proof.tangents {
                let far = locked_half.far;
                let near = (centre + seen * far) * toward.conj();
                if !(known && solver.envelopes.free.clears(near)) {
                    self.locked_corner(step, (ProfilePart::Tip, -far.arg()), far, near);
                }
            }
            // A land that is not exactly round about its axis can pass the near corner and touch the far one.
            if solver.free_off > 0.0 {
                self.far_corner(step, locked_place);
            }
            for &corner in free_teeth.shape.corners() {
                let near = (toward * corner.1 - centre) * seen.conj();
                let is_clear = known
                    && self.gears.is_ahead(near, seen)
                    && solver.envelopes.locked.clears(near);
                if !is_clear || solver.proof.turns_back {
                    self.free_corner(step, corner, near, is_clear);
                }
            }
        }
    }

    /// Examines a corner of the locked gear that the envelope does not show clear.
    #[cold]
    fn locked_corner(&mut self, step: i64, edge: (ProfilePart, f64), corner: C, near: C) {
        let solver = self.solver;
        let (locked, free) = (self.posed.locked(step), self.posed.free(step));
        let rho = locked.own_to_axis(corner);
        if self.gears.known && solver.envelopes.free.is_beyond_tip(near) && rho > solver.outmost {
            return;
        }
        if let Some(met) = meet(&free, Role::Free, solver.proof.free_fillet, rho, near) {
            self.offer(step, (&locked, edge), (&free, met));
        }
    }

    /// Examines the far corner of a locked land against the free tip land at its radius.
    ///
    /// In all other cases the near corners, or a search, have the greatest gap ([`super::search_free_proof`]).
    #[inline]
    fn far_corner(&mut self, step: i64, place: usize) {
        let Some(square) = far_corner_reaches(self.posed, self.solver, place) else {
            return;
        };
        let (locked, free) = (self.posed.locked(step), self.posed.free(step));
        let tip = ProfilePart::Tip;
        if let Some(met) = on_land(&free, tip, square.sqrt()) {
            self.offer(
                step,
                (&locked, (tip, locked.range(tip).0)),
                (&free, (tip, met)),
            );
        }
    }

    /// Examines a corner of the free gear that the envelope does not reliably show clear.
    #[cold]
    fn free_corner(&mut self, step: i64, (roll, corner): (f64, C), near: C, is_clear: bool) {
        let (solver, proof) = (self.solver, &self.solver.proof);
        let (locked, free) = (self.posed.locked(step), self.posed.free(step));
        let rho = free.own_to_axis(corner);
        // A flank that turns back can hide a clear point behind it, if the point came that near.
        let behind = proof.turns_back && tip_arm(&locked) <= 0.0 && rho >= nearest_turn(&locked);
        let trusted = self.gears.known && !behind;
        let over =
            || solver.envelopes.locked.is_beyond_tip(near) && rho < locked.least_land_radius();
        if trusted && (is_clear || over()) {
            return;
        }
        if let Some(met) = meet(&locked, Role::Locked, proof.locked_fillet, rho, near) {
            self.offer(step, (&locked, met), (&free, (ProfilePart::Involute, roll)));
        }
    }

    fn offer(
        &mut self,
        step: i64,
        locked: (&PlacedHalf, (ProfilePart, f64)),
        free: (&PlacedHalf, (ProfilePart, f64)),
    ) {
        let candidate = CandidateContact::new(locked, free, self.posed.origin_of(step), 0.0);
        if self.tightest_contacts.admits(candidate.gap) {
            self.tightest_contacts.offer(step, candidate);
            if self.tightest_contacts.greatest() > self.gears.greatest {
                self.gears = AtRotation::at(self.posed, self.tightest_contacts.greatest());
            }
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
        let known = greatest > f64::NEG_INFINITY;
        let back = turn(if known { -greatest } else { 0.0 }) * posed.origin;
        AtRotation {
            greatest,
            known,
            centre: back * posed.centre - posed.problem.free_off,
            direction: -back * posed.turned,
            axis: -back * posed.centre,
        }
    }

    /// Whether a free point is ahead of the axis along the locked tooth, where a point that turns in approaches the
    /// tooth's centre line. `near` is the point in the tooth's frame, `seen` the tooth's direction.
    #[inline]
    pub fn is_ahead(&self, near: C, seen: C) -> bool {
        near.re < self.axis.re * seen.re + self.axis.im * seen.im
    }
}
