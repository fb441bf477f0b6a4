//! Where along the face an edge may touch a fillet tightest.
//!
//! Along `b` the teeth roll on circles about both centres of a section, whose common point `P`, the pitch point, stands still. A gap between an
//! edge and a smooth curve is stationary in `b` where the curve's normal passes through `P`. On a fillet the normal at `γ` passes through
//! a point of the generating pitch circle, `r sin γ` from the gear's centre; through `P`, `r_w` from it, it runs at
//! `ω = asin(r sin γ/r_w)` from the line of centres, and the fillet's point stands `r cos γ − L − r_w cos ω` from `P` along it. That
//! the edge's radius about its own centre leads there is one equation for `γ`, common to all teeth; the turn of the locked tooth, and
//! with it `b`, follows. Where two edges cross, the tightest may stand as well: both circles' intersection says where.
//!
//! These are places to look at: a section's own method finds what touches there.

use crate::contact::exact::flank_problem::{FlankProblem, PosedFlanks};
use crate::contact::exact::shape::{C, Shape};
use crate::contact::exact::teeth::reduced;
use crate::pair::{GearPair, Member};
use std::f64::consts::PI;

/// Stretches of a fillet in which a change of sign is looked for: a fillet's equation has one root, or none, but for hanging-over ones.
const STRETCHES: u32 = 24;

/// Bisections of a root: to the last bit.
const HALVINGS: u32 = 52;

/// Of which gear a fillet may be touched.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edges {
    on_locked: bool,
    on_free: bool,
    /// Whether tips may come to the mate's root, which may jam the pair.
    jams: bool,
}

impl Edges {
    /// `None` where no tip of `assembly`, whose right-hand half teeth are those of `problem`, comes to a fillet.
    pub fn new(assembly: &GearPair, problem: &FlankProblem) -> Option<Edges> {
        let off = problem.locked_off.norm() + problem.free_off.norm();
        let nearest = assembly.center_distance() - off;
        let reached = |fillet: &Shape, tip: &Shape| nearest - tip.tip_radius < fillet.form_radius();
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let jams = |root: &Shape, tip: &Shape| nearest - tip.tip_radius < root.root_radius;
        let edges = Edges {
            on_locked: reached(locked, free),
            on_free: reached(free, locked),
            jams: jams(locked, free) || jams(free, locked),
        };
        (edges.on_locked || edges.on_free).then_some(edges)
    }

    /// Places on the face, mm, at a pose of the measuring plane with the free gear at `rotation`, rad, in the frame of `posed`.
    pub fn places(&self, assembly: &GearPair, posed: &PosedFlanks, rotation: f64) -> Vec<f64> {
        let (locked, free) = (&posed.problem.locked.shape, &posed.problem.free.shape);
        let (c_l, c_f) = (posed.centre, posed.free_centre_at(rotation));
        let mut places = Vec::new();
        if self.jams {
            // Tips are deepest on the line of centres.
            let [locked, free] = [
                Turning::locked(assembly, posed),
                Turning::free(assembly, posed, rotation),
            ];
            locked.places((c_f - c_l).arg(), &mut places);
            free.places((c_l - c_f).arg(), &mut places);
        }
        let turning = Turning::locked(assembly, posed);
        let mut take = |direction: f64| turning.places(direction, &mut places);
        for &(_, edge) in free.corners() {
            if self.on_locked {
                for (gamma, lean, _) in
                    touches(locked, (c_l, c_f), locked.base, free.base, edge.norm())
                {
                    take((c_f - c_l).arg() - lean + gamma - locked.fillet.pitch_angle(gamma));
                }
            }
            for &(_, other) in locked.corners() {
                for point in crossings((c_l, other.norm()), (c_f, edge.norm())) {
                    take((point - c_l).arg() - other.arg());
                }
            }
        }
        if self.on_free {
            for &(_, edge) in locked.corners() {
                for (.., point) in touches(free, (c_f, c_l), free.base, locked.base, edge.norm()) {
                    take((point - c_l).arg() - edge.arg());
                }
            }
        }
        places
    }
}

/// How the teeth of one gear stand along the face, in the frame of a pose.
struct Turning<'a> {
    face: [f64; 2],
    /// Rad a mm along the axis.
    twist: f64,
    /// Direction of the tooth of step 0 in the measuring plane, undisturbed, rad.
    ahead: f64,
    /// From one step to the next, rad.
    step: f64,
    /// What the flank of a step stands turned beyond its place, rad.
    offset: Box<dyn Fn(i64) -> f64 + 'a>,
}

impl<'a> Turning<'a> {
    fn new(assembly: &GearPair, posed: &PosedFlanks, member: Member) -> Turning<'a> {
        Turning {
            face: assembly.face(),
            twist: posed.mirror() * assembly.gear(member).gear().basic_data().twist(),
            ahead: 0.0,
            step: 0.0,
            offset: Box::new(|_| 0.0),
        }
    }

    fn locked(assembly: &GearPair, posed: &'a PosedFlanks) -> Turning<'a> {
        Turning {
            ahead: PI + posed.ahead,
            step: posed.problem.locked.pitch,
            offset: Box::new(|step| posed.locked_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.locked())
        }
    }

    fn free(assembly: &GearPair, posed: &'a PosedFlanks, rotation: f64) -> Turning<'a> {
        Turning {
            ahead: rotation + posed.free_angle(),
            step: -posed.problem.free.pitch,
            offset: Box::new(|step| posed.free_offset_at(step)),
            ..Turning::new(assembly, posed, assembly.free())
        }
    }

    /// Adds the places on the face, mm, at which a tooth's centre line has `direction`, rad.
    fn places(&self, direction: f64, places: &mut Vec<f64>) {
        let [from, to] = self.face;
        let ahead = reduced(direction - self.ahead);
        let ends = [from, to].map(|b| (ahead - self.twist * b) / self.step);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        // A pitch more: flanks may stand off their places.
        for step in (low - 1.0).floor() as i64..=(high + 1.0).ceil() as i64 {
            let b = (ahead - step as f64 * self.step - (self.offset)(step)) / self.twist;
            if (from..=to).contains(&b) {
                places.push(b);
            }
        }
    }
}

/// Where an edge `reach` from the second centre touches the fillet of a gear on the first one, normal through the pitch point: `γ`, the normal's
/// lean `ω` from the line of centres, and the point.
fn touches(
    shape: &Shape,
    (own, mate): (C, C),
    own_base: f64,
    mate_base: f64,
    reach: f64,
) -> impl Iterator<Item = (f64, f64, C)> {
    let between = mate - own;
    let distance = between.norm();
    let pitch_point = distance * own_base / (own_base + mate_base);
    let fillet = shape.fillet;
    let r = shape.pitch_radius;
    // The point from the own centre, the line of centres along +x.
    let at = move |gamma: f64| -> Option<(f64, C)> {
        let (sin, cos) = gamma.sin_cos();
        let lean = (r * sin / pitch_point).asin();
        let along = r * cos - fillet.reach(gamma) - pitch_point * lean.cos();
        (!lean.is_nan()).then(|| (lean, C::from(pitch_point) + C::from_polar(along, -lean)))
    };
    let excess = move |gamma: f64| at(gamma).map(|(_, point)| (point - distance).norm() - reach);
    let end = shape.fillet_end;
    let gamma = move |k: u32| end * f64::from(k) / f64::from(STRETCHES);
    (0..STRETCHES).filter_map(move |k| {
        let (mut low, mut high) = (gamma(k), gamma(k + 1));
        let (first, last) = (excess(low)?, excess(high)?);
        if (first < 0.0) == (last < 0.0) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match (excess(middle)? < 0.0) == (first < 0.0) {
                true => low = middle,
                false => high = middle,
            }
        }
        let gamma = 0.5 * (low + high);
        let (lean, point) = at(gamma)?;
        Some((gamma, lean, own + point * between / distance))
    })
}

/// Both intersections of two circles.
fn crossings(one: (C, f64), other: (C, f64)) -> Vec<C> {
    let between = other.0 - one.0;
    let distance = between.norm();
    let along = (distance * distance + one.1 * one.1 - other.1 * other.1) / (2.0 * distance);
    let square = one.1 * one.1 - along * along;
    if !(square >= 0.0) {
        return Vec::new();
    }
    let unit = between / distance;
    let aside = square.sqrt();
    vec![
        one.0 + unit * C::new(along, aside),
        one.0 + unit * C::new(along, -aside),
    ]
}
