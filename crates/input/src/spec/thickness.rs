//! Thickness of the teeth.

use super::rules::{
    at_least, at_most_one, beside, beside_list, columns, deviation, exactly_one, length,
    list_length, within,
};
use super::value::{AllowanceBandSpec, BandSpec, Either};
use gearlash::gear::MeasuringBody;
use gearlash_tables::TableFileSpec;
use schemars::{JsonSchema, Schema};
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer, Serialize};
use serde_with::skip_serializing_none;

/// The statements, one key each.
pub(crate) const STATEMENTS: [&[&str]; 8] = [
    &["span"],
    &["over_pins"],
    &["designation"],
    &["allowance_um"],
    &["flank_offset_mm"],
    &["base_thickness_mm"],
    &["arc_thickness_mm"],
    &["chordal_thickness"],
];

/// The default tolerance of a cross-check, µm.
pub(crate) const CROSS_CHECK_UM: f64 = gearlash::metrology::CrossCheck::TOLERANCE_UM;

/// Mean tooth thickness: one statement; none: nominal.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = thickness_keys)]
pub struct ThicknessSpec {
    /// The statement that counts.
    #[serde(flatten)]
    pub statement: StatementSpec,
    /// Added tooth by tooth at the reference circle.
    #[serde(default, deserialize_with = "listed")]
    #[schemars(with = "Option<Either<Vec<f64>, TableFileSpec>>")]
    #[schemars(transform = deviation(), transform = columns("tooth, thickness (µm)"))]
    pub per_tooth_um: Option<Vec<f64>>,
    /// A second statement: compared, never used.
    pub cross_check: Option<CrossCheckSpec>,
}

impl ThicknessSpec {
    /// `k` of the span that states the thickness, or else of the one in the cross-check.
    pub fn span_teeth(&self) -> Option<u32> {
        self.statements()
            .find_map(|statement| Some(statement.span.as_ref()?.teeth))
    }

    /// `D_M`, mm, of the dimension over pins that states the thickness, or else of the one in the cross-check.
    pub fn pin_mm(&self) -> Option<f64> {
        self.statements()
            .find_map(|statement| Some(statement.over_pins.as_ref()?.pin_mm))
    }

    fn statements(&self) -> impl Iterator<Item = &StatementSpec> {
        let second = self.cross_check.iter().map(|check| &check.statement);
        [&self.statement].into_iter().chain(second)
    }

    /// The statement that counts, and that of the cross-check.
    pub(crate) fn statements_mut(&mut self) -> impl Iterator<Item = &mut StatementSpec> {
        let second = self.cross_check.as_mut().map(|check| &mut check.statement);
        [&mut self.statement].into_iter().chain(second)
    }

    /// Converts allowances stated in the transverse section to normal ones; `cos` is their ratio.
    pub fn allowances_in_normal_section(&mut self, cos: f64) {
        for statement in self.statements_mut() {
            let normal = statement.allowance_um.map(|stated| match stated {
                Either::One(um) => Either::One(um * cos),
                Either::Other(BandSpec { min, max }) => Either::Other(BandSpec {
                    min: min * cos,
                    max: max * cos,
                }),
            });
            statement.allowance_um = normal;
        }
    }
}

/// One statement of the mean thickness: one of its keys.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StatementSpec {
    /// Span W_k over k teeth.
    pub span: Option<SpanSpec>,
    /// Dimension over two pins, or balls.
    pub over_pins: Option<OverPinsSpec>,
    /// Tolerance field of the tooth thickness, DIN 3967, such as 25cd.
    #[schemars(regex(
        pattern = r"^(DIN 3967[ -]*)?((2[1-9]|30) ?(ab?|bc?|cd?|[defgh])|(ab?|bc?|cd?|[defgh]) ?(2[1-9]|30))$"
    ))]
    pub designation: Option<String>,
    /// Thickness allowance A_sn, in the normal section at the reference circle.
    #[schemars(transform = deviation())]
    #[schemars(with = "Option<Either<f64, AllowanceBandSpec>>")]
    pub allowance_um: Option<Either<f64, BandSpec>>,
    /// Distance of both flanks beyond nominal along their normals, of printed and cut gears.
    #[schemars(transform = within(-100.0, 100.0))]
    pub flank_offset_mm: Option<Either<f64, BandSpec>>,
    /// Base tooth thickness s_b; of helical gears s_bn = s_bt cos β_b.
    #[schemars(transform = length())]
    pub base_thickness_mm: Option<Either<f64, BandSpec>>,
    /// Tooth thickness s_n along the reference circle, in the normal section.
    #[schemars(transform = length())]
    pub arc_thickness_mm: Option<Either<f64, BandSpec>>,
    /// Chordal tooth thickness in the normal section, by caliper.
    pub chordal_thickness: Option<ChordSpec>,
}

/// A second statement: compared, never used.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = cross_check_keys)]
pub struct CrossCheckSpec {
    /// The statement.
    #[serde(flatten)]
    pub statement: StatementSpec,
    /// Allowed difference of the two as base thickness.
    #[schemars(extend("default" = CROSS_CHECK_UM), transform = at_least(0.0))]
    pub tolerance_um: Option<f64>,
}

/// Span W_k over k teeth.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = span_keys, transform = columns("tooth (the first), span (mm)"))]
pub struct SpanSpec {
    /// Teeth spanned, k.
    #[schemars(range(min = 1))]
    pub teeth: u32,
    /// The measured length.
    #[serde(flatten)]
    pub length: LengthSpec,
    /// First tooth of each reading. A reading for every tooth needs none.
    #[schemars(inner(range(min = 1)))]
    pub first_tooth: Option<Vec<u32>>,
    /// Take thickness by tooth from spans all round where they determine it; default: true without `[pitch]`, whose flanks state it.
    pub per_tooth: Option<bool>,
    /// Readings all round from a table.
    #[serde(flatten)]
    pub table: Option<TableFileSpec>,
}

/// A length: one value, with deviations if it is a drawing's; measured values; or the least and the greatest.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = length())]
pub struct LengthSpec {
    /// Measured: one value, or a list.
    #[schemars(transform = list_length(1, None))]
    pub mm: Option<Either<f64, Vec<f64>>>,
    /// Least measured.
    pub min_mm: Option<f64>,
    /// Greatest measured.
    pub max_mm: Option<f64>,
    /// Upper deviation of the drawing from mm.
    #[schemars(transform = deviation())]
    pub upper_um: Option<f64>,
    /// Lower deviation.
    #[schemars(transform = deviation())]
    pub lower_um: Option<f64>,
}

/// Chordal tooth thickness: one value, or the least and the greatest.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = chord_keys, transform = length())]
pub struct ChordSpec {
    /// Measured.
    pub mm: Option<f64>,
    /// Least measured.
    pub min_mm: Option<f64>,
    /// Greatest measured.
    pub max_mm: Option<f64>,
    /// Depth of the chord below the tip circle; default: the nominal chordal addendum.
    pub height_mm: Option<f64>,
}

/// Dimension over two pins, or balls.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = over_pins_keys, transform = columns("tooth (before the space), pins (mm)"))]
pub struct OverPinsSpec {
    /// Diameter D_M of the pins or balls.
    #[schemars(transform = length())]
    pub pin_mm: f64,
    /// Measuring body; needed for an odd number of helical teeth.
    pub kind: Option<MeasuringBody>,
    /// The measured length.
    #[serde(flatten)]
    pub length: LengthSpec,
    /// Tooth before the space of each reading; the other pin lies opposite; default for all teeth: 1, 2, ….
    #[schemars(inner(range(min = 1)))]
    pub space: Option<Vec<u32>>,
    /// Readings all round from a table.
    #[serde(flatten)]
    pub table: Option<TableFileSpec>,
}

/// The values of a list; `None` for a table until its file is read.
fn listed<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<f64>>, D::Error> {
    Ok(match Either::deserialize(from)? {
        Either::One(list) => Some(list),
        Either::Other(IgnoredAny) => None,
    })
}

fn thickness_keys(schema: &mut Schema) {
    at_most_one(schema, &STATEMENTS);
    beside(schema, "cross_check", &STATEMENTS);
}

fn cross_check_keys(schema: &mut Schema) {
    exactly_one(schema, &STATEMENTS);
}

fn span_keys(schema: &mut Schema) {
    length_keys(schema);
    beside_list(schema, "first_tooth", "mm", &[]);
    beside_list(schema, "per_tooth", "mm", &["file"]);
}

fn over_pins_keys(schema: &mut Schema) {
    length_keys(schema);
    beside_list(schema, "space", "mm", &[]);
}

fn chord_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["mm"], &["min_mm", "max_mm"]]);
}

/// One value, least and greatest, or a table.
fn length_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["mm"], &["min_mm", "max_mm"], &["file"]]);
    beside(schema, "upper_um", &[&["mm", "lower_um"]]);
    beside(schema, "lower_um", &[&["mm", "upper_um"]]);
}
