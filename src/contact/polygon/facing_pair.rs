//! One half tooth of the free gear against one of the locked gear, and the relative position of their chords.
//!
//! All coordinates are in the frame of the locked half tooth. The *opening* `u`, rad, is the turn of the free gear from its nominal
//! rotation in the sense away from contact. The pair that touches at the greater opening is the tighter one.

use super::chord::{Chord, CutPair, Half};
use crate::contact::body::FarFlanks;
use crate::contact::lost_motion::contact_lost;
use crate::contact::parry::Closest;
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Member, Pose};
use nalgebra::{Isometry2, Point2, UnitComplex, Vector2};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Greatest error of a chord, as a part of its distance from the axis (the sine of an angle). A chord with more is halved.
const WIDE: f64 = 0.05;

/// Limit of these halvings; each divides the error by four. Only a curve through the axis itself stays wide.
const SPLITS: u32 = 12;

/// Uncertainty of a direction, rad, that does not shorten a safe turn noticeably.
const NEGLIGIBLE_DOUBT: f64 = 1e-6;

/// A pair of gears, and these cut in advance.
#[derive(Clone, Copy)]
pub(super) struct CutTeeth<'a> {
    pub assembly: &'a GearPair,
    pub cut: &'a CutPair,
}

/// A pair of half teeth that can touch on one side.
#[derive(Clone, Copy)]
pub(super) struct FacingPair<'a> {
    pub assembly: &'a GearPair,
    pub pose: &'a Pose,
    pub side: Side,
    pub locked_tooth: u32,
    pub free_tooth: u32,
    pub locked: Half<'a>,
    pub free: Half<'a>,
    /// Transforms the frame of the locked half tooth to the picture.
    pub locked_frame: Isometry2<f64>,
    /// The free axis, in the locked half tooth's frame.
    pub axis: Point2<f64>,
    /// Position of the free half tooth from the axis at the opening 0, in the directions of the locked frame.
    from_axis: Vector2<f64>,
    turn: UnitComplex<f64>,
    /// Direction of the free tooth at the opening 0 from its axis, counted from the direction to the mate, rad, to
    /// within a pitch. In a gear of few teeth, one that faces a tooth in reach can be more than half a turn away.
    nominal: f64,
}

impl<'a> FacingPair<'a> {
    /// The locked tooth `steps` places counter-clockwise of the mating's, and the free tooth that faces it on `side`. If none of these pairs
    /// touches, nothing does.
    pub fn new(teeth: &CutTeeth<'a>, pose: &'a Pose, side: Side, steps: i64) -> FacingPair<'a> {
        FacingPair::on(teeth, pose, [side; 2], steps)
    }

    /// All pairs of half teeth of `steps` that can touch. They include far flanks of locked teeth where those can be met.
    pub fn all(
        teeth: &CutTeeth<'a>,
        pose: &'a Pose,
        side: Side,
        steps: Range<i64>,
    ) -> impl Iterator<Item = FacingPair<'a>> {
        let is_clear = FarFlanks::of(teeth.assembly) == FarFlanks::Clear;
        let far = (!is_clear).then_some(side.other());
        let sides = [side].into_iter().chain(far);
        steps.flat_map(move |steps| {
            let on = move |locked| FacingPair::on(teeth, pose, [locked, side], steps);
            sides.clone().map(on)
        })
    }

    /// A half tooth on the first side of the locked tooth, and one on the second side of the free tooth that faces it.
    fn on(
        teeth: &CutTeeth<'a>,
        pose: &'a Pose,
        [locked_side, side]: [Side; 2],
        steps: i64,
    ) -> FacingPair<'a> {
        let assembly = teeth.assembly;
        let (locked, free) = (assembly.locked(), assembly.free());
        let mating = pose.mating().tooth(locked);
        let locked_tooth = assembly.gear(locked).counter_clockwise(mating, steps);
        let free_tooth = pose.facing_tooth(assembly, side, steps);
        let half = |member, side, tooth| {
            let profile = assembly.gear(member).profile(side, tooth);
            Half::new(profile, teeth.cut.gear(member), side, tooth)
        };
        let rotation = pose.locked_rotation();
        let locked_frame = frame(assembly, locked, rotation, locked_side, locked_tooth);
        let free_frame = frame(assembly, free, pose.free_rotation(), side, free_tooth);
        let axis = assembly.axis(free);
        let back = locked_frame.rotation.inverse();
        let pitch = |member| assembly.gear(member).gear().basic_data().angular_pitch();
        let here = pose.locked_rotation() + assembly.gear(locked).tooth_angle(f64::from(mating));
        let pitches = here / pitch(locked) + steps as f64;
        FacingPair {
            assembly,
            pose,
            side,
            locked_tooth,
            free_tooth,
            locked: half(locked, locked_side, locked_tooth),
            free: half(free, side, free_tooth),
            axis: back * (axis - locked_frame.translation.vector),
            from_axis: back * (free_frame.translation.vector - axis.coords),
            turn: back * free_frame.rotation,
            locked_frame,
            // Counter-clockwise on one gear is clockwise on the other.
            nominal: -pitches * pitch(free),
        }
    }

    /// Frame of the free half tooth in that of the locked one, at `opening`.
    pub fn at(&self, opening: f64) -> Isometry2<f64> {
        // A smaller opening turns the free gear in the sense of its side.
        let turned = UnitComplex::new(-self.side.sense() * opening);
        let centre = self.axis + turned * self.from_axis;
        Isometry2::from_parts(centre.coords.into(), turned * self.turn)
    }

    /// Greatest radius `R` of the free gear about its axis, mm.
    pub fn reach(&self) -> f64 {
        self.assembly.gear(self.assembly.free()).reach()
    }

    /// Rounding of a distance, mm: a few dozen operations on coordinates up to the centre distance and on radii turned by both rotations.
    pub fn rounding(&self) -> f64 {
        let turned = self.pose.locked_rotation().abs() + self.pose.free_rotation().abs();
        64.0 * f64::EPSILON * (self.assembly.center_distance() + self.reach() * turned)
    }

    /// How far the free gear can be turned in while two chords that are `closest` now stay more than `margin` apart.
    ///
    /// Between the chords there is a strip as wide as their distance, across the direction between their nearest
    /// points. If their distance is hardly above rounding, that direction has no meaning. Then the lines of both chords
    /// border narrower strips whose directions are known.
    pub fn safe_turn(
        &self,
        locked_chord: &Chord,
        free_chord: &Chord,
        closest: &Closest,
        margin: f64,
    ) -> f64 {
        let room = closest.distance - margin;
        // No point moves further than the reach times the angle; a lever gives a longer turn, except for rounding.
        let plain = room / self.reach();
        let rounding = self.rounding();
        let n = (closest.points[0] - closest.points[1]) / closest.distance;
        let safe = self.turn_across(n, free_chord, room, rounding / closest.distance);
        if rounding <= NEGLIGIBLE_DOUBT * closest.distance {
            return safe.max(plain);
        }
        let across_line = |line: &Chord, other: &Chord, sense: f64| {
            let along = (line.ends[1] - line.ends[0]) / (2.0 * line.half_length);
            let [one, two] = other.ends.map(|end| along.perp(&(end - line.ends[0])));
            // The side of the line on which the other chord lies, or lies for the most part.
            let (side, width) = if one + two > 0.0 {
                (1.0, one.min(two))
            } else {
                (-1.0, -one.max(two))
            };
            let n = sense * side * Vector2::new(-along.y, along.x);
            if width > margin {
                self.turn_across(n, free_chord, width - margin, rounding / line.half_length)
            } else {
                0.0
            }
        };
        let [from_ours, from_theirs] = [
            across_line(locked_chord, free_chord, -1.0),
            across_line(free_chord, locked_chord, 1.0),
        ];
        safe.max(plain).max(from_ours).max(from_theirs)
    }

    /// How far the free gear can be turned before `free_chord` moves by `room` along `n`, whose direction is off by up to `doubt`, rad.
    ///
    /// Turned by `φ` about the axis, a point at `r` from it moves along `n` by
    /// `sin φ n·(k × r) − (1 − cos φ) n·r ≤ φ l + φ² m/2`. `l` and `m` are the greatest such parts (not below 0) at the two ends, and so for
    /// all points between them. A curve lies within its error of its chord, and so do its parts. The lesser root of `φ l + φ² m/2 = room` is
    /// a safe turn.
    fn turn_across(&self, n: Vector2<f64>, free_chord: &Chord, room: f64, doubt: f64) -> f64 {
        let (mut lever, mut bulge) = (0.0f64, 0.0f64);
        for end in free_chord.ends {
            let r = end - self.axis;
            lever = lever.max(self.side.sense() * r.perp(&n));
            bulge = bulge.max(-r.dot(&n));
        }
        let off = free_chord.error + doubt * self.reach();
        let (lever, bulge) = (lever + off, bulge + off);
        2.0 * room / (lever + (lever * lever + 2.0 * room * bulge).sqrt())
    }

    /// Whether no turn can bring the two together, because one is always further from the free axis.
    pub fn passes(&self, locked_chord: &Chord, radii: [f64; 2]) -> bool {
        let [near, far] = distances(locked_chord, &self.axis);
        near > radii[1] || far < radii[0]
    }

    /// Least and greatest distance of a chord of the free half tooth from the axis, at any opening.
    pub fn radii(&self, free_chord: &Chord) -> [f64; 2] {
        // Its own frame, in which the axis does not move.
        distances(
            free_chord,
            &self.at(0.0).inverse_transform_point(&self.axis),
        )
    }

    /// The openings above and below which the two chords share no direction from the free axis.
    pub fn shared_directions(&self, locked_chord: &Chord, free_chord: &Chord) -> (f64, f64) {
        // Directions count from the direction to the mate, and within a half tooth from that of its disc: none jumps by a turn.
        let to_mate = self.locked_frame.rotation.inverse()
            * Vector2::new(
                self.assembly.mate_direction(self.assembly.free()).cos(),
                0.0,
            );
        let from = |disc: Point2<f64>, nominal: f64| {
            let disc = disc - self.axis;
            let from = angle(&to_mate, &disc);
            (disc, from + TAU * ((nominal - from) / TAU).round())
        };
        let at = self.at(0.0);
        // The locked gear is within half a turn of the line of centres.
        let ours_from = from(self.locked.disc().0, 0.0);
        let locked = self.spread(
            &self.locked,
            locked_chord,
            &Isometry2::identity(),
            ours_from,
            SPLITS,
        );
        let theirs_from = from(at * self.free.disc().0, self.nominal);
        let free = self.spread(&self.free, free_chord, &at, theirs_from, SPLITS);
        (locked.1 - free.0, locked.0 - free.1)
    }

    /// The range of directions of a chord's curve, against the sense of closing. `frame` places its half tooth; `disc`
    /// is the middle of that half tooth from the axis and its direction.
    ///
    /// The curve of a long chord can be so far off that its direction is unknown; those of its halves are known after a few cuts.
    fn spread(
        &self,
        half: &Half,
        chord: &Chord,
        frame: &Isometry2<f64>,
        disc: (Vector2<f64>, f64),
        splits: u32,
    ) -> (f64, f64) {
        let seen = chord.seen_in(frame);
        let distance = distances(&seen, &self.axis)[0] + chord.error;
        let sine = chord.error / distance;
        if splits > 0 && !(sine < WIDE) {
            let mut made = None;
            let halves = half.halves(chord, &mut made);
            let [one, two] = [0, 1].map(|i| self.spread(half, &halves[i], frame, disc, splits - 1));
            return (one.0.min(two.0), one.1.max(two.1));
        }
        let arc = if sine < 1.0 { sine.asin() } else { PI };
        let ends = seen.ends.map(|end| {
            let seen = disc.1 + angle(&disc.0, &(end - self.axis));
            -self.side.sense() * seen
        });
        (ends[0].min(ends[1]) - arc, ends[0].max(ends[1]) + arc)
    }

    /// An error that names the pair.
    pub fn lost(&self, reason: &str) -> Error {
        let teeth = [self.locked_tooth, self.free_tooth];
        contact_lost(self.assembly.free(), teeth, self.side, self.pose, reason)
    }
}

/// The angle from one direction to another, in (−π, π].
fn angle(from: &Vector2<f64>, to: &Vector2<f64>) -> f64 {
    from.perp(to).atan2(from.dot(to))
}

/// Least and greatest distance of a chord's curve from a point, mm.
fn distances(chord: &Chord, point: &Point2<f64>) -> [f64; 2] {
    let [a, b] = chord.ends.map(|end| end - point);
    let along = b - a;
    let part = (-a.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
    let near = if part.is_nan() { a } else { a + part * along };
    [
        near.norm() - chord.error,
        a.norm().max(b.norm()) + chord.error,
    ]
}

/// Frame in the picture of the half tooth on `side` of `tooth` of `member`, with the gear turned to `rotation`.
fn frame(
    assembly: &GearPair,
    member: Member,
    rotation: f64,
    side: Side,
    tooth: u32,
) -> Isometry2<f64> {
    let gear = assembly.gear(member);
    let tooth_1 = assembly.mate_direction(member) + rotation;
    let centre = assembly.axis(member) + gear.displacement(tooth_1);
    let turn = gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
    Isometry2::new(centre.coords, tooth_1 + turn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair::Mating;

    /// A safe turn uses the whole room: `φ l + φ² m/2` with the greatest speed and acceleration of the chord's ends
    /// along the direction equals it. Source: differences of the turned ends.
    #[test]
    fn a_safe_turn_uses_up_the_room_across() {
        let pair = GearPair::plain([30, 18], [0.0; 2], 48.2, Member::Wheel);
        let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
        let cut = &CutPair::new(wheel, pinion, 1e-2);
        let reach = pair.gear(Member::Pinion).gear().tip_radius();
        let assembly = &pair;
        let teeth = CutTeeth { assembly, cut };
        let pose = Pose::new(&pair, Mating::FIRST);
        let mut pulled = [0; 4];
        for side in Side::BOTH {
            let problem = FacingPair::new(&teeth, &pose, side, 1);
            for chord in problem.free.outline() {
                let chord = chord.seen_in(&problem.at(0.01));
                for k in 0..12 {
                    let n = UnitComplex::new(0.3 + f64::from(k) * TAU / 12.0) * Vector2::x();
                    let moved = |turn: f64| {
                        chord.ends.map(|end| {
                            let r = end - problem.axis;
                            let turned = UnitComplex::new(side.sense() * turn) * r;
                            (turned - r).dot(&n)
                        })
                    };
                    const STEP: f64 = 1e-3;
                    let [one, other] = [moved(-STEP), moved(STEP)];
                    let speed = [0, 1].map(|i| (other[i] - one[i]) / (2.0 * STEP));
                    let swerve = [0, 1].map(|i| (other[i] + one[i]) / (STEP * STEP));
                    let [l, m] = [speed, swerve].map(|it| it[0].max(it[1]).max(0.0));
                    pulled[2 * usize::from(l > 0.0) + usize::from(m > 0.0)] += 1;
                    for (room, doubt) in [(1e-3, 0.0), (0.2, 0.0), (0.2, 1e-2)] {
                        let off = chord.error + doubt * reach;
                        let turn = problem.turn_across(n, &chord, room, doubt);
                        let used = turn * (l + off) + 0.5 * turn * turn * (m + off);
                        let case = format!("{side:?} {k} {room} {doubt}: {turn} uses {used}");
                        assert!(turn > 0.0 && (used / room - 1.0).abs() < 1e-5, "{case}");
                    }
                }
            }
        }
        assert!(pulled.iter().all(|count| *count > 10), "{pulled:?}");
    }
}
