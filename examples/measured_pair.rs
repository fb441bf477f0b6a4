//! A pair from two inspection sheets: spans, runouts and their high teeth.
//! `cargo run --release --example measured_pair`

use gearlash::contact::lost_motion_at;
use gearlash::gear::{AsBuilt, BasicGearData, Face, GearDesign, Side};
use gearlash::metrology::{Measurements, Runout, RunoutStatement, ThicknessStatement, Toleranced};
use gearlash::pair::{GearPair, Mating};
use std::error::Error;

fn gear(face: Face, mm: f64, total_um: f64, high: f64) -> Result<AsBuilt, Box<dyn Error>> {
    let design = GearDesign::standard(BasicGearData::new(44, 3.0, 20f64.to_radians())?);
    let mut sheet = Measurements::nominal(design, face);
    let (teeth, mm) = (6, Toleranced::Single(mm));
    sheet.thickness = ThicknessStatement::Span { teeth, mm };
    sheet.runout = RunoutStatement::Total(Runout {
        total_um,
        high_tooth: Some(high),
    });
    let measured = sheet.measure().map_err(|errors| errors[0].clone());
    Ok(measured?.as_built.most().clone())
}

/// Prints the backlash at four matings.
pub fn table() -> Result<String, Box<dyn Error>> {
    let wheel = gear(Face::Front, 50.55, 30.0, 7.0)?;
    let pinion = gear(Face::Back, 50.56, 20.0, 1.0)?;
    let pair = GearPair::new(wheel, pinion, 132.15)?.into();
    let mut table = String::new();
    for tooth in [1, 12, 23, 34] {
        let found = lost_motion_at(&pair, Mating::at(tooth, tooth, Side::Right))?;
        let um = 1e3 * found.j_wt().ok_or("not in mesh")?;
        table += &format!("teeth {tooth:2}·{tooth:<2}  {um:8.3} µm\n");
    }
    Ok(table)
}

fn main() -> Result<(), Box<dyn Error>> {
    table().map(|table| print!("{table}"))
}
