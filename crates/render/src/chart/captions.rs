//! Captions, axes and legends shared by several charts.

use super::panel::{Entry, Look, Mark, Panel, Swatch};
use crate::kit::{Anchor, Axis};
use gearlash::analysis::curves::{Course, CourseLine};
use gearlash::analysis::requirement::{Quantity, Requirements};
use gearlash::contact::Status;
use gearlash::pair::BacklashUnit;
use gearlash_text::characters::listed;
use gearlash_text::numbers::{rounded, shortest, stated_distance};

pub(super) fn course_axis(course: &Course) -> Axis {
    let name = match course.teeth {
        Some(_) => "wheel tooth at the pitch point",
        None => "pitches from the first pose",
    };
    Axis::of_teeth(name, course.span, course.teeth)
}

pub(super) fn backlash_axis(unit: BacklashUnit, range: [f64; 2]) -> Axis {
    let name = match unit {
        BacklashUnit::Um => "circumferential backlash j_wt, µm".to_owned(),
        BacklashUnit::Arcmin { at, .. } => format!("lost motion at the {}, arcmin", at.name()),
    };
    Axis::new(&name, range)
}

pub(super) fn course_caption(course: &Course) -> String {
    let over = match course.teeth {
        Some(teeth) if course.span[1] - course.span[0] >= f64::from(teeth) => {
            "one wheel revolution".to_owned()
        }
        _ => format!("{} pitches", course.span[1] - course.span[0]),
    };
    let phase = match course.phase {
        Some((wheel, pinion)) => format!(" · phase {wheel}·{pinion}"),
        None => String::new(),
    };
    format!(
        "a = {} mm · {over} from mating {}·{} on{phase}",
        stated_distance(course.center_distance),
        course.start.0,
        course.start.1
    )
}

/// The zero line, and the shaded area below it where the axis reaches there. Its name is placed away from `busy`, a place on x.
pub(super) fn interference(panel: &mut Panel, busy: f64) {
    let ([left, right], [low, high]) = (panel.x.range, panel.y.range);
    let (corner, shift, anchor) = if busy < 0.5 * (left + right) {
        (right, -8.0, Anchor::End)
    } else {
        (left, 8.0, Anchor::Start)
    };
    if low >= 0.0 {
        return;
    }
    panel.marks.insert(0, Mark::Ground(0.0));
    if high > 0.0 {
        let zero = Mark::level(panel.x.range, 0.0, Look::Plain, 1.0);
        panel.marks.push(zero);
    }
    let name = Mark::text([corner, low], [shift, -10.0], "interference", anchor);
    panel.marks.push(name);
}

/// Draws the limits of j_wt in what is `required`. The axis makes room for a limit within its own length; the returned words name
/// those beyond.
pub(super) fn draw_limits(
    panel: &mut Panel,
    unit: BacklashUnit,
    required: &Requirements,
) -> String {
    let ([x, _], [low, high]) = (panel.x.range, panel.y.range);
    let mut beyond = String::new();
    let of = Quantity::OperatingBacklash;
    let limits = required
        .iter()
        .find(|limits| limits.0 == of && unit == BacklashUnit::Um);
    let ends = limits.map_or([None; 2], |(_, limits)| [limits.min, limits.max]);
    for (word, shift, mm) in [("min", 10.0, ends[0]), ("max", -10.0, ends[1])] {
        let Some(mm) = mm else {
            continue;
        };
        let limit = rounded(1e3 * mm, 9);
        let words = format!("required {word} {} µm", shortest(limit));
        if f64::max(low - limit, limit - high) > high - low {
            beyond += &format!(" · {words}");
            continue;
        }
        let [y0, y1] = panel.y.range;
        panel.y.range = [y0.min(limit), y1.max(limit)];
        let line = Mark::level(panel.x.range, limit, Look::Limit, 1.2);
        let name = Mark::text([x, limit], [8.0, shift], words, Anchor::Start);
        panel.marks.extend([line, name]);
    }
    beyond
}

pub(super) fn entry(name: &str, look: Look, sample: Swatch) -> Entry {
    Entry {
        name: name.to_owned(),
        look,
        sample,
    }
}

/// A panel with the reason why it is empty.
pub(super) fn empty(x: Axis, words: &str) -> Panel {
    let middle = 0.5 * (x.range[0] + x.range[1]);
    let words = Mark::text([middle, 0.5], [0.0; 2], words, Anchor::Middle);
    Panel::new(x, Axis::bare([0.0, 1.0]), 130.0, vec![words])
}

/// The number of unproven poses, at the start of a caption, where it is never cut off; empty where all are proven.
pub(super) fn unproven_note(poses: usize) -> String {
    match poses {
        0 => String::new(),
        1 => "1 pose unproven, not drawn · ".to_owned(),
        poses => format!("{poses} poses unproven, not drawn · "),
    }
}

pub(super) fn unproven_of<'a>(lines: impl Iterator<Item = &'a CourseLine>) -> usize {
    let points = lines.flat_map(|line| &line.points);
    let unproven = points.filter(|point| point.status == Status::Unproven);
    unproven.count()
}

/// The reason for no backlash, for poses with these statuses.
pub(super) fn without_value(statuses: impl Iterator<Item = Status>) -> String {
    let found: Vec<Status> = statuses.collect();
    let named = [
        (Status::Jammed, "jammed"),
        (Status::NoContact, "out of mesh"),
        (Status::Unproven, "unproven"),
    ];
    let named = named.iter().filter(|(status, _)| found.contains(status));
    let named: Vec<String> = named.map(|(_, name)| (*name).to_owned()).collect();
    match &named[..] {
        [] => "jammed or out of mesh".to_owned(),
        named => listed(named, "or"),
    }
}
