//! Conversions between measured mean tooth thickness and base tooth thickness `s_b`.
//!
//! The formulas hold for contact on the involute; [`check_span`] and [`check_pins`] test it. Lengths are mm.

use super::{BasicGearData, Gear, involute};
use crate::error::GearError;
use crate::numeric::bisect;
use std::f64::consts::FRAC_PI_2;

/// A body in a tooth space to be measured over. In a spur gear both give the same dimension.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum MeasuringBody {
    /// Balls, their centres in one transverse section.
    #[default]
    Ball,
    /// Cylindrical pins along the spaces.
    Pin,
}

/// `s_bt` from the span `W_k` over `k` teeth: `s_bt = W_k/cos β_b − (k − 1) p_bt` (K (15); ISO 21771).
///
/// The span is normal to the helix: `cos β_b` times the length along the transverse base tangent.
pub fn base_from_span(basic_data: &BasicGearData, k: u32, span: f64) -> f64 {
    span / normal(basic_data) - f64::from(k.saturating_sub(1)) * basic_data.base_pitch()
}

/// Span `W_k = ((k − 1) p_bt + s_bt) cos β_b` over `k` teeth.
pub fn span_from_base(basic_data: &BasicGearData, k: u32, base_thickness: f64) -> f64 {
    (f64::from(k.saturating_sub(1)) * basic_data.base_pitch() + base_thickness) * normal(basic_data)
}

/// `cos β_b`: the ratio of a normal length to the length along the transverse base tangent.
fn normal(basic_data: &BasicGearData) -> f64 {
    match basic_data.hand() {
        None => 1.0,
        Some(_) => basic_data.base_helix_angle().cos(),
    }
}

/// Distance of two pins in the most opposite spaces over `2 r_K`: 1, or `cos(π/(2z))` for odd `z`.
fn opposite(basic_data: &BasicGearData) -> f64 {
    if basic_data.teeth().is_multiple_of(2) {
        1.0
    } else {
        (FRAC_PI_2 / f64::from(basic_data.teeth())).cos()
    }
}

/// `s_bt` from the dimension `M_dK` over two balls (in a spur gear also pins) of diameter `D_M`.
///
/// The ball's centre lies at `r_K`: `M_dK = 2 r_K + D_M` for even `z`, `2 r_K cos(π/(2z)) + D_M` for odd `z`. The ball moves both
/// flanks by `D_M/(2 cos β_b)` along the transverse base tangent: `inv α_K = (D_M/cos β_b − p_bt + s_bt)/d_b` (ISO 21771,
/// dimension over balls).
///
/// # Errors
/// A centre inside the base circle.
pub fn base_from_pins(basic_data: &BasicGearData, pin: f64, over: f64) -> Result<f64, GearError> {
    let base = basic_data.base_radius();
    let centre = (over - pin) / (2.0 * opposite(basic_data));
    GearError::require(
        centre >= base,
        "dimension over pins",
        over,
        "above the base diameter plus the pin",
    )?;
    let inv = involute::inv_of_roll(involute::roll_at(centre, base));
    Ok(2.0 * base * inv - pin / normal(basic_data) + basic_data.base_pitch())
}

/// Radius `r_K` of the centre of a ball (in a spur gear also a pin) in a space between teeth of `base_thickness`.
pub fn pin_centre_radius(basic_data: &BasicGearData, pin: f64, base_thickness: f64) -> f64 {
    let base = basic_data.base_radius();
    let inv = (pin / normal(basic_data) - basic_data.base_pitch() + base_thickness) / (2.0 * base);
    involute::radius_at(involute::roll_of_inv(inv), base)
}

/// Dimension `M_dK` over two balls (in a spur gear also pins) of diameter `D_M` in the most opposite spaces.
pub fn pins_from_base(basic_data: &BasicGearData, pin: f64, base_thickness: f64) -> f64 {
    2.0 * opposite(basic_data) * pin_centre_radius(basic_data, pin, base_thickness) + pin
}

/// Dimension over two bodies of diameter `D_M` in the most opposite spaces.
///
/// Pins of a helical gear lie along the spaces: `M_dR = 2 r_K + D_M`. Also for odd `z` they are opposite each other somewhere along a face
/// of sufficient width.
pub fn over_from_base(
    basic_data: &BasicGearData,
    body: MeasuringBody,
    diameter: f64,
    base_thickness: f64,
) -> f64 {
    match (body, basic_data.hand()) {
        (MeasuringBody::Pin, Some(_)) => {
            2.0 * pin_centre_radius(basic_data, diameter, base_thickness) + diameter
        }
        _ => pins_from_base(basic_data, diameter, base_thickness),
    }
}

/// `s_bt` from the dimension over two bodies, as of [`over_from_base`].
///
/// # Errors
/// As [`base_from_pins`].
pub fn base_from_over(
    basic_data: &BasicGearData,
    body: MeasuringBody,
    diameter: f64,
    over: f64,
) -> Result<f64, GearError> {
    match (body, basic_data.hand()) {
        (MeasuringBody::Pin, Some(_)) => {
            let of_balls = (over - diameter) * opposite(basic_data) + diameter;
            base_from_pins(basic_data, diameter, of_balls)
        }
        _ => base_from_pins(basic_data, diameter, over),
    }
}

/// Most steps of Newton's method for a diameter; it needs some six.
const MOST_STEPS: usize = 50;

/// Diameter `D_M` of the ball (in a spur gear also a pin) that touches at the roll `ξ`, between teeth of `base_thickness`.
///
/// The centre has `inv α_K = ξ_K − atan ξ_K = (D_M/cos β_b − p_b + s_b)/d_b`. The ball touches `D_M cos β_b/2` down the transverse
/// base tangent and `D_M sin β_b/2` off its section, so `ξ_K = ξ + D_M cos β_b/d_b`. With `k = tan² β_b`,
/// `k ξ_K + atan ξ_K = (1 + k) ξ + (p_b − s_b)/d_b`. The left side rises and is concave: Newton's method from `ξ_K = ξ` never
/// passes the root. In a spur gear the result is not positive or not finite if the right side is a right angle or more: no pin touches.
pub fn pin_touching(basic_data: &BasicGearData, roll: f64, base_thickness: f64) -> f64 {
    let base_diameter = 2.0 * basic_data.base_radius();
    let beyond = (basic_data.base_pitch() - base_thickness) / base_diameter;
    if basic_data.hand().is_none() {
        return base_diameter * ((roll + beyond).tan() - roll);
    }
    let leaning = normal(basic_data);
    let k = leaning.powi(-2) - 1.0;
    let mut centre = roll;
    for _ in 0..MOST_STEPS {
        let left = k * (centre - roll) + centre.atan() - roll;
        let step = (beyond - left) / (k + 1.0 / (1.0 + centre * centre));
        centre += step;
        if step.abs() <= 4.0 * f64::EPSILON * centre {
            break;
        }
    }
    base_diameter * (centre - roll) / leaning
}

/// `s_bt` from the thickness allowance `A_sn` (normal section, at the reference circle): `s_bt,nominal + A_sn cos α_t/cos β`.
pub fn base_from_allowance(basic_data: &BasicGearData, nominal_base: f64, allowance: f64) -> f64 {
    nominal_base + allowance * per_normal_thickness(basic_data)
}

/// `ds_bt/ds_n = cos α_t/cos β`: base tooth thickness per normal tooth thickness at the reference circle.
pub fn per_normal_thickness(basic_data: &BasicGearData) -> f64 {
    basic_data.transverse_pressure_angle().cos() / basic_data.helix_cos()
}

/// Thickness allowance `A_sn = (s_bt − s_bt,nominal) cos β/cos α_t` at the reference circle.
pub fn allowance_from_base(
    basic_data: &BasicGearData,
    nominal_base: f64,
    base_thickness: f64,
) -> f64 {
    (base_thickness - nominal_base) / per_normal_thickness(basic_data)
}

/// Thickness allowance `A_sn` of `gear` at the reference circle in the normal section, mm.
pub fn allowance(gear: &Gear) -> f64 {
    let nominal = gear.design().nominal_base_thickness();
    allowance_from_base(gear.basic_data(), nominal, gear.base_thickness())
}

/// The virtual radius `r_n = r_y/cos²β_y` of the normal section at the radius `r_y`, and `cos β_y`, with `tan β_y = r_y tan β/r`.
fn virtual_radius(basic_data: &BasicGearData, radius: f64) -> [f64; 2] {
    let tan = basic_data.helix_angle().tan() * radius / basic_data.reference_radius();
    let leaning = 1.0 + tan * tan;
    [radius * leaning, leaning.sqrt().recip()]
}

/// Normal tooth thickness `s_n` at `radius`: `s_t cos β_y`, `s_t = r_y (s_bt/r_b − 2 inv α_yt)`.
fn normal_thickness_at(basic_data: &BasicGearData, radius: f64, base_thickness: f64) -> f64 {
    let base = basic_data.base_radius();
    let inv = involute::inv_of_roll(involute::roll_at(radius, base));
    let [_, cos] = virtual_radius(basic_data, radius);
    radius * (base_thickness / base - 2.0 * inv) * cos
}

/// Depth of the chord at `radius` below the tip: `r_a − r_y + r_n (1 − cos(s_n/(2 r_n)))` (ISO 21771, chordal height).
fn chord_height(
    basic_data: &BasicGearData,
    tip_radius: f64,
    radius: f64,
    base_thickness: f64,
) -> f64 {
    let [normal, _] = virtual_radius(basic_data, radius);
    let half = normal_thickness_at(basic_data, radius, base_thickness) / (2.0 * normal);
    tip_radius - radius + normal * (1.0 - half.cos())
}

/// Chordal addendum: depth below the tip of the chord at the reference circle.
pub fn chordal_addendum(basic_data: &BasicGearData, tip_radius: f64, base_thickness: f64) -> f64 {
    let radius = basic_data.reference_radius();
    chord_height(basic_data, tip_radius, radius, base_thickness)
}

/// Radius at which the ends of a `chord` in the normal section touch, `height` below the tip.
///
/// The chord is that of the virtual circle (ISO 21771): `r_y = r_a − h + r_n − √(r_n² − (s̄/2)²)`. In a spur gear `r_n = r_y`, and
/// the radius is that of a right triangle. The right side falls with `r_y`: there is one solution.
pub fn chord_radius(basic_data: &BasicGearData, tip_radius: f64, height: f64, chord: f64) -> f64 {
    let (below, half) = (tip_radius - height, 0.5 * chord);
    let is_within = |radius: f64| {
        let [normal, _] = virtual_radius(basic_data, radius);
        normal <= half || below + normal - (normal * normal - half * half).sqrt() > radius
    };
    let [radius, _] = bisect(below.max(0.0), below.max(0.0) + chord, 0.0, is_within);
    radius
}

/// `s_bt` from a `chord` in the normal section, `height` below the tip.
///
/// # Errors
/// A chord that touches inside the base circle.
pub fn base_from_chord(
    basic_data: &BasicGearData,
    tip_radius: f64,
    height: f64,
    chord: f64,
) -> Result<f64, GearError> {
    let base = basic_data.base_radius();
    let radius = chord_radius(basic_data, tip_radius, height, chord);
    GearError::require(
        radius >= base,
        "radius at which the chord touches (mm)",
        radius,
        "the base radius or more",
    )?;
    let [normal, cos] = virtual_radius(basic_data, radius);
    let thickness = 2.0 * normal * (0.5 * chord / normal).min(1.0).asin() / cos;
    let inv = involute::inv_of_roll(involute::roll_at(radius, base));
    Ok(base * (thickness / radius + 2.0 * inv))
}

/// The chord in the normal section, `height` below the tip, of teeth of `base_thickness`.
///
/// It is sought between base and tip circle.
pub fn chord_from_base(
    basic_data: &BasicGearData,
    tip_radius: f64,
    height: f64,
    base_thickness: f64,
) -> f64 {
    let is_above =
        |radius: f64| chord_height(basic_data, tip_radius, radius, base_thickness) < height;
    let [_, radius] = bisect(tip_radius, basic_data.base_radius(), 0.0, is_above);
    let [normal, _] = virtual_radius(basic_data, radius);
    let thickness = normal_thickness_at(basic_data, radius, base_thickness);
    2.0 * normal * (thickness / (2.0 * normal)).sin()
}

/// Checks that the ends of a chord `height` below the tip touch the involutes.
///
/// # Errors
/// [`GearError::ChordOffInvolute`].
pub fn check_chord(gear: &Gear, height: f64) -> Result<(), GearError> {
    let (data, tip) = (gear.basic_data(), gear.tip_radius());
    let chord = chord_from_base(data, tip, height, gear.base_thickness());
    let radius = chord_radius(data, tip, height, chord);
    if height > 0.0 && radius >= gear.form_radius() && radius <= tip {
        return Ok(());
    }
    Err(GearError::ChordOffInvolute {
        height_mm: height,
        contact_diameter_mm: 2.0 * radius,
        form_diameter_mm: 2.0 * gear.form_radius(),
        tip_diameter_mm: 2.0 * tip,
    })
}

/// Checks that a span over `k` teeth touches the involute on both sides.
///
/// The contacts divide `W_k`. Some position has both contacts on the involute exactly if the symmetric one, `W_k/2` each, has.
///
/// # Errors
/// [`GearError::SpanOffInvolute`].
pub fn check_span(gear: &Gear, k: u32) -> Result<(), GearError> {
    let base = gear.base_radius();
    // In the transverse section the contacts are W_k cos β_b apart: the tangent to the base cylinder is inclined by β_b.
    let leaning = normal(gear.basic_data());
    let roll = span_from_base(gear.basic_data(), k, gear.base_thickness()) * leaning / (2.0 * base);
    if (gear.form_roll()..=gear.tip_roll()).contains(&roll) {
        return Ok(());
    }
    Err(GearError::SpanOffInvolute {
        teeth: k,
        contact_diameter_mm: 2.0 * involute::radius_at(roll, base),
        form_diameter_mm: 2.0 * gear.form_radius(),
        tip_diameter_mm: 2.0 * gear.tip_radius(),
    })
}

/// Checks that pins of diameter `pin` rest on the involutes, clear of the root, and protrude beyond the tip.
///
/// # Errors
/// [`GearError::PinOffInvolute`], [`GearError::PinBelowTip`], [`GearError::PinInRoot`].
pub fn check_pins(gear: &Gear, pin: f64) -> Result<(), GearError> {
    let base = gear.base_radius();
    let centre = pin_centre_radius(gear.basic_data(), pin, gear.base_thickness());
    let tip = 2.0 * gear.tip_radius();
    // The ball touches D_M/2 down the base tangent, which is inclined by β_b.
    let roll = involute::roll_at(centre, base) - pin * normal(gear.basic_data()) / (2.0 * base);
    if !(gear.form_roll()..=gear.tip_roll()).contains(&roll) {
        return Err(GearError::PinOffInvolute {
            pin_mm: pin,
            contact_diameter_mm: 2.0 * involute::radius_at(roll.max(0.0), base),
            form_diameter_mm: 2.0 * gear.form_radius(),
            tip_diameter_mm: tip,
        });
    }
    if 2.0 * centre + pin <= tip {
        return Err(GearError::PinBelowTip {
            pin_mm: pin,
            pin_top_diameter_mm: 2.0 * centre + pin,
            tip_diameter_mm: tip,
        });
    }
    if 2.0 * centre - pin < 2.0 * gear.root_radius() {
        return Err(GearError::PinInRoot {
            pin_mm: pin,
            pin_bottom_diameter_mm: 2.0 * centre - pin,
            root_diameter_mm: 2.0 * gear.root_radius(),
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{BasicRack, GearDesign, Hand};
    use std::f64::consts::PI;

    /// A gear with 30 teeth of module 2, its tip lowered by `lower`, mm.
    fn gear(helix_deg: f64, rack: BasicRack, lower: f64) -> Gear {
        let design = GearDesign::plain(30, 2.0).helical(helix_deg, Hand::Right);
        let design = GearDesign {
            rack,
            tip_diameter: Some(2.0 * (design.basic_data.reference_radius() + 2.0 - lower)),
            ..design
        };
        Gear::new(design, design.nominal_base_thickness() - 0.02).unwrap()
    }

    /// `cos β_b` by `sin β_b = sin β cos α_n` (ISO 21771).
    fn lean(helix_deg: f64) -> f64 {
        let sin = helix_deg.to_radians().sin() * 20f64.to_radians().cos();
        (1.0 - sin * sin).sqrt()
    }

    /// Closed form: for a spur gear the chord at the radius `r_y` is `2 r_y sin ψ`, `r_a − r_y cos ψ` below the tip, with
    /// `ψ = s_b/(2 r_b) − inv α_y`; at the reference circle of a helical gear the virtual tooth number is `z/cos³β` (ISO 21771).
    #[test]
    fn a_chord_and_its_height_give_the_base_thickness() {
        let spur = gear(0.0, BasicRack::ISO_53_A, 0.0);
        let (data, base, tip) = (spur.basic_data(), spur.base_radius(), spur.tip_radius());
        for share in [0.05, 0.3, 0.6, 0.95] {
            let radius = spur.form_radius() + share * (tip - spur.form_radius());
            let alpha = (base / radius).acos();
            let half = spur.base_thickness() / (2.0 * base) - (alpha.tan() - alpha);
            let (chord, height) = (2.0 * radius * half.sin(), tip - radius * half.cos());
            let found = base_from_chord(data, tip, height, chord).unwrap();
            assert!((found - spur.base_thickness()).abs() < 1e-11, "{found}");
            let back = chord_from_base(data, tip, height, spur.base_thickness());
            assert!((back - chord).abs() < 1e-11, "{back}");
            assert!(check_chord(&spur, height).is_ok());
        }
        for helix_deg in [15.0, 45.0] {
            let gear = gear(helix_deg, BasicRack::ISO_53_A, 0.0);
            let (data, tip) = (gear.basic_data(), gear.tip_radius());
            let diameter = 2.0 * 30.0 / helix_deg.to_radians().cos().powi(3);
            let (sin, cos) = (PI / diameter).sin_cos();
            let height = tip - data.reference_radius() + 0.5 * diameter * (1.0 - cos);
            let nominal = gear.design().nominal_base_thickness();
            let addendum = chordal_addendum(data, tip, nominal);
            assert!((addendum - height).abs() < 1e-12, "{addendum} {height}");
            let found = base_from_chord(data, tip, height, diameter * sin).unwrap();
            assert!((found - nominal).abs() < 1e-11, "{helix_deg}: {found}");
        }
    }

    /// An error states contact, top and bottom of a pin, and the gear's circles. Source: the centre of a ball that touches at a roll
    /// lies `D_M cos β_b/2` up the base tangent.
    #[test]
    fn errors_say_where_a_pin_stands() {
        let high = BasicRack::new(1.0, 1.25, 0.0).unwrap();
        // Tips below the reference circle: pins near the form circle protrude and reach the root.
        let shallow = BasicRack::new(1.0, 1.05, 0.0).unwrap();
        let mut met = [0; 4];
        for (helix_deg, (rack, lower)) in [0.0, 30.0, 50.0].into_iter().flat_map(|helix_deg| {
            [(high, 0.0), (high, 1.0), (shallow, 2.5)].map(|tip| (helix_deg, tip))
        }) {
            let gear = gear(helix_deg, rack, lower);
            let (base, thickness) = (gear.base_radius(), gear.base_thickness());
            let [form, tip, root] =
                [gear.form_radius(), gear.tip_radius(), gear.root_radius()].map(|r| 2.0 * r);
            let length = gear.tip_roll() - gear.form_roll();
            for k in -2..=42 {
                let roll = gear.form_roll() + length * (0.025 * f64::from(k) + 1e-3);
                let pin = pin_touching(gear.basic_data(), roll, thickness);
                let up = roll + pin * lean(helix_deg) / (2.0 * base);
                let centre = 2.0 * base.hypot(base * up);
                let found = 2.0 * pin_centre_radius(gear.basic_data(), pin, thickness);
                assert!((found - centre).abs() < 2e-11, "{helix_deg} {k}");
                // No involute is nearer than the base circle.
                let contact = 2.0 * base.hypot(base * roll.max(0.0));
                let (what, expected) = if !(0..40).contains(&k) {
                    (1, [contact, form, tip])
                } else if centre + pin <= tip {
                    (2, [centre + pin, tip, pin])
                } else if centre - pin < root {
                    (3, [centre - pin, root, pin])
                } else {
                    (0, [0.0; 3])
                };
                let (said, numbers) = match check_pins(&gear, pin) {
                    Err(GearError::PinOffInvolute {
                        contact_diameter_mm,
                        form_diameter_mm,
                        tip_diameter_mm,
                        ..
                    }) => (1, [contact_diameter_mm, form_diameter_mm, tip_diameter_mm]),
                    Err(GearError::PinBelowTip {
                        pin_top_diameter_mm,
                        tip_diameter_mm,
                        pin_mm,
                    }) => (2, [pin_top_diameter_mm, tip_diameter_mm, pin_mm]),
                    Err(GearError::PinInRoot {
                        pin_bottom_diameter_mm,
                        root_diameter_mm,
                        pin_mm,
                    }) => (3, [pin_bottom_diameter_mm, root_diameter_mm, pin_mm]),
                    other => (0, other.map(|()| [0.0; 3]).unwrap()),
                };
                let close = numbers
                    .iter()
                    .zip(expected)
                    .all(|(a, b)| (a - b).abs() < 1e-9);
                let case = format!("{helix_deg} {lower} {k}: {numbers:?} {expected:?}");
                assert!(said == what && close, "{case}");
                met[what] += 1;
            }
        }
        assert!(met.iter().all(|count| *count > 0), "{met:?}");
    }
}
