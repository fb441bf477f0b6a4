//! Gears from measurements in memory: what no gear has is refused, and drawings are read as printed. `crates/input/tests/all_round` finds the deviations
//! of models again.

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
