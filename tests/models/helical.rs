//! Helical gears in closed form: other programs' numbers, and what follows from them.

use super::*;

/// Right hand; the tool's tip round is 0.25 of the module.
fn right(z: u32, module: f64, beta_deg: f64, shift: f64) -> Make {
    let gear = spur(z, module).rack(1.0, 1.25, 0.25).shift(shift);
    gear.helix(beta_deg, Hand::Right)
}

/// ISO 21771: `W_k = m_n cos α_n (π (k − ½) + z inv α_t) + 2 x m_n sin α_n + A_sn cos α_n`, in other symbols than the code's.
#[test]
fn spans_lie_in_the_normal_section() {
    let alpha = 20f64.to_radians();
    for (z, module, beta_deg, shift, k) in [
        (27, 4.5, 21.0, 0.3, 4),
        (51, 4.5, 21.0, 0.16, 7),
        (24, 14.0, 10.0, 0.48, 4),
        (95, 14.0, 10.0, 0.67, 13),
    ] {
        let beta = f64::to_radians(beta_deg);
        let alpha_t = (alpha.tan() / beta.cos()).atan();
        for allowance in [0.0, -0.14] {
            let teeth = PI * (f64::from(k) - 0.5) + f64::from(z) * inv(alpha_t);
            let expected = module * alpha.cos() * teeth
                + 2.0 * shift * module * alpha.sin()
                + allowance * alpha.cos();
            let gear = right(z, module, beta_deg, shift).allowance(allowance);
            let (data, base) = (gear.design.basic_data, gear.gear().base_thickness());
            let span = thickness::span_from_base(&data, k, base);
            near((z, k), span, expected, 1e-12 * expected);
            let back = thickness::base_from_span(&data, k, span);
            near((z, k), back, base, 1e-12 * span);
        }
    }
}

/// ISO 21771, in other symbols than the code's: `ε_β = b sin β/(π m_n)`; `s_an = s_at cos β_a`, `tan β_a = tan β d_a/d`,
/// `s_at = d_a ((π/2 + 2 x tan α_n)/z + inv α_t − inv α_at)`. Also of spur gears.
#[test]
fn overlap_and_tip_lands_are_of_the_helix() {
    let alpha = 20f64.to_radians();
    for (z, module, beta_deg, shift) in [
        (27, 4.5, 21.0, 0.3),
        (24, 14.0, 35.0, -0.1),
        (44, 3.0, 0.0, 0.0),
    ] {
        let make = right(z, module, beta_deg, shift);
        let gear = make.gear();
        let (beta, teeth) = (f64::to_radians(beta_deg), f64::from(z));
        let alpha_t = (alpha.tan() / beta.cos()).atan();
        let d = teeth * module / beta.cos();
        let tip = d + 2.0 * module * (1.0 + shift);
        let alpha_at = (d * alpha_t.cos() / tip).acos();
        let angle = (0.5 * PI + 2.0 * shift * alpha.tan()) / teeth + inv(alpha_t) - inv(alpha_at);
        let beta_a = (beta.tan() * tip / d).atan();
        near(z, limits::tip_helix_cos(&gear), beta_a.cos(), 1e-14);
        let expected = tip * angle * beta_a.cos();
        near(z, limits::tip_thickness(&gear), expected, 1e-12 * tip);

        let pair = pair(&make, &make.clone().helix(beta_deg, Hand::Left), tip);
        let width = 31.0;
        let pair = pair.with_face([-7.0, width - 7.0]).unwrap();
        let expected = width * beta.sin() / (PI * module);
        near(z, limits::overlap_ratio(&pair), expected, 1e-12 * expected);
    }
}

/// The least shift without undercut is the one from which on the generated tooth shows none (within 1/1000 of a module: nearer to it the edge is as
/// small as rounding).
#[test]
fn undercut_of_helical_gears_begins_at_its_shift() {
    for (z, beta_deg) in [(9, 10.0), (7, 30.0), (12, 45.0)] {
        let at = |shift| right(z, 3.0, beta_deg, shift);
        let design = at(0.0).design;
        let least = limits::least_shift_without_undercut(&design.basic_data, &design.rack);
        let is_undercut = [-1e-3, 1e-3].map(|by| at(least + by).gear().is_undercut());
        assert_eq!(is_undercut, [true, false], "{z}: {least}");
    }
}

/// Published: FVA Workbench (27 and 23 teeth, to 1e-9 mm) and KISSsoft (24/95, nominal, upper and lower thickness, printed to 1 µm): form
/// diameters, which a circle in place of the ellipse would put 33 to 47 µm lower.
#[test]
fn form_diameters_of_the_elliptic_tip_round() {
    for row in rows::<[f64; 6]>(include_str!("data/form_diameters_fva.csv")) {
        let [z, module, beta, x_e, form, root] = row;
        let gear = right(z as u32, module, beta, x_e).gear();
        near(z, 2.0 * gear.form_radius(), form, 1e-9);
        near(z, 2.0 * gear.root_radius(), root, 1e-9);
        // The involute and the envelope of the ellipse meet there, and run on into each other.
        let (fillet, involute) = (gear.fillet(), gear.form_radius());
        let end = fillet.point(fillet.end());
        near(z, end.coords.norm(), involute, 1e-12 * involute);
        let half = gear.half_angle_at_roll(gear.form_roll());
        near(z, -end.y.atan2(end.x), half, 1e-13);
    }
    for row in rows::<[f64; 4]>(include_str!("data/form_diameters_kisssoft.csv")) {
        let [z, shift, allowance, printed] = row;
        let gear = right(z as u32, 14.0, 10.0, shift).rack(1.0, 1.25, 0.38);
        let form = gear.allowance(allowance).gear().form_radius();
        near((z, allowance), 2.0 * form, printed, 5.1e-4);
    }
}

/// Published: FVA Workbench's two meshes (by their exact geometry, derived and checked by slices beside this program) and KISSsoft's 24/95,
/// printed 0.359 … 0.571 mm.
#[test]
fn backlash_of_published_meshes() {
    for row in rows::<[f64; 10]>(include_str!("data/meshes.csv")) {
        let [z_1, x_1, z_2, x_2, module, beta, distance, a_1, a_2, exact] = row;
        let gear = |z, x, allowance| right(z as u32, module, beta, x).allowance(allowance);
        let wheel = gear(z_1, x_1, a_1).helix(beta, Hand::Left);
        let pair = pair(&wheel, &gear(z_2, x_2, a_2), distance);
        let j_wt = InvolutePair::of(&pair).circumferential_backlash(distance);
        let j_wt = j_wt.unwrap();
        near(row, j_wt, exact, 1e-9);
        let backlash = gearlash::pair::Backlash::new(&pair, j_wt);
        let data = pair.gear(Member::Wheel).gear().basic_data();
        // j_bn = j_t cos α_n cos β.
        let normal = backlash.j_t * 20f64.to_radians().cos() * data.helix_angle().cos();
        near(row, backlash.j_bn, normal, 1e-15);
        let of_base = backlash.j_bt(&pair) * data.base_helix_angle().cos();
        near(row, of_base, normal, 1e-15);
    }
}

#[test]
fn what_is_no_helical_pair_is_refused() {
    let gear = |degrees: f64, hand| spur(30, 2.0).helix(degrees, hand).front();
    let pair = |degrees, hand| GearPair::new(gear(20.0, Hand::Left), gear(degrees, hand), 70.0);
    for (degrees, hand, message) in [
        (20.0, Hand::Left, "both gears are left-handed"),
        (21.0, Hand::Right, "helix angle (degrees) differs: wheel 20"),
        (0.0, Hand::Right, "helix angle (degrees) differs: wheel 20"),
    ] {
        let said = pair(degrees, hand).unwrap_err().to_string();
        assert!(said.starts_with(message), "{said}");
    }
    let helical = pair(20.0, Hand::Right).unwrap();
    for face in [[5.0, 4.0], [0.0, f64::NAN]] {
        assert!(helical.clone().with_face(face).is_err(), "{face:?}");
    }
    let faced = helical.with_face([-5.0, 4.0]).unwrap();
    assert_eq!(faced.at(71.0).unwrap().face(), [-5.0, 4.0]);
    let data = spur(30, 2.0).design.basic_data;
    for angle in [-0.1, 1.1, f64::NAN] {
        assert!(data.with_helix(angle, Hand::Left).is_err());
    }
    assert_eq!(data.with_helix(0.0, Hand::Left).unwrap(), data);
}
