//! Lead deviations of flanks: slope, crowning, end relief, measured traces (ISO 1328-1, ISO 21771).
//!
//! A lead deviation `δ(h)` counts along the transverse base tangent, plus = more material. It turns the flank of the section at the height
//! `h`, with its fillet, by `δ/r_b` about the gear's own centre: right flanks clockwise, left ones counter-clockwise. A reading square to
//! the surface is `δ cos β_b`. Heights count along the axis from the gear's measuring plane, away from the reference face.
//!
//! Pitch and thickness hold at the height where they were measured, so every deviation is 0 there ([`Lead::zero`]).

use super::modification::of_teeth;
use super::{ByTooth, DeviationCurve, Flank, Hand, Trace};
use crate::error::GearError;

/// Material removed towards an end of the teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndRelief {
    /// Relief at the end of the teeth, mm; at least 0.
    pub amount: f64,
    /// Length over which it grows, mm.
    pub length: f64,
    /// Whether it is at the far end of the teeth; otherwise at the end of the reference face.
    pub at_far_end: bool,
    /// Whether it is a parabola that joins the flank smoothly; otherwise a straight line.
    pub parabolic: bool,
}

/// Lead deviations of the flanks of one side of a gear. They add.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lead {
    /// Both ends of the teeth, mm: the end at the reference face, then the far end.
    pub face: [f64; 2],
    /// Evaluation range `L_β`, heights, mm, between the ends.
    pub range: [f64; 2],
    /// Material added over the evaluation range from its start to its end, mm: a straight line that continues beyond it.
    pub slope: f64,
    /// Crowning `C_β`, mm: a parabola, 0 in the middle of the teeth, this much less material at both ends.
    pub crowning: f64,
    /// Reliefs of both ends.
    pub end_reliefs: Vec<EndRelief>,
    /// Measured leads: straight lines between points (height, mm; deviation, mm). Teeth without a trace take the mean of all traces.
    pub traces: Vec<Trace>,
    /// Height, mm, at which pitch and thickness were measured.
    pub zero: f64,
}

impl Lead {
    /// The slope, mm, of a helix slope deviation `f_Hβ`, mm, which is positive where the helix angle is greater (ISO 1328-1). A spur gear's
    /// deviates as if it had this `hand`.
    pub fn slope_of_helix(f_h_beta: f64, hand: Hand, flank: Flank) -> f64 {
        match (hand, flank) {
            (Hand::Right, Flank::Right) | (Hand::Left, Flank::Left) => f_h_beta,
            _ => -f_h_beta,
        }
    }

    /// Whether there is no deviation.
    pub fn is_none(&self) -> bool {
        self.slope == 0.0
            && self.crowning == 0.0
            && self.end_reliefs.iter().all(|relief| relief.amount == 0.0)
            && self.traces.is_empty()
    }

    /// The deviation of every tooth's flank of a gear with `teeth`.
    ///
    /// # Errors
    /// Ends or an evaluation range without length; a range or a zero beyond the ends; a relief below 0, longer than the teeth or without
    /// length; traces as in [`super::Modification::curves`].
    pub fn curves(&self, teeth: u32) -> Result<ByTooth<DeviationCurve>, GearError> {
        let designed = self.designed()?;
        let curve = |trace: &Trace| {
            if trace.ascends() {
                Ok(DeviationCurve::linear(&trace.points))
            } else {
                Err(GearError::Readings(
                    "a lead trace needs two points or more, of ascending height",
                ))
            }
        };
        let curves = of_teeth(&designed, &self.traces, teeth, curve)?;
        Ok(curves.map(|curve| curve.clone().raised(-curve.at(self.zero))))
    }

    /// Slope, crowning and end reliefs.
    fn designed(&self) -> Result<DeviationCurve, GearError> {
        let ([near, far], [start, end]) = (self.face, self.range);
        GearError::require(
            near < far && near.is_finite() && far.is_finite(),
            "length of the teeth with lead deviations (mm)",
            far - near,
            "above 0",
        )?;
        GearError::require(
            near <= start && start < end && end <= far,
            "start of the lead's evaluation range (mm from the measuring plane)",
            start,
            "before its end, both on the teeth",
        )?;
        GearError::require(
            (near..=far).contains(&self.zero),
            "height at which pitch and thickness were measured (mm from the measuring plane)",
            self.zero,
            "on the teeth",
        )?;
        let rate = self.slope / (end - start);
        let (middle, half) = (0.5 * (near + far), 0.5 * (far - near));
        let bend = -self.crowning / (half * half);
        // In powers of h − near.
        let off = near - middle;
        let smooth = [
            rate * (near - start) + bend * off * off,
            rate + 2.0 * bend * off,
            bend,
            0.0,
        ];
        let mut parts = vec![DeviationCurve::polynomial(self.face, smooth)];
        for relief in &self.end_reliefs {
            GearError::require(
                relief.amount >= 0.0 && relief.amount.is_finite(),
                "end relief (mm)",
                relief.amount,
                "0 or more: what is taken off",
            )?;
            GearError::require(
                relief.length > 0.0 && relief.length <= far - near,
                "length of an end relief (mm)",
                relief.length,
                "above 0, up to the length of the teeth",
            )?;
            let (linear, square) = if relief.parabolic {
                (0.0, -relief.amount / (relief.length * relief.length))
            } else {
                (-relief.amount / relief.length, 0.0)
            };
            parts.push(if relief.at_far_end {
                let ends = [far - relief.length, far];
                DeviationCurve::polynomial(ends, [0.0, linear, square, 0.0])
            } else {
                // In powers of h − near, which is the length less the distance from the relief's start.
                let length = relief.length;
                let at_end = length * (linear + length * square);
                let cubic = [at_end, -linear - 2.0 * length * square, square, 0.0];
                DeviationCurve::polynomial([near, near + length], cubic)
            });
        }
        let parts: Vec<(f64, &DeviationCurve)> = parts.iter().map(|part| (1.0, part)).collect();
        Ok(DeviationCurve::sum(&parts))
    }
}

/// The leads of a gear's own right and left flanks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leads {
    flanks: [ByTooth<DeviationCurve>; 2],
    /// Heights between which every trace has points, mm; `None` without traces.
    traced: Option<[f64; 2]>,
}

impl Leads {
    /// The leads stated for the right and the left flanks of a gear with `teeth`; `None` without any deviation.
    ///
    /// # Errors
    /// As [`Lead::curves`].
    pub fn new(leads: &[Lead; 2], teeth: u32) -> Result<Option<Leads>, GearError> {
        if leads.iter().all(Lead::is_none) {
            return Ok(None);
        }
        let [right, left] = leads.each_ref().map(|lead| {
            // A flank without deviations has no face of its own to check.
            if lead.is_none() {
                let none = DeviationCurve::polynomial([0.0, 1.0], [0.0; 4]);
                return Ok(ByTooth::same(none));
            }
            lead.curves(teeth)
        });
        let traces = leads.iter().flat_map(|lead| &lead.traces);
        let ends =
            traces.filter_map(|trace| Some([trace.points.first()?.0, trace.points.last()?.0]));
        let traced = ends.reduce(|one, other| [one[0].max(other[0]), one[1].min(other[1])]);
        Ok(Some(Leads {
            flanks: [right?, left?],
            traced,
        }))
    }

    /// These leads and `further` ones, which all teeth of a flank share.
    pub fn plus(mut self, further: &Leads) -> Leads {
        for (own, further) in self.flanks.iter_mut().zip(&further.flanks) {
            *own = own.map(|curve| DeviationCurve::sum(&[(1.0, curve), (1.0, further.of(1))]));
        }
        self
    }

    /// Heights between which every trace has points, mm; `None` without traces.
    pub fn traced(&self) -> Option<[f64; 2]> {
        self.traced
    }

    /// The leads of a flank.
    pub fn of(&self, flank: Flank) -> &ByTooth<DeviationCurve> {
        &self.flanks[flank.index()]
    }

    /// These leads with `change` applied to every curve, and heights multiplied by `factor`.
    pub fn map(&self, factor: f64, change: impl Fn(&DeviationCurve) -> DeviationCurve) -> Leads {
        let flanks = self.flanks.each_ref().map(|flank| flank.map(&change));
        let traced = self.traced.map(|ends| ends.map(|end| factor * end));
        Leads { flanks, traced }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Teeth of 40 mm, evaluated over 36 mm, with this change.
    fn lead(change: impl Fn(&mut Lead)) -> Lead {
        let mut lead = Lead {
            face: [-20.0, 20.0],
            range: [-18.0, 18.0],
            ..Lead::default()
        };
        change(&mut lead);
        lead
    }

    /// Source: the definitions: a slope over the evaluation range, a parabola of height C over the teeth, reliefs over their lengths, and
    /// zero where pitch and thickness were measured.
    #[test]
    fn what_is_stated_adds_up_from_the_zero() {
        let slope = lead(|lead| lead.slope = 0.009);
        let crowned = lead(|lead| (lead.crowning, lead.zero) = (0.008, 20.0));
        let trace = Trace {
            tooth: None,
            points: vec![(-20.0, 0.0), (20.0, 0.008)],
        };
        let traced = lead(|lead| lead.traces = vec![trace.clone()]);
        let mut cases = vec![
            (slope.clone(), 18.0, 0.0045),
            (slope, -20.0, -0.005),
            (crowned.clone(), 0.0, 0.008),
            (crowned, 10.0, 0.006),
            (traced, 20.0, 0.004),
        ];
        for (at_far_end, parabolic) in [(false, false), (false, true), (true, false), (true, true)]
        {
            let relief = EndRelief {
                amount: 0.012,
                length: 6.0,
                at_far_end,
                parabolic,
            };
            let relieved = lead(|lead| lead.end_reliefs = vec![relief]);
            let sign = if at_far_end { 1.0 } else { -1.0 };
            let middle = if parabolic { 0.003 } else { 0.006 };
            for (height, expected) in [(0.0, 0.0), (14.0, 0.0), (17.0, -middle), (20.0, -0.012)] {
                cases.push((relieved.clone(), sign * height, expected));
                cases.push((relieved.clone(), -sign * height, 0.0));
            }
        }
        for (lead, height, expected) in cases {
            let expected: f64 = expected;
            let found = lead.curves(20).unwrap().of(1).at(height);
            let is_near = (found - expected).abs() < 1e-15;
            assert!(is_near, "{lead:?} at {height}: {found} {expected}");
        }
    }
}
