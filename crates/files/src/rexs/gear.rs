//! One spur gear of a REXS stage: its data, tool and thickness.

use super::document::{Document, Relation, shown};
use super::fault::{Attributes, Fault, Unit};
use crate::error::Problem;
use crate::numbers::{fixed, rounded};
use crate::spec::RackSpec;
use gearlash::gear::{BasicGearData, ThicknessField};

const HELIX: &str = "helix_angle_reference_diameter";
const SPAN: &str = "span_measurement";
const SPANNED: &str = "number_of_teeth_for_span_measurement";
const PIN: &str = "diameter_of_measuring_ball_or_pin";
const SIZES: [&str; 3] = ["size_over_pins", "size_over_balls", "diametral_measurement"];
/// The series of DIN 3967, as version 1.0 calls it and as all others do.
const SERIES: [&str; 2] = [
    "tooth_thickness_deviation_tolerance_series_din_3967_1978",
    "din_3967_deviation_tolerance_series",
];
/// Limits of the thickness in forms that are not read: where nothing else states it, the gear is not taken for a nominal one.
const OTHER_LIMITS: [&str; 6] = [
    "upper_backlash_allowance_balls_or_pins",
    "lower_backlash_allowance_balls_or_pins",
    "chordal_tooth_thickness_upper_deviation",
    "chordal_tooth_thickness_lower_deviation",
    "chordal_transverse_tooth_thickness_upper_deviation",
    "chordal_transverse_tooth_thickness_lower_deviation",
];

/// A gear as the file states it.
pub struct Gear<'a> {
    pub teeth: u32,
    /// mm.
    pub module: f64,
    /// Degrees.
    pub pressure_angle: f64,
    /// `None`: not stated.
    pub shift: Option<f64>,
    /// Diameter, mm.
    pub tip: Option<f64>,
    /// `None`: not stated.
    pub rack: Option<RackSpec>,
    /// The one that counts, and others.
    pub thickness: Vec<Thickness>,
    /// What the user should know.
    pub remarks: Vec<String>,
    /// The components it was read from, the gear first.
    pub parts: Vec<Attributes<'a>>,
}

/// A statement of the tooth thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Thickness {
    /// Of DIN 3967.
    Series(ThicknessField),
    /// Normal, at the reference cylinder, µm.
    Allowance { upper: f64, lower: f64 },
    /// mm.
    Span { teeth: u32, mm: f64 },
    /// mm.
    OverPins { pin: f64, mm: f64 },
}

/// The number of teeth and the module of a gear that is no other than spur and external.
pub fn spur(gear: &Attributes) -> Result<(u32, f64), Fault> {
    let place = gear.component().place();
    let left_out = |why: String| Err(Fault::LeftOut(format!("{place} {why}")));
    match gear.component().kind.as_str() {
        "cylindrical_gear" => {}
        "ring_gear" => return left_out("is internal".to_owned()),
        _ => return left_out("is no cylindrical gear".to_owned()),
    }
    let helix = gear.number(HELIX, Unit::Degree)?;
    match helix {
        Some(0.0) => {}
        Some(angle) => return left_out(format!("is helical: {HELIX} {angle}°")),
        None => return left_out(format!("has no {HELIX}: only 0 makes it spur")),
    }
    if gear
        .number("number_of_teeth", Unit::None)?
        .is_some_and(|z| z < 0.0)
    {
        return left_out("is internal: number_of_teeth is negative".to_owned());
    }
    let teeth = gear.count("number_of_teeth")?;
    let Some(teeth) = teeth else {
        return left_out("has no number_of_teeth".to_owned());
    };
    Ok((teeth, gear.need("normal_module", Unit::Millimetre)?))
}

impl<'a> Gear<'a> {
    /// The gear whose own attributes these are.
    pub fn read(document: &'a Document, gear: Attributes<'a>) -> Result<Gear<'a>, Fault> {
        let (teeth, module) = spur(&gear)?;
        let id = gear.component().id;
        let flanks = flanks(document, id)?;
        let pressure_angle = shared(&flanks, "normal_pressure_angle", Unit::Degree)?;
        let Some(pressure_angle) = pressure_angle else {
            return Err(Fault::LeftOut(format!(
                "the flanks of {} have no normal_pressure_angle",
                gear.component().place()
            )));
        };
        let mut shift = shared(&flanks, "addendum_modification_coefficient", Unit::None)?;
        if shift.is_none() {
            let mm = shared(&flanks, "addendum_modification", Unit::Millimetre)?;
            shift = mm.map(|mm| mm / module);
        }
        let addendum = shared(&flanks, "addendum_coefficient_basic_profile", Unit::None)?;
        let basic_data = BasicGearData::new(teeth, module, pressure_angle.to_radians());
        let basic_data = basic_data
            .map_err(|error| Fault::LeftOut(format!("{}: {error}", gear.component().place())))?;
        let thickness = thickness(&gear, &basic_data)?;
        let tip = gear.number("tip_diameter", Unit::Millimetre)?;
        let mut read = Gear {
            teeth,
            module,
            pressure_angle,
            shift,
            tip,
            rack: None,
            thickness,
            remarks: Vec::new(),
            parts: vec![gear],
        };
        read.parts.extend(flanks);
        read.tool(document, addendum)?;
        Ok(read)
    }

    /// Reads the basic rack from the tool that generates the gear.
    fn tool(&mut self, document: &'a Document, addendum: Option<f64>) -> Result<(), Fault> {
        let mut racks = Vec::new();
        let parts: Vec<i32> = self.parts.iter().map(|p| p.component().id).collect();
        let place = self.parts[0].component().place();
        for (relation, id) in tools(document, &parts) {
            let tool = document.component(id, relation)?;
            if tool.kind != "rack_shaped_tool" {
                let left = format!(
                    "{} is no rack: the fillet it cuts is not read",
                    tool.place()
                );
                self.remarks.push(left);
                continue;
            }
            let tool = Attributes::of(tool);
            racks.push(rack(&tool, self.module, addendum)?);
            let amount = tool.number("protuberance_amount", Unit::Millimetre)?;
            let factor = tool.number("protuberance_amount_factor", Unit::None)?;
            if [amount, factor].iter().flatten().any(|some| *some != 0.0) {
                let tool = tool.component().place();
                let left = format!("{tool} has a protuberance: the root is that without it");
                self.remarks.push(left);
            }
            self.parts.push(tool);
        }
        racks.dedup();
        let unlike = racks.len() > 1;
        self.rack = match racks.pop() {
            Some(rack) if !unlike => rack,
            _ => None,
        };
        if self.rack.is_none() {
            let why = match unlike {
                true => "has tools that differ",
                false => "has no rack-shaped tool with addendum and tip radius",
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

/// Tools of a gear, each once: by a reference of the gear, from version 1.3 on by manufacturing steps of its flanks.
fn tools<'a>(document: &'a Document, parts: &[i32]) -> Vec<(&'a Relation, i32)> {
    const KINDS: [(&str, &str, &str); 3] = [
        ("ordered_reference", "origin", "referenced"),
        ("reference", "origin", "referenced"),
        ("manufacturing_step", "workpiece", "tool"),
    ];
    let mut tools: Vec<(&Relation, i32)> = Vec::new();
    for (kind, of, role) in KINDS {
        for relation in parts
            .iter()
            .flat_map(|&id| document.relations(kind, of, id))
        {
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

/// What a rack-shaped tool leaves as the basic rack of the gear: its addendum cuts the dedendum, its tip round the root round.
/// `None` where one of the two is not stated.
fn rack(
    tool: &Attributes,
    module: f64,
    addendum: Option<f64>,
) -> Result<Option<RackSpec>, Problem> {
    let in_modules = |coefficients: &[&str], length: &str| {
        for coefficient in coefficients {
            if let Some(number) = tool.number(coefficient, Unit::None)? {
                return Ok(Some(number));
            }
        }
        let mm = tool.number(length, Unit::Millimetre)?;
        Ok::<_, Problem>(mm.map(|mm| mm / module))
    };
    let dedendum = in_modules(
        &["addendum_coefficient_reference_profile"],
        "addendum_reference_profile",
    )?;
    let radius = in_modules(
        &[
            "tip_corner_radius_factor_reference_profile",
            "tip_radius_factor",
        ],
        "tip_radius",
    )?;
    let radius = match radius {
        None => tool
            .number("tip_corner_radius_reference_profile", Unit::Millimetre)?
            .map(|mm| mm / module),
        some => some,
    };
    Ok(dedendum
        .zip(radius)
        .map(|(dedendum, root_radius)| RackSpec {
            addendum: addendum.unwrap_or(RackSpec::default().addendum),
            dedendum,
            root_radius,
        }))
}

/// Left and right flank of a gear.
fn flanks(document: &Document, gear: i32) -> Result<Vec<Attributes<'_>>, Problem> {
    let mut flanks = Vec::new();
    if let Some(relation) = document.relations("flank", "gear", gear).next() {
        for side in ["left", "right"] {
            let flank = document.component(relation.one(side)?, relation)?;
            if flanks
                .iter()
                .all(|other: &Attributes| other.component().id != flank.id)
            {
                flanks.push(Attributes::of(flank));
            }
        }
    }
    Ok(flanks)
}

/// What all flanks that state it have.
fn shared(flanks: &[Attributes], id: &str, unit: Unit) -> Result<Option<f64>, Fault> {
    let mut all: Option<f64> = None;
    for flank in flanks {
        match (all, flank.number(id, unit)?) {
            (Some(one), Some(other)) if one != other => {
                return Err(Fault::LeftOut(format!(
                    "{} differs from the other flank in {id}: {other}, not {one}",
                    flank.component().place()
                )));
            }
            (_, Some(number)) => all = Some(number),
            (_, None) => {}
        }
    }
    Ok(all)
}

/// Allowances of a span are printed in whole µm: 0.5 µm, as thickness at pressure angles up to 60° 1 µm.
const ROUNDING_UM: f64 = 1.0;

/// What tells the allowances of a span from those of the series.
fn agree(field: ThicknessField, span: [f64; 2], basic_data: &BasicGearData) -> Result<(), String> {
    let series = field
        .allowances_um(basic_data)
        .map_err(|error| error.to_string())?;
    let apart = |(one, other): (&f64, &f64)| (one - other).abs() > ROUNDING_UM;
    match series.iter().zip(&span).any(apart) {
        false => Ok(()),
        true => Err(format!(
            "contradicts itself: {field} is {} / {} µm, the allowances of its span make {} / {} µm",
            fixed(series[0], 1),
            fixed(series[1], 1),
            fixed(span[0], 1),
            fixed(span[1], 1)
        )),
    }
}

/// What is stated of the thickness: series, allowances, and where neither is, measured lengths.
fn thickness(gear: &Attributes, basic_data: &BasicGearData) -> Result<Vec<Thickness>, Fault> {
    let place = gear.component().place();
    let mut stated = Vec::new();
    if let Some(series) = SERIES.iter().find_map(|id| gear.text(id)) {
        let field = series
            .parse()
            .map_err(|error| Fault::LeftOut(format!("{place}: {}: {error}", shown(series))))?;
        stated.push(Thickness::Series(field));
    }
    let span = ["upper", "lower"].map(|end| format!("{end}_backlash_allowance_referenced_to_span"));
    let upper = gear.number(&span[0], Unit::Micrometre)?;
    let lower = gear.number(&span[1], Unit::Micrometre)?;
    match (upper, lower) {
        (Some(upper), Some(lower)) => {
            // W_k of a spur gear changes by A_sn cos α.
            let [upper, lower] =
                [upper, lower].map(|um| rounded(um / basic_data.pressure_angle().cos(), 6));
            match stated[..] {
                [Thickness::Series(field)] => {
                    agree(field, [upper, lower], basic_data)
                        .map_err(|why| Fault::LeftOut(format!("{place} {why}")))?;
                }
                _ => stated.push(Thickness::Allowance { upper, lower }),
            }
        }
        (None, None) => {}
        _ => {
            return Err(Fault::LeftOut(format!(
                "{place} has one of {} and {} without the other",
                span[0], span[1]
            )));
        }
    }
    if !stated.is_empty() {
        return Ok(stated);
    }
    if let Some(other) = OTHER_LIMITS
        .into_iter()
        .find(|id| gear.component().attribute(id).is_some())
    {
        return Err(Fault::LeftOut(format!(
            "{place} limits its thickness by {other} alone, which is not read: add its DIN 3967 series or the allowances of its span"
        )));
    }
    if let Some(mm) = gear.number(SPAN, Unit::Millimetre)?
        && let Some(teeth) = gear.count(SPANNED)?
    {
        stated.push(Thickness::Span { teeth, mm });
    }
    if let Some(pin) = gear.number(PIN, Unit::Millimetre)? {
        for size in SIZES {
            if let Some(mm) = gear.number(size, Unit::Millimetre)? {
                stated.push(Thickness::OverPins { pin, mm });
                break;
            }
        }
    }
    let lengths = [&[SPAN][..], &SIZES].concat();
    let length = lengths
        .into_iter()
        .find(|id| gear.component().attribute(id).is_some());
    match length.filter(|_| stated.is_empty()) {
        Some(length) => Err(Fault::LeftOut(format!(
            "{place} has {length} without {SPANNED} or {PIN}"
        ))),
        None => Ok(stated),
    }
}
