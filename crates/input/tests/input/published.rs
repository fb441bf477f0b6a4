//! The two pairs of the study as the design's section 8 states them.

use super::*;
use gearlash::gear::thickness::allowance_from_base;

/// Unrounded values to Table 1: allowances −17.830833 µm and −22.195630 µm at the reference circle.
#[test]
fn thickness_over_pins_of_the_86_21_pair() {
    let study = read("../../fixtures/karba_86x21.toml".as_ref()).unwrap();
    assert_eq!(study.study.center_distances, [160.470, 160.500, 160.550]);
    assert_eq!(study.study.chordal_error, 0.0002 / 1000.0);
    let runs = study.study.runs().unwrap();
    assert_eq!(runs.len(), 3);
    for run in &runs {
        assert_eq!(run.run.material, Material::AsMeasured);
        for (member, expected) in [(Member::Wheel, -17.830833), (Member::Pinion, -22.195630)] {
            let gear = run.run.assembly.data().unwrap().gear(member).gear();
            let nominal = gear.design().nominal_base_thickness();
            let um =
                1000.0 * allowance_from_base(gear.basic_data(), nominal, gear.base_thickness());
            assert!((um - expected).abs() < 5e-7, "{um} {expected}");
        }
        let teeth: Vec<_> = run
            .matings
            .iter()
            .map(|m| (m.wheel_tooth, m.pinion_tooth, m.flank.name()))
            .collect();
        assert_eq!(teeth, [(1, 1, "right"), (1, 1, "left")]);
    }
}

/// Tables 3 and 4 by K (15): s_b = W_6 − 5 π 3 cos 20° mm, 6.266028 … 6.279028 on the wheel.
#[test]
fn spans_of_the_44_44_pair() {
    let study = read("../../fixtures/karba_44x44.toml".as_ref()).unwrap();
    let expected = [
        (Material::Most, 6.279028, 6.285028),
        (Material::Least, 6.266028, 6.277028),
    ];
    assert_eq!(study.study.materials.len(), 2);
    for ((material, wheel, pinion), expected) in study.study.materials.iter().zip(expected) {
        assert_eq!(*material, expected.0);
        assert!((wheel.gear().base_thickness() - expected.1).abs() < 5e-7);
        assert!((pinion.gear().base_thickness() - expected.2).abs() < 5e-7);
        assert_eq!(wheel.eccentricity(), 0.0033);
        assert_eq!(pinion.eccentricity(), 0.005);
        assert_eq!((wheel.high_tooth(), pinion.high_tooth()), (33.0, 33.0));
    }
    assert_eq!(study.study.bearing_clearance, 0.010);
    assert_eq!(study.study.chordal_error, 1e-6);
}

#[test]
fn the_measured_file_is_the_reference() {
    let fixture = fs::read("../../fixtures/karba_tables_5_6.csv").unwrap();
    let reference = fs::read("../../fixtures/reference/karba_tables_5_6.csv").unwrap();
    assert_eq!(fixture, reference);
}
