//! `trace` of `[profile]`: measured profiles, as lists or from tables.

use super::Measured;
use crate::data_file::DataFile;
use crate::node::Node;
use crate::numbers::ascii;
use crate::sheet::{Column, Coverage, Sheet, Wanted};
use crate::spec::{Either, TraceSpec};
use crate::table::Table;
use gearlash::gear::{BasicGearData, Flank};
use std::collections::BTreeMap;

/// Traces of the right flanks, and of the left ones.
pub type FlankTraces = [Vec<TraceSpec>; 2];

/// A point of a trace: roll length, mm, and deviation, µm.
type Point = (f64, f64);

/// Reads the traces that are `stated` in a table of the `own` flank, or of both flanks.
pub fn read(
    table: &Table,
    stated: Option<Either<TraceSpec, Vec<TraceSpec>>>,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces> {
    let mut traces = FlankTraces::default();
    let (Some(entry), Some(stated)) = (table.get("trace"), stated) else {
        return Some(traces);
    };
    let path = table.path_of("trace");
    let each: Vec<(String, &Node, TraceSpec)> = match (entry, stated) {
        (Node::List(list), Either::Other(specs)) => {
            let nodes = (1..).zip(list).zip(specs);
            let named = |((place, node), spec)| (format!("{path}[{place}]"), node, spec);
            nodes.map(named).collect()
        }
        (node, Either::One(spec)) => vec![(path, node, spec)],
        _ => Vec::new(),
    };
    let mut good = Some(());
    for (path, node, spec) in each {
        let below = Table::new(&path, table.reading(), node.entries());
        match read_one(&below, spec, own, gear) {
            Some(found) => {
                for (all, more) in traces.iter_mut().zip(found) {
                    all.extend(more);
                }
            }
            None => good = None,
        }
    }
    good?;
    for (flank, traces) in Flank::BOTH.into_iter().zip(&mut traces) {
        traces.sort_by_key(|trace| trace.tooth);
        let duplicate = traces
            .windows(2)
            .find(|pair| pair[0].tooth == pair[1].tooth);
        let reason = match (duplicate, &traces[..]) {
            (
                Some(
                    [
                        TraceSpec {
                            tooth: Some(tooth), ..
                        },
                        _,
                    ],
                ),
                _,
            ) => {
                format!(
                    "tooth {tooth} has two traces of the {} flank, allowed is one",
                    flank.name()
                )
            }
            (_, [TraceSpec { tooth: None, .. }, _, ..]) => format!(
                "a trace of the {} flanks names no tooth and so stands for all, beside another one",
                flank.name()
            ),
            _ => continue,
        };
        table.add(
            "trace",
            reason,
            "keep one trace a tooth, each with its tooth, or one for all",
        );
        // The other flank mostly has the same problem.
        return None;
    }
    good.map(|()| traces)
}

fn read_one(
    table: &Table,
    stated: TraceSpec,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces> {
    let tooth = stated.tooth;
    let beyond = gear
        .teeth
        .filter(|teeth| tooth.is_some_and(|tooth| tooth > *teeth));
    if let Some(teeth) = beyond {
        return table.refuse(
            "tooth",
            format!("out of range, allowed is a whole number, 1 … {teeth}"),
            "give the number of the tooth that was measured",
        );
    }
    if stated.table.is_some() {
        return of_file(table, tooth, own, gear);
    }
    let points = of_lists(table, stated, gear)?;
    let trace = spec(tooth, &points);
    Some(match own {
        None => [vec![trace.clone()], vec![trace]],
        Some(Flank::Right) => [vec![trace], Vec::new()],
        Some(Flank::Left) => [Vec::new(), vec![trace]],
    })
}

fn spec(tooth: Option<u32>, points: &[Point]) -> TraceSpec {
    TraceSpec {
        tooth,
        roll_length_mm: Some(points.iter().map(|point| point.0).collect()),
        deviation_um: Some(points.iter().map(|point| point.1).collect()),
        ..TraceSpec::default()
    }
}

fn of_lists(table: &Table, stated: TraceSpec, gear: &Measured) -> Option<Vec<Point>> {
    let (name, by, at) = match (stated.roll_length_mm, stated.diameter_mm) {
        (None, Some(diameters)) => ("diameter_mm", Column::Diameter, diameters),
        (rolls, _) => (
            "roll_length_mm",
            Column::RollLength,
            rolls.unwrap_or_default(),
        ),
    };
    let deviations = stated.deviation_um.unwrap_or_default();
    if at.len() != deviations.len() {
        return table.refuse(
            "deviation_um",
            format!(
                "{} values beside {} of {name}, expected is one for each of two points or more",
                deviations.len(),
                at.len()
            ),
            "give the deviation at each point",
        );
    }
    let mut points = Vec::new();
    for (place, (at, um)) in (1..).zip(at.into_iter().zip(deviations)) {
        let fault = match roll_length(by, at, gear) {
            Ok(length) => {
                let fault = ascending(points.last(), (length, um), by);
                points.push((length, um));
                fault
            }
            // The gear's own problem is reported.
            Err(fault) => Some(fault?),
        };
        if let Some((reason, help)) = fault {
            let reason = format!("value {place} of the list: {reason}");
            return table.refuse(name, reason, help);
        }
    }
    Some(points)
}

/// A reason and a remedy.
type Fault = (String, String);

/// Roll length of a trace's stated position; `Err(None)` where the gear is unknown, which is reported elsewhere.
fn roll_length(by: Column, at_mm: f64, gear: &Measured) -> Result<f64, Option<Fault>> {
    if by == Column::RollLength {
        return Ok(at_mm);
    }
    let base = gear.basic_data.ok_or(None)?.base_radius();
    let radius = 0.5 * at_mm;
    if radius >= base {
        Ok(((radius - base) * (radius + base)).sqrt())
    } else {
        Err(Some((
            format!(
                "diameter {at_mm} mm, allowed is from the base circle on, {} mm",
                ascii(2.0 * base, 4)
            ),
            "leave out points below the base circle: there is no involute".to_owned(),
        )))
    }
}

/// The fault of a point that does not ascend from `last`.
fn ascending(last: Option<&Point>, point: Point, by: Column) -> Option<Fault> {
    let last = last.filter(|last| point.0 <= last.0)?;
    let how = if point.0 < last.0 {
        "descends"
    } else {
        "is the same as before"
    };
    let name = by.name();
    Some((
        format!("the {name} {how}, allowed is strictly ascending"),
        "give the points of a trace from root to tip, each once".to_owned(),
    ))
}

fn of_file(
    table: &Table,
    tooth: Option<u32>,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces> {
    let base_radius = gear.basic_data.map(BasicGearData::base_radius);
    let wanted = Wanted {
        columns: &[Column::RollLength, Column::Deviation],
        teeth: gear.teeth,
        coverage: Coverage::Points { base_radius },
    };
    let (file, read) = Sheet::read(table, &wanted)?;
    let by = *read.columns.first()?;
    gear.headers.borrow_mut().push(read.header.clone());
    file.list(|| of_rows(&file, &read, by, (tooth, own), gear))
}

/// The traces in the rows of a table `by` roll length or diameter, in a table that names a `tooth` or its `own` flank.
fn of_rows(
    file: &DataFile,
    read: &Sheet,
    by: Column,
    (tooth, own): (Option<u32>, Option<Flank>),
    gear: &Measured,
) -> Option<FlankTraces> {
    let first = read.rows.first()?;
    if let (Some(_), Some(_)) = (tooth, first.tooth) {
        let reason = "has a column tooth, and the key `tooth` stands beside the file: allowed is one of them";
        file.add(reason, "remove one or the other");
    }
    if let (Some(own), Some(_)) = (own, first.flank) {
        let reason = format!(
            "has a column flank, this table is of the {} flanks alone",
            own.name()
        );
        file.add(
            reason,
            "remove the column, or give the trace in the table of both flanks",
        );
    }
    // By flank and tooth; the line of each trace's last point.
    let mut traces: BTreeMap<(usize, Option<u32>), (u64, Vec<Point>)> = BTreeMap::new();
    for row in &read.rows {
        let [at_mm, deviation_um] = row.values[..] else {
            return None;
        };
        let flanks = match row.flank.or(own) {
            None => vec![0, 1],
            Some(flank) => vec![usize::from(flank == Flank::Left)],
        };
        let length = match roll_length(by, at_mm, gear) {
            Ok(length) => length,
            Err(None) => return None,
            Err(Some((reason, help))) => {
                file.add_at(row.line, file.found(reason), help);
                continue;
            }
        };
        let point = (length, deviation_um);
        let mut fault = None;
        for flank in flanks {
            let key = (flank, row.tooth.or(tooth));
            let (line, points) = traces.entry(key).or_default();
            fault = ascending(points.last(), point, by);
            points.push(point);
            *line = row.line;
        }
        if let Some((reason, help)) = fault {
            file.add_at(row.line, reason, help);
        }
    }
    let mut reported = None;
    for ((_, tooth), (line, points)) in &traces {
        if points.len() < 2 && reported.replace(*line) != Some(*line) {
            let whose = tooth.map_or(String::new(), |tooth| format!(" of tooth {tooth}"));
            let reason = format!("the trace{whose} has one point, allowed are two or more");
            file.add_at(*line, file.found(reason), "give the whole trace");
        }
    }
    let mut found = FlankTraces::default();
    for ((flank, tooth), (_, points)) in traces {
        found[flank].push(spec(tooth, &points));
    }
    Some(found)
}
