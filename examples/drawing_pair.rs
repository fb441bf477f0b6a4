//! Backlash of a pair as drawn, over centre distances: what a designer asks first.
//!
//! `cargo run --release --example drawing_pair`

use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
use gearlash::pair::{GearPair, Mating};

fn main() -> Result<(), gearlash::error::Error> {
    let gear = |teeth, profile_shift, allowance_mm| -> Result<Gear, gearlash::error::Error> {
        let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians())?;
        let design = GearDesign {
            profile_shift,
            ..GearDesign::standard(basic_data)
        };
        // Thinner by the allowance at the reference circle: as much on the base circle, times cos α.
        let thinner = allowance_mm * basic_data.pressure_angle().cos();
        Ok(Gear::new(
            design,
            design.nominal_base_thickness() - thinner,
        )?)
    };
    let wheel = AsBuilt::perfect(gear(51, 0.0, 0.06)?, Face::Front);
    let pinion = AsBuilt::perfect(gear(23, 0.2, 0.05)?, Face::Back);
    let mating = Mating::FIRST;
    for center_distance in [74.3, 74.35, 74.4, 74.45] {
        let pair = GearPair::new(wheel.clone(), pinion.clone(), center_distance)?;
        let found = pair.lost_motion(mating)?;
        let class = found.class(&pair).name();
        match found.j_wt() {
            Some(j_wt) => println!("{center_distance:6.2} mm  {:8.3} µm  {class}", 1e3 * j_wt),
            None => println!("{center_distance:6.2} mm  {}", found.status().name()),
        }
    }
    Ok(())
}
