//! The face that two gears have in common.

use super::files::PairFile;
use super::gear::GearPart;
use super::helix::missing_face;
use super::spec::GearSpec;
use gearlash::gear::AsBuilt;
use gearlash::pair::Member;
use gearlash_text::{Problem, Table};

/// The common face of both gears, mm from the wheel's measuring plane. Its length is 0 for spur gears that do not change along it. `offset` is the
/// place of the pinion's measuring plane. `leans`: axes are not known to be parallel.
///
/// The lengths of wheel and pinion are `factors` times those stated.
/// `None` where something is wrong with it: gears that do not face each other, hands that do not mesh.
pub fn common_face(
    file: &Table,
    [wheel, pinion]: [&GearPart; 2],
    (offset, leans): (f64, bool),
    factors: [f64; 2],
) -> Option<[f64; 2]> {
    let [one, other] = [wheel.known.helix?, pinion.known.helix?];
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
    if !one.is_helical() {
        let mut gears = [wheel, pinion].into_iter();
        let why = if leans {
            "the axes lean, or may lean"
        } else if gears.any(GearPart::has_leads) {
            "the mate has leads"
        } else {
            return Some([0.0; 2]);
        };
        for (name, helix) in [("wheel", one), ("pinion", other)] {
            if helix.face_mm.is_none() {
                return file.refuse(
                    &format!("{name}.face_width_mm"),
                    missing_face(format!(": {why}")),
                    GIVE_FACE,
                );
            }
        }
    } else if let Some(hand) = one.hand.filter(|_| one.hand == other.hand) {
        return file.refuse(
            "pinion.hand",
            format!(
                "is \"{}\" as the wheel's: teeth of an external pair wind opposite ways",
                hand.name()
            ),
            format!("write hand = \"{}\" at one of them", hand.mate().name()),
        );
    }
    let wheel = one.face_mm?.map(|end| end * factors[0]);
    let pinion = other.face_mm?.map(|end| end * factors[1] + offset);
    let common = common(wheel, pinion)
        .map_err(|reason| file.problem("pinion.face_mm", reason, CORRECT_FACE));
    file.reading().keep(common)
}

const GIVE_FACE: &str =
    "give the length of the teeth along the axis: results depend on where both gears have teeth";
const CORRECT_FACE: &str = "correct face_mm, face_width_mm or assembly.face_offset_mm, how far the pinion's measuring plane lies beyond the wheel's";

/// The common face of teeth with these ends, mm from the wheel's measuring plane.
/// Errors: the reason why there is none.
fn common(wheel: [f64; 2], pinion: [f64; 2]) -> Result<[f64; 2], String> {
    let common = [wheel[0].max(pinion[0]), wheel[1].min(pinion[1])];
    if common[0] < common[1] {
        return Ok(common);
    }
    Err(format!(
        "the gears do not face each other: the wheel's teeth run from {:?} to {:?} mm, the pinion's from {:?} to {:?} mm",
        wheel[0], wheel[1], pinion[0], pinion[1]
    ))
}

/// The reason why a face is needed where one of `gears` takes the place of a pair's own.
pub fn reason_of_gears<'a>(mut gears: impl Iterator<Item = &'a AsBuilt>) -> Option<&'static str> {
    let varies = |gear: &AsBuilt| gear.has_leads() || gear.wobble() > 0.0;
    gears
        .any(varies)
        .then_some("a measured gear has leads or wobble")
}

/// Gives the spur `pair` at 20 °C its common face where there is a reason `why` it needs one.
/// Errors: a face width that the pair does not state; gears that do not face each other.
pub fn add_to(pair: &mut PairFile, why: Option<&str>) -> Result<(), Problem> {
    let Some(why) = why.filter(|_| pair.study.face == [0.0; 2]) else {
        return Ok(());
    };
    let face = |member: Member| {
        let face = pair.spec.data(member).and_then(GearSpec::face);
        let key = || format!("{}.face_width_mm", member.name());
        face.ok_or_else(|| Problem::at(key(), missing_face(format!(": {why}")), GIVE_FACE))
    };
    let wheel = face(Member::Wheel)?;
    let offset = pair.spec.assembly.face_offset_mm.unwrap_or(0.0);
    let pinion = face(Member::Pinion)?.map(|end| end + offset);
    pair.study.face = common(wheel, pinion)
        .map_err(|reason| Problem::at("pinion.face_mm", reason, CORRECT_FACE))?;
    // Teeth are counted in the wheel's measuring plane.
    for (_, _, pinion) in &mut pair.study.materials {
        *pinion = pinion.section_at(-offset);
    }
    Ok(())
}
