//! The three analytic models against published tables, reference data, and each other.

use crate::common;

use common::{reference_file, reference_names, reference_pair};
use gearlash::analytic::{LineOfAction, SideContact, evaluate};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};

const UM: f64 = 1e-3;

fn design(teeth: u32, module: f64) -> GearDesign {
    GearDesign {
        basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    }
}

fn pose(assembly: &GearPair, wheel_tooth: u32, pinion_tooth: u32, flank: Side) -> Pose {
    let mating = Mating {
        wheel_tooth,
        pinion_tooth,
        flank,
        fraction: 0.0,
    };
    Pose::new(assembly, mating)
}

/// Tables 3 and 4: 44/44, m 3, by span over 6 teeth, runout 6.6 and 10 µm, both high teeth 33.
fn rig(distance: f64, wheel_span: f64, pinion_span: f64) -> GearPair {
    let gear = |span, face, runout_um: f64| {
        let design = design(44, 3.0);
        let base = thickness::base_from_span(&design.basic_data, 6, span);
        let deviations = Deviations {
            eccentricity: runout_um * UM / 2.0,
            high_tooth: 33.0,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    };
    GearPair::with_locked(
        gear(wheel_span, Face::Front, 6.6),
        gear(pinion_span, Face::Back, 10.0),
        distance,
        Member::Wheel,
    )
    .unwrap()
}

/// Tables 5 and 6 of the study, as printed: fixtures/reference/karba_tables_5_6.csv.
#[test]
fn model_2_gives_all_72_predicted_limits() {
    let file = reference_file("karba_tables_5_6.csv");
    let mut rows = csv::Reader::from_reader(file.as_bytes());
    let mut compared = 0;
    for row in rows.records() {
        let row = row.unwrap();
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let tooth = |column: usize| row[column].parse::<u32>().unwrap();
        for (wheel_span, pinion_span, printed) in
            [(50.561, 50.567, number(5)), (50.548, 50.559, number(6))]
        {
            let assembly = rig(number(0), wheel_span, pinion_span);
            let both = Side::BOTH.map(|flank| {
                let pose = pose(&assembly, tooth(1), tooth(2), flank);
                evaluate(&assembly, &pose).involute.unwrap() / UM
            });
            let mean = (both[0] + both[1]) / 2.0;
            assert!((mean - printed).abs() <= 0.07, "{row:?}: {mean}");
            compared += 1;
        }
    }
    assert_eq!(compared, 72);
}

/// Tables 1 and 2 of the study, 86/21 by dimension over pins of 5.25 mm; unrounded in design section 8.
#[test]
fn table_2_by_models_2_and_3() {
    let gear = |teeth, over, face| {
        let design = design(teeth, 3.0);
        let base = thickness::base_from_pins(&design.basic_data, 5.25, over).unwrap();
        AsBuilt::perfect(Gear::new(design, base).unwrap(), face)
    };
    for (distance, printed) in [
        (160.470, 18.200263),
        (160.500, 40.026463),
        (160.550, 76.490057),
    ] {
        let assembly = GearPair::with_locked(
            gear(86, 265.530, Face::Front),
            gear(21, 70.171, Face::Back),
            distance,
            Member::Wheel,
        )
        .unwrap();
        for flank in Side::BOTH {
            let result = evaluate(&assembly, &pose(&assembly, 17, 3, flank));
            let involute = result.involute.unwrap();
            let line = result.line_of_action.backlash(&assembly).unwrap();
            assert!(
                (involute / UM - printed).abs() < 1e-5,
                "{distance}: {involute}"
            );
            assert!(
                (line - involute).abs() < 1e-12,
                "{distance}: {line} {involute}"
            );
        }
    }
}

/// Nominal 44/44 at 0.1 mm beyond 132 mm: B = 2 · 0.1 · tan 20° = 0.2 · 0.363970234266202 mm by hand.
/// Thinned by 30 and 20 µm, B_0 = 50 µm on the operating circle of 132 mm, the reference circle.
#[test]
fn model_1_by_hand() {
    for (allowances_um, first) in [([0.0, 0.0], 0.0), ([-30.0, -20.0], 0.050)] {
        let gears = allowances_um.map(|allowance| {
            let design = design(44, 3.0);
            let nominal = design.nominal_base_thickness();
            let base = thickness::base_from_allowance(&design.basic_data, nominal, allowance * UM);
            AsBuilt::perfect(Gear::new(design, base).unwrap(), Face::Front)
        });
        let [wheel, pinion] = gears;
        let assembly = GearPair::with_locked(wheel, pinion, 132.1, Member::Wheel).unwrap();
        let result = evaluate(&assembly, &pose(&assembly, 1, 1, Side::Right));
        let expected = first + 0.072794046853240;
        assert!((result.michalec.unwrap() - expected).abs() < 1e-13);
    }
}

/// A high tooth that faces the mate takes backlash away: by 2 e tan φ in model 1.
#[test]
fn a_high_tooth_at_the_mate_closes_the_gap() {
    let gear = |high_tooth| {
        let deviations = Deviations {
            eccentricity: 0.010,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(
            Gear::nominal(design(44, 3.0)).unwrap(),
            Face::Front,
            &deviations,
        )
        .unwrap()
    };
    let mate = AsBuilt::perfect(Gear::nominal(design(44, 3.0)).unwrap(), Face::Back);
    let michalec = |high_tooth| {
        let assembly =
            GearPair::with_locked(gear(high_tooth), mate.clone(), 132.1, Member::Wheel).unwrap();
        let both = Side::BOTH.map(|flank| evaluate(&assembly, &pose(&assembly, 1, 1, flank)));
        (both[0].michalec.unwrap() + both[1].michalec.unwrap()) / 2.0
    };
    // Tooth 1 stands a quarter of a pitch, 2.05°, beside the line of centres: cos within 6.4e-4 of 1.
    let difference = michalec(23.0) - michalec(1.0);
    let expected = 2.0 * 2.0 * 0.010 * 20f64.to_radians().tan();
    assert!((difference / expected - 1.0).abs() < 7e-4, "{difference}");
}

#[test]
fn a_model_without_a_value_says_none() {
    // Base circles 0.001 mm apart, outlines 0.02 mm nearer each other.
    let eccentric = |face| {
        let deviations = Deviations {
            eccentricity: 0.010,
            high_tooth: 1.0,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::nominal(design(44, 3.0)).unwrap(), face, &deviations).unwrap()
    };
    let least = 2.0 * eccentric(Face::Front).gear().base_radius();
    let assembly = GearPair::with_locked(
        eccentric(Face::Front),
        eccentric(Face::Back),
        least + 0.001,
        Member::Wheel,
    )
    .unwrap();
    let result = evaluate(&assembly, &pose(&assembly, 1, 1, Side::Right));
    assert!(result.involute.is_none());
    assert!(result.line_of_action.backlash(&assembly).is_none());
    assert!(result.michalec.is_some_and(f64::is_finite));
    // Out of mesh: no contact inside the tips, but the formulas go on.
    let far = assembly.at(140.0).unwrap();
    let result = evaluate(&far, &pose(&far, 1, 1, Side::Right));
    assert_eq!(
        result.line_of_action,
        LineOfAction {
            right: None,
            left: None
        }
    );
    assert!(result.involute.is_some_and(f64::is_finite));
    // x_1 + x_2 = −1.8 < −(z_1 + z_2) inv α/(2 tan α) = −1.638: no play-free distance.
    let shifted = |face| {
        let design = GearDesign {
            profile_shift: -0.9,
            ..design(40, 3.0)
        };
        AsBuilt::perfect(Gear::nominal(design).unwrap(), face)
    };
    let assembly = GearPair::with_locked(
        shifted(Face::Front),
        shifted(Face::Back),
        114.0,
        Member::Wheel,
    )
    .unwrap();
    let result = evaluate(&assembly, &pose(&assembly, 1, 1, Side::Right));
    assert!(result.michalec.is_none());
    assert!(result.involute.is_some_and(f64::is_finite));
}

/// The contact that counts, and how much tighter it is than the next.
fn tightest(assembly: &GearPair, pose: &Pose, side: Side) -> (SideContact, f64) {
    let mut all: Vec<SideContact> = SideContact::all(assembly, pose, side).collect();
    all.sort_by(|one, other| {
        (side.sense() * one.rotation).total_cmp(&(side.sense() * other.rotation))
    });
    let ahead = all.get(1).map_or(f64::INFINITY, |next| {
        (next.rotation - all[0].rotation).abs()
    });
    (all[0], ahead)
}

/// fixtures/reference/lost_motion, wherever both sides touch involute on involute.
#[test]
fn model_3_equals_the_reference_on_the_line_of_action() {
    let (mut poses, mut named, mut worst) = (0, 0, 0.0);
    for name in reference_names() {
        let pair = reference_pair(&name);
        let assembly = &pair.assembly;
        for reference in &pair.poses {
            if !Side::BOTH
                .iter()
                .all(|&side| reference.contact(side).is_involute())
            {
                continue;
            }
            let pose = Pose::new(assembly, reference.mating());
            let model = LineOfAction::new(assembly, &pose);
            let difference = model.backlash(assembly).unwrap() / UM - reference.j_wt_um;
            assert!(
                difference.abs() <= 1e-6,
                "{name} {reference:?}: {difference}"
            );
            assert!((model.angle().unwrap() - reference.lost_motion_rad).abs() < 1e-12);
            poses += 1;
            worst = f64::max(worst, difference.abs());
            for (side, found) in [(Side::Right, model.right), (Side::Left, model.left)] {
                let (contact, ahead) = tightest(assembly, &pose, side);
                assert_eq!(found.unwrap().rotation, contact.rotation);
                if ahead <= 1e-9 {
                    continue;
                }
                let expected = reference.contact(side);
                assert_eq!(
                    (contact.locked_tooth, contact.free_tooth),
                    (expected.wheel_tooth, expected.pinion_tooth),
                    "{name} {reference:?} {side:?}"
                );
                let radius = |member: Member, roll: f64| {
                    assembly.gear(member).gear().base_radius() * roll.hypot(1.0)
                };
                // The reference searched: the place of an extremum is known to the root of its value only.
                // 1e-5 mm along flanks of some 10 mm curvature is 5e-12 mm across them.
                let wheel = radius(Member::Wheel, contact.locked_roll);
                let pinion = radius(Member::Pinion, contact.free_roll);
                assert!((wheel - expected.wheel_radius_mm).abs() <= 1e-5);
                assert!((pinion - expected.pinion_radius_mm).abs() <= 1e-5);
                named += 1;
            }
        }
    }
    println!("{poses} poses, {named} contacts told apart, worst difference {worst:e} µm");
    assert_eq!((poses, named), (99, 162));
}

/// The simulation may lie below model 3, never above (design section 5): all reference poses.
#[test]
fn the_reference_is_never_above_model_3() {
    let mut below = 0;
    for name in reference_names() {
        let pair = reference_pair(&name);
        for reference in &pair.poses {
            let pose = Pose::new(&pair.assembly, reference.mating());
            let model = LineOfAction::new(&pair.assembly, &pose);
            let Some(backlash) = model.backlash(&pair.assembly) else {
                continue;
            };
            let above = reference.j_wt_um - backlash / UM;
            assert!(above <= 1e-6, "{name} {reference:?}: {above}");
            below += usize::from(above < -1e-6);
        }
    }
    assert!(
        below > 0,
        "no reference pose touches off the line of action"
    );
}
