//! The design most test gears are made from.

use gearlash::gear::{BasicGearData, GearDesign};

/// 20°, ISO 53 profile A, no profile shift; the gears of the test rig (Karba et al.) with 44 teeth of module 3.
pub fn design(teeth: u32, module: f64) -> GearDesign {
    let data = BasicGearData::new(teeth, module, 20f64.to_radians());
    GearDesign::standard(data.unwrap())
}
