//! How profiles deviate from the involute: slope, crowning, relief, measured traces (ISO 1328-1, ISO 21771), as deviation of the roll.
//!
//! Deviations are mm along the involute's normal, plus = more material. Slope and crowning are a straight line and a parabola of the roll
//! over the evaluation range, and go on beyond it; a trace is held constant beyond its ends.
//!
//! The deviation is a curve of the roll (`roll_curve`) on a flank of its own (`part::modified`); [`AsBuilt::profile`](super::AsBuilt::profile) is
//! the half tooth of one tooth. The exact method has a quick path for such flanks (`contact::exact::modified`; flanks as measured by bounds of
//! their heights, `modified::heights`) beside its search, and bounds their extremes by gears that enclose them (`contact::exact::extremes::enclosed`).

use super::{Gear, RollCurve, involute};
use crate::error::GearError;
use std::sync::Arc;

/// Material taken off towards the tip or the root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relief {
    /// `C_α`, mm: what is taken off at the tip circle, or at the root form circle; at least 0.
    pub amount: f64,
    /// Radius at which it begins, mm.
    pub from: f64,
    /// Whether it is a parabola of the roll that leaves the flank smoothly; else a straight line, with an edge.
    pub parabolic: bool,
}

/// A measured profile: points of roll, rad, strictly ascending, and deviation, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// The tooth it was measured on; `None`: it stands for all.
    pub tooth: Option<u32>,
    /// At least two.
    pub points: Vec<(f64, f64)>,
}

/// How the flanks of one side of a gear deviate.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Modification {
    /// Profile slope `f_Hα`, mm: 0 at the start of the evaluation range, this much at its end.
    pub slope: f64,
    /// Crowning `C_α`, mm: a parabola that stands out so far in the middle of the evaluation range, 0 at its ends.
    pub crowning: f64,
    /// Taken off at the tip.
    pub tip_relief: Option<Relief>,
    /// Taken off at the root.
    pub root_relief: Option<Relief>,
    /// What was measured, added to all that. Teeth without a trace take the mean of those that have one.
    pub traces: Vec<Trace>,
    /// Evaluation range, radii, mm; `None`: root form circle to tip circle.
    pub range: Option<[f64; 2]>,
}

impl Modification {
    /// Whether it deviates nowhere.
    pub fn is_none(&self) -> bool {
        let relieved = |relief: &Option<Relief>| relief.is_some_and(|relief| relief.amount != 0.0);
        self.slope == 0.0
            && self.crowning == 0.0
            && !relieved(&self.tip_relief)
            && !relieved(&self.root_relief)
            && self.traces.is_empty()
    }

    /// Rolls of the evaluation range on `gear`, rad.
    pub fn evaluated(&self, gear: &Gear) -> [f64; 2] {
        match self.range {
            Some(radii) => radii.map(|radius| involute::roll_at(radius, gear.base_radius())),
            None => [gear.form_roll(), gear.tip_roll()],
        }
    }

    /// The deviation of every tooth's flank, tooth 1 first, on `gear`: one for all where all are alike.
    ///
    /// # Errors
    /// An evaluation range or a relief beyond the flank, or of no length; a relief below 0; a trace of less than two points, not ascending,
    /// of a tooth that does not exist or has one.
    pub fn curves(&self, gear: &Gear) -> Result<Vec<Arc<RollCurve>>, GearError> {
        let designed = self.designed(gear)?;
        let teeth = gear.basic_data().teeth();
        let mut own: Vec<Option<RollCurve>> = vec![None; teeth as usize];
        let mut all = None;
        for trace in &self.traces {
            let curve = trace.curve()?;
            let taken = match trace.tooth {
                None => all.replace(curve).is_some() || self.traces.len() > 1,
                Some(tooth) if (1..=teeth).contains(&tooth) => {
                    own[tooth as usize - 1].replace(curve).is_some()
                }
                Some(tooth) => return Err(GearError::NoSuchTooth { tooth, teeth }),
            };
            if taken {
                return Err(GearError::Readings(
                    "a tooth has two profile traces, or one stands for all teeth beside others",
                ));
            }
        }
        let total = |trace: &RollCurve| Arc::new(RollCurve::sum(&[(1.0, &designed), (1.0, trace)]));
        if let Some(trace) = all {
            return Ok(vec![total(&trace)]);
        }
        let measured: Vec<&RollCurve> = own.iter().flatten().collect();
        if measured.is_empty() {
            return Ok(vec![Arc::new(designed)]);
        }
        let share = 1.0 / measured.len() as f64;
        let weighed: Vec<(f64, &RollCurve)> =
            measured.iter().map(|curve| (share, *curve)).collect();
        let mean = total(&RollCurve::sum(&weighed));
        let curve = |own: &Option<RollCurve>| own.as_ref().map_or_else(|| Arc::clone(&mean), total);
        Ok(own.iter().map(curve).collect())
    }

    /// Slope, crowning and reliefs.
    fn designed(&self, gear: &Gear) -> Result<RollCurve, GearError> {
        let [form, tip] = [gear.form_roll(), gear.tip_roll()];
        let [start, end] = self.evaluated(gear);
        if !(start >= 0.0 && end > start) {
            return Err(GearError::OutOfRange {
                what: "end of the profile's evaluation range (mm)",
                value: self.range.map_or(0.0, |range| range[1]),
                allowed: "a radius above its start and the base circle",
            });
        }
        // Beyond the flank, whose ends move by the deviation itself: it is far less than half the roll.
        let whole = [0.0, 2.0 * tip];
        let length = end - start;
        // Slope and parabola in powers of ξ from 0 on.
        let rise = self.slope / length;
        let bulge = 4.0 * self.crowning / (length * length);
        let mut parts = vec![RollCurve::polynomial(
            whole,
            [
                -rise * start - bulge * start * end,
                rise + bulge * (start + end),
                -bulge,
                0.0,
            ],
        )];
        if self.slope == 0.0 && self.crowning == 0.0 {
            parts.clear();
        }
        let reliefs = [
            (&self.tip_relief, tip, 2.0 * tip),
            (&self.root_relief, form, 0.0),
        ];
        for (relief, at, beyond) in reliefs {
            let Some(relief) = relief else { continue };
            let from = involute::roll_at(relief.from, gear.base_radius());
            if !(relief.amount >= 0.0 && relief.amount.is_finite()) {
                return Err(GearError::OutOfRange {
                    what: "relief (mm)",
                    value: relief.amount,
                    allowed: "0 or more: what is taken off",
                });
            }
            if !(from > form && from < tip) {
                return Err(GearError::OutOfRange {
                    what: "radius at which a relief begins (mm)",
                    value: relief.from,
                    allowed: "between the root form circle and the tip circle",
                });
            }
            let length = at - from;
            // In powers of ξ − the lesser end.
            let shift = from.min(beyond) - from;
            let (linear, square) = match relief.parabolic {
                true => (0.0, -relief.amount / (length * length)),
                false => (-relief.amount / length, 0.0),
            };
            let cubic = [
                shift * (linear + shift * square),
                linear + 2.0 * shift * square,
                square,
                0.0,
            ];
            let curve = match beyond > from {
                true => RollCurve::polynomial([from, beyond], cubic),
                false => RollCurve::polynomial([beyond, from], cubic).and_nothing_to(2.0 * tip),
            };
            parts.push(match relief.parabolic {
                true => curve,
                false => curve.with_edge(from),
            });
        }
        let parts: Vec<(f64, &RollCurve)> = parts.iter().map(|part| (1.0, part)).collect();
        Ok(RollCurve::sum(&parts))
    }
}

impl Trace {
    fn curve(&self) -> Result<RollCurve, GearError> {
        let finite =
            |point: &(f64, f64)| point.0.is_finite() && point.0 >= 0.0 && point.1.is_finite();
        let ascends = self.points.windows(2).all(|pair| pair[1].0 > pair[0].0);
        match self.points.len() >= 2 && ascends && self.points.iter().all(finite) {
            true => Ok(RollCurve::through(&self.points)),
            false => Err(GearError::Readings(
                "a profile trace needs two points or more, of ascending roll from the base circle on",
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::GearDesign;

    fn trace(tooth: Option<u32>, deviation: f64) -> Trace {
        Trace {
            tooth,
            points: vec![(0.2, deviation), (0.4, deviation)],
        }
    }

    fn curves(traces: &[(Option<u32>, f64)]) -> Result<Vec<Arc<RollCurve>>, GearError> {
        let gear = Gear::nominal(GearDesign::plain(20, 2.0)).unwrap();
        let traces = traces.iter().map(|&(tooth, value)| trace(tooth, value));
        let modification = Modification {
            traces: traces.collect(),
            ..Modification::default()
        };
        modification.curves(&gear)
    }

    /// Teeth that were not measured have the mean of those that were: of level traces of 1, 2 and 6 µm that is 3.
    #[test]
    fn teeth_without_a_trace_have_the_mean_of_the_others() {
        let found = curves(&[(Some(1), 1e-3), (Some(5), 2e-3), (Some(20), 6e-3)]).unwrap();
        assert_eq!(found.len(), 20);
        for (k, curve) in found.iter().enumerate() {
            let expected = match k {
                0 => 1e-3,
                4 => 2e-3,
                19 => 6e-3,
                _ => 3e-3,
            };
            assert!((curve.at(0.3) - expected).abs() < 1e-15, "tooth {}", k + 1);
        }
    }

    /// A trace of all teeth stands alone, and no tooth has two.
    #[test]
    fn a_trace_of_all_teeth_stands_alone() {
        assert_eq!(curves(&[(None, 1e-3)]).unwrap().len(), 1);
        for traces in [
            [(None, 1e-3), (None, 2e-3)],
            [(None, 1e-3), (Some(1), 2e-3)],
            [(Some(1), 2e-3), (None, 1e-3)],
            [(Some(1), 2e-3), (Some(1), 1e-3)],
        ] {
            assert!(curves(&traces).is_err(), "{traces:?}");
        }
        for tooth in [0, 21] {
            let alone = curves(&[(Some(tooth), 1e-3)]);
            assert!(matches!(alone, Err(GearError::NoSuchTooth { .. })));
        }
    }
}
