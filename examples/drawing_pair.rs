//! Backlash of a pair as drawn, over centre distances.
//!
//! `cargo run --release --example drawing_pair`

use gearlash::contact::lost_motion_at;
use gearlash::error::Error;
use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, Side};
use gearlash::pair::{GearPair, Mating};

fn gear(teeth: u32, profile_shift: f64, allowance_mm: f64, face: Face) -> Result<AsBuilt, Error> {
    let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians())?;
    let mut design = GearDesign::standard(basic_data);
    design.profile_shift = profile_shift;
    // Thinner by the allowance at the reference circle: as much on the base circle, times cos α.
    let thinner = allowance_mm * basic_data.pressure_angle().cos();
    let gear = Gear::new(design, design.nominal_base_thickness() - thinner)?;
    Ok(AsBuilt::perfect(gear, face))
}

/// One line per centre distance.
pub fn table() -> Result<String, Error> {
    let wheel = gear(51, 0.0, 0.06, Face::Front)?;
    let pinion = gear(23, 0.2, 0.05, Face::Back)?;
    let mating = Mating::at(1, 1, Side::Right);
    let mut table = String::new();
    for a in [74.3, 74.35, 74.4, 74.45] {
        let pair = GearPair::new(wheel.clone(), pinion.clone(), a)?;
        let found = lost_motion_at(&pair.clone().into(), mating)?;
        let (j_wt, class) = (found.j_wt().unwrap_or(f64::NAN), found.class(&pair).name());
        table += &format!("{a:6.2} mm  {:8.3} µm  {class}\n", 1e3 * j_wt);
    }
    Ok(table)
}

fn main() -> Result<(), Error> {
    print!("{}", table()?);
    Ok(())
}
