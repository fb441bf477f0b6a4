//! The perfect master gear of the double-flank roll test.

use super::Unmeasured;
use crate::analytic::InvolutePair;
use crate::error::GearError;
use crate::gear::{AsBuilt, BasicGearData, BasicRack, Gear, GearDesign, involute};
use std::f64::consts::FRAC_PI_4;

/// Least number of teeth of a default master. From here up, the first one is taken whose involute reaches as deep as
/// the gear's tips (a usual size of master gears; smaller ones are nearly undercut).
const FEWEST: u32 = 30;
/// Greatest number of teeth of a default master: a larger one hardly reaches deeper.
const MOST: u32 = 200;
/// Distance of tips from the ends of involutes, in modules, in addition to the eccentricity.
const MARGIN: f64 = 0.05;
/// Greatest dedendum, in parts of that of a pointed tool.
const POINTED: f64 = 0.95;

/// A master for `gear` with its module and pressure angle, `x = 0` and nominal thickness.
///
/// At tight mesh its tips reach exactly to the gear's active flank, at most one module outside its reference circle.
/// The tool that cuts it has no tip radius and is deep enough for the gear's tips.
pub(super) fn master(gear: &AsBuilt, teeth: Option<u32>) -> Result<Gear, Unmeasured> {
    let failed = |error: GearError| Unmeasured(format!("no master gear: {error}"));
    if let Some(teeth) = teeth {
        return Ok(with_teeth(gear, teeth).map_err(failed)?.0);
    }
    let mut last = with_teeth(gear, MOST).map_err(failed)?.0;
    for teeth in FEWEST..MOST {
        if let Ok((master, true)) = with_teeth(gear, teeth) {
            last = master;
            break;
        }
    }
    Ok(last)
}

/// The master with this many teeth, and whether the gear's tips stay on its involute.
fn with_teeth(as_built: &AsBuilt, teeth: u32) -> Result<(Gear, bool), GearError> {
    let gear = as_built.gear();
    let of = gear.basic_data();
    let module = of.module();
    let basic_data = BasicGearData::new(teeth, module, of.pressure_angle())?;
    let basic_data = match of.hand() {
        Some(hand) => basic_data.with_helix(of.helix_angle(), hand.mate())?,
        None => basic_data,
    };
    let dedendum =
        (gear.design().rack.addendum() + 0.25).min(POINTED * FRAC_PI_4 / of.pressure_angle().tan());
    let design = |addendum: f64| -> Result<GearDesign, GearError> {
        Ok(GearDesign {
            basic_data,
            profile_shift: 0.0,
            rack: BasicRack::new(addendum, dedendum, 0.0)?,
            tip_diameter: None,
        })
    };
    let trial = Gear::nominal(design(0.25)?)?;
    let base = trial.base_radius();
    let bases = gear.base_radius() + base;
    let distance = InvolutePair::new(gear, &trial).center_distance(0.0);
    let no_mesh = GearError::OutOfRange {
        what: "base tooth thickness (mm)",
        value: gear.base_thickness(),
        allowed: "thick enough to mesh with a master gear without play",
    };
    // The line of action between both base circles; each tip circle cuts it from its own end.
    let line = bases * involute::roll_at(distance.ok_or(no_mesh)?, bases);
    let margin = MARGIN * module + 2.0 * as_built.eccentricity();
    let reach = line - gear.base_radius() * gear.form_roll() - margin;
    let deepest = (base.hypot(reach.max(0.0)) - basic_data.reference_radius()) / module;
    let master = Gear::nominal(design(deepest.min(1.0))?)?;
    let left = line - gear.base_radius() * gear.tip_roll() - margin;
    let on_involute = left >= base * master.form_roll();
    Ok((master, on_involute))
}
