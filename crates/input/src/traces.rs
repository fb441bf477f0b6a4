//! Values of the flanks, for both or for each, in `[profile]` and `[lead]`; and their traces: measured curves, as lists or from tables.

use crate::known_gear::KnownGear;
use crate::spec::{Either, FlankSpec, FlanksSpec, TraceDirection, TraceSpec};
use gearlash::gear::{BasicGearData, Flank};
use gearlash_tables::DataFile;
use gearlash_tables::{Column, Coverage, ProtocolHeader, Quantity, Sheet, Wanted};
use gearlash_text::numbers::ascii;
use gearlash_text::{Node, Table};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Traces of the right flanks, and of the left ones.
type FlankTraces = [Vec<TraceSpec>; 2];

/// A point of a trace: roll length or height, mm, and deviation, µm.
type Point = (f64, f64);

/// The gear that traces were measured on.
struct TraceGear<'a> {
    known: &'a KnownGear,
    along: Along,
    /// Statements about it in the files that were read.
    headers: RefCell<Vec<ProtocolHeader>>,
}

/// The direction in which a trace runs.
#[derive(Clone, Copy)]
pub enum Along {
    /// From root to tip.
    Profile,
    /// Along a face of this width, mm, of teeth with this cos β_b.
    Face { width: f64, helix_cos: f64 },
}

type ReasonAndHelp = (String, String);

impl TraceGear<'_> {
    /// Roll length or height of a stated place; `Err(None)` where the gear is unknown, which is reported elsewhere.
    fn place(&self, by: Quantity, at_mm: f64) -> Result<f64, Option<ReasonAndHelp>> {
        match self.along {
            Along::Profile if by == Quantity::RollLength => Ok(at_mm),
            Along::Profile => {
                let base = self.known.basic_data.ok_or(None)?.base_radius();
                let radius = 0.5 * at_mm;
                if radius >= base {
                    return Ok(((radius - base) * (radius + base)).sqrt());
                }
                Err(Some((
                    format!(
                        "diameter {at_mm} mm, allowed is from the base circle on, {} mm",
                        ascii(2.0 * base, 4)
                    ),
                    "leave out points below the base circle: there is no involute".to_owned(),
                )))
            }
            Along::Face { width, .. } if at_mm > width => Err(Some((
                format!("height {at_mm} mm is beyond the teeth, allowed is 0 … {width} mm"),
                "give heights from the end of the teeth, and leave out points beyond the other end"
                    .to_owned(),
            ))),
            Along::Face { .. } => Ok(at_mm),
        }
    }

    /// Factor of the deviations of a trace.
    fn factor(&self, direction: Option<TraceDirection>) -> f64 {
        match (self.along, direction) {
            (Along::Face { helix_cos, .. }, Some(TraceDirection::Normal)) => 1.0 / helix_cos,
            _ => 1.0,
        }
    }

    /// The trace of a tooth through `points`; a lead has deviations in the transverse section.
    fn trace(&self, tooth: Option<u32>, points: &[Point]) -> TraceSpec {
        let places = Some(points.iter().map(|point| point.0).collect());
        let (rolls, heights) = match self.along {
            Along::Profile => (places, None),
            Along::Face { .. } => (None, places),
        };
        TraceSpec {
            tooth,
            direction: heights.as_ref().map(|_| TraceDirection::Transverse),
            roll_length_mm: rolls,
            from_reference_face_mm: heights,
            deviation_um: Some(points.iter().map(|point| point.1).collect()),
            ..TraceSpec::default()
        }
    }

    /// The fault of a point that does not ascend from `last`.
    fn ascending(&self, last: Option<&Point>, point: Point, by: Quantity) -> Option<ReasonAndHelp> {
        let last = last.filter(|last| point.0 <= last.0)?;
        let how = if point.0 < last.0 {
            "descends"
        } else {
            "is the same as before"
        };
        let name = Column::of(by).name();
        let order = match self.along {
            Along::Profile => "from root to tip",
            Along::Face { .. } => "from one end of the teeth to the other",
        };
        Some((
            format!("the {name} {how}, allowed is strictly ascending"),
            format!("give the points of a trace {order}, each once"),
        ))
    }
}

fn read(
    table: &Table,
    stated: Option<Either<TraceSpec, Vec<TraceSpec>>>,
    own: Option<Flank>,
    gear: &TraceGear,
) -> Option<FlankTraces> {
    let mut traces = [Vec::new(), Vec::new()];
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
        traces.sort_by_cached_key(|trace| trace.tooth.map_or(0, |tooth| 1 + u64::from(tooth)));
        let teeth: Vec<Option<u32>> = traces.iter().map(|trace| trace.tooth).collect();
        let duplicate = teeth.windows(2).find(|pair| pair[0] == pair[1]);
        let reason = match (duplicate, &teeth[..]) {
            (Some([Some(tooth), _]), _) => {
                format!(
                    "tooth {tooth} has two traces of the {} flank, allowed is one",
                    flank.name()
                )
            }
            (_, [None, _, ..]) => format!(
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
    Some(traces)
}

fn read_one(
    table: &Table,
    stated: TraceSpec,
    own: Option<Flank>,
    gear: &TraceGear,
) -> Option<FlankTraces> {
    let tooth = stated.tooth;
    let beyond = gear
        .known
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
        return of_file(table, &stated, own, gear);
    }
    let trace = gear.trace(tooth, &of_lists(table, stated, gear)?);
    Some(match own {
        None => [vec![trace.clone()], vec![trace]],
        Some(Flank::Right) => [vec![trace], Vec::new()],
        Some(Flank::Left) => [Vec::new(), vec![trace]],
    })
}

fn of_lists(table: &Table, stated: TraceSpec, gear: &TraceGear) -> Option<Vec<Point>> {
    let places = [
        (
            Quantity::RollLength,
            "roll_length_mm",
            stated.roll_length_mm,
        ),
        (Quantity::Diameter, "diameter_mm", stated.diameter_mm),
        (
            Quantity::Height,
            "from_reference_face_mm",
            stated.from_reference_face_mm,
        ),
    ];
    let mut places = places.into_iter();
    let (by, name, at) = places.find_map(|(by, name, at)| Some((by, name, at?)))?;
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
    let factor = gear.factor(stated.direction);
    let mut points = Vec::new();
    for (place, (at, um)) in (1..).zip(at.into_iter().zip(deviations)) {
        let fault = match gear.place(by, at) {
            Ok(length) => {
                let point = (length, factor * um);
                let fault = gear.ascending(points.last(), point, by);
                points.push(point);
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

fn of_file(
    table: &Table,
    stated: &TraceSpec,
    own: Option<Flank>,
    gear: &TraceGear,
) -> Option<FlankTraces> {
    let (place, base_radius) = match gear.along {
        Along::Profile => {
            let data = gear.known.basic_data.as_ref();
            (Quantity::RollLength, data.map(BasicGearData::base_radius))
        }
        Along::Face { .. } => (Quantity::Height, None),
    };
    let wanted = Wanted {
        columns: &[place, Quantity::Deviation].map(Column::of),
        teeth: gear.known.teeth,
        coverage: Coverage::Points { base_radius },
    };
    let (file, read) = Sheet::read(table, &wanted)?;
    let by = read.columns.first()?.quantity;
    gear.headers.borrow_mut().push(read.header.clone());
    file.list(|| of_rows(&file, &read, by, (stated, own), gear))
}

/// The traces in the rows of a table; `by` is the quantity of its places. Tooth and flank are columns, or in `stated` and `own`.
fn of_rows(
    file: &DataFile,
    read: &Sheet,
    by: Quantity,
    (stated, own): (&TraceSpec, Option<Flank>),
    gear: &TraceGear,
) -> Option<FlankTraces> {
    let (tooth, factor) = (stated.tooth, gear.factor(stated.direction));
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
        let length = match gear.place(by, at_mm) {
            Ok(length) => length,
            Err(None) => return None,
            Err(Some((reason, help))) => {
                file.add_at(row.line, file.found(reason), help);
                continue;
            }
        };
        let point = (length, factor * deviation_um);
        let mut fault = None;
        for flank in flanks {
            let key = (flank, row.tooth.or(tooth));
            let (line, points) = traces.entry(key).or_default();
            fault = gear.ascending(points.last(), point, by);
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
    let mut found = [Vec::new(), Vec::new()];
    for ((flank, tooth), (_, points)) in traces {
        found[flank].push(gear.trace(tooth, &points));
    }
    Some(found)
}

/// The values of the right flanks, and of the left ones, of `table`. Traces of files become lists.
pub fn read_flanks<F: FlankSpec>(
    table: &Table,
    spec: FlanksSpec<F>,
    known: &KnownGear,
    along: Along,
) -> Option<[F; 2]> {
    let gear = TraceGear {
        known,
        along,
        headers: RefCell::default(),
    };
    let one = |table: &Table, mut spec: F, own| {
        let traces = read(table, spec.trace().take(), own, &gear);
        Some((spec, traces?))
    };
    let both = one(table, spec.both, None);
    let own = [(Flank::Right, spec.right), (Flank::Left, spec.left)].map(|(side, spec)| {
        let below = table.below(side.name());
        one(&below, spec.unwrap_or_default(), Some(side))
    });
    let [right, left] = own;
    let ((right, right_traces), (left, left_traces)) = (right?, left?);
    let (both, [of_right, of_left]) = both?;
    let [both_right, both_left] = [(both.clone(), of_right), (both, of_left)];
    known.headers.borrow_mut().extend(gear.headers.take());
    let [own_right, _] = right_traces;
    let [_, own_left] = left_traces;
    Some([
        joined((right, own_right), both_right),
        joined((left, own_left), both_left),
    ])
}

/// The own values of a flank, with those of both flanks in place of absent ones.
fn joined<F: FlankSpec>(own: (F, Vec<TraceSpec>), both: (F, Vec<TraceSpec>)) -> F {
    let [own, both] = [own, both].map(|(mut flank, mut traces)| {
        *flank.trace() = match traces.len() {
            0 => None,
            1 => traces.pop().map(Either::One),
            _ => Some(Either::Other(traces)),
        };
        flank
    });
    own.or(both)
}

/// Reports keys that are given for both flanks and again for one, in the table `name` of a gear.
pub fn check_flanks(gear: &Table, name: &str) -> Option<()> {
    let both = gear.below(name);
    let mut good = Some(());
    for side in Flank::BOTH {
        let own = both.below(side.name());
        let keys = own.entries().iter().map(|(key, _)| key);
        for key in keys.filter(|key| both.has(key)) {
            let [of_both, of_own] = [&both, &own].map(|table| table.path_of(""));
            let reason = format!("given together with {of_both}{key}, allowed is one of them");
            let help = format!(
                "remove one: what stands in [{}] is of both flanks, what stands in [{}] of the {} flanks alone",
                of_both.trim_end_matches('.'),
                of_own.trim_end_matches('.'),
                side.name()
            );
            own.add(key, reason, help);
            good = None;
        }
    }
    good
}

/// The key, below the gear's table, that states `key` of a flank in the table `name`.
pub fn key_of(gear: &Table, name: &str, flank: Flank, key: &str) -> String {
    let own = format!("{name}.{}.{key}", flank.name());
    if gear.has(&own) {
        own
    } else {
        format!("{name}.{key}")
    }
}
