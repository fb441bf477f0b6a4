//! Pair files and gear files as plain structs: units in names, keys as in the files.
//!
//! The schema follows from them ([`crate::pair_schema`]), their comments are its descriptions. It checks a file (`src/check.rs`);
//! then serde reads these structs. Written as JSON or TOML they are such files: the echo in results. A key that is an `Option`
//! is left out where nothing is said; another has a default, or must be there.

mod assembly;
#[cfg(not(target_family = "wasm"))]
mod derived;
mod explained;
mod flanks;
mod gear;
mod lead;
mod outline;
mod pair;
mod profile;
mod require;
mod rules;
mod schema;
mod thickness;
mod tolerance;
mod trace;
mod uncertainty;
mod value;

pub use assembly::MAX_DISTANCES;
pub use assembly::{
    AccuracySpec, AssemblySpec, BearingClearanceSpec, CenterDistanceSpec, CompareSpec,
    DesignatedDistanceSpec, DistanceBandSpec, DistanceEndsSpec, EitherSenseSpec, MeasuredSpec,
    MisalignmentSpec, Phases, Revolutions, SweepSpec,
};
pub(crate) use assembly::{DEFAULT_STEPS, ExtremePhases};
pub use explained::explained;
pub(crate) use explained::{as_clause, members};
pub use flanks::{FaceRunoutSpec, PitchSpec, ReadingPlace, RunoutPlaneSpec, RunoutSpec};
pub use gear::{GearSpec, RackSpec, System};
pub use gearlash_tables::TableFileSpec;
pub use gearlash_text::file_numbers::Decimal as DecimalSign;
pub use lead::{
    EndReliefSpec, FlankLeadSpec, LeadSpec, ReliefEnd, SlopeLength, SpurSlopeSpec, TeethEnd,
};
pub use outline::{
    CentreName, CentreSpec, OutlineGearSpec, OutlineSpec, OutlineThicknessSpec, PointsKind,
};
pub use pair::{EitherGearSpec, GearFileSpec, PairSpec};
pub use profile::{FlankProfileSpec, ProfileSpec, ReliefShape, ReliefSpec};
pub use require::{AngleLimitsSpec, LimitsSpec, RequireSpec};
pub(crate) use schema::{DRAWINGS, GEAR, PAIR, TABLE};
pub use schema::{gear_schema, pair_schema, schemas};
pub(crate) use thickness::{CROSS_CHECK_UM, STATEMENTS};
pub use thickness::{
    ChordSpec, CrossCheckSpec, LengthSpec, OverPinsSpec, SpanSpec, StatementSpec, ThicknessSpec,
};
pub use tolerance::{
    AxesScatterSpec, GearToleranceSpec, LeadScatterSpec, MAX_ASSEMBLIES, PhaseName,
    PitchScatterSpec, ScatterName, ScatterSpec, SpreadSpec, ToleranceSpec,
};
pub use trace::{FlankSpec, FlanksSpec, TraceDirection, TraceSpec};
pub use uncertainty::UncertaintySpec;
pub(crate) use value::each_value;
pub use value::{AllowanceBandSpec, BandSpec, Either};

use gearlash::error::GearError;
use gearlash::gear::ThicknessField;
use serde_json::Value;

/// The fault of a designation, which `schema` describes by its pattern.
pub(crate) fn designation_fault(schema: &Value, text: &str) -> Option<String> {
    let fault: GearError = match schema["pattern"].as_str()? {
        lead::SPUR_SLOPE => {
            let fault =
                "no helix slope of a spur gear, allowed is µm and a hand: \"10 r\" or \"10 l\"";
            let is_good = SpurSlopeSpec::of_text(text).parsed().is_some();
            return (!is_good).then(|| fault.to_owned());
        }
        assembly::DISTANCE_FIELD => text.parse::<DesignatedDistanceSpec>().err()?,
        _ => text.parse::<ThicknessField>().err()?,
    };
    Some(match fault {
        GearError::DistanceField => "no distance with a tolerance that is known: js, H, h, F or f with grade 5 … 10, ±, or deviations, as in \"30 js7\", \"30 ±0.02\" or \"30 +0.03/0\"".to_owned(),
        GearError::ThicknessField => format!("{fault}, allowed is 21 … 30 with a … h, ab, bc or cd, such as \"25cd\"; for another standard, as DIN 58405, give allowance_um or span"),
        other => other.to_string(),
    })
}
