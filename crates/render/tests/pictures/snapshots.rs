//! The contact snapshot: what it shows, and that any reader shows it. `tests/sessions/pictures_named.txt` holds what it says.

use super::drawn::{Picture, Room, meets, overlap, within};
use super::posed::{Posed, all, j_bn, nominal, pair};
use gearlash::gear::Side;
use gearlash::pair::Member;
use gearlash_render::{Snapshot, snapshot};
use roxmltree::{Document, Node};
use std::sync::LazyLock;

/// 44/44 of module 3, mating 11 & 11.
fn rig(center_distance: f64) -> Posed {
    let pair = pair([44, 44], 3.0, center_distance, Member::Wheel);
    Posed::new(pair, [11, 11], Side::Right, 0.0)
}

/// Named pictures of every kind: clear, interfering, wide open, out of mesh, jammed; small,
/// large, many-toothed; either gear locked.
static PICTURES: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    let mut pictures = Vec::new();
    for (teeth, module, distance) in [
        ([44, 44], 3.0, 132.1),
        ([86, 21], 3.0, 160.55),
        ([12, 60], 2.0, 72.05),
        ([44, 44], 3.0, 131.9),
        ([30, 20], 1.0, 26.0),
        ([17, 17], 0.01, 0.1705),
        ([20, 30], 1000.0, 25_000.03),
        ([10_000, 9_999], 1.0, 9_999.6),
    ] {
        for locked in [Member::Wheel, Member::Pinion] {
            let pair = pair(teeth, module, distance, locked);
            for (flank, fraction) in [
                (Side::Right, 0.0),
                (Side::Left, 0.0),
                (Side::Right, 0.37),
                (Side::Left, -0.21),
            ] {
                let posed = Posed::new(pair.clone(), teeth, flank, fraction);
                let locked = locked.name();
                let name = format!("{teeth:?} a {distance} {locked} {flank:?} {fraction}");
                pictures.push((name, posed.draw()));
            }
        }
    }
    let far = pair([44, 44], 3.0, 137.0, Member::Wheel);
    let mut far = Posed::new(far, [1, 44], Side::Left, 0.0);
    far.found.right = None;
    pictures.push(("one contact".into(), far.draw()));
    far.found.left = None;
    pictures.push(("no contact".into(), far.draw()));
    let near = pair([20, 20], 3.0, 58.5, Member::Wheel);
    let near = Posed::new(near, [1, 1], Side::Right, 0.0);
    pictures.push(("jammed".into(), near.draw()));
    let solved = all().into_iter().chain([nominal()]);
    pictures.extend(solved.map(|posed| (posed.title.into(), posed.draw())));
    pictures
});

/// Where the gears are shown.
const MAIN_VIEW: Room = [30.0, 142.0, 610.0, 730.0];

/// Plain readers understand it, and every text is on the sheet, off every other text, and clear of the lines and frames round it.
pub fn check(name: &str, svg: &str) {
    check_plain(name, svg);
    assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("\"-0.00"));
    let picture = Picture::of(svg);
    let areas = picture.areas.iter().filter(|area| !area.stroke.is_empty());
    let frames: Vec<Room> = areas.map(|area| area.room).collect();
    let sheet = [0.0, 0.0, 1188.0, 840.0];
    for (i, text) in picture.texts.iter().enumerate() {
        let (text, room) = (&text.content, &text.room);
        assert!(within(room, &sheet), "{name}: {text} leaves the sheet");
        for other in &picture.texts[..i] {
            let on = &other.content;
            assert!(!overlap(room, &other.room), "{name}: {text} on {on}");
        }
        // Text inside a frame must clear every line, text outside every frame.
        if frames.iter().any(|frame| within(room, frame)) {
            let lines = picture.lines.iter();
            let seen = lines.filter(|line| !line.turns || within(room, &MAIN_VIEW));
            let mut segments = seen.flat_map(|line| line.points.windows(2));
            let hit = segments.find(|ends| meets([ends[0], ends[1]], room));
            assert!(hit.is_none(), "{name}: {text} at {room:?} on {hit:?}");
        }
        let mut frames = frames.iter();
        let hit = frames.find(|frame| !within(room, frame) && overlap(room, frame));
        assert!(hit.is_none(), "{name}: {text} across {hit:?}");
    }
}

const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Elements that more readers understand than browsers do.
const PLAIN: &str =
    "svg g defs path rect circle text tspan use clipPath pattern title animate animateTransform";

/// No picture has features that plain readers of SVG lack. Inkscape 1.2 showed no gears, since it takes `<use>` by XLink's `href` alone.
/// LibreOffice 7.4 showed the whole pinion as overlap, since it neither clips by a `<use>` nor clips one.
fn check_plain(name: &str, svg: &str) {
    let document = Document::parse(svg).unwrap();
    for node in document.descendants().filter(Node::is_element) {
        let tag = node.tag_name().name();
        let is_plain = PLAIN.split(' ').any(|plain| plain == tag);
        assert!(is_plain, "{name}: {tag}");
        for lacking in "href style class paint-order dominant-baseline mask".split(' ') {
            let mut plain = node.attributes().filter(|one| one.namespace().is_none());
            let has = plain.any(|one| one.name() == lacking);
            assert!(!has, "{name}: {lacking} of {tag}");
        }
        let within = |above: &str| node.ancestors().any(|node| node.has_tag_name(above));
        if tag == "use" {
            let target = node.attribute((XLINK, "href")).unwrap();
            let target = target.strip_prefix('#').unwrap();
            let mut nodes = document.descendants();
            let is_there = nodes.any(|node| node.attribute("id") == Some(target));
            assert!(is_there, "{name}: {target}");
            assert!(!within("clipPath"), "{name}: clipped by a use of {target}");
            let is_whole = !node.has_attribute("clip-path");
            assert!(is_whole, "{name}: a use of {target} clipped");
        }
        // Each tspan of an anchored text goes to the text's own place.
        if tag == "tspan" {
            let mut above = node.ancestors();
            let text = above.find(|node| node.has_tag_name("text")).unwrap();
            let is_anchored = text.has_attribute("text-anchor");
            assert!(!is_anchored, "{name}: {:?}", text.text());
        }
    }
}

/// Labels keep clear, contacts are in view and as many as there are, and both mating teeth have their number.
#[test]
fn every_picture_is_whole() {
    for (name, svg) in PICTURES.iter() {
        check(name, svg);
        // The legend shows one filled and two open.
        let dots = Picture::of(svg).dots;
        let main = dots
            .iter()
            .filter(|dot| dot.radius == 4.0 && dot.centre[1] < 740.0);
        let (open, filled): (Vec<_>, Vec<_>) = main.partition(|dot| dot.fill == "white");
        for dot in open.iter().chain(&filled) {
            let [x, y] = dot.centre;
            let is_seen = within(&[x, y, x, y], &MAIN_VIEW);
            assert!(is_seen, "{name}: contact at {x} {y}");
        }
        let expected = match name.as_str() {
            "no contact" => (0, 0),
            "one contact" => (1, 0),
            "jammed" | "jammed 86/21" => (0, 4),
            _ => (1, 2),
        };
        assert_eq!((filled.len(), open.len()), expected, "{name}");
        let bold = svg.matches("font-weight=\"bold\" text-anchor=\"middle\"");
        assert_eq!(bold.count(), 2, "{name}");
    }
}

/// The gap of an inset, measured between its open dots: the chord of the free gear's turn `φ_j`
/// at the contact's radius, times the scale that is written beside the bar.
#[test]
fn a_gap_is_true_to_scale_and_wide_enough_to_see() {
    for distance in [132.01, 132.03, 132.1, 132.21, 133.0, 131.95] {
        let posed = rig(distance);
        let picture = Picture::of(&posed.draw());
        let is_open = |radius: f64, fill: &str| radius == 5.0 && fill == "white";
        let dots = picture.dots.iter();
        let open: Vec<_> = dots.filter(|dot| is_open(dot.radius, &dot.fill)).collect();
        assert_eq!(open.len(), 2);
        let [[x, y], other] = [open[0].centre, open[1].centre];
        let separation = (x - other[0]).hypot(y - other[1]);
        let mut frames = picture.areas.iter().filter(|area| area.room[0] > 600.0);
        let frame = frames.find(|area| within(&[x, y, x, y], &area.room));
        let below = frame.unwrap().room[3];
        let mut texts = picture
            .texts
            .iter()
            .filter(|text| text.content.ends_with(" : 1"));
        let bar = texts.find(|text| {
            text.room[0] > 600.0 && text.room[3] > below && text.room[3] < below + 30.0
        });
        let scale = bar
            .unwrap()
            .content
            .split(['·', ':'])
            .nth(1)
            .unwrap()
            .trim();
        let scale: f64 = scale.parse().unwrap();
        let left = posed.found.left.unwrap();
        let radius = (left.point - posed.pair.axis(Member::Pinion)).norm();
        let base = posed.pair.gear(Member::Pinion).gear().base_radius();
        let phi_j = j_bn(&posed.pair) / base;
        let expected = 2.0 * radius * (0.5 * phi_j).sin().abs() * 4.0 * scale;
        // Two coordinates, each to 0.005.
        let off = (separation - expected).abs();
        assert!(off < 0.02, "{distance}: {separation} {expected}");
        // At least 9 mm of paper, for j_bn from 7 µm on.
        assert!(separation >= 35.0, "{distance}: {separation}");
    }
}

#[test]
fn any_title_fits_and_stays_xml() {
    let posed = rig(132.1);
    for title in [
        "",
        "a < b & \"c\" > ]]> \u{0}\u{b} j_wt",
        &"歯車 Getriebe ".repeat(40),
    ] {
        let svg = snapshot(&Snapshot {
            title,
            ..posed.view()
        });
        let first = &Picture::of(&svg).texts[0];
        assert!(first.room[2] <= 1158.0, "{}", first.content);
        let own = title.replace(char::is_control, " ");
        assert!(title.len() > 100 || first.content == own.trim());
    }
}
