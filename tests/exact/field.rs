//! The field of action, sections as drawn, and what the face width costs, against closed forms and against the sections themselves.

use super::*;
use crate::helical_pairs::pair_of_the_prototype;
use gearlash::analysis::curves::{ContactLine, Field, FieldSide, PathLimit, STRETCH_END};
use gearlash::contact::{ContactClass, ContactKind, MeshSection, lost_motion_at};

fn mating(flank: Side, fraction: f64) -> Mating {
    at_flank(4, 16, flank, fraction)
}

fn field(pair: &GearPair, mating: Mating) -> Field {
    Field::of(pair, &lost_motion_at(&pair.clone().into(), mating).unwrap()).unwrap()
}

/// Perfect 27/51 on a face of its own.
fn perfect(hand: Hand) -> GearPair {
    let pair = pair_of_the_prototype([0.0; 2], [0.0; 2], hand, 1);
    pair.with_face([-20.0, 30.0]).unwrap()
}

/// A pair of the prototype with eccentricities and pitch deviations.
fn deviating(hand: Hand) -> GearPair {
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], hand, 7);
    pair.with_face([-24.0, 24.0]).unwrap()
}

/// Place on a contact line at `z`.
fn place_at(line: &ContactLine, z: f64) -> f64 {
    let [one, other] = line.ends;
    one[1] + (z - one[0]) / (other[0] - one[0]) * (other[1] - one[1])
}

/// tan β_b = tan β cos α_t, p_bt = π m_t cos α_t, with tan α_t = tan α_n/cos β and m_t = m_n/cos β (ISO 21771).
fn tangent_and_base_pitch() -> (f64, f64) {
    let beta = 21f64.to_radians();
    let transverse = (20f64.to_radians().tan() / beta.cos()).atan();
    let pitch = PI * 4.5 / beta.cos() * transverse.cos();
    (beta.tan() * transverse.cos(), pitch)
}

fn side(field: &Field, side: Side) -> &FieldSide {
    &field.sides[usize::from(side == Side::Left)]
}

fn line_of(side: &FieldSide, wheel_tooth: u32) -> &ContactLine {
    let mut lines = side.lines.iter();
    lines.find(|line| line.wheel_tooth == wheel_tooth).unwrap()
}

/// Base and tip radius of both gears.
fn radii(pair: &GearPair) -> [(f64, f64); 2] {
    Member::BOTH.map(|member| {
        let gear = pair.gear(member).gear();
        (gear.base_radius(), gear.tip_radius())
    })
}

/// The mating's flank passes through the pitch point in the measuring plane: its line is s = ± z tan β_b, those of its neighbours lie p_bt apart,
/// and all of them touch. The path ends at the tip circles, √(r_a² − r_b²) − r_b tan α_wt from the pitch point.
#[test]
fn contact_lines_of_perfect_gears_are_where_the_closed_form_says() {
    let (tangent, pitch) = tangent_and_base_pitch();
    let mut slopes = Vec::new();
    for hand in [Hand::Right, Hand::Left] {
        let pair = perfect(hand);
        let radii = radii(&pair);
        let cos = (radii[0].0 + radii[1].0) / 190.0;
        let beyond = radii.map(|(base, tip)| {
            (tip * tip - base * base).sqrt() - base * (1.0 - cos * cos).sqrt() / cos
        });
        for flank in Side::BOTH {
            let field = field(&pair, mating(flank, 0.0));
            let side = side(&field, flank);
            near("path", side.path[0], -beyond[1], 1e-10);
            near("path", side.path[1], beyond[0], 1e-10);
            let tips = [Member::Pinion, Member::Wheel].map(PathLimit::Tip);
            assert_eq!(side.limits, tips);
            let own = line_of(side, 4);
            let [one, other] = own.ends;
            let slope = (other[1] - one[1]) / (other[0] - one[0]);
            near("slope", slope.abs(), tangent, 1e-12);
            slopes.push(slope.signum());
            assert_eq!((own.wheel_tooth, own.pinion_tooth), (4, 16));
            assert!(side.lines.len() > 2);
            for line in &side.lines {
                let pitches = f64::from(line.wheel_tooth) - 4.0;
                for [z, place] in line.ends {
                    let off = (place - slope * z) / pitch;
                    near(z, off.abs(), pitches.abs(), 1e-12);
                    let [low, high] = side.path;
                    assert!((low - 1e-12..=high + 1e-12).contains(&place));
                    assert!((-20.0..=30.0).contains(&z));
                }
                near("gap", line.gap, 0.0, 1e-12);
            }
            assert_eq!(side.binding.kind, ContactKind::Involute);
            for section in &side.sections {
                near("gap", section.gap.unwrap(), 0.0, 1e-11);
            }
            assert!(side.fillets.is_empty());
        }
    }
    // Right and left flanks wind opposite ways, and so do both hands.
    assert_eq!(slopes[0], -slopes[1]);
    assert_eq!(slopes[..2], [-slopes[2], -slopes[3]]);
}

/// The exact method's own contact in a section, which knows no line: as far from the pitch point as a line of the field is there.
#[test]
fn contact_lines_hold_the_contacts_of_the_sections() {
    for locked in Member::BOTH {
        let pair = perfect(Hand::Right);
        let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member).clone());
        let pair = GearPair::with_locked(wheel, pinion, 190.0, locked).unwrap();
        let pair = pair.with_face([-20.0, 30.0]).unwrap();
        let mating = mating(Side::Right, 0.3);
        let field = field(&pair, mating);
        let pose = Pose::new(&pair, mating);
        let pitch_point = pair.operating_pitch_radius(Member::Wheel);
        for z in [-20.0, -3.0, 0.0, 11.0, 30.0] {
            let section = pair.section(z);
            let here = pose.in_section(&pair, z);
            let found = ExactKernel::new(&section).lost_motion(&here).unwrap();
            for flank in Side::BOTH {
                let contact = found.on(flank).unwrap();
                let away = (contact.point.x - pitch_point).hypot(contact.point.y);
                let line = line_of(side(&field, flank), contact.wheel.tooth);
                near(z, place_at(line, z).abs(), away, 1e-8);
            }
        }
    }
}

/// The gap of a pair is the gap of the sections in which it is the tightest, found by the exact method there. Where it
/// binds, the contact is on its line.
#[test]
fn gaps_of_lines_are_those_of_their_sections() {
    let pairs = [Hand::Right, Hand::Left].map(deviating);
    let (mut compared, mut on_line) = (0, 0);
    for k in 0..40 {
        let (pair, flank) = (&pairs[k % 2], Side::BOTH[k / 2 % 2]);
        let field = field(pair, mating(flank, k as f64 * 0.7));
        for side in &field.sides {
            let least = side.sections.iter().filter_map(|section| section.gap);
            let least = least.fold(f64::INFINITY, f64::min);
            near("least", least, 0.0, 1e-10);
            let lines = side.lines.iter().map(|line| line.gap);
            assert!(lines.clone().all(|gap| gap > -1e-10));
            for section in &side.sections {
                if section.kind == Some(ContactKind::Involute) {
                    let gap = section.gap.unwrap();
                    let off = lines.clone().map(|line| (line - gap).abs());
                    assert!(off.fold(f64::INFINITY, f64::min) < 1e-9, "{gap}");
                    compared += 1;
                }
            }
            let binding = &side.binding;
            if binding.kind == ContactKind::Involute {
                for line in side.lines.iter().filter(|line| line.binds) {
                    let place = place_at(line, binding.section);
                    near("place", place, binding.place, 1e-6);
                    on_line += 1;
                }
            }
        }
    }
    assert!(compared > 5000 && on_line > 40, "{compared} {on_line}");
}

/// A section turns its teeth by z tan β/r; where the flank binds nothing is left between, elsewhere the flanks are apart by what the section alone
/// would have more.
#[test]
fn a_drawn_section_stands_as_the_whole_face_holds_it() {
    let pair = deviating(Hand::Right);
    let (mut apart, mut together) = (0, 0);
    for k in 0..12 {
        let mating = mating(Side::Left, f64::from(k) * 0.7);
        let pose = lost_motion_at(&pair.clone().into(), mating).unwrap();
        let found = pose.proven();
        let own = MeshSection::of_contact(&pair, &pose.pose, found);
        let binding = MeshSection::new(&pair, &pose.pose, found, own).unwrap();
        let alone = binding.alone().unwrap().left.unwrap();
        assert_eq!(binding.held(), Some(alone.rotation));
        for z in [-24.0, -8.0, 0.0, 8.0, 24.0] {
            let section = MeshSection::new(&pair, &pose.pose, found, z).unwrap();
            let turned = section.pose().locked_rotation() - pose.pose.locked_rotation();
            let beta = 21f64.to_radians();
            let twist = -z * beta.tan() / (27.0 * 4.5 / 2.0 / beta.cos());
            near(z, without_turns(turned - twist), 0.0, 6e-12);
            let here = section.alone().unwrap().left.unwrap().rotation;
            let gap = without_turns(here - section.held().unwrap());
            assert!(gap > -1e-12, "{gap}");
            apart += u32::from(gap > 1e-9);
            together += u32::from(gap == 0.0);
        }
    }
    assert!(apart > 5 && together > 5, "{apart} {together}");
    let pose = lost_motion_at(&pair.clone().into(), mating(Side::Left, 0.0)).unwrap();
    for z in [-24.1, 24.1, f64::NAN] {
        let refused = MeshSection::new(&pair, &pose.pose, pose.proven(), z);
        assert!(refused.unwrap_err().to_string().contains("-24 to 24 mm"));
    }
}

/// In a perfect pair ⌊ε_γ⌋ or ⌊ε_γ⌋ + 1 contact lines cross the field of action, and ε_γ on the mean of a pitch. Source: ISO 21771, total
/// contact ratio ε_γ = ε_α + ε_β, ε_α = (√(r_a1² − r_b1²) + √(r_a2² − r_b2²) − a sin α_wt)/p_bt, ε_β = b sin β/(π m_n).
#[test]
fn as_many_lines_touch_as_the_total_contact_ratio_says() {
    const STEPS: u32 = 60;
    let (_, pitch) = tangent_and_base_pitch();
    let pair = pair_of_the_prototype([0.0; 2], [0.0; 2], Hand::Right, 1);
    for face in [[-20.0, 30.0], [-7.0, 5.0], [-100.0, 100.0]] {
        let pair = pair.clone().with_face(face).unwrap();
        let radii = radii(&pair);
        let sum = radii[0].0 + radii[1].0;
        let arms = radii.map(|(base, tip)| (tip * tip - base * base).sqrt());
        let arms = arms[0] + arms[1];
        let path = arms - (190f64 * 190.0 - sum * sum).sqrt();
        let overlap = (face[1] - face[0]) * 21f64.to_radians().sin() / (PI * 4.5);
        let ratio = path / pitch + overlap;
        let mut lines = [0; 2];
        for step in 0..STEPS {
            let mating = mating(Side::Right, f64::from(step) / f64::from(STEPS));
            let field = field(&pair, mating);
            for (sum, side) in lines.iter_mut().zip(&field.sides) {
                let count = side.lines.len();
                let whole = ratio as usize;
                assert!((whole..=whole + 1).contains(&count), "{count} {ratio}");
                *sum += count;
            }
        }
        for sum in lines {
            let steps = f64::from(STEPS);
            near(face, sum as f64 / steps, ratio, 1.0 / steps);
        }
    }
}

/// Perfect 70/25, m_n 2, β 15°, whose tips reach below the mate's form circle at 97.54 mm.
fn tips_on_fillets() -> GearPair {
    let gear = |teeth, hand| spur(teeth, 2.0).helix(15.0, hand).allowance(-0.45).front();
    let pair = GearPair::new(gear(70, Hand::Left), gear(25, Hand::Right), 97.54).unwrap();
    pair.with_face([-40.0, 40.0]).unwrap()
}

/// Where tips touch fillets first is where the sections, spur pairs of their own, say so; of perfect gears it comes again after the axial pitch
/// p_x = π m_n/sin β (ISO 21771).
#[test]
fn tips_touch_fillets_in_stretches_an_axial_pitch_apart() {
    let pair = tips_on_fillets();
    let axial = PI * 2.0 / 15f64.to_radians().sin();
    let mating = at_flank(3, 5, Side::Right, 0.3);
    let field = field(&pair, mating);
    let pose = Pose::new(&pair, mating);
    for side in &field.sides {
        assert_eq!(side.binding.kind, ContactKind::TipFillet);
        let whole: Vec<[f64; 2]> = (side.fillets.iter().copied())
            .filter(|ends| ends[0] > -40.0 && ends[1] < 40.0)
            .collect();
        assert!(whole.len() >= 2, "{:?}", side.fillets);
        for pair in whole.windows(2) {
            for (before, after) in pair[0].iter().zip(pair[1]) {
                near("apart", after - before, axial, 2.0 * STRETCH_END);
            }
        }
        let touched = |z: f64| {
            let section = pair.section(z);
            let here = pose.in_section(&pair, z);
            let found = ExactKernel::new(&section).lost_motion(&here).unwrap();
            let contact = found.on(side.side).unwrap();
            ContactClass::of(&section, side.side, &contact).kind
        };
        let seen = |z: f64| {
            let mut ends = side.fillets.iter();
            ends.any(|&[from, to]| (from..=to).contains(&z))
        };
        for k in 0..=777 {
            let z = -40.0 + 80.0 * f64::from(k) / 777.0;
            assert_eq!(touched(z) == ContactKind::TipFillet, seen(z), "{z}");
        }
        for [from, to] in whole {
            for (inside, outside) in [
                (from, from - 2.0 * STRETCH_END),
                (to, to + 2.0 * STRETCH_END),
            ] {
                assert_eq!(touched(inside), ContactKind::TipFillet);
                assert_ne!(touched(outside), ContactKind::TipFillet);
            }
        }
    }
}
