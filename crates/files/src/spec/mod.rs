//! What a pair file and a gear file say, as plain structs: units in names, keys as in the files.
//!
//! Written as JSON or TOML they are such files; of them the schema is made ([`crate::pair_schema`]), these comments being its
//! descriptions. Reading does not derive from them: a reader that collects every problem with its place fills them in, each
//! part as it was understood. A key that is an `Option` is left out where nothing is said; one that is none has a default.

mod assembly;
mod explained;
mod flanks;
mod gear;
mod outline;
mod pair;
mod profile;
mod require;
mod rules;
mod schema;
mod thickness;
mod tolerance;
mod uncertainty;
mod value;

pub(crate) use assembly::DEFAULT_STEPS;
pub use assembly::{
    AccuracySpec, AssemblySpec, BearingClearanceSpec, CenterDistanceSpec, CompareSpec,
    DesignatedDistanceSpec, DistanceBandSpec, GearName, MeasuredSpec, Phases, Revolutions,
    SweepSpec,
};
pub use explained::explained;
pub use flanks::{
    EccentricitySource, PitchAxis, PitchKind, PitchSense, PitchSpec, ReadingPlace, RunoutSpec,
};
pub use gear::{FaceName, GearSpec, HandName, RackSpec};
pub use outline::{CentreName, CentreSpec, OutlineGearSpec, OutlineSpec, PointsKind};
pub use pair::{EitherGearSpec, GearFileSpec, OutlinePairSpec, PairSpec};
pub use profile::{FlankProfileSpec, ProfileSpec, ReliefShape, ReliefSpec, TraceSpec};
pub use require::{AngleLimitsSpec, LimitsSpec, RequireSpec};
pub use schema::{gear_schema, pair_schema};
pub(crate) use thickness::CROSS_CHECK_UM;
pub use thickness::{
    BodyName, CrossCheckSpec, LengthSpec, OverPinsSpec, SpanSpec, StatementSpec, ThicknessSpec,
};
pub(crate) use tolerance::{DEFAULT_ASSEMBLIES, DEFAULT_IMPOSSIBLE, DEFAULT_ROWS};
pub use tolerance::{
    GearToleranceSpec, PhaseName, PitchScatterSpec, ScatterName, ScatterSpec, ToleranceSpec,
};
pub use uncertainty::UncertaintySpec;
pub use value::{AllowanceBandSpec, BandSpec, DecimalSign, Either, TableFileSpec};
