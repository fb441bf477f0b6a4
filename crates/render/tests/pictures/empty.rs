//! Charts of pairs that have no backlash, or no deviations, say so.

use super::{METHOD, course, heading, study};
use gearlash::analysis::curves::{Followed, courses, over_distance, revolution, with_sweep};
use gearlash::gear::Inspection;
use gearlash_render::chart;
use roxmltree::Document;
use std::ops::ControlFlow;

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let texts = document
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    texts
        .filter_map(|text| Some(text.text()?.trim().to_owned()))
        .collect()
}

/// r_a = 69 twice: out of mesh beyond 138 mm. An axis from 0.0 to 1.0 µm was invented for it.
#[test]
fn a_pair_out_of_mesh_has_no_axis_of_backlash() {
    let rig = with_sweep(study("karba_44x44.toml"))
        .at(vec![139.0])
        .unwrap();
    let runs = revolution(&rig, METHOD, &|| ControlFlow::Continue(())).unwrap();
    let chart = chart::revolution(&heading("c", "t"), &courses(&runs)[0]).unwrap();
    let texts = texts(&chart.svg);
    assert!(
        texts.contains(&"no pose has a backlash: out of mesh".to_owned()),
        "{texts:?}"
    );
    assert!(
        !texts
            .iter()
            .any(|text| text.contains("µm") || text.contains("flank") || text == "0.5")
    );
}

/// tests/charts/command.rs: jammed at every pose.
#[test]
fn a_jammed_pair_is_called_jammed() {
    let course = course("tip_on_fillet_86x21.toml", 159.6);
    let chart = chart::revolution(&heading("c", "t"), &course).unwrap();
    assert!(texts(&chart.svg).contains(&"no pose has a backlash: jammed".to_owned()));
}

/// r_a + r_f = 69 + 62.25 = 131.25: at 130 mm tips sit in roots. The legend named bands that are not there, and the last
/// number was cut at the edge.
#[test]
fn a_jammed_stretch_of_distances_is_named_and_no_band_invented() {
    let mut rig = with_sweep(study("karba_44x44.toml"))
        .at(vec![130.0])
        .unwrap();
    rig.measured.clear();
    let tick = || ControlFlow::Continue(());
    let curve = over_distance(&rig, Followed::Teeth(33, 33), &[], METHOD, &tick).unwrap();
    let chart = chart::distance(&heading("c", "t"), &curve, &[]).unwrap();
    let texts = texts(&chart.svg);
    assert!(texts.contains(&"jammed".to_owned()), "{texts:?}");
    assert!(
        !texts
            .iter()
            .any(|text| text.contains("simulated") || text.contains("clearance"))
    );
    let last = texts.iter().find(|text| *text == "130.06").unwrap();
    // Six characters of 12 units, half an em each, about the tick at the right edge of the plot.
    let half = 0.5 * 0.5 * 12.0 * last.len() as f64;
    assert!(chart.plot.right + half < 800.0, "{}", chart.plot.right);
}

/// Four panels of ±0.04 µm with "none" in each stood here.
#[test]
fn a_gear_without_deviations_has_one_panel_that_says_so() {
    let pair = study("karba_86x21.toml");
    let inspection = Inspection::of(&pair.materials[0].1);
    assert!(!inspection.deviates());
    let chart = chart::inspection(&heading("c", "t"), "wheel", &inspection).unwrap();
    assert_eq!(chart.panels.len(), 1);
    let words = "no pitch, thickness or runout deviations are given".to_owned();
    assert!(texts(&chart.svg).contains(&words));
}
