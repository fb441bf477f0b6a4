//! `[wheel]` and `[pinion]`: from the keys of one gear to the gear as built, or as drawn.

use super::helix::{self, Helix};
use super::known_gear::KnownGear;
use super::lead;
use super::outlines::{self, DrawingRead};
use super::profile;
use super::runout::RunoutSheet;
use super::spec::{Either, EitherGearSpec, GearSpec, LeadSpec, PitchSpec, ProfileSpec, RackSpec};
use super::statements::Statements;
use super::{faults, findings, thickness, unit_slips};
use gearlash::error::GearError;
use gearlash::gear::{AsBuilt, BasicRack, GearDesign};
use gearlash::metrology::{Finding, GearNotes, Toleranced};
use gearlash::outline::OutlineGear;
use gearlash_tables::ExpectedGear;
use gearlash_text::Table;
use gearlash_text::numbers::rounded;
use std::convert::Infallible;

/// The parts of one gear that have no problem.
#[derive(Debug, Default)]
pub struct GearPart {
    /// Its basic data; a drawn gear has its number of teeth alone.
    pub known: KnownGear,
    /// The gear by its data, in one or both materials.
    pub as_built: Option<Toleranced<AsBuilt>>,
    /// The gear by its outline, in one or both materials.
    pub drawn: Option<Toleranced<OutlineGear>>,
    /// The content of its drawing.
    pub drawing: Option<DrawingRead>,
    /// As in the pair file, defaults filled in.
    pub spec: Option<EitherGearSpec>,
    pub scale: f64,
    /// Coefficient of thermal expansion, 1/K; `Some(None)` where none is given.
    pub expansion_per_k: Option<Option<f64>>,
    /// Whether the file states its reference face.
    pub states_face: bool,
    /// Notes on statements that concern each other.
    pub notes: GearNotes,
    pub warnings: Vec<String>,
    /// Remarks on what is in order.
    pub remarks: Vec<String>,
}

impl GearPart {
    /// Reads the table `name` of one gear.
    pub fn read(file: &Table, name: &str) -> GearPart {
        let table = file.below(name);
        if table.has("outline") {
            return GearPart::drawn(file, name).unwrap_or_default();
        }
        let mut part = GearPart {
            known: KnownGear::read(&table),
            scale: table.read("scale").flatten().unwrap_or(1.0),
            expansion_per_k: table.read("expansion_per_k"),
            states_face: table.has("reference_face"),
            ..GearPart::default()
        };
        part.read_tables((file, name), &table);
        part.remarks.extend(table.reading().take_remarks());
        part
    }

    fn drawn(file: &Table, name: &str) -> Option<GearPart> {
        let part = outlines::gear(file, name)?;
        Some(GearPart {
            known: KnownGear {
                teeth: Some(part.gears.most().teeth()),
                ..KnownGear::default()
            },
            drawn: Some(part.gears),
            drawing: Some(part.read),
            spec: Some(EitherGearSpec::Outline(Box::new(part.spec))),
            expansion_per_k: Some(None),
            warnings: part.warning.into_iter().collect(),
            remarks: part.remarks,
            ..GearPart::default()
        })
    }

    fn read_tables(&mut self, (file, name): (&Table, &str), table: &Table) -> Option<()> {
        let known = &self.known;
        let profile_shift = table.read::<f64>("profile_shift");
        let tip_diameter = table.read::<f64>("tip_diameter_mm");
        let rack = table.read::<RackSpec>("rack");
        let rack = rack.and_then(|rack| self.rack(rack.unwrap_or_default(), table));
        let thickness = table.read("thickness");
        let thickness = thickness.and_then(|spec| {
            let mut spec = thickness::read(table, spec.unwrap_or_default(), known.teeth)?;
            spec.allowances_in_normal_section(known.normal_per_stated);
            Some(spec)
        });
        let runout = table.read("runout");
        let runout = runout.and_then(|spec| {
            RunoutSheet::read(table, spec.unwrap_or_default(), known.teeth, Some(known))
        });
        let pitch = match table.read::<PitchSpec>("pitch") {
            Some(Some(spec)) => spec.complete(table, known),
            absent => absent.map(|_| None),
        };
        let profile = profile::check(table).and_then(|()| table.read::<ProfileSpec>("profile"));
        let profile = profile.and_then(|spec| spec.unwrap_or_default().complete(table, known));
        let lead = lead::check(table).and_then(|()| table.read::<LeadSpec>("lead"));
        let lead = match lead {
            Some(Some(spec)) => spec.complete(table, known).map(Some),
            absent => absent.map(|_| None),
        };

        let checked_pitch = match (&pitch, &known.basic_data, &runout) {
            (Some(None), ..) => Some(()),
            (Some(Some(pitch)), Some(basic_data), Some(runout)) => {
                faults::check_pitch(table, pitch, runout, basic_data)
            }
            _ => None,
        };
        let mut design = GearDesign {
            basic_data: known.basic_data?,
            profile_shift: profile_shift?.unwrap_or(0.0) / known.normal_per_stated,
            rack: rack?,
            tip_diameter: tip_diameter?,
        };
        design.tip_diameter = Some(2.0 * design.tip_radius());
        thickness::check_body(table, thickness.as_ref()?, &design)?;
        let expected = ExpectedGear {
            design: &design,
            pressure_angle_deg: known.pressure_angle_deg?,
            helix_angle_deg: known.helix?.angle_deg,
        };
        let mut header_warnings = Vec::new();
        for header in known.headers.take() {
            header.check(&expected);
            header_warnings.extend_from_slice(header.warnings());
        }
        let statements = Statements {
            table,
            design,
            thickness: thickness?,
            pitch: pitch.flatten(),
            runout: runout?,
            profile: profile?,
            lead: lead?,
        };
        let measurements = statements.measurements(known)?;
        if checked_pitch.is_none() || statements.thickness.per_tooth_um.is_none() {
            // Other faults are reported, too.
            let errors = measurements.check_thickness_and_runout();
            faults::add_all(&statements, errors);
            return None;
        }
        let errors = |errors| faults::add_all(&statements, errors);
        let gear = measurements.measure().map_err(errors).ok()?;
        let mut spec = file.read::<GearSpec>(name)??;
        self.describe(&statements, &gear.findings, header_warnings);
        self.warnings.extend(self.known.warnings.take());
        self.notes = gear.notes;
        self.warn_of_short_face(&statements, gear.as_built.most());
        let scale = self.scale;
        let scaled = match spec.scale {
            Some(_) => gear.as_built.try_map(|gear| gear.expanded(scale)),
            None => Ok(gear.as_built),
        };
        let help = "check the factor";
        self.as_built = Some(table.keep("scale", scaled, help)?);
        let key = table.path_of("scale");
        let words = "every length and deviation of the gear is multiplied by it: results are of the gear as scaled";
        self.remarks
            .extend(spec.scale.map(|_| format!("{key}: {words}")));

        spec.face_width_mm = None;
        (spec.system, spec.diametral_pitch) = (None, None);
        spec.module_mm = self.known.module_mm?;
        spec.pressure_angle_deg = self.known.pressure_angle_deg?;
        spec.profile_shift = statements.design.profile_shift;
        spec.rack = RackSpec::from(&statements.design.rack);
        spec.tip_diameter_mm = statements.design.tip_diameter?;
        let settled_runout = statements.runout.spec_as_measured(gear.runout);
        let read_um = statements.runout.range_um();
        spec.runout = statements.runout.spec;
        spec.profile = statements.profile;
        spec.lead = statements.lead;
        spec.pitch = statements.pitch;
        spec.thickness = statements.thickness;
        if spec.thickness.statement.key().is_none() {
            spec.thickness.statement.allowance_um = Some(Either::One(0.0));
        }
        self.known.helix?.echo(&mut spec);
        self.warnings.extend(unit_slips::warnings(name, &spec));
        let read_slip = read_um.and_then(|um| {
            let key = table.path_of("runout.file");
            unit_slips::in_unit(&key, "um", rounded(um, 4))
        });
        self.warnings.extend(read_slip);
        spec.runout = settled_runout;
        self.spec = Some(EitherGearSpec::Data(Box::new(spec)));
        Some(())
    }

    /// The outline of the gear, in one or both materials.
    pub fn outline(&self) -> Option<Toleranced<OutlineGear>> {
        let of_data = |gear: &Toleranced<AsBuilt>| {
            let outline = |gear: &AsBuilt| Ok::<_, Infallible>(OutlineGear::from(gear));
            gear.try_map(outline).ok()
        };
        self.drawn
            .clone()
            .or_else(|| of_data(self.as_built.as_ref()?))
    }

    pub fn has_leads(&self) -> bool {
        let gear = self.as_built.as_ref();
        gear.is_some_and(|gear| gear.most().has_leads())
    }

    /// Base radius, mm.
    pub fn base_radius(&self) -> Option<f64> {
        Some(self.scale * self.known.basic_data.as_ref()?.base_radius())
    }

    /// The rack of the gear's table `gear`.
    fn rack(&self, spec: RackSpec, gear: &Table) -> Option<BasicRack> {
        let stated = [spec.addendum, spec.dedendum, spec.root_radius];
        let [addendum, dedendum, root_radius] =
            stated.map(|length| length / self.known.normal_per_stated);
        let rack = BasicRack::new(addendum, dedendum, root_radius);
        let rack = rack.map_err(|error| match error {
            GearError::OutOfRange { value, allowed, .. } => {
                format!("{value} is out of range, allowed is {allowed}")
            }
            other => other.to_string(),
        });
        gear.keep(
            "rack.root_radius",
            rack,
            "reduce it, or give a greater dedendum",
        )
    }

    /// Warns of a face too short for the span of helical teeth.
    fn warn_of_short_face(&mut self, of: &Statements, gear: &AsBuilt) {
        let Some(helix) = self.known.helix.filter(Helix::is_helical) else {
            return;
        };
        let span = of.thickness.statement.span.as_ref().map(|span| span.teeth);
        let name = of.table.path_of("face_mm");
        let name = name.trim_end_matches(".face_mm").to_owned();
        self.warnings
            .extend(helix::short_for_span(helix.face_mm, &name, gear, span));
    }

    /// Puts `findings` into words. Findings on the pitch sheet's own values come before the `header_warnings`.
    fn describe(&mut self, of: &Statements, findings: &[Finding], header_warnings: Vec<String>) {
        let sheet = |finding: &&Finding| matches!(finding, Finding::PitchDoesNotClose { .. });
        let of_sheet = findings.iter().take_while(sheet).count();
        let (before, after) = findings.split_at(of_sheet);
        self.warnings
            .extend(before.iter().map(|finding| findings::describe(of, finding)));
        self.warnings.extend(header_warnings);
        for finding in after {
            let list = if finding.is_in_order() {
                &mut self.remarks
            } else {
                &mut self.warnings
            };
            list.push(findings::describe(of, finding));
        }
    }
}
