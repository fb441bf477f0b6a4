//! The field of action: contact lines over the common face, the gap of each section alone, and the leads of the teeth that bind.

use super::captions::entry;
use super::panel::{Look, Mark, Panel, Point, Swatch, range};
use super::sheet::{self, Chart, Heading};
use crate::kit::{Anchor, Axis, TextStyle};
use crate::pose_name::{flank_heading, pose_name};
use gearlash::analysis::curves::{ContactLine, Field, FieldSection, FieldSide, PathLimit};
use gearlash::analysis::study::Material;
use gearlash::contact::{ContactKind, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash_text::numbers::{stated_distance, trimmed, um};

/// Heights of a field and of the curve below it.
const HEIGHTS: [f64; 2] = [270.0, 150.0];
/// Widths of a contact line, and of the binding one.
const WIDTHS: [f64; 2] = [1.4, 3.6];
/// Opacity of a stretch in which a fillet touches.
const SHADE: f64 = 0.2;
/// Share of the face before its end in which a label is before its line.
const LABEL_BEFORE: f64 = 0.2;
const LABEL_OFFSET: f64 = 6.0;
/// Approximate width of a plot, and the style of its labels: the room for them.
const FIELD_WIDTH: f64 = 704.0;
const LABEL: TextStyle = TextStyle::new(12.0);
/// A line shorter than this, mm along the face, is drawn as a point.
const SHORT: f64 = 0.01;
/// Most stretches listed in words.
const NAMED: usize = 2;
const ALONG: &str = "axial position z, mm, away from the viewer";
/// Gaps below this, µm, count as none.
const NO_GAP_UM: f64 = 5e-3;
/// Least height of the curve of gaps, µm, above its rounding.
const LEAST_UM: f64 = 1.0;
const LEADS_HEIGHT: f64 = 150.0;
/// Number of shades of contact points, and the opacity at the greatest gap.
const SHADES: usize = 8;
const PALEST: f64 = 0.12;
/// Half the height of a line of contact points, as a share of the axis.
const HALF_POINT: f64 = 0.012;

/// The [`field`] at `pose` of a pair, that with the least backlash; `None` for a pose without contact lines.
pub fn field_at_least(
    title: &str,
    material: Material,
    assembly: &AssembledPair,
    pose: &PoseResult,
) -> Option<Chart> {
    let found = assembly.data().and_then(|pair| Field::of(pair, pose));
    let subtitle = format!(
        "Field of action at the least backlash · a = {} mm · {}",
        stated_distance(assembly.center_distance()),
        material.words()
    );
    let heading = Heading::alone(title, &subtitle);
    found.map(|found| field(&heading, &found))
}

/// The field of action. Each side has its contact lines, and below them the transverse gap of each section.
pub fn field(heading: &Heading, field: &Field) -> Chart {
    let x = range(field.face.into_iter(), [0.0; 2], 1e-3).unwrap_or(field.face);
    let sides = &field.sides;
    let varies = sides.iter().any(varies);
    let panels: Vec<Panel> = if varies {
        let lines = sides.iter().map(|side| lines(side, x));
        let leads = sides.iter().filter_map(|side| leads(side, x));
        let [right, left] = sides;
        let title = "Room over the face: transverse gap of each section";
        let room = gaps(&[right, left], x).titled(title);
        lines.chain([room]).chain(leads).collect()
    } else {
        let each = sides.iter();
        each.flat_map(|side| [lines(side, x), gaps(&[side], x)])
            .collect()
    };
    let words = if varies {
        [
            "contact points of right flanks",
            "of left flanks (pale: a gap is left)",
        ]
    } else {
        [
            "contact lines of right flanks",
            "of left flanks (bold: the pair that binds)",
        ]
    };
    let mut entries = vec![
        entry(words[0], Look::Right, Swatch::Line),
        entry(words[1], Look::Left, Swatch::Line),
        entry("end of the path of contact", Look::Limit, Swatch::Line),
    ];
    if sides.iter().any(|side| leads(side, x).is_some()) {
        entries.push(entry("lead of the wheel", Look::Plain, Swatch::Line));
        entries.push(entry("of the pinion", Look::Third, Swatch::Line));
        let name = "their sum, in the colour of the flanks";
        entries.push(entry(name, Look::Right, Swatch::Line));
    }
    let point = |side: &FieldSide| binding_line(side).is_none();
    if field.sides.iter().any(point) {
        entries.push(entry("where it binds", Look::Plain, Swatch::Dot));
    }
    if field.sides.iter().any(|side| !side.fillets.is_empty()) {
        let name = "fillet, root or undercut edge touched first";
        entries.push(entry(name, Look::Third, Swatch::Band(SHADE)));
    }
    let pose = pose_name(field.pose.mating());
    let details = format!("{pose} · by each line: teeth, transverse gap");
    sheet::draw(heading, &details, &entries, &panels)
}

fn side_look(side: Side) -> Look {
    match side {
        Side::Right => Look::Right,
        Side::Left => Look::Left,
    }
}

fn lines(side: &FieldSide, x: [f64; 2]) -> Panel {
    let lines = side.lines.iter();
    let ends = lines.flat_map(|line| line.ends.map(|end| end[1]));
    let places = ends.chain(side.path).chain([side.binding.place]);
    let y = range(places, [0.1; 2], 1e-3).unwrap_or([-1.0, 1.0]);
    let mut marks = shades(side);
    for (limit, at) in side.limits.into_iter().zip(side.path) {
        marks.push(Mark::level(x, at, Look::Limit, 1.0));
        let shift = [-4.0, if at == side.path[0] { 11.0 } else { -11.0 }];
        marks.push(Mark::text([x[1], at], shift, name(limit), Anchor::End));
    }
    let most = side.lines.iter().flat_map(|line| &line.points);
    let most = most.fold(LEAST_UM * 1e-3, |most, point| most.max(point[2]));
    for line in &side.lines {
        if line.points.is_empty() {
            let points: Vec<Point> = line.ends.map(|[z, place]| (z, Some(place))).to_vec();
            let width = WIDTHS[usize::from(line.binds)];
            marks.push(Mark::Line(points, side_look(side.side), width));
        } else {
            marks.extend(shaded(line, side.side, most, HALF_POINT * (y[1] - y[0])));
        }
        marks.extend(label(line, side, x));
    }
    let binding = &side.binding;
    marks.extend(binding_point(side, binding.place));
    let title = format!(
        "{} flanks: wheel {} on pinion {} binds {}",
        flank_heading(side.side),
        binding.wheel_tooth,
        binding.pinion_tooth,
        binding_words(side)
    );
    let y = Axis::new("on the path of contact, mm", y);
    Panel::new(Axis::new("", x), y, HEIGHTS[0], marks).titled(title)
}

/// Whether gaps vary along contact lines.
fn varies(side: &FieldSide) -> bool {
    side.lines.iter().any(|line| !line.points.is_empty())
}

/// The contact points of a line, paler where a gap is left; `most` is the palest gap, mm.
fn shaded(line: &ContactLine, side: Side, most: f64, half: f64) -> Vec<Mark> {
    let shade = |point: &[f64; 3]| ((point[2] / most).sqrt() * SHADES as f64).round();
    let mut marks = Vec::new();
    let mut from = 0;
    for to in 1..line.points.len() {
        let is_last = to + 1 == line.points.len();
        if is_last || shade(&line.points[to]) != shade(&line.points[from]) {
            let points = &line.points[from..=to];
            let edge = |off: f64| points.iter().map(|p| (p[0], Some(p[1] + off))).collect();
            let part = shade(&line.points[from]) / SHADES as f64;
            let opacity = 1.0 - (1.0 - PALEST) * part;
            let edges = [edge(-half), edge(half)];
            marks.push(Mark::Band(edges, side_look(side), opacity));
            from = to;
        }
    }
    marks
}

/// The leads of the teeth that bind on one side, and their sum; `None` without leads.
fn leads(side: &FieldSide, x: [f64; 2]) -> Option<Panel> {
    let [wheel, pinion] = &side.leads;
    let curve = |lead: &[(f64, f64)]| -> Vec<Point> {
        lead.iter().map(|&(z, mm)| (z, Some(1e3 * mm))).collect()
    };
    let sum: Vec<(f64, f64)> = (wheel.iter().zip(pinion))
        .map(|(wheel, pinion)| (wheel.0, wheel.1 + pinion.1))
        .collect();
    let all = [wheel, pinion, &sum];
    let values = all.into_iter().flatten().map(|point| 1e3 * point.1);
    let y = range(values, [0.1; 2], LEAST_UM)?;
    let mut marks = vec![Mark::level(x, 0.0, Look::Limit, 0.8)];
    marks.push(Mark::Line(curve(wheel), Look::Plain, 1.0));
    marks.push(Mark::Line(curve(pinion), Look::Third, 1.4));
    marks.push(Mark::Line(curve(&sum), side_look(side.side), 2.0));
    let binding = &side.binding;
    let (wheel, pinion) = (binding.wheel_tooth, binding.pinion_tooth);
    let flanks = side.side.name();
    let title =
        format!("Leads of the {flanks} flanks of wheel {wheel} and pinion {pinion}, and their sum");
    let y = Axis::new("more material, µm", y);
    Some(Panel::new(Axis::new(ALONG, x), y, LEADS_HEIGHT, marks).titled(title))
}

/// The ends along the face of the binding contact line. Only involutes touch along a line, over the whole of theirs.
fn binding_line(side: &FieldSide) -> Option<[f64; 2]> {
    let binds = |line: &&ContactLine| line.binds && line.points.is_empty();
    let line = side.lines.iter().find(binds);
    let ends = line?.ends.map(|end| end[0]);
    let is_line = side.binding.kind == ContactKind::Involute && ends[1] - ends[0] > SHORT;
    is_line.then_some(ends)
}

/// The point at which a pair binds off its line.
fn binding_point(side: &FieldSide, place: f64) -> Option<Mark> {
    binding_line(side)
        .is_none()
        .then(|| Mark::Dots(vec![(side.binding.section, Some(place))], Look::Plain))
}

fn binding_words(side: &FieldSide) -> String {
    let binding = &side.binding;
    let mut words = match binding_line(side) {
        Some(ends) => format!("along its line, z = {} mm", stretch(ends)),
        None => format!(
            "at z = {} mm, {}",
            trimmed(binding.section, 0, 3),
            binding.kind.name()
        ),
    };
    // All pairs do so between perfect involutes.
    if binding.kind == ContactKind::Involute && touching(side) > 1 {
        words += &format!("; {} pairs touch at once", touching(side));
    }
    words
}

fn stretch(ends: [f64; 2]) -> String {
    let [from, to] = ends.map(|end| trimmed(end, 0, 2));
    format!("{from} … {to}")
}

fn touching(side: &FieldSide) -> usize {
    let gap = |line: &&ContactLine| line.gap * 1e3 <= NO_GAP_UM;
    side.lines.iter().filter(gap).count()
}

/// The teeth of a line and the gap between them, beside its middle; `None` where the next line is too near.
fn label(line: &ContactLine, side: &FieldSide, [from, to]: [f64; 2]) -> Option<Mark> {
    let [one, other] = line.ends;
    let middle = [0, 1].map(|i| 0.5 * (one[i] + other[i]));
    let teeth = format!("{}·{}", line.wheel_tooth, line.pinion_tooth);
    let with_gap = if line.gap * 1e3 > NO_GAP_UM {
        format!("{teeth}, {} µm", um(line.gap, 2))
    } else {
        teeth.clone()
    };
    let room = spacing(side).map(|mm| mm / (to - from) * FIELD_WIDTH);
    let fits =
        |text: &String| room.is_none_or(|room| LABEL.width(text) + 2.0 * LABEL_OFFSET < room);
    let text = [with_gap, teeth].into_iter().find(fits)?;
    let part = (middle[0] - from) / (to - from);
    let before = part > 1.0 - LABEL_BEFORE;
    // A rising line has room below on its right and above on its left.
    let below = (side_slope(side) > 0.0) != before;
    let sign = |yes| if yes { 1.0 } else { -1.0 };
    let shift = [sign(!before) * LABEL_OFFSET, sign(below) * 9.0];
    let anchor = if before { Anchor::End } else { Anchor::Start };
    Some(Mark::text(middle, shift, text, anchor))
}

/// Slope of the lines; 0 where lines are too short for one.
fn side_slope(side: &FieldSide) -> f64 {
    let slopes = side.lines.iter().map(|line| {
        let [one, other] = line.ends;
        (other[1] - one[1]) / (other[0] - one[0])
    });
    let finite = slopes.filter(|slope| slope.is_finite());
    finite.fold(0.0, |most: f64, slope| {
        if slope.abs() > most.abs() {
            slope
        } else {
            most
        }
    })
}

/// Distance of neighbouring lines along the face, mm; `None` for a single line.
fn spacing(side: &FieldSide) -> Option<f64> {
    let slope = side_slope(side);
    let feet = side.lines.iter().map(|line| line.ends[0]);
    let mut feet: Vec<f64> = feet.map(|[x, y]| x - y / slope).collect();
    feet.sort_unstable_by(f64::total_cmp);
    let apart = feet.windows(2).map(|pair| pair[1] - pair[0]);
    apart.filter(|mm| mm.is_finite()).reduce(f64::min)
}

/// The gap of each section on these sides.
fn gaps(sides: &[&FieldSide], x: [f64; 2]) -> Panel {
    let value = |section: &FieldSection| section.gap.map(|gap| gap * 1e3);
    let all = sides.iter().flat_map(|side| &side.sections);
    let y = range(all.filter_map(value).chain([0.0]), [0.08; 2], LEAST_UM);
    let y = y.unwrap_or([0.0, LEAST_UM]);
    let mut marks: Vec<Mark> = sides.iter().flat_map(|side| shades(side)).collect();
    for side in sides {
        let points = side.sections.iter().map(|s| (s.at, value(s)));
        marks.push(Mark::Line(points.collect(), side_look(side.side), 1.6));
        marks.extend(binding_point(side, 0.0));
    }
    let fillets: String = sides.iter().map(|side| fillets(side)).collect();
    let title = format!("Transverse gap of each section, the gears in contact{fillets}");
    let y = Axis::new("transverse gap, µm", y);
    Panel::new(Axis::new(ALONG, x), y, HEIGHTS[1], marks).titled(title)
}

/// The stretches where fillets touch first, in words.
fn fillets(side: &FieldSide) -> String {
    let stretches = side.fillets.iter().map(|&ends| stretch(ends));
    let stretches: Vec<String> = stretches.take(NAMED).collect();
    let more = if side.fillets.len() > NAMED {
        " and more"
    } else {
        ""
    };
    if stretches.is_empty() {
        String::new()
    } else {
        format!("; shaded: z = {} mm{more}", stretches.join(", "))
    }
}

/// The stretches where a fillet touches first.
fn shades(side: &FieldSide) -> Vec<Mark> {
    let shade = |x: [f64; 2]| Mark::Shade(x, Look::Third, SHADE);
    side.fillets.iter().copied().map(shade).collect()
}

fn name(limit: PathLimit) -> String {
    match limit {
        PathLimit::Tip(member) => format!("tip circle of the {}", member.name()),
        PathLimit::Form(member) => format!("form circle of the {}", member.name()),
    }
}
