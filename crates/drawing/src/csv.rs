//! A list of points: x and y per line, in order along a closed outline. A third column z must have one value.

use super::chain::DrawnPath;
use super::error::LONGEST_NAME;
use super::limits::MAX_SEGMENTS;
use super::pieces::Pieces;
use super::text::decode;
use super::{DrawingError, Options, Unit};
use gearlash::outline::PathSegment;
use gearlash_text::characters::cut;
use gearlash_text::file_numbers::{Decimal, FileNumber, number};
use nalgebra::{Point2, Vector2};

const TWO_NUMBERS: &str =
    "write x and y, or x, y and one z, separated by a comma, a semicolon, a tab or blanks";
const TABLES: &str = "; `gearlash import` reads tables of measurements";

struct Row<'a> {
    line: usize,
    numbers: [FileNumber<'a>; 2],
}

/// The unit of a list, and where it is stated.
type Stated = Option<(Unit, usize)>;

/// Adds the outline to `pieces`.
pub fn read(bytes: &[u8], options: &Options, pieces: &mut Pieces) -> Result<(), DrawingError> {
    let text = decode(bytes)?;
    let (rows, stated) = rows(&text)?;
    one_decimal_sign(&rows)?;
    let stated = stated.map(|(unit, line)| (format!("\"{unit}\" in line {line}"), unit.mm()));
    let scale = options.unit_mm(stated, "no line `# unit: mm` in the list")?;
    pieces.unit_mm = scale;
    let mut points: Vec<Point2<f64>> = Vec::with_capacity(rows.len());
    for row in &rows {
        let [x, y] = row.numbers.map(|number| number.value * scale);
        let point = Point2::new(x, y);
        if points.last() == Some(&point) {
            pieces.leave_out("repeated point", &format!("line {}", row.line))
        } else {
            points.push(point)
        }
    }
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        let count = points.len();
        let reason = format!("{count} different points, expected at least three");
        return Err(DrawingError::no_loop(reason));
    }
    let repeat = options.repeat.as_ref();
    let part = repeat.is_some_and(|one| one.is_part(&points));
    if part && options.smooth {
        let kind = "one tooth with kind = \"smooth\"";
        let help = "draw all teeth, or leave `kind` out";
        return Err(DrawingError::refused("line 1", kind, help));
    }
    let next = points.iter().skip(1).chain(&points[..usize::from(!part)]);
    let segments = if options.smooth {
        closed_spline(&points)
    } else {
        let ends = points.iter().zip(next);
        ends.map(|(from, to)| PathSegment::Line([*from, *to]))
            .collect()
    };
    pieces.add(
        "",
        DrawnPath {
            segments,
            name: String::new(),
            bound_mm: 0.0,
            place: format!("line {}", rows[0].line),
        },
    )
}

/// The lines with numbers, and the unit by a comment or the header.
fn rows(text: &str) -> Result<(Vec<Row<'_>>, Stated), DrawingError> {
    let (mut rows, mut stated) = (Vec::new(), None);
    let (mut separator, mut header) = (None, false);
    let (mut columns, mut height) = (None, None);
    for (index, text) in text.split('\n').enumerate() {
        let (line, text) = (index + 1, text.trim());
        // A table of measurements fails before its first point.
        let more = if rows.is_empty() { TABLES } else { "" };
        let wrong = |reason: String| {
            let help = format!("{TWO_NUMBERS}{more}");
            Err(DrawingError::at(format!("line {line}"), reason, &help))
        };
        if let Some(comment) = text.strip_prefix('#') {
            if let Some(unit) = commented_unit(comment) {
                record_unit(&mut stated, unit, line)?;
            }
            continue;
        }
        if text.is_empty() {
            continue;
        }
        let mark = *separator.get_or_insert_with(|| mark_of(text));
        let cells: Vec<&str> = match mark {
            ' ' => text.split_whitespace().collect(),
            mark => text.split(mark).map(str::trim).collect(),
        };
        let expected = *columns.get_or_insert(if cells.len() == 3 { 3 } else { 2 });
        if cells.len() != expected {
            let words = if expected == 3 { "three" } else { "two" };
            return wrong(format!("{} columns, expected {words}", cells.len()));
        }
        let (x, y) = (cells[0], cells[1]);
        // Numbers of a third column are heights.
        let is_height = |z: &&&str| !rows.is_empty() || heading_unit(z, "z").is_none();
        let z = cells.get(2).filter(is_height);
        if rows.len() == MAX_SEGMENTS {
            return Err(DrawingError::too_large("points", MAX_SEGMENTS));
        }
        match (number(x), number(y)) {
            (Some(x), Some(y)) => rows.push(Row {
                line,
                numbers: [x, y],
            }),
            _ if rows.is_empty()
                && !header
                && heading_unit(x, "x").is_some()
                && heading_unit(y, "y").is_some() =>
            {
                header = true;
                for name in [heading_unit(x, "x"), heading_unit(y, "y")]
                    .into_iter()
                    .flatten()
                {
                    if !name.is_empty() {
                        record_unit(&mut stated, name, line)?;
                    }
                }
            }
            (x_number, _) => {
                let cell = if x_number.is_none() { x } else { y };
                return wrong(format!("\"{}\" is not a number", cut(cell, LONGEST_NAME)));
            }
        }
        if let Some(z) = z {
            let first = *height.get_or_insert(*z);
            let value = |text| number(text).map(|number| number.value);
            if value(z).is_none() {
                return wrong(format!("z \"{}\" is not a number", cut(z, LONGEST_NAME)));
            }
            if value(z) != value(first) {
                return wrong(format!(
                    "z is \"{}\", expected one number for all points, \"{}\" as before",
                    cut(z, LONGEST_NAME),
                    cut(first, LONGEST_NAME)
                ));
            }
        }
    }
    Ok((rows, stated))
}

/// The separator of the columns of a line.
fn mark_of(text: &str) -> char {
    let marks = [';', '\t', ','];
    let found = marks.into_iter().find(|mark| text.contains(*mark));
    // "1,5 2,5": commas within the numbers.
    let numbers = text.split_whitespace().all(|cell| number(cell).is_some());
    let blank = text.split_whitespace().count() > 1 && (numbers || found.is_none());
    found
        .filter(|_| !blank)
        .unwrap_or(if blank { ' ' } else { ',' })
}

/// The unit by a comment `unit: mm`, as written.
fn commented_unit(comment: &str) -> Option<&str> {
    let (key, unit) = comment.split_once([':', '='])?;
    matches!(key.trim(), "unit" | "units").then(|| unit.trim().trim_matches('"'))
}

/// The text of a heading behind `axis`, without its brackets: a unit or nothing; `None` for any other heading.
fn heading_unit<'a>(heading: &'a str, axis: &str) -> Option<&'a str> {
    let (first, rest) = heading.trim_matches('"').split_at_checked(1)?;
    let unit = rest.trim_matches([' ', '(', ')', '[', ']', '_']);
    (first.eq_ignore_ascii_case(axis) && (unit.is_empty() || Unit::from_name(unit).is_some()))
        .then_some(unit)
}

/// Takes the unit stated in `line`.
fn record_unit(stated: &mut Stated, name: &str, line: usize) -> Result<(), DrawingError> {
    let wrong = |reason: String| {
        let help = "state one unit: mm, inch, cm, m or um";
        Err(DrawingError::at(format!("line {line}"), reason, help))
    };
    let Some(unit) = Unit::from_name(name) else {
        return wrong(format!("unit \"{}\" is not known", cut(name, LONGEST_NAME)));
    };
    match stated {
        Some((before, first)) if *before != unit => wrong(format!(
            "unit \"{unit}\", in line {first} it is \"{before}\""
        )),
        _ => {
            stated.get_or_insert((unit, line));
            Ok(())
        }
    }
}

/// Refuses two decimal signs, and a comma or point that may as well separate thousands.
fn one_decimal_sign(rows: &[Row]) -> Result<(), DrawingError> {
    let numbers = || {
        rows.iter()
            .flat_map(|row| row.numbers.iter().map(move |number| (row.line, number)))
    };
    let mut signs =
        numbers().filter_map(|(line, number)| number.decimal.map(|sign| (line, number, sign)));
    let Some((line, first, sign)) = signs.next() else {
        return Ok(());
    };
    if let Some((line, number, other)) = signs.find(|(.., other)| *other != sign) {
        let reason = format!(
            "\"{}\" has a decimal {}, those before have a {}",
            cut(number.text, LONGEST_NAME),
            other.name(),
            sign.name()
        );
        let help = "write all numbers with one decimal sign and without thousands separators";
        return Err(DrawingError::at(format!("line {line}"), reason, help));
    }
    // A point is the decimal sign: every program that writes coordinates uses it.
    let unsure = sign == Decimal::Comma
        && numbers().all(|(_, number)| number.decimal.is_none() || number.may_be_thousands);
    if !unsure {
        return Ok(());
    }
    let text = cut(first.text, LONGEST_NAME);
    let reason = format!("\"{text}\" is ambiguous: decimal comma or thousands separator");
    let help = "write the numbers with a decimal point";
    Err(DrawingError::at(format!("line {line}"), reason, help))
}

/// The periodic cubic spline through `points`, at least three and each apart from the next, with the chord as parameter: the first
/// and second derivatives are continuous all around (de Boor: A Practical Guide to Splines, ch. IV).
fn closed_spline(points: &[Point2<f64>]) -> Vec<PathSegment> {
    let count = points.len();
    let chord = |index: usize| points[(index + 1) % count] - points[index % count];
    let lengths: Vec<f64> = (0..count).map(|index| chord(index).norm()).collect();
    // h_i m_{i−1} + 2 (h_{i−1} + h_i) m_i + h_{i−1} m_{i+1} = 3 (h_i d_{i−1} + h_{i−1} d_i), of the slopes m and d = chord/h.
    let rows: Vec<[f64; 3]> = (0..count)
        .map(|index| {
            let (before, here) = (lengths[(index + count - 1) % count], lengths[index]);
            [here, 2.0 * (before + here), before]
        })
        .collect();
    let right: Vec<Vector2<f64>> = (0..count)
        .map(|index| {
            let previous = (index + count - 1) % count;
            let (before, here) = (lengths[previous], lengths[index]);
            3.0 * (chord(previous) * (here / before) + chord(index) * (before / here))
        })
        .collect();
    let slopes = cyclic(&rows, right);
    let segment = |index: usize| {
        let (next, third) = ((index + 1) % count, lengths[index] / 3.0);
        PathSegment::Cubic([
            points[index],
            points[index] + slopes[index] * third,
            points[next] - slopes[next] * third,
            points[next],
        ])
    };
    (0..count).map(segment).collect()
}

/// Solves a cyclic tridiagonal system with a dominant diagonal: its corners are a matrix of rank one (Sherman, Morrison).
///
/// A row holds the elements before, on and behind the diagonal.
fn cyclic(rows: &[[f64; 3]], right: Vec<Vector2<f64>>) -> Vec<Vector2<f64>> {
    let last = rows.len() - 1;
    let (upper, lower) = (rows[0][0], rows[last][2]);
    let pivot = -rows[0][1];
    let mut inner = rows.to_vec();
    inner[0][1] -= pivot;
    inner[last][1] -= upper * lower / pivot;
    let mut corner = vec![Vector2::zeros(); rows.len()];
    corner[0].x = pivot;
    corner[last].x = lower;
    let (solved, corner) = (tridiagonal(&inner, right), tridiagonal(&inner, corner));
    let corner: Vec<f64> = corner.iter().map(|value| value.x).collect();
    let share = upper / pivot;
    let factor = (solved[0] + solved[last] * share) / (1.0 + corner[0] + corner[last] * share);
    let corrected = |(value, along): (&Vector2<f64>, &f64)| value - factor * *along;
    solved.iter().zip(&corner).map(corrected).collect()
}

/// Solves a tridiagonal system with a dominant diagonal (Thomas).
fn tridiagonal(rows: &[[f64; 3]], mut right: Vec<Vector2<f64>>) -> Vec<Vector2<f64>> {
    let mut behind = vec![0.0; rows.len()];
    for index in 0..rows.len() {
        let [before, on, after] = rows[index];
        let (known, value) = match index {
            0 => (0.0, Vector2::zeros()),
            _ => (behind[index - 1], right[index - 1]),
        };
        let pivot = if index == 0 { on } else { on - before * known };
        behind[index] = after / pivot;
        right[index] = match index {
            0 => right[0] / pivot,
            _ => (right[index] - value * before) / pivot,
        };
    }
    for index in (0..rows.len() - 1).rev() {
        let next = right[index + 1];
        right[index] -= next * behind[index];
    }
    right
}
