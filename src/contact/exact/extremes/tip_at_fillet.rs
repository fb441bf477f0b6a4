//! A tip corner below its mate's form circle: a bound of its clearance from the fillet over many poses.
//!
//! Below the form circle the mate has a fillet instead of an involute. It is hollow ([`super::super::search_free_proof`], 2.), so its
//! chords are outside the metal. Take a point with a radius between those of a chord's ends. It is clear while it is in front of the
//! chord's line, and of the lines of all radii that it passes. Let the pair touch on the line of action, or where its extended involutes
//! would. Let `h` be the distance of the corner from the chord's line there, and `ρ` the radius about the free axis. Then the free gear has
//! to turn by at least `h/ρ` more until the corner meets the fillet. [`tip_clearance`](super::clearance::tip_clearance) bounds this.
//!
//! Two centred gears with the outlines' centre distance `d` represent any pose. The gap of the involutes is `μ = (Σ α − T − r_bL (λ −
//! ψ_bL))/r_bF + ψ_bF`. With `i = r_bL/r_bF` and growing `λ`, the acceleration of a free corner in the mate's frame is at most `d + (1 +
//! i)² ρ`. For a locked corner at `C` it is at most `(1 + 2i) d − (1 + i)² C`.

use super::super::line::Line;
use super::super::placed::Role;
use super::super::shape::{C, HalfToothShape, turn};
use crate::contact::gap::{dot, length};
use crate::gear::ProfilePart;
use std::f64::consts::PI;

/// Chords of a fillet (tuned: 16 are within 1/400 of its radius).
const CHORDS: usize = 16;

/// Clearances above this are not distinguished, rad (a tenth of a pitch of 30 teeth: more than flanks differ).
pub(super) const FARTHEST: f64 = 0.02;

/// A half plane that contains the metal between two radii.
#[derive(Debug, Clone, Copy)]
struct FilletChord {
    radii: (f64, f64),
    point: C,
    normal: C,
}

/// The tip corner of one gear and the fillet of its mate.
#[derive(Debug, Clone)]
pub(super) struct TipAtFillet {
    pub owner: Role,
    /// Least `γ` of the fillet in reach.
    pub deepest: f64,
    pub(super) locked: TipData,
    pub(super) free: TipData,
    /// Chords of the fillet, from the joint inwards.
    chords: Vec<FilletChord>,
    /// Greatest distance of the locked half tooth's angle from `middle` while the corner is below the form circle, at the least distance.
    half: f64,
    middle: f64,
}

/// The data of a gear that the path of its tip corner needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct TipData {
    pub base: f64,
    half_base: f64,
    pub corner: C,
    /// Distance of the corner from the axis.
    reach: f64,
}

impl TipData {
    fn new(shape: &HalfToothShape) -> TipData {
        let corner = shape.corners()[0].1;
        TipData {
            base: shape.base,
            half_base: shape.half_base,
            corner,
            reach: corner.norm(),
        }
    }
}

impl TipAtFillet {
    /// The corner of the gear `owner`, down to `deepest`, the least `γ` of the mate's fillet that it reaches. `least` is the least distance
    /// of the outlines' centres. `None` if the corner stays above the form circle.
    pub fn new(
        owner: Role,
        [locked, free]: [&HalfToothShape; 2],
        deepest: f64,
        least: f64,
    ) -> Option<TipAtFillet> {
        let (mate, corner) = match owner {
            Role::Locked => (free, locked.corners()[0].1),
            Role::Free => (locked, free.corners()[0].1),
        };
        // Locked corner: |d − e^{iλ} p| below the form radius. Free corner: the locked joint inside the free tip circle.
        let (turning, own, other) = match owner {
            Role::Locked => (corner, locked.tip_radius, free.form_radius()),
            Role::Free => (locked.joint, locked.form_radius(), free.tip_radius),
        };
        let cos = (least * least + own * own - other * other) / (2.0 * least * own);
        if cos >= 1.0 {
            return None;
        }
        let points: Vec<C> = (0..=CHORDS)
            .map(|k| {
                let part = k as f64 / CHORDS as f64;
                let gamma = mate.fillet_end + (deepest - mate.fillet_end) * part;
                mate.at(ProfilePart::Fillet, gamma).point
            })
            .collect();
        let chords = points.windows(2).map(|ends| {
            let along = ends[1] - ends[0];
            // The right-hand half tooth has its metal on the left of the inward direction.
            let normal = -C::i() * along / along.norm();
            let sign = if normal.im > 0.0 { -1.0 } else { 1.0 };
            FilletChord {
                radii: (ends[1].norm(), ends[0].norm()),
                point: ends[0],
                normal: normal * sign,
            }
        });
        Some(TipAtFillet {
            owner,
            deepest,
            locked: TipData::new(locked),
            free: TipData::new(free),
            chords: chords.collect(),
            half: cos.max(-1.0).acos(),
            middle: -turning.arg(),
        })
    }

    /// Whether the corner can be below the form circle while the locked half tooth is within `play` of the angle `at`.
    pub fn may_be_below_form(&self, at: f64, play: f64) -> bool {
        let off = at - self.middle;
        let off = off - 2.0 * PI * (off / (2.0 * PI)).round();
        off.abs() <= self.half + play
    }

    /// The gap at which the endless involutes touch on `line`, with the locked half tooth at the angle `at`.
    pub(super) fn gap(&self, at: f64, line: &Line) -> f64 {
        let (locked, free) = (&self.locked, &self.free);
        ((locked.base + free.base) * line.angle
            - line.length
            - locked.base * (at - locked.half_base))
            / free.base
            + free.half_base
    }

    /// Curvature of `h/ρ` over the distance: of the gap cos² α/(d sin α r_bF) and sin² α/r_bF², times ρ.
    pub fn bend(&self, distance: f64) -> f64 {
        let sum = self.locked.base + self.free.base;
        let cos = sum / distance;
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let per_base = 1.0 / self.free.base;
        cos * cos / (distance * sin) * per_base + (sin * per_base).powi(2)
    }

    /// The corner at a centre distance with its line of action, while the locked half tooth is within `play` of the angle `at`.
    fn corner(&self, at: f64, play: f64, (distance, line): &(f64, Line)) -> MovingCorner {
        let (distance, ratio) = (*distance, self.locked.base / self.free.base);
        let (locked, free) = (&self.locked, &self.free);
        let (l, f) = (-turn(at), turn(self.gap(at, line)));
        let (point, velocity, radius, by_gap) = match self.owner {
            Role::Locked => {
                let corner = C::from(distance) + l * locked.corner;
                let moving = C::i() * l * locked.corner;
                let seen = corner * f.conj();
                let by_gap = -C::i() * seen;
                (
                    seen,
                    moving * f.conj() - ratio * by_gap,
                    length(corner),
                    by_gap,
                )
            }
            Role::Free => {
                let corner = f * free.corner;
                let seen = (corner - C::from(distance)) * l.conj();
                let moving = -C::i() * ratio * corner;
                let by_gap = C::i() * corner * l.conj();
                (seen, moving * l.conj() - C::i() * seen, free.reach, by_gap)
            }
        };
        let speed = length(velocity);
        let square = (1.0 + ratio).powi(2);
        let acceleration = match self.owner {
            Role::Locked => {
                let corner = C::from(distance) + l * locked.corner;
                let corner = (1.0 + 2.0 * ratio) * distance - corner * square;
                length(corner) + square * locked.reach * play
            }
            Role::Free => distance + square * (radius + speed * play),
        };
        let jolt = 0.5 * acceleration * play * play;
        MovingCorner {
            point,
            velocity,
            speed,
            radius,
            by_gap,
            jolt,
            moved: speed * play + jolt,
            turned: (speed + (1.0 + ratio) * radius) * play + jolt,
        }
    }

    /// The clearance at one distance and its line, with the locked half tooth within `play` of the angle `at`, and whether the corner may be
    /// above the form circle.
    pub(super) fn at_distance(&self, at: f64, play: f64, line: &(f64, Line)) -> (f64, bool) {
        let corner = self.corner(at, play, line);
        let clearance = self.clearance_of(&corner, play);
        (clearance, self.may_be_above(&corner, clearance))
    }

    /// Whether the corner may be above the form circle at a contact with this clearance or a greater one.
    fn may_be_above(&self, corner: &MovingCorner, clearance: f64) -> bool {
        let Some(chord) = self.chords.first() else {
            return true;
        };
        let off = length(corner.point);
        let way = match self.owner {
            Role::Locked => 0.0,
            Role::Free => {
                // A point at `p` with the velocity `p'` and an acceleration of at most `ρ` is within
                // `|p| + p·p'/|p| t + (ρ²/|p| + ρ) t²/2` after the turn `t`.
                let outwards = dot(corner.by_gap, corner.point) / off;
                let radius = corner.radius;
                let bend = 0.5 * radius * (1.0 + radius / (off - corner.moved));
                let way = |rate: f64, by: f64| (rate.max(0.0) + corner.turned + bend * by) * by;
                way(outwards, (-clearance).max(0.0)).max(way(-outwards, FARTHEST))
            }
        };
        !(off + corner.moved + way < chord.radii.1)
    }

    /// The clearance of the corner while the locked half tooth moves by `play`.
    fn clearance_of(&self, corner: &MovingCorner, play: f64) -> f64 {
        let MovingCorner {
            point,
            velocity,
            speed,
            radius,
            by_gap,
            jolt,
            moved,
            turned,
        } = *corner;
        let off = length(point);
        let band = (off - moved, off + moved);
        let least = |chord: &FilletChord| {
            let height = dot(point - chord.point, chord.normal);
            let rate = dot(velocity, chord.normal);
            let height = height - rate.abs() * play - jolt;
            // As the free gear turns, the height changes by this arm, and the arm by the radius.
            let arm = dot(by_gap, chord.normal);
            let reach = radius + speed * play;
            if height >= 0.0 {
                let arm = (arm + turned).max(0.0);
                return 2.0 * height / (arm + (arm * arm + 2.0 * reach * height).sqrt());
            }
            let arm = arm - turned;
            let square = arm * arm + 2.0 * reach * height;
            if arm > 0.0 && square > 0.0 {
                2.0 * height / (arm + square.sqrt())
            } else {
                f64::NEG_INFINITY
            }
        };
        // No corner is deeper than the chords. On its way to the fillet, or out of it, a free corner changes its radius.
        let over = |way: f64| {
            let radial = dot(by_gap, point).abs() / off + turned;
            let (low, high) = (band.0 - radial * way, band.1 + radial * way);
            // From the joint inwards their radii fall.
            let first = self.chords.partition_point(|chord| chord.radii.0 > high);
            let reached = self.chords[first..].iter();
            let reached = reached.take_while(|chord| chord.radii.1 >= low);
            reached.map(least).fold(f64::INFINITY, f64::min)
        };
        if self.owner == Role::Locked {
            return over(0.0);
        }
        let way = |clearance: f64| clearance.min(FARTHEST).abs();
        let first = over(0.0);
        let found = over(1.5 * way(first).min(1.0));
        if way(found) <= 1.5 * way(first) {
            found.min(FARTHEST)
        } else {
            over(f64::MAX)
        }
    }
}

/// A tip corner in its mate's frame.
struct MovingCorner {
    point: C,
    /// Its velocity, by the turn of the locked gear, and its length.
    velocity: C,
    speed: f64,
    /// Its radius about the free axis, mm.
    radius: f64,
    /// Its velocity by the turn of the free gear.
    by_gap: C,
    /// Second-order part of its path, mm.
    jolt: f64,
    /// Bound of its path over the turn of the locked gear, mm.
    moved: f64,
    /// Bound of the change of `by_gap` on this path, and of its component along a normal that turns with the mate.
    turned: f64,
}

#[cfg(test)]
mod tests {
    use super::super::mesh_cycle::MeshCycle;
    use super::*;
    use crate::contact::{Effort, ExactKernel};
    use crate::gear::{Deviations, Face, GearDesign};
    use crate::pair::{GearPair, Mating};

    /// A corner leaves its tangent by no more than its second-order bound, and by more than a tenth of it. Source: the corner of other poses.
    #[test]
    fn a_corner_stays_within_its_second_order_bound() {
        let built = |z, face| GearDesign::plain(z, 1.0).built(face, &Deviations::default());
        let pair = GearPair::new(built(20, Face::Front), built(60, Face::Back), 40.05).unwrap();
        let kernel = ExactKernel::new(&pair);
        let effort = Effort::endless();
        let cycle = MeshCycle::new(&kernel, &pair, (Mating::FIRST, 1), &effort);
        let tips_at_fillets: Vec<&TipAtFillet> = cycle
            .sides
            .iter()
            .flat_map(|side| &side.tips_at_fillets)
            .collect();
        assert!(!tips_at_fillets.is_empty());
        for tip in tips_at_fillets {
            let line = Line::new(C::from(40.05), tip.locked.base + tip.free.base).unwrap();
            let line = (40.05, line);
            let play = 0.03;
            let mut most = 0.0f64;
            for off in [-0.8, -0.3, 0.0, 0.4, 0.9] {
                let at = tip.middle + off * tip.half;
                let corner = tip.corner(at, play, &line);
                for part in [-1.0, -0.5, 0.5, 1.0] {
                    let there = tip.corner(at + part * play, 0.0, &line);
                    let left = there.point - corner.point - corner.velocity * (part * play);
                    most = most.max(length(left) / corner.jolt);
                }
            }
            assert!((0.1..=1.0).contains(&most), "{:?}: {most}", tip.owner);
        }
    }
}
