//! A tip that a contact passes along the face.

/// A tip that leaves room where it is passed, mm along the base tangent.
pub(super) struct PassedTip {
    pub base: f64,
    pub roll: f64,
    /// Least roll beyond it in the section at 0 over the cell, rad, and its rate, rad/mm.
    pub excess: f64,
    pub rate: f64,
    /// Its change per locked lead, rad/mm.
    pub by_lead: f64,
    /// More room per angle beyond it, mm/rad.
    pub pull: f64,
    /// Share of the room that a lean takes.
    pub share: f64,
    /// Greatest roll above the least over the cell, rad.
    pub play: f64,
    /// The form roll, rad, and the tightness, mm/rad, that a lean may add below it, where a section has the contact at the form circle.
    pub form: f64,
    pub below: f64,
}

impl PassedTip {
    /// Least roll beyond it at `b`, where the locked lead is `lead`, rad.
    pub fn beyond(&self, b: f64, lead: f64) -> f64 {
        self.excess + self.rate * b + self.by_lead * lead
    }

    /// The room at a roll beyond it, mm, and its rate.
    pub fn room(&self, beyond: f64) -> [f64; 2] {
        if !(beyond > 0.0) {
            return [0.0; 2];
        }
        let (sin, cos) = beyond.sin_cos();
        let left = (1.0 - self.share) * self.base;
        [
            left * (self.roll * (1.0 - cos) + beyond - sin) + self.pull * beyond,
            left * (self.roll * sin + 1.0 - cos) + self.pull,
        ]
    }
}
