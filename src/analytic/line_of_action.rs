//! Model 3: exact backlash of eccentric involutes with pitch and thickness deviations.
//!
//! Each side of the free gear is solved alone: the model finds the rotations of the free gear at which facing involutes touch. Only
//! contact on the line of action counts.
//!
//! Derivation, in the frame of the line of centres. The locked gear's axis is the origin, the free gear's axis `(a, 0)`. Angles of a
//! gear count from the direction to its mate. The left side is mirrored in the x axis, which makes it a right side. In complex
//! notation, the right flank of a tooth with its centre at the angle `θ` on a gear centred at `C` is
//!
//! ```text
//! P(ξ) = C + r_b E (1 − iξ),   E = e^{i(ξ − ψ_b + θ)},   outward normal −iE,
//! ```
//!
//! where `ψ_b` is half the tooth on the base circle. At a contact the normals oppose: `E_2 = −E_1`. With `D = C_2 − C_1`,
//! `R = r_b1 + r_b2` and `Σ = r_b1 ξ_1 + r_b2 ξ_2`, equal points mean `D = E_1 (R − iΣ)`, so
//!
//! ```text
//! Σ² = |D|² − R²,   arg E_1 = arg D + atan(Σ/R),
//!
//! ξ_1 = arg E_1 + ψ_b1 − θ_1,   ξ_2 = (Σ − r_b1 ξ_1)/r_b2,   θ_2 = arg E_1 + ψ_b2 − ξ_2.
//! ```
//!
//! `C_2` turns with the free gear, and so does `D` with its rotation `φ`: the last line is a fixed point `φ = G(φ)`. With
//! `G' = Im(conj(E_1) dD/dφ)/r_b2` and `|dD/dφ| = e_2`, `|G'| ≤ e_2/r_b2`.
//!
//! A profile deviation `δ` moves the point along the normal, `P = C + r_b E (1 − iξ) − iEδ(ξ)`. To first order the normal stays, and
//! `Σ = r_b1 ξ_1 + δ_1 + r_b2 ξ_2 + δ_2` with the deviations at the two points. The tilt of the normal, `δ'/(r_b ξ)`, moves the
//! contact along the flanks; its effect is of second order and neglected.
//!
//! Leads turn the flanks of the section at `b` by `δ(b)/r_b`: a pair is on the line over one stretch of the face, and `G` grows by the
//! greatest `Σ δ(b)/r_b2` over it.
//!
//! Profile deviations of helical teeth count at the rolls of each section, so that `G` is greatest at one of them as well.
//!
//! Where axes lean, centres move along the face, and twist and lead are those at the height of the contact along each gear's own axis
//! ([`section_at`](crate::pair::section_at)). `G` on the line is a parabola of `b` plus the leads. Rolls and heights are linear. Three sections give them, to the
//! second order of the lean. The model leaves out `½ g² ρ`, by which the contact moves along the flank ([`GearPair::section_error_bound`]).

use crate::gear::{AsBuilt, DeviationCurve, ProfilePart, Side};
use crate::numeric::{bisect, rank, wrap_angle};
use crate::pair::{FacingTeeth, GearPair, Member, Pose};
use nalgebra::{UnitComplex, Vector2};
use std::ops::RangeInclusive;

/// Contact of two involutes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideContact {
    /// Rotation of the free gear, rad, counted as in [`Pose`].
    pub rotation: f64,
    /// Tooth of the locked gear.
    pub locked_tooth: u32,
    /// Tooth of the free gear.
    pub free_tooth: u32,
    /// Roll `ξ` of the contact on the locked gear.
    pub locked_roll: f64,
    /// Roll `ξ` of the contact on the free gear.
    pub free_roll: f64,
    /// Section with these rolls, mm from the measuring plane: the contact nearest to that plane; 0 for spur gears.
    pub section: f64,
}

impl SideContact {
    /// All contacts of facing `side` flanks within both gears' tip and form circles about their displaced centres.
    ///
    /// Also empty if the free gear's eccentricity is its base radius or more: the rotation at contact is then not unique.
    pub fn all<'a>(
        assembly: &'a GearPair,
        pose: &'a Pose,
        side: Side,
    ) -> impl Iterator<Item = SideContact> + 'a {
        OneSide::new(assembly, pose, side).contacts()
    }
}

/// Tolerance of a roll at the ends of the involute, over the tip roll. Rolls are sums of a few angles of order 1, rounded by some 1e-15.
const END: f64 = 1e-12;

/// One side of a pose, mirrored if left. All angles from the line of centres.
pub(super) struct OneSide<'a> {
    assembly: &'a GearPair,
    pose: &'a Pose,
    side: Side,
    /// −1 on the left side: angles change sign in the mirror.
    mirror: f64,
    locked: &'a AsBuilt,
    free: &'a AsBuilt,
    /// Centre of the free gear's eccentric circle less the centre of the locked outline, mm.
    between: Vector2<f64>,
    /// From there to the centre of the free outline, at the nominal rotation, mm.
    displacement: Vector2<f64>,
    /// Lean of the locked and of the free shaft, and of the toothing of each on its shaft at the nominal rotation, mm per mm.
    shafts: [Vector2<f64>; 2],
    tilts: [Vector2<f64>; 2],
    /// Twist of the locked teeth from the measuring plane to both ends of the common face, the lesser first, rad; 0 for spur gears.
    face: [f64; 2],
}

/// Two teeth that face each other, locked and free.
struct Facing<'a> {
    teeth: FacingTeeth<'a>,
    /// Their profile deviations.
    profiles: [Option<&'a DeviationCurve>; 2],
    /// Angle of the locked tooth, and of the free one at the nominal rotation, rad, with their deviations in the measuring plane.
    angles: [f64; 2],
}

/// The contact of two teeth in one section, wherever their involutes end.
struct Touch {
    /// Rotation of the free gear from its nominal one, rad.
    turn: f64,
    rolls: [f64; 2],
    /// Lengths of the tangents to both base circles, with the profile deviations, mm.
    arms: [f64; 2],
    /// Height of the contact along each gear's own axis, less the place of the section, mm.
    heights: [f64; 2],
    is_settled: bool,
}

/// The common base tangent at one rotation of the free gear.
struct Line {
    /// `arg E_1`, rad.
    direction: f64,
    /// `Σ`, its length between the two base circles, mm.
    length: f64,
}

impl<'a> OneSide<'a> {
    pub(super) fn new(assembly: &'a GearPair, pose: &'a Pose, side: Side) -> OneSide<'a> {
        let mirror = -side.sense();
        let (locked, free) = (
            assembly.gear(assembly.locked()),
            assembly.gear(assembly.free()),
        );
        let seen = |vector: Vector2<f64>| Vector2::new(vector.x, mirror * vector.y);
        let twist = mirror * locked.gear().basic_data().twist();
        let mut face = assembly.face().map(|b| twist * b);
        face.sort_unstable_by(f64::total_cmp);
        let [x, y] = assembly.lean();
        let pinion = seen(Vector2::new(x, y));
        // The picture is turned by half a turn where the pinion is locked.
        let shafts = match assembly.locked() {
            Member::Wheel => [Vector2::zeros(), pinion],
            Member::Pinion => [-pinion, Vector2::zeros()],
        };
        // The free gear's direction to its mate is −x.
        OneSide {
            assembly,
            pose,
            side,
            mirror,
            locked,
            free,
            between: Vector2::new(assembly.center_distance(), 0.0)
                - seen(locked.displacement(pose.locked_rotation())),
            displacement: -seen(free.displacement(pose.free_rotation())),
            shafts,
            tilts: [
                seen(locked.lean(pose.locked_rotation())),
                -seen(free.lean(pose.free_rotation())),
            ],
            face,
        }
    }

    /// All contacts on both involutes.
    pub(super) fn contacts(self) -> impl Iterator<Item = SideContact> + 'a {
        let window = self.window();
        self.steps(&window)
            .filter_map(move |steps| self.contact(steps, &window))
    }

    fn base_radii(&self) -> f64 {
        self.locked.gear().base_radius() + self.free.gear().base_radius()
    }

    /// `atan(Σ/R)` and `Σ` at a distance of the outlines' centres; 0 if the base circles overlap.
    fn tangent(&self, distance: f64) -> (f64, f64) {
        let base = self.base_radii();
        let length = ((distance - base) * (distance + base)).max(0.0).sqrt();
        (length.atan2(base), length)
    }

    /// The base tangent of the section at `b`, mm, with the free gear turned by `turn` from its nominal rotation.
    fn line(&self, turn: f64, b: f64) -> Line {
        let [locked, free] = self.shafts;
        let between = self.between + b * (free - locked - self.tilts[0]);
        let d = between + UnitComplex::new(turn) * (self.displacement + b * self.tilts[1]);
        let (angle, length) = self.tangent(d.norm());
        Line {
            direction: d.y.atan2(d.x) + angle,
            length,
        }
    }

    /// Angle `θ_1` of the locked tooth `steps` counter-clockwise of the mating's tooth, without its deviation.
    fn locked_angle(&self, steps: i64) -> f64 {
        let tooth = f64::from(self.pose.mating().tooth(self.assembly.locked()));
        let turned = self.pose.locked_rotation() + self.locked.tooth_angle(tooth);
        self.mirror * (turned + steps as f64 * self.locked.gear().basic_data().angular_pitch())
    }

    /// The range of `θ_1` that can bring the contact onto the locked gear's involute.
    ///
    /// At every rotation of the free gear, `|D|` is within `e_2` of its value for `e_2 = 0`, and `arg D` within `asin` of their ratio.
    /// The range follows from `ξ_1 = arg E_1 + ψ_b1 − θ_1`.
    fn window(&self) -> RangeInclusive<f64> {
        let gear = self.locked.gear();
        let distance = self.between.norm();
        let e = self.free.eccentricity() + self.assembly.shift_bound();
        let direction = self.between.y.atan2(self.between.x) + gear.half_base_angle();
        let swing = (e / distance).min(1.0).asin();
        let slack = if self.locked.is_modified() {
            // A flank with a deviation ends at another roll, off by less than a pitch.
            gear.basic_data().angular_pitch()
        } else {
            END * gear.tip_roll()
        };
        let slack = slack + self.assembly.height_bound() * gear.basic_data().twist().abs();
        let low = direction - swing + self.tangent(distance - e).0 - gear.tip_roll();
        let high = direction + swing + self.tangent(distance + e).0 - gear.form_roll();
        // θ_1 + s lies in the range, for s over the face.
        low - slack - self.face[1]..=high + slack - self.face[0]
    }

    /// Whether a pair with these arms, mm, touches on both involutes.
    fn is_on_involutes(&self, [locked_arm, free_arm]: [f64; 2]) -> bool {
        on_involute(self.locked, locked_arm / self.locked.gear().base_radius())
            && on_involute(self.free, free_arm / self.free.gear().base_radius())
    }

    /// The stretch of the face, mm, over which a pair with these arms in the measuring plane is on the line, for gears with leads.
    fn stretch(&self, locked_arm: f64, free_arm: f64) -> Option<[f64; 2]> {
        let twist = self.mirror * self.locked.gear().basic_data().twist();
        let face = self.assembly.face();
        if twist == 0.0 {
            return self.is_on_involutes([locked_arm, free_arm]).then_some(face);
        }
        let [from, to] = self.turns_on_involutes(locked_arm, free_arm)?;
        let mut ends = [from, to].map(|turn| (turn / twist).clamp(face[0], face[1]));
        ends.sort_unstable_by(f64::total_cmp);
        Some(ends)
    }

    /// Where both leads and `smooth`, mm in powers of the place, add most over a stretch of the face, mm.
    fn tightest_place(teeth: &FacingTeeth, stretch: [f64; 2], smooth: [f64; 3]) -> f64 {
        let [at_0, slope, bend] = smooth;
        let value = |b: f64| teeth.lead_sum(b) + (at_0 + b * (slope + b * bend));
        let rate = |b: f64| teeth.lead_rate_sum(b) + (slope + 2.0 * b * bend);
        let mut places = teeth.knots(stretch, |k, height| teeth.section_of(k, height));
        places.extend(tops(&places, rate));
        // The nearest to the measuring plane comes first.
        places.sort_by_cached_key(|b| rank(b.abs()));
        let mut best = (places[0], value(places[0]));
        for b in places {
            let here = value(b);
            if here > best.1 {
                best = (b, here);
            }
        }
        best.0
    }

    /// Heights of a point on the line over the section at `b`, mm along each gear's own axis, and the turns of the flanks by twist and stretch,
    /// rad ([`section_at`](crate::pair::section_at)). The point has these rolls.
    fn leaning(&self, b: f64, turn: f64, direction: f64, rolls: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let e = Vector2::new(direction.cos(), direction.sin());
        let (mut heights, mut turns) = ([0.0; 2], [0.0; 2]);
        for (k, gear) in [self.locked, self.free].into_iter().enumerate() {
            let (gear, twist) = (gear.gear(), gear.gear().basic_data().twist());
            let (e, turned) = if k == 0 { (e, 0.0) } else { (-e, turn) };
            let lean = self.shafts[k] + UnitComplex::new(turned) * self.tilts[k];
            let normal = Vector2::new(e.y, -e.x);
            let along = gear.base_radius() * lean.dot(&(e + rolls[k] * normal));
            let square = lean.norm_squared();
            let root = (1.0 + square).sqrt();
            heights[k] = b * (root - 1.0) + along / root;
            // (1 − 1/k)/α² without cancellation.
            let stretch = along * normal.dot(&lean) / (root * (root + 1.0));
            turns[k] = self.mirror * twist * (b + heights[k]) - stretch / gear.base_radius();
        }
        (heights, turns)
    }

    /// The contact of two teeth in the section at `b`, mm, with their leads, mm.
    fn touch(&self, facing: &Facing, b: f64, leads: [f64; 2]) -> Touch {
        let (locked, free) = (self.locked.gear(), self.free.gear());
        let bases = [locked.base_radius(), free.base_radius()];
        let leans = self.assembly.leans();
        // The lead of the locked tooth moves the contact along the line, which changes its heights.
        let (moved, leads) = if leans {
            (leads[0] / bases[0], leads[1] / bases[1])
        } else {
            (0.0, (leads[0] + leads[1]) / bases[1])
        };
        let mut rate = self.free.eccentricity() / bases[1];
        if leans {
            let wound = self.assembly.height_bound() * free.basic_data().twist().abs();
            rate += wound + self.assembly.shift_bound() / bases[1];
        }
        // φ = G(φ): the error after a step is at most its length times rate/(1 − rate). Stop when that is below 1e-16 rad or when
        // steps no longer shrink. The rest is rounding, unless the base circles overlap on the way: G need not contract there, and a
        // limit of 1e-9 rad detects it.
        let (mut turn, mut last) = (0.0, f64::INFINITY);
        let (mut heights, mut turns) = ([0.0; 2], [0.0; 2]);
        loop {
            let line = self.line(turn, b);
            let locked_angle = facing.angles[0] + turns[0] - moved;
            let locked_roll = line.direction + locked.half_base_angle() - locked_angle;
            let locked_arm = bases[0] * locked_roll + deviation(facing.profiles[0], locked_roll);
            let free_arm = line.length - locked_arm;
            let mut free_roll = free_arm / bases[1];
            if facing.profiles[1].is_some() {
                // The iteration contracts: a deviation's slope is far less than the base radius.
                for _ in 0..DEVIATION_STEPS {
                    free_roll = (free_arm - deviation(facing.profiles[1], free_roll)) / bases[1];
                }
            }
            let nominal = facing.angles[1] + turns[1];
            let next =
                wrap_angle(line.direction + free.half_base_angle() - free_roll - nominal + leads);
            let step = (next - turn).abs();
            turn = next;
            let rolls = [locked_roll, free_roll];
            if leans {
                let is_first = last == f64::INFINITY;
                (heights, turns) = self.leaning(b, turn, line.direction, rolls);
                if is_first {
                    last = f64::MAX;
                    continue;
                }
            }
            if step * rate > 1e-16 * (1.0 - rate) && step < last {
                last = step;
                continue;
            }
            return Touch {
                turn,
                rolls,
                arms: [locked_arm, free_arm],
                heights,
                is_settled: step * rate < 1e-9 && line.length > 0.0,
            };
        }
    }

    /// The tightest place along the face, mm, of two teeth of leaning axes with `leads`, mm, and their leads there; `None` if they are nowhere
    /// on the line.
    fn tightest_leaning(&self, facing: &Facing, leads: [f64; 2]) -> Option<(f64, [f64; 2])> {
        let face = self.assembly.face();
        let middle = 0.5 * (face[0] + face[1]);
        let width = face[1] - face[0];
        let [near, half, far] = [face[0], middle, face[1]].map(|b| self.touch(facing, b, leads));
        let per_mm = |change: f64| if width > 0.0 { change / width } else { 0.0 };
        let mut stretch = face;
        let mut heights = [[0.0, 1.0]; 2];
        let members = [self.assembly.locked(), self.assembly.free()];
        for (k, member) in members.into_iter().enumerate() {
            let gear = self.assembly.gear(member).gear();
            let slack = END * gear.tip_roll();
            let rolls = [gear.form_roll() - slack, gear.tip_roll() + slack];
            let rate = per_mm(far.arms[k] - near.arms[k]);
            let arm = [half.arms[k] - rate * middle, rate];
            stretch = within(stretch, arm, rolls.map(|roll| gear.base_radius() * roll));
            let rate = 1.0 + per_mm(far.heights[k] - near.heights[k]);
            heights[k] = [middle + half.heights[k] - rate * middle, rate];
            stretch = within(stretch, heights[k], self.assembly.own_face(member));
        }
        let teeth = facing.teeth.with_heights(heights);
        if stretch[0] > stretch[1] {
            return None;
        }
        let base = self.free.gear().base_radius();
        let slope = per_mm(far.turn - near.turn);
        let bend = 2.0 * per_mm(per_mm(near.turn + far.turn - 2.0 * half.turn));
        let smooth = [0.0, base * (slope - 2.0 * bend * middle), base * bend];
        let b = OneSide::tightest_place(&teeth, stretch, smooth);
        Some((b, teeth.leads(b)))
    }

    /// The tightest section of two teeth whose profiles deviate, mm, and the contact there; `None` if they are nowhere on the line.
    ///
    /// Rolls on the line fall by `τ` per mm, but for the deviations. The second round takes those of the first.
    fn tightest_on_profiles(&self, facing: &Facing) -> Option<(f64, Touch)> {
        let first = (0.0, self.touch(facing, 0.0, [0.0; 2]));
        let second = self.tightest_near(facing, &first)?;
        self.tightest_near(facing, &second)
    }

    /// The tightest section, with rolls on the line that are those of the contact `known` in its section.
    ///
    /// Profiles and leads add a cubic between their knots. Its maximum is at a knot, at an end of the line or where its slope vanishes.
    fn tightest_near(&self, facing: &Facing, (at, known): &(f64, Touch)) -> Option<(f64, Touch)> {
        let gears = [self.locked, self.free].map(AsBuilt::gear);
        let twists = gears.map(|gear| self.mirror * gear.basic_data().twist());
        let roll = |k: usize, b: f64| known.rolls[k] - twists[k] * (b - at);
        let [mut from, mut to] = self.assembly.face();
        let mut own = Vec::new();
        for (k, (gear, tooth)) in facing.teeth.teeth.into_iter().enumerate() {
            let place = |roll: f64| at + (known.rolls[k] - roll) / twists[k];
            let profile = gear.profile(self.side, tooth);
            let (low, high) = profile.range(ProfilePart::Involute);
            let ends = [place(low), place(high)];
            (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
            let knots = facing.profiles[k].map_or(&[][..], DeviationCurve::knots);
            own.extend(knots.iter().map(|roll| place(*roll)));
        }
        if !(from <= to) {
            return None;
        }
        let mut places = facing.teeth.knots([from, to], |_, height| height);
        places.extend(own.into_iter().filter(|b| *b > from && *b < to));
        places.sort_unstable_by(f64::total_cmp);
        let slope = |b: f64| {
            let along = |k: usize| facing.profiles[k].map_or(0.0, |flank| flank.slope(roll(k, b)));
            facing.teeth.lead_rate_sum(b) - twists[0] * along(0) - twists[1] * along(1)
        };
        places.extend(tops(&places, slope));
        let found = places.into_iter().map(|b| {
            let twisted = Facing {
                angles: [0, 1].map(|k| facing.angles[k] + twists[k] * b),
                ..*facing
            };
            (b, self.touch(&twisted, 0.0, facing.teeth.leads(b)))
        });
        found.reduce(|best, next| {
            if next.1.turn > best.1.turn {
                next
            } else {
                best
            }
        })
    }

    /// The twists `s` of the locked teeth, from and to, with a contact on both involutes; `None` without one on the common face.
    ///
    /// The arms are the lengths of the tangents to the base circles in the measuring plane, mm. A section has the rolls `ξ_1 − s` and
    /// `ξ_2 + s r_b1/r_b2` at the same rotation (own derivation: centres do not wind, and `r_b1 τ_1 + r_b2 τ_2 = 0`). Each involute
    /// allows a range of `s`, and the face limits it.
    fn turns_on_involutes(&self, locked_arm: f64, free_arm: f64) -> Option<[f64; 2]> {
        let (locked, free) = (self.locked.gear(), self.free.gear());
        let base = locked.base_radius();
        let (roll, per_free) = (locked_arm / base, free.base_radius() / base);
        let free_roll = free_arm / free.base_radius();
        let slack = END * locked.tip_roll().max(free.tip_roll() * per_free);
        let low = (roll - locked.tip_roll()).max((free.form_roll() - free_roll) * per_free);
        let high = (roll - locked.form_roll()).min((free.tip_roll() - free_roll) * per_free);
        let (from, to) = (low.max(self.face[0]), high.min(self.face[1]));
        (from <= to + slack).then(|| [from.min(to), to])
    }

    /// The section nearest to the measuring plane in which a pair with these arms there is on the line, mm, and the twist of its locked tooth.
    fn nearest_section(&self, [locked_arm, free_arm]: [f64; 2]) -> Option<(f64, f64)> {
        if self.face == [0.0; 2] {
            return self
                .is_on_involutes([locked_arm, free_arm])
                .then_some((0.0, 0.0));
        }
        let [from, to] = self.turns_on_involutes(locked_arm, free_arm)?;
        let turned = 0f64.max(from).min(to);
        let section = if turned == 0.0 {
            0.0
        } else {
            turned / (self.mirror * self.locked.gear().basic_data().twist())
        };
        Some((section, turned))
    }

    /// The locked teeth to try, as steps counter-clockwise of the mating's tooth.
    ///
    /// Three more teeth at each end, because a flank deviates by less than three pitches. [`AsBuilt::new`] keeps pitch deviations below
    /// τ/2. Positive tips keep half a tooth's extra thickness above −τ, and positive spaces below 5τ/2.
    fn steps(&self, window: &RangeInclusive<f64>) -> RangeInclusive<i64> {
        let pitch = self.locked.gear().basic_data().angular_pitch();
        let places = |angle: &f64| {
            // More than the fraction of any pose, and within i64.
            (self.mirror * (angle - self.locked_angle(0)) / pitch).clamp(-1e15, 1e15)
        };
        let (one, other) = (places(window.start()), places(window.end()));
        one.min(other).ceil() as i64 - 3..=one.max(other).floor() as i64 + 3
    }

    /// The contact of the locked tooth `steps` places on, if its `θ_1` is in the window and the contact lies on both involutes.
    fn contact(&self, steps: i64, window: &RangeInclusive<f64>) -> Option<SideContact> {
        let locked_tooth = self
            .locked
            .counter_clockwise(self.pose.mating().tooth(self.assembly.locked()), steps);
        let theta = self.locked_angle(steps)
            + self.mirror * self.locked.flank_offset(self.side, locked_tooth);
        if !window.contains(&theta) {
            return None;
        }
        let free_tooth = self.pose.facing_tooth(self.assembly, self.side, steps);
        // Angle of the facing tooth at the nominal rotation.
        let nominal = wrap_angle(
            self.mirror
                * (self.pose.free_rotation()
                    + self.free.tooth_angle(f64::from(free_tooth))
                    + self.free.flank_offset(self.side, free_tooth)),
        );
        let free_base = self.free.gear().base_radius();
        if self.free.eccentricity() >= free_base {
            return None;
        }
        let teeth = [(self.locked, locked_tooth), (self.free, free_tooth)];
        let facing = Facing {
            teeth: FacingTeeth::new(self.side, teeth),
            profiles: teeth.map(|(gear, tooth)| gear.modification(self.side, tooth)),
            angles: [theta, nominal],
        };
        // The leads' part of G, and the rounds in which it settles: the stretch on the line moves with it.
        let (mut leads, mut rounds) = ([0.0; 2], 0);
        let (section, turned, touch) = loop {
            if self.assembly.binds_along_profiles() {
                let (section, touch) = self.tightest_on_profiles(&facing)?;
                break (section, 0.0, touch);
            }
            if !self.assembly.deviates_along_face() {
                let touch = self.touch(&facing, 0.0, [0.0; 2]);
                let (section, turned) = self.nearest_section(touch.arms)?;
                break (section, turned, touch);
            }
            let (section, more, plane) = if self.assembly.leans() {
                let (section, more) = self.tightest_leaning(&facing, leads)?;
                (section, more, section)
            } else {
                let touch = self.touch(&facing, 0.0, leads);
                let stretch = self.stretch(touch.arms[0], touch.arms[1])?;
                let section = OneSide::tightest_place(&facing.teeth, stretch, [0.0; 3]);
                (section, facing.teeth.leads(section), 0.0)
            };
            let change = (more[0] + more[1]) - (leads[0] + leads[1]);
            if change.abs() <= LEADS_SETTLED * free_base || rounds >= MOST_ROUNDS {
                let twist = self.mirror * self.locked.gear().basic_data().twist();
                let turned = twist * (section - plane);
                break (section, turned, self.touch(&facing, plane, leads));
            }
            (leads, rounds) = (more, rounds + 1);
        };
        touch.is_settled.then(|| SideContact {
            rotation: self.pose.free_rotation() + self.mirror * touch.turn,
            locked_tooth,
            free_tooth,
            locked_roll: touch.rolls[0] - turned,
            free_roll: touch.rolls[1] + turned * self.locked.gear().base_radius() / free_base,
            section,
        })
    }
}

/// Change of a rotation by leads, rad, at which they are settled, and the rounds to it: each leaves a share of the leads' slope.
const LEADS_SETTLED: f64 = 1e-15;
const MOST_ROUNDS: u32 = 8;

/// Steps for the roll with a deviation. Each divides the error by `r_b/δ'`, some hundreds.
const DEVIATION_STEPS: u32 = 6;

/// A flank's deviation at a roll, mm.
fn deviation(flank: Option<&DeviationCurve>, roll: f64) -> f64 {
    flank.map_or(0.0, |flank| flank.at(roll))
}

/// The part of `stretch` over which a line, in powers of the place, is between `least` and `most`.
fn within(stretch: [f64; 2], [at_0, rate]: [f64; 2], [least, most]: [f64; 2]) -> [f64; 2] {
    let [one, other] = [least, most].map(|end| (end - at_0) / rate);
    [
        stretch[0].max(one.min(other)),
        stretch[1].min(one.max(other)),
    ]
}

/// Whether the involute's point at `roll` lies between form and tip circle.
fn on_involute(gear: &AsBuilt, roll: f64) -> bool {
    let (form, tip) = (gear.gear().form_roll(), gear.gear().tip_roll());
    form - END * tip <= roll && roll <= tip + END * tip
}

/// The tightest contact of each side; `None` without contact on the line of action.
///
/// Pairs within rounding, as of perfect gears, tie: any of them may be the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOfAction {
    /// The contact that limits clockwise rotation.
    pub right: Option<SideContact>,
    /// The contact that limits counter-clockwise rotation.
    pub left: Option<SideContact>,
}

impl LineOfAction {
    /// The tightest contacts at `pose`.
    pub fn new(assembly: &GearPair, pose: &Pose) -> LineOfAction {
        // Clockwise rotation stops at the greatest contact rotation, counter-clockwise rotation at the least.
        let tightest = |side: Side| {
            SideContact::all(assembly, pose, side).reduce(|best, next| {
                if side.sense() * (next.rotation - best.rotation) < 0.0 {
                    next
                } else {
                    best
                }
            })
        };
        LineOfAction {
            right: tightest(Side::Right),
            left: tightest(Side::Left),
        }
    }

    /// Lost motion `φ_j` = left − right, rad.
    pub fn angle(&self) -> Option<f64> {
        Some(self.left?.rotation - self.right?.rotation)
    }

    /// Circumferential backlash `j_wt = φ_j r_w` of the free gear, mm.
    pub fn backlash(&self, assembly: &GearPair) -> Option<f64> {
        Some(self.angle()? * assembly.operating_pitch_radius(assembly.free()))
    }
}

/// Places between neighbouring `places` at which a rate falls through 0.
fn tops(places: &[f64], rate: impl Fn(f64) -> f64) -> Vec<f64> {
    let tops = places.windows(2).filter_map(|ends| {
        let beside = 1e-9 * (ends[1] - ends[0]);
        let (low, high) = (ends[0] + beside, ends[1] - beside);
        (rate(low) > 0.0 && rate(high) < 0.0).then(|| bisect(low, high, 0.0, |b| rate(b) > 0.0)[0])
    });
    tops.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign, Hand};
    use crate::pair::Mating;

    /// No contact exists outside the window. Source: the contact of every tooth. The gears are eccentric, either one locked. One is
    /// undercut, so its involutes begin within the path of contact. Helical gears have faces on either side of the measuring plane.
    #[test]
    fn no_tooth_that_touches_is_outside_the_window() {
        let (mut found, mut beside) = (0, 0);
        for (face, free_off, teeth) in [[0.0, 0.0], [-70.0, -20.0], [15.0, 80.0], [-30.0, 45.0]]
            .into_iter()
            .flat_map(|face| [(face, 0.0), (face, 1.4)])
            .flat_map(|(face, off)| [[19, 23], [8, 47]].map(|teeth| (face, off, teeth)))
        {
            let helix_deg = if face == [0.0; 2] { 0.0 } else { 17.0 };
            let gear = |teeth, side, hand, eccentricity| {
                let design = GearDesign::plain(teeth, 3.0).helical(helix_deg, hand);
                design.built(side, &Deviations::off_axis(eccentricity, 2.3))
            };
            let wheel = gear(teeth[0], Face::Front, Hand::Right, 0.9);
            let pinion = gear(teeth[1], Face::Back, Hand::Left, free_off);
            let sum = f64::from(teeth[0] + teeth[1]);
            let distance = 1.5 * sum / helix_deg.to_radians().cos() + 2.6;
            for locked in Member::BOTH {
                let gears = (wheel.clone(), pinion.clone());
                let pair = GearPair::with_locked(gears.0, gears.1, distance, locked);
                let pair = pair.unwrap().with_face(face).unwrap();
                for (k, side) in (0..400u32).flat_map(|k| Side::BOTH.map(|side| (k, side))) {
                    let mating = Mating {
                        fraction: f64::from(k % 13) / 13.0,
                        ..Mating::at(1 + k % teeth[0], 1 + (5 * k) % teeth[1], Side::Right)
                    };
                    let pose = Pose::new(&pair, mating);
                    let own: Vec<SideContact> =
                        OneSide::new(&pair, &pose, side).contacts().collect();
                    let one = OneSide::new(&pair, &pose, side);
                    let anywhere = f64::NEG_INFINITY..=f64::INFINITY;
                    let each = (-60..=60).filter_map(|steps| one.contact(steps, &anywhere));
                    assert_eq!(own, each.collect::<Vec<_>>(), "{face:?} {free_off} {k}");
                    found += own.len();
                    beside += own.iter().filter(|contact| contact.section != 0.0).count();
                }
            }
        }
        assert!(found > 10_000 && beside > 2000, "{found} {beside}");
    }
}
