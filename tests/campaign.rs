//! A short campaign of exact against polygon method (the long one: `examples/campaign.rs`).

#[path = "common/campaign.rs"]
mod campaign;

use campaign::{AGREEMENT_UM, Drawn, run};
use gearlash::gear::{AsBuilt, Side};
use gearlash::input;
use gearlash::pair::Member;

const SEED: u64 = 2;

#[test]
fn both_methods_agree_on_random_poses() {
    let tally = run(300, SEED);
    assert!(tally.faults.is_empty(), "{:?}", tally.faults);
    assert_eq!(tally.without_result, 0);
    assert!(tally.greatest_um <= AGREEMENT_UM);
    // What the issue asks the poses to be: a quarter off the involutes, half with an eccentric free gear.
    let shares = [tally.off_involute, tally.free_eccentric, tally.undercut];
    assert!(4 * tally.off_involute >= tally.poses, "{shares:?}");
    assert!(5 * tally.free_eccentric >= 2 * tally.poses, "{shares:?}");
    assert!(10 * tally.undercut >= tally.poses, "{shares:?}");
    for status in ["clear", "interference", "jammed", "no_contact"] {
        assert!(tally.statuses.contains_key(status), "{status}");
    }
    for curves in ["fillet–tip", "involute–tip"] {
        assert!(tally.curves.contains_key(curves), "{:?}", tally.curves);
    }
}

/// The same to the rounding of a conversion from µm.
fn same_gear(one: &AsBuilt, other: &AsBuilt) {
    let numbers = |gear: &AsBuilt| {
        let radii = [gear.gear().base_thickness(), gear.gear().tip_radius()];
        let mut numbers = vec![gear.eccentricity(), gear.gear().form_roll()];
        numbers.extend(radii);
        for tooth in 1..=gear.gear().toothing().teeth() {
            numbers.extend(Side::BOTH.map(|side| gear.flank_offset(side, tooth)));
        }
        numbers
    };
    assert_eq!(one.face(), other.face());
    let (one, other) = (numbers(one), numbers(other));
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(&other) {
        assert!(
            (one - other).abs() <= 1e-15 * (1.0 + one.abs()) * 4.0,
            "{one} {other}"
        );
    }
}

/// The pair file printed for a pose is that pose: same gears, same distance, same mating.
#[test]
fn a_printed_pose_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pose.toml");
    for index in 0..20 {
        let drawn = Drawn::new(SEED, index);
        std::fs::write(&path, drawn.pair_file()).unwrap();
        let study = input::read(&path).unwrap();
        let (_, wheel, pinion) = &study.materials[0];
        for (read, member) in [(wheel, Member::Wheel), (pinion, Member::Pinion)] {
            same_gear(read, drawn.assembly.gear(member));
        }
        assert_eq!(study.locked, drawn.assembly.locked());
        assert_eq!(study.center_distances, [drawn.assembly.center_distance()]);
        let matings = study.sweep.unwrap().matings(&drawn.assembly);
        assert!(matings.contains(&drawn.mating));
    }
}
