//! One external gear of a REXS stage: its data, tool and thickness.

use super::attributes::{Attributes, DEGREE, MILLIMETRE, NUMBER, Unit};
use super::document::{Component, Document, Relation};
use super::thickness::{self, Generated, Thickness};
use gearlash::gear::{BasicGearData, Hand};
use gearlash_input::spec::RackSpec;

const HELIX: &str = "helix_angle_reference_diameter";
const SETTINGS: &str = "manufacturing_settings";

/// A gear as the file states it.
pub struct Gear<'a> {
    pub teeth: u32,
    /// mm.
    pub module: f64,
    /// Degrees.
    pub pressure_angle: f64,
    /// `None` for a spur gear.
    pub helix: Option<Helix>,
    /// `None`: not stated.
    pub shift: Option<f64>,
    /// Diameter, mm.
    pub tip: Option<f64>,
    /// `None`: not stated.
    pub rack: Option<RackSpec>,
    /// The statement that counts, then the others.
    pub thickness: Vec<Thickness>,
    pub remarks: Vec<String>,
    /// The components it was read from; the gear is first.
    pub parts: Vec<Attributes<'a>>,
}

/// Helix and face width of a helical gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// Degrees, above 0.
    pub angle: f64,
    /// The format's angle has the sign of ISO 21771: right hands are positive.
    pub hand: Hand,
    /// mm.
    pub face_width: f64,
}

fn basics(gear: &Attributes) -> Result<(u32, f64, Option<Helix>), String> {
    match gear.component().kind.as_str() {
        "cylindrical_gear" => {}
        "ring_gear" => return Err(gear.left_out("is internal")),
        _ => return Err(gear.left_out("is no cylindrical gear")),
    }
    let helix = match gear.number(HELIX, DEGREE)? {
        Some(0.0) => None,
        Some(angle) => Some(Helix {
            angle: angle.abs(),
            hand: if angle > 0.0 { Hand::Right } else { Hand::Left },
            face_width: gear.need("face_width", MILLIMETRE)?,
        }),
        None => {
            return Err(gear.left_out(format!("has no {HELIX}: only 0 makes it spur")));
        }
    };
    let teeth = gear.number("number_of_teeth", NUMBER)?;
    if teeth.is_some_and(|z| z < 0.0) {
        return Err(gear.left_out("is internal: number_of_teeth is negative"));
    }
    let teeth = gear.count("number_of_teeth")?;
    let teeth = teeth.ok_or_else(|| gear.left_out("has no number_of_teeth"))?;
    Ok((teeth, gear.need("normal_module", MILLIMETRE)?, helix))
}

impl<'a> Gear<'a> {
    /// Reads the gear with these own attributes.
    pub fn read(document: &'a Document, gear: Attributes<'a>) -> Result<Gear<'a>, String> {
        let (teeth, module, helix) = basics(&gear)?;
        let id = gear.component().id;
        let flanks = flanks(document, id)?;
        let pressure_angle = common_value(&flanks, "normal_pressure_angle", DEGREE)?;
        let Some(pressure_angle) = pressure_angle else {
            let place = gear.component().place();
            return Err(format!(
                "the flanks of {place} have no normal_pressure_angle"
            ));
        };
        let mut shift = common_value(&flanks, "addendum_modification_coefficient", NUMBER)?;
        if shift.is_none() {
            let mm = common_value(&flanks, "addendum_modification", MILLIMETRE)?;
            shift = mm.map(|mm| mm / module);
        }
        let addendum = common_value(&flanks, "addendum_coefficient_basic_profile", NUMBER)?;
        let basic_data = BasicGearData::new(teeth, module, pressure_angle.to_radians());
        let basic_data = basic_data.and_then(|data| match helix {
            None => Ok(data),
            Some(helix) => data.with_helix(helix.angle.to_radians(), helix.hand),
        });
        let basic_data =
            basic_data.map_err(|error| format!("{}: {error}", gear.component().place()))?;
        let settings = settings(document, id, &flanks)?;
        let sources = [&gear].into_iter().chain(&flanks).chain(&settings);
        let generated = Generated::read(sources)?;
        let mut remarks = Vec::new();
        let x = shift.unwrap_or(0.0);
        let thickness = thickness::stated(&gear, &basic_data, x, &generated, &mut remarks)?;
        let tip = gear.number("tip_diameter", MILLIMETRE)?;
        let mut read = Gear {
            teeth,
            module,
            pressure_angle,
            helix,
            shift,
            tip,
            rack: None,
            thickness,
            remarks,
            parts: vec![gear],
        };
        read.parts.extend(flanks);
        read.tool(document, addendum)?;
        read.parts.extend(settings);
        Ok(read)
    }

    /// Reads the basic rack from the tool that generates the gear.
    fn tool(&mut self, document: &'a Document, addendum: Option<f64>) -> Result<(), String> {
        let mut racks = Vec::new();
        let parts: Vec<i32> = self.parts.iter().map(|p| p.component().id).collect();
        let place = self.parts[0].component().place();
        for (relation, id) in tools(document, &parts) {
            let tool = document.component(id, relation)?;
            if tool.kind != "rack_shaped_tool" {
                let tool = tool.place();
                let left = format!("{tool} is no rack: the fillet it cuts is not read");
                self.remarks.push(left);
                continue;
            }
            let tool = Attributes::of(tool);
            racks.push(rack(&tool, self.module, addendum)?);
            let amount = tool.number("protuberance_amount", MILLIMETRE)?;
            let factor = tool.number("protuberance_amount_factor", NUMBER)?;
            if [amount, factor].iter().flatten().any(|some| *some != 0.0) {
                let tool = tool.component().place();
                let left = format!("{tool} has a protuberance: the root is that without it");
                self.remarks.push(left);
            }
            self.parts.push(tool);
        }
        racks.dedup();
        let several = racks.len() > 1;
        self.rack = match racks.pop() {
            Some(rack) if !several => rack,
            _ => None,
        };
        if self.rack.is_none() {
            let why = if several {
                "has tools that differ"
            } else {
                "has no rack-shaped tool with addendum and tip radius"
            };
            self.remarks
                .push(format!("{place} {why}: the root is that of ISO 53 A"));
            self.rack = addendum.map(|addendum| RackSpec {
                addendum,
                ..RackSpec::default()
            });
        }
        Ok(())
    }
}

/// Tools of a gear, each once: by a reference of the gear; from version 1.3 on also by manufacturing steps of its flanks.
fn tools<'a>(document: &'a Document, parts: &[i32]) -> Vec<(&'a Relation, i32)> {
    const KINDS: [(&str, &str, &str); 3] = [
        ("ordered_reference", "origin", "referenced"),
        ("reference", "origin", "referenced"),
        ("manufacturing_step", "workpiece", "tool"),
    ];
    let mut tools: Vec<(&Relation, i32)> = Vec::new();
    for (kind, of, role) in KINDS {
        let relations = parts
            .iter()
            .flat_map(|&id| document.relations(kind, of, id));
        for relation in relations {
            for (_, id) in relation.refs.iter().filter(|(r, _)| r == role) {
                let is_tool = |id| {
                    let component = document.component(id, relation);
                    component.map_or(true, |component| component.kind.ends_with("_tool"))
                };
                if is_tool(*id) && tools.iter().all(|(_, other)| other != id) {
                    tools.push((relation, *id));
                }
            }
        }
    }
    tools
}

/// The basic rack of a rack-shaped tool: its addendum cuts the dedendum, its tip round the root round. `None` where one of the
/// two is not stated.
fn rack(tool: &Attributes, module: f64, addendum: Option<f64>) -> Result<Option<RackSpec>, String> {
    let in_modules = |names: &[(&str, Unit)]| {
        for (name, unit) in names {
            if let Some(number) = tool.number(name, unit)? {
                let per = if *unit == NUMBER { 1.0 } else { module };
                return Ok(Some(number / per));
            }
        }
        Ok::<_, String>(None)
    };
    let dedendum = in_modules(&[
        ("addendum_coefficient_reference_profile", NUMBER),
        ("addendum_reference_profile", MILLIMETRE),
    ])?;
    let radius = in_modules(&[
        ("tip_corner_radius_factor_reference_profile", NUMBER),
        ("tip_radius_factor", NUMBER),
        ("tip_radius", MILLIMETRE),
        ("tip_corner_radius_reference_profile", MILLIMETRE),
    ])?;
    let both = dedendum.zip(radius);
    Ok(both.map(|(dedendum, root_radius)| RackSpec {
        addendum: addendum.unwrap_or(RackSpec::default().addendum),
        dedendum,
        root_radius,
    }))
}

/// Left and right flank of a gear.
fn flanks(document: &Document, gear: i32) -> Result<Vec<Attributes<'_>>, String> {
    let mut flanks = Vec::new();
    if let Some(relation) = document.relations("flank", "gear", gear).next() {
        for side in ["left", "right"] {
            let flank = document.component(relation.one(side)?, relation)?;
            add_once(flank, &mut flanks);
        }
    }
    Ok(flanks)
}

/// Settings of the manufacturing steps of a gear or its flanks, each once.
fn settings<'a>(
    document: &'a Document,
    gear: i32,
    flanks: &[Attributes],
) -> Result<Vec<Attributes<'a>>, String> {
    let mut settings: Vec<Attributes> = Vec::new();
    let flanks = flanks.iter().map(|flank| flank.component().id);
    for id in [gear].into_iter().chain(flanks) {
        for relation in document.relations("manufacturing_step", "workpiece", id) {
            for (_, id) in relation.refs.iter().filter(|(r, _)| r == SETTINGS) {
                add_once(document.component(*id, relation)?, &mut settings);
            }
        }
    }
    Ok(settings)
}

/// Adds `component` to `all` where it is not among them.
fn add_once<'a>(component: &'a Component, all: &mut Vec<Attributes<'a>>) {
    if all.iter().all(|other| other.component().id != component.id) {
        all.push(Attributes::of(component));
    }
}

/// The common value of all flanks that state it.
fn common_value(flanks: &[Attributes], id: &str, unit: Unit) -> Result<Option<f64>, String> {
    let mut all: Option<f64> = None;
    for flank in flanks {
        match (all, flank.number(id, unit)?) {
            (Some(one), Some(other)) if one != other => {
                return Err(flank.left_out(format!(
                    "differs from the other flank in {id}: {other}, not {one}"
                )));
            }
            (_, Some(number)) => all = Some(number),
            (_, None) => {}
        }
    }
    Ok(all)
}
