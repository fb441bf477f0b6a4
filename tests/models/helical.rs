//! Helical gears in closed form: other programs' numbers, and what follows from them.

use super::helical_dimensions::{PUBLISHED, Published};
use gearlash::analytic::{InvolutePair, limits};
use gearlash::error::GearError;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Hand, MeasuringBody, involute,
    thickness,
};
use gearlash::pair::{GearPair, Member};
use std::f64::consts::PI;

fn design(z: u32, module: f64, beta_deg: f64, shift: f64, rack: [f64; 3]) -> GearDesign {
    let [addendum, dedendum, round] = rack;
    let data = BasicGearData::new(z, module, 20f64.to_radians()).unwrap();
    let basic_data = data.with_helix(beta_deg.to_radians(), Hand::Right).unwrap();
    GearDesign {
        basic_data,
        profile_shift: shift,
        rack: BasicRack::new(addendum, dedendum, round).unwrap(),
        tip_diameter: None,
    }
}

const RACK: [f64; 3] = [1.0, 1.25, 0.25];

/// Published: FVA Workbench examples 1-3 (z 27/51 and 23/34). They have dimensions over two balls and over two pins of nominal gears. They
/// also have the allowances of the dimension over balls for −115 and −165 µm of tooth thickness in the normal section.
#[test]
fn over_balls_and_over_pins() {
    for Published {
        teeth,
        module,
        helix_deg,
        shift,
        ball,
        over_balls,
        over_pins,
        allowances,
    } in PUBLISHED
    {
        let design = design(teeth, module, helix_deg, shift, RACK);
        let data = design.basic_data;
        let nominal = design.nominal_base_thickness();
        let over = thickness::pins_from_base(&data, ball, nominal);
        assert!((over - over_balls).abs() < 1e-9, "{teeth}: {over}");
        let pins = thickness::over_helical_pins(&data, ball, nominal);
        assert!((pins - over_pins).abs() < 1e-9, "{teeth}: {pins}");
        for (mm, allowance) in [-0.115, -0.165].into_iter().zip(allowances) {
            let base = thickness::base_from_allowance(&data, nominal, mm);
            let found = thickness::pins_from_base(&data, ball, base) - over;
            assert!((found - allowance).abs() < 1e-9, "{teeth}: {found}");
            let back = thickness::base_from_pins(&data, ball, over + found).unwrap();
            assert!((back - base).abs() < 1e-11);
            for (body, over) in [
                (MeasuringBody::Ball, over + found),
                (MeasuringBody::Pin, {
                    thickness::over_helical_pins(&data, ball, base)
                }),
            ] {
                let is = thickness::over_from_base(&data, body, ball, base);
                assert!((is - over).abs() < 1e-9, "{teeth} {body:?}: {is} {over}");
                let back = thickness::base_from_over(&data, body, ball, over).unwrap();
                assert!(
                    (back - base).abs() < 1e-9,
                    "{teeth} {body:?}: {back} {base}"
                );
            }
            let back = thickness::base_from_helical_pins(
                &data,
                ball,
                pins + thickness::over_helical_pins(&data, ball, base) - pins,
            );
            assert!((back.unwrap() - base).abs() < 1e-11);
            assert!((thickness::allowance_from_base(&data, nominal, base) - mm).abs() < 1e-14);
        }
    }
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
        let design = design(z, module, beta_deg, shift, RACK);
        let beta = f64::to_radians(beta_deg);
        let alpha_t = (alpha.tan() / beta.cos()).atan();
        for allowance in [0.0, -0.14] {
            let expected = module
                * alpha.cos()
                * (PI * (f64::from(k) - 0.5) + f64::from(z) * involute::inv(alpha_t))
                + 2.0 * shift * module * alpha.sin()
                + allowance * alpha.cos();
            let data = &design.basic_data;
            let base =
                thickness::base_from_allowance(data, design.nominal_base_thickness(), allowance);
            let span = thickness::span_from_base(data, k, base);
            assert!(
                (span - expected).abs() < 1e-12 * expected,
                "{span} {expected}"
            );
            assert!((thickness::base_from_span(data, k, span) - base).abs() < 1e-12 * span);
        }
    }
}

/// ISO 21771, in other symbols than the code's: `ε_β = b sin β/(π m_n)`; `s_an = s_at cos β_a`, `tan β_a = tan β d_a/d`,
/// `s_at = d_a ((π/2 + 2 x tan α_n)/z + inv α_t − inv α_at)`.
#[test]
fn overlap_and_tip_lands_are_of_the_helix() {
    let alpha = 20f64.to_radians();
    for (z, module, beta_deg, shift) in [(27, 4.5, 21.0, 0.3), (24, 14.0, 35.0, -0.1)] {
        let gear = Gear::nominal(design(z, module, beta_deg, shift, RACK)).unwrap();
        let (beta, teeth) = (f64::to_radians(beta_deg), f64::from(z));
        let alpha_t = (alpha.tan() / beta.cos()).atan();
        let d = teeth * module / beta.cos();
        let tip = d + 2.0 * module * (1.0 + shift);
        let alpha_at = (d * alpha_t.cos() / tip).acos();
        let angle = (0.5 * PI + 2.0 * shift * alpha.tan()) / teeth + involute::inv(alpha_t)
            - involute::inv(alpha_at);
        let beta_a = (beta.tan() * tip / d).atan();
        assert!((limits::tip_helix_cos(&gear) - beta_a.cos()).abs() < 1e-14);
        let expected = tip * angle * beta_a.cos();
        assert!((limits::tip_thickness(&gear) - expected).abs() < 1e-12 * tip);

        let mate = GearDesign {
            basic_data: gear.basic_data().with_helix(beta, Hand::Left).unwrap(),
            ..*gear.design()
        };
        let built = |gear| AsBuilt::perfect(gear, Face::Front);
        let pair = GearPair::new(built(gear), built(Gear::nominal(mate).unwrap()), tip).unwrap();
        let width = 31.0;
        let pair = pair.with_face([-7.0, width - 7.0]).unwrap();
        let expected = width * beta.sin() / (PI * module);
        assert!((limits::overlap_ratio(&pair) - expected).abs() < 1e-12 * expected);
    }
}

/// The least shift without undercut is the one from which on the generated tooth shows none (within 1/1000 of a module: nearer to it the edge is as
/// small as rounding).
#[test]
fn undercut_of_helical_gears_begins_at_its_shift() {
    for (z, beta_deg) in [(9, 10.0), (7, 30.0), (12, 45.0)] {
        let at = |shift| design(z, 3.0, beta_deg, shift, RACK);
        let least = limits::least_shift_without_undercut(&at(0.0).basic_data, &at(0.0).rack);
        let is_undercut = |shift| Gear::nominal(at(shift)).unwrap().is_undercut();
        assert!(
            is_undercut(least - 1e-3) && !is_undercut(least + 1e-3),
            "{z}: {least}"
        );
    }
}

/// Published: FVA Workbench (27 and 23 teeth, to 1e-9 mm) and KISSsoft (24/95, nominal, upper and lower thickness, printed to 1 µm): form
/// diameters, which a circle in place of the ellipse would put 33 to 47 µm lower.
#[test]
fn form_diameters_of_the_elliptic_tip_round() {
    let nominal =
        |z, module, beta, x_e, rack| Gear::nominal(design(z, module, beta, x_e, rack)).unwrap();
    for (z, module, beta, x_e, form, root) in [
        (
            27,
            4.5,
            21.0,
            0.26489334408474646,
            124.21168451170895,
            121.27815682366175,
        ),
        (
            23,
            6.5,
            10.0,
            0.2756953920586706,
            144.12170239598015,
            139.1403185736816,
        ),
    ] {
        let gear = nominal(z, module, beta, x_e, RACK);
        assert!(
            (2.0 * gear.form_radius() - form).abs() < 1e-9,
            "{z}: {}",
            2.0 * gear.form_radius()
        );
        assert!((2.0 * gear.root_radius() - root).abs() < 1e-9, "{z}");
        // The involute and the envelope of the ellipse meet there, and run on into each other.
        let fillet = gear.fillet();
        let (end, involute) = (fillet.point(fillet.end()), gear.form_radius());
        assert!((end.coords.norm() - involute).abs() < 1e-12 * involute);
        let half = -end.y.atan2(end.x);
        assert!((half - gear.half_angle_at_roll(gear.form_roll())).abs() < 1e-13);
    }
    for (z, shift, allowances, printed) in [
        (24, 0.48, [0.0, -0.13, -0.19], [328.991, 328.754, 328.645]),
        (
            95,
            0.6690882620776267,
            [0.0, -0.24, -0.34],
            [1341.487, 1340.862, 1340.603],
        ),
    ] {
        let design = design(z, 14.0, 10.0, shift, [1.0, 1.25, 0.38]);
        for (allowance, printed) in allowances.into_iter().zip(printed) {
            let (data, nominal) = (&design.basic_data, design.nominal_base_thickness());
            let base = thickness::base_from_allowance(data, nominal, allowance);
            let form = 2.0 * Gear::new(design, base).unwrap().form_radius();
            assert!((form - printed).abs() < 5.1e-4, "{z}: {form}");
        }
    }
}

/// Published: FVA Workbench's two meshes (by their exact geometry, derived and checked by slices beside this program) and KISSsoft's 24/95,
/// printed 0.359 … 0.571 mm.
#[test]
fn backlash_of_published_meshes() {
    for (z, module, beta, shift, distances, allowances, exact) in [
        (
            [27, 51],
            4.5,
            21.0,
            [0.3, 0.1628301985916763],
            [189.977, 190.023],
            [[-0.115, -0.165]; 2],
            [0.2296391511516653, 0.37665968616658085],
        ),
        (
            [23, 34],
            6.5,
            10.0,
            [0.3, 0.0014790906759136746],
            [189.977, 190.023],
            [[-0.115, -0.165]; 2],
            [0.21750255035542532, 0.3568872280662292],
        ),
        (
            [24, 95],
            14.0,
            10.0,
            [0.48, 0.6690882620776267],
            [860.972, 861.028],
            [[-0.13, -0.19], [-0.24, -0.34]],
            [0.358822838, 0.571440497],
        ),
    ] {
        for end in [0, 1] {
            let gear = |index: usize, hand| {
                let design = design(z[index], module, beta, shift[index], RACK);
                let data = design
                    .basic_data
                    .with_helix(design.basic_data.helix_angle(), hand)
                    .unwrap();
                let design = GearDesign {
                    basic_data: data,
                    ..design
                };
                let allowance = allowances[index][end];
                let base = thickness::base_from_allowance(
                    &data,
                    design.nominal_base_thickness(),
                    allowance,
                );
                AsBuilt::perfect(Gear::new(design, base).unwrap(), Face::Front)
            };
            let pair =
                GearPair::new(gear(0, Hand::Left), gear(1, Hand::Right), distances[end]).unwrap();
            let j_wt = InvolutePair::of(&pair)
                .circumferential_backlash(distances[end])
                .unwrap();
            assert!((j_wt - exact[end]).abs() < 1e-9, "{z:?}: {j_wt}");
            let backlash = pair.backlash(j_wt);
            let data = pair.gear(Member::Wheel).gear().basic_data();
            // j_bn = j_t cos α_n cos β.
            let normal = backlash.j_t * 20f64.to_radians().cos() * data.helix_angle().cos();
            assert!((backlash.j_bn - normal).abs() < 1e-15);
            assert!((backlash.j_bt(&pair) * data.base_helix_angle().cos() - normal).abs() < 1e-15);
        }
    }
}

#[test]
fn what_is_no_helical_pair_is_refused() {
    let gear = |beta_deg: f64, hand| {
        let data = BasicGearData::new(30, 2.0, 20f64.to_radians()).unwrap();
        let data = data.with_helix(beta_deg.to_radians(), hand).unwrap();
        AsBuilt::perfect(
            Gear::nominal(GearDesign::standard(data)).unwrap(),
            Face::Front,
        )
    };
    let pair = |one, other| GearPair::new(one, other, 70.0);
    let said = |found: Result<GearPair, GearError>| found.unwrap_err().to_string();
    assert_eq!(
        said(pair(gear(20.0, Hand::Left), gear(20.0, Hand::Left))),
        "both gears are left-handed: teeth of an external pair wind opposite ways"
    );
    assert!(
        said(pair(gear(20.0, Hand::Left), gear(21.0, Hand::Right)))
            .starts_with("helix angle (degrees) differs: wheel 20")
    );
    assert!(
        said(pair(gear(20.0, Hand::Left), gear(0.0, Hand::Right)))
            .starts_with("helix angle (degrees) differs")
    );
    let helical = pair(gear(20.0, Hand::Left), gear(20.0, Hand::Right)).unwrap();
    assert!(helical.clone().with_face([5.0, 4.0]).is_err());
    assert!(helical.clone().with_face([0.0, f64::NAN]).is_err());
    assert_eq!(
        helical
            .with_face([-5.0, 4.0])
            .unwrap()
            .at(71.0)
            .unwrap()
            .face(),
        [-5.0, 4.0]
    );
    let data = BasicGearData::new(30, 2.0, 20f64.to_radians()).unwrap();
    for angle in [-0.1, 1.1, f64::NAN] {
        assert!(data.with_helix(angle, Hand::Left).is_err());
    }
    assert_eq!(data.with_helix(0.0, Hand::Left).unwrap(), data);
}
