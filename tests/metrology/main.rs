//! Gears from measurements in memory: impossible ones are refused, drawings read as printed. `crates/input/tests/all_round` finds models' deviations.

mod drawing;
#[path = "../common/kit.rs"]
mod kit;
mod refused;

use gearlash::analytic::InvolutePair;
use gearlash::error::GearError;
use gearlash::gear::{Face, Gear, GearDesign, MeasuringBody, PitchAxis, ThicknessField, thickness};
use gearlash::metrology::{
    CrossCheck, DeviationCause, Fits, MeasurementError, Measurements, Outlier, PitchKind,
    PitchSense, PitchStatement, ProbeReadings, ReadWith, Runout, RunoutStatement, StatementRole,
    ThicknessStatement, Toleranced,
};
use gearlash::pair::DesignatedDistance;
use kit::{near, spur};
