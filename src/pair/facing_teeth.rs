//! Two teeth that face each other, with their leads along the face.

use crate::gear::{AsBuilt, DeviationCurve, Side};

/// A tooth of each gear, locked and free, that touch on one side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FacingTeeth<'a> {
    pub side: Side,
    /// Gear and number of both teeth.
    pub teeth: [(&'a AsBuilt, u32); 2],
    /// Their lead deviations; `None` without any.
    curves: [Option<&'a DeviationCurve>; 2],
    /// Their leads in the measuring plane, mm, which their places contain.
    in_plane: [f64; 2],
    /// Height at which each tooth touches in the section at 0, mm along its own axis, and its rate along the face.
    heights: [[f64; 2]; 2],
}

impl<'a> FacingTeeth<'a> {
    /// These teeth of the locked and the free gear.
    pub fn new(side: Side, teeth: [(&'a AsBuilt, u32); 2]) -> FacingTeeth<'a> {
        let curves = teeth.map(|(gear, tooth)| gear.lead_curve(side, tooth));
        FacingTeeth {
            side,
            teeth,
            curves,
            in_plane: [0, 1].map(|k| teeth[k].0.lead_jet(curves[k], 0.0)[0]),
            heights: [[0.0, 1.0]; 2],
        }
    }

    /// These teeth of leaning axes, which touch at `heights` along their own axes: mm in the section at 0, and mm per mm along the face.
    pub fn with_heights(self, heights: [[f64; 2]; 2]) -> FacingTeeth<'a> {
        FacingTeeth { heights, ..self }
    }

    /// Height along the axis of the locked (0) or the free gear (1), mm, in the section at `b`.
    fn height(&self, k: usize, b: f64) -> f64 {
        let [at_0, rate] = self.heights[k];
        at_0 + rate * b
    }

    /// The section, mm, of a height along the axis of the locked (0) or the free gear (1), mm.
    pub fn section_of(&self, k: usize, height: f64) -> f64 {
        let [at_0, rate] = self.heights[k];
        (height - at_0) / rate
    }

    /// Lead of each tooth at `b`, less that in the measuring plane, mm, and its rate, mm per mm.
    pub fn leads_and_rates(&self, b: f64) -> [[f64; 2]; 2] {
        [0, 1].map(|k| {
            let (gear, _) = self.teeth[k];
            let [lead, rate] = gear.lead_jet(self.curves[k], self.height(k, b));
            [lead - self.in_plane[k], self.heights[k][1] * rate]
        })
    }

    /// Leads of both teeth at `b`, less those in the measuring plane, mm.
    pub fn leads(&self, b: f64) -> [f64; 2] {
        self.leads_and_rates(b).map(|[lead, _]| lead)
    }

    /// Sum of both leads at `b`, less that in the measuring plane, mm: what they add along the base tangent.
    pub fn lead_sum(&self, b: f64) -> f64 {
        let [locked, free] = self.leads(b);
        locked + free
    }

    /// Rates of both leads at `b`, mm per mm.
    pub fn lead_rates(&self, b: f64) -> [f64; 2] {
        self.leads_and_rates(b).map(|[_, rate]| rate)
    }

    /// Rate of the sum of both leads at `b`, mm per mm.
    pub fn lead_rate_sum(&self, b: f64) -> f64 {
        let [locked, free] = self.lead_rates(b);
        locked + free
    }

    /// Bound of the sum of both leads over `face`, less that in the measuring plane, mm.
    pub fn lead_sum_bound(&self, face: [f64; 2]) -> f64 {
        self.lead_sum_bounds(face)[1]
    }

    /// Lower and upper bound of that sum.
    pub fn lead_sum_bounds(&self, face: [f64; 2]) -> [f64; 2] {
        let [locked, free] = [0, 1].map(|k| {
            let (gear, tooth) = self.teeth[k];
            let face = face.map(|b| self.height(k, b));
            let [bounds, ..] = gear.lead_bounds(self.side, tooth, face);
            bounds.map(|bound| bound - self.in_plane[k])
        });
        [locked[0] + free[0], locked[1] + free[1]]
    }

    /// Least and greatest second derivative of each lead between two places, mm per mm².
    pub fn second_derivative_bounds(&self, ends: [f64; 2]) -> [[f64; 2]; 2] {
        [0, 1].map(|k| {
            let (gear, tooth) = self.teeth[k];
            let rate = self.heights[k][1];
            let bends = gear.lead_bounds(self.side, tooth, ends.map(|b| self.height(k, b)))[2];
            bends.map(|bend| bend * rate * rate)
        })
    }

    /// Bounds on the amount of the rate of each lead over `face`, mm per mm.
    pub fn steepest(&self, face: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| {
            let (gear, tooth) = self.teeth[k];
            let face = face.map(|b| self.height(k, b));
            let [least, most] = gear.lead_bounds(self.side, tooth, face)[1];
            least.abs().max(most.abs())
        })
    }

    /// Places between which each lead is one cubic, mm, from `from` to `to`, ascending. `section` gives the section in which the teeth touch
    /// at a place along the locked (0) or the free gear (1).
    pub fn knots(&self, [from, to]: [f64; 2], section: impl Fn(usize, f64) -> f64) -> Vec<f64> {
        let mut knots = vec![from, to];
        for (k, (gear, tooth)) in self.teeth.into_iter().enumerate() {
            let own = gear.lead_knots(self.side, tooth);
            let sections = own.map(|place| section(k, place));
            knots.extend(sections.filter(|b| *b > from && *b < to));
        }
        knots.sort_unstable_by(f64::total_cmp);
        knots.dedup();
        knots
    }
}
