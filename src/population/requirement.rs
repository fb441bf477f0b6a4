//! The limits on each assembly, and their evaluation.

use super::assembly::{Assembly, Outcome, OutcomeKind};
use super::spread::tenths;
use crate::analysis::extremes::WIDTH;
use crate::analysis::requirement::{Limits, Quantity, Requirements};
use crate::outline::AssembledPair;
#[cfg(feature = "matching")]
use crate::pair::GearPair;

/// Quantities besides `j_wt` that can be limited.
const OTHERS: [Quantity; 6] = Quantity::BESIDE_OPERATING_BACKLASH;

/// The limits on each assembly over its whole mesh cycle: `j_wt`, mm, and other quantities ([`Quantity`]). Each is
/// judged as by [`Verdict`](crate::analysis::verdict::Verdict): with bearing clearance the axes are pressed together
/// for the least and apart for the greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssemblyLimits {
    backlash: Limits,
    others: [Limits; OTHERS.len()],
}

/// The evaluation of an assembly against the requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standing {
    /// Whether a quantity is below its lower limit.
    pub below: bool,
    /// Whether a quantity is above its upper limit.
    pub above: bool,
    /// Distance to the nearest limit, tenths of a nanometre (a lost motion counts on the operating pitch circle). `None` without a limit
    /// or a value.
    pub(super) margin: Option<i64>,
}

impl AssemblyLimits {
    /// `j_wt` at least `min` and at most `max`, mm. Without a `min` the pair must assemble.
    pub fn new(min: Option<f64>, max: Option<f64>) -> AssemblyLimits {
        AssemblyLimits {
            backlash: Limits { min, max },
            others: [Limits::default(); OTHERS.len()],
        }
    }

    /// All limits in `required`. Without a lower limit on backlash, the pair must assemble.
    pub fn of(required: &Requirements) -> AssemblyLimits {
        let of = |quantity| {
            let mut each = required.iter();
            let found = each.find(|(one, _)| *one == quantity);
            found.map_or(Limits::default(), |(_, limits)| *limits)
        };
        AssemblyLimits {
            backlash: of(Quantity::OperatingBacklash),
            others: OTHERS.map(of),
        }
    }

    /// The stated lower limit of `j_wt`, mm.
    pub fn min(&self) -> Option<f64> {
        self.backlash.min
    }

    /// The stated upper limit, mm.
    pub fn max(&self) -> Option<f64> {
        self.backlash.max
    }

    /// The limits of other quantities than `j_wt`.
    pub fn others(&self) -> impl Iterator<Item = (Quantity, Limits)> {
        let each = OTHERS.into_iter().zip(self.others);
        each.filter(|(_, limits)| *limits != Limits::default())
    }

    /// The evaluation of `assembly` with the result `outcome`.
    pub fn standing(&self, assembly: &Assembly, outcome: &Outcome) -> Standing {
        self.standing_of(outcome, || assembly.ends())
    }

    /// The evaluation of a pair with the result `outcome`; `ends` are the pairs with the least and with the greatest backlash.
    pub(crate) fn standing_of(
        &self,
        outcome: &Outcome,
        ends: impl FnOnce() -> Option<[AssembledPair; 2]>,
    ) -> Standing {
        let nothing = matches!(
            outcome.kind,
            OutcomeKind::Unproven | OutcomeKind::Impossible
        );
        let (jammed, apart) = (
            outcome.kind == OutcomeKind::Jammed,
            outcome.kind == OutcomeKind::NoContact,
        );
        let below = outcome.least.zip(self.lower());
        let below = below.map(|(least, lower)| least - lower);
        let above = outcome.greatest.zip(self.backlash.max);
        let above = above.map(|(greatest, max)| max - greatest);
        let mut margins = [below, above];
        if self.others().next().is_some()
            && !nothing
            && let Some(ends) = ends()
        {
            for (quantity, limits) in self.others() {
                let more = [(limits.min, false), (limits.max, true)]
                    .map(|(limit, is_max)| margin_to(quantity, limit?, is_max, &ends, outcome));
                for (margin, more) in margins.iter_mut().zip(more) {
                    *margin = (*margin).into_iter().chain(more).reduce(f64::min);
                }
            }
        }
        let [least, greatest] = margins;
        let beyond = |margin: Option<f64>| margin.is_some_and(|margin| margin < 0.0);
        let margin = least.into_iter().chain(greatest).map(tenths).min();
        Standing {
            below: jammed || beyond(least),
            above: apart || beyond(greatest),
            margin: margin.filter(|_| !nothing),
        }
    }

    /// The lower limit of the least `j_wt`; without a lower limit on backlash, no proven interference.
    fn lower(&self) -> Option<f64> {
        let mut others = self.others();
        let is_limited = others.any(|(quantity, limits)| {
            quantity != Quantity::RadialClearance && limits.min.is_some()
        });
        self.backlash.min.or((!is_limited).then_some(-WIDTH))
    }

    /// The range of `j_wt`, mm, in which the first of `ends` meets the lower limits of every backlash and the second
    /// the upper ones. A radial limit is converted to first order, `j_wt = 2 j_r tan α_wt`.
    #[cfg(feature = "matching")]
    pub fn as_operating_backlash(&self, ends: &[GearPair; 2]) -> Limits {
        let mut all = self.backlash;
        for (quantity, limits) in self.others() {
            let of = |end: &GearPair, limit: Option<f64>| {
                let per = match quantity {
                    Quantity::RadialClearance => return None,
                    Quantity::RadialBacklash => 0.5 / end.operating_pressure_angle().tan(),
                    other => other.bracket(&end.clone().into(), [1.0; 2], false)?[0],
                };
                limit.map(|limit| limit / per)
            };
            let tightest = |one: Option<f64>, other: Option<f64>, fold: fn(f64, f64) -> f64| {
                one.into_iter().chain(other).reduce(fold)
            };
            all.min = tightest(all.min, of(&ends[0], limits.min), f64::max);
            all.max = tightest(all.max, of(&ends[1], limits.max), f64::min);
        }
        all
    }
}

/// Margin to a `limit` of `quantity`, mm; negative if it is missed. `None` without a backlash.
fn margin_to(
    quantity: Quantity,
    limit: f64,
    is_max: bool,
    ends: &[AssembledPair; 2],
    outcome: &Outcome,
) -> Option<f64> {
    let [near, far] = ends;
    let (end, j_wt) = if is_max {
        (far, outcome.greatest)
    } else {
        (near, outcome.least)
    };
    let j_wt = match quantity {
        Quantity::RadialClearance => 0.0,
        _ => j_wt?,
    };
    let value = quantity.bracket(end, [j_wt; 2], is_max)?[usize::from(is_max)];
    let per = match quantity {
        Quantity::LostMotion(member) => end.operating_pitch_radius(member),
        _ => 1.0,
    };
    let margin = if is_max { limit - value } else { value - limit };
    Some(margin * per)
}
