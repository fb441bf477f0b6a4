//! Measures a modelled gear as a shop does: span and runout.
//!
//! `cargo run --release --example gauge`

use gearlash::error::go_on;
use gearlash::gauge::{Settings, gauge};
use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
use std::error::Error;

/// Prints span and runout.
pub fn readings() -> Result<String, Box<dyn Error>> {
    let design = GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?);
    // 5 µm off its axis, tooth 3 highest.
    let gear = AsBuilt::perfect(Gear::nominal(design)?, Face::Front).with_runout(0.005, 3.0)?;
    let settings = Settings {
        span_teeth: Some(3),
        steps_per_pitch: 1,
        ..Settings::default()
    };
    let gauged = gauge(&gear, &settings, &|_| (), &go_on)?;
    let spans = gauged.spans.map_err(|error| error.to_string())?;
    let runout = gauged.runout.map_err(|error| error.to_string())?;
    let span = format!("span over 3 teeth  {:8.4} mm\n", spans.summary().mean);
    Ok(span + &format!("runout             {:8.2} µm\n", 1e3 * runout.total()))
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", readings()?);
    Ok(())
}
