//! The section of helical gears: it follows the contact, and winds the teeth.

use crate::chromium::{Chromium, Script, Tab};
use crate::mesh::go;
use crate::page::Site;

/// How far the outline of a gear is turned in itself, degrees.
fn wound(tab: &mut Tab, member: &str) -> f64 {
    let transform = tab.text(&format!(
        "document.getElementById('viewer-{member}-0').getAttribute('transform')"
    ));
    let angle = transform.strip_prefix("rotate(").expect("an outline winds");
    angle.split(' ').next().unwrap().parse().expect("an angle")
}

fn choose(tab: &mut Tab, z: f64) {
    tab.eval(&format!(
        "{{ const slider = document.getElementById('viewer-section'); slider.value = {z}; \
         slider.dispatchEvent(new Event('input', {{ bubbles: true }})); }}"
    ));
}

fn opacity(tab: &mut Tab, side: &str) -> f64 {
    tab.number(&format!(
        "Number(document.getElementById('viewer-{side}-contact').getAttribute('opacity'))"
    ))
}

/// Teeth wind by z tan β/r, r = m_n z/(2 cos β): right-hand ones clockwise away from the viewer, those of the mate the other way.
fn assert_at(tab: &mut Tab, z: f64) {
    for (member, teeth, hand) in [("wheel", 27.0, 1.0), ("pinion", 51.0, -1.0)] {
        let beta = 21f64.to_radians();
        let expected = -hand * z * 2.0 * beta.sin() / (4.5 * teeth);
        let off = wound(tab, member) - expected.to_degrees();
        assert!(off.abs() < 1e-6, "{member} at {z}: {off}");
    }
}

pub fn a_section_of_helical_gears_can_be_chosen(browser: &Chromium, site: &Site) {
    let mut tab = browser.tab(1280, 900);
    tab.open(&site.helical);
    let poses = site.helical_result["runs"][0]["poses"].as_array().unwrap();
    for pose in [0, 7, 100, 300] {
        go(&mut tab, 0, pose);
        let at = poses[pose]["right"]["section_mm"].as_f64().unwrap();
        assert_at(&mut tab, at);
        assert_eq!(opacity(&mut tab, "right"), 1.0);
    }
    for z in [-24.0, 3.0, 24.0] {
        choose(&mut tab, z);
        assert_at(&mut tab, z);
        // A chosen section stays.
        go(&mut tab, 0, 20);
        assert_at(&mut tab, z);
    }
    choose(&mut tab, 1.234);
    assert_eq!(opacity(&mut tab, "right"), 0.3);
    tab.click("#viewer-section-follow");
    assert_at(&mut tab, poses[20]["right"]["section_mm"].as_f64().unwrap());
    tab.click("[name=viewer-side][value=left]");
    assert_at(&mut tab, poses[20]["left"]["section_mm"].as_f64().unwrap());
    let shown = tab.text("document.getElementById('viewer-section-text').textContent");
    assert!(shown.starts_with("Drawn in the section at z = "), "{shown}");
}
