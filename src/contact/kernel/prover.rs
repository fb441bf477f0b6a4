//! Proves a pose that another method found: by directions that keep all pairs of half teeth apart.
//!
//! A contact at the rotation `μ` is proven from two sides. Opened by its error and by rounding, to `μ + δ`, every part of every half tooth in reach
//! is kept off the mate's by a direction with a positive arm ([`super::at`]), by a hollow curve's own tangents ([`super::hollow`]), or is out of
//! reach: so nothing touches at `μ + δ` or farther on. Closed by as much, a point lies in the metal of both teeth of the pair that is said to
//! touch: so something touches at `μ − δ` or farther on. With `need = 8 ε (a + r_aL + r_aF)`, the rounding of a room in mm,
//! `δ = error + 3 need/arm`: the pair that touches passes by its own normal.
//!
//! Not proven here are gears whose flanks are no involutes, contacts on fillets that bulge, root lands that reach each other, and teeth that may
//! meet the mate's far flank.

use super::at::{Apart, At};
use super::convex::{Convex, along};
use super::hollow::{Hollow, OffStretch};
use super::proof::{Piece, Proof, Reason, Separation, SideProof, TouchProof};
use crate::contact::Effort;
use crate::contact::exact::{
    ExactKernel, FlankProblem, HalfToothShape, Placed, PosedFlanks, Section, reduced,
};
use crate::contact::gap::{C, turn};
use crate::contact::lost_motion::{Contact, LostMotion, ToothPlace};
use crate::gear::{ProfilePart, Side};
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{Point2, Vector2};

/// A bound wider than this part of a pitch says nothing about one pair of teeth.
const NARROW: f64 = 1e-2;

/// Directions looked at before a side is given up: ordinary ones take 15 to 60.
const MOST_LOOKS: u32 = 4000;

/// As many directions take the time of a unit of effort.
const LOOKS_A_UNIT: u32 = 8;

/// By so much wider contacts of lands are closed.
const THIN: f64 = 16.0;

/// Why a pose is not proven here; it may be right all the same.
type NotProven = &'static str;

/// Proves poses of one assembly.
#[derive(Debug, Clone)]
pub struct Prover<'a> {
    assembly: &'a GearPair,
    kernel: ExactKernel,
    /// Of the locked and the free gear: the fillet, where the mate reaches it.
    hollows: [Option<Hollow>; 2],
    /// Whether the mate's top reaches the root land, and whether its fillet does.
    roots: [bool; 2],
    deep_roots: [bool; 2],
    /// Whether both fillets reach each other.
    fillets_meet: bool,
    /// Why no pose of the assembly is proven here.
    beyond: Option<NotProven>,
    /// Rounding of a room, mm.
    need: f64,
    /// Angular pitch of the free gear, rad.
    pitch: f64,
}

/// A contact in the frame of [`crate::contact::exact`].
#[derive(Debug, Clone, Copy)]
struct Held {
    /// `μ`, rad.
    rotation: f64,
    /// `δ`, rad, to the open and to the closed side.
    opening: f64,
    closing: f64,

    point: C,
    /// Out of the locked metal.
    normal: C,
    /// Of the free gear, mm.
    arm: f64,
    /// Tooth numbers, the locked gear's first.
    teeth: [u32; 2],
}

impl<'a> Prover<'a> {
    /// The prover of `assembly`, whose kernel is `kernel`.
    pub fn new(assembly: &'a GearPair, kernel: &ExactKernel) -> Prover<'a> {
        let problem = kernel.plane().side(Side::Right);
        let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let shapes = [&problem.locked.shape, &problem.free.shape];
        let distance = assembly.center_distance();
        let tips = gears.map(|gear| gear.gear().tip_radius());
        let forms = shapes.map(HalfToothShape::form_radius);
        let rooted = shapes.map(|shape| shape.root_radius);
        // Less by a rounding: what is nearly reached is looked at.
        let off = gears[0].eccentricity() + gears[1].eccentricity();
        let nearest = distance * (1.0 - 1e-9) - off;
        let is_reached = [0, 1].map(|k| {
            let (low, high) = shapes[k].range(ProfilePart::Fillet);
            nearest - tips[1 - k] < forms[k] && high > low
        });
        let hollows = [0, 1].map(|k| {
            let fillet = shapes[k].part(ProfilePart::Fillet);
            is_reached[k].then(|| Hollow::new(fillet, shapes[k].pitch_radius))
        });
        let is_other = |k: usize| !gears[k].is_generated() || gears[k].is_modified();
        let beyond = if (0..2).any(is_other) {
            Some("a flank is no involute")
        } else if rooted[0] + rooted[1] > nearest {
            Some("root lands reach each other")
        } else if kernel.plane().meets_far_flanks() {
            Some("a tooth may meet the mate's far flank")
        } else {
            None
        };
        Prover {
            assembly,
            kernel: kernel.clone(),
            roots: [0, 1].map(|k| nearest - tips[1 - k] < rooted[k]),
            deep_roots: [0, 1].map(|k| rooted[k] + forms[1 - k] > nearest),
            fillets_meet: forms[0] + forms[1] > nearest,
            hollows,
            beyond,
            need: 8.0 * f64::EPSILON * (distance + tips[0] + tips[1]),
            pitch: gears[1].gear().basic_data().angular_pitch(),
        }
    }

    /// Proves both contacts of `found` at `pose`.
    ///
    /// # Errors
    /// Why it is not proven here; it may be right all the same.
    pub fn check(&self, pose: &Pose, found: &LostMotion) -> Result<(), &'static str> {
        self.check_within(pose, found, &Effort::of_pose())
    }

    /// The same with what `effort` allows, that of this pose.
    pub(in crate::contact) fn check_within(
        &self,
        pose: &Pose,
        found: &LostMotion,
        effort: &Effort,
    ) -> Result<(), NotProven> {
        // Teeth in the mate's body prove it by themselves, whatever touches.
        if found.solid {
            return Ok(());
        }
        self.over(pose, found, |section, here, b| {
            for (side, contact) in contacts(found) {
                let posed = section.posed(section.side(side), here);
                let mut proving = Proving::new(self, &posed, section.free());
                let proven = proving.side(pose, here, contact, b);
                effort.spend(u64::from(proving.looks / LOOKS_A_UNIT) + 1);
                proven?;
            }
            Ok(())
        })
    }

    /// What proves both contacts of `found` at `pose`.
    ///
    /// # Errors
    /// Why it is not proven here; it may be right all the same.
    pub fn proof(&self, pose: &Pose, found: &LostMotion) -> Result<Proof, &'static str> {
        let mut sides = Vec::new();
        self.over(pose, found, |section, here, b| {
            for (side, contact) in contacts(found) {
                let posed = section.posed(section.side(side), here);
                let mut proving = Proving::new(self, &posed, section.free());
                proving.apart = Some(Vec::new());
                let held = proving.side(pose, here, contact, b)?;
                let contact = contact.filter(|contact| contact.section == b);
                sides.push(SideProof {
                    side,
                    section: b,
                    open: held.map(|held| proving.turned(held.rotation + held.opening)),
                    touch: held.zip(contact).and_then(|(held, _)| {
                        let [locked_tooth, free_tooth] = held.teeth;
                        let point = proving.common_point(&held)?;
                        Some(TouchProof {
                            closed: proving.turned(held.rotation - held.closing),
                            locked_tooth,
                            free_tooth,
                            point: proving.picture_point(point),
                        })
                    }),
                    apart: proving.apart.unwrap_or_default(),
                });
            }
            Ok(())
        })?;
        Ok(Proof { sides })
    }

    /// Calls `each` for every section that the contacts of `found` are proven in, with the pose there and its place along the face, mm.
    fn over(
        &self,
        pose: &Pose,
        found: &LostMotion,
        mut each: impl FnMut(&Section, &Pose, f64) -> Result<(), NotProven>,
    ) -> Result<(), NotProven> {
        if let Some(reason) = self.beyond {
            return Err(reason);
        }
        let (assembly, kernel) = (self.assembly, &self.kernel);
        let Some(sections) = kernel.sections_over_face() else {
            return each(kernel.plane(), pose, 0.0);
        };
        for (b, section) in sections {
            each(section, &pose.in_section(assembly, *b), *b)?;
        }
        let mut further: Vec<f64> = contacts(found)
            .filter_map(|(_, contact)| Some(contact?.section))
            .filter(|place| sections.iter().all(|(b, _)| b != place))
            .collect();
        further.dedup();
        for b in further {
            let section = kernel.plane().turned(&assembly.section(b));
            each(&section, &pose.in_section(assembly, b), b)?;
        }
        Ok(())
    }
}

fn contacts(found: &LostMotion) -> impl Iterator<Item = (Side, Option<&Contact>)> {
    let contacts = [found.right.as_ref(), found.left.as_ref()];
    [Side::Right, Side::Left].into_iter().zip(contacts)
}

/// One side of one section that is being proven.
struct Proving<'a> {
    prover: &'a Prover<'a>,
    posed: &'a PosedFlanks<'a>,
    free: Member,
    /// Directions looked at so far.
    looks: u32,
    /// What was proven, where that is asked for.
    apart: Option<Vec<Separation>>,
}

/// The half teeth of one step, and their tops.
struct Pair<'a> {
    step: i64,
    at: At,
    placed: [Placed<'a>; 2],
    tops: [Convex<'a>; 2],
}

impl<'a> Proving<'a> {
    fn new(prover: &'a Prover<'a>, posed: &'a PosedFlanks<'a>, free: Member) -> Proving<'a> {
        Proving {
            prover,
            posed,
            free,
            looks: 0,
            apart: None,
        }
    }

    fn problem(&self) -> &'a FlankProblem {
        self.posed.problem
    }

    /// Proves the side at `here`, the pose that `pose` is in the section at `b`, mm; returns the contact.
    fn side(
        &mut self,
        pose: &Pose,
        here: &Pose,
        contact: Option<&Contact>,
        b: f64,
    ) -> Result<Option<Held>, NotProven> {
        let Some(contact) = contact else {
            return self.nothing().map(|()| None);
        };
        let onward = here.free_rotation() - pose.free_rotation();
        let held = self.held(contact, onward)?;
        if contact.section == b && self.common_point(&held).is_none() {
            return Err("nothing is shown to touch");
        }
        self.all_apart(&held).map(|()| Some(held))
    }

    /// `contact` in this frame, the free gear's nominal rotation `onward` rad from that of the measuring plane.
    fn held(&self, contact: &Contact, onward: f64) -> Result<Held, NotProven> {
        let problem = self.problem();
        let point = C::new(contact.point.x, contact.point.y);
        let point = self.mirrored(match self.free {
            Member::Pinion => C::from(problem.distance) - point,
            Member::Wheel => point,
        });
        let normal = -self.mirrored(C::new(contact.normal.x, contact.normal.y));
        let arm = -along(point, normal);
        let opening = contact.error + 3.0 * self.prover.need / arm;
        if !(arm > 0.0 && opening < NARROW * self.prover.pitch) {
            return Err("the contact has next to no lever");
        }
        // Where lands cross, what overlaps is thin beside its length.
        let curves = [contact.wheel.curve, contact.pinion.curve];
        let is_thin =
            curves.iter().all(|curve| curve.is_land()) || curves.contains(&ToothPlace::Root);
        let closing = if is_thin { THIN * opening } else { opening };
        Ok(Held {
            rotation: self.turned(contact.rotation + onward),
            opening,
            closing,

            point,
            normal,
            arm,
            teeth: match self.free {
                Member::Pinion => [contact.wheel.tooth, contact.pinion.tooth],
                Member::Wheel => [contact.pinion.tooth, contact.wheel.tooth],
            },
        })
    }

    fn mirrored(&self, z: C) -> C {
        match self.problem().side {
            Side::Right => z,
            Side::Left => z.conj(),
        }
    }

    /// A rotation of the free gear in this frame as the picture counts it, and the other way round.
    fn turned(&self, rotation: f64) -> f64 {
        -self.problem().side.sense() * rotation
    }

    fn picture_point(&self, point: C) -> Point2<f64> {
        let point = self.mirrored(point);
        let point = match self.free {
            Member::Pinion => C::from(self.problem().distance) - point,
            Member::Wheel => point,
        };
        Point2::new(point.re, point.im)
    }

    fn picture_normal(&self, n: C) -> Vector2<f64> {
        let n = self.mirrored(n);
        let n = match self.free {
            Member::Pinion => -n,
            Member::Wheel => n,
        };
        Vector2::new(n.re, n.im)
    }

    fn tell(&mut self, step: i64, [locked, free]: [Piece; 2], by: Reason, n: C) {
        if self.apart.is_none() {
            return;
        }
        let (locked_place, free_place) = self.posed.places(step);
        let separation = Separation {
            locked_tooth: self.problem().locked.number(locked_place),
            free_tooth: self.problem().free.number(free_place),
            locked,
            free,
            by,
            normal: self.picture_normal(n),
        };
        self.apart.get_or_insert_default().push(separation);
    }

    fn tell_apart(&mut self, step: i64, pieces: [Piece; 2], apart: Apart) {
        match apart {
            Apart::Direction(n) => self.tell(step, pieces, Reason::Direction, n),
            Apart::OutOfReach(n) => self.tell(step, pieces, Reason::OutOfReach, n),
        }
    }

    fn tell_stretch(&mut self, step: i64, owner: usize, pieces: [Piece; 2], proof: OffStretch) {
        match (proof, owner) {
            (OffStretch::Apart(apart), _) => self.tell_apart(step, pieces, apart),
            (OffStretch::Tangents(n), 0) => self.tell(step, pieces, Reason::LockedTangents, n),
            (OffStretch::Tangents(n), _) => self.tell(step, pieces, Reason::FreeTangents, n),
        }
    }

    /// The pair of a step at a rotation of the free gear; `turned` is `e^{i rotation}`.
    #[inline]
    fn pair(&self, step: i64, rotation: f64, turned: C) -> Pair<'a> {
        let placed = [self.posed.locked(step), self.posed.free(step)];
        let [on_locked, on_free] = self.posed.angles(step);
        let [locked, free] = &placed;
        Pair {
            step,
            at: At {
                centres: [locked.centre, turned * free.centre],
                angles: [on_locked, reduced(on_free + rotation)],
                directions: [locked.direction, turned * free.direction],
            },
            tops: placed
                .each_ref()
                .map(|half| Convex::top(half.shape, half.far)),
            placed,
        }
    }

    /// Proves that every pair in reach is apart a little more open than `held`.
    fn all_apart(&mut self, held: &Held) -> Result<(), NotProven> {
        let rotation = held.rotation + held.opening;
        let turned = turn(rotation);
        let nu = held.normal.im.atan2(held.normal.re);
        for step in self.posed.steps() {
            let pair = self.pair(step, rotation, turned);
            self.tops_apart(&pair, (nu, held.normal))?;
            for owner in 0..2 {
                self.fillet_apart(&pair, owner, (Piece::Top, &pair.tops[1 - owner]))?;
                self.root_apart(&pair, owner, nu)?;
            }
            self.fillets_apart(&pair)?;
            if self.looks > MOST_LOOKS {
                return Err("too many directions were tried");
            }
        }
        Ok(())
    }

    fn tops_apart(&mut self, pair: &Pair, (nu, n): (f64, C)) -> Result<(), NotProven> {
        let (need, pieces) = (self.prover.need, [Piece::Top; 2]);
        let [locked, free] = &pair.tops;
        self.looks += 1;
        if pair.at.room(locked, free, nu, n).holds(need) {
            self.tell(pair.step, pieces, Reason::Direction, n);
            return Ok(());
        }
        let apart = pair.at.separated(locked, free, nu, need, &mut self.looks);
        let apart = apart.ok_or("two teeth are not shown to be apart")?;
        self.tell_apart(pair.step, pieces, apart);
        Ok(())
    }

    /// Proves that the fillet of gear `owner` is apart from a convex piece of the mate.
    fn fillet_apart(
        &mut self,
        pair: &Pair,
        owner: usize,
        (piece, mate): (Piece, &Convex),
    ) -> Result<(), NotProven> {
        let prover = self.prover;
        let Some(hollow) = &prover.hollows[owner] else {
            return Ok(());
        };
        let at = &pair.at;
        self.looks += 1;
        if at.is_off_chord(owner, &hollow.whole, mate, prover.need) {
            let pieces = ordered(owner, Piece::Fillet(hollow.whole.ends), piece);
            let n = at.out_of_locked(owner, hollow.whole.normal);
            self.tell(pair.step, pieces, Reason::Direction, n);
            return Ok(());
        }
        let mut looks = self.looks;
        let mut tell = |ends, proof| {
            let pieces = ordered(owner, Piece::Fillet(ends), piece);
            self.tell_stretch(pair.step, owner, pieces, proof);
        };
        let budget = (&mut looks, MOST_LOOKS);
        let is_off = at.is_off_hollow((owner, hollow), mate, prover.need, budget, &mut tell);
        self.looks = looks;
        match is_off {
            true => Ok(()),
            false => Err("a fillet is not shown to be apart from the mate"),
        }
    }

    /// Proves that the root land of gear `owner` is apart from what of the mate reaches it.
    fn root_apart(&mut self, pair: &Pair, owner: usize, nu: f64) -> Result<(), NotProven> {
        let land = self.prover.roots[owner].then(|| root_land(&pair.placed[owner]));
        let Some(land) = land.flatten() else {
            return Ok(());
        };
        let mate = &pair.tops[1 - owner];
        let (locked, free) = match owner {
            0 => (&land, mate),
            _ => (mate, &land),
        };
        let need = self.prover.need;
        let apart = pair.at.separated(locked, free, nu, need, &mut self.looks);
        let apart = apart.ok_or("a root land is not shown to be apart from the mate's tip")?;
        self.tell_apart(pair.step, ordered(owner, Piece::Root, Piece::Top), apart);
        match self.prover.deep_roots[owner] {
            true => self.fillet_apart(pair, 1 - owner, (Piece::Root, &land)),
            false => Ok(()),
        }
    }

    fn fillets_apart(&mut self, pair: &Pair) -> Result<(), NotProven> {
        let prover = self.prover;
        let [Some(locked), Some(free)] = &prover.hollows else {
            return Ok(());
        };
        if !prover.fillets_meet {
            return Ok(());
        }
        let mut looks = self.looks;
        let mut tell = |[locked, free]: [[f64; 2]; 2], owner, proof| {
            let pieces = [Piece::Fillet(locked), Piece::Fillet(free)];
            self.tell_stretch(pair.step, owner, pieces, proof);
        };
        let budget = (&mut looks, MOST_LOOKS);
        let is_off = pair
            .at
            .is_off_both([locked, free], prover.need, budget, &mut tell);
        self.looks = looks;
        match is_off {
            true => Ok(()),
            false => Err("two fillets are not shown to be apart"),
        }
    }

    /// Proves that no pair in reach touches at any rotation.
    fn nothing(&mut self) -> Result<(), NotProven> {
        for step in self.posed.steps() {
            let pair = self.pair(step, 0.0, C::ONE);
            let at = &pair.at;
            // All of the free tooth turns within its top's disc.
            let radius = pair.tops[1].farthest(at.centres[1] * at.directions[1].conj());
            self.beyond(&pair, Piece::Top, &pair.tops[0], radius)?;
            if let Some(hollow) = &self.prover.hollows[0] {
                let (need, mut looks) = (self.prover.need, self.looks);
                let budget = (&mut looks, MOST_LOOKS);
                let mut tell = |ends, n| {
                    let pieces = [Piece::Fillet(ends), Piece::Top];
                    self.tell(pair.step, pieces, Reason::OutOfReach, n);
                };
                let is_beyond = at.is_beyond(hollow, radius, need, budget, &mut tell);
                self.looks = looks;
                if !is_beyond {
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
        pair: &Pair,
        piece: Piece,
        convex: &Convex,
        radius: f64,
    ) -> Result<(), NotProven> {
        let n = pair
            .at
            .beyond(convex, radius, self.prover.need, &mut self.looks);
        let n = n.ok_or("a tooth is not shown to be out of reach")?;
        self.tell(pair.step, [piece, Piece::Top], Reason::OutOfReach, n);
        Ok(())
    }

    /// A point that lies in the metal of both teeth that touch, closed from `held`; `None` where none is found.
    ///
    /// Closed by `δ`, both outlines overlap by `arm δ` along the normal. Half as deep below the contact of the one or of the other there is metal of
    /// both: of either one, unless that is its corner, beside which the mate's slides.
    fn common_point(&self, held: &Held) -> Option<C> {
        let step = self.posed.steps().find(|step| {
            let (locked, free) = self.posed.places(*step);
            let problem = self.problem();
            held.teeth == [problem.locked.number(locked), problem.free.number(free)]
        })?;
        let (locked, free) = (self.posed.locked(step), self.posed.free(step));
        // A point's own rounding is a quarter of that of a room.
        let need = 0.25 * self.prover.need;

        let deep = held.normal * (0.5 * held.arm * held.closing);
        let moved = held.point * turn(-held.closing);
        let back = turn(held.closing - held.rotation);
        let is_common =
            |point: &C| depth(&locked, *point) > need && depth(&free, point * back) > need;
        [held.point - deep, moved + deep]
            .into_iter()
            .find(is_common)
    }
}

/// Pieces of the locked and the free tooth: `piece` is of gear `owner`, `other` of its mate.
fn ordered(owner: usize, piece: Piece, other: Piece) -> [Piece; 2] {
    match owner {
        0 => [piece, other],
        _ => [other, piece],
    }
}

/// The root land as a piece of its half tooth.
fn root_land(half: &Placed) -> Option<Convex<'static>> {
    let (low, high) = half.range(ProfilePart::Root);
    (high > low).then(|| Convex::arc(half.shape.root_radius, -high, -low))
}

/// How deep a point lies in the metal of a half tooth, between its outline, the middle of the space and the far corner of its tip land, mm along
/// circles about its centre; not above 0 outside.
fn depth(half: &Placed, point: C) -> f64 {
    let shape = half.shape;
    let own = (point - half.centre) * half.direction.conj();
    let radius = own.norm();
    let angle = own.im.atan2(own.re);
    let before_far = half.far.arg() - angle;
    if radius <= shape.root_radius {
        let within = (angle + half.root_end).min(before_far);
        return (shape.root_radius - radius).min(within * radius);
    }
    let below_tip = shape.tip_radius - radius;
    if below_tip <= 0.0 {
        return below_tip;
    }
    let flank = match radius >= shape.form_radius() {
        true => {
            let roll = ((radius - shape.base) * (radius + shape.base))
                .max(0.0)
                .sqrt()
                / shape.base;
            roll - roll.atan() - shape.half_base
        }
        false => fillet_angle(shape, radius),
    };
    below_tip.min((angle - flank).min(before_far) * radius)
}

/// Polar angle of the fillet at a radius, which rises with its parameter.
fn fillet_angle(shape: &HalfToothShape, radius: f64) -> f64 {
    let (mut low, mut high) = shape.range(ProfilePart::Fillet);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match shape.radius(ProfilePart::Fillet, middle) < radius {
            true => low = middle,
            false => high = middle,
        }
    }
    // Both ends of the last bracket are on the fillet; the greater angle is on the safe side.
    let angle = |t: f64| shape.at(ProfilePart::Fillet, t).point.arg();
    angle(low).max(angle(high))
}
