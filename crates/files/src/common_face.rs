//! The face that two helical gears have in common.

use super::gear::GearPart;
use super::table::Table;

/// The common face of both gears, mm from the wheel's measuring plane, and how far off the pinion's lies; no length of spur gears.
///
/// `None` where something is wrong with it: gears that do not face each other, hands that do not mesh.
pub fn common_face(
    file: &Table,
    [wheel, pinion]: [&GearPart; 2],
    offset_mm: Option<f64>,
) -> Option<[f64; 2]> {
    let [one, other] = [wheel.helix?, pinion.helix?];
    if one.angle_deg != other.angle_deg {
        return file.refuse(
            "pinion.helix_angle_deg",
            format!(
                "differs from wheel.helix_angle_deg = {:?}, must be equal on both gears",
                one.angle_deg
            ),
            "correct one of them: gears of parallel axes have one helix angle at the reference circle",
        );
    }
    if one.angle_deg == 0.0 {
        return Some([0.0; 2]);
    }
    if let Some(hand) = one.hand.filter(|_| one.hand == other.hand) {
        return file.refuse(
            "pinion.hand",
            format!(
                "is \"{}\" as the wheel's: teeth of an external pair wind opposite ways",
                hand.name()
            ),
            format!("write hand = \"{}\" at one of them", hand.mate().name()),
        );
    }
    let offset = offset_mm.unwrap_or(0.0);
    let (wheel, pinion) = (one.face_mm?, other.face_mm?.map(|end| end + offset));
    let common = [wheel[0].max(pinion[0]), wheel[1].min(pinion[1])];
    if common[0] < common[1] {
        return Some(common);
    }
    file.refuse(
        "pinion.face_mm",
        format!(
            "the gears do not face each other: the wheel's teeth run from {:?} to {:?} mm, the pinion's from {:?} to {:?} mm",
            wheel[0], wheel[1], pinion[0], pinion[1]
        ),
        "correct face_mm, face_width_mm or assembly.face_offset_mm, how far the pinion's measuring plane lies beyond the wheel's",
    )
}

/// The common face, mm from the wheel's measuring plane, and how far off the pinion's lies, where the lengths of the wheel and of the pinion are `factors` times
/// those stated; the distance of the measuring planes is taken to expand as the wheel does. `cold` is the common face as stated.
pub fn warm_face(
    cold: [f64; 2],
    [wheel, pinion]: [&GearPart; 2],
    offset_mm: Option<f64>,
    factors: [f64; 2],
) -> ([f64; 2], f64) {
    let offset = offset_mm.unwrap_or(0.0) * factors[0];
    let faces = [wheel, pinion].map(|gear| gear.helix.and_then(|helix| helix.face_mm));
    let warm = match (faces, factors[0] == factors[1]) {
        ([Some(wheel), Some(pinion)], false) => {
            let wheel = wheel.map(|end| end * factors[0]);
            let pinion = pinion.map(|end| end * factors[1] + offset);
            [wheel[0].max(pinion[0]), wheel[1].min(pinion[1])]
        }
        _ => cold.map(|end| end * factors[0]),
    };
    (warm, offset)
}
