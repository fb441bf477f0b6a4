//! Closed formulas for a gear of the mean thickness without deviations, for comparison with the readings.

use super::roll::Roll;
use crate::analytic::InvolutePair;
use crate::gear::{AsBuilt, MeasuringBody, thickness};
use std::f64::consts::PI;

/// Values by formula, lengths in mm; all `None` for an outline.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Formula {
    /// `W_k = ((k − 1) p_bt + s_bt) cos β_b`.
    pub span: Option<f64>,
    /// `M_dK` over two pins; for a helical gear over two balls.
    pub over_two: Option<f64>,
    /// `M_dK = r_K (1 + cos(π/z)) + D_M` over three pins: the two are `π/z` beside the opposite direction.
    pub over_three: Option<f64>,
    /// `M_dR = 2 r_K + D_M` over two cylindrical pins along the spaces of a helical gear; `None` for a spur gear.
    pub over_lying: Option<f64>,
    /// Radius `r_K` of the ball's centre.
    pub ball_centre: Option<f64>,
    /// Root radius `r_f = r − m (h_fP* − x_E)`.
    pub root: Option<f64>,
    /// Arc thickness at the reference circle, `s_bt/cos α_t − 2 r inv α_t`.
    pub thickness: Option<f64>,
    /// Centre distance without play against the master.
    pub distance: Option<f64>,
    /// `F_r = F_i'' = 2 e`: the first-order effect of a pure eccentricity.
    pub runout: Option<f64>,
}

/// The formulas for `gear`, measured over `k` teeth, pins of `pin` and balls of `ball`, against the master of `roll`.
pub(super) fn formula(
    gear: &AsBuilt,
    k: Option<u32>,
    [pin, ball]: [Option<f64>; 2],
    roll: Option<&Roll>,
) -> Formula {
    let runout = 2.0 * gear.eccentricity();
    let gear = gear.gear();
    let basic_data = gear.basic_data();
    let s_b = gear.base_thickness();
    let centre = |diameter| thickness::pin_centre_radius(basic_data, diameter, s_b);
    let odd = !basic_data.teeth().is_multiple_of(2);
    let both = 1.0 + (PI / f64::from(basic_data.teeth())).cos();
    let alpha = basic_data.transverse_pressure_angle();
    Formula {
        span: k.map(|k| thickness::span_from_base(basic_data, k, s_b)),
        over_two: pin.map(|pin| thickness::pins_from_base(basic_data, pin, s_b)),
        over_three: pin.filter(|_| odd).map(|pin| both * centre(pin) + pin),
        over_lying: pin
            .filter(|_| basic_data.hand().is_some())
            .map(|pin| thickness::over_from_base(basic_data, MeasuringBody::Pin, pin, s_b)),
        ball_centre: ball.map(centre),
        root: Some(gear.root_radius()),
        thickness: Some(
            s_b / alpha.cos()
                - 2.0 * basic_data.reference_radius() * crate::gear::involute::inv(alpha),
        ),
        distance: roll.and_then(|roll| InvolutePair::new(gear, &roll.master).center_distance(0.0)),
        runout: Some(runout),
    }
}
