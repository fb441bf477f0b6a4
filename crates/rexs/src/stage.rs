//! One stage of a REXS file: its pair, or the reason why it has none.

use super::attributes::{Attributes, MICROMETRE, MILLIMETRE, differ};
use super::document::{Component, Document};
use super::gear::Gear;
use super::thickness::Thickness;
use gearlash::gear::MeasuringBody;
use gearlash::pair::DesignatedDistance;
use gearlash_text::characters::cut;
use gearlash_text::node::LONGEST;
use gearlash_text::numbers::{shortest, trimmed};

/// The tolerance field of DIN 3964, as version 1.0 names it and as later ones do.
const FIELD: [&str; 2] = [
    "center_distance_tolerance_field_din_3964_1980",
    "din_3964_center_distance_tolerance_field",
];

/// A stage of two external gears, as the file states it.
pub struct Stage<'a> {
    stage: Attributes<'a>,
    gears: [Gear<'a>; 2],
    distance: f64,
    band: Band,
    remarks: Vec<String>,
}

enum Band {
    None,
    /// js of this grade: the fields of DIN 3964 are those of ISO 286.
    Js(u32),
    /// µm.
    Ends {
        upper: f64,
        lower: f64,
    },
}

fn gears<'a>(document: &'a Document, stage: &Component) -> Result<[Attributes<'a>; 2], String> {
    let left_out = |why: &str| Err(why.to_owned());
    if stage.kind == "planetary_stage" {
        return left_out("a planetary stage: its play is not that of one pair");
    }
    if stage.kind != "cylindrical_stage" {
        return left_out("not a stage of cylindrical gears");
    }
    for relation in document.relations("assembly", "part", stage.id) {
        let whole = document.component(relation.one("assembly")?, relation)?;
        if whole.kind == "planetary_stage" {
            return Err(format!("part of {}", whole.place()));
        }
    }
    let mut relations = document.relations("stage", "stage", stage.id);
    let Some(relation) = relations.next() else {
        return left_out("no relation names its gears");
    };
    if relations.next().is_some() {
        return left_out("more than one relation names its gears");
    }
    let gear = |role| {
        document
            .component(relation.one(role)?, relation)
            .map(Attributes::of)
    };
    let (one, two) = (gear("gear_1")?, gear("gear_2")?);
    if one.component().id == two.component().id {
        let place = one.component().place();
        return Err(format!("both its gears are {place}"));
    }
    Ok([one, two])
}

impl<'a> Stage<'a> {
    pub fn read(document: &'a Document, component: &'a Component) -> Result<Stage<'a>, String> {
        let [one, two] = gears(document, component)?;
        let gears = [Gear::read(document, one)?, Gear::read(document, two)?];
        let stage = Attributes::of(component);
        let distance = stage.need("center_distance", MILLIMETRE)?;
        let upper = stage.number("upper_center_distance_allowance", MICROMETRE)?;
        let lower = stage.number("lower_center_distance_allowance", MICROMETRE)?;
        let field = FIELD.iter().find_map(|id| stage.count(id).transpose());
        let mut remarks = Vec::new();
        let band = match (upper, lower, field.transpose()?) {
            (Some(upper), Some(lower), field) => {
                if let Some(grade) = field {
                    let remark = agree(distance, grade, [upper, lower])
                        .map_err(|why| stage.left_out(why))?;
                    let place = component.place();
                    remarks.extend(remark.map(|remark| format!("{place}: {remark}")));
                }
                Band::Ends { upper, lower }
            }
            (None, None, Some(grade)) => Band::Js(grade),
            (None, None, None) => Band::None,
            _ => {
                return Err(stage.left_out("has one centre distance allowance without the other"));
            }
        };
        Ok(Stage {
            stage,
            gears,
            distance,
            band,
            remarks,
        })
    }

    pub fn summary(&self) -> String {
        let [one, two] = &self.gears;
        let band = |lower: f64, upper: f64| {
            format!("{}…{} µm", trimmed(lower, 0, 1), trimmed(upper, 0, 1))
        };
        let thickness = |gear: &Gear| match gear.thickness.first() {
            None => "nominal".to_owned(),
            Some(Thickness::Series(field)) => field.to_string(),
            Some(Thickness::Allowance { upper, lower }) => band(*lower, *upper),
            Some(Thickness::Span { .. }) => "span".to_owned(),
            Some(Thickness::OverPins { body, .. }) => match (body, gear.helix) {
                (MeasuringBody::Ball, Some(_)) => "over balls".to_owned(),
                _ => "over pins".to_owned(),
            },
        };
        let distance = shortest(self.distance);
        let distance = match self.band {
            Band::None => distance,
            Band::Js(grade) => format!("{distance} js{grade}"),
            Band::Ends { upper, lower } => format!("{distance} ({})", band(lower, upper)),
        };
        format!(
            "z {}/{}, m {}{}, a {distance}, thickness {} / {}",
            one.teeth,
            two.teeth,
            shortest(one.module),
            one.helix.map_or(String::new(), |helix| format!(
                ", β {}° {}/{}",
                shortest(helix.angle),
                helix.hand.name(),
                two.helix.map_or("spur", |helix| helix.hand.name())
            )),
            thickness(one),
            thickness(two)
        )
    }

    /// Its pair file. Absent values take the defaults of a pair file.
    pub fn pair_file(&self, source: &str) -> String {
        let component = self.stage.component();
        let title = match component.name.as_str() {
            "" => format!("Stage {} of {source}", component.id),
            name => format!("{name}, stage {} of {source}", component.id),
        };
        let title = toml::Value::String(title);
        let gears = ["wheel", "pinion"].into_iter().zip(&self.gears);
        let gears: String = gears.map(|(name, gear)| table(name, gear)).collect();
        let distance = match &self.band {
            Band::None => format!("{:?}", self.distance),
            Band::Js(grade) => format!("\"{} js{grade}\"", self.distance),
            Band::Ends { upper, lower } => format!(
                "{{ nominal_mm = {:?}, upper_um = {upper:?}, lower_um = {lower:?} }}",
                self.distance
            ),
        };
        format!("title = {title}\n{gears}\n[assembly]\ncenter_distance_mm = {distance}\n")
    }

    pub fn remarks(&self) -> Vec<String> {
        let mut remarks = self.remarks.clone();
        for gear in &self.gears {
            let place = gear.parts[0].component().place();
            if gear.shift.is_none() {
                remarks.push(format!(
                    "{place} has no addendum_modification_coefficient: taken as 0"
                ));
            }
            if gear.thickness.is_empty() {
                remarks.push(format!("{place} states no tooth thickness: nominal"));
            }
            remarks.extend_from_slice(&gear.remarks);
        }
        if self.gears.iter().any(|gear| gear.helix.is_some()) {
            remarks.push(format!(
                "{}: where along their axes the gears stand is not read: their faces are taken as centred on each other",
                self.stage.component().place()
            ));
        }
        remarks
    }

    pub fn parts(&self) -> impl Iterator<Item = &Attributes<'a>> {
        let gears = self.gears.iter().flat_map(|gear| &gear.parts);
        [&self.stage].into_iter().chain(gears)
    }
}

/// Checks the allowances of a centre distance (upper and lower, µm) against its tolerance field. Returns a remark where they are
/// not comparable.
fn agree(distance: f64, grade: u32, allowances: [f64; 2]) -> Result<Option<String>, String> {
    let field = format!("{distance} js{grade}").parse::<DesignatedDistance>();
    let half = match field.and_then(|field| field.deviations_um()) {
        Ok([_, half]) => half,
        Err(error) => return Ok(Some(format!("js{grade} is not compared: {error}"))),
    };
    if differ(allowances, [half, -half]) {
        Err(format!(
            "contradicts itself: js{grade} is ±{} µm, its centre distance allowances are {} / {} µm",
            trimmed(half, 0, 1),
            trimmed(allowances[0], 0, 1),
            trimmed(allowances[1], 0, 1)
        ))
    } else {
        Ok(None)
    }
}

fn table(name: &str, gear: &Gear) -> String {
    let component = gear.parts[0].component();
    let comment = format!("{} {}", component.place(), cut(&component.name, LONGEST));
    let number = |key: &str, value: f64| format!("{key} = {value:?}");
    let mut lines = vec![
        format!("\n[{name}]  # {}", comment.trim_end()),
        format!("teeth = {}", gear.teeth),
        number("module_mm", gear.module),
        number("pressure_angle_deg", gear.pressure_angle),
    ];
    if let Some(helix) = gear.helix {
        lines.push(number("helix_angle_deg", helix.angle));
        lines.push(format!("hand = \"{}\"", helix.hand.name()));
        lines.push(number("face_width_mm", helix.face_width));
    }
    lines.extend(gear.shift.map(|shift| number("profile_shift", shift)));
    lines.extend(gear.tip.map(|tip| number("tip_diameter_mm", tip)));
    lines.extend(gear.rack.as_ref().map(|rack| {
        format!(
            "rack = {{ addendum = {:?}, dedendum = {:?}, root_radius = {:?} }}",
            rack.addendum, rack.dedendum, rack.root_radius
        )
    }));
    let mut stated = gear.thickness.iter().map(|one| statement(one, gear));
    let counts = stated.next();
    let second = stated
        .next()
        .map(|second| format!(", cross_check = {{ {second} }}"));
    let second = second.unwrap_or_default();
    lines.extend(counts.map(|counts| format!("thickness = {{ {counts}{second} }}")));
    lines.join("\n") + "\n"
}

fn statement(thickness: &Thickness, gear: &Gear) -> String {
    match thickness {
        Thickness::Series(field) => format!("designation = \"{field}\""),
        Thickness::Allowance { upper, lower } => {
            format!("allowance_um = {{ upper = {upper:?}, lower = {lower:?} }}")
        }
        Thickness::Span { teeth, mm } => format!("span = {{ teeth = {teeth}, mm = {mm:?} }}"),
        Thickness::OverPins { body, pin, mm } => {
            let kind = match (gear.helix, body) {
                (None, _) => "",
                (_, MeasuringBody::Ball) => "kind = \"ball\", ",
                (_, MeasuringBody::Pin) => "kind = \"pin\", ",
            };
            format!("over_pins = {{ pin_mm = {pin:?}, {kind}mm = {mm:?} }}")
        }
    }
}
