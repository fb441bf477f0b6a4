//! The mesh: the page shows the values of the result, and every control works.

use crate::browsers::{Chromium, Script, Tab};
use crate::page::{Site, of, open, shown_text, unfold};
use gearlash_text::numbers::{decades, two_digits_up};
use serde_json::{Value, json};

/// Shows a pose by the controls' own events.
pub fn go(tab: &mut Tab, run: usize, pose: usize) {
    tab.eval(&format!(
        "for (const [name, value, event] of [['runs', {run}, 'change'], ['slider', {pose}, 'input']]) {{ \
         const control = document.getElementById('viewer-' + name); control.value = value; \
         control.dispatchEvent(new Event(event, {{ bubbles: true }})); }}"
    ));
}

/// Puts the focus on an element of the viewer.
pub fn focus(tab: &mut Tab, name: &str) {
    tab.eval(&format!("document.getElementById('viewer-{name}').focus()"));
}

fn transform(tab: &mut Tab, name: &str) -> String {
    of(tab, name, "getAttribute('transform')")
}

/// Where the mark of a contact stands, mm.
pub fn contact_place(tab: &mut Tab, side: &str) -> [f64; 2] {
    let place = tab.text(&format!(
        "document.querySelector('#viewer-locked-{side} path').getAttribute('transform')"
    ));
    let place = place.trim_start_matches("translate(").trim_end_matches(')');
    let (x, y) = place.split_once(' ').unwrap();
    [x, y].map(|number| number.parse().unwrap())
}

/// The rotation in a gear's transform, degrees.
fn turned(tab: &mut Tab, member: &str) -> f64 {
    let transform = transform(tab, member);
    let (_, rotation) = transform.rsplit_once("rotate(").unwrap();
    rotation.trim_end_matches(')').parse().unwrap()
}

/// A gear has a rotation, shown to 1e-6°; the free gear's left contact is the sum of two such numbers.
fn assert_angle(tab: &mut Tab, member: &str, rotation: &Value) {
    let (shown, expected) = (turned(tab, member), rotation.as_f64().unwrap().to_degrees());
    let off = (shown - expected + 180.0).rem_euclid(360.0) - 180.0;
    assert!(off.abs() < 1.1e-6, "{member}: {shown}°, not {expected}°");
}

fn assert_stands(tab: &mut Tab, expected: &Value) {
    assert_angle(tab, "wheel", &expected["wheel_rotation_rad"]);
    assert_angle(tab, "pinion", &expected["right_rad"]);
}

pub fn number_shown(tab: &mut Tab) -> usize {
    of(tab, "slider", "value").parse().unwrap()
}

pub fn slider_and_arrow_keys_turn_the_gears(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let assert_at = |tab: &mut Tab, pose: usize| {
        assert_eq!(number_shown(tab), pose);
        assert_stands(tab, site.pose(0, pose));
    };
    go(&mut tab, 0, 10);
    assert_at(&mut tab, 10);
    let before = turned(&mut tab, "wheel");
    focus(&mut tab, "slider");
    tab.key("ArrowRight", false);
    assert_at(&mut tab, 11);
    assert!((turned(&mut tab, "wheel") - before).abs() > 1.0);
    focus(&mut tab, "picture");
    for (key, pose) in [("ArrowLeft", 10), ("ArrowLeft", 9), ("ArrowRight", 10)] {
        tab.key(key, false);
        assert_at(&mut tab, pose);
    }
    for (button, pose) in [("on", 11), ("back", 10)] {
        tab.click(&format!("#viewer-{button}"));
        assert_at(&mut tab, pose);
    }
    // No pose before the first.
    go(&mut tab, 0, 0);
    focus(&mut tab, "picture");
    tab.key("ArrowLeft", false);
    assert_at(&mut tab, 0);
}

pub fn backlash_is_the_results(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let tab = &mut tab;
    let mut negative = 0;
    for run in 0..4 {
        for pose in [0, 1, 7, 33, 80, 121, 159] {
            go(tab, run, pose);
            let expected = site.pose(run, pose);
            let j_wt = site.backlash(run, pose);
            negative += i32::from(j_wt < 0.0);
            let shown = shown_text(tab, "backlash");
            assert_eq!(shown, format!("{j_wt:.3} µm").replace('-', "−"));
            assert_eq!(of(tab, "backlash", "dataset.um").parse(), Ok(j_wt));
            assert_eq!(expected["status"], shown_text(tab, "status"));
            let bound = two_digits_up(expected["error_bound_um"].as_f64().unwrap());
            assert_eq!(shown_text(tab, "bound"), format!("≤ {} µm", decades(bound)));
            for side in ["right", "left"] {
                let contact = &expected[side];
                let words = format!(
                    "wheel tooth {} on pinion tooth {}, {}",
                    contact["wheel_tooth"],
                    contact["pinion_tooth"],
                    contact["class"].as_str().unwrap()
                );
                let shown = shown_text(tab, side);
                assert!(shown.starts_with(&words), "{shown}: not {words}");
                for (axis, shown) in contact_place(tab, side).into_iter().enumerate() {
                    let exact = contact["point_mm"][axis].as_f64().unwrap();
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
    for (run, pose, overlaps) in [(0, 40, true), (3, 20, false)] {
        go(&mut tab, run, pose);
        let j_wt = site.backlash(run, pose);
        assert_eq!(j_wt < 0.0, overlaps, "{j_wt} µm");
        let by = -j_wt;
        let expected = format!("Teeth overlap by {by:.1} µm at the red dots: zoom in to see it.");
        let expected = if overlaps { &expected } else { "" };
        assert_eq!(shown_text(&mut tab, "overlapping"), expected);
        tab.holds(&format!(
            "(getComputedStyle(document.querySelector('#viewer-locked-left path')).stroke === 'rgb(224, 64, 44)') === {overlaps}"
        ));
    }
}

/// The curve of a run at another distance is folded away: choosing the run unfolds it. Labels stay above the cursor.
pub fn the_cursor_is_where_it_can_be_seen(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    for run in [0, 2] {
        go(&mut tab, run, 40);
        for expression in [
            "document.querySelector('.viewer-cursor').getBoundingClientRect().height > 100",
            "document.querySelector('.viewer-cursor').nextElementSibling.getAttribute('class') === 'gearlash-labels'",
            "document.getElementById('viewer-no-curve').hidden",
        ] {
            tab.holds(expression);
        }
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
        let before = turned(&mut tab, "wheel");
        focus(&mut tab, "picture");
        tab.key("ArrowRight", false);
        assert_eq!(number_shown(&mut tab), 4);
        let step = (turned(&mut tab, "wheel") - before).abs();
        // Half of a twentieth of a turn.
        assert!((step.min(360.0 - step) - 9.0).abs() < 1e-5, "{step}°");
        assert!(turned(&mut tab, "pinion").is_finite());
    }
}

pub fn the_free_gear_goes_from_contact_to_contact(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    go(&mut tab, 1, 20);
    let expected = site.pose(1, 20);
    let assert_open = |tab: &mut Tab, side: &str, is_open: bool| {
        tab.holds(&format!(
            "document.getElementById('viewer-free-{side}').classList.contains('viewer-open') === {is_open}"
        ));
    };
    assert_open(&mut tab, "right", false);
    tab.click("[name=viewer-side][value=left]");
    assert_angle(&mut tab, "pinion", &expected["left_rad"]);
    assert_open(&mut tab, "right", true);
    assert_open(&mut tab, "left", false);
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
        let axis = transform(&mut tab, "pinion");
        let distance = site.result["runs"][run]["center_distance_mm"].as_f64();
        let expected = format!("translate({} 0)", distance.unwrap());
        assert!(axis.starts_with(&expected), "{axis}");
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
    assert_stands(&mut tab, site.pose(0, stopped));
}

/// Left, top, width, height of what the picture shows.
pub fn view(tab: &mut Tab) -> [f64; 4] {
    tab.numbers(
        "document.getElementById('viewer-picture').getAttribute('viewBox').split(' ').map(Number)",
    )
}

pub fn dragging_and_shifted_arrows_pan(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let [left, top, width, height] = view(&mut tab);
    let assert_at = |tab: &mut Tab, [x, y]: [f64; 2], share: f64, what: &str| {
        let moved = view(tab);
        let off = [(moved[0] - x) / width, (moved[1] - y) / height];
        assert!(off.iter().all(|off| off.abs() < share), "{what}: {moved:?}");
    };
    let scale = tab.number("document.getElementById('viewer-picture').getScreenCTM().a");
    let at = tab.middle("#viewer-picture");
    tab.mouse("mousePressed", at, 0.0);
    let to = |part: f64| [at[0] + 80.0 * part, at[1] - 50.0 * part];
    for part in [0.5, 1.0] {
        tab.mouse("mouseMoved", to(part), 0.0);
    }
    tab.mouse("mouseReleased", to(1.0), 0.0);
    let dragged = [left - 80.0 / scale, top + 50.0 / scale];
    assert_at(&mut tab, dragged, 1e-3, "dragged");
    let before = view(&mut tab);
    tab.mouse("mouseMoved", at, 0.0);
    assert_eq!(view(&mut tab), before);
    tab.key("0", false);
    let pose = number_shown(&mut tab);
    for (key, right, down) in [
        ("ArrowRight", 0.1, 0.0),
        ("ArrowDown", 0.1, 0.1),
        ("ArrowLeft", 0.0, 0.1),
        ("ArrowUp", 0.0, 0.0),
    ] {
        tab.key(key, true);
        let expected = [left + right * width, top + down * height];
        assert_at(&mut tab, expected, 1e-9, key);
    }
    assert_eq!(number_shown(&mut tab), pose);
}

pub fn a_click_in_the_chart_leads_to_the_pose(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    unfold(&mut tab);
    // A right-flank pose of each material: its place by the chart's frame, its curve by its backlash.
    for (run, pose) in [(0, 40), (1, 97), (2, 12), (3, 130)] {
        go(&mut tab, run, 0);
        let expected = site.pose(run, pose);
        // Before tooth 1 comes again, a wheel tooth and a fraction are a place.
        let [tooth, fraction] =
            ["wheel_tooth", "fraction"].map(|key| expected["mating"][key].as_f64().unwrap());
        let at: [f64; 2] = tab.numbers(&format!(
            "(() => {{ const svg = [...document.querySelectorAll('svg')].find((svg) => svg.querySelector('.viewer-cursor')); \
             svg.scrollIntoView({{ block: 'center' }}); \
             const d = svg.dataset, at = (v, a, b, from, to) => +from + (v - a) / (b - a) * (to - from); \
             const p = new DOMPoint(at({}, d.x0, d.x1, d.left, d.right), at({}, d.y0, d.y1, d.bottom, d.top)).matrixTransform(svg.getScreenCTM()); \
             return [p.x, p.y]; }})()",
            tooth + fraction,
            site.backlash(run, pose)
        ));
        tab.click_at(at);
        assert_eq!(number_shown(&mut tab), pose);
        assert_eq!(of(&mut tab, "runs", "value"), run.to_string());
        assert_stands(&mut tab, expected);
        // One cursor is seen, where the click was.
        let [cursor]: [f64; 1] = tab.numbers(
            "[...document.querySelectorAll('.viewer-cursor')].map((line) => line.getBoundingClientRect()).filter((b) => b.height > 0).map((b) => b.x + b.width / 2)",
        );
        assert!((cursor - at[0]).abs() < 1.0, "{cursor}, click at {at:?}");
    }
}

/// The outlines of helical gears wind with the section, by z tan β/r, r = m_n z/(2 cos β): right-hand ones clockwise away from the viewer, those of the
/// mate the other way. The section follows the contact until one is chosen.
pub fn a_section_of_helical_gears_can_be_chosen(browser: &Chromium, site: &Site) {
    let assert_at = |tab: &mut Tab, z: f64| {
        for (member, teeth, hand) in [("wheel", 27.0, 1.0), ("pinion", 51.0, -1.0)] {
            let transform = transform(tab, &format!("{member}-0"));
            let angle = transform.strip_prefix("rotate(").unwrap();
            let wound: f64 = angle.split(' ').next().unwrap().parse().unwrap();
            let beta = 21f64.to_radians();
            let expected = -hand * z * 2.0 * beta.sin() / (4.5 * teeth);
            let off = wound - expected.to_degrees();
            assert!(off.abs() < 1e-6, "{member} at {z}: {off}");
        }
    };
    let opacity = |tab: &mut Tab| -> f64 {
        let opacity = of(tab, "right-contact", "getAttribute('opacity')");
        opacity.parse().unwrap()
    };
    let choose = |tab: &mut Tab, z: f64| {
        tab.eval(&format!(
            "{{ const slider = document.getElementById('viewer-section'); slider.value = {z}; \
             slider.dispatchEvent(new Event('input', {{ bubbles: true }})); }}"
        ));
    };
    let mut tab = browser.tab(1280, 900);
    tab.open(&site.helical);
    let poses = &site.helical_result["runs"][0]["poses"];
    let section = |pose: usize, side: &str| poses[pose][side]["section_mm"].as_f64().unwrap();
    for pose in [0, 7, 100, 300] {
        go(&mut tab, 0, pose);
        assert_at(&mut tab, section(pose, "right"));
        assert_eq!(opacity(&mut tab), 1.0);
    }
    for z in [-24.0, 3.0, 24.0] {
        choose(&mut tab, z);
        assert_at(&mut tab, z);
        // A chosen section stays.
        go(&mut tab, 0, 20);
        assert_at(&mut tab, z);
    }
    choose(&mut tab, 1.234);
    assert_eq!(opacity(&mut tab), 0.3);
    tab.click("#viewer-section-follow");
    assert_at(&mut tab, section(20, "right"));
    tab.click("[name=viewer-side][value=left]");
    assert_at(&mut tab, section(20, "left"));
    let shown: f64 = of(&mut tab, "section-at", "value").parse().unwrap();
    assert!((shown - section(20, "left")).abs() <= 5e-3, "{shown}");
}
