//! Zooming: the fixed place, the limits, and a responsive page throughout.

use crate::browsers::{Chromium, Script, Tab};
use crate::mesh::{contact_place, focus, go, number_shown, view};
use crate::page::{Site, open};
use serde_json::json;

/// The place of the contact on a side in the view, as shares of its width and height from the upper left corner.
fn contact(tab: &mut Tab, side: &str) -> [f64; 2] {
    let [x, y] = contact_place(tab, side);
    let [left, top, width, height] = view(tab);
    [(x - left) / width, (-y - top) / height]
}

/// The contact on a side stands where it stood in the view: the viewBox is kept in double precision.
fn assert_still(tab: &mut Tab, side: &str, before: [f64; 2], most: f64) {
    let after = contact(tab, side);
    let off = [0, 1].map(|axis| (after[axis] - before[axis]).abs());
    assert!(off.iter().all(|off| *off < most), "{before:?} {after:?}");
}

/// No dash-dotted line has dashes by the hundred. The diagonal of the picture is some 1200 px: a line through it, and as much again on both sides.
fn assert_few_dashes(tab: &mut Tab) {
    tab.holds(
        "(() => { const scale = document.getElementById('viewer-picture').getScreenCTM().a; \
         const lines = [...document.querySelectorAll('#viewer-picture [stroke-dasharray]')]; \
         return lines.length === 3 && lines.every((line) => { \
         const length = line.getAttribute('d') ? line.getTotalLength() * scale : 0; \
         const period = line.getAttribute('stroke-dasharray').split(' ').reduce((sum, part) => sum + Number(part), 0); \
         return length < 5000 && length / period < 300; }); })()",
    );
}

/// Issue 6: `+` again and again crashed the tab: whole pitch circles in dashes of a few pixels are millions of dashes.
pub fn zooming_in_keeps_the_page_alive_and_the_contact_in_view(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let before = contact(&mut tab, "right");
    focus(&mut tab, "picture");
    for step in 1..=19 {
        tab.key("+", false);
        assert_few_dashes(&mut tab);
        let at = contact(&mut tab, "right");
        let is_inside = at.iter().all(|part| (0.0..=1.0).contains(part));
        assert!(is_inside, "step {step}: {at:?}");
    }
    assert_still(&mut tab, "right", before, 1e-6);
    // The narrowest: chords of 2/60 000 mm are 2 of 800 px.
    let width = view(&mut tab)[2];
    assert!((width - 0.013_333).abs() < 1e-6, "{width} mm");
    // Drawn, not only set: two frames come.
    tab.eval("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
    let picture = tab.call("Page.captureScreenshot", json!({ "format": "png" }));
    assert!(picture["data"].as_str().unwrap().len() > 1000);
    // And all the way out again.
    for _ in 0..30 {
        tab.key("-", false);
    }
    assert_few_dashes(&mut tab);
}

/// Near by, the next pose's contact was millimetres outside the view.
pub fn near_by_the_view_follows_the_contact(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 0, 20);
    focus(&mut tab, "picture");
    for _ in 0..10 {
        tab.key("+", false);
    }
    let before = contact(&mut tab, "right");
    tab.key("ArrowRight", false);
    assert_eq!(number_shown(&mut tab), 21);
    assert_still(&mut tab, "right", before, 1e-6);
}

pub fn the_gap_can_be_looked_at(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    for (run, pose) in [(1, 20), (2, 40)] {
        go(&mut tab, run, pose);
        tab.click("#viewer-gap");
        assert_still(&mut tab, "left", [0.5, 0.5], 1e-6);
        let expected = 4e-3 * site.backlash(run, pose).abs();
        let width = view(&mut tab)[2];
        assert!((width - expected).abs() < 1e-9, "{width} mm: {expected}");
        // The button, and no other contact in view: zooming holds the gap.
        tab.click("#viewer-in");
        assert_still(&mut tab, "left", [0.5, 0.5], 1e-6);
        tab.click("#viewer-home");
    }
}

/// Issue 6, review: each event of the wheel zoomed by a fifth, and a trackpad sends dozens a second.
pub fn the_wheel_zooms_by_how_far_it_turns(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let home = view(&mut tab);
    tab.middle("#viewer-picture");
    focus(&mut tab, "picture");
    // 2 px of a trackpad, a notch of 120 px, a notch of 3 lines, a page: never more than a fifth. Across is the page's own: scrolling, or back to the
    // page before.
    for (down, across, mode, least, most) in [
        (-2.0, 0.0, 0, 0.99, 0.999),
        (-120.0, 0.0, 0, 0.8, 0.85),
        (3.0, 0.0, 1, 1.15, 1.25),
        (1.0, 0.0, 2, 1.15, 1.25),
        (-5000.0, 0.0, 0, 0.8, 0.85),
        (0.0, 60.0, 0, 1.0, 1.0),
        (3.0, -40.0, 0, 1.0, 1.0),
    ] {
        let is_left = tab.eval(&format!(
            "(() => {{ const picture = document.getElementById('viewer-picture'), box = picture.getBoundingClientRect(); \
             return picture.dispatchEvent(new WheelEvent('wheel', {{ deltaY: {down}, deltaX: {across}, deltaMode: {mode}, \
             clientX: box.x + 200, clientY: box.y + 150, bubbles: true, cancelable: true }})); }})()"
        ));
        let factor = view(&mut tab)[2] / home[2];
        tab.key("0", false);
        assert_eq!(is_left, json!(across != 0.0), "{down} {across}");
        let is_between = (least..=most).contains(&factor);
        assert!(is_between, "{down} of mode {mode}: {factor}");
    }
}

/// Two fingers on one spot gave 0/0 and a viewBox of NaN.
pub fn two_fingers_pinch(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let two = json!({ "enabled": true, "maxTouchPoints": 2 });
    tab.call("Emulation.setTouchEmulationEnabled", two);
    let home = view(&mut tab);
    // A focused picture receives every touch.
    focus(&mut tab, "picture");
    let [x, y] = tab.middle("#viewer-picture");
    let touch = |tab: &mut Tab, kind: &str, distances: &[f64]| {
        let points = (0..).zip(distances);
        let points = points.map(|(id, off)| json!({ "x": x + off, "y": y, "id": id }));
        let points: Vec<_> = points.collect();
        let event = json!({ "type": kind, "touchPoints": points });
        tab.call("Input.dispatchTouchEvent", event);
    };
    // Each finger moves by an event of its own, and a call may return before its events are handled.
    let width_is = |tab: &mut Tab, width: f64| {
        tab.until(&format!(
            "Math.abs(document.getElementById('viewer-picture').viewBox.baseVal.width / {width} - 1) < 0.02"
        ));
    };
    touch(&mut tab, "touchStart", &[-40.0]);
    touch(&mut tab, "touchStart", &[-40.0, 40.0]);
    for half in [60.0, 80.0] {
        touch(&mut tab, "touchMove", &[-half, half]);
    }
    width_is(&mut tab, home[2] / 2.0);
    // Both onto one spot, and apart again.
    for half in [0.0, 0.0, 50.0, 60.0] {
        touch(&mut tab, "touchMove", &[-half, half]);
    }
    touch(&mut tab, "touchEnd", &[]);
    // One finger after the other: to half, from a spot to nothing (left out), twice, and by 60/50.
    width_is(&mut tab, home[2] / 2.4);
    let last = view(&mut tab);
    assert!(last.iter().all(|value| value.is_finite()), "{last:?}");
    assert!(tab.events("Runtime.exceptionThrown").is_empty());
}

pub fn buttons_wheel_and_keys_zoom(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let tab = &mut tab;
    let home = view(tab);
    // Both sides are `times` those of the first view.
    let assert_size = |tab: &mut Tab, times: f64| {
        let now = view(tab);
        let off = [2, 3].map(|side| (now[side] - times * home[side]).abs());
        assert!(off.iter().all(|off| *off < 1e-9 * home[2]), "{now:?}");
    };
    let before = contact(tab, "right");
    tab.click("#viewer-in");
    assert_size(tab, 1.0 / 1.5);
    assert_still(tab, "right", before, 1e-9 * home[2]);
    // Held in left contact, that one keeps its place.
    tab.click("[name=viewer-side][value=left]");
    let before = contact(tab, "left");
    tab.click("#viewer-in");
    assert_still(tab, "left", before, 1e-9 * home[2]);
    tab.click("#viewer-out");
    tab.click("[name=viewer-side][value=right]");
    tab.click("#viewer-out");
    assert_size(tab, 1.0);
    tab.click("#viewer-home");
    focus(tab, "picture");
    for (keys, times) in [("+", 1.0 / 1.5), ("--", 1.5), ("0", 1.0)] {
        for key in keys.chars() {
            tab.key(&key.to_string(), false);
        }
        assert_size(tab, times);
    }
    assert_eq!(view(tab), home);
    // The wheel keeps the place under the pointer.
    let at = tab.middle("#viewer-picture");
    let at = [at[0] + 100.0, at[1] - 60.0];
    let under = format!(
        "(() => {{ const p = new DOMPoint({}, {}).matrixTransform(document.getElementById('viewer-picture').getScreenCTM().inverse()); return p.x; }})()",
        at[0], at[1]
    );
    let before = tab.number(&under);
    let scrolled = tab.number("window.scrollY");
    for (wheel, comparison, times) in [(-120.0, '<', 0.9), (120.0, '>', 0.99)] {
        tab.mouse("mouseWheel", at, wheel);
        let width = "document.getElementById('viewer-picture').viewBox.baseVal.width";
        tab.until(&format!("{width} {comparison} {}", times * home[2]));
        // The page counts in single precision here.
        assert!((tab.number(&under) - before).abs() < 1e-4 * home[2]);
    }
    assert_eq!(tab.number("window.scrollY"), scrolled);
    tab.click("#viewer-whole");
    let whole = view(tab);
    // Tip radii of 22 and 32 mm, plus the eccentricities.
    assert!(whole[0] < -22.0 && whole[0] + whole[2] > 50.0 + 32.0 && whole[3] > 64.0);
    tab.click("#viewer-home");
    assert_eq!(view(tab), home);
}
