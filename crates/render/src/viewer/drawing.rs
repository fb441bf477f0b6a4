//! The SVG of one pose; the script moves its parts.
//!
//! Coordinates are mm in the picture frame, with y up by a flip of the outermost group. A gear's group turns about its axis; the
//! outline in it is displaced by the eccentricity.

use super::columns::{free_rotation, outline_of};
use super::marks::{axis, circle, line, marks, numbers};
use super::precision::{Precision, degrees};
use super::section::{Winding, first};
use crate::kit::{INK, OVERLAP, PINION, WHEEL};
use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::gear::Side;
use gearlash::outline::{AssembledPair, PlacedGear};
use gearlash::pair::Member;
use gearlash_files::numbers::rounded;
use std::fmt::Write;
use svg::node::element::{ClipPath, Definitions, Group, Path, SVG, Use};

/// Width over height of the picture.
const ASPECT: f64 = 1.25;
/// Half the height shown first, modules: more than one and a half pitches, as in a snapshot.
const HALF_HEIGHT: f64 = 5.0;
/// Margin round whole gears, modules.
const BORDER: f64 = 2.0;

/// The picture of `pose` in `run`.
pub fn draw(
    outlines: &[&AssembledPair],
    run: &ComparedRun,
    pose: &ComparedPose,
    precision: Precision,
) -> String {
    let assembly = &run.run.assembly;
    let module = assembly.module();
    let turn = |member: Member| {
        let turned = if member == assembly.locked() {
            degrees(pose.simulated.pose.locked_rotation())
        } else {
            degrees(free_rotation(&pose.simulated))
        };
        format!("translate({} 0) rotate({turned})", assembly.axis(member).x)
    };
    let own = outline_of(outlines, run);
    let section = first(assembly, &pose.simulated);
    let metal = |member: Member| {
        Use::new()
            .set("href", format!("#viewer-{}-{own}", member.name()))
            .set("data-outline", member.name())
    };
    let gear = |(member, fill): (Member, &str)| {
        let outline = metal(member).set("fill", fill).set("stroke", INK);
        let placed = PlacedGear::new(assembly, member, 0.0);
        Group::new()
            .set("id", format!("viewer-{}", member.name()))
            .set("transform", turn(member))
            .add(outline.set("stroke-width", "1.3"))
            .add(axis(module))
            .add(numbers(&placed, member, module, section, precision))
    };
    let overlap = Group::new().set("clip-path", "url(#viewer-clip)").add(
        Group::new()
            .set("id", "viewer-overlap")
            .set("transform", turn(Member::Pinion))
            .add(metal(Member::Pinion).set("fill", OVERLAP)),
    );
    let clip = metal(Member::Wheel)
        .set("id", "viewer-clip-shape")
        .set("transform", turn(Member::Wheel));
    // Unlimited dashes: a view 0.02 mm wide would have millions. The script cuts both lines to the visible part.
    let centres = line()
        .set("id", "viewer-centres")
        .set("d", format!("M0 0H{}", assembly.center_distance()))
        .set("stroke-dasharray", "22 4 2 4 2 4");
    let pitch_circle = |member: Member| {
        let radius = assembly.operating_pitch_radius(member);
        line()
            .set("id", format!("viewer-pitch-{}", member.name()))
            .set(
                "transform",
                format!("translate({} 0)", assembly.axis(member).x),
            )
            .set("d", circle(rounded(radius, precision.decimals)))
            .set("stroke-dasharray", "14 3 2 3")
    };
    let gears = [(Member::Wheel, WHEEL), (Member::Pinion, PINION)].map(gear);
    let picture = Group::new().set("transform", "scale(1 -1)");
    let picture = gears.into_iter().fold(picture, Group::add);
    let picture = picture.add(overlap).add(centres);
    let circles = Member::BOTH.map(pitch_circle).into_iter();
    let picture = circles.fold(picture, Group::add);
    let marks = Side::BOTH.map(|side| marks(assembly, pose, side, precision));
    let picture = marks.into_iter().fold(picture, Group::add);
    let [home, whole] = views(assembly, module);
    let definitions = definitions(outlines, section, precision)
        .add(ClipPath::new().set("id", "viewer-clip").add(clip));
    let sheet = SVG::new()
        .set("id", "viewer-picture")
        .set("viewBox", home.as_str())
        .set("data-home", home)
        .set("data-whole", whole)
        .set("data-narrowest", rounded(precision.narrowest(), 6))
        .set("role", "img")
        .set("aria-label", "Both gears in mesh")
        .set("font-family", "sans-serif")
        .add(definitions)
        .add(picture);
    format!("{sheet}\n")
}

/// The outlines, `viewer-wheel-0` and so on; for helical gears in a section.
fn definitions(
    outlines: &[&AssembledPair],
    section: Option<f64>,
    precision: Precision,
) -> Definitions {
    let gears = outlines.iter().enumerate().flat_map(|(number, pair)| {
        let both = Member::BOTH.into_iter();
        both.map(move |member| (number, member, *pair))
    });
    gears.fold(Definitions::new(), |definitions, (number, member, pair)| {
        let placed = PlacedGear::new(pair, member, 0.0);
        let scale = format!("scale({})", precision.unit());
        let wound = section.map(|at| Winding::new(&placed, member, at, precision.decimals));
        let outline = match wound {
            None => Path::new().set("transform", scale),
            Some(wound) => Path::new()
                .set(
                    "transform",
                    format!("rotate({} {}) {scale}", wound.turned, wound.centre()),
                )
                .set("data-winds", wound.name)
                .set("data-centre", wound.centre())
                .set("data-then", scale),
        };
        definitions.add(
            outline
                .set("id", format!("viewer-{}-{number}", member.name()))
                .set("vector-effect", "non-scaling-stroke")
                .set("stroke-linejoin", "round")
                .set("d", path(&placed, pair.gear_reach(member), precision)),
        )
    })
}

/// The `viewBox` of the mesh zone and of the whole gears.
fn views(assembly: &AssembledPair, module: f64) -> [String; 2] {
    let a = assembly.center_distance();
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear_reach(member));
    let view = |middle: f64, half_width: f64, half_height: f64| {
        let half_height = f64::max(half_height, half_width / ASPECT);
        let half_width = half_height * ASPECT;
        let [x, y, width, height] = [
            middle - half_width,
            -half_height,
            2.0 * half_width,
            2.0 * half_height,
        ]
        .map(|v| rounded(v, 4));
        format!("{x} {y} {width} {height}")
    };
    let border = BORDER * module;
    [
        view(0.5 * (wheel + a - pinion), 0.0, HALF_HEIGHT * module),
        view(
            0.5 * (a + pinion - wheel),
            0.5 * (a + wheel + pinion) + border,
            f64::max(wheel, pinion) + border,
        ),
    ]
}

/// The whole outline about its axis, displaced by its eccentricity: relative path data in units of the last decimal.
///
/// Whole numbers stay exact: browsers add single-precision numbers, which hold 24 bits.
fn path(gear: &PlacedGear, reach: f64, precision: Precision) -> String {
    // A disc about the axis, at least as large as the gear, contains its centre and thus all teeth.
    let mut data = String::new();
    let mut last: Option<[i64; 2]> = None;
    for point in gear.outline_near(gear.axis(), reach, precision.chord) {
        let point = point - gear.axis();
        let [x, y] = [point.x, point.y].map(|value| precision.units(value));
        let _ = match last {
            None => write!(data, "M{x} {y}l"),
            Some(before) if before == [x, y] => Ok(()),
            Some([left, low]) => {
                let [dx, dy] = [x - left, y - low];
                // A minus sign separates two numbers as a space does.
                let separator = if data.ends_with('l') || dx < 0 {
                    ""
                } else {
                    " "
                };
                let between = if dy < 0 { "" } else { " " };
                write!(data, "{separator}{dx}{between}{dy}")
            }
        };
        last = Some([x, y]);
    }
    data.push('z');
    data
}
