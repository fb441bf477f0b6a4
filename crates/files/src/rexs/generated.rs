//! The profile shift that a gear is generated with: the thickness as stated for manufacturing.

use super::fault::{Attributes, Fault, NUMBER};
use crate::numbers::{rounded, shortest};
use gearlash::gear::BasicGearData;
use std::fmt;

const SHIFT: &str = "generated_addendum_modification_coefficient";

/// The generated profile shift that the settings of a gear, its flanks, or the gear itself state.
pub enum Generated {
    None,
    One(GeneratedShift),
    /// Different ones, in words: the last manufacturing step is unknown.
    Several(String),
}

/// A generated profile shift coefficient `x_E`, in modules.
pub struct GeneratedShift {
    shift: f64,
    /// Upper and lower.
    deviations: [f64; 2],
    /// The component that states it.
    place: String,
}

impl Generated {
    /// The shift that all `sources` state.
    ///
    /// # Errors
    /// No number, or one deviation without the other.
    pub fn read<'a, 'b: 'a>(
        sources: impl Iterator<Item = &'a Attributes<'b>>,
    ) -> Result<Generated, Fault> {
        let mut all: Vec<GeneratedShift> = Vec::new();
        for source in sources {
            let Some(shift) = source.number(SHIFT, NUMBER)? else {
                continue;
            };
            let end = |end: &str| source.number(&format!("{SHIFT}_{end}_deviation"), NUMBER);
            let place = source.component().place();
            let deviations = match (end("upper")?, end("lower")?) {
                (Some(upper), Some(lower)) => [upper, lower],
                (None, None) => [0.0; 2],
                _ => {
                    return Err(Fault::LeftOut(format!(
                        "{place} has one deviation of {SHIFT} without the other"
                    )));
                }
            };
            let same =
                |other: &GeneratedShift| other.shift == shift && other.deviations == deviations;
            if !all.iter().any(same) {
                all.push(GeneratedShift {
                    shift,
                    deviations,
                    place,
                });
            }
        }
        let stated: Vec<String> = all.iter().map(ToString::to_string).collect();
        Ok(match (all.pop(), all.is_empty()) {
            (None, _) => Generated::None,
            (Some(one), true) => Generated::One(one),
            (Some(_), false) => Generated::Several(stated.join(" and ")),
        })
    }
}

impl GeneratedShift {
    /// Whether it equals the profile shift `x` and has no deviations. It then states no allowance.
    pub fn is(&self, x: f64) -> bool {
        self.shift == x && self.deviations == [0.0; 2]
    }

    /// Upper and lower allowance of the thickness at the reference cylinder against a gear of profile shift `x`, µm.
    ///
    /// A rack shifted by `x` modules generates the thickness `s_n = m_n (π/2 + 2 x tan α_n)` (ISO 21771, as
    /// `BasicGearData::half_base_angle`). The gear generated at `x_E` thus has `A_sn = s(x_E) − s(x) = 2 m_n tan α_n (x_E − x)`.
    pub fn allowances_um(&self, x: f64, basic_data: &BasicGearData) -> [f64; 2] {
        let of_shift = um_of_shift(basic_data);
        self.deviations
            .map(|deviation| rounded(of_shift * (self.shift + deviation - x), 6))
    }
}

/// Thickness per module of profile shift, µm.
pub fn um_of_shift(basic_data: &BasicGearData) -> f64 {
    2e3 * basic_data.module() * basic_data.pressure_angle().tan()
}

impl fmt::Display for GeneratedShift {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{SHIFT} {} of {}", shortest(self.shift), self.place)?;
        match self.deviations {
            [0.0, 0.0] => Ok(()),
            [upper, lower] => write!(f, " ({}…{})", shortest(lower), shortest(upper)),
        }
    }
}
