//! `[thickness]`: completes the statements by the number of teeth, and converts them for metrology.

use super::spec::{
    CROSS_CHECK_UM, CrossCheckSpec, Either, LengthSpec, OverPinsSpec, STATEMENTS, StatementSpec,
    TableFileSpec, ThicknessSpec,
};
use gearlash::gear::{Deviations, GearDesign, MeasuringBody, thickness};
use gearlash::metrology::{self, ThicknessStatement, Toleranced};
use gearlash_tables::{Column, Coverage, Quantity, Sheet, Wanted};
use gearlash_text::Table;
use gearlash_text::numbers::{ascii, rounded};
use std::collections::HashSet;

/// The table of the second statement, below the gear's.
pub const CROSS_CHECK: &str = "thickness.cross_check";

/// Reads the tables that `spec` names and checks its lists on a gear with `teeth` teeth; fills in defaults.
///
/// `gear` is the gear's table. `None` where a statement has a problem; `per_tooth_um` is `None` where its values have one.
pub fn read(gear: &Table, mut spec: ThicknessSpec, teeth: Option<u32>) -> Option<ThicknessSpec> {
    let table = gear.below("thickness");
    let statement = complete_statement(&table, &mut spec.statement, teeth);
    if let Some(span) = &mut spec.statement.span
        && span.first_tooth.is_some()
    {
        span.per_tooth.get_or_insert(!gear.has("pitch"));
    }
    let per_tooth = per_tooth(&table, spec.per_tooth_um.take(), teeth);
    let mut second = Some(());
    if let Some(check) = &mut spec.cross_check {
        let table = gear.below(CROSS_CHECK);
        second = complete_statement(&table, &mut check.statement, teeth);
        check.tolerance_um.get_or_insert(CROSS_CHECK_UM);
        if table.has("span.per_tooth") {
            table.add(
                "span.per_tooth",
                "needless: a cross-check never changes a tooth",
                "remove it",
            );
            second = None;
        }
    }
    spec.per_tooth_um = per_tooth;
    statement?;
    second?;
    Some(spec)
}

fn complete_statement(table: &Table, spec: &mut StatementSpec, teeth: Option<u32>) -> Option<()> {
    if let Some(field) = &mut spec.designation {
        // In the notation of drawings.
        *field = field
            .parse()
            .ok()
            .map(|field: gearlash::gear::ThicknessField| field.to_string())?;
    }
    if let Some(span) = &mut spec.span {
        if let Some(teeth) = teeth.filter(|teeth| span.teeth > *teeth) {
            return table.refuse(
                "span.teeth",
                format!("out of range, allowed is a whole number, 1 … {teeth}"),
                "count the teeth spanned",
            );
        }
        let table = table.below("span");
        let stated = (&mut span.length, &mut span.first_tooth, &mut span.table);
        complete_readings(&table, (Quantity::Span, "first_tooth"), stated, teeth)?;
    }
    if let Some(pins) = &mut spec.over_pins {
        let table = table.below("over_pins");
        let stated = (&mut pins.length, &mut pins.space, &mut pins.table);
        complete_readings(&table, (Quantity::OverPins, "space"), stated, teeth)?;
    }
    Some(())
}

/// Rejects dimensions over unspecified bodies where balls and pins give different thicknesses.
pub fn check_body(gear: &Table, spec: &ThicknessSpec, design: &GearDesign) -> Option<()> {
    let data = &design.basic_data;
    if data.hand().is_none() || data.teeth().is_multiple_of(2) {
        return Some(());
    }
    let second = spec.cross_check.as_ref().map(|check| &check.statement);
    let statements = [("thickness", Some(&spec.statement)), (CROSS_CHECK, second)];
    let mut named = Some(());
    for (under, statement) in statements {
        let pins = statement.and_then(|statement| statement.over_pins.as_ref());
        let Some(pins) = pins.filter(|pins| pins.kind.is_none()) else {
            continue;
        };
        let shown = [MeasuringBody::Ball, MeasuringBody::Pin].map(|body| {
            let stated = StatementSpec {
                over_pins: Some(OverPinsSpec {
                    kind: Some(body),
                    ..pins.clone()
                }),
                ..StatementSpec::default()
            };
            let base = stated
                .for_metrology()
                .base_thickness(design, &Deviations::default());
            let nominal = design.nominal_base_thickness();
            base.map_or("none".to_owned(), |base| {
                let beyond = thickness::allowance_from_base(data, nominal, *base.most());
                format!("{} mm", ascii(design.nominal_thickness() + beyond, 4))
            })
        });
        let [balls, pins] = shown;
        named = gear.refuse(
            &format!("{under}.over_pins.kind"),
            format!(
                "missing: with an odd number of teeth and a helix angle the normal tooth thickness is {balls} over balls, {pins} over pins"
            ),
            "add kind = \"ball\" or kind = \"pin\"",
        );
    }
    named
}

/// Fills in the limits of a drawn length, or the readings of a `quantity` and their places. Places are those that `key` states, those of the
/// table's file, or 1, 2, … where every tooth has a reading.
fn complete_readings(
    table: &Table,
    (quantity, key): (Quantity, &str),
    (length, places, file): (
        &mut LengthSpec,
        &mut Option<Vec<u32>>,
        &mut Option<TableFileSpec>,
    ),
    teeth: Option<u32>,
) -> Option<()> {
    if file.take().is_some() {
        let wanted = Wanted {
            columns: &[Column::of(quantity)],
            teeth,
            coverage: Coverage::SomeTeeth,
        };
        let (_, sheet) = Sheet::read(table, &wanted)?;
        *places = Some(sheet.teeth());
        length.mm = Some(Either::Other(sheet.values(0)));
        return Some(());
    }
    if let (Some(Either::One(mm)), Some(upper), Some(lower)) =
        (&length.mm, length.upper_um, length.lower_um)
    {
        let [min, max] = [lower, upper].map(|um| Some(rounded(mm + um / 1000.0, 7)));
        *length = LengthSpec {
            min_mm: min,
            max_mm: max,
            ..LengthSpec::default()
        };
    }
    let Some(Either::Other(mm)) = &length.mm else {
        return Some(());
    };
    if length.upper_um.is_some() {
        let reason = "given beside readings, expected one drawn length";
        return table.refuse("upper_um", reason, "leave out upper_um and lower_um");
    }
    let (teeth, readings) = (teeth?, mm.len());
    let help = "give the number of each reading, in the order of mm";
    let wrong = |reason: String, help: String| table.refuse(key, reason, help);
    let Some(listed) = places else {
        if readings == teeth as usize {
            *places = Some((1..=teeth).collect());
            return Some(());
        }
        return wrong(
            format!(
                "missing, expected one number a reading: there are {readings} for {teeth} teeth"
            ),
            format!("add `{key}`: {help}; or state their mean alone, or min_mm and max_mm"),
        );
    };
    if listed.len() != readings {
        let length = listed.len();
        return wrong(
            format!("length {length}, expected {readings}: one number a reading"),
            help.to_owned(),
        );
    }
    if let Some((index, place)) = listed.iter().enumerate().find(|(_, place)| **place > teeth) {
        return wrong(
            format!(
                "value {} of the list: {place} is out of range, allowed is a whole number, 1 … {teeth}",
                index + 1
            ),
            "give a number of the gear's teeth".to_owned(),
        );
    }
    let mut seen = HashSet::new();
    match listed.iter().find(|place| !seen.insert(**place)) {
        Some(duplicate) => wrong(
            format!("{duplicate} is listed twice, allowed is once"),
            "keep one reading of it, or their mean".to_owned(),
        ),
        None => Some(()),
    }
}

/// `per_tooth_um`, listed or in a file: empty or one value a tooth, µm.
fn per_tooth(table: &Table, listed: Option<Vec<f64>>, teeth: Option<u32>) -> Option<Vec<f64>> {
    if let Some(list) = listed {
        return one_per_tooth(table, "per_tooth_um", list, teeth);
    }
    if !table.has("per_tooth_um") {
        return Some(Vec::new());
    }
    let table = table.below("per_tooth_um");
    let sheet = Sheet::of_one_quantity(&table, Quantity::Thickness, teeth)?;
    Some(sheet.values(0))
}

/// `list`, if it is empty or has one value per tooth.
pub fn one_per_tooth(
    table: &Table,
    name: &str,
    list: Vec<f64>,
    teeth: Option<u32>,
) -> Option<Vec<f64>> {
    match teeth {
        Some(teeth) if !list.is_empty() && list.len() != teeth as usize => table.refuse(
            name,
            format!("length {}, expected {teeth}: one value a tooth", list.len()),
            "give them in ascending tooth number, tooth 1 first",
        ),
        _ => Some(list),
    }
}

impl StatementSpec {
    /// The key that states the thickness; `None` where nothing is stated: nominal.
    pub(crate) fn key(&self) -> Option<&'static str> {
        let stated = serde_json::to_value(self).unwrap_or_default();
        let mut keys = STATEMENTS.iter().map(|keys| keys[0]);
        keys.find(|key| stated.get(key).is_some())
    }

    pub(crate) fn for_metrology(&self) -> ThicknessStatement {
        if let Some(span) = &self.span {
            let teeth = span.teeth;
            return match span.length.readings(&span.first_tooth) {
                Some(readings) => ThicknessStatement::SpanReadings {
                    teeth,
                    readings,
                    per_tooth: span.per_tooth.unwrap_or_default(),
                },
                None => ThicknessStatement::Span {
                    teeth,
                    mm: span.length.toleranced(),
                },
            };
        }
        if let Some(pins) = &self.over_pins {
            let (body, pin_mm) = (pins.kind.unwrap_or_default(), pins.pin_mm);
            return match pins.length.readings(&pins.space) {
                Some(readings) => ThicknessStatement::PinReadings {
                    body,
                    pin_mm,
                    readings,
                },
                None => ThicknessStatement::OverPins {
                    body,
                    pin_mm,
                    mm: pins.length.toleranced(),
                },
            };
        }
        let field = self
            .designation
            .as_ref()
            .and_then(|field| field.parse().ok());
        let others = [
            field.map(ThicknessStatement::Field),
            self.allowance_um
                .map(|um| ThicknessStatement::AllowanceUm(um.toleranced())),
            self.flank_offset_mm
                .map(|mm| ThicknessStatement::FlankOffset(mm.toleranced())),
            self.base_thickness_mm
                .map(|mm| ThicknessStatement::BaseThickness(mm.toleranced())),
            self.arc_thickness_mm
                .map(|mm| ThicknessStatement::ArcThickness(mm.toleranced())),
            self.chordal_thickness
                .map(|chord| ThicknessStatement::Chord {
                    height_mm: chord.height_mm,
                    mm: single_or_band(chord.mm, chord.min_mm, chord.max_mm),
                }),
        ];
        let mut others = others.into_iter().flatten();
        others.next().unwrap_or(ThicknessStatement::Nominal)
    }
}

impl CrossCheckSpec {
    pub(crate) fn for_metrology(&self) -> metrology::CrossCheck {
        metrology::CrossCheck {
            statement: self.statement.for_metrology(),
            tolerance_um: self.tolerance_um.unwrap_or(CROSS_CHECK_UM),
        }
    }
}

/// One value, or the least and the greatest; the schema allows no other combination.
fn single_or_band(mm: Option<f64>, least: Option<f64>, most: Option<f64>) -> Toleranced<f64> {
    match (least, most) {
        (Some(least), Some(most)) => Toleranced::Band { least, most },
        _ => Toleranced::Single(mm.unwrap_or_default()),
    }
}

impl LengthSpec {
    /// One value, or the least and the greatest.
    fn toleranced(&self) -> Toleranced<f64> {
        let single = match self.mm {
            Some(Either::One(mm)) => Some(mm),
            _ => None,
        };
        single_or_band(single, self.min_mm, self.max_mm)
    }

    /// Each of several readings with its place.
    fn readings(&self, places: &Option<Vec<u32>>) -> Option<Vec<(u32, f64)>> {
        match &self.mm {
            Some(Either::Other(mm)) => {
                let places = places.iter().flatten().copied();
                Some(places.zip(mm.iter().copied()).collect())
            }
            _ => None,
        }
    }
}
