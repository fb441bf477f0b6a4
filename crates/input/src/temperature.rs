//! `assembly.temperature_c`: converts lengths stated at 20 °C to those of warm or cold gears and housing.

use super::gear::GearPart;
use super::spec::AssemblySpec;
use gearlash::analysis::study::Material;
use gearlash::gear::AsBuilt;
use gearlash::pair::MOST_MODULE_DIFFERENCE;
use gearlash_text::Table;
use gearlash_text::numbers::{ascii, rounded, shortest};

/// The temperature at which lengths are stated, °C (ISO 1).
pub const REFERENCE_C: f64 = 20.0;

/// Checks that the length `factors` of both gears leave modules that mesh.
pub fn check_unequal(file: &Table, [wheel, pinion]: [f64; 2]) -> Option<()> {
    let difference = (wheel - pinion).abs() / wheel.max(pinion);
    if difference <= MOST_MODULE_DIFFERENCE {
        return Some(());
    }
    let keys = ["pinion.scale", "wheel.scale"];
    let key = keys.into_iter().find(|key| file.has(key));
    file.refuse(
        key.unwrap_or("assembly.temperature_c"),
        format!(
            "lets the modules of wheel and pinion differ by {} %, allowed is up to {} %",
            ascii(100.0 * difference, 2),
            100.0 * MOST_MODULE_DIFFERENCE
        ),
        "check scale, the temperature and the coefficients of expansion",
    )
}

/// The temperature of a pair, and the factors of its lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Temperature {
    temperature_c: f64,
    /// Factors of the lengths of wheel, pinion and housing.
    factors: [f64; 3],
}

impl Temperature {
    /// The temperature of a pair file; `Some(None)` where it states none.
    ///
    /// A coefficient that is missing is a problem.
    pub fn read(
        file: &Table,
        assembly: &AssemblySpec,
        gears: [&GearPart; 2],
    ) -> Option<Option<Temperature>> {
        let [wheel, pinion] = gears.map(|gear| gear.expansion_per_k);
        let stated = [
            ("wheel.expansion_per_k", wheel?),
            ("pinion.expansion_per_k", pinion?),
            (
                "assembly.housing_expansion_per_k",
                assembly.housing_expansion_per_k,
            ),
        ];
        let Some(temperature_c) = assembly.temperature_c else {
            let unused = stated.iter().filter(|(_, expansion)| expansion.is_some());
            let unused: Vec<&str> = unused.map(|(key, _)| *key).collect();
            let remark = (!unused.is_empty()).then(|| {
                format!(
                    "{}: not used without assembly.temperature_c",
                    unused.join(", ")
                )
            });
            file.reading().add_remark(remark);
            return Some(None);
        };
        let mut missing = Vec::new();
        let factors = stated.map(|(key, expansion)| {
            missing.extend(expansion.is_none().then_some(key));
            1.0 + expansion.unwrap_or_default() * (temperature_c - REFERENCE_C)
        });
        if missing.is_empty() {
            return Some(Some(Temperature {
                temperature_c,
                factors,
            }));
        }
        file.refuse(
            "assembly.temperature_c",
            format!("given without {}", missing.join(", ")),
            "add the coefficients of thermal expansion in 1/K: of steel some 11.5e-6, of aluminium 23e-6, of POM 110e-6; or remove the temperature",
        )
    }

    /// Factors of the lengths of wheel and pinion.
    pub fn gear_factors(&self) -> [f64; 2] {
        let [wheel, pinion, _] = self.factors;
        [wheel, pinion]
    }

    /// A centre distance of the warm housing, mm. It is rounded to the digits of a file.
    pub fn distance(&self, mm: f64) -> f64 {
        rounded(mm * self.factors[2], 12)
    }

    /// The warm gears. A gear that cannot exist is a problem.
    pub fn gears(
        &self,
        file: &Table,
        materials: Vec<(Material, AsBuilt, AsBuilt)>,
    ) -> Option<Vec<(Material, AsBuilt, AsBuilt)>> {
        let [wheel, pinion, _] = self.factors;
        let warm = materials.iter().map(|(material, first, second)| {
            Ok((*material, first.expanded(wheel)?, second.expanded(pinion)?))
        });
        let warm = warm.collect::<Result<_, gearlash::error::GearError>>();
        let warm = warm.map_err(|error| format!("leaves no gear: {error}"));
        let help = "check the temperature and the coefficients of expansion";
        file.keep("assembly.temperature_c", warm, help)
    }

    /// The factors in words, for a remark.
    pub fn described(&self) -> String {
        let [wheel, pinion, housing] = self.factors.map(|factor| ascii(factor, 7));
        format!(
            "lengths are stated at {REFERENCE_C} °C; at {} °C those of the wheel are × {wheel}, of the pinion × {pinion}, centre distances × {housing}: \
             results are of the warm pair",
            shortest(self.temperature_c)
        )
    }
}
