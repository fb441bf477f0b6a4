//! The field of action at one pose: the contacts of tooth pairs over the common face and along the path of contact.
//!
//! In every transverse section involutes touch on the line of action, the common tangent of the displaced base circles. It is the same in
//! all sections, because their centres are constant along the face. The contact of a pair moves along it with the twist of the teeth. At
//! `b` mm along the face its roll on the wheel is less by `τ_1 b`. Its place on the path,
//!
//! ```text
//! s = r_b1 ξ_1 − T r_b1/(r_b1 + r_b2),
//! ```
//!
//! counts from the pitch point towards the pinion's end of the tangent of length `T`. It changes by `∓ tan β_b` per mm: a straight line.
//!
//! With leads the gap of a pair varies along its line, and leaning axes bend the line. Then its points are those of each section.

use crate::analytic::SideContact;
use crate::contact::{Contact, ContactClass, ContactKind, ExactKernel, LostMotion, PoseResult};
use crate::gear::{Placed, Side};
use crate::numeric::{bisect, wrap_angle};
use crate::pair::{GearPair, Member, Pose, section_at};
use nalgebra::{UnitComplex, Vector2};

/// Number of equal intervals between sections, besides the ends of contact lines (tuned: a few pixels of a chart each).
const INTERVALS: u32 = 160;
/// Gap below which an involute also touches, mm, beyond the errors of both contacts: rolls and rotations are sums of several angles.
const ROUNDING: f64 = 1e-10;

/// The field of action at a pose, with the free gear held on each side in turn.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Field {
    /// The pose.
    pub pose: Pose,
    /// Ends of the common face, mm from the measuring plane.
    pub face: [f64; 2],
    /// Right and left contact.
    pub sides: [FieldSide; 2],
}

/// One side of the field.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FieldSide {
    /// Its flanks.
    pub side: Side,
    /// Ends of the path of contact, mm from the pitch point.
    pub path: [f64; 2],
    /// The limits at both ends.
    pub limits: [PathLimit; 2],
    /// The contact line of every pair that has one on the face, in the order of the locked teeth.
    pub lines: Vec<ContactLine>,
    /// The contact that holds the free gear.
    pub binding: BindingContact,
    /// The sections, ascending: evenly over the face, at the ends of contact lines, and where the free gear is held.
    pub sections: Vec<FieldSection>,
    /// Stretches along the face, mm, with contact on a fillet, a root or an undercut edge before any involute; each end
    /// within [`STRETCH_END`]. A stretch is found if one of `sections` is in it.
    pub fillets: Vec<[f64; 2]>,
    /// Leads of the binding teeth over the face, wheel first: mm along the face, mm; empty for gears without leads.
    pub leads: [Vec<(f64, f64)>; 2],
}

/// The contact line of a tooth pair, now or after a further turn of the free gear.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactLine {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// Both ends: mm along the face, mm along the path.
    pub ends: [[f64; 2]; 2],
    /// Gap between the flanks along the line of action, mm: 0 for the binding pair. The least of `points`.
    pub gap: f64,
    /// Points where the gap varies along the face: mm along the face, mm along the path, gap, mm. Empty where it is constant.
    pub points: Vec<[f64; 3]>,
    /// Whether its teeth hold the free gear.
    pub binds: bool,
}

impl ContactLine {
    /// Gap at a place along the face, mm; `None` beyond the line.
    fn gap_at(&self, at: f64) -> Option<f64> {
        let [[from, _], [to, _]] = self.ends;
        let next = self.points.partition_point(|point| point[0] < at);
        match (self.points.get(next.wrapping_sub(1)), self.points.get(next)) {
            (Some(one), Some(other)) => {
                let part = (at - one[0]) / (other[0] - one[0]);
                Some(one[2] + part * (other[2] - one[2]))
            }
            (None, Some(first)) if first[0] == at => Some(first[2]),
            _ => (self.points.is_empty() && (from..=to).contains(&at)).then_some(self.gap),
        }
    }
}

/// The contact that holds the free gear.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BindingContact {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// Place along the face, mm.
    pub section: f64,
    /// Place along the path, mm; for a contact off the line of action, the foot of its perpendicular.
    pub place: f64,
    /// Kind of the contact.
    pub kind: ContactKind,
}

/// The play that the teeth of one section would leave alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FieldSection {
    /// Place along the face, mm.
    pub at: f64,
    /// Further turn of the free gear, along the line of action, with this section alone, mm; `None` without contact in it.
    pub gap: Option<f64>,
    /// Kind of the contact that would hold it.
    pub kind: Option<ContactKind>,
}

impl Field {
    /// The field of action at `pose`. `None` for a pair whose sections are all equal, without a proven lost motion, or if the displaced base
    /// circles overlap.
    pub fn of(assembly: &GearPair, pose: &PoseResult) -> Option<Field> {
        let found = pose.proven().filter(|found| found.angle().is_some())?;
        if !assembly.varies_along_face() {
            return None;
        }
        let pose = &pose.pose;
        let held = |side: Side| HeldSide::new(assembly, pose, side, found.on(side)?);
        let held = [held(Side::Right)?, held(Side::Left)?];
        let sections = places(&held, assembly.face()).into_iter();
        let sections = sections.map(|at| SectionAlone::new(assembly, pose, at));
        let sections: Vec<SectionAlone> = sections.collect();
        Some(Field {
            pose: *pose,
            face: assembly.face(),
            sides: held.map(|side| side.field(&sections)),
        })
    }
}

/// Places along the face to examine, mm, ascending.
fn places(held: &[HeldSide; 2], [from, to]: [f64; 2]) -> Vec<f64> {
    let even = (0..=INTERVALS).map(|k| from + (to - from) * (f64::from(k) / f64::from(INTERVALS)));
    let ends = held.iter().flat_map(|side| &side.lines);
    let ends = ends.flat_map(|line| line.ends.map(|end| end[0]));
    let holding = held.iter().map(|side| side.contact.section);
    let mut places: Vec<f64> = even.chain(ends).chain(holding).collect();
    places.sort_unstable_by(f64::total_cmp);
    places.dedup();
    places
}

/// A section of the pair, with its pose and its own lost motion.
struct SectionAlone {
    at: f64,
    pair: GearPair,
    pose: Pose,
    found: Option<LostMotion>,
}

impl SectionAlone {
    fn new(assembly: &GearPair, pose: &Pose, at: f64) -> SectionAlone {
        let (pair, here) = section_at(assembly, pose, at);
        SectionAlone {
            at,
            found: ExactKernel::new(&pair).lost_motion(&here).ok(),
            pair,
            pose: here,
        }
    }

    /// Whether all teeth of leaning gears reach through this section of `assembly`.
    fn is_whole(&self, assembly: &GearPair) -> bool {
        let beyond = assembly.height_bound();
        let [from, to] = assembly.face();
        (from + beyond..=to - beyond).contains(&self.at)
    }
}

/// One side, with the free gear held by its contact over the whole face.
struct HeldSide<'a> {
    assembly: &'a GearPair,
    pose: &'a Pose,
    side: Side,
    contact: Contact,
    tangent: Tangent,
    path: [f64; 2],
    limits: [PathLimit; 2],
    lines: Vec<ContactLine>,
}

impl<'a> HeldSide<'a> {
    /// `None` if the displaced base circles overlap.
    fn new(
        assembly: &'a GearPair,
        pose: &'a Pose,
        side: Side,
        contact: Contact,
    ) -> Option<HeldSide<'a>> {
        let tangent = Tangent::new(assembly, pose, side, contact.rotation)?;
        let (path, limits) = tangent.path(assembly);
        let mut held = HeldSide {
            assembly,
            pose,
            side,
            contact,
            tangent,
            path,
            limits,
            lines: Vec::new(),
        };
        if !assembly.binds_anywhere() {
            held.lines = SideContact::all(assembly, pose, side)
                .filter_map(|line| held.line(&line))
                .collect();
        }
        Some(held)
    }

    /// Base radius of the free gear, mm.
    fn radius(&self) -> f64 {
        let free = self.assembly.gear(self.assembly.free());
        free.gear().base_radius()
    }

    /// Distance along the line of action, mm, of the free gear from a contact that is `turn`, rad, past its present one.
    fn gap(&self, turn: f64) -> f64 {
        self.side.sense() * wrap_angle(turn) * self.radius()
    }

    fn teeth(&self) -> (u32, u32) {
        (self.contact.wheel.tooth, self.contact.pinion.tooth)
    }

    fn line(&self, line: &SideContact) -> Option<ContactLine> {
        let twist = (self.assembly.gear(Member::Wheel).gear().basic_data()).twist();
        let slope = self.side.sense() * self.tangent.base[0] * twist;
        let (wheel, pinion) = by_member(self.assembly, line.locked_tooth, line.free_tooth);
        let rolls = by_member(self.assembly, line.locked_roll, line.free_roll);
        let place = self.tangent.place([rolls.0, rolls.1]);
        let ends = clipped(line.section, place, slope, self.assembly.face(), self.path)?;
        Some(ContactLine {
            wheel_tooth: wheel,
            pinion_tooth: pinion,
            ends,
            gap: self.gap(line.rotation - self.contact.rotation),
            points: Vec::new(),
            binds: (wheel, pinion) == self.teeth(),
        })
    }

    /// The contact lines of a pair that deviates along the face, from its sections. The line of the contact includes its section.
    fn lines_of(&self, sections: &[SectionAlone]) -> Vec<ContactLine> {
        let mut lines: Vec<ContactLine> = Vec::new();
        for alone in sections {
            let is_whole = alone.is_whole(self.assembly);
            if !is_whole && alone.at != self.contact.section {
                continue;
            }
            let (pair, here) = (&alone.pair, &alone.pose);
            let held = here.free_rotation() + self.contact.rotation - self.pose.free_rotation();
            let Some(tangent) = Tangent::new(pair, here, self.side, held) else {
                continue;
            };
            for contact in SideContact::all(pair, here, self.side) {
                let teeth = by_member(pair, contact.locked_tooth, contact.free_tooth);
                if !is_whole && teeth != self.teeth() {
                    continue;
                }
                let rolls = by_member(pair, contact.locked_roll, contact.free_roll);
                let place = tangent.place([rolls.0, rolls.1]);
                let gap = self.gap(contact.rotation - held);
                let point = [alone.at, place, gap];
                let end = [alone.at, place];
                let is_of =
                    |line: &&mut ContactLine| (line.wheel_tooth, line.pinion_tooth) == teeth;
                match lines.iter_mut().find(is_of) {
                    Some(line) => {
                        line.ends[1] = end;
                        line.gap = line.gap.min(gap);
                        line.points.push(point);
                    }
                    None => lines.push(ContactLine {
                        wheel_tooth: teeth.0,
                        pinion_tooth: teeth.1,
                        ends: [end; 2],
                        gap,
                        points: vec![point],
                        binds: teeth == self.teeth(),
                    }),
                }
            }
        }
        lines
    }

    /// Leads of the binding teeth in each section, wheel first.
    fn leads(&self, sections: &[SectionAlone]) -> [Vec<(f64, f64)>; 2] {
        let teeth = self.teeth();
        [(Member::Wheel, teeth.0), (Member::Pinion, teeth.1)].map(|(member, tooth)| {
            let gear = self.assembly.gear(member);
            let lead = |alone: &SectionAlone| (alone.at, gear.lead(self.side, tooth, alone.at));
            let with = self.assembly.has_leads().then_some(sections);
            with.into_iter().flatten().map(lead).collect()
        })
    }

    fn section(&self, alone: &SectionAlone) -> FieldSection {
        let touching = alone.found.as_ref().and_then(|found| found.on(self.side));
        let is_shown = alone.is_whole(self.assembly) || alone.at == self.contact.section;
        let touching = touching.filter(|_| is_shown);
        let turn = |here: Contact| {
            let beyond = here.rotation - alone.pose.free_rotation();
            self.gap(beyond - (self.contact.rotation - self.pose.free_rotation()))
        };
        FieldSection {
            at: alone.at,
            gap: touching.map(turn),
            kind: touching.map(|here| ContactClass::of(&alone.pair, self.side, &here).kind),
        }
    }

    /// Whether a section has contact below the involutes, and none on the line of action at the same time.
    fn is_off_involutes(&self, alone: &SectionAlone) -> bool {
        let section = self.section(alone);
        let found = alone.found.as_ref().and_then(|found| found.on(self.side));
        let (Some(gap), Some(kind), Some(found)) = (section.gap, section.kind, found) else {
            return false;
        };
        let alike = (found.error + self.contact.error) * self.radius() + ROUNDING;
        let touches = |line: &ContactLine| {
            let here = line.gap_at(alone.at);
            here.is_some_and(|here| here <= gap + alike)
        };
        kind.is_non_involute() && !self.lines.iter().any(touches)
    }

    fn field(mut self, sections: &[SectionAlone]) -> FieldSide {
        if self.assembly.binds_anywhere() {
            self.lines = self.lines_of(sections);
        }
        let looks = sections.iter();
        let looks = looks.map(|alone| (alone.at, self.is_off_involutes(alone)));
        let looks: Vec<(f64, bool)> = looks.collect();
        let is_off = |at| self.is_off_involutes(&SectionAlone::new(self.assembly, self.pose, at));
        let (wheel_tooth, pinion_tooth) = self.teeth();
        FieldSide {
            side: self.side,
            path: self.path,
            limits: self.limits,
            binding: BindingContact {
                wheel_tooth,
                pinion_tooth,
                section: self.contact.section,
                place: self.tangent.foot(&self.contact),
                kind: ContactClass::of(self.assembly, self.side, &self.contact).kind,
            },
            sections: sections.iter().map(|alone| self.section(alone)).collect(),
            fillets: stretches(&looks, is_off),
            leads: self.leads(sections),
            lines: self.lines,
        }
    }
}

/// Values of wheel and pinion from those of the locked and the free gear.
fn by_member<T>(assembly: &GearPair, locked: T, free: T) -> (T, T) {
    match assembly.locked() {
        Member::Wheel => (locked, free),
        Member::Pinion => (free, locked),
    }
}

/// The line through `place` at `at` with this slope, clipped to face and path; `None` if it only grazes them by rounding.
fn clipped(
    at: f64,
    place: f64,
    slope: f64,
    face: [f64; 2],
    path: [f64; 2],
) -> Option<[[f64; 2]; 2]> {
    let on_path = path.map(|end| at + (end - place) / slope);
    let from = face[0].max(on_path[0].min(on_path[1]));
    let to = face[1].min(on_path[0].max(on_path[1]));
    (from <= to).then(|| [from, to].map(|b| [b, place + slope * (b - at)]))
}

/// Accuracy of the ends of a stretch, mm along the face.
pub const STRETCH_END: f64 = 1e-6;

/// The stretches in which `holds`, ascending. `looks` are samples at ascending places. Bisection between two of them
/// finds each end to within [`STRETCH_END`]. A stretch between two samples is missed.
fn stretches(looks: &[(f64, bool)], holds: impl Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let mut begin = looks.first().filter(|look| look.1).map(|look| look.0);
    for pair in looks.windows(2) {
        let [(from, before), (to, after)] = [pair[0], pair[1]];
        if !before && after {
            begin = Some(bisect(to, from, STRETCH_END, &holds)[0]);
        } else if before && !after {
            let [end, _] = bisect(from, to, STRETCH_END, &holds);
            found.extend(begin.take().map(|begin| [begin, end]));
        }
    }
    let end = looks.last().map(|look| look.0);
    found.extend(begin.zip(end).map(|(begin, end)| [begin, end]));
    found
}

/// Limit of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PathLimit {
    /// The tip circle of this gear.
    Tip(Member),
    /// The form circle of this gear, below which its flank is no involute.
    Form(Member),
}

/// The common tangent of the displaced base circles.
struct Tangent {
    /// Base radii of wheel and pinion, mm.
    base: [f64; 2],
    /// Its length, mm.
    length: f64,
    /// From the origin to the pitch point on it, mm.
    pitch_point: Vector2<f64>,
    /// From the wheel's end to the pinion's.
    direction: Vector2<f64>,
}

impl Tangent {
    /// The tangent of `side` with the free gear at `rotation`; `None` where the base circles overlap.
    fn new(assembly: &GearPair, pose: &Pose, side: Side, rotation: f64) -> Option<Tangent> {
        let centre = |member: Member| {
            let turned = if member == assembly.locked() {
                pose.locked_rotation()
            } else {
                rotation
            };
            let tooth_1 = assembly.mate_direction(member) + turned;
            Placed::new(assembly.gear(member), assembly.axis(member), tooth_1).centre()
        };
        let [wheel, pinion] = Member::BOTH.map(centre);
        let base = Member::BOTH.map(|m| assembly.gear(m).gear().base_radius());
        let between = pinion - wheel;
        let (distance, sum) = (between.norm(), base[0] + base[1]);
        if distance <= sum {
            return None;
        }
        // As in `Scene::line_of_action`.
        let radial =
            UnitComplex::new(-side.sense() * (sum / distance).acos()) * (between / distance);
        let ends = [wheel + base[0] * radial, pinion - base[1] * radial];
        let along = ends[1] - ends[0];
        let length = ((distance - sum) * (distance + sum)).sqrt();
        Some(Tangent {
            base,
            length,
            pitch_point: ends[0].coords + along * (base[0] / sum),
            direction: along / length,
        })
    }

    /// The wheel's part of a length from one end to the other.
    fn share(&self) -> f64 {
        self.base[0] / (self.base[0] + self.base[1])
    }

    /// Place of a contact with these rolls of wheel and pinion, mm from the pitch point.
    fn place(&self, rolls: [f64; 2]) -> f64 {
        let arms = [self.base[0] * rolls[0], self.base[1] * rolls[1]];
        arms[0] - (arms[0] + arms[1]) * self.share()
    }

    /// The foot of the perpendicular from a contact.
    fn foot(&self, contact: &Contact) -> f64 {
        (contact.point.coords - self.pitch_point).dot(&self.direction)
    }

    /// Both ends of the path of contact, mm from the pitch point, and their limits.
    fn path(&self, assembly: &GearPair) -> ([f64; 2], [PathLimit; 2]) {
        let arms = |member: Member, base: f64| {
            let gear = assembly.gear(member).gear();
            [gear.form_roll(), gear.tip_roll()].map(|roll| base * roll)
        };
        let [form_1, tip_1] = arms(Member::Wheel, self.base[0]);
        let [form_2, tip_2] = arms(Member::Pinion, self.base[1]).map(|arm| self.length - arm);
        let (low, begins) = if tip_2 >= form_1 {
            (tip_2, PathLimit::Tip(Member::Pinion))
        } else {
            (form_1, PathLimit::Form(Member::Wheel))
        };
        let (high, ends) = if tip_1 <= form_2 {
            (tip_1, PathLimit::Tip(Member::Wheel))
        } else {
            (form_2, PathLimit::Form(Member::Pinion))
        };
        let origin = self.length * self.share();
        ([low - origin, high - origin], [begins, ends])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed form: sin x > 0.5 between π/6 and 5π/6, and again a turn later, limited by the last sample.
    #[test]
    fn stretches_end_where_the_sine_crosses() {
        use std::f64::consts::PI;
        let holds = |x: f64| x.sin() > 0.5;
        let last = 2.5 * PI;
        let looks: Vec<(f64, bool)> = (0..=40)
            .map(|k| last * f64::from(k) / 40.0)
            .map(|x| (x, holds(x)))
            .collect();
        let found = stretches(&looks, holds);
        let expected = [[PI / 6.0, 5.0 * PI / 6.0], [13.0 * PI / 6.0, last]];
        assert_eq!(found.len(), 2);
        for (found, expected) in found.iter().zip(expected) {
            for (end, at) in found.iter().zip(expected) {
                assert!((end - at).abs() <= STRETCH_END, "{end} {at}");
            }
        }
        assert!(stretches(&[(0.0, false), (1.0, false)], holds).is_empty());
        assert_eq!(stretches(&[(0.6, true), (0.9, true)], holds), [[0.6, 0.9]]);
    }
}
