//! The files: two gears and how they are put together, or one gear.

use super::value::Either;
use super::{
    AccuracySpec, AssemblySpec, CompareSpec, GearSpec, MeasuredSpec, OutlineGearSpec, RequireSpec,
    SweepSpec, ToleranceSpec, UncertaintySpec,
};
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
    pub wheel: GearSpec,
    /// Gear 2, right in the picture: the same keys.
    #[schemars(with = "Either<GearSpec, OutlineGearSpec>")]
    pub pinion: GearSpec,
    /// How the gears are put together.
    #[schemars(with = "Option<AssemblySpec>")]
    pub assembly: AssemblySpec,
    /// Measured backlash to set beside the simulation.
    pub measured: Option<MeasuredSpec>,
    /// Which poses; none beside measured: exactly its rows, none at all: one wheel revolution.
    pub sweep: Option<SweepSpec>,
    /// Of the polygon method.
    #[schemars(with = "Option<AccuracySpec>")]
    pub accuracy: AccuracySpec,
    /// Of gearlash compare.
    #[schemars(with = "Option<CompareSpec>")]
    pub compare: CompareSpec,
    /// What the pair must keep over its whole mesh cycle; exit code 1 where it does not.
    pub require: Option<RequireSpec>,
    /// Standard uncertainties of what was measured, µm; least and greatest backlash are shown with theirs.
    pub uncertainty: Option<UncertaintySpec>,
    /// How the numbers scatter from one assembly to the next: of gearlash tolerance.
    pub tolerance: Option<ToleranceSpec>,
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

/// Two drawings of one gear.
#[derive(Serialize, JsonSchema)]
pub(super) struct TwoDrawingsSpec {
    /// The one that the other is compared with.
    pub a: OutlineGearSpec,
    /// The other.
    pub b: OutlineGearSpec,
}

/// Two gears of which one at least is an outline.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutlinePairSpec {
    /// Shown in results and pictures.
    pub title: String,
    /// Gear 1, left in the picture.
    pub wheel: EitherGearSpec,
    /// Gear 2, right in the picture.
    pub pinion: EitherGearSpec,
    /// How the gears are put together.
    pub assembly: AssemblySpec,
    /// Poses a pitch, and the teeth that mate first.
    pub sweep: SweepSpec,
    /// What the pair must keep over its whole mesh cycle; exit code 1 where it does not.
    pub require: Option<RequireSpec>,
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
