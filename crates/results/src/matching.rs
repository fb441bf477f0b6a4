//! The result of a matching: the pairs, and every wheel with every pinion.

use crate::column::{Row, Value, json_text, list, row_type, shown};
use crate::layout::Screen;
use gearlash::matching::{Expected, PairFit};
use gearlash_input::matching::MatchResult;
use gearlash_text::characters::plain;
use gearlash_text::numbers::{fixed, stated_distance, um_ascii};
use serde_json::json;

/// A wheel with a pinion in its best phase.
pub(crate) struct AssignmentRow {
    wheel: String,
    pinion: String,
    found: PairFit,
    is_assigned: bool,
    /// Whether the pair has several assembly phases, so that teeth must be marked.
    has_phases: bool,
}

impl AssignmentRow {
    /// The tooth to mark on the wheel.
    fn wheel_tooth(&self) -> u32 {
        1
    }

    /// The teeth to mark on wheel and pinion; none in a pair with one assembly phase.
    fn marks(&self) -> Value {
        let teeth = || format!("{} · {}", self.wheel_tooth(), self.found.best.pinion_tooth);
        Value::optional(self.has_phases.then(teeth))
    }
}

row_type!(row: AssignmentRow {
    "wheel" Plain [heading(shown("wheel").left())] => row.wheel.clone();
    "pinion" Plain [heading(shown("pinion").left())] => row.pinion.clone();
    "wheel_tooth" Plain [no_csv] => row.wheel_tooth();
    "pinion_tooth" Plain => row.found.best.pinion_tooth;
    "" Plain [heading(shown("teeth to mark").left())] => row.marks();
    "least_um" Fixed(2) [heading(shown("least µm"))] => Value::um(row.found.best.outcome.least);
    "greatest_um" Fixed(2) [heading(shown("greatest µm"))] => Value::um(row.found.best.outcome.greatest);
    "" Plain [csv("status")] => row.found.best.outcome.kind.name();
    "" Plain [csv("phases_meeting")] => row.found.phases_that_meet;
    "" Plain [csv("assigned")] => u32::from(row.is_assigned);
});

/// A wheel with a pinion by their places; `None` where they were not tried.
fn row(result: &MatchResult, [wheel, pinion]: [usize; 2]) -> Option<AssignmentRow> {
    Some(AssignmentRow {
        wheel: result.names[0][wheel].clone(),
        pinion: result.names[1][pinion].clone(),
        found: *result.matrix.pair_fit(wheel, pinion)?,
        has_phases: result.matrix.phases() > 1,
        is_assigned: result.places.binary_search(&(wheel, pinion)).is_ok(),
    })
}

/// Every wheel with every pinion, wheel by wheel.
fn rows(result: &MatchResult) -> impl Iterator<Item = AssignmentRow> {
    let [wheels, pinions] = [0, 1].map(|kind| result.names[kind].len());
    let places = (0..wheels).flat_map(move |wheel| (0..pinions).map(move |pinion| [wheel, pinion]));
    places.filter_map(|places| row(result, places))
}

/// The pair of `rows` nearest to the limits, and how far beyond them it is, mm; `None` where it meets them, or these are of another quantity alone.
fn nearest(
    result: &MatchResult,
    rows: impl Iterator<Item = AssignmentRow>,
) -> Option<(AssignmentRow, f64)> {
    let [min, max] = match result.limits {
        [None, None] if result.others.is_empty() => [Some(0.0), None],
        limits => limits,
    };
    let missed = |row: AssignmentRow| {
        let outcome = row.found.best.outcome;
        let below = min.and_then(|min| Some(min - outcome.least?));
        let above = max.and_then(|max| Some(outcome.greatest? - max));
        let beyond = below.into_iter().chain(above).reduce(f64::max)?;
        Some((row, beyond))
    };
    let each = rows.filter_map(missed);
    let nearest = each.min_by(|one, other| one.1.total_cmp(&other.1));
    nearest.filter(|(_, beyond)| *beyond > 0.0)
}

/// Gears left over whose nearest mate is named.
const MOST_REASONS: usize = 10;

/// The gear `name`, left over of a `kind` (0: wheels), with its nearest mate.
fn left_over(result: &MatchResult, kind: usize, name: &str) -> String {
    let place = result.names[kind].iter().position(|one| one == name);
    let mates = 0..result.names[1 - kind].len();
    let rows = mates.filter_map(|mate| {
        let mut places = [mate; 2];
        places[kind] = place?;
        row(result, places)
    });
    let rows: Vec<AssignmentRow> = rows.collect();
    let mate = |row: &AssignmentRow| plain([&row.pinion, &row.wheel][kind]);
    let reason = if let Some(row) = rows.iter().find(|row| row.found.best.meets) {
        format!(" (fits {}, which has another mate)", mate(row))
    } else {
        nearest(result, rows.into_iter()).map_or(String::new(), |(row, beyond)| {
            let outcome = row.found.best.outcome;
            format!(
                " ({} to {} µm with {}, {} µm beyond the limits)",
                um_ascii(outcome.least, 2),
                um_ascii(outcome.greatest, 2),
                mate(&row),
                um_ascii(beyond, 2)
            )
        })
    };
    plain(name) + &reason
}

/// The pairs of the assignment.
fn pairs(result: &MatchResult) -> Vec<AssignmentRow> {
    rows(result).filter(|row| row.is_assigned).collect()
}

/// The result as JSON with a line end; lengths in µm.
pub fn json(result: &MatchResult) -> String {
    let um = |mm: Option<f64>| mm.map(|mm| 1e3 * mm);
    let expected = |expected: Expected| json!({ "any_phase": expected.any_phase, "best_phase": expected.best_phase });
    json_text(&json!({
        "gearlash": env!("CARGO_PKG_VERSION"),
        "title": result.title,
        "text": result.sentence(),
        "require_um": { "min": um(result.limits[0]), "max": um(result.limits[1]) },
        "require_others": result.others,
        "wanted_um": 1e3 * result.wanted,
        "phases": result.matrix.phases(),
        "pairs": list(&pairs(result)),
        "best": result.is_best,
        "left_over": { "wheels": result.left_over[0], "pinions": result.left_over[1] },
        "expected_pairs": {
            "random": expected(result.at_random),
            "thickness_classes": result.by_classes.map(|(count, classes)| json!({
                "classes": count, "any_phase": classes.any_phase, "best_phase": classes.best_phase,
            })),
        },
    }))
}

/// Every wheel with every pinion in its best phase as CSV.
pub fn csv(result: &MatchResult) -> String {
    let rows: Vec<AssignmentRow> = rows(result).collect();
    AssignmentRow::columns().csv(&rows)
}

/// The result for a terminal: the sentence, the pairs with the teeth to mark, the unpaired gears.
pub fn text(result: &MatchResult, screen: &Screen) -> String {
    let mut text = screen.paragraphs(&format!("{}.", result.sentence()));
    text.push('\n');
    let pairs = pairs(result);
    let has_phases = result.matrix.phases() > 1;
    if !pairs.is_empty() {
        text += &AssignmentRow::columns().text(&pairs, screen);
        text += &screen.fold(if has_phases {
            "Mark these teeth. Their right flanks meet.\n"
        } else {
            "No teeth to mark: the tooth numbers have no common divisor.\n"
        });
    }
    if result.clearance > 0.0 {
        text += &screen.fold(&format!(
            "Least and greatest include the bearing clearance: a ± {} mm.\n",
            stated_distance(result.clearance)
        ));
    }
    if pairs.is_empty()
        && let Some((row, beyond)) = nearest(result, rows(result))
    {
        let outcome = row.found.best.outcome;
        text += &screen.fold(&format!(
            "Nearest: wheel {} with pinion {}, least {} µm, greatest {} µm, {} µm beyond the limits.\n",
            plain(&row.wheel),
            plain(&row.pinion),
            um_ascii(outcome.least, 2),
            um_ascii(outcome.greatest, 2),
            um_ascii(beyond, 2)
        ));
    }
    text += &screen.fold(&format!(
        "Target of the backlash: {} µm (--target-um sets another).\n",
        fixed(1e3 * result.wanted, 2)
    ));
    for (kind, names) in result.left_over.iter().enumerate() {
        if !names.is_empty() {
            let each = names.iter().enumerate().map(|(k, name)| match k {
                ..MOST_REASONS => left_over(result, kind, name),
                _ => plain(name),
            });
            let names: Vec<String> = each.collect();
            text.push('\n');
            let kind = ["Wheels", "Pinions"][kind];
            text += &screen.fold(&format!("{kind} left over: {}.\n", names.join(", ")));
        }
    }
    if has_phases {
        text.push('\n');
        text += &screen.fold(&format!(
            "At random, {} pairs are to be expected if the best teeth are marked.\n",
            fixed(result.at_random.best_phase, 1)
        ));
    }
    text
}
