//! The mesh: the page shows the values of the result, and every control works.

use crate::chromium::{Chromium, Script, Tab};
use crate::page::{Site, open, shown_text, unfold};
use serde_json::{Value, json};

/// Shows a pose by the controls' own events.
pub fn go(tab: &mut Tab, run: usize, pose: usize) {
    tab.eval(&format!(
        "for (const [name, value, event] of [['runs', {run}, 'change'], ['slider', {pose}, 'input']]) {{ \
         const control = document.getElementById('viewer-' + name); control.value = value; \
         control.dispatchEvent(new Event(event, {{ bubbles: true }})); }}"
    ));
}

/// The rotation in a gear's transform, degrees.
fn turned(tab: &mut Tab, member: &str) -> f64 {
    let transform = tab.text(&format!(
        "document.getElementById('viewer-{member}').getAttribute('transform')"
    ));
    let rotation = transform
        .rsplit_once("rotate(")
        .expect("a gear is turned")
        .1;
    rotation.trim_end_matches(')').parse().expect("an angle")
}

fn assert_angle(shown: f64, expected_rad: &Value, what: &str) {
    let expected = expected_rad.as_f64().expect("a rotation").to_degrees();
    let off = (shown - expected + 180.0).rem_euclid(360.0) - 180.0;
    // Shown to 1e-6°; the free gear's left contact is the sum of two such numbers.
    assert!(
        off.abs() < 1.1e-6,
        "{what}: {shown}° instead of {expected}°"
    );
}

fn assert_stands(tab: &mut Tab, expected: &Value) {
    let (wheel, pinion) = (turned(tab, "wheel"), turned(tab, "pinion"));
    assert_angle(wheel, &expected["wheel_rotation_rad"], "wheel");
    assert_angle(pinion, &expected["right_rad"], "pinion");
}

pub fn number_shown(tab: &mut Tab) -> f64 {
    tab.number("Number(document.getElementById('viewer-slider').value)")
}

pub fn slider_and_arrow_keys_turn_the_gears(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 0, 10);
    assert_stands(&mut tab, site.pose(0, 10));
    let before = turned(&mut tab, "wheel");
    tab.eval("document.getElementById('viewer-slider').focus()");
    tab.key("ArrowRight", false);
    assert_eq!(number_shown(&mut tab), 11.0);
    assert_stands(&mut tab, site.pose(0, 11));
    assert!((turned(&mut tab, "wheel") - before).abs() > 1.0);
    tab.eval("document.getElementById('viewer-picture').focus()");
    for (key, pose) in [("ArrowLeft", 10), ("ArrowLeft", 9), ("ArrowRight", 10)] {
        tab.key(key, false);
        assert_eq!(number_shown(&mut tab), f64::from(pose));
        assert_stands(&mut tab, site.pose(0, pose as usize));
    }
    for (button, pose) in [("on", 11), ("back", 10)] {
        tab.click(&format!("#viewer-{button}"));
        assert_stands(&mut tab, site.pose(0, pose));
    }
    // No pose before the first.
    go(&mut tab, 0, 0);
    tab.eval("document.getElementById('viewer-picture').focus()");
    tab.key("ArrowLeft", false);
    assert_stands(&mut tab, site.pose(0, 0));
}

pub fn backlash_is_the_results(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let mut negative = 0;
    for run in 0..4 {
        for pose in [0, 1, 7, 33, 80, 121, 159] {
            go(&mut tab, run, pose);
            let expected = site.pose(run, pose);
            let j_wt = expected["j_wt_um"].as_f64().expect("a backlash");
            negative += i32::from(j_wt < 0.0);
            let shown = shown_text(&mut tab, "backlash");
            assert_eq!(shown, format!("{j_wt:.3} µm").replace('-', "−"));
            let whole = tab.text("document.getElementById('viewer-backlash').dataset.um");
            assert_eq!(whole.parse(), Ok(j_wt));
            assert_eq!(
                shown_text(&mut tab, "status"),
                expected["status"].as_str().expect("a status")
            );
            let bound = shown_text(&mut tab, "bound");
            let bound = bound.trim_start_matches("≤ ").trim_end_matches(" µm");
            let plain: String = bound.chars().map(lowered).collect();
            let bound: f64 = plain.replace("·10", "e").parse().expect("a bound");
            let exact = expected["error_bound_um"].as_f64().expect("a bound");
            assert!(
                bound >= exact && bound <= 1.1 * exact,
                "{bound} for {exact}"
            );
            for side in ["right", "left"] {
                let contact = &expected[side];
                let teeth = format!(
                    "wheel tooth {} on pinion tooth {}, ",
                    contact["wheel_tooth"], contact["pinion_tooth"]
                );
                let shown = shown_text(&mut tab, side);
                let class = shown
                    .strip_prefix(&teeth)
                    .unwrap_or_else(|| panic!("{shown}: not {teeth}"));
                assert!(
                    class.starts_with(contact["class"].as_str().expect("a class")),
                    "{class}"
                );
                let place = tab.text(&format!(
                    "document.querySelector('#viewer-locked-{side} path').getAttribute('transform')"
                ));
                let place = place.trim_start_matches("translate(").trim_end_matches(')');
                for (axis, shown) in place.split(' ').enumerate() {
                    let shown: f64 = shown.parse().expect("a place");
                    let exact = contact["point_mm"][axis].as_f64().expect("a place");
                    assert!((shown - exact).abs() <= 0.51e-4, "{shown} for {exact}");
                }
            }
        }
    }
    assert!(negative > 0, "an interference is among them");
}

/// An overlap of micrometres is no pixel wide at the opening zoom: words and dots say where it is.
pub fn an_overlap_is_reported_where_it_cannot_be_seen(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    for (run, pose) in [(0, 40), (3, 20)] {
        go(&mut tab, run, pose);
        let j_wt = site.pose(run, pose)["j_wt_um"]
            .as_f64()
            .expect("a backlash");
        let overlaps = j_wt < 0.0;
        assert_eq!(overlaps, run == 0, "{j_wt} µm");
        let expected = if overlaps {
            format!(
                "Teeth overlap by {:.1} µm at the red dots: zoom in to see it.",
                -j_wt
            )
        } else {
            String::new()
        };
        assert_eq!(shown_text(&mut tab, "overlapping"), expected);
        let red = tab
            .text("getComputedStyle(document.querySelector('#viewer-locked-left path')).stroke")
            == "rgb(224, 64, 44)";
        assert_eq!(red, overlaps);
    }
}

/// The curve of a run at another distance is folded away: choosing the run unfolds it.
pub fn the_cursor_is_where_it_can_be_seen(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    for run in [0, 2] {
        go(&mut tab, run, 40);
        let seen = "document.querySelector('.viewer-cursor').getBoundingClientRect().height > 100";
        assert_eq!(tab.eval(seen), json!(true), "run {run}");
        // Labels stay above it.
        let above =
            "document.querySelector('.viewer-cursor').nextElementSibling.getAttribute('class')";
        assert_eq!(tab.text(above), "gearlash-labels");
        let silent = "document.getElementById('viewer-no-curve').hidden";
        assert_eq!(tab.eval(silent), json!(true));
    }
}

/// Poses without a number: the page names the kind, and the gears are still drawn and turn.
pub fn jammed_and_out_of_mesh_poses_are_shown(browser: &Chromium, site: &Site) {
    let mut tab = browser.tab(1280, 900);
    tab.open(&site.stuck);
    for (run, status) in [(0, "jammed"), (1, "no contact")] {
        go(&mut tab, run, 3);
        assert_eq!(shown_text(&mut tab, "status"), status);
        assert_eq!(shown_text(&mut tab, "backlash"), "none");
        assert_eq!(
            tab.text("document.getElementById('viewer-backlash').title"),
            ""
        );
        let before = turned(&mut tab, "wheel");
        tab.eval("document.getElementById('viewer-picture').focus()");
        tab.key("ArrowRight", false);
        assert_eq!(number_shown(&mut tab), 4.0);
        let step = (turned(&mut tab, "wheel") - before).abs();
        // Half of a twentieth of a turn.
        assert!((step.min(360.0 - step) - 9.0).abs() < 1e-5, "{step}°");
        let standing = turned(&mut tab, "pinion");
        assert!(standing.is_finite(), "{standing}");
    }
    assert!(tab.events("Runtime.exceptionThrown").is_empty());
    assert!(tab.events("Runtime.consoleAPICalled").is_empty());
}

pub fn the_free_gear_goes_from_contact_to_contact(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 1, 20);
    let expected = site.pose(1, 20);
    assert_eq!(
        tab.eval("document.getElementById('viewer-free-right').classList.contains('viewer-open')"),
        json!(false)
    );
    tab.click("[name=viewer-side][value=left]");
    let free = turned(&mut tab, "pinion");
    assert_angle(free, &expected["left_rad"], "pinion at left contact");
    assert_eq!(
        tab.eval("document.getElementById('viewer-free-right').classList.contains('viewer-open')"),
        json!(true)
    );
    assert_eq!(
        tab.eval("document.getElementById('viewer-free-left').classList.contains('viewer-open')"),
        json!(false)
    );
    tab.click("[name=viewer-side][value=right]");
    assert_stands(&mut tab, expected);
}

pub fn a_run_can_be_chosen(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let labels = tab
        .eval("[...document.getElementById('viewer-runs').options].map((option) => option.text)");
    let expected = [
        "a = 49.900 mm, most material",
        "a = 49.900 mm, least material",
        "a = 50.000 mm, most material",
        "a = 50.000 mm, least material",
    ];
    // The worst pose lies between those of the runs.
    let worst = "a = 49.900 mm, most material, worst of the whole mesh cycle";
    assert_eq!(labels, json!([&expected[..], &[worst]].concat()));
    for (run, label) in expected.iter().enumerate() {
        go(&mut tab, run, 5);
        assert_eq!(shown_text(&mut tab, "run"), *label);
        assert_stands(&mut tab, site.pose(run, 5));
        let outline = tab.text("document.querySelector('#viewer-pinion use').getAttribute('href')");
        assert_eq!(outline, format!("#viewer-pinion-{}", run % 2));
        let axis = tab.text("document.getElementById('viewer-pinion').getAttribute('transform')");
        let distance = &site.result["runs"][run]["center_distance_mm"];
        let distance = distance.as_f64().expect("a distance");
        assert!(
            axis.starts_with(&format!("translate({distance} 0)")),
            "{axis}"
        );
    }
}

pub fn play_advances_until_paused(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 0, 3);
    tab.click("#viewer-play");
    assert_eq!(shown_text(&mut tab, "play"), "Pause");
    tab.until("Number(document.getElementById('viewer-slider').value) >= 6");
    tab.click("#viewer-play");
    assert_eq!(shown_text(&mut tab, "play"), "Play");
    let stopped = number_shown(&mut tab);
    std::thread::sleep(std::time::Duration::from_millis(400));
    assert_eq!(number_shown(&mut tab), stopped);
    assert_stands(&mut tab, site.pose(0, stopped as usize));
}

/// Left, top, width, height of what the picture shows.
pub fn view(tab: &mut Tab) -> [f64; 4] {
    let text = tab.text("document.getElementById('viewer-picture').getAttribute('viewBox')");
    let numbers: Vec<f64> = text
        .split(' ')
        .map(|n| n.parse().expect("a number"))
        .collect();
    numbers.try_into().expect("a viewBox has four numbers")
}

pub fn dragging_and_shifted_arrows_pan(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let home = view(&mut tab);
    let scale = tab.number("document.getElementById('viewer-picture').getScreenCTM().a");
    let at = tab.middle("#viewer-picture");
    tab.mouse("mousePressed", at, 0.0);
    for part in [0.5, 1.0] {
        tab.mouse(
            "mouseMoved",
            [at[0] + 80.0 * part, at[1] - 50.0 * part],
            0.0,
        );
    }
    tab.mouse("mouseReleased", [at[0] + 80.0, at[1] - 50.0], 0.0);
    let dragged = view(&mut tab);
    assert!(
        (dragged[0] - (home[0] - 80.0 / scale)).abs() < 1e-3 * home[2],
        "{dragged:?}"
    );
    assert!(
        (dragged[1] - (home[1] + 50.0 / scale)).abs() < 1e-3 * home[2],
        "{dragged:?}"
    );
    tab.mouse("mouseMoved", at, 0.0);
    assert_eq!(view(&mut tab), dragged);
    tab.key("0", false);
    let pose = number_shown(&mut tab);
    for (key, right, down) in [
        ("ArrowRight", 0.1, 0.0),
        ("ArrowDown", 0.1, 0.1),
        ("ArrowLeft", 0.0, 0.1),
        ("ArrowUp", 0.0, 0.0),
    ] {
        tab.key(key, true);
        let moved = view(&mut tab);
        assert!(
            (moved[0] - (home[0] + right * home[2])).abs() < 1e-9 * home[2],
            "{key}: {moved:?}"
        );
        assert!(
            (moved[1] - (home[1] + down * home[3])).abs() < 1e-9 * home[3],
            "{key}: {moved:?}"
        );
    }
    assert_eq!(number_shown(&mut tab), pose);
}

pub fn a_click_in_the_chart_leads_to_the_pose(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    unfold(&mut tab);
    // A right-flank pose of each material: its place by the chart's frame, its curve by its backlash.
    for (run, pose) in [(0, 40), (1, 97), (2, 12), (3, 130)] {
        go(&mut tab, run, 0);
        let chart = "[...document.querySelectorAll('svg')].find((svg) => svg.querySelector('.viewer-cursor'))";
        tab.eval(&format!("{chart}.scrollIntoView({{ block: 'center' }})"));
        let expected = site.pose(run, pose);
        let mating = &expected["mating"];
        // Before tooth 1 comes again, a wheel tooth and a fraction are a place.
        let x = mating["wheel_tooth"].as_f64().expect("a tooth")
            + mating["fraction"].as_f64().expect("a fraction");
        let at = tab.eval(&format!(
            "(() => {{ const svg = {chart}, d = svg.dataset, at = (v, a, b, from, to) => +from + (v - a) / (b - a) * (to - from); \
             const p = new DOMPoint(at({x}, d.x0, d.x1, d.left, d.right), at({}, d.y0, d.y1, d.bottom, d.top)).matrixTransform(svg.getScreenCTM()); \
             return [p.x, p.y]; }})()",
            expected["j_wt_um"]
        ));
        let at = [0, 1].map(|i| at[i].as_f64().expect("a place"));
        tab.click_at(at);
        assert_eq!(number_shown(&mut tab), pose as f64);
        assert_eq!(
            tab.eval("Number(document.getElementById('viewer-runs').value)"),
            json!(run)
        );
        assert_stands(&mut tab, expected);
        let cursor = tab.number("(() => { const b = document.querySelector('.viewer-cursor').getBoundingClientRect(); return b.x + b.width / 2; })()");
        assert!(
            (cursor - at[0]).abs() < 1.0,
            "cursor at {cursor}, click at {}",
            at[0]
        );
        assert_eq!(
            tab.number("[...document.querySelectorAll('.viewer-cursor')].filter((line) => line.getBoundingClientRect().height > 0).length"),
            1.0
        );
    }
}

/// A raised digit as a plain one.
fn lowered(c: char) -> char {
    let raised = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c);
    match (c, raised) {
        ('⁻', _) => '-',
        (_, Some(digit)) => char::from(b'0' + digit as u8),
        _ => c,
    }
}
