//! Profile deviations from the involute: slope, crowning, relief, measured traces (ISO 1328-1, ISO 21771).
//!
//! Deviations are mm along the involute's normal, plus = more material. Slope and crowning are a straight line and a parabola of
//! the roll over the evaluation range and continue beyond it. A trace is constant beyond its ends.
//!
//! The deviation is a curve of the roll (`deviation_curve`) on a flank (`part::modified`).
//! [`AsBuilt::profile`](super::AsBuilt::profile) is the half tooth of one tooth.

use super::{ByTooth, DeviationCurve, Gear, involute};
use crate::error::GearError;

/// Material removed towards the tip or the root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relief {
    /// `C_α`, mm: relief at the tip circle, or at the root form circle; at least 0.
    pub amount: f64,
    /// Radius at which the relief begins, mm.
    pub from: f64,
    /// Whether the relief is a parabola of the roll that joins the flank smoothly; otherwise a straight line with an edge.
    pub parabolic: bool,
}

/// A measured profile or lead: points of roll, rad, or height, mm, strictly ascending, and deviation, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// The measured tooth; `None`: the trace holds for all teeth.
    pub tooth: Option<u32>,
    /// At least two points.
    pub points: Vec<(f64, f64)>,
}

/// Profile deviations of the flanks of one side of a gear.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Modification {
    /// Profile slope `f_Hα`, mm: 0 at the start of the evaluation range, this much at its end.
    pub slope: f64,
    /// Crowning `C_α`, mm: a parabola with this height in the middle of the evaluation range and 0 at its ends.
    pub crowning: f64,
    /// Tip relief.
    pub tip_relief: Option<Relief>,
    /// Root relief.
    pub root_relief: Option<Relief>,
    /// Measured traces, added to the other deviations. Teeth without a trace take the mean of all traces.
    pub traces: Vec<Trace>,
    /// Evaluation range, radii, mm; `None`: root form circle to tip circle.
    pub range: Option<[f64; 2]>,
}

impl Modification {
    /// Whether there is no deviation.
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

    /// The deviation of every tooth's flank on `gear`.
    ///
    /// # Errors
    /// An evaluation range or a relief beyond the flank or without length; a relief below 0; a trace with fewer than two points or not
    /// ascending; a second trace of a tooth, or one of a tooth that does not exist.
    pub fn curves(&self, gear: &Gear) -> Result<ByTooth<DeviationCurve>, GearError> {
        let designed = self.designed(gear)?;
        let teeth = gear.basic_data().teeth();
        of_teeth(&designed, &self.traces, teeth, Trace::curve)
    }

    /// Slope, crowning and reliefs.
    fn designed(&self, gear: &Gear) -> Result<DeviationCurve, GearError> {
        let [form, tip] = [gear.form_roll(), gear.tip_roll()];
        let [start, end] = self.evaluated(gear);
        GearError::require(
            start >= 0.0 && end > start,
            "end of the profile's evaluation range (mm)",
            self.range.map_or(0.0, |range| range[1]),
            "a radius above its start and the base circle",
        )?;
        // Wider than the flank: the deviation moves its ends by far less than half the roll.
        let whole = [0.0, 2.0 * tip];
        let length = end - start;
        // Slope and parabola in powers of ξ.
        let rise = self.slope / length;
        let bulge = 4.0 * self.crowning / (length * length);
        let mut parts = vec![DeviationCurve::polynomial(
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
            GearError::require(
                relief.amount >= 0.0 && relief.amount.is_finite(),
                "relief (mm)",
                relief.amount,
                "0 or more: what is taken off",
            )?;
            GearError::require(
                from > form && from < tip,
                "radius at which a relief begins (mm)",
                relief.from,
                "between the root form circle and the tip circle",
            )?;
            let length = at - from;
            // Powers of ξ minus the lesser end.
            let shift = from.min(beyond) - from;
            let (linear, square) = if relief.parabolic {
                (0.0, -relief.amount / (length * length))
            } else {
                (-relief.amount / length, 0.0)
            };
            let cubic = [
                shift * (linear + shift * square),
                linear + 2.0 * shift * square,
                square,
                0.0,
            ];
            let curve = if beyond > from {
                DeviationCurve::polynomial([from, beyond], cubic)
            } else {
                DeviationCurve::polynomial([beyond, from], cubic).zero_until(2.0 * tip)
            };
            parts.push(if relief.parabolic {
                curve
            } else {
                curve.with_edge(from)
            });
        }
        let parts: Vec<(f64, &DeviationCurve)> = parts.iter().map(|part| (1.0, part)).collect();
        Ok(DeviationCurve::sum(&parts))
    }
}

impl Trace {
    /// Whether it has two finite points or more, strictly ascending.
    pub(super) fn ascends(&self) -> bool {
        let finite = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
        self.points.len() >= 2
            && self.points.windows(2).all(|pair| pair[1].0 > pair[0].0)
            && self.points.iter().all(finite)
    }

    fn curve(&self) -> Result<DeviationCurve, GearError> {
        if self.ascends() && self.points.iter().all(|(roll, _)| *roll >= 0.0) {
            Ok(DeviationCurve::through(&self.points))
        } else {
            Err(GearError::Readings(
                "a profile trace needs two points or more, of ascending roll from the base circle on",
            ))
        }
    }
}

/// The deviation of every tooth's flank: `designed` plus its trace, or plus the mean of all traces.
///
/// # Errors
/// A second trace of a tooth, or one of a tooth that does not exist; errors of `curve`.
pub(super) fn of_teeth(
    designed: &DeviationCurve,
    traces: &[Trace],
    teeth: u32,
    curve: impl Fn(&Trace) -> Result<DeviationCurve, GearError>,
) -> Result<ByTooth<DeviationCurve>, GearError> {
    let mut own: Vec<Option<DeviationCurve>> = vec![None; teeth as usize];
    let mut all = None;
    for trace in traces {
        let curve = curve(trace)?;
        let taken = match trace.tooth {
            None => all.replace(curve).is_some() || traces.len() > 1,
            Some(tooth) if (1..=teeth).contains(&tooth) => {
                own[tooth as usize - 1].replace(curve).is_some()
            }
            Some(tooth) => return Err(GearError::NoSuchTooth { tooth, teeth }),
        };
        if taken {
            return Err(GearError::Readings(
                "a tooth has two traces, or one stands for all teeth beside others",
            ));
        }
    }
    let total = |trace: &DeviationCurve| DeviationCurve::sum(&[(1.0, designed), (1.0, trace)]);
    if let Some(trace) = all {
        return Ok(ByTooth::same(total(&trace)));
    }
    let measured: Vec<&DeviationCurve> = own.iter().flatten().collect();
    if measured.is_empty() {
        return Ok(ByTooth::same(designed.clone()));
    }
    let share = 1.0 / measured.len() as f64;
    let weighed: Vec<(f64, &DeviationCurve)> =
        measured.iter().map(|curve| (share, *curve)).collect();
    let mean = DeviationCurve::sum(&weighed);
    // In the order of the first tooth of each.
    let (mut shapes, mut of_mean) = (Vec::new(), None);
    let mut shape = |trace: &DeviationCurve| {
        shapes.push(total(trace));
        shapes.len() - 1
    };
    let of_tooth = own.iter().map(|own| match own {
        Some(own) => shape(own),
        None => *of_mean.get_or_insert_with(|| shape(&mean)),
    });
    let of_tooth = of_tooth.collect();
    Ok(ByTooth::new(shapes, of_tooth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::GearDesign;

    /// Teeth without a trace take the mean of the others: 3 µm for constant traces of 1, 2 and 6 µm. A trace of all teeth excludes other
    /// traces, and no tooth has two.
    #[test]
    fn teeth_without_a_trace_have_the_mean_of_the_others() {
        let curves = |traces: &[(Option<u32>, f64)]| {
            let trace = |&(tooth, deviation): &(Option<u32>, f64)| Trace {
                tooth,
                points: vec![(0.2, deviation), (0.4, deviation)],
            };
            let modification = Modification {
                traces: traces.iter().map(trace).collect(),
                ..Modification::default()
            };
            modification.curves(&GearDesign::plain(20, 2.0).gear())
        };
        let found = curves(&[(Some(1), 1e-3), (Some(5), 2e-3), (Some(20), 6e-3)]).unwrap();
        let mut expected = [3e-3; 20];
        (expected[0], expected[4], expected[19]) = (1e-3, 2e-3, 6e-3);
        assert_eq!(found.shapes().len(), 4);
        for (tooth, expected) in (1..).zip(expected) {
            assert!(
                (found.of(tooth).at(0.3) - expected).abs() < 1e-15,
                "{expected}"
            );
        }
        assert_eq!(curves(&[(None, 1e-3)]).unwrap().shapes().len(), 1);
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
