//! The tables of one gear, and their keys.

use super::known_gear::KnownGear;
use super::runout::RunoutSheet;
use super::spec::{CrossCheckSpec, LeadSpec, PitchSpec, ProfileSpec, StatementSpec, ThicknessSpec};
use super::thickness;
use gearlash::gear::{GearDesign, Lead, PitchAxis};
use gearlash::metrology::{Measurements, StatementRole};
use gearlash_text::Table;

/// The tables of one gear, as understood.
pub struct Statements<'a> {
    /// `[wheel]`, `[pinion]` or `[gear]`.
    pub table: &'a Table<'a>,
    /// The design, the tip diameter filled in.
    pub design: GearDesign,
    pub thickness: ThicknessSpec,
    pub pitch: Option<PitchSpec>,
    pub runout: RunoutSheet,
    pub profile: Option<ProfileSpec>,
    pub lead: Option<LeadSpec>,
}

impl Statements<'_> {
    /// The statements for metrology; `None` where a part of them is not known.
    pub fn measurements(&self, known: &KnownGear) -> Option<Measurements> {
        let lead = self.lead.as_ref();
        let profile = self.profile.as_ref();
        let cross_check = self.thickness.cross_check.as_ref();
        Some(Measurements {
            design: self.design,
            face: known.face?,
            thickness: self.thickness.statement.for_metrology(),
            per_tooth_um: self.thickness.per_tooth_um.clone().unwrap_or_default(),
            cross_check: cross_check.map(CrossCheckSpec::for_metrology),
            pitch: self.pitch.as_ref().map(PitchSpec::for_metrology),
            runout: self.runout.for_metrology(),
            wobble: self.runout.wobble,
            profiles: profile
                .map(|spec| spec.for_metrology(&self.design.basic_data))
                .unwrap_or_default(),
            leads_about_datum: lead.is_some_and(|spec| spec.axis == PitchAxis::Datum),
            leads: match lead {
                Some(spec) => spec.for_metrology(known)?,
                None => <[Lead; 2]>::default(),
            },
        })
    }

    /// A statement of the thickness, and the table of it below the gear's.
    pub fn of_thickness(&self, role: StatementRole) -> (&StatementSpec, &'static str) {
        match (role, &self.thickness.cross_check) {
            (StatementRole::CrossCheck, Some(check)) => (&check.statement, thickness::CROSS_CHECK),
            _ => (&self.thickness.statement, "thickness"),
        }
    }

    /// The pitch's `sense` that reads the left flank the other way round.
    pub fn other_sense(&self) -> &'static str {
        self.pitch.as_ref().map_or("", PitchSpec::other_sense)
    }
}
