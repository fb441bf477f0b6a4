//! DXF in ASCII: lines, arcs, circles, ellipses, polylines and splines of the section ENTITIES, and of the blocks that it inserts.
//!
//! Each entity is checked whole ([`entity`]), placed ([`block`]) and then becomes segments ([`shape`]). Other entities are
//! ignored with a remark or rejected. Binary DXF is rejected.

mod block;
mod entity;
mod shape;

use super::error::LONGEST_NAME;
use super::limits::MAX_SEGMENTS;
use super::pieces::Pieces;
use super::text::decode;
use super::{DrawingError, Options, Unit};
use block::{Block, Placement};
use entity::{EXPORT, Entity, Handling, Pairs, check_format};
use gearlash_text::characters::cut;
use std::collections::HashMap;
use std::rc::Rc;

/// The values of `$INSUNITS` (DXF reference) that are read.
const UNITS: [(i32, Unit); 5] = [
    (1, Unit::Inch),
    (4, Unit::Mm),
    (5, Unit::Cm),
    (6, Unit::M),
    (13, Unit::Um),
];

/// Layers that are remembered for a message.
const MAX_LAYERS: usize = 100;

/// Blocks in blocks: drawing programs nest a few.
const DEEPEST: usize = 16;

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
                let place = format!("line {}", pair.line);
                return Err(DrawingError::at(place, reason, EXPORT));
            }
        }
    }
    if let (Some(name), true) = (sheet.select, sheet.kept.is_empty()) {
        return Err(DrawingError::not_there("layer", name, &sheet.layers));
    }
    let scale = options.unit_mm(sheet.unit()?, "no $INSUNITS in the DXF")?;
    pieces.unit_mm = scale;
    shape::read(&sheet.kept, scale, pieces)
}

#[derive(Debug)]
pub struct Kept<'a> {
    pub entity: Rc<Entity<'a>>,
    pub placed: Placement,
    /// Its layer; that of the INSERT where its own is "0".
    pub layer: &'a str,
}

#[derive(Debug, Default)]
struct Sheet<'a> {
    select: Option<&'a str>,
    /// The value of `$INSUNITS`, and its place.
    insunits: Option<(String, String)>,
    /// The value of `$MEASUREMENT`.
    measurement: Option<&'a str>,
    layers: Vec<String>,
    blocks: HashMap<&'a str, Block<'a>>,
    /// The block whose entities are being read.
    block: Option<&'a str>,
    /// The entities to read, in order.
    kept: Vec<Kept<'a>>,
    /// Entities in blocks, and entities visited in order to place them.
    count: usize,
    /// The POLYLINE whose vertices are being read.
    polyline: Option<Entity<'a>>,
}

impl<'a> Sheet<'a> {
    /// Reads through the section that begins here.
    fn section(&mut self, pairs: &mut Pairs<'a>, pieces: &mut Pieces) -> Result<(), DrawingError> {
        let name = pairs.next()?;
        if name.code != 2 {
            let reason = "section without a name";
            return Err(DrawingError::at(name.place(), reason, EXPORT));
        }
        let drawn = matches!(name.value, "ENTITIES" | "BLOCKS");
        let (mut variable, mut entity): (&str, Option<Entity<'a>>) = ("", None);
        let mut number = 0;
        loop {
            let pair = pairs.next()?;
            if drawn && pair.code == 0 {
                if let Some(entity) = entity.take() {
                    number = if entity.kind == "BLOCK" { 0 } else { number };
                    self.complete(entity, pieces)?;
                }
                number += 1;
                entity = Some(Entity {
                    kind: pair.value,
                    line: pair.line,
                    number,
                    block: self.block.unwrap_or_default(),
                    ..Entity::default()
                });
            }
            match (pair.code, pair.value, &mut entity) {
                (0, "ENDSEC", _) => break,
                (0, "EOF" | "SECTION", _) => {
                    let reason = format!("section {} does not end before this", name.value);
                    return Err(DrawingError::at(pair.place(), reason, EXPORT));
                }
                (9, value, _) => variable = value,
                (70, value, _) if name.value == "HEADER" => match variable {
                    "$INSUNITS" => self.insunits = Some((value.to_owned(), pair.place())),
                    "$MEASUREMENT" => self.measurement = Some(value),
                    _ => {}
                },
                (_, _, Some(entity)) => entity.push(pair),
                _ => {}
            }
        }
        self.block = None;
        match self.polyline.take() {
            Some(polyline) => Err(without_end(&polyline)),
            None => Ok(()),
        }
    }

    /// The unit the file states, in words and in mm.
    fn unit(&self) -> Result<Option<(String, f64)>, DrawingError> {
        let stated = self.insunits.as_ref();
        let stated = stated.filter(|(value, _)| value.parse() != Ok(0));
        let Some((value, place)) = stated else {
            let metric = self.measurement == Some("1");
            return Ok(metric.then(|| ("$MEASUREMENT = 1 (\"mm\")".to_owned(), Unit::Mm.mm())));
        };
        let whole = value.parse::<i32>().ok();
        let known = UNITS.iter().find(|unit| Some(unit.0) == whole);
        let Some((_, unit)) = known else {
            let reason =
                format!("$INSUNITS = {value}, expected 1 (inch), 4 (mm), 5 (cm), 6 (m) or 13 (µm)");
            return Err(DrawingError::at(place, reason, "export the drawing in mm"));
        };
        let words = format!("$INSUNITS = {value} (\"{unit}\")");
        Ok(Some((words, unit.mm())))
    }

    /// Takes an entity whose pairs are complete: the vertices of a POLYLINE belong to it.
    fn complete(&mut self, entity: Entity<'a>, pieces: &mut Pieces) -> Result<(), DrawingError> {
        match (self.polyline.take(), entity.kind) {
            (Some(mut polyline), "VERTEX") => {
                entity.check()?;
                let vertex = (entity.point(10), entity.number(42, 0.0));
                polyline.vertices.push(vertex);
                self.polyline = Some(polyline);
                Ok(())
            }
            (Some(polyline), "SEQEND") => self.found(polyline, pieces),
            (Some(polyline), _) => Err(without_end(&polyline)),
            (None, "VERTEX") => {
                let reason = "a VERTEX without a POLYLINE";
                Err(DrawingError::at(entity.place(), reason, EXPORT))
            }
            // The end of the attributes of an INSERT.
            (None, "SEQEND") => Ok(()),
            (None, "POLYLINE") => {
                self.polyline = Some(entity);
                Ok(())
            }
            (None, _) => self.found(entity, pieces),
        }
    }

    /// Takes a whole entity as part of a block or of the drawing.
    fn found(&mut self, entity: Entity<'a>, pieces: &mut Pieces) -> Result<(), DrawingError> {
        match (entity.kind, self.block) {
            ("BLOCK", _) => {
                let name = entity.value(2).unwrap_or_default();
                self.block = Some(name);
                let base = entity.point(10);
                let entities = Vec::new();
                self.blocks.insert(name, Block { base, entities });
                Ok(())
            }
            ("ENDBLK", _) => {
                self.block = None;
                Ok(())
            }
            (_, Some(name)) => {
                self.counted()?;
                if let Some(block) = self.blocks.get_mut(name) {
                    block.entities.push(Rc::new(entity));
                }
                Ok(())
            }
            _ => self.place(&Rc::new(entity), Placement::default(), None, 0, pieces),
        }
    }

    /// Counts an entity that is kept or visited.
    fn counted(&mut self) -> Result<(), DrawingError> {
        self.count += 1;
        if self.count > MAX_SEGMENTS {
            return Err(DrawingError::too_large("entities", MAX_SEGMENTS));
        }
        Ok(())
    }

    /// Keeps an entity that is `placed`, on the layer `around` where its own is "0".
    fn place(
        &mut self,
        entity: &Rc<Entity<'a>>,
        placed: Placement,
        around: Option<&'a str>,
        depth: usize,
        pieces: &mut Pieces,
    ) -> Result<(), DrawingError> {
        self.counted()?;
        let layer = match (entity.layer(), around) {
            ("0", Some(around)) => around,
            (own, _) => own,
        };
        let select = self.select;
        let selected = select.is_none_or(|name| name.eq_ignore_ascii_case(layer));
        let handling = entity.handling();
        if matches!(handling, Handling::Read | Handling::Insert) {
            entity.check()?;
            let hidden = match (entity.value(67), entity.value(60)) {
                (Some("1"), _) => Some("entity in paper space"),
                (_, Some("1")) => Some("invisible entity"),
                _ => None,
            };
            if let Some(words) = hidden {
                if selected {
                    pieces.leave_out(words, &entity.place());
                }
                return Ok(());
            }
        }
        match handling {
            Handling::Reject if selected => Err(DrawingError::refused(
                entity.place(),
                entity.kind,
                "explode it into lines, arcs and splines, delete it, or name the `layer` of the outline alone",
            )),
            Handling::Ignore if selected => {
                pieces.leave_out(entity.kind, &entity.place());
                Ok(())
            }
            Handling::Insert => self.insert(entity, placed, layer, depth, pieces),
            Handling::Read => {
                let known = self.layers.iter().any(|known| known == layer);
                if select.is_some() && !known && self.layers.len() < MAX_LAYERS {
                    self.layers.push(layer.to_owned());
                }
                if selected {
                    self.kept.push(Kept {
                        entity: entity.clone(),
                        placed,
                        layer,
                    });
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Places the entities of the block that an INSERT names, once for each of its columns and rows.
    fn insert(
        &mut self,
        insert: &Entity<'a>,
        placed: Placement,
        layer: &'a str,
        depth: usize,
        pieces: &mut Pieces,
    ) -> Result<(), DrawingError> {
        let wrong = |kind: String| {
            let help = "explode the block, or export the drawing again";
            Err(DrawingError::refused(insert.place(), kind, help))
        };
        let name = insert.value(2).unwrap_or_default();
        if depth == DEEPEST {
            return wrong(format!("blocks nested deeper than {DEEPEST}"));
        }
        let Some(block) = self.blocks.get(name) else {
            let name = cut(name, LONGEST_NAME);
            return wrong(format!(
                "an INSERT of \"{name}\", a block that the file does not have"
            ));
        };
        let copies = match Placement::copies(insert, block.base) {
            Ok(copies) => copies,
            Err(reason) => return wrong(reason.to_owned()),
        };
        let entities = block.entities.clone();
        for copy in copies {
            // A block without entities costs a step as well.
            self.counted()?;
            let inner = placed.after(&copy);
            for entity in &entities {
                self.place(entity, inner, Some(layer), depth + 1, pieces)?;
            }
        }
        Ok(())
    }
}

fn without_end(polyline: &Entity) -> DrawingError {
    DrawingError::at(polyline.place(), "a POLYLINE without SEQEND", EXPORT)
}
