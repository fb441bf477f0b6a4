//! The deviations of both gears, enlarged until they are visible, over the ghosts of perfect teeth.

use super::caption;
use super::labels::tooth_numbers;
use super::subject::{INSETS, MAIN, Snapshot, names};
use super::view::{MARGIN, View, mesh_view};
use crate::kit::{
    Frame, HEIGHT, INK, Ids, OVERLAP, Occupied, PINION, Spot, TextStyle, WHEEL, WIDTH, area,
    blank_sheet, clip, clipped, dashed, define_area, define_frame, inner_outline, line, number,
    polygon,
};
use gearlash::contact::Exaggeration;
use gearlash::gear::Placed;
use gearlash::pair::{Member, Pose};
use gearlash_text::numbers::{rounded, um};
use svg::node::element::{Group, Path};

const GHOST_DASH: &str = "5 3";
/// Teeth narrower than this on the sheet are drawn as circles only.
const LEAST_TOOTH: f64 = 4.0;

/// The SVG text of `view`'s gears, with the enlarged deviations of `gears`.
pub fn exaggerated(view: &Snapshot, gears: &Exaggeration) -> String {
    let scene = view.scene();
    let main = mesh_view(&scene, MAIN);
    let mut occupied = Occupied::default();
    let mesh = mesh(view, gears, &main, &mut occupied);
    let mating = view.drawn_pose().mating();
    let ([wheel_numbers, pinion_numbers], _) = tooth_numbers(&scene, &main, mating, &mut occupied);
    let mut sheet = blank_sheet(WIDTH, HEIGHT)
        .add(caption::heading(view, MAIN.left, WIDTH - 2.0 * MAIN.left))
        .add(warning(gears))
        .add(names(&scene, &MAIN))
        .add(mesh)
        .add(MAIN.border())
        .add(wheel_numbers)
        .add(pinion_numbers);
    for (member, frame) in Member::BOTH.into_iter().zip(INSETS) {
        sheet = sheet.add(whole_gear(view.drawn_pose(), gears, member, frame));
    }
    let modified = Member::BOTH.map(|member| gears.found(member).profile.is_some());
    format!("{}\n", sheet.add(legend(modified.contains(&true))))
}

fn warning(gears: &Exaggeration) -> Group {
    let words = format!(
        "deviations × {}: not to scale · gears at their nominal rotation, not in contact",
        gears.factor()
    );
    let style = TextStyle::new(16.0).bold().colour("#a32014");
    Group::new().add(style.text(&words, [MAIN.left, 97.0]))
}

/// The mesh zone: metal as exaggerated, perfect outlines dashed over it.
fn mesh(view: &Snapshot, gears: &Exaggeration, main: &View, occupied: &mut Occupied) -> Group {
    let wide = main.frame.grown(MARGIN);
    let outline = |placed: &Placed| -> Vec<Spot> {
        let points = Exaggeration::outline_near(placed, main.middle, main.reach(), main.chord());
        clip::polygon(&main.spots(&points), &wide)
    };
    let ids = Ids::default();
    let mut definitions = define_frame(&ids, "mesh-frame", &main.frame);
    let mut metal = Group::new();
    let mut ghosts = Group::new();
    for (member, fill) in Member::BOTH.into_iter().zip([WHEEL, PINION]) {
        let [drawn, perfect] = gears.placed(view.drawn_pose(), member);
        let (polygon, ghost) = (outline(&drawn), outline(&perfect));
        occupied.line(&polygon);
        occupied.line(&ghost);
        let name = member.name();
        definitions = define_area(definitions, &ids, name, &polygon);
        let filled = area(&ids, name).set("fill", fill);
        metal = metal
            .add(filled.set("fill-opacity", "0.8"))
            .add(inner_outline(&ids, name, INK, "2.40"));
        ghosts = ghosts.add(ghost_line(&ghost, 1.2));
    }
    clipped(&ids, "mesh-frame")
        .add(definitions)
        .add(metal)
        .add(ghosts)
}

fn ghost_line(points: &[Spot], width: f64) -> Path {
    polygon(points, "none")
        .set("stroke", OVERLAP)
        .set("stroke-width", number(width))
        .set("stroke-dasharray", GHOST_DASH)
}

/// A whole gear on the left of `frame`, its deviations on the right.
fn whole_gear(pose: &Pose, gears: &Exaggeration, member: Member, frame: Frame) -> Group {
    let tooth = pose.mating().tooth(member);
    let [drawn, perfect] = gears.placed(pose, member);
    let right = frame.left + frame.height();
    let square = Frame { right, ..frame };
    let gear = perfect.as_built().gear();
    let reach = gear.tip_radius() + drawn.as_built().eccentricity();
    let scale = 0.5 * (square.height() - 16.0) / reach;
    let seen = View {
        frame: square,
        middle: drawn.axis(),
        scale,
    };
    let name = member.name();
    let fill = match member {
        Member::Wheel => WHEEL,
        Member::Pinion => PINION,
    };
    let title = TextStyle::new(16.0).bold();
    let title = title.text(&format!("the whole {name}"), [frame.left, frame.top - 9.0]);
    let mut group = Group::new().add(title).add(frame.border());
    for (placed, is_ghost) in [(&drawn, false), (&perfect, true)] {
        let tooth = gear.basic_data().angular_pitch() * gear.tip_radius() * scale;
        let rings = if tooth < LEAST_TOOTH {
            let circles = [gear.tip_radius(), gear.root_radius()];
            let circles = circles.map(|radius| seen.arc(placed.centre(), radius));
            circles.to_vec()
        } else {
            let points = Exaggeration::outline_near(placed, placed.centre(), reach, seen.chord());
            vec![seen.spots(&points)]
        };
        for ring in rings {
            group = group.add(if is_ghost {
                ghost_line(&ring, 0.7)
            } else {
                let metal = polygon(&ring, fill).set("stroke", INK);
                metal.set("stroke-width", "0.90")
            });
        }
    }
    for (centre, arm, colour) in [(perfect.centre(), 9.0, OVERLAP), (drawn.centre(), 6.0, INK)] {
        let [x, y] = seen.spot(centre);
        group = group
            .add(line(&[[x - arm, y], [x + arm, y]], colour, 1.4))
            .add(line(&[[x, y - arm], [x, y + arm]], colour, 1.4));
    }
    let found = gears.found(member);
    let (eccentricity, high) = found.eccentricity;
    let flanks = gears.flanks_of(member, tooth);
    let [size, towards] = if eccentricity > 0.0 {
        let size = format!("eccentricity {} µm", um(eccentricity, 2));
        [size, format!("towards tooth {}", rounded(high, 2))]
    } else {
        ["no eccentricity".to_owned(), String::new()]
    };
    let [right_um, left_um] = flanks.map(|mm| um(mm, 2));
    let rows = [
        size,
        towards,
        "flank deviations, µm".to_owned(),
        "(reference circle, + more metal):".to_owned(),
        match found.flanks.map(|mm| um(mm, 2)) {
            [least, most] if least == most => format!("all teeth {least}"),
            [least, most] => format!("all teeth {least} … {most}"),
        },
        format!("tooth {tooth}: right {right_um}, left {left_um}"),
    ];
    let profile = found.profile.map(|ends| {
        let [least, most] = ends.map(|mm| um(mm, 2));
        format!("profile deviations {least} … {most} µm")
    });
    let (left, room) = (square.right + 8.0, frame.right - square.right - 16.0);
    let tops = [48.0, 70.0, 118.0, 138.0, 160.0, 182.0, 222.0];
    for (row, top) in rows.iter().chain(&profile).zip(tops) {
        let style = TextStyle::new(13.0).fitted(row, room, 0.0);
        group = group.add(style.text(row, [left, frame.top + top]));
    }
    group
}

fn legend(modified: bool) -> Group {
    let [x, y] = [MAIN.left, 772.0];
    let ghost = [[x + 390.0, y], [x + 426.0, y]];
    let mut group = Group::new()
        .add(line(&[[x, y], [x + 36.0, y]], INK, 2.4))
        .add(dashed(&ghost, OVERLAP, 1.2, GHOST_DASH));
    let perfect = "perfect teeth of nominal thickness, without eccentricity";
    for (words, left) in [("outline, its deviations enlarged", 44.0), (perfect, 434.0)] {
        group = group.add(TextStyle::new(13.0).text(words, [x + left, y + 4.5]));
    }
    let note = if modified {
        "centre distance and rotations are to scale; where the flanks stand and how their profiles deviate is not"
    } else {
        "centre distance, rotations and the shape of each flank are to scale; where the flanks stand is not"
    };
    group.add(TextStyle::new(13.0).grey().text(note, [x, y + 29.5]))
}
