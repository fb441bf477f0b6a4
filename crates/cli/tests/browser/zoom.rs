//! Zooming: the fixed place, the limits, and a responsive page throughout.

use crate::chromium::{Chromium, Script, Tab};
use crate::mesh::{go, number_shown, view};
use crate::page::{Site, open};
use serde_json::json;

/// The place of the contact on a side in the view, as shares of its width and height from the upper left corner.
fn contact(tab: &mut Tab, side: &str) -> [f64; 2] {
    let place = tab.text(&format!(
        "document.querySelector('#viewer-locked-{side} path').getAttribute('transform')"
    ));
    let place = place.trim_start_matches("translate(").trim_end_matches(')');
    let mut place = place.split(' ').map(|n| n.parse::<f64>().expect("a place"));
    let mut next = || place.next().expect("x and y");
    let (x, y) = (next(), -next());
    let [left, top, width, height] = view(tab);
    [(x - left) / width, (y - top) / height]
}

fn in_view(at: [f64; 2]) -> bool {
    at.iter().all(|part| (0.0..=1.0).contains(part))
}

/// Each dash-dotted line's length on the screen, px, and its dashes' period.
fn dashed(tab: &mut Tab) -> Vec<[f64; 2]> {
    let found = tab.eval(
        "(() => { const scale = document.getElementById('viewer-picture').getScreenCTM().a; \
         return [...document.querySelectorAll('#viewer-picture [stroke-dasharray]')].map((line) => \
         [line.getAttribute('d') ? line.getTotalLength() * scale : 0, \
          line.getAttribute('stroke-dasharray').split(' ').reduce((sum, part) => sum + Number(part), 0)]); })()",
    );
    let lines = found.as_array().expect("lines").iter();
    lines
        .map(|line| [0, 1].map(|i| line[i].as_f64().expect("a length")))
        .collect()
}

/// Issue 6: `+` again and again crashed the tab: whole pitch circles in dashes of a few pixels are millions of dashes.
pub fn zooming_in_keeps_the_page_alive_and_the_contact_in_view(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let home = view(&mut tab);
    let before = contact(&mut tab, "right");
    tab.eval("document.getElementById('viewer-picture').focus()");
    for step in 1..=19 {
        tab.key("+", false);
        let lines = dashed(&mut tab);
        assert_eq!(lines.len(), 3);
        for [length, period] in lines {
            // The diagonal of the picture is some 1200 px: a line through it, and as much again on both sides.
            assert!(
                length < 5000.0 && length / period < 300.0,
                "step {step}: {length} px in dashes of {period} px"
            );
        }
        assert!(in_view(contact(&mut tab, "right")), "step {step}");
    }
    let after = contact(&mut tab, "right");
    for axis in [0, 1] {
        // The viewBox is kept in double precision here: the contact stands still.
        assert!(
            (after[axis] - before[axis]).abs() < 1e-6,
            "{before:?} {after:?}"
        );
    }
    // The narrowest: chords of 2/60 000 mm are 2 of 800 px.
    let width = view(&mut tab)[2];
    assert!(
        (width - 0.013_333).abs() < 1e-6,
        "{width} mm of {}",
        home[2]
    );
    // Drawn, not only set: two frames come.
    tab.eval("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
    let picture = tab.call("Page.captureScreenshot", json!({ "format": "png" }));
    assert!(picture["data"].as_str().expect("a picture").len() > 1000);
    // And all the way out again.
    for _ in 0..30 {
        tab.key("-", false);
    }
    for [length, period] in dashed(&mut tab) {
        assert!(length / period < 300.0);
    }
}

/// Near by, the next pose's contact was millimetres outside the view.
pub fn near_by_the_view_follows_the_contact(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 0, 20);
    tab.eval("document.getElementById('viewer-picture').focus()");
    for _ in 0..10 {
        tab.key("+", false);
    }
    let before = contact(&mut tab, "right");
    tab.key("ArrowRight", false);
    assert_eq!(number_shown(&mut tab), 21.0);
    let after = contact(&mut tab, "right");
    for axis in [0, 1] {
        assert!(
            (after[axis] - before[axis]).abs() < 1e-6,
            "{before:?} {after:?}"
        );
    }
}

pub fn the_gap_can_be_looked_at(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    for (run, pose) in [(1, 20), (2, 40)] {
        go(&mut tab, run, pose);
        tab.click("#viewer-gap");
        let at = contact(&mut tab, "left");
        assert!(
            (at[0] - 0.5).abs() < 1e-6 && (at[1] - 0.5).abs() < 1e-6,
            "{at:?}"
        );
        let j_wt = site.pose(run, pose)["j_wt_um"]
            .as_f64()
            .expect("a backlash");
        let width = view(&mut tab)[2];
        assert!(
            (width - 4e-3 * j_wt.abs()).abs() < 1e-9,
            "{width} mm for {j_wt} µm"
        );
        // The button, and no other contact in view: zooming holds the gap.
        tab.click("#viewer-in");
        assert!((contact(&mut tab, "left")[0] - 0.5).abs() < 1e-6);
        tab.click("#viewer-home");
    }
}

/// Issue 6, review: each event of the wheel zoomed by a fifth, and a trackpad sends dozens a second.
pub fn the_wheel_zooms_by_how_far_it_turns(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let home = view(&mut tab);
    tab.middle("#viewer-picture");
    let turn = |tab: &mut Tab, down: f64, across: f64, mode: u32| {
        let taken = tab.eval(&format!(
            "(() => {{ const picture = document.getElementById('viewer-picture'), box = picture.getBoundingClientRect(); \
             return !picture.dispatchEvent(new WheelEvent('wheel', {{ deltaY: {down}, deltaX: {across}, deltaMode: {mode}, \
             clientX: box.x + 200, clientY: box.y + 150, bubbles: true, cancelable: true }})); }})()"
        ));
        let width = view(tab)[2];
        tab.key("0", false);
        (taken == json!(true), width / home[2])
    };
    tab.eval("document.getElementById('viewer-picture').focus()");
    // 2 px of a trackpad, a notch of 120 px, a notch of 3 lines, a page: never more than a fifth.
    for (down, mode, least, most) in [
        (-2.0, 0, 0.99, 0.999),
        (-120.0, 0, 0.8, 0.85),
        (3.0, 1, 1.15, 1.25),
        (1.0, 2, 1.15, 1.25),
        (-5000.0, 0, 0.8, 0.85),
    ] {
        let (taken, factor) = turn(&mut tab, down, 0.0, mode);
        assert!(
            taken && (least..=most).contains(&factor),
            "{down} of mode {mode}: {factor}"
        );
    }
    // Across is the page's own: scrolling, or back to the page before.
    for (down, across) in [(0.0, 60.0), (3.0, -40.0)] {
        assert_eq!(turn(&mut tab, down, across, 0), (false, 1.0));
    }
}

/// Two fingers on one spot gave 0/0 and a viewBox of NaN.
pub fn two_fingers_pinch(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    tab.call(
        "Emulation.setTouchEmulationEnabled",
        json!({ "enabled": true, "maxTouchPoints": 2 }),
    );
    let home = view(&mut tab);
    // A focused picture receives every touch.
    tab.eval("document.getElementById('viewer-picture').focus()");
    let [x, y] = tab.middle("#viewer-picture");
    let touch = |tab: &mut Tab, kind: &str, distances: &[f64]| {
        let points: Vec<_> = (0..)
            .zip(distances)
            .map(|(id, off)| json!({ "x": x + off, "y": y, "id": id }))
            .collect();
        tab.call(
            "Input.dispatchTouchEvent",
            json!({ "type": kind, "touchPoints": points }),
        );
    };
    touch(&mut tab, "touchStart", &[-40.0]);
    touch(&mut tab, "touchStart", &[-40.0, 40.0]);
    touch(&mut tab, "touchMove", &[-60.0, 60.0]);
    touch(&mut tab, "touchMove", &[-80.0, 80.0]);
    // Each finger moves by an event of its own, and a call may return before its events are handled.
    let width_is = |tab: &mut Tab, width: f64| {
        tab.until(&format!(
            "Math.abs(document.getElementById('viewer-picture').viewBox.baseVal.width / {width} - 1) < 0.02"
        ));
    };
    width_is(&mut tab, home[2] / 2.0);
    // Both onto one spot, and apart again.
    touch(&mut tab, "touchMove", &[0.0, 0.0]);
    touch(&mut tab, "touchMove", &[0.0, 0.0]);
    touch(&mut tab, "touchMove", &[-50.0, 50.0]);
    touch(&mut tab, "touchMove", &[-60.0, 60.0]);
    touch(&mut tab, "touchEnd", &[]);
    // One finger after the other: to half, from a spot to nothing (left out), twice, and by 60/50.
    width_is(&mut tab, home[2] / 2.4);
    let last = view(&mut tab);
    assert!(last.iter().all(|value| value.is_finite()), "{last:?}");
    assert!(tab.events("Runtime.exceptionThrown").is_empty());
}

pub fn buttons_wheel_and_keys_zoom(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let home = view(&mut tab);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * home[2];
    let before = contact(&mut tab, "right");
    tab.click("#viewer-in");
    let nearer = view(&mut tab);
    assert!(near(nearer[2], home[2] / 1.5) && near(nearer[3], home[3] / 1.5));
    let after = contact(&mut tab, "right");
    assert!(near(after[0], before[0]) && near(after[1], before[1]));
    // Held in left contact, that one keeps its place.
    tab.click("[name=viewer-side][value=left]");
    let before = contact(&mut tab, "left");
    tab.click("#viewer-in");
    let after = contact(&mut tab, "left");
    assert!(near(after[0], before[0]) && near(after[1], before[1]));
    tab.click("#viewer-out");
    tab.click("[name=viewer-side][value=right]");
    tab.click("#viewer-out");
    assert!(near(view(&mut tab)[2], home[2]));
    tab.click("#viewer-home");
    tab.eval("document.getElementById('viewer-picture').focus()");
    tab.key("+", false);
    assert!(near(view(&mut tab)[2], home[2] / 1.5));
    tab.key("-", false);
    tab.key("-", false);
    assert!(near(view(&mut tab)[2], home[2] * 1.5));
    tab.key("0", false);
    assert_eq!(view(&mut tab), home);
    // The wheel keeps the place under the pointer.
    let at = tab.middle("#viewer-picture");
    let at = [at[0] + 100.0, at[1] - 60.0];
    let under = format!(
        "(() => {{ const p = new DOMPoint({}, {}).matrixTransform(document.getElementById('viewer-picture').getScreenCTM().inverse()); return p.x; }})()",
        at[0], at[1]
    );
    let before = tab.number(&under);
    let scrolled = tab.number("window.scrollY");
    tab.mouse("mouseWheel", at, -120.0);
    tab.until(&format!(
        "document.getElementById('viewer-picture').viewBox.baseVal.width < {}",
        0.9 * home[2]
    ));
    // The page counts in single precision here.
    assert!((tab.number(&under) - before).abs() < 1e-4 * home[2]);
    assert_eq!(tab.number("window.scrollY"), scrolled);
    tab.mouse("mouseWheel", at, 120.0);
    tab.until(&format!(
        "document.getElementById('viewer-picture').viewBox.baseVal.width > {}",
        0.99 * home[2]
    ));
    tab.click("#viewer-whole");
    let whole = view(&mut tab);
    // Tip radii of 22 and 32 mm, plus the eccentricities.
    assert!(whole[0] < -22.0 && whole[0] + whole[2] > 50.0 + 32.0 && whole[3] > 64.0);
    tab.click("#viewer-home");
    assert_eq!(view(&mut tab), home);
}
