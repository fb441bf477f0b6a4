//! The field of action of helical gears: contact lines over the common face, and what each section would allow alone.

use super::paint::Look;
use super::panel::{Entry, Mark, Panel, Point, Sample, range};
use super::sheet::{self, Chart, Heading, PictureError};
use crate::kit::{Anchor, Axis};
use crate::pose_name::pose_name;
use gearlash::analysis::curves::{ContactLine, Field, FieldSection, FieldSide, PathLimit};
use gearlash::contact::ContactKind;
use gearlash::gear::Side;
use gearlash_files::numbers::{trimmed, um};

/// Heights of a field and of the curve below it.
const HEIGHTS: [f64; 2] = [270.0, 150.0];
/// Widths of a contact line, and of that which binds.
const WIDTHS: [f64; 2] = [1.4, 3.6];
/// How dark a stretch is in which a fillet is touched.
const SHADE: f64 = 0.2;
/// Part of the face beside an end in which a label grows away from it.
const BESIDE: f64 = 0.12;
/// Less than this, µm, is no gap.
const NO_GAP_UM: f64 = 5e-3;
/// Least height of the curve of gaps, µm: rounding is no curve.
const LEAST_UM: f64 = 1.0;

/// The field of action: of each side its contact lines, and below the gap each section would leave.
///
/// # Errors
/// [`PictureError`] without a face.
pub fn field(heading: &Heading, field: &Field) -> Result<Chart, PictureError> {
    let Some(x) = range(field.face.into_iter(), [0.0; 2], 1e-3) else {
        return Err(PictureError("there is no common face".to_owned()));
    };
    let panels: Vec<Panel> = field
        .sides
        .iter()
        .flat_map(|side| [lines(side, x), gaps(side, x)])
        .collect();
    let entry = |name: &str, look, sample| Entry {
        name: name.to_owned(),
        look,
        sample,
    };
    let mut entries = vec![
        entry("contact lines of right flanks", Look::Right, Sample::Line),
        entry(
            "of left flanks (bold: the pair that binds)",
            Look::Left,
            Sample::Line,
        ),
        entry("where it binds", Look::Plain, Sample::Dot),
        entry("end of the path of contact", Look::Limit, Sample::Line),
    ];
    if field.sides.iter().any(|side| !fillets(side).is_empty()) {
        entries.push(entry(
            "a fillet is touched first",
            Look::Third,
            Sample::Band(SHADE),
        ));
    }
    let details = format!(
        "{} · at each line: wheel·pinion tooth, gap left",
        pose_name(field.pose.mating())
    );
    sheet::draw(heading, &details, &entries, &panels)
}

fn look(side: Side) -> Look {
    match side {
        Side::Right => Look::Right,
        Side::Left => Look::Left,
    }
}

/// The contact lines of one side.
fn lines(side: &FieldSide, x: [f64; 2]) -> Panel {
    let ends = side
        .lines
        .iter()
        .flat_map(|line| line.ends.map(|end| end[1]));
    let places = ends.chain(side.path).chain([side.binding.place]);
    let y = range(places, [0.1; 2], 1e-3).unwrap_or([-1.0, 1.0]);
    let mut marks = shades(side, y);
    for (limit, at) in side.limits.into_iter().zip(side.path) {
        marks.push(Mark::Line {
            points: x.map(|x| (x, Some(at))).to_vec(),
            look: Look::Limit,
            width: 1.0,
        });
        marks.push(Mark::Text {
            at: [x[1], at],
            shift: [-4.0, if at == side.path[0] { 9.0 } else { -9.0 }],
            text: name(limit),
            anchor: Anchor::End,
        });
    }
    for line in &side.lines {
        let points: Vec<Point> = line.ends.map(|[z, place]| (z, Some(place))).to_vec();
        marks.push(Mark::Line {
            points,
            look: look(side.side),
            width: WIDTHS[usize::from(line.binds)],
        });
        marks.push(label(line, x));
    }
    let binding = &side.binding;
    marks.push(Mark::Dots {
        points: vec![(binding.section, Some(binding.place))],
        look: Look::Plain,
    });
    Panel {
        title: format!(
            "{} flanks: wheel {} on pinion {} binds at z = {} mm, {}",
            match side.side {
                Side::Right => "Right",
                Side::Left => "Left",
            },
            binding.wheel_tooth,
            binding.pinion_tooth,
            trimmed(binding.section, 0, 3),
            match binding.kind {
                // As all pairs do between perfect involutes.
                ContactKind::Involute if touching(side) > 1 =>
                    format!("as do {} pairs at once", touching(side)),
                kind => kind.name().to_owned(),
            }
        ),
        x: Axis::new("", x),
        y: Axis::new("on the path of contact, mm", y),
        height: HEIGHTS[0],
        marks,
    }
}

/// How many pairs touch.
fn touching(side: &FieldSide) -> usize {
    let gap = |line: &&ContactLine| line.gap * 1e3 <= NO_GAP_UM;
    side.lines.iter().filter(gap).count()
}

/// The teeth of a line and the gap between them, beside its middle.
fn label(line: &ContactLine, [from, to]: [f64; 2]) -> Mark {
    let [one, other] = line.ends;
    let middle = [0, 1].map(|i| 0.5 * (one[i] + other[i]));
    let part = (middle[0] - from) / (to - from);
    let anchor = match part {
        part if part < BESIDE => Anchor::Start,
        part if part > 1.0 - BESIDE => Anchor::End,
        _ => Anchor::Middle,
    };
    let gap = match line.gap * 1e3 > NO_GAP_UM {
        true => format!(", {} µm", um(line.gap, 2)),
        false => String::new(),
    };
    Mark::Text {
        at: middle,
        shift: [0.0, -9.0],
        text: format!("{}·{}{gap}", line.wheel_tooth, line.pinion_tooth),
        anchor,
    }
}

/// What each section would leave.
fn gaps(side: &FieldSide, x: [f64; 2]) -> Panel {
    let value = |section: &FieldSection| section.gap.map(|gap| gap * 1e3);
    let y = range(
        side.sections.iter().filter_map(value).chain([0.0]),
        [0.08; 2],
        LEAST_UM,
    );
    let y = y.unwrap_or([0.0, LEAST_UM]);
    let mut marks = shades(side, y);
    marks.push(Mark::Line {
        points: side.sections.iter().map(|s| (s.at, value(s))).collect(),
        look: look(side.side),
        width: 1.6,
    });
    marks.push(Mark::Dots {
        points: vec![(side.binding.section, Some(0.0))],
        look: Look::Plain,
    });
    Panel {
        title: "Gap that each section has when the gears are in contact, along the line of action"
            .to_owned(),
        x: Axis::new(
            "axial position z, mm from the measuring plane, away from the viewer",
            x,
        ),
        y: Axis::new("gap, µm", y),
        height: HEIGHTS[1],
        marks,
    }
}

/// The stretches of the face in which a fillet or a root is touched before any involute.
fn fillets(side: &FieldSide) -> Vec<[f64; 2]> {
    let sections = &side.sections;
    let touches = |section: &FieldSection| section.kind.is_some_and(|kind| kind.is_non_involute());
    sections
        .chunk_by(|a, b| touches(a) == touches(b))
        .filter_map(|run| Some((run.first()?, run.last()?)))
        .filter(|(first, _)| touches(first))
        .map(|(first, last)| [first.at, last.at])
        .collect()
}

fn shades(side: &FieldSide, y: [f64; 2]) -> Vec<Mark> {
    let band = |stretch: [f64; 2]| {
        let level = |at: f64| stretch.map(|z| (z, Some(at))).to_vec();
        Mark::Band {
            low: level(y[0]),
            high: level(y[1]),
            look: Look::Third,
            opacity: SHADE,
        }
    };
    fillets(side).into_iter().map(band).collect()
}

fn name(limit: PathLimit) -> String {
    match limit {
        PathLimit::Tip(member) => format!("tip circle of the {}", member.name()),
        PathLimit::Form(member) => format!("form circle of the {}", member.name()),
    }
}
