//! Every case of fixtures/reference/published.json by name: each printed output within its printed digits. The file names the source of each.

use super::*;
use common::published_case::{Case, file};

/// Each case by the program or the handbook that it is of.
#[test]
fn every_case_of_the_file_is_as_published() {
    let cases = file();
    assert_eq!(cases.len(), 22);
    for case in cases {
        let id = case["id"].as_str().unwrap().to_owned();
        println!("{id}");
        let case = Case::new(case);
        match id.split_once('-').unwrap() {
            ("KHK", "4-3") => zero_backlash(&case),
            ("KHK", "5-10-span") => span(&case),
            ("KHK", "5-thickness") => normal_thickness(&case),
            ("TSapp", _) => thinned_pair(&case),
            ("gearcore", _) => shallow_undercut(&case),
            ("pygear", _) => hobbed(&case),
            ("dth", _) => whole_pair(&case),
            ("pgw", name) if name.starts_with("sharp") => {
                let gear = Gear::nominal(case.design("")).unwrap();
                case.expect("d_Ff_mm", 2.0 * gear.form_radius());
            }
            ("pgw", _) => distance_of_play(&case),
            ("ecc", _) => runout(&case),
            _ => panic!("{id}"),
        }
        case.finish();
    }
}

fn any_pose(assembly: &GearPair) -> Pose {
    Pose::new(assembly, Mating::FIRST)
}

fn zero_backlash(case: &Case) {
    // Any distance that the pair can be put at.
    let assembly = case.nominal_pair(60.0);
    let zero = limits::zero_backlash_distance(&assembly).unwrap();
    let alpha = assembly.at(zero).unwrap().operating_pressure_angle();
    case.expect("alpha_wt_deg", alpha.to_degrees());
    case.expect("a_zero_backlash_mm", zero);
}

fn span(case: &Case) {
    let gear = Gear::nominal(case.design("")).unwrap();
    let (base, k) = (gear.base_radius(), case.input("k").unwrap() as u32);
    let span = |k| thickness::span_from_base(gear.basic_data(), k, gear.base_thickness());
    let contact = |k| involute::radius_at(span(k) / (2.0 * base), base);
    assert!(thickness::check_span(&gear, k).is_ok());
    case.expect("W_k_mm", span(k));
    case.expect("W_5_mm", span(5));
    case.expect("contact_radius_k4_mm", contact(4));
    case.expect("contact_radius_k5_mm", contact(5));
}

/// The normal section of a helical rack tooth is that of a spur gear: `s_n` on the reference circle.
fn normal_thickness(case: &Case) {
    let design = case.design("");
    let alpha = design.basic_data.pressure_angle();
    let r = design.basic_data.reference_radius();
    // s = r (s_b/r_b − 2 inv α).
    let half = design.nominal_base_thickness() / (2.0 * design.basic_data.base_radius());
    case.expect("s_n_mm", 2.0 * r * (half - inv(alpha)));
    // The virtual number of teeth is of a helical gear; gearlash's gears are spur.
    case.mark("z_v");
}

/// Both gears thinned. That program keeps the nominal root circles: clearance and contact ratio of nominal gears.
fn thinned_pair(case: &Case) {
    let distance = case.input("a_mm").unwrap();
    let nominal = case.nominal_pair(distance);
    case.expect_if_printed("eps_alpha", limits::contact_ratio(&nominal));
    let [clearance, _] = ends(Member::BOTH.map(|member| nominal.radial_clearance(member)));
    case.expect_if_printed("tip_clearance_min_mm", clearance);
    if case.input("A_sn1_um").is_none() {
        return;
    }
    let thinned = |n: &str| {
        let um = case.input(&format!("A_sn{n}_um")).unwrap();
        Make::of(case.design(n)).allowance(um * 1e-3)
    };
    let assembly = pair(&thinned("1"), &thinned("2"), distance);
    let result = evaluate(&assembly, &any_pose(&assembly));
    case.expect("j_wt_mm", result.involute.unwrap());
}

fn shallow_undercut(case: &Case) {
    let design = case.design("");
    let least = case.input("x_Emin").unwrap();
    let found = limits::least_shift_without_undercut(&design.basic_data, &design.rack);
    assert!((found - least).abs() < 1e-14, "x_Emin {found} {least}");
    let gear = Gear::nominal(design).unwrap();
    let above_base = 2.0 * (gear.form_radius() - gear.base_radius());
    case.expect("d_Ff_minus_d_b_um", above_base * 1e3);
}

fn hobbed(case: &Case) {
    let gear = Gear::nominal(case.design("")).unwrap();
    case.expect("x_E", gear.generating_shift());
    case.expect("d_Ff_mm", 2.0 * gear.form_radius());
    case.expect("d_fE_mm", 2.0 * gear.root_radius());
    for curve in [ProfilePart::Fillet, ProfilePart::Involute] {
        let points = &*format!("{}_points_xy_mm", curve.name());
        let list = case.value["outputs"][points].as_array().unwrap();
        assert!(!list.is_empty());
        // The file's tooth points up, ours along +x.
        let each = list.iter().map(|xy| {
            let point = Point2::new(xy[1].as_f64().unwrap(), -xy[0].as_f64().unwrap());
            off_curve(&gear, curve, point)
        });
        let [_, worst] = ends(each);
        case.expect(&format!("max_dev_{}_points_mm", curve.name()), worst);
        case.mark(points);
    }
}

/// Distance of `point` from `curve` of the left half tooth, mm: foot of the perpendicular by bisection.
fn off_curve(gear: &Gear, curve: ProfilePart, point: Point2<f64>) -> f64 {
    let profile = Profile::new(gear);
    let (top, bottom) = profile.range(curve);
    // Both parameters rise from root to tip.
    let offset = |t: f64| point - profile.point(curve, t, Side::Left);
    // Towards the tip along the left flank: the normal turned clockwise.
    let towards_tip = |t: f64| {
        let normal = profile.normal(curve, t, Side::Left);
        offset(t).dot(&Vector2::new(normal.y, -normal.x))
    };
    let [foot, _] = halved(bottom, top, 200, |t| towards_tip(t) > 0.0);
    offset(foot).norm()
}

fn whole_pair(case: &Case) {
    let assembly = case.nominal_pair(case.input("a_mm").unwrap());
    let zero = limits::zero_backlash_distance(&assembly).unwrap();
    let alpha = assembly.operating_pressure_angle();
    let gear = |member| assembly.gear(member).gear();
    case.expect("a_zero_backlash_mm", zero);
    case.expect("alpha_wt_deg", alpha.to_degrees());
    let [first, second] = Member::BOTH.map(|member| limits::operating_thickness(&assembly, member));
    case.expect("s_wt1_mm", first);
    case.expect("s_wt2_mm", second);
    let left = limits::operating_pitch(&assembly) - first - second;
    case.expect("j_wt_mm_from_thicknesses", left);
    let result = evaluate(&assembly, &any_pose(&assembly));
    case.expect("j_wt_mm_from_thicknesses", result.involute.unwrap());
    case.expect("s_bt1_mm", gear(Member::Wheel).base_thickness());
    case.expect("eps_alpha", limits::contact_ratio(&assembly));
    // Which of the two clearances is c_1 does not matter: they are equal, with 2.25 m deep teeth.
    let [first, second] = Member::BOTH.map(|member| assembly.radial_clearance(member));
    case.expect("tip_clearance_c1_mm", first);
    case.expect("tip_clearance_c2_mm", second);
    let radial = limits::radial_backlash(&assembly).unwrap();
    case.expect("j_wt_mm_LINEARISED", 2.0 * radial * alpha.tan());
    let wheel = gear(Member::Wheel);
    // That program takes the tool's flank to be straight down to h_aP* = 1: a sharp tool of that depth.
    let straight = BasicRack::new(1.0, 1.0, 0.0).unwrap();
    let least = limits::least_shift_without_undercut(wheel.basic_data(), &straight);
    case.expect("x_min_no_undercut", least);
    for (member, key) in [(Member::Wheel, "d_Ff1_mm"), (Member::Pinion, "d_Ff2_mm")] {
        if case.value["outputs"][key].is_null() {
            // That program gives none where it detects undercut: the wheel of one case.
            assert!(member == Member::Wheel && wheel.generating_shift() < least);
            case.mark(key);
        } else {
            case.expect(key, 2.0 * gear(member).form_radius());
        }
    }
}

fn distance_of_play(case: &Case) {
    let gears = ["1", "2"].map(|n| Gear::nominal(case.design(n)).unwrap());
    let pair = InvolutePair::new(&gears[0], &gears[1]);
    let module = case.input("m_n").unwrap();
    let zero = pair.center_distance(0.0).unwrap();
    case.expect("r_b1_mm", gears[0].base_radius());
    case.expect("r_b2_mm", gears[1].base_radius());
    case.expect("a_zero_backlash_mm", zero);
    for (key, play) in [("0p02", 0.02), ("0p05", 0.05)] {
        let distance = pair.center_distance(play * module).unwrap();
        case.expect(&format!("a_for_j_bt_{key}_mt_mm"), distance);
    }
    let ratio = limits::contact_ratio(&case.nominal_pair(zero));
    case.expect("eps_alpha_at_zero_backlash", ratio);
}

/// Both high teeth, half the eccentricity each, at the mate, square to it, and turned away from it.
fn runout(case: &Case) {
    let eccentricity = case.input("e1_plus_e2_mm").unwrap() / 2.0;
    let assembly = case.nominal_pair(case.input("a_mm").unwrap());
    let nominal = any_pose(&assembly);
    let eccentric = |member: Member, rotation: f64, direction: f64| {
        let perfect = assembly.gear(member);
        let teeth = f64::from(assembly.teeth(member));
        // The high tooth is at rotation + ascending (high − 1) τ from the mate.
        let steps = (direction - rotation) * perfect.face().ascending() * teeth / TAU;
        let high_tooth = 1.0 + steps.rem_euclid(teeth);
        perfect.with_runout(eccentricity, high_tooth).unwrap()
    };
    for (name, direction) in [("min", 0.0), ("mean", PI / 2.0), ("max", PI)] {
        let wheel = eccentric(Member::Wheel, nominal.locked_rotation(), direction);
        let pinion = eccentric(Member::Pinion, nominal.free_rotation(), direction);
        let pair = GearPair::new(wheel, pinion, assembly.center_distance()).unwrap();
        let pose = any_pose(&pair);
        let distance = effective_center_distance(&pair, &pose);
        let normal = InvolutePair::of(&pair).base_backlash(distance);
        let backlash = evaluate(&pair, &pose).involute;
        case.expect(&format!("j_wt_{name}_mm"), backlash.unwrap());
        case.expect(&format!("j_bt_{name}_mm"), normal.unwrap());
    }
}
