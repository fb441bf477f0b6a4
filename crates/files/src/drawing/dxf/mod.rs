//! DXF in ASCII: lines, arcs, circles, ellipses, polylines and splines of the section ENTITIES.
//!
//! Each entity is checked whole ([`entity`]) and then becomes segments ([`shape`]). Other entities are left out with a remark or refused.
//! Binary DXF is refused.

mod entity;
mod pairs;
mod shape;

use super::pieces::Pieces;
use super::text::decode;
use super::{DrawingError, Options, Unit};
use entity::{Entity, Fate};
use nalgebra::Point3;
use pairs::{Pairs, check_format};

/// `$INSUNITS` by the reference of DXF, those that are read.
const UNITS: [(i32, Unit); 5] = [
    (1, Unit::Inch),
    (4, Unit::Mm),
    (5, Unit::Cm),
    (6, Unit::M),
    (13, Unit::Um),
];

/// Layers that are remembered for a message.
const MOST_LAYERS: usize = 100;

/// Adds what the file draws to `pieces`.
pub fn read(bytes: &[u8], options: &Options, pieces: &mut Pieces) -> Result<(), DrawingError> {
    check_format(bytes)?;
    let text = decode(bytes)?;
    let mut pairs = Pairs::of(&text);
    let mut sheet = Sheet {
        select: options.select.as_deref(),
        ..Sheet::default()
    };
    loop {
        let pair = pairs.next()?;
        match (pair.code, pair.value) {
            (0, "EOF") => break,
            (0, "SECTION") => sheet.section(&mut pairs, pieces)?,
            _ => {
                let reason = "expected 0 and SECTION, or 0 and EOF";
                return Err(DrawingError::syntax(
                    format!("line {}", pair.line),
                    reason,
                    "export it again as DXF",
                ));
            }
        }
    }
    if let (Some(name), true) = (sheet.select, sheet.kept.is_empty()) {
        return Err(DrawingError::NotThere {
            what: "layer",
            name: name.to_owned(),
            known: sheet.layers,
        });
    }
    let scale = options.unit_mm(sheet.unit()?, "no $INSUNITS in the DXF")?;
    pieces.unit_mm = scale;
    shape::read(&sheet.kept, scale, pieces)
}

/// An entity to read.
#[derive(Debug)]
pub struct Kept<'a> {
    /// The entity.
    pub entity: Entity<'a>,
    /// The vertices of a POLYLINE and their bulges.
    pub vertices: Vec<(Point3<f64>, f64)>,
}

/// The useful content of a file.
#[derive(Debug, Default)]
struct Sheet<'a> {
    /// The layer asked for.
    select: Option<&'a str>,
    /// The value of `$INSUNITS`, and where it stands.
    insunits: Option<(String, String)>,
    /// Layers with something that is read.
    layers: Vec<String>,
    /// The entities to read, in order.
    kept: Vec<Kept<'a>>,
    /// How many entities there were.
    count: usize,
    /// Within the vertices of a polyline: where it stands, and whether it is kept.
    polyline: Option<(String, bool)>,
}

impl<'a> Sheet<'a> {
    /// Reads through the section that begins here.
    fn section(&mut self, pairs: &mut Pairs<'a>, pieces: &mut Pieces) -> Result<(), DrawingError> {
        let name = pairs.next()?;
        if name.code != 2 {
            let reason = "section without a name";
            return Err(DrawingError::syntax(
                name.place(),
                reason,
                "export it again as DXF",
            ));
        }
        let (mut variable, mut entity): (&str, Option<Entity<'a>>) = ("", None);
        loop {
            let pair = pairs.next()?;
            if name.value == "ENTITIES" && pair.code == 0 {
                if let Some(entity) = entity.take() {
                    self.keep(entity, pieces)?;
                }
                self.count += 1;
                entity = Some(Entity {
                    kind: pair.value,
                    line: pair.line,
                    number: self.count,
                    pairs: Vec::new(),
                });
            }
            match (pair.code, pair.value, &mut entity) {
                (0, "ENDSEC", _) => break,
                (0, "EOF" | "SECTION", _) => {
                    let reason = format!("section {} does not end before this", name.value);
                    return Err(DrawingError::syntax(
                        pair.place(),
                        reason,
                        "export it again as DXF",
                    ));
                }
                (9, value, _) => variable = value,
                (70, value, _) if name.value == "HEADER" && variable == "$INSUNITS" => {
                    self.insunits = Some((value.to_owned(), pair.place()));
                }
                (_, _, Some(entity)) => entity.push(pair),
                _ => {}
            }
        }
        match self.polyline.take() {
            Some((place, _)) => Err(without_end(place)),
            None => Ok(()),
        }
    }

    /// The unit the file states, in words and in mm.
    fn unit(&self) -> Result<Option<(String, f64)>, DrawingError> {
        let Some((value, place)) = &self.insunits else {
            return Ok(None);
        };
        let whole = value.parse::<i32>().ok();
        if whole == Some(0) {
            return Ok(None);
        }
        let known = UNITS.iter().find(|unit| Some(unit.0) == whole);
        let Some((_, unit)) = known else {
            return Err(DrawingError::syntax(
                place,
                format!("$INSUNITS = {value}, expected 1 (inch), 4 (mm), 5 (cm), 6 (m) or 13 (µm)"),
                "export the drawing in mm",
            ));
        };
        Ok(Some((
            format!("$INSUNITS = {value} (\"{unit}\")"),
            unit.mm(),
        )))
    }

    /// Sorts an entity that is complete.
    fn keep(&mut self, entity: Entity<'a>, pieces: &mut Pieces) -> Result<(), DrawingError> {
        let of_polyline = matches!(entity.kind, "VERTEX" | "SEQEND");
        if let Some((place, kept)) = self.polyline.take() {
            if !of_polyline {
                return Err(without_end(place));
            }
            if kept {
                entity.check()?;
                if let ("VERTEX", Some(polyline)) = (entity.kind, self.kept.last_mut()) {
                    polyline
                        .vertices
                        .push((entity.point(10), entity.number(42, 0.0)));
                }
            }
            if entity.kind == "VERTEX" {
                self.polyline = Some((place, kept));
            }
            return Ok(());
        }
        let asked = self
            .select
            .is_none_or(|name| name.eq_ignore_ascii_case(entity.layer()));
        let place = entity.place();
        match (entity.fate(), of_polyline) {
            // The end of the attributes of an INSERT.
            (_, true) if entity.kind == "SEQEND" => {}
            (_, true) => {
                let reason = "a VERTEX without a POLYLINE";
                return Err(DrawingError::syntax(
                    place,
                    reason,
                    "export it again as DXF",
                ));
            }
            (Fate::Refuse, _) if asked => {
                let help = "explode it into lines, arcs and splines, delete it, or name the `layer` of the outline alone";
                return Err(DrawingError::refused(place, entity.kind, help));
            }
            (Fate::Beside, _) if asked => pieces.leave_out(entity.kind, &place),
            (Fate::Read, _) => {
                let layer = entity.layer();
                let new = self.layers.len() < MOST_LAYERS
                    && !self.layers.iter().any(|known| known == layer);
                if self.select.is_some() && new {
                    self.layers.push(layer.to_owned());
                }
                entity.check()?;
                let hidden = match (entity.value(67), entity.value(60)) {
                    (Some("1"), _) => Some("entity in paper space"),
                    (_, Some("1")) => Some("invisible entity"),
                    _ => None,
                };
                if let (Some(words), true) = (hidden, asked) {
                    pieces.leave_out(words, &place);
                }
                let kept = asked && hidden.is_none();
                if entity.kind == "POLYLINE" {
                    self.polyline = Some((place, kept));
                }
                if kept {
                    self.kept.push(Kept {
                        entity,
                        vertices: Vec::new(),
                    });
                }
            }
            _ => {}
        }
        Ok(())
    }
}

fn without_end(place: String) -> DrawingError {
    DrawingError::syntax(place, "a POLYLINE without SEQEND", "export it again as DXF")
}
