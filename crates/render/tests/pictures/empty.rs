//! Charts of pairs that have no backlash, or no deviations, say so.

use super::drawn::Picture;
use super::{UM, course, heading, of_course, over, study};
use gearlash::analysis::curves::with_sweep;
use gearlash::gear::Inspection;
use gearlash_render::chart;

/// r_a = 69 twice: out of mesh beyond 138 mm. An axis from 0.0 to 1.0 µm was invented for it. A pair with tips in roots is jammed.
#[test]
fn a_pair_without_backlash_has_no_axis_of_it() {
    for (fixture, a, why) in [
        ("karba_44x44.toml", 139.0, "out of mesh"),
        ("tip_on_fillet_86x21.toml", 159.6, "jammed"),
    ] {
        let (_, picture) = of_course(&course(fixture, a));
        assert!(picture.has(&format!("no pose has a backlash: {why}")));
        let invented = ["µm", "flank", "0.5"];
        assert!(!picture.says(|text| invented.iter().any(|part| text.contains(part))));
    }
}

/// r_a + r_f = 69 + 62.25 = 131.25: at 130 mm tips sit in roots. The legend named bands that are not there, and the last
/// number was cut at the edge.
#[test]
fn a_jammed_stretch_of_distances_is_named_and_no_band_invented() {
    let rig = with_sweep(study("karba_44x44.toml")).at(vec![130.0]);
    let mut rig = rig.unwrap();
    rig.measured.clear();
    let chart = chart::distance(UM, &heading("c", "t"), &over(&rig, 33, 33), &[]).unwrap();
    let picture = Picture::of(&chart.svg);
    assert!(picture.has("jammed"));
    assert!(!picture.says(|text| text.contains("simulated") || text.contains("clearance")));
    let mut texts = picture.texts.iter();
    let last = texts.find(|text| text.content == "130.06").unwrap();
    assert!(last.room[2] < 800.0, "{:?}", last.room);
}

/// Four panels of ±0.04 µm with "none" in each stood here.
#[test]
fn a_gear_without_deviations_has_one_panel_that_says_so() {
    let pair = study("karba_86x21.toml");
    let inspection = Inspection::of(&pair.materials[0].1);
    assert!(!inspection.deviates());
    let chart = chart::inspection(&heading("c", "t"), "wheel", &inspection).unwrap();
    assert_eq!(chart.panels.len(), 1);
    let words = "no pitch, thickness or runout deviations are given";
    assert!(Picture::of(&chart.svg).has(words));
}
