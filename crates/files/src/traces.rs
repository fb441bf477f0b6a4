//! `trace` of `[profile]` and `[lead]`: measured curves of flanks, as lists or from tables.

use crate::data_file::DataFile;
use crate::node::Node;
use crate::numbers::ascii;
use crate::sheet::{Column, Coverage, Header, Quantity, Sheet, Wanted};
use crate::spec::{Either, LeadTraceSpec, TraceDirection, TraceSpec};
use crate::table::Table;
use gearlash::gear::{BasicGearData, Flank};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Traces of the right flanks, and of the left ones.
pub type FlankTraces<T> = [Vec<T>; 2];

/// A point of a trace: roll length or height, mm, and deviation, µm.
type Point = (f64, f64);

/// A trace as a file states it.
pub trait StatedTrace: Clone {
    fn stated(self) -> Stated;

    fn of_points(tooth: Option<u32>, points: &[Point]) -> Self;

    /// Tooth it was measured on; none: all.
    fn tooth(&self) -> Option<u32>;
}

pub struct Stated {
    tooth: Option<u32>,
    /// Kind of its places, their key, and the places.
    by: (Quantity, &'static str),
    at: Vec<f64>,
    deviation_um: Vec<f64>,
    is_normal: bool,
    is_file: bool,
}

impl StatedTrace for TraceSpec {
    fn stated(self) -> Stated {
        let (by, at) = match (self.roll_length_mm, self.diameter_mm) {
            (None, Some(diameters)) => ((Quantity::Diameter, "diameter_mm"), diameters),
            (rolls, _) => {
                let by = (Quantity::RollLength, "roll_length_mm");
                (by, rolls.unwrap_or_default())
            }
        };
        Stated {
            tooth: self.tooth,
            by,
            at,
            deviation_um: self.deviation_um.unwrap_or_default(),
            is_normal: false,
            is_file: self.table.is_some(),
        }
    }

    fn of_points(tooth: Option<u32>, points: &[Point]) -> TraceSpec {
        TraceSpec {
            tooth,
            roll_length_mm: Some(points.iter().map(|point| point.0).collect()),
            deviation_um: Some(points.iter().map(|point| point.1).collect()),
            ..TraceSpec::default()
        }
    }

    fn tooth(&self) -> Option<u32> {
        self.tooth
    }
}

impl StatedTrace for LeadTraceSpec {
    fn stated(self) -> Stated {
        Stated {
            tooth: self.tooth,
            by: (Quantity::Height, "from_reference_face_mm"),
            at: self.from_reference_face_mm.unwrap_or_default(),
            deviation_um: self.deviation_um.unwrap_or_default(),
            is_normal: self.direction == Some(TraceDirection::Normal),
            is_file: self.table.is_some(),
        }
    }

    fn of_points(tooth: Option<u32>, points: &[Point]) -> LeadTraceSpec {
        LeadTraceSpec {
            tooth,
            from_reference_face_mm: Some(points.iter().map(|point| point.0).collect()),
            deviation_um: Some(points.iter().map(|point| point.1).collect()),
            direction: Some(TraceDirection::Transverse),
            table: None,
        }
    }

    fn tooth(&self) -> Option<u32> {
        self.tooth
    }
}

/// The gear that traces were measured on, as far as known.
pub struct Measured<'a> {
    teeth: Option<u32>,
    along: Along<'a>,
    /// Statements about it in the files that were read.
    headers: RefCell<Vec<Header>>,
}

/// The direction in which a trace runs.
#[derive(Clone, Copy)]
pub enum Along<'a> {
    /// From root to tip of a gear, where it is known.
    Profile(Option<&'a BasicGearData>),
    /// Along a face of this width, mm, of teeth with this cos β_b.
    Face { width: f64, helix_cos: f64 },
}

type Fault = (String, String);

impl<'a> Measured<'a> {
    pub fn new(teeth: Option<u32>, along: Along<'a>) -> Measured<'a> {
        Measured {
            teeth,
            along,
            headers: RefCell::default(),
        }
    }

    /// Statements about the gear in the files that were read.
    pub fn into_headers(self) -> Vec<Header> {
        self.headers.into_inner()
    }

    /// Roll length or height of a stated place; `Err(None)` where the gear is unknown, which is reported elsewhere.
    fn place(&self, by: Quantity, at_mm: f64) -> Result<f64, Option<Fault>> {
        match self.along {
            Along::Profile(_) if by == Quantity::RollLength => Ok(at_mm),
            Along::Profile(basic_data) => {
                let base = basic_data.ok_or(None)?.base_radius();
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
    fn factor(&self, is_normal: bool) -> f64 {
        match self.along {
            Along::Face { helix_cos, .. } if is_normal => 1.0 / helix_cos,
            _ => 1.0,
        }
    }

    /// The fault of a point that does not ascend from `last`.
    fn ascending(&self, last: Option<&Point>, point: Point, by: Quantity) -> Option<Fault> {
        let last = last.filter(|last| point.0 <= last.0)?;
        let how = if point.0 < last.0 {
            "descends"
        } else {
            "is the same as before"
        };
        let name = Column::of(by).name();
        let order = match self.along {
            Along::Profile(_) => "from root to tip",
            Along::Face { .. } => "from one end of the teeth to the other",
        };
        Some((
            format!("the {name} {how}, allowed is strictly ascending"),
            format!("give the points of a trace {order}, each once"),
        ))
    }
}

/// Reads the traces that are `stated` in a table of the `own` flank, or of both flanks.
pub fn read<T: StatedTrace>(
    table: &Table,
    stated: Option<Either<T, Vec<T>>>,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces<T>> {
    let mut traces = [Vec::new(), Vec::new()];
    let (Some(entry), Some(stated)) = (table.get("trace"), stated) else {
        return Some(traces);
    };
    let path = table.path_of("trace");
    let each: Vec<(String, &Node, T)> = match (entry, stated) {
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
        traces.sort_by_key(T::tooth);
        let teeth: Vec<Option<u32>> = traces.iter().map(T::tooth).collect();
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
    good.map(|()| traces)
}

fn read_one<T: StatedTrace>(
    table: &Table,
    stated: T,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces<T>> {
    let stated = stated.stated();
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
    if stated.is_file {
        return of_file(table, &stated, own, gear);
    }
    let trace = T::of_points(tooth, &of_lists(table, stated, gear)?);
    Some(match own {
        None => [vec![trace.clone()], vec![trace]],
        Some(Flank::Right) => [vec![trace], Vec::new()],
        Some(Flank::Left) => [Vec::new(), vec![trace]],
    })
}

fn of_lists(table: &Table, stated: Stated, gear: &Measured) -> Option<Vec<Point>> {
    let (by, name) = stated.by;
    let (at, deviations) = (stated.at, stated.deviation_um);
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
    let factor = gear.factor(stated.is_normal);
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

fn of_file<T: StatedTrace>(
    table: &Table,
    stated: &Stated,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<FlankTraces<T>> {
    let (place, base_radius) = match gear.along {
        Along::Profile(data) => (Quantity::RollLength, data.map(BasicGearData::base_radius)),
        Along::Face { .. } => (Quantity::Height, None),
    };
    let wanted = Wanted {
        columns: &[place, Quantity::Deviation].map(Column::of),
        teeth: gear.teeth,
        coverage: Coverage::Points { base_radius },
    };
    let (file, read) = Sheet::read(table, &wanted)?;
    let by = read.columns.first()?.quantity;
    gear.headers.borrow_mut().push(read.header.clone());
    file.list(|| of_rows(&file, &read, by, (stated, own), gear))
}

/// The traces in the rows of a table `by` a kind of place, in a table that `stated` describes or that is of its `own` flank.
fn of_rows<T: StatedTrace>(
    file: &DataFile,
    read: &Sheet,
    by: Quantity,
    (stated, own): (&Stated, Option<Flank>),
    gear: &Measured,
) -> Option<FlankTraces<T>> {
    let (tooth, factor) = (stated.tooth, gear.factor(stated.is_normal));
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
        found[flank].push(T::of_points(tooth, &points));
    }
    Some(found)
}
