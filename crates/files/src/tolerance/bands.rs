//! Bands stated by a file: their middle, their limits, and bands that `[tolerance]` does not draw from.

use crate::read::PairFile;
use crate::spec::{GearToleranceSpec, ToleranceSpec};
use gearlash::analysis::study::Material;
use gearlash::error::GearError;
use gearlash::gear::thickness::per_normal_thickness;
use gearlash::gear::{AsBuilt, Deviations};
use gearlash::pair::Member;

/// A warning for each band of `pair` that `tolerance` does not draw from, with the key to write.
pub fn left_out(pair: &PairFile, tolerance: &ToleranceSpec) -> Vec<String> {
    let mut warnings = Vec::new();
    for member in Member::BOTH {
        let is_drawn = |spec: &GearToleranceSpec| spec.thickness.is_some() || spec.gears.is_some();
        if !tolerance.gear(member).is_some_and(is_drawn) && thickness_band(pair, member).is_some() {
            let name = member.name();
            warnings.push(format!(
                "{name}.thickness: states a band from which nothing is drawn, every {name} has its middle; to draw it, write thickness = {{ scatter = \"normal\" }} in [tolerance.{name}]"
            ));
        }
    }
    if tolerance.center_distance.is_none() && pair.study.band.is_some() {
        warnings.push(
            "assembly.center_distance_mm: states a band from which nothing is drawn, every pair has the nominal distance; to draw it, write center_distance = { scatter = \"normal\" } in [tolerance]"
                .to_owned(),
        );
    }
    warnings
}

/// The gear in the middle between the thickest and the thinnest.
pub fn middle<'a>(gears: impl Iterator<Item = &'a AsBuilt>) -> Result<AsBuilt, GearError> {
    let gears: Vec<&AsBuilt> = gears.collect();
    let base = |gear: &AsBuilt| gear.gear().base_thickness();
    let (first, rest) = gears.split_first().ok_or(GearError::ThicknessField)?;
    let Some(last) = rest.last() else {
        return Ok((*first).clone());
    };
    let per = per_normal_thickness(first.gear().basic_data());
    let thicker = 0.5 * (base(last) - base(first)) / per;
    first.varied(thicker, &Deviations::default())
}

/// The band of a gear's thickness about its middle, mm at the reference circle (in the normal section).
pub fn thickness_band(pair: &PairFile, member: Member) -> Option<[f64; 2]> {
    let gear = |(_, wheel, pinion): &'_ (Material, AsBuilt, AsBuilt)| {
        let gear = [wheel, pinion][member as usize].gear();
        (
            gear.base_thickness(),
            per_normal_thickness(gear.basic_data()),
        )
    };
    let materials = &pair.study.materials;
    let ((most, per), (least, _)) = (gear(materials.first()?), gear(materials.last()?));
    let half = 0.5 * (most - least) / per;
    (half > 0.0).then_some([-half, half])
}
