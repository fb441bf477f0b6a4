//! A drawn pose as the text of a pair file that reproduces it to the last bit.

use super::draw::Drawn;
use super::gear::Numbers;
use gearlash::gear::Face;
use gearlash::pair::GearPair;
use std::fmt::Write;

/// The pose as a pair file, its flank in the title (a pair file runs both).
pub fn text(drawn: &Drawn) -> String {
    let mating = &drawn.mating;
    let mut text = format!("title = \"pose at the {} flank\"\n", mating.flank.name());
    for (numbers, name) in drawn.gears.iter().zip(["wheel", "pinion"]) {
        // Writing to a String cannot fail.
        let _ = write(numbers, name, &drawn.assembly, &mut text);
    }
    let _ = writeln!(
        text,
        "[assembly]\ncenter_distance_mm = {:?}\nlocked = \"{}\"\n[sweep]\nmating = [[{}, {}]]\nfraction = [{:?}]",
        drawn.assembly.center_distance(),
        drawn.assembly.locked().name(),
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.fraction,
    );
    text
}

fn write(
    numbers: &Numbers,
    name: &str,
    assembly: &GearPair,
    text: &mut String,
) -> std::fmt::Result {
    let face = match numbers.face {
        Face::Front => "front",
        Face::Back => "back",
    };
    writeln!(text, "[{name}]\nteeth = {}", numbers.teeth)?;
    writeln!(text, "reference_face = \"{face}\"")?;
    for (key, value) in [
        ("module_mm", numbers.module_mm),
        ("pressure_angle_deg", numbers.pressure_angle_deg),
        ("profile_shift", numbers.profile_shift),
        ("tip_diameter_mm", numbers.tip_diameter_mm),
    ] {
        writeln!(text, "{key} = {value:?}")?;
    }
    if let Some((angle_deg, hand)) = numbers.helix {
        let (hand, ends) = (hand.name(), assembly.face());
        writeln!(text, "helix_angle_deg = {angle_deg:?}\nhand = \"{hand}\"")?;
        writeln!(text, "face_mm = {ends:?}")?;
    }
    let [addendum, dedendum, root_radius] = numbers.rack;
    writeln!(
        text,
        "rack = {{ addendum = {addendum:?}, dedendum = {dedendum:?}, root_radius = {root_radius:?} }}"
    )?;
    writeln!(text, "[{name}.thickness]")?;
    writeln!(text, "allowance_um = {:?}", numbers.allowance_um)?;
    if !numbers.per_tooth_um.is_empty() {
        writeln!(text, "per_tooth_um = {:?}", numbers.per_tooth_um)?;
    }
    if numbers.runout_um > 0.0 {
        let (total, high) = (numbers.runout_um, numbers.high_tooth);
        writeln!(text, "[{name}.runout]\ntotal_um = {total:?}")?;
        writeln!(text, "high_tooth = {high:?}")?;
    }
    if !numbers.right_um.is_empty() {
        let (right, left) = (&numbers.right_um, &numbers.left_um);
        writeln!(text, "[{name}.pitch]\nkind = \"cumulative\"")?;
        writeln!(text, "right_um = {right:?}\nleft_um = {left:?}")?;
    }
    Ok(())
}
