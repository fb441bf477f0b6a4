//! The files: two gears and how they are put together, or one gear.

use super::value::Either;
use super::{
    AccuracySpec, AssemblySpec, CompareSpec, GearSpec, MeasuredSpec, OutlineGearSpec, RequireSpec,
    RunoutSpec, SweepSpec, ToleranceSpec, UncertaintySpec,
};
use gearlash::analysis::remedies::StatedGear;
use gearlash::gear::Face;
use gearlash::pair::Member;
use schemars::JsonSchema;
use serde::Serialize;
use serde_with::skip_serializing_none;

/// Two cylindrical gears, what was measured on them, how they are put together.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "gearlash pair file")]
pub struct PairSpec {
    /// Shown in results and pictures; default: the file's name.
    #[schemars(with = "Option<String>")]
    pub title: String,
    /// Gear 1, left in the picture.
    #[schemars(with = "Either<GearSpec, OutlineGearSpec>")]
    pub wheel: EitherGearSpec,
    /// Gear 2, right in the picture.
    #[schemars(with = "Either<GearSpec, OutlineGearSpec>")]
    pub pinion: EitherGearSpec,
    /// How the gears are put together.
    #[schemars(with = "Option<AssemblySpec>")]
    pub assembly: AssemblySpec,
    /// Measured backlash to set beside the simulation.
    pub measured: Option<MeasuredSpec>,
    /// Poses; default: the rows of measured, or one wheel revolution.
    pub sweep: Option<SweepSpec>,
    /// Settings of the polygon method.
    pub accuracy: Option<AccuracySpec>,
    /// Settings of gearlash compare.
    pub compare: Option<CompareSpec>,
    /// Limits that the pair must keep; exit code 1 where it does not.
    pub require: Option<RequireSpec>,
    /// Standard uncertainties of what was measured.
    pub uncertainty: Option<UncertaintySpec>,
    /// Scatter of assemblies, for gearlash tolerance.
    pub tolerance: Option<ToleranceSpec>,
}

impl PairSpec {
    /// How wheel and pinion are stated.
    pub fn stated_gears(&self) -> [StatedGear; 2] {
        [&self.wheel, &self.pinion].map(|gear| StatedGear {
            scale: gear.scale().unwrap_or(1.0),
            by_flank_offset: match gear {
                EitherGearSpec::Data(gear) => gear.thickness.statement.flank_offset_mm.is_some(),
                EitherGearSpec::Outline(_) => true,
            },
        })
    }

    /// Wheel or pinion by its data; `None` for an outline.
    pub fn data(&self, member: Member) -> Option<&GearSpec> {
        [&self.wheel, &self.pinion][member as usize].data()
    }

    /// Wheel and pinion by their data; `None` where one is an outline.
    pub fn by_data(&self) -> Option<[&GearSpec; 2]> {
        Some([self.wheel.data()?, self.pinion.data()?])
    }
}

/// One cylindrical gear and what was measured on it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "gearlash gear file")]
pub struct GearFileSpec {
    /// Shown in results and pictures; default: the file's name.
    #[schemars(with = "Option<String>")]
    pub title: String,
    /// The gear.
    #[schemars(with = "Either<GearSpec, OutlineGearSpec>")]
    pub gear: GearSpec,
}

/// A gear by its data or by its outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum EitherGearSpec {
    /// By its data.
    Data(Box<GearSpec>),
    /// By its outline.
    Outline(Box<OutlineGearSpec>),
}

impl EitherGearSpec {
    /// The gear by its data; `None` for an outline.
    pub fn data(&self) -> Option<&GearSpec> {
        match self {
            EitherGearSpec::Data(spec) => Some(spec),
            EitherGearSpec::Outline(_) => None,
        }
    }

    /// Its runout.
    pub fn runout(&self) -> &RunoutSpec {
        match self {
            EitherGearSpec::Data(spec) => &spec.runout,
            EitherGearSpec::Outline(spec) => &spec.runout,
        }
    }

    /// The factor of its lengths, where one is stated.
    pub fn scale(&self) -> Option<f64> {
        match self {
            EitherGearSpec::Data(spec) => spec.scale,
            EitherGearSpec::Outline(spec) => spec.scale,
        }
    }

    /// The face from which its data and deviations are stated.
    pub fn reference_face(&self) -> Face {
        match self {
            EitherGearSpec::Data(spec) => spec.reference_face,
            EitherGearSpec::Outline(spec) => spec.reference_face,
        }
    }
}
