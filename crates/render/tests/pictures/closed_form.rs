//! Perfect gears, whose lost motion has a closed form.

use gearlash::contact::{Contact, LostMotion, ToothPlace, Touch};
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Side, involute};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use nalgebra::{Point2, UnitComplex, Vector2};
use std::f64::consts::TAU;

/// A pair of full-depth gears of 20°, wheel front, pinion back.
pub fn pair(teeth: [u32; 2], module: f64, center_distance: f64, locked: Member) -> GearPair {
    let [wheel, pinion] = teeth.map(|teeth| {
        Gear::nominal(GearDesign {
            basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
            profile_shift: 0.0,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        })
        .unwrap()
    });
    GearPair::with_locked(
        AsBuilt::perfect(wheel, Face::Front),
        AsBuilt::perfect(pinion, Face::Back),
        center_distance,
        locked,
    )
    .unwrap()
}

/// A pose.
pub fn pose(assembly: &GearPair, teeth: [u32; 2], flank: Side, fraction: f64) -> Pose {
    let mating = Mating {
        wheel_tooth: teeth[0],
        pinion_tooth: teeth[1],
        flank,
        fraction,
    };
    Pose::new(assembly, mating)
}

/// `j_bn = p_b − s_b1 − s_b2 + 2 (r_b1 + r_b2) inv α_wt`, mm (design section 5, model 2).
pub fn j_bn(assembly: &GearPair) -> f64 {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m).gear());
    wheel.basic_data().base_pitch() - wheel.base_thickness() - pinion.base_thickness()
        + 2.0
            * (wheel.base_radius() + pinion.base_radius())
            * involute::inv(assembly.operating_pressure_angle())
}

/// Lost motion of perfect gears. Both contacts are on the lines of action. The mating's flanks meet at the nominal rotation;
/// `j_bn` is open on the other side. Among pairs that tie, it has the one nearest the pitch point.
pub fn lost_motion(assembly: &GearPair, pose: &Pose) -> LostMotion {
    let flank = pose.mating().flank;
    let free = assembly.gear(assembly.free()).gear();
    let contact = |side: Side| {
        let open = side.sense() * j_bn(assembly) / free.base_radius();
        let turn = if side == flank { 0.0 } else { open };
        contact(assembly, pose, side, pose.free_rotation() + turn)
    };
    LostMotion {
        right: Some(contact(Side::Right)),
        left: Some(contact(Side::Left)),
        solid: false,
    }
}

fn contact(assembly: &GearPair, pose: &Pose, side: Side, rotation: f64) -> Contact {
    let alpha = assembly.operating_pressure_angle();
    let touch = |member: Member| {
        let as_built = assembly.gear(member);
        let gear = as_built.gear();
        let turned = if member == assembly.locked() {
            pose.locked_rotation()
        } else {
            rotation
        };
        // A tooth has its centre at θ; its flank starts on the base circle at θ ± ψ_b. Its line of action leaves the base circle
        // at ∓α. The flank crosses it at the roll ξ = α + ψ_b ± θ.
        let roll = |tooth: u32| {
            let theta = turned + as_built.tooth_angle(f64::from(tooth));
            let theta = theta - (theta / TAU).round() * TAU;
            alpha + gear.half_base_angle() + side.sense() * theta
        };
        let off = |tooth: u32| (roll(tooth) - alpha.tan()).abs();
        let tooth = (1..=gear.basic_data().teeth())
            .min_by(|a, b| off(*a).total_cmp(&off(*b)))
            .unwrap();
        let touch = Touch {
            tooth,
            curve: ToothPlace::Involute,
            radius: involute::radius_at(roll(tooth), gear.base_radius()),
        };
        (touch, roll(tooth) * gear.base_radius())
    };
    let (wheel, along) = touch(Member::Wheel);
    let (pinion, _) = touch(Member::Pinion);
    let radial = UnitComplex::new(-side.sense() * alpha) * Vector2::x();
    let normal = side.sense() * Vector2::new(-radial.y, radial.x);
    let base = assembly.gear(Member::Wheel).gear().base_radius();
    Contact {
        rotation,
        error: 1e-9,
        wheel,
        pinion,
        point: Point2::from(base * radial + along * normal),
        normal,
        section: 0.0,
    }
}
