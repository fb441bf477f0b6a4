//! The field of action, sections as drawn, and what the face width costs, against closed forms and against the sections themselves.

use super::helical::pair_of_the_prototype;
use gearlash::analysis::curves::{Field, FieldSide, PathLimit};
use gearlash::analysis::extremes::extremes;
use gearlash::analysis::face_width::over_widths;
use gearlash::analysis::study::Study;
use gearlash::contact::{ContactKind, ExactKernel, MeshSection, Method};
use gearlash::gear::{Hand, Side};
use gearlash::pair::{GearPair, Mating, Member};
use std::ops::ControlFlow;

fn mating(flank: Side, fraction: f64) -> Mating {
    Mating {
        wheel_tooth: 4,
        pinion_tooth: 16,
        flank,
        fraction,
    }
}

fn field(pair: &GearPair, mating: Mating) -> Field {
    Field::of(pair, &pair.lost_motion(mating).unwrap()).unwrap()
}

/// Perfect 27/51 on a face of its own.
fn perfect(hand: Hand) -> GearPair {
    let pair = pair_of_the_prototype([0.0; 2], [0.0; 2], hand, 1);
    pair.with_face([-20.0, 30.0]).unwrap()
}

/// tan β_b = tan β cos α_t, p_bt = π m_t cos α_t, with tan α_t = tan α_n/cos β and m_t = m_n/cos β (ISO 21771).
fn tangent_and_base_pitch() -> (f64, f64) {
    let beta = 21f64.to_radians();
    let transverse = (20f64.to_radians().tan() / beta.cos()).atan();
    let pitch = std::f64::consts::PI * 4.5 / beta.cos() * transverse.cos();
    (beta.tan() * transverse.cos(), pitch)
}

fn side(field: &Field, side: Side) -> &FieldSide {
    &field.sides[usize::from(side == Side::Left)]
}

/// The mating's flank passes through the pitch point in the measuring plane: its line is s = ± z tan β_b, those of its neighbours lie p_bt apart,
/// and all of them touch. The path ends at the tip circles, √(r_a² − r_b²) − r_b tan α_wt from the pitch point.
#[test]
fn contact_lines_of_perfect_gears_are_where_the_closed_form_says() {
    let (tangent, pitch) = tangent_and_base_pitch();
    let mut slopes = Vec::new();
    for hand in [Hand::Right, Hand::Left] {
        let pair = perfect(hand);
        let radii = [Member::Wheel, Member::Pinion].map(|member| {
            let gear = pair.gear(member).gear();
            (gear.base_radius(), gear.tip_radius())
        });
        let cos = (radii[0].0 + radii[1].0) / 190.0;
        let beyond = radii.map(|(base, tip)| {
            (tip * tip - base * base).sqrt() - base * (1.0 - cos * cos).sqrt() / cos
        });
        for flank in Side::BOTH {
            let field = field(&pair, mating(flank, 0.0));
            let side = side(&field, flank);
            assert!((side.path[0] + beyond[1]).abs() < 1e-10, "{:?}", side.path);
            assert!((side.path[1] - beyond[0]).abs() < 1e-10, "{:?}", side.path);
            let tips = [Member::Pinion, Member::Wheel].map(PathLimit::Tip);
            assert_eq!(side.limits, tips);
            let own = side
                .lines
                .iter()
                .find(|line| line.wheel_tooth == 4)
                .unwrap();
            let [one, other] = own.ends;
            let slope = (other[1] - one[1]) / (other[0] - one[0]);
            assert!((slope.abs() - tangent).abs() < 1e-12, "{slope}");
            slopes.push(slope.signum());
            assert_eq!((own.wheel_tooth, own.pinion_tooth), (4, 16));
            assert!(side.lines.len() > 2);
            for line in &side.lines {
                let pitches = f64::from(line.wheel_tooth) - 4.0;
                for [z, place] in line.ends {
                    let off = (place - slope * z) / pitch;
                    assert!((off.abs() - pitches.abs()).abs() < 1e-12, "{off} {pitches}");
                    let [low, high] = side.path;
                    assert!((low - 1e-12..=high + 1e-12).contains(&place));
                    assert!((-20.0..=30.0).contains(&z));
                }
                assert!(line.gap.abs() < 1e-12, "{}", line.gap);
            }
            assert_eq!(side.binding.kind, ContactKind::Involute);
            for section in &side.sections {
                assert!(section.gap.unwrap().abs() < 1e-11);
            }
        }
    }
    // Right and left flanks wind opposite ways, and so do both hands.
    assert_eq!(slopes[0], -slopes[1]);
    assert_eq!(slopes[..2], [-slopes[2], -slopes[3]]);
}

/// The exact method's own contact in a section, which knows no line: as far from the pitch point as a line of the field is there.
#[test]
fn contact_lines_hold_the_contacts_of_the_sections() {
    for locked in [Member::Wheel, Member::Pinion] {
        let pair = perfect(Hand::Right);
        let gear = |member| pair.gear(member).clone();
        let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(gear);
        let pair = GearPair::with_locked(wheel, pinion, 190.0, locked).unwrap();
        lines_hold_contacts(&pair.with_face([-20.0, 30.0]).unwrap());
    }
}

fn lines_hold_contacts(pair: &GearPair) {
    let mating = mating(Side::Right, 0.3);
    let field = field(pair, mating);
    let pose = gearlash::pair::Pose::new(pair, mating);
    let pitch_point = pair.operating_pitch_radius(Member::Wheel);
    for z in [-20.0, -3.0, 0.0, 11.0, 30.0] {
        let here = pose.in_section(pair, z);
        let found = ExactKernel::new(&pair.section(z))
            .lost_motion(&here)
            .unwrap();
        for (flank, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
            let contact = contact.unwrap();
            let away = (contact.point.x - pitch_point).hypot(contact.point.y);
            let lines = &side(&field, flank).lines;
            let line = lines
                .iter()
                .find(|line| line.wheel_tooth == contact.wheel.tooth);
            let [one, other] = line.unwrap().ends;
            let part = (z - one[0]) / (other[0] - one[0]);
            let place = one[1] + part * (other[1] - one[1]);
            assert!((place.abs() - away).abs() < 1e-8, "{z}: {place} {away}");
        }
    }
}

/// What a pair lacks until it touches is what the sections have in which it is the tightest, found by the exact method there; where it binds the
/// point is on its line.
#[test]
fn gaps_of_lines_are_those_of_their_sections() {
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 7);
    let pair = pair.with_face([-24.0, 24.0]).unwrap();
    let (mut compared, mut on_line) = (0, 0);
    for k in 0..40 {
        let field = field(&pair, mating(Side::Right, f64::from(k) * 0.7));
        for side in &field.sides {
            let least = side.sections.iter().filter_map(|section| section.gap);
            let least = least.fold(f64::INFINITY, f64::min);
            assert!(least.abs() < 1e-10, "{least}");
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
            for line in side.lines.iter().filter(|line| line.binds) {
                let [one, other] = line.ends;
                let part = (binding.section - one[0]) / (other[0] - one[0]);
                if binding.kind == ContactKind::Involute {
                    let place = one[1] + part * (other[1] - one[1]);
                    assert!((place - binding.place).abs() < 1e-6);
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
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 7);
    let pair = pair.with_face([-24.0, 24.0]).unwrap();
    let (mut apart, mut together) = (0, 0);
    for k in 0..12 {
        let pose = pair
            .lost_motion(mating(Side::Left, f64::from(k) * 0.7))
            .unwrap();
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
            let whole = (turned - twist) / std::f64::consts::TAU;
            assert!((whole - whole.round()).abs() < 1e-12, "{z}: {whole}");
            let here = section.alone().unwrap().left.unwrap().rotation;
            let gap = here - section.held().unwrap();
            let gap = gap - std::f64::consts::TAU * (gap / std::f64::consts::TAU).round();
            assert!(gap > -1e-12, "{gap}");
            apart += u32::from(gap > 1e-9);
            together += u32::from(gap == 0.0);
        }
    }
    assert!(apart > 5 && together > 5, "{apart} {together}");
    let pose = pair.lost_motion(mating(Side::Left, 0.0)).unwrap();
    for z in [-24.1, 24.1, f64::NAN] {
        let refused = MeshSection::new(&pair, &pose.pose, pose.proven(), z);
        assert!(refused.unwrap_err().to_string().contains("-24 to 24 mm"));
    }
}

/// A face that holds another has no more play; eccentricities alone cost nothing.
#[test]
fn a_wider_face_costs() {
    let on = || ControlFlow::Continue(());
    let method = Method::Exact { certify: true };
    for (pitch, costs) in [([0.0; 2], false), ([4.0, 5.0], true)] {
        let pair = pair_of_the_prototype([30.0, 40.0], pitch, Hand::Right, 7);
        let pair = pair.with_face([-20.0, 40.0]).unwrap();
        let study = Study::of_pair("27/51", &pair, 4);
        let full = extremes(&study, method, &on).unwrap().each;
        let widths = over_widths(&study, &full, method, &on).unwrap();
        let faces: Vec<[f64; 2]> = widths.iter().map(|at| at.face).collect();
        let held = [[0.0, 0.0], [-5.0, 10.0], [-10.0, 20.0], [-15.0, 30.0]];
        assert_eq!(faces[..4], held);
        assert_eq!(faces[4..], [[-20.0, 40.0]]);
        for pair in widths.windows(2) {
            for rises in pair[1].against(&pair[0]) {
                assert!(rises.unwrap() < 2e-6);
            }
        }
        let [least, greatest] = widths[4].against(&widths[0]).map(Option::unwrap);
        match costs {
            false => assert!(least.abs() < 2e-6 && greatest.abs() < 2e-6),
            true => assert!(greatest < -1e-3, "{least} {greatest}"),
        }
    }
}
