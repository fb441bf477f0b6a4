//! `[wheel]` and `[pinion]`: from the keys of one gear to the gear as built.

use super::entry::Limits;
use super::faults::Drawing;
use super::per_tooth;
use super::pitch::PitchSheet;
use super::problems::Problems;
use super::runout::Runout;
use super::sheet::Drawn;
use super::stated::Stated;
use super::table::Table;
use super::thickness::{self, Statement};
use crate::error::GearError;
use crate::gear::{AsBuilt, Blank, Deviations, Face, Rack, Toothing};
use serde_json::{Value, json};

const KEYS: &[&str] = &[
    "teeth",
    "module_mm",
    "pressure_angle_deg",
    "profile_shift",
    "reference_face",
    "tip_diameter_mm",
    "rack",
    "thickness",
    "runout",
    "pitch",
];
const RACK_KEYS: &[&str] = &["addendum", "dedendum", "root_radius"];
const FACES: [(&str, Face); 2] = [("front", Face::Front), ("back", Face::Back)];

const MODULE: Limits = Limits {
    allowed: "a number of mm, 0.01 … 1000",
    holds: |mm| (0.01..=1000.0).contains(&mm),
    way_out: "give the module in mm",
};
const PRESSURE_ANGLE: Limits = Limits {
    allowed: "a number of degrees, 5 … 45",
    holds: |degrees| (5.0..=45.0).contains(&degrees),
    way_out: "give the pressure angle in degrees",
};
const PROFILE_SHIFT: Limits = Limits {
    allowed: "a number of modules, −100 … 100",
    holds: |x| x.abs() <= 100.0,
    way_out: "give the profile shift coefficient x, 0 for none",
};
const TIP_DIAMETER: Limits = Limits {
    allowed: "a number of mm above 0 and up to 1e9",
    holds: |mm| mm > 0.0 && mm <= 1e9,
    way_out: "give the tip diameter, or leave it out to have it follow from addendum and profile shift",
};
const DEPTH: Limits = Limits {
    allowed: "a number of modules above 0 and up to 10",
    holds: |modules| modules > 0.0 && modules <= 10.0,
    way_out: "give it in modules; ISO 53 A has addendum 1.0 and dedendum 1.25",
};
const ROOT_RADIUS: Limits = Limits {
    allowed: "a number of modules, 0 up to the dedendum",
    holds: |modules| modules >= 0.0,
    way_out: "give the tool's tip round in modules; ISO 53 A has 0.38",
};

/// What is good of one gear.
#[derive(Debug, Default)]
pub struct GearPart {
    /// `z`.
    pub teeth: Option<u32>,
    /// `m`, mm.
    pub module_mm: Option<f64>,
    /// `α`, degrees as written.
    pub pressure_angle_deg: Option<f64>,
    /// All three of these.
    pub toothing: Option<Toothing>,
    /// The gear, in one or both materials.
    pub as_built: Option<Stated<AsBuilt>>,
    /// As in the pair file, defaults filled in.
    pub echo: Option<Value>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

impl GearPart {
    /// Reads the table `name` of one gear.
    pub fn read(file: &Table, name: &str, problems: &mut Problems) -> GearPart {
        let there = file.need(name, "the table of a gear", problems);
        let Some(table) = there.and_then(|_| file.table(name, KEYS, problems)) else {
            return GearPart::default();
        };
        let teeth = table.whole(
            "teeth",
            3..=10_000,
            "give the number of teeth all round",
            problems,
        );
        let module_mm = table.number("module_mm", &MODULE, problems);
        let pressure_angle_deg = table.number("pressure_angle_deg", &PRESSURE_ANGLE, problems);
        let mut part = GearPart {
            teeth,
            module_mm,
            pressure_angle_deg,
            toothing: toothing(&table, teeth, module_mm, pressure_angle_deg, problems),
            ..GearPart::default()
        };
        part.complete(&table, problems);
        part
    }

    fn complete(&mut self, table: &Table, problems: &mut Problems) -> Option<()> {
        let teeth = self.teeth;
        let profile_shift = table.number_or("profile_shift", 0.0, &PROFILE_SHIFT, problems);
        let face = table.choice_or_first("reference_face", &FACES, problems);
        let tip_diameter = match table.optional("tip_diameter_mm") {
            Some(Some(entry)) => problems.keep(entry.number(&TIP_DIAMETER)).map(Some),
            absent => absent.map(|_| None),
        };
        let rack = rack(table, problems);
        let thickness = table.table("thickness", thickness::KEYS, problems);
        let statement = thickness
            .as_ref()
            .and_then(|table| Statement::read(table, teeth, problems));
        let per_tooth = thickness
            .as_ref()
            .and_then(|table| per_tooth::thickness(table, teeth, problems));
        let runout = Runout::read(table, teeth, problems);
        let sheet = PitchSheet::read(table, teeth, problems);

        if let Some(runout) = &runout {
            self.warnings.extend(runout.warning.clone());
        }
        let pitch = match (&sheet, &self.toothing, &runout) {
            (Some(None), ..) => Some(None),
            (Some(Some(sheet)), Some(toothing), Some(runout)) => {
                self.warnings.extend(sheet.warnings(table));
                sheet.curves(table, toothing, runout, problems).map(Some)
            }
            _ => None,
        };
        let mut blank = Blank {
            toothing: self.toothing?,
            profile_shift: profile_shift?,
            rack: rack?,
            tip_diameter: tip_diameter?,
        };
        blank.tip_diameter = Some(2.0 * blank.tip_radius());
        let drawn = Drawn {
            blank: &blank,
            pressure_angle_deg: self.pressure_angle_deg?,
        };
        let pitch_header = sheet.iter().flatten().map(PitchSheet::header);
        for header in pitch_header.chain(runout.iter().map(|runout| &runout.header)) {
            header.check(&drawn, problems);
        }
        let drawing = Drawing {
            table,
            blank,
            statement: statement?,
        };
        let gears = drawing.gears(problems)?;
        let runout = runout?;
        let runout_fits = runout.check(table, &gears, problems).is_some();
        let (per_tooth, face) = (per_tooth?, face?);
        let pitch = pitch?;
        let separated = match (&sheet, &pitch) {
            (Some(Some(sheet)), Some(pitch)) => {
                sheet.separate(pitch, gears.most(), table, problems)?
            }
            _ => None,
        };
        let mut deviations = Deviations {
            per_tooth: per_tooth.iter().map(|um| um / 1000.0).collect(),
            pitch,
            // One that does not fit is told; the rest is checked without it.
            eccentricity: if runout_fits {
                runout.eccentricity()
            } else {
                0.0
            },
            high_tooth: runout.high_tooth.unwrap_or(1.0),
        };
        if let Some(separated) = separated {
            self.warnings.push(format!(
                "{}: the datum-axis values contain an eccentricity of {:.3} µm towards tooth {:.2}, which is taken as the gear's \
                 (a first harmonic of its own pitch cannot be told from it)",
                table.path_of("pitch"),
                1000.0 * separated.eccentricity,
                separated.high_tooth,
            ));
            deviations.eccentricity = separated.eccentricity;
            deviations.high_tooth = separated.high_tooth;
            deviations.pitch = Some(separated.pitch);
        }
        self.as_built = Some(drawing.as_built(&gears, face, &deviations, problems)?);

        let mut echo = self.echo_of(&drawing, face, &runout);
        echo["thickness"]["per_tooth_um"] = json!(per_tooth);
        if let Some(Some(sheet)) = sheet {
            echo["pitch"] = sheet.echo();
        }
        self.echo = Some(echo);
        Some(())
    }

    /// As in the pair file, without the lists of one value a tooth.
    fn echo_of(&self, drawing: &Drawing, face: Face, runout: &Runout) -> Value {
        let blank = &drawing.blank;
        json!({
            "teeth": self.teeth,
            "module_mm": self.module_mm,
            "pressure_angle_deg": self.pressure_angle_deg,
            "profile_shift": blank.profile_shift,
            "reference_face": if face == Face::Front { "front" } else { "back" },
            "tip_diameter_mm": blank.tip_diameter,
            "rack": {
                "addendum": blank.rack.addendum(),
                "dedendum": blank.rack.dedendum(),
                "root_radius": blank.rack.root_radius(),
            },
            "thickness": drawing.statement.echo(),
            "runout": runout.echo(),
        })
    }
}

fn toothing(
    table: &Table,
    teeth: Option<u32>,
    module_mm: Option<f64>,
    pressure_angle_deg: Option<f64>,
    problems: &mut Problems,
) -> Option<Toothing> {
    let toothing = Toothing::new(teeth?, module_mm?, pressure_angle_deg?.to_radians());
    problems.keep(toothing.map_err(|error| {
        table.problem(
            "module_mm",
            error.to_string(),
            "correct the gear's basic data",
        )
    }))
}

fn rack(gear: &Table, problems: &mut Problems) -> Option<Rack> {
    let table = gear.table("rack", RACK_KEYS, problems)?;
    let standard = Rack::ISO_53_A;
    let addendum = table.number_or("addendum", standard.addendum(), &DEPTH, problems);
    let dedendum = table.number_or("dedendum", standard.dedendum(), &DEPTH, problems);
    let root_radius = table.number_or(
        "root_radius",
        standard.root_radius(),
        &ROOT_RADIUS,
        problems,
    );
    let rack = Rack::new(addendum?, dedendum?, root_radius?);
    problems.keep(rack.map_err(|error| match error {
        GearError::OutOfRange { value, allowed, .. } => table.problem(
            "root_radius",
            format!("{value} is out of range, allowed is {allowed}"),
            "reduce it, or give a greater dedendum",
        ),
        other => table.problem("root_radius", other.to_string(), "correct the rack"),
    }))
}
