//! `[wheel]` and `[pinion]`: from the keys of one gear to the gear as built.

mod rack;

use super::cross_check::CrossCheck;
use super::faults::Drawing;
use super::flanks::{Flanks, Sheets};
use super::limits::{MODULE, PRESSURE_ANGLE, PROFILE_SHIFT, TEETH, TIP_DIAMETER};
use super::per_tooth;
use super::pitch::PitchSheet;
use super::problems::Problems;
use super::runout::Runout;
use super::sheet::Drawn;
use super::slips::{self, Outlier};
use super::spec::{GearSpec, RackSpec, ThicknessSpec};
use super::stated::Stated;
use super::table::Table;
use super::thickness::{self, Statement};
use super::{all_round, contradictions, eccentricity, first_harmonic, unit_slips};
use gearlash::gear::{AsBuilt, BasicGearData, Deviations, Face, GearDesign};
use gearlash::notes::GearNotes;

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
    /// All three of these.
    pub basic_data: Option<BasicGearData>,
    /// The gear, in one or both materials.
    pub as_built: Option<Stated<AsBuilt>>,
    /// As in the pair file, defaults filled in.
    pub spec: Option<GearSpec>,
    /// What its statements say of each other.
    pub notes: GearNotes,
    /// What the user should know.
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
        let mut part = GearPart {
            teeth,
            module_mm,
            pressure_angle_deg,
            basic_data: basic_data(&table, teeth, module_mm, pressure_angle_deg, problems),
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
        let rack = rack::read(table, problems);
        let thickness = table.table("thickness", thickness::KEYS, problems);
        let statement = thickness
            .as_ref()
            .and_then(|table| Statement::read(table, teeth, problems));
        let per_tooth = thickness
            .as_ref()
            .and_then(|table| per_tooth::thickness(table, teeth, problems));
        let cross_check = thickness
            .as_ref()
            .and_then(|table| CrossCheck::read(table, statement.as_ref(), teeth, problems));
        let runout = Runout::read(table, teeth, problems);
        let sheet = PitchSheet::read(table, teeth, problems);

        let pitch = match (&sheet, &self.basic_data, &runout) {
            (Some(None), ..) => Some(None),
            (Some(Some(sheet)), Some(basic_data), Some(runout)) => {
                self.warnings.extend(sheet.warnings(table));
                let curves = sheet.curves(table, basic_data, problems);
                let once = eccentricity::check(table, sheet, runout, problems);
                once.and(curves).map(|pitch| Some((sheet, pitch)))
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
        let drawn = Drawn {
            design: &design,
            pressure_angle_deg: self.pressure_angle_deg?,
        };
        let pitch_header = sheet.iter().flatten().filter_map(PitchSheet::header);
        for header in pitch_header.chain(runout.iter().filter_map(Runout::header)) {
            header.check(&drawn, problems);
            self.warnings.extend_from_slice(header.warnings());
        }
        let drawing = Drawing {
            table,
            design,
            statement: statement?,
            under: "thickness",
        };
        let runout = runout?;
        let (Some(per_tooth_um), Some(pitch)) = (per_tooth, pitch) else {
            // Whatever else is wrong is told, too.
            let gears = drawing.gears(&Deviations::default(), problems)?;
            return runout.check(table, &gears, problems);
        };
        let measured = pitch.clone();
        let sheets = Sheets {
            per_tooth: per_tooth_um.iter().map(|um| um / 1000.0).collect(),
            runout: &runout,
            pitch,
        };
        let flanks = Flanks::settle(&drawing, sheets, problems)?;
        let (face, cross_check) = (face?, cross_check?);
        self.warnings.extend_from_slice(&flanks.told);
        if let Some(note) = &flanks.eccentricity {
            self.warnings.push(eccentricity::told(table, note));
        }
        self.warnings.extend(all_round::told(&drawing, &flanks));
        let measured = measured.as_ref().map(|(sheet, pitch)| (*sheet, pitch));
        self.warnings.extend(contradictions::told(
            &drawing,
            cross_check.as_ref(),
            measured,
            &flanks,
        ));
        self.warnings
            .extend(per_tooth::off_mean(&drawing, &per_tooth_um));
        self.warnings.extend(unit_slips::told(
            &drawing,
            &flanks.runout,
            &per_tooth_um,
            measured.map(|(sheet, _)| sheet),
        ));
        let cross_checks = cross_check.iter();
        self.warnings
            .extend(cross_checks.filter_map(|check| check.same_kind(&drawing)));
        self.warnings
            .extend(measured.and_then(|(sheet, pitch)| match sheet.is_datum() {
                true => first_harmonic::not_joint(table, sheet, pitch, &flanks),
                false => first_harmonic::held(table, pitch, &flanks),
            }));
        let basic_data = &drawing.design.basic_data;
        let in_pitch = measured.and_then(|(sheet, _)| sheet.slip(table, basic_data));
        let slips: Vec<Outlier> = slips::in_readings(&drawing, &flanks.stated)
            .into_iter()
            .chain(in_pitch)
            .collect();
        self.warnings.extend(slips.iter().map(Outlier::told));
        self.notes = GearNotes {
            eccentricity: flanks.eccentricity,
            all_round: flanks.all_round,
            thickness: None,
        };
        if let Some(check) = &cross_check {
            let compared = check.compare(&drawing, &flanks.gears, &flanks.deviations, problems)?;
            let told = check.told(&drawing, &compared);
            match compared.agree() {
                true => self.remarks.push(told),
                false => self.warnings.push(told),
            }
            self.notes.thickness = Some(compared);
        }
        let deviations = &flanks.deviations;
        self.as_built =
            Some(drawing.as_built(&flanks.gears, face, deviations, &slips, problems)?);

        let design = &drawing.design;
        self.spec = Some(GearSpec {
            teeth: self.teeth?,
            module_mm: self.module_mm?,
            pressure_angle_deg: self.pressure_angle_deg?,
            profile_shift: design.profile_shift,
            reference_face: face.into(),
            tip_diameter_mm: design.tip_diameter?,
            rack: RackSpec::from(&design.rack),
            thickness: ThicknessSpec {
                statement: drawing.statement.spec(),
                per_tooth_um: Some(per_tooth_um),
                cross_check: cross_check.as_ref().map(CrossCheck::spec),
            },
            runout: flanks.runout.spec(),
            pitch: measured.map(|(sheet, _)| sheet.spec()),
        });
        Some(())
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
