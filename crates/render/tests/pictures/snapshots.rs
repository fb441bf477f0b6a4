//! The contact snapshot and the scene it is drawn from.

mod animated;
mod closed_form;
#[path = "../../../../tests/common/design.rs"]
mod design;
mod exaggerated;
mod picture;
mod readers;
mod scene;
mod solved;

use closed_form::{j_bn, lost_motion, pair, pose};
use gearlash::contact::{LostMotion, ToothPlace};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member, Pose};
use gearlash_render::{Snapshot, snapshot};
use nalgebra::{Point2, Vector2};
use picture::{meets, overlap, read, within};
use std::sync::LazyLock;

fn draw(assembly: &GearPair, pose: &Pose, lost_motion: &LostMotion) -> String {
    snapshot(&Snapshot {
        title: "Closed form",
        assembly: &assembly.clone().into(),
        pose,
        material: gearlash::analysis::study::Material::Most,
        found: Ok(lost_motion),
        section: None,
    })
}

/// Named pictures of every kind: clear, interfering, wide open, out of mesh, jammed; small,
/// large, many-toothed; either gear locked.
static PICTURES: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    let mut pictures = Vec::new();
    let pairs = [
        ([44, 44], 3.0, 132.1),
        ([86, 21], 3.0, 160.55),
        ([12, 60], 2.0, 72.05),
        ([44, 44], 3.0, 131.9),
        ([30, 20], 1.0, 26.0),
        ([17, 17], 0.01, 0.1705),
        ([20, 30], 1000.0, 25_000.03),
        ([10_000, 9_999], 1.0, 9_999.6),
    ];
    for (teeth, module, distance) in pairs {
        for locked in [Member::Wheel, Member::Pinion] {
            let assembly = pair(teeth, module, distance, locked);
            for (flank, fraction) in [
                (Side::Right, 0.0),
                (Side::Left, 0.0),
                (Side::Right, 0.37),
                (Side::Left, -0.21),
            ] {
                let pose = pose(&assembly, teeth, flank, fraction);
                let svg = draw(&assembly, &pose, &lost_motion(&assembly, &pose));
                let name = format!(
                    "{teeth:?} a {distance} {} {flank:?} {fraction}",
                    locked.name()
                );
                pictures.push((name, svg));
            }
        }
    }
    let assembly = pair([44, 44], 3.0, 138.5, Member::Wheel);
    let at = pose(&assembly, [1, 44], Side::Left, 0.0);
    let mut none = LostMotion {
        right: None,
        left: None,
        solid: false,
    };
    pictures.push(("no contact".into(), draw(&assembly, &at, &none)));
    none.left = lost_motion(&assembly, &at).left;
    pictures.push(("one contact".into(), draw(&assembly, &at, &none)));
    let (assembly, at, lost) = jammed();
    pictures.push(("jammed".into(), draw(&assembly, &at, &lost)));
    let solved = solved::all();
    pictures.extend(
        solved
            .iter()
            .map(|solved| (solved.name.into(), solved.draw())),
    );
    pictures
});

/// 0.75 mm too near: pinion tips in wheel roots. The contacts are made up, on the wheel's root circle.
fn jammed() -> (GearPair, Pose, LostMotion) {
    let assembly = pair([20, 20], 3.0, 58.5, Member::Wheel);
    let at = pose(&assembly, [1, 1], Side::Right, 0.0);
    let LostMotion { right, left, .. } = lost_motion(&assembly, &at);
    let made_up = |contact: Option<gearlash::contact::Contact>, turn: f64| {
        let mut contact = contact.unwrap();
        contact.rotation = at.free_rotation() + turn;
        contact.wheel.curve = ToothPlace::Root;
        contact.pinion.curve = ToothPlace::Tip;
        contact.point = Point2::new(26.2, -30.0 * turn);
        contact.normal = Vector2::x();
        Some(contact)
    };
    let lost = LostMotion {
        right: made_up(right, 0.06),
        left: made_up(left, -0.06),
        solid: false,
    };
    (assembly, at, lost)
}

/// Plain readers understand it, and every text is on the sheet, off every other text, and clear of the lines and frames round it.
fn check_labels(name: &str, svg: &str) {
    readers::check(name, svg);
    let picture = read(svg);
    let sheet = [0.0, 0.0, 1188.0, 840.0];
    for (i, (text, room)) in picture.texts.iter().enumerate() {
        assert!(within(room, &sheet), "{name}: {text} leaves the sheet");
        for (other, its_room) in &picture.texts[..i] {
            assert!(!overlap(room, its_room), "{name}: {text} on {other}");
        }
        // Text inside a frame must clear every line, text outside every frame.
        let inside = picture.frames.iter().any(|frame| within(room, frame));
        let in_view = |line: &&[[f64; 2]; 2]| inside && meets(line, room);
        let mut lines = picture.lines.iter().chain(
            picture
                .turning
                .iter()
                .filter(|_| within(room, &[30.0, 142.0, 610.0, 730.0])),
        );
        let hit = lines.find(in_view);
        assert!(hit.is_none(), "{name}: {text} at {room:?} on {hit:?}");
        let outside = |frame: &&[f64; 4]| !within(room, frame) && overlap(room, frame);
        let hit = picture.frames.iter().find(outside);
        assert!(hit.is_none(), "{name}: {text} across {hit:?}");
    }
}

#[test]
fn labels_keep_clear_of_each_other_and_of_the_drawing() {
    for (name, svg) in PICTURES.iter() {
        check_labels(name, svg);
    }
}

#[test]
fn contacts_are_in_view_and_as_many_as_there_are() {
    for (name, svg) in PICTURES.iter() {
        let dots = read(svg).dots;
        // The legend shows one filled and two open.
        let main: Vec<_> = dots
            .iter()
            .filter(|dot| dot.1 == 4.0 && dot.0[1] < 740.0)
            .collect();
        for ([x, y], ..) in &main {
            let seen = (30.0..=610.0).contains(x) && (142.0..=730.0).contains(y);
            assert!(seen, "{name}: contact at {x} {y}");
        }
        let expected = match name.as_str() {
            "no contact" => (0, 0),
            "one contact" => (1, 0),
            "jammed" | "jammed 86/21" => (0, 4),
            _ => (1, 2),
        };
        let filled = main.iter().filter(|dot| dot.2).count();
        assert_eq!((filled, main.len() - filled), expected, "{name}");
    }
}

#[test]
fn both_mating_teeth_have_their_number() {
    for (name, svg) in PICTURES.iter() {
        let bold = svg
            .matches("font-weight=\"bold\" text-anchor=\"middle\"")
            .count();
        assert_eq!(bold, 2, "{name}");
    }
}

/// The gap of an inset, measured between its open dots: the chord of the free gear's turn `φ_j`
/// at the contact's radius, times the scale that is written beside the bar.
#[test]
fn a_gap_is_true_to_scale_and_wide_enough_to_see() {
    for distance in [132.01, 132.03, 132.1, 132.21, 133.0, 131.95] {
        let assembly = pair([44, 44], 3.0, distance, Member::Wheel);
        let at = pose(&assembly, [11, 11], Side::Right, 0.0);
        let lost = lost_motion(&assembly, &at);
        let svg = draw(&assembly, &at, &lost);
        let picture = read(&svg);
        let open: Vec<_> = picture
            .dots
            .iter()
            .filter(|dot| dot.1 == 5.0 && !dot.2)
            .collect();
        assert_eq!(open.len(), 2);
        let separation = (open[0].0[0] - open[1].0[0]).hypot(open[0].0[1] - open[1].0[1]);
        let frame = picture
            .frames
            .iter()
            .find(|frame| within(&dot_box(open[0].0), frame) && frame[0] > 600.0);
        let below = frame.unwrap()[3];
        let scale = picture
            .texts
            .iter()
            .filter(|(text, _)| text.ends_with(" : 1"))
            .find(|(_, room)| room[0] > 600.0 && room[3] > below && room[3] < below + 30.0)
            .map(|(text, _)| {
                text.split(['·', ':'])
                    .nth(1)
                    .unwrap()
                    .trim()
                    .parse::<f64>()
                    .unwrap()
            })
            .unwrap();
        let left = lost.left.unwrap();
        let radius = (left.point - assembly.axis(Member::Pinion)).norm();
        let phi_j = j_bn(&assembly) / assembly.gear(Member::Pinion).gear().base_radius();
        let expected = 2.0 * radius * (0.5 * phi_j).sin().abs() * 4.0 * scale;
        // Two coordinates, each to 0.005.
        assert!(
            (separation - expected).abs() < 0.02,
            "{distance}: {separation} {expected}"
        );
        // At least 9 mm of paper, for j_bn from 7 µm on.
        assert!(separation >= 35.0, "{distance}: {separation}");
    }
}

fn dot_box([x, y]: [f64; 2]) -> [f64; 4] {
    [x, y, x, y]
}

#[test]
fn the_caption_names_the_outcome() {
    let expected = [
        (
            "[44, 44] a 132.1 wheel Right 0",
            "jwt= 73.06 µm (error ≤ … µm) · clear · drawn with the pinion turned clockwise to right-flank contact",
        ),
        (
            "[44, 44] a 131.9 pinion Left 0",
            "jwt= −72.53 µm (error ≤ … µm) · interference · drawn with the wheel turned counter-clockwise to left-flank contact",
        ),
        (
            "[86, 21] a 160.55 wheel Left -0.21",
            "wheel 86 with pinion 21 at the left flank, 0.21 pitch before · centre distance 160.550 mm · most material",
        ),
        (
            "jammed",
            "jammed: a tip sits in a root · drawn with the pinion at its nominal rotation",
        ),
        (
            "no contact",
            "no contact: out of mesh · drawn with the pinion at its nominal rotation",
        ),
    ];
    for (name, line) in expected {
        let (_, svg) = PICTURES.iter().find(|(other, _)| other == name).unwrap();
        let texts = read(svg).texts;
        let without_bound = |text: &str| match text.split_once("≤ ") {
            Some((before, after)) => {
                let (_, after) = after.split_once(" µm)").unwrap();
                format!("{before}≤ … µm){after}")
            }
            None => text.to_owned(),
        };
        assert!(
            texts.iter().any(|(text, _)| without_bound(text) == line),
            "{name}: {texts:?}"
        );
    }
}

#[test]
fn the_same_pose_gives_the_same_bytes() {
    let assembly = pair([44, 44], 3.0, 132.1, Member::Wheel);
    let at = pose(&assembly, [11, 11], Side::Right, 0.0);
    let lost = lost_motion(&assembly, &at);
    let first = draw(&assembly, &at, &lost);
    let elsewhere =
        std::thread::scope(|scope| scope.spawn(|| draw(&assembly, &at, &lost)).join().unwrap());
    assert_eq!(first, elsewhere);
    assert!(!first.contains("-0.00"));
    assert!(!first.contains("NaN") && !first.contains("inf"));
}

#[test]
fn any_title_fits_and_stays_xml() {
    let assembly = pair([44, 44], 3.0, 132.1, Member::Wheel);
    let at = pose(&assembly, [11, 11], Side::Right, 0.0);
    let lost = lost_motion(&assembly, &at);
    for title in [
        "",
        "a < b & \"c\" > ]]> \u{0}\u{b} j_wt",
        &"歯車 Getriebe ".repeat(40),
    ] {
        let svg = snapshot(&Snapshot {
            title,
            assembly: &assembly.clone().into(),
            pose: &at,
            material: gearlash::analysis::study::Material::Most,
            found: Ok(&lost),
            section: None,
        });
        let (first, room) = &read(&svg).texts[0];
        assert!(room[2] <= 1158.0, "{first}");
        assert!(title.len() > 100 || *first == title.replace(char::is_control, " ").trim());
    }
}

#[test]
fn a_small_pair_as_svg() {
    let assembly = pair([17, 12], 2.0, 29.1, Member::Wheel);
    let at = pose(&assembly, [3, 5], Side::Right, 0.0);
    insta::assert_snapshot!(draw(&assembly, &at, &lost_motion(&assembly, &at)));
}

#[test]
fn a_small_interference_as_svg() {
    let assembly = pair([17, 12], 2.0, 28.9, Member::Wheel);
    let at = pose(&assembly, [3, 5], Side::Right, 0.0);
    let solved = solved::Solved::new("Tight", assembly, at);
    insta::assert_snapshot!(solved.draw());
}
