//! Extremes over all places of the axes that a pair leaves open: a misalignment without a direction, bearings with clearance at both ends.
//!
//! Let the pinion's axis be displaced by `u(b)` at the place `b` along the axes, in any way within its limits. At a pose the tightness of a contact, along
//! the base tangent, is
//!
//! ```text
//! f = f_0 + n·u(b) − (a square),        0 ≤ square ≤ |u(b)|²/(2 ρ)
//! ```
//!
//! with the normal `n` of its side and the least radius of curvature `ρ` of an involute. The second-order part of leans (see
//! [`section_at`](crate::pair::section_at)) is a square of the other sign, so it is greatest at a corner too. The lost motion is `−max f_R − max f_L`.
//!
//! **Least.** A linear `f` is greatest at a corner of a polygon that holds all displacements. So no place has less lost motion than the worst
//! corner, but for the squares of both sides. (A corner that meets a corner or a land jams, which is reported as such.) The corners of a
//! misalignment are possible themselves. A disc of clearance lies within its polygon, so its bracket is wider.
//!
//! **Greatest.** No pair has more lost motion than any of its sections, and that grows with the distance of its axes. One section bounds it:
//! that whose axes can move least. Leans also change the heights at which its teeth touch, and with them twist and leads. A height that both
//! sides share only screws the free gear on. So the twist adds at most `tan β_b θ |P_R − P_L|` along the base tangent, with the contacts `P`
//! inside of both tip circles.
//!
//! A displacement across the line of centres turns it. That is another pose of the cycle, but for the turn of the lean, of the second order.

use crate::contact::first_least;
use crate::error::GearError;
use crate::pair::{FaceDeviation, GearPair, Member, overlap_half_angle};
use std::f64::consts::PI;

/// Bearings of both gears together, whose clearance differs from one end of the shafts to the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingEnds {
    /// Both places along the axes, mm from the wheel's measuring plane.
    pub at: [f64; 2],
    /// Radial clearance `c` of both gears together at each, mm.
    pub clearance: [f64; 2],
}

impl BearingEnds {
    /// How much a displacement at each bearing moves the axis at `b`.
    fn weights(&self, b: f64) -> [f64; 2] {
        let [one, other] = self.at;
        [(other - b) / (other - one), (b - one) / (other - one)]
    }

    /// Clearance at `b`, mm.
    pub fn clearance_at(&self, b: f64) -> f64 {
        let [one, other] = self.weights(b);
        one.abs() * self.clearance[0] + other.abs() * self.clearance[1]
    }
}

/// A place of the pinion's axis, from that of the pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axis {
    /// Its distance from the wheel's axis beyond the stated one, in the measuring plane, mm.
    farther: f64,
    /// In the plane of the axes and out of it, mm per mm.
    lean: [f64; 2],
}

impl Axis {
    const AS_STATED: Axis = Axis {
        farther: 0.0,
        lean: [0.0; 2],
    };

    fn plus(&self, other: &Axis) -> Axis {
        Axis {
            farther: self.farther + other.farther,
            lean: [0, 1].map(|k| self.lean[k] + other.lean[k]),
        }
    }

    /// `pair` with its axis here.
    pub fn of(&self, pair: &GearPair) -> Result<GearPair, GearError> {
        let lean = [0, 1].map(|k| pair.lean()[k] + self.lean[k]);
        pair.at(pair.center_distance() + self.farther)?
            .with_lean(lean)
    }
}

/// The places of the pinion's axis that a pair leaves open.
#[derive(Debug, Clone)]
pub(super) struct Axes {
    /// Corners of polygons that contain every place; empty if they are `possible` themselves.
    pub corners: Vec<Axis>,
    /// Possible places, among them those expected to be worst.
    pub possible: Vec<Axis>,
    misalignment: [f64; 2],
    bearings: Option<BearingEnds>,
}

/// Corners of a polygon about a disc of `radius`, mm. `sense` is 1 where only displacements towards the mate count, −1 where only those away
/// from it count, and 0 where all do.
fn about_disc(radius: f64, sense: f64, pressure_angle: f64) -> Vec<[f64; 2]> {
    let (step, count) = if sense == 0.0 {
        (PI / 4.0, 8)
    } else {
        // Sums of the normals of both sides lie within a right angle less the pressure angle of the line of centres.
        ((PI - 2.0 * pressure_angle) / 3.0, 3)
    };
    let towards = if sense < 0.0 { 0.0 } else { PI };
    let radius = radius / (0.5 * step).cos();
    let angles = (0..count).map(|k| towards + step * (f64::from(k) - 1.0));
    angles
        .map(|angle| [radius * angle.cos(), radius * angle.sin()])
        .collect()
}

impl Axes {
    /// The axes of `pair` with this unknown `misalignment`, at most, mm per mm, and with clearance in these `bearings`.
    pub fn new(pair: &GearPair, misalignment: [f64; 2], bearings: Option<BearingEnds>) -> Axes {
        let signs = misalignment.map(|most| {
            if most == 0.0 {
                vec![0.0]
            } else {
                vec![-most, most]
            }
        });
        let [in_plane, out_of_plane] = &signs;
        let leans = in_plane
            .iter()
            .flat_map(|x| out_of_plane.iter().map(move |y| [*x, *y]));
        let leans: Vec<Axis> = leans.map(|lean| Axis { farther: 0.0, lean }).collect();
        let mut axes = Axes {
            possible: leans.clone(),
            corners: leans,
            misalignment,
            bearings,
        };
        let Some(bearings) = bearings else {
            // The corners are possible.
            axes.corners.clear();
            axes.possible.push(Axis::AS_STATED);
            return axes;
        };
        let [from, to] = pair.face().map(|end| bearings.weights(end));
        let angle = pair.operating_pressure_angle();
        let discs = [0, 1].map(|k| {
            let sense = if from[k] * to[k] < 0.0 {
                0.0
            } else {
                (from[k] + to[k]).signum()
            };
            about_disc(bearings.clearance[k], sense, angle)
        });
        let [one, other] = bearings.at;
        let axis = |u: &[f64; 2], v: &[f64; 2]| Axis {
            farther: (u[0] * other - v[0] * one) / (other - one),
            lean: [0, 1].map(|k| (v[k] - u[k]) / (other - one)),
        };
        let corners = discs[0].iter();
        let corners = corners.flat_map(|u| discs[1].iter().map(move |v| axis(u, v)));
        let mut corners: Vec<Axis> = corners.collect();
        // Right flanks that bind at one end of the face, and left ones at one: both bearings move along the sum of their normals.
        let ends = [[from, from], [from, to], [to, from], [to, to]];
        let mut possible: Vec<Axis> = ends
            .iter()
            .map(|[right, left]| {
                let [u, v] = [0, 1].map(|k| {
                    let sum = [
                        -(right[k] + left[k]) * angle.sin(),
                        (right[k] - left[k]) * angle.cos(),
                    ];
                    let length = sum[0].hypot(sum[1]);
                    sum.map(|part| {
                        if length > 0.0 {
                            bearings.clearance[k] * part / length
                        } else {
                            0.0
                        }
                    })
                });
                axis(&u, &v)
            })
            .collect();
        let apart = [0, 1].map(|k| (from[k] + to[k]).signum() * bearings.clearance[k]);
        possible.push(axis(&[apart[0], 0.0], &[apart[1], 0.0]));
        for list in [&mut corners, &mut possible] {
            *list = list
                .iter()
                .flat_map(|one| axes.corners.iter().map(move |lean| one.plus(lean)))
                .collect();
        }
        (axes.corners, axes.possible) = (corners, possible);
        axes
    }

    /// Bound on the displacement of an axis at `b`, mm.
    fn reach(&self, b: f64) -> f64 {
        let [x, y] = self.misalignment;
        let clearance = self.bearings.map_or(0.0, |ends| ends.clearance_at(b));
        b.abs() * x.hypot(y) + clearance
    }

    /// The place on the face whose section can move least; the reach is linear between these.
    fn least_moved_section(&self, [from, to]: [f64; 2]) -> f64 {
        let bearings = self.bearings.map_or([0.0; 2], |bearings| bearings.at);
        let places = [from, 0.0, bearings[0], bearings[1], to].map(|b| b.clamp(from, to));
        let least = first_least(places.into_iter().map(|b| (b, self.reach(b), 0.0)));
        least.unwrap_or(from)
    }

    /// The section of `pair` whose axes can move least, with the axes as far apart as they can move.
    pub fn section(&self, pair: &GearPair) -> Result<GearPair, GearError> {
        let b = self.least_moved_section(pair.face());
        let [x, y] = pair.lean().map(|lean| lean * b);
        let distance = (pair.center_distance() + x).hypot(y) + self.reach(b);
        // The teeth of gears that lean miss each other in a single section.
        pair.section(b)
            .without(&[FaceDeviation::Wobble])
            .at(distance)
    }

    /// Bound on the further lost motion of a section of `pair` by the heights of its contacts, mm along the base tangent.
    pub fn contact_height_bound(&self, pair: &GearPair) -> f64 {
        let [x, y] = self.misalignment;
        let tilt = self.bearings.map_or(0.0, |bearings| {
            let [one, other] = bearings.at;
            (bearings.clearance[0] + bearings.clearance[1]) / (other - one).abs()
        });
        let gears = Member::BOTH.map(|member| pair.gear(member));
        let [wheel, pinion] = gears.map(|gear| gear.reach());
        let [from, to] = pair.face();
        let nearest =
            pair.center_distance() - (self.reach(from).max(self.reach(to)) + pair.shift_bound());
        let half = overlap_half_angle(wheel, pinion, nearest).unwrap_or(0.0);
        let across = 2.0 * wheel * half.min(0.5 * PI).sin();
        let apart = across.hypot((wheel + pinion - nearest).max(0.0));
        let tan_base_helix = gears[0].gear().basic_data().base_helix_angle().tan();
        // The pinion's shaft leans from the wheel's, and both toothings from their shafts.
        let shaft = pair.lean()[0].hypot(pair.lean()[1]) + x.hypot(y) + tilt;
        let leans = [gears[0].wobble(), gears[1].wobble() + shaft];
        let by_gear = [0, 1].map(|k| {
            let height = leans[k] * gears[k].reach();
            let steepest = gears[k].steepest_lead([from - height, to + height]);
            // Leads at other heights on both sides, and the stretch of a section, half of the lean's square on each.
            height * (2.0 * steepest + leans[k])
        });
        tan_base_helix * (leans[0] + leans[1]) * apart + by_gear[0] + by_gear[1]
    }

    /// Bound on the squares of both sides, mm along the base tangent.
    pub fn second_order_bound(&self, pair: &GearPair) -> f64 {
        let [from, to] = pair.face();
        let reach = self.reach(from).max(self.reach(to));
        let radii = Member::BOTH.map(|member| {
            let gear = pair.gear(member).gear();
            gear.base_radius() * gear.form_roll()
        });
        // Where an involute ends on its base circle, by the displacement itself: no lever is shorter than half of the base radius.
        2.0 * (reach * reach / (2.0 * radii[0].min(radii[1]))).min(2.0 * reach)
    }
}
