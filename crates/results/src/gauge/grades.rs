//! Accuracy grades of gears that deviate.

use gearlash::gauge::{GradedReading, LeadReadings, PitchReadings, ProfileReadings, Unmeasured};
use gearlash::gauge::{graded, leads, pitches, profiles};
use gearlash::gear::{AsBuilt, Inspection};
use gearlash_input::PairFile;
use gearlash_input::spec::GearSpec;

/// The accuracy grades of one gear as the gauge measures it, and the required grade.
#[derive(Debug, Clone)]
pub struct GearGrades {
    /// `wheel` or `pinion`.
    pub name: &'static str,
    /// The grade that its table requires.
    pub required: Option<u32>,
    /// The graded readings.
    pub graded: Result<Vec<GradedReading>, Unmeasured>,
    /// Pitch about both axes.
    pub pitches: Vec<PitchReadings>,
    /// Profiles, where the file states their deviations.
    pub profile: Option<ProfileReadings>,
    /// Leads about the axis of the teeth, where the file states their deviations.
    pub lead: Option<LeadReadings>,
}

/// The grades of each gear that has deviations or a required grade. The gauge grades the one of most material.
pub fn grades(pair: &PairFile) -> Vec<GearGrades> {
    let gears = pair.study.materials.first().zip(pair.spec.by_data());
    let Some(((_, wheel, pinion), specs)) = gears else {
        return Vec::new();
    };
    let gears = [("wheel", wheel, specs[0]), ("pinion", pinion, specs[1])];
    let deviating = gears.into_iter().filter(|(_, gear, spec)| {
        let stated = spec.grade.is_some() || spec.profile.is_some() || spec.lead.is_some();
        stated || Inspection::of(gear).deviates()
    });
    let grades = deviating.map(|(name, gear, spec)| {
        let profile = spec.profile.as_ref();
        GearGrades {
            name,
            required: spec.grade,
            graded: graded(gear, spec.thickness.pin_mm()),
            pitches: pitches(gear),
            profile: profile.and_then(|_| profiles(gear, spec.evaluation_radii()).ok()),
            lead: stated_leads(gear, spec),
        }
    });
    grades.collect()
}

/// The leads of `gear` about the axis of its teeth, where `spec` states any.
pub fn stated_leads(gear: &AsBuilt, spec: &GearSpec) -> Option<LeadReadings> {
    let (lead, face) = spec.lead.as_ref().zip(spec.face())?;
    leads(gear, face, lead.range_mm).ok()
}
