//! Proves a pose that another method found, by directions that keep all teeth in reach apart.
//!
//! A contact at the rotation `μ` is proven from two sides.
//!
//! 1. The free gear is opened to `μ + δ`. Each part of each pair of teeth in reach must be proven off the other tooth: by a direction
//!    ([`super::facing_halves`]), by the tangents of a hollow curve ([`super::hollow`]), or as out of reach. Then nothing touches from there to
//!    the middle between both contacts. If the pair interferes, nothing touches as far as the free gear can turn.
//! 2. The free gear is closed to `μ − δ`. A point must be in the metal of both touching teeth.
//!
//! The rounding of a room is `margin = 8 ε (a + r_aL + r_aF)`, mm. With `δ = error + 3 margin/arm` the touching pair is separated by its own
//! normal.
//!
//! The locked tooth counts with both its flanks, because a free gear of few teeth can close against the far one.
//!
//! Three kinds of pose are not proven here: with flanks other than involutes, with contact on a fillet that bulges, and with root lands in
//! reach of each other.

use super::convex::{Convex, Support, along};
use super::facing_halves::{Apart, FacingHalves};
use super::facing_pair::{EndsAlong, FacingPair};
use super::hollow::{Hollow, is_beyond, is_off_both, is_off_chord, is_off_hollow, out_of_locked};
use super::proof::{Piece, Proof, Separation, SideProof, TouchProof};
use crate::contact::Effort;
use crate::contact::exact::{
    ExactKernel, FlankProblem, HalfToothShape, PlacedHalf, PosedFlanks, Section, reduced,
};
use crate::contact::gap::{C, PlacedCurve, turn};
use crate::contact::lost_motion::{Contact, LostMotion, ToothPlace};
use crate::gear::{AsBuilt, ProfilePart, Side};
use crate::numeric::bisect;
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{Point2, Vector2};
use std::cell::Cell;
use std::iter;

/// Widest error bound of a contact, as a part of a pitch, that is proven. A wider one could be that of another pair of teeth.
const NARROW: f64 = 1e-2;

/// Number of directions per unit of effort.
const DIRECTIONS_A_UNIT: u32 = 8;

/// Factor by which the free gear is closed further at contacts of lands.
const THIN: f64 = 16.0;

/// The reason why a pose is not proven here; it may still be right.
type NotProven = &'static str;

/// Proves poses of one assembly.
#[derive(Debug, Clone)]
pub struct Prover {
    kernel: ExactKernel,
    /// The fillets of the locked and the free gear, if the mate reaches them.
    hollows: [Option<Hollow>; 2],
    /// The fillet of the locked teeth's far halves, if the mate reaches it.
    far_hollow: Option<Hollow>,
    /// Whether the mate's top reaches the root land, and whether its fillet does.
    roots: [bool; 2],
    deep_roots: [bool; 2],
    /// Least distance of the locked outline's centre from the free axis at which no root lands meet, mm.
    roots_meet: f64,
    /// Whether both fillets reach each other.
    fillets_meet: bool,
    /// The reason why no pose of the assembly is proven here.
    beyond: Option<NotProven>,
    /// Rounding of a room, mm.
    margin: f64,
    /// Angular pitch of the free gear, rad.
    pitch: f64,
    /// Greatest radius of the free gear about its axis, mm.
    radius: f64,
}

/// A contact to be proven, in the frame of [`crate::contact::exact`].
#[derive(Debug, Clone, Copy)]
struct ContactToProve {
    /// `μ`, rad.
    rotation: f64,
    /// `δ`, rad, to the open and to the closed side.
    opening: f64,
    closing: f64,
    /// Number of tips that touch.
    tips: usize,
    point: C,
    /// Points out of the locked metal.
    normal: C,
    /// Arm about the free gear's axis, mm.
    arm: f64,
    /// Tooth numbers, the locked gear's first.
    teeth: [u32; 2],
    /// From the contact to the middle between both contacts, rad; infinite without room between them.
    play: f64,
}

impl Prover {
    /// The prover of `assembly`; `kernel` is its kernel.
    pub fn new(assembly: &GearPair, kernel: &ExactKernel) -> Prover {
        let problem = kernel.plane().side(Side::Right);
        let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let distance = assembly.center_distance();
        let tips = gears.map(|gear| gear.gear().tip_radius());
        let forms = shapes.map(|shape| shape.form_radius());
        let rooted = shapes.map(|shape| shape.root_radius);
        // Less by a rounding: a part that is nearly reached is also examined.
        let off = gears[0].eccentricity() + gears[1].eccentricity() + assembly.shift_bound();
        let nearest = distance * (1.0 - 1e-9) - off;
        let is_reached = [0, 1].map(|k| {
            let (low, high) = shapes[k].range(ProfilePart::Fillet);
            nearest - tips[1 - k] < forms[k] && high > low
        });
        let hollow = |k: usize, mirrored| {
            let fillet = shapes[k].part(ProfilePart::Fillet);
            is_reached[k].then(|| Hollow::new(fillet, shapes[k].pitch_radius, mirrored))
        };
        let is_modified = gears.into_iter().any(AsBuilt::is_modified);
        let beyond = is_modified.then_some("a flank is no involute");
        Prover {
            kernel: kernel.clone(),
            roots: [0, 1].map(|k| nearest - tips[1 - k] < rooted[k]),
            deep_roots: [0, 1].map(|k| rooted[k] + forms[1 - k] > nearest),
            roots_meet: rooted[0] + rooted[1] + gears[1].eccentricity(),
            fillets_meet: forms[0] + forms[1] > nearest,
            hollows: [0, 1].map(|k| hollow(k, false)),
            far_hollow: hollow(0, true),
            beyond,
            margin: 8.0 * f64::EPSILON * (distance + tips[0] + tips[1]),
            pitch: gears[1].gear().basic_data().angular_pitch(),
            radius: gears[1].reach(),
        }
    }

    /// Proves both contacts of `found` at `pose`.
    ///
    /// # Errors
    /// The reason why it is not proven here; it may still be right.
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), &'static str> {
        self.check_within(pose, found, &Effort::of_pose())
    }

    /// As [`Prover::check`], within the `effort` of this pose.
    pub(in crate::contact) fn check_within(
        &self,
        pose: &Pose,
        found: &LostMotion,
        effort: &Effort,
    ) -> Result<(), NotProven> {
        // Teeth in the mate's body prove the jam by themselves.
        if found.solid {
            return Ok(());
        }
        self.over(pose, found, |section, here, b| {
            for (side, contact) in contacts(found) {
                let (posed, tried) = (section.posed(section.side(side), here), Cell::new(0));
                let mut proving = SideProver::new(self, &posed, section.free(), found, &tried);
                let proven = proving.side(pose, here, contact, b);
                effort.spend(u64::from(tried.get() / DIRECTIONS_A_UNIT) + 1);
                proven?;
            }
            Ok(())
        })
    }

    /// The proof of both contacts of `found` at `pose`.
    ///
    /// # Errors
    /// The reason why it is not proven here; it may still be right.
    pub fn proof(&self, pose: &Pose, found: &LostMotion) -> Result<Proof, &'static str> {
        let mut sides = Vec::new();
        self.over(pose, found, |section, here, b| {
            for (side, contact) in contacts(found) {
                let (posed, tried) = (section.posed(section.side(side), here), Cell::new(0));
                let mut proving = SideProver::new(self, &posed, section.free(), found, &tried);
                proving.apart = Some(Vec::new());
                let proven = proving.side(pose, here, contact, b)?;
                let held = proven.map(|(held, _)| held);
                sides.push(SideProof {
                    side,
                    section: b,
                    open: held.map(|held| proving.turned(held.rotation + held.opening)),
                    until: held
                        .filter(|held| held.play.is_finite())
                        .map(|held| proving.turned(held.rotation + held.play)),
                    touch: proven.and_then(|(held, touch)| {
                        let (step, point) = touch?;
                        let [locked_tooth, free_tooth] = posed.numbers(step);
                        let point = proving.in_other_frame(point);
                        Some(TouchProof {
                            closed: proving.turned(held.rotation - held.closing),
                            locked_tooth,
                            free_tooth,
                            point: Point2::new(point.re, point.im),
                        })
                    }),
                    apart: proving.apart.unwrap_or_default(),
                });
            }
            Ok(())
        })?;
        Ok(Proof { sides })
    }

    /// Calls `each` for every section in which the contacts of `found` are proven, with the pose there and its place along the face, mm.
    fn over(
        &self,
        pose: &Pose,
        found: &LostMotion,
        each: impl FnMut(&Section, &Pose, f64) -> Result<(), NotProven>,
    ) -> Result<(), NotProven> {
        if let Some(reason) = self.beyond {
            return Err(reason);
        }
        let touching = contacts(found).filter_map(|(_, contact)| Some(contact?.section));
        self.kernel.each_section(pose, touching, each)
    }
}

fn contacts(found: &LostMotion) -> impl Iterator<Item = (Side, Option<&Contact>)> {
    let contacts = [found.right.as_ref(), found.left.as_ref()];
    [Side::Right, Side::Left].into_iter().zip(contacts)
}

/// The proof of one side of one section in progress.
struct SideProver<'a> {
    prover: &'a Prover,
    posed: &'a PosedFlanks<'a>,
    free: Member,
    /// As [`ContactToProve::play`].
    play: f64,
    /// Directions examined so far.
    tried: &'a Cell<u32>,
    /// The separations found, if the proof is to be returned.
    apart: Option<Vec<Separation>>,
}

/// The separation of the tops of a pair.
struct TopSeparation {
    apart: Apart,
    /// Its direction, rad, and the supports of both tops in it.
    nu: f64,
    supports: [Support; 2],
}

/// The tops of a pair as pieces.
const TOPS: [Piece; 2] = [Piece::Tooth, Piece::Top];

impl<'a> SideProver<'a> {
    fn new(
        prover: &'a Prover,
        posed: &'a PosedFlanks<'a>,
        free: Member,
        found: &LostMotion,
        tried: &'a Cell<u32>,
    ) -> SideProver<'a> {
        let angle = found.angle().filter(|angle| *angle > 0.0);
        SideProver {
            prover,
            posed,
            free,
            // Slightly past the middle, so that both sides together cover the whole play.
            play: angle.map_or(f64::INFINITY, |angle| 0.5 * angle * (1.0 + 1e-9)),
            tried,
            apart: None,
        }
    }

    fn problem(&self) -> &'a FlankProblem {
        self.posed.problem
    }

    /// Proves the side at `here`, the pose that `pose` is in the section at `b`, mm. Returns the contact, and the step and the point of two
    /// teeth that touch, if these do in this section.
    fn side(
        &mut self,
        pose: &Pose,
        here: &Pose,
        contact: Option<&Contact>,
        b: f64,
    ) -> Result<Option<(ContactToProve, Option<CommonPoint>)>, NotProven> {
        if self.posed.centre.norm() * (1.0 - 1e-9) < self.prover.roots_meet {
            return Err("root lands reach each other");
        }
        let Some(contact) = contact else {
            return self.prove_no_contact().map(|()| None);
        };
        let onward = here.free_rotation() - pose.free_rotation();
        let held = self.contact_to_prove(contact, onward)?;
        let touch = if contact.section == b {
            let touch = self.common_point(&held);
            Some(touch.ok_or("nothing is shown to touch")?)
        } else {
            None
        };
        self.prove_all_apart(&held).map(|()| Some((held, touch)))
    }

    /// `contact` in this frame; the free gear's nominal rotation is `onward` rad from that of the measuring plane.
    fn contact_to_prove(
        &self,
        contact: &Contact,
        onward: f64,
    ) -> Result<ContactToProve, NotProven> {
        let point = self.in_other_frame(C::new(contact.point.x, contact.point.y));
        let normal = -self.mirrored(C::new(contact.normal.x, contact.normal.y));
        let arm = -along(point, normal);
        let opening = contact.error + 3.0 * self.prover.margin / arm;
        if !(arm > 0.0 && opening < NARROW * self.prover.pitch) {
            return Err("the contact has next to no lever");
        }
        // The overlap of crossing lands is thin beside its length.
        let curves = [contact.wheel.curve, contact.pinion.curve];
        let is_thin =
            curves.iter().all(|curve| curve.is_land()) || curves.contains(&ToothPlace::Root);
        let closing = if is_thin { THIN * opening } else { opening };
        Ok(ContactToProve {
            rotation: self.turned(contact.rotation + onward),
            opening,
            closing,
            tips: curves
                .iter()
                .filter(|curve| **curve == ToothPlace::Tip)
                .count(),
            point,
            normal,
            arm,
            teeth: [self.free.mate(), self.free].map(|member| contact.touch(member).tooth),
            play: self.play,
        })
    }

    fn mirrored(&self, z: C) -> C {
        match self.problem().side {
            Side::Right => z,
            Side::Left => z.conj(),
        }
    }

    /// Converts a rotation of the free gear between this frame and the picture.
    fn turned(&self, rotation: f64) -> f64 {
        -self.problem().side.sense() * rotation
    }

    /// A point of this frame in the picture, or one of the picture in this frame.
    fn in_other_frame(&self, point: C) -> C {
        let point = self.mirrored(point);
        match self.free {
            Member::Pinion => C::from(self.problem().distance) - point,
            Member::Wheel => point,
        }
    }

    fn picture_normal(&self, n: C) -> Vector2<f64> {
        let n = self.mirrored(n);
        let n = match self.free {
            Member::Pinion => -n,
            Member::Wheel => n,
        };
        Vector2::new(n.re, n.im)
    }

    fn record(&mut self, step: i64, [locked, free]: [Piece; 2], apart: Apart) {
        if self.apart.is_none() {
            return;
        }
        let [locked_tooth, free_tooth] = self.posed.numbers(step);
        let separation = Separation {
            locked_tooth,
            free_tooth,
            locked,
            free,
            by: apart.by,
            normal: self.picture_normal(apart.normal),
        };
        self.apart.get_or_insert_default().push(separation);
    }

    /// The pair of a step at a rotation of the free gear; `turned` is `e^{i rotation}`.
    #[inline]
    fn pair(&self, step: i64, rotation: f64, turned: C) -> FacingPair<'a> {
        let placed = [self.posed.locked(step), self.posed.free(step)];
        let [on_locked, on_free] = self.posed.angles(step);
        let [locked, free] = &placed;
        FacingPair {
            step,
            at: FacingHalves {
                centres: [locked.centre, turned * free.centre],
                angles: [on_locked, reduced(on_free + rotation)],
                directions: [locked.direction, turned * free.direction],
                play: self.play,
                radius: self.prover.radius,
                margin: self.prover.margin,
                tried: self.tried,
            },
            tops: [
                Convex::tooth(locked.shape, locked.far),
                Convex::top(free.shape, free.far),
            ],
            placed,
        }
    }

    /// Proves that every pair in reach is apart slightly more open than `held`.
    fn prove_all_apart(&mut self, held: &ContactToProve) -> Result<(), NotProven> {
        let rotation = held.rotation + held.opening;
        let turned = turn(rotation);
        let nu = held.normal.im.atan2(held.normal.re);
        for step in self.posed.steps_of_whole_teeth() {
            let pair = self.pair(step, rotation, turned);
            let tops = self.prove_tops_apart(&pair, (nu, held.normal))?;
            self.prove_fillets_apart(&pair, &tops)?;
            for owner in 0..2 {
                self.prove_root_apart(&pair, owner, tops.nu)?;
            }
            if pair.at.is_spent() {
                return Err("too many directions were tried");
            }
        }
        Ok(())
    }

    /// Proves that the tops of a pair are apart, first by the direction `n = e^{iν}`.
    fn prove_tops_apart(
        &mut self,
        pair: &FacingPair,
        (nu, n): (f64, C),
    ) -> Result<TopSeparation, NotProven> {
        let (at, [locked, free]) = (&pair.at, &pair.tops);
        at.count();
        let mut supports = at.supports(locked, free, nu, n);
        let here = at.room_of(&supports, n);
        let (mut apart, mut nu) = (Apart::along(n), nu);
        if !at.stays_apart(here.room, here.arm) {
            let found = at.find_separation(locked, free, nu);
            apart = found.ok_or("two teeth are not shown to be apart")?;
            nu = apart.normal.im.atan2(apart.normal.re);
            supports = at.supports(locked, free, nu, apart.normal);
        }
        self.record(pair.step, TOPS, apart);
        Ok(TopSeparation {
            apart,
            nu,
            supports,
        })
    }

    /// Proves that the fillets of a pair are apart from the mate: by the separation of the tops if it suffices, otherwise each by itself.
    fn prove_fillets_apart(
        &mut self,
        pair: &FacingPair,
        tops: &TopSeparation,
    ) -> Result<(), NotProven> {
        let &TopSeparation {
            apart,
            nu,
            supports,
        } = tops;
        let prover = self.prover;
        let [near, free] = &prover.hollows;
        if near.is_none() && free.is_none() {
            return Ok(());
        }
        let (at, [tooth, top]) = (&pair.at, &pair.tops);
        at.count();
        let along = EndsAlong::new(pair, apart, supports);
        let free_bound = free.as_ref().map(|free| (free, along.of_free(at, free)));
        let near = near.as_ref().map(|near| (near, false));
        let far = prover.far_hollow.as_ref().map(|far| (far, true));
        for (hollow, is_far) in near.into_iter().chain(far) {
            let named = if is_far {
                Piece::FarFillet
            } else {
                Piece::Fillet
            };
            let piece = named(hollow.whole.ends);
            let reach = along.of_locked(pair, hollow, is_far);
            let here = || if is_far { pair.far_at() } else { pair.at };
            if along.keeps_off(at, reach, along.top) {
                self.record(pair.step, [piece, Piece::Top], apart);
            } else {
                let mate = (Piece::Top, top, along.n);
                self.prove_fillet_apart(pair.step, &here(), (0, hollow), mate, named)?;
            }
            let Some((free, bound)) = free_bound.filter(|_| prover.fillets_meet) else {
                continue;
            };
            if along.keeps_off(at, reach, bound) {
                let pieces = [piece, Piece::Fillet(free.whole.ends)];
                self.record(pair.step, pieces, apart);
            } else {
                self.prove_both_apart(pair.step, &here(), ([hollow, free], nu), named)?;
            }
        }
        let Some((free, bound)) = free_bound else {
            return Ok(());
        };
        if along.keeps_off(at, along.tooth, bound) {
            let pieces = [Piece::Tooth, Piece::Fillet(free.whole.ends)];
            self.record(pair.step, pieces, apart);
            return Ok(());
        }
        let mate = (Piece::Tooth, tooth, along.n);
        self.prove_fillet_apart(pair.step, at, (1, free), mate, Piece::Fillet)
    }

    /// Proves that a fillet of gear `owner` is apart from a convex piece of the mate.
    fn prove_fillet_apart(
        &mut self,
        step: i64,
        at: &FacingHalves,
        (owner, hollow): (usize, &Hollow),
        (piece, mate, facing): (Piece, &Convex, C),
        named: fn([f64; 2]) -> Piece,
    ) -> Result<(), NotProven> {
        at.count();
        if is_off_chord(at, owner, &hollow.whole, mate) {
            let pieces = ordered(owner, named(hollow.whole.ends), piece);
            let n = out_of_locked(at, owner, hollow.whole.normal);
            self.record(step, pieces, Apart::along(n));
            return Ok(());
        }
        let mut record = |ends, proof| {
            self.record(step, ordered(owner, named(ends), piece), proof);
        };
        if is_off_hollow(at, (owner, hollow), (mate, facing), &mut record) {
            Ok(())
        } else {
            Err("a fillet is not shown to be apart from the mate")
        }
    }

    /// Proves that the root land of gear `owner` is apart from the parts of the mate that reach it.
    fn prove_root_apart(
        &mut self,
        pair: &FacingPair,
        owner: usize,
        nu: f64,
    ) -> Result<(), NotProven> {
        let land = self.prover.roots[owner].then(|| root_land(&pair.placed[owner]));
        let Some(land) = land.flatten() else {
            return Ok(());
        };
        let mate = &pair.tops[1 - owner];
        let (locked, free) = match owner {
            0 => (&land, mate),
            _ => (mate, &land),
        };
        // A tip may face the middle of the land, a right angle and more from the direction that keeps the tops apart.
        let (low, high) = pair.placed[owner].range(ProfilePart::Root);
        let across = out_of_locked(&pair.at, owner, turn(-0.5 * (low + high)));
        let apart = [nu, across.im.atan2(across.re)]
            .into_iter()
            .find_map(|start| pair.at.find_separation(locked, free, start));
        let apart = apart.ok_or("a root land is not shown to be apart from the mate's tip")?;
        let pieces = ordered(owner, Piece::Root, TOPS[1 - owner]);
        self.record(pair.step, pieces, apart);
        if self.prover.deep_roots[owner] {
            self.prove_fillets_off_root(pair, 1 - owner, (&land, nu))
        } else {
            Ok(())
        }
    }

    /// Proves that the fillets of gear `owner` are apart from the mate's root land.
    fn prove_fillets_off_root(
        &mut self,
        pair: &FacingPair,
        owner: usize,
        (land, nu): (&Convex, f64),
    ) -> Result<(), NotProven> {
        let (prover, step) = (self.prover, pair.step);
        let mate = (Piece::Root, land, turn(nu));
        if let Some(hollow) = &prover.hollows[owner] {
            self.prove_fillet_apart(step, &pair.at, (owner, hollow), mate, Piece::Fillet)?;
        }
        match &prover.far_hollow {
            Some(hollow) if owner == 0 => {
                let at = pair.far_at();
                self.prove_fillet_apart(step, &at, (0, hollow), mate, Piece::FarFillet)
            }
            _ => Ok(()),
        }
    }

    /// Proves that a fillet of the locked tooth and one of the free tooth are apart.
    fn prove_both_apart(
        &mut self,
        step: i64,
        at: &FacingHalves,
        hollows: ([&Hollow; 2], f64),
        named: fn([f64; 2]) -> Piece,
    ) -> Result<(), NotProven> {
        let mut record = |[locked, free]: [[f64; 2]; 2], proof| {
            self.record(step, [named(locked), Piece::Fillet(free)], proof);
        };
        if is_off_both(at, hollows, &mut record) {
            Ok(())
        } else {
            Err("two fillets are not shown to be apart")
        }
    }

    /// Proves that no pair of facing half teeth in reach touches at any rotation.
    fn prove_no_contact(&mut self) -> Result<(), NotProven> {
        for step in self.posed.steps() {
            let pair = self.pair(step, 0.0, C::ONE);
            let radius = pair.farthest_of_free();
            let [locked, _] = &pair.placed;
            let top = Convex::top(locked.shape, locked.far);
            self.beyond(&pair, Piece::Top, &top, radius)?;
            if let Some(hollow) = &self.prover.hollows[0] {
                let mut record = |ends, proof| {
                    self.record(step, [Piece::Fillet(ends), Piece::Top], proof);
                };
                if !is_beyond(&pair.at, hollow, radius, &mut record) {
                    return Err("a fillet is not shown to be out of reach");
                }
            }
            if let Some(land) = self.prover.roots[0]
                .then(|| root_land(&pair.placed[0]))
                .flatten()
            {
                self.beyond(&pair, Piece::Root, &land, radius)?;
            }
        }
        Ok(())
    }

    fn beyond(
        &mut self,
        pair: &FacingPair,
        piece: Piece,
        convex: &Convex,
        radius: f64,
    ) -> Result<(), NotProven> {
        let apart = pair.at.beyond(convex, radius);
        let apart = apart.ok_or("a tooth is not shown to be out of reach")?;
        self.record(pair.step, [piece, Piece::Top], apart);
        Ok(())
    }

    /// A point in the metal of two teeth, closed from `held`, and their step; `None` if none is found.
    ///
    /// Closed by `δ`, both outlines overlap by `arm δ` along the normal. Half as deep below the contact of one or the other there is metal
    /// of both: below either one, unless it is a corner beside which the mate's curve slides. The teeth of `held` may tie with others that
    /// touch before by more than its bound.
    fn common_point(&self, held: &ContactToProve) -> Option<CommonPoint> {
        let down = 0.5 * held.arm * held.closing;
        let deep = held.normal * down;
        let closed = held.rotation - held.closing;
        let turned = turn(closed);
        let is_common = |(step, point): &CommonPoint, margin: f64| {
            let (locked, free) = (self.posed.locked(*step), self.posed.free(*step));
            let in_locked =
                depth(&locked, *point, down) > margin || far_depth(&locked, *point) > margin;
            in_locked && depth(&free, point * turned.conj(), down) > margin
        };
        let named = (self.posed.steps_of_whole_teeth())
            .find(|step| held.teeth == self.posed.numbers(*step))?;
        // At the end of a root land the mate's flank may be along the radius: there it is deeper towards the centre.
        let (locked, free) = (self.posed.locked(named), self.posed.free(named));
        let centres = [locked.centre, turned * free.centre];
        let deeper = |point: C| {
            let towards = centres.map(|centre| (centre - point) / (centre - point).norm());
            towards.map(|towards| point + towards * (2.0 * down))
        };
        let below = [held.point - deep, held.point * turn(-held.closing) + deep];
        let near = below.map(|point| iter::once(point).chain(deeper(point)));
        // Straight below a tip corner the mate's outline may be along the way: beside it is metal of both.
        let aside = [1.0, -1.0].map(|side| C::i() * deep * side);
        let beside = below.map(|point| aside.map(|aside| point + aside));
        let beside = beside.into_iter().flatten().filter(|_| held.tips > 0);
        // Tips that hardly overlap share a thin lens between their circles, with the corner of the free or of the locked tip in it.
        let parts = [2.0, 1.2, 0.5, -1.0].into_iter().filter(|_| held.tips == 2);
        let lens = parts.map(|part| {
            let point = held.point * turn(-part * held.closing);
            let rooms = [0, 1].map(|k| {
                let tip = [&locked, &free][k].shape.tip_radius;
                tip - (point - centres[k]).norm()
            });
            let across = centres[1] - centres[0];
            point + across / across.norm() * (0.5 * (rooms[0] - rooms[1]))
        });
        let mut tied = self.posed.steps_of_whole_teeth().filter_map(|step| {
            let FacingPair { at, tops, .. } = self.pair(step, closed, turned);
            Some((step, at.middle(&tops, held.normal, 4.0 * down)?))
        });
        // A point's own rounding is at most half of that of a room.
        let margin = self.prover.margin;
        let near = near.into_iter().flatten().chain(lens).chain(beside);
        let mut near = near.map(|point| (named, point));
        near.find(|found| is_common(found, 0.5 * margin))
            .or_else(|| tied.find(|found| is_common(found, margin)))
    }
}

/// The step of two teeth, and a point in the metal of both.
type CommonPoint = (i64, C);

/// Pieces of the locked and the free tooth: `piece` belongs to gear `owner`, `other` to its mate.
fn ordered(owner: usize, piece: Piece, other: Piece) -> [Piece; 2] {
    match owner {
        0 => [piece, other],
        _ => [other, piece],
    }
}

/// The root land as a piece of its half tooth.
fn root_land(half: &PlacedHalf) -> Option<Convex<'static>> {
    let (low, high) = half.range(ProfilePart::Root);
    (high > low).then(|| Convex::arc(half.shape.root_radius, -high, -low))
}

/// Depth of a point in the metal of a half tooth, between its outline and the far corner of its tip land, mm along circles about its
/// centre; at most 0 outside. Inside the root circle it reaches `beyond` mm past the middle of the space, where the gear is solid.
fn depth(half: &PlacedHalf, point: C, beyond: f64) -> f64 {
    depth_of((point - half.centre) * half.direction.conj(), half, beyond)
}

/// Depth of a point in the metal of the tooth's other half, mm.
fn far_depth(half: &PlacedHalf, point: C) -> f64 {
    let direction = half.far_direction();
    depth_of(((point - half.centre) * direction.conj()).conj(), half, 0.0)
}

/// [`depth`] of a point in the half tooth's own frame.
fn depth_of(own: C, half: &PlacedHalf, beyond: f64) -> f64 {
    let shape = half.shape;
    let radius = own.norm();
    let angle = own.im.atan2(own.re);
    let before_far = half.far.arg() - angle;
    if radius <= shape.root_radius {
        let within = (angle + half.root_end).min(before_far) * radius + beyond;
        return (shape.root_radius - radius).min(within);
    }
    let below_tip = shape.tip_radius - radius;
    if below_tip <= 0.0 {
        return below_tip;
    }
    let flank = if radius >= shape.form_radius() {
        let roll = ((radius - shape.base) * (radius + shape.base))
            .max(0.0)
            .sqrt()
            / shape.base;
        roll - roll.atan() - shape.half_base
    } else {
        fillet_angle(shape, radius)
    };
    below_tip.min((angle - flank).min(before_far) * radius)
}

/// Polar angle of the fillet at a radius; it rises with the parameter.
fn fillet_angle(shape: &HalfToothShape, radius: f64) -> f64 {
    let (mut low, mut high) = shape.range(ProfilePart::Fillet);
    let own = PlacedCurve {
        curve: shape.curve(ProfilePart::Fillet),
        mirrored: false,
        centre: C::ZERO,
        direction: C::ONE,
    };
    // Newton's method leaves a few units in the last place to bisection.
    let near = own.invert(radius, [low, high], high);
    for end in [-4.0, 4.0].map(|by| near + by * f64::EPSILON * near.abs()) {
        if end > low && end < high && shape.radius(ProfilePart::Fillet, end) < radius {
            low = end;
        } else if end > low && end < high {
            high = end;
        }
    }
    let is_below = |t: f64| shape.radius(ProfilePart::Fillet, t) < radius;
    let finest = f64::EPSILON * f64::EPSILON * (high - low);
    let [low, high] = bisect(low, high, finest, is_below);
    // Both ends of the last bracket are on the fillet; the greater angle is on the safe side.
    let angle = |t: f64| shape.at(ProfilePart::Fillet, t).point.arg();
    angle(low).max(angle(high))
}

#[cfg(test)]
mod tests;
