//! `[wheel]` and `[pinion]`: from the keys of one gear to the gear as built.

use super::cross_check::CrossCheck;
use super::helix::{self, Helix};
use super::limits::{
    EXPANSION, MODULE, PRESSURE_ANGLE, PROFILE_SHIFT, RACK_DEPTH, ROOT_RADIUS, TEETH, TIP_DIAMETER,
};
use super::pitch::PitchSheet;
use super::problems::Problems;
use super::profile::Profiles;
use super::runout::Runout;
use super::sheet::StatedGear;
use super::spec::{GearSpec, RackSpec, ThicknessSpec};
use super::statements::Statements;
use super::table::Table;
use super::thickness::{self, Statement};
use super::{faults, findings, per_tooth};
use gearlash::analysis::study::Material;
use gearlash::error::GearError;
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, GRADES, GearDesign};
use gearlash::metrology::{Finding, GearNotes, Toleranced};

const KEYS: &[&str] = &[
    "teeth",
    "module_mm",
    "pressure_angle_deg",
    "helix_angle_deg",
    "hand",
    "face_mm",
    "face_width_mm",
    "profile_shift",
    "grade",
    "reference_face",
    "tip_diameter_mm",
    "expansion_per_k",
    "rack",
    "thickness",
    "runout",
    "pitch",
    "profile",
];
const RACK_KEYS: &[&str] = &["addendum", "dedendum", "root_radius"];
const FACES: [(&str, Face); 2] = [("front", Face::Front), ("back", Face::Back)];

/// What is good of one gear.
#[derive(Debug, Default)]
pub struct GearPart {
    /// `z`.
    pub teeth: Option<u32>,
    /// `m`, mm.
    pub module_mm: Option<f64>,
    /// `α`, degrees as written.
    pub pressure_angle_deg: Option<f64>,
    /// How its teeth wind.
    pub helix: Option<Helix>,
    /// All of these.
    pub basic_data: Option<BasicGearData>,
    /// The gear, in one or both materials.
    pub as_built: Option<Toleranced<AsBuilt>>,
    /// As in the pair file, defaults filled in.
    pub spec: Option<GearSpec>,
    /// Coefficient of thermal expansion, 1/K; `Some(None)` where none is given.
    pub expansion_per_k: Option<Option<f64>>,
    /// Whether the file states its reference face.
    pub states_face: bool,
    /// What its statements say of each other.
    pub notes: GearNotes,
    /// Warnings.
    pub warnings: Vec<String>,
    /// What was found to be in order.
    pub remarks: Vec<String>,
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
            TEETH,
            "give the number of teeth all round",
            problems,
        );
        let module_mm = table.number("module_mm", &MODULE, problems);
        let pressure_angle_deg = table.number("pressure_angle_deg", &PRESSURE_ANGLE, problems);
        let helix = Helix::read(&table, problems);
        let basic_data = basic_data(&table, teeth, module_mm, pressure_angle_deg, problems);
        let wound = basic_data.zip(helix);
        let mut part = GearPart {
            teeth,
            module_mm,
            pressure_angle_deg,
            helix,
            basic_data: wound.and_then(|(data, helix)| helix.of(data, &table, problems)),
            states_face: table.has("reference_face"),
            ..GearPart::default()
        };
        part.complete(&table, problems);
        part.remarks.extend(table.place().take_remarks());
        part
    }

    fn complete(&mut self, table: &Table, problems: &mut Problems) -> Option<()> {
        let teeth = self.teeth;
        let profile_shift = table.number_or("profile_shift", 0.0, &PROFILE_SHIFT, problems);
        let grade = match table.optional("grade") {
            Some(Some(entry)) => problems
                .keep(entry.whole(GRADES, "required accuracy grade, ISO 1328-1"))
                .map(Some),
            absent => absent.map(|_| None),
        };
        let face = table.choice_or_first("reference_face", &FACES, problems);
        let tip_diameter = match table.optional("tip_diameter_mm") {
            Some(Some(entry)) => problems.keep(entry.number(&TIP_DIAMETER)).map(Some),
            absent => absent.map(|_| None),
        };
        self.expansion_per_k = table.optional_as("expansion_per_k", problems, |entry| {
            entry.number(&EXPANSION)
        });
        let rack = rack(table, problems);
        let thickness = table.table("thickness", thickness::KEYS, problems);
        let statement = thickness
            .as_ref()
            .and_then(|table| Statement::read(table, teeth, problems));
        let per_tooth = thickness
            .as_ref()
            .and_then(|thick| per_tooth::thickness(thick, teeth, problems));
        let cross_check = thickness
            .as_ref()
            .and_then(|table| CrossCheck::read(table, statement.as_ref(), teeth, problems));
        let runout = Runout::read(table, teeth, problems);
        let sheet = PitchSheet::read(table, teeth, problems);
        let profiles = Profiles::read(table, teeth, self.basic_data.as_ref(), problems);

        let pitch = match (&sheet, &self.basic_data, &runout) {
            (Some(None), ..) => Some(()),
            (Some(Some(sheet)), Some(basic_data), Some(runout)) => {
                faults::check_pitch(table, sheet, runout, basic_data, problems)
            }
            _ => None,
        };
        let mut design = GearDesign {
            basic_data: self.basic_data?,
            profile_shift: profile_shift?,
            rack: rack?,
            tip_diameter: tip_diameter?,
        };
        design.tip_diameter = Some(2.0 * design.tip_radius());
        let drawn = StatedGear {
            design: &design,
            pressure_angle_deg: self.pressure_angle_deg?,
            helix_angle_deg: self.helix?.angle_deg,
        };
        let pitch_header = sheet.iter().flatten().filter_map(PitchSheet::header);
        let mut header_warnings = Vec::new();
        let runout_header = runout.iter().filter_map(Runout::header);
        let trace_headers = profiles.iter().flat_map(Profiles::headers);
        let headers = pitch_header.chain(runout_header);
        for header in headers.chain(trace_headers) {
            header.check(&drawn, problems);
            header_warnings.extend_from_slice(header.warnings());
        }
        let understood = per_tooth.is_some() && pitch.is_some();
        let statements = Statements {
            table,
            design,
            thickness: statement?,
            per_tooth_um: per_tooth.unwrap_or_default(),
            cross_check: cross_check.clone().flatten(),
            pitch: sheet.flatten(),
            runout: runout?,
            profiles: profiles?,
        };
        let measurements = statements.measurements(face.unwrap_or(Face::Front));
        if !understood {
            // Whatever else is wrong is reported, too.
            let errors = measurements.check_thickness_and_runout();
            faults::add_all(&statements, errors, problems);
            return None;
        }
        let errors = |errors| faults::add_all(&statements, errors, problems);
        let gear = measurements.measure().map_err(errors).ok()?;
        let face = face?;
        cross_check?;
        self.describe(&statements, &gear.findings, header_warnings);
        self.notes = gear.notes;
        self.beside_helix(&statements, gear.as_built.most(), problems)?;
        self.as_built = Some(gear.as_built);

        let design = &statements.design;
        let cross_check = statements.cross_check.as_ref();
        let runout = statements.runout.settled(gear.runout);
        let expansion_per_k = self.expansion_per_k?;
        let mut spec = GearSpec {
            teeth: self.teeth?,
            module_mm: self.module_mm?,
            pressure_angle_deg: self.pressure_angle_deg?,
            helix_angle_deg: None,
            hand: None,
            face_mm: None,
            face_width_mm: None,
            profile_shift: design.profile_shift,
            grade: grade?,
            reference_face: face.into(),
            tip_diameter_mm: design.tip_diameter?,
            expansion_per_k,
            rack: RackSpec::from(&design.rack),
            thickness: ThicknessSpec {
                statement: statements.thickness.spec(),
                cross_check: cross_check.map(CrossCheck::spec),
                per_tooth_um: Some(statements.per_tooth_um),
            },
            runout: runout.spec(),
            pitch: statements.pitch.as_ref().map(PitchSheet::spec),
            profile: statements.profiles.spec(),
        };
        self.helix?.echo(&mut spec);
        self.spec = Some(spec);
        Some(())
    }

    /// What cannot stand beside a helix angle, and a face too short for the span.
    fn beside_helix(
        &mut self,
        of: &Statements,
        gear: &AsBuilt,
        problems: &mut Problems,
    ) -> Option<()> {
        let helix = self.helix?;
        if helix.angle_deg == 0.0 {
            return Some(());
        }
        helix::refuse(
            of.table,
            &[(
                "profile",
                gear.is_modified(),
                "between helical teeth whose profiles deviate the lost motion varies along the face, which is not worked out",
            )],
            problems,
        )?;
        let span = of.thickness.spec().span.map(|span| span.teeth);
        let name = of.table.path_of("face_mm");
        let name = name.trim_end_matches(".face_mm").to_owned();
        self.warnings
            .extend(helix::short_for_span(helix.face_mm, &name, gear, span));
        Some(())
    }

    /// Puts `findings` into words, those of the pitch sheet's own values before the `header_warnings`.
    fn describe(&mut self, of: &Statements, findings: &[Finding], header_warnings: Vec<String>) {
        let sheet = |finding: &&Finding| matches!(finding, Finding::PitchDoesNotClose { .. });
        let of_sheet = findings.iter().take_while(sheet).count();
        let (before, after) = findings.split_at(of_sheet);
        self.warnings
            .extend(before.iter().map(|finding| findings::describe(of, finding)));
        self.warnings.extend(header_warnings);
        for finding in after {
            let list = match finding.is_in_order() {
                true => &mut self.remarks,
                false => &mut self.warnings,
            };
            list.push(findings::describe(of, finding));
        }
    }
}

fn basic_data(
    table: &Table,
    teeth: Option<u32>,
    module_mm: Option<f64>,
    pressure_angle_deg: Option<f64>,
    problems: &mut Problems,
) -> Option<BasicGearData> {
    let basic_data = BasicGearData::new(teeth?, module_mm?, pressure_angle_deg?.to_radians());
    problems.keep(basic_data.map_err(|error| {
        table.problem(
            "module_mm",
            error.to_string(),
            "correct the gear's basic data",
        )
    }))
}

/// The rack of a gear's table, ISO 53 A where it says nothing.
fn rack(gear: &Table, problems: &mut Problems) -> Option<BasicRack> {
    let table = gear.table("rack", RACK_KEYS, problems)?;
    let standard = BasicRack::ISO_53_A;
    let addendum = table.number_or("addendum", standard.addendum(), &RACK_DEPTH, problems);
    let dedendum = table.number_or("dedendum", standard.dedendum(), &RACK_DEPTH, problems);
    let root_radius = table.number_or(
        "root_radius",
        standard.root_radius(),
        &ROOT_RADIUS,
        problems,
    );
    let rack = BasicRack::new(addendum?, dedendum?, root_radius?);
    problems.keep(rack.map_err(|error| match error {
        GearError::OutOfRange { value, allowed, .. } => table.problem(
            "root_radius",
            format!("{value} is out of range, allowed is {allowed}"),
            "reduce it, or give a greater dedendum",
        ),
        other => table.problem("root_radius", other.to_string(), "correct the rack"),
    }))
}

/// What `of` makes of the gear in each material.
pub fn materials<T>(built: &Toleranced<AsBuilt>, of: impl Fn(&AsBuilt) -> T) -> Vec<(Material, T)> {
    match built {
        Toleranced::Single(gear) => vec![(Material::AsMeasured, of(gear))],
        Toleranced::Band { least, most } => {
            vec![(Material::Most, of(most)), (Material::Least, of(least))]
        }
    }
}
