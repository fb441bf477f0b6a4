//! Leads measured about the datum axis contain the wobble of the teeth, and on helical gears their eccentricity. Both are taken out of them.
//!
//! Seen on its reference face, a gear has its outline's centre at `e_0 + t h` at the height `h`. The flank with the outward normal `n` moves by
//!
//! ```text
//! δ(h) = n(h)·(e_0 + t h) + s τ' r_b t·q(h)
//! ```
//!
//! along the base tangent, to first order in `e_0` and `t`. `q` is the place of the trace, on the reference circle, which winds by the twist
//! `τ'` per mm, and `s` the sense of the flank. The second term is the move of the tilted flank along the axis. Every trace has its own
//! constant, and all traces of the flanks of one side share a slope and a crown. The least squares of what is left give `t`. Eccentricity and
//! wobble of a helical gear are hardly distinct in leads, so `e_0` must be known.

use super::error::MeasurementError;
use super::runout::{Runout, RunoutStatement};
use super::wobble::Wobble;
use crate::gear::{BasicGearData, Face, Flank, GearDesign, Lead, involute};
use crate::numeric::mean;
use nalgebra::{Matrix2, UnitComplex, Vector2};

/// Least share of the wobble's effect, in its worst direction, that slopes and crowns do not explain. Two teeth opposite each other leave
/// `tan² α`, a tenth, by their two flanks.
const DISTINCT: f64 = 0.02;

/// Flanks on the reference circle.
struct ReferenceFlanks {
    data: BasicGearData,
    /// Half the angle of a tooth on the reference circle, rad.
    half_angle: f64,
    /// `e_0`, mm.
    eccentricity: Vector2<f64>,
}

impl ReferenceFlanks {
    fn new(design: &GearDesign, runout: &Runout) -> ReferenceFlanks {
        let data = design.basic_data;
        let base = 0.5 * design.nominal_base_thickness() / data.base_radius();
        let high = runout.high_tooth.unwrap_or(1.0);
        ReferenceFlanks {
            half_angle: base - involute::inv(data.transverse_pressure_angle()),
            eccentricity: direction(&data, high) * runout.eccentricity(),
            data,
        }
    }

    /// Effects of the eccentricity, mm, and of the lean in both directions, mm per unit.
    fn effects(&self, (tooth, flank): (u32, Flank), height: f64) -> (f64, Vector2<f64>) {
        let data = &self.data;
        let (s, alpha) = (flank.sense(), data.transverse_pressure_angle());
        let own = angle(data, f64::from(tooth)) + s * self.half_angle;
        let place = own + height * data.twist();
        let (sin, cos) = (place - s * alpha).sin_cos();
        let normal = s * Vector2::new(-sin, cos);
        let point = UnitComplex::new(place) * Vector2::new(data.reference_radius(), 0.0);
        let lean = height * normal + s * data.twist() * data.base_radius() * point;
        (normal.dot(&self.eccentricity), lean)
    }
}

/// Angle of a tooth seen on the reference face, rad.
fn angle(data: &BasicGearData, tooth: f64) -> f64 {
    Face::Front.ascending() * (tooth - 1.0) * data.angular_pitch()
}

fn direction(data: &BasicGearData, tooth: f64) -> Vector2<f64> {
    UnitComplex::new(angle(data, tooth)) * Vector2::new(1.0, 0.0)
}

/// Subtracts the mean.
fn centred(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let mean = mean(&values);
    values.into_iter().map(|value| value - mean).collect()
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The wobble in `leads` about the datum axis, and these leads about the axis of the teeth.
pub(super) fn separate(
    design: &GearDesign,
    leads: &[Lead; 2],
    runout: &RunoutStatement,
) -> Result<(Wobble, [Lead; 2]), MeasurementError> {
    let refused = |why| Err(MeasurementError::DatumLeads(why));
    let is_known = runout.readings().is_none();
    let runout = runout.runout();
    if design.basic_data.hand().is_some()
        && (!is_known || runout.total_um > 0.0 && runout.high_tooth.is_none())
    {
        return refused(
            "the traces of helical teeth contain the eccentricity, whose size and direction must be stated",
        );
    }
    let probed = ReferenceFlanks::new(design, &runout);
    let (mut left, mut right) = (Matrix2::zeros(), Vector2::zeros());
    let mut all = 0.0;
    for (flank, lead) in Flank::BOTH.into_iter().zip(leads) {
        // Height and its square, both effects of the lean, the trace without the eccentricity.
        let mut columns: [Vec<f64>; 5] = Default::default();
        for trace in &lead.traces {
            let Some(tooth) = trace.tooth else {
                return refused(
                    "a trace for all teeth shows no wobble, which differs from tooth to tooth",
                );
            };
            let points = || trace.points.iter();
            let effects = |height: f64| probed.effects((tooth, flank), height);
            let lean = |axis: usize| points().map(move |(height, _)| effects(*height).1[axis]);
            columns[0].extend(centred(points().map(|(height, _)| *height)));
            columns[1].extend(centred(points().map(|(height, _)| height * height)));
            columns[2].extend(centred(lean(0)));
            columns[3].extend(centred(lean(1)));
            columns[4].extend(centred(
                points().map(|(height, mm)| mm - effects(*height).0),
            ));
        }
        all += dot(&columns[2], &columns[2]) + dot(&columns[3], &columns[3]);
        for k in 0..2 {
            let (own, others) = columns[k..].split_at_mut(1);
            let square = dot(&own[0], &own[0]);
            for other in others.iter_mut().filter(|_| square > 0.0) {
                let share = dot(&own[0], other) / square;
                for (value, own) in other.iter_mut().zip(&own[0]) {
                    *value -= share * own;
                }
            }
        }
        let [_, _, x, y, found] = &columns;
        left += Matrix2::new(dot(x, x), dot(x, y), dot(x, y), dot(y, y));
        right += Vector2::new(dot(x, found), dot(y, found));
    }
    let least = left.symmetric_eigenvalues().min();
    let inverse = left.try_inverse().filter(|_| least > DISTINCT * 0.5 * all);
    let Some(inverse) = inverse else {
        return refused(
            "the traces do not tell the wobble from the slope of all teeth: three teeth or more around the gear are needed",
        );
    };
    let lean: Vector2<f64> = inverse * right;
    let data = &design.basic_data;
    let wobble = Wobble {
        lean: lean.norm(),
        tooth: data.tooth_towards(Face::Front.ascending() * lean.y.atan2(lean.x)),
    };
    let mut own = leads.clone();
    for (flank, lead) in Flank::BOTH.into_iter().zip(&mut own) {
        for trace in &mut lead.traces {
            for (height, mm) in &mut trace.points {
                let tooth = trace.tooth.unwrap_or(1);
                let (by_eccentricity, by_lean) = probed.effects((tooth, flank), *height);
                *mm -= by_eccentricity + by_lean.dot(&lean);
            }
        }
    }
    Ok((wobble, own))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Hand, Trace};
    use nalgebra::Vector3;

    const LEAN: f64 = 2e-4;

    /// A crown and a slope, by the height, mm.
    fn shape(h: f64) -> f64 {
        0.004 * h / 15.0 - 0.006 * (h - 3.0) * (h - 3.0) / 225.0
    }

    /// A point of a flank, by roll and height: `r_b (E + ξ E')` of the unwound string.
    fn point(
        probed: &ReferenceFlanks,
        (tooth, flank): (u32, Flank),
        roll: f64,
        h: f64,
    ) -> Vector3<f64> {
        let (data, s) = (&probed.data, flank.sense());
        let base = probed.half_angle + involute::inv(data.transverse_pressure_angle());
        let start = angle(data, f64::from(tooth)) + s * base + h * data.twist();
        let (sin, cos) = (start - s * roll).sin_cos();
        let r = data.base_radius();
        Vector3::new(r * (cos - s * roll * sin), r * (sin + s * roll * cos), h)
    }

    /// Lead of these teeth of a rigid gear tilted by `t` and off its axis: the move of each point along the normal of its flank in space.
    fn lead(probed: &ReferenceFlanks, flank: Flank, teeth: &[u32], t: Vector2<f64>) -> Lead {
        let roll = probed.data.transverse_pressure_angle().tan();
        let e = probed.eccentricity;
        let of_point = |tooth: u32, h: f64| {
            let at = |roll, h| point(probed, (tooth, flank), roll, h);
            let d = 1e-5;
            let along = (
                at(roll + d, h) - at(roll - d, h),
                at(roll, h + d) - at(roll, h - d),
            );
            let mut normal = along.0.cross(&along.1).normalize();
            // Outwards: away from the tooth's centre line.
            let middle = angle(&probed.data, f64::from(tooth)) + h * probed.data.twist();
            let across = Vector3::new(-middle.sin(), middle.cos(), 0.0) * flank.sense();
            normal *= normal.dot(&across).signum();
            let moved = Vector3::new(e.x + t.x * h, e.y + t.y * h, -t.dot(&at(roll, h).xy()));
            (h, 0.3 + shape(h) + moved.dot(&normal) / normal.xy().norm())
        };
        let trace = |&tooth: &u32| Trace {
            tooth: Some(tooth),
            points: (0..=20)
                .map(|k| of_point(tooth, 1.5 * f64::from(k) - 12.0))
                .collect(),
        };
        Lead {
            traces: teeth.iter().map(trace).collect(),
            ..Lead::default()
        }
    }

    /// Crown, slope and eccentricity do not disturb it; what is left is crown and slope.
    #[test]
    fn the_wobble_of_a_rigid_gear_is_found() {
        for (beta, hand, teeth) in [
            (0.0, Hand::Right, vec![1, 6, 11, 16]),
            (8.0, Hand::Left, vec![1, 8, 14]),
            (21.0, Hand::Right, vec![2, 7, 12, 17]),
            (35.0, Hand::Left, vec![1, 6, 11, 16]),
        ] {
            let design = GearDesign::plain(20, 3.0).helical(beta, hand);
            let runout = Runout::new(14.0, 4.5);
            let probed = ReferenceFlanks::new(&design, &runout);
            let t = direction(&design.basic_data, 9.25) * LEAN;
            let leads = Flank::BOTH.map(|flank| lead(&probed, flank, &teeth, t));
            let stated = RunoutStatement::Total(runout);
            let (found, own) = separate(&design, &leads, &stated).unwrap();
            assert!((found.lean - LEAN).abs() < 1e-9, "{beta}: {}", found.lean);
            assert!((found.tooth - 9.25).abs() < 1e-4, "{beta}: {}", found.tooth);
            for trace in own.iter().flat_map(|lead| &lead.traces) {
                let zero = trace.points[0].1 - shape(trace.points[0].0);
                for (h, mm) in &trace.points {
                    assert!((mm - zero - shape(*h)).abs() < 1e-7, "{beta}");
                }
            }
        }
    }

    #[test]
    fn traces_that_do_not_show_it_are_refused() {
        let design = GearDesign::plain(20, 3.0);
        let probed = ReferenceFlanks::new(&design, &Runout::default());
        for (teeth, is_shown) in [
            (&[][..], false),
            (&[3], false),
            (&[3, 13], false),
            (&[3, 10, 16], true),
        ] {
            let left = lead(&probed, Flank::Left, teeth, Vector2::zeros());
            let found = separate(&design, &[Lead::default(), left], &RunoutStatement::None);
            assert_eq!(found.is_ok(), is_shown, "{teeth:?}");
        }
    }
}
